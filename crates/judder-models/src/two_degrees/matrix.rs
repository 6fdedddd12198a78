//! The matrices of a two-degrees case: compiled entries, refused while reading where no sweep can mend them.

use crate::two_degrees::mass::{NoMass, check_mass};
use judder_keys::cause::Cause;
use judder_keys::document::{Data, Node};
use judder_keys::error::Fault;
use judder_keys::expression::Expression;
use judder_keys::problem::Placed;
use judder_keys::section::{Section, finite_number, list, wrong_type};

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

/// Reads M; where the case gives none it is the identity.
pub(crate) fn read_mass(section: &Section<'_>, scope: &Scope<'_>) -> Result<Matrix, Fault> {
    let matrix = read_matrix(section, "mass", 1.0, scope)?;
    if let Some(node) = section.get(matrix.name)
        && !matrix.is_swept(scope)
    {
        let mass = matrix.evaluate(scope.values).map_err(|cause| cause.at(node.place))?;
        check_mass(mass).map_err(|problem| NoMass { mass, problem }.at(node.place))?;
    }
    Ok(matrix)
}

/// Reads one matrix; where the case gives none it is `diagonal` times the identity.
pub(crate) fn read_matrix(
    section: &Section<'_>,
    name: &'static str,
    diagonal: f64,
    scope: &Scope<'_>,
) -> Result<Matrix, Fault> {
    let Some(node) = section.get(name) else {
        let entry =
            |row, column| Entry::constant(name, [row, column], if row == column { diagonal } else { 0.0 });
        return Ok(Matrix { name, entries: [[entry(0, 0), entry(0, 1)], [entry(1, 0), entry(1, 1)]] });
    };
    let key = section.path(name);
    let pair = |node: &'_ Node| -> Result<[Node; 2], Fault> {
        let shape = || Cause::MatrixShape { key: key.clone() }.at(node.place);
        list(&key, node)?.to_vec().try_into().map_err(|_| shape())
    };
    let row = |index: usize, node: &Node| -> Result<[Entry; 2], Fault> {
        let [left, right] = pair(node)?;
        let read = |column, node| read_entry(&key, name, [index, column], node, scope);
        Ok([read(0, &left)?, read(1, &right)?])
    };
    let [first, second] = pair(node)?;
    Ok(Matrix { name, entries: [row(0, &first)?, row(1, &second)?] })
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
