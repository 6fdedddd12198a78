//! What the errors of the law leave along a sweep: an error beside every number, and whether it is marginal.

use super::steady_states::SteadyState;
use crate::axis::Curves;
use crate::error::ModelError;
use crate::within_law::MARGINAL;
use judder_oscillator::Contact;
use judder_oscillator::within_law::WithinLaw;
use judder_store::{Declared, Results, Told, Variable};
use judder_study::axis::SweptAxis;
use judder_study::outcome::Outcome;
use serde_json::{Map, Value};

/// A number with errors, and what they are called.
pub(super) struct Erring {
    pub(super) name: &'static str,
    pub(super) long_name: &'static str,
    pub(super) of: fn(&SteadyState, &WithinLaw) -> Option<f64>,
}

/// What is told of a curve besides the errors themselves.
#[derive(Results)]
struct MarginalWithinLaw {
    marginal_within_law: Vec<Option<bool>>,
}

impl Erring {
    /// The keys that [`add`] adds to the summary of a curve, if its law has errors.
    pub(super) fn keys(&self) -> Vec<Declared> {
        let errors = Declared { is_optional: true, ..Declared::new(self.name, Vec::<f64>::kind()) };
        [vec![errors], Option::<MarginalWithinLaw>::declared()].concat()
    }
}

/// Adds the errors of a number at the states of all curves, one a point of the sweep, to an outcome whose law is no formula.
pub(super) fn add(
    outcome: &mut Outcome,
    axis: &SweptAxis,
    curves: &Curves,
    contact: &Contact,
    states: &[Option<SteadyState>],
    erring: &Erring,
) -> Result<(), ModelError> {
    if contact.law.is_formula() {
        return Ok(());
    }
    let within: Vec<Option<(f64, bool)>> = states
        .iter()
        .map(|state| {
            let state = state.as_ref()?;
            let within = WithinLaw::new(contact, &state.coefficients, &state.equilibrium)?;
            Some(((erring.of)(state, &within)?, !within.is_decided()))
        })
        .collect();
    let error = |within: &Option<(f64, bool)>| within.map_or(f64::NAN, |(error, _)| error);
    let add = |scalars: &mut Map<String, Value>, curve: &[Option<(f64, bool)>]| {
        scalars.insert(erring.name.to_owned(), curve.iter().map(error).collect());
        let marginal_within_law = curve.iter().map(|within| within.map(|(_, open)| open)).collect();
        scalars.extend(MarginalWithinLaw { marginal_within_law }.scalars());
    };
    outcome.add_to_curves(within.chunks(axis.values.len().max(1)), add);
    let (dimensions, shape) = curves.dimensions(axis, &[]);
    let variable =
        Variable::new(erring.name, &dimensions, &shape, within.iter().map(error).collect::<Vec<_>>())
            .units("1")
            .long_name(erring.long_name);
    outcome.dataset = std::mem::take(&mut outcome.dataset).with(variable)?;
    let marginal = within.iter().flatten().filter(|(_, open)| *open).count();
    if marginal > 0 {
        outcome.warnings.push(format!(
            "at {marginal} of {} points the verdict is {MARGINAL}: its errors decide there",
            within.len()
        ));
    }
    Ok(())
}
