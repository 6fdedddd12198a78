//! Where the parameter of a branch of cycles turns, and how well that is known.

use crate::CyclesError;
use crate::backbone::PeriodicMotion;
use crate::balance::HarmonicBalance;
use crate::branch::{AssemblyCycleBranch, BranchSettings, CycleAtKey};
use crate::extended::{BalanceSource, ExtendedBalance, Free, KeyedBalance};
use crate::path::{ClosingEquation, GoOn, Newton, PathEquations, PathPoint, PathRule, distance, follow};
use crate::series::Series;
use crate::turning::{extreme, turns};
use judder_assembly::assembly::Assembly;

/// Where the parameter turns.
pub(crate) fn folds<S: BalanceSource>(
    equations: &mut ExtendedBalance<S>,
    newton: &mut Newton<'_>,
    cycles: &[CycleAtKey],
    settings: &BranchSettings,
) -> Result<Vec<(usize, f64)>, CyclesError> {
    /// Of the unit, by how much the parameter goes back beyond a fold, at least: small cycles all have that of their Hopf point.
    const ROUNDING: f64 = 1e-6;
    let parameters: Vec<f64> = cycles.iter().map(|own| own.parameter).collect();
    let mut folds = Vec::new();
    for (cycle, rose) in turns(&parameters, settings.rises, ROUNDING * settings.unit) {
        let near = [cycle - 1, cycle, cycle + 1].map(|k| equations.place(&cycles[k].motion, parameters[k]));
        equations.accept(&near[1])?;
        let near = near.each_ref().map(Vec::as_slice);
        let last = near[1].len() - 1;
        folds.push((cycle, settings.unit * extreme(equations, newton, near, (last, rose))?));
    }
    Ok(folds)
}

/// How many times the harmonics and instants a fold is found with once more.
pub const FOLD_REFINEMENT: usize = 2;

/// The same fold with twice the harmonics and instants, from a cycle at which the parameter turns and its neighbours on the branch.
///
/// # Errors
/// Why the cycle is not found with them; [`CyclesError::NotConverged`] where the parameter does not turn near it.
pub fn refined_fold<F: Fn(f64) -> Result<Assembly, CyclesError>>(
    assembly_at: &F,
    balance: &HarmonicBalance<'_>,
    around: [&CycleAtKey; 3],
    settings: &BranchSettings,
    go_on: &GoOn<'_>,
) -> Result<f64, CyclesError> {
    let few = balance;
    let [harmonics, samples] =
        [few.series().harmonics(), few.series().samples()].map(|own| FOLD_REFINEMENT * own);
    let series = Series::new(harmonics, samples);
    let balance = few.with_series(series);
    let source = KeyedBalance::new(assembly_at, &balance);
    let reference = Some(vec![1.0; 2 * balance.components()]);
    let [before, own, after] = around;
    let frequency = own.motion.turning.frequency;
    let mut equations =
        ExtendedBalance::new(source, &balance, frequency, Free::Parameter(settings.unit), reference);
    let mut near = Vec::new();
    for cycle in around {
        let assembly = assembly_at(cycle.parameter)?;
        let (_, unknown) =
            few.of(&assembly)?.with_left_out(&cycle.motion.unknown, cycle.motion.turning, FOLD_REFINEMENT)?;
        near.push(equations.place(&PeriodicMotion { unknown, ..cycle.motion.clone() }, cycle.parameter));
    }
    equations.weigh_swing(&near[1]);
    equations.accept(&near[1])?;
    let way: Vec<f64> = near[2].iter().zip(&near[0]).map(|(a, b)| a - b).collect();
    let step = 0.5 * distance(&near[0], &near[2], equations.weights());
    let rule = PathRule { steps: [0.5 * step, step, settings.rule.steps[2]], ..settings.rule };
    let mut newton = Newton::new(rule, go_on);
    let closing = ClosingEquation::across(&way, equations.weights(), &near[1]);
    let mut first = newton.corrected(&mut equations, &near[1], &closing, &way);
    for beside in [&near[2], &near[0]] {
        if matches!(first, Ok(_) | Err(CyclesError::Stopped)) {
            break;
        }
        let closing = ClosingEquation::across(&way, equations.weights(), beside);
        first = newton.corrected(&mut equations, beside, &closing, &way);
    }
    let first = first?;
    let rose = own.parameter - before.parameter > after.parameter - own.parameter;
    let mut along = Vec::new();
    for forwards in [false, true] {
        let one_way = beyond_the_fold(&mut equations, &mut newton, &first, (forwards, rose))?;
        match forwards {
            false => along.extend(one_way.into_iter().rev()),
            true => along.extend(one_way.into_iter().skip(1)),
        }
    }
    let last = first.at.len() - 1;
    let ahead = |k: &usize| if rose { along[*k][last] } else { -along[*k][last] };
    let farthest = (1..along.len() - 1).max_by(|a, b| ahead(a).total_cmp(&ahead(b))).unwrap_or(1);
    let near = [farthest - 1, farthest, farthest + 1].map(|k| &along[k][..]);
    equations.accept(near[1])?;
    Ok(settings.unit * extreme(&mut equations, &mut newton, near, (last, rose))?)
}

/// The solutions from one on, forwards or backwards, until the parameter has gone back for some steps from the farthest one; it rises to the fold, or falls to it.
fn beyond_the_fold<E: PathEquations>(
    equations: &mut E,
    newton: &mut Newton<'_>,
    first: &PathPoint,
    (forwards, rose): (bool, bool),
) -> Result<Vec<Vec<f64>>, CyclesError> {
    /// Steps that go back: less may be those of points that change their state from one instant to the next.
    const BACK: usize = 3;
    const MOST: usize = 60;
    let last = first.at.len() - 1;
    let ahead = |at: &[f64]| if rose { at[last] } else { -at[last] };
    let mut start = first.clone();
    if !forwards {
        start.tangent.iter_mut().for_each(|own| *own = -*own);
        start.orientation = -start.orientation;
    }
    let mut along = vec![first.at.clone()];
    let mut farthest = (0, ahead(&first.at));
    equations.accept(&first.at)?;
    let found = follow(newton, equations, start, MOST, |_, _, [_, next]| {
        along.push(next.at.clone());
        if ahead(&next.at) > farthest.1 {
            farthest = (along.len() - 1, ahead(&next.at));
        }
        Ok((along.len() > farthest.0 + BACK).then_some(()))
    })?;
    match found {
        Some(()) => Ok(along),
        None => Err(CyclesError::NotConverged { iterations: MOST, residual: f64::NAN }),
    }
}

impl AssemblyCycleBranch {
    /// What the harmonics leave out of a fold of this place of the list, from the same one with twice as many as [`refined_fold`] has it: an error of which twice the
    /// harmonics leave two thirds or less is at most three times the difference.
    #[must_use]
    pub fn fold_error(&self, place: usize, refined: f64) -> f64 {
        const TIMES: f64 = 3.0;
        self.folds.get(place).map_or(f64::NAN, |(_, fold)| TIMES * (refined - fold).abs())
    }
}
