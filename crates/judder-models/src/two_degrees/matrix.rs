//! The matrices of a two-degrees case: compiled entries, refused while reading where no sweep can mend them.

use crate::two_degrees::mass::{NoMass, check_mass};
use judder_keys::cause::Cause;
use judder_keys::declared::{Allowed, Setting, both};
use judder_keys::document::{Data, Node};
use judder_keys::error::{Fault, Place};
use judder_keys::expression::Expression;
use judder_keys::problem::Placed;
use judder_keys::section::{Section, finite_number, list, wrong_type};
use serde_json::{Value as Json, json};

/// One matrix: compiled entries, and their texts for the record.
#[derive(Debug, Clone)]
pub(crate) struct Matrix {
    pub(crate) name: &'static str,
    entries: [[Entry; 2]; 2],
}

#[derive(Debug, Clone)]
struct Entry {
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

impl Matrix {
    /// A multiple of the identity.
    pub(crate) fn diagonal(name: &'static str, value: f64) -> Self {
        let entry =
            |row, column| Entry::constant(name, [row, column], if row == column { value } else { 0.0 });
        Self { name, entries: [[entry(0, 0), entry(0, 1)], [entry(1, 0), entry(1, 1)]] }
    }

    /// The texts of the entries as the case file has them.
    pub(crate) fn texts(&self) -> [[&str; 2]; 2] {
        self.entries.each_ref().map(|row| row.each_ref().map(|entry| entry.text.as_str()))
    }

    /// The entries where the parameters are `values`; the first that is not finite is the error.
    pub(crate) fn evaluate(&self, values: &[f64]) -> Result<[[f64; 2]; 2], Cause> {
        let [[a, b], [c, d]] = &self.entries;
        Ok([[a.evaluate(values)?, b.evaluate(values)?], [c.evaluate(values)?, d.evaluate(values)?]])
    }

    fn is_swept(&self, scope: &Scope<'_>) -> bool {
        self.entries.iter().flatten().any(|entry| entry.is_swept(scope))
    }
}

impl Entry {
    fn constant(matrix: &'static str, [row, column]: [usize; 2], value: f64) -> Self {
        let (text, expression) = (value.to_string(), Expression::constant(value));
        Self { matrix, row, column, text, expression, parameters: Vec::new() }
    }

    fn evaluate(&self, values: &[f64]) -> Result<f64, Cause> {
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

/// Two rows of two entries as a case gives them, before the parameters are known.
#[derive(Debug)]
pub(crate) struct Entries {
    rows: [[Node; 2]; 2],
    place: Place,
}

impl Setting for Entries {
    type Rule = ();

    fn form((): &()) -> Allowed {
        let two = |of: Allowed| Allowed::List { of: Box::new(of), length: [2, 2] };
        two(two(Allowed::Expression))
    }

    fn read(section: &Section<'_>, key: &str, node: &Node, (): &()) -> Result<Self, Fault> {
        let key = section.path(key);
        let pair = |node: &Node| -> Result<[Node; 2], Fault> {
            let shape = |_| Cause::MatrixShape { key: key.clone() }.at(node.place);
            list(&key, node)?.to_vec().try_into().map_err(shape)
        };
        let [first, second] = pair(node)?;
        let (first, second) = both(pair(&first), pair(&second))?;
        Ok(Self { rows: [first, second], place: node.place })
    }

    /// The numbers and expressions as they stand there.
    fn write(&self, (): &()) -> Json {
        let entry = |node: &Node| match &node.data {
            Data::Text(text) => json!(text),
            Data::Number { value, .. } => json!(value),
            _ => Json::Null,
        };
        self.rows.each_ref().map(|row| row.each_ref().map(entry)).into_iter().collect()
    }
}

impl Entries {
    /// M.
    pub(crate) fn mass(&self, scope: &Scope<'_>) -> Result<Matrix, Fault> {
        let matrix = self.matrix("mass", scope)?;
        if !matrix.is_swept(scope) {
            let mass = matrix.evaluate(scope.values).map_err(|cause| cause.at(self.place))?;
            check_mass(mass).map_err(|problem| NoMass { mass, problem }.at(self.place))?;
        }
        Ok(matrix)
    }

    /// The matrix of this name, all that is wrong with its entries told.
    pub(crate) fn matrix(&self, name: &'static str, scope: &Scope<'_>) -> Result<Matrix, Fault> {
        let key = format!("matrices.{name}");
        let entry =
            |row: usize, column: usize| read_entry(&key, name, [row, column], &self.rows[row][column], scope);
        let ((a, b), (c, d)) = both(both(entry(0, 0), entry(0, 1)), both(entry(1, 0), entry(1, 1)))?;
        Ok(Matrix { name, entries: [[a, b], [c, d]] })
    }
}

fn read_entry(
    key: &str,
    matrix: &'static str,
    position: [usize; 2],
    node: &Node,
    scope: &Scope<'_>,
) -> Result<Entry, Fault> {
    let text = match &node.data {
        Data::Text(text) => text,
        Data::Number { .. } => {
            return finite_number(key, node).map(|value| Entry::constant(matrix, position, value));
        }
        _ => return Err(wrong_type(key, "a number or an expression in quotes", node)),
    };
    let expression = Expression::compile(text, scope.names).map_err(|(problem, range)| {
        Cause::Expression { problem, parameters: scope.names.to_vec() }.at(node.part(range))
    })?;
    let used = scope.names.iter().enumerate().filter(|(index, _)| expression.depends_on(*index));
    let parameters = used.map(|(index, name)| (index, name.clone())).collect();
    let [row, column] = position;
    let entry = Entry { matrix, row, column, text: text.clone(), expression, parameters };
    if !entry.is_swept(scope) {
        entry.evaluate(scope.values).map_err(|cause| cause.at(node.part(0..text.len())))?;
    }
    Ok(entry)
}
