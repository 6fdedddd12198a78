//! Results for whoever moves a slider: analyses in no folder, in stages, watched, given up; laws that stay.

#![allow(clippy::panic, reason = "a test fails by panicking")]

use crate::computed_law::law_in;
use judder_models::law_cache::{LawCache, law_surface};
use judder_models::oscillator::case::OscillatorCase;
use judder_models::oscillator::keys::OscillatorKey;
use judder_models::oscillator::{BoundaryKind, boundary_curves};
use judder_models::sweep::StabilityMapAnalysis;
use judder_models::{ModelError, bridge, point};
use judder_store::{Dataset, VariableValues};
use judder_study::analyses::{self, run_watched};
use judder_study::case::file::CaseFile;
use judder_study::model::SampleBlock;
use judder_study::{Progress, Silent, StudyError};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::SystemTime;

fn parsed(text: &str) -> CaseFile {
    judder_models::parse("case.toml", text, &[]).unwrap()
}

fn oscillator(text: &str) -> OscillatorCase {
    parsed(text).case.of::<OscillatorCase>().unwrap().clone()
}

fn floats<'a>(dataset: &'a Dataset, name: &str) -> &'a [f64] {
    let VariableValues::F64(values) = &dataset.variable(name).unwrap().data else { panic!("{name}") };
    values
}

fn bits(values: &[f64]) -> Vec<u64> {
    values.iter().map(|value| value.to_bits()).collect()
}

/// Lets an analysis ask so many times, then says stop; counts what is asked after that.
struct Impatient {
    patience: usize,
    asked: AtomicUsize,
}

impl Impatient {
    fn after(patience: usize) -> Self {
        Self { patience, asked: AtomicUsize::new(0) }
    }

    fn asked_in_vain(&self) -> usize {
        self.asked.load(Ordering::Relaxed).saturating_sub(self.patience)
    }
}

impl Progress for Impatient {
    fn begin(&self, _name: &str, _steps: usize) {}
    fn expect(&self, _steps: usize) {}
    fn advance(&self) {}
    fn end(&self) {}
    fn interrupted(&self) -> bool {
        self.asked.fetch_add(1, Ordering::Relaxed) >= self.patience
    }
}

const MAP: &str = r#"
    model = "oscillator"
    operation = { normal_load = 1e-6 }
    [[analysis]]
    name = "map"
    kind = "stability-map"
    x = { key = "operation.velocity", from = 1e-8, to = 1e2, points = 61, scale = "log" }
    y = { key = "contact.shear_strength", from = 1e-4, to = 1.0, points = 51, scale = "log" }
"#;

#[test]
fn boundaries_one_by_one_are_the_overlays_of_the_map() {
    let file = parsed(MAP);
    let outcome = analyses::run(&file, 0, &Silent).unwrap();
    let case = file.case.of::<OscillatorCase>().unwrap();
    let settings = case.analyses[0].settings::<StabilityMapAnalysis<OscillatorKey>>().unwrap();
    let contact = bridge::contact_of(case, &Silent).unwrap().contact;
    for kind in BoundaryKind::ALL {
        let curves = boundary_curves(kind, case, &contact, settings).unwrap();
        for (name, values) in
            [("velocity", &curves.x), ("shear_strength", &curves.y), ("frequency", &curves.frequency)]
        {
            let stored = floats(&outcome.dataset, &format!("{}_boundary_{name}", kind.name()));
            assert_eq!(bits(stored), bits(values), "{} {name}", kind.name());
        }
        assert!(curves.x.len() > 100 && curves.x.last().unwrap().is_nan());
    }
}

#[test]
fn nothing_is_without_the_coupling_that_is_swept() {
    let case = oscillator(&MAP.replace(
        "operation.velocity\", from = 1e-8, to = 1e2",
        "oscillator.coupling\", from = 0.1, to = 1.0",
    ));
    let settings = case.analyses[0].settings::<StabilityMapAnalysis<OscillatorKey>>().unwrap();
    let contact = bridge::contact_of(&case, &Silent).unwrap().contact;
    assert_eq!(boundary_curves(BoundaryKind::Decoupled, &case, &contact, settings), None);
}

const STICK_SLIP: &str = r#"
    model = "oscillator"
    contact = { shear_strength = 0.03 }
    operation = { velocity = 4e-4, normal_load = 7.5e-4 }
    [[analysis]]
    kind = "motion"
    duration = 2000
    transient = 300
    points = 9001
"#;

const BELT: &str = r#"
    model = "belt"
    oscillator = { damping = 0.05 }
    friction = { at_rest = 1.0, at_speed = 0.5, decay_speed = 0.5 }
    operation = { velocity = 1.0, normal_force = 1.0 }
    [[analysis]]
    kind = "motion"
    start = { x = 1.0, velocity_x = 1.5 }
    duration = 2000
    points = 9001
"#;

#[test]
fn a_watched_motion_is_the_motion() {
    for (text, names) in
        [(STICK_SLIP, &["x", "y", "velocity_x", "velocity_y"][..]), (BELT, &["x", "velocity_x"])]
    {
        let file = parsed(text);
        let alone = analyses::run(&file, 0, &Silent).unwrap();
        let mut blocks: Vec<SampleBlock> = Vec::new();
        let watched = run_watched(&file, 0, &Silent, &mut |block| blocks.push(block)).unwrap();
        assert_eq!(alone.scalars, watched.scalars);
        assert!(blocks.len() >= 3 && blocks.iter().all(|block| (1..=4096).contains(&block.time.len())));
        let times: Vec<f64> = blocks.iter().flat_map(|block| block.time.iter().copied()).collect();
        assert_eq!(bits(&times), bits(floats(&alone.dataset, "time")));
        for (k, name) in names.iter().enumerate() {
            let values = blocks.iter().flat_map(|block| {
                assert_eq!(block.numbers[k].0, *name);
                block.numbers[k].1.iter().copied()
            });
            let values: Vec<f64> = values.collect();
            assert_eq!(bits(&values), bits(floats(&alone.dataset, name)));
            assert_eq!(bits(&values), bits(floats(&watched.dataset, name)));
        }
        let states: Vec<u8> = blocks.iter().flat_map(|block| block.classes.iter().copied()).collect();
        assert_eq!(VariableValues::U8(states), alone.dataset.variable("contact_state").unwrap().data);
    }
}

/// One small analysis of every kind that an oscillator case has.
const OSCILLATOR_KINDS: [&str; 10] = [
    "kind = \"equivalent-damping\"\nsweep = { key = \"operation.velocity\", from = 1e-6, to = 1.0, points = 5, scale = \"log\" }",
    "kind = \"spectrum\"\nsweep = { key = \"operation.velocity\", from = 1e-6, to = 1.0, points = 5, scale = \"log\" }",
    "kind = \"critical-shear-strength\"\nsweep = { key = \"operation.velocity\", from = 1e-2, to = 1.0, points = 2, scale = \"log\" }\nglobal_margin = false",
    "kind = \"critical-load\"\nsweep = { key = \"operation.velocity\", from = 1e-6, to = 1.0, points = 5, scale = \"log\" }\nglobal_margin = false",
    "kind = \"stability-map\"\nx = { key = \"operation.velocity\", from = 1e-6, to = 1.0, points = 20, scale = \"log\" }\ny = { key = \"contact.shear_strength\", from = 1e-4, to = 1.0, points = 20, scale = \"log\" }",
    "kind = \"motion\"\nduration = 200\npoints = 101",
    "kind = \"limit-cycle\"",
    "kind = \"bifurcation\"\nsweep = { key = \"contact.shear_strength\", from = 2.9e-2, to = 3e-2, points = 2 }",
    "kind = \"basin\"\nwithin = { x = [0.0, 0.1] }\nsamples = 3\nseed = 1",
    "kind = \"engines\"\ntime_step = { from = 1e-2, to = 1e-1, points = 3 }\nwidth = { from = 1e-1, to = 1.0, points = 3 }",
];

/// One small analysis of every kind that a contact case has.
const CONTACT_KINDS: [&str; 5] = [
    "kind = \"contact\"\nvelocity = 1e-1\nindentation = 1e-2\naccuracy = 3e-2",
    "kind = \"modulus\"",
    "kind = \"contact-law\"\nvelocity = { from = 1e-2, to = 1e-1, points = 3 }\nindentation = { from = 1e-3, to = 1e-2, points = 3 }\naccuracy = 5e-2",
    "kind = \"fit\"\nvelocity = { from = 1e-3, to = 1e3, points = 12 }\nindentation = { from = 1e-3, to = 1e-2, points = 4 }\naccuracy = 5e-2",
    "kind = \"transient\"\nmotion = \"start\"\nvelocity = 0.1\nindentation = 1e-2\nduration = 0.2\ncells = 32",
];

fn with_analysis(head: &str, analysis: &str) -> CaseFile {
    parsed(&format!("{head}\n[[analysis]]\nname = \"view\"\n{analysis}\n"))
}

const OSCILLATOR: &str = "model = \"oscillator\"\ncontact = { shear_strength = 0.03 }\noperation = { velocity = 4e-4, normal_load = 7.5e-4 }";
const CONTACT: &str = "model = \"contact\"";

#[test]
fn every_kind_runs_in_memory() {
    let all = OSCILLATOR_KINDS.map(|kind| (OSCILLATOR, kind));
    for (head, kind) in all.into_iter().chain(CONTACT_KINDS.map(|kind| (CONTACT, kind))) {
        let file = with_analysis(head, kind);
        let outcome = analyses::run(&file, 0, &Silent).unwrap_or_else(|error| panic!("{kind}: {error}"));
        assert!(!outcome.dataset.variables().is_empty() && !outcome.is_stored, "{kind}");
        assert!(!outcome.scalars.is_empty(), "{kind}");
    }
}

/// Each of these would take hours.
#[test]
fn long_analyses_end_when_they_are_given_up() {
    let endless = [
        "kind = \"motion\"\nduration = 1e9\nsteps = 1000000000\npoints = 100",
        "kind = \"bifurcation\"\nsweep = { key = \"contact.shear_strength\", from = 1e-4, to = 5e-2, points = 100000 }",
        "kind = \"basin\"\nwithin = { x = [0.0, 0.1] }\nsamples = 1000000\nseed = 1",
        "kind = \"critical-load\"\nsweep = { key = \"operation.velocity\", from = 1e-6, to = 1.0, points = 100000 }",
        "kind = \"engines\"\ntime_step = { from = 1e-7, to = 1e-1, points = 50 }\nwidth = { from = 1e-9, to = 1.0, points = 50 }",
    ];
    let of_contact = [
        "kind = \"contact\"\nvelocity = 1e-1\nindentation = 1e-2\naccuracy = 1e-6\ncells = 1024",
        "kind = \"contact-law\"\nvelocity = { from = 1e-3, to = 1e3, points = 200 }\nindentation = { from = 1e-4, to = 1e-1, points = 200 }\naccuracy = 1e-3",
        "kind = \"fit\"\nvelocity = { from = 1e-4, to = 1e4, points = 40 }\nindentation = { from = 1e-4, to = 1e-1, points = 40 }\naccuracy = 1e-3",
        "kind = \"transient\"\nmotion = \"start\"\nvelocity = 0.1\nindentation = 1e-2\nduration = 4000\ncells = 64",
    ];
    // substrates of their own: a law that another test has computed would be known
    let contact = "model = \"contact\"\nsubstrate = { glassy_modulus = \"9.1 MPa\" }";
    let rough = "model = \"contact\"\nsubstrate = { retardation_time = \"1 ms\" }\nindenter = { radius = \"1 mm\", shape = { rough = { period = \"1 mm\", cells = 256, hurst = 0.8, roll_off = \"0.5 mm\", rms_height = \"5 um\", seed = 1 } } }";
    let rough = (rough, "kind = \"contact\"\nvelocity = \"10 mm/s\"\nload = \"20 mN\"\naccuracy = 1e-6", 3);
    let law = "model = \"oscillator\"\nsubstrate = { glassy_modulus = \"9.2 MPa\" }\ncontact = { law = { computed = true, accuracy = 1e-4 } }";
    let all = endless.map(|kind| (OSCILLATOR, kind, 50)).into_iter();
    let all = all
        .chain(of_contact.map(|kind| (contact, kind, 3)))
        .chain([rough, (law, "kind = \"limit-cycle\"", 3)]);
    for (head, kind, patience) in all {
        let file = with_analysis(head, kind);
        let impatient = Impatient::after(patience);
        let ended = analyses::run(&file, 0, &impatient);
        let reason = ended.err().map(|error| error.to_string());
        assert_eq!(reason, Some(StudyError::Interrupted.to_string()), "{kind}");
        // a thread asks once or twice more, and some work is shared out before it is asked for
        assert!((1..400).contains(&impatient.asked_in_vain()), "{kind}: {}", impatient.asked_in_vain());
    }
}

#[test]
fn a_limit_cycle_is_given_up_at_once() {
    let file = with_analysis(OSCILLATOR, "kind = \"limit-cycle\"");
    let impatient = Impatient::after(50);
    assert!(matches!(analyses::run(&file, 0, &impatient), Err(StudyError::Interrupted)));
    assert!(impatient.asked_in_vain() < 10);
    let mut shown = 0;
    let file = parsed(STICK_SLIP);
    let ended = run_watched(&file, 0, &Impatient::after(50), &mut |_| shown += 1);
    assert!(matches!(ended, Err(StudyError::Interrupted)) && shown == 0);
}

#[test]
fn what_was_read_stays_while_the_system_tells_of_no_change() {
    let folder = tempfile::tempdir().unwrap();
    law_in(folder.path());
    let law = folder.path().join("law.json");
    let read = || {
        let text = "model = \"oscillator\"\ncontact = { law = { file = \"law.json\" } }\noperation = { velocity = 2e-2, normal_load = 1e-2 }";
        let name = folder.path().join("case.toml");
        judder_models::parse(name.to_str().unwrap(), text, &[])
            .unwrap()
            .case
            .of::<OscillatorCase>()
            .unwrap()
            .clone()
    };
    let cache = LawCache::new();
    let case = read();
    let direct = bridge::contact_of(&case, &Silent).unwrap();
    let ready = cache.ready(&case, &Silent).unwrap();
    assert_eq!((&ready.contact.contact, &ready.contact.warnings), (&direct.contact, &direct.warnings));
    assert_eq!(ready.point().unwrap().json(), point::point(&case).unwrap().json());
    // rubbish of the same length and date: nobody looks inside
    let date = std::fs::metadata(&law).unwrap().modified().unwrap();
    let length = std::fs::read(&law).unwrap().len();
    std::fs::write(&law, vec![b'x'; length]).unwrap();
    std::fs::File::options().write(true).open(&law).unwrap().set_modified(date).unwrap();
    assert_eq!(cache.ready(&case, &Silent).unwrap().contact.contact, direct.contact);
    std::fs::File::options().write(true).open(&law).unwrap().set_modified(SystemTime::UNIX_EPOCH).unwrap();
    assert!(matches!(cache.ready(&case, &Silent), Err(ModelError::Study(StudyError::File { .. }))));
}

#[test]
fn a_computed_law_serves_a_drag_of_other_keys() {
    let text = |velocity: f64, glassy: f64| {
        oscillator(&format!(
            "model = \"oscillator\"\nsubstrate = {{ glassy_modulus = \"{glassy} MPa\" }}\n\
             contact = {{ law = {{ computed = true, accuracy = 0.05 }} }}\noperation = {{ velocity = {velocity} }}"
        ))
    };
    let cache = LawCache::new();
    let first = cache.ready(&text(1e-4, 6.7), &Silent).unwrap();
    // who may ask nothing may still have what is known
    let never = Impatient::after(0);
    for velocity in [1e-5, 1e-3, 1e-1] {
        let case = text(velocity, 6.7);
        let ready = cache.ready(&case, &never).unwrap();
        assert_eq!(ready.contact.contact, first.contact.contact);
        assert_eq!(ready.case.inputs, case.inputs);
    }
    assert!(matches!(cache.ready(&text(1e-4, 6.8), &never), Err(ModelError::Interrupted)));
}

#[test]
fn a_cache_knows_one_case_from_another() {
    let cache = LawCache::new();
    let laws = ["oscillator-paper", "oscillator-paper-corrected", "hertz"];
    for _ in 0..3 {
        for law in laws {
            for (contrast, load) in [(5, "normal-load"), (10, "normal-load"), (10, "contact-force")] {
                let case = oscillator(&format!(
                    "model = \"oscillator\"\nsubstrate = {{ glassy_modulus = \"{contrast} MPa\" }}\ncontact = {{ law = \"{law}\", friction_load = \"{load}\" }}"
                ));
                let (ready, direct) =
                    (cache.ready(&case, &Silent).unwrap(), bridge::contact_of(&case, &Silent).unwrap());
                assert_eq!(ready.contact.contact, direct.contact);
                assert_eq!(ready.contact.warnings, direct.warnings);
            }
        }
    }
}

#[test]
fn a_law_over_speeds_and_depths_is_the_law_at_each() {
    let contact = bridge::contact_of(&oscillator("model = \"oscillator\""), &Silent).unwrap().contact;
    let (velocities, depths) = ([1e-6, 1e-3, 1e-1, f64::NAN], [1e-5, 1e-2, -1.0]);
    let surface = law_surface(&contact, &velocities, &depths);
    for (row, depth) in depths.iter().enumerate() {
        for (column, velocity) in velocities.iter().enumerate() {
            let at = row * velocities.len() + column;
            let found = [surface.force[at], surface.area[at], surface.friction[at]];
            if *depth < 0.0 || velocity.is_nan() {
                assert!(found.iter().all(|value| value.is_nan()));
                continue;
            }
            let point = judder_contact::LawPoint::new(*velocity, *depth);
            let response = judder_contact::ContactLaw::evaluate(&contact.law, &point);
            assert_eq!(found, [response.force.value, response.area.value, response.friction.value]);
        }
    }
    assert_eq!(surface.force.len(), 12);
}
