//! Bodies that springs and ties join, and bodies whose matrices stand in the case.

use crate::{number, run_into};
use judder_models::parse;
use judder_study::case::file::CaseFile;
use serde_json::{Map, Value};

fn read(text: &str) -> CaseFile {
    parse("case.toml", text, &[]).unwrap()
}

fn modes(file: &CaseFile) -> Map<String, Value> {
    let folder = tempfile::tempdir().unwrap();
    run_into(folder.path(), file, &["modes"]).summary.results["modes"].clone()
}

fn frequencies(file: &CaseFile) -> Vec<f64> {
    let modes = modes(file);
    assert_eq!(modes["complete"], true);
    modes["eigenvalues"].as_array().unwrap().iter().map(|value| number(&value["im"])).collect()
}

fn mass(name: &str, mass: f64, place: f64) -> String {
    format!(
        "[[structure]]\nname = \"{name}\"\n[structure.matrices]\nmass = [[{mass:?}]]\nfreedoms = [[\"end\", \"x\"]]\n\
         places = {{ end = [\"{place} m\", \"0 m\"] }}\n"
    )
}

const MODES: &str =
    "[[analysis]]\nname = \"modes\"\nkind = \"eigen\"\nregion = { re = [-9.0, 9.0], im = [0.1, 90.0] }\n";

/// Two masses between walls on three springs, one along the line of its ends, one with a damper: closed form of both modes.
#[test]
fn springs_between_masses_and_to_the_ground() {
    let spring = |name: &str, from: &str, to: &str, rest: &str| {
        format!(
            "[[spring]]\nname = \"{name}\"\nfrom = {{ structure = \"{from}\", set = \"end\" }}\nto = {to}\n{rest}\n"
        )
    };
    let text = [
        "model = \"assembly\"\n".to_owned(),
        mass("a", 2.0, 0.0),
        mass("b", 2.0, 1.0),
        spring(
            "left",
            "a",
            "\"ground\"",
            "direction = [2, 0]\nstiffness = \"100 N/m\"\ndamping = \"0.4 N s/m\"",
        ),
        spring(
            "right",
            "b",
            "\"ground\"",
            "direction = [-1, 0]\nstiffness = \"100 N/m\"\ndamping = \"0.4 N s/m\"",
        ),
        spring(
            "middle",
            "a",
            "{ structure = \"b\", set = \"end\" }",
            "stiffness = \"40 N/m\"\ndamping = \"0.1 N s/m\"",
        ),
        MODES.to_owned(),
    ];
    let file = read(&text.concat());
    let told = file.case.resolve(&file, file.case.resolved()).unwrap().text;
    assert!(told.contains("middle  a.end to b.end   40 N/m   0.1 N s/m"), "{told}");
    let modes = modes(&file);
    // masses together and against each other: λ² m + λ c + k with k, c of the middle none or twice
    for (value, (damping, stiffness)) in
        modes["eigenvalues"].as_array().unwrap().iter().zip([(0.4, 100.0), (0.6, 180.0)])
    {
        let (re, im) = (number(&value["re"]), number(&value["im"]));
        let expected: f64 = -damping / 4.0;
        assert!((re - expected).abs() < 1e-10, "{re}");
        assert!((im - (stiffness / 2.0 - expected * expected).sqrt()).abs() < 1e-10, "{im}");
    }
    assert_eq!(modes["eigenvalues"].as_array().unwrap().len(), 2);
}

/// A point mass on a node of arrays adds to its matrix, a tie makes two bodies one.
#[test]
fn tied_masses_are_one() {
    let tie = "[[tie]]\nname = \"bond\"\nfrom = { structure = \"a\", set = \"end\" }\nto = { structure = \"b\", set = \"end\" }\n";
    let spring = "[[spring]]\nname = \"left\"\nfrom = { structure = \"a\", set = \"end\" }\ndirection = [1, 0]\nstiffness = \"100 N/m\"\n";
    let heavy = mass("b", 1.0, 0.0).replace(
        "[structure.matrices]",
        "masses = [{ set = \"end\", mass = \"2 kg\" }]\n[structure.matrices]",
    );
    let text = ["model = \"assembly\"\n", &mass("a", 1.0, 0.0), &heavy, spring, tie, MODES].concat();
    let found = frequencies(&read(&text));
    assert!(found.len() == 1 && (found[0] - 5.0).abs() < 1e-10, "{found:?}");
    // twice the same bond is one too many
    let twice = [&text, &tie.replace("bond", "again")[..]].concat();
    let file = read(&twice);
    let refused = file.case.preflight(&file, &|_| true).map(drop).expect_err("it is refused");
    assert_eq!(
        refused.to_string(),
        "the tie `again` holds a displacement that ties or supports hold already"
    );
}

fn block(name: &str, cells: &str, length: &str, from: &str, rest: &str) -> String {
    format!(
        "[[structure]]\nname = \"{name}\"\nblock = {{ element = \"quad4\", size = [\"{length}\", \"10 mm\"], cells = {cells}, origin = [\"{from}\", \"0 mm\"] }}\n\
         material = {{ youngs_modulus = \"2 GPa\", poisson_ratio = 0.3, density = \"1200 kg/m^3\" }}\n{rest}\n"
    )
}

const LOWEST: &str = "[[analysis]]\nname = \"modes\"\nkind = \"eigen\"\nband = [\"10 Hz\", \"20 kHz\"]\n";

/// A block cut in two and bonded on matching nodes is the whole block; with a mesh that does not match it comes near.
#[test]
fn a_block_that_was_cut_and_bonded_is_the_whole() {
    let held = "supports = [{ set = \"x-min\", fixed = [\"x\", \"y\"] }]";
    let whole = ["model = \"assembly\"\n", &block("all", "[8, 2]", "40 mm", "0 mm", held), LOWEST].concat();
    let whole = frequencies(&read(&whole));
    let cut = |cells: &str, rest: &str| {
        let tie = "[[tie]]\nname = \"cut\"\nfrom = { structure = \"right\", set = \"x-min\" }\nto = { structure = \"left\", set = \"x-max\" }\n";
        let (left, right) =
            (block("left", "[4, 2]", "20 mm", "0 mm", held), block("right", cells, "20 mm", "20 mm", rest));
        frequencies(&read(&["model = \"assembly\"\n", &left, &right, tie, LOWEST].concat()))
    };
    assert!(whole.len() >= 3, "{whole:?}");
    let off = |found: &[f64]| {
        assert_eq!(found.len(), whole.len());
        found.iter().zip(&whole).map(|(own, of)| (own - of).abs() / of).fold(0.0, f64::max)
    };
    assert!(off(&cut("[4, 2]", "")) < 1e-10);
    // nodes that are bonded are kept by a reduction: with all its fixed-interface modes it changes nothing
    assert!(off(&cut("[4, 2]", "reduction = { count = 24 }")) < 1e-8);
    let finer = off(&cut("[4, 3]", ""));
    assert!(finer > 1e-6 && finer < 0.05, "{finer}");
}

/// A spring at a surface of several nodes pulls at the mean of their displacements: on a stiff block the whole block swings on it.
#[test]
fn the_nodes_of_a_set_share_a_spring() {
    let guided = "supports = [{ set = \"y-min\", fixed = [\"y\"] }, { set = \"y-max\", fixed = [\"y\"] }]";
    let spring = "[[spring]]\nname = \"mount\"\nfrom = { structure = \"all\", set = \"x-min\" }\ndirection = [1, 0]\nstiffness = \"10 N/m\"\n";
    let text =
        ["model = \"assembly\"\n", &block("all", "[4, 2]", "40 mm", "0 mm", guided), spring, MODES].concat();
    // 40 × 10 mm of a width of 1 m
    let expected = (10.0_f64 / (1200.0 * 0.04 * 0.01)).sqrt();
    let found = frequencies(&read(&text));
    assert!(found.len() == 1 && (found[0] - expected).abs() < 1e-6 * expected, "{found:?} {expected}");
}

/// A mass that slides on another, which carries the plane: contact force and modes follow from both.
#[test]
fn a_mass_slides_on_a_mass() {
    let body = |name: &str, stiffness: &str| {
        format!(
            "[[structure]]\nname = \"{name}\"\n[structure.matrices]\nmass = [[1, 0], [0, 1]]\nstiffness = {stiffness}\n\
             freedoms = [[\"mass\", \"x\"], [\"mass\", \"y\"]]\n"
        )
    };
    let text = [
        "model = \"assembly\"\n",
        &body("pad", "[[50, 0], [0, 0]]"),
        &body("disc", "[[1000, 0], [0, 200]]"),
        "[[contact]]\nname = \"lining\"\nslider = { structure = \"pad\", set = \"mass\" }\n\
         track = { structure = \"disc\", set = \"mass\", normal = [0, 1] }\n\
         sliding = { velocity = \"1 m/s\", direction = [1, 0] }\nfriction_coefficient = 0.3\n\
         [[load]]\nstructure = \"pad\"\nset = \"mass\"\ndirection = \"y\"\nforce = \"-4 N\"\n\
         [[analysis]]\nname = \"steady\"\nkind = \"steady-sliding\"\n",
        MODES,
    ]
    .concat();
    let file = read(&text);
    let folder = tempfile::tempdir().unwrap();
    let results = run_into(folder.path(), &file, &[]).summary.results;
    let lining = &results["steady"]["contacts"]["lining"];
    assert!((number(&lining["normal_force"]) - 4.0).abs() < 1e-10);
    assert!((number(&lining["tangential_force"][0]) - 1.2).abs() < 1e-10);
    // up and down both masses move as one on the spring of the disc
    let found = frequencies(&file);
    for (own, expected) in found.iter().zip([50_f64.sqrt(), 100_f64.sqrt(), 1000_f64.sqrt()]) {
        assert!((own - expected).abs() < 1e-9, "{found:?}");
    }
}

/// Circulation in the matrices of a body that slides: the work that makes the mode grow is told, and sums to its growth.
#[test]
fn circulation_of_a_body_is_told_as_what_makes_it_grow() {
    let text = "model = \"assembly\"\n[parameters]\nmu = 1.0\n[[structure]]\nname = \"body\"\n[structure.matrices]\n\
        mass = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]\nstiffness = [[2, \"1 - 4*mu/3\", 0], [1, 2, 0], [0, 0, 5]]\n\
        freedoms = [[\"a\", \"x\"], [\"a\", \"y\"], [\"b\", \"y\"]]\n\
        [[contact]]\nname = \"sole\"\nslider = { structure = \"body\", set = \"b\" }\ntrack = { plane = { normal = [0, 1] } }\n\
        sliding = { velocity = \"1 m/s\", direction = [1, 0] }\nfriction_coefficient = 0.0\n\
        [[load]]\nstructure = \"body\"\nset = \"b\"\ndirection = \"y\"\nforce = \"-1 N\"\n\
        [[analysis]]\nname = \"modes\"\nkind = \"eigen\"\nregion = { re = [-3.0, 3.0], im = [0.1, 3.0] }\n";
    let modes = modes(&read(text));
    let growing = &modes["growing"][0];
    let rate = number(&growing["growth"]["unsymmetric stiffness"]);
    assert!((rate - 0.202_071_768_8).abs() < 1e-9, "{growing}");
    // what nothing holds but circulation is held; what nothing holds at all is told
    let file = read(&text.replace("[0, 0, 5]", "[0, 0, 0]").replace(
        "[[\"a\", \"x\"], [\"a\", \"y\"], [\"b\", \"y\"]]",
        "[[\"b\", \"y\"], [\"a\", \"y\"], [\"a\", \"x\"]]",
    ));
    let folder = tempfile::tempdir().unwrap();
    let options = judder_study::run::RunOptions::default();
    let report = judder_study::run::run(&file, folder.path(), &options, &judder_study::Silent);
    let told = format!("{report:?}");
    assert!(told.contains("moves `body` along x, most at `a`"), "{told}");
}
