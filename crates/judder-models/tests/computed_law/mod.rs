//! Computed laws in oscillator cases.

use crate::contact::run_text;
use judder_models::oscillator::case::OscillatorCase;
use judder_study::run::{RunOptions, run};
use judder_study::{Progress, StudyError};
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};

/// At low speed the critical shear strength hangs on the slope of the contact area; it does not depend on how finely the law was
/// made: the conservative one to 1e-3, and the full one, which that slope lowers by a factor of 29, to 1 %.
#[test]
#[ignore = "expensive: run by make validate"]
fn thresholds_at_low_speed_are_those_of_the_contact() {
    let point = |accuracy: f64, shear_strength: f64| {
        let text = format!(
            "model = \"oscillator\"\n[contact]\nshear_strength = {shear_strength}\n\
             law = {{ computed = true, accuracy = {accuracy} }}\n\
             [operation]\nvelocity = 1e-5\nnormal_load = 1e-4\n"
        );
        let case = judder_models::parse("case.toml", &text, &[])
            .unwrap()
            .case
            .of::<OscillatorCase>()
            .unwrap()
            .clone();
        judder_models::point::point(&case).unwrap()
    };
    let full = 3.85e-3;
    let found = [1e-2, 3e-3, 1e-3].map(|accuracy| {
        let above = point(accuracy, 1.01 * full);
        assert!(above.steady.growth_rate() > 0.0, "{accuracy}");
        above.critical_shear_strength[0]
    });
    assert!(
        point(1e-2, 0.99 * full).steady.growth_rate() < 0.0
            && point(3e-3, 0.99 * full).steady.growth_rate() < 0.0
    );
    for strength in found {
        assert!((strength / found[2] - 1.0).abs() < 1e-3, "{found:?}");
    }
}

/// Stops after a number of steps.
struct Impatient {
    left: AtomicUsize,
    done: AtomicUsize,
}

impl Impatient {
    fn after(steps: usize) -> Self {
        Self { left: AtomicUsize::new(steps), done: AtomicUsize::new(0) }
    }
}

impl Progress for Impatient {
    fn begin(&self, _name: &str, _steps: usize) {}
    fn expect(&self, _steps: usize) {}
    fn advance(&self) {
        self.done.fetch_add(1, Ordering::Relaxed);
        let _ = self.left.fetch_update(Ordering::Relaxed, Ordering::Relaxed, |left| left.checked_sub(1));
    }
    fn end(&self) {}
    fn interrupted(&self) -> bool {
        self.left.load(Ordering::Relaxed) == 0
    }
}

/// The law of an oscillator case goes on from the contacts of an interrupted run, and serves all its analyses.
#[test]
fn a_computed_law_is_taken_up_and_shared() {
    let text = r#"
        model = "oscillator"
        substrate = { glassy_modulus = "7.3 MPa" }
        contact = { law = { computed = true, accuracy = 0.04 } }
        [[analysis]]
        name = "slow"
        kind = "equivalent-damping"
        sweep = { key = "operation.velocity", from = 1e-4, to = 1e-3, points = 3, scale = "log" }
        [[analysis]]
        name = "fast"
        kind = "equivalent-damping"
        sweep = { key = "operation.velocity", from = 1e-2, to = 1e-1, points = 3, scale = "log" }
    "#;
    let folder = tempfile::tempdir().unwrap();
    let file = judder_models::parse("case.toml", text, &[]).unwrap();
    let points = folder.path().join(".scratch-law");
    let stopped = run(&file, folder.path(), &RunOptions::default(), &Impatient::after(7));
    assert!(matches!(stopped, Err(StudyError::Interrupted)));
    // the hash of the law, then a line a contact
    let kept = std::fs::read_to_string(&points).unwrap().lines().count() - 1;
    assert!((7..=9).contains(&kept), "{kept}");
    let rest = Impatient::after(usize::MAX);
    let report = run(&file, folder.path(), &RunOptions::default(), &rest).unwrap();
    assert!(report.complete && report.messages.is_empty(), "{:?}", report.messages);
    assert!(!points.exists());
    // nine knots, then seventeen or thirty-three: what was known is not solved again, and nothing twice
    let steps = rest.done.load(Ordering::Relaxed) - 6;
    assert!([9, 17, 33].contains(&(steps + kept)), "{steps} {kept}");
}

/// A law in a file, computed for few points.
pub(crate) fn law_in(folder: &Path) {
    let law = r#"
        model = "contact"
        indenter = { shape = "sphere" }
        [[analysis]]
        name = "law"
        kind = "contact-law"
        velocity = { from = 1e-2, to = 1e-1, points = 3 }
        indentation = { from = 5e-2, to = 1e-1, points = 3 }
        accuracy = 0.2
    "#;
    run_text(folder, law);
    std::fs::copy(folder.join("out/law.json"), folder.join("law.json")).unwrap();
}

#[test]
fn a_law_says_what_it_was_made_for_and_what_it_misses() {
    let folder = tempfile::tempdir().unwrap();
    law_in(folder.path());
    let text = r#"
        model = "oscillator"
        substrate = { glassy_modulus = "5 MPa" }
        contact = { law = { file = "law.json" } }
        [[analysis]]
        kind = "equivalent-damping"
        sweep = { key = "operation.velocity", from = 1e-2, to = 1e-1, points = 3, scale = "log" }
    "#;
    let messages = run_text(folder.path(), text).messages.join("\n");
    assert!(messages.contains("computed for a sphere") && messages.contains("a paraboloid"), "{messages}");
    assert!(messages.contains("E∞/E0 = 10, this substrate has E∞/E0 = 5"), "{messages}");
}
