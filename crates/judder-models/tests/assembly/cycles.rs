//! Limit cycles of assemblies: against marches, stored over a period, and told where there is none.

use crate::{case, number, run_into};
use judder_report::{Axis, Scale};
use judder_store::{StudyFolder, VariableValues};
use judder_study::Silent;
use judder_study::case::file::CaseFile;
use judder_study::run::{RunOptions, RunReport, run};
use serde_json::Value;
use std::path::Path;

const BLOCK: &str = "assembly/cycle-of-a-block.toml";

fn alone(file: &CaseFile, name: &str) -> RunReport {
    run_into(tempfile::tempdir().unwrap().path(), file, &[name])
}

fn numbers(list: &Value) -> Vec<f64> {
    list.as_array().unwrap().iter().map(number).collect()
}

pub(super) fn array(dataset: &judder_store::Dataset, name: &str) -> Vec<f64> {
    match &dataset.variable(name).unwrap_or_else(|| panic!("no {name}")).data {
        VariableValues::F64(values) => values.clone(),
        _ => panic!("{name}"),
    }
}

/// The march knows nothing of periods.
#[test]
fn the_cycle_of_a_block_is_what_its_march_settles_to() {
    let report = run_into(tempfile::tempdir().unwrap().path(), &case(BLOCK, &[]), &["cycle", "motion"]);
    assert!(report.complete, "{:?}", report.messages);
    let [cycle, motion] = ["cycle", "motion"].map(|name| &report.summary.results[name]);
    let close = |key: &str, within: f64| {
        let [own, other] = [cycle, motion].map(|told| number(&told[key]));
        assert!((own / other - 1.0).abs() < within, "{key}: {own} {other}");
    };
    close("frequency_hz", 1e-4);
    close("normal_force_mean", 1e-3);
    close("friction_force_mean", 2e-3);
    for (key, within) in [("friction", 5e-3), ("damping", 2e-3), ("drive", 2e-3)] {
        let [own, other] = [cycle, motion].map(|told| number(&told["power"][key]));
        assert!((own / other - 1.0).abs() < within, "{key}: {own} {other}");
    }
    for (key, within) in [("tangential_velocity_rms", 3e-3), ("normal_force_mean", 3e-3)] {
        let [own, other] = [cycle, motion].map(|told| numbers(&told["contacts"]["sole"][key]));
        assert!(own.len() == 9 && own.iter().zip(&other).all(|(a, b)| (a / b - 1.0).abs() < within), "{key}");
    }
    assert_eq!(
        cycle["tangential_velocity_rms"]["sole"],
        cycle["contacts"]["sole"]["tangential_velocity_rms"]
    );
    assert!(cycle["converged"] == true && cycle["attracts"] == true && cycle["stable"] == true);
    assert!(number(&cycle["left_out"]) <= 0.01 && number(&cycle["energy_balance"]) < 1e-4);
}

/// One harmonic leaves more of the forces out than a tenth: a cycle is found, but it has not converged, wherever it is told.
#[test]
fn a_cycle_of_too_few_harmonics_has_not_converged() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/small/assembly-cycle.toml");
    let few = ["cycle", "less-friction"].map(|name| format!("analysis.{name}.harmonics=1"));
    let file = judder_models::read(path, &few).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let report = run_into(folder.path(), &file, &["cycle"]);
    let told = &report.summary.results["cycle"];
    assert!(number(&told["left_out"]) > 0.1 && told["converged"] == false, "{told:?}");
    let reason = told["reason"].as_str().unwrap();
    assert!(reason.contains("leave") && report.messages.iter().any(|own| own.contains(reason)), "{reason}");
    assert!(!report.complete && number(&told["frequency_hz"]) > 0.0);
    let page = std::fs::read_to_string(folder.path().join("report.html")).unwrap();
    assert!(page.contains("<td>converged</td>"));
    let report = alone(&file, "less-friction");
    let told = &report.summary.results["less-friction"];
    let converged = told["converged"].as_array().unwrap();
    assert!(
        converged.len() == numbers(&told["value"]).len() && converged.contains(&false.into()),
        "{told:?}"
    );
    let said = "cycles have not converged: the harmonics leave";
    assert!(
        !report.complete && report.messages.iter().any(|own| own.contains(said)),
        "{:?}",
        report.messages
    );
    let text = std::fs::read_to_string(path).unwrap();
    let bare: String = text
        .lines()
        .filter(|line| !["margin", "knocks", "cures"].iter().any(|own| line.starts_with(own)))
        .map(|line| format!("{line}\n"))
        .collect();
    let file = judder_models::parse("case.toml", &bare, &["analysis.squeal.harmonics=1".to_owned()]).unwrap();
    let report = alone(&file, "squeal");
    let modes = report.summary.results["squeal"]["modes"].as_array().unwrap();
    assert!(!report.complete && modes.iter().any(|mode| mode["converged"] == false), "{modes:?}");
}

/// Arrays of one period say what the summary says.
#[test]
fn a_period_is_stored_as_it_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/small/assembly-cycle.toml");
    let file = judder_models::read(path, &[]).unwrap();
    let report = run_into(folder.path(), &file, &["cycle"]);
    let told = &report.summary.results["cycle"];
    let dataset = StudyFolder::open(folder.path()).unwrap().read_dataset("cycle").unwrap();
    let mean_square = |values: &[f64]| values.iter().map(|own| own * own).sum::<f64>() / values.len() as f64;
    let [displacement, velocity, acceleration] =
        [".displacement", ".velocity", ""].map(|what| array(&dataset, &format!("edge.x{what}")));
    let rms = mean_square(&acceleration).sqrt();
    assert!((rms / number(&told["levels"]["edge.x"]["acceleration_rms"]) - 1.0).abs() < 1e-9);
    // 1 µm/s² is 0 dB
    let level = 20.0 * (rms / 1e-6).log10();
    assert!((level - number(&told["levels"]["edge.x"]["level_db"])).abs() < 1e-9);
    let step = 1.0 / (number(&told["frequency_hz"]) * velocity.len() as f64);
    let differs = |values: &[f64], rates: &[f64]| {
        let next = |k: usize| (k + 2) % values.len();
        let off = (0..values.len())
            .map(|k| (values[next(k)] - values[k]) / (2.0 * step) - rates[(k + 1) % rates.len()]);
        (off.map(|own| own * own).sum::<f64>() / values.len() as f64 / mean_square(rates)).sqrt()
    };
    assert!(differs(&displacement, &velocity) < 5e-3 && differs(&velocity, &acceleration) < 5e-3);
    assert!(differs(&array(&dataset, "edge.y.velocity"), &array(&dataset, "edge.y")) < 5e-3);
    // N of the contact is that of its points together, and on average what is told
    let [contact, points] = ["sole.normal_force", "point_normal_force"].map(|name| array(&dataset, name));
    for (sum, own) in contact.iter().zip(points.chunks_exact(5)) {
        assert!((sum - own.iter().sum::<f64>()).abs() < 1e-9 * sum.abs().max(1.0));
    }
    let mean = contact.iter().sum::<f64>() / contact.len() as f64;
    assert!((mean / number(&told["normal_force_mean"]) - 1.0).abs() < 1e-3);
    // one multiplier is that of the phase
    let off = |own: &Value| (number(&own[0]) - 1.0).hypot(number(&own[1]));
    let multipliers = told["floquet_multipliers"].as_array().unwrap();
    let nearest = multipliers.iter().map(off).fold(1.0, f64::min);
    assert!(multipliers.len() == 10 && nearest <= 1.0001 * number(&told["floquet_error"]), "{multipliers:?}");
    assert!(told["stability"] == "stable" && told["stable"] == true);
    // heard as it is
    assert!(folder.path().join("cycle-edge.y.wav").exists() && told["sound"].as_array().unwrap().len() == 2);
    // small motions swing as the mode does, but for the growth that is taken off
    let (frequency, growth) = (array(&dataset, "frequency"), array(&dataset, "growth_rate"));
    assert!(array(&dataset, "amplitude").len() == frequency.len());
    assert!((frequency[0] / number(&told["mode_frequency_hz"]) - 1.0).abs() < 1e-3);
    assert!((growth[0] / number(&told["mode_growth_rate"]) - 1.0).abs() < 1e-3);
}

/// A mode that decays, one that is not followed far enough, one that is not there.
#[test]
fn no_cycle_is_told_with_the_reason() {
    let decays = alone(&case(BLOCK, &["analysis.cycle.frequency=\"27.7 kHz\""]), "cycle");
    let told = &decays.summary.results["cycle"];
    assert!(told["converged"] == false && number(&told["mode_growth_rate"]) < 0.0, "{told:?}");
    assert!(told["frequency_hz"].is_null() && told["contacts"].is_null());
    assert!(
        told["reason"].as_str().unwrap().starts_with(
            "motions of the mode decay, with 7 harmonics (no cycle with 3 either), at every amplitude"
        ),
        "{told:?}"
    );

    let near = alone(&case(BLOCK, &["analysis.cycle.largest_amplitude=1.2"]), "cycle");
    let told = &near.summary.results["cycle"];
    assert_eq!(
        told["reason"],
        "motions of the mode grow, with 7 harmonics (no cycle with 3 either), at every amplitude up to 1.2 times that at which the contact first changes its state"
    );
    assert!(!near.complete && told["converged"] == false);
    assert!(near.messages.iter().any(|own| own.contains("no limit cycle: motions of the mode grow")));
}

/// Ranks are of levels and of growth rates, the mode that grows fastest has the cycle that `limit-cycle` finds, and a study is the same on one thread.
#[test]
fn modes_are_ranked_by_their_cycles() {
    let block = |set: &[&str]| {
        let text =
            std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/").to_owned() + BLOCK);
        let more = "\n[[analysis]]\nname = \"squeal\"\nkind = \"squeal\"\nband = [\"1 kHz\", \"60 kHz\"]\n";
        let set: Vec<String> = set.iter().map(|own| (*own).to_owned()).collect();
        judder_models::parse("case.toml", &(text.unwrap() + more), &set).unwrap()
    };
    let friction = "contact.sole.friction_coefficient=0.4";
    let report = run_into(tempfile::tempdir().unwrap().path(), &block(&[friction]), &["cycle", "squeal"]);
    let [cycle, squeal] = ["cycle", "squeal"].map(|name| &report.summary.results[name]);
    assert!(squeal["unstable"] == 2 && squeal["found"] == 2 && squeal["complete"] == true);
    let modes = squeal["modes"].as_array().unwrap();
    let fastest = modes.iter().find(|mode| mode["rank_by_growth"] == 1).unwrap();
    let same = |a: &Value, b: &Value| (number(a) / number(b) - 1.0).abs() < 1e-9;
    assert!(same(&fastest["frequency_hz"], &cycle["frequency_hz"]));
    assert!(same(&fastest["levels"]["edge.y"], &cycle["levels"]["edge.y"]["level_db"]));
    let place = |mode: &Value| mode["rank_by_level"].as_u64().unwrap();
    let louder = |own: &&Value| number(&own["level_db"]);
    // cycles that motions leave are not heard, and stand behind
    let heard = modes.iter().filter(|mode| mode["stable"] != false);
    match heard.max_by(|a, b| louder(a).total_cmp(&louder(b))) {
        Some(loudest) => assert!(place(loudest) == 1 && loudest["level_db"] == squeal["level_db"]),
        None => assert!(squeal["level_db"].is_null(), "{squeal:?}"),
    }
    let alone = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    let again =
        alone.install(|| run_into(tempfile::tempdir().unwrap().path(), &block(&[friction]), &["squeal"]));
    assert_eq!(&again.summary.results["squeal"], squeal);
    // no mode grows without friction: an answer
    let quiet = run_into(
        tempfile::tempdir().unwrap().path(),
        &block(&["contact.sole.friction_coefficient=0.05"]),
        &["squeal"],
    );
    assert!(quiet.complete && quiet.summary.results["squeal"]["unstable"] == 0, "{:?}", quiet.messages);
}

/// With less friction the cycle shrinks to steady sliding, where an eigenvalue begins to grow; with more it goes on to the end of the range.
#[test]
fn cycles_along_a_key_shrink_to_steady_sliding_at_the_onset() {
    let folder = tempfile::tempdir().unwrap();
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/small/assembly-cycle.toml");
    let file = judder_models::read(path, &[]).unwrap();
    let report = run_into(folder.path(), &file, &["less-friction"]);
    assert!(report.complete, "{:?}", report.messages);
    let told = &report.summary.results["less-friction"];
    let [value, frequency, rms] = ["value", "frequency_hz", "rms"].map(|key| numbers(&told[key]));
    assert_eq!(told["ends"].as_array().unwrap().len(), 2);
    assert!(
        told["ends"][0] == "shrinks to steady sliding" && told["ends"][1] == "leaves the range",
        "{told:?}"
    );
    let hopf = number(&told["hopf_points"][0]);
    assert!(
        (value[0] - hopf).abs() < 1e-9 && value.windows(2).all(|pair| pair[1] >= pair[0] - 1e-9),
        "{value:?}"
    );
    assert!(rms[0] < 0.05 * rms[rms.len() - 1], "{rms:?}");
    assert!(told["stable"].as_array().unwrap().iter().all(Value::is_null));
    // nothing failed: the eigenvalue there is that of what shrinks
    assert!(report.messages.is_empty(), "{:?}", report.messages);
    // the cycle at the friction of the case is that of `limit-cycle`
    let cycle = run_into(tempfile::tempdir().unwrap().path(), &file, &["cycle"]);
    let own = number(&cycle.summary.results["cycle"]["frequency_hz"]);
    let beside = value.iter().position(|own| *own > 0.4).unwrap();
    let share = (0.4 - value[beside - 1]) / (value[beside] - value[beside - 1]);
    let between = frequency[beside - 1] + share * (frequency[beside] - frequency[beside - 1]);
    assert!((between / own - 1.0).abs() < 2e-3, "{between} {own}");
}

/// With a slower plane the cycle becomes smaller, and nothing else: no onset is there.
#[test]
fn a_cycle_that_shrinks_with_the_speed_tells_no_onset() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/small/assembly-cycle.toml");
    let sweep =
        "{ key = \"contact.sole.sliding.velocity\", from = \"10 mm/s\", to = \"2 m/s\", points = 10 }";
    let file = judder_models::read(path, &[format!("analysis.less-friction.sweep={sweep}")]).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let report = run_into(folder.path(), &file, &["less-friction"]);
    let told = &report.summary.results["less-friction"];
    assert!(numbers(&told["hopf_points"]).is_empty(), "{told:?}");
    let axes = across(&file, folder.path());
    assert!(axes.iter().all(|own| matches!(own.scale, Scale::Linear)));
    // values are told in SI units, and shown as the case has them
    assert!(
        told["unit"] == "m/s"
            && told["shown_unit"] == "mm/s"
            && numbers(&told["value"]).iter().all(|own| *own <= 2.0)
    );
    assert!(axes.iter().all(|own| own.label == "contact.sole.sliding.velocity (mm/s)"), "{axes:?}");
    assert!(report.messages.iter().all(|own| !own.contains("velocity = 0.")), "{:?}", report.messages);
    assert_eq!(told["ends"][0], "shrinks below 2 % of its largest amplitude");
    assert!(report.messages.iter().any(|own| own.contains("no eigenvalue begins to grow there")));
}

/// The axes of the key in the figure of a branch.
fn across(file: &CaseFile, folder: &Path) -> Vec<Axis> {
    let dataset = StudyFolder::open(folder).unwrap().read_dataset("less-friction").unwrap();
    let model = judder_models::REGISTRY.model_of(&file.case.resolved()).unwrap();
    let figure = model.figure("less-friction", "", &dataset).unwrap().unwrap();
    figure.panels.into_iter().map(|panel| panel.x).collect()
}

/// A key whose values lie evenly in its logarithm is drawn so.
#[test]
fn a_branch_along_a_logarithmic_key_is_drawn_over_its_logarithm() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/small/assembly-cycle.toml");
    let set = ["scale=\"log\"", "points=2"].map(|own| format!("analysis.less-friction.sweep.{own}"));
    let file =
        judder_models::read(path, &[&set[..], &["analysis.less-friction.cycles=2".to_owned()]].concat())
            .unwrap();
    let folder = tempfile::tempdir().unwrap();
    run_into(folder.path(), &file, &["less-friction"]);
    let axes = across(&file, folder.path());
    assert!(axes.len() == 2 && axes.iter().all(|own| matches!(own.scale, Scale::Log)), "{axes:?}");
}

/// A march that comes back says the same as harmonics, and what is told is its.
#[test]
fn shooting_agrees_with_harmonics() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/small/assembly-cycle.toml");
    let [own, shot] = ["harmonic-balance", "shooting"].map(|method| {
        let set = [format!("analysis.cycle.method=\"{method}\"")];
        let file = judder_models::read(path, &set).unwrap();
        let report = run_into(tempfile::tempdir().unwrap().path(), &file, &["cycle"]);
        assert!(report.complete && report.messages.is_empty(), "{:?}", report.messages);
        report.summary.results["cycle"].clone()
    });
    assert!(own.get("shooting").is_none());
    let told = &shot["shooting"];
    assert!(number(&told["residual"]) <= 1e-7 && told["steps"] == 2048, "{told:?}");
    assert_eq!(told["harmonics_frequency_hz"], own["frequency_hz"]);
    assert_eq!(told["frequency_hz"], shot["frequency_hz"]);
    // one is that of the phase, the next is the same within what either says
    let [by_harmonics, along_it] = [&own["floquet_error"], &told["floquet_error"]].map(number);
    let both = [&own["floquet_multipliers"], &told["floquet_multipliers"]];
    assert!((number(&both[1][0][0]) - 1.0).abs() <= along_it + 1e-9 && along_it < by_harmonics, "{both:?}");
    for part in [0, 1] {
        let [a, b] = both.map(|all| number(&all[1][part]));
        assert!((a - b).abs() < by_harmonics + along_it, "{both:?}");
    }
    for (key, within) in [("frequency_hz", 1e-4), ("normal_force_mean", 3e-3), ("friction_force_mean", 1e-2)]
    {
        let [a, b] = [&own, &shot].map(|told| number(&told[key]));
        assert!(a != b && (a / b - 1.0).abs() < within, "{key}: {a} {b}");
    }
}

/// The plate of the lumped brake by a table of its force: 201 places of k d + k₃ d³ leave the slope at steady sliding off by k₃ h² = 4e-4 of k.
#[test]
fn a_tabulated_spring_swings_as_the_one_that_was_tabulated() {
    let run = |name: &str, only: &[&str]| {
        let report = run_into(tempfile::tempdir().unwrap().path(), &case(name, &[]), only);
        assert!(report.complete, "{:?}", report.messages);
        serde_json::to_value(&report.summary.results).unwrap()
    };
    let cubic = run("assembly/lumped-brake.toml", &["modes", "cycle"]);
    let table = run("assembly/tabulated-spring.toml", &["modes", "cycle", "motion"]);
    let [own, other] = [&table, &cubic].map(|of| number(&of["cycle"]["frequency_hz"]));
    assert!((own / other - 1.0).abs() < 1e-3, "{own} {other}");
    let swing = |of: &Value| numbers(&of["contacts"]["stiffening"]["tangential_velocity_rms"])[0];
    let [own, other] = [&table, &cubic].map(|of| swing(&of["cycle"]));
    assert!((own / other - 1.0).abs() < 2e-2, "{own} {other}");
    let [march, cycle] = ["motion", "cycle"].map(|name| swing(&table[name]));
    assert!((march / cycle - 1.0).abs() < 1e-2, "{march} {cycle}");
    for part in ["re", "im"] {
        let [own, other] = [&table, &cubic].map(|of| number(&of["modes"]["eigenvalues"][0][part]));
        assert!((own - other).abs() < 0.5, "{part}: {own} {other}");
    }
}

/// Where contact is smooth two ways say it; where points stick, that steps alone do is told.
#[test]
fn stability_has_a_second_opinion() {
    let report =
        run_into(tempfile::tempdir().unwrap().path(), &case("assembly/lumped-brake.toml", &[]), &["cycle"]);
    let told = &report.summary.results["cycle"];
    assert!(told["stable"] == true && told["second_opinion"] == "Hill's method says the same", "{told:?}");
    // steps are off by their scheme
    let [apart, hill, steps] =
        ["multipliers_apart", "hill_error", "floquet_error"].map(|key| number(&told[key]));
    assert!(apart < steps && hill < 1e-6 && steps < 1e-2, "{apart} {hill} {steps}");
    assert_eq!(
        told["hill_multipliers"].as_array().unwrap().len(),
        told["floquet_multipliers"].as_array().unwrap().len()
    );
    let brake = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/assembly/lumped-brake.toml");
    let squeal = "[[analysis]]\nname = \"squeal\"\nkind = \"squeal\"\nband = [\"50 Hz\", \"150 Hz\"]\n";
    let text = format!("{}\n{squeal}", std::fs::read_to_string(brake).unwrap());
    let file = judder_models::parse("case.toml", &text, &[]).unwrap();
    let report = run_into(tempfile::tempdir().unwrap().path(), &file, &["squeal"]);
    let mode = &report.summary.results["squeal"]["modes"][0];
    for key in ["stable", "stability", "second_opinion"] {
        assert_eq!(mode[key], told[key], "{key}");
    }
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/small/assembly-cycle.toml");
    let file = judder_models::read(path, &[]).unwrap();
    let report = run_into(tempfile::tempdir().unwrap().path(), &file, &["cycle"]);
    let told = &report.summary.results["cycle"];
    assert_eq!(told["stable"], true);
    assert_eq!(
        told["second_opinion"],
        "steps alone: contact point 1 sticks, turns, or is rigid: its force does not follow smoothly from its motion"
    );
    assert!(told["hill_multipliers"].is_null() && told["multipliers_apart"].is_null());
}

/// Where the mode grows nowhere there is nothing to begin with.
#[test]
fn a_key_along_which_nothing_grows_says_so() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/small/assembly-cycle.toml");
    let sets = ["analysis.less-friction.sweep.to=0.001", "analysis.less-friction.sweep.from=0.0005"];
    let file = judder_models::read(path, &sets.map(ToOwned::to_owned)).unwrap();
    let report = run_into(tempfile::tempdir().unwrap().path(), &file, &["less-friction"]);
    assert!(!report.complete && numbers(&report.summary.results["less-friction"]["value"]).is_empty());
    assert!(
        report.messages.iter().any(|own| own.contains("no limit cycle was found to begin with")),
        "{:?}",
        report.messages
    );
    assert!(
        report.messages.iter().any(|own| own.contains("the mode does not grow")),
        "{:?}",
        report.messages
    );
}

const BELT: &str = "assembly/mass-on-falling-belt.toml";

/// The belt with an analysis in place of its own, at a speed of the belt.
fn on_belt(speed: &str, analysis: &str) -> RunReport {
    let text = std::fs::read_to_string(format!("{}/../../cases/{BELT}", env!("CARGO_MANIFEST_DIR"))).unwrap();
    let bodies = text.split("[[analysis]]").next().unwrap().replace("1.2 m/s", speed);
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("belt.toml");
    std::fs::write(&path, format!("{bodies}[[analysis]]\nname = \"own\"\n{analysis}")).unwrap();
    alone(&judder_models::read(path.to_str().unwrap(), &[]).unwrap(), "own")
}

const FROM_MARCH: &str = "start = { march = { step = \"10 ms\", duration = \"1000 s\", start = { mode = 1, amplitude = \"1 m\" } } }";

/// Above 1.0397 m/s the mass slides steadily, and yet a march that begins far enough comes to a cycle, as below it.
#[test]
fn a_march_leads_to_cycles_that_no_mode_leads_to() {
    for (speed, grows) in [("1.2 m/s", false), ("0.9 m/s", true)] {
        let report = on_belt(speed, &format!("kind = \"limit-cycle\"\nharmonics = 25\n{FROM_MARCH}"));
        let told = &report.summary.results["own"];
        assert!(told["converged"] == true && told["stable"] == true, "{:?}", report.messages);
        assert_eq!(number(&told["mode_growth_rate"]) > 0.0, grows);
        assert!(told["attracts"].is_null() && told["amplitude"].is_null());
    }
    let report = on_belt("1.7 m/s", &format!("kind = \"limit-cycle\"\n{FROM_MARCH}"));
    assert!(!report.complete);
    assert_eq!(report.summary.results["own"]["reason"], "the march settles to steady sliding");
}

/// From the march the branch goes through its fold and shrinks to its Hopf point, c = N Δμ/v₀ exp(−v/v₀).
#[test]
fn a_branch_that_begins_at_a_march_goes_through_its_fold_to_its_hopf_point() {
    let sweep = "sweep = { key = \"contact.belt.sliding.velocity\", from = \"0.7 m/s\", to = \"1.6 m/s\", points = 19 }";
    let report = on_belt(
        "1.2 m/s",
        &format!("kind = \"bifurcation\"\n{sweep}\nharmonics = 25\nstability = false\n{FROM_MARCH}"),
    );
    let told = &report.summary.results["own"];
    // as it is known from a Runge–Kutta method
    assert!((number(&told["folds"][0]) - 1.5562).abs() < 2e-3, "{told:?}");
    assert!((number(&told["hopf_points"][0]) - 0.5 * 8.0_f64.ln()).abs() < 2e-4, "{told:?}");
    let fold = told["bifurcations"].as_array().unwrap().iter().find(|own| own["kind"] == "fold").unwrap();
    let (off, error) = ((number(&fold["value"]) - 1.5562).abs(), number(&fold["error"]));
    println!("fold off by {off:.1e}, said to be off by at most {error:.1e}");
    assert!(off < error && error < 0.02, "{fold:?}");
}

/// What a reduction leaves is known before its modes are computed: from what is kept and how many modes are asked for.
#[test]
fn reductions_that_keep_too_many_freedoms_are_refused_before_they_are_made() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/small/assembly-cycle.toml");
    let foot =
        ["block.cells=[40, 20]", "reduction={ count = 1300 }"].map(|own| format!("structure.foot.{own}"));
    let file = judder_models::read(path, &foot).unwrap();
    let error = run(&file, tempfile::tempdir().unwrap().path(), &RunOptions::default(), &Silent).unwrap_err();
    let (told, of) = (
        error.to_string(),
        "periodic motions are computed of up to 1200; reduce the bodies: the reduction of `foot` keeps",
    );
    assert!(told.contains(of), "{told}");
}
