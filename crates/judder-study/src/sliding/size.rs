//! What a march keeps, what looking at it takes, and what is refused beforehand as too much or too short.

use super::{SlidingSystem, method, step};
use judder_case::sliding::march::March;
use judder_case::{CaseError, CaseFile, Memory, SlidingAnalysis, SlidingCase, SlidingProblem};
use judder_numerics::signal::decimate::Decimation;
use judder_sliding::motion::Motion;

/// What bursts, sound and spectrum of one signal take beside the stored arrays: copies of time, position and signal, before and after
/// the ramps, envelope and what is sorted of it.
const COPIES: f64 = 9.0;
/// What the arrays of one march may take while they are looked at.
const LIMIT: Memory = Memory::DEFAULT;

const SMALLER: &str = "lower analysis.signals.sample_rate with its pass_band, march over a shorter path (from, to), or mind the unit of motion.velocity";
const SHORTER: &str = "give a shorter length, or none";

/// The arrays of a march.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Size {
    /// Samples of each of its signals.
    pub(crate) samples: f64,
    /// Signals, with time and position.
    pub(crate) signals: usize,
}

impl Size {
    /// Of a march with the step that it would choose; `None` where that is refused.
    pub(crate) fn of(system: &SlidingSystem, march: &March) -> Option<Self> {
        let chosen = step(&system.pair, method(march.method), march.step, path(system, march)).ok()?;
        Some(Self::new(system, march, chosen.step))
    }

    /// Of a march with steps of so many seconds.
    pub(crate) fn new(system: &SlidingSystem, march: &March, step: f64) -> Self {
        let rate = 1.0 / step;
        let factor = Decimation::factor_to(rate, march.signals.sample_rate);
        // two observed displacements a point
        let signals = 2 + march.kept(system.pair.observed().len() / 2).len();
        Self { samples: (path(system, march).duration() * rate / factor as f64).ceil(), signals }
    }

    /// Bytes in the study folder, before they are packed.
    pub(crate) fn stored(&self) -> f64 {
        8.0 * self.samples * self.signals as f64
    }

    /// Bytes of memory of what looks at all samples when the march is over.
    pub(crate) fn memory(&self) -> f64 {
        8.0 * self.samples * (self.signals as f64 + COPIES)
    }
}

/// What a march prescribes.
fn path(system: &SlidingSystem, march: &March) -> Motion {
    Motion { start: march.from, end: march.to, ..system.motion }
}

/// Refuses marches whose samples would not fit into memory, and spectrograms whose windows are longer than their march.
///
/// # Errors
/// [`SlidingProblem::Unbuilt`] at the key that is to blame.
pub(crate) fn fits(
    (file, case, system): (&CaseFile, &SlidingCase, &SlidingSystem),
    index: usize,
) -> Result<(), CaseError> {
    let analysis = &case.analyses[index];
    let refuse = |key: &str, reason: String, advice| {
        let path = format!("analysis.{}.{key}", analysis.name);
        Err(file.sliding_error(&path, SlidingProblem::Unbuilt { reason, advice }))
    };
    match &analysis.kind {
        SlidingAnalysis::March(march) => {
            // a step that is refused is said by the analysis
            let Some(size) = Size::of(system, march) else { return Ok(()) };
            if size.memory() <= LIMIT.bytes as f64 {
                return Ok(());
            }
            let Size { samples, signals } = size;
            let amount = |bytes: f64| Memory { bytes: bytes as u64 };
            let reason = format!(
                "the march would keep {samples:.3e} samples of {signals} signals, {}, and take {} of memory to look at them: more than {LIMIT}",
                amount(size.stored()),
                amount(size.memory())
            );
            refuse("signals.sample_rate", reason, SMALLER)
        }
        SlidingAnalysis::Spectrogram(asked) => {
            let marched = case.analyses.iter().find(|own| own.name == asked.of);
            let Some(SlidingAnalysis::March(march)) = marched.map(|own| &own.kind) else { return Ok(()) };
            let duration = path(system, march).duration();
            if asked.length <= duration {
                return Ok(());
            }
            let (length, of) = (asked.length, &asked.of);
            refuse(
                "length",
                format!("a window is {length} s long, but the march `{of}` takes {duration:.6} s"),
                SHORTER,
            )
        }
        _ => Ok(()),
    }
}
