//! Periodic motions that a periodic force drives, over its frequency.

use crate::CyclesError;
use crate::backbone::PeriodicMotion;
use crate::balance::{CycleRate, HarmonicBalance, LastEvaluated};
use crate::path::{ClosingEquation, Path, PathEquations, PathPoint, PathRule, corrected};
use faer::Mat;

/// How a response is followed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ResponseSettings {
    /// How solutions are sought; of a step along the frequency, one is the whole of the first frequency.
    pub rule: PathRule,
    /// The first and the last angular frequency in rad/s.
    pub between: [f64; 2],
    /// The most motions.
    pub points: usize,
}

/// Why a response ends.
#[derive(Debug, Clone, PartialEq)]
pub enum ResponseEnd {
    /// It left the range of frequencies.
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
    /// The motion after which the frequency turns, and the frequency there in rad/s, between the neighbours.
    pub folds: Vec<(usize, f64)>,
    /// Why it ends.
    pub end: ResponseEnd,
}

/// The balance of harmonics with the frequency as its last unknown.
struct ForcedEquations<'b, 'a> {
    balance: &'b HarmonicBalance<'a>,
    frequency: f64,
    weights: Vec<f64>,
    last: LastEvaluated,
}

impl ForcedEquations<'_, '_> {
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

    fn accept(&mut self, _: &[f64]) -> Result<(), CyclesError> {
        Ok(())
    }
}

/// The motions under the forces of a balance, from the unknowns of a guess at the first frequency on.
///
/// # Errors
/// What the first motion says; what is lost later ends the response.
pub fn forced_response(
    balance: &HarmonicBalance<'_>,
    guess: &[f64],
    settings: &ResponseSettings,
) -> Result<ForcedResponse, CyclesError> {
    let [from, to] = settings.between;
    let unknowns = balance.unknowns();
    let mut weights = vec![1.0 / balance.components() as f64; unknowns];
    weights.push(1.0);
    let mut equations = ForcedEquations { balance, frequency: from, weights, last: LastEvaluated::default() };
    let start: Vec<f64> = guess.iter().copied().chain([1.0]).collect();
    let closing = ClosingEquation::fixed(unknowns, unknowns + 1, 1.0);
    let towards: Vec<f64> = closing.row.iter().map(|own| own * (to - from).signum()).collect();
    let first = corrected(&mut equations, &start, &closing, &towards, &settings.rule)?;
    let mut found = ForcedResponse {
        motions: vec![equations.motion(&first)],
        folds: Vec::new(),
        end: ResponseEnd::Points,
    };
    let mut path = Path::from(first, settings.rule);
    while found.motions.len() < settings.points {
        let before = path.point().tangent[unknowns];
        match path.go_on(&mut equations) {
            Ok(next) => {
                let motion = equations.motion(next);
                if before * next.tangent[unknowns] < 0.0 {
                    let last = found.motions.len() - 1;
                    let pair = [found.motions[last].turning.frequency, motion.turning.frequency];
                    let turn = if before > 0.0 { pair[0].max(pair[1]) } else { pair[0].min(pair[1]) };
                    found.folds.push((last, turn));
                }
                let frequency = motion.turning.frequency;
                found.motions.push(motion);
                if (frequency - from) * (frequency - to) > 0.0 {
                    found.end = ResponseEnd::Range;
                    break;
                }
            }
            Err(error) => {
                found.end = ResponseEnd::Lost(error);
                break;
            }
        }
    }
    Ok(found)
}
