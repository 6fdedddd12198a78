//! Sliding cases that are read.

use super::parse;
use judder_contact::friction::{FallingFriction, Friction, TableInterpolation};
use judder_models::friction::FrictionSettings;
use judder_models::sliding::case::SlidingCase;
use judder_models::sliding::case::motion::PlaneAxis;
use judder_models::sliding::case::observe::{PointNode, PointQuantity, Signal};
use judder_models::sliding::growth::settings::GrowthAnalysis;
use judder_models::sliding::locus::settings::{Along, LocusAnalysis};
use judder_models::sliding::march::settings::MarchAnalysis;
use judder_models::sliding::spectrogram::settings::SpectrogramAnalysis;
use judder_models::spectrogram::settings::SpectrogramWindow;
use judder_models::structure::case::StructureSource;
use judder_models::structure::case::body::{BodyGeometry, EndCondition};
use judder_models::structure::case::damping::{Damping, Rayleigh};
use judder_models::structure::case::reduction::{FixedModes, KeptNodes};
use judder_models::template::template;
use judder_sliding::edge::Interpolation;
use judder_sliding::locus::Configuration;
use judder_sliding::march::{ContactMethod, Predictor};
use std::f64::consts::TAU;

pub(crate) fn sliding(text: &str, overrides: &[&str]) -> SlidingCase {
    parse(text, overrides)
        .unwrap_or_else(|error| panic!("{error}"))
        .of::<SlidingCase>()
        .expect("its model")
        .clone()
}

/// The template without its analyses, and others in their place.
pub(crate) fn with_analyses(analyses: &str) -> String {
    let text = template("beams-paper").unwrap();
    let (system, _) = text.split_once("[[analysis]]").unwrap();
    format!("{system}\n{analyses}")
}

fn analysis<T: Clone + 'static>(text: &str) -> T {
    sliding(&with_analyses(&format!("[[analysis]]\n{text}\n")), &[]).analyses[0]
        .settings::<T>()
        .unwrap()
        .clone()
}

/// Tables 1 and 2 of the beams paper, the text of its section 2.3, and the readings of what it does not print.
#[test]
fn the_template_is_the_beams_paper() {
    let case = sliding(&template("beams-paper").unwrap(), &[]);
    let beams = [
        (case.slider(), (0.075, 0.0015, 0.010), (71e9, 0.33, 2770.0), (0.2, 4e-8), EndCondition::Guided),
        (case.track(), (0.1, 0.002, 0.020), (2.38e9, 0.40, 1200.0), (40.0, 4e-8), EndCondition::Clamped),
    ];
    for (structure, sizes, elastic, (alpha, beta), start) in beams {
        let StructureSource::Body(body) = &structure.source else { panic!("a body") };
        let BodyGeometry::Beam(beam) = &body.geometry else { panic!("a beam") };
        let material = body.material.unwrap();
        assert_eq!((beam.length, beam.thickness, body.width.unwrap()), sizes);
        assert_eq!((material.youngs_modulus, material.poisson_ratio, material.density), elastic);
        assert_eq!(structure.damping(), Damping::Rayleigh(Rayleigh { alpha, beta, ratios: None }));
        assert_eq!([beam.start, beam.end], [start, EndCondition::Free]);
        assert_eq!(structure.reduction.modes, FixedModes::Count(20));
    }
    let set = |name: &str| KeptNodes::Set(name.to_owned());
    assert_eq!(
        (&case.contact.slider.nodes, &case.contact.track.nodes),
        (&set("end-lower"), &set("upper-corners"))
    );
    assert_eq!(
        (&case.contact.friction, case.contact.interpolation),
        (&FrictionSettings::Constant(0.3), Interpolation::Linear)
    );
    let motion = &case.motion;
    assert_eq!((motion.start, motion.end, motion.velocity), (0.01, 0.0985, 0.03));
    assert_eq!(
        (motion.load.force, motion.load.direction, &motion.load.nodes),
        (-0.2, PlaneAxis::Y, &set("start"))
    );
    assert_eq!((motion.ramps.velocity, motion.ramps.load, motion.ramps.friction), (0.1, 0.1, 0.1));
    let initial = motion.initial_damping.unwrap();
    assert_eq!((initial.alpha, initial.beta, initial.hold, initial.release), (40.0, 4e-8, 0.2, 0.05));
    assert_eq!((motion.settled(), motion.noise.force), (0.25, 0.0));
}

#[test]
fn the_runnable_case_is_the_template() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/beams-paper/paper.toml");
    assert_eq!(std::fs::read_to_string(path).unwrap(), template("beams-paper").unwrap());
}

/// Whoever leaves a key out gets what the template says: the readings are the defaults.
#[test]
fn numbers_left_out_are_those_of_the_paper() {
    let text = with_analyses("");
    let numbers = [
        "friction_coefficient",
        "interpolation",
        "initial_gap",
        "start =",
        "end =",
        "velocity",
        "ramps",
        "noise",
    ];
    let is_given = |line: &&str| !numbers.iter().any(|key| line.starts_with(key));
    let bare: String = text.lines().filter(is_given).map(|line| format!("{line}\n")).collect();
    let bare = bare.replace(", direction = \"y\", force = \"-0.2 N\"", "");
    assert!(bare.len() + 300 < text.len());
    let [bare, given] = [bare, text].map(|text| parse(&text, &[]).unwrap().resolved());
    assert_eq!(bare, given);
}

#[test]
fn structures_points_and_analyses_go_by_their_names() {
    let case = sliding(
        &template("beams-paper").unwrap(),
        &[
            "structure.oblique.beam.angle=-25 deg",
            "structure.1.width=21 mm",
            "observe.points.T.set=end-lower",
            "analysis.ensubs.step=2e-7 s",
        ],
    );
    let StructureSource::Body(body) = &case.slider().source else { panic!("a body") };
    let BodyGeometry::Beam(beam) = &body.geometry else { panic!("a beam") };
    assert!((beam.angle / TAU + 25.0 / 360.0).abs() < 1e-15);
    let StructureSource::Body(body) = &case.track().source else { panic!("a body") };
    assert_eq!(body.width, Some(0.021));
    assert_eq!(case.points[0].node, PointNode::Kept(KeptNodes::Set("end-lower".to_owned())));
    let marches = case.analyses.iter().filter_map(|analysis| analysis.settings::<MarchAnalysis>());
    let steps: Vec<_> = marches.map(|march| march.step).collect();
    assert_eq!(steps, [Some(3e-7), Some(2e-7), Some(3e-7), None]);
}

#[test]
fn friction_may_fall_with_the_speed() {
    let table = "friction_coefficient = { velocity = [\"0 mm/s\", \"10 mm/s\"], coefficient = [0.4, 0.3] }";
    let case = sliding(&with_analyses("").replace("friction_coefficient = 0.3", &format!("{table} #")), &[]);
    let expected = Friction::table(vec![0.0, 0.01], vec![0.4, 0.3], TableInterpolation::Linear).unwrap();
    assert_eq!(case.contact.friction.friction().unwrap(), expected);
    let falls = "friction_coefficient = { at_rest = 0.4, at_speed = 0.3, decay_speed = \"10 mm/s\", viscous = \"0.1 s/m\", exponent = 2 }";
    let case = sliding(&with_analyses("").replace("friction_coefficient = 0.3", &format!("{falls} #")), &[]);
    let expected =
        FallingFriction { viscous: 0.1, exponent: 2.0, ..FallingFriction::exponential([0.4, 0.3], 0.01) };
    assert_eq!(case.contact.friction.friction().unwrap(), expected.into());
}

#[test]
fn a_locus_follows_the_path_where_nothing_is_said() {
    let locus: LocusAnalysis = analysis("kind = \"locus\"");
    assert_eq!((locus.configuration, locus.damping, locus.count), (Configuration::Undeformed, true, 20));
    let Along::Positions(positions) = locus.along else { panic!("positions") };
    assert_eq!((positions.from, positions.to, positions.points), (0.01, 0.0985, 1000));
}

#[test]
fn every_value_of_a_swept_key_is_a_case() {
    let text = with_analyses(
        "[[analysis]]\nkind = \"locus\"\nat = \"74 mm\"\n\
         sweep = { key = \"structure.oblique.beam.angle\", from = \"-40 deg\", to = \"-20 deg\", points = 3 }\n",
    );
    let case = sliding(&text, &[]);
    let locus: &LocusAnalysis = case.analyses[0].settings().unwrap();
    let Along::Key { at, sweep } = &locus.along else { panic!("a key") };
    assert_eq!(*at, 0.074);
    for (value, degrees) in sweep.values.iter().zip([-40.0, -30.0, -20.0]) {
        let swept = case.at(sweep, *value).unwrap();
        let StructureSource::Body(body) = &swept.slider().source else { panic!("a body") };
        let BodyGeometry::Beam(beam) = &body.geometry else { panic!("a beam") };
        assert_eq!(beam.angle, *value);
        assert!((value / TAU * 360.0 - degrees).abs() < 1e-12);
        assert_eq!(swept.motion, case.motion);
    }
}

#[test]
fn counts_and_defaults_are_swept_too() {
    for (key, values) in
        [("structure.oblique.reduction.count", "[5, 10]"), ("motion.noise.force", "[\"0 N\", \"1 mN\"]")]
    {
        let text = with_analyses(&format!(
            "[[analysis]]\nkind = \"locus\"\nat = \"74 mm\"\nsweep = {{ key = \"{key}\", values = {values} }}\n"
        ));
        let case = sliding(&text, &[]);
        let locus: &LocusAnalysis = case.analyses[0].settings().unwrap();
        let Along::Key { sweep, .. } = &locus.along else { panic!("a key") };
        let [first, last] = [0, 1].map(|index| case.at(sweep, sweep.values[index]).unwrap());
        assert_eq!(
            (first.slider().reduction.modes, last.slider().reduction.modes),
            match key {
                "motion.noise.force" => (FixedModes::Count(20), FixedModes::Count(20)),
                _ => (FixedModes::Count(5), FixedModes::Count(10)),
            }
        );
        assert_eq!(last.motion.noise.force, if key == "motion.noise.force" { 1e-3 } else { 0.0 });
    }
}

#[test]
fn a_march_takes_the_whole_path_and_chooses_its_step() {
    let march: MarchAnalysis = analysis("kind = \"march\"\nmethod = \"ensubs\"");
    assert_eq!((march.from, march.to, march.step), (0.01, 0.0985, None));
    assert!((march.signals.sample_rate.0 - 400e3).abs() < 1e-6);
    assert!((march.signals.pass_band / TAU - 50e3).abs() < 1e-6);
    let vertical = Signal::Point { point: 0, axis: PlaneAxis::Y, quantity: PointQuantity::Acceleration };
    assert_eq!((march.method(), *march.signal), (ContactMethod::EnSubs, vertical));
}

#[test]
fn what_belongs_to_a_method_is_read_with_it() {
    let method = |text: &str| {
        let march: MarchAnalysis = analysis(text);
        (march.method(), march.step)
    };
    let found = method("kind = \"march\"\nmethod = \"subs\"\nslope = \"static\"");
    assert_eq!(found, (ContactMethod::Subs { static_slope: true }, None));
    let (found, step) = method("kind = \"march\"\nmethod = \"residual-flexibility\"\ncut_off = \"100 kHz\"");
    assert!(matches!(found, ContactMethod::ResidualFlexibility { cut_off } if (cut_off - 1e5).abs() < 1e-6));
    assert_eq!(step, None);
    let growth: GrowthAnalysis = analysis(
        "kind = \"growth\"\nmethod = \"film\"\nposition = \"82 mm\"\nfrequency = \"3.5 kHz\"\nstep = \"2e-7 s\"",
    );
    assert_eq!((growth.method(), growth.step), (ContactMethod::Film, Some(2e-7)));
}

#[test]
fn the_predictor_is_that_under_the_last_force_where_nothing_is_said() {
    for (settings, expected) in [
        ("method = \"ensubs\"", Some(Predictor::WithForce)),
        ("method = \"film\"\npredictor = \"with-force\"", Some(Predictor::WithForce)),
        ("method = \"film\"\npredictor = \"printed\"", Some(Predictor::Printed)),
        ("method = \"subs\"", None),
        ("method = \"residual-flexibility\"", None),
    ] {
        let march: MarchAnalysis = analysis(&format!("kind = \"march\"\n{settings}"));
        assert_eq!(march.predictor, expected, "{settings}");
    }
}

#[test]
fn velocities_displacements_and_sounds_are_kept_on_request() {
    let kept = |settings: &str| {
        let case = sliding(
            &with_analyses(&format!("[[analysis]]\nkind = \"march\"\nmethod = \"ensubs\"\n{settings}\n")),
            &[],
        );
        let march: &MarchAnalysis = case.analyses[0].settings().unwrap();
        let names = |signals: Vec<Signal>| {
            signals.iter().map(|signal| signal.name(&case.points)).collect::<Vec<_>>().join(" ")
        };
        (names(march.kept(case.points.len())), names(march.heard(case.points.len())))
    };
    let told = |kept: &str, heard: &str| (kept.to_owned(), heard.to_owned());
    let contact = "normal-force tangential-force sliding-velocity";
    assert_eq!(kept(""), told(&format!("T.x T.y {contact}"), "T.x T.y"));
    assert_eq!(
        kept("signals = { quantities = [\"velocity\", \"acceleration\"] }\nsound = false"),
        told(&format!("T.x T.y T.x.velocity T.y.velocity {contact}"), "")
    );
    assert_eq!(
        kept("signals = { quantities = [] }\nsignal = \"T.x.displacement\""),
        told(&format!("{contact} T.x.displacement"), "T.x.displacement")
    );
    assert_eq!(
        kept("sound = [\"T.y.velocity\", \"normal-force\", \"T.y.velocity\"]"),
        told(&format!("T.x T.y {contact} T.y.velocity"), "T.y.velocity normal-force")
    );
}

#[test]
fn a_path_may_run_back() {
    let text = with_analyses(
        "[[analysis]]\nkind = \"march\"\nmethod = \"ensubs\"\nto = \"50 mm\"\n[[analysis]]\nkind = \"locus\"\n",
    );
    let case = sliding(&text, &["motion.start=98.5 mm", "motion.end=10 mm", "motion.velocity=-30 mm/s"]);
    let march: &MarchAnalysis = case.analyses[0].settings().unwrap();
    assert_eq!((march.from, march.to), (0.0985, 0.05));
    let locus: &LocusAnalysis = case.analyses[1].settings().unwrap();
    let Along::Positions(positions) = &locus.along else { panic!("positions") };
    assert_eq!((positions.from, positions.to), (0.01, 0.0985));
}

#[test]
fn a_spectrogram_has_the_unit_of_its_signal() {
    let march = "[[analysis]]\nkind = \"march\"\nmethod = \"ensubs\"\n[[analysis]]\nkind = \"spectrogram\"\nof = \"march\"\n";
    let march = march.replace(
        "[[analysis]]\nkind = \"spec",
        "signals = { quantities = [\"acceleration\", \"velocity\"] }\n[[analysis]]\nkind = \"spec",
    );
    for (settings, reference) in [
        ("signal = \"T.y\"\nreference = \"2 m/s^2\"", 2.0),
        ("signal = \"T.x.velocity\"\nreference = \"3 mm/s\"", 3e-3),
        ("signal = \"normal-force\"\nreference = \"1 mN\"", 1e-3),
        ("range = [-60.0, 40]\noverlap = 0", 1e-6),
    ] {
        let case = sliding(&with_analyses(&format!("{march}{settings}\n")), &[]);
        let found: &SpectrogramAnalysis = case.analyses[1].settings().unwrap();
        assert_eq!(
            (found.levels.reference.0.number, found.levels.pieces.window, found.levels.pieces.length),
            (reference, SpectrogramWindow::Hann, 5e-3)
        );
        assert_eq!(found.levels.drawn.waterfall, None);
    }
}
