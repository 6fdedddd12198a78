//! Analyses of sliding cases that are refused: the message, the place and what would be right.

use super::bad_sliding::analysis;
use super::parse;
use super::sliding::with_analyses;
use judder_models::key_sweep::KeySweepProblem;
use judder_models::sliding::case::SlidingCase;
use judder_models::sliding::locus::settings::LocusAnalysis;

#[test]
fn a_locus_that_cannot_be() {
    analysis(
        "kind = \"locus\"\nat = \"74 mm\"",
        "`at` has no meaning with `positions`, without `sweep`",
        "\"74 mm\"",
        "leave `at` out",
    );
    analysis(
        "kind = \"locus\"\npositions = { from = \"50 mm\", to = \"20 mm\" }",
        "the range runs backwards: from 50 mm to 20 mm",
        "{ from = \"50 mm\", to = \"20 mm\" }",
        "exchange its two ends",
    );
    analysis(
        "kind = \"locus\"\nsweep = { key = \"contact.friction_coefficient\", from = 0, to = 1, points = 3 }",
        "an analysis of kind `locus` lacks the key `at`",
        "[[analysis]]",
        "give at = \"74 mm\", where the contact is held while the key is swept",
    );
    analysis(
        "kind = \"locus\"\nat = \"74 mm\"\npositions = {}\nsweep = { key = \"x\" }",
        "`sweep` and `positions` cannot both be given: one follows from the other",
        "{}",
        "keep `sweep` or `positions`",
    );
}

/// A sweep of the contact held at 74 mm.
fn sweep(settings: &str, message: &str, place: &str, help: &str) {
    let text = format!("kind = \"locus\"\nat = \"74 mm\"\nsweep = {{ {settings} }}");
    analysis(&text, message, place, help);
}

#[test]
fn swept_keys_that_cannot_be() {
    let advice = "sweep a number of a structure, the contact, the motion or the parameters: structure.NAME.beam.angle, \
                  contact.friction_coefficient, motion.load.force, parameters.NAME";
    for key in ["analysis.locus.at", "friction_coefficient", ""] {
        let (message, place) = (format!("`{key}` cannot be swept"), format!("\"{key}\""));
        sweep(&format!("key = \"{key}\", from = 0, to = 1, points = 3"), &message, &place, advice);
    }
    let settings = "key = \"contact.frictoin_coefficient\", from = 0, to = 1, points = 3";
    sweep(
        settings,
        "`contact.frictoin_coefficient` cannot be swept: unknown key `frictoin_coefficient` in [contact]",
        "\"contact.frictoin_coefficient\"",
        "did you mean `friction_coefficient`? keys here: slider, track, friction_coefficient, interpolation, initial_gap",
    );
    sweep(
        "key = \"contact.friction\", from = 0, to = 1, points = 3",
        "`contact.friction` cannot be swept: unknown key `friction` in [contact]",
        "\"contact.friction\"",
        "did you mean `friction_coefficient`? keys here: slider, track, friction_coefficient, interpolation, initial_gap",
    );
    let settings = "key = \"structure.oblque.width\", from = \"1 mm\", to = \"2 mm\", points = 3";
    sweep(
        settings,
        "`structure.oblque.width` cannot be swept: unknown key `oblque` in `structure`",
        "\"structure.oblque.width\"",
        "did you mean `oblique`? keys here: oblique, horizontal",
    );
    let settings = "key = \"contact.interpolation\", from = 0, to = 1, points = 3";
    sweep(
        settings,
        "with `contact.interpolation` = 0: `contact.interpolation` is an integer, but must be a string",
        &format!("{{ {settings} }}"),
        "sweep values that the key can take",
    );
}

#[test]
fn swept_values_that_cannot_be() {
    let settings = "key = \"contact.friction_coefficient\", from = 0.5, to = -0.5, points = 3";
    sweep(
        settings,
        "with `contact.friction_coefficient` = -0.5: `contact.friction_coefficient` must be zero or positive, but is -0.5",
        &format!("{{ {settings} }}"),
        "sweep values that the key can take",
    );
    let settings = "key = \"motion.load.force\", values = [-1, -2]";
    sweep(
        settings,
        "with `motion.load.force` = -1: `motion.load.force` needs a unit: it has no dimensionless form",
        &format!("{{ {settings} }}"),
        "write a force, such as \"0.2 N\"",
    );
    sweep(
        "key = \"motion.load.force\", from = \"-1 N\", to = \"2 mm\", points = 3",
        "`sweep.from` is a force, but `sweep.to` is a length",
        "\"2 mm\"",
        "give both in units of the key that varies",
    );
    sweep(
        "key = \"motion.load.force\", values = [\"-1 N\", \"-3 N\", \"-2 N\"]",
        "the values of `sweep.values` must ascend or descend",
        "[\"-1 N\", \"-3 N\", \"-2 N\"]",
        "branches are followed from one value to the next: sort them",
    );
    sweep(
        "key = \"motion.load.force\", from = \"-1 Nn\", to = \"2 N\", points = 3",
        "`sweep.from` is not a quantity: unknown unit `Nn`",
        "Nn",
        "write a plain number, or a number with a unit in quotes: \"10 mm\"",
    );
}

/// A value within a range of which only the ends were tried.
#[test]
fn a_value_between_the_ends_of_a_sweep() {
    let text = with_analyses(
        "[[analysis]]\nkind = \"locus\"\nat = \"74 mm\"\n\
         sweep = { key = \"motion.velocity\", from = \"10 mm/s\", to = \"30 mm/s\", points = 3 }\n",
    );
    let case = parse(&text, &[]).unwrap().of::<SlidingCase>().unwrap().clone();
    let locus: &LocusAnalysis = case.analyses[0].settings().unwrap();
    let judder_models::sliding::locus::settings::Along::Key { sweep, .. } = &locus.along else {
        panic!("a key")
    };
    let KeySweepProblem::SweptValue { key, value, reason, .. } = case.at(sweep, -0.01).unwrap_err() else {
        panic!("a value")
    };
    assert_eq!((key.as_str(), value.as_str()), ("motion.velocity", "-10 mm/s"));
    assert_eq!(reason, "a velocity of -0.01 m/s does not lead from 0.01 m to 0.0985 m");
}

#[test]
fn a_march_that_cannot_be() {
    let march = |method: &str, settings: &str| format!("kind = \"march\"\nmethod = \"{method}\"\n{settings}");
    analysis(
        "kind = \"march\"",
        "an analysis of kind `march` lacks the key `method`",
        "[[analysis]]",
        "give method = \"…\", one of subs, ensubs, film, residual-flexibility",
    );
    analysis(
        &march("ensub", ""),
        "unknown method `ensub`",
        "ensub",
        "did you mean `ensubs`? known: subs, ensubs, film, residual-flexibility",
    );
    analysis(
        &march("ensubs", "slope = \"static\""),
        "`slope` has no meaning with method = \"ensubs\"",
        "\"static\"",
        "leave `slope` out",
    );
    analysis(
        &march("film", "cut_off = \"100 kHz\""),
        "`cut_off` has no meaning with method = \"film\"",
        "\"100 kHz\"",
        "leave `cut_off` out",
    );
    for method in ["subs", "residual-flexibility"] {
        analysis(
            &march(method, "predictor = \"printed\""),
            &format!("`predictor` has no meaning with method = \"{method}\""),
            "\"printed\"",
            "leave `predictor` out",
        );
    }
    analysis(
        &march("film", "predictor = \"as-printed\""),
        "unknown predictor `as-printed`",
        "as-printed",
        "did you mean `printed`? known: printed, with-force",
    );
    analysis(&march("film", "step = \"0 s\""), "`step` must be positive, but is 0 s", "\"0 s\"", "");
    analysis(
        &march("film", "from = \"5 mm\""),
        "`from` is 0.005 m, but the motion goes from 0.01 m to 0.0985 m",
        "\"5 mm\"",
        "a march is a part of the motion, in its direction",
    );
    analysis(
        &march("film", "from = \"50 mm\"\nto = \"20 mm\""),
        "a velocity of 0.03 m/s does not lead from 0.05 m to 0.02 m",
        "\"20 mm\"",
        "the velocity is positive where `end` lies beyond `start`, negative where it lies before it",
    );
    analysis(
        &march("film", "step = \"1e-12 s\""),
        "this march takes 3.05e12 steps, and 1e12 are allowed",
        "\"1e-12 s\"",
        "take a shorter path, a larger step or a higher velocity",
    );
}

#[test]
fn samples_that_cannot_carry_a_signal() {
    let help = "1/step ≥ sample_rate > 2 pass_band; at 3e-7 s, 400 kHz carry 50 kHz with room for the filter";
    for (rate, reason) in [
        ("100 kHz", "samples at 100000 Hz cannot carry frequencies up to 50000 Hz"),
        ("4 MHz", "samples at 4000000 Hz are more than one a step of 3e-7 s"),
    ] {
        let signals = format!("{{ sample_rate = \"{rate}\" }}");
        let text = format!("kind = \"march\"\nmethod = \"ensubs\"\nstep = \"3e-7 s\"\nsignals = {signals}");
        analysis(&text, reason, &signals, help);
    }
}

#[test]
fn signals_that_there_are_not() {
    let march = |settings: &str| format!("kind = \"march\"\nmethod = \"ensubs\"\n{settings}");
    analysis(
        &march("signals = { quantities = [\"velocty\"] }"),
        "unknown quantity `velocty`",
        "velocty",
        "did you mean `velocity`? known: acceleration, velocity, displacement",
    );
    analysis(
        &march("sound = [\"T.y\", \"T.z\"]"),
        "unknown signal `T.z`",
        "\"T.z\"",
        "did you mean `T.x`? known: T.x, T.y, normal-force, tangential-force, sliding-velocity",
    );
    analysis(
        &march("sound = \"T.y\""),
        "`sound` is a string, but must be true, false or a list of signals",
        "\"T.y\"",
        "",
    );
    analysis(
        &march("[[analysis]]\nkind = \"spectrogram\"\nof = \"march\"\nsignal = \"T.y.velocity\""),
        "the march `march` does not keep the signal `T.y.velocity`",
        "\"T.y.velocity\"",
        "let the march `march` keep it: signals = { quantities = [\"velocity\"] }",
    );
}

#[test]
fn a_growth_of_nothing() {
    analysis(
        "kind = \"growth\"\nmethod = \"ensubs\"\nposition = \"74 mm\"",
        "an analysis of kind `growth` lacks the key `frequency`",
        "[[analysis]]",
        "give frequency = \"40 rad/s\" or \"7 kHz\"",
    );
    analysis(
        "kind = \"growth\"\nmethod = \"ensubs\"\nposition = 74\nfrequency = \"3.52 kHz\"",
        "`position` needs a unit: it has no dimensionless form",
        "74",
        "write a length, such as \"10 mm\"",
    );
}

#[test]
fn a_spectrogram_of_what_does_not_stand_above() {
    let march = "kind = \"march\"\nname = \"long\"\nmethod = \"ensubs\"\n[[analysis]]\n";
    analysis(
        "kind = \"spectrogram\"\nof = \"long\"",
        "there is no march above that could be `long`",
        "\"long\"",
        "let the march stand before what shows it",
    );
    analysis(
        &format!("{march}kind = \"spectrogram\"\nof = \"lang\""),
        "unknown march `lang`",
        "\"lang\"",
        "did you mean `long`? known: long",
    );
    analysis(
        &format!("{march}kind = \"spectrogram\"\nof = \"long\"\nlocus = \"long\""),
        "there is no locus over positions above that could be `long`",
        "\"long\"",
        "let the locus over positions stand before what shows it",
    );
    analysis(
        &format!("{march}kind = \"spectrogram\"\nof = \"long\"\noverlap = 1"),
        "`overlap` must be zero or positive, and below one, but is 1.0",
        "1",
        "",
    );
    analysis(
        &format!("{march}kind = \"spectrogram\"\nof = \"long\"\nreference = \"1 N\""),
        "`reference` must be an acceleration, but this is a force",
        "\"1 N\"",
        "write an acceleration, such as \"1 m/s^2\"",
    );
}
