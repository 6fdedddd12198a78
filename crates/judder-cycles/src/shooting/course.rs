//! What the points of a march do once around a cycle, and when.
//!
//! A march changes the state of a point from a step to the next. When it changes in between is told by what goes before: where the slip velocity vanishes a point is
//! caught, where friction comes to its bound it is let go, where the gap vanishes it lifts off or comes back.

use crate::balance::HarmonicBalance;
use judder_nonsmooth::contact::ContactPoints;
use judder_nonsmooth::contact_problem::{FrictionCondition, PointMotion};
use judder_nonsmooth::march::NonsmoothMarch;
use judder_numerics::order::sort_by_number;

/// What a point does in a step.
#[derive(Debug, Clone, Copy)]
struct PointInStep {
    motion: PointMotion,
    /// N and T in N.
    force: [f64; 2],
    /// At its end, in m and m/s.
    gap: f64,
    slip: f64,
}

/// The state of a point in the plane between two changes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum PointPhase {
    Open,
    Stick,
    /// With the sign of its slip.
    Slip(f64),
}

/// A point changes its state.
#[derive(Debug, Clone, Copy)]
pub(crate) struct PhaseChange {
    /// In steps.
    pub(crate) at: f64,
    point: usize,
    from: PointPhase,
    pub(crate) to: PointPhase,
}

/// What a point does at an instant.
#[derive(Debug, Clone, Copy)]
pub(crate) struct PointAtInstant {
    pub(crate) phase: PointPhase,
    /// N in N.
    pub(crate) normal: f64,
    pub(crate) gap: f64,
    pub(crate) slip: f64,
}

/// The steps of a march once around, point by point.
#[derive(Debug, Clone)]
pub(crate) struct ShotCourse {
    points: Vec<Vec<PointInStep>>,
}

impl ShotCourse {
    pub(crate) fn new(balance: &HarmonicBalance<'_>) -> Self {
        Self { points: vec![Vec::new(); balance.contact().points.len()] }
    }

    /// Takes the step that a march is at.
    pub(crate) fn take(&mut self, balance: &HarmonicBalance<'_>, march: &NonsmoothMarch<'_>) {
        let (bodies, dimension) = (balance.bodies(), balance.contact().dimension);
        let x = if bodies.is_passed() { bodies.to_coordinates(&march.state()[0]) } else { Vec::new() };
        for (point, steps) in self.points.iter_mut().enumerate() {
            let [normal, friction, _] = march.force(point);
            let passes = bodies.carries(point * dimension + 1, &x);
            steps.push(PointInStep {
                motion: march.motion(point),
                force: [normal, friction],
                gap: march.gap(point),
                slip: march.velocity(point)[1] - balance.contact().speed(point) - passes,
            });
        }
    }

    pub(crate) fn steps(&self) -> usize {
        self.points.first().map_or(0, Vec::len)
    }

    /// A step of a point, counted around.
    fn step(&self, point: usize, step: isize) -> &PointInStep {
        let all = &self.points[point];
        &all[step.rem_euclid(all.len() as isize) as usize]
    }

    fn phase(&self, point: usize, step: isize) -> PointPhase {
        let own = self.step(point, step);
        match own.motion {
            PointMotion::Open => PointPhase::Open,
            PointMotion::Stick => PointPhase::Stick,
            PointMotion::Slip => PointPhase::Slip(own.slip.signum()),
        }
    }

    /// All changes, in their order; none where a rigid point touches, or slip turns without stick: what these do is not told by the steps.
    pub(crate) fn changes(&self, contact: &ContactPoints<'_>) -> Option<Vec<PhaseChange>> {
        let mut changes = Vec::new();
        for point in 0..self.points.len() {
            let mut last = f64::NEG_INFINITY;
            for step in 0..self.steps() as isize {
                let [from, to] = [step - 1, step].map(|own| self.phase(point, own));
                if from == to {
                    continue;
                }
                let before = match (from, to) {
                    (PointPhase::Slip(_), PointPhase::Slip(_)) => return None,
                    (PointPhase::Open, _) | (_, PointPhase::Open) if !contact.is_compliant(point) => {
                        return None;
                    }
                    (PointPhase::Open, _) | (_, PointPhase::Open) => self.touch(point, step),
                    (_, PointPhase::Stick) => self.catch(point, step),
                    _ => self.release(contact, point, step),
                };
                last = (step as f64 + before).max(last);
                changes.push(PhaseChange { at: last, point, from, to });
            }
        }
        let steps = self.steps() as f64;
        changes.iter_mut().for_each(|own| own.at = own.at.rem_euclid(steps));
        sort_by_number(&mut changes, |own| own.at);
        Some(changes)
    }

    /// Where the gap vanishes next to the beginning of a step, from there on.
    fn touch(&self, point: usize, step: isize) -> f64 {
        let [before, at, after] = [2, 1, 0].map(|back| self.step(point, step - back).gap);
        match (at * after < 0.0, before * at < 0.0) {
            (true, _) => at / (at - after),
            (false, true) => at / (before - at),
            _ => 0.0,
        }
    }

    /// Where the slip velocity that it has before a step vanishes in it: of the parabola through its last three.
    fn catch(&self, point: usize, step: isize) -> f64 {
        /// Steps of Newton's method.
        const STEPS: usize = 4;
        let [first, second, third] = [1, 2, 3].map(|back| self.step(point, step - back).slip);
        let [slope, bend] = [first - second, first - 2.0 * second + third];
        let mut at = -first / slope;
        for _ in 0..STEPS {
            at -= (first + at * slope + 0.5 * at * (at + 1.0) * bend) / (slope + (at + 0.5) * bend);
        }
        if at.is_finite() { at.clamp(0.0, 1.0) } else { 0.0 }
    }

    /// Where friction comes to its bound about the beginning of a step before which the point sticks.
    fn release(&self, contact: &ContactPoints<'_>, point: usize, step: isize) -> f64 {
        let left = |step: isize| {
            let own = self.step(point, step);
            // a march takes the coefficient where a step begins
            let closure = -self.step(point, step - 1).gap;
            let bound = match contact.friction(point, closure, 0.0, 1.0) {
                FrictionCondition::Law { law, factor } => factor * law.at(0.0).coefficient,
                FrictionCondition::Now { at_rest, .. } => at_rest,
                FrictionCondition::Sliding { coefficient } => coefficient,
            };
            bound * own.force[0] - own.force[1].abs()
        };
        // that in which it is caught has more friction than it is held by
        if [2, 3].iter().any(|back| self.phase(point, step - back) != PointPhase::Stick) {
            return 0.0;
        }
        // mean forces of steps are those of their middle
        let [last, before] = [1, 2].map(|back| left(step - back));
        let at = last / (before - last);
        if at.is_finite() { at.clamp(0.0, 1.0) - 0.5 } else { 0.0 }
    }

    /// What a point does at an instant between two changes, in steps.
    pub(crate) fn at(&self, changes: &[PhaseChange], point: usize, instant: f64) -> PointAtInstant {
        let of_point = || changes.iter().filter(|own| own.point == point);
        let steps = self.steps() as f64;
        let began = of_point().rev().find(|own| own.at <= instant).copied();
        let began = began.or_else(|| of_point().next_back().map(|own| own.moved_by(-steps)));
        let ends = of_point().find(|own| own.at > instant).copied();
        let ends = ends.or_else(|| of_point().next().map(|own| own.moved_by(steps)));
        let step = instant.floor() as isize;
        let [from, to] = [step - 1, step].map(|own| self.step(point, own));
        let phase = began.map_or_else(|| self.phase(point, 0), |own| own.to);
        let slip = match phase {
            PointPhase::Slip(sign) => sign * self.speed(point, [began, ends], instant),
            PointPhase::Open | PointPhase::Stick => 0.0,
        };
        let gap = from.gap + (instant - instant.floor()) * (to.gap - from.gap);
        PointAtInstant { phase, normal: to.force[0], gap, slip }
    }

    /// The speed of a slip from one change to another, from those at the ends of the steps between them: none where it begins from stick, and grows there with the
    /// square of the time, none where it is caught.
    fn speed(&self, point: usize, [began, ends]: [Option<PhaseChange>; 2], instant: f64) -> f64 {
        /// Instants that a polynomial goes through.
        const NODES: usize = 4;
        /// A share of a step from a change on that tells instants apart.
        const APART: f64 = 0.05;
        let stuck = began.filter(|own| own.from == PointPhase::Stick).map(|own| own.at);
        let caught = ends.filter(|own| own.to == PointPhase::Stick).map(|own| own.at);
        let [first, last] =
            [began.map_or(f64::NEG_INFINITY, |own| own.at), ends.map_or(f64::INFINITY, |own| own.at)];
        let grows = stuck.is_some() && instant - first < last - instant;
        let here = instant.floor() as isize;
        let reach = NODES as isize;
        let mut nodes: Vec<(f64, f64)> = (here - reach..=here + reach)
            .filter(|own| *own as f64 > first + APART && (*own as f64) < last - APART)
            .map(|own| (own as f64, self.step(point, own - 1).slip.abs()))
            .chain(stuck.into_iter().chain(caught).map(|own| (own, 0.0)))
            .collect();
        sort_by_number(&mut nodes, |own| (own.0 - instant).abs());
        nodes.truncate(NODES);
        if grows {
            nodes.iter_mut().for_each(|own| own.1 = own.1.sqrt());
        }
        let through = through(&nodes, instant);
        if grows { through * through } else { through.max(0.0) }
    }
}

impl PhaseChange {
    fn moved_by(self, steps: f64) -> Self {
        Self { at: self.at + steps, ..self }
    }
}

/// The polynomial through these (J. L. Lagrange).
fn through(nodes: &[(f64, f64)], at: f64) -> f64 {
    let share = |k: usize| -> f64 {
        let others = nodes.iter().enumerate().filter(|(other, _)| *other != k);
        others.map(|(_, other)| (at - other.0) / (nodes[k].0 - other.0)).product()
    };
    nodes.iter().enumerate().map(|(k, own)| own.1 * share(k)).sum()
}
