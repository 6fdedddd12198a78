//! Whether a cycle draws all motions nearby, by its Floquet multipliers.

use crate::error::ModelError;
use judder_cycles::backbone::PeriodicMotion;
use judder_cycles::balance::HarmonicBalance;
use judder_cycles::stability::{CycleStability, FloquetMultipliers, floquet_multipliers};
use judder_study::Progress;
use num_complex::Complex64;

/// What is known of it; nothing where it was not asked for.
pub(in crate::assembly) struct KnownStability(Option<Result<FloquetMultipliers, CycleStability>>);

impl KnownStability {
    /// That of a cycle, where it is asked for.
    pub(in crate::assembly) fn of(
        balance: &HarmonicBalance<'_>,
        motion: &PeriodicMotion,
        is_asked: bool,
        progress: &dyn Progress,
    ) -> Result<Self, ModelError> {
        let found = is_asked.then(|| floquet_multipliers(balance, motion, &|| !progress.interrupted()));
        Ok(Self(found.transpose()?))
    }

    fn known(&self) -> Option<&FloquetMultipliers> {
        self.0.as_ref()?.as_ref().ok()
    }

    /// All multipliers, that of the phase among them, the largest first.
    pub(in crate::assembly) fn multipliers(&self) -> Option<Vec<Complex64>> {
        let known = self.known()?;
        let place = known.values.partition_point(|own| own.norm() > known.phase.norm());
        let mut all = known.values.clone();
        all.insert(place, known.phase);
        Some(all)
    }

    /// What the largest but that of the phase may be off.
    pub(in crate::assembly) fn error(&self) -> Option<f64> {
        self.known().map(|known| known.error)
    }

    fn verdict(&self) -> Option<CycleStability> {
        self.0.as_ref().map(|found| match found {
            Ok(known) => known.verdict(),
            Err(hindered) => *hindered,
        })
    }

    /// Whether it is stable, where that is known.
    pub(in crate::assembly) fn is_stable(&self) -> Option<bool> {
        match self.verdict()? {
            CycleStability::Stable => Some(true),
            CycleStability::Unstable => Some(false),
            CycleStability::Undecided | CycleStability::Impacts | CycleStability::TooLarge => None,
        }
    }

    /// The same in words, with what hinders it.
    pub(in crate::assembly) fn words(&self) -> &'static str {
        match self.verdict() {
            None => "not asked for",
            Some(CycleStability::Stable) => "stable",
            Some(CycleStability::Unstable) => "unstable",
            Some(CycleStability::Undecided) => {
                "undecided: the largest multiplier lies on the unit circle, as far as it is known"
            }
            Some(CycleStability::Impacts) => {
                "unknown: rigid points open and close, and what their impacts do to small motions is not followed"
            }
            Some(CycleStability::TooLarge) => {
                "unknown: the bodies have too many coordinates for a monodromy matrix; reduce them"
            }
        }
    }

    /// What has to be said of it.
    pub(in crate::assembly) fn doubt(&self) -> Option<String> {
        match self.verdict()? {
            CycleStability::Stable => None,
            CycleStability::Unstable => {
                let largest = self.known().map_or(f64::NAN, FloquetMultipliers::largest);
                Some(format!(
                    "motions nearby leave the cycle, with a Floquet multiplier of modulus {largest:.4}: no march comes to it"
                ))
            }
            _ => Some(format!("whether motions nearby are drawn to the cycle is {}", self.words())),
        }
    }
}
