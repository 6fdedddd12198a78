//! Matrices of numbers and expressions: compiled entries, refused while reading where no sweep can mend them.

use crate::mass::{NoMass, check_mass};
use judder_keys::cause::Cause;
use judder_keys::declared::{Allowed, Setting, all};
use judder_keys::document::{Data, Node};
use judder_keys::error::{Fault, Place};
use judder_keys::expression::Expression;
use judder_keys::problem::{Placed, Problem};
use judder_keys::section::{Section, finite_number, list, wrong_type};
use serde_json::{Value as Json, json};
use thiserror::Error;

/// One matrix: compiled entries, and their texts for the record.
#[derive(Debug, Clone)]
pub struct EntryMatrix {
    pub(crate) name: &'static str,
    rows: Vec<Vec<MatrixEntry>>,
}

/// An entry: a number, or an expression of parameters.
#[derive(Debug, Clone)]
pub(crate) struct MatrixEntry {
    matrix: &'static str,
    row: usize,
    column: usize,
    text: String,
    expression: Expression,
    /// The parameters that the entry depends on: position and name.
    parameters: Vec<(usize, String)>,
}

/// What is known of the parameters while the matrices are read.
pub(crate) struct Scope<'a> {
    pub(crate) names: &'a [String],
    pub(crate) values: &'a [f64],
    /// The positions of those that an analysis sweeps.
    pub(crate) swept: &'a [usize],
}

impl EntryMatrix {
    /// A multiple of the identity.
    pub(crate) fn diagonal(name: &'static str, order: usize, value: f64) -> Self {
        let entry =
            |row, column| MatrixEntry::constant(name, [row, column], if row == column { value } else { 0.0 });
        Self {
            name,
            rows: (0..order).map(|row| (0..order).map(|column| entry(row, column)).collect()).collect(),
        }
    }

    /// How many rows it has.
    pub(crate) fn order(&self) -> usize {
        self.rows.len()
    }

    /// The entries, row by row.
    pub(crate) fn entries(&self) -> impl Iterator<Item = &MatrixEntry> {
        self.rows.iter().flatten()
    }

    /// The text of an entry as the case file has it.
    pub(crate) fn text(&self, row: usize, column: usize) -> &str {
        &self.rows[row][column].text
    }

    /// An entry where the parameters are `values`; one that is not finite is the error.
    pub(crate) fn entry(&self, row: usize, column: usize, values: &[f64]) -> Result<f64, Cause> {
        self.rows[row][column].evaluate(values)
    }

    /// Whether an entry depends on the parameter at `index`.
    pub(crate) fn depends_on(&self, index: usize) -> bool {
        self.entries().any(|entry| entry.parameters.iter().any(|(used, _)| *used == index))
    }

    fn is_swept(&self, scope: &Scope<'_>) -> bool {
        self.entries().any(|entry| entry.is_swept(scope))
    }
}

impl MatrixEntry {
    fn constant(matrix: &'static str, [row, column]: [usize; 2], value: f64) -> Self {
        let (text, expression) = (value.to_string(), Expression::constant(value));
        Self { matrix, row, column, text, expression, parameters: Vec::new() }
    }

    /// Row and column.
    pub(crate) fn position(&self) -> [usize; 2] {
        [self.row, self.column]
    }

    /// What it is called in messages.
    pub(crate) fn name(&self) -> String {
        format!("{}[{}][{}]", self.matrix, self.row, self.column)
    }

    /// Whether no parameter enters it.
    pub(crate) fn is_constant(&self) -> bool {
        self.parameters.is_empty()
    }

    /// Its value where the parameters are `values`; one that is not finite is the error.
    pub(crate) fn evaluate(&self, values: &[f64]) -> Result<f64, Cause> {
        let value = self.expression.evaluate(values);
        if value.is_finite() {
            return Ok(value);
        }
        let known = |(index, name): &(usize, String)| Some(format!("{name} = {}", values.get(*index)?));
        let point: Vec<_> = self.parameters.iter().filter_map(known).collect();
        let Self { matrix, row, column, .. } = *self;
        Err(Cause::NotFiniteEntry { matrix, row, column, value, point: point.join(", ") })
    }

    /// Whether an analysis varies the entry, so that only the run can tell what it is.
    fn is_swept(&self, scope: &Scope<'_>) -> bool {
        self.parameters.iter().any(|(index, _)| scope.swept.contains(index))
    }
}

/// How many rows a matrix must have.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Order {
    /// Two.
    Two,
    /// Any number, as many as columns.
    Any,
}

/// Rows of entries as a case gives them, before the parameters are known.
#[derive(Debug, Clone)]
pub(crate) struct Entries {
    /// The key.
    key: String,
    rows: Vec<Vec<Node>>,
    place: Place,
}

/// Rows that make no square matrix.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("`{key}` is not square: it has {rows} row{}, but row {row} has {found} entr{}", if *.rows == 1 { "" } else { "s" }, if *.found == 1 { "y" } else { "ies" })]
pub struct NotSquare {
    /// The key.
    pub key: String,
    /// How many rows there are.
    pub rows: usize,
    /// The row, counted from one.
    pub row: usize,
    /// How many entries it has.
    pub found: usize,
}

impl Problem for NotSquare {
    fn kind(&self) -> &'static str {
        "Matrix"
    }

    fn label(&self) -> &'static str {
        "this row"
    }

    fn help(&self) -> Option<String> {
        Some("give as many rows as entries in each, as in [[\"2\", \"1 - mu\"], [1, 2]]".to_owned())
    }
}

impl Setting for Entries {
    type Rule = Order;

    fn form(order: &Order) -> Allowed {
        let length = if *order == Order::Two { [2, 2] } else { [1, usize::MAX] };
        let listed = |of: Allowed| Allowed::List { of: Box::new(of), length };
        listed(listed(Allowed::Expression))
    }

    fn read(section: &Section<'_>, key: &str, node: &Node, order: &Order) -> Result<Self, Fault> {
        let key = section.path(key);
        let rows = list(&key, node)?;
        let shape = |node: &Node| Cause::MatrixShape { key: key.clone() }.at(node.place);
        if *order == Order::Two && rows.len() != 2 {
            return Err(shape(node));
        }
        if rows.is_empty() {
            return Err(Cause::EmptyList { key }.at(node.place));
        }
        let row = |(number, node): (usize, &Node)| -> Result<Vec<Node>, Fault> {
            let entries = list(&key, node)?;
            if entries.len() == rows.len() {
                return Ok(entries.to_vec());
            }
            Err(match order {
                Order::Two => shape(node),
                Order::Any => {
                    let (key, found) = (key.clone(), entries.len());
                    NotSquare { key, rows: rows.len(), row: number + 1, found }.at(node.place)
                }
            })
        };
        let rows = all(rows.iter().enumerate().map(row))?;
        Ok(Self { key, rows, place: node.place })
    }

    /// The numbers and expressions as they stand there.
    fn write(&self, _: &Order) -> Json {
        let entry = |node: &Node| match &node.data {
            Data::Text(text) => json!(text),
            Data::Number { value, .. } => json!(value),
            _ => Json::Null,
        };
        self.rows.iter().map(|row| row.iter().map(entry).collect::<Json>()).collect()
    }
}

impl Entries {
    /// How many rows it has.
    pub(crate) fn order(&self) -> usize {
        self.rows.len()
    }

    /// M.
    pub(crate) fn mass(&self, scope: &Scope<'_>) -> Result<EntryMatrix, Fault> {
        let matrix = self.matrix("mass", scope)?;
        if !matrix.is_swept(scope) {
            let row = |row: &Vec<MatrixEntry>| -> Result<Vec<f64>, Cause> {
                row.iter().map(|entry| entry.evaluate(scope.values)).collect()
            };
            let mass: Result<Vec<_>, _> = matrix.rows.iter().map(row).collect();
            let mass = mass.map_err(|cause| cause.at(self.place))?;
            check_mass(&mass).map_err(|problem| NoMass { mass, problem }.at(self.place))?;
        }
        Ok(matrix)
    }

    /// The matrix of this name, all that is wrong with its entries told.
    pub(crate) fn matrix(&self, name: &'static str, scope: &Scope<'_>) -> Result<EntryMatrix, Fault> {
        let row = |(row, nodes): (usize, &Vec<Node>)| {
            let entry = |(column, node): (usize, &Node)| self.entry(name, [row, column], node, scope);
            all(nodes.iter().enumerate().map(entry))
        };
        Ok(EntryMatrix { name, rows: all(self.rows.iter().enumerate().map(row))? })
    }

    fn entry(
        &self,
        matrix: &'static str,
        position: [usize; 2],
        node: &Node,
        scope: &Scope<'_>,
    ) -> Result<MatrixEntry, Fault> {
        let text = match &node.data {
            Data::Text(text) => text,
            Data::Number { .. } => {
                return finite_number(&self.key, node)
                    .map(|value| MatrixEntry::constant(matrix, position, value));
            }
            _ => return Err(wrong_type(&self.key, "a number or an expression in quotes", node)),
        };
        let expression = Expression::compile(text, scope.names).map_err(|(problem, range)| {
            Cause::Expression { problem, parameters: scope.names.to_vec() }.at(node.part(range))
        })?;
        let used = scope.names.iter().enumerate().filter(|(index, _)| expression.depends_on(*index));
        let parameters = used.map(|(index, name)| (index, name.clone())).collect();
        let [row, column] = position;
        let entry = MatrixEntry { matrix, row, column, text: text.clone(), expression, parameters };
        if !entry.is_swept(scope) {
            entry.evaluate(scope.values).map_err(|cause| cause.at(node.part(0..text.len())))?;
        }
        Ok(entry)
    }
}
