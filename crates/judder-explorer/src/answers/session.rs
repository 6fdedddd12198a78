//! What the page needs to know of the case before anything is computed.

use super::{case, inputs, oscillator, sections};
use crate::limits::is_settable;
use crate::site::SharedSite;
use axum::Json;
use axum::extract::State;
use judder_keys::cause::Cause;
use judder_keys::declared::{Declaration, Listed};
use judder_keys::keys::{Key, Keys};
use judder_keys::numeric_key::Form;
use judder_models::contact::case::ContactCase;
use judder_models::oscillator::case::OscillatorCase;
use judder_models::oscillator::inputs::TimeForm;
use judder_models::oscillator::keys::OscillatorKey;
use judder_models::sweep::{StabilityMapAnalysis, Sweep};
use judder_models::{REGISTRY, worded};
use judder_study::case::analysis::KindEntry;
use judder_study::case::file::CaseFile;
use judder_study::study_view::shown_text;
use serde_json::{Map, Value, json};

/// Answers `/api/session`.
pub(crate) async fn answer(State(site): SharedSite) -> Json<Value> {
    let base = site.subject.base();
    let resolved = base.map(|base| base.case.resolved()).unwrap_or_default();
    let own = base.map_or(&[][..], |base| sections(&base.case));
    let values = base.and_then(|base| Some(case::document(&inputs(base).ok()?, own)));
    // what slides steadily without an oscillator, or is none, has no stability to map and no law to choose
    let oscillator = base.and_then(|base| oscillator(base).ok());
    let map = oscillator.map(|oscillator| {
        oscillator
            .analyses
            .iter()
            .find_map(|analysis| analysis.settings().map(axes))
            .unwrap_or_else(usual_axes)
    });
    let keys = OscillatorKey::ALL.iter().filter(|entry| own.contains(&entry.section()));
    Json(json!({
        "version": judder_study::version(),
        "title": resolved["title"].as_str().map(shown_text),
        "case": base.map(|base| json!({ "name": base.name, "file": base.origin, "model": base.case.model(), "text": base.text })),
        "keys": keys.map(|entry| key(entry, base.is_some_and(|base| takes(base, entry)))).collect::<Vec<_>>(),
        "values": values,
        "choices": base.map(|base| choices(base.case.model(), own, &resolved)).unwrap_or_default(),
        "map": map,
        "analyses": analyses(&resolved),
        "settings": base.map(|base| settings(base.case.model())).unwrap_or_default(),
        "study": site.subject.study.as_ref().map(|study| json!({ "name": study.view.name() })),
    }))
}

/// The keys of these sections that take one of a few words, with what the case says; one that it leaves out comes with others and is not chosen alone.
fn choices(model: &str, sections: &[&str], resolved: &Value) -> Vec<Value> {
    let choice = |own: Listed| {
        let (section, key) = own.path.split_once('.')?;
        let words = own.words();
        let value = word(&resolved[section][key], &words)?;
        sections.contains(&section).then(|| {
            json!({ "path": own.path, "section": section, "doc": own.key.doc, "value": value, "words": words })
        })
    };
    worded(model).into_iter().filter_map(choice).collect()
}

/// The word that a value is, or that its table has; of another table its first key.
fn word<'a>(value: &'a Value, words: &[&str]) -> Option<&'a str> {
    let in_table = || {
        let table = value.as_object()?;
        let known = table.values().filter_map(Value::as_str).find(|word| words.contains(word));
        known.or_else(|| table.keys().next().map(String::as_str))
    };
    value.as_str().or_else(in_table)
}

/// The analyses of the case, with their kinds.
fn analyses(resolved: &Value) -> Vec<Value> {
    let listed = resolved["analysis"].as_array().into_iter().flatten();
    listed.map(|analysis| json!({ "name": analysis["name"], "kind": analysis["kind"] })).collect()
}

/// Whether the case takes a value of this key, which it has: of two keys that say the same only the one that it has, and none that its data decide.
fn takes(base: &CaseFile, entry: &Key<OscillatorKey>) -> bool {
    let of_oscillator = base.case.of().map(|case: &OscillatorCase| &case.inputs);
    let of_contact = || base.case.of().map(|case: &ContactCase| &case.inputs);
    let Some(inputs) = of_oscillator.or_else(of_contact) else { return false };
    let says_relaxation = inputs.time_form() == TimeForm::Relaxation;
    if entry.key == OscillatorKey::RelaxationTime && !says_relaxation {
        return false;
    }
    let value = entry.default.map_or_else(|| entry.rule.example(), str::to_owned);
    let options = [&base.overrides[..], &[format!("{}={value}", entry.path)]].concat();
    // a value that does not fit the others is still one that can be set
    let refused = judder_models::parse(&base.origin, &base.text, &options).err();
    !refused.is_some_and(|error| matches!(error.cause(), Cause::Conflict { .. }))
}

/// A key with its words, its range and its slider.
fn key(entry: &Key<OscillatorKey>, is_settable: bool) -> Value {
    let (from, to, scale) = slider(entry);
    json!({
        "path": entry.path, "section": entry.section(), "symbol": entry.symbol, "group": entry.rule.group,
        "unit": entry.rule.dimension.unit(), "doc": entry.doc, "range": entry.rule.range.document(), "settable": is_settable,
        "slider": { "from": from, "to": to, "scale": scale },
        "label": entry.label(Form::Group), "label_si": entry.label(Form::Si),
    })
}

/// What the slider of a key runs over, as a group where there is one, else in SI units.
fn slider(entry: &Key<OscillatorKey>) -> (f64, f64, &'static str) {
    let [from, to] = entry.typical();
    (from, to, if from > 0.0 { "log" } else { "linear" })
}

/// What is said of the settings of each kind of analysis that may be asked for: those of the case's model, and of the contact of an oscillator.
fn settings(model: &str) -> Map<String, Value> {
    let derived = (model == "oscillator").then_some("contact");
    let kinds =
        REGISTRY.kinds_of(model).chain(derived.into_iter().flat_map(|model| REGISTRY.kinds_of(model)));
    let keys = |kind: &KindEntry| {
        let declared = (kind.declared)();
        declared.iter().filter(|key| is_settable(key.name)).map(Declaration::document).collect::<Vec<_>>()
    };
    kinds.map(|kind| (kind.name.to_owned(), json!({ "doc": kind.doc, "keys": keys(&kind) }))).collect()
}

/// The axes of a stability map.
fn axes(map: &StabilityMapAnalysis<OscillatorKey>) -> Value {
    json!({ "x": axis(&map.x), "y": axis(&map.y) })
}

fn axis(sweep: &Sweep<OscillatorKey>) -> Value {
    let unit = sweep.key.entry().rule.dimension.unit();
    let end = |value: f64| match sweep.form {
        Form::Group => json!(value),
        Form::Si => json!(format!("{value:e} {unit}")),
    };
    json!({ "key": sweep.path, "from": end(sweep.from), "to": end(sweep.to), "scale": sweep.scale.name() })
}

/// Those of Fig. 9 of the oscillator paper.
fn usual_axes() -> Value {
    let axis = |key: OscillatorKey| {
        let (from, to, scale) = slider(key.entry());
        json!({ "key": key.entry().path, "from": from, "to": to, "scale": scale })
    };
    json!({ "x": axis(OscillatorKey::Velocity), "y": axis(OscillatorKey::ShearStrength) })
}
