//! Where slip turns without sticking.
//!
//! Friction that jumps from −b to b brakes a point that turns; where it does not hold it, what differs by δv before differs by (a⁺/a⁻) δv after, a the accelerations of the slip
//! on either side (M. A. Aizerman, F. R. Gantmakher 1958). Harmonics, which have no jumps, show a short stick there: the point sticks where b is enough to hold it,
//! |ā| < G b with the mean acceleration ā as it turns and the mobility G = P M⁻¹ Pᵀ, and turns otherwise.
//!
//! Harmonics ripple, too, and a long stick may show slivers of slip: what slips between two sticks for less than half a wave of the last harmonic is no slip that they know, and sticks;
//! and slip that friction does not brake has its sign from the ripple alone, and begins or ends no turn.

use crate::balance::{HarmonicBalance, PointSignals, ProjectedForces};
use crate::series::Series;
use faer::Mat;
use judder_nonsmooth::contact_problem::PointMotion;

/// A turn of a point in the plane.
#[derive(Debug, Clone, Copy)]
struct SlipTurn {
    point: usize,
    /// The last step before and the first one after it, this one counted on beyond the period.
    between: [usize; 2],
    /// a⁺/a⁻.
    factor: f64,
}

/// All turns of a period.
pub(super) struct SlipTurns {
    steps: usize,
    dimension: usize,
    turns: Vec<SlipTurn>,
    /// M⁻¹ Pᵀ.
    mobility: Mat<f64>,
}

impl SlipTurns {
    /// Those among so many steps of a motion, amid which the laws are known; none in space, where slip turns round, nor where a freedom has no mass.
    pub(super) fn of(
        balance: &HarmonicBalance<'_>,
        (series, signals): (&Series, &PointSignals),
        projected: &ProjectedForces,
        step: f64,
    ) -> Self {
        let (dimension, steps) = (balance.contact().dimension, series.samples() / 2);
        let mobility = balance.bodies().mobility().filter(|_| dimension == 2);
        let mut found =
            Self { steps, dimension, turns: Vec::new(), mobility: mobility.unwrap_or_else(Mat::new) };
        if found.mobility.ncols() == 0 {
            return found;
        }
        let motions = series.values(signals.motions.as_ref());
        for point in 0..balance.contact().points.len() {
            let component = point * dimension + 1;
            let yields = balance.bodies().displaced_by(component, found.mobility.col_as_slice(component));
            let at = |k: usize| 2 * (k % steps) + 1;
            let speed = |k: usize| motions[(at(k), component)];
            let law = |k: usize| projected.at(at(k), point);
            let states: Vec<PointMotion> = (0..steps).map(|k| law(k).state).collect();
            let states = without_slivers(&states, steps / (2 * series.harmonics()));
            let is_braked =
                |k: usize| states[k % steps] == PointMotion::Slip && law(k).force[1] * speed(k) < 0.0;
            for before in (0..steps).filter(|k| is_braked(*k)) {
                let amid =
                    (1..steps).take_while(|k| states[(before + k) % steps] == PointMotion::Stick).count();
                let after = before + amid + 1;
                if !is_braked(after) || speed(before) * speed(after) >= 0.0 {
                    continue;
                }
                let mean = (speed(after) - speed(before)) / (step * (amid + 1) as f64);
                let jump = 0.5 * yields * (law(after).force[1] - law(before).force[1]);
                let [slows, goes_on] = [mean - jump, mean + jump];
                if mean * goes_on > 0.0 && mean * slows > 0.0 {
                    let factor = goes_on / slows;
                    found.turns.push(SlipTurn { point, between: [before, after], factor });
                }
            }
        }
        found
    }

    /// The step whose law a point has at a step: while it turns that before or after.
    pub(super) fn law_of(&self, point: usize, step: usize) -> usize {
        let is_amid = |own: &&SlipTurn| own.point == point && self.offset(own, step).is_some();
        match self.turns.iter().find(is_amid) {
            Some(own) if self.offset(own, step) <= Some(own.half()) => own.between[0],
            Some(own) => own.between[1] % self.steps,
            None => step,
        }
    }

    /// How many steps after the last one before a turn a step lies, where it is one amid.
    fn offset(&self, own: &SlipTurn, step: usize) -> Option<usize> {
        let [before, after] = own.between;
        let offset = (step + self.steps - before) % self.steps;
        (offset < after - before).then_some(offset)
    }

    /// What turns make of differences of the velocities after a step; `carried` is what the passing material brings to a component of a column.
    pub(super) fn take(
        &self,
        balance: &HarmonicBalance<'_>,
        step: usize,
        v: &mut Mat<f64>,
        carried: impl Fn(usize, usize) -> f64,
    ) {
        for own in self.turns.iter().filter(|own| self.offset(own, step) == Some(own.half())) {
            let component = own.point * self.dimension + 1;
            let push = self.mobility.col_as_slice(component);
            let yields = balance.bodies().displaced_by(component, push);
            for column in 0..v.ncols() {
                let slip = balance.bodies().displaced_by(component, v.col_as_slice(column))
                    - carried(component, column);
                let impulse = (own.factor - 1.0) * slip / yields;
                v.col_as_slice_mut(column).iter_mut().zip(push).for_each(|(v, push)| *v += impulse * push);
            }
        }
    }
}

/// What a point does at the steps of a period, where slip between two sticks for less than so many steps is taken for stick.
fn without_slivers(states: &[PointMotion], least: usize) -> Vec<PointMotion> {
    let at = |k: usize| states[k % states.len()];
    let mut own = states.to_vec();
    for stuck in (0..states.len()).filter(|k| at(*k) == PointMotion::Stick) {
        let slips = (1..=least).take_while(|k| at(stuck + k) == PointMotion::Slip).count();
        if slips < least && at(stuck + slips + 1) == PointMotion::Stick {
            (1..=slips).for_each(|k| own[(stuck + k) % states.len()] = PointMotion::Stick);
        }
    }
    own
}

impl SlipTurn {
    /// The steps after the last one before it at whose end it is.
    fn half(&self) -> usize {
        (self.between[1] - self.between[0]) / 2
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn short_slip_between_two_sticks_is_stick() {
        let states = |told: &str| -> Vec<PointMotion> {
            let of = |own: char| match own {
                's' => PointMotion::Slip,
                'o' => PointMotion::Open,
                _ => PointMotion::Stick,
            };
            told.chars().map(of).collect()
        };
        for (told, least, expected) in [
            ("ss-s--ss", 2, "ss----ss"),
            // around the end of the period
            ("s--sss-s", 3, "---sss--"),
            ("s--ss-oo", 3, "s-----oo"),
            // as long as what is known, next to what is open, and where steps are few
            ("--ss--ss", 2, "--ss--ss"),
            ("-sos-sss", 3, "-sos-sss"),
            ("-s-ssss-", 0, "-s-ssss-"),
            ("-sssssss", 4, "-sssssss"),
            ("ssssssss", 4, "ssssssss"),
        ] {
            assert_eq!(without_slivers(&states(told), least), states(expected), "{told}");
        }
    }
}
