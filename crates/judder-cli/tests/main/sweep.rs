//! Sweeps of whole studies: what is told before they run, what is refused, what they would take.

use crate::desk::Desk;

/// A grid, samples with sensitivity, a list.
const SWEEPS: &str = r#"
model = "oscillator"

[[analysis]]
name = "cycle"
kind = "limit-cycle"

[[sweep]]
name = "map"
over = [
  { key = "operation.velocity", from = "0.1 mm/s", to = "1 m/s", points = 6, scale = "log" },
  { key = "contact.shear_strength", values = [0.01, 0.02, 0.05] },
]
quantities = ["growth_rate", "mechanism"]
chunk = 3

[[sweep]]
name = "robust"
method = "sobol"
points = 8
over = [{ key = "operation.velocity", from = 1e-4, to = 1e-2, scale = "log" }, { key = "oscillator.damping_x", from = 0, to = 0.1 }]
quantities = ["growth_rate"]
sensitivity = true
"#;

fn refused(from: &str, to: &str, message: &str, help: &str) {
    let text = SWEEPS.replacen(from, to, 1);
    assert_ne!(text, SWEEPS, "{from}");
    let desk = Desk::with_case(&text);
    desk.refused(&["run", "case.toml"], message, help);
    desk.refused(&["check", "case.toml"], message, help);
}

#[test]
fn check_lists_them() {
    let desk = Desk::with_case(SWEEPS);
    let told = desk.succeed(&["check", "case.toml"]).stdout;
    for words in [
        "map     grid",
        "18 points",
        "in 6 chunks",
        "0.0001 m/s to 1 m/s",
        "6 values, log",
        "→ mechanism",
        "robust  sobol",
        "32 points",
        "→ sensitivity",
    ] {
        assert!(told.contains(words), "{words:?} is not in\n{told}");
    }
    let told = desk.succeed(&["check", "case.toml", "--json"]).json();
    let map = &told["sweeps"][0];
    assert_eq!((&map["points"], &map["chunks"]), (&18.into(), &6.into()));
    assert_eq!(map["columns"], serde_json::json!(["growth_rate", "mechanism"]));
    assert_eq!(map["keys"][0]["key"], "operation.velocity");
    let columns = serde_json::json!(["operation.velocity", "oscillator.damping_x", "growth_rate"]);
    assert_eq!(told["sweeps"][1]["columns"], columns);
    assert_eq!(told["sweeps"][1]["sensitivity"]["resamples"], 1000);
}

#[test]
fn what_a_run_would_refuse_is_refused_by_check() {
    let quantities = "\"growth_rate\", \"mechanism\"";
    refused(quantities, "\"growthrate\"", "has a quantity `growthrate`", "did you mean `growth_rate`?");
    refused(quantities, "\"cycles.rms\"", "there is no analysis `cycles`", "did you mean `cycle`?");
    refused(quantities, "\"cycle\"", "it names a whole analysis", "ANALYSIS.PATH");
    refused(
        "operation.velocity",
        "operation.speed",
        "`operation.speed` cannot be swept",
        "keys here: velocity",
    );
    refused("from = \"0.1 mm/s\"", "from = \"0.1 kg\"", "from` is a mass, but", "another dimension");
    refused(
        "points = 6",
        "points = 0",
        "`over.points` must be a whole number from 2",
        "give a number from 2",
    );
    refused(
        "values = [0.01, 0.02, 0.05]",
        "values = []",
        "`over.values` is an empty list",
        "at least one value",
    );
    refused("method = \"sobol\"", "method = \"sobel\"", "unknown method `sobel`", "did you mean `sobol`?");
    refused("points = 8\n", "", "a sweep lacks the key `points`", "give points = 4096");
    refused("method = \"sobol\"\npoints = 8\n", "", "`sensitivity` has no meaning", "use method = \"sobol\"");
    refused(
        "name = \"robust\"",
        "name = \"cycle\"",
        "names both this sweep and an analysis",
        "`name` of its own",
    );
    refused("chunk = 3", "chunk = 0", "`chunk` must be a whole number from 1", "give a number from 1");
    refused("chunk = 3", "chunks = 3", "unknown key `chunks` in a sweep", "did you mean `chunk`?");
    refused(
        "from = 1e-4, to = 1e-2",
        "from = -1e-4, to = 1e-2",
        "cannot touch or pass zero",
        "scale = \"linear\"",
    );
}

#[test]
fn a_dry_run_estimates_and_writes_nothing() {
    let desk = Desk::with_case(SWEEPS);
    let before = desk.files();
    let told = desk.succeed(&["run", "case.toml", "--dry-run"]).stdout;
    for words in ["map\n", "points", "chunks                6 (0 done)", "memory", "on the disk, at most"] {
        assert!(told.contains(words), "{words:?} is not in\n{told}");
    }
    assert_eq!(desk.files(), before);
    desk.succeed(&["run", "case.toml", "--shard", "1/2"]);
    let told = desk.succeed(&["run", "case.toml", "--dry-run", "--json", "--only", "map"]).json();
    let map = &told["sweeps"][0];
    assert_eq!((&map["chunks"], &map["chunks_done"]), (&6.into(), &3.into()));
    assert!(map["seconds_per_point"].as_f64().unwrap() > 0.0 && told["sweeps"][1].is_null());
}

/// A motion needs 79 MB in all: alone it fits into 130 MB, beside another it does not.
#[test]
fn points_share_the_memory_of_the_process() {
    let case = "model = \"oscillator\"\n[[analysis]]\nkind = \"motion\"\npoints = 100000\n\
                [[sweep]]\nname = \"map\"\nchunk = 1\nquantities = [\"motion.rms\"]\n\
                over = [{ key = \"operation.velocity\", values = [1e-4, 2e-4, 3e-4, 4e-4] }]\n";
    let computed = |memory: &str| {
        let desk = Desk::with_case(case);
        let run = ["run", "case.toml", "--only", "map", "--threads", "3", "--memory", memory];
        let said = desk.succeed(&run);
        let told = format!("{}{}", said.stdout, said.stderr);
        let results = desk.read_json("out/case/summary.json")["results"]["map"].clone();
        (told.contains("map: at last only 1 of its chunks were computed at once"), results)
    };
    let [(alone, of_one), (not_alone, of_three)] = ["130 MB", "1 GB"].map(computed);
    assert!(alone && !not_alone);
    assert_eq!(of_one, of_three);
    assert_eq!(of_one["failed"], 0, "{of_one}");
}

/// What the memory was not enough for is no result: the search of these modes takes more than it begins with, and no chunk tells of that.
#[test]
fn a_point_without_memory_leaves_no_chunk() {
    let desk = Desk::with_case(
        r#"model = "structure"
[structure]
block = { element = "hexahedron20", size = ["200 mm", "20 mm", "10 mm"], cells = [10, 2, 1] }
material = { youngs_modulus = "210 GPa", poisson_ratio = 0.3, density = "7850 kg/m^3" }
supports = [{ set = "x-min", fixed = ["x", "y", "z"] }]
[damping]
rayleigh = { alpha = "40 1/s", beta = "4e-8 s" }
[[analysis]]
name = "modes"
kind = "eigen"
region = { re = [-2000, 2000], im = [10, 2e6] }
[[sweep]]
name = "stiff"
over = [{ key = "structure.material.youngs_modulus", from = "200 GPa", to = "220 GPa", points = 2 }]
quantities = ["modes.eigenvalues.0.frequency_hz"]
"#,
    );
    desk.succeed(&["check", "case.toml", "--memory", "64 MiB"]);
    let said = desk.judder(&["run", "case.toml", "--only", "stiff", "--memory", "64 MiB"]);
    assert_eq!(said.code, 1, "{}", said.stderr);
    said.says("of memory are needed, and 67.1 MB are to be had, as was said");
    let values = desk.path("out/case/results.zarr/stiff/values");
    let chunks = std::fs::read_dir(values).unwrap().filter(|entry| {
        let name = entry.as_ref().unwrap().file_name();
        name.to_string_lossy().starts_with("c.")
    });
    assert_eq!(chunks.count(), 0);
}

#[test]
fn parts_and_merge_say_what_is_wrong() {
    let desk = Desk::with_case(SWEEPS);
    desk.refused(&["run", "case.toml", "--shard", "4/3"], "part 4 of 3", "parts count from 1");
    desk.refused(&["run", "case.toml", "--shard", "third"], "k/N", "");
    desk.refused(&["run", "case.toml", "--shard", "1/2", "--fresh"], "--fresh", "");
    desk.refused(
        &["run", "case.toml", "--only", "maps"],
        "no analysis or sweep `maps`",
        "cycle, map, robust",
    );
    desk.write("plain.toml", "model = \"oscillator\"\n");
    desk.refused(&["merge", "plain.toml"], "no sweep to merge", "judder run");
    let told = desk.succeed(&["run", "plain.toml", "--dry-run"]).stdout;
    assert!(told.contains("no sweep"), "{told}");
}

#[test]
fn what_is_left_to_others_is_a_document() {
    let desk = Desk::with_case(SWEEPS);
    let only = ["--only", "map", "--json"];
    let part = |shard: &'static str| [&["run", "case.toml", "--shard", shard], only.as_slice()].concat();
    let sweeps = |done: u64| serde_json::json!([{ "name": "map", "chunks": 6, "chunks_done": done }]);
    let told = desk.succeed(&part("1/2")).json();
    assert_eq!(told, serde_json::json!({ "sweeps": sweeps(3) }));
    let merge = [&["merge", "case.toml"], only.as_slice()].concat();
    let said = desk.judder(&merge);
    assert_eq!(said.code, 1, "{}", said.stderr);
    let lacking = ["map: 3 of 6 chunks are missing"];
    assert_eq!(said.json(), serde_json::json!({ "sweeps": sweeps(3), "lacking": lacking }));
    said.says(&format!("a requested result is missing: {}", lacking[0]));
    assert_eq!(said.stderr.matches("`judder run` computes").count(), 1, "{}", said.stderr);

    desk.succeed(&part("2/2"));
    let whole = desk.succeed(&merge).json();
    assert!(whole["lacking"].is_null() && whole["results"]["map"]["points"] == 18, "{whole}");
    std::fs::write(desk.path("out/case/results.zarr/map/values/c.0.0.0"), "").unwrap();
    let said = desk.judder(&merge);
    assert_eq!(said.code, 1, "{}", said.stderr);
    assert_eq!(said.json()["lacking"], serde_json::json!(["map: 1 chunk is damaged"]));
}

#[test]
fn sweeps_are_held_against_the_budget_together() {
    let sweep = |name: &str| {
        format!(
            "[[sweep]]\nname = \"{name}\"\nquantities = [\"growth_rate\"]\n\
             over = [{{ key = \"operation.velocity\", from = 1e-4, to = 1.0, points = 3000000 }}]\n"
        )
    };
    let text = format!("model = \"oscillator\"\n{}", ["a", "b", "c"].map(sweep).concat());
    let message = "the 9000000 values of the keys of 3 sweeps: 216.0 MB of memory are needed";
    Desk::with_case(&text).refused(&["check", "case.toml", "--memory", "100 MiB"], message, "--memory");
}

#[test]
fn the_report_has_a_section_and_the_terminal_a_table() {
    let desk = Desk::with_case(SWEEPS);
    let said = desk.succeed(&["run", "case.toml", "--only", "map", "--only", "robust"]);
    said.says("map: 18 points, 0 failed, 0 doubtful");
    said.says("first order");
    for figure in ["map", "robust", "robust-sensitivity"] {
        assert!(desk.path(&format!("out/case/figures/{figure}.svg")).is_file(), "{figure}");
    }
    for table in ["map.csv", "robust.csv"] {
        assert!(desk.path(&format!("out/case/{table}")).is_file(), "{table}");
    }
    let page = std::fs::read_to_string(desk.path("out/case/report.html")).unwrap();
    for words in [
        "Quantities over all points",
        "Sensitivity of growth_rate",
        "2 of 3 analyses and sweeps done",
        "Not computed: cycle.",
    ] {
        assert!(page.contains(words), "{words:?} is not on the page");
    }
    let rebuilt = desk.succeed(&["report", "out/case"]);
    rebuilt.says("report: ");
    assert_eq!(std::fs::read_to_string(desk.path("out/case/report.html")).unwrap(), page);
}

#[test]
fn wall_time_has_the_sweeps() {
    let desk = Desk::with_case(
        "model = \"oscillator\"\n[[sweep]]\nname = \"speeds\"\nquantities = [\"critical_shear_strength\"]\n\
         over = [{ key = \"operation.velocity\", from = 1e-6, to = 1.0, points = 2000, scale = \"log\" }]\n",
    );
    let said = desk.succeed(&["run", "case.toml", "--json", "--progress", "json"]);
    let ends = said.stderr.lines().filter_map(|line| serde_json::from_str::<serde_json::Value>(line).ok());
    let of_sweep = ends.filter(|line| line["event"] == "end" && line["name"] == "speeds");
    let seconds: f64 = of_sweep.map(|line| line["seconds"].as_f64().unwrap()).sum();
    let wall = said.json()["wall_time_s"].as_f64().unwrap();
    assert!(seconds > 0.01 && wall >= seconds, "{seconds} s of {wall} s");
}
