//! Analyses of motion end to end: the literature's belt, the oscillator paper's section 5, what is kept of an interruption.

mod si;

use crate::{case, number, run_into};
use judder_study::case::file::CaseFile;
use judder_study::run::{RunOptions, run};
use judder_study::{Progress, Silent, StudyError};
use serde_json::Value;
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};

const BELT: &str = "benchmarks/belt.toml";

fn parsed(text: &str) -> CaseFile {
    judder_models::parse("case.toml", text, &[]).unwrap()
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|v| v.as_f64().unwrap_or(f64::NAN)).collect()
}

fn words(value: &Value) -> Vec<&str> {
    value.as_array().unwrap().iter().map(|v| v.as_str().unwrap()).collect()
}

/// The comment of the case: 0.3165 ± 0.0150.
#[test]
fn the_basin_of_the_belts_fixed_point() {
    let folder = tempfile::tempdir().unwrap();
    let report = run_into(folder.path(), &case(BELT, &[]), &["basin"]);
    assert!(report.complete && report.messages.is_empty(), "{:?}", report.messages);
    let basin = &report.summary.results["basin"];
    let (fraction, interval) = (number(&basin["fraction"]), numbers(&basin["interval"]));
    assert!((fraction - 0.3165).abs() < 0.0150, "{fraction}");
    assert!(interval[0] < fraction && fraction < interval[1] && interval[1] - interval[0] < 0.014);
    assert!(folder.path().join("figures/basin.svg").exists());
}

/// The belt of the literature in SI, all lengths a thousandth: the same cycle, over 1/ω = 0.1 s and in m.
#[test]
fn a_belt_in_si_has_the_cycle_of_one_in_its_own_units() {
    let results = |name: &str, only: &[&str]| {
        let folder = tempfile::tempdir().unwrap();
        let report = run_into(folder.path(), &case(name, &[]), only);
        assert!(report.complete, "{:?}", report.messages);
        report.summary.results
    };
    let (own, si) = (results(BELT, &["cycle"]), results("benchmarks/belt-in-si.toml", &["cycle"]));
    for (key, factor) in [("period", 1.0), ("rms", 1e-3), ("mean", 1e-3), ("stick_fraction", 1.0)] {
        let [own, si] = [&own, &si].map(|results| number(&results["cycle"][key]));
        assert!((si / (factor * own) - 1.0).abs() < 1e-7, "{key}: {si} {own}");
    }
    // x is in m, and a unit of time is 0.1 s
    let told = |key: &str| number(&si["cycle"][key]);
    assert_eq!((told("rms_m"), told("mean_m")), (told("rms"), told("mean")));
    assert!((told("period_s") / (0.1 * told("period")) - 1.0).abs() < 1e-12);
    assert!((told("frequency_hz") * told("period_s") - 1.0).abs() < 1e-12);
}

/// Its motion is drawn in µm and mm/s, and the 10 s after the transient are heard, 3 bytes a sample at 48 kHz.
#[test]
fn a_belt_in_si_is_drawn_in_si_and_heard() {
    let folder = tempfile::tempdir().unwrap();
    let file = case("benchmarks/belt-in-si.toml", &["analysis.motion.sound=true"]);
    let report = run_into(folder.path(), &file, &["motion", "diagram"]);
    assert!(report.complete, "{:?}", report.messages);
    assert_eq!(report.summary.results["motion"]["sound"][0]["file"], "motion-velocity_x.wav");
    let bytes = std::fs::read(folder.path().join("motion-velocity_x.wav")).unwrap();
    let seconds = bytes.len() as f64 / (3.0 * 48e3);
    assert!(bytes.starts_with(b"RIFF") && (9.9..10.1).contains(&seconds), "{seconds}");
    let table = std::fs::read_to_string(folder.path().join("motion.csv")).unwrap();
    assert!(
        table.starts_with("time,x,velocity_x,") && table.lines().next().unwrap().contains("velocity_x [m/s]")
    );
    let page = std::fs::read_to_string(folder.path().join("report.html")).unwrap();
    for shown in ["Frequency (Hz)", "(mm/s)", "rms (mm)", "rms of "] {
        assert!(page.contains(shown), "{shown}");
    }
}

/// A damper of 0 N s/m is none, which the canonical form says too.
#[test]
fn a_belt_in_si_without_a_damper_stays_one() {
    let undamped = |name: &str| case(name, &["oscillator.damping=\"0 N s/m\""]).case.resolved();
    let resolved = undamped("benchmarks/belt-in-si.toml");
    assert_eq!(resolved["oscillator"]["damping"]["value"], 0.0);
    assert_eq!(case(BELT, &[]).case.resolved()["oscillator"].get("mass"), None);
}

/// Closed form: steady sliding loses stability at 0.5 ln 10 = 1.1513; the case's comment: the cycle exists up to 1.83660.
#[test]
fn the_belts_diagram_has_its_jumps_at_the_fold_and_at_the_hopf_point() {
    let folder = tempfile::tempdir().unwrap();
    let report = run_into(folder.path(), &case(BELT, &[]), &["diagram"]);
    let diagram = &report.summary.results["diagram"];
    let (values, rms) = (numbers(&diagram["value"]), numbers(&diagram["rms"]));
    let (directions, becomes) = (words(&diagram["direction"]), words(&diagram["becomes"]));
    assert_eq!((values.len(), directions[0], directions[121]), (122, "forward", "backward"));
    for k in 0..122 {
        // a step of the sweep may fall off the cycle a little before its end
        if directions[k] == "forward" && (1.81..1.83660).contains(&values[k]) {
            continue;
        }
        let cycle = match directions[k] {
            "forward" => values[k] < 1.83660,
            _ => values[k] < 0.5 * 10.0_f64.ln(),
        };
        assert_eq!(becomes[k] != "steady sliding", cycle, "{} {}", directions[k], values[k]);
        assert_eq!(rms[k] > 0.0, cycle);
        // in a plane no motion is irregular: near the threshold it has only not settled
        assert!(becomes[k] != "irregular", "{} {}", directions[k], values[k]);
    }
    assert!(report.complete && folder.path().join("figures/diagram.svg").exists());
}

/// The same, by continuation: the unstable branch from the Hopf point to the fold, and the stable one back.
#[test]
fn the_belts_branches_lead_from_the_hopf_point_to_the_fold_and_back() {
    let folder = tempfile::tempdir().unwrap();
    let report = run_into(folder.path(), &case(BELT, &[]), &["diagram"]);
    assert!(report.messages.is_empty(), "{:?}", report.messages);
    let diagram = &report.summary.results["diagram"];
    let hopf = diagram["hopf_points"].as_array().unwrap();
    assert_eq!((hopf.len(), &hopf[0]["criticality"]), (1, &Value::from("subcritical")));
    assert!((number(&hopf[0]["value"]) - 0.5 * 10.0_f64.ln()).abs() < 1e-9);
    // averaging: Re c₁ = (3/2) · (1/6) μ‴(v), with μ‴ = 4 e^(−2v) and e^(−2v) = 1/10
    assert!((number(&hopf[0]["lyapunov_coefficient"]) - 0.1).abs() < 1e-6);
    let branches = diagram["branches"].as_array().unwrap();
    assert_eq!(branches.len(), 1);
    let branch = &branches[0];
    let (values, rms) = (numbers(&branch["value"]), numbers(&branch["rms"]));
    assert_eq!((values[0], rms[0]), (number(&hopf[0]["value"]), 0.0));
    let folds = numbers(&branch["folds"]);
    assert!(folds.len() == 1 && (folds[0] - 1.836_601).abs() < 1e-5, "{folds:?}");
    let stable: Vec<bool> =
        branch["stable"].as_array().unwrap().iter().map(|s| s.as_bool().unwrap()).collect();
    let turn = stable.iter().position(|stable| *stable).unwrap();
    assert!(turn > 10 && stable[turn..].iter().all(|stable| *stable));
    assert!(values[..turn].is_sorted() && values[turn..].is_sorted_by(|a, b| a >= b));
    assert!(values.last().unwrap() < &0.5 && branch["end"] == "leaves the range");
    let change = &branch["pattern_changes"][0];
    assert_eq!((words(&change["from"]), words(&change["to"])), (vec!["slip"], vec!["slip", "stick"]));
    // the simulated cycles lie on the stable part
    let (simulated, of_motions) = (numbers(&diagram["value"]), numbers(&diagram["rms"]));
    for (value, rms_of_motion) in simulated.iter().zip(&of_motions).filter(|(_, rms)| **rms > 0.1) {
        let k = (turn..values.len() - 1).find(|k| values[k + 1] <= *value && *value <= values[*k]);
        let Some(k) = k else { continue };
        let share = (value - values[k]) / (values[k + 1] - values[k]);
        let on_branch = rms[k] + share * (rms[k + 1] - rms[k]);
        assert!((on_branch / rms_of_motion - 1.0).abs() < 5e-3, "{value} {on_branch} {rms_of_motion}");
    }
}

/// Supercritical: simulations and the branch from the Hopf point are the same cycles.
#[test]
fn the_oscillators_branch_is_what_simulation_finds() {
    let text = "model = \"oscillator\"\n[contact]\nfriction_load = \"contact-force\"\n[operation]\nvelocity = 4e-4\n\
                normal_load = 7.5e-4\n[[analysis]]\nname = \"diagram\"\nkind = \"bifurcation\"\nbranches = true\n\
                direction = \"forward\"\nduration = 20000\n\
                sweep = { key = \"contact.shear_strength\", from = 1.95e-3, to = 2.05e-3, points = 5 }";
    let folder = tempfile::tempdir().unwrap();
    let report = run_into(folder.path(), &parsed(text), &[]);
    // the paper's own speeds: its contact is not in step with the motion, and that is all there is to say
    let others = report.messages.iter().filter(|message| !message.contains("eq. (3)")).count();
    assert!(report.complete && others == 0, "{:?}", report.messages);
    let diagram = &report.summary.results["diagram"];
    assert_eq!(diagram["hopf_points"][0]["criticality"], "supercritical");
    assert!((number(&diagram["hopf_points"][0]["value"]) - 1.983_134_6e-3).abs() < 1e-9);
    assert_eq!(words(&diagram["becomes"])[..2], ["steady sliding"; 2]);
    assert!(words(&diagram["becomes"])[2..].iter().all(|becomes| *becomes == "cycle"));
    let branch = &diagram["branches"][0];
    assert!(branch["stable"].as_array().unwrap().iter().any(|stable| stable == true));
    assert!(numbers(&branch["value"]).iter().all(|value| *value >= 1.983e-3));
}

#[test]
fn the_belts_cycle_and_its_motion_agree() {
    let folder = tempfile::tempdir().unwrap();
    let report = run_into(folder.path(), &case(BELT, &[]), &["cycle", "motion"]);
    assert!(report.complete && report.messages.is_empty(), "{:?}", report.messages);
    let (cycle, motion) = (&report.summary.results["cycle"], &report.summary.results["motion"]);
    assert!((number(&cycle["period"]) / number(&motion["period"]) - 1.0).abs() < 1e-7);
    assert!(motion["repeats"] == true && cycle["stable"] == true);
    assert_eq!(words(&cycle["pattern"]), ["slip", "stick"]);
    // stick forgets how fast the mass was: one multiplier is the trivial one, the other is zero
    let multipliers = cycle["floquet_multipliers"].as_array().unwrap();
    assert_eq!(numbers(&multipliers[0]), [1.0, 0.0]);
    assert!(numbers(&multipliers[1])[0].abs() < 1e-8);
    for name in ["friction", "normal", "damping", "change", "residual"] {
        assert!(cycle["energy"][name].is_f64(), "{name}");
    }
    for figure in ["cycle", "motion"] {
        assert!(folder.path().join(format!("figures/{figure}.svg")).exists());
    }
}

/// Our notes on the paper: a stable cycle of period about 133 with the normal load.
#[test]
fn the_cycle_of_section_5() {
    let text = "model = \"oscillator\"\n[contact]\nshear_strength = 0.03\n[operation]\nvelocity = 4e-4\nnormal_load = 7.5e-4\n\
                [[analysis]]\nkind = \"limit-cycle\"\n[[analysis]]\nkind = \"motion\"\nduration = 1000\npoints = 2001";
    let folder = tempfile::tempdir().unwrap();
    let report = run_into(folder.path(), &parsed(text), &[]);
    assert!(report.complete && report.messages.is_empty(), "{:?}", report.messages);
    let (cycle, motion) = (&report.summary.results["limit-cycle"], &report.summary.results["motion"]);
    assert!((number(&cycle["period"]) - 133.0).abs() < 1.0 && cycle["stable"] == true, "{cycle:?}");
    assert_eq!(cycle["floquet_multipliers"].as_array().unwrap().len(), 4);
    assert!(number(&cycle["residual"]) < 1e-8);
    for result in [cycle, motion] {
        assert!(number(&result["stick_fraction"]) > 0.97 && number(&result["lift_off_fraction"]) < 0.01);
    }
    // (2π/133 − ṽ_d/A_x) τ̃ with ṽ_d = 5e-3, τ̃ = 0.4 and A_x = 0.32 or so
    let condition = number(&cycle["quasi_steady"]["largest"]);
    assert!((condition - 0.4 * (std::f64::consts::TAU / 133.0 - 5e-3 / 0.32)).abs() < 5e-3, "{condition}");
    assert_eq!(number(&motion["quasi_steady"]["above_0.1"]), 0.0);
}

const SECTION_5: &str = "model = \"oscillator\"\n[contact]\nshear_strength = 0.03\n[operation]\nvelocity = 4e-4\nnormal_load = 7.5e-4\n";

/// Our notes on the paper: a smoothed sign of ε = 0.1 v_d is 5–11 % off in rms.
#[test]
fn two_other_engines_come_to_the_cycle_of_section_5() {
    let text = format!(
        "{SECTION_5}[[analysis]]\nkind = \"engines\"\ntime_step = {{ from = 1e-3, to = 4e-3, points = 3 }}\n\
         width = {{ from = 1e-4, to = 1e-3, points = 3 }}"
    );
    let folder = tempfile::tempdir().unwrap();
    let report = run_into(folder.path(), &parsed(&text), &[]);
    assert!(report.complete && report.messages.is_empty(), "{:?}", report.messages);
    let engines = &report.summary.results["engines"];
    assert!((number(&engines["period"]) - 132.855_768).abs() < 1e-5);
    for engine in ["time_stepping", "smoothed"] {
        assert!((number(&engines[engine]["order"]) - 1.0).abs() < 0.2, "{engines:?}");
        assert!(number(&engines[engine]["extrapolated"]).abs() < 1e-5, "{engines:?}");
    }
    let typical = &engines["typical"];
    assert_eq!((number(&typical["width"]), typical["becomes"].as_str()), (0.1, Some("cycle")));
    assert!((-0.11..-0.05).contains(&number(&typical["rms_error"])), "{typical}");
    assert!(folder.path().join("figures/engines.svg").exists());
    let table = std::fs::read_to_string(folder.path().join("engines.csv")).unwrap();
    assert_eq!(table.lines().count(), 7);
}

#[test]
fn no_other_engine_is_asked_to_stay_on_an_unstable_cycle() {
    let text =
        format!("{SECTION_5}[[analysis]]\nkind = \"engines\"\nduration = 5000\n").replace("0.03", "0.05");
    let folder = tempfile::tempdir().unwrap();
    let report = run_into(folder.path(), &parsed(&text), &[]);
    assert!(!report.complete);
    let message =
        "engines: the cycle of period 205.0937 is unstable, with a Floquet multiplier of magnitude 1.214";
    assert!(report.messages.iter().any(|m| m.starts_with(message)), "{:?}", report.messages);
}

#[test]
fn a_motion_that_cannot_be_followed_says_when_and_where() {
    let text = "model = \"belt\"\n[[analysis]]\nkind = \"motion\"\nstart = { x = 1.0, velocity_x = 1.0 }\nsteps = 60\n\
                [[analysis]]\nkind = \"basin\"\nwithin = { x = [-1, 1] }\nsamples = 20\nsteps = 60";
    let folder = tempfile::tempdir().unwrap();
    let report = run_into(folder.path(), &parsed(text), &[]);
    assert!(!report.complete);
    let message = report.messages.iter().find(|m| m.starts_with("motion: ")).unwrap();
    assert!(
        message.contains("has used its 60 steps at time ") && message.contains("at the state ["),
        "{message}"
    );
    // an ensemble marks what is lost, and goes on
    assert_eq!(report.summary.results["basin"]["fates"]["lost"], 20);
    assert!(
        report.messages.iter().any(|m| m.starts_with("basin: 20 of 20 motions")),
        "{:?}",
        report.messages
    );
}

#[test]
fn an_oscillator_may_start_in_the_air() {
    let text = "model = \"oscillator\"\n[operation]\nvelocity = 4e-4\nnormal_load = 7.5e-4\n[[analysis]]\nkind = \"motion\"\n\
                start = { y = -0.01, velocity_y = -0.01 }\nduration = 20\ntransient = 0\npoints = 101";
    let folder = tempfile::tempdir().unwrap();
    let report = run_into(folder.path(), &parsed(text), &[]);
    assert!(report.complete, "{:?}", report.messages);
    assert!(number(&report.summary.results["motion"]["lift_off_fraction"]) > 0.01);
    let table = std::fs::read_to_string(folder.path().join("motion.csv")).unwrap();
    assert!(table.lines().nth(1).unwrap().ends_with("lift-off"), "{table}");
}

/// Asks to stop after so many steps.
struct Impatient {
    done: AtomicUsize,
    most: usize,
}

impl Progress for Impatient {
    fn begin(&self, _name: &str, _steps: usize) {}
    fn expect(&self, _steps: usize) {}
    fn advance(&self) {
        self.done.fetch_add(1, Ordering::Relaxed);
    }
    fn end(&self) {}
    fn interrupted(&self) -> bool {
        self.done.load(Ordering::Relaxed) >= self.most
    }
}

fn small_basin() -> CaseFile {
    let text = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases").join(BELT))
        .unwrap();
    parsed(&text.replace("samples = 20000", "samples = 300"))
}

#[test]
fn a_basin_and_a_diagram_go_on_where_they_were_interrupted() {
    let file = small_basin();
    for (name, most) in [("basin", 100), ("diagram", 10)] {
        let options = RunOptions { only: vec![name.to_owned()], fresh: false, ..RunOptions::default() };
        let interrupted = tempfile::tempdir().unwrap();
        let impatient = Impatient { done: AtomicUsize::new(0), most };
        let error = run(&file, interrupted.path(), &options, &impatient).unwrap_err();
        assert!(matches!(error, StudyError::Interrupted));
        let kept = std::fs::read_to_string(interrupted.path().join(format!(".scratch-of-{name}"))).unwrap();
        assert!(kept.lines().count() >= most, "{kept}");
        let resumed = run(&file, interrupted.path(), &options, &Silent).unwrap();
        let at_once = tempfile::tempdir().unwrap();
        let whole = run(&file, at_once.path(), &options, &Silent).unwrap();
        assert_eq!(resumed.summary.results, whole.summary.results);
        let table = |folder: &Path| std::fs::read_to_string(folder.join(format!("{name}.csv"))).unwrap();
        assert_eq!(table(interrupted.path()), table(at_once.path()));
    }
}

#[test]
fn one_long_motion_can_be_interrupted() {
    let text = "model = \"belt\"\n[operation]\nvelocity = 1.0\n\
                [[analysis]]\nkind = \"motion\"\nduration = 1e9\nsteps = 1_000_000_000\n";
    let folder = tempfile::tempdir().unwrap();
    let impatient = Impatient { done: AtomicUsize::new(0), most: 0 };
    let error = run(&parsed(text), folder.path(), &RunOptions::default(), &impatient).unwrap_err();
    assert!(matches!(error, StudyError::Interrupted));
}

#[test]
fn ensembles_do_not_depend_on_the_number_of_threads() {
    let text = "model = \"belt\"\n[operation]\nvelocity = 1.5\n\
                [[analysis]]\nkind = \"basin\"\nwithin = { x = [-2, 2], velocity_x = [0, 2] }\nsamples = 100\n\
                [[analysis]]\nkind = \"bifurcation\"\nsweep = { key = \"friction.at_rest\", from = 0.6, to = 1.2, points = 8 }";
    let tables = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let folder = tempfile::tempdir().unwrap();
        pool.install(|| run_into(folder.path(), &parsed(text), &[]));
        ["basin.csv", "bifurcation.csv"]
            .map(|name| std::fs::read_to_string(folder.path().join(name)).unwrap())
    };
    assert_eq!(tables(1), tables(3));
}

/// Weakly damped steady sliding at v̂ = 1e-2, F̃_n = 1e-4, where steps of 1e-6 leave a noise that repeats itself. The eigenvalues of the
/// linear motion, and motions at 1e-11, decay.
#[test]
fn the_noise_of_loose_steps_is_no_cycle() {
    let text = "model = \"oscillator\"\n[contact]\nfriction_load = \"contact-force\"\n[operation]\nvelocity = 1e-2\n\
                normal_load = 1e-4\n[[analysis]]\nname = \"diagram\"\nkind = \"bifurcation\"\n\
                sweep = { key = \"contact.shear_strength\", from = 6e-3, to = 6.8e-3, points = 5 }";
    let folder = tempfile::tempdir().unwrap();
    let report = run_into(folder.path(), &parsed(text), &[]);
    assert!(report.complete && report.messages.is_empty(), "{:?}", report.messages);
    let diagram = &report.summary.results["diagram"];
    assert_eq!(words(&diagram["becomes"]), ["steady sliding"; 10]);
}

/// A wiper lip with short sticks: cycles of one oscillation of period 5.09 and 5.08, which steps of 1e-6 show as irregular and as one of
/// three oscillations. What the default tolerance tells must be what one of 1e-10 tells.
#[test]
fn the_kinds_of_a_wipers_motion_do_not_depend_on_the_tolerance() {
    let folder = tempfile::tempdir().unwrap();
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/motion/wiper/dma.csv");
    std::fs::copy(data, folder.path().join("dma.csv")).unwrap();
    let substrate = "[substrate]\ndma = { file = \"dma.csv\" }\npoisson_ratio = 0.49\ntemperature = \"25 degC\"\n\
                     shift = { wlf = { c1 = 12.0, c2 = \"120 K\", reference_temperature = \"25 degC\" } }\n\
                     [indenter]\nradius = \"0.3 mm\"\n";
    let law = "[[analysis]]\nname = \"law\"\nkind = \"contact-law\"\naccuracy = 3e-2\n\
               velocity = { from = \"1e-9 m/s\", to = \"1000 m/s\", points = 61 }\n\
               indentation = { from = \"0.1 um\", to = \"30 um\", points = 7 }\n";
    let speeds = "[contact]\nlaw = { file = \"law/law.json\" }\nfriction_load = \"contact-force\"\nshear_strength = \"200 kPa\"\n\
                  [oscillator]\nnatural_frequency = \"60 Hz\"\nstiffness_x = \"200 N/m\"\ndamping_x = 0.02\ndamping_y = 0.02\n\
                  [operation]\nvelocity = \"3 mm/s\"\nnormal_load = \"10 mN\"\n\
                  [[analysis]]\nname = \"speeds\"\nkind = \"bifurcation\"\n\
                  sweep = { key = \"operation.velocity\", from = \"0.5 mm/s\", to = \"50 mm/s\", points = 15, scale = \"log\" }\n";
    let run_case = |name: &str, text: String| {
        let path = folder.path().join(format!("{name}.toml"));
        std::fs::write(&path, text).unwrap();
        run_into(&folder.path().join(name), &judder_models::read(path, &[]).unwrap(), &[]).summary
    };
    run_case("law", format!("model = \"contact\"\n{substrate}{law}"));
    let [loose, fine] = ["", "tolerance = 1e-10\n"].map(|tolerance| {
        let name = if tolerance.is_empty() { "loose" } else { "fine" };
        let summary = run_case(name, format!("model = \"oscillator\"\n{substrate}{speeds}{tolerance}"));
        summary.results["speeds"].clone()
    });
    assert_eq!(words(&loose["becomes"]), words(&fine["becomes"]));
    let (periods, exact) = (numbers(&loose["period"]), numbers(&fine["period"]));
    for (k, (period, exact)) in periods.iter().zip(&exact).enumerate() {
        let is_same = (period - exact).abs() <= 1e-3 * exact;
        assert!(is_same || (period.is_nan() && exact.is_nan()), "{k}: {period} {exact}");
    }
    assert_eq!(words(&loose["becomes"])[4], "cycle");
    assert!((periods[4] - 5.0933).abs() < 1e-3 && (periods[5] - 5.0806).abs() < 1e-3, "{periods:?}");
}

/// A slow spiral is near to itself after seven oscillations, and beside it a period has doubled: each cycle is on one branch, once. Walked
/// twice or seven times it has the same rms and the same time an oscillation.
#[test]
fn every_cycle_is_on_one_branch() {
    let text = "model = \"oscillator\"\n[operation]\nvelocity = 1e-4\nnormal_load = 1e-6\n[[analysis]]\nname = \"diagram\"\n\
                kind = \"bifurcation\"\nbranches = true\n\
                sweep = { key = \"contact.shear_strength\", from = 0.01414213562373095, to = 0.02, points = 6, scale = \"log\" }";
    let folder = tempfile::tempdir().unwrap();
    let diagram = run_into(folder.path(), &parsed(text), &[]).summary.results["diagram"].clone();
    assert!((numbers(&diagram["period"])[1] - 4.531_578).abs() < 1e-4, "{}", diagram["period"]);
    let branches: Vec<[Vec<f64>; 3]> =
        diagram["branches"].as_array().unwrap().iter().map(of_one_oscillation).collect();
    let most = |wanted: &Value| {
        diagram["branches"].as_array().unwrap().iter().filter(|b| b["oscillations"] == *wanted).count()
    };
    assert!(most(&1.into()) >= 1 && most(&2.into()) == 1, "{}", branches.len());
    for (k, branch) in branches.iter().enumerate() {
        for (other, others) in branches.iter().enumerate().filter(|(other, _)| *other != k) {
            let shared =
                (0..branch[0].len()).filter(|i| passes(others, branch.each_ref().map(|of| of[*i]))).count();
            assert_eq!(shared, 0, "{k} {other} of {}", branch[0].len());
        }
    }
}

/// Value, rms and the time of an oscillation of every cycle of a branch.
fn of_one_oscillation(branch: &Value) -> [Vec<f64>; 3] {
    let oscillations = branch["oscillations"].as_f64().unwrap();
    let times = numbers(&branch["period"]).iter().map(|period| period / oscillations).collect();
    [numbers(&branch["value"]), numbers(&branch["rms"]), times]
}

/// Whether a branch has a cycle like this one between two of its own.
fn passes(branch: &[Vec<f64>; 3], [value, rms, time]: [f64; 3]) -> bool {
    (1..branch[0].len()).any(|i| {
        let share = (value - branch[0][i - 1]) / (branch[0][i] - branch[0][i - 1]);
        let at = |of: &[f64]| of[i - 1] + share * (of[i] - of[i - 1]);
        (0.0..=1.0).contains(&share)
            && (at(&branch[1]) / rms - 1.0).abs() < 1e-4
            && (at(&branch[2]) / time - 1.0).abs() < 1e-4
    })
}
