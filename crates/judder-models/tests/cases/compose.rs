//! Cases composed of a text, options and an analysis: they say by themselves what text and options say together.

use std::path::{Path, PathBuf};

use judder_keys::error::CaseError;
use judder_models::compose;
use judder_models::contact::case::ContactCase;
use judder_models::oscillator::case::OscillatorCase;
use judder_models::oscillator::contact_case::contact_case_of;
use judder_study::case::anywhere::anywhere;
use judder_study::case::compose::alone;
use judder_study::case::file::CaseFile;
use proptest::prelude::*;
use serde_json::{Value, json};

/// Options that some cases take and others refuse: plain values, units, tables, items of lists by name and by number, new sections.
const OPTIONS: &[&str] = &[
    "title=another title",
    "title=\"with \\\"quotes\\\" and # no comment\"",
    "operation.velocity=30 mm/s",
    "operation.velocity = 2e-3 ",
    "operation={ velocity = 1e-3, normal_load = \"0.1 N\" }",
    "operation.normal_load=1e-300",
    "operation.normal_load=99999999999999999999",
    "contact.shear_strength=0.02",
    "contact.law=hertz",
    "contact.law={ computed = true, accuracy = 1e-2 }",
    "contact.law.computed=true",
    "contact={ law = \"oscillator-paper-corrected\" }",
    "oscillator.coupling=0",
    "oscillator.natural_frequency=50 rad/s",
    "substrate.poisson_ratio=0.4",
    "substrate.glassy_modulus=5 MPa",
    "substrate.retardation_time=20 ms",
    "substrate.prony=[{ time = \"1 ms\", compliance = \"0.3 1/MPa\" }, { time = \"10 ms\", compliance = \"0.6 1/MPa\" }]",
    "substrate.prony.0.time=2 ms",
    "substrate.prony.1.time=2 ms",
    "substrate.prony.2.time=2 ms",
    "substrate.prony.+1.time=3 ms",
    "indenter.radius=12 mm",
    "indenter.shape=sphere",
    "analysis.0.x.points=9",
    "analysis.map.x.points=11",
    "analysis.map.x={ key = \"operation.velocity\", from = 1e-6, to = 1.0, points = 5, scale = \"log\" }",
    "analysis.map.name=renamed",
    "analysis.renamed.x.points=12",
    "analysis.map={ kind = \"stability-map\", x = { key = \"operation.velocity\", from = 1e-6, to = 1.0, points = 5 }, y = { key = \"contact.shear_strength\", from = 0.01, to = 1.0, points = 5 } }",
    "analysis.map=3",
    "analysis.critical.sweep.points=13",
    "analysis.spectrum.sweep.points=14",
    "analysis=[]",
    "analysis=[{ kind = \"spectrum\", sweep = { key = \"operation.velocity\", from = 1e-6, to = 1.0, points = 5 } }]",
    "sweep.0.chunk=4",
    "sweep.amplitude.over.operation.velocity.to=0.01",
    "sweep.amplitude.over.0.to=0.002",
    "sweep=[]",
    "parameters.c2=0.02",
    "parameters.new=1",
    "structure.disc.density=7000 kg/m^3",
    "structure.0.name=other",
    "motion.velocity=2 m/s",
    "memory_limit=1 GiB",
    "new.table.key=1",
    "a.b.c.d.e.f.g.h.i.j=1",
    "no value",
    "operation..velocity=1",
    "operation.velocity.deeper=1",
    "model=contact",
    "operation.velocity=1979-05-27",
    "operation.velocity=0x10",
    "operation.velocity=0xffffffffffffffffffff",
    "operation.velocity=1 # a comment",
    "operation.velocity=",
];

fn case_files() -> Vec<(PathBuf, String)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases");
    let folders = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let inside = |folder: PathBuf| std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let mut paths: Vec<PathBuf> = folders.filter(|path| path.is_dir()).flat_map(inside).collect();
    paths.retain(|path| path.extension().is_some_and(|extension| extension == "toml"));
    paths.sort();
    paths.into_iter().map(|path| (path.clone(), std::fs::read_to_string(path).unwrap())).collect()
}

fn strings(options: &[&str]) -> Vec<String> {
    options.iter().map(|option| (*option).to_owned()).collect()
}

/// What a case says, without its text.
fn said(file: &CaseFile) -> String {
    format!("{:?} {:?} {:?}", file.name, file.case, file.sweeps)
}

fn told(error: &CaseError) -> (String, String, String) {
    (error.to_string(), error.source_name().to_owned(), error.place().to_owned())
}

/// Whether text and options are accepted; composed they say the same, or are refused in the same words at the same place.
fn agree(path: &Path, text: &str, options: &[String]) -> bool {
    let name = path.to_str().unwrap();
    match (judder_models::parse(name, text, options), compose(name, text, options, None)) {
        (Ok(given), Ok(composed)) => {
            assert_eq!(said(&given), said(&composed), "{name} {options:?}:\n{}", composed.text);
            let read = judder_models::parse(name, &composed.text, &[]).unwrap();
            assert_eq!(said(&given), said(&read), "{name} {options:?}");
            true
        }
        (Err(given), Err(composed)) => {
            assert_eq!(told(&given), told(&composed), "{name} {options:?}");
            false
        }
        (given, composed) => panic!("{name} {options:?}: {given:?} {composed:?}"),
    }
}

#[test]
fn every_case_with_every_option_says_the_same_composed() {
    let (mut whole, mut taken) = (0, vec![0; OPTIONS.len()]);
    for (path, text) in case_files() {
        whole += usize::from(agree(&path, &text, &[]));
        for (option, taken) in OPTIONS.iter().zip(&mut taken) {
            *taken += usize::from(agree(&path, &text, &strings(&[option])));
        }
    }
    // the matrices of two cases are no part of the repository
    assert!(whole > 30, "{whole}");
    assert!(taken.iter().filter(|count| **count > 0).count() > 25, "{taken:?}");
}

#[test]
fn without_options_the_text_stays_as_it_is() {
    let mut kept = 0;
    for (path, text) in case_files() {
        if let Ok(composed) = compose(path.to_str().unwrap(), &text, &[], None) {
            assert_eq!(composed.text, text, "{}", path.display());
            kept += 1;
        }
    }
    assert!(kept > 30, "{kept}");
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, ..ProptestConfig::default() })]

    #[test]
    fn options_come_one_after_the_other(
        file in prop::sample::select(case_files()),
        options in prop::collection::vec(prop::sample::select(OPTIONS.to_vec()), 0..5),
    ) {
        agree(&file.0, &file.1, &strings(&options));
    }
}

/// Comments before, behind and between, and every way to write a table.
const COMMENTED: &str = r#"# head
title = "A"                # of the title
model = "oscillator"
operation.velocity = 1e-4  # dotted

# of the contact
[contact]
shear_strength = 0.01 # τ0/E0*
law = { computed = true, accuracy = 0.01 }

[substrate]
prony = [
    { time = "1 ms", compliance = "0.3 1/MPa" }, # the first
    { time = "10 ms", compliance = "0.6 1/MPa" },
]

# of the map
[[analysis]]
name = "map"
kind = "stability-map"
x = { key = "operation.velocity", from = 1e-8, to = 1e2, points = 40, scale = "log" }
y = { key = "contact.shear_strength", from = 1e-4, to = 1.0, points = 40, scale = "log" }
"#;

#[test]
fn comments_and_order_are_kept() {
    let options = [
        "operation.velocity=30 mm/s",
        "operation.normal_load=1e-6",
        "contact.shear_strength=0.02",
        "contact.law.accuracy=0.02",
        "substrate.prony.0.time=2 ms",
        "indenter.radius=12 mm",
        "analysis.map.x.points=50",
    ];
    let expected = COMMENTED
        .replace(
            "velocity = 1e-4  # dotted\n",
            "velocity = \"30 mm/s\"  # dotted\noperation.normal_load = 1e-6\n",
        )
        .replace("0.01 #", "0.02 #")
        .replace("accuracy = 0.01", "accuracy = 0.02")
        .replace("\"1 ms\"", "\"2 ms\"")
        .replace("1e2, points = 40", "1e2, points = 50");
    let composed = compose("case.toml", COMMENTED, &strings(&options), None).unwrap();
    assert_eq!(composed.text, format!("{expected}\n[indenter]\nradius = \"12 mm\"\n"));
}

fn spectrum(points: Value) -> serde_json::Map<String, Value> {
    let sweep = json!({ "key": "operation.velocity", "from": 1e-8, "to": 1e2, "points": points, "scale": "log", "unit": null });
    let table = json!({ "name": "view", "kind": "spectrum", "sweep": sweep, "family": null });
    table.as_object().unwrap().clone()
}

#[test]
fn one_analysis_takes_the_place_of_all() {
    let set = strings(&["analysis.map.x.points=50", "contact.shear_strength=0.02"]);
    let text = format!(
        "{COMMENTED}\n[[sweep]]\nname = \"s\"\nover = [{{ key = \"operation.velocity\", from = 1e-3, to = 1e-2, points = 3 }}]\nquantities = [\"growth_rate\"]\n"
    );
    let composed = compose("case.toml", &text, &set, Some(&spectrum(json!(7)))).unwrap();
    let end = "\n[[analysis]]\nname = \"view\"\nkind = \"spectrum\"\nsweep = { key = \"operation.velocity\", from = 1e-8, to = 100.0, points = 7, scale = \"log\" }\n";
    assert!(composed.text.ends_with(end), "{}", composed.text);
    assert!(composed.sweeps.is_empty() && composed.overrides.is_empty());
    let case = composed.case.of::<OscillatorCase>().unwrap().clone();
    let names: Vec<_> = case.analyses.iter().map(|analysis| analysis.name.as_str()).collect();
    assert_eq!(names, ["view"]);
}

#[test]
fn what_is_replaced_cannot_be_wrong() {
    let text = COMMENTED.replace("points = 40", "points = -1");
    assert!(compose("case.toml", &text, &[], None).is_err());
    compose("case.toml", &text, &[], Some(&spectrum(json!(7)))).unwrap();
}

#[test]
fn errors_point_to_what_was_given() {
    let refused = strings(&["contact.shear_strength=-1"]);
    let error = compose("case.toml", COMMENTED, &refused, Some(&spectrum(json!(7)))).unwrap_err();
    assert_eq!((error.source_name(), error.place()), ("--set", "-1"));
    let error = compose("case.toml", COMMENTED, &[], Some(&spectrum(json!(-7)))).unwrap_err();
    assert_eq!((error.source_name(), error.place()), ("case.toml", "-7"));
}

#[test]
fn the_contact_of_an_oscillator_case_is_a_contact_case() {
    let set = strings(&["substrate.prony.0.time=2 ms", "indenter.radius=12 mm"]);
    let contact = contact_case_of("case.toml", COMMENTED, &set).unwrap();
    let case = contact.case.of::<ContactCase>().unwrap();
    assert_eq!(case.title, "A: its contact");
    let oscillator = judder_models::parse("case.toml", COMMENTED, &set)
        .unwrap()
        .case
        .of::<OscillatorCase>()
        .unwrap()
        .clone();
    assert_eq!(case.substrate, oscillator.substrate);
    assert_eq!(case.inputs.number(judder_models::oscillator::keys::OscillatorKey::Radius), 0.012);
    assert!(contact.text.contains("# the first") && !contact.text.contains("shear_strength"));
    let modulus = json!({ "name": "modulus", "kind": "modulus" });
    let composed = compose("case.toml", &contact.text, &[], modulus.as_object()).unwrap();
    assert_eq!(composed.case.analysis_names(), ["modulus"]);
    let error = contact_case_of("case.toml", &contact.text, &[]).unwrap_err();
    assert_eq!(error.to_string(), "unknown model `contact`");
}

/// The items of a list of the resolved case, by name.
fn named(case: &Value, list: &str) -> Vec<(String, Value)> {
    let items = case[list].as_array().map_or(&[][..], Vec::as_slice);
    items.iter().map(|item| (item["name"].as_str().unwrap().to_owned(), item.clone())).collect()
}

#[test]
fn an_analysis_alone_is_the_one_of_the_case() {
    let mut compared = 0;
    for (path, text) in case_files() {
        let Ok(whole) = judder_models::parse(path.to_str().unwrap(), &text, &[]) else { continue };
        let resolved = whole.resolved();
        let (analyses, sweeps) = (named(&resolved, "analysis"), named(&resolved, "sweep"));
        assert_eq!(analyses.len(), whole.case.analysis_names().len(), "{}", path.display());
        for (name, given) in &analyses {
            let one = alone(&whole, name).unwrap().resolved();
            let kept = named(&one, "analysis");
            assert_eq!(kept.last(), Some(&(name.clone(), given.clone())), "{}", path.display());
            // what it takes up stands before it, and is as it was
            let taken = &kept[..kept.len() - 1];
            let texts =
                |key: &str| given[key].as_str().is_some_and(|of| taken.iter().any(|(name, _)| name == of));
            let takes = ["of", "locus"].into_iter().filter(|key| texts(key)).count();
            assert_eq!(taken.len(), takes, "{} {name}", path.display());
            assert!(taken.iter().all(|other| analyses.contains(other)), "{} {name}", path.display());
            assert!(named(&one, "sweep").is_empty());
            compared += 1;
        }
        for (name, given) in &sweeps {
            let one = alone(&whole, name).unwrap().resolved();
            assert_eq!(named(&one, "sweep"), [(name.clone(), given.clone())], "{}", path.display());
            // every analysis that it names, and no other
            let kept = named(&one, "analysis");
            assert!(kept.iter().all(|one| analyses.contains(one)), "{} {name}", path.display());
            let quantities = given["quantities"].to_string();
            let mentioned = |name: &str| quantities.contains(&format!("\"{name}."));
            let expected = analyses.iter().filter(|(name, _)| mentioned(name)).count();
            assert_eq!(kept.len(), expected, "{} {name}", path.display());
            compared += 1;
        }
    }
    assert!(compared > 60, "{compared}");
}

#[test]
fn a_spectrogram_alone_has_its_march_and_its_locus() {
    let paths = case_files();
    let (path, text) = paths.iter().find(|(path, _)| path.ends_with("sliding/curved-edge.toml")).unwrap();
    let set = strings(&["contact.shear_strength=1"]);
    assert!(judder_models::parse(path.to_str().unwrap(), text, &set).is_err());
    let whole =
        judder_models::parse(path.to_str().unwrap(), text, &strings(&["motion.velocity=1.5 m/s"])).unwrap();
    let names = |name: &str| alone(&whole, name).unwrap().case.analysis_names().join(" ");
    assert_eq!(names("spectrogram"), "locus ensubs spectrogram");
    assert_eq!((names("locus"), names("ensubs")), ("locus".to_owned(), "ensubs".to_owned()));
    let locus = alone(&whole, "locus").unwrap();
    assert!(locus.overrides.is_empty() && locus.text.contains("velocity = \"1.5 m/s\""), "{}", locus.text);
}

#[test]
fn analyses_of_one_line_are_kept_and_dropped_too() {
    let text = "model = \"oscillator\"\nanalysis = [{ kind = \"spectrum\", sweep = { key = \"operation.velocity\", from = 1e-6, to = 1.0, points = 5 } }, { name = \"from\", kind = \"motion\" }]\n";
    let whole = judder_models::parse("case.toml", text, &[]).unwrap();
    assert_eq!(alone(&whole, "from").unwrap().case.analysis_names(), ["from"]);
    assert_eq!(alone(&whole, "spectrum").unwrap().case.analysis_names(), ["spectrum"]);
    let error = alone(&whole, "spectrun").unwrap_err();
    assert_eq!(error.to_string(), "unknown analysis or sweep `spectrun`");
    assert_eq!(error.cause().help().unwrap(), "did you mean `spectrum`? known: spectrum, from");
}

/// Matrices in a folder, one of them named as a file beside the case is.
const OF_MATRICES: &str = r#"title = "K.mtx"
model = "structure"
matrices = { folder = "arm", mass = [{ file = "M.mtx" }], stiffness = [{ file = "K.mtx" }] } # measured
"#;

const OF_MODULI: &str = r#"title = "moduli.csv"
model = "contact"
substrate = { dma = { file = "moduli.csv" } } # of the file
"#;

#[test]
fn a_case_reads_the_same_files_anywhere() {
    let (home, elsewhere) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
    std::fs::create_dir(home.path().join("arm")).unwrap();
    for name in ["arm/M.mtx", "arm/K.mtx", "K.mtx", "moduli.csv"] {
        std::fs::write(home.path().join(name), "").unwrap();
    }
    let paths = |file: &CaseFile| {
        let whole = |file: &&judder_keys::file_reference::FileReference| file.path.canonicalize().unwrap();
        file.case.files().iter().map(whole).collect::<Vec<_>>()
    };
    let named = |folder: &tempfile::TempDir| folder.path().join("case.toml").to_str().unwrap().to_owned();
    let folder = format!("matrices.folder={}", home.path().join("arm").display());
    for (text, set, count) in [
        (OF_MATRICES, vec![], 2),
        (OF_MATRICES, vec![folder], 2),
        (OF_MODULI, vec!["indenter.radius=2 mm".to_owned()], 1),
    ] {
        let case = judder_models::parse(&named(&home), text, &set).unwrap();
        let free = anywhere(&case).unwrap();
        assert!(judder_models::parse(&named(&elsewhere), text, &[]).is_err());
        let moved = judder_models::parse(&named(&elsewhere), &free.text, &[]).unwrap();
        assert_eq!((paths(&moved), paths(&moved).len()), (paths(&case), count));
        assert_eq!(moved.text.lines().next(), text.lines().next());
        assert!(moved.text.contains("} # ") && !moved.text.contains("/./"), "{}", moved.text);
    }
    let plain = judder_models::parse("case.toml", COMMENTED, &[]).unwrap();
    assert_eq!(anywhere(&plain).unwrap().text, COMMENTED);
}
