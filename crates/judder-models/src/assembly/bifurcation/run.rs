//! The first cycle along a key, and the branch through it.

use super::CycleDiagram;
use super::told::{KnownCycle, ToldCycleBranch, dataset};
use crate::assembly::AssemblySubject;
use crate::assembly::branch_checks::{ShrunkAt, equations, shrinks};
use crate::assembly::cycles_along_key::{CyclesAlongKey, FirstCycle};
use crate::assembly::limit_cycle::search::{is_converged, left_out};
use crate::assembly::limit_cycle::settings::LOWEST;
use crate::assembly::limit_cycle::stability::KnownStability;
use crate::assembly::meant_mode::{fastest, near_frequency};
use crate::assembly::swept::{SlidingState, SweptAssembly};
use crate::error::ModelError;
use judder_cycles::backbone::BackboneSettings;
use judder_cycles::balance::HarmonicBalance;
use judder_cycles::branch::{AssemblyCycleBranch, CycleAtKey, CycleBranchEnd};
use judder_cycles::cycle::points;
use judder_numerics::parallel;
use judder_study::Progress;
use judder_study::outcome::Outcome;
use num_complex::Complex64;

/// Values at which a first cycle is sought.
const TRIED: usize = 5;

pub(super) fn run(
    of: &AssemblySubject<'_>,
    asked: &CycleDiagram,
    progress: &dyn Progress,
) -> Result<Outcome, ModelError> {
    let family = SweptAssembly::new(of, vec![&asked.sweep], true);
    let along = CyclesAlongKey {
        family: &family,
        sweep: &asked.sweep,
        harmonics: asked.harmonics,
        samples: asked.samples,
        backbone: BackboneSettings::default(),
        most: asked.cycles,
        progress,
    };
    let mut reasons = Vec::new();
    for value in tried(&asked.sweep.values) {
        progress.go_on()?;
        match first(asked, &along, value)? {
            Ok(found) => return branches(asked, &along, &found),
            Err(reason) => reasons.push(along.told(value, &reason)),
        }
    }
    reasons.insert(0, "no limit cycle was found to begin with".to_owned());
    let told = ToldCycleBranch::none(asked);
    let Outcome { scalars, .. } = Outcome::of(&told)?;
    Ok(Outcome {
        scalars,
        dataset: dataset(asked, &[], &[])?,
        warnings: reasons,
        missing: 1,
        ..Outcome::default()
    })
}

/// The last value, the first, and some between, from the last on.
fn tried(values: &[f64]) -> Vec<f64> {
    let last = values.len() - 1;
    let mut places: Vec<usize> = (0..TRIED).map(|k| last - k * last / (TRIED - 1)).collect();
    places.dedup();
    places.into_iter().map(|place| values[place]).collect()
}

/// The cycle at a value; in words why there is none.
fn first(
    asked: &CycleDiagram,
    along: &CyclesAlongKey<'_>,
    value: f64,
) -> Result<Result<FirstCycle, String>, ModelError> {
    match &asked.start {
        Some(start) => along.near_march(value, start),
        None => along.of_mode(value, |state| growing_mode(asked, along.family, state)),
    }
}

/// The eigenvalue of the mode that is meant, where it grows.
fn growing_mode(
    asked: &CycleDiagram,
    family: &SweptAssembly<'_>,
    state: &SlidingState,
) -> Result<Complex64, ModelError> {
    let about = family.about(state)?;
    let mode = match asked.frequency {
        Some(frequency) => near_frequency(&about, frequency)?,
        None => fastest(&about, asked.modes.unwrap_or(LOWEST))?.0,
    };
    let eigenvalue = mode.eigenvalue.value;
    match eigenvalue.re > 0.0 {
        true => Ok(eigenvalue),
        false => Err(ModelError::Unsupported("the mode does not grow".to_owned())),
    }
}

/// The branch both ways, in the order along it.
fn branches(
    asked: &CycleDiagram,
    along: &CyclesAlongKey<'_>,
    found: &FirstCycle,
) -> Result<Outcome, ModelError> {
    let (family, progress) = (along.family, along.progress);
    let balance = along.balance(found)?;
    let mut ways = Vec::new();
    for rises in [false, true] {
        progress.go_on()?;
        ways.push(along.branch(found, &balance, rises)?);
    }
    let [down, up]: [AssemblyCycleBranch; 2] = [ways.swap_remove(0), ways.swap_remove(0)];
    let [from, to] = along.range();
    let cycles = down.cycles.iter().rev().chain(up.cycles.iter().skip(1));
    let mut known = Vec::new();
    for cycle in cycles.filter(|own| (from..=to).contains(&own.parameter)) {
        progress.go_on()?;
        let assembly = along.assembly(cycle.parameter)?;
        known.push(told_of(asked, &balance.of(&assembly)?, cycle, progress)?);
    }
    let ends = [&down, &up].map(|way| ShrunkAt::of(family, way));
    let hopf: Vec<&CycleAtKey> = [&down, &up]
        .into_iter()
        .zip(ends)
        .filter(|(_, end)| end.is_some_and(ShrunkAt::is_hopf))
        .filter_map(|(way, _)| way.cycles.last())
        .collect();
    let fold_errors = fold_errors(along, &balance, [&down, &up])?;
    let told = ToldCycleBranch::new(asked, &known, [&down, &up], &fold_errors, &hopf);
    let Outcome { scalars, .. } = Outcome::of(&told)?;
    // the branch goes on, and how is not known
    let is_cut =
        |own: &&AssemblyCycleBranch| matches!(own.end, CycleBranchEnd::Lost(_) | CycleBranchEnd::Points);
    let cut = [&down, &up].into_iter().filter(is_cut).count();
    let unconverged = known.iter().any(|own| !is_converged(own.left_out));
    let missing = cut + usize::from(unconverged);
    let shrunk = ends.into_iter().flatten();
    let checks = std::iter::once(equations(known.iter().map(|own| own.residual)))
        .chain(shrunk.clone().filter(|own| own.is_hopf()).map(|own| shrinks(&asked.sweep, own)));
    let mut warnings = ToldCycleBranch::words([&down, &up]);
    warnings.extend(shrunk.filter(|own| !own.is_hopf()).map(|own| not_at_an_onset(asked, own)));
    warnings.extend(told.kinks());
    let motions = told.bifurcations.iter().map(|own| own.unknown_motion(|value| asked.sweep.text(value)));
    warnings.extend(motions.flatten());
    warnings.extend(told.folds_alone());
    warnings.extend(of_cycles(asked, &known));
    Ok(Outcome {
        scalars,
        dataset: dataset(asked, &known, &told.bifurcations)?,
        checks: checks.collect(),
        warnings,
        missing,
        ..Outcome::default()
    })
}

/// That a branch shrinks where no eigenvalue begins to grow.
fn not_at_an_onset(asked: &CycleDiagram, at: ShrunkAt) -> String {
    let (path, value) = (&asked.sweep.path, asked.sweep.text(at.value));
    format!(
        "the branch is followed no further than {path} = {value}, where it has less than 2 % of its largest amplitude: no eigenvalue begins to grow there"
    )
}

/// What is to be said of the cycles of a branch.
fn of_cycles(asked: &CycleDiagram, known: &[KnownCycle]) -> Vec<String> {
    let unknown = known.iter().filter(|own| asked.stability && own.stability.is_stable().is_none()).count();
    let all = known.len();
    let undecided = (unknown > 0)
        .then(|| format!("whether motions nearby are drawn to it is not known of {unknown} of {all} cycles"));
    let unconverged = known.iter().filter(|own| !is_converged(own.left_out)).count();
    let largest = known.iter().map(|own| own.left_out).fold(0.0, f64::max);
    let much =
        left_out(largest).map(|words| format!("{unconverged} of {all} cycles have not converged: {words}"));
    much.into_iter().chain(undecided).collect()
}

/// What the folds of each way may be off, each from the same one with twice the harmonics.
fn fold_errors(
    along: &CyclesAlongKey<'_>,
    balance: &HarmonicBalance<'_>,
    ways: [&AssemblyCycleBranch; 2],
) -> Result<[Vec<f64>; 2], ModelError> {
    let [down, up] = ways.map(|way| {
        along.progress.expect(way.folds.len());
        parallel::try_each_place(way.folds.len(), |place| {
            let error = along.fold_error(balance, way, place);
            along.progress.advance();
            error
        })
    });
    Ok([down?, up?])
}

/// What is known of a cycle of the branch.
fn told_of(
    asked: &CycleDiagram,
    balance: &HarmonicBalance<'_>,
    cycle: &CycleAtKey,
    progress: &dyn Progress,
) -> Result<KnownCycle, ModelError> {
    let (points, quality) = points(balance, &cycle.motion)?;
    let stability = KnownStability::of(balance, &cycle.motion, asked.stability, progress)?;
    let count = points.len() as f64;
    let mean = |of: &dyn Fn(usize) -> f64| (0..points.len()).map(of).sum::<f64>() / count;
    let rms = |k: usize| points[k].tangential_velocity_rms * points[k].tangential_velocity_rms;
    Ok(KnownCycle {
        value: cycle.parameter,
        frequency: cycle.motion.turning.frequency,
        rms: mean(&rms).sqrt(),
        stick: mean(&|k| points[k].shares[0]),
        open: mean(&|k| points[k].shares[2]),
        left_out: quality.left_out,
        residual: cycle.motion.residual,
        stability,
    })
}
