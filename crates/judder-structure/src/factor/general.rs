//! The sparse factorisation of a complex matrix that need not be symmetric, on a pattern that is.
//!
//! The multifrontal method with pivots among the rows of a block: I. S. Duff and J. K. Reid, *The multifrontal solution of unsymmetric sets
//! of linear equations*, SIAM Journal on Scientific and Statistical Computing 5 (1984). Matrices of structures are nearly symmetric, and their
//! fill then is that of the symmetric pattern; where the rows of a block offer no pivot, the caller has to take another method.

use super::front::each_tile;
use super::lines::MatrixLines;
use super::tree::Tree;
use super::{FactorPattern, over_tree, taken_update};
use crate::StructureError;
use faer::linalg::matmul::matmul;
use faer::linalg::triangular_solve::{
    solve_lower_triangular_in_place, solve_unit_lower_triangular_in_place,
    solve_unit_upper_triangular_in_place, solve_upper_triangular_in_place,
};
use faer::sparse::SparseColMat;
use faer::{Accum, Mat, MatMut, MatRef, Par, c64};
use judder_dense::general::eliminate_complex;
use rayon::prelude::*;
use std::collections::BTreeMap;

/// Rows below the diagonal that are eliminated together.
const CHUNK: usize = 256;
const MINUS_ONE: c64 = c64::new(-1.0, 0.0);
const ZERO: c64 = c64::new(0.0, 0.0);

/// A = L U by blocks, on the pattern of a symmetric matrix, each with an order of its rows.
#[derive(Debug)]
pub(crate) struct GeneralFactor {
    pattern: FactorPattern,
    fronts: Vec<GeneralFront>,
}

/// The factors of a block of columns.
#[derive(Debug)]
struct GeneralFront {
    columns: usize,
    /// L below its diagonal of ones and U on and above it, then the rows below, column by column.
    lower: Vec<c64>,
    /// U in the columns beyond the block, column by column.
    beside: Vec<c64>,
    /// Which row of the block a row of its factor was.
    order: Vec<usize>,
}

impl GeneralFactor {
    /// The factors of a matrix none of whose entries lies outside of the pattern; `None` where a block offers no pivot.
    ///
    /// # Errors
    /// [`StructureError::WrongPattern`], [`StructureError::OutOfMemory`].
    pub(crate) fn new(
        pattern: &FactorPattern,
        matrix: &SparseColMat<usize, c64>,
    ) -> Result<Option<Self>, StructureError> {
        let (tree, inverse) = (&pattern.shared.tree, &pattern.shared.inverse);
        let size = inverse.len();
        if matrix.nrows() != size || matrix.ncols() != size {
            return Err(StructureError::WrongPattern { rows: matrix.nrows(), expected: size });
        }
        let all = (0..size).flat_map(|column| {
            let values = matrix.row_idx_of_col(column).zip(matrix.val_of_col(column));
            values.map(move |(row, value)| (inverse[row], inverse[column], *value))
        });
        let below = all.clone().filter(|(row, column, _)| row >= column);
        let beyond = all.filter(|(row, column, _)| row < column);
        let columns = MatrixLines::new(size, below.map(|(row, column, value)| (column, row, value)));
        let rows = MatrixLines::new(size, beyond);
        let step = |block: usize, updates: &mut BTreeMap<usize, Vec<c64>>, shared: bool| {
            eliminated(tree, block, [&columns, &rows], updates, shared)
        };
        let fronts = over_tree(tree, step, |front| front)?;
        Ok(fronts
            .into_iter()
            .collect::<Option<Vec<_>>>()
            .map(|fronts| Self { pattern: pattern.clone(), fronts }))
    }

    /// X with A X = B, in place of B.
    pub(crate) fn solve(&self, block: &mut Mat<c64>) {
        self.within(block, |tree, x| {
            for (number, front) in self.fronts.iter().enumerate() {
                front.forward(tree, number, x);
            }
            for (number, front) in self.fronts.iter().enumerate().rev() {
                front.backward(tree, number, x);
            }
        });
    }

    /// X with Aᵀ X = B, in place of B.
    pub(crate) fn solve_transposed(&self, block: &mut Mat<c64>) {
        self.within(block, |tree, x| {
            for (number, front) in self.fronts.iter().enumerate() {
                front.forward_transposed(tree, number, x);
            }
            for (number, front) in self.fronts.iter().enumerate().rev() {
                front.backward_transposed(tree, number, x);
            }
        });
    }

    /// Works on a block in the order of elimination.
    fn within(&self, block: &mut Mat<c64>, work: impl Fn(&Tree, &mut Mat<c64>)) {
        let order = &self.pattern.shared.order;
        let mut x = Mat::from_fn(order.len(), block.ncols(), |row, column| block[(order[row], column)]);
        work(&self.pattern.shared.tree, &mut x);
        for column in 0..block.ncols() {
            for (k, row) in order.iter().enumerate() {
                block[(*row, column)] = x[(k, column)];
            }
        }
    }
}

/// Assembles a block from the matrix and the updates of its children, which are taken, and eliminates it; what it changes in the rows and
/// columns beyond comes back.
fn eliminated(
    tree: &Tree,
    block: usize,
    [of_columns, of_rows]: [&MatrixLines; 2],
    updates: &mut BTreeMap<usize, Vec<c64>>,
    shared: bool,
) -> Result<(Option<GeneralFront>, Vec<c64>), StructureError> {
    let (own, rows) = (tree.columns(block), tree.rows(block));
    let size = of_columns.count();
    let (begin, width, count) = (own.start, own.len(), rows.len());
    let wrong = || StructureError::WrongPattern { rows: size, expected: size };
    let place = |row: usize| match row < own.end {
        true => Some(row - begin),
        false => rows.binary_search(&row).ok().map(|k| width + k),
    };
    let tall = width + count;
    let zeros = |length: usize| -> Result<Vec<c64>, StructureError> {
        let mut values = Vec::new();
        values.try_reserve_exact(length).map_err(|_| StructureError::OutOfMemory { rows: size })?;
        values.resize(length, ZERO);
        Ok(values)
    };
    let (mut lower, mut beside, mut update) =
        (zeros(tall * width)?, zeros(width * count)?, zeros(count * count)?);
    for line in own.clone() {
        let k = line - begin;
        for (row, value) in of_columns.of(line) {
            lower[k * tall + place(*row).ok_or_else(wrong)?] += value;
        }
        for (column, value) in of_rows.of(line) {
            match place(*column).ok_or_else(wrong)? {
                column if column < width => lower[column * tall + k] += value,
                column => beside[(column - width) * width + k] += value,
            }
        }
    }
    for child in &tree.children[block] {
        let places: Vec<usize> =
            tree.rows(*child).iter().map(|row| place(*row)).collect::<Option<_>>().ok_or_else(wrong)?;
        // those of the block come first
        let inside = places.partition_point(|place| *place < width);
        let of_child = taken_update(updates, *child);
        for (own, column) in of_child.chunks(places.len().max(1)).zip(&places) {
            let (upper, below) = own.split_at(inside);
            if *column < width {
                let target = &mut lower[column * tall..(column + 1) * tall];
                own.iter().zip(&places).for_each(|(value, row)| target[*row] += value);
                continue;
            }
            let column = column - width;
            let target = &mut beside[column * width..(column + 1) * width];
            upper.iter().zip(&places).for_each(|(value, row)| target[*row] += value);
            let target = &mut update[column * count..(column + 1) * count];
            below.iter().zip(&places[inside..]).for_each(|(value, row)| target[row - width] += value);
        }
    }
    let front = GeneralFront::eliminate(width, lower, beside, &mut update, shared);
    Ok((front, update))
}

impl GeneralFront {
    /// Eliminates an assembled block, and takes from what is beyond what it changes there; `None` where it offers no pivot.
    fn eliminate(
        columns: usize,
        mut lower: Vec<c64>,
        mut beside: Vec<c64>,
        update: &mut [c64],
        shared: bool,
    ) -> Option<Self> {
        let rows = lower.len() / columns.max(1);
        let below = rows - columns;
        let whole = MatMut::from_column_major_slice_mut(&mut lower, rows, columns);
        let (mut top, under) = whole.split_at_row_mut(columns);
        let order = eliminate_complex(top.as_mut())?;
        let is_regular =
            |k: usize| top[(k, k)].re.is_finite() && top[(k, k)].im.is_finite() && top[(k, k)] != ZERO;
        if !(0..columns).all(is_regular) {
            return None;
        }
        let top = top.as_ref();
        // L of the rows below: A U⁻¹
        let divide = |rows: MatMut<'_, c64>| {
            solve_lower_triangular_in_place(top.transpose(), rows.transpose_mut(), Par::Seq);
        };
        match shared {
            true => under.par_row_chunks_mut(CHUNK).for_each(divide),
            false => divide(under),
        }
        // U of the columns beyond: L⁻¹ P A
        each_tile(&mut beside, columns, shared, |_, tile| {
            for column in tile.chunks_mut(columns) {
                let before = column.to_vec();
                column.iter_mut().zip(&order).for_each(|(value, row)| *value = before[*row]);
            }
            let count = tile.len() / columns;
            let tile = MatMut::from_column_major_slice_mut(tile, columns, count);
            solve_unit_lower_triangular_in_place(top, tile, Par::Seq);
        });
        let front = Self { columns, lower, beside, order };
        let (left, right) = (front.under(), front.beside());
        each_tile(update, below, shared, |first, tile| {
            let count = tile.len() / below;
            let tile = MatMut::from_column_major_slice_mut(tile, below, count);
            matmul(tile, Accum::Add, left, right.subcols(first, count), MINUS_ONE, Par::Seq);
        });
        Some(front)
    }

    fn rows(&self) -> usize {
        self.lower.len() / self.columns.max(1)
    }

    /// L and U of the block itself.
    fn top(&self) -> MatRef<'_, c64> {
        MatRef::from_column_major_slice(&self.lower, self.rows(), self.columns).subrows(0, self.columns)
    }

    /// L of the rows below.
    fn under(&self) -> MatRef<'_, c64> {
        MatRef::from_column_major_slice(&self.lower, self.rows(), self.columns).split_at_row(self.columns).1
    }

    /// U of the columns beyond.
    fn beside(&self) -> MatRef<'_, c64> {
        MatRef::from_column_major_slice(&self.beside, self.columns, self.rows() - self.columns)
    }

    /// x ← L⁻¹ P x.
    fn forward(&self, tree: &Tree, block: usize, x: &mut Mat<c64>) {
        let mut own = gathered(x, tree.columns(block).start, &self.order);
        solve_unit_lower_triangular_in_place(self.top(), own.as_mut(), Par::Seq);
        lose(self.under(), own.as_ref(), tree.rows(block), x);
        x.subrows_mut(tree.columns(block).start, self.columns).copy_from(&own);
    }

    /// x ← U⁻¹ x.
    fn backward(&self, tree: &Tree, block: usize, x: &mut Mat<c64>) {
        let beyond = gathered(x, 0, tree.rows(block));
        let mut own = x.subrows_mut(tree.columns(block).start, self.columns);
        matmul(own.as_mut(), Accum::Add, self.beside(), beyond.as_ref(), MINUS_ONE, Par::Seq);
        solve_upper_triangular_in_place(self.top(), own, Par::Seq);
    }

    /// x ← U⁻ᵀ x.
    fn forward_transposed(&self, tree: &Tree, block: usize, x: &mut Mat<c64>) {
        let mut own = x.subrows(tree.columns(block).start, self.columns).to_owned();
        solve_lower_triangular_in_place(self.top().transpose(), own.as_mut(), Par::Seq);
        lose(self.beside().transpose(), own.as_ref(), tree.rows(block), x);
        x.subrows_mut(tree.columns(block).start, self.columns).copy_from(&own);
    }

    /// x ← Pᵀ L⁻ᵀ x.
    fn backward_transposed(&self, tree: &Tree, block: usize, x: &mut Mat<c64>) {
        let beyond = gathered(x, 0, tree.rows(block));
        let begin = tree.columns(block).start;
        let mut own = x.subrows(begin, self.columns).to_owned();
        matmul(own.as_mut(), Accum::Add, self.under().transpose(), beyond.as_ref(), MINUS_ONE, Par::Seq);
        solve_unit_upper_triangular_in_place(self.top().transpose(), own.as_mut(), Par::Seq);
        for column in 0..own.ncols() {
            for (k, row) in self.order.iter().enumerate() {
                x[(begin + row, column)] = own[(k, column)];
            }
        }
    }
}

/// Some rows of a block.
fn gathered(x: &Mat<c64>, begin: usize, rows: &[usize]) -> Mat<c64> {
    Mat::from_fn(rows.len(), x.ncols(), |k, column| x[(begin + rows[k], column)])
}

/// Takes A Y from some rows of a block.
fn lose(matrix: MatRef<'_, c64>, own: MatRef<'_, c64>, rows: &[usize], x: &mut Mat<c64>) {
    let mut lost = Mat::zeros(rows.len(), own.ncols());
    matmul(lost.as_mut(), Accum::Replace, matrix, own, c64::new(1.0, 0.0), Par::Seq);
    for column in 0..own.ncols() {
        for (k, row) in rows.iter().enumerate() {
            x[(*row, column)] -= lost[(k, column)];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::assembly::Sparse;
    use faer::sparse::Triplet;
    use judder_numerics::counter::uniform;

    /// Neighbours on a square, not symmetric, without a diagonal where there is none.
    fn matrix(side: usize, diagonal: Option<f64>) -> Sparse {
        let number = |i: usize, j: usize| i * side + j;
        let random = |a: usize, b: usize| uniform(5, (a * side * side + b) as u64) - 0.5;
        let mut entries = Vec::new();
        for (i, j) in (0..side).flat_map(|i| (0..side).map(move |j| (i, j))) {
            let own = number(i, j);
            entries.extend(diagonal.map(|value| Triplet::new(own, own, value + random(own, own))));
            let others = [(i + 1 < side).then(|| number(i + 1, j)), (j + 1 < side).then(|| number(i, j + 1))];
            for other in others.into_iter().flatten() {
                entries.push(Triplet::new(own, other, random(own, other)));
                // the transpose has entries that the matrix lacks
                if other % 3 > 0 {
                    entries.push(Triplet::new(other, own, random(other, own)));
                }
            }
        }
        Sparse::try_new_from_triplets(side * side, side * side, &entries).unwrap()
    }

    fn factored(side: usize, diagonal: Option<f64>) -> (SparseColMat<usize, c64>, Option<GeneralFactor>) {
        let real = matrix(side, diagonal);
        let turned =
            real.val().iter().enumerate().map(|(k, value)| c64::new(*value, 0.3 * uniform(6, k as u64)));
        let complex = SparseColMat::new(real.symbolic().to_owned().unwrap(), turned.collect());
        let pattern = FactorPattern::of_sums(&[&real]).unwrap();
        let factor = GeneralFactor::new(&pattern, &complex).unwrap();
        (complex, factor)
    }

    fn right(rows: usize) -> Mat<c64> {
        Mat::from_fn(rows, 3, |i, k| c64::new(uniform(7, (3 * i + k) as u64), uniform(8, (3 * i + k) as u64)))
    }

    #[test]
    fn solutions_are_those_of_the_matrix_and_of_its_transpose_with_and_without_branches() {
        for side in [1, 9, 220] {
            let (matrix, factor) = factored(side, Some(1.7));
            let (factor, right) = (factor.unwrap(), right(side * side));
            let (mut x, mut z) = (right.clone(), right.clone());
            factor.solve(&mut x);
            factor.solve_transposed(&mut z);
            let rest = (&matrix * &x - &right).norm_max();
            let of_transposed = (matrix.transpose() * &z - &right).norm_max();
            assert!(rest < 1e-12 && of_transposed < 1e-12, "{side}: {rest:e} {of_transposed:e}");
        }
    }

    #[test]
    fn a_matrix_without_pivots_has_no_factors() {
        assert!(factored(4, None).1.is_none());
    }

    #[test]
    fn the_number_of_threads_does_not_change_a_bit() {
        let solved = |threads: usize| {
            rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap().install(|| {
                let factor = factored(220, Some(1.7)).1.unwrap();
                assert!(factor.pattern.shared.tree.branches.len() > 1);
                let mut x = right(220 * 220);
                factor.solve(&mut x);
                (0..x.nrows())
                    .map(|row| (x[(row, 0)].re.to_bits(), x[(row, 2)].im.to_bits()))
                    .collect::<Vec<_>>()
            })
        };
        assert_eq!(solved(1), solved(3));
    }
}
