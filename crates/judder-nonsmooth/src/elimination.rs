//! Gaussian elimination in memory that is kept: a step of a march takes none.

use pulp::Arch;

/// A pivot that is rounding, as a share of the largest entry.
const ROUNDING: f64 = 1e-13;

/// A dense matrix, column after column, and what is left of it when it is eliminated: L and U, with the rows that changed places.
#[derive(Debug, Clone)]
pub(crate) struct KeptElimination {
    arch: Arch,
    size: usize,
    entries: Vec<f64>,
    swaps: Vec<usize>,
}

impl KeptElimination {
    /// Room for so many rows.
    pub(crate) fn new(arch: Arch, most: usize) -> Self {
        Self { arch, size: 0, entries: vec![0.0; most * most], swaps: vec![0; most] }
    }

    /// The columns of a matrix of so many rows, to be filled.
    pub(crate) fn columns(&mut self, size: usize) -> std::slice::ChunksExactMut<'_, f64> {
        self.size = size;
        self.entries[..size * size].chunks_exact_mut(size.max(1))
    }

    /// Eliminates the matrix; `false` where it is singular but for rounding.
    pub(crate) fn eliminate(&mut self) -> bool {
        let Self { arch, size, entries, swaps } = self;
        let size = *size;
        let entries = &mut entries[..size * size];
        let largest = entries.iter().fold(0.0_f64, |most, entry| most.max(entry.abs()));
        for k in 0..size {
            let (done, rest) = entries.split_at_mut((k + 1) * size);
            let column = &mut done[k * size..];
            let pivot = (k + 1..size)
                .fold(k, |best, row| if column[row].abs() > column[best].abs() { row } else { best });
            let size_of_pivot = column[pivot].abs();
            if size_of_pivot <= ROUNDING * largest || size_of_pivot.is_nan() {
                return false;
            }
            swaps[k] = pivot;
            column.swap(k, pivot);
            let inverse = 1.0 / column[k];
            column[k + 1..].iter_mut().for_each(|entry| *entry *= inverse);
            let below = &column[k + 1..];
            arch.dispatch(
                #[inline(always)]
                || {
                    for other in rest.chunks_exact_mut(size) {
                        other.swap(k, pivot);
                        let factor = other[k];
                        if factor != 0.0 {
                            other[k + 1..].iter_mut().zip(below).for_each(|(a, b)| *a -= factor * b);
                        }
                    }
                },
            );
            // the rows of L change places with those of what is still to come
            for earlier in 0..k {
                done.swap(earlier * size + k, earlier * size + pivot);
            }
        }
        true
    }

    /// b becomes the solution.
    pub(crate) fn solve(&self, b: &mut [f64]) {
        let size = self.size;
        (0..size).for_each(|k| b.swap(k, self.swaps[k]));
        let columns = || self.entries[..size * size].chunks_exact(size.max(1));
        self.arch.dispatch(
            #[inline(always)]
            || {
                for (k, column) in columns().enumerate() {
                    let (above, below) = b.split_at_mut(k + 1);
                    let factor = above[k];
                    below.iter_mut().zip(&column[k + 1..]).for_each(|(b, entry)| *b -= factor * entry);
                }
                for (k, column) in columns().enumerate().rev() {
                    let factor = b[k] / column[k];
                    b[k] = factor;
                    b[..k].iter_mut().zip(column).for_each(|(b, entry)| *b -= factor * entry);
                }
            },
        );
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::KeptElimination;
    use pulp::Arch;

    #[test]
    fn solutions_solve_and_singular_matrices_are_told() {
        let mut room = KeptElimination::new(Arch::new(), 12);
        for size in [1_usize, 2, 7, 12] {
            let at = |i: usize, j: usize| ((5 * i * j + 3 * i + 7 * j * j + 1) as f64).sin();
            for (j, column) in room.columns(size).enumerate() {
                column.iter_mut().enumerate().for_each(|(i, entry)| *entry = at(i, j));
            }
            assert!(room.eliminate());
            let wanted: Vec<f64> = (0..size).map(|k| (k as f64).cos()).collect();
            let mut found: Vec<f64> =
                (0..size).map(|i| (0..size).map(|j| at(i, j) * wanted[j]).sum()).collect();
            room.solve(&mut found);
            assert!(found.iter().zip(&wanted).all(|(a, b)| (a - b).abs() < 1e-10), "{found:?}");
        }
        room.columns(3).for_each(|column| column.fill(1.0));
        assert!(!room.eliminate());
        room.columns(2).for_each(|column| column.fill(f64::NAN));
        assert!(!room.eliminate());
    }
}
