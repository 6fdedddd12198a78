//! What `judder check` shows of a two-degrees case.

use crate::error::ModelError;
use crate::estimate::{estimate_json, estimate_text, title};
use crate::oscillator::stability_map::{ONE_WAY, class_name};
use crate::two_degrees::case::TwoDegreesCase;
use judder_study::case::text::CaseText;
use judder_study::model::estimates;
use judder_study::resolve::Resolved;
use judder_study::text::{columns, number};
use serde_json::{Value, json};

pub(super) fn resolve(
    file: &CaseText,
    case: &TwoDegreesCase,
    resolved: Value,
) -> Result<Resolved, ModelError> {
    let estimates = estimates(case, file, |name| name)?;
    let mut text = format!("{}\n\nparameters\n", title(&case.title));
    text.push_str(&columns(
        &case.parameters.iter().map(|p| vec![p.name.clone(), number(p.value)]).collect::<Vec<_>>(),
    ));
    let document_point = match analysed(case) {
        Ok((point, shown)) => {
            text.push_str(&shown);
            point
        }
        Err(reason) => {
            text.push_str(&format!("\nno answer at these parameters: {reason}\n"));
            Value::Null
        }
    };
    text.push_str(&estimate_text(&estimates));
    let document = json!({
        "case": resolved,
        "point": document_point,
        "estimate": estimate_json(&estimates),
        "warnings": [],
    });
    Ok(Resolved { document, text })
}

/// Eigenvalues and verdict at the case's own parameters, as a document and as text.
fn analysed(case: &TwoDegreesCase) -> Result<(Value, String), String> {
    use judder_oscillator::mechanism::StabilityClass;
    let system = case.matrices(&case.values()).map_err(|cause| cause.to_string())?;
    let reduced = system.reduced().map_err(|error| error.to_string())?;
    let values = judder_oscillator::spectrum::eigenvalues(&reduced).map_err(|error| error.to_string())?;
    let class = StabilityClass::of_system(&system).map_err(|error| error.to_string())?;
    let rows: Vec<Vec<String>> =
        values.iter().map(|l| vec![number(l.re), format!("{} i", number(l.im))]).collect();
    let text =
        format!("\nat these parameters: {}; eigenvalues\n{}", class_name(class, ONE_WAY), columns(&rows));
    let verdict = class.verdict().map_or("unresolved", judder_oscillator::Verdict::name);
    let document = json!({
        "eigenvalues": values.map(|l| [l.re, l.im]),
        "growth_rate": judder_oscillator::spectrum::growth_rate(&values),
        "verdict": verdict,
        "mechanism": if class.is_unstable() { class_name(class, ONE_WAY) } else { "none" },
    });
    Ok((document, text))
}
