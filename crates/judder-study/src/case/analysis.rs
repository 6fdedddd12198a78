//! Analyses: a name that serves as a file name, and a kind with its settings.

use crate::registry::Registry;
use dyn_clone::{DynClone, arc_make_mut};
use judder_keys::cause::Cause;
use judder_keys::declared::{Declaration, all, both};
use judder_keys::document::{Data, Node};
use judder_keys::error::Fault;
use judder_keys::section::{Section, text, wrong_type};
use judder_report::Panel;
use judder_store::Dataset;
use std::any::Any;
use std::sync::{Arc, OnceLock};

/// One analysis of a case.
#[derive(Debug, Clone, PartialEq)]
pub struct Planned<K> {
    /// Unique in its case, safe as a file name; the kind where the case gives none.
    pub name: String,
    /// The name of its kind.
    pub kind_name: &'static str,
    /// What is computed.
    pub kind: K,
}

impl<A: AsAny + DynClone + ?Sized> Planned<Arc<A>> {
    /// Its settings, where they are of this type.
    pub fn settings<T: Any>(&self) -> Option<&T> {
        self.kind.as_ref().as_any().downcast_ref()
    }

    /// The same, to be changed; other clones of the case keep theirs.
    pub fn settings_mut<T: Any>(&mut self) -> Option<&mut T> {
        arc_make_mut(&mut self.kind).as_any_mut().downcast_mut()
    }
}

/// The names of analyses, in their order.
pub fn names<K>(analyses: &[Planned<K>]) -> Vec<&str> {
    analyses.iter().map(|planned| planned.name.as_str()).collect()
}

/// What can be asked of which type it is.
pub trait AsAny {
    /// The value, its type unsaid.
    fn as_any(&self) -> &dyn Any;

    /// The same, to be changed.
    fn as_any_mut(&mut self) -> &mut dyn Any;
}

impl<T: Any> AsAny for T {
    fn as_any(&self) -> &dyn Any {
        self
    }

    fn as_any_mut(&mut self) -> &mut dyn Any {
        self
    }
}

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
    kinds: &'static [Kind<S, T>],
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
    /// The panels, from the stored arrays; `None` where some are missing.
    pub draw: fn(&Dataset) -> Option<Vec<Panel>>,
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
    fn find(&self, name: &str) -> Option<(&Kind<S, T>, &[&'static str])> {
        let index = self.kinds.iter().position(|kind| kind.name == name)?;
        let known = self.known.get_or_init(|| self.kinds.iter().map(Kind::keys).collect());
        Some((self.kinds.get(index)?, known.get(index)?))
    }
}

/// Reads `[[analysis]]`: each kind is looked up among `kinds`, and reads its own keys. The registry tells kinds of other models from
/// what is no kind at all.
pub fn read_analyses<S, T>(
    root: &Section<'_>,
    keys: &S,
    kinds: &Kinds<S, T>,
    registry: Registry,
) -> Result<Vec<Planned<T>>, Fault> {
    let Some(node) = root.get("analysis") else { return Ok(Vec::new()) };
    let Data::List(nodes) = &node.data else {
        return Err(wrong_type("analysis", "a list, each item headed [[analysis]]", node));
    };
    let mut names = Vec::new();
    all(nodes.iter().map(|node| read_analysis(node, keys, find_kind(node, kinds, registry)?, &mut names)))
}

/// Reads one analysis, whose name joins those of the ones before.
fn read_analysis<S, T>(
    node: &Node,
    keys: &S,
    (kind, known): (&Kind<S, T>, &[&'static str]),
    before: &mut Vec<String>,
) -> Result<Planned<T>, Fault> {
    let section = Section::of_table(node, "", &format!("an analysis of kind `{}`", kind.name))?;
    let named = both(section.refuse_others(known), read_name(&section, kind.name, before));
    let (((), name), settings) = both(named, (kind.read)(keys, &section))?;
    Ok(Planned { name, kind_name: kind.name, kind: settings })
}

/// Reads the name of an analysis, its kind where it gives none.
fn read_name(section: &Section<'_>, kind: &str, before: &mut Vec<String>) -> Result<String, Fault> {
    let name = section.text("name")?.unwrap_or(kind).to_owned();
    let place = section.place_of(&["name"]);
    if !is_file_name(&name) {
        return Err(Cause::BadName { name }.at(place));
    }
    if before.iter().any(|other| other.eq_ignore_ascii_case(&name)) {
        return Err(Cause::DuplicateName { name }.at(place));
    }
    before.push(name.clone());
    Ok(name)
}

/// The kind of one analysis; it decides which keys the analysis may have.
fn find_kind<'k, S, T>(
    node: &Node,
    kinds: &'k Kinds<S, T>,
    registry: Registry,
) -> Result<(&'k Kind<S, T>, &'k [&'static str]), Fault> {
    let Data::Table(table) = &node.data else { return Err(wrong_type("analysis", "a table", node)) };
    let known: Vec<_> = kinds.kinds.iter().map(|kind| kind.name.to_owned()).collect();
    let Some(entry) = table.get("kind") else {
        let expected = format!("kind = \"…\", one of {}", known.join(", "));
        let (key, section) = ("kind".to_owned(), "this analysis".to_owned());
        return Err(Cause::MissingKey { key, section, expected }.at(node.place));
    };
    let name = text("kind", &entry.node)?;
    if let Some(found) = kinds.find(name) {
        return Ok(found);
    }
    let (what, place) = ("analysis kind", entry.node.part(0..name.len()));
    let name = name.to_owned();
    Err(if registry.kinds().any(|kind| kind.name == name) {
        Cause::OtherModel { name, known }
    } else {
        Cause::UnknownName { what, name, known }
    }
    .at(place))
}

/// Whether a name is a plain file name on every system.
pub fn is_file_name(name: &str) -> bool {
    let plain = |byte: u8| byte.is_ascii_alphanumeric() || matches!(byte, b'.' | b'_' | b'-');
    (1..=100).contains(&name.len()) && !name.starts_with('.') && name.bytes().all(plain)
}
