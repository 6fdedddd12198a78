//! Kinds of analyses: what is said of them, how they are read, how their results are drawn.

use crate::pictures::StoredArrays;
use judder_keys::declared::Declaration;
use judder_keys::error::Fault;
use judder_keys::section::Section;
use judder_report::Panel;
use std::sync::OnceLock;

/// A kind of analysis: its name, what is said of its keys besides `name` and `kind`, how those are read, and how its results are drawn.
pub struct Kind<S, T> {
    /// Its name in a case file.
    pub name: &'static str,
    /// What it computes, in a line.
    pub doc: &'static str,
    /// Its keys besides `name` and `kind`.
    pub declared: fn() -> Vec<Declaration>,
    /// Reads them, with what else the case says.
    pub read: fn(&S, &Section<'_>) -> Result<T, Fault>,
    /// How its results are drawn; `None` where they are no picture.
    pub picture: Option<Picture>,
}

/// The kinds of analyses of a model.
pub struct Kinds<S: 'static, T: 'static> {
    pub(super) kinds: &'static [Kind<S, T>],
    /// The names of the keys of each, which every reading of a case needs.
    known: OnceLock<Vec<Vec<&'static str>>>,
}

/// What is said of a kind of analysis, whatever its model.
pub struct KindEntry {
    /// Its name.
    pub name: &'static str,
    /// What it computes.
    pub doc: &'static str,
    /// Its keys besides `name` and `kind`.
    pub declared: fn() -> Vec<Declaration>,
    /// How its results are drawn; `None` where they are no picture.
    pub picture: Option<&'static Picture>,
}

/// How the results of a kind of analysis are drawn.
pub struct Picture {
    /// The panels, from the stored arrays; `None` where some are missing, or not what they should be.
    pub draw: fn(&StoredArrays<'_>) -> Option<Vec<Panel>>,
    /// What stands under it.
    pub caption: &'static str,
}

impl<S, T> Kind<S, T> {
    /// What is said of it, whatever its model.
    pub fn entry(&'static self) -> KindEntry {
        KindEntry { name: self.name, doc: self.doc, declared: self.declared, picture: self.picture.as_ref() }
    }

    /// The names of its keys.
    fn keys(&self) -> Vec<&'static str> {
        let own = (self.declared)();
        ["name", "kind"].into_iter().chain(own.iter().map(|key| key.name)).collect()
    }
}

impl<S, T> Kinds<S, T> {
    /// These kinds, in the order in which they are listed.
    pub const fn new(kinds: &'static [Kind<S, T>]) -> Self {
        Self { kinds, known: OnceLock::new() }
    }

    /// What is said of each, whatever the model.
    pub fn entries(&'static self) -> Vec<KindEntry> {
        self.kinds.iter().map(Kind::entry).collect()
    }

    /// The kind of this name, with the names of its keys.
    pub(super) fn find(&self, name: &str) -> Option<(&Kind<S, T>, &[&'static str])> {
        let index = self.kinds.iter().position(|kind| kind.name == name)?;
        let known = self.known.get_or_init(|| self.kinds.iter().map(Kind::keys).collect());
        Some((self.kinds.get(index)?, known.get(index)?))
    }
}
