//! Solutions with the factors: forward through the tree, block by block, and back.

use super::front::{Front, Pivot, column_mut};
use super::tree::Subtree;
use super::{Elimination, SymmetricFactor};
use faer::linalg::triangular_solve::{
    solve_unit_lower_triangular_in_place, solve_unit_upper_triangular_in_place,
};
use faer::{MatRef, Par};
use judder_numerics::parallel;
use std::ops::Range;

/// Rows that are worked together.
const CHUNK: usize = 512;

impl SymmetricFactor {
    /// x with A x = b, in place of b.
    pub fn solve(&self, right: &mut [f64]) {
        self.solve_together([right]);
    }

    /// The same for N right sides together: large factors are read from memory once for all of them.
    pub fn solve_together<const N: usize>(&self, right: [&mut [f64]; N]) {
        let Elimination { tree, order, .. } = &*self.pattern.shared;
        let shared = !tree.branches.is_empty();
        let mut x = right.each_ref().map(|right| order.iter().map(|row| right[*row]).collect::<Vec<f64>>());
        let forward = |branch: &Subtree| self.forward_branch(branch, &x);
        let solved: Vec<[Vec<f64>; N]> = parallel::each(&tree.branches, forward);
        for (branch, solved) in tree.branches.iter().zip(&solved) {
            let (columns, rows) = branch.places.split_at(branch.columns);
            for (x, solved) in x.iter_mut().zip(solved) {
                for (place, value) in columns.iter().zip(solved) {
                    x[*place] = *value;
                }
                for (place, lost) in rows.iter().zip(&solved[branch.columns..]) {
                    x[*place] += lost;
                }
            }
        }
        for block in &tree.trunk {
            let own = x.each_mut().map(|x| &mut x[tree.columns(*block)]);
            let lost = self.fronts[*block].forward(own, shared);
            for (x, lost) in x.iter_mut().zip(lost) {
                for (row, lost) in tree.rows(*block).iter().zip(lost) {
                    x[*row] -= lost;
                }
            }
        }
        for block in tree.trunk.iter().rev() {
            let columns = tree.columns(*block);
            let mut own =
                x.each_ref().map(|x| gathered(x, columns.clone().chain(tree.rows(*block).iter().copied())));
            self.fronts[*block].backward(&mut own, shared);
            for (x, own) in x.iter_mut().zip(&own) {
                x[columns.clone()].copy_from_slice(&own[..columns.len()]);
            }
        }
        let backward = |branch: &Subtree| self.backward_branch(branch, &x);
        let solved: Vec<[Vec<f64>; N]> = parallel::each(&tree.branches, backward);
        for (branch, solved) in tree.branches.iter().zip(&solved) {
            for (x, solved) in x.iter_mut().zip(solved) {
                for (place, value) in branch.places.iter().zip(&solved[..branch.columns]) {
                    x[*place] = *value;
                }
            }
        }
        for (right, x) in right.into_iter().zip(&x) {
            for (row, value) in order.iter().zip(x) {
                right[*row] = *value;
            }
        }
    }

    /// The values at a branch's columns, and what it adds to the rows of its root.
    fn forward_branch<const N: usize>(&self, branch: &Subtree, x: &[Vec<f64>; N]) -> [Vec<f64>; N] {
        let tree = &self.pattern.shared.tree;
        let columns = &branch.places[..branch.columns];
        let mut local = x.each_ref().map(|x| gathered(x, columns.iter().copied()));
        for local in &mut local {
            local.resize(branch.places.len(), 0.0);
        }
        let mut start = 0;
        for (block, rows) in branch.blocks.iter().zip(&branch.rows) {
            let end = start + tree.width(*block);
            let own = local.each_mut().map(|local| &mut local[start..end]);
            let lost = self.fronts[*block].forward(own, false);
            for (local, lost) in local.iter_mut().zip(lost) {
                for (row, lost) in rows.iter().zip(lost) {
                    local[*row] -= lost;
                }
            }
            start = end;
        }
        local
    }

    fn backward_branch<const N: usize>(&self, branch: &Subtree, x: &[Vec<f64>; N]) -> [Vec<f64>; N] {
        let tree = &self.pattern.shared.tree;
        let mut local = x.each_ref().map(|x| gathered(x, branch.places.iter().copied()));
        let mut end = branch.columns;
        for (block, rows) in branch.blocks.iter().zip(&branch.rows).rev() {
            let start = end - tree.width(*block);
            let mut own =
                local.each_ref().map(|local| gathered(local, (start..end).chain(rows.iter().copied())));
            self.fronts[*block].backward(&mut own, false);
            for (local, own) in local.iter_mut().zip(&own) {
                local[start..end].copy_from_slice(&own[..end - start]);
            }
            end = start;
        }
        local
    }
}

fn gathered(x: &[f64], places: impl Iterator<Item = usize>) -> Vec<f64> {
    places.map(|place| x[place]).collect()
}

impl Front {
    /// x = B⁻¹ L⁻¹ P x on the block's columns, of N right sides; what the rows below lose comes back.
    pub(super) fn forward<const N: usize>(&self, mut x: [&mut [f64]; N], shared: bool) -> [Vec<f64>; N] {
        let mut lost = [(); N].map(|()| vec![0.0; self.rows()]);
        for (start, width) in self.panels() {
            let (top, below) = self.panel(start, width);
            for (x, lost) in x.iter_mut().zip(&lost) {
                let own = &mut x[start..start + width];
                let left: Vec<f64> = own.iter().zip(&lost[start..]).map(|(x, lost)| x - lost).collect();
                for (x, pivot) in own.iter_mut().zip(&self.pivots[start..]) {
                    *x = left[*pivot];
                }
                solve_unit_lower_triangular_in_place(top, column_mut(own), Par::Seq);
            }
            let own = x.each_ref().map(|x| &x[start..start + width]);
            for (lost, more) in lost.iter_mut().zip(product(below, own, shared)) {
                add(&mut lost[start + width..], &more);
            }
            for x in &mut x {
                self.divide_panel(top, start, &mut x[start..start + width]);
            }
        }
        lost.map(|mut lost| lost.split_off(self.columns))
    }

    /// x = B⁻¹ x on a panel.
    pub(super) fn divide_panel(&self, top: MatRef<'_, f64>, start: usize, x: &mut [f64]) {
        let mut k = 0;
        while k < x.len() {
            let pivot = Pivot::at(top, &self.subdiagonal[start..start + x.len()], k);
            let [first, second] = pivot.solve([x[k], x.get(k + 1).copied().unwrap_or(0.0)]);
            x[k] = first;
            if pivot.rows() == 2 {
                x[k + 1] = second;
            }
            k += pivot.rows();
        }
    }

    /// x = Pᵀ L⁻ᵀ x on the block's columns, which stand first, with the rows below after them, of N right sides.
    pub(super) fn backward<const N: usize>(&self, x: &mut [Vec<f64>; N], shared: bool) {
        for (start, width) in self.panels().rev() {
            let (top, below) = self.panel(start, width);
            let sums = transposed_product(below, x.each_ref().map(|x| &x[start + width..]), shared);
            for (x, sum) in x.iter_mut().zip(&sums) {
                let own = &mut x[start..start + width];
                for (x, s) in own.iter_mut().zip(sum) {
                    *x -= s;
                }
                solve_unit_upper_triangular_in_place(top.transpose(), column_mut(own), Par::Seq);
                let before = own.to_vec();
                for (value, pivot) in before.iter().zip(&self.pivots[start..]) {
                    own[*pivot] = *value;
                }
            }
        }
    }
}

/// A x for N vectors. A is read from memory once: what a solution takes is that.
fn product<const N: usize>(matrix: MatRef<'_, f64>, x: [&[f64]; N], shared: bool) -> [Vec<f64>; N] {
    let piece = |rows: Range<usize>| -> [Vec<f64>; N] {
        let mut y = [(); N].map(|()| vec![0.0; rows.len()]);
        for first in (0..matrix.ncols()).step_by(4) {
            for (x, y) in x.iter().zip(&mut y) {
                add_columns(matrix, rows.clone(), first, &x[first..], y);
            }
        }
        y
    };
    let mut y = [(); N].map(|()| Vec::with_capacity(matrix.nrows()));
    for piece in pieces(matrix.nrows(), shared, piece) {
        for (y, piece) in y.iter_mut().zip(piece) {
            y.extend(piece);
        }
    }
    y
}

/// Works on rows piece by piece, side by side where they are to be shared.
fn pieces<T: Send>(rows: usize, shared: bool, work: impl Fn(Range<usize>) -> T + Sync) -> Vec<T> {
    let piece = |k: usize| work(k * CHUNK..rows.min((k + 1) * CHUNK));
    let count = rows.div_ceil(CHUNK);
    match shared {
        true => parallel::each_place(count, piece),
        false => (0..count).map(piece).collect(),
    }
}

/// Aᵀ x for N vectors; the pieces of sums are added in their order.
fn transposed_product<const N: usize>(
    matrix: MatRef<'_, f64>,
    x: [&[f64]; N],
    shared: bool,
) -> [Vec<f64>; N] {
    let columns = matrix.ncols();
    let partial = |rows: Range<usize>| -> [Vec<f64>; N] {
        let mut sums = [(); N].map(|()| vec![0.0; columns]);
        for first in (0..columns).step_by(4) {
            for (x, sum) in x.iter().zip(&mut sums) {
                for (s, value) in sum[first..].iter_mut().zip(dot_columns(matrix, rows.clone(), first, x)) {
                    *s = value;
                }
            }
        }
        sums
    };
    let mut total = [(); N].map(|()| vec![0.0; columns]);
    for partial in pieces(matrix.nrows(), shared, partial) {
        for (total, partial) in total.iter_mut().zip(&partial) {
            add(total, partial);
        }
    }
    total
}

fn add(total: &mut [f64], more: &[f64]) {
    for (t, m) in total.iter_mut().zip(more) {
        *t += m;
    }
}

/// Rows of a column; of one that is not there, none.
fn piece<'a>(matrix: MatRef<'a, f64>, rows: &Range<usize>, column: usize) -> &'a [f64] {
    if column >= matrix.ncols() {
        return &[];
    }
    let column = matrix.col(column).try_as_col_major();
    column.map_or(&[], |column| &column.as_slice()[rows.clone()])
}

/// y += A x on four columns from one on.
fn add_columns(matrix: MatRef<'_, f64>, rows: Range<usize>, first: usize, x: &[f64], y: &mut [f64]) {
    let [a, b, c, d] = [0, 1, 2, 3].map(|k| piece(matrix, &rows, first + k));
    if let [p, q, r, s, ..] = *x {
        for ((((y, a), b), c), d) in y.iter_mut().zip(a).zip(b).zip(c).zip(d) {
            *y += p * a + q * b + (r * c + s * d);
        }
        return;
    }
    for (column, x) in [a, b, c].iter().zip(x) {
        for (y, a) in y.iter_mut().zip(*column) {
            *y += x * a;
        }
    }
}

/// aᵀ x on four columns from one on; zero for a column that is not there.
fn dot_columns(matrix: MatRef<'_, f64>, rows: Range<usize>, first: usize, x: &[f64]) -> [f64; 4] {
    let columns = [0, 1, 2, 3].map(|k| piece(matrix, &rows, first + k));
    let x = &x[rows];
    let mut sums = [0.0; 4];
    if columns[3].is_empty() {
        for (sum, column) in sums.iter_mut().zip(columns) {
            *sum = column.iter().zip(x).map(|(a, x)| a * x).sum();
        }
        return sums;
    }
    let [a, b, c, d] = columns;
    for ((((x, a), b), c), d) in x.iter().zip(a).zip(b).zip(c).zip(d) {
        sums[0] += a * x;
        sums[1] += b * x;
        sums[2] += c * x;
        sums[3] += d * x;
    }
    sums
}
