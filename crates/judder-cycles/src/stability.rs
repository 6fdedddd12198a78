//! Floquet multipliers of a limit cycle.
//!
//! Small motions about the cycle are stepped once around it, M δẍ + C δẋ + K δx = Pᵀ δλ with δλ = ∂π/∂λ δλ + ∂π/∂y δy at every step, by the implicit scheme of the
//! march: a point that sticks has no velocity at the end of a step, so that what differed when it was caught is gone, as it is in the motion itself. What the steps
//! make of all displacements and velocities is the monodromy matrix; its eigenvalues are the multipliers. Of motions that nothing drives one of them is 1, the cycle a little earlier or later: that whose vector lies along
//! the velocity of the cycle.
//!
//! Where points yield, slide, lift off and come back, steps are parted at each touch, and their error of second order is taken off: [`floquet_multipliers`].
//!
//! What an impact of a rigid point does to small motions depends on the instant at which it touches, which the steps do not follow: such cycles are told as
//! unknown.

mod along_shot;
mod change;
mod doubled;
mod hill;
mod mean_law;
mod monodromy;
mod turn;

use crate::CyclesError;
use crate::backbone::PeriodicMotion;
use crate::balance::HarmonicBalance;
use crate::path::GoOn;
use doubled::DoubledSteps;
use faer::c64;
use judder_nonsmooth::contact_problem::PointMotion;
use judder_numerics::complex::ElementaryComplex;

pub use along_shot::shot_multipliers;
pub use change::{CircleCrossing, StabilityChange, stability_changes};
pub use hill::{HILL_ROWS, HillMultipliers, HillRefusal, hill_multipliers};
pub(crate) use monodromy::monodromy;

/// The multipliers of a cycle.
#[derive(Debug, Clone, PartialEq)]
pub struct FloquetMultipliers {
    /// All but the one that belongs to the phase, the largest first.
    pub values: Vec<c64>,
    /// That of the phase, which should be 1: of motions that nothing drives.
    pub phase: Option<c64>,
    /// Steps of a period.
    pub steps: usize,
    /// By how much the largest differs between half as many steps and these, how far it lies from those with what the harmonics leave out of the forces, and by how much that of the phase is not 1.
    pub error: f64,
}

/// Whether motions near a cycle are drawn to it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum CycleStability {
    /// All multipliers lie within the unit circle, by more than their error.
    Stable,
    /// One lies outside, by more than its error.
    Unstable,
    /// The largest lies on the unit circle, as far as it is known, or two ways disagree.
    Undecided,
    /// A rigid point opens and closes.
    Impacts,
    /// There are too many coordinates for a monodromy matrix.
    TooLarge,
}

/// Coordinates up to which there is a monodromy matrix: its eigenvalues cost as the cube of twice as many.
const MOST: usize = 400;
/// Steps of a period at first, and at most.
pub const FLOQUET_STEPS: [usize; 2] = [256, 4096];
/// How many times the harmonics of a motion its multipliers are looked at with besides.
pub const FLOQUET_WIDER: usize = 4;
/// A change from half as many steps that is small enough.
const ENOUGH: f64 = 1e-3;
/// One where no point sticks or turns, of what the harmonics leave out, and by itself.
const OF_LEFT_OUT: f64 = 0.1;
const ENOUGH_SLIDING: f64 = 1e-8;

impl FloquetMultipliers {
    /// The largest modulus but that of the phase.
    #[must_use]
    pub fn largest(&self) -> f64 {
        self.values.first().map_or(0.0, |own| own.modulus())
    }

    /// What they say; nothing where another multiplier may be that of the phase, and would let them say something else.
    #[must_use]
    pub fn verdict(&self) -> CycleStability {
        verdict(&self.values, self.phase, self.error)
    }

    /// How far the largest of them and of those by Hill's method lie from the nearest of the other.
    #[must_use]
    pub fn apart_from(&self, hill: &HillMultipliers) -> f64 {
        apart(&self.values, &hill.values)
    }
}

impl CycleStability {
    /// What two ways say together: the same, or nothing.
    #[must_use]
    pub fn agreed(self, other: Self) -> Self {
        if self == other { self } else { Self::Undecided }
    }
}

/// What multipliers say that are known to an error, the largest first, beside that of the phase.
fn verdict(values: &[c64], phase: Option<c64>, error: f64) -> CycleStability {
    /// A multiplier so many errors from 1 may be that of the phase.
    const NEAR: f64 = 3.0;
    let said = |largest: f64, error: f64| match largest - 1.0 {
        beyond if beyond > error => CycleStability::Unstable,
        beyond if beyond < -error => CycleStability::Stable,
        _ => CycleStability::Undecided,
    };
    let own = said(values.first().map_or(0.0, |own| own.modulus()), error);
    let off = |value: c64| (value - 1.0).modulus();
    let near = (0..values.len()).filter(|k| phase.is_some() && off(values[*k]) <= NEAR * error);
    let as_others = near.map(|chosen| {
        let others = (0..values.len()).filter(|k| *k != chosen).map(|k| values[k].modulus());
        let phase = phase.map_or(0.0, ElementaryComplex::modulus);
        said(others.fold(phase, f64::max), error.max(off(values[chosen])))
    });
    if as_others.into_iter().all(|other| other == own) { own } else { CycleStability::Undecided }
}

/// The multipliers of a periodic motion, driven or not, with as many steps as they take to settle; what hinders them otherwise.
///
/// # Errors
/// [`CyclesError::Singular`].
pub fn floquet_multipliers(
    balance: &HarmonicBalance<'_>,
    cycle: &PeriodicMotion,
    go_on: &GoOn<'_>,
) -> Result<Result<FloquetMultipliers, CycleStability>, CyclesError> {
    if balance.bodies().coordinates() > MOST {
        return Ok(Err(CycleStability::TooLarge));
    }
    if has_impacts(balance, cycle)? {
        return Ok(Err(CycleStability::Impacts));
    }
    let mut own = DoubledSteps::new(balance, cycle, FLOQUET_STEPS[0], go_on)?;
    own.double(go_on)?;
    while !own.is_known_to(ENOUGH) {
        own.double(go_on)?;
    }
    // a stick or a turn that harmonics alone show, not the forces that the laws make of the motion, may change all of them
    let (wide, unknown) = balance.with_left_out(&cycle.unknown, cycle.turning, FLOQUET_WIDER)?;
    let beside = PeriodicMotion { unknown, ..cycle.clone() };
    let steps = own.found.steps;
    // twice halved steps tell the error of what is made of each two, where they are enough for the harmonics
    let serves = |own_steps: &usize| own.slides() && *own_steps > wide.series().harmonics();
    let first = [steps / 4, steps / 2].into_iter().find(serves).unwrap_or(steps);
    let mut other = DoubledSteps::new(&wide, &beside, first, go_on)?;
    while other.found.steps < steps {
        other.double(go_on)?;
    }
    // with as many steps both have the same error of them
    let left_out = apart(&own.found.values, &other.found.values);
    let of_phases =
        own.found.phase.zip(other.found.phase).map_or(0.0, |(own, other)| (own - other).modulus());
    let enough = (OF_LEFT_OUT * left_out.max(of_phases)).max(ENOUGH_SLIDING);
    let slide = own.slides() && other.slides();
    while slide && !other.is_known_to(enough) {
        other.double(go_on)?;
    }
    // what slides on is closer to the motion under the forces of the laws, by as much as the harmonics alone leave out
    let mut found = if slide { other.found } else { own.found };
    let of_phase = found.phase.map_or(0.0, |phase| (phase - 1.0).modulus());
    found.error = found.error.max(left_out).max(of_phase);
    Ok(Ok(found))
}

/// How far the largest of multipliers lie from the nearest of others, or those from these.
fn apart(some: &[c64], others: &[c64]) -> f64 {
    let off = |own: &[c64], from: &[c64]| {
        let largest = own.first().copied().unwrap_or_default();
        from.iter().map(|other| (largest - other).modulus()).fold(f64::INFINITY, f64::min)
    };
    off(some, others).max(off(others, some))
}

/// Whether a rigid point that may open does so amid the cycle.
fn has_impacts(balance: &HarmonicBalance<'_>, cycle: &PeriodicMotion) -> Result<bool, CyclesError> {
    let signals = balance.signals_at(&cycle.unknown, cycle.turning)?;
    let projected = balance.projected(balance.series(), &signals);
    let contact = balance.contact();
    let open =
        |point: usize| projected.of_point(point).iter().filter(|own| own.state == PointMotion::Open).count();
    Ok((0..contact.points.len())
        .filter(|point| !contact.is_compliant(*point) && !contact.points[*point].stays_closed)
        .any(|point| ![0, balance.series().samples()].contains(&open(point))))
}

/// The state where a cycle begins, its direction there, of length one, and how far it swings; velocities are measured by ω.
pub(crate) fn beginning(
    balance: &HarmonicBalance<'_>,
    near: &PeriodicMotion,
) -> Result<(Vec<f64>, Vec<f64>, f64), CyclesError> {
    let (mean, harmonics) = balance.coordinates(&near.unknown, near.turning)?;
    let size = mean.len();
    let turned = |h: usize| c64::new(0.0, (h + 1) as f64);
    let sum = |k: usize, times: i32| -> f64 {
        harmonics.iter().enumerate().map(|(h, own)| (turned(h).powi(times) * own[k]).re).sum()
    };
    let place: Vec<f64> =
        (0..size).map(|k| mean[k] + sum(k, 0)).chain((0..size).map(|k| sum(k, 1))).collect();
    let mut direction: Vec<f64> = (0..size).map(|k| sum(k, 1)).chain((0..size).map(|k| sum(k, 2))).collect();
    let swing = harmonics.iter().flatten().map(c64::norm_sqr).sum::<f64>().sqrt();
    let size = direction.iter().map(|own| own * own).sum::<f64>().sqrt();
    direction.iter_mut().for_each(|own| *own /= size);
    Ok((place, direction, swing))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn multipliers(phase: f64, values: &[f64]) -> CycleStability {
        let values = values.iter().map(|own| c64::new(*own, 0.0)).collect();
        let phase = c64::new(phase, 0.0);
        let error = (phase - 1.0).norm();
        FloquetMultipliers { values, phase: Some(phase), steps: 1, error }.verdict()
    }

    /// Two ways that do not say the same say nothing.
    #[test]
    fn stability_is_what_two_ways_agree_on() {
        use CycleStability::{Stable, Undecided, Unstable};
        assert_eq!(Stable.agreed(Stable), Stable);
        assert_eq!(Unstable.agreed(Unstable), Unstable);
        for [own, other] in [[Stable, Unstable], [Unstable, Undecided], [Undecided, Stable]] {
            assert_eq!(own.agreed(other), Undecided);
        }
        let one = |value: f64| vec![c64::new(value, 0.0)];
        let steps = FloquetMultipliers { values: one(0.9), phase: None, steps: 1, error: 1e-3 };
        let hill = HillMultipliers { values: one(-1.1), phase: None, error: 1e-3 };
        assert!(steps.verdict() == Stable && hill.verdict() == Unstable);
        assert!((steps.apart_from(&hill) - 2.0).abs() < 1e-12);
    }

    /// Of two multipliers as far from 1 neither is known to be that of the phase.
    #[test]
    fn a_multiplier_that_may_be_that_of_the_phase_decides_nothing() {
        assert_eq!(multipliers(1.0475, &[0.9515]), CycleStability::Undecided);
        assert_eq!(multipliers(0.9512, &[1.0531]), CycleStability::Undecided);
        assert_eq!(multipliers(1.001, &[0.7, -0.6]), CycleStability::Stable);
        assert_eq!(multipliers(1.001, &[-1.2, 0.6]), CycleStability::Unstable);
    }
}
