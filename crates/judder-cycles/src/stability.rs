//! Floquet multipliers of a limit cycle.
//!
//! Small motions about the cycle are stepped once around it, M δẍ + C δẋ + K δx = Pᵀ δλ with δλ = ∂π/∂λ δλ + ∂π/∂y δy at every step, by the implicit scheme of the
//! march: a point that sticks has no velocity at the end of a step, so that what differed when it was caught is gone, as it is in the motion itself. What the steps
//! make of all displacements and velocities is the monodromy matrix; its eigenvalues are the multipliers. Of motions that nothing drives one of them is 1, the cycle a little earlier or later: that whose vector lies along
//! the velocity of the cycle.
//!
//! What an impact of a rigid point does to small motions depends on the instant at which it touches, which the steps do not follow: such cycles are told as
//! unknown.

mod change;
mod hill;
mod mean_law;
mod turn;

use crate::CyclesError;
use crate::backbone::PeriodicMotion;
use crate::balance::HarmonicBalance;
use crate::path::GoOn;
use crate::point_law::ProjectedForce;
use crate::receptance::BodyStep;
use crate::series::Series;
use faer::{Mat, c64};
use judder_dense::general::{PickedEigenvalues, real_eigen, solve};
use judder_dense::product::product;
use judder_nonsmooth::contact_problem::PointMotion;
use std::f64::consts::TAU;

use mean_law::MeanLaws;
use turn::SlipTurns;

pub use change::{CircleCrossing, StabilityChange, stability_changes};
pub use hill::{HILL_ROWS, HillMultipliers, HillRefusal, hill_multipliers};

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
/// A change from half as many steps that is small enough, and one where no point sticks or turns, whose error falls fast.
const ENOUGH: f64 = 1e-3;
const ENOUGH_SLIDING: f64 = 1e-7;

impl FloquetMultipliers {
    /// The largest modulus but that of the phase.
    #[must_use]
    pub fn largest(&self) -> f64 {
        self.values.first().map_or(0.0, |own| own.norm())
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
    let own = said(values.first().map_or(0.0, |own| own.norm()), error);
    let off = |value: c64| (value - 1.0).norm();
    let near = (0..values.len()).filter(|k| phase.is_some() && off(values[*k]) <= NEAR * error);
    let as_others = near.map(|chosen| {
        let others = (0..values.len()).filter(|k| *k != chosen).map(|k| values[k].norm());
        let phase = phase.map_or(0.0, c64::norm);
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
    let [first, most] = FLOQUET_STEPS;
    let mut coarse = monodromy(balance, cycle, first, go_on)?;
    let mut found = multipliers_of(balance, cycle, &coarse.matrix, first)?;
    loop {
        let steps = 2 * found.steps;
        let fine = monodromy(balance, cycle, steps, go_on)?;
        let mut finer = multipliers_of(balance, cycle, &fine.beyond(&coarse), steps)?;
        let of_steps = (finer.largest() - found.largest()).abs();
        let of_steps = match (finer.phase, found.phase) {
            (Some(finer), Some(found)) => of_steps.max((finer - found).norm()),
            _ => of_steps,
        };
        // that of the phase tells what the harmonics leave out too
        finer.error = finer.phase.map_or(of_steps, |phase| of_steps.max((phase - 1.0).norm()));
        found = finer;
        if of_steps < if fine.slides { ENOUGH_SLIDING } else { ENOUGH } || steps >= most {
            break;
        }
        coarse = fine;
    }
    // so do those of the motion under the forces that the laws make of it: a stick or a turn that harmonics alone show may change all of them
    let (wide, unknown) = balance.with_left_out(&cycle.unknown, cycle.turning, FLOQUET_WIDER)?;
    let beside = PeriodicMotion { unknown, ..cycle.clone() };
    let mut other = monodromy(&wide, &beside, found.steps, go_on)?;
    if other.slides {
        other.matrix = other.beyond(&monodromy(&wide, &beside, found.steps / 2, go_on)?);
    }
    let slides = other.slides;
    let other = multipliers_of(&wide, &beside, &other.matrix, found.steps)?;
    found.error = found.error.max(apart(&found.values, &other.values));
    // what slides on is closer to that motion than to the one of the harmonics alone, by as much as these leave out
    if slides {
        (found.values, found.phase) = (other.values, other.phase);
    }
    Ok(Ok(found))
}

/// How far the largest of multipliers lie from the nearest of others, or those from these.
fn apart(some: &[c64], others: &[c64]) -> f64 {
    let off = |own: &[c64], from: &[c64]| {
        let largest = own.first().copied().unwrap_or_default();
        from.iter().map(|other| (largest - other).norm()).fold(f64::INFINITY, f64::min)
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

/// The multipliers of what so many steps make of a period.
fn multipliers_of(
    balance: &HarmonicBalance<'_>,
    cycle: &PeriodicMotion,
    matrix: &Mat<f64>,
    steps: usize,
) -> Result<FloquetMultipliers, CyclesError> {
    let PickedEigenvalues { mut values, right, .. } =
        real_eigen(matrix, &|_| true).ok_or(CyclesError::Singular)?;
    let phase = match balance.is_driven() {
        true => None,
        false => {
            let (_, direction, _) = beginning(balance, cycle)?;
            let along = |k: usize| -> f64 {
                direction.iter().enumerate().map(|(row, own)| right[(row, k)] * *own).sum::<c64>().norm()
            };
            let most = (0..values.len()).max_by(|a, b| along(*a).total_cmp(&along(*b)));
            most.map(|k| values.remove(k))
        }
    };
    values.sort_by(|a, b| b.norm().total_cmp(&a.norm()).then(a.im.total_cmp(&b.im)));
    Ok(FloquetMultipliers { values, phase, steps, error: f64::INFINITY })
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

/// What the steps of a period make of displacements and velocities of the coordinates, in this order.
pub(crate) struct Monodromy {
    pub(crate) matrix: Mat<f64>,
    /// Whether no point sticks or turns, so that its error falls with the square of the step.
    slides: bool,
}

impl Monodromy {
    /// The matrix without what is known of its error from that of half as many steps (L. F. Richardson): where both are of second order.
    fn beyond(&self, coarse: &Self) -> Mat<f64> {
        let more = if self.slides && coarse.slides { 1.0 / 3.0 } else { 0.0 };
        Mat::from_fn(self.matrix.nrows(), self.matrix.ncols(), |i, j| {
            let own = self.matrix[(i, j)];
            own + more * (own - coarse.matrix[(i, j)])
        })
    }
}

/// What a period makes of small motions in so many steps.
pub(crate) fn monodromy(
    balance: &HarmonicBalance<'_>,
    cycle: &PeriodicMotion,
    steps: usize,
    go_on: &GoOn<'_>,
) -> Result<Monodromy, CyclesError> {
    let size = balance.bodies().coordinates();
    let step = TAU / cycle.turning.frequency / steps as f64;
    let bodies = balance.bodies().step(step)?;
    // the laws amid the steps
    let series = Series::new(balance.series().harmonics(), 2 * steps);
    let signals = balance.signals_at(&cycle.unknown, cycle.turning)?;
    let projected = balance.projected(&series, &signals);
    // velocities are measured by the frequency, so that the matrix is of the order of one
    let unit = |row: usize, column: usize| f64::from(u8::from(row == column));
    let omega = cycle.turning.frequency;
    let mut x = Mat::from_fn(size, 2 * size, unit);
    let mut v = Mat::from_fn(size, 2 * size, |row, column| omega * unit(row + size, column));
    let compliance = product(bodies.rows.as_ref(), bodies.pushes.as_ref());
    let turns = SlipTurns::of(balance, (&series, &signals), &projected, step);
    let means = MeanLaws::of(balance, (&series, &signals), &projected);
    for which in 0..steps {
        if !go_on() {
            return Err(CyclesError::Stopped);
        }
        let own = (0..balance.contact().points.len())
            .map(|point| match &means {
                Some(means) => means.over(point, which),
                None => *projected.at(2 * turns.law_of(point, which) + 1, point),
            })
            .collect();
        let at = PointsAt { balance, bodies: &bodies, compliance: &compliance, projected: own, step };
        let next = at.advanced(&x, &v)?;
        x = Mat::from_fn(size, 2 * size, |k, j| x[(k, j)] + 0.5 * step * (v[(k, j)] + next[(k, j)]));
        v = next;
        turns.take(balance, which, &mut v, |component, column| {
            bodies.carries(component, x.col_as_slice(column))
        });
    }
    let matrix = Mat::from_fn(2 * size, 2 * size, |row, column| match row < size {
        true => x[(row, column)],
        false => v[(row - size, column)] / omega,
    });
    Ok(Monodromy { matrix, slides: means.is_some() })
}

/// The points amid a step.
struct PointsAt<'s, 'b, 'a> {
    balance: &'b HarmonicBalance<'a>,
    bodies: &'s BodyStep,
    /// P A⁻¹ h Pᵀ.
    compliance: &'s Mat<f64>,
    projected: Vec<ProjectedForce>,
    step: f64,
}

impl PointsAt<'_, '_, '_> {
    /// δv⁺.
    fn advanced(&self, x: &Mat<f64>, v: &Mat<f64>) -> Result<Mat<f64>, CyclesError> {
        let free = self.bodies.free(x, v);
        let rows = self.bodies.rows.as_ref();
        let [place, before, after] = [x, v, &free].map(|own| product(rows, own.as_ref()));
        // y of the step without contact forces, and what these add
        let carried = self.carried(x, v, &free);
        let moved = Mat::from_fn(place.nrows(), place.ncols(), |component, column| {
            let [of_place, of_before, of_after] = self.shares(component);
            let own = of_place * place[(component, column)]
                + of_before * before[(component, column)]
                + of_after * after[(component, column)];
            own - carried.as_ref().map_or(0.0, |carried| carried[(component, column)])
        });
        let matrix =
            self.law(|component, other| self.shares(component)[2] * self.compliance[(component, other)]);
        let mut forces = Mat::from_fn(moved.nrows(), moved.ncols(), |component, column| {
            self.by_motion(component, |other| moved[(other, column)])
        });
        solve(matrix, &mut forces).ok_or(CyclesError::Singular)?;
        Ok(free + product(self.bodies.pushes.as_ref(), forces.as_ref()))
    }

    fn dimension(&self) -> usize {
        self.balance.contact().dimension
    }

    /// Shares of place, of velocities before and after the step in the y that the law takes: amid the step where it is smooth, at its end where it holds a point.
    fn shares(&self, component: usize) -> [f64; 3] {
        let (point, own) = (component / self.dimension(), component % self.dimension());
        let state = self.projected[point].state;
        let is_rigid = !self.balance.contact().is_compliant(point);
        match (own, state) {
            (0, PointMotion::Stick | PointMotion::Slip) if is_rigid => [1.0, 0.0, self.step],
            (0, _) => [1.0, 0.25 * self.step, 0.25 * self.step],
            (_, PointMotion::Stick) => [0.0, 0.0, 1.0],
            _ => [0.0, 0.5, 0.5],
        }
    }

    /// What the passing material brings amid the step, where there is any.
    fn carried(&self, x: &Mat<f64>, v: &Mat<f64>, free: &Mat<f64>) -> Option<Mat<f64>> {
        if self.bodies.convected.is_empty() {
            return None;
        }
        let mut all = Mat::zeros(self.bodies.rows.nrows(), x.ncols());
        for (component, row) in &self.bodies.convected {
            for column in 0..x.ncols() {
                let middle =
                    |k: usize| x[(k, column)] + 0.25 * self.step * (v[(k, column)] + free[(k, column)]);
                all[(*component, column)] = row.iter().enumerate().map(|(k, share)| share * middle(k)).sum();
            }
        }
        Some(all)
    }

    /// Σ ∂π/∂y y of a component.
    fn by_motion(&self, component: usize, motion: impl Fn(usize) -> f64) -> f64 {
        let (dimension, own) = (self.dimension(), component % self.dimension());
        let first = component - own;
        let slopes = &self.projected[component / dimension].by_motion[own];
        (0..dimension).map(|k| slopes[k] * motion(first + k)).sum()
    }

    /// 1 − ∂π/∂λ − ∂π/∂y (∂y/∂λ).
    fn law(&self, moved: impl Fn(usize, usize) -> f64) -> Mat<f64> {
        let dimension = self.dimension();
        let size = self.compliance.nrows();
        Mat::from_fn(size, size, |i, j| {
            let (point, own) = (i / dimension, i % dimension);
            let by_force =
                if j / dimension == point { self.projected[point].by_force[own][j % dimension] } else { 0.0 };
            f64::from(u8::from(i == j)) - by_force - self.by_motion(i, |k| moved(k, j))
        })
    }
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
