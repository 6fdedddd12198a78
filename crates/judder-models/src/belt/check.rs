//! What `judder check` shows of a belt case.

use crate::belt::case::{BeltCase, BeltKey};
use crate::error::ModelError;
use crate::estimate::{estimate_json, estimate_text, title};
use crate::motion::doubts;
use crate::motion::model::{BeltModel, Moving};
use judder_keys::keys::{Key, Keys};
use judder_keys::numeric_key::{Form, Value};
use judder_oscillator::motion::SlidingSystem;
use judder_study::case::text::CaseText;
use judder_study::model::estimates;
use judder_study::resolve::Resolved;
use judder_study::text::{columns, number};
use serde_json::{Value as Json, json};

pub(super) fn resolve(file: &CaseText, case: &BeltCase, resolved: Json) -> Result<Resolved, ModelError> {
    let operating = BeltModel::new(case, "").operating(None)?;
    let warnings: Vec<String> = doubts::beyond_law::<BeltModel<'_>, 2>(&operating, &[]).into_iter().collect();
    let system = operating.system;
    let estimates = estimates(case, file, |name| BeltModel::new(case, name))?;
    let has_meaning = |key: &&Key<BeltKey>| case.curve.is_none() || key.section() != "friction";
    let written = |key: &Key<BeltKey>| {
        let Value { number: own, form } = case.inputs.get(key.key);
        match form {
            Form::Group => number(own),
            Form::Si => format!("{} {}", number(own), key.rule.dimension.unit()),
        }
    };
    let keys = BeltKey::ALL
        .iter()
        .filter(has_meaning)
        .filter(|key| case.inputs.has(key.key))
        .map(|key| vec![key.path.to_owned(), written(key)]);
    let mut text = format!("{}\n\n{}", title(&case.title), columns(&keys.collect::<Vec<_>>()));
    let damping = system.equivalent_damping();
    let [displacement, _] = system.steady_sliding();
    let verdict = system.verdict().name();
    text.push_str("\nat the operating point\n");
    text.push_str(&columns(&[
        vec!["steady sliding".to_owned(), verdict.to_owned()],
        vec!["displacement".to_owned(), number(displacement)],
        vec!["equivalent damping".to_owned(), number(damping)],
    ]));
    text.push_str(&estimate_text(&estimates));
    let document = json!({
        "case": resolved,
        "point": { "verdict": verdict, "displacement": displacement, "equivalent_damping": damping },
        "estimate": estimate_json(&estimates),
        "warnings": warnings,
    });
    Ok(Resolved { document, text })
}
