//! Lists whose items keys call by their names, as in `contact.sole.friction_coefficient`.

use super::problem::AssemblyProblem;
use crate::sliding::case::plain_name::PlainName;
use judder_keys::cause::Cause;
use judder_keys::declared::{Allowed, Setting, Settings, all, read_settings};
use judder_keys::document::Node;
use judder_keys::error::Fault;
use judder_keys::problem::Placed;
use judder_keys::section::{Section, list};
use serde_json::{Map, Value as Json};

/// What a list of names has.
pub(crate) trait NamedItem: Settings {
    /// What one is, in a word.
    const WHAT: &'static str;

    /// Its name.
    fn name(&self) -> &PlainName;

    /// The canonical form.
    fn written(&self) -> Json {
        let mut json = Map::new();
        self.write_table(&mut json);
        Json::Object(json)
    }
}

/// Items with names of their own, one at least.
#[derive(Debug, Clone)]
pub(crate) struct NamedList<T>(pub(crate) Vec<T>);

impl<T: NamedItem> NamedList<T> {
    /// The dotted path of an item and how messages call it, by its name where it has one.
    pub(crate) fn titles(section: &Section<'_>) -> (String, String) {
        let what = T::WHAT;
        match section.get("name").map(|node| PlainName::read(section, "name", node, &T::WHAT)) {
            Some(Ok(name)) => (format!("{what}.{name}"), format!("the {what} `{name}`")),
            _ => (what.to_owned(), format!("a {what}")),
        }
    }
}

/// An item of a list as a section of its own.
pub(crate) fn item_section<'a, T: NamedItem>(node: &'a Node) -> Result<Section<'a>, Fault> {
    let (path, title) = NamedList::<T>::titles(&Section::of_table(node, T::WHAT, T::WHAT)?);
    Section::of_table(node, &path, &title)
}

impl<T: NamedItem> Setting for NamedList<T> {
    type Rule = ();

    fn form((): &()) -> Allowed {
        Allowed::List { of: Box::new(T::form(&())), length: [1, usize::MAX] }
    }

    fn read(_: &Section<'_>, key: &str, node: &Node, (): &()) -> Result<Self, Fault> {
        let nodes = list(key, node)?;
        if nodes.is_empty() {
            return Err(Cause::EmptyList { key: key.to_owned() }.at(node.place));
        }
        let read = |node: &Node| {
            let (path, title) = Self::titles(&Section::of_table(node, T::WHAT, T::WHAT)?);
            read_settings::<T>(node, &path, &title)
        };
        let items = all(nodes.iter().map(read))?;
        let is_twice = |k: &usize| items[..*k].iter().any(|before| before.name() == items[*k].name());
        match (1..items.len()).find(is_twice) {
            None => Ok(Self(items)),
            Some(k) => {
                let name = items[k].name().to_string();
                Err(AssemblyProblem::NameTwice { what: T::WHAT, name }.at(nodes[k].place))
            }
        }
    }

    fn write(&self, (): &()) -> Json {
        self.0.iter().map(NamedItem::written).collect()
    }
}
