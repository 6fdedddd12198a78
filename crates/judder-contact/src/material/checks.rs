//! What must hold for a viscoelastic material, computed from its moduli rather than from its terms.

use super::creep::CreepSpectrum;
use judder_numerics::decade::power_of_ten;

/// Samples of frequency and of time in every decade.
const PER_DECADE: f64 = 16.0;
/// Decades that are looked at beyond the shortest and the longest time.
const MARGIN: f64 = 3.0;
/// A modulus may step back by this fraction of itself: rounding of the sum of a hundred terms.
const ROUNDING: f64 = 1e-13;

/// What a material was found to do over all frequencies and times at which it is not elastic.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct MaterialChecks {
    /// E0 < E∞ (E0 = E∞ without a term).
    pub rubbery_below_glassy: bool,
    /// E′ never falls with frequency.
    pub storage_rises: bool,
    /// E″ > 0 (E″ = 0 without a term).
    pub loss_is_positive: bool,
    /// J never falls with time.
    pub creep_advances: bool,
}

impl MaterialChecks {
    /// Looks at a material at sixteen frequencies and times a decade, three decades beyond its times at either end.
    #[must_use]
    pub fn of(material: &CreepSpectrum) -> Self {
        let (Some(first), Some(last)) = (material.terms().first(), material.terms().last()) else {
            return Self {
                rubbery_below_glassy: true,
                storage_rises: true,
                loss_is_positive: true,
                creep_advances: true,
            };
        };
        let shortest = libm::log10(first.retardation_time) - MARGIN;
        // loss goes on up to the shortest relaxation time, E0/E∞ below the retardation time
        let fastest = shortest - libm::log10(material.contrast());
        let times = decades(fastest, libm::log10(last.retardation_time) + MARGIN);
        let moduli: Vec<_> = times.iter().rev().map(|time| material.complex_modulus(1.0 / time)).collect();
        let storage: Vec<f64> = moduli.iter().map(|modulus| modulus.re).collect();
        let creep: Vec<f64> = times.iter().map(|time| material.creep_compliance(*time)).collect();
        Self {
            rubbery_below_glassy: material.rubbery_modulus() < material.glassy_modulus(),
            storage_rises: never_falls(&storage),
            loss_is_positive: moduli.iter().all(|modulus| modulus.im > 0.0),
            creep_advances: never_falls(&creep),
        }
    }

    /// Whether every check holds.
    #[must_use]
    pub fn hold(&self) -> bool {
        self.rubbery_below_glassy && self.storage_rises && self.loss_is_positive && self.creep_advances
    }
}

/// Numbers from 10^`from` to 10^`to`, evenly spaced in the logarithm.
pub(super) fn decades(from: f64, to: f64) -> Vec<f64> {
    let steps = ((to - from) * PER_DECADE).ceil().max(1.0);
    (0..=steps as usize).map(|k| power_of_ten(from + (to - from) * k as f64 / steps)).collect()
}

fn never_falls(values: &[f64]) -> bool {
    values.windows(2).all(|pair| pair[1] >= pair[0] * (1.0 - ROUNDING))
}
