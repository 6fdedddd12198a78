//! Periodic motions that a periodic force drives, over its frequency.

use crate::CyclesError;
use crate::backbone::PeriodicMotion;
use crate::balance::{CycleRate, HarmonicBalance, LastEvaluated};
use crate::path::{ClosingEquation, Path, PathEquations, PathPoint, PathRule, corrected};
use faer::Mat;

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
    /// It left the range of frequencies.
    Range,
    /// It has as many motions as were asked for.
    Points,
    /// It was stopped from outside.
    Stopped,
    /// No next motion was found.
    Lost(CyclesError),
}

/// A response over frequency, through its folds.
#[derive(Debug, Clone, PartialEq)]
pub struct ForcedResponse {
    /// In the order along the branch; of one that leaves the range the last lies at its end.
    pub motions: Vec<PeriodicMotion>,
    /// How far along the branch each lies.
    pub along: Vec<f64>,
    /// The motion nearest to where the frequency turns, and the frequency there in rad/s, by a search among the motions between its neighbours.
    pub folds: Vec<(usize, f64)>,
    /// Why it ends.
    pub end: ResponseEnd,
}

/// The balance of harmonics with the frequency as its last unknown.
struct ForcedEquations<'b, 'a> {
    balance: &'b HarmonicBalance<'a>,
    frequency: f64,
    pace: StepMeasure,
    weights: Vec<f64>,
    /// The largest mean square of the forces so far, in the force scale.
    largest: f64,
    last: LastEvaluated,
}

impl<'b, 'a> ForcedEquations<'b, 'a> {
    fn new(balance: &'b HarmonicBalance<'a>, settings: &ResponseSettings) -> Self {
        let [frequency, _] = settings.between;
        let [_, longest, _] = settings.rule.steps;
        let (force, turning) = match settings.pace {
            StepMeasure::Fixed(force) => (balance.force_scale() / force, 1.0),
            StepMeasure::Largest(step) => (1.0, longest * frequency / step),
        };
        let mut weights = vec![force * force / balance.components() as f64; balance.unknowns()];
        weights.push(turning * turning);
        Self {
            balance,
            frequency,
            pace: settings.pace,
            weights,
            largest: 1.0,
            last: LastEvaluated::default(),
        }
    }

    fn turning(&self, at: &[f64]) -> CycleRate {
        CycleRate { frequency: self.frequency * at[self.balance.unknowns()], growth: 0.0 }
    }

    fn motion(&self, point: &PathPoint) -> PeriodicMotion {
        let unknowns = self.balance.unknowns();
        PeriodicMotion {
            unknown: point.at[..unknowns].to_vec(),
            turning: self.turning(&point.at),
            amplitude: 0.0,
            residual: point.residual,
        }
    }

    /// The motion at one frequency in rad/s near a guess; its tangent points as `towards` does.
    fn fixed(
        &mut self,
        guess: &[f64],
        frequency: f64,
        towards: &[f64],
        rule: &PathRule,
    ) -> Result<PathPoint, CyclesError> {
        let last = guess.len() - 1;
        let mut guess = guess.to_vec();
        guess[last] = frequency / self.frequency;
        let closing = ClosingEquation::fixed(last, guess.len(), guess[last]);
        corrected(self, &guess, &closing, towards, rule)
    }

    /// The unknowns of a motion.
    fn place(&self, motion: &PeriodicMotion) -> Vec<f64> {
        motion.unknown.iter().copied().chain([motion.turning.frequency / self.frequency]).collect()
    }

    /// The frequency in rad/s at which the branch through three places turns, by golden sections on planes across the line between the outer ones.
    fn fold(&mut self, [first, amid, last]: &[Vec<f64>; 3], rose: bool, rule: &PathRule) -> f64 {
        /// Sections: a thousandth of the way is left.
        const SECTIONS: usize = 14;
        const GOLDEN: f64 = 0.618_033_988_749_894_9;
        let unknown = amid.len() - 1;
        let sign = if rose { 1.0 } else { -1.0 };
        let way: Vec<f64> = last.iter().zip(first).map(|(a, b)| a - b).collect();
        let start = ClosingEquation::across(&way, &self.weights, first);
        let end = ClosingEquation::across(&way, &self.weights, last).value;
        let place = |share: f64| start.value + share * (end - start.value);
        let own =
            (ClosingEquation::across(&way, &self.weights, amid).value - start.value) / (end - start.value);
        let mut at = |share: f64| {
            let (from, to, part) = match share < own {
                true => (first, amid, share / own),
                false => (amid, last, (share - own) / (1.0 - own)),
            };
            let guess: Vec<f64> = from.iter().zip(to).map(|(a, b)| a + part * (b - a)).collect();
            let closing = ClosingEquation { value: place(share), ..start.clone() };
            corrected(self, &guess, &closing, &way, rule)
                .map_or(f64::NEG_INFINITY, |found| sign * found.at[unknown])
        };
        let mut farthest = sign * amid[unknown];
        let mut between = [0.0, 1.0];
        let mut tried = [1.0 - GOLDEN, GOLDEN].map(|share| (share, at(share)));
        for _ in 0..SECTIONS {
            farthest = farthest.max(tried[0].1).max(tried[1].1);
            if tried[0].1 > tried[1].1 {
                between[1] = tried[1].0;
                let share = between[1] - GOLDEN * (between[1] - between[0]);
                tried = [(share, at(share)), tried[0]];
            } else {
                between[0] = tried[0].0;
                let share = between[0] + GOLDEN * (between[1] - between[0]);
                tried = [tried[1], (share, at(share))];
            }
        }
        self.frequency * sign * farthest
    }

    fn distance(&self, a: &[f64], b: &[f64]) -> f64 {
        a.iter()
            .zip(b)
            .zip(&self.weights)
            .map(|((a, b), weight)| (a - b) * (a - b) * weight)
            .sum::<f64>()
            .sqrt()
    }
}

impl PathEquations for ForcedEquations<'_, '_> {
    fn residual(&mut self, at: &[f64]) -> Result<Vec<f64>, CyclesError> {
        let evaluated = self.balance.evaluated(&at[..self.balance.unknowns()], self.turning(at))?;
        let residual = evaluated.residual.clone();
        self.last.keep(at, evaluated);
        Ok(residual)
    }

    fn linearised(&mut self, at: &[f64]) -> Result<(Vec<f64>, Mat<f64>), CyclesError> {
        let unknowns = self.balance.unknowns();
        let evaluated = match self.last.take(at) {
            Some(evaluated) => evaluated,
            None => self.balance.evaluated(&at[..unknowns], self.turning(at))?,
        };
        let balanced = self.balance.linearised(evaluated, self.turning(at))?;
        let derivative = Mat::from_fn(unknowns, unknowns + 1, |i, j| match j == unknowns {
            true => self.frequency * balanced.jacobian[(i, j)],
            false => balanced.jacobian[(i, j)],
        });
        Ok((balanced.residual, derivative))
    }

    fn weights(&self) -> &[f64] {
        &self.weights
    }

    fn is_sought(&mut self, _: &[f64]) -> Result<bool, CyclesError> {
        Ok(true)
    }

    fn accept(&mut self, at: &[f64]) -> Result<(), CyclesError> {
        if let StepMeasure::Largest(_) = self.pace {
            let (unknowns, components) = (self.balance.unknowns(), self.balance.components() as f64);
            let square = at[..unknowns].iter().map(|own| own * own).sum::<f64>() / components;
            self.largest = self.largest.max(square);
            self.weights[..unknowns].fill(1.0 / (components * self.largest));
        }
        Ok(())
    }
}

/// The motions under the forces of a balance, from the unknowns of a guess at the first frequency on; `go_on` is told how many there are, and may stop them.
///
/// # Errors
/// What the first motion says; what is lost later ends the response.
pub fn forced_response(
    balance: &HarmonicBalance<'_>,
    guess: &[f64],
    settings: &ResponseSettings,
    go_on: &mut dyn FnMut(usize) -> bool,
) -> Result<ForcedResponse, CyclesError> {
    let [from, to] = settings.between;
    let unknowns = balance.unknowns();
    let mut equations = ForcedEquations::new(balance, settings);
    let start: Vec<f64> = guess.iter().copied().chain([1.0]).collect();
    let mut towards = vec![0.0; unknowns + 1];
    towards[unknowns] = (to - from).signum();
    let first = equations.fixed(&start, from, &towards, &settings.rule)?;
    equations.accept(&first.at)?;
    let mut found = ForcedResponse {
        motions: vec![equations.motion(&first)],
        along: vec![0.0],
        folds: Vec::new(),
        end: ResponseEnd::Points,
    };
    let mut path = Path::from(first, settings.rule);
    while found.motions.len() < settings.points {
        if !go_on(found.motions.len()) {
            found.end = ResponseEnd::Stopped;
            break;
        }
        let before = path.point().clone();
        let mut next = match path.go_on(&mut equations) {
            Ok(next) => next.clone(),
            Err(error) => {
                found.end = ResponseEnd::Lost(error);
                break;
            }
        };
        let frequency = equations.turning(&next.at).frequency;
        let leaves = (frequency - from) * (frequency - to) > 0.0;
        if leaves {
            let bound = if (frequency - from).abs() < (frequency - to).abs() { from } else { to };
            let bounded = equations.fixed(&next.at, bound, &next.tangent, &settings.rule);
            // else the motion stays that beyond the range
            next = bounded.unwrap_or(next);
            found.end = ResponseEnd::Range;
        }
        let so_far = found.along[found.along.len() - 1];
        found.along.push(so_far + equations.distance(&before.at, &next.at));
        found.motions.push(equations.motion(&next));
        if leaves {
            break;
        }
    }
    for (motion, rose) in found.turns(to > from, settings.pace.resolved()) {
        let near = [motion - 1, motion, motion + 1].map(|k| equations.place(&found.motions[k]));
        found.folds.push((motion, equations.fold(&near, rose, &settings.rule)));
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
    /// The motions from which the frequency goes back by more than `least` in rad/s, and whether it rose to them; at first it does as told.
    fn turns(&self, mut rises: bool, least: f64) -> Vec<(usize, bool)> {
        let (mut turns, mut farthest) = (Vec::new(), 0);
        for k in 1..self.motions.len() {
            let ahead = self.motions[k].turning.frequency - self.motions[farthest].turning.frequency;
            let ahead = if rises { ahead } else { -ahead };
            if ahead >= 0.0 {
                farthest = k;
            } else if -ahead > least {
                if farthest > 0 {
                    turns.push((farthest, rises));
                }
                (rises, farthest) = (!rises, k);
            }
        }
        turns
    }

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
        // it rises to 1.2475 and goes back to one, and less than what is not looked at is no turn
        assert_eq!(own.turns(true, 0.1), [(2, true)]);
        assert!(own.turns(true, 0.3).is_empty());
        // through three values that rise there is no highest one between them
        assert_eq!(own.highest(1, &|k| along[k]), (0.3, own.motions[1].turning.frequency));
    }
}
