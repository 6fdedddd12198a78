//! What can be swept: the keys of a case, as each model has them, and the parameters of a two-degrees case.

use crate::sweep::ParameterKey;
use judder_keys::cause::Cause;
use judder_keys::declared::{Allowed, Number};
use judder_keys::dimension::Dimension;
use judder_keys::document::Node;
use judder_keys::error::Fault;
use judder_keys::numeric_key::{Form, Value};
use judder_keys::schema::reference;
use judder_keys::section::finite_number;
use judder_study::case::schema::swept_keys;
use serde_json::{Value as Json, json};
use std::fmt;

/// The keys that the analyses of one case can vary.
pub(crate) trait SweptKeys {
    type Key: Copy + PartialEq + fmt::Debug + Send + Sync + 'static;

    /// The key that a case file names by `path`.
    fn find(&self, path: &str) -> Result<Self::Key, Cause>;

    /// The dotted path of a key.
    fn path(&self, key: Self::Key) -> String;

    /// Reads a value of `key`; an error calls it `name`.
    fn read(&self, key: Self::Key, name: &str, node: &Node) -> Result<Value, Fault>;

    /// Whether two keys vary the same quantity.
    fn same(&self, first: Self::Key, second: Self::Key) -> bool;

    /// The dimension of a key.
    fn dimension(key: Self::Key) -> Dimension;

    /// What a case file may say for a key.
    fn key_form() -> Allowed;

    /// What it may say for a value of a key.
    fn value_form() -> Allowed {
        Allowed::Number(Number::any(Dimension::NUMBER))
    }

    /// A value of a key in a canonical form.
    fn write(key: Self::Key, value: Value) -> Json {
        match value.form {
            Form::Group => json!(value.number),
            Form::Si => json!({ "value": value.number, "unit": Self::dimension(key).unit() }),
        }
    }

    /// Checks the conditions that tie keys together, with some keys set.
    fn check(&self, settings: &[(Self::Key, Value)]) -> Result<(), Cause>;
}

/// One of the numbers that the analyses of a model vary.
pub(crate) fn key_of(model: &str) -> Allowed {
    let words = "the dotted path of a number of the case".to_owned();
    Allowed::Told { schema: reference(&swept_keys(model)), words, keys: Vec::new() }
}

/// The parameters of a two-degrees case, by their names.
pub(crate) struct ParameterKeys(pub(crate) Vec<String>);

impl SweptKeys for ParameterKeys {
    type Key = ParameterKey;

    fn find(&self, path: &str) -> Result<ParameterKey, Cause> {
        let name = path.strip_prefix("parameters.").unwrap_or(path);
        self.0.iter().position(|known| known == name).map(ParameterKey).ok_or_else(|| {
            let known = self.0.iter().map(|name| format!("parameters.{name}")).collect();
            Cause::UnknownName { what: "swept key", name: path.to_owned(), known }
        })
    }

    fn path(&self, key: ParameterKey) -> String {
        format!("parameters.{}", self.0[key.0])
    }

    fn read(&self, _: ParameterKey, name: &str, node: &Node) -> Result<Value, Fault> {
        finite_number(name, node).map(Value::group)
    }

    fn same(&self, first: ParameterKey, second: ParameterKey) -> bool {
        first == second
    }

    fn dimension(_: ParameterKey) -> Dimension {
        Dimension::NUMBER
    }

    fn key_form() -> Allowed {
        Allowed::Told {
            schema: json!({ "type": "string" }),
            words: "`parameters.NAME`".to_owned(),
            keys: Vec::new(),
        }
    }

    fn check(&self, _: &[(ParameterKey, Value)]) -> Result<(), Cause> {
        Ok(())
    }
}
