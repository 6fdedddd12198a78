//! Sound: signals as WAV files, for engineers who listen.

pub(crate) mod error;

pub use error::SoundError;

use crate::cause::FileCause;
use crate::error::ExchangeError;
use crate::whole_file::write_file;
use hound::{SampleFormat, WavSpec, WavWriter};
use judder_numerics::decade::power_of_ten;
use std::io::{self, Cursor};
use std::path::Path;

/// A WAV file says its size in 32 bits; this leaves room for its header.
const MOST_BYTES: u64 = u32::MAX as u64 - 1024;

/// The highest sample rate (Hz) at which the bytes of a second still fit into 32 bits.
const HIGHEST_RATE: u32 = 100_000_000;

/// The largest whole number of 24 bits, which is full scale.
const FULL_SCALE_24: f64 = 8_388_607.0;

/// How a sample is stored.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum WavFormat {
    /// A whole number of 24 bits: every player, 138 dB.
    #[default]
    Integer24,
    /// A real number of 32 bits.
    Float32,
}

/// How loud a sound is made.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Loudness {
    /// The largest sample of all channels comes to this level (dB of full scale, at most 0). Silence stays silence, with a gain of 1.
    Peak(f64),
    /// This value of the signal, in its unit, is full scale: sounds that are to be compared share it. No sample may be beyond it.
    FullScale(f64),
}

impl Default for Loudness {
    /// −1 dB of full scale, which leaves room for what players do between the samples.
    fn default() -> Self {
        Self::Peak(-1.0)
    }
}

impl From<SoundError> for ExchangeError {
    fn from(source: SoundError) -> Self {
        FileCause::Sound { source }.into()
    }
}

/// One channel, or two of the same length, as the bytes of a WAV file at `sample_rate` (Hz), and the gain g of both: what is heard is g times
/// the signal, full scale being 1.
///
/// # Errors
/// [`FileCause::Sound`] with what cannot be heard.
pub fn wav_bytes(
    channels: &[&[f64]],
    sample_rate: u32,
    format: WavFormat,
    loudness: Loudness,
) -> Result<(Vec<u8>, f64), ExchangeError> {
    check(channels, sample_rate, format)?;
    let gain = gain(channels, loudness)?;
    Ok((encoded(channels, sample_rate, format, gain)?, gain))
}

/// Writes one channel, or two of the same length, as a WAV file at `sample_rate` (Hz), and returns the gain g of both: what is heard is g times the
/// signal, full scale being 1.
///
/// # Errors
/// [`FileCause::Sound`] with what cannot be heard; [`FileCause::Unwritable`]. What was there before is then still there.
pub fn write_wav(
    path: &Path,
    channels: &[&[f64]],
    sample_rate: u32,
    format: WavFormat,
    loudness: Loudness,
) -> Result<f64, ExchangeError> {
    let (bytes, gain) =
        wav_bytes(channels, sample_rate, format, loudness).map_err(|error| error.in_file(path))?;
    write_file(path, |out| Ok(out.write_all(&bytes)?))?;
    Ok(gain)
}

fn check(channels: &[&[f64]], sample_rate: u32, format: WavFormat) -> Result<(), SoundError> {
    match channels {
        [_] => {}
        [left, right] if left.len() == right.len() => {}
        [left, right] => {
            return Err(SoundError::ChannelsDiffer { left: left.len(), right: right.len() });
        }
        _ => return Err(SoundError::Channels { found: channels.len() }),
    }
    if !(1..=HIGHEST_RATE).contains(&sample_rate) {
        return Err(SoundError::Rate { rate: sample_rate });
    }
    let samples: u64 = channels.iter().map(|channel| channel.len() as u64).sum();
    let bytes = samples.saturating_mul(u64::from(bits(format) / 8));
    if bytes > MOST_BYTES {
        return Err(SoundError::TooLong { bytes, most: MOST_BYTES });
    }
    for (channel, samples) in channels.iter().enumerate() {
        if let Some(index) = samples.iter().position(|value| !value.is_finite()) {
            return Err(SoundError::NotFinite { channel, index, value: samples[index] });
        }
    }
    Ok(())
}

/// The factor from the signal to parts of full scale.
fn gain(channels: &[&[f64]], loudness: Loudness) -> Result<f64, SoundError> {
    let (what, value, gain) = match loudness {
        Loudness::Peak(level) if !(-100.0..=0.0).contains(&level) => {
            return Err(SoundError::PeakLevel { level });
        }
        Loudness::Peak(level) => {
            let samples = channels.iter().flat_map(|channel| channel.iter());
            let peak = samples.fold(0.0, |peak: f64, value| peak.max(value.abs()));
            if peak == 0.0 {
                return Ok(1.0);
            }
            ("a peak", peak, power_of_ten(level / 20.0) / peak)
        }
        Loudness::FullScale(full_scale) => {
            for (channel, samples) in channels.iter().enumerate() {
                if let Some(index) = samples.iter().position(|value| value.abs() > full_scale) {
                    let value = samples[index];
                    return Err(SoundError::BeyondFullScale { channel, index, value, full_scale });
                }
            }
            ("a full scale", full_scale, 1.0 / full_scale)
        }
    };
    if gain > 0.0 && gain.is_normal() { Ok(gain) } else { Err(SoundError::Gain { what, value, gain }) }
}

fn bits(format: WavFormat) -> u16 {
    match format {
        WavFormat::Integer24 => 24,
        WavFormat::Float32 => 32,
    }
}

/// The bytes of the file.
fn encoded(
    channels: &[&[f64]],
    sample_rate: u32,
    format: WavFormat,
    gain: f64,
) -> Result<Vec<u8>, ExchangeError> {
    let sample_format = match format {
        WavFormat::Integer24 => SampleFormat::Int,
        WavFormat::Float32 => SampleFormat::Float,
    };
    let spec = WavSpec {
        channels: channels.len() as u16,
        sample_rate,
        bits_per_sample: bits(format),
        sample_format,
    };
    let mut file = Cursor::new(Vec::new());
    let write = |file: &mut Cursor<Vec<u8>>| -> hound::Result<()> {
        let mut writer = WavWriter::new(file, spec)?;
        for index in 0..channels[0].len() {
            for channel in channels {
                // rounding may carry the largest sample a last bit beyond full scale
                let part = (gain * channel[index]).clamp(-1.0, 1.0);
                match format {
                    WavFormat::Integer24 => writer.write_sample((part * FULL_SCALE_24).round() as i32)?,
                    WavFormat::Float32 => writer.write_sample(part as f32)?,
                }
            }
        }
        writer.finalize()
    };
    write(&mut file).map_err(|error| match error {
        hound::Error::IoError(source) => ExchangeError::from(source),
        other => io::Error::other(other).into(),
    })?;
    let mut bytes = file.into_inner();
    if format == WavFormat::Integer24 {
        shorten_head(&mut bytes);
    }
    Ok(bytes)
}

/// Makes the extensible head of a file of whole numbers the plain one, which older readers know too: of one channel or two it says as much.
fn shorten_head(bytes: &mut Vec<u8>) {
    /// A `fmt ` chunk of 40 bytes, format 0xfffe.
    const EXTENSIBLE: [u8; 10] = *b"fmt \x28\0\0\0\xfe\xff";
    /// One of 16 bytes, format 1, whole numbers.
    const PLAIN: [u8; 10] = *b"fmt \x10\0\0\0\x01\0";
    const EXTENSION: std::ops::Range<usize> = 36..60;
    let Some(size) = bytes.get(4..8).and_then(|size| size.try_into().ok()).map(u32::from_le_bytes) else {
        return;
    };
    if bytes.get(12..22) != Some(&EXTENSIBLE[..]) || bytes.len() < EXTENSION.end {
        return;
    }
    bytes[12..22].copy_from_slice(&PLAIN);
    bytes[4..8].copy_from_slice(&(size - EXTENSION.len() as u32).to_le_bytes());
    bytes.drain(EXTENSION);
}

#[cfg(test)]
mod tests {
    use super::*;
    use hound::WavReader;
    use proptest::prelude::*;
    use std::fs;

    fn written(
        channels: &[&[f64]],
        format: WavFormat,
        loudness: Loudness,
    ) -> Result<(f64, Vec<u8>), ExchangeError> {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.wav");
        let gain = write_wav(&path, channels, 48_000, format, loudness)?;
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
        Ok((gain, fs::read(&path).unwrap()))
    }

    fn problem(channels: &[&[f64]], loudness: Loudness) -> SoundError {
        match written(channels, WavFormat::Integer24, loudness).unwrap_err().cause() {
            FileCause::Sound { source } => *source,
            other => panic!("{other}"),
        }
    }

    proptest! {
        /// What is read, divided by the gain, is the signal, to half a step of 24 bits or to the 24 bits of a float's fraction.
        #[test]
        fn a_signal_comes_back(
            pairs in prop::collection::vec((-1e4..1e4_f64, -1e4..1e4_f64), 1..200),
            is_float in any::<bool>(),
            is_stereo in any::<bool>(),
        ) {
            let (left, right): (Vec<f64>, Vec<f64>) = pairs.into_iter().unzip();
            let channels: &[&[f64]] = if is_stereo { &[&left, &right] } else { &[&left] };
            let format = if is_float { WavFormat::Float32 } else { WavFormat::Integer24 };
            let (gain, bytes) = written(channels, format, Loudness::default()).unwrap();
            let mut reader = WavReader::new(&bytes[..]).unwrap();
            prop_assert_eq!(reader.spec().sample_rate, 48_000);
            prop_assert_eq!(usize::from(reader.spec().channels), channels.len());
            let read: Vec<f64> = if is_float {
                reader.samples::<f32>().map(|sample| f64::from(sample.unwrap())).collect()
            } else {
                reader.samples::<i32>().map(|sample| f64::from(sample.unwrap()) / FULL_SCALE_24).collect()
            };
            prop_assert_eq!(read.len(), left.len() * channels.len());
            for (place, found) in read.iter().enumerate() {
                let expected = gain * channels[place % channels.len()][place / channels.len()];
                prop_assert!((found - expected).abs() <= 6e-8, "{found} {expected}");
            }
            let loudest = read.iter().fold(0.0, |loudest: f64, part| loudest.max(part.abs()));
            prop_assert!((20.0 * loudest.log10() + 1.0).abs() < 1e-5, "{loudest}");
        }
    }

    /// The bytes that the format prescribes (Multimedia Programming Interface and Data Specifications 1.0, IBM and Microsoft, 1991).
    #[test]
    fn the_bytes_are_those_of_the_format() {
        let (gain, bytes) =
            written(&[&[2.0, -2.0, 1.0, 0.0]], WavFormat::Integer24, Loudness::FullScale(2.0)).unwrap();
        assert_eq!(gain, 0.5);
        assert_eq!((&bytes[..4], &bytes[8..12]), (&b"RIFF"[..], &b"WAVE"[..]));
        assert_eq!(u32::from_le_bytes(bytes[4..8].try_into().unwrap()) as usize, bytes.len() - 8);
        // 16 bytes: whole numbers, mono, 48 kHz, 144000 bytes a second, 3 bytes a sample, 24 bits
        let head = [16, 0, 0, 0, 1, 0, 1, 0, 0x80, 0xbb, 0, 0, 0x80, 0x32, 2, 0, 3, 0, 24, 0];
        assert_eq!((&bytes[12..16], &bytes[16..36]), (&b"fmt "[..], &head[..]));
        let data = bytes.len() - 12;
        // 8388607, −8388607, 4194304 (half, rounded away from zero), 0
        assert_eq!(bytes[data..], [0xff, 0xff, 0x7f, 1, 0, 0x80, 0, 0, 0x40, 0, 0, 0]);
        assert_eq!(bytes[data - 8..data], *b"data\x0c\0\0\0");
    }

    #[test]
    fn silence_and_nothing_are_files_too() {
        let (gain, bytes) = written(&[&[0.0; 10]], WavFormat::Float32, Loudness::default()).unwrap();
        assert_eq!(gain, 1.0);
        assert_eq!(WavReader::new(&bytes[..]).unwrap().len(), 10);
        let (_, bytes) = written(&[&[], &[]], WavFormat::Integer24, Loudness::default()).unwrap();
        assert_eq!(WavReader::new(&bytes[..]).unwrap().len(), 0);
    }

    #[test]
    fn what_cannot_be_heard_is_refused_and_what_was_there_stays() {
        let peak = Loudness::default();
        assert_eq!(problem(&[], peak), SoundError::Channels { found: 0 });
        assert_eq!(problem(&[&[], &[], &[]], peak), SoundError::Channels { found: 3 });
        assert_eq!(problem(&[&[1.0], &[]], peak), SoundError::ChannelsDiffer { left: 1, right: 0 });
        let hole = problem(&[&[1.0, 2.0], &[1.0, f64::NAN]], peak);
        assert!(matches!(hole, SoundError::NotFinite { channel: 1, index: 1, .. }));
        let beyond = problem(&[&[0.0, -3.0]], Loudness::FullScale(2.0));
        assert!(matches!(beyond, SoundError::BeyondFullScale { index: 1, value: -3.0, .. }));
        assert_eq!(problem(&[&[1.0]], Loudness::Peak(1.0)), SoundError::PeakLevel { level: 1.0 });
        assert!(matches!(problem(&[&[1.0]], Loudness::Peak(f64::NAN)), SoundError::PeakLevel { .. }));
        assert!(matches!(problem(&[&[1e-320]], peak), SoundError::Gain { .. }));
        for bad in [0.0, f64::NAN, f64::INFINITY] {
            assert!(matches!(problem(&[&[0.0]], Loudness::FullScale(bad)), SoundError::Gain { .. }));
        }
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.wav");
        fs::write(&path, "old").unwrap();
        let refused = write_wav(&path, &[&[1.0]], 0, WavFormat::Float32, peak).unwrap_err();
        assert!(refused.to_string().contains("a.wav: 0 samples a second"), "{refused}");
        write_wav(&path, &[&[f64::NAN]], 48_000, WavFormat::Float32, peak).unwrap_err();
        assert_eq!(fs::read(&path).unwrap(), b"old");
    }
}
