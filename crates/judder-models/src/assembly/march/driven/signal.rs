//! A signal over time: a sine, a sweep, random numbers within a band, samples of a file.

use judder_keys::declared::{Number, NumberPair, UNLIMITED, Whole};
use judder_keys::dimension::Dimension;
use judder_keys::error::Fault;
use judder_keys::file_reference::{FileReference, read_file_reference};
use judder_keys::section::Section;
use judder_keys::{Choice, Settings};
use std::path::Path;

/// A signal over time, of a force or else of an acceleration.
#[derive(Debug, Clone, PartialEq, Settings)]
#[settings(title = "`{path}`")]
pub enum SignalSettings<const IS_FORCE: bool> {
    /// A sine.
    Swing {
        /// Amplitude of a sine, or of a sweep.
        #[key(rule = any(IS_FORCE), symbol = "a", example = "\"…\" with a frequency, or rms = \"…\" with a band, or file = \"….csv\"")]
        amplitude: f64,
        /// Its frequency.
        #[key(flatten)]
        frequency: SwingFrequency,
    },
    /// Random.
    Random {
        /// Root mean square of a random signal, in place of an amplitude.
        #[key(rule = Number { range: judder_keys::numeric_key::Range::NonNegative, ..any(IS_FORCE) }, symbol = "a_rms")]
        rms: f64,
        /// Between which frequencies a random signal lies.
        #[key(rule = BAND, symbol = "ω_1, ω_2", example = "[\"20 Hz\", \"2 kHz\"]")]
        band: [f64; 2],
        /// Which random signal: the same seed gives the same.
        #[key(rule = Whole { from: 0, to: UNLIMITED }, default = 1)]
        seed: u64,
    },
    /// Samples of a file.
    Samples {
        /// Samples over time, straight between them, in place of an amplitude: a table with a header such as `time [s],acceleration [m/s^2]`.
        file: FileReference,
        /// What the samples are multiplied by.
        #[key(rule = Number::any(Dimension::NUMBER), default = 1.0)]
        scale: f64,
    },
}

/// How fast a sine swings.
#[derive(Debug, Clone, Copy, PartialEq, Settings)]
pub enum SwingFrequency {
    /// With one frequency.
    Steady {
        /// Frequency of a sine.
        #[key(rule = FREQUENCY, symbol = "ω")]
        frequency: f64,
        /// Phase with which a sine begins.
        #[key(rule = Number::any(Dimension::ANGLE), symbol = "φ", default = 0.0)]
        phase: f64,
    },
    /// With one that changes.
    Sweeping {
        /// Frequency with which a sweep begins, in place of one frequency.
        #[key(rule = FREQUENCY, symbol = "ω_1")]
        from: f64,
        /// Frequency with which it ends, when the motion does.
        #[key(rule = FREQUENCY, symbol = "ω_2")]
        to: f64,
        /// How a sweep goes from one to the other.
        #[key(default = SweepWord::Linear)]
        sweep: SweepWord,
    },
}

/// How a sweep goes from one frequency to another.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Choice)]
#[choice(what = "sweep")]
pub enum SweepWord {
    /// The frequency grows evenly.
    Linear,
    /// Its logarithm grows evenly.
    Logarithmic,
}

const FREQUENCY: Number = Number::non_negative(Dimension::ANGULAR_FREQUENCY);
const BAND: NumberPair =
    NumberPair { of: FREQUENCY, what: "the lowest and the highest frequency", is_ascending: true };

/// The dimension of a force or of an acceleration.
pub(super) const fn dimension(is_force: bool) -> Dimension {
    if is_force { Dimension::FORCE } else { Dimension::ACCELERATION }
}

const fn any(is_force: bool) -> Number {
    Number::any(dimension(is_force))
}

impl<const IS_FORCE: bool> SignalSettings<IS_FORCE> {
    /// Finds its file, which is relative to a folder; `section` is that of the signal.
    pub(super) fn found(&mut self, section: &Section<'_>, folder: &Path) -> Result<(), Fault> {
        if let Self::Samples { file, .. } = self {
            *file = read_file_reference(section, "file", folder)?;
        }
        Ok(())
    }

    pub(super) fn file(&self) -> Option<&FileReference> {
        match self {
            Self::Samples { file, .. } => Some(file),
            _ => None,
        }
    }
}
