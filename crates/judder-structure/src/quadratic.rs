//! The quadratic eigenproblem of a damped structure, (λ² M + λ C + K) x = 0, and the region of the complex plane that is looked at.

mod products;

use crate::StructureError;
use crate::assembly::Sparse;
use crate::factor::FactorPattern;
use faer::sparse::{SparseColMat, SymbolicSparseColMat};
use faer::{ColRef, Mat, MatRef, c64};
use judder_numerics::complex::ElementaryComplex;
use products::{TOGETHER, add_product, add_products, in_groups, packed};
use std::sync::OnceLock;

/// Q(λ) = λ² M + λ C + K with real matrices of one size, none of which need be symmetric.
#[derive(Debug, Clone)]
pub struct Quadratic {
    mass: Sparse,
    damping: Sparse,
    stiffness: Sparse,
    norms: [f64; 3],
    pattern: OnceLock<FactorPattern>,
}

/// Q(λ) X and Q′(λ) X of vectors with a λ each.
pub(crate) struct QuadraticImages {
    pub(crate) image: Mat<c64>,
    pub(crate) slope: Mat<c64>,
}

/// Whether a matrix is meant or its transpose, whose right vectors are the conjugate left vectors.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum MatrixSide {
    /// Q(λ).
    Right,
    /// Q(λ)ᵀ.
    Left,
}

/// A rectangle of the complex plane: λ = re + i im.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Region {
    /// Growth rates from and to, 1/s.
    pub re: [f64; 2],
    /// Angular frequencies from and to, rad/s.
    pub im: [f64; 2],
}

impl Quadratic {
    /// Mass (kg), damping (N s/m) and stiffness (N/m) of a structure.
    ///
    /// # Errors
    /// [`StructureError::WrongShape`] where they are not square and of one size, [`StructureError::NotFinite`] for an entry that is
    /// no number, [`StructureError::EmptyMatrix`] where the mass or the stiffness is zero.
    pub fn new(mass: Sparse, damping: Sparse, stiffness: Sparse) -> Result<Self, StructureError> {
        let rows = mass.nrows();
        for (name, matrix) in [("mass", &mass), ("damping", &damping), ("stiffness", &stiffness)] {
            check(name, matrix, rows)?;
        }
        let norms = [norm_of(&mass), norm_of(&damping), norm_of(&stiffness)];
        for (name, norm) in [("mass", norms[0]), ("stiffness", norms[2])] {
            if norm == 0.0 {
                return Err(StructureError::EmptyMatrix { name: name.to_owned() });
            }
        }
        Ok(Self { mass, damping, stiffness, norms, pattern: OnceLock::new() })
    }

    /// Rows of the matrices.
    #[must_use]
    pub fn size(&self) -> usize {
        self.mass.nrows()
    }

    /// M.
    #[must_use]
    pub fn mass(&self) -> &Sparse {
        &self.mass
    }

    /// C.
    #[must_use]
    pub fn damping(&self) -> &Sparse {
        &self.damping
    }

    /// K.
    #[must_use]
    pub fn stiffness(&self) -> &Sparse {
        &self.stiffness
    }

    /// |λ|² ‖M‖ + |λ| ‖C‖ + ‖K‖, what normalised residuals are measured by (F. Tisseur, 2000).
    #[must_use]
    pub fn scale(&self, value: c64) -> f64 {
        let size = value.modulus();
        (self.norms[0] * size + self.norms[1]) * size + self.norms[2]
    }

    /// |z|ᵀ (|λ|² |M| + |λ| |C| + |K|) |x|.
    pub(crate) fn scale_by_entries(&self, value: c64, z: &[c64], x: &[c64]) -> f64 {
        let size = value.modulus();
        let z: Vec<f64> = z.iter().map(|z| z.modulus()).collect();
        let of = |matrix: &Sparse| -> f64 {
            let column = |k: usize| {
                let entries = matrix.row_idx_of_col(k).zip(matrix.val_of_col(k));
                x[k].modulus() * entries.map(|(row, entry)| z[row] * entry.abs()).sum::<f64>()
            };
            (0..matrix.ncols()).map(column).sum()
        };
        (of(&self.mass) * size + of(&self.damping)) * size + of(&self.stiffness)
    }

    /// √(‖M‖₁ ‖M‖∞).
    pub(crate) fn mass_norm(&self) -> f64 {
        self.norms[0]
    }

    /// Q(λ) as a sparse matrix on the union of the three patterns.
    pub(crate) fn at(&self, value: c64) -> Result<SparseColMat<usize, c64>, StructureError> {
        let parts =
            [(value * value, &self.mass), (value, &self.damping), (c64::new(1.0, 0.0), &self.stiffness)];
        union(&parts).ok_or(StructureError::OutOfMemory { rows: self.size() })
    }

    /// The pattern of the factors of Q(λ) on a symmetric pattern, one for every λ.
    ///
    /// # Errors
    /// [`StructureError::OutOfMemory`].
    pub(crate) fn pattern(&self) -> Result<FactorPattern, StructureError> {
        if let Some(known) = self.pattern.get() {
            return Ok(known.clone());
        }
        let found = FactorPattern::of_sums(&[&self.mass, &self.damping, &self.stiffness])?;
        Ok(self.pattern.get_or_init(|| found).clone())
    }

    /// Q(λ) X of a block of vectors, or Q(λ)ᵀ X.
    pub(crate) fn image(&self, side: MatrixSide, value: c64, x: MatRef<'_, c64>) -> Mat<c64> {
        let mut image = Mat::zeros(x.nrows(), x.ncols());
        add_product(&self.mass, side, value * value, x, &mut image);
        add_product(&self.damping, side, value, x, &mut image);
        add_product(&self.stiffness, side, c64::new(1.0, 0.0), x, &mut image);
        image
    }

    /// Q′(λ) X = (2λ M + C) X of a block of vectors, or with the transposes.
    pub(crate) fn slope(&self, side: MatrixSide, value: c64, x: MatRef<'_, c64>) -> Mat<c64> {
        let mut image = Mat::zeros(x.nrows(), x.ncols());
        add_product(&self.mass, side, 2.0 * value, x, &mut image);
        add_product(&self.damping, side, c64::new(1.0, 0.0), x, &mut image);
        image
    }

    /// Q(λ) x and Q′(λ) x of vectors with a λ each, or with the transposes.
    pub(crate) fn images(&self, side: MatrixSide, values: &[c64], x: MatRef<'_, c64>) -> QuadraticImages {
        let zeros = || Mat::zeros(x.nrows(), x.ncols());
        let mut images = QuadraticImages { image: zeros(), slope: zeros() };
        in_groups(x.ncols(), &mut |first, together| match together {
            TOGETHER => self.add_images::<TOGETHER>(side, values, x, first, &mut images),
            _ => self.add_images::<1>(side, values, x, first, &mut images),
        });
        images
    }

    /// The same of N vectors from a number on.
    fn add_images<const N: usize>(
        &self,
        side: MatrixSide,
        values: &[c64],
        x: MatRef<'_, c64>,
        first: usize,
        images: &mut QuadraticImages,
    ) {
        let from = packed::<N>(x, first);
        let [mass, damping, stiffness] = [&self.mass, &self.damping, &self.stiffness].map(|matrix| {
            let mut to = vec![[c64::new(0.0, 0.0); N]; x.nrows()];
            add_products(matrix, side, c64::new(1.0, 0.0), &from, &mut to);
            to
        });
        for k in 0..N {
            let value = values[first + k];
            for row in 0..x.nrows() {
                let (m, c) = (mass[row][k], damping[row][k]);
                images.image[(row, first + k)] = (value * m + c) * value + stiffness[row][k];
                images.slope[(row, first + k)] = 2.0 * value * m + c;
            }
        }
    }

    /// Y += a M X of a block of vectors, or with the transpose.
    pub(crate) fn add_mass(&self, side: MatrixSide, factor: c64, x: MatRef<'_, c64>, image: &mut Mat<c64>) {
        add_product(&self.mass, side, factor, x, image);
    }
}

impl Region {
    /// # Errors
    /// [`StructureError::EmptyRegion`] where a range is not finite or does not rise.
    pub(crate) fn check(&self) -> Result<(), StructureError> {
        for (name, range) in [("re", self.re), ("im", self.im)] {
            if !(range[0].is_finite() && range[1].is_finite() && range[0] < range[1]) {
                return Err(StructureError::EmptyRegion { name, from: range[0], to: range[1] });
            }
        }
        Ok(())
    }

    /// The middle.
    pub(crate) fn centre(&self) -> c64 {
        c64::new(0.5 * (self.re[0] + self.re[1]), 0.5 * (self.im[0] + self.im[1]))
    }

    /// From the middle to a corner.
    pub(crate) fn radius(&self) -> f64 {
        0.5 * libm::hypot(self.re[1] - self.re[0], self.im[1] - self.im[0])
    }

    /// Whether a value lies inside, or outside by no more than a margin.
    pub(crate) fn contains(&self, value: c64, margin: f64) -> bool {
        let within = |x: f64, range: [f64; 2]| range[0] - margin <= x && x <= range[1] + margin;
        within(value.re, self.re) && within(value.im, self.im)
    }

    /// How far a value inside is from the nearest edge.
    pub(crate) fn distance_to_edge(&self, value: c64) -> f64 {
        let within = |x: f64, [from, to]: [f64; 2]| (x - from).min(to - x);
        within(value.re, self.re).min(within(value.im, self.im))
    }

    /// A region larger by a share of its sides.
    pub(crate) fn widened(&self, share: f64) -> Self {
        let wider = |[from, to]: [f64; 2]| [from - share * (to - from), to + share * (to - from)];
        Self { re: wider(self.re), im: wider(self.im) }
    }

    /// Two halves, cut across the longer side.
    pub(crate) fn halves(&self) -> [Self; 2] {
        let centre = self.centre();
        if self.re[1] - self.re[0] > self.im[1] - self.im[0] {
            [Self { re: [self.re[0], centre.re], ..*self }, Self { re: [centre.re, self.re[1]], ..*self }]
        } else {
            [Self { im: [self.im[0], centre.im], ..*self }, Self { im: [centre.im, self.im[1]], ..*self }]
        }
    }
}

/// # Errors
/// [`StructureError::WrongShape`], [`StructureError::NotFinite`].
pub(crate) fn check(name: &str, matrix: &Sparse, rows: usize) -> Result<(), StructureError> {
    if matrix.nrows() != rows || matrix.ncols() != rows {
        return Err(StructureError::WrongShape {
            name: name.to_owned(),
            found: (matrix.nrows(), matrix.ncols()),
            rows,
        });
    }
    for column in 0..rows {
        for (row, value) in matrix.row_idx_of_col(column).zip(matrix.val_of_col(column)) {
            if !value.is_finite() {
                return Err(StructureError::NotFinite { name: name.to_owned(), row, column, value: *value });
            }
        }
    }
    Ok(())
}

/// √(‖A‖₁ ‖A‖∞), which is no less than ‖A‖₂.
pub(crate) fn norm_of(matrix: &Sparse) -> f64 {
    let (mut of_rows, mut of_columns) = (vec![0.0; matrix.nrows()], vec![0.0; matrix.ncols()]);
    for (column, sum) in of_columns.iter_mut().enumerate() {
        for (row, value) in matrix.row_idx_of_col(column).zip(matrix.val_of_col(column)) {
            *sum += value.abs();
            of_rows[row] += value.abs();
        }
    }
    let largest = |sums: &[f64]| sums.iter().copied().fold(0.0, f64::max);
    (largest(&of_rows) * largest(&of_columns)).sqrt()
}

/// The entries of a column.
pub(crate) fn entries(column: ColRef<'_, c64>) -> impl Iterator<Item = c64> + '_ {
    (0..column.nrows()).map(move |row| column[row])
}

/// Σ fᵢ Aᵢ on the union of the patterns, zeros included; `None` where it does not fit into memory.
fn union(parts: &[(c64, &Sparse)]) -> Option<SparseColMat<usize, c64>> {
    let size = parts.first()?.1.nrows();
    let entries = parts.iter().map(|(_, matrix)| matrix.val().len()).sum();
    let (mut start, mut rows, mut values) = (Vec::new(), Vec::new(), Vec::new());
    start.try_reserve(size + 1).ok()?;
    rows.try_reserve(entries).ok()?;
    values.try_reserve(entries).ok()?;
    start.push(0);
    // where a row's entry of this column lies, of columns before it something smaller
    let mut place = vec![usize::MAX; size];
    for column in 0..size {
        let first = rows.len();
        for (_, matrix) in parts {
            for row in matrix.row_idx_of_col(column) {
                if place[row] == usize::MAX || place[row] < first {
                    place[row] = rows.len();
                    rows.push(row);
                }
            }
        }
        rows[first..].sort_unstable();
        for (k, row) in rows[first..].iter().enumerate() {
            place[*row] = first + k;
        }
        values.resize(rows.len(), c64::new(0.0, 0.0));
        for (factor, matrix) in parts {
            for (row, value) in matrix.row_idx_of_col(column).zip(matrix.val_of_col(column)) {
                values[place[row]] += *factor * *value;
            }
        }
        start.push(rows.len());
    }
    Some(SparseColMat::new(SymbolicSparseColMat::new_checked(size, size, start, None, rows), values))
}

#[cfg(test)]
mod tests {
    use super::*;
    use faer::sparse::Triplet;

    fn matrix(size: usize, entries: &[(usize, usize, f64)]) -> Sparse {
        let triplets: Vec<_> = entries.iter().map(|(i, j, v)| Triplet::new(*i, *j, *v)).collect();
        Sparse::try_new_from_triplets(size, size, &triplets).unwrap()
    }

    #[test]
    fn the_matrix_at_a_value_is_what_its_image_says() {
        let problem = Quadratic::new(
            matrix(3, &[(0, 0, 2.0), (1, 1, 3.0), (2, 0, 1.0)]),
            matrix(3, &[(0, 2, 0.5), (2, 2, -1.0)]),
            matrix(3, &[(0, 0, 4.0), (1, 0, -7.0), (2, 2, 9.0), (0, 2, 3.0)]),
        )
        .unwrap();
        let value = c64::new(0.3, -1.7);
        let identity = Mat::<c64>::identity(3, 3);
        let image = problem.image(MatrixSide::Right, value, identity.as_ref());
        let of_transposed = problem.image(MatrixSide::Left, value, identity.as_ref());
        let whole = problem.at(value).unwrap().to_dense();
        for i in 0..3 {
            for j in 0..3 {
                assert!((image[(i, j)] - whole[(i, j)]).norm() < 1e-15);
                assert!((of_transposed[(j, i)] - whole[(i, j)]).norm() < 1e-15);
            }
        }
    }

    #[test]
    fn what_is_not_a_problem_is_refused() {
        let one = || matrix(2, &[(0, 0, 1.0), (1, 1, 1.0)]);
        let refused = |m, c, k| Quadratic::new(m, c, k).unwrap_err().to_string();
        assert!(refused(one(), matrix(3, &[]), one()).contains("the damping matrix is 3 × 3"));
        assert!(refused(one(), matrix(2, &[(0, 1, f64::NAN)]), one()).contains("row 0, column 1"));
        assert!(refused(matrix(2, &[]), one(), one()).contains("the mass matrix has no entries"));
    }
}
