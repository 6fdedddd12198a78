//! What can be swept: the numeric keys of an oscillator case, or the parameters of a two-degrees case.

use crate::contact::problem::ContactProblem;
use crate::oscillator::case::OscillatorCase;
use crate::oscillator::inputs::{LawName, OscillatorInputs};
use crate::oscillator::keys::{KEYS, OscillatorKey};
use crate::sweep::ParameterKey;
use judder_keys::cause::Cause;
use judder_keys::declared::{Allowed, Number};
use judder_keys::dimension::Dimension;
use judder_keys::document::Node;
use judder_keys::error::Fault;
use judder_keys::numeric_key::{Form, Value, read_value};
use judder_keys::section::finite_number;
use serde_json::{Value as Json, json};

/// The keys that the analyses of one case can vary.
pub(crate) trait SweptKeys {
    type Key: Copy + PartialEq;

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

/// One of the numeric keys that a definition of the schema lists.
pub(crate) fn key_among(definition: &str) -> Allowed {
    let words = "the dotted path of a number of the case".to_owned();
    Allowed::Told { schema: judder_keys::schema::reference(definition), words, keys: Vec::new() }
}

/// The numeric keys of an oscillator case, around its operating point.
pub(crate) struct OscillatorKeys {
    pub(crate) inputs: OscillatorInputs,
    pub(crate) law: LawName,
    /// What decides moduli and times together, where a series or data were given.
    pub(crate) decided_by: Option<&'static str>,
}

/// Keys of an oscillator case that are not numeric.
const NOT_NUMERIC: [&str; 11] = [
    "title",
    "model",
    "contact.law",
    "contact.friction_load",
    "substrate.prony",
    "substrate.relaxation",
    "substrate.continuous",
    "substrate.dma",
    "substrate.temperature",
    "substrate.shift",
    "analysis",
];

impl OscillatorKeys {
    /// Those of this case.
    pub(crate) fn of(case: &OscillatorCase) -> Self {
        Self { inputs: case.inputs, law: case.law, decided_by: case.substrate.decided_by() }
    }

    /// What keeps a key from being swept.
    fn fixed_by(&self, key: OscillatorKey) -> Option<String> {
        use OscillatorKey::{GlassyModulus, RelaxationTime, RetardationTime, RubberyModulus};
        let is_modulus = matches!(key, RubberyModulus | GlassyModulus);
        match self.decided_by {
            Some(by) if is_modulus || matches!(key, RetardationTime | RelaxationTime) => {
                Some(format!("`{by}`"))
            }
            _ if is_modulus && self.law == LawName::Bem => {
                Some("the law `bem`, which is computed for one substrate,".to_owned())
            }
            _ => None,
        }
    }
}

impl SweptKeys for OscillatorKeys {
    type Key = OscillatorKey;

    fn find(&self, path: &str) -> Result<OscillatorKey, Cause> {
        if let Some(key) = OscillatorKey::from_path(path) {
            return match self.fixed_by(key) {
                None => Ok(key),
                Some(by) => {
                    let problem = ContactProblem::FixedKey { key: path.to_owned(), by };
                    Err(problem.into())
                }
            };
        }
        let known = KEYS.iter().map(|entry| entry.path.to_owned()).collect();
        Err(if NOT_NUMERIC.contains(&path) {
            Cause::NotNumeric { key: path.to_owned(), known }
        } else {
            Cause::UnknownName { what: "swept key", name: path.to_owned(), known }
        })
    }

    fn path(&self, key: OscillatorKey) -> String {
        key.to_string()
    }

    fn read(&self, key: OscillatorKey, name: &str, node: &Node) -> Result<Value, Fault> {
        read_value(key.entry(), name, node)
    }

    fn same(&self, first: OscillatorKey, second: OscillatorKey) -> bool {
        let is_time = |key| matches!(key, OscillatorKey::RetardationTime | OscillatorKey::RelaxationTime);
        first == second || (is_time(first) && is_time(second))
    }

    fn dimension(key: OscillatorKey) -> Dimension {
        key.entry().dimension
    }

    fn key_form() -> Allowed {
        key_among("oscillator-key")
    }

    fn value_form() -> Allowed {
        Allowed::Told {
            schema: json!({ "type": ["number", "string"] }),
            words: "a plain number, which is the group of the key, or a quantity with its unit".to_owned(),
            keys: Vec::new(),
        }
    }

    fn check(&self, settings: &[(OscillatorKey, Value)]) -> Result<(), Cause> {
        let mut inputs = self.inputs;
        for (key, value) in settings {
            inputs.set(*key, *value);
        }
        inputs.check(self.law)
    }
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
