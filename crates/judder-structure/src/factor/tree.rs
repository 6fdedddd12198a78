//! The tree of elimination: blocks of columns with one pattern, and which of them can be eliminated side by side.

use crate::StructureError;
use crate::assembly::Sparse;
use faer::Side;
use faer::perm::PermRef;
use faer::sparse::linalg::SupernodalThreshold;
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, SymbolicCholeskyRaw, SymmetricOrdering, factorize_symbolic_cholesky,
};
use std::ops::Range;

/// Fewer operations than these are done before other threads have begun.
const WORTH_SHARING: f64 = 1e8;
/// A branch holds at most this share of all operations.
const SHARE: f64 = 1.0 / 32.0;

/// Blocks of neighbouring columns (supernodes), numbered so that a parent comes after its children.
#[derive(Debug, Default)]
pub(super) struct Tree {
    /// The first column of each block, and the end of the last.
    begins: Vec<usize>,
    /// Where the rows of each block begin, and their number.
    row_starts: Vec<usize>,
    /// Rows below the diagonal part of each block, ascending.
    rows: Vec<usize>,
    /// The blocks whose updates a block takes up.
    pub(super) children: Vec<Vec<usize>>,
    /// Subtrees that do not touch each other.
    pub(super) branches: Vec<Subtree>,
    /// The blocks above the branches, in their order.
    pub(super) trunk: Vec<usize>,
}

/// A subtree.
#[derive(Debug)]
pub(super) struct Subtree {
    /// Its blocks in their order; the last is its root.
    pub(super) blocks: Vec<usize>,
    /// Its columns, block by block, then the rows of its root.
    pub(super) places: Vec<usize>,
    /// How many of the places are columns.
    pub(super) columns: usize,
    /// The rows of each block as numbers of places.
    pub(super) rows: Vec<Vec<usize>>,
}

impl Tree {
    /// The tree of a matrix whose rows are eliminated in this order (`inverse` is the order's).
    ///
    /// # Errors
    /// [`StructureError::OutOfMemory`].
    pub(super) fn new(matrix: &Sparse, order: &[usize], inverse: &[usize]) -> Result<Self, StructureError> {
        let size = matrix.nrows();
        let parameters = CholeskySymbolicParams {
            supernodal_flop_ratio_threshold: SupernodalThreshold::FORCE_SUPERNODAL,
            ..CholeskySymbolicParams::default()
        };
        let order = SymmetricOrdering::Custom(PermRef::new_checked(order, inverse, size));
        let symbolic = factorize_symbolic_cholesky(matrix.symbolic(), Side::Lower, order, parameters)
            .map_err(|_| StructureError::OutOfMemory { rows: size })?;
        let SymbolicCholeskyRaw::Supernodal(symbolic) = symbolic.raw() else {
            // of a matrix without rows
            return Ok(Self::default());
        };
        let count = symbolic.n_supernodes();
        let mut begins = symbolic.supernode_begin().to_vec();
        begins.truncate(count);
        begins.push(size);
        let (mut row_starts, mut rows) = (vec![0], Vec::with_capacity(symbolic.row_idx().len()));
        for block in 0..count {
            let start = symbolic.col_ptr_for_row_idx()[block];
            rows.extend_from_slice(&symbolic.row_idx()[start..start + symbolic.nnz_per_super()[block]]);
            row_starts.push(rows.len());
        }
        let (children, branches, trunk) = (vec![Vec::new(); count], Vec::new(), Vec::new());
        let mut tree = Self { begins, row_starts, rows, children, branches, trunk };
        tree.grow();
        Ok(tree)
    }

    /// How many blocks there are.
    pub(super) fn blocks(&self) -> usize {
        self.begins.len().saturating_sub(1)
    }

    /// How many columns a block has.
    pub(super) fn width(&self, block: usize) -> usize {
        self.begins[block + 1] - self.begins[block]
    }

    /// The columns of a block.
    pub(super) fn columns(&self, block: usize) -> Range<usize> {
        self.begins[block]..self.begins[block + 1]
    }

    /// Rows of a block below its diagonal part.
    pub(super) fn rows(&self, block: usize) -> &[usize] {
        &self.rows[self.row_starts[block]..self.row_starts[block + 1]]
    }

    /// Entries of all blocks.
    pub(super) fn entries(&self) -> usize {
        (0..self.blocks()).map(|block| self.width(block) * (self.width(block) + self.rows(block).len())).sum()
    }

    /// Multiplications and additions of all blocks.
    pub(super) fn operations(&self) -> f64 {
        (0..self.blocks()).map(|block| self.operations_of(block)).sum()
    }

    fn operations_of(&self, block: usize) -> f64 {
        let (width, below) = (self.width(block), self.rows(block).len());
        (below..below + width).map(|entries| (entries as f64 + 1.0).powi(2)).sum()
    }

    fn grow(&mut self) {
        let blocks = self.blocks();
        let mut block_of = vec![0; self.begins[blocks]];
        for block in 0..blocks {
            block_of[self.begins[block]..self.begins[block + 1]].fill(block);
        }
        let parent = |block: usize| self.rows(block).first().map(|row| block_of[*row]);
        let parents: Vec<Option<usize>> = (0..blocks).map(parent).collect();
        for (block, parent) in parents.iter().enumerate() {
            if let Some(parent) = parent {
                self.children[*parent].push(block);
            }
        }
        let mut below: Vec<f64> = (0..blocks).map(|block| self.operations_of(block)).collect();
        for (block, parent) in parents.iter().enumerate() {
            if let Some(parent) = parent {
                below[*parent] += below[block];
            }
        }
        let whole = self.operations();
        let limit = if whole > WORTH_SHARING { SHARE * whole } else { -1.0 };
        let mut branch_of: Vec<Option<usize>> = vec![None; blocks];
        let mut members: Vec<Vec<usize>> = Vec::new();
        // from the root down: a block under a branch belongs to it
        for block in (0..blocks).rev() {
            branch_of[block] = parents[block].and_then(|parent| branch_of[parent]);
            if branch_of[block].is_none() && below[block] <= limit {
                branch_of[block] = Some(members.len());
                members.push(Vec::new());
            }
            match branch_of[block] {
                Some(branch) => members[branch].push(block),
                None => self.trunk.push(block),
            }
        }
        self.trunk.reverse();
        self.branches = members.into_iter().map(|blocks| self.branch(blocks)).collect();
    }

    /// A branch of blocks that are named from its root down.
    fn branch(&self, mut blocks: Vec<usize>) -> Subtree {
        blocks.reverse();
        let mut offsets = Vec::with_capacity(blocks.len());
        let mut places = Vec::new();
        for block in &blocks {
            offsets.push(places.len());
            places.extend(self.begins[*block]..self.begins[block + 1]);
        }
        let columns = places.len();
        let rows_of_root = blocks.last().map_or(&[][..], |root| self.rows(*root));
        places.extend_from_slice(rows_of_root);
        let place = |row: &usize| {
            // the last block that begins at or before the row
            let k = blocks.partition_point(|block| self.begins[*block] <= *row);
            match k.checked_sub(1) {
                Some(k) if *row < self.begins[blocks[k] + 1] => offsets[k] + row - self.begins[blocks[k]],
                _ => columns + rows_of_root.partition_point(|other| other < row),
            }
        };
        let rows = blocks.iter().map(|block| self.rows(*block).iter().map(place).collect()).collect();
        Subtree { blocks, places, columns, rows }
    }
}
