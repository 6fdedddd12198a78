//! Few vectors that carry many: proper orthogonal decomposition of snapshots, batch by batch.

use faer::{Mat, MatRef};
use judder_dense::product::product;
use judder_dense::symmetric::{Eigen, symmetric};

/// Orthonormal columns that carry snapshots.
#[derive(Debug)]
pub(super) struct SnapshotBasis {
    vectors: Mat<f64>,
    /// What the largest direction of the first batch holds, squared.
    largest: f64,
    /// Directions that hold less than this share of the largest are left out.
    cut: f64,
}

impl SnapshotBasis {
    /// One without columns, for eigenvalues of which less than a share of |λ| is to be left open: that is of second order in what is cut.
    pub(super) fn empty(tolerance: f64) -> Self {
        /// Of the root of the tolerance: what is cut of vectors leaves some thousand times its square of the eigenvalues open.
        const CUT: f64 = 1e-2;
        Self { vectors: Mat::zeros(0, 0), largest: 0.0, cut: CUT * tolerance.sqrt() }
    }

    /// The columns.
    pub(super) fn vectors(&self) -> MatRef<'_, f64> {
        self.vectors.as_ref()
    }

    /// With what snapshots, columns of one length, have beyond it; `None` where they have no finite directions.
    pub(super) fn extended(self, mut snapshots: Mat<f64>) -> Option<Self> {
        let (rows, known, cut) = (snapshots.nrows(), self.vectors.ncols(), self.cut);
        let before = if known == 0 { Mat::zeros(rows, 0) } else { self.vectors };
        project_out(before.as_ref(), &mut snapshots);
        let Eigen { values, vectors } = symmetric(&product(snapshots.transpose(), snapshots.as_ref()))?;
        let largest = if known == 0 { values.last().copied().unwrap_or(0.0) } else { self.largest };
        let kept: Vec<usize> = (0..values.len())
            .rev()
            .filter(|k| values[*k] > cut * cut * largest && values[*k] > 0.0)
            .collect();
        if kept.is_empty() {
            return Some(Self { vectors: before, largest, cut });
        }
        let shares =
            Mat::from_fn(values.len(), kept.len(), |i, k| vectors[(i, kept[k])] / values[kept[k]].sqrt());
        let mut directions = product(snapshots.as_ref(), shares.as_ref());
        // the squares in the products have cost half of the digits of small directions
        project_out(before.as_ref(), &mut directions);
        let directions = orthonormal(directions)?;
        let vectors = Mat::from_fn(rows, known + kept.len(), |row, k| match k.checked_sub(known) {
            None => before[(row, k)],
            Some(k) => directions[(row, k)],
        });
        Some(Self { vectors, largest, cut })
    }
}

/// B ← B − V Vᵀ B, twice (W. Kahan, B. N. Parlett).
fn project_out(basis: MatRef<'_, f64>, block: &mut Mat<f64>) {
    if basis.ncols() == 0 {
        return;
    }
    for _ in 0..2 {
        let shares = product(basis.transpose(), block.as_ref());
        *block -= product(basis, shares.as_ref());
    }
}

/// The orthonormal columns that are nearest to these, which are nearly so: B (Bᵀ B)^(−1/2), twice for all digits.
fn orthonormal(mut block: Mat<f64>) -> Option<Mat<f64>> {
    for _ in 0..2 {
        let Eigen { values, vectors } = symmetric(&product(block.transpose(), block.as_ref()))?;
        let size = values.len();
        let scaled = Mat::from_fn(size, size, |i, k| vectors[(i, k)] / values[k].sqrt());
        block = product(block.as_ref(), product(scaled.as_ref(), vectors.transpose()).as_ref());
    }
    block.is_all_finite().then_some(block)
}

#[cfg(test)]
mod tests {
    use super::*;
    use judder_numerics::counter::uniform;

    #[test]
    fn a_basis_carries_every_snapshot_but_for_what_is_cut() {
        let random = |i: usize, k: usize| uniform(11, (40 * k + i) as u64) - 0.5;
        let first = Mat::from_fn(40, 6, random);
        // the second batch is in the first but for two columns, one of which is below the cut
        let second = Mat::from_fn(40, 5, |i, k| match k {
            3 => first[(i, 0)] + random(i, 20),
            4 => first[(i, 1)] + 1e-9 * random(i, 21),
            k => first[(i, k)] - 2.0 * first[(i, k + 1)],
        });
        let basis =
            SnapshotBasis::empty(1e-8).extended(first.clone()).unwrap().extended(second.clone()).unwrap();
        let vectors = basis.vectors();
        assert_eq!(vectors.ncols(), 7);
        let unit = product(vectors.transpose(), vectors) - Mat::<f64>::identity(7, 7);
        assert!(unit.norm_max() < 1e-14, "{:e}", unit.norm_max());
        for snapshots in [first, second] {
            let mut rest = snapshots;
            project_out(vectors, &mut rest);
            assert!(rest.norm_max() < 1e-8);
        }
    }
}
