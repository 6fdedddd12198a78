//! `reduction`: the reduced structure against the full one.

use super::modes::Undamped;
use crate::error::StudyError;
use crate::outcome::{CheckRecord, Outcome};
use crate::structure::Structure;
use judder_case::StructureCase;
use judder_case::structure::reduction::FixedModes;
use judder_store::{Dataset, Table, Variable};
use judder_structure::craig_bampton::CraigBampton;
use judder_structure::modes::{Mode, Wanted, modes};
use serde_json::{Map, json};
use std::f64::consts::TAU;

pub(super) fn run(
    (case, structure): (&StructureCase, &Structure),
    count: usize,
) -> Result<Outcome, StudyError> {
    let problem = structure.at(case, &case.values())?;
    let Undamped { mass, stiffness, warnings } = Undamped::new(&problem)?;
    let kept_modes = match case.reduction.as_ref().map(|reduction| reduction.modes) {
        Some(FixedModes::Count(count)) => count,
        _ => 20,
    };
    let reduced = CraigBampton::new(&stiffness, &mass, &structure.kept, kept_modes)?;
    let (values, _) = reduced.modal_form()?;
    let full = modes(&stiffness, &mass, Wanted::Lowest(count))?;
    let full: Vec<f64> = full.modes.iter().map(Mode::frequency_hz).collect();
    let reduced: Vec<f64> = values.iter().take(full.len()).map(|value| value.max(0.0).sqrt() / TAU).collect();
    let errors: Vec<f64> = reduced.iter().zip(&full).map(|(r, f)| r / f - 1.0).collect();
    let size = structure.kept.len() + kept_modes;
    let compared = reduced.len();
    let modal = |name: &str, values: &[f64]| Variable::new(name, &["mode"], &[compared], values.to_vec());
    let dataset = Dataset::new()
        .attribute("kind", "reduction")?
        .with(
            Variable::coordinate("mode", (1..=compared as i64).collect::<Vec<_>>())
                .long_name("number of the mode"),
        )?
        .with(modal("full", &full).units("Hz").long_name("frequency of the full structure"))?
        .with(modal("reduced", &reduced).units("Hz").long_name("frequency of the reduced structure"))?
        .with(modal("error", &errors).units("1").long_name("relative error of the reduced frequency"))?;
    let table = Table::new()
        .column("mode", "1", (1..=compared as i64).collect::<Vec<_>>())?
        .column("full", "Hz", full.clone())?
        .column("reduced", "Hz", reduced.clone())?
        .column("error", "1", errors.clone())?;
    let scalars = Map::from_iter([
        ("full_hz".to_owned(), json!(full)),
        ("reduced_hz".to_owned(), json!(reduced)),
        ("errors".to_owned(), json!(errors)),
        ("kept_freedoms".to_owned(), json!(structure.kept.len())),
        ("fixed_interface_modes".to_owned(), json!(kept_modes)),
        ("reduced_freedoms".to_owned(), json!(size)),
        ("degrees_of_freedom".to_owned(), json!(problem.size())),
    ]);
    let below = errors.iter().copied().fold(0.0, |a: f64, b| a.max(-b));
    let checks = vec![CheckRecord {
        name: "reduced frequencies lie above the full ones".to_owned(),
        compared: format!("how far below the nearest one lies, relative, of {compared}"),
        figure: below,
        limit: 1e-6,
    }];
    Ok(Outcome { scalars, dataset, table: Some(table), checks, warnings, ..Outcome::default() })
}
