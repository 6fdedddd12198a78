//! Sweeps of the whole case that are refused: the message, the place and what would be right.

use miette::Diagnostic;

use super::study_sweep::oscillator;
use super::{help_of, refused, with_file};

pub(crate) const OVER: &str =
    "over = [{ key = \"operation.velocity\", from = 1e-4, to = 1e-2, points = 3 }]\n";
pub(crate) const QUANTITIES: &str = "quantities = [\"growth_rate\"]\n";

/// Refuses a sweep of an oscillator with these settings.
pub(crate) fn sweep(settings: &str, message: &str, place: &str, help: &str) {
    refused(&oscillator(settings), message, place, help);
}

/// Refuses an entry of `over` of a sweep by this method.
pub(crate) fn over(method: &str, entry: &str, message: &str, place: &str, help: &str) {
    let points = if ["sobol", "latin-hypercube"].contains(&method) { "points = 8\n" } else { "" };
    sweep(
        &format!("method = \"{method}\"\n{points}over = [{{ {entry} }}]\n{QUANTITIES}"),
        message,
        place,
        help,
    );
}

/// Refuses a quantity.
fn quantity(path: &str, message: &str, help: &str) {
    let place = format!("\"{path}\"");
    sweep(&format!("{OVER}quantities = [\"rms\", {place}]"), message, &place, help);
}

#[test]
fn a_list_that_is_none() {
    refused(
        "model = \"oscillator\"\n[sweep]\nname = \"a\"\n",
        "`sweep` is a table, but must be a list, each item headed [[sweep]]",
        "[sweep]",
        "",
    );
}

#[test]
fn a_misspelt_heading() {
    refused(
        "model = \"belt\"\n[[sweeps]]\nname = \"a\"\n",
        "unknown key `sweeps` in a belt case",
        "sweeps",
        "did you mean `sweep`? keys here: title, model, oscillator, friction, operation, analysis, sweep",
    );
}

#[test]
fn an_unknown_key_of_a_sweep() {
    sweep(
        &format!("quantity = [\"rms\"]\n{OVER}{QUANTITIES}"),
        "unknown key `quantity` in a sweep",
        "quantity",
        "did you mean `quantities`? keys here: name, method, points, seed, over, quantities, chunk, sensitivity, probabilities",
    );
}

#[test]
fn an_unknown_method() {
    sweep(
        &format!("method = \"sobel\"\n{OVER}{QUANTITIES}"),
        "unknown method `sobel`",
        "sobel",
        "did you mean `sobol`? known: grid, list, latin-hypercube, sobol",
    );
}

#[test]
fn names_that_cannot_be() {
    let named = |name: &str| {
        format!(
            "model = \"oscillator\"\n[[analysis]]\nkind = \"limit-cycle\"\n[[sweep]]\nname = \"first\"\n{OVER}{QUANTITIES}\
             [[sweep]]\nname = \"{name}\"\n{OVER}{QUANTITIES}"
        )
    };
    let advice = "use 1 to 100 of A-Z a-z 0-9 . _ - and no dot at either end: the name becomes a folder";
    for name in ["", "../out", ".hidden", "dotted.", "zarr.json", "a b", &"n".repeat(101)] {
        refused(&named(name), &format!("`{name}` cannot name a sweep"), &format!("\"{name}\""), advice);
    }
    let advice = "give each analysis and each sweep a `name` of its own";
    let taken = "`Limit-Cycle` names both this sweep and an analysis";
    refused(&named("Limit-Cycle"), taken, "\"Limit-Cycle\"", advice);
    // the first of both is quoted alike: the place is the second
    let error = super::parse(&named("first"), &[]).unwrap_err();
    assert_eq!(error.to_string(), "`first` names both this sweep and another sweep");
    let offset = error.labels().unwrap().next().unwrap().offset();
    assert_eq!(offset, named("first").rfind("\"first\"").unwrap());
    refused(
        "model = \"oscillator\"\n[[sweep]]\nmethod = \"grid\"\n",
        "a sweep lacks the key `name`",
        "[[sweep]]",
        "give name = \"…\", under which its results are kept",
    );
}

#[test]
fn points_of_a_grid() {
    sweep(
        &format!("points = 100\n{OVER}{QUANTITIES}"),
        "`points` has no meaning with method = \"grid\"",
        "100",
        "give each key its own: over = [{ key = …, from = …, to = …, points = 21 }, …]; or use method = \"sobol\"",
    );
    sweep(
        &format!("seed = 3\n{OVER}{QUANTITIES}"),
        "`seed` has no meaning with method = \"grid\"",
        "3",
        "leave `seed` out",
    );
    sweep(
        &format!("method = \"sobol\"\n{OVER}{QUANTITIES}"),
        "a sweep lacks the key `points`",
        "[[sweep]]",
        "give points = 4096, the number of points",
    );
}

#[test]
fn keys_of_another_method() {
    let range = "key = \"operation.velocity\", from = 1e-4, to = 1e-2";
    over(
        "grid",
        range,
        "an entry of `over` lacks the key `points`",
        &format!("{{ {range} }}"),
        "give points = 21, the number of values; or values = [ … ] in place of the range",
    );
    over(
        "grid",
        "key = \"operation.velocity\", values = [1e-4, 1e-2], points = 77",
        "`points` has no meaning with `values`",
        "77",
        "leave `points` out",
    );
    over(
        "list",
        range,
        "an entry of `over` lacks the key `values`",
        &format!("{{ {range} }}"),
        "give values = [ … ], one a point",
    );
    over(
        "sobol",
        &format!("{range}, points = 77"),
        "`points` has no meaning with method = \"sobol\"",
        "77",
        "leave `points` out",
    );
    over(
        "latin-hypercube",
        "key = \"operation.velocity\", values = [0.5, 0.6]",
        "`values` has no meaning with method = \"latin-hypercube\"",
        "[0.5, 0.6]",
        "leave `values` out",
    );
}

#[test]
fn lists_of_different_lengths() {
    let second = r#"{ key = "oscillator.damping_x", values = [0.1] }"#;
    sweep(
        &format!(
            "method = \"list\"\nover = [{{ key = \"operation.velocity\", values = [1e-4, 1e-2] }}, {second}]\n{QUANTITIES}"
        ),
        "`operation.velocity` has 2 values, but `oscillator.damping_x` has 1",
        second,
        "a list takes one value of each key a point; for all combinations, use method = \"grid\"",
    );
}

#[test]
fn lists_that_are_empty() {
    let help = "give at least one value, or leave the table out";
    sweep(&format!("over = []\n{QUANTITIES}"), "`over` is an empty list", "[]", help);
    sweep(&format!("{OVER}quantities = []"), "`quantities` is an empty list", "[]", help);
    over("list", "key = \"operation.velocity\", values = []", "`over.values` is an empty list", "[]", help);
}

/// Two entries of `over` that vary one number.
fn twice(model: &str, [first, second]: [&str; 2], value: &str, message: &str) {
    let text = format!(
        "{model}\n[[sweep]]\nname = \"s\"\nmethod = \"list\"\n\
         over = [{{ key = \"{first}\", values = [{value}] }}, {{ key = \"{second}\", values = [{value}] }}]\nquantities = [\"q\"]\n"
    );
    let error = super::parse(&text, &[]).unwrap_err();
    assert_eq!((error.to_string(), error.place()), (message.to_owned(), second));
    let offset = error.labels().unwrap().next().unwrap().offset();
    assert_eq!(offset, text.rfind(second).unwrap());
    assert_eq!(help_of(&error), "sweep each number once");
}

#[test]
fn one_number_twice() {
    let model = "model = \"oscillator\"";
    let key = "operation.velocity";
    twice(model, [key, key], "0.5", "`operation.velocity` is swept twice");
    let model = "model = \"oscillator\"\n[[analysis]]\nkind = \"limit-cycle\"";
    twice(
        model,
        ["analysis.limit-cycle.tolerance", "analysis.0.tolerance"],
        "1e-9",
        "`analysis.0.tolerance` is swept twice: `analysis.limit-cycle.tolerance` says the same",
    );
    over(
        "grid",
        "key = \"operation.velocity\", values = [\"1 mm/s\", \"2 mm/s\", \"0.001 m/s\"]",
        "`operation.velocity` is 0.001 m/s twice",
        "\"0.001 m/s\"",
        "give each value of an axis once",
    );
}

/// Two keys that the reader of the case itself refuses together.
#[test]
fn two_forms_of_one_quantity() {
    let first = r#"{ key = "substrate.retardation_time", from = "1 ms", to = "2 ms", points = 2 }"#;
    let second = r#"{ key = "substrate.relaxation_time", from = "1 ms", to = "2 ms", points = 2 }"#;
    let error = super::parse(&oscillator(&format!("over = [{first}, {second}]\n{QUANTITIES}")), &[]);
    let error = error.unwrap_err();
    assert!(error.to_string().contains("`substrate.relaxation_time` = 0.001 s"), "{error}");
    assert!(error.to_string().ends_with("both say the same thing"), "{error}");
    assert_eq!(error.place(), second);
}

#[test]
fn quantities_that_cannot_be() {
    let advice = "write a name such as growth_rate, or ANALYSIS.PATH: cycle.rms, thresholds.full.0.min, modes.frequencies_hz.0";
    quantity("", "`` is not the path of a quantity: it is empty", advice);
    for path in ["cycle.", ".rms", "cycle..rms"] {
        quantity(path, &format!("`{path}` is not the path of a quantity: a step of it is empty"), advice);
    }
    let reason = "its steps are names of A-Z a-z 0-9 _ - and numbers";
    quantity("cycle.full[0]", &format!("`cycle.full[0]` is not the path of a quantity: {reason}"), advice);
    quantity("cycle", "`cycle` is not the path of a quantity: it names a whole analysis", advice);
    quantity(
        "cycle.a.b.c.d.e.f.g.h",
        "`cycle.a.b.c.d.e.f.g.h` is not the path of a quantity: it has more steps than results are deep",
        advice,
    );
    quantity(
        "cycel.rms",
        "`cycel.rms`: there is no analysis `cycel`",
        "did you mean `cycle`? analyses: cycle",
    );
    let twice = format!("{OVER}quantities = [\"cycle.rms\", 'cycle.rms']");
    sweep(&twice, "the quantity `cycle.rms` stands twice", "'cycle.rms'", "ask for each quantity once");
    refused(
        &format!("model = \"belt\"\n[[sweep]]\nname = \"s\"\n{OVER}quantities = [\"cycle.rms\"]"),
        "`cycle.rms`: there is no analysis `cycle`",
        "\"cycle.rms\"",
        "the case has no analysis: give one in [[analysis]], or a quantity of the point, without a dot",
    );
}

#[test]
fn chunks_that_cannot_be() {
    for chunk in ["0", "-1"] {
        sweep(
            &format!("chunk = {chunk}\n{OVER}{QUANTITIES}"),
            &format!("`chunk` must be a whole number from 1 to 268435456, but is {chunk}"),
            chunk,
            "give a number from 1 to 268435456",
        );
    }
}

#[test]
fn sensitivity_that_cannot_be() {
    let advice =
        "leave it out, or use method = \"sobol\" or \"latin-hypercube\", whose points fill the ranges evenly";
    sweep(
        &format!("sensitivity = true\n{OVER}{QUANTITIES}"),
        "`sensitivity` has no meaning with method = \"grid\"",
        "true",
        advice,
    );
    sweep(
        &format!(
            "method = \"list\"\nsensitivity = {{}}\nover = [{{ key = \"operation.velocity\", values = [0.5] }}]\n{QUANTITIES}"
        ),
        "`sensitivity` has no meaning with method = \"list\"",
        "{}",
        advice,
    );
    let sobol = |sensitivity: &str, message: &str, place: &str, help: &str| {
        let over = "over = [{ key = \"operation.velocity\", from = 1e-4, to = 1e-2 }]";
        let settings =
            format!("method = \"sobol\"\npoints = 8\n{over}\nsensitivity = {sensitivity}\n{QUANTITIES}");
        sweep(&settings, message, place, help);
    };
    sobol(
        "1",
        "`sensitivity` is an integer, but must be true, or a table { confidence, resamples }",
        "1",
        "",
    );
    sobol(
        "{ confidence = 95 }",
        "`sensitivity.confidence` must be above 0 and at most 0.9999, but is 95.0",
        "95",
        "give a share of one: 0.95 for 95 %",
    );
    sobol(
        "{ resamples = 10 }",
        "`sensitivity.resamples` must be a whole number from 100 to 1000000, but is 10",
        "10",
        "give a number from 100 to 1000000",
    );
}

/// A two-degrees case with as many parameters, all swept.
fn wide(keys: usize, more: &str) -> String {
    let parameters: Vec<String> = (0..keys).map(|k| format!("p{k} = 1")).collect();
    let sum: String = (0..keys).map(|k| format!(" + p{k}")).collect();
    let over: Vec<String> =
        (0..keys).map(|k| format!("{{ key = \"parameters.p{k}\", from = 0, to = 1 }}")).collect();
    format!(
        "model = \"two-degrees\"\n[parameters]\n{}\n[matrices]\nstiffness = [[\"1{sum}\", 0], [0, 1]]\n\
         [[sweep]]\nname = \"wide\"\nmethod = \"sobol\"\npoints = 4\n{QUANTITIES}{more}over = [{}]\n",
        parameters.join("\n"),
        over.join(", ")
    )
}

#[test]
fn more_keys_than_points_have_dimensions() {
    let help = "sweep fewer keys; with `sensitivity` a point takes two coordinates a key";
    for (keys, limit, more) in [(129, 128, ""), (65, 64, "sensitivity = true\n")] {
        let error = super::parse(&wide(keys, more), &[]).unwrap_err();
        let message = format!("{keys} keys are swept, but this method takes {limit} at most");
        assert_eq!((error.to_string(), help_of(&error)), (message, help.to_owned()));
        assert!(error.place().starts_with("[{ key = \"parameters.p0\""), "{}", error.place());
        assert_eq!(with_file(&wide(limit, more)).sweeps[0].axes.len(), limit);
    }
}

#[test]
fn more_points_than_can_be_told_apart() {
    let axis = |key: &str| format!("{{ key = \"{key}\", from = 0.1, to = 0.2, points = 2_000_000 }}");
    let list = format!("[{}, {}]", axis("operation.velocity"), axis("oscillator.damping_x"));
    sweep(
        &format!("over = {list}\n{QUANTITIES}"),
        "2000000 × 2000000 = 4000000000000 points are more than 1e12",
        &list,
        "take fewer points",
    );
    let list = r#"[{ key = "operation.velocity", from = 1e-4, to = 1e-2 }]"#;
    sweep(
        &format!(
            "method = \"sobol\"\npoints = 1_000_000_000_000\nsensitivity = true\nover = {list}\n{QUANTITIES}"
        ),
        "3000000000000 points are more than 1e12",
        list,
        "take fewer points",
    );
}
