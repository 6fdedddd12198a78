//! The case file as a tree whose every key and value knows its place; `--set` options are grafted onto it.

mod parameters;
mod path;

pub use parameters::{PARAMETER, PARAMETERS, refuse_unknown_parameters};
pub(crate) use path::path_at;

use toml::Spanned;
use toml::de::{DeInteger, DeTable, DeValue};

use crate::cause::Cause;
use crate::error::{Fault, Place};

/// A value with its place.
#[derive(Debug, Clone)]
pub struct Node {
    /// Where it stands.
    pub place: Place,
    /// What it is.
    pub data: Data,
}

/// What a value is.
#[derive(Debug, Clone)]
pub enum Data {
    /// A number; `whole` where it was written as an integer.
    Number {
        /// The number.
        value: f64,
        /// The integer that was written.
        whole: Option<i64>,
    },
    /// A string.
    Text(String),
    /// `true` or `false`.
    Boolean(bool),
    /// A date or a time, which no key takes.
    Date,
    /// A list.
    List(Vec<Node>),
    /// A table.
    Table(DocumentTable),
}

/// A table, its entries in the order of the text.
#[derive(Debug, Clone, Default)]
pub struct DocumentTable {
    /// Its keys with their values.
    pub entries: Vec<Entry>,
}

/// A key with its place, and its value.
#[derive(Debug, Clone)]
pub struct Entry {
    /// The key.
    pub key: String,
    /// Where the key stands.
    pub place: Place,
    /// Its value.
    pub node: Node,
}

impl DocumentTable {
    /// The entry of a key.
    pub fn get(&self, key: &str) -> Option<&Entry> {
        self.entries.iter().find(|entry| entry.key == key)
    }
}

impl Node {
    /// What the value is, as an error says it.
    pub fn type_name(&self) -> &'static str {
        match &self.data {
            Data::Number { whole: Some(_), .. } => "an integer",
            Data::Number { .. } => "a number",
            Data::Text(_) => "a string",
            Data::Boolean(_) => "a boolean",
            Data::Date => "a date",
            Data::List(_) => "a list",
            Data::Table(_) => "a table",
        }
    }

    /// The value under `key` of a table.
    pub fn entry(&self, key: &str) -> Option<&Node> {
        match &self.data {
            Data::Table(table) => table.get(key).map(|entry| &entry.node),
            _ => None,
        }
    }

    /// The value to which a step of a dotted path leads: a key of a table, an item of a list.
    pub fn step(&self, step: &str) -> Option<&Node> {
        match &self.data {
            Data::List(items) => item(items, step).and_then(|index| items.get(index)),
            _ => self.entry(step),
        }
    }

    /// Puts `leaf` at the end of a dotted path, whose steps errors place at `place`.
    pub fn set(&mut self, path: &str, place: Place, leaf: Node) -> Result<(), Fault> {
        let steps: Vec<_> = path.split('.').map(|step| (step, place)).collect();
        graft(self, "the case", &steps, leaf)
    }

    /// A dotted path with the items of lists by their positions.
    pub fn by_position(&self, path: &str) -> String {
        let mut node = Some(self);
        let step = |step: &str| {
            let position = match node.map(|node| &node.data) {
                Some(Data::List(items)) => item(items, step).map(|index| index.to_string()),
                _ => None,
            };
            node = node.and_then(|node| node.step(step));
            position.unwrap_or_else(|| step.to_owned())
        };
        path.split('.').map(step).collect::<Vec<_>>().join(".")
    }

    /// Takes the value under `key` out of a table.
    pub fn take(&mut self, key: &str) -> Option<Node> {
        let Data::Table(table) = &mut self.data else { return None };
        let index = table.entries.iter().position(|entry| entry.key == key)?;
        Some(table.entries.remove(index).node)
    }

    /// The place of `range` of a text value; the whole value where escapes hide the correspondence.
    pub fn part(&self, range: std::ops::Range<usize>) -> Place {
        let Data::Text(text) = &self.data else { return self.place };
        let quotes = match (self.place.end - self.place.start).checked_sub(text.len()) {
            Some(0) => 0,
            Some(2) => 1,
            _ => return self.place,
        };
        let offset = self.place.start + quotes;
        Place { start: offset + range.start, end: offset + range.end, ..self.place }
    }
}

/// Parses the text of the case file.
pub fn parse(text: &str) -> Result<Node, Fault> {
    let converter = Converter { source: 0, offset: 0 };
    match DeTable::parse(text) {
        Ok(table) => {
            let place = converter.place(table.span());
            Ok(Node { place, data: Data::Table(converter.table(table.into_inner())) })
        }
        Err(error) => {
            let span = error.span().unwrap_or(0..0);
            Err(Cause::Syntax { message: error.message().to_owned() }.at(converter.place(span)))
        }
    }
}

/// Grafts the `number`-th option `key=value` onto the tree; a later option wins over an earlier one.
///
/// The value is read as TOML and, where it is none, as a bare string: `velocity=30 mm/s` needs no inner quotes.
pub fn apply_override(root: &mut Node, number: usize, option: &str) -> Result<(), Fault> {
    let SetOption { steps, value } = read_option(number, option)?;
    let place = Place { source: number, start: value.start, end: value.end };
    let value = &option[value];
    let data = match DeValue::parse(value) {
        Ok(parsed) => Converter { source: number, offset: place.start }.value(parsed).data,
        Err(_) => Data::Text(value.to_owned()),
    };
    graft(root, "the case", &steps, Node { place, data })
}

/// What an option `key=value` says.
pub struct SetOption<'a> {
    /// The dotted path, step by step.
    pub steps: Vec<(&'a str, Place)>,
    /// Where the value stands.
    pub value: std::ops::Range<usize>,
}

/// Takes the `number`-th option `key=value` apart.
pub fn read_option(number: usize, option: &str) -> Result<SetOption<'_>, Fault> {
    let whole = Place { source: number, start: 0, end: option.len() };
    let malformed = || Cause::OverrideForm { option: option.to_owned() }.at(whole);
    let (path, value) = option.split_once('=').ok_or_else(malformed)?;
    let offset = option.len() - value.trim_start().len();
    let value = offset..offset + value.trim().len();
    if path.matches('.').count() > STEPS_LIMIT {
        return Err(malformed());
    }
    let mut steps = Vec::new();
    let mut start = 0;
    for step in path.split('.') {
        let place = Place { source: number, start, end: start + step.len() };
        start = place.end + 1;
        if step.trim().is_empty() {
            return Err(malformed());
        }
        steps.push((step.trim(), place));
    }
    Ok(SetOption { steps, value })
}

/// The most steps of a dotted path after the first: no key of a case lies deeper, and grafting recurses.
pub const STEPS_LIMIT: usize = 8;

/// The keys that name an item of a list: the first that it has.
pub const NAMING: [&str; 2] = ["name", "kind"];

/// The name of an item of a list.
pub(crate) fn name_of(node: &Node) -> Option<&str> {
    let name = NAMING.iter().find_map(|key| node.entry(key))?;
    if let Data::Text(name) = &name.data { Some(name) } else { None }
}

/// The index of the item of a list that `step` means: the one of this name, or the one of this number, counted from 0.
fn item(items: &[Node], step: &str) -> Option<usize> {
    item_index(items.iter().map(name_of), step)
}

/// As of `item`, of a list whose items have these names.
pub fn item_index<'a>(
    mut names: impl ExactSizeIterator<Item = Option<&'a str>>,
    step: &str,
) -> Option<usize> {
    let count = names.len();
    let named = names.position(|name| name == Some(step));
    named.or_else(|| step.parse().ok().filter(|index| *index < count))
}

/// Walks down `steps`, making tables where there are none, and puts `leaf` at the end.
fn graft(node: &mut Node, name: &str, steps: &[(&str, Place)], leaf: Node) -> Result<(), Fault> {
    let [(step, place), rest @ ..] = steps else {
        *node = leaf;
        return Ok(());
    };
    let found = node.type_name();
    if let Data::List(items) = &mut node.data {
        let known: Vec<String> = items.iter().filter_map(name_of).map(str::to_owned).collect();
        return match item(items, step) {
            Some(index) => graft(&mut items[index], step, rest, leaf),
            None => {
                let (key, section) = ((*step).to_owned(), format!("`{name}`"));
                Err(Cause::UnknownKey { key, section, known }.at(*place))
            }
        };
    }
    let Data::Table(table) = &mut node.data else {
        return Err(
            Cause::WrongType { key: name.to_owned(), expected: "a table".to_owned(), found }.at(*place)
        );
    };
    let index = match table.entries.iter().position(|entry| entry.key == *step) {
        Some(index) => index,
        None => {
            let node = Node { place: *place, data: Data::Table(DocumentTable::default()) };
            table.entries.push(Entry { key: (*step).to_owned(), place: *place, node });
            table.entries.len() - 1
        }
    };
    graft(&mut table.entries[index].node, step, rest, leaf)
}

/// Turns the spanned TOML of one source into nodes.
struct Converter {
    source: usize,
    offset: usize,
}

impl Converter {
    fn place(&self, span: std::ops::Range<usize>) -> Place {
        Place { source: self.source, start: self.offset + span.start, end: self.offset + span.end }
    }

    fn table(&self, table: DeTable<'_>) -> DocumentTable {
        let mut entries: Vec<_> = table
            .into_iter()
            .map(|(key, value)| Entry {
                place: self.place(key.span()),
                key: key.into_inner().into_owned(),
                node: self.value(value),
            })
            .collect();
        entries.sort_by_key(|entry| entry.place.start);
        DocumentTable { entries }
    }

    fn value(&self, value: Spanned<DeValue<'_>>) -> Node {
        let place = self.place(value.span());
        let data = match value.into_inner() {
            DeValue::String(text) => Data::Text(text.into_owned()),
            DeValue::Integer(integer) => whole_number(&integer),
            DeValue::Float(float) => {
                Data::Number { value: float.as_str().parse().unwrap_or(f64::NAN), whole: None }
            }
            DeValue::Boolean(value) => Data::Boolean(value),
            DeValue::Datetime(_) => Data::Date,
            DeValue::Array(list) => Data::List(list.into_iter().map(|item| self.value(item)).collect()),
            DeValue::Table(table) => Data::Table(self.table(table)),
        };
        Node { place, data }
    }
}

/// An integer beyond `i64` still has a value; in another base than ten it becomes NaN, which every key refuses.
fn whole_number(integer: &DeInteger<'_>) -> Data {
    match i64::from_str_radix(integer.as_str(), integer.radix()) {
        Ok(whole) => Data::Number { value: whole as f64, whole: Some(whole) },
        Err(_) => {
            let value = if integer.radix() == 10 { integer.as_str().parse() } else { Ok(f64::NAN) };
            Data::Number { value: value.unwrap_or(f64::NAN), whole: None }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn text_of(root: &Node, section: &str, key: &str) -> Option<String> {
        let Data::Table(root) = &root.data else { return None };
        let Data::Table(table) = &root.get(section)?.node.data else { return None };
        match &table.get(key)?.node.data {
            Data::Text(text) => Some(text.clone()),
            Data::Number { value, .. } => Some(value.to_string()),
            _ => None,
        }
    }

    #[test]
    fn options_are_grafted_with_their_place() {
        let mut root = parse("[operation]\nvelocity = 1e-4\n").unwrap();
        apply_override(&mut root, 1, "operation.velocity = 30 mm/s").unwrap();
        apply_override(&mut root, 2, "contact.law=hertz").unwrap();
        apply_override(&mut root, 3, "operation.normal_load=2e-6").unwrap();
        assert_eq!(text_of(&root, "operation", "velocity").unwrap(), "30 mm/s");
        assert_eq!(text_of(&root, "contact", "law").unwrap(), "hertz");
        assert_eq!(text_of(&root, "operation", "normal_load").unwrap(), "0.000002");
        let Data::Table(table) = &root.data else { panic!() };
        let Data::Table(operation) = &table.get("operation").unwrap().node.data else { panic!() };
        let place = operation.get("velocity").unwrap().node.place;
        assert_eq!((place.source, place.start, place.end), (1, 21, 28));
    }

    #[test]
    fn entries_keep_the_order_of_the_text() {
        let Data::Table(table) = parse("b = 1\na = 2\nz = 3").unwrap().data else { panic!() };
        assert_eq!(table.entries.iter().map(|entry| entry.key.as_str()).collect::<Vec<_>>(), ["b", "a", "z"]);
    }
}
