//! The resolved case as canonical JSON: every key with the value in use, keys sorted, the same bytes each time.

use serde_json::{Map, Value as Json, json};

use crate::analysis::Analysis;
use crate::case_file::Case;
use crate::dimension::Dimension;
use crate::keys::{Form, KEYS, OscillatorKey};
use crate::oscillator_analysis::OscillatorAnalysis;
use crate::oscillator_case::OscillatorCase;
use crate::sweep::{Family, ParameterKey, StabilityMap, Sweep, Within};
use crate::two_degrees::{TwoDegreesAnalysis, TwoDegreesCase};

impl Case {
    /// The case with every default filled in, for the hash of a study and for its report.
    ///
    /// A group is a number; a quantity is `{"value": …, "unit": …}` in SI units.
    pub fn resolved(&self) -> Json {
        let mut json = match self {
            Self::Oscillator(case) => oscillator(case),
            Self::TwoDegrees(case) => two_degrees(case),
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
    for entry in &KEYS {
        let value = case.inputs.get(entry.key);
        json[entry.section()][entry.name()] = number(value.number, value.form, entry.dimension);
    }
    json
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
    let strength = OscillatorKey::ShearStrength;
    let load = OscillatorKey::NormalLoad;
    match kind {
        OscillatorAnalysis::EquivalentDamping { sweep: axis, family: curves } => json!({
            "kind": "equivalent-damping", "sweep": sweep(axis), "family": curves.as_ref().map(family),
        }),
        OscillatorAnalysis::Spectrum { sweep: axis, family: curves } => json!({
            "kind": "spectrum", "sweep": sweep(axis), "family": curves.as_ref().map(family),
        }),
        OscillatorAnalysis::CriticalShearStrength { sweep: axis, within: range, family: curves } => json!({
            "kind": "critical-shear-strength", "sweep": sweep(axis), "within": within(range, strength),
            "family": curves.as_ref().map(family),
        }),
        OscillatorAnalysis::CriticalLoad { sweep: axis, within: range, family: curves } => json!({
            "kind": "critical-load", "sweep": sweep(axis), "within": within(range, load),
            "family": curves.as_ref().map(family),
        }),
        OscillatorAnalysis::StabilityMap(map) => stability_map(map),
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

fn number(number: f64, form: Form, dimension: Dimension) -> Json {
    match form {
        Form::Group => json!(number),
        Form::Si => json!({ "value": number, "unit": dimension.unit() }),
    }
}
