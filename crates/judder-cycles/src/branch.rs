//! Limit cycles along a parameter, through folds, to where they shrink to steady sliding.

use crate::CyclesError;
use crate::backbone::PeriodicMotion;
use crate::balance::HarmonicBalance;
use crate::extended::{BalanceSource, ExtendedBalance, Free, KeyedBalance};
use crate::fold::folds;
use crate::path::{ClosingEquation, GoOn, Newton, PathEquations, PathPoint, PathRule, ended, follow};
use crate::turning::sign_change;
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

/// Where the determinant of the equations under the tangent changes its sign: cycles of another branch cross there, or points change what they do.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CycleBranchPoint {
    /// The cycle before.
    pub cycle: usize,
    /// The parameter.
    pub parameter: f64,
    /// Whether no point changes what it does within the last thousandth of the step: else the determinant may jump at a kink without a branch point.
    pub is_smooth: bool,
}

/// Why a branch ends.
#[derive(Debug, Clone, PartialEq)]
pub enum CycleBranchEnd {
    /// It came to an end of the range of the parameter, where its last cycle lies.
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
    /// The cycle nearest to where the parameter turns, and the parameter there, by a search among the cycles between its neighbours.
    pub folds: Vec<(usize, f64)>,
    /// Where other cycles may branch off.
    pub branch_points: Vec<CycleBranchPoint>,
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
    equations.weigh_swing(&at);
    equations.keep_within(settings.range);
    equations.accept(&at)?;
    let last = at.len() - 1;
    let closing = ClosingEquation::fixed(last, at.len(), at[last]);
    let towards: Vec<f64> = closing.row.iter().map(|own| if settings.rises { *own } else { -own }).collect();
    let mut newton = Newton::new(settings.rule, go_on);
    let mut first = newton.corrected(&mut equations, &at, &closing, &towards)?;
    first.at[last] = at[last];
    let mut cycles = vec![CycleAtKey::of(&mut equations, &first)?];
    let mut branch_points = Vec::new();
    let mut largest = cycles[0].motion.amplitude;
    let end = match leaves(&first, equations.ends()) {
        true => Ok(Some(CycleBranchEnd::Range)),
        false => follow(
            &mut newton,
            &mut equations,
            first,
            settings.points,
            |equations, newton, [before, next]| {
                if before.orientation != next.orientation {
                    branch_points.push(branch_point(equations, newton, [before, next], cycles.len() - 1)?);
                }
                cycles.push(CycleAtKey::of(equations, next)?);
                let amplitude = cycles[cycles.len() - 1].motion.amplitude;
                largest = largest.max(amplitude);
                Ok(if amplitude < SHRUNK * largest {
                    Some(CycleBranchEnd::SteadySliding)
                } else if equations.ends().contains(&next.at[last]) {
                    Some(CycleBranchEnd::Range)
                } else {
                    None
                })
            },
        ),
    };
    let end = ended(end, CycleBranchEnd::Points, CycleBranchEnd::Lost)?;
    let folds = folds(&mut equations, &mut newton, &cycles, settings)?;
    Ok(AssemblyCycleBranch { cycles, folds, branch_points, end })
}

/// Whether a path that begins at an end goes beyond it.
fn leaves(first: &PathPoint, [low, high]: [f64; 2]) -> bool {
    let last = first.at.len() - 1;
    let (at, rises) = (first.at[last], first.tangent[last] > 0.0);
    if rises { at >= high } else { at <= low }
}

fn branch_point<S: BalanceSource>(
    equations: &mut ExtendedBalance<S>,
    newton: &mut Newton<'_>,
    between: [&PathPoint; 2],
    cycle: usize,
) -> Result<CycleBranchPoint, CyclesError> {
    let [low, high] = sign_change(equations, newton, between)?;
    let parameter = 0.5 * (equations.parameter(&low.at) + equations.parameter(&high.at));
    let is_smooth = equations.states(&low.at)? == equations.states(&high.at)?;
    Ok(CycleBranchPoint { cycle, parameter, is_smooth })
}

impl AssemblyCycleBranch {
    /// The parameter at which the square of the amplitude comes to zero, straight on from the two cycles before the smallest, as it does at a Hopf point; of a branch that shrinks to steady sliding.
    ///
    /// What is left of the equations is so large beside the smallest one that it is known to fewer digits.
    #[must_use]
    pub fn vanishes_at(&self) -> Option<f64> {
        let [.., before, last, _] = &self.cycles[..] else { return None };
        let square = |cycle: &CycleAtKey| cycle.motion.amplitude * cycle.motion.amplitude;
        let (there, falls) = (square(last), square(before) - square(last));
        let shrinks = self.end == CycleBranchEnd::SteadySliding && falls > 0.0;
        shrinks.then(|| last.parameter + there * (last.parameter - before.parameter) / falls)
    }
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
