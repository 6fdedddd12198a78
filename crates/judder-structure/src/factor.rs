//! The sparse factorisation of a symmetric matrix that need not be positive, and how many of its eigenvalues are negative.
//!
//! The multifrontal method: I. S. Duff and J. K. Reid, *The multifrontal solution of indefinite sparse symmetric linear equations*, ACM
//! Transactions on Mathematical Software 9 (1983). Subtrees of the elimination are worked side by side, and the large blocks above
//! them piece by piece; pieces and the order of sums do not depend on the number of threads.

mod compliance;
mod front;
pub(crate) mod general;
mod likely;
mod lines;
mod ordering;
mod substitution;
mod tree;

use crate::StructureError;
use crate::assembly::Sparse;
use faer::Side;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::perm::PermRef;
use faer::sparse::utils::{permute_self_adjoint_scratch, permute_self_adjoint_to_unsorted};
use front::{Front, FrontAssembly};
use judder_numerics::parallel;
pub use likely::likely_entries;
use std::collections::BTreeMap;
use std::sync::Arc;
use tree::{Subtree, Tree};

/// The order of elimination and the pattern of the factors: one for all matrices with one pattern.
#[derive(Debug, Clone)]
pub struct FactorPattern {
    shared: Arc<Elimination>,
}

#[derive(Debug)]
struct Elimination {
    tree: Tree,
    order: Vec<usize>,
    inverse: Vec<usize>,
}

impl FactorPattern {
    /// The pattern of the factors of a matrix; its lower triangle is read, its values are not.
    ///
    /// # Errors
    /// [`StructureError::OutOfMemory`].
    pub fn new(matrix: &Sparse) -> Result<Self, StructureError> {
        let order = ordering::order(matrix)?;
        let mut inverse = vec![0; order.len()];
        for (k, row) in order.iter().enumerate() {
            inverse[*row] = k;
        }
        let tree = Tree::new(matrix, &order, &inverse)?;
        Ok(Self { shared: Arc::new(Elimination { tree, order, inverse }) })
    }

    /// How many eigenvalues of a matrix are negative (Sylvester's law of inertia); its factors are not held.
    ///
    /// # Errors
    /// Those of [`SymmetricFactor::with_pattern`].
    pub fn negative_eigenvalues(&self, matrix: &Sparse) -> Result<usize, StructureError> {
        Ok(eliminated(&self.shared, matrix, |front| front.negative())?.iter().sum())
    }

    /// Numbers that the factors hold, 8 bytes each.
    #[must_use]
    pub fn entries(&self) -> usize {
        self.shared.tree.entries()
    }

    /// Multiplications and additions of a factorisation.
    #[must_use]
    pub fn operations(&self) -> f64 {
        self.shared.tree.operations()
    }
}

/// P A Pᵀ = L B Lᵀ with blocks of one and two rows in B.
#[derive(Debug)]
pub struct SymmetricFactor {
    pattern: FactorPattern,
    fronts: Vec<Front>,
}

impl SymmetricFactor {
    /// The factors of a symmetric matrix; its lower triangle is read.
    ///
    /// # Errors
    /// [`StructureError::OutOfMemory`], [`StructureError::Singular`].
    pub fn new(matrix: &Sparse) -> Result<Self, StructureError> {
        Self::with_pattern(&FactorPattern::new(matrix)?, matrix)
    }

    /// The factors of a matrix whose pattern is known.
    ///
    /// # Errors
    /// [`StructureError::WrongPattern`] for a matrix of another size or with entries that the pattern lacks, and those of
    /// [`Self::new`].
    pub fn with_pattern(pattern: &FactorPattern, matrix: &Sparse) -> Result<Self, StructureError> {
        let fronts = eliminated(&pattern.shared, matrix, |front| front)?;
        Ok(Self { pattern: pattern.clone(), fronts })
    }

    /// How many eigenvalues are negative (Sylvester's law of inertia).
    #[must_use]
    pub fn negative_eigenvalues(&self) -> usize {
        self.fronts.iter().map(Front::negative).sum()
    }
}

/// The lower triangle of P A Pᵀ.
struct Permuted {
    starts: Vec<usize>,
    rows: Vec<usize>,
    values: Vec<f64>,
}

impl Permuted {
    fn new(matrix: &Sparse, order: &[usize], inverse: &[usize]) -> Result<Self, StructureError> {
        let size = order.len();
        let entries = matrix.compute_nnz();
        let mut new = Self { starts: vec![0; size + 1], rows: vec![0; entries], values: vec![0.0; entries] };
        let needed = permute_self_adjoint_scratch::<usize>(size);
        let mut memory =
            MemBuffer::try_new(needed).map_err(|_| StructureError::OutOfMemory { rows: size })?;
        permute_self_adjoint_to_unsorted(
            &mut new.values,
            &mut new.starts,
            &mut new.rows,
            matrix.as_ref(),
            PermRef::new_checked(order, inverse, size),
            Side::Lower,
            Side::Lower,
            MemStack::new(&mut memory),
        );
        Ok(new)
    }

    fn column(&self, column: usize) -> impl Iterator<Item = (usize, f64)> + '_ {
        let own = self.starts[column]..self.starts[column + 1];
        self.rows[own.clone()].iter().copied().zip(self.values[own].iter().copied())
    }
}

/// What is to be kept of each block, in their order.
fn eliminated<T: Send>(
    elimination: &Elimination,
    matrix: &Sparse,
    keep: impl Fn(Front) -> T + Sync,
) -> Result<Vec<T>, StructureError> {
    let Elimination { tree, order, inverse } = elimination;
    let rows = matrix.nrows();
    if rows != order.len() || matrix.ncols() != rows {
        return Err(StructureError::WrongPattern { rows, expected: order.len() });
    }
    let permuted = Permuted::new(matrix, order, inverse)?;
    let step = |block: usize, updates: &mut BTreeMap<usize, Vec<f64>>, shared: bool| {
        eliminate(tree, block, &permuted, updates, shared)
    };
    over_tree(tree, step, keep)
}

/// Eliminates every block of a tree by a step that takes the updates of its children; what is to be kept of each, in their order.
fn over_tree<F, U: Send, T: Send>(
    tree: &Tree,
    step: impl Fn(usize, &mut BTreeMap<usize, Vec<U>>, bool) -> Result<(F, Vec<U>), StructureError> + Sync,
    keep: impl Fn(F) -> T + Sync,
) -> Result<Vec<T>, StructureError> {
    let branch = |branch: &Subtree| -> Result<(Vec<T>, Vec<U>), StructureError> {
        let mut updates = BTreeMap::new();
        let mut kept = Vec::with_capacity(branch.blocks.len());
        for block in &branch.blocks {
            let (front, update) = step(*block, &mut updates, false)?;
            kept.push(keep(front));
            updates.insert(*block, update);
        }
        // what its root changes
        let update = branch.blocks.last().map(|root| taken_update(&mut updates, *root));
        Ok((kept, update.unwrap_or_default()))
    };
    let of_branches = parallel::try_each(&tree.branches, branch)?;
    let mut updates = BTreeMap::new();
    let mut kept: Vec<Option<T>> = (0..tree.blocks()).map(|_| None).collect();
    for (branch, (own, update)) in tree.branches.iter().zip(of_branches) {
        for (block, own) in branch.blocks.iter().zip(own) {
            kept[*block] = Some(own);
        }
        if let Some(root) = branch.blocks.last() {
            updates.insert(*root, update);
        }
    }
    let shared = !tree.branches.is_empty();
    for block in &tree.trunk {
        let (front, update) = step(*block, &mut updates, shared)?;
        kept[*block] = Some(keep(front));
        updates.insert(*block, update);
    }
    // every block is in a branch or in the trunk
    Ok(kept.into_iter().flatten().collect())
}

/// What a block changes, which is needed once.
fn taken_update<U>(updates: &mut BTreeMap<usize, Vec<U>>, block: usize) -> Vec<U> {
    updates.remove(&block).unwrap_or_default()
}

/// Assembles a block from the matrix and the updates of its children, which are taken, and eliminates it.
fn eliminate(
    tree: &Tree,
    block: usize,
    matrix: &Permuted,
    updates: &mut BTreeMap<usize, Vec<f64>>,
    shared: bool,
) -> Result<(Front, Vec<f64>), StructureError> {
    let (columns, rows) = (tree.columns(block), tree.rows(block));
    let size = matrix.starts.len() - 1;
    let (begin, width) = (columns.start, columns.len());
    let wrong = || StructureError::WrongPattern { rows: size, expected: size };
    let place = |row: usize| match row < columns.end {
        true => Some(row - begin),
        false => rows.binary_search(&row).ok().map(|k| width + k),
    };
    let mut assembly = FrontAssembly::new(width, rows.len(), size)?;
    for column in columns.clone() {
        for (row, value) in matrix.column(column) {
            assembly.add(place(row).ok_or_else(wrong)?, column - begin, value);
        }
    }
    for child in &tree.children[block] {
        let places: Vec<usize> =
            tree.rows(*child).iter().map(|row| place(*row)).collect::<Option<_>>().ok_or_else(wrong)?;
        assembly.add_update(&taken_update(updates, *child), &places);
    }
    let (front, update) = assembly.eliminate(shared)?;
    if front.is_regular() { Ok((front, update)) } else { Err(StructureError::Singular { rows: size }) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::statics::product;
    use faer::sparse::Triplet;

    /// The five-point Laplacian of a square less a shift: its eigenvalues are known.
    fn shifted_laplacian(side: usize, shift: f64) -> Sparse {
        let number = |i: usize, j: usize| i * side + j;
        let mut entries = Vec::new();
        for (i, j) in (0..side).flat_map(|i| (0..side).map(move |j| (i, j))) {
            entries.push(Triplet::new(number(i, j), number(i, j), 4.0 - shift));
            for other in [(i + 1 < side).then(|| number(i + 1, j)), (j + 1 < side).then(|| number(i, j + 1))]
            {
                entries.extend(other.map(|other| Triplet::new(other, number(i, j), -1.0)));
                entries.extend(other.map(|other| Triplet::new(number(i, j), other, -1.0)));
            }
        }
        Sparse::try_new_from_triplets(side * side, side * side, &entries).unwrap()
    }

    /// λ = 4 − 2 cos(iπ/(n+1)) − 2 cos(jπ/(n+1)).
    fn below(side: usize, shift: f64) -> usize {
        let cosine = |i: usize| 2.0 * (i as f64 * std::f64::consts::PI / (side + 1) as f64).cos();
        (1..=side)
            .flat_map(|i| (1..=side).map(move |j| 4.0 - cosine(i) - cosine(j)))
            .filter(|l| *l < shift)
            .count()
    }

    fn right(size: usize) -> Vec<f64> {
        (0..size).map(|k| (1.7 * k as f64).sin()).collect()
    }

    #[test]
    fn solutions_and_signs_are_those_of_the_matrix_with_and_without_branches() {
        for (side, shift) in [(1, 0.5), (7, 2.1), (40, 1.234), (160, 0.9)] {
            let matrix = shifted_laplacian(side, shift);
            let factor = SymmetricFactor::new(&matrix).unwrap();
            assert_eq!(factor.negative_eigenvalues(), below(side, shift), "{side}");
            let right = right(side * side);
            let mut x = right.clone();
            factor.solve(&mut x);
            let rest =
                product(&matrix, &x).iter().zip(&right).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(rest < 1e-9, "{side}: {rest:e}");
            let forms = [vec![(0, 1.0), (side * side - 1, -2.0)], vec![(side / 2, 1.5)]];
            let moved = factor.compliance(&forms.each_ref().map(Vec::as_slice), 1);
            for (k, form) in forms.iter().enumerate() {
                let mut solved = vec![0.0; side * side];
                form.iter().for_each(|(row, value)| solved[*row] += value);
                factor.solve(&mut solved);
                let expected: f64 = forms[0].iter().map(|(row, value)| value * solved[*row]).sum();
                assert!((moved[(0, k)] - expected).abs() < 1e-12 * (1.0 + expected.abs()), "{side}");
            }
            let (mut first, mut second) = (right.clone(), x.clone());
            factor.solve_together([&mut first, &mut second]);
            let mut alone = x.clone();
            factor.solve(&mut alone);
            assert!(first == x && second == alone, "{side}");
        }
    }

    #[test]
    fn the_number_of_threads_does_not_change_a_bit() {
        let solved = |threads: usize| {
            rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap().install(|| {
                let matrix = shifted_laplacian(220, 0.9);
                let factor = SymmetricFactor::new(&matrix).unwrap();
                assert!(factor.pattern.shared.tree.branches.len() > 1);
                let mut x = right(matrix.nrows());
                factor.solve(&mut x);
                x.iter().map(|x| x.to_bits()).collect::<Vec<_>>()
            })
        };
        assert_eq!(solved(1), solved(3));
    }

    #[test]
    fn a_matrix_that_is_singular_or_of_another_pattern_is_refused() {
        let matrix = shifted_laplacian(3, 4.0);
        let zero = shifted_laplacian(1, 4.0);
        assert_eq!(SymmetricFactor::new(&zero).unwrap_err(), StructureError::Singular { rows: 1 });
        let pattern = FactorPattern::new(&zero).unwrap();
        let error = SymmetricFactor::with_pattern(&pattern, &matrix).unwrap_err();
        assert_eq!(error, StructureError::WrongPattern { rows: 9, expected: 1 });
        let size = 9;
        let diagonal: Vec<_> = (0..size).map(|k| Triplet::new(k, k, 1.0)).collect();
        let pattern =
            FactorPattern::new(&Sparse::try_new_from_triplets(size, size, &diagonal).unwrap()).unwrap();
        let error = SymmetricFactor::with_pattern(&pattern, &matrix).unwrap_err();
        assert!(matches!(error, StructureError::WrongPattern { .. }));
    }
}
