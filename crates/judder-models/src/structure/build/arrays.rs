//! Matrices that stand in the case, as sums: what no parameter enters is one matrix, every expression one of its own.

use super::{Structure, StructureLayout, Unbuilt};
use crate::entries::{EntryMatrix, MatrixEntry};
use crate::structure::case::arrays::MatrixArrays;
use faer::sparse::Triplet;
use judder_keys::cause::Cause;
use judder_structure::StructureError;
use judder_structure::affine::{AffineFamily, Factors, Term};
use judder_structure::assembly::Sparse;
use judder_structure::freedom::Freedom;

/// The sums of all matrices.
pub(super) fn structure(arrays: &MatrixArrays) -> Result<Structure, Unbuilt> {
    let refused = |error| Unbuilt::because("matrices", &error);
    let sums = arrays.matrices().iter().map(|matrix| terms(matrix).map_err(refused));
    let mut sums = sums.collect::<Result<Vec<_>, _>>()?.into_iter();
    let mut next = || sums.next().unwrap_or_default();
    let family = AffineFamily::new(next(), next(), next()).map_err(refused)?;
    let layout = Some(layout(arrays));
    Ok(Structure { family, layout, elements: None, kept: Vec::new(), warnings: Vec::new() })
}

/// The factors of all terms where the parameters are `values`.
pub(super) fn factors(arrays: &MatrixArrays, values: &[f64]) -> Result<Factors, Cause> {
    let of = |matrix: &EntryMatrix| -> Result<Vec<f64>, Cause> {
        let varied = matrix.entries().filter(|entry| !entry.is_constant());
        let varied = varied.map(|entry| entry.evaluate(values)).collect::<Result<Vec<_>, _>>()?;
        Ok([vec![1.0], varied].concat())
    };
    let mut all = arrays.matrices().iter().map(of).collect::<Result<Vec<_>, _>>()?.into_iter();
    let mut next = || all.next().unwrap_or_default();
    Ok(Factors { mass: next(), damping: next(), stiffness: next() })
}

/// The matrix of all numbers, and one with a single entry of one for each expression.
fn terms(matrix: &EntryMatrix) -> Result<Vec<Term>, StructureError> {
    let sparse = |entries: &[Triplet<usize, usize, f64>]| {
        let rows = matrix.order();
        let made = Sparse::try_new_from_triplets(rows, rows, entries);
        made.map_err(|_| StructureError::OutOfMemory { rows })
    };
    let placed = |entry: &MatrixEntry, value: f64| {
        let [row, column] = entry.position();
        Triplet::new(row, column, value)
    };
    let fixed = matrix.entries().filter(|entry| entry.is_constant());
    let fixed = fixed.filter_map(|entry| Some(placed(entry, entry.evaluate(&[]).ok()?)));
    // the diagonal stands there even where it is zero: factors want it
    let fixed: Vec<_> = fixed.filter(|entry| entry.val != 0.0 || entry.row == entry.col).collect();
    let mut terms = vec![Term { name: matrix.name.to_owned(), matrix: sparse(&fixed)? }];
    for entry in matrix.entries().filter(|entry| !entry.is_constant()) {
        terms.push(Term { name: entry.name(), matrix: sparse(&[placed(entry, 1.0)])? });
    }
    Ok(terms)
}

/// The nodes, numbered from one on, each a set of its name.
fn layout(arrays: &MatrixArrays) -> StructureLayout {
    let (nodes, places) = (arrays.nodes(), arrays.places());
    let number = |name: &String| nodes.iter().position(|node| node == name).unwrap_or_default();
    let table: Vec<Freedom> = arrays
        .freedoms()
        .iter()
        .map(|(name, direction)| Freedom {
            node: 1 + number(name),
            direction: *direction,
            place: places.get(name.as_str()).copied().unwrap_or_default(),
        })
        .collect();
    // nodes are numbered in the order of their first freedoms, as points are
    let sets = nodes.iter().enumerate().map(|(point, name)| (name.clone(), vec![point])).collect();
    StructureLayout { sets, ..StructureLayout::of_table(&table) }
}
