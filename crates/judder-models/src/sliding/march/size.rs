//! What a march keeps, and what looking at it takes.

use crate::sliding::march::settings::MarchAnalysis;
use crate::sliding::system::{ReducedPair, step};
use judder_numerics::signal::Decimation;
use judder_study::model::NeededMemory;

/// What bursts, sound and spectrum of one signal take beside the stored arrays: copies of time, position and signal, before and after
/// the ramps, envelope and what is sorted of it.
const COPIES: f64 = 9.0;
/// Bytes of a state of the contact and its time.
const STATE: f64 = 9.0;

const SMALLER: &str = "lower `signals.sample_rate` with its `pass_band`, march over a shorter path (`from`, `to`), or mind the unit of `motion.velocity`";

/// The arrays of a march.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct MarchSize {
    /// Samples of each of its signals.
    pub(crate) samples: f64,
    /// Signals, with time and position.
    pub(crate) signals: usize,
}

impl MarchSize {
    /// Of a march with the step that it would choose; `None` where that is refused.
    pub(crate) fn of(system: &ReducedPair, march: &MarchAnalysis) -> Option<Self> {
        let chosen = step(&system.pair, march.method(), march.step, system.along(march)).ok()?;
        Some(Self::new(system, march, chosen.step))
    }

    /// Of a march with steps of so many seconds.
    pub(crate) fn new(system: &ReducedPair, march: &MarchAnalysis, step: f64) -> Self {
        let rate = 1.0 / step;
        let factor = Decimation::factor_to(rate, march.signals.sample_rate.0);
        // two observed displacements a point
        let signals = 2 + march.kept(system.pair.observed().len() / 2).len();
        Self { samples: (system.along(march).duration() * rate / factor as f64).ceil(), signals }
    }

    /// Bytes in the study folder, before they are packed.
    pub(crate) fn stored(&self) -> f64 {
        8.0 * self.samples * self.signals as f64
    }

    /// What looks at all samples when the march is over.
    pub(crate) fn memory(self) -> NeededMemory {
        let Self { samples, signals } = self;
        NeededMemory {
            beside: (samples * (8.0 * (signals as f64 + COPIES) + STATE)) as u128,
            what: format!("{samples:.3e} samples of {signals} signals").into(),
            keys: &["signals.sample_rate"],
            advice: SMALLER,
            ..NeededMemory::LITTLE
        }
    }
}
