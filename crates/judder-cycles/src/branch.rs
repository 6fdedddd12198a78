//! Limit cycles along a parameter, through folds, to where they shrink to steady sliding.

use crate::CyclesError;
use crate::backbone::PeriodicMotion;
use crate::balance::{Balanced, CycleRate, HarmonicBalance};
use crate::path::{ClosingEquation, Path, PathEquations, PathPoint, PathRule, corrected};
use crate::phase::Phase;
use faer::Mat;
use judder_assembly::assembly::Assembly;

/// How a branch is followed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BranchSettings {
    /// How solutions are sought.
    pub rule: PathRule,
    /// Where the parameter may lie.
    pub range: [f64; 2],
    /// What of the parameter counts as much as all of the frequency.
    pub unit: f64,
    /// Whether it rises at first.
    pub rises: bool,
    /// The most cycles.
    pub points: usize,
}

/// A cycle on a branch.
#[derive(Debug, Clone, PartialEq)]
pub struct CycleAtKey {
    /// The parameter.
    pub parameter: f64,
    /// The motion.
    pub motion: PeriodicMotion,
    /// Whether the parameter rises along the branch.
    pub rises: bool,
}

/// Why a branch ends.
#[derive(Debug, Clone, PartialEq)]
pub enum CycleBranchEnd {
    /// It left the range of the parameter.
    Range,
    /// It has as many cycles as were asked for.
    Points,
    /// It shrank to steady sliding: a Hopf point.
    SteadySliding,
    /// No next cycle was found.
    Lost(CyclesError),
}

/// Limit cycles along a parameter.
#[derive(Debug, Clone, PartialEq)]
pub struct AssemblyCycleBranch {
    /// In the order along the branch.
    pub cycles: Vec<CycleAtKey>,
    /// The cycle after which the parameter turns, and the parameter there.
    pub folds: Vec<(usize, f64)>,
    /// Why it ends.
    pub end: CycleBranchEnd,
}

/// What follows a parameter.
struct KeyEquations<'f, 'a, F> {
    assembly_at: &'f F,
    scales: HarmonicBalance<'a>,
    frequency: f64,
    unit: f64,
    weights: Vec<f64>,
    phase: Phase,
}

impl<F: Fn(f64) -> Result<Assembly, CyclesError>> KeyEquations<'_, '_, F> {
    fn parameter(&self, at: &[f64]) -> f64 {
        self.unit * at[at.len() - 1]
    }

    fn turning(&self, at: &[f64]) -> CycleRate {
        CycleRate { frequency: self.frequency * at[at.len() - 2], growth: 0.0 }
    }

    /// What is left at a value of the parameter.
    fn residual_at(&self, parameter: f64, at: &[f64]) -> Result<Vec<f64>, CyclesError> {
        let assembly = (self.assembly_at)(parameter)?;
        let balance = self.scales.of(&assembly)?;
        let evaluated = balance.evaluated(&at[..balance.unknowns()], self.turning(at))?;
        let mut residual = evaluated.residual;
        residual.push(self.phase.of(&evaluated.signals.motions));
        Ok(residual)
    }

    fn cycle(&self, point: &PathPoint) -> Result<CycleAtKey, CyclesError> {
        let parameter = self.parameter(&point.at);
        let assembly = (self.assembly_at)(parameter)?;
        let balance = self.scales.of(&assembly)?;
        let (unknown, turning) = (point.at[..balance.unknowns()].to_vec(), self.turning(&point.at));
        let amplitude = self.phase.amplitude(&balance.signals_at(&unknown, turning)?.motions);
        let motion = PeriodicMotion { unknown, turning, amplitude, residual: point.residual };
        Ok(CycleAtKey { parameter, motion, rises: point.tangent[point.tangent.len() - 1] > 0.0 })
    }
}

impl<F: Fn(f64) -> Result<Assembly, CyclesError>> PathEquations for KeyEquations<'_, '_, F> {
    fn residual(&mut self, at: &[f64]) -> Result<Vec<f64>, CyclesError> {
        self.residual_at(self.parameter(at), at)
    }

    fn linearised(&mut self, at: &[f64]) -> Result<(Vec<f64>, Mat<f64>), CyclesError> {
        /// Of the unit of the parameter.
        const DIFFERENCE: f64 = 1e-6;
        let assembly = (self.assembly_at)(self.parameter(at))?;
        let balance = self.scales.of(&assembly)?;
        let unknowns = balance.unknowns();
        let Balanced { mut residual, jacobian, signals, first } =
            balance.balanced(&at[..unknowns], self.turning(at))?;
        residual.push(self.phase.of(&signals.motions));
        let beside = self.residual_at(self.parameter(at) + DIFFERENCE * self.unit, at)?;
        let phase = self.phase.slopes(&first);
        let derivative = Mat::from_fn(unknowns + 1, unknowns + 2, |i, j| {
            let own = if i < unknowns { jacobian[(i, j)] } else { phase[j] };
            match j.checked_sub(unknowns) {
                None => own,
                Some(0) => self.frequency * own,
                Some(_) => (beside[i] - residual[i]) / DIFFERENCE,
            }
        });
        Ok((residual, derivative))
    }

    fn weights(&self) -> &[f64] {
        &self.weights
    }

    fn is_sought(&mut self, at: &[f64]) -> Result<bool, CyclesError> {
        let assembly = (self.assembly_at)(self.parameter(at))?;
        let balance = self.scales.of(&assembly)?;
        Ok(self.phase.moves(&balance.signals_at(&at[..balance.unknowns()], self.turning(at))?.motions))
    }

    fn accept(&mut self, at: &[f64]) -> Result<(), CyclesError> {
        let assembly = (self.assembly_at)(self.parameter(at))?;
        let balance = self.scales.of(&assembly)?;
        self.phase.follow(&balance.signals_at(&at[..balance.unknowns()], self.turning(at))?.motions);
        Ok(())
    }
}

/// The branch through a cycle that is known at a value of the parameter.
///
/// # Errors
/// What the first cycle says; what is lost later ends the branch.
pub fn cycle_branch<F: Fn(f64) -> Result<Assembly, CyclesError>>(
    assembly_at: &F,
    balance: &HarmonicBalance<'_>,
    (parameter, cycle): (f64, &PeriodicMotion),
    settings: &BranchSettings,
) -> Result<AssemblyCycleBranch, CyclesError> {
    /// Of the largest amplitude: what is smaller has shrunk to its Hopf point.
    const SHRUNK: f64 = 0.02;
    let unknowns = balance.unknowns();
    let mut weights = vec![1.0 / balance.components() as f64; unknowns + 2];
    weights[unknowns..].fill(1.0);
    let mut equations = KeyEquations {
        assembly_at,
        scales: balance.clone(),
        frequency: cycle.turning.frequency,
        unit: settings.unit,
        weights,
        phase: Phase::new(balance, vec![1.0; 2 * balance.components()]),
    };
    let at: Vec<f64> = cycle.unknown.iter().copied().chain([1.0, parameter / settings.unit]).collect();
    equations.accept(&at)?;
    let last = at.len() - 1;
    let closing = ClosingEquation::fixed(last, at.len(), at[last]);
    let towards: Vec<f64> = closing.row.iter().map(|own| if settings.rises { *own } else { -own }).collect();
    let first = corrected(&mut equations, &at, &closing, &towards, &settings.rule)?;
    let mut found = AssemblyCycleBranch {
        cycles: vec![equations.cycle(&first)?],
        folds: Vec::new(),
        end: CycleBranchEnd::Points,
    };
    let mut path = Path::from(first, settings.rule);
    let mut largest = found.cycles[0].motion.amplitude;
    while found.cycles.len() < settings.points {
        let next = path.go_on(&mut equations).cloned().and_then(|point| equations.cycle(&point));
        let next = match next {
            Ok(next) => next,
            Err(error) => {
                found.end = CycleBranchEnd::Lost(error);
                break;
            }
        };
        let before = &found.cycles[found.cycles.len() - 1];
        if before.rises != next.rises {
            let pair = [before.parameter, next.parameter];
            let turn = if before.rises { pair[0].max(pair[1]) } else { pair[0].min(pair[1]) };
            found.folds.push((found.cycles.len() - 1, turn));
        }
        let (parameter, amplitude) = (next.parameter, next.motion.amplitude);
        largest = largest.max(amplitude);
        found.cycles.push(next);
        let [from, to] = settings.range;
        if parameter < from || parameter > to {
            found.end = CycleBranchEnd::Range;
            break;
        }
        if amplitude < SHRUNK * largest {
            found.end = CycleBranchEnd::SteadySliding;
            break;
        }
    }
    Ok(found)
}
