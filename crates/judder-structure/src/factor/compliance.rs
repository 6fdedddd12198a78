//! How linear forms move under unit forces along them: A K⁻¹ Aᵀ of many forms with few entries, without the solutions in between.
//!
//! With P K Pᵀ = L B Lᵀ it is Yᵀ B⁻¹ Y with Y = L⁻¹ P Aᵀ. A form passes through the blocks above its entries alone, so most of Y is zero, and
//! what a block adds concerns the forms beneath it.

use super::front::Front;
use super::tree::Tree;
use super::{Elimination, SymmetricFactor};
use faer::linalg::matmul::matmul;
use faer::linalg::triangular_solve::solve_unit_lower_triangular_in_place;
use faer::{Accum, Mat, MatMut, Par};
use judder_numerics::parallel;
use rayon::prelude::*;
use std::collections::BTreeMap;

/// Forms that are worked together.
const TILE: usize = 128;

/// What reaches the rows below a block: a column a form.
struct Passing {
    /// Numbers of forms, ascending.
    forms: Vec<usize>,
    values: Mat<f64>,
}

/// Entries of forms by the block in whose columns they lie: the form, the column in the order of elimination, the value.
type FormEntries = Vec<Vec<(usize, usize, f64)>>;

/// What a block adds to the products of forms.
struct Added {
    forms: Vec<usize>,
    /// Of so many of the first forms, and of all.
    products: Mat<f64>,
}

/// What passes the root of a branch, and what its blocks add.
type OfBranch = (Option<(usize, Passing)>, Vec<Added>);

impl SymmetricFactor {
    /// aᵢ K⁻¹ aⱼᵀ of the first `count` forms and of all, each its entries by row.
    #[must_use]
    pub fn compliance(&self, forms: &[&[(usize, f64)]], count: usize) -> Mat<f64> {
        let Elimination { tree, inverse, .. } = &*self.pattern.shared;
        let entries = by_block(tree, inverse, forms);
        let of_branches: Vec<OfBranch> = parallel::each(&tree.branches, |branch| {
            let (mut passing, mut added) = (BTreeMap::new(), Vec::new());
            for block in &branch.blocks {
                let own = self.passed(*block, &entries[*block], &mut passing, count);
                added.extend(own);
            }
            let root = branch.blocks.last().and_then(|root| Some((*root, passing.remove(root)?)));
            (root, added)
        });
        let mut sums = Mat::zeros(count, forms.len());
        let mut passing = BTreeMap::new();
        for (root, added) in of_branches {
            passing.extend(root);
            added.iter().for_each(|added| added.add_to(&mut sums));
        }
        for block in &tree.trunk {
            let added = self.passed(*block, &entries[*block], &mut passing, count);
            added.iter().for_each(|added| added.add_to(&mut sums));
        }
        sums
    }

    /// Takes forms through a block: what they leave to the rows below is put among what passes, what the block adds comes back.
    fn passed(
        &self,
        block: usize,
        entries: &[(usize, usize, f64)],
        passing: &mut BTreeMap<usize, Passing>,
        count: usize,
    ) -> Option<Added> {
        let tree = &self.pattern.shared.tree;
        let (columns, rows) = (tree.columns(block), tree.rows(block));
        let width = columns.len();
        let below: Vec<(usize, Passing)> =
            tree.children[block].iter().filter_map(|child| Some((*child, passing.remove(child)?))).collect();
        let mut forms: Vec<usize> = entries.iter().map(|(form, ..)| *form).collect();
        below.iter().for_each(|(_, own)| forms.extend(&own.forms));
        forms.sort_unstable();
        forms.dedup();
        if forms.is_empty() {
            return None;
        }
        let number = |form: usize| forms.partition_point(|other| *other < form);
        let mut values = Mat::zeros(width + rows.len(), forms.len());
        for (form, column, value) in entries {
            values[(column - columns.start, number(*form))] += value;
        }
        for (child, own) in &below {
            let place = |row: &usize| match *row < columns.end {
                true => row - columns.start,
                false => width + rows.partition_point(|other| other < row),
            };
            let places: Vec<usize> = tree.rows(*child).iter().map(place).collect();
            for (k, form) in own.forms.iter().enumerate() {
                let column = number(*form);
                places
                    .iter()
                    .enumerate()
                    .for_each(|(row, place)| values[(*place, column)] += own.values[(row, k)]);
            }
        }
        let front = &self.fronts[block];
        let mut divided = Mat::zeros(width, forms.len());
        values.par_col_chunks_mut(TILE).zip(divided.par_col_chunks_mut(TILE)).for_each(
            |(values, divided)| {
                front.take_through(values, divided);
            },
        );
        let first = forms.partition_point(|form| *form < count);
        let mut products = Mat::zeros(first, forms.len());
        let lower = values.submatrix(0, 0, width, first).transpose();
        products.par_col_chunks_mut(TILE).enumerate().for_each(|(k, products)| {
            let right = divided.subcols(k * TILE, products.ncols());
            matmul(products, Accum::Replace, lower, right, 1.0, Par::Seq);
        });
        if !rows.is_empty() {
            let values = values.subrows(width, rows.len()).to_owned();
            passing.insert(block, Passing { forms: forms.clone(), values });
        }
        Some(Added { forms, products })
    }
}

impl Added {
    fn add_to(&self, sums: &mut Mat<f64>) {
        for (k, column) in self.forms.iter().enumerate() {
            for row in 0..self.products.nrows() {
                sums[(self.forms[row], *column)] += self.products[(row, k)];
            }
        }
    }
}

fn by_block(tree: &Tree, inverse: &[usize], forms: &[&[(usize, f64)]]) -> FormEntries {
    let mut block_of = vec![0; inverse.len()];
    for block in 0..tree.blocks() {
        block_of[tree.columns(block)].fill(block);
    }
    let mut entries: FormEntries = vec![Vec::new(); tree.blocks()];
    for (form, own) in forms.iter().enumerate() {
        for (row, value) in *own {
            let column = inverse[*row];
            entries[block_of[column]].push((form, column, *value));
        }
    }
    entries
}

impl Front {
    /// Columns x become L⁻¹ P x on the block and what is left of them below it; those of the block over B come beside.
    fn take_through(&self, mut x: MatMut<'_, f64>, mut divided: MatMut<'_, f64>) {
        for (start, width) in self.panels() {
            let (top, below) = self.panel(start, width);
            let pivots = &self.pivots[start..start + width];
            let (mut own, rest) = x.as_mut().split_at_row_mut(start).1.split_at_row_mut(width);
            let mut before = vec![0.0; width];
            for k in 0..own.ncols() {
                before.iter_mut().enumerate().for_each(|(row, value)| *value = own[(row, k)]);
                pivots.iter().enumerate().for_each(|(row, pivot)| own[(row, k)] = before[*pivot]);
            }
            solve_unit_lower_triangular_in_place(top, own.as_mut(), Par::Seq);
            matmul(rest, Accum::Add, below, own.as_ref(), -1.0, Par::Seq);
            for k in 0..own.ncols() {
                before.iter_mut().enumerate().for_each(|(row, value)| *value = own[(row, k)]);
                self.divide_panel(top, start, &mut before);
                before.iter().enumerate().for_each(|(row, value)| divided[(start + row, k)] = *value);
            }
        }
    }
}
