//! The ranges in which the errors of the law leave thresholds, as scalars, arrays and columns of a table.

use super::found::FoundThresholds;
use crate::axis::Curves;
use crate::error::ModelError;
use judder_oscillator::critical::Thresholds;
use judder_oscillator::undecided::{Ranges, Undecided};
use judder_store::{Dataset, Declared, Table, Told, Variable};
use judder_study::axis::SweptAxis;
use judder_study::outcome::Outcome;
use serde_json::{Map, Value};

/// A system of thresholds: its name in results, its ranges.
type ThresholdSystem = (&'static str, fn(&Undecided) -> &Ranges);

const SYSTEMS: [ThresholdSystem; 2] =
    [("full", |undecided| &undecided.full), ("conservative", |undecided| &undecided.conservative)];

/// Adds the ranges of all curves to the outcome of an analysis with a law that is no formula.
pub(super) fn add(
    outcome: &mut Outcome,
    axis: &SweptAxis,
    curves: &Curves,
    found: &[FoundThresholds],
    unit: &str,
) -> Result<(), ModelError> {
    outcome.add_to_curves(found.chunks(axis.values.len()), add_scalars);
    outcome.dataset = add_arrays(std::mem::take(&mut outcome.dataset), axis, curves, found, unit)?;
    outcome.table = outcome.table.take().map(|table| add_columns(table, found, unit)).transpose()?;
    outcome.warnings.extend(warning(found));
    Ok(())
}

/// The key of the ranges of a system.
fn key(system: &str) -> String {
    format!("{system}_within_law")
}

/// The keys that [`add`] adds to the summary of a curve, if its law has errors.
pub(super) fn keys() -> Vec<Declared> {
    let declared = |(system, _): ThresholdSystem| Declared {
        is_optional: true,
        ..Declared::new(key(system), Vec::<Ranges>::kind())
    };
    SYSTEMS.map(declared).to_vec()
}

/// Adds to the scalars of a curve a list of ranges a value, `null` where nothing is known of the errors of the law.
fn add_scalars(scalars: &mut Map<String, Value>, curve: &[FoundThresholds]) {
    for (system, of) in SYSTEMS {
        let ranges = curve.iter().map(|found| found.within_law.as_ref().map(of).told());
        scalars.insert(key(system), ranges.collect());
    }
}

/// Adds where each range begins and where it ends.
fn add_arrays(
    mut dataset: Dataset,
    axis: &SweptAxis,
    curves: &Curves,
    found: &[FoundThresholds],
    unit: &str,
) -> Result<Dataset, ModelError> {
    for (system, of) in SYSTEMS {
        let ranges = |found: &FoundThresholds| {
            found.within_law.as_ref().map_or(Ranges::new(), |within| of(within).clone())
        };
        let all: Vec<Ranges> = found.iter().map(ranges).collect();
        let most = all.iter().map(Vec::len).max().unwrap_or(0);
        let dimension = format!("{system}_range");
        let (dimensions, shape) = curves.dimensions(axis, &[(&dimension, most)]);
        for (end, name, long_name) in [(0, "from", "begin"), (1, "to", "end")] {
            let padded =
                all.iter().flat_map(|ranges| (0..most).map(|k| ranges.get(k).map_or(f64::NAN, |r| r[end])));
            let variable = Variable::new(
                &format!("{system}_within_law_{name}"),
                &dimensions,
                &shape,
                padded.collect::<Vec<f64>>(),
            )
            .units(unit)
            .long_name(&format!(
                "where the ranges {long_name} in which the errors of the law leave the {system} thresholds"
            ))
            .apart();
            dataset = dataset.with(variable)?;
        }
    }
    Ok(dataset)
}

/// Adds for each row of the table, which has the thresholds of both systems value by value, the range that its threshold lies in.
fn add_columns(table: Table, found: &[FoundThresholds], unit: &str) -> Result<Table, ModelError> {
    let rows = found.iter().flat_map(|found| {
        let Thresholds { full, conservative, .. } = &found.thresholds;
        let roots = [full, conservative].into_iter().zip(SYSTEMS);
        roots.flat_map(move |(roots, (_, of))| {
            let ranges = found.within_law.as_ref().map_or(&[][..], |within| of(within));
            let own = |root: &f64| ranges.iter().find(|[from, to]| (from..=to).contains(&root)).copied();
            roots.iter().map(move |root| own(root).unwrap_or([f64::NAN; 2])).collect::<Vec<_>>()
        })
    });
    let (from, to): (Vec<f64>, Vec<f64>) = rows.map(|[from, to]| (from, to)).unzip();
    Ok(table.column("within_law_from", unit, from)?.column("within_law_to", unit, to)?)
}

/// At how many values the law may have thresholds of the full system that its own numbers do not show.
fn warning(found: &[FoundThresholds]) -> Option<String> {
    let is_hidden = |found: &&FoundThresholds| {
        let has_none =
            |[from, to]: &[f64; 2]| !found.thresholds.full.iter().any(|root| (from..=to).contains(&root));
        found.within_law.as_ref().is_some_and(|within| within.full.iter().any(has_none))
    };
    let count = found.iter().filter(is_hidden).count();
    (count > 0).then(|| {
        format!(
            "at {count} of {} points the law with its errors may have thresholds that its own numbers do not show: `full_within_law` says where",
            found.len()
        )
    })
}
