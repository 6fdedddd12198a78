//! Eigenvalues at the values of a parameter.

use crate::axis::{self, Curves};
use crate::error::ModelError;
use crate::oscillator::spectrum::{Spectra, SpectraWords, outcome};
use crate::sweep::{ParameterKey, Sweep};
use crate::two_degrees::case::TwoDegreesCase;
use judder_study::outcome::Outcome;

const WORDS: SpectraWords = SpectraWords {
    full: "eigenvalues λ of the full system",
    conservative: "eigenvalues λ without damping",
};

pub(super) fn run(case: &TwoDegreesCase, sweep: &Sweep<ParameterKey>) -> Result<Outcome, ModelError> {
    let axis = axis::of_parameter(sweep);
    let spectra = axis.values.iter().map(|value| Spectra::new(&case.system(&[(sweep, *value)])?)).collect();
    let mut outcome = outcome(&axis, &Curves::alone(), spectra, &WORDS, None)?;
    if outcome.missing > 0 {
        outcome.warnings.push(format!(
            "no eigenvalues at {} of {} values: the matrices are not finite there, or M is not symmetric and positive definite",
            outcome.missing,
            axis.values.len()
        ));
    }
    Ok(outcome)
}
