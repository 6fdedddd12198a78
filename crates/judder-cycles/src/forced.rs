//! Periodic motions that a periodic force drives, over its frequency.

use crate::CyclesError;
use crate::backbone::PeriodicMotion;
use crate::balance::HarmonicBalance;
use crate::extended::{ExtendedBalance, Free};
use crate::path::{ClosingEquation, GoOn, Newton, PathEquations, PathRule, distance, ended, follow};
use crate::turning::{extreme, turns};

/// How a response is followed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ResponseSettings {
    /// How solutions are sought.
    pub rule: PathRule,
    /// The first and the last angular frequency in rad/s.
    pub between: [f64; 2],
    /// The most motions.
    pub points: usize,
    /// What a step is a share of.
    pub pace: StepMeasure,
}

/// What a step along a response is a share of.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum StepMeasure {
    /// Of so many newtons, and of the first frequency.
    Fixed(f64),
    /// Of the largest forces so far, at least the force scale; the longest step goes on by at most so many rad/s.
    Largest(f64),
}

/// Why a response ends.
#[derive(Debug, Clone, PartialEq)]
pub enum ResponseEnd {
    /// It came to an end of the range of frequencies, where its last motion lies.
    Range,
    /// It has as many motions as were asked for.
    Points,
    /// No next motion was found.
    Lost(CyclesError),
}

/// A response over frequency, through its folds.
#[derive(Debug, Clone, PartialEq)]
pub struct ForcedResponse {
    /// In the order along the branch.
    pub motions: Vec<PeriodicMotion>,
    /// How far along the branch each lies.
    pub along: Vec<f64>,
    /// The motion nearest to where the frequency turns, and the frequency there in rad/s, by a search among the motions between its neighbours.
    pub folds: Vec<(usize, f64)>,
    /// Why it ends.
    pub end: ResponseEnd,
}

/// The balance with the frequency as its last unknown.
type ForcedEquations<'b, 'a> = ExtendedBalance<&'b HarmonicBalance<'a>>;

fn equations<'b, 'a>(
    balance: &'b HarmonicBalance<'a>,
    settings: &ResponseSettings,
) -> ForcedEquations<'b, 'a> {
    let [from, to] = settings.between;
    let [_, longest, _] = settings.rule.steps;
    let mut equations = ExtendedBalance::new(balance, balance, from, Free::Nothing, None);
    equations.keep_within([from.min(to), from.max(to)]);
    match settings.pace {
        StepMeasure::Fixed(force) => equations.weigh(balance.force_scale() / force, 1.0, false),
        StepMeasure::Largest(step) => equations.weigh(1.0, longest * from / step, true),
    }
    equations
}

/// The motions under the forces of a balance, from the unknowns of a guess at the first frequency on.
///
/// # Errors
/// What the first motion says; what is lost later ends the response. [`CyclesError::Stopped`].
pub fn forced_response(
    balance: &HarmonicBalance<'_>,
    guess: &[f64],
    settings: &ResponseSettings,
    go_on: &GoOn<'_>,
) -> Result<ForcedResponse, CyclesError> {
    let [from, to] = settings.between;
    let unknowns = balance.unknowns();
    let (mut equations, mut newton) = (equations(balance, settings), Newton::new(settings.rule, go_on));
    let start: Vec<f64> = guess.iter().copied().chain([1.0]).collect();
    let mut towards = vec![0.0; unknowns + 1];
    towards[unknowns] = (to - from).signum();
    let closing = ClosingEquation::fixed(unknowns, start.len(), 1.0);
    let mut first = newton.corrected(&mut equations, &start, &closing, &towards)?;
    first.at[unknowns] = 1.0;
    equations.accept(&first.at)?;
    let (mut motions, mut along) = (vec![equations.motion(&first)?], vec![0.0]);
    let points = settings.points;
    let end = follow(&mut newton, &mut equations, first, points, |equations, _, [before, next]| {
        along.push(along[along.len() - 1] + distance(&before.at, &next.at, equations.weights()));
        motions.push(equations.motion(next)?);
        Ok(equations.ends().contains(&next.at[unknowns]).then_some(ResponseEnd::Range))
    });
    let end = ended(end, ResponseEnd::Points, ResponseEnd::Lost)?;
    let mut found = ForcedResponse { motions, along, folds: Vec::new(), end };
    let frequencies: Vec<f64> = found.motions.iter().map(|own| own.turning.frequency).collect();
    for (motion, rose) in turns(&frequencies, to > from, settings.pace.resolved()) {
        let near = [motion - 1, motion, motion + 1].map(|k| equations.place(&found.motions[k], 0.0));
        let near = near.each_ref().map(Vec::as_slice);
        let turn = extreme(&mut equations, &mut newton, near, (unknowns, rose))?;
        found.folds.push((motion, from * turn));
    }
    Ok(found)
}

impl StepMeasure {
    /// By how much the frequency goes back beyond a fold, in rad/s, at least: less is that of points that change their state from one instant to the next.
    fn resolved(self) -> f64 {
        match self {
            Self::Fixed(_) => 0.0,
            Self::Largest(step) => 0.2 * step,
        }
    }
}

impl ForcedResponse {
    /// The largest value of the parabola along the branch through a motion and its neighbours, and the frequency in rad/s there; those of the motion itself where it has only one.
    #[must_use]
    pub fn highest(&self, motion: usize, value: &dyn Fn(usize) -> f64) -> (f64, f64) {
        let frequency = |k: usize| self.motions[k].turning.frequency;
        let here = (value(motion), frequency(motion));
        if motion == 0 || motion + 1 >= self.motions.len() {
            return here;
        }
        let near = [motion - 1, motion, motion + 1];
        let [back, ahead] = [motion - 1, motion + 1].map(|k| self.along[k] - self.along[motion]);
        // a + b s + c s² through all three
        let through = |of: &dyn Fn(usize) -> f64| {
            let [before, own, after] = near.map(of);
            let (left, right) = ((before - own) / back, (after - own) / ahead);
            let curvature = (right - left) / (ahead - back);
            [own, left - curvature * back, curvature]
        };
        let [own, slope, curvature] = through(value);
        let place = -0.5 * slope / curvature;
        if !(curvature < 0.0 && place >= back && place <= ahead) {
            return here;
        }
        let [at, along, bend] = through(&frequency);
        (own + 0.5 * slope * place, at + along * place + bend * place * place)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::balance::CycleRate;

    /// A branch whose frequency is 1 + s − s², of so many motions.
    fn branch(along: &[f64]) -> ForcedResponse {
        let motion = |s: &f64| PeriodicMotion {
            unknown: Vec::new(),
            turning: CycleRate { frequency: 1.0 + s - s * s, growth: 0.0 },
            amplitude: 0.0,
            residual: 0.0,
        };
        ForcedResponse {
            motions: along.iter().map(motion).collect(),
            along: along.to_vec(),
            folds: Vec::new(),
            end: ResponseEnd::Range,
        }
    }

    #[test]
    fn peaks_of_parabolas_are_exact() {
        let along = [0.0, 0.3, 0.55, 1.0];
        let own = branch(&along);
        let value = |k: usize| 2.0 - (along[k] - 0.4) * (along[k] - 0.4);
        let (most, frequency) = own.highest(1, &value);
        assert!((most - 2.0).abs() < 1e-14 && (frequency - 1.24).abs() < 1e-14);
        assert_eq!(own.highest(0, &value), (value(0), 1.0));
        // through three values that rise there is no highest one between them
        assert_eq!(own.highest(1, &|k| along[k]), (0.3, own.motions[1].turning.frequency));
    }
}
