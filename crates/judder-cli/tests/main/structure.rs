//! Structures: the template, the disc brake, what only a file can tell.

use std::path::Path;

use serde_json::Value;

use crate::desk::Desk;

#[test]
fn the_template_runs() {
    let desk = Desk::new();
    let template = desk.succeed(&["new", "structure"]).stdout;
    desk.write("case.toml", template);
    let checked = desk.succeed(&["check", "case.toml", "--json"]).json();
    assert_eq!(checked["structure"]["degrees_of_freedom"], 1600);
    let summary = desk.succeed(&["run", "case.toml", "--json"]).json();
    assert_eq!(summary["results"]["modes"]["frequencies_hz"].as_array().unwrap().len(), 12);
    assert_eq!(summary["results"]["damped"]["complete"], true);
    for file in
        ["fields/modes.vtu", "fields/modes.unv", "fields/modes-mode-1.pvd", "fields/damped-mode-1-00.vtu"]
    {
        assert!(desk.path(&format!("out/case/{file}")).is_file(), "{file}");
    }
}

#[test]
fn a_set_that_is_not_there_is_shown_in_the_case() {
    let desk = Desk::new();
    let template = desk.succeed(&["new", "structure"]).stdout;
    desk.write("case.toml", template.replace("set = \"upper-corners\"", "set = \"uper-corners\""));
    let message = "there is no set of nodes named `uper-corners`";
    for command in ["run", "check"] {
        desk.refused(&[command, "case.toml"], message, "did you mean `upper-corners`?");
    }
}

/// The numbers of the data's own notes: 11 eigenvalues, two of them unstable, one marginal.
#[test]
fn the_disc_brake_squeals() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let data = root.join("../shared/data/disc-brake-m0");
    if !data.is_dir() {
        eprintln!("SKIPPED: the matrices of the disc brake are not at {}", data.display());
        return;
    }
    let desk = Desk::new();
    let case = root.join("cases/benchmarks/disc-brake.toml");
    let folder = format!("matrices.folder={}", data.canonicalize().unwrap().display());
    let arguments =
        ["run", case.to_str().unwrap(), "--set", &folder, "--only", "squeal", "--json", "-o", "out"];
    let squeal = desk.succeed(&arguments).json()["results"]["squeal"].clone();
    assert_eq!(squeal["complete"], true);
    let values = squeal["eigenvalues"].as_array().unwrap();
    assert_eq!(values.len(), 11);
    let of = |verdict: &str| -> Vec<&Value> {
        values.iter().filter(|value| value["verdict"] == verdict).collect()
    };
    let number = |value: &Value| value.as_f64().unwrap();
    for (value, (re, im)) in
        of("unstable").iter().zip([(2.076_338, 4_920.344_220), (69.474_050, 17_429.059_590)])
    {
        assert!(
            (number(&value["re"]) - re).abs() < 2e-6 && (number(&value["im"]) - im).abs() < 2e-6,
            "{value}"
        );
        assert!(number(&value["residual"]) < 1e-12);
    }
    assert_eq!((of("unstable").len(), of("marginal").len()), (2, 1));
    assert!((number(&of("marginal")[0]["im"]) - 5_130.604_422).abs() < 2e-6);
    // the work of all matrices is the growth rate, and undamped modes take part
    for told in squeal["diagnosis"].as_array().unwrap() {
        let sum: f64 = told["matrices"].as_array().unwrap().iter().map(|own| number(&own["growth"])).sum();
        assert!((sum - number(&told["growth_rate"])).abs() < 1e-6, "{told}");
        assert!(number(&told["component_modes"][0]["share"]) > 0.1, "{told}");
    }
}

/// What `check` warns of in a case.
fn warnings(desk: &Desk) -> Vec<String> {
    let checked = desk.succeed(&["check", "case.toml", "--json"]).json();
    let warnings = checked["warnings"].as_array().unwrap().iter();
    warnings.map(|warning| warning.as_str().unwrap().to_owned()).collect()
}

#[test]
fn matrices_that_are_not_positive_are_told() {
    let matrix = |entries: &str| {
        let count = entries.lines().count();
        format!("%%MatrixMarket matrix coordinate real general\n4 4 {count}\n{entries}\n")
    };
    let desk = Desk::with_case(
        "model = \"structure\"\n[matrices]\nmass = [{ file = \"M.mtx\" }]\nstiffness = [{ file = \"K.mtx\" }]\n\
         [[analysis]]\nname = \"modes\"\nkind = \"modes\"\ncount = 4\n",
    );
    desk.write("K.mtx", matrix("1 1 1\n2 2 1\n3 3 1\n4 4 1"));
    desk.write("M.mtx", matrix("1 1 1\n2 2 1\n3 3 1\n4 4 1"));
    assert_eq!(warnings(&desk), [""; 0]);
    // two freedoms share one mass
    desk.write("M.mtx", matrix("1 1 1\n1 2 1\n2 1 1\n2 2 1\n3 3 1\n4 4 1"));
    let told = warnings(&desk);
    assert_eq!(told.len(), 1, "{told:?}");
    assert!(
        told[0].starts_with("the mass is singular, zero to rounding in 1 of its 4 eigenvalues"),
        "{told:?}"
    );
    let run = desk.succeed(&["run", "case.toml"]);
    run.says("4 modes are asked for, and there are 3: the mass is singular");
    // complex modes may be those of any matrices
    let modes = std::fs::read_to_string(desk.path("case.toml")).unwrap();
    let eigen = modes
        .replace("kind = \"modes\"\ncount = 4", "kind = \"eigen\"\nregion = { re = [-2, 2], im = [0, 2] }");
    desk.write("case.toml", eigen);
    desk.write("K.mtx", matrix("1 1 1\n2 2 1\n3 3 -1\n4 4 1"));
    let told = warnings(&desk);
    assert!(
        told[1].starts_with("the stiffness is indefinite, negative in 1 of its 4 eigenvalues"),
        "{told:?}"
    );
}

/// What a run certainly refuses, and nothing else.
#[test]
fn matrices_that_have_no_undamped_modes_are_refused_by_check_and_run() {
    let diagonal = |entries: [&str; 4]| {
        let lines: Vec<String> =
            entries.iter().zip(1..).map(|(entry, k)| format!("{k} {k} {entry}\n")).collect();
        format!("%%MatrixMarket matrix coordinate real general\n4 4 4\n{}", lines.concat())
    };
    let (ones, springs) = (diagonal(["1"; 4]), diagonal(["1", "4", "9", "16"]));
    let negative_mass = diagonal(["1", "1", "1", "-1"]);
    let pushing = diagonal(["-1", "4", "9", "16"]);
    let skew = "%%MatrixMarket matrix coordinate real general\n4 4 4\n1 2 5\n2 1 -5\n3 4 5\n4 3 -5\n";
    let desk = Desk::new();
    let case = |analysis: &str| {
        let head = "model = \"structure\"\n[matrices]\nmass = [{ file = \"M.mtx\" }]\nstiffness = [{ file = \"K.mtx\" }]\n";
        let freedoms = "freedoms = \"f.csv\"\n[reduction]\nkept = [{ nodes = [4], directions = [\"x\"] }]\n";
        let freedoms = if analysis.contains("reduction") { freedoms } else { "" };
        desk.write("case.toml", format!("{head}{freedoms}[[analysis]]\nname = \"own\"\n{analysis}\n"));
    };
    desk.write("f.csv", "node,direction,x,y,z\n1,x,0,0,0\n2,x,1,0,0\n3,x,2,0,0\n4,x,3,0,0\n");
    let matrices = |stiffness: &str, mass: &str| {
        desk.write("K.mtx", stiffness);
        desk.write("M.mtx", mass);
    };
    for analysis in [
        "kind = \"modes\"\ncount = 4",
        "kind = \"modes\"\nband = [\"0 Hz\", \"1 Hz\"]",
        "kind = \"reduction\"",
    ] {
        case(analysis);
        matrices(&diagonal(["1e308"; 4]), &ones);
        refused_by_both(&desk, "the trace of the stiffness is inf: it must be positive and finite");
        matrices(skew, &ones);
        refused_by_both(&desk, "the trace of the stiffness is 0: it must be positive");
        matrices(&pushing, &ones);
        refused_by_both(&desk, "the stiffness is indefinite, negative in 1 of its ");
        matrices(&springs, &negative_mass);
        refused_by_both(&desk, "the mass is indefinite, negative in 1 of its 4 eigenvalues");
    }
    case("kind = \"modes\"\nband = [\"0.1 Hz\", \"1 Hz\"]");
    refused_by_both(&desk, "the mass is indefinite");
    matrices(&pushing, &ones);
    assert_eq!(warnings(&desk).len(), 1);
    desk.succeed(&["run", "case.toml"]);
}

#[test]
fn elements_that_are_given_twice_are_told() {
    let desk = Desk::with_case(
        "model = \"structure\"\n[structure]\nmesh = \"plate.inp\"\nsection = \"plane-stress\"\nwidth = \"1 mm\"\n\
         material = { youngs_modulus = \"210 GPa\", poisson_ratio = 0.3, density = \"7850 kg/m^3\" }\n",
    );
    let mesh = |elements: &str| {
        format!(
            "*NODE\n1,0,0\n2,1,0\n3,1,1\n4,0,1\n5,2,0\n6,2,1\n*ELEMENT, TYPE=CPS4I, ELSET=all\n1,1,2,3,4\n2,2,5,6,3\n{elements}"
        )
    };
    desk.write("plate.inp", mesh(""));
    assert_eq!(warnings(&desk), [""; 0]);
    desk.write("plate.inp", mesh("7,2,3,4,1\n8,2,5,5,3\n"));
    let told = warnings(&desk).join("\n");
    assert!(told.contains("element given twice, the first is 7 with the nodes of 1"), "{told}");
    assert!(told.contains("a node that is named twice, the first is 8 with node 5"), "{told}");
}

#[test]
fn contact_that_is_never_made_is_told() {
    let desk = Desk::new();
    desk.write("case.toml", desk.succeed(&["examples", "assembly/block-on-plane"]).stdout);
    assert_eq!(warnings(&desk), [""; 0]);
    desk.write(
        "case.toml",
        desk.succeed(&["examples", "assembly/block-on-plane"]).stdout.replace("\"-20 um\"", "\"20 um\""),
    );
    let told = warnings(&desk).join("\n");
    assert!(told.contains("contact is never made: "), "{told}");
}

/// What every analysis would be refused for: a support was forgotten, or a sign is wrong.
#[test]
fn bodies_that_nothing_holds_are_refused_by_check_and_run() {
    let desk = Desk::new();
    let block = desk.succeed(&["examples", "assembly/block-on-plane"]).stdout;
    let support = block.lines().find(|line| line.starts_with("supports = ")).unwrap();
    desk.write(
        "case.toml",
        block.replace(support, "").replace("displacement = \"-20 um\"", "force = \"-1 kN\""),
    );
    refused_by_both(&desk, "rigid motion");
    let stop = desk.succeed(&["examples", "assembly/stop"]).stdout;
    let stiffness = stop.lines().find(|line| line.starts_with("stiffness = ")).unwrap();
    desk.write("case.toml", stop.replace(stiffness, "stiffness = [[1, -1], [-1, -0.5]]"));
    refused_by_both(&desk, "the stiffness of the bodies is not positive: it pushes on 1 motion");
}

/// Refused before anything is computed, and where each analysis begins.
fn refused_by_both(desk: &Desk, message: &str) {
    desk.refused(&["check", "case.toml"], message, "");
    let said = desk.judder(&["run", "case.toml"]);
    assert_eq!(said.code, 2, "{}", said.stderr);
    said.says(message);
}
