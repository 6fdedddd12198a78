//! The modes that grow, and their cycles.

use super::cycle::{CycleInBand, SoughtMode};
use super::margin::margins;
use super::margin_told::ToldMargins;
use super::settings::AssemblySqueal;
use super::told::{ToldSqueal, ranked, stabilities};
use crate::assembly::AssemblySubject;
use crate::assembly::eigen::band;
use crate::assembly::limit_cycle::checks::checks;
use crate::assembly::limit_cycle::search::CycleOfMode;
use crate::assembly::limit_cycle::settings::components;
use crate::error::ModelError;
use crate::structure::eigen::run::found;
use judder_assembly::linearised::{Linearised, LinearisedTerms};
use judder_structure::complex_modes::{ComplexMode, Verdict};
use judder_study::Progress;
use judder_study::outcome::Outcome;
use num_complex::Complex64;
use rayon::prelude::*;

pub(super) fn run(
    of: &AssemblySubject<'_>,
    asked: &AssemblySqueal,
    progress: &dyn Progress,
) -> Result<Outcome, ModelError> {
    let steady = of.steady_to_march()?;
    let about = Linearised::new(&of.built.assembly, &steady, LinearisedTerms::default())?;
    let all = found(&about.problem, &band(asked.band[0], asked.band[1]))?;
    let grows = |mode: &&ComplexMode| {
        mode.eigenvalue.verdict() == Verdict::Unstable && mode.eigenvalue.value.im > 0.0
    };
    let values: Vec<Complex64> = all.modes.iter().filter(grows).map(|mode| mode.eigenvalue.value).collect();
    let settings = asked.solver.settings(components(of)?);
    let sought = |value: &Complex64| -> Result<SoughtMode, ModelError> {
        progress.go_on()?;
        let sought = CycleOfMode::new(&of.built.assembly, &steady, *value, &settings, progress)?;
        let cycle = match sought.cycle() {
            Some(cycle) => Ok(CycleInBand::new(of, &sought, cycle, asked.solver.stability, progress)?),
            None => Err(sought.reason().unwrap_or_default()),
        };
        Ok((*value, cycle))
    };
    let modes: Vec<SoughtMode> = values.par_iter().map(sought).collect::<Result<_, _>>()?;
    let mut told = ToldSqueal::new(all.complete(), ranked(&modes));
    let mut warnings = of.doubts(&steady);
    if !told.complete {
        warnings.push("it is not proven that the band has no other modes".to_owned());
    }
    for mode in told.modes.iter().filter(|mode| !mode.reason.is_empty()) {
        warnings.push(format!("mode at {:.1} Hz: {}", mode.mode_frequency, mode.reason));
    }
    warnings.extend(told.all_unstable());
    let mut missing = told.unstable - told.found + usize::from(!told.complete);
    if let Some(sweep) = asked.margin_sweep() {
        let found = margins(of, asked, sweep, &values, progress)?;
        warnings.extend(ToldMargins::doubts(sweep, &found));
        missing += ToldMargins::missing(&found);
        told = told.with_margins(asked, sweep, &found);
    }
    let cycles = || modes.iter().filter_map(|(_, cycle)| cycle.as_ref().ok());
    let checks = match told.found {
        0 => Vec::new(),
        found => checks(
            &format!("{found} cycles"),
            cycles().map(|own| own.residual).collect(),
            cycles().map(|own| own.imbalance).collect(),
        ),
    };
    let outcome = Outcome::of(&told)?;
    let dataset = outcome.dataset.clone().with(stabilities(&told.modes))?;
    Ok(Outcome { dataset, checks, warnings, missing, ..outcome })
}
