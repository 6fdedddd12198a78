//! Sliding cases: the template, and what is refused of it.

use crate::desk::Desk;

#[test]
fn the_template_is_checked() {
    let desk = Desk::new();
    desk.write("case.toml", desk.succeed(&["new", "beams-paper"]).stdout);
    let shown = desk.succeed(&["check", "case.toml"]).stdout;
    for words in
        ["structure.oblique.beam.start", "guided", "motion.ramps.load", "101 values", "analysis.ensubs.step"]
    {
        assert!(shown.contains(words), "{words:?} is not in\n{shown}");
    }
    let checked = desk.succeed(&["check", "case.toml", "--json"]).json();
    assert_eq!(checked["case"]["motion"]["velocity"]["value"], 0.03);
}

#[test]
fn a_swept_key_that_is_not_there_is_shown_in_the_case() {
    let desk = Desk::new();
    let template = desk.succeed(&["new", "beams-paper"]).stdout;
    desk.write("case.toml", template.replace("key = \"contact.friction", "key = \"contact.frction"));
    let message = "with `contact.frction_coefficient` = 0: unknown key";
    desk.refused(&["check", "case.toml"], message, "did you mean `friction_coefficient`?");
}
