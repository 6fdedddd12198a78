//! Names that a case gives to what it has.

use super::problem::SlidingProblem;
use judder_keys::cause::Cause;
use judder_keys::declared::{Allowed, Named, Setting};
use judder_keys::document::Node;
use judder_keys::error::Fault;
use judder_keys::problem::Placed;
use judder_keys::section::{Section, text};
use serde_json::{Value as Json, json};
use std::fmt;
use std::ops::Deref;

/// A name of letters, digits, `_` and `-`, such that dotted paths can contain it; its rule is what it names.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PlainName(String);

impl Deref for PlainName {
    type Target = String;

    fn deref(&self) -> &String {
        &self.0
    }
}

impl fmt::Display for PlainName {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.0)
    }
}

impl Setting for PlainName {
    type Rule = &'static str;

    fn form(_: &&'static str) -> Allowed {
        Allowed::Told {
            schema: json!({ "type": "string", "pattern": "^[A-Za-z0-9_-]{1,100}$" }),
            words: "a name of letters, digits, `_` and `-`".to_owned(),
            keys: Vec::new(),
        }
    }

    fn read(section: &Section<'_>, key: &str, node: &Node, what: &&'static str) -> Result<Self, Fault> {
        let name = text(&section.path(key), node)?.to_owned();
        let plain = |byte: u8| byte.is_ascii_alphanumeric() || matches!(byte, b'_' | b'-');
        if (1..=100).contains(&name.len()) && name.bytes().all(plain) {
            return Ok(Self(name));
        }
        Err(SlidingProblem::Name { what, name }.at(node.place))
    }

    fn write(&self, _: &&'static str) -> Json {
        json!(self.0)
    }
}

/// Finds the structure that `structure` of a section names, of those with these names.
pub(crate) fn find_structure<'a>(
    named: &mut Named<usize>,
    names: impl Iterator<Item = &'a PlainName>,
    section: &Section<'_>,
) -> Result<(), Fault> {
    let known: Vec<String> = names.map(PlainName::to_string).collect();
    let node = section.required("structure", &format!("structure = \"…\", one of {}", known.join(", ")))?;
    let found = known.iter().position(|other| *other == named.name).ok_or_else(|| {
        Cause::UnknownName { what: "structure", name: named.name.clone(), known }.at(node.place)
    });
    found.map(|found| named.found = found)
}
