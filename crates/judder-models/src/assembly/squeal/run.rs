//! The modes that grow, and their cycles.

use super::at_change::ModeInBand;
use super::cures::cures;
use super::cycle::{CycleInBand, SoughtMode};
use super::knocks::{bends, knocked};
use super::margin::margins;
use super::margin_told::ToldMargins;
use super::settings::AssemblySqueal;
use super::small_motions::KnownSmallMotions;
use super::told::{ToldSqueal, ranked, stabilities};
use crate::assembly::AssemblySubject;
use crate::assembly::eigen::band;
use crate::assembly::limit_cycle::checks::checks;
use crate::assembly::limit_cycle::search::CycleOfMode;
use crate::assembly::meant_mode::mode_at;
use crate::assembly::periodic::components;
use crate::error::ModelError;
use crate::structure::eigen::run::found;
use judder_assembly::linearised::{Linearised, LinearisedTerms};
use judder_assembly::steady::SteadySliding;
use judder_numerics::parallel;
use judder_structure::complex_modes::{ComplexMode, Verdict};
use judder_study::Progress;
use judder_study::kept::KeptLines;
use judder_study::outcome::{CheckRecord, Outcome};
use judder_study::text::short;
use num_complex::Complex64;
use std::f64::consts::TAU;

pub(super) fn run(
    of: &AssemblySubject<'_>,
    asked: &AssemblySqueal,
    kept: KeptLines<'_>,
    progress: &dyn Progress,
) -> Result<Outcome, ModelError> {
    let steady = of.steady_to_march()?;
    let about = Linearised::new(&of.built.assembly, &steady, LinearisedTerms::default())?;
    let all = found(&about.problem, &band(asked.band[0], asked.band[1]))?;
    let swings = |mode: &&ComplexMode| {
        mode.eigenvalue.verdict() == Verdict::Unstable && mode.eigenvalue.value.im > 0.0
    };
    let values: Vec<Complex64> = all.modes.iter().filter(swings).map(|mode| mode.eigenvalue.value).collect();
    let modes = sought(of, asked, &steady, &values, progress)?;
    let mut told = ToldSqueal::new(asked.band, all.complete(), ranked(&modes));
    let mut warnings = of.doubts(&steady);
    if !told.complete {
        warnings.push("it is not proven that the band has no other modes".to_owned());
    }
    for mode in told.modes.iter().filter(|mode| !mode.reason.is_empty()) {
        warnings.push(format!("{}: {}", mode_at(mode.mode_frequency), mode.reason));
    }
    let unheard = told.all_unstable();
    // motions go somewhere, but how loud that is no cycle tells
    let unconverged = told.modes.iter().filter(|mode| mode.converged == Some(false)).count();
    let mut missing = told.unstable - told.found
        + unconverged
        + usize::from(!told.complete)
        + usize::from(unheard.is_some());
    warnings.extend(unheard);
    let mut checks = checked(&modes);
    if let Some(sweep) = asked.margin_sweep() {
        let found = margins(of, asked, sweep, &values, (kept, progress))?;
        warnings.extend(ToldMargins::doubts(sweep, &found));
        missing += ToldMargins::missing(&found);
        checks.extend(found.checks(sweep));
        told = told.with_margins(asked, sweep, &found);
    }
    let knocks = match &asked.knocks {
        Some(knocks) => {
            let small = KnownSmallMotions::of(&about.problem, (asked.band, &all), bends(of, &steady)?)?;
            Some((knocks, small, knocked(of, knocks, &steady, small, (kept, progress))?))
        }
        None => None,
    };
    if let Some((asked, small, found)) = &knocks {
        warnings.extend(found.warnings(small));
        missing += found.unsolved();
        told.knocks = Some(found.told(asked, small));
        if let Some(margin) = told.margin.as_mut().filter(|_| found.vibrates()) {
            margin.set_knocked(small);
        }
    }
    if let Some(cured) = asked.cures.as_ref().filter(|own| own.asks()) {
        let found = cures(of, cured, leading(asked, &told, &values), progress)?;
        warnings.extend(found.doubts());
        told.cures = Some(found);
    }
    let outcome = Outcome::of(&told)?;
    let mut dataset = outcome.dataset.clone().with(stabilities(&told.modes))?;
    if let Some((.., found)) = &knocks {
        dataset = found.variables(dataset)?;
    }
    Ok(Outcome { dataset, checks, warnings, missing, ..outcome })
}

/// The mode whose cures are sought, or why there is none.
fn leading(asked: &AssemblySqueal, told: &ToldSqueal, values: &[Complex64]) -> Result<ModeInBand, String> {
    match told.leading() {
        Some(leading) => Ok(ModeInBand { value: values[leading], band: asked.band, unstable: values.len() }),
        None => {
            let [from, to] = asked.band.map(|omega| short(omega / TAU));
            Err(format!("no mode from {from} to {to} Hz, the band that is asked for, grows"))
        }
    }
}

/// The cycle of each of these modes, or why there is none.
fn sought(
    of: &AssemblySubject<'_>,
    asked: &AssemblySqueal,
    steady: &SteadySliding,
    modes: &[Complex64],
    progress: &dyn Progress,
) -> Result<Vec<SoughtMode>, ModelError> {
    let settings = asked.solver.settings(components(of)?);
    let sought = |value: &Complex64| -> Result<SoughtMode, ModelError> {
        progress.go_on()?;
        let sought = CycleOfMode::new(&of.built.assembly, steady, *value, &settings, progress)?;
        let cycle = match sought.cycle() {
            Some(cycle) => Ok(CycleInBand::new(of, &sought, cycle, asked.solver.stability, progress)?),
            None => Err(sought.reason().unwrap_or_default()),
        };
        Ok((*value, cycle))
    };
    parallel::try_each(modes, sought)
}

/// What is checked of all cycles that were found.
fn checked(modes: &[SoughtMode]) -> Vec<CheckRecord> {
    let cycles = || modes.iter().filter_map(|(_, cycle)| cycle.as_ref().ok());
    match cycles().count() {
        0 => Vec::new(),
        found => checks(
            &format!("{found} cycles"),
            cycles().map(|own| own.residual).collect(),
            cycles().map(|own| own.imbalance).collect(),
        ),
    }
}
