//! What is stored of a response: observed coordinates motion by motion, in their order along the branch.

use super::followed::{FollowedCoordinate, MEASURES};
use super::settings::FrequencyResponse;
use crate::assembly::limit_cycle::stability::{KnownStability, crossing_words, with_multipliers};
use crate::error::ModelError;
use judder_cycles::forced::ForcedResponse;
use judder_cycles::stability::stability_changes;
use judder_store::{Dataset, Table, Variable};
use std::f64::consts::TAU;

/// The arrays.
pub(super) fn dataset(
    asked: &FrequencyResponse,
    found: &ForcedResponse,
    coordinates: &[FollowedCoordinate],
    stabilities: &[KnownStability],
) -> Result<Dataset, ModelError> {
    let along = |name: &str, unit: &str, values: Vec<f64>| {
        Variable::new(name, &["motion"], &[values.len()], values).units(unit)
    };
    let frequency = along("frequency", "Hz", frequencies(found))
        .long_name("frequency of each motion, in the order along the branch")
        .attribute("label", "Frequency (Hz)");
    let residual = along("residual", "1", found.motions.iter().map(|own| own.residual).collect())
        .long_name("largest residual of the balance of harmonics, over the force scale");
    let folds = |name: &str| {
        Variable::new(name, &["fold"], &[found.folds.len()], {
            found.folds.iter().map(|(_, own)| own / TAU).collect::<Vec<f64>>()
        })
    };
    let turns: Vec<i64> = found.folds.iter().map(|(motion, _)| *motion as i64).collect();
    let mut dataset = Dataset::new()
        .with(frequency)?
        .with(residual)?
        .with(folds("fold_frequency").units("Hz").long_name("where the frequency turns"))?
        .with(
            Variable::new("fold_motion", &["fold"], &[turns.len()], turns)
                .long_name("the motion nearest to that, counted from 0"),
        )?;
    if asked.stability {
        let all: Vec<&KnownStability> = stabilities.iter().collect();
        dataset = with_changes(with_multipliers(dataset, "motion", &all)?, stabilities)?;
    }
    for own in coordinates {
        for (k, (measure, words, label)) in MEASURES.into_iter().enumerate() {
            let values = own.measures.iter().map(|measures| measures[k]).collect();
            let variable = along(&format!("{}.{measure}", own.name), "m", values)
                .long_name(&format!("{words}, of the displacement {}", own.name))
                .attribute("label", label);
            dataset = dataset.with(variable)?;
        }
    }
    Ok(dataset)
}

/// Where multipliers cross the unit circle, and how.
fn with_changes(dataset: Dataset, stabilities: &[KnownStability]) -> Result<Dataset, ModelError> {
    let multipliers: Vec<_> = stabilities.iter().map(KnownStability::known).collect();
    let changes = stability_changes(&multipliers);
    let motions: Vec<i64> = changes.iter().map(|own| own.between[0] as i64).collect();
    let kinds: Vec<String> = changes.iter().map(|own| crossing_words(own.crossing).to_owned()).collect();
    let along = ["stability_change"];
    Ok(dataset
        .with(
            Variable::new("change_motion", &along, &[changes.len()], motions)
                .long_name("the last motion before the stability changes, counted from 0"),
        )?
        .with(
            Variable::new("change_kind", &along, &[changes.len()], kinds).long_name("how it changes there"),
        )?)
}

/// The same as a table, a row a motion.
pub(super) fn table(found: &ForcedResponse, coordinates: &[FollowedCoordinate]) -> Result<Table, ModelError> {
    let mut table = Table::new().column("frequency", "Hz", frequencies(found))?;
    for own in coordinates {
        for (k, (measure, ..)) in MEASURES.into_iter().enumerate() {
            let values: Vec<f64> = own.measures.iter().map(|measures| measures[k]).collect();
            table = table.column(&format!("{}.{measure}", own.name), "m", values)?;
        }
    }
    Ok(table)
}

fn frequencies(found: &ForcedResponse) -> Vec<f64> {
    found.motions.iter().map(|own| own.turning.frequency / TAU).collect()
}
