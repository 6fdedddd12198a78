//! Responses of assemblies to what swings, against published numbers and closed forms.

use crate::{case, number, run_into};
use judder_models::parse;
use judder_store::{Dataset, StudyFolder, VariableValues};
use judder_study::case::file::CaseFile;
use serde_json::{Map, Value};
use std::f64::consts::{PI, TAU};

/// What is told of the response of a case, and its arrays.
fn responded(file: &CaseFile) -> (Map<String, Value>, Dataset) {
    let folder = tempfile::tempdir().unwrap();
    let report = run_into(folder.path(), file, &["response"]);
    assert!(report.complete, "{:?}", report.messages);
    let dataset = StudyFolder::open(folder.path()).unwrap().read_dataset("response").unwrap();
    (report.summary.results["response"].clone(), dataset)
}

fn array<'a>(dataset: &'a Dataset, name: &str) -> &'a [f64] {
    match &dataset.variable(name).unwrap_or_else(|| panic!("no {name}")).data {
        VariableValues::F64(values) => values,
        _ => panic!("{name}"),
    }
}

/// The root mean square of NLvib's example 3 where it is largest, in m, and its frequency in rad/s; the frequencies of its folds in rad/s.
pub(super) fn stop() -> ([f64; 2], Vec<f64>) {
    let (told, _) = responded(&case("assembly/stop.toml", &[]));
    let first = &told["peaks"]["first.y"];
    let folds = told["folds"].as_array().unwrap().iter().map(|own| TAU * number(&own["frequency_hz"]));
    ([number(&first["rms"]), TAU * number(&first["rms_frequency_hz"])], folds.collect())
}

/// The amplitude of VM320 where it is largest, in m, and its frequency in rad/s.
pub(super) fn damper() -> [f64; 2] {
    let (told, _) = responded(&case("assembly/friction-damper.toml", &[]));
    let mass = &told["peaks"]["mass.x"];
    [number(&mass["amplitude"]), TAU * number(&mass["frequency_hz"])]
}

/// NLvib's code with 16384 samples: 1.01297 at 0.75375 rad/s, beneath the upper fold at 0.75562 rad/s. The lower fold is where the mass without the stop comes to it.
#[test]
fn a_stop_bends_the_response_as_published() {
    let ([rms, frequency], folds) = stop();
    assert!((rms / 1.01297 - 1.0).abs() < 1e-4, "{rms}");
    assert!((frequency / 0.75375 - 1.0).abs() < 1e-4, "{frequency}");
    // q₁ of (K − Ω² M + i Ω C) q = (0, 0.1)
    let swings = |omega: f64| {
        let (k, c) = (1.0 - omega * omega, 0.03 * omega);
        // (k + i c) (1 + k + 2 i c) − (1 + i c)²
        let re = k * (1.0 + k) - 2.0 * c * c - (1.0 - c * c);
        let im = 2.0 * k * c + c * (1.0 + k) - 2.0 * c;
        0.1 * 1.0_f64.hypot(c) / re.hypot(im)
    };
    let [lower, upper] = folds[..] else { panic!("{folds:?}") };
    assert!((swings(lower) - 1.0).abs() < 1e-3, "{lower} {}", swings(lower));
    assert!((upper / 0.75562 - 1.0).abs() < 1e-4, "{upper}");
}

/// ANSYS VM320: 1.50e-5 m at 209 rad/s, by one harmonic.
#[test]
fn a_friction_damper_has_the_published_peak() {
    let [amplitude, frequency] = damper();
    assert!((amplitude / 1.50e-5 - 1.0).abs() < 1e-2, "{amplitude}");
    assert!((frequency / 209.0 - 1.0).abs() < 1e-2, "{frequency}");
}

/// The mass with dry friction whose base shakes, with this analysis in the place of its marches.
fn shaken(analysis: &str) -> CaseFile {
    let text = include_str!("../../../../cases/assembly/shaken-base.toml");
    let bodies = text.split("[[analysis]]").next().unwrap();
    let bodies = bodies.replace("velocity = \"1 m/s\"", "velocity = \"0 m/s\"");
    let text =
        format!("{bodies}[[analysis]]\nname = \"response\"\nkind = \"frequency-response\"\n{analysis}\n");
    parse("case.toml", &text, &[]).unwrap()
}

/// J. P. Den Hartog 1931: the amplitude of a mass with dry friction that never sticks. Friction jumps, and many harmonics come near it.
#[test]
fn a_mass_with_dry_friction_on_a_shaking_base_swings_as_den_hartog_says() {
    let ratio: f64 = 15.0 / 20.0;
    let turn = (PI / ratio).sin() / (ratio * (1.0 + (PI / ratio).cos()));
    let exact = 3.0 / 400.0 * ((1.0 - ratio * ratio).powi(-2) - (turn / 3.0).powi(2)).sqrt();
    let [fewest, few, many] = [3, 21, 81].map(|harmonics| {
        let (told, dataset) = responded(&shaken(&format!(
            "frequency = [\"15 rad/s\", \"15.1 rad/s\"]\nharmonics = {harmonics}\nlongest_step = \"0.1 rad/s\"\nbase = [{{ direction = \"x\", amplitude = \"3 m/s^2\" }}]"
        )));
        assert_eq!(told["peaks"]["mass.x"]["at_end"], true);
        // one and three alone leave more than a tenth of a force that jumps out
        assert_eq!(told["peaks"]["mass.x"]["converged"], harmonics > 3, "{told:?}");
        assert!((array(&dataset, "frequency").last().unwrap() - 15.1 / TAU).abs() < 1e-9);
        (array(&dataset, "mass.x.largest")[0] / exact - 1.0).abs()
    });
    assert!(many < 2e-3 && many < 0.5 * few && few < fewest, "{few} {many}");
}

/// Forces that swing by rounding alone leave nothing out.
#[test]
fn a_contact_without_friction_has_no_swing_to_be_left_out() {
    let (told, _) = responded(&case(
        "assembly/friction-damper.toml",
        &[
            "contact.damper.friction_coefficient=0",
            "analysis.response.frequency=[\"150 rad/s\", \"170 rad/s\"]",
            "analysis.response.harmonics=7",
        ],
    ));
    let peak = &told["peaks"]["mass.x"];
    assert!(number(&peak["left_out"]) < 1e-2 && peak["converged"] == true, "{peak}");
}

/// A force that friction holds moves nothing, and forces whose phases take each other away neither.
#[test]
fn what_is_held_does_not_move() {
    let force = |amplitude: &str, phase: &str| {
        format!(
            "{{ structure = \"block\", set = \"mass\", direction = \"x\", amplitude = \"{amplitude}\", phase = \"{phase}\" }}"
        )
    };
    let largest = |forces: &[String]| {
        let forces = forces.join(", ");
        let (_, dataset) = responded(&shaken(&format!(
            "frequency = [\"15 rad/s\", \"10 rad/s\"]\nharmonics = 5\nlongest_step = \"1 rad/s\"\nforces = [{forces}]"
        )));
        array(&dataset, "mass.x.amplitude").iter().fold(0.0_f64, |most, own| most.max(*own))
    };
    assert!(largest(&[force("1.9 N", "0 deg")]) < 1e-7);
    assert!(largest(&[force("6 N", "0 deg")]) > 1e-3);
    assert!(largest(&["0 deg", "120 deg", "240 deg"].map(|phase| force("6 N", phase))) < 1e-7);
}

/// A response that does not leave its range is a missing result, and says why.
#[test]
fn a_response_that_ends_early_says_why() {
    let base = "frequency = [\"15 rad/s\", \"60 rad/s\"]\npoints = 5\nbase = [{ direction = \"x\", amplitude = \"3 m/s^2\" }]";
    let folder = tempfile::tempdir().unwrap();
    let report = run_into(folder.path(), &shaken(base), &["response"]);
    assert!(!report.complete);
    let told = &report.summary.results["response"];
    assert!(
        number(&told["points"]) == 5.0
            && told["end"].as_str().unwrap().contains("as many motions as `points` allows")
    );
    let table = std::fs::read_to_string(folder.path().join("response.csv")).unwrap();
    assert!(table.starts_with("frequency [Hz],mass.x.amplitude [m],mass.x.rms [m],"), "{table}");
    assert_eq!(table.lines().count(), 6);
}

/// A resonance of 1 % damping that the steps pass over, of a mass that touches nothing: its amplitude is a/√((ω₀² − ω²)² + (c ω/m)²).
#[test]
fn a_peak_between_long_steps_is_doubted() {
    let text = include_str!("../small/assembly-response.toml")
        .replace("gap = \"2 mm\"", "gap = \"1 m\"")
        .replace("damping = [[2, 0]", "damping = [[0.8, 0]")
        .replace("points = 60", "points = 900");
    let peak = |step: &str| {
        let text = text.replace("longest_step = \"0.2 Hz\"", &format!("longest_step = \"{step}\""));
        let folder = tempfile::tempdir().unwrap();
        let report = run_into(folder.path(), &parse("case.toml", &text, &[]).unwrap(), &["shaken"]);
        assert!(report.complete);
        let is_doubted = report.messages.iter().any(|message| message.contains("beside the peak of mass.x"));
        (number(&report.summary.results["shaken"]["peaks"]["mass.x"]["amplitude"]), is_doubted)
    };
    let ((coarse, is_doubted), (fine, is_fine_doubted)) = (peak("0.3 Hz"), peak("0.01 Hz"));
    // ω₀ = 20 rad/s, c/m = 0.4 1/s: largest at ω² = ω₀² − (c/m)²/2
    let exact = 3.0 / (0.4 * (400.0_f64 - 0.04).sqrt());
    assert!((fine / exact - 1.0).abs() < 1e-3 && !is_fine_doubted, "{fine} {exact}");
    assert!(coarse < 0.9 * exact && is_doubted, "{coarse} {exact}");
}

/// 1 + tr Φ + det Φ of the monodromy matrix Φ of the motion with the period of the force, which vanishes where a multiplier is −1; det Φ = e^{−cT} (J. Liouville). By the
/// method of Runge and Kutta and Newton's, from a state on that becomes that of the motion.
fn off_doubling(omega: f64, state: &mut [f64; 2]) -> f64 {
    const STEPS: usize = 20_000;
    let step = TAU / omega / STEPS as f64;
    let rate = |t: f64, [x, v, a, b, c, d]: [f64; 6]| {
        let (stop, stiffness) = if x > 0.05 { (8.0 * (x - 0.05), 9.0) } else { (0.0, 1.0) };
        let force = (omega * t).cos() - 0.3 * v - x - stop;
        [v, force, c, d, -0.3 * c - stiffness * a, -0.3 * d - stiffness * b]
    };
    let ahead = |state: [f64; 6], slope: [f64; 6], by: f64| -> [f64; 6] {
        std::array::from_fn(|k| state[k] + by * slope[k])
    };
    for _ in 0..50 {
        let begin = [state[0], state[1], 1.0, 0.0, 0.0, 1.0];
        let [x, v, a, b, c, d] = (0..STEPS).fold(begin, |own, k| {
            let t = k as f64 * step;
            let first = rate(t, own);
            let second = rate(t + 0.5 * step, ahead(own, first, 0.5 * step));
            let third = rate(t + 0.5 * step, ahead(own, second, 0.5 * step));
            let fourth = rate(t + step, ahead(own, third, step));
            std::array::from_fn(|k| {
                own[k] + step / 6.0 * (first[k] + 2.0 * (second[k] + third[k]) + fourth[k])
            })
        });
        let [missed_x, missed_v] = [x - state[0], v - state[1]];
        let determinant = (1.0 - a) * (1.0 - d) - b * c;
        state[0] += ((1.0 - d) * missed_x + b * missed_v) / determinant;
        state[1] += (c * missed_x + (1.0 - a) * missed_v) / determinant;
        if missed_x.abs() + missed_v.abs() < 1e-10 {
            return 1.0 + a + d + (-0.3 * TAU / omega).exp();
        }
    }
    panic!("no motion at {omega}")
}

/// A mass between a spring and one that only pushes: between both frequencies at which a multiplier passes −1 every second swing differs.
#[test]
fn a_spring_that_only_pushes_doubles_the_period() {
    let file = case("assembly/period-doubling.toml", &[]);
    let (told, dataset) = responded(&file);
    let changes = told["stability_changes"].as_array().unwrap();
    assert_eq!(changes.len(), 2, "{changes:?}");
    let sought = [([-0.08, 0.022], [4.0, 3.9], 3.9305), ([-0.43, 0.12], [2.35, 2.25], 2.2949)];
    for (change, (mut state, [mut above, mut below], printed)) in changes.iter().zip(sought) {
        assert_eq!(change["kind"], "period doubling");
        let at_above = off_doubling(above, &mut state);
        for _ in 0..16 {
            let middle = 0.5 * (above + below);
            let is_above = off_doubling(middle, &mut state) * at_above > 0.0;
            if is_above { above = middle } else { below = middle }
        }
        assert!((above - printed).abs() < 1e-4, "{above}");
        let [before, after] = [0, 1].map(|k| TAU * number(&change["between_hz"][k]));
        // what 15 harmonics leave out moves it
        assert!(before + 2e-3 > above && below > after - 2e-3, "{before} {above} {after}");
    }
    let [frequency, apart] = ["frequency", "multipliers_apart"].map(|name| array(&dataset, name));
    assert!(apart.iter().all(|own| *own < 0.02), "{apart:?}");
    let VariableValues::U8(stable) = &dataset.variable("stable").unwrap().data else { panic!() };
    let unstable = frequency.iter().zip(stable).filter(|(_, code)| **code == 0);
    assert!(
        unstable.clone().count() > 60 && unstable.clone().all(|(own, _)| (2.28..3.95).contains(&(TAU * own)))
    );
    let opinion = told["second_opinion"].as_str().unwrap();
    assert!(opinion.starts_with("Hill's method says the same of"), "{opinion}");
    // on one thread the same, to the last byte
    let alone = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    let again = alone.install(|| responded(&file));
    assert!(again.0 == told && again.1 == dataset);
}
