//! `judder point`: one operating point, in milliseconds.

use clap::Args;
use judder_models::ModelError;
use judder_models::oscillator::case::OscillatorCase;
use judder_models::point::point;

use super::CaseArguments;
use crate::console::{Console, ResultDocument};
use crate::failure::{Exit, Failure};

const HELP: &str = "\
Examples:
  judder point case.toml
  judder point case.toml --set operation.velocity=1e-3 --set contact.shear_strength=0.05
  judder point case.toml --json | jq .growth_rate

All numbers are dimensionless as in the oscillator paper: eigenvalues in units of ω_nx, forces of E0* R², areas of R².";

/// Analyse one operating point of an oscillator: equilibrium, matrices, eigenvalues, verdict, thresholds
#[derive(Debug, Args)]
#[command(after_help = HELP)]
pub(crate) struct PointArguments {
    #[command(flatten)]
    case: CaseArguments,
}

impl PointArguments {
    pub(super) fn execute(&self, console: Console) -> Result<Exit, Failure> {
        let case = self.case.read(console)?.case;
        let Some(case) = case.of::<OscillatorCase>() else {
            return Err(ModelError::WrongModel { command: "point", model: case.model() }.into());
        };
        let point = point(case)?;
        let lacking = match point.steady.class.verdict() {
            Some(_) => Vec::new(),
            None => vec![format!("operating point: {}", point.steady.verdict_in_words())],
        };
        console.result(|| point.text(), || ResultDocument::lacking(point.json(), &lacking))?;
        Ok(console.lacking(&lacking, "another speed, load or strength may have one: --set tries it"))
    }
}
