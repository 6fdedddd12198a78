//! Numbers of a case: a plain number is a dimensionless group, a string carries a unit; their ranges, and how they are read and written.

use crate::cause::Cause;
use crate::dimension::Dimension;
use crate::document::{Data, Node};
use crate::error::Fault;
use crate::quantity::{Quantity, WrittenNumber};
use crate::section::{finite_number, text, wrong_type};
use serde_json::{Value as Json, json};

pub use crate::range::Range;

/// Whether a number is the paper's dimensionless group or a quantity in SI units.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Form {
    /// A plain number in the case file: the group that [`Scaled::group`] names.
    #[default]
    Group,
    /// A quantity with a unit in the case file; the number is in SI units.
    Si,
}

/// A number of a case with its form.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
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

/// A number that is a dimensionless group, or a quantity of this dimension, or either.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scaled {
    /// The dimension of a quantity with a unit; that of a number where none may have one.
    pub dimension: Dimension,
    /// The dimensionless group that a plain number is; without one only a quantity with a unit is taken.
    pub group: Option<&'static str>,
    /// The numbers allowed, as group and in SI units alike.
    pub range: Range,
    /// Whether a temperature is meant as a difference: degrees Celsius, with their own zero, are then refused.
    pub is_difference: bool,
}

impl Scaled {
    /// Above zero, as this group or with a unit.
    pub const fn positive(dimension: Dimension, group: &'static str) -> Self {
        Self { dimension, group: Some(group), range: Range::Positive, is_difference: false }
    }

    /// Above zero, with a unit.
    pub const fn quantity(dimension: Dimension) -> Self {
        Self { dimension, group: None, range: Range::Positive, is_difference: false }
    }

    /// A pure number, by its symbol.
    pub const fn number(symbol: &'static str, range: Range) -> Self {
        Self { dimension: Dimension::NUMBER, group: Some(symbol), range, is_difference: false }
    }

    /// An example of a value with a unit.
    pub fn example(&self) -> String {
        if self.is_difference { "51.6 K".to_owned() } else { self.dimension.example() }
    }

    /// The canonical form of a value.
    pub fn write(&self, value: Value) -> Json {
        match value.form {
            Form::Group => json!(value.number),
            Form::Si => json!({ "value": value.number, "unit": self.dimension.unit() }),
        }
    }

    /// Reads a value, which errors call `name`: a plain number is the group, a string carries a unit.
    pub fn read(&self, name: &str, node: &Node) -> Result<Value, Fault> {
        let value = match &node.data {
            Data::Number { .. } => {
                let number = finite_number(name, node)?;
                if self.group.is_none() {
                    let (key, dimension) = (name.to_owned(), self.dimension);
                    return Err(Cause::NeedsUnit { key, dimension }.at(node.place));
                }
                Value::group(number)
            }
            Data::Text(text) if !self.dimension.is_number() => self.read_quantity(name, text, node)?,
            _ => return Err(wrong_type(name, &self.expected(), node)),
        };
        if self.range.contains(value.number) {
            return Ok(value);
        }
        let (key, number, range) = (name.to_owned(), WrittenNumber::of(node, value.number), self.range);
        Err(Cause::OutOfRange { key, number, range }.at(node.place))
    }

    fn read_quantity(&self, name: &str, text: &str, node: &Node) -> Result<Value, Fault> {
        let dimension = self.dimension;
        let quantity = Quantity::parse(text).map_err(|(problem, range)| {
            Cause::Quantity { key: name.to_owned(), dimension, problem }.at(node.part(range))
        })?;
        if self.is_difference && Quantity::is_celsius(text) {
            let problem = Cause::Difference { key: name.to_owned(), example: self.example() };
            return Err(problem.at(node.place));
        }
        if quantity.dimension == dimension {
            return Ok(Value::si(quantity.number));
        }
        let (key, found) = (name.to_owned(), quantity.dimension);
        Err(Cause::WrongDimension { key, expected: dimension, found, group: self.group }.at(node.place))
    }

    /// What may stand there, as an error says it.
    fn expected(&self) -> String {
        let quantity = || format!("{} in quotes, such as \"{}\"", self.dimension, self.example());
        match self.group {
            _ if self.dimension.is_number() => "a plain number".to_owned(),
            None => quantity(),
            Some(group) => format!("a plain number ({group}) or {}", quantity()),
        }
    }
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
