//! What `judder check` shows of an oscillator case.

use super::quasi_steady::QuasiSteadyCondition;
use super::{KnownOscillator, point};
use crate::bridge;
use crate::error::ModelError;
use crate::estimate::{estimate_json, estimate_text, title};
use crate::known_substrate::KnownSubstrate;
use crate::measured_band::excited_at;
use crate::oscillator::case::OscillatorCase;
use crate::oscillator::keys::OscillatorKey;
use crate::oscillator::law_name::LawName;
use judder_contact::{HertzLaw, Law};
use judder_keys::keys::Keys;
use judder_keys::numeric_key::Form;
use judder_oscillator::Contact;
use judder_oscillator::groups::Dimensional;
use judder_study::case::text::CaseText;
use judder_study::model::estimates;
use judder_study::resolve::Resolved;
use judder_study::text::{columns, list, number};
use serde_json::{Value, json};

/// Where nothing is known of the operating point: a law that would have to be computed first.
const LATER: &str = "the law `bem` is computed by a run, which takes seconds to minutes";

pub(super) fn resolve(
    file: &CaseText,
    case: &OscillatorCase,
    resolved: Value,
) -> Result<Resolved, ModelError> {
    let groups = bridge::groups(&case.inputs);
    let dimensional = groups.dimensional(&case.inputs.scales());
    // a law that cannot be read is no matter of the operating point
    let known = bridge::known_contact(case)?;
    let limits = match &known {
        None => Err(LATER.to_owned()),
        Some(_) => point::point(case).map_err(|error| format!("no answer: {error}")),
    };
    let contact = known.as_ref().map(|own| &own.contact);
    let estimates = estimates(case, file, |name| KnownOscillator { name, case, contact })?;
    let mut text = format!(
        "{}\n\nlaw {}, friction load {}\n\n",
        title(&case.title),
        case.law.name(),
        case.friction_load.name()
    );
    text.push_str(&columns(&key_rows(case)));
    text.push_str("\ndimensionless, and with units\n");
    let rows = group_rows(&groups, &dimensional);
    text.push_str(&columns(
        &rows
            .iter()
            .map(|(name, group, unit)| vec![(*name).to_owned(), number(*group), unit.clone()])
            .collect::<Vec<_>>(),
    ));
    // without a law nothing is known of steady sliding, but of the frequency and the substrate
    let (condition, of_band) = match &limits {
        Ok(point) => (point.quasi_steady, None),
        Err(_) => {
            let substrate = KnownSubstrate::of(case)?;
            // how large the contact is an elastic one tells near enough
            let hertz = Contact { law: Law::Hertz(HertzLaw::default()), friction_load: case.friction_load };
            let is_round = case.law == LawName::Bem && case.length.is_none();
            let excited = excited_at(&hertz, &case.inputs).filter(|_| is_round);
            (
                QuasiSteadyCondition::at(&case.inputs, None, &substrate.terms),
                substrate.band.and_then(|band| band.warning(excited)),
            )
        }
    };
    text.push_str("\nat the operating point\n");
    let document_limits = match &limits {
        Ok(point) => {
            text.push_str(&columns(&[
                vec!["steady sliding".to_owned(), point.steady.verdict_in_words()],
                vec!["growth rate".to_owned(), number(point.steady.growth_rate())],
                vec!["critical shear strength (undamped)".to_owned(), list(&point.critical_shear_strength)],
                vec!["critical load (undamped)".to_owned(), list(&point.critical_load)],
            ]));
            point.json()
        }
        Err(error) => {
            text.push_str(&format!("  {error}\n"));
            Value::Null
        }
    };
    if let Some(condition) = &condition {
        text.push_str(&columns(&condition.rows()));
    }
    text.push_str(&estimate_text(&estimates));
    let warnings: Vec<String> = limits
        .map(|point| point.warnings)
        .unwrap_or_else(|_| {
            condition.and_then(|condition| condition.warning(None)).into_iter().chain(of_band).collect()
        })
        .into_iter()
        .collect::<std::collections::BTreeSet<_>>()
        .into_iter()
        .collect();
    for warning in &warnings {
        text.push_str(&format!("\nwarning: {warning}\n"));
    }
    let document = json!({
        "case": resolved,
        "groups": rows.iter().map(|(name, group, _)| ((*name).to_owned(), json!(group))).collect::<serde_json::Map<_, _>>(),
        "point": document_limits,
        "quasi_steady": condition.as_ref().map(QuasiSteadyCondition::json),
        "estimate": estimate_json(&estimates),
        "warnings": warnings,
    });
    Ok(Resolved { document, text })
}

fn key_rows(case: &OscillatorCase) -> Vec<Vec<String>> {
    OscillatorKey::ALL
        .iter()
        .filter(|key| case.substrate.has(key.key))
        .map(|key| {
            let value = case.inputs.get(key.key);
            let unit = match value.form {
                Form::Group => key.rule.group.map_or(String::new(), |group| format!("= {group}")),
                Form::Si => key.rule.dimension.unit(),
            };
            vec![key.path.to_owned(), number(value.number), unit]
        })
        .chain(line_rows(case.substrate.thickness, case.length))
        .collect()
}

/// The lengths of a cylinder on its layer, in m.
pub(crate) fn line_rows(thickness: Option<f64>, length: Option<f64>) -> impl Iterator<Item = Vec<String>> {
    let rows = [("substrate.thickness", thickness), ("indenter.length", length)];
    let row = |(key, value): (&str, Option<f64>)| Some(vec![key.to_owned(), number(value?), "m".to_owned()]);
    rows.into_iter().filter_map(row)
}

/// Name, group, and the quantity that it stands for.
fn group_rows(
    groups: &judder_oscillator::Groups,
    dimensional: &Dimensional,
) -> Vec<(&'static str, f64, String)> {
    let with = |value: f64, unit: &str| format!("{} {unit}", number(value));
    vec![
        ("k_x/(E0* R)", groups.stiffness, with(dimensional.stiffness_x, "N/m")),
        ("ω_nx τ", groups.retardation_time, with(dimensional.retardation_time, "s")),
        ("R/x0", groups.radius(), with(dimensional.radius, "m")),
        ("v_d τ/R", groups.velocity, with(dimensional.velocity, "m/s")),
        ("F_n/(E0* R²)", groups.normal_load, with(dimensional.normal_load, "N")),
        ("τ0/E0*", groups.shear_strength, with(dimensional.shear_strength, "Pa")),
    ]
}
