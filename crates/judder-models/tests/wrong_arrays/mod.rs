//! Stored arrays in whose place others stand, valid ones of another type, length or dimension: told by their names, or not read, and never a panic.

use crate::march::contents;
use crate::sliding::small;
use crate::{case, run_into};
use judder_models::REGISTRY;
use judder_store::{Dataset, StoreError, StudyFolder, Variable, VariableValues, content_hash};
use judder_study::WrongArray;
use judder_study::report::{stored, write};
use serde_json::{Map, Value, json};
use std::collections::BTreeMap;
use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;

/// The dimension of what stands in the place of an array.
const ANOTHER: &str = "another";

/// The same numbers as values of another type.
fn of_another_type(variable: &Variable) -> Variable {
    let data = match &variable.data {
        VariableValues::F64(values) => VariableValues::I64(vec![1; values.len()]),
        VariableValues::Complex(values) => VariableValues::F64(values.iter().map(|own| own.re).collect()),
        VariableValues::I64(values) => VariableValues::F64(values.iter().map(|own| *own as f64).collect()),
        VariableValues::U8(values) => VariableValues::I64(values.iter().map(|own| i64::from(*own)).collect()),
        VariableValues::Text(values) => VariableValues::U8(vec![0; values.len()]),
    };
    Variable { data, ..variable.clone() }
}

/// As many of its values as are asked for, from the start on again where there are fewer.
fn with_values(variable: &Variable, count: usize) -> VariableValues {
    fn some<T: Clone>(values: &[T], count: usize) -> Vec<T> {
        values.iter().cycle().take(if values.is_empty() { 0 } else { count }).cloned().collect()
    }
    match &variable.data {
        VariableValues::F64(values) => VariableValues::F64(some(values, count)),
        VariableValues::Complex(values) => VariableValues::Complex(some(values, count)),
        VariableValues::I64(values) => VariableValues::I64(some(values, count)),
        VariableValues::U8(values) => VariableValues::U8(some(values, count)),
        VariableValues::Text(values) => VariableValues::Text(some(values, count)),
    }
}

/// One over other dimensions, with so many values.
fn over(variable: &Variable, dimensions: &[&str], shape: &[usize]) -> Variable {
    let data = with_values(variable, shape.iter().product());
    let shape: Vec<usize> = if data.is_empty() { shape.iter().map(|_| 0).collect() } else { shape.to_vec() };
    let dimensions = dimensions.iter().map(|&own| own.to_owned()).collect();
    Variable { dimensions, shape, data, ..variable.clone() }
}

/// What may stand in the place of an array of a dataset. Of a dimension that it has alone any length is right.
fn wrong(dataset: &Dataset, variable: &Variable) -> Vec<(&'static str, Variable)> {
    let count = variable.data.len();
    let own: Vec<&str> = variable.dimensions.iter().map(String::as_str).collect();
    let more = over(variable, &[&own[..], &[ANOTHER]].concat(), &[&variable.shape[..], &[2]].concat());
    let mut all = vec![("another type", of_another_type(variable)), ("one more dimension", more)];
    if !own.is_empty() {
        all.push(("another dimension", over(variable, &[ANOTHER], &[count + 3])));
        all.push(("no dimension", over(variable, &[], &[])));
        all.push(("one shorter", over(variable, &own[..1], &[variable.shape[0].saturating_sub(1)])));
    }
    let others = dataset.variables().iter().filter(|other| other.name != variable.name);
    let is_shared = own
        .first()
        .is_some_and(|first| others.clone().any(|other| other.dimensions.iter().any(|own| own == first)));
    all.retain(|(what, _)| is_shared || *what != "one shorter");
    all.retain(|(_, wrong)| wrong != variable && wrong.data.len() == wrong.shape.iter().product::<usize>());
    all
}

/// A dataset with another array in the place of one.
fn with(dataset: &Dataset, wrong: &Variable) -> Result<Dataset, StoreError> {
    let mut changed = Dataset::new();
    for (name, value) in dataset.attributes() {
        changed = changed.attribute(name, value.clone())?;
    }
    // that which is wrong joins last: what does not fit is its own
    let others = dataset.variables().iter().filter(|own| own.name != wrong.name);
    others.chain([wrong]).try_fold(changed, |changed, own| changed.with(own.clone()))
}

/// What is believed of the arrays of a study that is not so, or panics; how many were tried, and how many of those told.
fn failures(folder: &Path) -> (Vec<String>, usize, usize) {
    let store = StudyFolder::open(folder).unwrap();
    let summary = store.read_summary().unwrap().unwrap();
    let model = REGISTRY.model_of(&summary.case).unwrap();
    let (mut failures, mut tried, mut told) = (Vec::new(), 0, 0);
    for name in summary.analyses.keys() {
        let dataset = store.read_dataset(name).unwrap();
        let whole = format!("{:?}", model.figure("f", "", &dataset).unwrap());
        for variable in dataset.variables() {
            for (what, wrong) in wrong(&dataset, variable) {
                tried += 1;
                let place = format!("{name}, {} as one of {what}", variable.name);
                let drawn = catch_unwind(AssertUnwindSafe(|| {
                    with(&dataset, &wrong).map(|dataset| model.figure("f", "", &dataset))
                }));
                match drawn {
                    Err(_) => failures.push(format!("{place}: a panic")),
                    Ok(Err(refused)) if refused.to_string().contains(&variable.name) => told += 1,
                    Ok(Err(refused)) => failures.push(format!("{place}: {refused}")),
                    Ok(Ok(Err(WrongArray { array, .. }))) if array == variable.name => told += 1,
                    Ok(Ok(Err(other))) => failures.push(format!("{place}: {other}")),
                    // of what no figure reads, the figure is as it was
                    Ok(Ok(Ok(figure))) if format!("{figure:?}") == whole => {}
                    Ok(Ok(Ok(_))) => failures.push(format!("{place}: drawn")),
                }
            }
        }
    }
    (failures, tried, told)
}

/// Where the small cases of every kind lie.
const SMALL: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/small");

fn all_told(names: &[&str], studies: &[&Path]) {
    let folder = tempfile::tempdir().unwrap();
    let mut found = Vec::new();
    let (mut tried, mut told) = (0, 0);
    let mut look = |study: &Path| {
        let (own, own_tried, own_told) = failures(study);
        found.extend(own);
        tried += own_tried;
        told += own_told;
    };
    for name in names {
        let own = folder.path().join(name);
        let file = judder_models::read(Path::new(SMALL).join(format!("{name}.toml")), &[]).unwrap();
        run_into(&own, &file, &[]);
        look(&own);
    }
    studies.iter().for_each(|study| look(study));
    assert!(found.is_empty(), "{} of {tried}:\n{}", found.len(), found.join("\n"));
    assert!(told > tried / 3, "{told} of {tried} were told");
}

#[test]
fn no_figure_is_drawn_of_arrays_that_are_others() {
    let folder = tempfile::tempdir().unwrap();
    let locus = folder.path().join("locus");
    run_into(&locus, &small("positions = { points = 5 }"), &[]);
    all_told(&["beam", "two-degrees", "assembly-response", "assembly-sphere"], &[&locus]);
}

/// The other small cases, so that there is one of every kind.
#[test]
#[ignore = "expensive: some seconds for each of the larger small cases"]
fn no_figure_of_any_kind_is_drawn_of_arrays_that_are_others() {
    let names = [
        "assembly",
        "assembly-cycle",
        "belt",
        "contact",
        "contact-law",
        "contact-layer",
        "contact-line",
        "contact-rough",
        "contact-sphere",
        "matrices",
        "oscillator",
        "oscillator-computed",
        "oscillator-dimensional",
        "oscillator-engines",
        "sliding",
    ];
    all_told(&names, &[]);
}

/// Puts another array in the place of one on the disk, with the metadata of its group, and makes the list of the study anew.
fn replace(study: &Path, analysis: &str, wrong: &Variable) {
    let beside = tempfile::tempdir().unwrap();
    // under a name that is that of no dimension
    let alone = Variable { name: "alone".to_owned(), is_coordinate: false, ..wrong.clone() };
    let alone = Dataset::new().with(alone).unwrap();
    StudyFolder::create(beside.path()).unwrap().write_dataset("one", "h", &alone).unwrap();
    let group = study.join("results.zarr").join(analysis);
    let (from, to) = (beside.path().join("results.zarr/one/alone"), group.join(&wrong.name));
    fs::remove_dir_all(&to).unwrap();
    copied(&from, &to);
    let read = |path: &Path| serde_json::from_slice::<Value>(&fs::read(path).unwrap()).unwrap();
    let mut metadata = read(&group.join("zarr.json"));
    metadata["consolidated_metadata"]["metadata"][&wrong.name] = read(&to.join("zarr.json"));
    fs::write(group.join("zarr.json"), metadata.to_string()).unwrap();
    list_anew(study, analysis);
    StudyFolder::open(study).unwrap().consolidate().unwrap();
}

/// Makes the list of a study believe what lies in the folder of an analysis.
fn list_anew(study: &Path, analysis: &str) {
    let path = study.join("manifest.json");
    let mut manifest: Map<String, Value> = serde_json::from_slice(&fs::read(&path).unwrap()).unwrap();
    let below = format!("results.zarr/{analysis}/");
    let files: BTreeMap<String, Value> = serde_json::from_value(manifest["files"].clone()).unwrap();
    let others = files.into_iter().filter(|(path, _)| !path.starts_with(&below));
    let own =
        contents(study).into_iter().filter(|(path, _)| path.starts_with(&below)).map(|(path, content)| {
            let record = json!({ "bytes": content.len(), "hash": content_hash(&content), "of": analysis });
            (path.to_str().unwrap().to_owned(), record)
        });
    let files: BTreeMap<String, Value> = others.chain(own).collect();
    manifest.insert("files".to_owned(), json!(files));
    manifest.shift_remove("hash");
    let hash = content_hash(&serde_json::to_vec(&manifest).unwrap());
    manifest.shift_insert(0, "hash".to_owned(), json!(hash));
    fs::write(&path, serde_json::to_string_pretty(&manifest).unwrap() + "\n").unwrap();
}

fn copied(from: &Path, to: &Path) {
    fs::create_dir_all(to).unwrap();
    for entry in fs::read_dir(from).unwrap() {
        let entry = entry.unwrap();
        let target = to.join(entry.file_name());
        if entry.file_type().unwrap().is_dir() {
            copied(&entry.path(), &target);
        } else {
            fs::copy(entry.path(), target).unwrap();
        }
    }
}

/// What a report says in the place of the figure names study, analysis and array, whether the store or the figure refuses them.
#[test]
fn a_report_names_the_study_the_analysis_and_the_array() {
    let folder = tempfile::tempdir().unwrap();
    let whole = folder.path().join("whole");
    let file = case("benchmarks/damped-hopf.toml", &[]);
    run_into(&whole, &file, &["spectrum"]);
    let dataset = StudyFolder::open(&whole).unwrap().read_dataset("spectrum").unwrap();
    // with a list made anew, and untouched otherwise, it is as it was
    let drawn = |study: &Path| {
        let (store, summary) = stored(study).unwrap();
        write(REGISTRY, &store, &summary).unwrap().lacking()
    };
    assert!(drawn(&whole).is_empty());
    for (k, (what, wrong)) in dataset.variables().iter().flat_map(|own| wrong(&dataset, own)).enumerate() {
        let study = folder.path().join(k.to_string());
        copied(&whole, &study);
        replace(&study, "spectrum", &wrong);
        let lacking = drawn(&study);
        let told = lacking.first().map_or("", String::as_str);
        let place = study.display().to_string();
        let is_told = ["spectrum", &wrong.name, &place].iter().all(|own| told.contains(own));
        assert!(is_told, "{} as one of {what}: {lacking:?}", wrong.name);
    }
}
