//! The resolved case as canonical JSON: every key with the value in use, keys sorted, the same bytes each time.

mod motion;
mod sliding;
mod structure;
mod sweep;

use serde_json::{Map, Value as Json, json};

use crate::analysis::Analysis;
use crate::case_file::Case;
use crate::contact_analysis::ContactAnalysis;
use crate::contact_case::ContactCase;
use crate::declared::{Setting, Settings};
use crate::dimension::Dimension;
use crate::inputs::{LawName, TimeForm};
use crate::keys::{Form, KEYS, OscillatorKey};
use crate::oscillator_analysis::{DampingCurves, OscillatorAnalysis, SpectrumCurves};
use crate::oscillator_case::OscillatorCase;
use crate::span::Span;
use crate::substrate::{Substrate, SubstrateKeys};
use crate::sweep::{Family, ParameterKey, StabilityMap, Sweep, Within};
use crate::swept_keys::OscillatorKeys;
use crate::two_degrees::{TwoDegreesAnalysis, TwoDegreesCase};

impl Case {
    /// The case with every default filled in, for the hash of a study and for its report.
    ///
    /// A group is a number; a quantity is `{"value": …, "unit": …}` in SI units.
    pub fn resolved(&self) -> Json {
        let mut json = match self {
            Self::Oscillator(case) => oscillator(case),
            Self::Contact(case) => contact(case),
            Self::Belt(case) => motion::belt(case),
            Self::TwoDegrees(case) => two_degrees(case),
            Self::Structure(case) => structure::case(case),
            Self::Sliding(case) => sliding::case(case),
        };
        // another crate of the build may have switched serde_json to insertion order
        json.sort_all_objects();
        json
    }
}

fn oscillator(case: &OscillatorCase) -> Json {
    let mut json = json!({
        "model": "oscillator",
        "title": case.title,
        "contact": { "law": case.law.name(), "friction_load": case.friction_load.name() },
        "analysis": case.analyses.iter().map(|analysis| named(analysis, oscillator_analysis)).collect::<Vec<_>>(),
    });
    if let Some(file) = &case.law_file {
        json["contact"]["law"] = json!({ "file": file.given });
    }
    if case.law == LawName::Bem {
        json["contact"]["law"] = json!({ "computed": true, "accuracy": case.law_accuracy });
    }
    json["substrate"] = substrate(&case.substrate, case.inputs.time_form());
    for entry in KEYS.iter().filter(|entry| case.substrate.takes(entry.key)) {
        let value = case.inputs.get(entry.key);
        json[entry.section()][entry.name()] = number(value.number, value.form, entry.dimension);
    }
    json
}

fn contact(case: &ContactCase) -> Json {
    let mut json = json!({
        "model": "contact",
        "title": case.title,
        "indenter": { "shape": Setting::write(&case.shape, &()) },
        "analysis": case.analyses.iter().map(|analysis| named(analysis, contact_analysis)).collect::<Vec<_>>(),
    });
    json["substrate"] = substrate(&case.substrate, case.inputs.time_form());
    let keys = ContactCase::KEYS.into_iter().filter(|key| case.substrate.takes(*key));
    for entry in keys.map(OscillatorKey::entry) {
        let value = case.inputs.get(entry.key);
        json[entry.section()][entry.name()] = number(value.number, value.form, entry.dimension);
    }
    json
}

/// How the relaxation was given, and what a substrate has beside its numeric keys.
fn substrate(substrate: &Substrate, time_form: TimeForm) -> Json {
    let given_as = substrate.source.key().unwrap_or(time_form.name());
    let mut json = Map::from_iter([("given_as".to_owned(), json!(given_as))]);
    SubstrateKeys::from(substrate).write_table(&mut json);
    Json::Object(json)
}

fn contact_analysis(kind: &ContactAnalysis) -> Json {
    match kind {
        ContactAnalysis::Contact(settings) => declared("contact", settings),
        ContactAnalysis::ContactLaw(law) => declared("contact-law", law),
        ContactAnalysis::Fit(fit) => {
            let mut json = declared("fit", &fit.law);
            json["velocity_scale"] = json!(fit.reading.velocity_scale);
            json
        }
        ContactAnalysis::Modulus(settings) => declared("modulus", settings),
        ContactAnalysis::Transient(settings) => declared("transient", settings),
    }
}

fn span(span: &Span, dimension: Dimension) -> Json {
    let end = |end| number(end, span.form, dimension);
    json!({ "from": end(span.from), "to": end(span.to), "points": span.points })
}

fn two_degrees(case: &TwoDegreesCase) -> Json {
    let parameters = case.parameters.iter().map(|parameter| json!([parameter.name, parameter.value]));
    let matrices: Map<_, _> =
        case.expressions().into_iter().map(|(name, texts)| (name.to_owned(), json!(texts))).collect();
    json!({
        "model": "two-degrees",
        "title": case.title,
        "parameters": parameters.collect::<Vec<_>>(),
        "matrices": matrices,
        "analysis": case.analyses.iter().map(|analysis| named(analysis, two_degrees_analysis)).collect::<Vec<_>>(),
    })
}

fn named<T>(analysis: &Analysis<T>, settings: impl Fn(&T) -> Json) -> Json {
    let mut json = settings(&analysis.kind);
    json["name"] = json!(analysis.name);
    json
}

fn oscillator_analysis(kind: &OscillatorAnalysis) -> Json {
    match kind {
        OscillatorAnalysis::EquivalentDamping(DampingCurves { sweep: axis, family: curves }) => json!({
            "kind": "equivalent-damping", "sweep": sweep(axis), "family": curves.as_ref().map(family),
        }),
        OscillatorAnalysis::Spectrum(SpectrumCurves { sweep: axis, family: curves }) => json!({
            "kind": "spectrum", "sweep": sweep(axis), "family": curves.as_ref().map(family),
        }),
        OscillatorAnalysis::Critical(asked) => json!({
            "kind": asked.sought.kind(), "sweep": sweep(&asked.sweep), "within": within(&asked.within, asked.sought.key()),
            "family": asked.family.as_ref().map(family), "global_margin": asked.global_margin,
        }),
        OscillatorAnalysis::StabilityMap(map) => {
            let mut json = stability_map(map);
            json["global_margin"] = json!(map.global_margin);
            json
        }
        OscillatorAnalysis::Motion(kind) => motion::motion::<OscillatorKeys>(kind),
        OscillatorAnalysis::Engines(settings) => motion::engines(settings),
    }
}

fn two_degrees_analysis(kind: &TwoDegreesAnalysis) -> Json {
    match kind {
        TwoDegreesAnalysis::Spectrum { sweep: axis } => json!({ "kind": "spectrum", "sweep": sweep(axis) }),
        TwoDegreesAnalysis::StabilityMap(map) => stability_map(map),
        TwoDegreesAnalysis::Critical { sweep: axis } => json!({ "kind": "critical", "sweep": sweep(axis) }),
    }
}

/// A key with a dimension of its own.
trait Dimensioned: Copy {
    fn dimension(self) -> Dimension;
}

impl Dimensioned for OscillatorKey {
    fn dimension(self) -> Dimension {
        self.entry().dimension
    }
}

impl Dimensioned for ParameterKey {
    fn dimension(self) -> Dimension {
        Dimension::NUMBER
    }
}

fn stability_map<K: Dimensioned>(map: &StabilityMap<K>) -> Json {
    json!({
        "kind": "stability-map", "x": sweep(&map.x), "y": sweep(&map.y),
        "method": map.method.name(), "boundaries": map.boundaries,
    })
}

fn sweep<K: Dimensioned>(sweep: &Sweep<K>) -> Json {
    let end = |end| number(end, sweep.form, sweep.key.dimension());
    json!({
        "key": sweep.path, "from": end(sweep.from), "to": end(sweep.to), "points": sweep.points,
        "scale": sweep.scale.name(),
    })
}

fn family<K: Dimensioned>(family: &Family<K>) -> Json {
    let values = family.values.iter().map(|value| number(*value, family.form, family.key.dimension()));
    json!({ "key": family.path, "values": values.collect::<Vec<_>>() })
}

fn within(within: &Within, sought: OscillatorKey) -> Json {
    let end = |end| number(end, within.form, sought.dimension());
    json!({ "from": end(within.from), "to": end(within.to) })
}

/// Declared settings of an analysis of this kind.
fn declared(kind: &str, settings: &impl Settings) -> Json {
    let mut json = Map::from_iter([("kind".to_owned(), json!(kind))]);
    settings.write_table(&mut json);
    Json::Object(json)
}

fn number(number: f64, form: Form, dimension: Dimension) -> Json {
    match form {
        Form::Group => json!(number),
        Form::Si => json!({ "value": number, "unit": dimension.unit() }),
    }
}
