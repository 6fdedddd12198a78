//! The doors that read a file, and their samples.

use std::fs;
use std::path::{Path, PathBuf};

use judder_contact::law::PerQuantity;
use judder_contact::law::file::{from_json, to_json};
use judder_contact::law::sampled::{SampleRequest, sampled};
use judder_contact::{ContactLaw, FittedLaw, Law, LawError, LawPoint};
use judder_exchange::dma_table::read_dma_table;
use judder_exchange::freedom_table::read_freedoms;
use judder_exchange::heights::read_heights;
use judder_exchange::matrix::read_stored_matrix;
use judder_exchange::mesh_file::read_mesh;
use judder_exchange::number_table::read_number_table;
use judder_study::Silent;
use judder_study::resolve::resolve;

use crate::{Door, Reading, Sample};

/// The root of the project.
pub(crate) fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// The files below a folder of the project with one of these extensions, those of more than 200 kB left out.
fn samples(folder: &str, extensions: &[&str]) -> Vec<Sample> {
    let (mut found, mut folders) = (Vec::new(), vec![root().join(folder)]);
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|end| extensions.iter().any(|own| end == *own)) {
                let content = fs::read(&path).unwrap();
                found.push((path, content));
            }
        }
    }
    found.retain(|(_, content)| content.len() < 200_000);
    found.sort();
    found
}

fn case_files() -> Vec<Sample> {
    let mut cases = samples("cases", &["toml"]);
    cases.extend(small_cases());
    cases
}

/// Cases that are made ready in a moment.
fn small_cases() -> Vec<Sample> {
    samples("crates/judder-models/tests/small", &["toml"])
}

/// A law of values, as its file.
fn laws() -> Vec<Sample> {
    let exact = FittedLaw::oscillator_paper();
    let source = "the paper".to_owned();
    let request = SampleRequest { source, velocity: (1e-3, 1.0), indentation: (1e-3, 1e-1), tolerance: 0.5 };
    let law = sampled(&request, |velocities, indentations| -> Result<_, LawError> {
        let points = velocities.iter().zip(indentations).map(|(v, y)| exact.evaluate(&LawPoint::new(*v, *y)));
        let points: Vec<_> = points.collect();
        Ok(PerQuantity {
            force: points.iter().map(|point| point.force.value).collect(),
            area: points.iter().map(|point| point.area.value).collect(),
            friction: points.iter().map(|point| point.friction.value).collect(),
        })
    });
    let text = to_json(&Law::Sampled(law.unwrap().law.into())).unwrap().unwrap();
    vec![(PathBuf::from("law.json"), text.into_bytes())]
}

fn freedoms() -> Vec<Sample> {
    let text = "row,node,direction,x,y,z\n1,4,x,0.5,-1e-3,0\n2,4,y,0.5,-1e-3,0\n3,9,z,1.5,2,3\n";
    vec![(PathBuf::from("freedoms.csv"), text.into())]
}

fn text(content: &[u8]) -> std::borrow::Cow<'_, str> {
    String::from_utf8_lossy(content)
}

/// All doors that read a file.
pub(crate) fn doors() -> Vec<Door> {
    let silent = |name, samples, reading| Door { name, samples, tells: false, reading };
    let parse: Reading = Box::new(|_, content| {
        let read = judder_models::parse("case.toml", &text(content), &[]);
        read.map_or(Ok(()), |file| judder_study::run::resolved_with_files(&file).map_or(Ok(()), |_| Ok(())))
    });
    let check: Reading = Box::new(|_, content| {
        if let Ok(file) = judder_models::parse("case.toml", &text(content), &[]) {
            drop(resolve(&file, &Silent));
        }
        Ok(())
    });
    let refused = |path: &Path, own: Option<&Path>| match own {
        Some(own) if own == path => Ok(()),
        own => Err(format!("the error is of {own:?}")),
    };
    vec![
        silent("case files", case_files(), parse),
        Door { name: "checks", samples: small_cases(), tells: true, reading: check },
        silent("laws", laws(), Box::new(|_, content| from_json(&text(content)).map_or(Ok(()), |_| Ok(())))),
        silent(
            "meshes",
            samples("crates/judder-exchange/tests/validation/meshes", &["msh", "inp"]),
            Box::new(move |path, _| match read_mesh(path) {
                Ok(read) => read.mesh.check().map_err(|error| error.to_string()),
                Err(error) => refused(path, error.path()),
            }),
        ),
        silent(
            "matrices",
            samples("crates/judder-exchange/tests/validation/matrices", &["mtx", "mat", "npz"]),
            Box::new(move |path, _| {
                read_stored_matrix(path).map_or_else(|error| refused(path, error.path()), |_| Ok(()))
            }),
        ),
        silent(
            "heights",
            samples("crates/judder-exchange/tests/validation/height_maps", &["npy", "nc"]),
            Box::new(|path, content| read_heights(path, content.to_vec(), None).map_or(Ok(()), |_| Ok(()))),
        ),
        silent(
            "tables",
            samples("cases", &["csv"]).into_iter().chain(freedoms()).collect(),
            Box::new(|path, content| {
                drop(read_number_table::<2>(&text(content), "x [m],y [N]"));
                drop(read_dma_table(&text(content)));
                drop(read_freedoms(path));
                Ok(())
            }),
        ),
    ]
}
