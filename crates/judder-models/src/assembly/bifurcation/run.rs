//! The first cycle along a key, and the branch through it.

use super::CycleDiagram;
use super::told::{KnownCycle, ToldCycleBranch, dataset};
use crate::assembly::AssemblySubject;
use crate::assembly::limit_cycle::search::left_out;
use crate::assembly::limit_cycle::settings::LOWEST;
use crate::assembly::limit_cycle::stability::KnownStability;
use crate::assembly::limit_cycle::start::CycleStart;
use crate::assembly::meant_mode::{fastest, near_frequency};
use crate::assembly::swept::{SlidingState, SweptAssembly};
use crate::error::ModelError;
use judder_assembly::assembly::Assembly;
use judder_assembly::steady::SteadySliding;
use judder_cycles::CyclesError;
use judder_cycles::backbone::{BackboneSettings, PeriodicMotion};
use judder_cycles::balance::HarmonicBalance;
use judder_cycles::branch::{AssemblyCycleBranch, BranchSettings, CycleAtKey, CycleBranchEnd, cycle_branch};
use judder_cycles::cycle::{AssemblyCycle, CycleSettings, HarmonicCount, limit_cycles, points};
use judder_cycles::path::PathRule;
use judder_cycles::series::Series;
use judder_study::Progress;
use judder_study::case::scale::Spacing;
use judder_study::outcome::{CheckRecord, Outcome};
use num_complex::Complex64;

/// Values at which a first cycle is sought.
const TRIED: usize = 5;
/// What the eigenvalue may grow, of its modulus, where a branch shrinks to steady sliding.
const NEUTRAL: f64 = 1e-4;

pub(super) fn run(
    of: &AssemblySubject<'_>,
    asked: &CycleDiagram,
    progress: &dyn Progress,
) -> Result<Outcome, ModelError> {
    let family = SweptAssembly::new(of, vec![&asked.sweep], true);
    let mut reasons = Vec::new();
    for value in tried(&asked.sweep.values) {
        progress.go_on()?;
        let told = |reason: String| format!("{} = {}: {reason}", asked.sweep.path, asked.sweep.text(value));
        let state = match family.state(&[value]) {
            Ok(state) => state,
            Err(error) => {
                reasons.push(told(error.to_string()));
                continue;
            }
        };
        match first(asked, &family, &state, value, progress)? {
            Ok(found) => return branches(asked, &family, &found, progress),
            Err(reason) => reasons.push(told(reason)),
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

/// Where the branch begins.
struct FirstCycle {
    value: f64,
    assembly: Assembly,
    motion: PeriodicMotion,
    steady: SteadySliding,
    /// In rad/s, by which its equations are scaled.
    frequency: f64,
}

fn mode_of(
    asked: &CycleDiagram,
    family: &SweptAssembly<'_>,
    state: &SlidingState,
) -> Result<Complex64, ModelError> {
    let about = family.about(state)?;
    let mode = match asked.frequency {
        Some(frequency) => near_frequency(&about, frequency)?,
        None => fastest(&about, asked.modes.unwrap_or(LOWEST))?.0,
    };
    Ok(mode.eigenvalue.value)
}

/// The cycle at a value; in words why there is none.
fn first(
    asked: &CycleDiagram,
    family: &SweptAssembly<'_>,
    state: &SlidingState,
    value: f64,
    progress: &dyn Progress,
) -> Result<Result<FirstCycle, String>, ModelError> {
    let harmonics = HarmonicCount::Fixed(asked.harmonics);
    let settings = CycleSettings { harmonics, samples: asked.samples, backbone: BackboneSettings::default() };
    let found = match &asked.start {
        Some(start) => started(start, family, state, value, &settings, progress)?,
        None => of_mode(asked, family, state, value, &settings, progress)?,
    };
    let steady = state.steady.clone();
    Ok(found.map(|(assembly, motion, frequency)| FirstCycle { value, assembly, motion, steady, frequency }))
}

/// An assembly, its cycle, and the frequency in rad/s by which the equations of that are scaled.
type CycleOfAssembly = (Assembly, PeriodicMotion, f64);

/// The cycle where it is to be sought in place of along a mode.
fn started(
    start: &CycleStart,
    family: &SweptAssembly<'_>,
    state: &SlidingState,
    value: f64,
    settings: &CycleSettings,
    progress: &dyn Progress,
) -> Result<Result<CycleOfAssembly, String>, ModelError> {
    let built = family.built(&[value])?;
    let found = start.cycle(&family.subject(&built), &state.steady, settings, progress)?;
    let motion = found.map_err(|error| error.to_string()).and_then(whole);
    Ok(motion.map(|motion| {
        let frequency = motion.turning.frequency;
        (built.assembly, motion, frequency)
    }))
}

/// The cycle of the mode.
fn of_mode(
    asked: &CycleDiagram,
    family: &SweptAssembly<'_>,
    state: &SlidingState,
    value: f64,
    settings: &CycleSettings,
    progress: &dyn Progress,
) -> Result<Result<CycleOfAssembly, String>, ModelError> {
    let eigenvalue = match mode_of(asked, family, state) {
        Ok(eigenvalue) => eigenvalue,
        Err(ModelError::Unsupported(reason)) => return Ok(Err(reason)),
        Err(error) => return Err(error),
    };
    if eigenvalue.re <= 0.0 {
        return Ok(Err("the mode does not grow".to_owned()));
    }
    let assembly = family.assembly(&[value])?;
    let search =
        match limit_cycles(&assembly, &state.steady, eigenvalue, settings, &|| !progress.interrupted()) {
            Err(error) if error.is_of_the_motion() => return Ok(Err(error.to_string())),
            search => search?,
        };
    let none = || "the mode grows, but no cycle of it was found".to_owned();
    let motion = search.cycles.into_iter().next().ok_or_else(none).and_then(whole);
    Ok(motion.map(|motion| (assembly, motion, eigenvalue.im)))
}

/// A cycle with all harmonics.
fn whole(cycle: AssemblyCycle<'_>) -> Result<PeriodicMotion, String> {
    match cycle.held_back {
        Some(error) => Err(format!("its cycle was not found with all harmonics: {error}")),
        None => Ok(cycle.motion),
    }
}

/// The branch both ways, in the order along it.
fn branches(
    asked: &CycleDiagram,
    family: &SweptAssembly<'_>,
    found: &FirstCycle,
    progress: &dyn Progress,
) -> Result<Outcome, ModelError> {
    let series = Series::new(asked.harmonics, asked.samples * asked.harmonics);
    let balance = HarmonicBalance::new(&found.assembly, &found.steady, found.frequency, series, &[])?;
    let at = |value: f64| {
        let built = family.assembly(&[value]);
        built.map_err(|error| CyclesError::NoAssembly { value, reason: error.to_string() })
    };
    let along = AlongKey::of(asked);
    let [from, to] = range(&asked.sweep.values);
    let ends = [from, to].map(|value| along.measure(value));
    let longest = 1.0 / asked.sweep.values.len().max(10) as f64;
    let mut ways = Vec::new();
    for rises in [false, true] {
        progress.go_on()?;
        let rule = PathRule { steps: [0.2 * longest, longest, 1e-7], tolerance: 1e-8, ..PathRule::default() };
        let settings =
            BranchSettings { rule, range: ends, unit: ends[1] - ends[0], rises, points: asked.cycles };
        let begins = (along.measure(found.value), &found.motion);
        let at_measure = |measure: f64| at(along.value(measure));
        let way = cycle_branch(&at_measure, &balance, begins, &settings, &|| !progress.interrupted())?;
        ways.push(along.in_values(way));
    }
    let [down, up]: [AssemblyCycleBranch; 2] = [ways.swap_remove(0), ways.swap_remove(0)];
    let cycles = down.cycles.iter().rev().chain(up.cycles.iter().skip(1));
    let mut known = Vec::new();
    for cycle in cycles.filter(|own| (from..=to).contains(&own.parameter)) {
        progress.go_on()?;
        known.push(told_of(asked, &balance, &at, cycle, progress)?);
    }
    let ends = [&down, &up].map(|way| shrunk(way).map(|cycle| (cycle, off_neutral(family, cycle))));
    let is_hopf = |off: f64| off <= NEUTRAL;
    let hopf: Vec<&CycleAtKey> =
        ends.iter().flatten().filter(|(_, off)| is_hopf(*off)).map(|(cycle, _)| *cycle).collect();
    let told = ToldCycleBranch::new(asked, &known, [&down, &up], &hopf);
    let Outcome { scalars, .. } = Outcome::of(&told)?;
    let lost = |own: &&AssemblyCycleBranch| matches!(own.end, CycleBranchEnd::Lost(_));
    let missing = [&down, &up].into_iter().filter(lost).count();
    let mut warnings = ToldCycleBranch::words([&down, &up]);
    for (cycle, _) in ends.iter().flatten().filter(|(_, off)| !is_hopf(*off)) {
        let (path, value) = (&asked.sweep.path, asked.sweep.text(cycle.parameter));
        warnings.push(format!(
            "the branch is followed no further than {path} = {value}, where it has less than 2 % of its largest amplitude: no eigenvalue begins to grow there"
        ));
    }
    warnings.extend(left_out(known.iter().map(|own| own.left_out).fold(0.0, f64::max)));
    warnings.extend(told.kinks());
    let unknown = known.iter().filter(|own| asked.stability && own.stability.is_stable().is_none()).count();
    if unknown > 0 {
        warnings.push(format!(
            "whether motions nearby are drawn to it is not known of {unknown} of {} cycles",
            known.len()
        ));
    }
    Ok(Outcome {
        scalars,
        dataset: dataset(asked, &known, &told.bifurcations)?,
        checks: checks(asked, &known, ends.iter().flatten().filter(|(_, off)| is_hopf(*off))),
        warnings,
        missing,
        ..Outcome::default()
    })
}

/// How lengths along the key are measured: by its logarithm where its `scale` is that.
#[derive(Clone, Copy)]
struct AlongKey {
    is_log: bool,
}

impl AlongKey {
    fn of(asked: &CycleDiagram) -> Self {
        let is_log = asked.sweep.scale == Spacing::Log && asked.sweep.values.iter().all(|own| *own > 0.0);
        Self { is_log }
    }

    fn measure(self, value: f64) -> f64 {
        if self.is_log { value.ln() } else { value }
    }

    fn value(self, measure: f64) -> f64 {
        if self.is_log { measure.exp() } else { measure }
    }

    /// A branch with the values of the key in place of their measures.
    fn in_values(self, mut branch: AssemblyCycleBranch) -> AssemblyCycleBranch {
        let cycles = branch.cycles.iter_mut().map(|own| &mut own.parameter);
        let folds = branch.folds.iter_mut().map(|(_, own)| own);
        let points = branch.branch_points.iter_mut().map(|own| &mut own.parameter);
        cycles.chain(folds).chain(points).for_each(|own| *own = self.value(*own));
        branch
    }
}

fn range(values: &[f64]) -> [f64; 2] {
    let fold = |of: fn(f64, f64) -> f64, from: f64| values.iter().copied().fold(from, of);
    [fold(f64::min, f64::INFINITY), fold(f64::max, f64::NEG_INFINITY)]
}

/// The last cycle before a branch shrinks to steady sliding.
fn shrunk(branch: &AssemblyCycleBranch) -> Option<&CycleAtKey> {
    branch.cycles.last().filter(|_| branch.end == CycleBranchEnd::SteadySliding)
}

fn told_of(
    asked: &CycleDiagram,
    balance: &HarmonicBalance<'_>,
    at: &impl Fn(f64) -> Result<Assembly, CyclesError>,
    cycle: &CycleAtKey,
    progress: &dyn Progress,
) -> Result<KnownCycle, ModelError> {
    let assembly = at(cycle.parameter)?;
    let balance = balance.of(&assembly)?;
    let (points, quality) = points(&balance, &cycle.motion)?;
    let stability = KnownStability::of(&balance, &cycle.motion, asked.stability, progress)?;
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

/// How far the eigenvalue at the last cycle of a branch is from turning as that does without growing, of its modulus; infinite where there is none.
fn off_neutral(family: &SweptAssembly<'_>, cycle: &CycleAtKey) -> f64 {
    let omega = cycle.motion.turning.frequency;
    let mode = family
        .state(&[cycle.parameter])
        .and_then(|state| family.about(&state))
        .and_then(|about| near_frequency(&about, omega));
    mode.map_or(f64::INFINITY, |mode| {
        let value = mode.eigenvalue.value;
        value.re.abs().max((value.im - omega).abs()) / value.norm()
    })
}

/// The equations of each cycle, and the eigenvalues where the branch shrinks to steady sliding.
fn checks<'c>(
    asked: &CycleDiagram,
    known: &[KnownCycle],
    hopf: impl Iterator<Item = &'c (&'c CycleAtKey, f64)>,
) -> Vec<CheckRecord> {
    let worse = |most: f64, own: f64| if own.is_nan() { f64::INFINITY } else { most.max(own) };
    let largest = known.iter().map(|own| own.residual).fold(0.0, worse);
    let equations = CheckRecord::new(
        "harmonics of the contact forces are those that the contact laws make of the motions",
        format!("largest residual over the largest normal force, {} cycles", known.len()),
        largest.into(),
        1e-8,
    );
    let shrinks = hopf.map(|(cycle, off)| {
        CheckRecord::new(
            "the branch shrinks to steady sliding where an eigenvalue begins to grow",
            format!(
                "eigenvalue at {} = {} against i times the frequency of the last cycle, over its modulus",
                asked.sweep.path,
                asked.sweep.text(cycle.parameter),
            ),
            (*off).into(),
            NEUTRAL,
        )
    });
    std::iter::once(equations).chain(shrinks).collect()
}
