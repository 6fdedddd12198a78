//! The mean slopes of the laws over a step, where no point sticks.
//!
//! Small motions follow the mean of the slopes over a step to second order, whatever jumps amid it; those of its middle are off by first order where a point
//! lifts off or comes back. So the instant at which the gap changes its sign is found, and the step is parted there. From a touch on slopes may grow as a
//! root of the time, so that instants crowd there.

use crate::balance::{HarmonicBalance, PointSignals, ProjectedForces};
use crate::point_law::{COMPONENTS, ProjectedForce, projected};
use crate::series::Series;
use judder_nonsmooth::contact_problem::PointMotion;
use std::f64::consts::TAU;

/// Gauss points on [0, 1] and their weights.
const GAUSS: [(f64, f64); 3] =
    [(0.112_701_665_379_258_31, 5.0 / 18.0), (0.5, 4.0 / 9.0), (0.887_298_334_620_741_7, 5.0 / 18.0)];
/// Halves of a step after which the instant of a touch is known as well as rounding lets it.
const HALVES: usize = 50;

/// The laws along a motion that has no stick.
pub(super) struct MeanLaws<'s, 'b, 'a> {
    balance: &'b HarmonicBalance<'a>,
    signals: &'s PointSignals,
    steps: usize,
}

impl<'s, 'b, 'a> MeanLaws<'s, 'b, 'a> {
    /// Of so many steps, amid and between which the laws are known; none where a point is rigid, sticks, or turns amid slip, nor in space, where forces turn with
    /// the slip.
    pub(super) fn of(
        balance: &'b HarmonicBalance<'a>,
        (series, signals): (&Series, &'s PointSignals),
        laws: &ProjectedForces,
    ) -> Option<Self> {
        let contact = balance.contact();
        let is_smooth = |point: usize| {
            let all = laws.of_point(point);
            let pushes = all.iter().filter(|own| own.state != PointMotion::Open).map(|own| own.force[1]);
            let (low, high) =
                pushes.fold((0.0_f64, 0.0_f64), |(low, high), own| (low.min(own), high.max(own)));
            contact.is_compliant(point)
                && all.iter().all(|own| own.state != PointMotion::Stick)
                && (low == 0.0 || high == 0.0)
        };
        let all = contact.dimension == 2 && (0..contact.points.len()).all(is_smooth);
        all.then(|| Self { balance, signals, steps: series.samples() / 2 })
    }

    /// The motion or the force of a component at an instant, in steps.
    fn value(&self, of_motion: bool, component: usize, at: f64) -> f64 {
        let coefficients = if of_motion { &self.signals.motions } else { &self.signals.forces };
        let own = coefficients.col(component);
        let turn = TAU * at / self.steps as f64;
        let harmonic = |h: usize| {
            let (sine, cosine) = (h as f64 * turn).sin_cos();
            own[2 * h - 1] * cosine + own[2 * h] * sine
        };
        own[0] + (1..=own.nrows() / 2).map(harmonic).sum::<f64>()
    }

    fn gap(&self, point: usize, at: f64) -> f64 {
        self.value(true, point * self.balance.contact().dimension, at)
    }

    fn law(&self, point: usize, at: f64) -> ProjectedForce {
        let dimension = self.balance.contact().dimension;
        let of = |of_motion: bool| {
            let mut own = [0.0; COMPONENTS];
            for (k, own) in own.iter_mut().take(dimension).enumerate() {
                *own = self.value(of_motion, point * dimension + k, at);
            }
            own
        };
        projected(&self.balance.contact().points[point], self.balance.scales()[point], of(false), of(true))
    }

    /// Where amid a step the gap changes its sign, where it does.
    fn touch(&self, point: usize, step: usize) -> Option<f64> {
        let [mut from, mut to] = [step as f64, (step + 1) as f64];
        let is_open = self.gap(point, from) >= 0.0;
        if is_open == (self.gap(point, to) >= 0.0) {
            return None;
        }
        for _ in 0..HALVES {
            let middle = 0.5 * (from + to);
            if (self.gap(point, middle) >= 0.0) == is_open { from = middle } else { to = middle }
        }
        Some(0.5 * (from + to))
    }

    /// The mean of the law of a point over a step.
    pub(super) fn over(&self, point: usize, step: usize) -> ProjectedForce {
        let [from, to] = [step as f64, (step + 1) as f64];
        let mut mean = ProjectedForce { state: PointMotion::Open, ..ProjectedForce::default() };
        match self.touch(point, step) {
            None => {
                for (node, weight) in GAUSS {
                    add(&mut mean, &self.law(point, from + node), weight);
                }
            }
            Some(touch) => {
                for end in [from, to] {
                    for (node, weight) in GAUSS {
                        let own = self.law(point, touch + (end - touch) * node * node);
                        add(&mut mean, &own, 2.0 * node * weight * (end - touch).abs());
                    }
                }
            }
        }
        mean
    }
}

/// Adds a share of a law, which closes the mean where it is closed.
fn add(mean: &mut ProjectedForce, own: &ProjectedForce, share: f64) {
    if own.state != PointMotion::Open {
        mean.state = own.state;
    }
    for k in 0..COMPONENTS {
        mean.force[k] += share * own.force[k];
        for j in 0..COMPONENTS {
            mean.by_motion[k][j] += share * own.by_motion[k][j];
            mean.by_force[k][j] += share * own.by_force[k][j];
        }
    }
}
