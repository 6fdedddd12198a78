//! Stored studies: one file of a finished study is another.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use judder_models::REGISTRY;
use judder_store::{StudyFolder, StudyReader, verify};
use judder_study::Silent;
use judder_study::run::{RunOptions, run};
use serde_json::{Value, json};
use tempfile::TempDir;

use crate::{Door, Sample};

const CASE: &str = r#"
model = "two-degrees"
[parameters]
mu = 0.5
c = 0.1
[matrices]
damping = [["c", 0], [0, 0.1]]
stiffness = [[2, "1 - 4*mu/3"], [1, 2]]
[[analysis]]
kind = "spectrum"
sweep = { key = "parameters.mu", from = 0.0, to = 1.5, points = 7 }
[[analysis]]
kind = "stability-map"
x = { key = "parameters.mu", from = 0.0, to = 1.5, points = 8 }
y = { key = "parameters.c", from = 0.0, to = 0.2, points = 6 }
[[sweep]]
name = "friction"
over = [{ key = "parameters.mu", values = [0.1, 0.5, 1.0] }]
quantities = ["growth_rate"]
chunk = 2
"#;

/// A finished study, whole again after every input. A sample is one of its files, whose path has `,` for `/`.
struct Stored {
    folder: TempDir,
    /// Where nothing is drawn, and the study stays as it is.
    page: TempDir,
    files: Vec<Sample>,
}

impl Stored {
    fn new() -> Self {
        let folder = TempDir::new().unwrap();
        let file = judder_models::parse("case.toml", CASE, &[]).unwrap();
        let options = RunOptions { without_report: true, ..RunOptions::default() };
        assert!(run(&file, folder.path(), &options, &Silent).unwrap().complete);
        let mut files = Vec::new();
        let mut folders = vec![folder.path().to_owned()];
        while let Some(own) = folders.pop() {
            for entry in fs::read_dir(own).unwrap() {
                let path = entry.unwrap().path();
                if path.is_dir() {
                    folders.push(path);
                } else if !path.ends_with(".judder.lock") {
                    let content = fs::read(&path).unwrap();
                    files.push((path.strip_prefix(folder.path()).unwrap().to_owned(), content));
                }
            }
        }
        files.sort();
        Self { folder, page: TempDir::new().unwrap(), files }
    }

    /// Reads the study in which the file of this name is another, with its list and without.
    fn read(&self, name: &str, content: &[u8]) -> Result<(), String> {
        let path = PathBuf::from(name.replace(',', "/"));
        let study = self.folder.path();
        let put = |path: &Path, content: &[u8]| {
            fs::write(study.join(path), content).map_err(|error| format!("{}: {error}", path.display()))
        };
        put(&path, content)?;
        let list = Path::new("manifest.json");
        for listed in [true, false] {
            if !listed {
                fs::remove_file(study.join(list)).map_err(|error| error.to_string())?;
            }
            read_all(study, &self.page.path().join("page"));
        }
        let whole = |(own, _): &&Sample| own == &path || own == list;
        self.files.iter().filter(whole).try_for_each(|(own, content)| put(own, content))
    }
}

/// All that readers give of a study, and its figures.
fn read_all(study: &Path, page: &Path) {
    drop(verify(study, |_, _| true));
    let mut names =
        BTreeSet::from(["spectrum".to_owned(), "stability-map".to_owned(), "friction".to_owned()]);
    if let Ok(reader) = StudyReader::open(study) {
        drop(reader.read_summary());
        names.extend(reader.names().unwrap_or_default());
        for name in &names {
            for variable in reader.head(name).iter().flat_map(|head| &head.variables) {
                drop(reader.read_rows(name, &variable.name, 0..usize::MAX));
            }
        }
    }
    let Ok(folder) = StudyFolder::drawn_into(study, page) else { return };
    let model = REGISTRY.model_of(&json!({ "model": "two-degrees" })).unwrap();
    for name in &names {
        if let Ok(dataset) = folder.read_dataset(name) {
            let kind = dataset.attributes().get("kind").and_then(Value::as_str).unwrap_or(name);
            drop(model.figure(name, kind, &dataset));
        }
        drop(folder.read_points(name, |_| Vec::new()));
    }
}

/// The door of stored studies; a sample is a file of one.
pub(crate) fn door() -> Door {
    let stored = Stored::new();
    let flat = |path: &Path| PathBuf::from(path.to_string_lossy().replace('/', ","));
    let samples = stored.files.iter().map(|(path, content)| (flat(path), content.clone())).collect();
    let reading = move |path: &Path, content: &[u8]| {
        stored.read(&path.file_name().unwrap_or_default().to_string_lossy(), content)
    };
    Door { name: "studies", samples, tells: true, reading: Box::new(reading) }
}
