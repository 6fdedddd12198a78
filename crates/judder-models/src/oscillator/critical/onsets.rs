//! What grows from thresholds, as scalars, arrays and columns of a table.

use super::found::FoundThresholds;
use crate::axis::Curves;
use crate::error::ModelError;
use crate::oscillator::margins::{self, Margin, MarginOnset, TOLD, ToldSearch, ToldStarts};
use judder_store::{Dataset, Declared, Table, Told, Variable};
use judder_study::axis::SweptAxis;
use serde_json::{Map, Value};

/// A number of a threshold: its name in results, what it is, whether it has the unit of the threshold or that of its inverse.
struct ThresholdNumber {
    name: &'static str,
    long_name: &'static str,
    unit: ThresholdUnit,
    of: fn(&MarginOnset) -> Option<f64>,
}

#[derive(Clone, Copy)]
enum ThresholdUnit {
    One,
    Threshold,
    PerThreshold,
}

impl ThresholdUnit {
    fn text(self, threshold: &str) -> String {
        match (self, threshold) {
            (Self::One, _) | (_, "1") => "1".to_owned(),
            (Self::Threshold, unit) => unit.to_owned(),
            (Self::PerThreshold, unit) => format!("1/{unit}"),
        }
    }
}

/// What is always known of a threshold.
const OF_HOPF_POINT: [ThresholdNumber; 2] = [
    ThresholdNumber {
        name: "lyapunov_coefficient",
        long_name: "first Lyapunov coefficient Re c₁ of each threshold: growth rate per squared amplitude |z| of x̃ = 2|z| cos φ",
        unit: ThresholdUnit::One,
        of: |onset| Some(onset.hopf.coefficient),
    },
    ThresholdNumber {
        name: "amplitude_factor",
        long_name: "d(rms² of x̃)/d(threshold quantity): the cycles near a threshold have an rms of √(factor · (value − threshold))",
        unit: ThresholdUnit::PerThreshold,
        of: |onset| Some(onset.amplitude_factor),
    },
];

/// What the branches and the search beyond them tell.
const OF_MARGIN: [ThresholdNumber; 4] = [
    ThresholdNumber {
        name: "fold",
        long_name: "least fold over the known branches of motions beside each threshold: up to there a knock may start one beside stable \
                    steady sliding",
        unit: ThresholdUnit::Threshold,
        of: |onset| onset.margin.as_ref()?.fold(),
    },
    ThresholdNumber {
        name: "branch_fold",
        long_name: "first turn of the branch of cycles that begins at each threshold",
        unit: ThresholdUnit::Threshold,
        of: |onset| onset.margin.as_ref()?.branch_fold(),
    },
    ThresholdNumber {
        name: "reaches",
        long_name: "value farthest from each threshold at which a motion beside steady sliding is known",
        unit: ThresholdUnit::Threshold,
        of: |onset| onset.margin.as_ref()?.reaches(onset.stable_side),
    },
    ThresholdNumber {
        name: "moving_share",
        long_name: "share of starts that keep moving a twentieth before the known motions end",
        unit: ThresholdUnit::One,
        of: |onset| onset.margin.as_ref()?.search.moving_share(),
    },
];

/// A class of thresholds: its name in results, what it is, its words, and which one a threshold has.
type ThresholdClass = (&'static str, &'static str, &'static [(u8, &'static str)], fn(&MarginOnset) -> u8);

const CRITICALITY: [(u8, &str); 3] = [(0, "none"), (1, "supercritical"), (2, "subcritical")];
const STABLE_SIDE: [(u8, &str); 3] = [(0, "none"), (1, "below"), (2, "above")];

fn criticality(onset: &MarginOnset) -> u8 {
    1 + u8::from(onset.hopf.is_subcritical())
}

fn stable_side(onset: &MarginOnset) -> u8 {
    1 + u8::from(onset.stable_side > 0.0)
}

fn numbers(global_margin: bool) -> impl Iterator<Item = &'static ThresholdNumber> {
    OF_HOPF_POINT.iter().chain(OF_MARGIN.iter().filter(move |_| global_margin))
}

fn told(onset: &MarginOnset) -> u8 {
    onset.margin.as_ref().map_or(0, |margin| margin.search.told as u8)
}

/// Where the threshold's own branch ends, in words; nothing beside a supercritical one.
fn branch_end(onset: &MarginOnset) -> Option<&str> {
    Some(&onset.margin.as_ref()?.own.as_ref()?.end)
}

/// The keys that [`add_scalars`] adds to the summary of a curve.
pub(super) fn keys(global_margin: bool) -> Vec<Declared> {
    let word = |name: &'static str| (name, String::kind());
    let of_margin =
        [word("branch_end"), word("told"), ("search", ToldSearch::kind()), ("basin", ToldStarts::kind())];
    let numbers = numbers(global_margin).map(|entry| (entry.name, f64::kind()));
    let all = [word("criticality"), word("stable_side")].into_iter().chain(numbers);
    let all = all.chain(of_margin.into_iter().filter(|_| global_margin));
    all.map(|(name, kind)| Declared::new(name, kind.list().list())).collect()
}

/// Adds to the scalars of a curve, an entry for each threshold of the full system, nested like those.
pub(super) fn add_scalars(scalars: &mut Map<String, Value>, curve: &[FoundThresholds], global_margin: bool) {
    let mut add = |name: &str, of: &dyn Fn(&MarginOnset) -> Value| {
        let of = |onset: &Option<MarginOnset>| onset.as_ref().map_or(Value::Null, of);
        let lists = curve.iter().map(|found| found.onsets.iter().map(of).collect::<Value>());
        scalars.insert(name.to_owned(), lists.collect());
    };
    add("criticality", &|onset| CRITICALITY[usize::from(criticality(onset))].1.told());
    add("stable_side", &|onset| STABLE_SIDE[usize::from(stable_side(onset))].1.told());
    for entry in numbers(global_margin) {
        add(entry.name, &|onset| (entry.of)(onset).told());
    }
    if global_margin {
        let of = |of: fn(&Margin) -> Value| {
            move |onset: &MarginOnset| onset.margin.as_ref().map_or(Value::Null, of)
        };
        add("branch_end", &|onset| branch_end(onset).map(str::to_owned).told());
        add("told", &of(|margin| margin.search.told.words().told()));
        add("search", &of(|margin| margin.search.summary().told()));
        add("basin", &of(|margin| margin.search.basin().told()));
    }
}

/// Adds to the arrays, over the same dimensions as the thresholds of the full system.
pub(super) fn add_arrays(
    mut dataset: Dataset,
    axis: &SweptAxis,
    curves: &Curves,
    found: &[FoundThresholds],
    unit: &str,
    global_margin: bool,
) -> Result<Dataset, ModelError> {
    let most = found.iter().map(|f| f.onsets.len()).max().unwrap_or(0);
    let (dimensions, shape) = curves.dimensions(axis, &[("full_root", most)]);
    let onsets =
        || found.iter().flat_map(move |f| (0..most).map(move |k| f.onsets.get(k).and_then(Option::as_ref)));
    let mut classes: Vec<ThresholdClass> = vec![
        ("criticality", "what grows from each threshold", &CRITICALITY, criticality),
        (
            "stable_side",
            "on which side of each threshold steady sliding is stable",
            &STABLE_SIDE,
            stable_side,
        ),
    ];
    if global_margin {
        classes.push((
            "told",
            "what a search tells of the stable points beyond all known motions",
            &TOLD,
            told,
        ));
    }
    for (name, long_name, meanings, of) in classes {
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
    rows: &[Option<&MarginOnset>],
    unit: &str,
    global_margin: bool,
) -> Result<Table, ModelError> {
    let words = |of: &dyn Fn(&MarginOnset) -> String| -> Vec<String> {
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
        let end = |onset: &MarginOnset| branch_end(onset).unwrap_or_default().to_owned();
        let told = |onset: &MarginOnset| TOLD[usize::from(told(onset))].1.to_owned();
        table = table.column("branch_end", "", words(&end))?.column("told", "", words(&told))?;
    }
    Ok(table)
}

/// How many thresholds have no mode, how many branches no fold and how many searches no end, with the first reason.
pub(super) fn warnings(found: &[FoundThresholds]) -> Vec<String> {
    let all = found.iter().flat_map(|f| &f.onsets);
    let unknown = all.clone().filter(|onset| onset.is_none()).count();
    let margins: Vec<&Margin> = all.clone().flatten().filter_map(|onset| onset.margin.as_ref()).collect();
    let beyond = all.flatten().filter(|onset| goes_beyond(onset)).count();
    let mut warnings = Vec::new();
    if unknown > 0 {
        warnings.push(format!("what grows from {unknown} thresholds could not be had"));
    }
    warnings.extend(margins::open(&margins, "`reaches` says how far they are known"));
    if beyond > 0 {
        warnings.push(format!(
            "{beyond} of {} branches come back beyond the least fold: there cycles live next to stable steady sliding as well; `reaches` \
             says how far",
            margins.len()
        ));
    }
    warnings
}

/// Whether a later turn of a branch lies beyond the least fold.
fn goes_beyond(onset: &MarginOnset) -> bool {
    let of = |margin: &Margin| Some((margin.fold()?, margin.reaches(onset.stable_side)?));
    let Some((fold, reaches)) = onset.margin.as_ref().and_then(of) else { return false };
    (reaches - fold) * onset.stable_side > 1e-3 * fold.abs()
}
