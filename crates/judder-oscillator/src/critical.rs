//! Thresholds: the values of a swept quantity at which steady sliding gains or loses stability (Figs. 7, 8).
//!
//! (27) and (28) are implicit through the indentation, and they can have several solutions (unstable, stable, unstable as the shear
//! strength grows). So the condition and the equilibrium are solved together, and all solutions in a range are returned.

use crate::Contact;
use crate::block::{LANES, PointBlock};
use crate::characteristic::Characteristic;
use crate::conservative::discriminant_share;
use crate::equilibrium::equilibrium;
use crate::groups::Coefficients;
use crate::linear_system::ReducedSystem;
use crate::linearisation::Linearisation;
use judder_numerics::root::all_roots_from_values;

/// How a range is divided.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum RangeScale {
    /// Evenly.
    Linear,
    /// Evenly in the logarithm; both ends positive.
    #[default]
    Logarithmic,
}

/// The range of a quantity, with positions between 0 and 1 along it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ParameterRange {
    /// The value at position 0.
    pub from: f64,
    /// The value at position 1.
    pub to: f64,
    /// How positions map to values.
    pub scale: RangeScale,
}

impl ParameterRange {
    /// The value at a position; exact at 0 and 1.
    #[must_use]
    pub fn value(&self, position: f64) -> f64 {
        if position == 0.0 {
            return self.from;
        }
        if position == 1.0 {
            return self.to;
        }
        match self.scale {
            RangeScale::Linear => self.from + (self.to - self.from) * position,
            RangeScale::Logarithmic => {
                libm::exp(libm::log(self.from) + (libm::log(self.to) - libm::log(self.from)) * position)
            }
        }
    }
}

/// All thresholds over a range, ascending.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Thresholds {
    /// Of the full, damped system: where its stability changes.
    pub full: Vec<f64>,
    /// Of the system without damping (27), (28): where the two modes merge or part.
    pub conservative: Vec<f64>,
    /// Values at which there was no steady sliding to linearise; thresholds next to them may be missing.
    pub failures: Vec<f64>,
}

/// The stability margin of the full system and the discriminant's share of the conservative one, at every position.
fn margins(contact: &Contact, at: &impl Fn(f64) -> Coefficients, positions: &[f64]) -> (Vec<f64>, Vec<f64>) {
    let (mut full, mut conservative) = (Vec::new(), Vec::new());
    let mut block = PointBlock::default();
    let mut guess = f64::NAN;
    for positions in positions.chunks(LANES) {
        for (lane, position) in positions.iter().enumerate() {
            block.set(lane, &at(*position), guess);
        }
        block.decide(contact, positions.len());
        block.measure_margins(contact);
        full.extend(&block.margin[..positions.len()]);
        conservative.extend(&block.conservative_margin[..positions.len()]);
        guess = block.ln_indentation[positions.len() - 1];
    }
    (full, conservative)
}

/// The system about steady sliding, by the scalar path; `None` without an equilibrium.
fn reduced_system(contact: &Contact, c: &Coefficients) -> Option<ReducedSystem> {
    let state = equilibrium(contact, c).ok()?;
    let linearisation = Linearisation::new(contact.friction_load, c, &state.response);
    Some(ReducedSystem { damping: linearisation.damping(), stiffness: linearisation.stiffness() })
}

/// All thresholds of both systems over `range`, looked for from `samples` evenly spaced positions (at least 2).
///
/// `coefficients` gives the oscillator at a value of the swept quantity. Roots are found to the last digits that the
/// condition carries; two roots closer than a sample interval are found where the margin between them shows a dip.
#[must_use]
pub fn thresholds(
    contact: &Contact,
    range: &ParameterRange,
    samples: usize,
    coefficients: impl Fn(f64) -> Coefficients,
) -> Thresholds {
    let at = |position: f64| coefficients(range.value(position));
    let last = samples.max(2) - 1;
    let positions: Vec<f64> = (0..=last).map(|k| k as f64 / last as f64).collect();
    let (full, conservative) = margins(contact, &at, &positions);
    let system = |position: f64| reduced_system(contact, &at(position));
    let margin = |position: f64| system(position).map_or(f64::NAN, |s| Characteristic::new(&s).margin());
    let merging = |position: f64| system(position).map_or(f64::NAN, |s| discriminant_share(&s.stiffness));
    let full = all_roots_from_values(margin, &positions, &full);
    let conservative = all_roots_from_values(merging, &positions, &conservative);
    let values = |positions: Vec<f64>| positions.into_iter().map(|position| range.value(position)).collect();
    Thresholds {
        full: values(full.roots),
        conservative: values(conservative.roots),
        failures: values(full.failures),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::conservative::critical_shear_strength;
    use crate::{FrictionLoad, Groups};
    use judder_contact::{FittedLaw, Law};

    fn paper() -> Contact {
        Contact { law: Law::Fitted(FittedLaw::oscillator_paper()), friction_load: FrictionLoad::NormalLoad }
    }

    #[test]
    fn self_consistent_thresholds_satisfy_eq_27() {
        let groups = Groups { velocity: 1e-4, normal_load: 7.5e-6, ..Groups::default() };
        let with = |shear_strength: f64| Groups { shear_strength, ..groups }.resolve();
        let range = ParameterRange { from: 1e-6, to: 1e3, scale: RangeScale::Logarithmic };
        let found = thresholds(&paper(), &range, 400, with);
        assert!(!found.conservative.is_empty(), "{found:?}");
        for value in found.conservative {
            let c = with(value);
            let e = equilibrium(&paper(), &c).unwrap();
            let printed = critical_shear_strength(FrictionLoad::NormalLoad, &c, &e.response);
            assert!((printed / value - 1.0).abs() < 1e-9, "{value} {printed}");
        }
    }

    #[test]
    fn an_undamped_system_changes_stability_where_the_modes_merge() {
        let groups = Groups { damping_x: 0.0, damping_y: 0.0, ..Groups::default() };
        let contact = Contact { law: Law::Hertz(judder_contact::HertzLaw::default()), ..paper() };
        let range = ParameterRange { from: 1e-6, to: 1e3, scale: RangeScale::Logarithmic };
        let found = thresholds(&contact, &range, 400, |s| Groups { shear_strength: s, ..groups }.resolve());
        assert!(!found.full.is_empty());
        for (a, b) in found.full.iter().zip(&found.conservative) {
            assert!((a / b - 1.0).abs() < 1e-9);
        }
    }
}
