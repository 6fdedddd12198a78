//! A family of problems on a basis of few vectors, and what that leaves open.
//!
//! With right and left vectors of the samples in one basis V the projected eigenvalues are exact to second order: λ − λ̃ = sᵀ Q⁻¹ r/d
//! with the residuals r = Q(λ̃) x̃ and s = Q(λ̃)ᵀ z̃, both orthogonal to V. The inverse of the nearest sample stands in for Q⁻¹: on what
//! V does not carry the two differ little. Twice ‖s‖ ‖Q⁻¹ r‖/|d| is shown as the error.

use super::basis::SnapshotBasis;
use super::problem_family::ProblemFamily;
use crate::StructureError;
use crate::complex_modes::{RefinedEigenvalue, SearchedRegion, ShiftedFactor, Triple, vectors};
use crate::quadratic::{MatrixSide, Quadratic, Region};
use faer::{Mat, c64};
use judder_dense::general::{real_eigen, solve};
use judder_dense::product::product;
use judder_numerics::complex::ElementaryComplex;

/// A family on a basis V.
pub(super) struct Projection<'a, F: ProblemFamily> {
    family: &'a F,
    basis: SnapshotBasis,
    prepared: F::OnBasis,
}

/// Eigenvalues of the projected problem, measured on the full one, with what the projection leaves open of each, times d.
pub(super) struct Projected {
    pub(super) refined: Vec<RefinedEigenvalue>,
    pub(super) left_open: Vec<f64>,
}

impl Projected {
    /// Whether nothing is open beyond a share of |λ|.
    pub(super) fn within(&self, tolerance: f64) -> bool {
        let pairs = self.refined.iter().zip(&self.left_open);
        pairs
            .into_iter()
            .all(|(of, open)| *open <= tolerance * of.triple.value.modulus() * of.slope.modulus())
    }
}

impl<'a, F: ProblemFamily> Projection<'a, F> {
    /// On a basis, that of some samples, of one of which this is the problem; `None` where the basis is empty.
    pub(super) fn new(family: &'a F, basis: SnapshotBasis, sample: &Quadratic) -> Option<Self> {
        let has_vectors = basis.vectors().ncols() > 0;
        has_vectors.then(|| Self { family, prepared: family.on_basis(basis.vectors(), sample), basis })
    }

    /// Its basis.
    pub(super) fn into_basis(self) -> SnapshotBasis {
        self.basis
    }

    /// Vectors of the basis.
    pub(super) fn size(&self) -> usize {
        self.basis.vectors().ncols()
    }

    /// The eigenvalues in a region at a point; the factors of a sample near it measure what is left open. `None` where the
    /// projected problem has no solution: its mass is singular, say.
    pub(super) fn at(
        &self,
        point: &F::Point,
        problem: &Quadratic,
        region: &Region,
        sample: &[ShiftedFactor],
    ) -> Result<Option<Projected>, StructureError> {
        let matrices = self.family.projected(&self.prepared, self.basis.vectors(), point, problem);
        let Some(triples) = self.triples(matrices, region) else { return Ok(None) };
        let refined = RefinedEigenvalue::all_measured(problem, triples);
        let left_open = left_open(&refined, sample)?;
        Ok(Some(Projected { refined, left_open }))
    }

    /// The eigenvalues of the projected problem in a region, with their vectors on all freedoms.
    fn triples(&self, [mass, damping, stiffness]: [Mat<f64>; 3], region: &Region) -> Option<Vec<Triple>> {
        let size = self.size();
        // λ = ω₀ s makes the blocks of the companion matrix alike
        let unit = region.re.iter().chain(&region.im).fold(0.0_f64, |a, b| a.max(b.abs()));
        let mut blocks = Mat::from_fn(size, 2 * size, |i, j| {
            if j < size { -stiffness[(i, j)] / (unit * unit) } else { -damping[(i, j - size)] / unit }
        });
        solve(mass.clone(), &mut blocks)?;
        let companion = Mat::from_fn(2 * size, 2 * size, |i, j| match (i < size, i + size == j) {
            (true, true) => 1.0,
            (true, false) => 0.0,
            _ => blocks[(i - size, j)],
        });
        let inside = |value: c64| region.contains(value * unit, BORDER * unit);
        let picked = real_eigen(&companion, &inside)?;
        // of the left vectors w = (…, Mᵀ y) the lower half
        let count = picked.values.len();
        let mut halves = Mat::from_fn(size, 2 * count, |i, k| {
            let entry = picked.left[(size + i, k % count)];
            if k < count { entry.re } else { -entry.im }
        });
        solve(mass.transpose().to_owned(), &mut halves)?;
        // real and imaginary parts of the right vectors, then of the left ones
        let parts = Mat::from_fn(size, 4 * count, |i, k| match (k / count, k % count) {
            (0, k) => picked.right[(i, k)].re,
            (1, k) => picked.right[(i, k)].im,
            (part, k) => halves[(i, (part - 2) * count + k)],
        });
        let lifted = product(self.basis.vectors(), parts.as_ref());
        let vector = |part: usize, k: usize| {
            let entry =
                |row: usize| c64::new(lifted[(row, part * count + k)], lifted[(row, (part + 1) * count + k)]);
            let mut vector: Vec<c64> = (0..lifted.nrows()).map(entry).collect();
            vectors::normalise(&mut vector);
            vector
        };
        let triple =
            |k: usize| Triple { value: picked.values[k] * unit, right: vector(0, k), left: vector(2, k) };
        Some((0..count).map(triple).collect())
    }
}

/// The parts of the vectors of a sample as columns.
pub(super) fn snapshots(sample: &SearchedRegion) -> Mat<f64> {
    let both = sample.refined.iter().flat_map(|refined| [&refined.triple.right, &refined.triple.left]);
    let all: Vec<&Vec<c64>> = both.collect();
    let rows = all.first().map_or(0, |vector| vector.len());
    Mat::from_fn(rows, 2 * all.len(), |row, k| {
        let entry = all[k / 2][row];
        if k % 2 == 0 { entry.re } else { entry.im }
    })
}

/// Eigenvalues that lie outside of the region by this share of its size are looked at: their error may reach in.
const BORDER: f64 = 1e-6;

/// 2 ‖s‖ ‖Q⁻¹ r‖ of each, with the factor whose shift is nearest.
fn left_open(refined: &[RefinedEigenvalue], sample: &[ShiftedFactor]) -> Result<Vec<f64>, StructureError> {
    const SAFETY: f64 = 2.0;
    let mut left_open = vec![f64::INFINITY; refined.len()];
    for (number, factor) in sample.iter().enumerate() {
        let nearest = |value: c64| {
            let distance = |k: &usize| (sample[*k].shift() - value).modulus();
            (0..sample.len()).min_by(|a, b| distance(a).total_cmp(&distance(b)))
        };
        let mine: Vec<usize> =
            (0..refined.len()).filter(|k| nearest(refined[*k].triple.value) == Some(number)).collect();
        if mine.is_empty() {
            continue;
        }
        let size = refined[0].rest.len();
        let mut block = Mat::from_fn(size, mine.len(), |row, k| refined[mine[k]].rest[row]);
        factor.solve(MatrixSide::Right, &mut block)?;
        for (k, place) in mine.iter().enumerate() {
            let of = &refined[*place];
            left_open[*place] = SAFETY * vectors::length(&of.left_rest) * block.col(k).norm_l2();
        }
    }
    Ok(left_open)
}
