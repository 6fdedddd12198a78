//! `equivalent-damping`: ξ_eq (23) along one key (Fig. 4).

use crate::axis::{self, Curves};
use crate::checks;
use crate::error::ModelError;
use crate::oscillator::case::OscillatorCase;
use crate::oscillator::keys::OscillatorKey;
use crate::oscillator::law_errors::{self, Erring};
use crate::oscillator::steady_states::{SteadyState, along, failure_warning, validity_warnings};
use crate::sweep::{Family, Sweep};
use judder_oscillator::Contact;
use judder_store::{Dataset, Results, Table, Variable};
use judder_study::Progress;
use judder_study::outcome::Outcome;

/// What is told of a curve.
#[derive(Results)]
pub(super) struct ToldDamping {
    value: Vec<f64>,
    #[result(unit = "1")]
    equivalent_damping: Vec<f64>,
}

pub(super) const EQUIVALENT_DAMPING: Erring = Erring {
    name: "equivalent_damping_error",
    long_name: "how far ξ_eq may be off by the errors of the contact law",
    of: |_, within| Some(within.equivalent_damping_error()),
};

pub(super) fn run(
    case: &OscillatorCase,
    contact: &Contact,
    sweep: &Sweep<OscillatorKey>,
    family: Option<&Family<OscillatorKey>>,
    progress: &dyn Progress,
) -> Result<Outcome, ModelError> {
    let (axis, curves) = (axis::of_key(sweep), Curves::new(case, family));
    let mut outcome = Outcome::default();
    let (mut damping, mut states, mut scalars) = (Vec::new(), Vec::new(), Vec::new());
    for inputs in &curves.inputs {
        let line = along(contact, inputs, sweep, progress)?;
        outcome.warnings.extend(failure_warning(&line, &axis.values));
        outcome.missing += line.iter().filter(|s| s.is_err()).count();
        let values: Vec<f64> = line
            .iter()
            .map(|s| s.as_ref().map_or(f64::NAN, |s| s.linearisation.equivalent_damping()))
            .collect();
        damping.extend(values.iter().copied());
        scalars.push(ToldDamping { value: axis.values.clone(), equivalent_damping: values }.scalars());
        states.extend(line.into_iter().map(Result::ok));
    }
    let known: Vec<SteadyState> = states.iter().flatten().copied().collect();
    outcome.warnings.extend(validity_warnings(contact, known.iter()));
    outcome.checks = checks::steady_sliding(contact, &known);
    outcome.scalars = curves.scalars(scalars);
    let rows = vec![axis.values.len(); curves.inputs.len()];
    let mut table = Table::new();
    if let Some((name, unit, column)) = curves.column(&rows) {
        table = table.column(&name, &unit, column)?;
    }
    let repeated: Vec<f64> = rows.iter().flat_map(|_| axis.values.clone()).collect();
    table = table.column(axis.name(), &axis.quantity.unit, repeated)?;
    outcome.table = Some(table.column("equivalent_damping", "1", damping.clone())?);
    let (dimensions, shape) = curves.dimensions(&axis, &[]);
    let variable = Variable::new("equivalent_damping", &dimensions, &shape, damping)
        .units("1")
        .long_name("equivalent damping ξ_eq = c11/2, eq. (23)");
    let mut dataset = Dataset::new().with(axis.coordinate())?;
    if let Some(coordinate) = curves.coordinate() {
        dataset = dataset.with(coordinate)?;
    }
    outcome.dataset = dataset.with(variable)?;
    law_errors::add(&mut outcome, &axis, &curves, contact, &states, &EQUIVALENT_DAMPING)?;
    Ok(outcome)
}
