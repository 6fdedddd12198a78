//! The value of every key, with and without units.

use super::{inputs, sections};
use crate::body::JsonBody;
use crate::refusal::RequestRefusal;
use crate::site::SharedSite;
use crate::view::View;
use axum::Json;
use axum::extract::State;
use judder_keys::keys::Keys;
use judder_keys::numeric_key::Form;
use judder_models::bridge;
use judder_models::oscillator::inputs::OscillatorInputs;
use judder_models::oscillator::keys::OscillatorKey;
use judder_oscillator::Groups;
use judder_oscillator::groups::Dimensional;
use serde_json::{Value, json};

/// Answers `/api/case`.
pub(crate) async fn answer(
    State(site): SharedSite,
    JsonBody(view): JsonBody<View>,
) -> Result<Json<Value>, RequestRefusal> {
    view.check()?;
    site.compute(move |subject, _| {
        let file = subject.with(&view.set)?;
        Ok(Json(document(&inputs(&file)?, sections(&file.case))))
    })
    .await
}

/// The values of all keys of the case's sections, and the scales between their two forms.
pub(crate) fn document(inputs: &OscillatorInputs, sections: &[&str]) -> Value {
    let (groups, scales) = (bridge::groups(inputs), inputs.scales());
    let dimensional = groups.dimensional(&scales);
    let own = OscillatorKey::ALL.iter().filter(|entry| sections.contains(&entry.section()));
    let values: Vec<Value> = own.map(|entry| value(entry.key, inputs, &groups, &dimensional)).collect();
    let mut known = json!({
        "reduced_modulus": scales.reduced_modulus,
        "radius": scales.radius,
        "time": inputs.number(OscillatorKey::RetardationTime),
    });
    if sections.contains(&"oscillator") {
        known["natural_frequency"] = json!(scales.natural_frequency);
        known["length"] = json!(scales.radius / groups.radius());
    }
    // E0*, R, τ; with an oscillator ω_nx and x0 = F_n/k_x
    json!({ "values": values, "scales": known })
}

/// Both forms of a key: of the three that have a group, the one that was not given follows.
fn value(key: OscillatorKey, inputs: &OscillatorInputs, groups: &Groups, dimensional: &Dimensional) -> Value {
    let given = inputs.get(key);
    let (group, si) = match (key, given.form) {
        (OscillatorKey::Velocity, _) => (Some(groups.velocity), Some(dimensional.velocity)),
        (OscillatorKey::NormalLoad, _) => (Some(groups.normal_load), Some(dimensional.normal_load)),
        (OscillatorKey::ShearStrength, _) => (Some(groups.shear_strength), Some(dimensional.shear_strength)),
        (_, Form::Group) => (Some(given.number), None),
        (_, Form::Si) => (None, Some(given.number)),
    };
    let form = match given.form {
        Form::Group => "group",
        Form::Si => "si",
    };
    json!({ "path": key.entry().path, "form": form, "number": given.number, "group": group, "si": si })
}
