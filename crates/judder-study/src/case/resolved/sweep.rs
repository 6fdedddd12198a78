//! Sweeps of the whole case.

use serde_json::{Value as Json, json};

use super::number;
use crate::case::file::CaseFile;
use crate::case::study_sweep::{Design, StudySweep, SweptKey, SweptValues};
use judder_keys::numeric_key::Form;

impl CaseFile {
    /// [`Case::resolved`](crate::case::file::Case::resolved) with the sweeps of the case under `sweep`, where it has any.
    pub fn resolved(&self) -> Json {
        let mut json = self.case.resolved();
        if !self.sweeps.is_empty() {
            json["sweep"] = self.sweeps.iter().map(StudySweep::resolved).collect();
        }
        json.sort_all_objects();
        json
    }
}

impl StudySweep {
    /// The sweep with every default filled in; `chunk` is null where the program chooses.
    pub fn resolved(&self) -> Json {
        let quantities: Vec<&str> = self.quantities.iter().map(|path| path.text.as_str()).collect();
        let sensitivity = self.sensitivity.map(
            |sensitivity| json!({ "confidence": sensitivity.confidence, "resamples": sensitivity.resamples }),
        );
        let mut json = json!({
            "name": self.name, "method": self.method.name(), "over": self.axes.iter().map(key).collect::<Vec<_>>(),
            "quantities": quantities, "chunk": self.chunk,
        });
        if let Design::LatinHypercube { points, seed } | Design::Sobol { points, seed } = self.method {
            json["points"] = json!(points);
            json["seed"] = json!(seed);
            json["sensitivity"] = json!(sensitivity);
        }
        json.sort_all_objects();
        json
    }
}

fn key(key: &SweptKey) -> Json {
    let form = if key.dimension.is_number() { Form::Group } else { Form::Si };
    let value = |value: f64| number(value, form, key.dimension);
    match &key.values {
        SweptValues::Listed(values) => {
            json!({ "key": key.path, "values": values.iter().map(|x| value(*x)).collect::<Vec<_>>() })
        }
        SweptValues::Spaced { from, to, points } => json!({
            "key": key.path, "from": value(*from), "to": value(*to), "points": points, "scale": key.scale.name(),
        }),
        SweptValues::Between { from, to } => {
            json!({ "key": key.path, "from": value(*from), "to": value(*to), "scale": key.scale.name() })
        }
    }
}
