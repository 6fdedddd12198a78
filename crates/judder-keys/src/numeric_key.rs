//! Numbers of a case: a plain number is a dimensionless group, a string carries a unit; their ranges, and how they are read.

use crate::cause::Cause;
use crate::dimension::Dimension;
use crate::document::{Data, Node};
use crate::error::Fault;
use crate::quantity::Quantity;
use crate::section::{finite_number, text, wrong_type};

pub use crate::range::Range;

/// Whether a number is the paper's dimensionless group or a quantity in SI units.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Form {
    /// A plain number in the case file: the group that [`Key::group`] names.
    Group,
    /// A quantity with a unit in the case file; the number is in SI units.
    Si,
}

/// A number of a case with its form.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Value {
    /// The number: a group, or in the SI unit of the key's dimension.
    pub number: f64,
    /// Which of the two it is.
    pub form: Form,
}

impl Value {
    /// A dimensionless group or pure number.
    pub const fn group(number: f64) -> Self {
        Self { number, form: Form::Group }
    }

    /// A number in SI units.
    pub const fn si(number: f64) -> Self {
        Self { number, form: Form::Si }
    }
}

/// One entry of a table of numeric keys.
#[derive(Debug, Clone, Copy)]
pub struct Key<K> {
    /// The key itself.
    pub key: K,
    /// Its dotted path in the case file, such as `section.name`.
    pub path: &'static str,
    /// The paper's symbol of the dimensional quantity, or of the pure number.
    pub symbol: &'static str,
    /// The dimension of a value with a unit.
    pub dimension: Dimension,
    /// The dimensionless group that a plain number is; without one the key takes only a quantity with a unit.
    pub group: Option<&'static str>,
    /// Whether a temperature is meant as a difference: degrees Celsius, with their own zero, are then refused.
    pub difference: bool,
    /// The numbers allowed, as group and in SI units alike.
    pub range: Range,
    /// The oscillator paper's value: as a case file writes it (without quotes), and read.
    pub default: Option<(&'static str, Value)>,
    /// From where to where its values usually lie, in the form of a plain number where the key takes one, else in SI units: what a control
    /// runs over, between equal ratios where it begins above zero.
    pub typical: Option<[f64; 2]>,
    /// What the key is, in one line.
    pub doc: &'static str,
}

impl<K> Key<K> {
    /// From where to where its values usually lie; where that is not said the whole of a range that ends, or what lies about the default.
    pub fn typical(&self) -> [f64; 2] {
        let about = |value: f64| if value > 0.0 { [1e-3 * value, 1e3 * value] } else { [0.0, 1.0] };
        match (self.typical, self.range) {
            (Some(typical), _) => typical,
            (None, Range::Interval { above, up_to }) => [above, up_to],
            (None, Range::Fraction) => [0.0, 1.0],
            (None, _) => about(self.default.map_or(0.0, |(_, value)| value.number)),
        }
    }

    /// An example of a value with a unit.
    pub fn example(&self) -> String {
        if self.difference { "51.6 K".to_owned() } else { self.dimension.example() }
    }

    /// What stands at an axis: the group or pure number, or the symbol with its SI unit.
    pub fn label(&self, form: Form) -> String {
        match (form, self.group) {
            (Form::Group, Some(group)) => group.to_owned(),
            _ => format!("{} ({})", self.symbol, self.dimension.unit()),
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
}

impl<K: Copy> Key<K> {
    /// The same, whose values usually lie between these.
    #[must_use]
    pub const fn typically(self, from: f64, to: f64) -> Self {
        Self { typical: Some([from, to]), ..self }
    }
}

/// An entry that takes a pure number only.
pub const fn number<K: Copy>(
    key: K,
    path: &'static str,
    symbol: &'static str,
    range: Range,
    default: (&'static str, f64),
    doc: &'static str,
) -> Key<K> {
    let default = Some((default.0, Value::group(default.1)));
    let group = Some(symbol);
    let (dimension, typical) = (Dimension::NUMBER, None);
    Key { key, path, symbol, dimension, group, difference: false, range, default, typical, doc }
}

/// An entry that takes a quantity with a unit only.
pub const fn quantity<K: Copy>(
    key: K,
    path: &'static str,
    symbol: &'static str,
    dimension: Dimension,
    default: (&'static str, f64),
    doc: &'static str,
) -> Key<K> {
    let default = Some((default.0, Value::si(default.1)));
    let range = Range::Positive;
    let (group, typical) = (None, None);
    Key { key, path, symbol, dimension, group, difference: false, range, default, typical, doc }
}

/// Reads the value of a numeric key: a plain number is its group, a string carries a unit.
pub fn read_value<K>(entry: &Key<K>, name: &str, node: &Node) -> Result<Value, Fault> {
    let value = match &node.data {
        Data::Number { .. } => {
            let number = finite_number(name, node)?;
            if entry.group.is_none() {
                return Err(
                    Cause::NeedsUnit { key: name.to_owned(), dimension: entry.dimension }.at(node.place)
                );
            }
            Value::group(number)
        }
        Data::Text(text) if !entry.dimension.is_number() => read_quantity(entry, name, text, node)?,
        _ => {
            let expected = match (entry.group, entry.dimension.is_number()) {
                (_, true) => "a plain number".to_owned(),
                (None, false) => {
                    format!("{} in quotes, such as \"{}\"", entry.dimension, entry.example())
                }
                (Some(group), false) => {
                    format!(
                        "a plain number ({group}) or {} in quotes, such as \"{}\"",
                        entry.dimension,
                        entry.example()
                    )
                }
            };
            return Err(wrong_type(name, &expected, node));
        }
    };
    if entry.range.contains(value.number) {
        return Ok(value);
    }
    Err(Cause::OutOfRange { key: name.to_owned(), number: value.number, range: entry.range }.at(node.place))
}

/// Reads a quantity of this dimension, in SI units; an error calls it `name`.
pub fn read_si(name: &str, dimension: Dimension, node: &Node) -> Result<f64, Fault> {
    let (key, text) = (name.to_owned(), text(name, node)?);
    let quantity = Quantity::parse(text).map_err(|(problem, range)| {
        Cause::Quantity { key: key.clone(), dimension, problem }.at(node.part(range))
    })?;
    if quantity.dimension == dimension {
        return Ok(quantity.number);
    }
    Err(Cause::WrongDimension { key, expected: dimension, found: quantity.dimension, group: None }
        .at(node.place))
}

fn read_quantity<K>(entry: &Key<K>, name: &str, text: &str, node: &Node) -> Result<Value, Fault> {
    let dimension = entry.dimension;
    let quantity = Quantity::parse(text).map_err(|(problem, range)| {
        Cause::Quantity { key: name.to_owned(), dimension, problem }.at(node.part(range))
    })?;
    if entry.difference && Quantity::is_celsius(text) {
        let problem = Cause::Difference { key: name.to_owned(), example: entry.example() };
        return Err(problem.at(node.place));
    }
    if quantity.dimension == dimension {
        return Ok(Value { number: quantity.number, form: Form::Si });
    }
    let (key, found) = (name.to_owned(), quantity.dimension);
    Err(Cause::WrongDimension { key, expected: dimension, found, group: entry.group }.at(node.place))
}
