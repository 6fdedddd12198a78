//! The resolved case as canonical JSON: every key with the value in use, keys sorted, the same bytes each time.

mod motion;
mod sliding;
mod structure;
mod sweep;

use serde_json::{Map, Value as Json, json};

use crate::analysis::Analysis;
use crate::case_file::Case;
use crate::contact_analysis::{ContactAnalysis, LawSettings, Loading};
use crate::contact_case::ContactCase;
use crate::contact_keys::ContactKey;
use crate::continuous::{ContinuousSource, Density, DensitySample, TermChoice};
use crate::declared::Settings;
use crate::dimension::Dimension;
use crate::inputs::LawName;
use crate::keys::{Form, KEYS, OscillatorKey, Value};
use crate::oscillator_analysis::{DampingCurves, OscillatorAnalysis, SpectrumCurves};
use crate::oscillator_case::OscillatorCase;
use crate::shape::{Roughness, Shape};
use crate::span::Span;
use crate::substrate::{
    PronyTerm, RelaxationSource, RelaxationTerm, Shift, Substrate, Temperature, TermCount,
};
use crate::sweep::{Family, ParameterKey, StabilityMap, Sweep, Within};
use crate::swept_keys::OscillatorKeys;
use crate::transient_analysis::{Motion, Oscillation, TransientSettings};
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
        "substrate": { "given_as": case.time_form().name() },
        "analysis": case.analyses.iter().map(|analysis| named(analysis, oscillator_analysis)).collect::<Vec<_>>(),
    });
    if let Some(file) = &case.law_file {
        json["contact"]["law"] = json!({ "file": file.given });
    }
    if case.law == LawName::Bem {
        json["contact"]["law"] = json!({ "computed": true, "accuracy": case.law_accuracy });
    }
    add_substrate(&mut json["substrate"], &case.substrate);
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
        "substrate": { "given_as": case.inputs.time_form().name() },
        "indenter": { "shape": shape(&case.shape) },
        "analysis": case.analyses.iter().map(|analysis| named(analysis, contact_analysis)).collect::<Vec<_>>(),
    });
    add_substrate(&mut json["substrate"], &case.substrate);
    let keys = ContactCase::KEYS.into_iter().filter(|key| case.substrate.takes(*key));
    for entry in keys.map(OscillatorKey::entry) {
        let value = case.inputs.get(entry.key);
        json[entry.section()][entry.name()] = number(value.number, value.form, entry.dimension);
    }
    json
}

/// Adds what a substrate has beside its numeric keys.
fn add_substrate(json: &mut Json, substrate: &Substrate) {
    let si = |value: f64, key: ContactKey| number(value, Form::Si, key.entry().dimension);
    match &substrate.source {
        RelaxationSource::OneTime => (),
        RelaxationSource::Prony(terms) => {
            let term = |term: &PronyTerm| {
                json!({
                    "time": si(term.retardation_time, ContactKey::PronyTime),
                    "compliance": si(term.compliance, ContactKey::PronyCompliance),
                })
            };
            json["given_as"] = json!("prony");
            json["prony"] = terms.iter().map(term).collect();
        }
        RelaxationSource::Relaxation(terms) => {
            let term = |term: &RelaxationTerm| {
                json!({
                    "time": si(term.relaxation_time, ContactKey::RelaxationTime),
                    "modulus": si(term.modulus, ContactKey::RelaxationModulus),
                })
            };
            json["given_as"] = json!("relaxation");
            json["relaxation"] = terms.iter().map(term).collect();
        }
        RelaxationSource::Continuous(source) => {
            json["given_as"] = json!("continuous");
            json["continuous"] = continuous(source);
        }
        RelaxationSource::Dma { file, terms, .. } => {
            let terms = match terms {
                TermCount::Auto => json!("auto"),
                TermCount::Given(count) => json!(count),
            };
            json["given_as"] = json!("dma");
            json["dma"] = json!({ "file": file.given, "terms": terms });
        }
    }
    if let Some(Temperature { temperature, shift }) = &substrate.temperature {
        json["temperature"] = si(*temperature, ContactKey::Temperature);
        json["shift"] = match *shift {
            Shift::Wlf { first, second, reference } => json!({ "wlf": {
                "c1": first, "c2": si(second, ContactKey::WlfSecond),
                "reference_temperature": si(reference, ContactKey::WlfReference),
            } }),
            Shift::Arrhenius { activation_energy, reference } => json!({ "arrhenius": {
                "activation_energy": si(activation_energy, ContactKey::ActivationEnergy),
                "reference_temperature": si(reference, ContactKey::ArrheniusReference),
            } }),
        };
    }
}

fn continuous(source: &ContinuousSource) -> Json {
    let time = |time: f64| number(time, Form::Si, Dimension::TIME);
    let mut json = match &source.density {
        Density::LogNormal { median, width } => {
            json!({ "log_normal": { "median": time(*median), "width": width } })
        }
        Density::PowerLaw { from, to, exponent } => {
            json!({ "power_law": { "from": time(*from), "to": time(*to), "exponent": exponent } })
        }
        Density::Samples(samples) => {
            let sample = |sample: &DensitySample| {
                let density = number(sample.density, Form::Si, Dimension::COMPLIANCE_RATE);
                json!({ "time": time(sample.time), "density": density })
            };
            json!({ "samples": samples.iter().map(sample).collect::<Vec<_>>() })
        }
    };
    match source.terms {
        TermChoice::Given(terms) => json["terms"] = json!(terms),
        TermChoice::Within(accuracy) => json["accuracy"] = json!(accuracy),
    }
    json
}

fn shape(shape: &Shape) -> Json {
    let length = |value: f64| number(value, Form::Si, Dimension::LENGTH);
    match shape {
        Shape::Heights(heights) => json!({
            "heights": heights.file.given, "spacing": heights.spacing.map(length), "variable": heights.variable,
            "unit": length(heights.unit), "periodic": heights.periodic, "turned_over": heights.turned_over,
        }),
        Shape::Rough(rough) => {
            let (name, value) = match rough.roughness {
                Roughness::Height(height) => ("rms_height", length(height)),
                Roughness::Slope(slope) => ("rms_slope", json!(slope)),
            };
            json!({ "rough": {
                "period": length(rough.period), "cells": rough.cells, "hurst": rough.hurst,
                "roll_off": length(rough.roll_off), "cut_off": length(rough.cut_off), "seed": rough.seed,
                name: value,
            } })
        }
        word => json!(word.name()),
    }
}

fn contact_analysis(kind: &ContactAnalysis) -> Json {
    let value = contact_value;
    match kind {
        ContactAnalysis::Contact(contact) => {
            let (loading, load) = pressed(contact.loading);
            json!({
                "kind": "contact", "velocity": value(contact.velocity, ContactKey::Velocity), loading: load,
                "accuracy": contact.accuracy, "cells": contact.cells, "memory_limit": contact.memory.bytes,
                "domain": contact.domain.map(|domain| value(domain, ContactKey::Domain)),
            })
        }
        ContactAnalysis::ContactLaw(law) => law_settings("contact-law", law),
        ContactAnalysis::Fit(fit) => {
            let mut json = law_settings("fit", &fit.law);
            json["velocity_scale"] = json!(fit.velocity_scale);
            json
        }
        ContactAnalysis::Modulus(modulus) => json!({
            "kind": "modulus",
            "frequency": modulus.frequency.as_ref().map(|range| span(range, ContactKey::Frequency.entry().dimension)),
        }),
        ContactAnalysis::Transient(settings) => transient(settings),
    }
}

fn transient(settings: &TransientSettings) -> Json {
    let (key, load) = pressed(settings.loading);
    let mut json = json!({
        "kind": "transient", "motion": settings.motion.name(), key: load,
        "duration": contact_value(settings.duration, ContactKey::Duration), "cells": settings.cells,
        "memory_limit": settings.memory.bytes,
        "oscillation": settings.oscillation.as_ref().map(oscillation),
    });
    match &settings.motion {
        Motion::Rest => {}
        Motion::Start(velocity) => json["velocity"] = contact_value(*velocity, ContactKey::Velocity),
        Motion::Reciprocation(wave) => {
            json["amplitude"] = contact_value(wave.amplitude, ContactKey::Amplitude);
            json["frequency"] = contact_value(wave.frequency, ContactKey::Frequency);
        }
    }
    json
}

fn oscillation(wave: &Oscillation) -> Json {
    json!({
        "amplitude": contact_value(wave.amplitude, ContactKey::Amplitude),
        "frequency": contact_value(wave.frequency, ContactKey::Frequency),
    })
}

/// What presses the indenter down: its key and its value.
fn pressed(loading: Loading) -> (&'static str, Json) {
    match loading {
        Loading::Indentation(depth) => ("indentation", contact_value(depth, ContactKey::Indentation)),
        Loading::Load(force) => ("load", contact_value(force, ContactKey::Load)),
    }
}

fn contact_value(value: Value, key: ContactKey) -> Json {
    number(value.number, value.form, key.entry().dimension)
}

fn law_settings(kind: &str, law: &LawSettings) -> Json {
    json!({
        "kind": kind, "velocity": span(&law.velocity, ContactKey::Velocity.entry().dimension),
        "indentation": span(&law.indentation, ContactKey::Indentation.entry().dimension), "accuracy": law.accuracy,
        "method": law.method.name(), "memory_limit": law.memory.bytes,
    })
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
