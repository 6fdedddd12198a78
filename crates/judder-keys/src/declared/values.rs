//! The types that a declared key may have, and the rules by which they are read.

use super::rules::{Fixed, Number, NumberPair, Several, Whole};
use super::{Allowed, Setting, Settings, all, read_settings};
use crate::cause::Cause;
use crate::document::{Data, Node};
use crate::error::Fault;
use crate::section::{Section, list, text, whole, word, wrong_type};
use crate::span::{ascending, written_items};
use serde_json::{Map, Value as Json, json};

impl Setting for f64 {
    type Rule = Number;

    fn form(rule: &Number) -> Allowed {
        Allowed::Number(*rule)
    }

    fn read(section: &Section<'_>, key: &str, node: &Node, rule: &Number) -> Result<Self, Fault> {
        Ok(rule.scaled().read(&section.path(key), node)?.number)
    }

    fn write(&self, rule: &Number) -> Json {
        match rule.dimension.is_number() {
            true => json!(self),
            false => json!({ "value": self, "unit": rule.dimension.unit() }),
        }
    }
}

impl Setting for usize {
    type Rule = Whole;

    fn form(rule: &Whole) -> Allowed {
        Allowed::Whole(*rule)
    }

    fn read(section: &Section<'_>, key: &str, node: &Node, rule: &Whole) -> Result<Self, Fault> {
        whole(&section.path(key), node, rule.from, rule.to)
    }

    fn write(&self, _: &Whole) -> Json {
        json!(self)
    }
}

impl Setting for u64 {
    type Rule = Whole;

    fn form(rule: &Whole) -> Allowed {
        Allowed::Whole(*rule)
    }

    fn read(section: &Section<'_>, key: &str, node: &Node, rule: &Whole) -> Result<Self, Fault> {
        usize::read(section, key, node, rule).map(|number| number as Self)
    }

    fn write(&self, _: &Whole) -> Json {
        json!(self)
    }
}

impl Setting for bool {
    type Rule = ();

    fn form((): &()) -> Allowed {
        Allowed::Flag
    }

    fn read(section: &Section<'_>, key: &str, node: &Node, (): &()) -> Result<Self, Fault> {
        match node.data {
            Data::Boolean(value) => Ok(value),
            _ => Err(wrong_type(&section.path(key), "true or false", node)),
        }
    }

    fn write(&self, (): &()) -> Json {
        json!(self)
    }
}

impl Setting for String {
    type Rule = ();

    fn form((): &()) -> Allowed {
        Allowed::Text
    }

    fn read(section: &Section<'_>, key: &str, node: &Node, (): &()) -> Result<Self, Fault> {
        text(&section.path(key), node).map(str::to_owned)
    }

    fn write(&self, (): &()) -> Json {
        json!(self)
    }
}

impl Setting for [f64; 2] {
    type Rule = NumberPair;

    fn form(rule: &NumberPair) -> Allowed {
        Allowed::List { of: Box::new(Allowed::Number(rule.of)), length: [2, 2] }
    }

    fn read(section: &Section<'_>, key: &str, node: &Node, rule: &NumberPair) -> Result<Self, Fault> {
        let [from, to] = exactly(section, key, rule.what, node, items(section, key, node, &rule.of)?)?;
        if rule.is_ascending {
            ascending([from, to], || written_items(node, [from, to]), node.place)?;
        }
        Ok([from, to])
    }

    fn write(&self, rule: &NumberPair) -> Json {
        self.iter().map(|value| value.write(&rule.of)).collect()
    }
}

impl Setting for [usize; 2] {
    type Rule = Fixed<Whole>;

    fn form(rule: &Fixed<Whole>) -> Allowed {
        Allowed::List { of: Box::new(Allowed::Whole(rule.of)), length: [2, 2] }
    }

    fn read(section: &Section<'_>, key: &str, node: &Node, rule: &Fixed<Whole>) -> Result<Self, Fault> {
        exactly(section, key, rule.what, node, items(section, key, node, &rule.of)?)
    }

    fn write(&self, _: &Fixed<Whole>) -> Json {
        json!(self)
    }
}

/// Directions x, y, z by their names.
impl Setting for [bool; 3] {
    type Rule = ();

    fn form((): &()) -> Allowed {
        Allowed::List {
            of: Box::new(Allowed::Choice { words: &[("x", ""), ("y", ""), ("z", "")] }),
            length: [0, 3],
        }
    }

    fn read(section: &Section<'_>, key: &str, node: &Node, (): &()) -> Result<Self, Fault> {
        let path = section.path(key);
        let mut taken = [false; 3];
        for item in list(&path, node)? {
            taken[word(&path, "direction", item, &AXES)?] = true;
        }
        Ok(taken)
    }

    fn write(&self, (): &()) -> Json {
        AXES.iter().filter(|(_, axis)| self[*axis]).map(|(name, _)| json!(name)).collect()
    }
}

impl<T: Setting> Setting for Vec<T> {
    type Rule = Several<T::Rule>;

    fn form(rule: &Several<T::Rule>) -> Allowed {
        Allowed::List { of: Box::new(T::form(&rule.of)), length: rule.length }
    }

    fn read(section: &Section<'_>, key: &str, node: &Node, rule: &Several<T::Rule>) -> Result<Self, Fault> {
        items(section, key, node, &rule.of)
    }

    fn write(&self, rule: &Several<T::Rule>) -> Json {
        self.iter().map(|value| value.write(&rule.of)).collect()
    }
}

/// The directions by their names.
const AXES: [(&str, usize); 3] = [("x", 0), ("y", 1), ("z", 2)];

/// The items of a list.
pub(super) fn items<T: Setting>(
    section: &Section<'_>,
    key: &str,
    node: &Node,
    rule: &T::Rule,
) -> Result<Vec<T>, Fault> {
    all(list(&section.path(key), node)?.iter().map(|item| T::read(section, key, item, rule)))
}

/// The items of a list that must be so many.
pub(super) fn exactly<T, const N: usize>(
    section: &Section<'_>,
    key: &str,
    expected: &'static str,
    node: &Node,
    items: Vec<T>,
) -> Result<[T; N], Fault> {
    items.try_into().map_err(|items: Vec<T>| {
        Cause::Length { key: section.path(key), expected, found: items.len() }.at(node.place)
    })
}

impl<T: Setting> Setting for Option<T> {
    type Rule = T::Rule;
    const IS_OPTIONAL: bool = true;

    fn absent() -> Option<Self> {
        Some(None)
    }

    fn form(rule: &T::Rule) -> Allowed {
        T::form(rule)
    }

    fn read(section: &Section<'_>, key: &str, node: &Node, rule: &T::Rule) -> Result<Self, Fault> {
        T::read(section, key, node, rule).map(Some)
    }

    fn write(&self, rule: &T::Rule) -> Json {
        self.as_ref().map_or(Json::Null, |value| value.write(rule))
    }
}

impl<T: Settings> Setting for T {
    type Rule = ();

    fn form((): &()) -> Allowed {
        Allowed::Table { doc: T::DOC, keys: T::declarations() }
    }

    fn read(section: &Section<'_>, key: &str, node: &Node, (): &()) -> Result<Self, Fault> {
        let path = section.path(key);
        let name = T::TITLE.map_or_else(|| section.title(key), |title| title.replace("{path}", &path));
        read_settings(node, &path, &name)
    }

    fn write(&self, (): &()) -> Json {
        let mut json = Map::new();
        self.write_table(&mut json);
        Json::Object(json)
    }
}

/// The refusal of a key that means nothing beside another.
pub fn conflict(section: &Section<'_>, first: &str, second: &str) -> Result<(), Fault> {
    match (section.get(first), section.get(second)) {
        (Some(_), Some(node)) => {
            let (first, second) = (section.path(first), section.path(second));
            Err(Cause::Conflict { first, second }.at(node.place))
        }
        _ => Ok(()),
    }
}
