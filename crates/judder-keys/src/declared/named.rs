//! Names by which a case calls what it has.

use super::{Allowed, Setting};
use crate::document::Node;
use crate::error::Fault;
use crate::section::{Section, text};
use serde_json::{Value as Json, json};
use std::ops::Deref;

/// What a case calls by a name: the name is read first, what it means is found when the case is known.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Named<T> {
    /// The name.
    pub name: String,
    /// What it means.
    pub found: T,
}

impl<T> Deref for Named<T> {
    type Target = T;

    fn deref(&self) -> &T {
        &self.found
    }
}

impl<T: Default> Setting for Named<T> {
    type Rule = ();

    fn form((): &()) -> Allowed {
        Allowed::Text
    }

    fn read(section: &Section<'_>, key: &str, node: &Node, (): &()) -> Result<Self, Fault> {
        let name = text(&section.path(key), node)?.to_owned();
        Ok(Self { name, found: T::default() })
    }

    fn write(&self, (): &()) -> Json {
        json!(self.name)
    }
}
