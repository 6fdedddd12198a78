//! The periodic motions of a mode over their amplitude.
//!
//! A mode that grows with σ moves periodically where σ is taken off all motions alike: M ẍ + (C + 2 σ M) ẋ + K x = f + Pᵀ λ (M. Krack, *Nonlinear modal analysis of
//! nonconservative systems*, Comput. Struct. 154, 2015). As its amplitude grows, points stick, slide the other way, lift off, and σ
//! changes; where it passes through zero the motion needs nothing: a limit cycle. Where it falls with the amplitude motions
//! nearby are drawn to it, as far as they have this shape; where it rises they leave it.

mod mode;

use crate::CyclesError;
use crate::balance::{Balanced, CycleRate, HarmonicBalance, LastEvaluated};
use crate::path::{ClosingEquation, Path, PathEquations, PathPoint, PathRule, corrected};
use crate::phase::Phase;
use faer::{Mat, c64};
use judder_assembly::steady::SteadySliding;

/// How the motions of a mode are followed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BackboneSettings {
    /// How solutions are sought.
    pub rule: PathRule,
    /// The most of them.
    pub points: usize,
    /// The amplitude at which they end, of that at which contact first changes its state.
    pub largest: f64,
    /// How many limit cycles are enough.
    pub cycles: usize,
}

impl Default for BackboneSettings {
    fn default() -> Self {
        Self { rule: PathRule::default(), points: 400, largest: 1e3, cycles: 1 }
    }
}

/// A periodic motion.
#[derive(Debug, Clone, PartialEq)]
pub struct PeriodicMotion {
    /// Unknowns of the balance.
    pub unknown: Vec<f64>,
    /// ω in rad/s, and σ in 1/s.
    pub turning: CycleRate,
    /// The root of Σ |ε y₁|² over all components, y₁ the first harmonic of their motions, in N.
    pub amplitude: f64,
    /// What is left of the equations, of the force scale.
    pub residual: f64,
}

/// Why the motions of a mode are followed no further.
#[derive(Debug, Clone, PartialEq)]
pub enum BackboneEnd {
    /// As many limit cycles were found as were asked for.
    Found,
    /// The amplitude is as large as was asked for.
    Largest,
    /// There are as many motions as were asked for.
    Points,
    /// They came back to small ones.
    Shrunk,
    /// No next motion was found.
    Lost(CyclesError),
}

/// The periodic motions of a mode.
#[derive(Debug, Clone, PartialEq)]
pub struct Backbone {
    /// In the order in which they were found, from small ones on.
    pub motions: Vec<PeriodicMotion>,
    /// Those with σ = 0, and whether σ falls there as the amplitude grows.
    pub cycles: Vec<(PeriodicMotion, bool)>,
    /// The amplitude of the mode at which the contact first changes its state.
    pub first_change: f64,
    /// Why there are no more.
    pub end: BackboneEnd,
}

/// The balance of harmonics with ω and σ, and a phase.
struct TurningEquations<'b, 'a> {
    balance: &'b HarmonicBalance<'a>,
    /// In rad/s.
    frequency: f64,
    weights: Vec<f64>,
    phase: Phase,
    last: LastEvaluated,
}

impl<'b, 'a> TurningEquations<'b, 'a> {
    fn new(balance: &'b HarmonicBalance<'a>, frequency: f64, reference: Vec<f64>) -> Self {
        let unknowns = balance.unknowns();
        let mut weights = vec![1.0 / balance.components() as f64; unknowns + 2];
        weights[unknowns..].fill(1.0);
        Self {
            balance,
            frequency,
            weights,
            phase: Phase::new(balance, reference),
            last: LastEvaluated::default(),
        }
    }

    fn turning(&self, at: &[f64]) -> CycleRate {
        let unknowns = self.balance.unknowns();
        CycleRate { frequency: self.frequency * at[unknowns], growth: self.frequency * at[unknowns + 1] }
    }

    /// A motion at a solution.
    fn motion(&self, point: &PathPoint) -> Result<PeriodicMotion, CyclesError> {
        let turning = self.turning(&point.at);
        let unknown = point.at[..self.balance.unknowns()].to_vec();
        let signals = self.balance.signals_at(&unknown, turning)?;
        let amplitude = self.phase.amplitude(&signals.motions);
        Ok(PeriodicMotion { unknown, turning, amplitude, residual: point.residual })
    }
}

impl PathEquations for TurningEquations<'_, '_> {
    fn residual(&mut self, at: &[f64]) -> Result<Vec<f64>, CyclesError> {
        let evaluated = self.balance.evaluated(&at[..self.balance.unknowns()], self.turning(at))?;
        let mut residual = evaluated.residual.clone();
        residual.push(self.phase.of(&evaluated.signals.motions));
        self.last.keep(at, evaluated);
        Ok(residual)
    }

    fn linearised(&mut self, at: &[f64]) -> Result<(Vec<f64>, Mat<f64>), CyclesError> {
        let unknowns = self.balance.unknowns();
        let evaluated = match self.last.take(at) {
            Some(evaluated) => evaluated,
            None => self.balance.evaluated(&at[..unknowns], self.turning(at))?,
        };
        let Balanced { mut residual, jacobian, signals, first } =
            self.balance.linearised(evaluated, self.turning(at))?;
        residual.push(self.phase.of(&signals.motions));
        let phase = self.phase.slopes(&first);
        let derivative = Mat::from_fn(unknowns + 1, unknowns + 2, |i, j| {
            let own = if i < unknowns { jacobian[(i, j)] } else { phase[j] };
            if j >= unknowns { self.frequency * own } else { own }
        });
        Ok((residual, derivative))
    }

    fn weights(&self) -> &[f64] {
        &self.weights
    }

    fn is_sought(&mut self, at: &[f64]) -> Result<bool, CyclesError> {
        let signals = self.balance.signals_at(&at[..self.balance.unknowns()], self.turning(at))?;
        Ok(self.phase.moves(&signals.motions))
    }

    fn accept(&mut self, at: &[f64]) -> Result<(), CyclesError> {
        let signals = self.balance.signals_at(&at[..self.balance.unknowns()], self.turning(at))?;
        self.phase.follow(&signals.motions);
        Ok(())
    }
}

/// The periodic motions of the mode with this eigenvalue about steady sliding.
///
/// # Errors
/// What the smallest motion says; what is lost later ends the backbone.
pub fn backbone(
    balance: &HarmonicBalance<'_>,
    steady: &SteadySliding,
    eigenvalue: c64,
    settings: &BackboneSettings,
) -> Result<Backbone, CyclesError> {
    let start = mode::smallest(balance, steady, eigenvalue)?;
    let mut equations = TurningEquations::new(balance, eigenvalue.im, start.reference.clone());
    let closing = ClosingEquation::across(&start.direction, equations.weights(), &start.at);
    let first = corrected(&mut equations, &start.at, &closing, &start.direction, &settings.rule)?;
    equations.accept(&first.at)?;
    let smallest = equations.motion(&first)?;
    let first_change = smallest.amplitude / mode::SHARE;
    let mut found =
        Backbone { motions: vec![smallest], cycles: Vec::new(), first_change, end: BackboneEnd::Points };
    let last = first.at.len() - 1;
    let mut path = Path::from(first, settings.rule);
    while found.motions.len() < settings.points {
        let before = path.point().clone();
        let next = match path.go_on(&mut equations) {
            Ok(next) => next.clone(),
            Err(error) => {
                found.end = BackboneEnd::Lost(error);
                break;
            }
        };
        if before.at[last] * next.at[last] <= 0.0 && before.at[last] != 0.0 {
            match located(&mut equations, [&before, &next], &settings.rule) {
                Ok(cycle) => found.cycles.push(cycle),
                Err(error) => {
                    found.end = BackboneEnd::Lost(error);
                    break;
                }
            }
        }
        let motion = equations.motion(&next)?;
        let amplitude = motion.amplitude;
        found.motions.push(motion);
        if found.cycles.len() >= settings.cycles {
            found.end = BackboneEnd::Found;
            break;
        }
        if amplitude > settings.largest * first_change {
            found.end = BackboneEnd::Largest;
            break;
        }
        if amplitude < 0.5 * mode::SHARE * first_change {
            found.end = BackboneEnd::Shrunk;
            break;
        }
    }
    Ok(found)
}

/// A limit cycle near another that is known with as many harmonics or fewer.
///
/// # Errors
/// [`CyclesError::NotConverged`] and [`CyclesError::Singular`].
pub fn refined(
    balance: &HarmonicBalance<'_>,
    near: &PeriodicMotion,
    rule: &PathRule,
) -> Result<PeriodicMotion, CyclesError> {
    let size = balance.series().coefficients();
    let known = near.unknown.len() / balance.components();
    let mut at = vec![0.0; balance.unknowns()];
    for (own, from) in at.chunks_exact_mut(size).zip(near.unknown.chunks_exact(known)) {
        let kept = known.min(size);
        own[..kept].copy_from_slice(&from[..kept]);
    }
    at.extend([1.0, 0.0]);
    let mut equations =
        TurningEquations::new(balance, near.turning.frequency, vec![1.0; 2 * balance.components()]);
    equations.accept(&at)?;
    let closing = ClosingEquation::fixed(at.len() - 1, at.len(), 0.0);
    let found = corrected(&mut equations, &at, &closing, &closing.row, rule)?;
    let cycle = equations.motion(&found)?;
    if cycle.amplitude < SHRUNK * near.amplitude { Err(CyclesError::Shrunk) } else { Ok(cycle) }
}

/// A motion so much smaller than those near it is steady sliding, or on its way there.
const SHRUNK: f64 = 0.3;

/// The cycle between two motions, and whether σ falls from small to large ones.
///
/// Steady sliding is a solution with σ = 0 too: σ is free until it is small, on planes across the path.
fn located(
    equations: &mut TurningEquations<'_, '_>,
    [before, after]: [&PathPoint; 2],
    rule: &PathRule,
) -> Result<(PeriodicMotion, bool), CyclesError> {
    /// Steps, and the σ at which it is as good as zero.
    const STEPS: usize = 12;
    const SMALL: f64 = 1e-7;
    let last = before.at.len() - 1;
    let size = [before, after].map(|point| equations.motion(point).map(|own| own.amplitude));
    let [small, large] = [size[0].clone()?, size[1].clone()?];
    let (mut low, mut high) = (before.clone(), after.clone());
    for _ in 0..STEPS {
        let nearest = if low.at[last].abs() < high.at[last].abs() { &low } else { &high };
        if nearest.at[last].abs() < SMALL {
            break;
        }
        let share = (low.at[last] / (low.at[last] - high.at[last])).clamp(0.1, 0.9);
        let guess: Vec<f64> = low.at.iter().zip(&high.at).map(|(a, b)| a + share * (b - a)).collect();
        let chord: Vec<f64> = low.at.iter().zip(&high.at).map(|(a, b)| b - a).collect();
        let closing = ClosingEquation::across(&chord, equations.weights(), &guess);
        let between = corrected(equations, &guess, &closing, &before.tangent, rule)?;
        if between.at[last] * low.at[last] > 0.0 { low = between } else { high = between }
    }
    let nearest = if low.at[last].abs() < high.at[last].abs() { low } else { high };
    let closing = ClosingEquation::fixed(last, nearest.at.len(), 0.0);
    let found = corrected(equations, &nearest.at, &closing, &nearest.tangent, rule)?;
    let cycle = equations.motion(&found)?;
    if cycle.amplitude < SHRUNK * small.min(large) {
        return Err(CyclesError::Shrunk);
    }
    Ok((cycle, (large > small) == (after.at[last] < before.at[last])))
}
