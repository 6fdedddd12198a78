//! Figures of results that are nearly nothing: every array of every kind of analysis with none or one along each of its dimensions, with
//! nothing but NaN, or with one value throughout. What there is to draw is drawn; nothing fails.

use crate::contact::run_text;
use crate::sliding::small;
use crate::{case, run_into};
use judder_models::REGISTRY;
use judder_report::{json, svg};
use judder_store::{Complex64, Dataset, StudyFolder, Variable, VariableValues};
use std::collections::BTreeSet;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;

/// The values whose places these are.
fn taken<T: Clone>(values: &[T], places: &[usize]) -> Vec<T> {
    places.iter().map(|place| values[*place].clone()).collect()
}

/// An array with only the first `length` along a dimension.
fn shortened(variable: &Variable, dimension: &str, length: usize) -> Variable {
    let Some(axis) = variable.dimensions.iter().position(|own| own == dimension) else {
        return variable.clone();
    };
    let inner: usize = variable.shape[axis + 1..].iter().product();
    let own = variable.shape[axis];
    let places: Vec<usize> = (0..variable.data.len()).filter(|k| k / inner.max(1) % own < length).collect();
    let data = match &variable.data {
        VariableValues::F64(values) => VariableValues::F64(taken(values, &places)),
        VariableValues::Complex(values) => VariableValues::Complex(taken(values, &places)),
        VariableValues::I64(values) => VariableValues::I64(taken(values, &places)),
        VariableValues::U8(values) => VariableValues::U8(taken(values, &places)),
        VariableValues::Text(values) => VariableValues::Text(taken(values, &places)),
    };
    let mut shape = variable.shape.clone();
    shape[axis] = length.min(own);
    Variable { shape, data, ..variable.clone() }
}

/// An array of one value throughout; coordinates stay what they are.
fn filled(variable: &Variable, value: f64) -> Variable {
    if variable.is_coordinate {
        return variable.clone();
    }
    let data = match &variable.data {
        VariableValues::F64(values) => VariableValues::F64(vec![value; values.len()]),
        VariableValues::Complex(values) => {
            VariableValues::Complex(vec![Complex64::new(value, value); values.len()])
        }
        other => other.clone(),
    };
    Variable { data, ..variable.clone() }
}

fn of(dataset: &Dataset, change: impl Fn(&Variable) -> Variable) -> Dataset {
    let mut changed = Dataset::new();
    for (name, value) in dataset.attributes() {
        changed = changed.attribute(name, value.clone()).unwrap();
    }
    dataset.variables().iter().fold(changed, |changed, variable| changed.with(change(variable)).unwrap())
}

/// Everything that can be nearly nothing about an analysis.
fn bare(dataset: &Dataset) -> Vec<(String, Dataset)> {
    let dimensions: BTreeSet<&String> = dataset.variables().iter().flat_map(|own| &own.dimensions).collect();
    // every spectrum has four eigenvalues
    let is_spectrum = dataset.attributes()["kind"] == "spectrum";
    let lengths = dimensions.into_iter().filter(|dimension| !(is_spectrum && *dimension == "mode"));
    let cut = lengths.flat_map(|dimension| {
        [0, 1].map(|length| {
            (format!("{length} along {dimension}"), of(dataset, |own| shortened(own, dimension, length)))
        })
    });
    let filled = [f64::NAN, 0.0, 1.0, -1e-300]
        .map(|value| (format!("{value:e} throughout"), of(dataset, |own| filled(own, value))));
    cut.chain(filled).collect()
}

/// What fails of the figures of a study, and the models and kinds that were drawn.
fn failures(folder: &Path, kinds: &mut BTreeSet<(&'static str, String)>) -> Vec<String> {
    let store = StudyFolder::open(folder).unwrap();
    let summary = store.read_summary().unwrap().unwrap();
    let model = REGISTRY.model_of(&summary.case).unwrap();
    let mut failures = Vec::new();
    for name in summary.analyses.keys() {
        let dataset = store.read_dataset(name).unwrap();
        kinds.insert((model.name, dataset.attributes()["kind"].as_str().unwrap().to_owned()));
        for (what, dataset) in bare(&dataset) {
            let drawn = catch_unwind(AssertUnwindSafe(|| {
                // an array that cannot be so short is told as wrong
                let Ok(Some(figure)) = model.figure("f", "", &dataset) else { return Ok(()) };
                svg(&figure).and_then(|_| json(&figure)).map(|_| ()).map_err(|error| error.to_string())
            }));
            match drawn {
                Ok(Ok(())) => (),
                Ok(Err(error)) => failures.push(format!("{name}, {what}: {error}")),
                Err(_) => failures.push(format!("{name}, {what}: a panic")),
            }
        }
    }
    failures
}

const OSCILLATOR: &str = include_str!("../small/oscillator.toml");
const CONTACT: &str = include_str!("../small/contact.toml");
const BEAM: &str = include_str!("../small/beam.toml");

#[test]
fn no_figure_fails_on_results_that_are_nearly_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let mut kinds = BTreeSet::new();
    let mut found = Vec::new();
    for (name, text) in [("oscillator", OSCILLATOR), ("contact", CONTACT), ("beam", BEAM)] {
        let own = folder.path().join(name);
        std::fs::create_dir(&own).unwrap();
        let report = run_text(&own, text);
        assert!(report.refused.is_empty(), "{:?}", report.messages);
        found.extend(failures(&own.join("out"), &mut kinds));
    }
    for (name, file, only) in [
        ("locus", small("positions = { points = 5 }"), &[][..]),
        ("hopf", case("benchmarks/damped-hopf.toml", &[]), &[]),
    ] {
        let own = folder.path().join(name);
        run_into(&own, &file, only);
        found.extend(failures(&own, &mut kinds));
    }
    assert!(kinds.len() >= 17, "{kinds:?}");
    assert!(found.is_empty(), "{}", found.join("\n"));
}

/// A region without an eigenvalue is an answer: a figure, empty and captioned, and the report with it.
#[test]
fn an_empty_region_has_its_figure_and_its_report() {
    let folder = tempfile::tempdir().unwrap();
    let text = BEAM.replace("im = [0.0, 10000.0]", "im = [1.0, 2.0]");
    let path = folder.path().join("case.toml");
    std::fs::write(&path, text).unwrap();
    let report = run_into(&folder.path().join("out"), &judder_models::read(&path, &[]).unwrap(), &["eigen"]);
    assert_eq!(report.summary.results["eigen"]["eigenvalues"], serde_json::json!([]));
    let page = std::fs::read_to_string(report.report.unwrap()).unwrap();
    assert!(
        page.contains("All eigenvalues found in the region") && page.contains("the region has no eigenvalue")
    );
    assert!(folder.path().join("out/figures/eigen.svg").is_file());
}
