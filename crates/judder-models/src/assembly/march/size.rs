//! What a march keeps, what looking at it takes, and what is refused beforehand as too much.

use super::settings::AssemblyMarch;
use crate::assembly::AssemblySubject;
use judder_numerics::signal::Decimation;
use judder_study::model::NeededMemory;

/// What the strongest line of one signal takes beside the stored arrays, in numbers a sample: time, signal, weights, and a spectrum of four to eight
/// times as many before and after its transform. Measured of marches of one point to 31 over 200 000 to 1 500 000 samples: 6 to 35: of that with most 0.86 of what it took is told, of that with least 1.2.
const COPIES: f64 = 24.0;

/// The arrays of a march.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::assembly) struct MarchedSize {
    /// Samples of each signal.
    pub(in crate::assembly) samples: f64,
    /// Bytes a sample of all of them, with the states.
    bytes: f64,
}

/// Samples a second that a march stores, Hz.
pub(crate) fn stored_rate(asked: &AssemblyMarch) -> f64 {
    let rate = 1.0 / asked.step;
    rate / Decimation::factor_to(rate, asked.sample_rate.0) as f64
}

impl MarchedSize {
    /// Of a march with this contact.
    pub(in crate::assembly) fn new(of: &AssemblySubject<'_>, asked: &AssemblyMarch) -> Self {
        let built = of.built;
        let points: usize = built.assembly.interfaces.iter().map(|interface| interface.points.len()).sum();
        let signals = 2 + 2 * built.assembly.interfaces.len() + 2 * built.watched.len() + 2 * points;
        let samples = (asked.duration * stored_rate(asked)).ceil();
        Self { samples, bytes: (8 * signals + points) as f64 }
    }

    /// Bytes in the study folder, before they are packed.
    pub(in crate::assembly) fn stored(self) -> f64 {
        self.samples * self.bytes
    }

    /// What looks at all samples when the march is over.
    pub(super) fn memory(self) -> NeededMemory {
        let samples = self.samples;
        NeededMemory {
            beside: (self.stored() + samples * 8.0 * COPIES) as u128,
            what: format!("{samples:.3e} samples of the signals and of the states of all contact points")
                .into(),
            keys: &["sample_rate", "duration"],
            advice: "lower `sample_rate`, or march over a shorter `duration`",
            ..NeededMemory::LITTLE
        }
    }
}
