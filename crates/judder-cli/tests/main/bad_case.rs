//! Cases that are refused, each with what is wrong, what would be right, exit code 2 and nothing left behind.

use crate::desk::{CASE, Desk};

/// Checks that `run`, `check` and `point` refuse the small case with these lines in place of others.
fn refused(lines: &str, message: &str, help: &str) {
    let desk = Desk::with_case(&format!("model = \"oscillator\"\n{lines}\n"));
    for command in ["run", "check", "point"] {
        desk.refused(&[command, "case.toml"], message, help);
    }
}

fn map(x: &str) -> String {
    format!(
        "[[analysis]]\nkind = \"stability-map\"\nx = {{ {x} }}\n\
         y = {{ key = \"contact.shear_strength\", from = 1e-4, to = 1, points = 25000, scale = \"log\" }}"
    )
}

#[test]
fn an_unknown_key() {
    let message = "unknown key `velocty` in [operation]";
    refused("[operation]\nvelocty = 1e-4", message, "did you mean `velocity`?");
    refused("[operation]\nvelocty = 1e-4", "case.toml:3:1", "velocty = 1e-4");
}

/// What is wrong with different keys, tables and analyses is told together, in the order of the text, a misspelt key once and not as
/// lacking too; of very many the first twenty.
#[test]
fn everything_that_is_wrong() {
    let head = "model = \"structure\"\n[structure]\nbeam = { length = \"1 s\", tickness = \"1 cm\", elements = [10, 2] }\n\
                [damping]\nrayleigh = { alpha = \"-1 1/s\" }\n";
    let desk = Desk::with_case(head);
    let messages = [
        "`structure.beam.length` must be a length",
        "unknown key `tickness`",
        "`damping.rayleigh.alpha` must be zero or positive",
    ];
    for message in messages {
        desk.refused(&["check", "case.toml"], message, "");
    }
    let analysis: String =
        (0..30).map(|k| format!("[[analysis]]\nname = \"m{k}\"\nkind = \"modes\"\ncount = 0\n")).collect();
    let body = "model = \"structure\"\n[structure]\nbeam = { length = \"1 m\", thickness = \"1 cm\", elements = [10, 2] }\n\
                material = { youngs_modulus = \"1 GPa\", poisson_ratio = 0.3, density = \"1000 kg/m^3\" }\n";
    let desk = Desk::with_case(&format!("{body}{analysis}"));
    desk.refused(&["check", "case.toml"], "10 more things are wrong with it", "");
}

#[test]
fn a_margin_or_branches_that_are_no_yes_or_no() {
    let map = map("key = \"operation.velocity\", from = 1e-4, to = 1, points = 3");
    let lines = format!("{}\nglobal_margin = \"yes\"", map.replace("25000", "3"));
    refused(&lines, "`global_margin` is a string, but must be true or false", "global_margin = \"yes\"");
    let lines = "[[analysis]]\nkind = \"bifurcation\"\nbranches = 1\n\
                 sweep = { key = \"operation.velocity\", from = 1e-5, to = 1e-3, points = 3 }";
    refused(lines, "`branches` is an integer, but must be true or false", "branches = 1");
}

#[test]
fn a_wrong_unit() {
    let message = "`operation.velocity` must be a speed, but this is a length";
    refused("[operation]\nvelocity = \"30 mm\"", message, "write a speed, such as \"30 mm/s\"");
}

#[test]
fn a_negative_stiffness() {
    let message = "`oscillator.stiffness_x` must be positive, but is -50 N/m";
    refused("[oscillator]\nstiffness_x = \"-50 N/m\"", message, "out of range");
}

#[test]
fn nan() {
    let message = "`operation.normal_load` is not a finite number";
    refused("[operation]\nnormal_load = nan", message, "not values of a case");
}

#[test]
fn an_empty_range() {
    let x = "key = \"operation.velocity\", from = 1, to = 1, points = 40";
    refused(&map(x), "the range is empty", "let `from` and `to` differ");
}

#[test]
fn a_logarithmic_range_through_zero() {
    let x = "key = \"oscillator.coupling\", from = 0, to = 1, points = 40, scale = \"log\"";
    refused(&map(x), "a logarithmic range cannot touch or pass zero", "use scale = \"linear\"");
}

#[test]
fn a_sweep_of_a_key_that_does_not_exist() {
    let x = "key = \"operation.velocty\", from = 1e-8, to = 1, points = 40";
    refused(&map(x), "unknown swept key `operation.velocty`", "did you mean `operation.velocity`?");
}

#[test]
fn a_map_of_a_thousand_million_points() {
    let x = "key = \"operation.velocity\", from = 1e-8, to = 1e2, points = 40000, scale = \"log\"";
    refused(&map(x), "40000 × 25000 = 1000000000 points need 14.9 GiB of memory", "the limit is");
}

#[test]
fn what_a_contact_case_cannot_be() {
    let refused = |lines: &str, message: &str, help: &str| {
        let desk = Desk::with_case(&format!("model = \"contact\"\n{lines}\n"));
        for command in ["run", "check"] {
            desk.refused(&[command, "case.toml"], message, help);
        }
    };
    let contact = "[[analysis]]\nkind = \"contact\"\nvelocity = 1\n";
    refused("indenter = { shape = \"cone\" }", "unknown shape `cone`", "known: paraboloid, sphere, cylinder");
    refused(
        &format!("{contact}indentation = 1e-2\nload = 1"),
        "cannot both be given",
        "keep `indentation` or `load`",
    );
    refused(&format!("{contact}load = 1e-2\naccuracy = 2"), "`accuracy` must be above 0", "out of range");
    refused(
        "substrate = { dma = { file = \"x.csv\" } }",
        "which does not exist",
        "relative to the folder of the case",
    );
}

/// What is there is told, whichever file it stands in the place of.
#[cfg(unix)]
#[test]
fn what_is_no_file_in_the_place_of_one() {
    let matrices = "model = \"structure\"\n[matrices]\nmass = [{ file = \"own.mtx\" }]\nstiffness = [{ file = \"own.mtx\" }]\n";
    let desk = Desk::with_case(matrices);
    let refused = |message: &str| {
        for command in ["run", "check"] {
            desk.refused(&[command, "case.toml"], message, "relative to the folder of the case");
        }
    };
    refused("names `own.mtx`, which does not exist");
    let pipe = desk.path("own.mtx");
    assert!(std::process::Command::new("mkfifo").arg(&pipe).status().unwrap().success());
    refused("names `own.mtx`, which is a pipe, not a file");
    std::fs::remove_file(&pipe).unwrap();
    std::os::unix::fs::symlink("/dev/zero", &pipe).unwrap();
    refused("names `own.mtx`, which is a device, not a file");
    desk.write("case.toml", format!("{matrices}folder = \"own.mtx\"\n"));
    refused_folder(&desk, "which is a device, not a folder");
    desk.write("case.toml", "model = \"contact\"\nsubstrate = { dma = { file = \"own.mtx\" } }\n");
    refused("names `own.mtx`, which is a device, not a file");
}

#[cfg(unix)]
fn refused_folder(desk: &Desk, message: &str) {
    desk.refused(&["check", "case.toml"], message, "a folder in a case is relative to the case file");
}

#[test]
fn data_that_are_none() {
    let desk = Desk::with_case("model = \"contact\"\nsubstrate = { dma = { file = \"data.csv\" } }\n");
    desk.write("data.csv", "frequency [Hz],E' [MPa],E'' [MPa]\n1,2,x\n");
    let said = desk.judder(&["check", "case.toml"]);
    assert_eq!(said.code, 2, "{}", said.stderr);
    said.says("data.csv: ");
}

#[test]
fn files_that_are_no_case() {
    let desk = Desk::with_case(CASE);
    desk.write("binary.toml", [0x7f, b'E', b'L', b'F', 0xff, 0xfe]);
    desk.write("empty.toml", "# nothing\n");
    desk.write("prose.toml", "velocity is thirty\n");
    let begin = "`judder new` prints a case file to start from";
    desk.refused(&["run", "missing.toml"], "there is no file `missing.toml`", begin);
    desk.refused(&["run", "."], "`.` is a folder, not a case file", begin);
    desk.refused(&["run", "binary.toml"], "`binary.toml` is not a text file: the byte at offset 4", begin);
    desk.refused(&["run", "empty.toml"], "`empty.toml` is empty", begin);
    desk.refused(&["run", "prose.toml"], "this is not TOML", "prose.toml:1:");
    // a path through a file cannot be read, whoever asks
    desk.refused(&["run", "case.toml/inner.toml"], "cannot read `case.toml/inner.toml`", "Not a directory");
}

#[test]
fn set_options() {
    let desk = Desk::with_case(CASE);
    let refused = |option: &str, message: &str, help: &str| {
        desk.refused(&["run", "case.toml", "--set", option], message, help);
    };
    refused("operation.velocity", "is not of the form key=value", "--set \"operation.velocity=30 mm/s\"");
    refused("operation.velocty=1", "unknown key `velocty`", "did you mean `velocity`?");
    refused("operation.velocity=30 mm", "but this is a length", "[--set:1:20]");
    refused("operation.velocity=nan", "is not a finite number", "[--set:1:20]");
}

#[test]
fn the_place_is_drawn() {
    let desk = Desk::with_case("model = \"oscillator\"\n\n[operation]\nvelocty = 1e-4\n");
    let expected = "  × unknown key `velocty` in [operation]
   ╭─[case.toml:4:1]
 3 │ [operation]
 4 │ velocty = 1e-4
   · ───┬───
   ·    ╰── unknown key
   ╰────
  help: did you mean `velocity`? keys here: velocity, normal_load
";
    assert_eq!(desk.judder(&["check", "case.toml"]).stderr, expected);
}

#[test]
fn the_place_is_in_the_document() {
    let desk = Desk::with_case("model = \"oscillator\"\n\n[operation]\nvelocity = \"3 τ\"\n");
    let said = desk.judder(&["--json", "run", "case.toml"]);
    assert_eq!(said.code, 2);
    said.says("`operation.velocity` is not a speed");
    let error = &said.json()["error"];
    assert_eq!(error["message"], "`operation.velocity` is not a speed: unknown unit `τ`");
    let place = serde_json::json!({ "source": "case.toml", "line": 4, "column": 15, "text": "τ" });
    assert_eq!(error["place"], place);
    assert!(error["help"].as_str().unwrap().starts_with("write a speed"));
}

/// What the process may take is asked before anything is made: these would have ended it without a word.
#[test]
fn sizes_that_no_memory_has() {
    let axis =
        "{ key = \"operation.velocity\", from = 1e-6, to = 1.0, points = 1000000000000, scale = \"log\" }";
    let sweep = format!("[[sweep]]\nname = \"all\"\nover = [{axis}]\nquantities = [\"growth_rate\"]");
    let message = "the 1000000000000 values of the keys of the sweep `all`: 24.0 TB of memory are needed";
    let desk = Desk::with_case(&format!("model = \"oscillator\"\n{sweep}\n"));
    for command in ["run", "check"] {
        desk.refused(&[command, "case.toml"], message, "--memory \"22352 GiB\"");
    }
    let block = |cells: &str| {
        Desk::with_case(&format!(
            "model = \"structure\"\n[structure]\nblock = {{ element = \"hexahedron8\", size = [\"1 m\", \"1 m\", \"1 m\"], cells = {cells} }}\n\
             material = {{ youngs_modulus = \"1 GPa\", poisson_ratio = 0.3, density = \"1000 kg/m^3\" }}\n\
             [[analysis]]\nkind = \"modes\"\n"
        ))
    };
    let desk = block("[100000, 100000, 100000]");
    let message = "this structure: 28.7 EB of memory are needed";
    desk.refused(&["check", "case.toml"], message, "no machine has that");
    desk.refused(&["run", "case.toml"], message, "no machine has that");
}

#[test]
fn memory_beyond_what_was_told() {
    let desk = Desk::with_case(CASE);
    for amount in ["lots", "1 EB", "4gib", "-1", "-1 GiB", "0.5 MiB"] {
        let units = "give a number of 1 MiB or more with its unit (TiB, GiB, MiB, KiB, TB, GB, MB, kB)";
        let message = format!("invalid value '{amount}' for '--memory <AMOUNT>'");
        desk.refused(&["check", "case.toml", "--memory", amount], &message, units);
    }
    let message = "the program itself: 44.0 MB of memory are needed, and 2.1 MB are to be had, as was said";
    desk.refused(&["check", "case.toml", "--memory", "2 MiB"], message, "--memory \"1 GiB\"");
    let motion = "model = \"oscillator\"\n[[analysis]]\nkind = \"motion\"\npoints = 4194304\n";
    let desk = Desk::with_case(motion);
    let check = ["check", "case.toml", "--memory", "1 GiB"];
    let spectrum = "model = \"oscillator\"\n[[analysis]]\nkind = \"spectrum\"\n\
                    sweep = { key = \"operation.velocity\", from = 1e-5, to = 1e-3, points = 1000000 }\n";
    let message = "5.5 GB of memory are needed, and 1.1 GB are to be had, as was said";
    Desk::with_case(spectrum).refused(&check, message, "--memory \"6 GiB\"");
    desk.refused(
        &check,
        "1.5 GB of memory are needed, and 1.1 GB are to be had, as was said",
        "--memory \"2 GiB\"",
    );
}

/// Each takes what it says, but for nothing that was asked before.
#[test]
fn what_is_read_made_and_found_is_held_against_the_budget() {
    let check = ["check", "case.toml", "--memory", "100 MiB"];
    let refused = |text: &str, message: &str| Desk::with_case(text).refused(&check, message, "--memory");
    let swept = r#"model = "oscillator"
[[sweep]]
name = "all"
method = "sobol"
points = 524288
sensitivity = true
over = [
  { key = "operation.velocity", from = 1e-6, to = 1.0, scale = "log" },
  { key = "contact.shear_strength", from = 1e-3, to = 1.0, scale = "log" },
]
quantities = ["growth_rate", "frequency"]
"#;
    refused(
        swept,
        "the sensitivities of 2 quantities at 2097152 points of the sweep `all`: 125.8 MB of memory",
    );
    let contact = "model = \"contact\"\n[substrate]\nrubbery_modulus = \"1 MPa\"\nglassy_modulus = \"10 MPa\"\n\
                   retardation_time = \"10 ms\"\npoisson_ratio = 0.5\n[indenter]\n";
    let law = "radius = \"10 mm\"\n[[analysis]]\nkind = \"contact-law\"\naccuracy = 0.2\n\
               velocity = { from = 1e-2, to = 1, points = 2000 }\nindentation = { from = 1e-3, to = 1e-2, points = 2000 }\n";
    refused(&format!("{contact}{law}"), "a law at 2000 × 2000 points: ");
    let rough = "shape = { rough = { period = \"1 mm\", cells = 4096, hurst = 0.8, rms_height = \"1 um\", seed = 1 } }\n\
                 [[analysis]]\nkind = \"contact\"\nload = \"1 mN\"\nvelocity = \"1 mm/s\"\n";
    refused(
        &format!("{contact}{rough}"),
        "a rough surface of 4096 × 4096 cells: 681.5 MB of memory are needed",
    );
}

/// Files that fit one by one are held together.
#[test]
fn matrices_share_one_budget() {
    let desk = Desk::new();
    let count = 300_000;
    let rows: String = (1..=count).map(|k| format!("{k} {k} 1\n")).collect();
    desk.write(
        "k.mtx",
        format!("%%MatrixMarket matrix coordinate real general\n{count} {count} {count}\n{rows}"),
    );
    let many = ["{ file = \"k.mtx\" }"; 12].join(", ");
    desk.write(
        "case.toml",
        format!("model = \"structure\"\n[matrices]\nmass = [{many}]\nstiffness = [{many}]\n[[analysis]]\nkind = \"modes\"\ncount = 1\n"),
    );
    desk.refused(&["check", "case.toml", "--memory", "200 MiB"], "of memory are needed", "--memory");
}
