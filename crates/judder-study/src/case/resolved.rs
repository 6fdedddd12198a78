//! The resolved case as canonical JSON: every key with the value in use, keys sorted, the same bytes each time.

mod sweep;

use crate::case::analysis::Planned;
use crate::case::file::Case;
use judder_keys::dimension::Dimension;
use judder_keys::numeric_key::Form;
use serde_json::{Map, Value as Json, json};

impl Case {
    /// The case with every default filled in, for the hash of a study and for its report.
    ///
    /// A group is a number; a quantity is `{"value": …, "unit": …}` in SI units.
    pub fn resolved(&self) -> Json {
        let mut json = (**self).resolved();
        // another crate of the build may have switched serde_json to insertion order
        json.sort_all_objects();
        json
    }
}

/// The analyses of a case.
pub fn analyses<K>(analyses: &[Planned<K>], write: impl Fn(&K, &mut Map<String, Json>)) -> Json {
    let written = |planned: &Planned<K>| {
        let mut json = Map::new();
        write(&planned.kind, &mut json);
        json.insert("kind".to_owned(), json!(planned.kind_name));
        json.insert("name".to_owned(), json!(planned.name));
        Json::Object(json)
    };
    analyses.iter().map(written).collect()
}

/// A number in its form.
pub fn number(number: f64, form: Form, dimension: Dimension) -> Json {
    match form {
        Form::Group => json!(number),
        Form::Si => json!({ "value": number, "unit": dimension.unit() }),
    }
}
