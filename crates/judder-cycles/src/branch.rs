//! Limit cycles along a parameter, through folds, to where they shrink to steady sliding.

use crate::CyclesError;
use crate::backbone::PeriodicMotion;
use crate::balance::HarmonicBalance;
use crate::extended::{BalanceSource, ExtendedBalance, Free, KeyedBalance};
use crate::path::{ClosingEquation, GoOn, Newton, PathEquations, PathPoint, PathRule, ended, follow};
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

/// The branch through a cycle that is known at a value of the parameter.
///
/// # Errors
/// What the first cycle says; what is lost later ends the branch. [`CyclesError::Stopped`].
pub fn cycle_branch<F: Fn(f64) -> Result<Assembly, CyclesError>>(
    assembly_at: &F,
    balance: &HarmonicBalance<'_>,
    (parameter, cycle): (f64, &PeriodicMotion),
    settings: &BranchSettings,
    go_on: &GoOn<'_>,
) -> Result<AssemblyCycleBranch, CyclesError> {
    /// Of the largest amplitude: what is smaller has shrunk to its Hopf point.
    const SHRUNK: f64 = 0.02;
    let source = KeyedBalance::new(assembly_at, balance);
    let reference = Some(vec![1.0; 2 * balance.components()]);
    let frequency = cycle.turning.frequency;
    let mut equations =
        ExtendedBalance::new(source, balance, frequency, Free::Parameter(settings.unit), reference);
    let at = equations.place(cycle, parameter);
    equations.accept(&at)?;
    let last = at.len() - 1;
    let closing = ClosingEquation::fixed(last, at.len(), at[last]);
    let towards: Vec<f64> = closing.row.iter().map(|own| if settings.rises { *own } else { -own }).collect();
    let mut newton = Newton::new(settings.rule, go_on);
    let first = newton.corrected(&mut equations, &at, &closing, &towards)?;
    let mut cycles = vec![CycleAtKey::of(&mut equations, &first)?];
    let mut folds = Vec::new();
    let mut largest = cycles[0].motion.amplitude;
    let end = follow(&mut newton, &mut equations, first, settings.points, |equations, _, [_, next]| {
        let next = CycleAtKey::of(equations, next)?;
        let before = &cycles[cycles.len() - 1];
        if before.rises != next.rises {
            let pair = [before.parameter, next.parameter];
            let turn = if before.rises { pair[0].max(pair[1]) } else { pair[0].min(pair[1]) };
            folds.push((cycles.len() - 1, turn));
        }
        let (parameter, amplitude) = (next.parameter, next.motion.amplitude);
        largest = largest.max(amplitude);
        cycles.push(next);
        let [from, to] = settings.range;
        Ok(if parameter < from || parameter > to {
            Some(CycleBranchEnd::Range)
        } else if amplitude < SHRUNK * largest {
            Some(CycleBranchEnd::SteadySliding)
        } else {
            None
        })
    });
    let end = ended(end, CycleBranchEnd::Points, CycleBranchEnd::Lost)?;
    Ok(AssemblyCycleBranch { cycles, folds, end })
}

impl CycleAtKey {
    fn of<S: BalanceSource>(
        equations: &mut ExtendedBalance<S>,
        point: &PathPoint,
    ) -> Result<Self, CyclesError> {
        let rises = point.tangent[point.tangent.len() - 1] > 0.0;
        Ok(Self { parameter: equations.parameter(&point.at), motion: equations.motion(point)?, rises })
    }
}
