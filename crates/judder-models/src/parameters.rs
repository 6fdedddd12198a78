//! `[parameters]`: named numbers that expressions use and sweeps vary.

use judder_keys::cause::Cause;
use judder_keys::declared::{Allowed, Number, Setting, all};
use judder_keys::dimension::Dimension;
use judder_keys::document::{Data, Entry, Node};
use judder_keys::error::Fault;
use judder_keys::expression::is_parameter_name;
use judder_keys::section::{Section, finite_number, wrong_type};
use serde_json::{Value as Json, json};

/// A named number that expressions use and sweeps vary.
#[derive(Debug, Clone, PartialEq)]
pub struct Parameter {
    /// The name in expressions; a swept key calls it `parameters.NAME`.
    pub name: String,
    /// The value where no sweep sets it; finite.
    pub value: f64,
}

/// The parameters in the order of the case file.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Parameters(pub(crate) Vec<Parameter>);

impl Parameters {
    /// The names in the root of a case, whatever is wrong with them and their values: analyses are read with these.
    pub(crate) fn given(root: &Section<'_>) -> Vec<String> {
        match root.get("parameters") {
            Some(Node { data: Data::Table(table), .. }) => {
                table.entries.iter().map(|entry| entry.key.clone()).collect()
            }
            _ => Vec::new(),
        }
    }

    /// Their names.
    pub(crate) fn names(&self) -> Vec<String> {
        self.0.iter().map(|parameter| parameter.name.clone()).collect()
    }

    /// Their values.
    pub(crate) fn values(&self) -> Vec<f64> {
        self.0.iter().map(|parameter| parameter.value).collect()
    }
}

/// None where they are left out.
impl Setting for Parameters {
    type Rule = ();
    const IS_OPTIONAL: bool = true;

    fn absent() -> Option<Self> {
        Some(Self::default())
    }

    fn form((): &()) -> Allowed {
        Allowed::Named(Box::new(Allowed::Number(Number::any(Dimension::NUMBER))))
    }

    fn read(section: &Section<'_>, key: &str, node: &Node, (): &()) -> Result<Self, Fault> {
        let path = section.path(key);
        let Data::Table(table) = &node.data else { return Err(wrong_type(&path, "a table", node)) };
        let read = |entry: &Entry| {
            let name = entry.key.clone();
            if !is_parameter_name(&name) {
                return Err(Cause::ParameterName { name }.at(entry.place));
            }
            let value = finite_number(&format!("{path}.{name}"), &entry.node)?;
            Ok(Parameter { name, value })
        };
        all(table.entries.iter().map(read)).map(Self)
    }

    fn write(&self, (): &()) -> Json {
        self.0.iter().map(|parameter| json!([parameter.name, parameter.value])).collect()
    }
}
