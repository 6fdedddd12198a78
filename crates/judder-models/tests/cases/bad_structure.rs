//! Structure cases that are refused.

use super::structure::{FILES, MATRICES, with_files};
use super::{help_of, refused};

const MATERIAL: &str =
    "material = { youngs_modulus = \"1 GPa\", poisson_ratio = 0.3, density = \"1000 kg/m^3\" }";

pub(super) fn body(lines: &str) -> String {
    format!("model = \"structure\"\n[structure]\n{lines}\n{MATERIAL}\n")
}

fn beam(rest: &str) -> String {
    body("beam = { length = \"1 m\", thickness = \"1 cm\", elements = [10, 2] }") + rest
}

fn analysis(lines: &str) -> String {
    beam(&format!("[[analysis]]\n{lines}\n"))
}

#[test]
fn no_structure() {
    refused(
        "model = \"structure\"\n",
        "a structure case needs `[structure]` or `[matrices]`",
        "",
        "give [structure] with beam = { … }, block = { … }, disc = { … } or mesh = \"file.msh\", or [matrices] with mass = [{ file = \"…\" }]",
    );
}

#[test]
fn structure_and_matrices() {
    refused(
        &beam("[matrices]\nfolder = \".\"\n"),
        "`matrices` together with `structure`: both say the same thing",
        "[matrices]",
        "keep `structure` or `matrices`",
    );
}

#[test]
fn no_geometry_and_two() {
    let help = "as in beam = { length = \"100 mm\", thickness = \"2 mm\", elements = [100, 2] }";
    refused(
        &body(""),
        "[structure] has none, but takes one of `beam`, `block`, `disc`, `mesh`",
        "[structure]",
        help,
    );
    refused(
        &body("beam = { length = \"1 m\" }\nblock = { size = [\"1 m\"] }"),
        "[structure] has `beam` and `block`, but takes one of `beam`, `block`, `disc`, `mesh`",
        "{ size = [\"1 m\"] }",
        help,
    );
}

#[test]
fn a_length_without_a_unit() {
    refused(
        &body("beam = { length = 1, thickness = \"1 cm\", elements = [10, 2] }"),
        "`structure.beam.length` needs a unit: it has no dimensionless form",
        "1",
        "write a length, such as \"10 mm\"",
    );
}

#[test]
fn a_density_in_another_unit() {
    refused(
        &beam("").replace("1000 kg/m^3", "1000 kg/m^2"),
        "`structure.material.density` must be a density, but this is a quantity in kg/m^2",
        "\"1000 kg/m^2\"",
        "write a density, such as \"7850 kg/m^3\"",
    );
}

#[test]
fn a_material_that_is_incompressible() {
    refused(
        &beam("").replace("poisson_ratio = 0.3", "poisson_ratio = 0.5"),
        "`structure.material.poisson_ratio` must be above -1 and at most 0.499999, but is 0.5",
        "0.5",
        "",
    );
}

#[test]
fn a_beam_without_material() {
    refused(
        &beam("").replace(MATERIAL, ""),
        "a beam needs `material`",
        "[structure]",
        "give material = { youngs_modulus = \"210 GPa\", poisson_ratio = 0.3, density = \"7850 kg/m^3\" }",
    );
}

#[test]
fn an_unknown_end_condition() {
    refused(
        &body("beam = { length = \"1 m\", thickness = \"1 cm\", elements = [10, 2], start = \"clampd\" }"),
        "unknown end condition `clampd`",
        "clampd",
        "did you mean `clamped`? known: free, clamped, guided",
    );
}

#[test]
fn cells_of_another_dimension() {
    refused(
        &body("block = { size = [\"1 m\", \"1 m\", \"1 m\"], cells = [2, 2] }"),
        "`structure.block.cells` has 2 entries, but must have three in space",
        "[2, 2]",
        "give three in space",
    );
}

#[test]
fn no_cells() {
    refused(
        &body("block = { size = [\"1 m\", \"1 m\"], cells = [2, 0] }"),
        "`structure.block.cells` must be a whole number from 1 to 100000, but is 0",
        "0",
        "give a number from 1 to 100000",
    );
}

#[test]
fn a_width_in_space() {
    refused(
        &body("block = { size = [\"1 m\", \"1 m\", \"1 m\"], cells = [2, 2, 2] }\nwidth = \"1 m\""),
        "`width` has no meaning with elements of space",
        "\"1 m\"",
        "leave `width` out",
    );
}

#[test]
fn a_mesh_that_is_not_there() {
    let text = "model = \"structure\"\n[structure]\nmesh = \"part.msh\"\n";
    refused(
        text,
        "`structure.mesh` names `part.msh`, which does not exist",
        "\"part.msh\"",
        "a path in a case is relative to the folder of the case file",
    );
}

#[test]
fn a_mesh_of_another_format() {
    let text = "model = \"structure\"\n[structure]\nmesh = \"part.stl\"\n";
    let error = with_files(&["part.stl"], text, &[]).unwrap_err();
    assert!(error.to_string().ends_with("part.stl`, which is of no format that is read"), "{error}");
    assert_eq!(help_of(&error), "known endings: .msh, .inp");
}

#[test]
fn a_support_without_effect() {
    refused(
        &body(
            "beam = { length = \"1 m\", thickness = \"1 cm\", elements = [10, 2] }\nsupports = [{ set = \"end\" }]",
        ),
        "the support of set `end` neither fixes nor ties a direction",
        "{ set = \"end\" }",
        "give fixed = [\"x\", \"y\"] or tied = [\"y\"]",
    );
}

#[test]
fn a_direction_that_is_none() {
    refused(
        &body(
            "beam = { length = \"1 m\", thickness = \"1 cm\", elements = [10, 2] }\nsupports = [{ set = \"end\", fixed = [\"w\"] }]",
        ),
        "unknown direction `w`",
        "w",
        "did you mean `x`? known: x, y, z",
    );
}

#[test]
fn parameters_of_a_body() {
    refused(
        &format!("{}[parameters]\nmu = 1\n", beam("")),
        "`parameters` has no meaning with [structure]",
        "[parameters]",
        "leave `parameters` out",
    );
}

#[test]
fn ratios_that_need_a_negative_coefficient() {
    refused(
        &beam(
            "[damping]\nrayleigh = { ratios = [{ frequency = \"1 Hz\", ratio = 0.01 }, { frequency = \"10 Hz\", ratio = 0.5 }] }\n",
        ),
        "the damping ratios 0.01 at 1 Hz and 0.5 at 10 Hz need a negative coefficient",
        "[{ frequency = \"1 Hz\", ratio = 0.01 }, { frequency = \"10 Hz\", ratio = 0.5 }]",
        "move the ratios closer to one another",
    );
}

#[test]
fn a_reduction_without_its_section() {
    refused(
        &analysis("kind = \"reduction\""),
        "the case lacks the key `reduction`",
        "[[analysis]]",
        "give [reduction] with kept = [{ set = \"…\" }]",
    );
}

#[test]
fn kept_nodes_of_a_body() {
    refused(
        &beam("[reduction]\nkept = [{ nodes = [1] }]\n"),
        "`reduction.kept` of a body names sets, not nodes",
        "[1]",
        "as in set = \"end\"",
    );
}

#[test]
fn a_count_and_a_cut_off() {
    refused(
        &beam("[reduction]\nkept = [{ set = \"end\" }]\ncount = 3\ncut_off = \"1 kHz\"\n"),
        "`reduction.cut_off` together with `reduction.count`: both say the same thing",
        "\"1 kHz\"",
        "keep `reduction.count` or `reduction.cut_off`",
    );
}

#[test]
fn a_band_that_runs_backwards() {
    refused(
        &analysis("kind = \"modes\"\nband = [\"2 rad/s\", \"1 rad/s\"]"),
        "the range runs backwards: from 2 rad/s to 1 rad/s",
        "[\"2 rad/s\", \"1 rad/s\"]",
        "exchange its two ends",
    );
}

#[test]
fn a_region_without_width() {
    refused(
        &analysis("kind = \"eigen\"\nregion = { re = [0, 0], im = [0, 1] }"),
        "the range is empty: from and to are both 0.0",
        "[0, 0]",
        "let `from` and `to` differ",
    );
    refused(
        &analysis("kind = \"eigen\""),
        "an analysis of kind `eigen` lacks the key `region`",
        "[[analysis]]",
        "give region = { frequency = [\"0 Hz\", \"8 kHz\"], damping_ratio = [-0.1, 0.1] }, or { re = […], im = […] } in 1/s and rad/s",
    );
}

#[test]
fn a_sweep_of_a_body() {
    refused(
        &analysis("kind = \"eigen-sweep\"\nregion = { re = [0, 1], im = [0, 1] }"),
        "there is nothing to sweep: only factors and entries of `[matrices]` depend on parameters",
        "[[analysis]]",
        "take matrices with factors such as \"1/speed - 1\", or run the case once a value with `--set`",
    );
}

#[test]
fn an_analysis_of_another_model() {
    refused(
        &analysis("kind = \"spectrum\""),
        "the analysis kind `spectrum` belongs to another model",
        "spectrum",
        "available: modes, reduction, eigen, eigen-sweep, receptance",
    );
}

/// The message, place and help of matrices with one thing changed.
fn matrices(from: &str, to: &str, message: &str, place: &str, help: &str) {
    assert!(MATRICES.contains(from), "{from}");
    let error = with_files(&FILES, &MATRICES.replacen(from, to, 1), &[]).unwrap_err();
    let found = error.to_string();
    assert!(found.ends_with(message), "{found}");
    assert_eq!((error.place(), help_of(&error).as_str()), (place, help));
}

#[test]
fn matrices_that_cannot_be() {
    let path = "a path in a case is relative to the folder of the case file";
    matrices("M.mat", "N.mat", "N.mat`, which does not exist", "\"N.mat\"", path);
    matrices(
        "\"brake\"",
        "\"brakes\"",
        "brakes`, which does not exist",
        "\"brakes\"",
        "a folder in a case is relative to the case file, one in `--set` to where the program runs",
    );
    matrices(
        "\"speed\" }, ",
        "\"sped\" }, ",
        "unknown symbol `sped`",
        "sped",
        "did you mean `speed`? known symbols: speed, pi; functions: sin cos tan asin acos atan sinh cosh tanh exp ln sqrt abs",
    );
    matrices(
        "speed = 2",
        "speed = 0",
        "the factor of `R.mtx` is inf, at speed = 0",
        "[[analysis]]",
        "a factor must be finite: mind division by zero",
    );
    matrices(
        "values = [1, 2, 4]",
        "values = [1, 0]",
        "the factor of `R.mtx` is inf, at speed = 0",
        "{ key = \"parameters.speed\", values = [1, 0] }",
        "a factor must be finite: mind division by zero",
    );
    matrices(
        "values = [1, 2, 4]",
        "values = [1, 4, 2]",
        "the values of `sweep.values` must ascend or descend",
        "[1, 4, 2]",
        "branches are followed from one value to the next: sort them",
    );
    matrices(
        "method = \"projected\"",
        "method = \"full\"",
        "`tolerance` has no meaning with method = \"full\"",
        "1e-4",
        "leave `tolerance` out",
    );
    matrices(
        "\"parameters.speed\"",
        "\"parameters.sped\"",
        "unknown swept key `parameters.sped`",
        "\"parameters.sped\"",
        "did you mean `parameters.speed`? known: parameters.speed",
    );
    matrices(
        "[parameters]",
        "[damping]\n[parameters]",
        "`damping` has no meaning with [matrices]",
        "[damping]",
        "leave `damping` out",
    );
    matrices(
        "[parameters]",
        "[reduction]\nkept = [{ nodes = [1] }]\n[parameters]",
        "`reduction.kept` names nodes, but `matrices.freedoms` does not say which freedoms they have",
        "[1]",
        "give freedoms = \"table.csv\" with the matrices",
    );
    matrices(
        "[parameters]",
        "[reduction]\nkept = [{ set = \"a\" }]\n[parameters]",
        "matrices have no sets: `reduction.kept` names nodes of the table `matrices.freedoms`",
        "\"a\"",
        "as in nodes = [1, 17]",
    );
}

#[test]
fn a_matrix_of_another_format() {
    let text = MATRICES.replace("M.mat", "M.csv");
    let error = with_files(&[&FILES[..], &["brake/M.csv"]].concat(), &text, &[]).unwrap_err();
    assert!(error.to_string().ends_with("M.csv`, which is of no format that is read"), "{error}");
    assert_eq!(help_of(&error), "known endings: .mtx, .mat, .npz");
}

#[test]
fn a_parameter_that_no_factor_contains() {
    let text =
        MATRICES.replace("speed = 2", "speed = 2\nload = 1").replace("parameters.speed", "parameters.load");
    let error = with_files(&FILES, &text, &[]).unwrap_err();
    assert_eq!(error.to_string(), "no factor and no entry of a matrix contains the parameter `load`");
}
