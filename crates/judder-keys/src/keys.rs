//! The numbers of a case that its analyses vary: an enum with a variant a key, from which everything said of them follows.

use crate::declared::{Allowed, Declaration, Flat, Number, Setting, all, both};
use crate::dimension::Dimension;
use crate::document::{Data, Node};
use crate::error::{CaseError, Fault, Place, Sources};
use crate::numeric_key::{Form, Range, Scaled, Value};
use crate::quantity::Quantity;
use crate::section::Section;
use serde_json::{Map, Value as Json, json};

/// The numbers of a case that its analyses vary.
pub trait Keys: Copy + PartialEq + 'static {
    /// What is said of each, in the order of the case file.
    const ALL: &'static [Key<Self>];

    /// What is said of this one.
    fn entry(self) -> &'static Key<Self>;

    /// The key of a dotted path such as `operation.velocity`.
    fn from_path(path: &str) -> Option<Self> {
        Self::ALL.iter().find(|entry| entry.path == path).map(|entry| entry.key)
    }

    /// The dotted paths of all.
    fn paths() -> Vec<&'static str> {
        Self::ALL.iter().map(|entry| entry.path).collect()
    }

    /// The value of this key, as a case file that says `given` would have it; errors call it by its dotted path, and their source `argument`.
    ///
    /// # Errors
    /// [`CaseError`] for a unit of another dimension or none, a text that is no quantity, a number that is out of range or not finite.
    fn read(self, given: Given<'_>) -> Result<Value, CaseError> {
        let Key { path, rule, .. } = self.entry();
        let (data, text) = match given {
            Given::Number(value) if rule.group.is_some() && rule.range.contains(value) => {
                return Ok(Value::group(value));
            }
            Given::Number(value) => (Data::Number { value, whole: None }, value.to_string()),
            Given::Text(text) => (Data::Text(text.to_owned()), format!("\"{text}\"")),
        };
        let node = Node { place: Place { source: 0, start: 0, end: text.len() }, data };
        rule.read(path, &node).map_err(|fault| Sources::new("argument", &text, &[]).error(fault))
    }

    /// Those of one section.
    fn of_section(section: &str) -> impl Iterator<Item = &'static Key<Self>> {
        Self::ALL.iter().filter(move |entry| entry.section() == section)
    }
}

/// A value that comes from a program and not from a case file.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Given<'a> {
    /// A plain number: the group of the key, or its pure number.
    Number(f64),
    /// A number with its unit, such as `30 mm/s`.
    Text(&'a str),
}

/// What is said of a number of a case.
#[derive(Debug, Clone, Copy)]
pub struct Key<K> {
    /// The key itself.
    pub key: K,
    /// Its dotted path in the case file, such as `section.name`.
    pub path: &'static str,
    /// The paper's symbol of the dimensional quantity, or of the pure number.
    pub symbol: &'static str,
    /// What it may be.
    pub rule: Scaled,
    /// The usual value as a case file writes it, without quotes; a key without one follows from the others.
    pub default: Option<&'static str>,
    /// From where to where its values usually lie, in the form of a plain number where the key takes one, else in SI units: what a control
    /// runs over, between equal ratios where it begins above zero.
    pub typical: Option<[f64; 2]>,
    /// What it is, in one line.
    pub doc: &'static str,
    /// Its words at an axis.
    pub label: &'static str,
    /// The symbol of the group that a plain number is at an axis, in the markup of figures, where it is not that of the key.
    pub scaled: Option<&'static str>,
}

impl<K> Key<K> {
    /// What stands at an axis: the group or pure number, or the symbol with its SI unit.
    pub fn label(&self, form: Form) -> String {
        match (form, self.rule.group) {
            (Form::Group, Some(group)) => group.to_owned(),
            _ => format!("{} ({})", self.symbol, self.rule.dimension.unit()),
        }
    }

    /// The symbol in the markup of figures, of a value of this form: `v_{d}`.
    pub fn markup(&self, form: Form) -> String {
        if let (Form::Group, Some(scaled)) = (form, self.scaled) {
            return scaled.to_owned();
        }
        let (base, index) = self.symbol.split_at(self.symbol.chars().next().map_or(0, char::len_utf8));
        match index.trim_start_matches('_') {
            "" => base.to_owned(),
            index => format!("{base}_{{{index}}}"),
        }
    }

    /// From where to where its values usually lie; where that is not said the whole of a range that ends, or what lies about the usual value.
    pub fn typical(&self) -> [f64; 2] {
        let about = |value: f64| if value > 0.0 { [1e-3 * value, 1e3 * value] } else { [0.0, 1.0] };
        match (self.typical, self.rule.range) {
            (Some(typical), _) => typical,
            (None, Range::Interval { above: from, up_to: to } | Range::Closed { from, to }) => [from, to],
            (None, Range::Fraction) => [0.0, 1.0],
            (None, _) => about(self.usual_value().map_or(0.0, |value| value.number)),
        }
    }

    /// The section of the key, such as `operation`.
    pub fn section(&self) -> &'static str {
        self.path.split_once('.').map_or("", |(section, _)| section)
    }

    /// The name of the key in its table, such as `velocity`.
    pub fn name(&self) -> &'static str {
        self.path.rsplit_once('.').map_or(self.path, |(_, name)| name)
    }

    /// The usual value; none where the text of it is no quantity of the key.
    pub fn usual_value(&self) -> Option<Value> {
        let quantity = Quantity::parse(self.default?).ok()?;
        let form = if quantity.dimension.is_number() { Form::Group } else { Form::Si };
        let fits =
            quantity.dimension == if form == Form::Si { self.rule.dimension } else { Dimension::NUMBER };
        fits.then_some(Value { number: quantity.number, form })
    }

    /// The usual value as a case file writes it: in quotes where it has a unit.
    fn written(&self) -> Option<Json> {
        let (text, value) = (self.default?, self.usual_value()?);
        Some(if value.form == Form::Group { json!(value.number) } else { json!(text) })
    }

    /// Its line in a commented case: `velocity = 1e-4  # v_d τ/R, or a speed ("30 mm/s"): driving speed`; a key without a usual value shows, as a
    /// comment, the one that follows from the others.
    fn line(&self, followed: impl FnOnce() -> f64) -> String {
        let Scaled { dimension, group, .. } = self.rule;
        let (mark, value) = match self.default.zip(self.usual_value()) {
            Some((text, Value { form: Form::Group, .. })) => ("", text.to_owned()),
            Some((text, _)) => ("", format!("\"{text}\"")),
            None => ("# ", format!("\"{} {}\"", followed(), dimension.unit())),
        };
        let symbol = match group {
            Some(group) if !dimension.is_number() => {
                format!("{group}, or {dimension} (\"{}\")", dimension.example())
            }
            _ => self.symbol.to_owned(),
        };
        let setting = format!("{mark}{} = {value}", self.name());
        format!("{setting:<34}# {symbol}: {}\n", self.doc)
    }

    /// As a key of the table of its section.
    pub fn declaration(&self) -> Declaration {
        let Scaled { dimension, group, range, .. } = self.rule;
        let form = match group {
            Some(_) if !dimension.is_number() => Allowed::Scaled(self.rule),
            _ => Allowed::Number(Number { dimension, range }),
        };
        let (name, doc, symbol, default) = (self.name(), self.doc, self.symbol, self.written());
        Declaration { name, doc, symbol, default, is_required: false, alternative: None, form }
    }
}

/// The lines of a section in a commented case, one a key; `followed` says what follows where a key has no usual value.
pub fn lines<K: Keys>(section: &str, followed: impl Fn(K) -> f64) -> String {
    K::of_section(section).map(|entry| entry.line(|| followed(entry.key))).collect()
}

/// The numbers that a section of a case gives.
#[derive(Debug, Clone, PartialEq)]
pub struct Numbers<K>(pub Vec<(K, Value)>);

impl<K> Default for Numbers<K> {
    fn default() -> Self {
        Self(Vec::new())
    }
}

/// The keys of the section that the rule names, among others of it.
impl<K: Keys> Flat for Numbers<K> {
    type Rule = &'static str;

    fn keys(section: &&'static str) -> Vec<&'static str> {
        K::of_section(section).map(Key::name).collect()
    }

    fn declarations(section: &&'static str) -> Vec<Declaration> {
        K::of_section(section).map(Key::declaration).collect()
    }

    fn read(section: &Section<'_>, rule: &&'static str) -> Result<Self, Fault> {
        let given =
            K::of_section(rule).filter_map(|entry| section.get(entry.name()).map(|node| (entry, node)));
        let read = |(entry, node): (&Key<K>, &Node)| {
            Ok((entry.key, entry.rule.read(&section.path(entry.name()), node)?))
        };
        all(given.map(read)).map(Self)
    }

    fn write(&self, json: &mut Map<String, Json>) {
        for (key, value) in &self.0 {
            let entry = key.entry();
            json.insert(entry.name().to_owned(), entry.rule.write(*value));
        }
    }
}

/// The whole section that the rule names.
impl<K: Keys> Setting for Numbers<K> {
    type Rule = &'static str;
    const IS_OPTIONAL: bool = true;

    fn absent() -> Option<Self> {
        Some(Self::default())
    }

    fn form(section: &&'static str) -> Allowed {
        Allowed::Table { doc: "", keys: <Self as Flat>::declarations(section) }
    }

    fn read(root: &Section<'_>, key: &str, node: &Node, rule: &&'static str) -> Result<Self, Fault> {
        let section = Section::of_table(node, &root.path(key), &root.title(key))?;
        let known = <Self as Flat>::keys(rule);
        both(section.refuse_others(&known), <Self as Flat>::read(&section, rule)).map(|((), numbers)| numbers)
    }

    fn write(&self, _: &&'static str) -> Json {
        let mut json = Map::new();
        Flat::write(self, &mut json);
        Json::Object(json)
    }
}
