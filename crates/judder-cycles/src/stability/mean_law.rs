//! The mean slopes of the laws over a step, where no point sticks.
//!
//! Small motions follow the mean of the slopes over a step to second order. Where these jump amid it, as a point lifts off or comes back, the error is another at
//! each place of the jump in its step, and does not fall evenly: so the instant at which the gap changes its sign is found, and the step is parted there. From a
//! touch on slopes may grow as a root of the time, so that instants crowd there.

use crate::balance::{HarmonicBalance, PointSignals, ProjectedForces};
use crate::point_law::{COMPONENTS, ProjectedForce, projected};
use crate::series::Series;
use judder_nonsmooth::contact_problem::PointMotion;
use judder_numerics::order::sort_numbers;
use judder_numerics::quadrature::gauss_legendre;
use std::f64::consts::TAU;

/// Instants from the beginning of a step on, halves of it, and their weights.
const SIMPSON: [(usize, f64); 3] = [(0, 1.0 / 6.0), (1, 2.0 / 3.0), (2, 1.0 / 6.0)];
/// Halves of a step after which the instant of a touch is known as well as rounding lets it.
const HALVES: usize = 50;

/// Steps beside a touch within which instants of their own are taken.
const NEAR: f64 = 8.0;

/// The laws along a motion that has no stick.
pub(super) struct MeanLaws<'s, 'b, 'a> {
    balance: &'b HarmonicBalance<'a>,
    signals: &'s PointSignals,
    /// At both ends of each step and amid it.
    laws: &'s ProjectedForces,
    steps: usize,
    /// Where each point lifts off or comes back, in steps.
    touches: Vec<Vec<f64>>,
}

impl<'s, 'b, 'a> MeanLaws<'s, 'b, 'a> {
    /// Of so many steps, amid and between which the laws are known; none where a point is rigid, sticks, or turns amid slip, nor in space, where forces turn with
    /// the slip.
    pub(super) fn of(
        balance: &'b HarmonicBalance<'a>,
        (series, signals): (&Series, &'s PointSignals),
        laws: &'s ProjectedForces,
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
        if contact.dimension != 2 || !(0..contact.points.len()).all(is_smooth) {
            return None;
        }
        let mut own = Self { balance, signals, laws, steps: series.samples() / 2, touches: Vec::new() };
        own.touches = (0..contact.points.len())
            .map(|point| (0..own.steps).filter_map(|step| own.touch(point, step)).collect())
            .collect();
        Some(own)
    }

    /// The motion or the force of a component at an instant, in steps.
    fn value(&self, of_motion: bool, component: usize, at: f64) -> f64 {
        let coefficients = if of_motion { &self.signals.motions } else { &self.signals.forces };
        let own = coefficients.col(component);
        let turn = TAU * at / self.steps as f64;
        let harmonic = |h: usize| {
            let (sine, cosine) = libm::sincos(h as f64 * turn);
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

    /// Where amid a step a point lifts off or comes back, where it does.
    fn touch(&self, point: usize, step: usize) -> Option<f64> {
        let is_open =
            |instant: usize| self.laws.at(instant % (2 * self.steps), point).state == PointMotion::Open;
        if is_open(2 * step) == is_open(2 * step + 2) {
            return None;
        }
        let [mut from, mut to] = [step as f64, (step + 1) as f64];
        for _ in 0..HALVES {
            let middle = 0.5 * (from + to);
            if (self.gap(point, middle) >= 0.0) == is_open(2 * step) { from = middle } else { to = middle }
        }
        Some(0.5 * (from + to))
    }

    /// The parts of a step between which no point lifts off or comes back, in steps.
    pub(super) fn parts(&self, step: usize) -> Vec<[f64; 2]> {
        let [from, to] = [step as f64, (step + 1) as f64];
        let amid = |own: &&f64| (from..to).contains(*own);
        let mut cuts: Vec<f64> = self.touches.iter().flatten().filter(amid).copied().collect();
        cuts.extend([from, to]);
        sort_numbers(&mut cuts);
        cuts.windows(2).filter(|own| own[1] > own[0]).map(|own| [own[0], own[1]]).collect()
    }

    /// The mean of the law of a point over a step or a part of it.
    pub(super) fn over(&self, point: usize, [from, to]: [f64; 2]) -> ProjectedForce {
        let steps = self.steps as f64;
        let away = |touch: f64| {
            let off = (0.5 * (from + to) - touch).abs();
            off.min(steps - off)
        };
        let mut mean = ProjectedForce { state: PointMotion::Open, ..ProjectedForce::default() };
        let nearest = self.touches[point].iter().copied().min_by(|a, b| away(*a).total_cmp(&away(*b)));
        let is_whole = to - from == 1.0;
        match nearest {
            Some(touch) if touch == from || touch == to => {
                let other = from + to - touch;
                for (node, weight) in gauss_legendre::<3>() {
                    add(
                        &mut mean,
                        &self.law(point, touch + (other - touch) * node * node),
                        2.0 * node * weight,
                    );
                }
            }
            Some(touch) if !is_whole || away(touch) < NEAR => {
                for (node, weight) in gauss_legendre::<3>() {
                    add(&mut mean, &self.law(point, from + (to - from) * node), weight);
                }
            }
            None if !is_whole => add(&mut mean, &self.law(point, 0.5 * (from + to)), 1.0),
            _ => {
                for (instant, weight) in SIMPSON {
                    let own = self.laws.at((2 * from as usize + instant) % (2 * self.steps), point);
                    add(&mut mean, own, weight);
                }
            }
        }
        mean
    }
}

/// Adds a share of a law, which closes the mean where it is closed.
pub(super) fn add(mean: &mut ProjectedForce, own: &ProjectedForce, share: f64) {
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
