//! The tables of contact analyses: coefficients, terms, errors of a law.

use crate::swept_tables::{table, told, word};
use crate::told_quantities::{ToldQuantity, quantities};
use judder_report::page::PageTable;
use judder_study::prefixed::PrefixedUnit;
use judder_study::registry::ToldAnalysis;
use judder_study::report_tables::{listed, uncertainty};
use judder_study::shown::{SHOWN_UNIT, ShownValues};
use serde_json::Value;

/// A number of a row.
fn number(row: &Value, key: &str) -> String {
    told(row[key].as_f64().unwrap_or(f64::NAN))
}

/// The items of a list; nothing where there are none.
fn list<'a>(analysis: ToldAnalysis<'a>, key: &str) -> Option<&'a Vec<Value>> {
    analysis.results.get(key).and_then(Value::as_array).filter(|items| !items.is_empty())
}

/// The fitted coefficients beside the paper's.
pub(crate) fn fit(analysis: ToldAnalysis<'_>) -> Vec<PageTable> {
    const NUMBERS: [&str; 5] = ["value", "standard_error", "paper", "deviation", "relative_deviation"];
    let head = [
        "coefficient",
        "fitted (−)",
        "standard error (−)",
        "the paper's (−)",
        "deviation (−)",
        "deviation (relative)",
    ];
    let of = |items: &Vec<Value>| {
        listed("Coefficients beside the paper's", &head, items, |_, own| {
            let numbers = NUMBERS.iter().map(|key| number(own, key));
            [word(&own["name"]).to_owned()].into_iter().chain(numbers).collect()
        })
    };
    list(analysis, "beside_the_paper").map(of).into_iter().collect()
}

/// What is told of a modulus.
const MODULUS: &[ToldQuantity] = &[
    ("rubbery_modulus_pascal", "rubbery modulus", "Pa"),
    ("glassy_modulus_pascal", "glassy modulus", "Pa"),
    ("contrast", "glassy over rubbery", "1"),
    ("mean_retardation_time_second", "mean retardation time", "s"),
    ("largest_loss_tangent", "largest loss tangent", "1"),
    ("terms", "terms", ""),
    ("measurements", "measurements", ""),
    ("storage_deviation", "how far they are from the storage modulus at most (relative)", "1"),
    ("loss_deviation", "the same of the loss modulus (relative)", "1"),
];

/// What is told of the modulus, and the terms of its creep form.
pub(crate) fn modulus(analysis: ToldAnalysis<'_>) -> Vec<PageTable> {
    let shown = ShownValues::called(analysis.results.get(SHOWN_UNIT).and_then(Value::as_str));
    let head = [&*shown.head("retardation time"), "compliance (1/Pa)"];
    let of = |items: &Vec<Value>| {
        listed("Terms of the creep form", &head, items, |_, own| {
            vec![shown.value(&own["time_second"]), number(own, "compliance_per_pascal")]
        })
    };
    let terms = list(analysis, "prony").map(of);
    terms.into_iter().chain(quantities("The modulus", analysis.results, MODULUS)).collect()
}

/// What the law is known to.
pub(crate) fn law(analysis: ToldAnalysis<'_>) -> Vec<PageTable> {
    let rows = [("interpolation_error", "between its knots"), ("solver_error", "of the solved contacts")];
    let rows = rows.into_iter().filter_map(|(key, words)| {
        let own = analysis.results.get(key)?;
        let numbers = ["force", "area", "friction"].map(|key| uncertainty(&own[key]));
        Some([words.to_owned()].into_iter().chain(numbers).collect())
    });
    let rows: Vec<Vec<String>> = rows.collect();
    let head = ["error", "force (relative)", "area (relative)", "friction (relative)"];
    if rows.is_empty() { Vec::new() } else { vec![table("What the law is known to".to_owned(), &head, rows)] }
}

/// What a contact tells: its name in groups, and what of it is told in SI, each in words, by its key, in its unit.
type QuantityOfContact = (&'static str, &'static [(&'static str, &'static str, &'static str)]);

const QUANTITIES: [QuantityOfContact; 5] = [
    ("force", &[("force per length", "force_newton_per_metre", "N/m"), ("force", "force_newton", "N")]),
    ("area", &[("width", "width_metre", "m"), ("area", "area_square_metre", "m²")]),
    ("friction", &[("friction coefficient", "", "")]),
    ("indentation", &[("indentation", "indentation_metre", "m")]),
    ("peak_pressure", &[("peak pressure", "peak_pressure_pascal", "Pa")]),
];

/// The results of one contact in SI and in groups, with their errors.
pub(crate) fn single(analysis: ToldAnalysis<'_>) -> Vec<PageTable> {
    let told_as = |key: &str| analysis.results.get(key).and_then(Value::as_f64);
    let Some(errors) = analysis.results.get("errors").and_then(Value::as_object) else { return Vec::new() };
    let mut rows = Vec::new();
    for (name, in_si) in QUANTITIES {
        let error = errors.get(name).and_then(Value::as_f64).unwrap_or(f64::NAN);
        let group = told_as(name).unwrap_or(f64::NAN);
        // of a line the first is per length, as the group is
        let told = in_si.iter().filter(|(_, key, _)| key.is_empty() || told_as(key).is_some());
        for (place, (words, key, unit)) in told.enumerate() {
            let si = told_as(key).map_or_else(String::new, |own| with_prefix(own, error, unit));
            let group = if place == 0 { within(group, error) } else { String::new() };
            let error = if error < 1.0 { uncertainty(&error.into()) } else { "–".to_owned() };
            rows.push(vec![(*words).to_owned(), si, group, error]);
        }
    }
    vec![table("The contact".to_owned(), &["quantity", "in SI", "in groups (−)", "error (relative)"], rows)]
}

fn with_prefix(value: f64, error: f64, unit: &str) -> String {
    let shown = PrefixedUnit::of(unit, value);
    format!("{} {}", within(shown.factor * value, error), shown.name)
}

/// A value with a relative error; where that is as large as the value, zero within it.
fn within(value: f64, error: f64) -> String {
    if error < 1.0 || !error.is_finite() {
        told(value)
    } else {
        format!("0 ± {}", uncertainty(&(value * error).abs().into()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn rows(results: &Value) -> Vec<Vec<String>> {
        let asked = Value::Null;
        single(ToldAnalysis { asked: &asked, results: results.as_object().unwrap() }).remove(0).rows
    }

    #[test]
    fn a_contact_is_told_in_si_and_in_groups() {
        let rows = rows(&json!({
            "force": 0.05, "area": 0.5, "friction": 2.8e-17, "indentation": 0.1, "peak_pressure": 0.125,
            "force_newton_per_metre": 15.0, "force_newton": 9.0, "width_metre": 1.015e-4, "area_square_metre": 6.09e-5,
            "indentation_metre": 2.06e-5, "peak_pressure_pascal": 188_428.0,
            "errors": { "force": 0.0, "area": 3.6e-3, "friction": 1.857, "indentation": 2e-5, "peak_pressure": 6e-5 },
        }));
        let row = |place: usize| rows[place].join(" | ");
        assert_eq!(row(0), "force per length | 15 N/m | 0.05 | 0");
        assert_eq!(row(1), "force | 9 N |  | 0");
        assert_eq!(row(2), "width | 101.5 µm | 0.5 | 0.0036");
        assert_eq!(row(3), "area | 60.9 mm² |  | 0.0036");
        assert_eq!(
            row(4),
            "friction coefficient |  | 0 ± 5.2e−17 | –",
            "an error as large as the value leaves no digit of it"
        );
        assert_eq!(row(6), "peak pressure | 188.428 kPa | 0.125 | 6e−5");
    }

    #[test]
    fn a_contact_that_ends_has_a_force_and_an_area() {
        let rows = rows(&json!({
            "force": 0.05, "area": 0.5, "force_newton": 9.0, "area_square_metre": 6.09e-5,
            "errors": { "force": 1e-3, "area": 3.6e-3 },
        }));
        assert_eq!((&*rows[0][0], &*rows[0][2], &*rows[1][0]), ("force", "0.05", "area"));
    }
}
