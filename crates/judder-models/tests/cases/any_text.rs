//! No text, and no option, makes the reader panic; every error points into the text that it concerns.

use proptest::prelude::*;

use super::parse;
use judder_models::template::{template, templates};
use miette::Diagnostic;

/// Fragments of case files, right and wrong, from which texts are put together.
fn fragment() -> impl Strategy<Value = String> {
    let known = prop::sample::select(vec![
        "model = \"oscillator\"\n",
        "model = \"two-degrees\"\n",
        "model = \"structure\"\n",
        "model = \"sliding\"\n",
        "[[structure]]\nname = \"a\"\n",
        "[motion]\n",
        "slider = { structure = \"a\", set = ",
        "kind = \"locus\"\nat = \"1 mm\"\nsweep = { key = ",
        "kind = \"march\"\nmethod = \"film\"\n",
        "[structure]\n",
        "[damping]\n",
        "[reduction]\n",
        "beam = { length = \"1 m\", thickness = ",
        "block = { size = [\"1 m\", ",
        "mass = [{ file = \".\", factor = ",
        "kept = [{ set = ",
        "kind = \"modes\"\n",
        "kind = \"eigen-sweep\"\n",
        "region = { re = [0, 1], im = [",
        "[substrate]\n",
        "[operation]\n",
        "[contact]\n",
        "[parameters]\n",
        "[matrices]\n",
        "[[analysis]]\n",
        "[[sweep]]\nname = \"s\"\nquantities = [\"q\", \"spectrum.",
        "[[sweep]]\nname = \"s\"\nquantities = [\"q\"]\n",
        "method = \"sobol\"\npoints = 4\n",
        "over = [{ key = \"operation.velocity\", from = 1e-3, to = ",
        "over = [{ key = \"analysis.0.sweep.points\", values = [3, ",
        "sensitivity = {",
        "kind = \"spectrum\"\n",
        "kind = \"stability-map\"\n",
        "kind = \"critical\"\n",
        "sweep = { key = \"operation.velocity\", from = 1e-8, to = 1, points = 3 }\n",
        "sweep = { key = \"mu\", from = ",
        "velocity = ",
        "prony = [{ time = \"1 s\", compliance = ",
        "mu = ",
        "stiffness = [[2, \"1 - mu\"], [1, ",
        "\"30 mm/s\"",
        "\"µ²\"",
        "9223372036854775808",
        "0xffffffffffffffffff",
        "-inf",
        "\n",
        "}]\n",
        "]]\n",
        "\"\"\"x\"\"\"",
        "'\\u0000'",
    ]);
    prop_oneof![4 => known.prop_map(str::to_owned), 1 => "\\PC{0,12}", 1 => "[ -~]{0,6}\n"]
}

fn check(text: &str, overrides: &[&str]) {
    if let Err(error) = parse(text, overrides) {
        let place = error.place().len();
        let span = error.labels().and_then(|mut labels| labels.next()).map_or(0, |label| label.len());
        // a long place is labelled in part
        assert!(place == span || (place > 2000 && span <= 2000), "{error} lies outside its text");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn texts(fragments in prop::collection::vec(fragment(), 0..12)) {
        check(&fragments.concat(), &[]);
    }

    #[test]
    fn options(key in "[a-z_.]{0,12}|operation\\.velocity|analysis|contact\\.law", value in "\\PC{0,16}|[0-9a-z\"{}\\[\\]=., ]{0,16}") {
        check("model = \"oscillator\"", &[&format!("{key}={value}"), &value]);
    }

    #[test]
    fn damaged_templates(which in 0..templates().len(), start in 0..2000_usize, length in 0..20_usize, patch in "\\PC{0,4}") {
        let mut text: Vec<char> = template(templates()[which]).unwrap().chars().collect();
        let start = start.min(text.len());
        let end = (start + length).min(text.len());
        text.splice(start..end, patch.chars());
        check(&text.into_iter().collect::<String>(), &[]);
    }
}

#[test]
fn a_very_long_option_is_refused() {
    check("model = \"oscillator\"", &[&format!("{}=1", "a.".repeat(100_000))]);
}
