//! What grows from thresholds, as scalars, arrays and columns of a table.

use super::Found;
use crate::analyses::axis::{Axis, Curves};
use crate::analyses::margins::{Margin, Onset};
use crate::error::StudyError;
use judder_store::{Dataset, Table, Variable, number};
use serde_json::{Map, Value, json};

/// A number of a threshold: its name in results, what it is, whether it has the unit of the threshold or that of its inverse.
struct Number {
    name: &'static str,
    long_name: &'static str,
    unit: Unit,
    of: fn(&Onset) -> Option<f64>,
}

#[derive(Clone, Copy)]
enum Unit {
    One,
    Threshold,
    PerThreshold,
}

impl Unit {
    fn text(self, threshold: &str) -> String {
        match (self, threshold) {
            (Self::One, _) | (_, "1") => "1".to_owned(),
            (Self::Threshold, unit) => unit.to_owned(),
            (Self::PerThreshold, unit) => format!("1/{unit}"),
        }
    }
}

/// What is always known of a threshold.
const OF_HOPF_POINT: [Number; 2] = [
    Number {
        name: "lyapunov_coefficient",
        long_name: "first Lyapunov coefficient Re c₁ of each threshold: growth rate per squared amplitude |z| of x̃ = 2|z| cos φ",
        unit: Unit::One,
        of: |onset| Some(onset.hopf.coefficient),
    },
    Number {
        name: "amplitude_factor",
        long_name: "d(rms² of x̃)/d(threshold quantity): the cycles near a threshold have an rms of √(factor · (value − threshold))",
        unit: Unit::PerThreshold,
        of: |onset| Some(onset.amplitude_factor),
    },
];

/// What the branches tell.
const OF_BRANCH: [Number; 2] = [
    Number {
        name: "fold",
        long_name: "first turn of the branch of cycles from each threshold: up to there a knock starts a cycle beside stable steady sliding",
        unit: Unit::Threshold,
        of: |onset| onset.margin.as_ref()?.fold,
    },
    Number {
        name: "reaches",
        long_name: "value farthest from each threshold at which a cycle of its branch is known",
        unit: Unit::Threshold,
        of: |onset| onset.margin.as_ref()?.reaches,
    },
];

const CRITICALITY: [(u8, &str); 3] = [(0, "none"), (1, "supercritical"), (2, "subcritical")];
const STABLE_SIDE: [(u8, &str); 3] = [(0, "none"), (1, "below"), (2, "above")];

fn criticality(onset: &Onset) -> u8 {
    1 + u8::from(onset.hopf.is_subcritical())
}

fn stable_side(onset: &Onset) -> u8 {
    1 + u8::from(onset.stable_side > 0.0)
}

fn numbers(global_margin: bool) -> impl Iterator<Item = &'static Number> {
    OF_HOPF_POINT.iter().chain(OF_BRANCH.iter().filter(move |_| global_margin))
}

/// Adds to the scalars of a curve, an entry for each threshold of the full system, nested like those.
pub(super) fn add_scalars(scalars: &mut Map<String, Value>, curve: &[Found], global_margin: bool) {
    let mut add = |name: &str, of: &dyn Fn(&Onset) -> Value| {
        let of = |onset: &Option<Onset>| onset.as_ref().map_or(Value::Null, of);
        let lists = curve.iter().map(|found| found.onsets.iter().map(of).collect::<Value>());
        scalars.insert(name.to_owned(), lists.collect());
    };
    add("criticality", &|onset| json!(CRITICALITY[usize::from(criticality(onset))].1));
    add("stable_side", &|onset| json!(STABLE_SIDE[usize::from(stable_side(onset))].1));
    for entry in numbers(global_margin) {
        add(entry.name, &|onset| (entry.of)(onset).map_or(Value::Null, number));
    }
    if global_margin {
        add("branch_end", &|onset| onset.margin.as_ref().map_or(Value::Null, |margin| json!(margin.end)));
    }
}

/// Adds to the arrays, over the same dimensions as the thresholds of the full system.
pub(super) fn add_arrays(
    mut dataset: Dataset,
    (axis, curves): (&Axis, &Curves),
    found: &[Found],
    unit: &str,
    global_margin: bool,
) -> Result<Dataset, StudyError> {
    let most = found.iter().map(|f| f.onsets.len()).max().unwrap_or(0);
    let (dimensions, shape) = curves.dimensions(axis, &[("full_root", most)]);
    let onsets =
        || found.iter().flat_map(move |f| (0..most).map(move |k| f.onsets.get(k).and_then(Option::as_ref)));
    for (name, long_name, meanings, of) in [
        ("criticality", "what grows from each threshold", &CRITICALITY, criticality as fn(&Onset) -> u8),
        (
            "stable_side",
            "on which side of each threshold steady sliding is stable",
            &STABLE_SIDE,
            stable_side,
        ),
    ] {
        let codes = onsets().map(|onset| onset.map_or(0, of)).collect();
        let variable = Variable::classes(name, &dimensions, &shape, codes, meanings).long_name(long_name);
        dataset = dataset.with(variable)?;
    }
    for entry in numbers(global_margin) {
        let values: Vec<f64> = onsets().map(|onset| onset.and_then(entry.of).unwrap_or(f64::NAN)).collect();
        let variable = Variable::new(entry.name, &dimensions, &shape, values)
            .units(&entry.unit.text(unit))
            .long_name(entry.long_name)
            .apart();
        dataset = dataset.with(variable)?;
    }
    Ok(dataset)
}

/// Adds columns for the rows of a table of thresholds; `rows` are their onsets, `None` for the system without damping.
pub(super) fn add_columns(
    mut table: Table,
    rows: &[Option<&Onset>],
    unit: &str,
    global_margin: bool,
) -> Result<Table, StudyError> {
    let words = |of: &dyn Fn(&Onset) -> String| -> Vec<String> {
        rows.iter().map(|onset| onset.map_or(String::new(), of)).collect()
    };
    table = table
        .column("criticality", "", words(&|o| CRITICALITY[usize::from(criticality(o))].1.to_owned()))?
        .column("stable_side", "", words(&|o| STABLE_SIDE[usize::from(stable_side(o))].1.to_owned()))?;
    for entry in numbers(global_margin) {
        let values: Vec<f64> =
            rows.iter().map(|onset| onset.and_then(entry.of).unwrap_or(f64::NAN)).collect();
        table = table.column(entry.name, &entry.unit.text(unit), values)?;
    }
    if global_margin {
        let end = |onset: &Onset| onset.margin.as_ref().map_or(String::new(), |margin| margin.end.clone());
        table = table.column("branch_end", "", words(&end))?;
    }
    Ok(table)
}

/// How many thresholds have no mode, and how many branches no fold, with the first reason.
pub(super) fn warnings(found: &[Found]) -> Vec<String> {
    let all = found.iter().flat_map(|f| &f.onsets);
    let unknown = all.clone().filter(|onset| onset.is_none()).count();
    let margins: Vec<&Margin> = all.clone().flatten().filter_map(|onset| onset.margin.as_ref()).collect();
    let open: Vec<&&Margin> = margins.iter().filter(|margin| margin.is_open).collect();
    let beyond = all.flatten().filter(|onset| goes_beyond(onset)).count();
    let mut warnings = Vec::new();
    if unknown > 0 {
        warnings.push(format!("what grows from {unknown} thresholds could not be had"));
    }
    if let Some(first) = open.first() {
        warnings.push(format!(
            "{} of {} branches of cycles have no fold, for one: {}; `reaches` says how far they are known",
            open.len(),
            margins.len(),
            first.end
        ));
    }
    if beyond > 0 {
        warnings.push(format!(
            "{beyond} of {} branches come back beyond their first fold: there cycles live next to stable steady sliding as well; `reaches` \
             says how far",
            margins.len()
        ));
    }
    warnings
}

/// Whether a later turn of a branch lies beyond its first fold.
fn goes_beyond(onset: &Onset) -> bool {
    let Some((fold, reaches)) = onset.margin.as_ref().and_then(|m| Some((m.fold?, m.reaches?))) else {
        return false;
    };
    (reaches - fold) * onset.stable_side > 1e-3 * fold.abs()
}
