//! Entries of matrices by lines, and the pattern of sums of matrices.

use super::FactorPattern;
use crate::StructureError;
use crate::assembly::Sparse;
use faer::c64;
use faer::sparse::SymbolicSparseColMat;

/// Entries by lines, each with its place along the line.
pub(super) struct MatrixLines {
    starts: Vec<usize>,
    entries: Vec<(usize, c64)>,
}

impl MatrixLines {
    pub(super) fn new(count: usize, entries: impl Iterator<Item = (usize, usize, c64)> + Clone) -> Self {
        let (starts, entries) = sorted(count, entries);
        Self { starts, entries }
    }

    /// How many lines there are.
    pub(super) fn count(&self) -> usize {
        self.starts.len() - 1
    }

    pub(super) fn of(&self, line: usize) -> &[(usize, c64)] {
        &self.entries[self.starts[line]..self.starts[line + 1]]
    }
}

/// What lies on lines, by their numbers, in the order in which it comes: where each line begins, and places with what is there.
fn sorted<T: Copy + Default>(
    count: usize,
    entries: impl Iterator<Item = (usize, usize, T)> + Clone,
) -> (Vec<usize>, Vec<(usize, T)>) {
    let mut starts = vec![0; count + 1];
    entries.clone().for_each(|(line, ..)| starts[line + 1] += 1);
    for line in 0..count {
        starts[line + 1] += starts[line];
    }
    let mut next = starts.clone();
    let mut all = vec![(0, T::default()); starts[count]];
    for (line, place, value) in entries {
        all[next[line]] = (place, value);
        next[line] += 1;
    }
    (starts, all)
}

impl FactorPattern {
    /// The pattern of the factors of any sum of matrices of one size, which need not be symmetric.
    ///
    /// # Errors
    /// [`StructureError::OutOfMemory`].
    pub(crate) fn of_sums(matrices: &[&Sparse]) -> Result<Self, StructureError> {
        let size = matrices.first().map_or(0, |matrix| matrix.nrows());
        let entries = matrices.iter().flat_map(|matrix| {
            let of_column = |column: usize| matrix.row_idx_of_col(column).map(move |row| (row, column));
            (0..size).flat_map(of_column)
        });
        // the upper triangle mirrored into the lower
        let lower = entries.map(|(row, column)| (row.min(column), row.max(column)));
        let (starts, all) = sorted(size, lower.map(|(line, place)| (line, place, ())));
        let (mut kept, mut rows, mut seen) = (vec![0], Vec::new(), vec![usize::MAX; size]);
        for column in 0..size {
            let first = rows.len();
            for (row, ()) in &all[starts[column]..starts[column + 1]] {
                if std::mem::replace(&mut seen[*row], column) != column {
                    rows.push(*row);
                }
            }
            rows[first..].sort_unstable();
            kept.push(rows.len());
        }
        let values = vec![0.0; rows.len()];
        Self::new(&Sparse::new(SymbolicSparseColMat::new_checked(size, size, kept, None, rows), values))
    }
}
