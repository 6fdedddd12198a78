//! Motions that are driven: by a base that shakes, by forces, by a course of speeds, loads and friction.

use crate::{case, number, run_into};
use judder_models::parse;
use judder_store::{Dataset, StudyFolder, VariableValues};
use judder_study::case::file::CaseFile;
use serde_json::{Map, Value};
use std::f64::consts::{PI, TAU};

/// What is told of the march `name` of a case, its arrays, and its warnings.
fn marched(file: &CaseFile, name: &str) -> (Map<String, Value>, Dataset) {
    let folder = tempfile::tempdir().unwrap();
    let report = run_into(folder.path(), file, &[name]);
    assert!(report.complete, "{:?}", report.messages);
    let dataset = StudyFolder::open(folder.path()).unwrap().read_dataset(name).unwrap();
    (report.summary.results[name].clone(), dataset)
}

fn array<'a>(dataset: &'a Dataset, name: &str) -> &'a [f64] {
    match &dataset.variable(name).unwrap_or_else(|| panic!("no {name}")).data {
        VariableValues::F64(values) => values,
        _ => panic!("{name}"),
    }
}

/// J. P. Den Hartog 1931: the amplitude of a mass with dry friction that never sticks.
#[test]
fn a_mass_with_dry_friction_on_a_shaking_base_swings_as_den_hartog_says() {
    let (shaking, ratio, dry): (f64, f64, f64) = (3.0, 15.0 / 20.0, 1.0);
    let turn = (PI / ratio).sin() / (ratio * (1.0 + (PI / ratio).cos()));
    let exact = shaking / 400.0 * ((1.0 - ratio * ratio).powi(-2) - (dry / shaking * turn).powi(2)).sqrt();
    for method in ["moreau", "film"] {
        let file = case("assembly/shaken-base.toml", &[&format!("analysis.sine.method=\"{method}\"")]);
        let (told, dataset) = marched(&file, "sine");
        let (times, velocity) = (array(&dataset, "time"), array(&dataset, "mass.x.velocity"));
        // the way from one turning point to the other, of velocities at the ends of equal steps
        let last: Vec<f64> =
            times.iter().zip(velocity).filter(|(t, _)| **t > 38.0).map(|(_, v)| *v).collect();
        let step = times[1] - times[0];
        let (mut place, mut low, mut high) = (0.0_f64, 0.0_f64, 0.0_f64);
        for pair in last.windows(2) {
            place += 0.5 * step * (pair[0] + pair[1]);
            (low, high) = (low.min(place), high.max(place));
        }
        assert!((0.5 * (high - low) / exact - 1.0).abs() < 2e-3, "{method}: {} {exact}", 0.5 * (high - low));
        // what the base brings is what friction takes
        let power = &told["power"];
        assert!(
            (number(&power["excitation"]) + number(&power["friction"])).abs()
                < 1e-2 * number(&power["excitation"])
        );
        assert!(number(&told["energy_balance"]) < 1e-6);
        let base = array(&dataset, "base.1.x");
        assert!((base[100] - shaking * (15.0 * times[100]).sin()).abs() < 1e-12);
    }
}

/// On a floor at rest nothing is drawn on at the start, and the mass comes to the same swing; a force that friction can hold moves it not at all.
#[test]
fn a_floor_at_rest_holds_what_it_can() {
    let rest = "contact.floor.sliding.velocity=\"0 m/s\"";
    let force = |size: f64| {
        format!(
            "analysis.sine.forces=[{{ structure = \"block\", set = \"mass\", direction = \"x\", force = {{ amplitude = \"{size} N\", frequency = \"15 rad/s\" }} }}]"
        )
    };
    let largest = |options: &[&str]| {
        let (_, dataset) = marched(&case("assembly/shaken-base.toml", options), "sine");
        array(&dataset, "mass.x.velocity").iter().fold(0.0_f64, |most, own| most.max(own.abs()))
    };
    let still = "analysis.sine.base=[{ direction = \"x\", acceleration = { amplitude = \"0 m/s^2\", frequency = \"15 rad/s\" } }]";
    let short = ["analysis.sine.duration=\"4 s\"", "analysis.sine.transient=\"0 s\"", rest, still];
    let [held, moved] = [1.9, 2.5].map(|size| largest(&[&short[..], &[&force(size)]].concat()));
    assert!(held < 1e-9 && moved > 1e-3, "{held} {moved}");
    let [at_rest, stopped] = [&[rest][..], &[]].map(|options| {
        let (told, _) = marched(&case("assembly/shaken-base.toml", options), "sine");
        number(&told["contacts"]["floor"]["tangential_velocity_rms"][0])
    });
    assert!((at_rest / stopped - 1.0).abs() < 1e-3, "{at_rest} {stopped}");
}

/// A mass on a spring and a damper whose base shakes: seen from what does not, its acceleration is that of the base times
/// √((1 + (2 ζ r)²)/((1 − r²)² + (2 ζ r)²)) with r = Ω/ω, beside the base r²/√((1 − r²)² + (2 ζ r)²).
#[test]
fn a_shaken_mass_transmits_in_closed_form() {
    let (mass, stiffness, damping, shaking, omega): (f64, f64, f64, f64, f64) = (2.0, 800.0, 12.0, 3.0, 25.0);
    let ratio = omega / (stiffness / mass).sqrt();
    let damped = damping * omega / stiffness;
    let size = (1.0 - ratio * ratio).hypot(damped);
    let expected = [shaking * 1.0_f64.hypot(damped) / size, shaking * ratio * ratio / size];
    for method in ["moreau", "film"] {
        let text = format!(
            "model = \"assembly\"\n\n[[structure]]\nname = \"block\"\n\n[structure.matrices]\nmass = [[{mass}]]\nfreedoms = [[\"mass\", \"x\"]]\n\n\
             [[spring]]\nname = \"along\"\nfrom = {{ structure = \"block\", set = \"mass\" }}\nto = \"ground\"\ndirection = [1, 0, 0]\n\
             stiffness = \"{stiffness} N/m\"\ndamping = \"{damping} N s/m\"\n\n[observe]\npoints = [{{ name = \"mass\", structure = \"block\", set = \"mass\" }}]\n\n\
             [[analysis]]\nname = \"shaken\"\nkind = \"march\"\nmethod = \"{method}\"\nstep = \"0.1 ms\"\nduration = \"12 s\"\ntransient = \"8 s\"\nmodes = 0\n\
             base = [{{ direction = \"x\", acceleration = {{ amplitude = \"{shaking} m/s^2\", frequency = \"{omega} rad/s\" }} }}]\n"
        );
        let (_, dataset) = marched(&parse("case.toml", &text, &[]).unwrap(), "shaken");
        let times = array(&dataset, "time");
        for (name, expected) in ["mass.x.absolute", "mass.x"].into_iter().zip(expected) {
            let own = times.iter().zip(array(&dataset, name)).filter(|(time, _)| **time > 8.0);
            let largest = own.map(|(_, value)| value.abs()).fold(0.0, f64::max);
            assert!((largest / expected - 1.0).abs() < 1e-3, "{method}, {name}: {largest} {expected}");
        }
    }
}

/// The disc stops, friction ends with the temperature's factor, and the pad judders where friction falls faster than the damper takes.
#[test]
fn a_stop_from_speed_judders_at_its_end() {
    let (told, dataset) = marched(&case("assembly/stop-from-speed.toml", &[]), "stop");
    assert!(number(&told["energy_balance"]) < 1e-6);
    let times = array(&dataset, "time");
    let at = |time: f64| times.partition_point(|own| *own < time);
    let (speed, load) = (array(&dataset, "course.speed"), array(&dataset, "course.load"));
    assert!((speed[at(1.5)] - 0.5).abs() < 1e-4 && speed[at(3.1)] == 0.0);
    assert!((load[at(0.1)] - 0.5).abs() < 1e-2 && load[at(0.3)] == 1.0);
    // 20 + 230 t/3 degC: 1 at 20, 1.05 at 120, 0.8 at 300 degC, straight between them
    let (friction, normal) = (array(&dataset, "disc.friction_force"), array(&dataset, "disc.normal_force"));
    let factor = array(&dataset, "course.friction");
    for (time, expected) in [
        (120.0 / 230.0 * 3.0 - 20.0 / 230.0 * 3.0, 1.05),
        (2.0, 1.05 - 0.25 * (20.0 + 460.0 / 3.0 - 120.0) / 180.0),
    ] {
        assert!((factor[at(time)] - expected).abs() < 1e-4, "{time}");
        let slip = 50.0 / 3.6 * (1.0 - time / 3.0);
        let law = 0.35 + 0.2 * (-slip / 1.5).exp();
        let found = friction[at(time)] / normal[at(time)];
        assert!((found / (expected * law) - 1.0).abs() < 5e-3, "{time}: {found}");
    }
    let velocity = array(&dataset, "pad.x.velocity");
    let largest =
        |from: f64, to: f64| velocity[at(from)..at(to)].iter().fold(0.0_f64, |most, own| most.max(own.abs()));
    assert!(largest(2.8, 3.0) > 20.0 * largest(1.0, 2.0), "{} {}", largest(1.0, 2.0), largest(2.8, 3.0));
    assert!(largest(3.15, 3.2) < 0.05 * largest(2.8, 3.0));
}

/// A bar that is held at one end and shaken along itself far below its modes: its tip lags by ρ a L²/2E, and what is held pulls with ρ L A a. Whole, reduced,
/// and tied together of two.
#[test]
fn a_bar_is_shaken_by_all_of_its_mass() {
    let bar = |name: &str, origin: &str, reduction: &str, supports: &str| {
        format!(
            "[[structure]]\nname = \"{name}\"\nblock = {{ element = \"quad4\", size = [\"50 mm\", \"10 mm\"], cells = [8, 2], origin = [\"{origin}\", \"0 mm\"] }}\n\
             section = \"plane-stress\"\nwidth = \"10 mm\"\nmaterial = {{ youngs_modulus = \"1 GPa\", poisson_ratio = 0, density = \"2000 kg/m^3\" }}\n\
             damping = {{ rayleigh = {{ alpha = \"0 1/s\", beta = \"1e-4 s\" }} }}\n{supports}{reduction}\n"
        )
    };
    let held = "supports = [{ set = \"x-min\", fixed = [\"x\", \"y\"] }]\n";
    let tie = "[[tie]]\nname = \"weld\"\nfrom = { structure = \"right\", set = \"x-min\" }\nto = { structure = \"left\", set = \"x-max\" }\n\n";
    let (omega, shaking) = (TAU * 20.0, 5.0);
    for reduction in ["", "reduction = { count = 30 }\n"] {
        let text = format!(
            "model = \"assembly\"\n\n{}{}{tie}[observe]\npoints = [{{ name = \"tip\", structure = \"right\", set = \"x-max\" }}]\n\n\
             [[analysis]]\nname = \"shaken\"\nkind = \"march\"\nstep = \"10 us\"\nduration = \"0.2 s\"\nmodes = 0\n\
             base = [{{ direction = \"x\", acceleration = {{ amplitude = \"5 m/s^2\", frequency = \"20 Hz\" }} }}]\n",
            bar("left", "0 mm", reduction, held),
            bar("right", "50 mm", reduction, "")
        );
        let file = parse("case.toml", &text, &[]).unwrap();
        let (_, dataset) = marched(&file, "shaken");
        let (times, velocity) = (array(&dataset, "time"), array(&dataset, "tip.x.velocity"));
        // static but for (ω/ω₁)² and ω β, both below 1e-2
        let exact = 2000.0 * shaking * 0.1 * 0.1 / 2e9 * omega;
        let turned = |pick: fn(f64) -> f64| {
            let own = times.iter().zip(velocity).filter(|(time, _)| **time >= 0.1);
            let count = own.clone().count() as f64;
            own.map(|(time, value)| value * pick(omega * time)).sum::<f64>() * 2.0 / count
        };
        let (in_phase, across) = (turned(f64::cos), turned(f64::sin));
        assert!((in_phase / -exact - 1.0).abs() < 1e-2, "{reduction}: {in_phase} {exact}");
        assert!(across.abs() < 3e-2 * exact, "{reduction}: {across} {exact}");
    }
}

/// Tables in files are read with their units, and what they hold is part of what a result belongs to.
#[test]
fn files_are_read_and_known_by_what_they_hold() {
    let desk = tempfile::tempdir().unwrap();
    let path = desk.path().join("case.toml");
    let text = include_str!("../../../../cases/assembly/shaken-base.toml");
    let bodies = text.split("[[analysis]]").next().unwrap();
    let file = |name: &str, text: &str| std::fs::write(desk.path().join(name), text).unwrap();
    file("speed.csv", "time [ms];factor\n0;0\n1;0\n");
    file("base.csv", "# measured\ntime [ms],a [cm/s^2]\n0,0\n100,100\n1000,100\n");
    file("heat.csv", "time [s],T [degC]\n0,20\n0.5,120\n");
    file("friction.csv", "T [K],factor\n273.15,2\n373.15,1\n473.15,1\n");
    file("force.csv", "time [s],F [mN]\n0,500\n1,500\n");
    let analysis = "[[analysis]]\nname = \"m\"\nkind = \"march\"\nstep = \"1 ms\"\nduration = \"1 s\"\nmodes = 0\ncourse = { speed = { file = \"speed.csv\" } }\n\
        temperature = { file = \"heat.csv\" }\nfriction_over_temperature = { file = \"friction.csv\" }\n\
        base = [{ direction = \"x\", acceleration = { file = \"base.csv\", scale = 2 } }]\n\
        forces = [{ structure = \"block\", set = \"mass\", direction = \"x\", force = { file = \"force.csv\" } }]\n";
    std::fs::write(&path, format!("{bodies}{analysis}")).unwrap();
    let read = || judder_models::read(&path, &[]).unwrap();
    let mut files: Vec<String> = read().case.files().iter().map(|file| file.given.clone()).collect();
    files.sort();
    assert_eq!(files, ["base.csv", "force.csv", "friction.csv", "heat.csv", "speed.csv"]);
    let folder = tempfile::tempdir().unwrap();
    let report = run_into(folder.path(), &read(), &[]);
    assert!(report.complete && report.summary.results.contains_key("m"));
    let dataset = StudyFolder::open(folder.path()).unwrap().read_dataset("m").unwrap();
    let times = array(&dataset, "time");
    let at = |time: f64| times.partition_point(|own| *own < time - 1e-9);
    assert!((array(&dataset, "base.1.x")[at(0.05)] - 1.0).abs() < 1e-9);
    assert!(array(&dataset, "force.1.x").iter().all(|force| (force - 0.5).abs() < 1e-12));
    let factors = array(&dataset, "course.friction");
    assert!((factors[at(0.2)] - 1.4).abs() < 1e-9 && factors[at(0.8)] == 1.0);
    let before = std::fs::read_to_string(folder.path().join("summary.json")).unwrap();
    file("force.csv", "time [s],F [mN]\n0,500\n1,501\n");
    run_into(folder.path(), &read(), &[]);
    let after = std::fs::read_to_string(folder.path().join("summary.json")).unwrap();
    let hash = |summary: &str| serde_json::from_str::<Value>(summary).unwrap()["case_hash"].clone();
    assert!(hash(&before).is_string() && hash(&before) != hash(&after));
    // what files may not hold
    let refused = |name: &str, text: &str| {
        let kept = std::fs::read_to_string(desk.path().join(name)).unwrap();
        file(name, text);
        let own = read();
        let refused = own.case.preflight(&own, &|_| true).map(drop).expect_err("it is refused").to_string();
        file(name, &kept);
        refused
    };
    let short = refused("base.csv", "time [ms],a [cm/s^2]\n0,0\n100,100\n");
    assert!(
        short.contains("the samples of a signal go from 0 to 0.1 s, the motion from 0 to 1 s"),
        "{short}"
    );
    let unsorted = refused("base.csv", "time [s],a [m/s^2]\n0,0\n2,1\n1,1\n");
    assert!(unsorted.contains("a time of a table is 1: it must be above the one before"), "{unsorted}");
    let unit = refused("base.csv", "time [s],a [m/s]\n0,0\n2,1\n");
    assert!(
        unit.contains("base.csv")
            && unit.contains("`m/s` is no unit of an acceleration, as in `time [s],acceleration [m/s^2]`"),
        "{unit}"
    );
    let none = refused("heat.csv", "time,T [degC]\n0,0\n2,1\n");
    assert!(none.contains("the column of a time has no unit in brackets"), "{none}");
    let hot = refused("heat.csv", "time [s],T [degC]\n0,20\n0.5,220\n");
    assert!(hot.contains("the temperature in K is 493.15 at 0.5 s, outside of the table of factors, which goes from 273.15 to 473.15"), "{hot}");
    let number = refused("friction.csv", "T [K],factor\n273.15,x\n");
    assert!(
        number.contains("friction.csv") && number.contains("`x` in line 2 is no finite number"),
        "{number}"
    );
}

/// A course without a change, and no excitation, is the motion that it was; one that changes says of which steady sliding the modes are.
#[test]
fn what_does_not_change_leaves_the_motion_as_it_is() {
    const MOTION: &str = "duration = \"0.4 ms\"\n";
    let text = include_str!("../small/assembly.toml");
    let with = |more: &str| {
        let file = parse("case.toml", &text.replacen(MOTION, &format!("{MOTION}{more}"), 1), &[]).unwrap();
        let folder = tempfile::tempdir().unwrap();
        let report = run_into(folder.path(), &file, &["motion"]);
        let dataset = StudyFolder::open(folder.path()).unwrap().read_dataset("motion").unwrap();
        let told = report.summary.results["motion"].clone();
        (array(&dataset, "sole.normal_force").to_vec(), told, report.summary)
    };
    let (plain, _, _) = with("");
    let (one, told, _) = with("course = { load = { times = [\"0 s\"], factors = [1] } }\n");
    assert_eq!(plain, one);
    assert_eq!(number(&told["power"]["excitation"]), 0.0);
    let (rising, told, summary) =
        with("course = { load = { times = [\"0 s\", \"0.4 ms\"], factors = [0.8, 1.2] } }\n");
    assert_ne!(plain, rising);
    assert!(number(&told["energy_balance"]) < 1e-6 && told["power"].get("excitation").is_some());
    assert!(
        format!("{summary:?}")
            .contains("the modes in the motion are those about steady sliding with the case's own values")
    );
}

/// What a course leaves as it is, and what a step does not see, is told.
#[test]
fn what_a_driven_motion_does_not_follow_is_told() {
    let desk = tempfile::tempdir().unwrap();
    let path = desk.path().join("case.toml");
    std::fs::write(desk.path().join("base.csv"), "time [s],a [m/s^2]\n0,0\n1e-6,1\n0.01,0\n").unwrap();
    let text = "model = \"assembly\"\n\n[[structure]]\nname = \"disc\"\ndisc = { radii = [\"70 mm\", \"88 mm\"], thickness = \"20 mm\", cells = [1, 12, 1] }\n\
        material = { youngs_modulus = \"210 GPa\", poisson_ratio = 0.3, density = \"7850 kg/m^3\" }\nsupports = [{ set = \"r-min\", fixed = [\"x\", \"y\", \"z\"] }]\n\
        rotation = { speed = \"100 rpm\", frame = \"fixed\" }\n\n[[analysis]]\nname = \"m\"\nkind = \"march\"\nstep = \"10 us\"\nduration = \"10 ms\"\nmodes = 1\n\
        course = { speed = { times = [\"0 s\", \"10 ms\"], factors = [1, 0] } }\nbase = [{ direction = \"z\", acceleration = { file = \"base.csv\" } }]\n";
    std::fs::write(&path, text).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let report = run_into(folder.path(), &judder_models::read(&path, &[]).unwrap(), &[]);
    let told = format!("{:?}", report.summary);
    for expected in [
        "the modes in the motion are those about steady sliding with the case's own values",
        "the speed of sliding changes over time, but what turning does to `disc` stays that of its full speed",
        "samples of the acceleration of the base along z lie 1e-6 s apart, closer than the steps",
    ] {
        assert!(told.contains(expected), "{expected}: {told}");
    }
}
