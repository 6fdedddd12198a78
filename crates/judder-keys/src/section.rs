//! Typed reading of one section: unknown keys are refused first, then each key is read as what it must be.

use crate::cause::Cause;
use crate::document::{Data, DocumentTable, Node};
use crate::error::{Fault, Place};
use crate::quantity::WrittenNumber;

/// A table of the case with the words that errors need.
pub struct Section<'a> {
    /// What comes before a key in an error: `substrate.`, or nothing in an analysis.
    prefix: String,
    /// How an error names the section: `[substrate]`, `this analysis`.
    name: String,
    /// Whether it is the case itself, whose tables go by their headers.
    is_case: bool,
    table: &'a DocumentTable,
    /// Where the table stands.
    pub place: Place,
}

/// An empty table.
pub static NOTHING: Section<'static> = Section {
    prefix: String::new(),
    name: String::new(),
    is_case: false,
    table: &DocumentTable { entries: Vec::new() },
    place: Place { source: 0, start: 0, end: 0 },
};

impl<'a> Section<'a> {
    /// Opens `node`, which must be a table with no other keys than `known`.
    pub fn open(node: &'a Node, path: &str, name: &str, known: &[&str]) -> Result<Self, Fault> {
        let section = Self::of_table(node, path, name)?;
        section.refuse_others(known).map(|()| section)
    }

    /// Opens `node`, which must be a table, whatever its keys are.
    pub fn of_table(node: &'a Node, path: &str, name: &str) -> Result<Self, Fault> {
        let Data::Table(table) = &node.data else {
            return Err(wrong_type(path, "a table", node));
        };
        let prefix = if path.is_empty() { String::new() } else { format!("{path}.") };
        Ok(Self { prefix, name: name.to_owned(), is_case: false, table, place: node.place })
    }

    /// Opens the root of a case.
    pub fn of_case(node: &'a Node, name: &str) -> Result<Self, Fault> {
        Ok(Self { is_case: true, ..Self::of_table(node, "", name)? })
    }

    /// How an error names the table under a key: `[substrate]` of the case itself, else by its path.
    pub fn title(&self, key: &str) -> String {
        if self.is_case { format!("[{key}]") } else { format!("`{}`", self.path(key)) }
    }

    /// Whether it has no keys at all.
    pub fn is_empty(&self) -> bool {
        self.table.entries.is_empty()
    }

    /// Refuses all keys but those that are known.
    pub fn refuse_others(&self, known: &[&str]) -> Result<(), Fault> {
        let unknown = self.table.entries.iter().filter(|entry| !known.contains(&entry.key.as_str()));
        let faults = unknown.map(|entry| {
            let (key, section) = (entry.key.clone(), self.name.clone());
            let known = known.iter().map(|key| (*key).to_owned()).collect();
            Cause::UnknownKey { key, section, known }.at(entry.place)
        });
        faults.reduce(Fault::and).map_or(Ok(()), Err)
    }

    /// The dotted path of the section itself.
    pub fn own_path(&self) -> &str {
        self.prefix.strip_suffix('.').unwrap_or_default()
    }

    /// The section as an error names it.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Opens `node`, the table under `key` of this section.
    pub fn table<'b>(&self, key: &str, node: &'b Node, known: &[&str]) -> Result<Section<'b>, Fault> {
        Section::open(node, &self.path(key), &self.title(key), known)
    }

    /// The table under `key`, where there is one, whatever its keys are.
    pub fn inner(&self, key: &str) -> Result<Option<Section<'a>>, Fault> {
        self.get(key).map(|node| Section::of_table(node, &self.path(key), &self.title(key))).transpose()
    }

    /// The place of the first of these keys that there is, or of the section.
    pub fn place_of(&self, keys: &[&str]) -> Place {
        keys.iter().find_map(|key| self.get(key)).map_or(self.place, |node| node.place)
    }

    /// The number of a key as it is written.
    pub fn written(&self, key: &str, number: f64) -> WrittenNumber {
        self.get(key).map_or_else(|| number.into(), |node| WrittenNumber::of(node, number))
    }

    /// The dotted path of a key of this section.
    pub fn path(&self, key: &str) -> String {
        format!("{}{key}", self.prefix)
    }

    /// The value of a key.
    pub fn get(&self, key: &str) -> Option<&'a Node> {
        self.table.get(key).map(|entry| &entry.node)
    }

    /// The value of a key that must be there; `expected` says what it would be.
    pub fn required(&self, key: &str, expected: &str) -> Result<&'a Node, Fault> {
        self.get(key).ok_or_else(|| self.missing(key, expected))
    }

    /// The fault of a key that is not there; `expected` says what it would be.
    pub fn missing(&self, key: &str, expected: &str) -> Fault {
        let (key, section) = (key.to_owned(), self.name.clone());
        Cause::MissingKey { key, section, expected: expected.to_owned() }.at(self.place)
    }

    /// A string.
    pub fn text(&self, key: &str) -> Result<Option<&'a str>, Fault> {
        self.get(key).map(|node| text(&self.path(key), node)).transpose()
    }

    /// `true` or `false`.
    pub fn boolean(&self, key: &str) -> Result<Option<bool>, Fault> {
        let Some(node) = self.get(key) else { return Ok(None) };
        match node.data {
            Data::Boolean(value) => Ok(Some(value)),
            _ => Err(wrong_type(&self.path(key), "true or false", node)),
        }
    }

    /// A whole number from `from` to `to`.
    pub fn whole(&self, key: &str, from: usize, to: usize) -> Result<Option<usize>, Fault> {
        self.get(key).map(|node| whole(&self.path(key), node, from, to)).transpose()
    }

    /// One of a few words, each with its meaning.
    pub fn choice<T: Copy>(
        &self,
        key: &str,
        what: &'static str,
        choices: &[(&'static str, T)],
    ) -> Result<Option<T>, Fault> {
        self.get(key).map(|node| word(&self.path(key), what, node, choices)).transpose()
    }
}

/// A whole number from one to another.
pub fn whole(key: &str, node: &Node, from: usize, to: usize) -> Result<usize, Fault> {
    let Data::Number { whole: Some(found), .. } = node.data else {
        return Err(wrong_type(key, "an integer", node));
    };
    match usize::try_from(found) {
        Ok(count) if (from..=to).contains(&count) => Ok(count),
        _ => {
            let problem = Cause::Count { key: key.to_owned(), from, to, found };
            Err(problem.at(node.place))
        }
    }
}

/// One of a few words, each with its meaning.
pub fn word<T: Copy>(
    key: &str,
    what: &'static str,
    node: &Node,
    choices: &[(&'static str, T)],
) -> Result<T, Fault> {
    let name = text(key, node)?;
    match choices.iter().find(|(choice, _)| *choice == name) {
        Some((_, meaning)) => Ok(*meaning),
        None => {
            let known = choices.iter().map(|(choice, _)| (*choice).to_owned()).collect();
            Err(Cause::UnknownName { what, name: name.to_owned(), known }.at(node.part(0..name.len())))
        }
    }
}

/// The items of a list.
pub fn list<'a>(key: &str, node: &'a Node) -> Result<&'a [Node], Fault> {
    match &node.data {
        Data::List(items) => Ok(items),
        _ => Err(wrong_type(key, "a list", node)),
    }
}

/// A string.
pub fn text<'a>(key: &str, node: &'a Node) -> Result<&'a str, Fault> {
    match &node.data {
        Data::Text(text) => Ok(text),
        _ => Err(wrong_type(key, "a string", node)),
    }
}

/// A finite plain number; an integer counts as one.
pub fn finite_number(key: &str, node: &Node) -> Result<f64, Fault> {
    match node.data {
        Data::Number { value, .. } if value.is_finite() => Ok(value),
        Data::Number { .. } => Err(Cause::NotFinite { key: key.to_owned() }.at(node.place)),
        _ => Err(wrong_type(key, "a plain number", node)),
    }
}

/// The fault of a value of the wrong type.
pub fn wrong_type(key: &str, expected: &str, node: &Node) -> Fault {
    Cause::WrongType { key: key.to_owned(), expected: expected.to_owned(), found: node.type_name() }
        .at(node.place)
}
