//! What a march keeps, what looking at it takes, and what is refused beforehand as too much.

use super::settings::AssemblyMarch;
use crate::assembly::AssemblySubject;
use crate::assembly::case::problem::AssemblyProblem;
use judder_keys::memory::Memory;
use judder_numerics::signal::Decimation;
use judder_study::model::Refusal;

/// What the strongest line and the sound of one signal take beside the stored arrays, in numbers a sample: a spectrum of four to eight times as many, before
/// and after its transform.
const COPIES: f64 = 30.0;
/// What the arrays of one march may take while they are looked at.
const LIMIT: Memory = Memory::DEFAULT;

/// The arrays of a march.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct MarchedSize {
    /// Samples of each signal.
    samples: f64,
    /// Bytes a sample of all of them, with the states.
    bytes: f64,
}

impl MarchedSize {
    /// Of a march with this contact.
    pub(super) fn new(of: &AssemblySubject<'_>, asked: &AssemblyMarch) -> Self {
        let built = of.built;
        let points: usize = built.assembly.interfaces.iter().map(|interface| interface.points.len()).sum();
        let signals = 2 + 2 * built.assembly.interfaces.len() + 2 * built.watched.len() + 2 * points;
        let rate = 1.0 / asked.step;
        let factor = Decimation::factor_to(rate, asked.sample_rate.0);
        let samples = (asked.duration * rate / factor as f64).ceil();
        Self { samples, bytes: (8 * signals + points) as f64 }
    }

    /// Bytes in the study folder, before they are packed.
    fn stored(self) -> f64 {
        self.samples * self.bytes
    }

    /// Bytes of memory of what looks at all samples when the march is over.
    fn memory(self) -> f64 {
        self.samples * (self.bytes + 8.0 * COPIES)
    }

    /// Refuses a march whose samples would not fit into memory.
    pub(super) fn fits(self) -> Result<(), Refusal> {
        if self.memory() <= LIMIT.bytes as f64 {
            return Ok(());
        }
        let amount = |bytes: f64| Memory { bytes: bytes as u64 };
        let reason = format!(
            "the march would keep {:.3e} samples of its signals and of the states of all contact points, {}, and take {} of memory to look at them: more than {LIMIT}; \
             lower sample_rate, or march over a shorter duration",
            self.samples,
            amount(self.stored()),
            amount(self.memory()),
        );
        Err(Refusal::keys(&["sample_rate", "duration"], AssemblyProblem::Refused { reason }))
    }
}
