//! Settings that are declared once: a struct whose fields are the keys of a table.
//!
//! What is read with its places in errors, the canonical form, the schema and the reference follow from the fields; each says by its doc
//! comment what the key is, and by its type and rule what it may be. [`judder_keys_derive`] derives it.

mod allowed;
mod described;
mod expressed;
mod listed;
mod named;
mod rows;
mod rules;
mod scaled;
mod values;

use crate::document::Node;
use crate::error::Fault;
use crate::section::{NOTHING, Section};
use serde_json::{Map, Value as Json};

pub use crate::numeric_key::Scaled;
pub use allowed::{
    Allowed, AlternativePart, Declaration, alternatives, beside, declared_table, with_declared,
};
pub use expressed::{EvaluatedTree, ExpressionScope, NumberExpression};
pub use listed::{Listed, listed};
pub use named::Named;
pub use rows::{ToldKey, rows, told};
pub use rules::{Fixed, Number, NumberPair, Several, UNLIMITED, Whole};
pub use scaled::{Ladder, ScaledPair};
pub use values::conflict;

/// A table of settings.
pub trait Settings: Sized {
    /// How messages call the table; by its path where this is `None`.
    const TITLE: Option<&'static str>;
    /// What it is.
    const DOC: &'static str;

    /// Its keys, in the order of the fields.
    fn keys() -> Vec<&'static str>;

    /// What is said of each.
    fn declarations() -> Vec<Declaration>;

    /// Reads all of them; what is wrong with one does not hide what is wrong with another.
    fn read_table(section: &Section<'_>) -> Result<Self, Fault>;

    /// Puts them into a canonical form, defaults filled in.
    fn write_table(&self, json: &mut Map<String, Json>);
}

/// Keys that stand among those of a table.
pub trait Flat: Sized {
    /// What decides which they are, besides the type.
    type Rule: 'static;

    /// Their names.
    fn keys(rule: &Self::Rule) -> Vec<&'static str>;

    /// What is said of each.
    fn declarations(rule: &Self::Rule) -> Vec<Declaration>;

    /// Reads all of them.
    fn read(section: &Section<'_>, rule: &Self::Rule) -> Result<Self, Fault>;

    /// Puts them into a canonical form.
    fn write(&self, json: &mut Map<String, Json>);
}

impl<T: Settings> Flat for T {
    type Rule = ();

    fn keys((): &()) -> Vec<&'static str> {
        T::keys()
    }

    fn declarations((): &()) -> Vec<Declaration> {
        T::declarations()
    }

    fn read(section: &Section<'_>, (): &()) -> Result<Self, Fault> {
        T::read_table(section)
    }

    fn write(&self, json: &mut Map<String, Json>) {
        self.write_table(json);
    }
}

/// The value of a key.
pub trait Setting: Sized {
    /// What reading needs to know besides the type: unit, range, length.
    type Rule: 'static;
    /// Whether it may be left out without a default.
    const IS_OPTIONAL: bool = false;

    /// What it is where the key is left out; `None` where it must be given.
    fn absent() -> Option<Self> {
        None
    }

    /// What a case file may say.
    fn form(rule: &Self::Rule) -> Allowed;

    /// Reads the value under a key of a section.
    fn read(section: &Section<'_>, key: &str, node: &Node, rule: &Self::Rule) -> Result<Self, Fault>;

    /// The canonical form.
    fn write(&self, rule: &Self::Rule) -> Json;
}

/// How messages speak of a key that lacks.
#[derive(Debug, Clone, Copy)]
pub struct Called {
    /// Its name.
    pub key: &'static str,
    /// What it is.
    pub doc: &'static str,
    /// What would be right, in place of what the form says.
    pub example: Option<&'static str>,
}

/// Reads a table by the name that messages give it; keys that it does not have are told beside what is wrong with those that it has.
pub fn read_settings<T: Settings>(node: &Node, path: &str, name: &str) -> Result<T, Fault> {
    let section = Section::of_table(node, path, name)?;
    both(section.refuse_others(&T::keys()), T::read_table(&section)).map(|((), settings)| settings)
}

/// Reads a key, or takes what it is where it is left out.
pub fn read_key<T: Setting>(
    section: &Section<'_>,
    called: Called,
    rule: &T::Rule,
    absent: impl FnOnce() -> Option<T>,
) -> Result<T, Fault> {
    let Called { key, doc, example } = called;
    match section.get(key) {
        Some(node) => T::read(section, key, node, rule),
        None => absent().ok_or_else(|| {
            let expected = match example {
                // the head of a section stands for itself
                Some(own) if own.starts_with(&format!("[{key}]")) => own.to_owned(),
                Some(own) => format!("{key} = {own}"),
                None => T::form(rule).example(key, doc),
            };
            section.missing(key, &expected)
        }),
    }
}

/// The settings of an empty table, where all of them may be left out.
pub fn of_nothing<T: Settings>() -> Option<T> {
    T::read_table(&NOTHING).ok()
}

/// Which of some alternatives a section has the keys of, the first where it has none; two are refused.
pub fn alternative(section: &Section<'_>, keys: &[Vec<&str>]) -> Result<usize, Fault> {
    let given = |(index, keys): (usize, &Vec<&str>)| {
        keys.iter().find(|key| section.get(key).is_some()).map(|key| (index, (*key).to_owned()))
    };
    let mut found = keys.iter().enumerate().filter_map(given);
    let Some((index, first)) = found.next() else { return Ok(0) };
    found.next().map_or(Ok(()), |(_, second)| conflict(section, &first, &second)).map(|()| index)
}

/// Lists as one.
pub fn joined<T: Clone>(lists: Vec<Vec<T>>) -> Vec<T> {
    lists.concat()
}

/// Both of two, or all that is wrong with either.
pub fn both<A, B>(one: Result<A, Fault>, other: Result<B, Fault>) -> Result<(A, B), Fault> {
    match (one, other) {
        (Ok(one), Ok(other)) => Ok((one, other)),
        (Err(one), Err(other)) => Err(one.and(other)),
        (Err(fault), Ok(_)) | (Ok(_), Err(fault)) => Err(fault),
    }
}

/// All of many, or all that is wrong with any.
pub fn all<T>(many: impl IntoIterator<Item = Result<T, Fault>>) -> Result<Vec<T>, Fault> {
    let nothing = Ok(Vec::new());
    many.into_iter().fold(nothing, |before, own| {
        both(before, own).map(|(mut before, own)| {
            before.push(own);
            before
        })
    })
}

/// Puts a key into a canonical form; one that is left out is `null` there, or nothing.
pub fn write_key(json: &mut Map<String, Json>, key: &str, is_omitted: bool, value: Json) {
    if !(is_omitted && value.is_null()) {
        json.insert(key.to_owned(), value);
    }
}
