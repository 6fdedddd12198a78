//! Structure cases that are read.

use super::parse;
use judder_models::structure::case::body::{BodyGeometry, EndCondition};
use judder_models::structure::case::damping::Damping;
use judder_models::structure::case::damping::Rayleigh;
use judder_models::structure::case::reduction::{FixedModes, KeptNodes};
use judder_models::structure::case::{Matrices, StructureCase, StructureSource};
use judder_models::structure::eigen_sweep::settings::EigenSweep;
use judder_models::structure::modes::ModesAnalysis;
use judder_structure::eigen_sweep::SweepMethod;
use judder_structure::element::ElementKind;
use judder_study::model::Case;
use std::f64::consts::TAU;

fn structure(text: &str) -> StructureCase {
    parse(text, &[]).unwrap().of::<StructureCase>().expect("its model").clone()
}

const BEAM: &str = r#"
model = "structure"
[structure]
beam = { length = "75 mm", thickness = "1.5 mm", elements = [75, 2], angle = "30 deg", origin = ["1 mm", "-2 mm"], start = "guided" }
width = "10 mm"
material = { youngs_modulus = "71 GPa", poisson_ratio = 0.33, density = "2770 kg/m^3" }
supports = [{ set = "end", fixed = ["x"], tied = ["y"] }]
[damping]
rayleigh = { ratios = [{ frequency = "5 kHz", ratio = 0.02 }, { frequency = "100 Hz", ratio = 0.01 }] }
[reduction]
kept = [{ set = "end", directions = ["y"] }]
cut_off = "20 kHz"
[[analysis]]
kind = "modes"
band = ["0 Hz", "10 kHz"]
[[analysis]]
kind = "reduction"
"#;

#[test]
fn a_beam_has_its_numbers_in_si_units() {
    let case = structure(BEAM);
    let StructureSource::Body(body) = &case.source else { panic!("a body") };
    let BodyGeometry::Beam(beam) = &body.geometry else { panic!("a beam") };
    assert_eq!((beam.length, beam.thickness, beam.elements), (0.075, 0.0015, [75, 2]));
    assert_eq!(
        (beam.origin, beam.start, beam.end),
        ([1e-3, -2e-3], EndCondition::Guided, EndCondition::Free)
    );
    assert!((beam.angle - TAU / 12.0).abs() < 1e-15);
    assert_eq!(body.supports[0].tied, [false, true, false]);
    let reduction = case.reduction.unwrap();
    assert_eq!(reduction.kept[0].nodes, KeptNodes::Set("end".to_owned()));
    assert_eq!(reduction.modes, FixedModes::CutOff(TAU * 20e3));
    let band = ModesAnalysis::Band([0.0, TAU * 10e3]);
    let modes: &ModesAnalysis = case.analyses[0].settings().unwrap();
    assert_eq!(*modes, band);
}

/// ζ = α/(2ω) + βω/2 gives the two ratios back.
#[test]
fn two_ratios_become_alpha_and_beta() {
    let Damping::Rayleigh(Rayleigh { alpha, beta, .. }) = structure(BEAM).damping else { panic!("Rayleigh") };
    for (frequency, ratio) in [(TAU * 100.0, 0.01), (TAU * 5e3, 0.02)] {
        let found = alpha / (2.0 * frequency) + beta * frequency / 2.0;
        assert!((found - ratio).abs() < 1e-15, "{found}");
    }
}

#[test]
fn a_block_is_of_quadratic_elements_where_nothing_is_said() {
    for (size, cells, element) in [
        (r#"["1 m", "2 m"]"#, "[3, 4]", ElementKind::Quad8),
        (r#"["1 m", "2 m", "3 m"]"#, "[3, 4, 5]", ElementKind::Hexahedron20),
    ] {
        let case = structure(&format!(
            "model = \"structure\"\n[structure]\nblock = {{ size = {size}, cells = {cells} }}\n\
             material = {{ youngs_modulus = \"1 Pa\", poisson_ratio = 0, density = \"1 kg/m^3\" }}\n"
        ));
        let StructureSource::Body(body) = &case.source else { panic!("a body") };
        let BodyGeometry::Block(block) = &body.geometry else { panic!("a block") };
        assert_eq!(block.element(), element);
    }
}

/// A folder with files of these names, and a case that names them.
pub(crate) fn with_files(
    files: &[&str],
    text: &str,
    overrides: &[&str],
) -> Result<Case, judder_keys::error::CaseError> {
    let folder = tempfile::tempdir().unwrap();
    for file in files {
        let path = folder.path().join(file);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, "").unwrap();
    }
    let path = folder.path().join("case.toml");
    std::fs::write(&path, text).unwrap();
    let place = folder.path().display().to_string();
    let overrides: Vec<String> = overrides.iter().map(|option| option.replace("HERE", &place)).collect();
    judder_models::read(&path, &overrides).map(|file| file.case)
}

/// The form of the finite-element disc brake's case.
pub(crate) const MATRICES: &str = r#"
model = "structure"
[parameters]
speed = 2
[matrices]
folder = "brake"
mass      = [{ file = "M.mat" }]
damping   = [{ file = "D.mat" }, { file = "G.npz", factor = "speed" }, { file = "R.mtx", factor = "1/speed - 1" }]
stiffness = [{ file = "K.mat", triangle = "lower" }, { file = "W.mat", factor = "speed^2 - 1" }]
[[analysis]]
name = "squeal"
kind = "eigen"
region = { re = [-50.0, 1000.0], im = [0.0, 20000.0] }
[[analysis]]
kind = "eigen-sweep"
sweep = { key = "parameters.speed", values = [1, 2, 4] }
region = { re = [-50, 1000], im = [0, 20000] }
method = "projected"
tolerance = 1e-4
"#;

pub(crate) const FILES: [&str; 6] =
    ["brake/M.mat", "brake/D.mat", "brake/G.npz", "brake/R.mtx", "brake/K.mat", "brake/W.mat"];

#[test]
fn sums_of_matrices_have_factors_of_parameters() {
    let case = with_files(&FILES, MATRICES, &[]).unwrap().of::<StructureCase>().unwrap().clone();
    let StructureSource::Matrices(Matrices::Files(sums)) = &case.source else { panic!("matrices") };
    let values: Vec<f64> = sums
        .sums()
        .iter()
        .flat_map(|(_, terms)| *terms)
        .map(|term| term.factor.value(&[2.0]).unwrap())
        .collect();
    assert_eq!(values, [1.0, 1.0, 2.0, -0.5, 1.0, 3.0]);
    assert_eq!(case.files().len(), 6);
    let sweep: &EigenSweep = case.analyses[1].settings().unwrap();
    assert_eq!(
        (&sweep.sweep.values[..], sweep.method),
        (&[1.0, 2.0, 4.0][..], SweepMethod::Projected { tolerance: 1e-4 })
    );
}

#[test]
fn the_folder_of_an_option_may_be_anywhere() {
    let case =
        with_files(&FILES, &MATRICES.replace("\"brake\"", "\"elsewhere\""), &["matrices.folder=HERE/brake"]);
    assert_eq!(case.unwrap().files().len(), 6);
}

/// Where the files lie changes no result.
#[test]
fn the_resolved_case_does_not_tell_the_folder() {
    let resolved = |text: &str, overrides: &[&str]| with_files(&FILES, text, overrides).unwrap().resolved();
    let moved = resolved(&MATRICES.replace("\"brake\"", "\"x\""), &["matrices.folder=HERE/brake"]);
    assert_eq!(resolved(MATRICES, &[]), moved);
    assert_eq!(moved["matrices"]["damping"][2]["factor"], "1/speed - 1");
}
