//! Block Arnoldi on the quadratic problem shifted and inverted: the eigenvalues nearest to a shift.
//!
//! With λ = σ + ρ/θ the problem reads θ² Q(σ) x + θ ρ Q′(σ) x + ρ² M x = 0, so θ (x, u) = (−Q(σ)⁻¹ (ρ Q′(σ) x + ρ² M u), x) with
//! u = x/θ. Eigenvalues within ρ of σ have |θ| ≥ 1, and infinite ones θ = 0.

use super::shift::ShiftedFactor;
use crate::StructureError;
use crate::dense::general::complex_eigen;
use crate::quadratic::{Quadratic, Side};
use faer::linalg::matmul::matmul;
use faer::{Accum, Mat, MatRef, Par, c64};
use judder_numerics::counter::uniform;

/// Vectors that are taken through the operator together: solving for four costs little more than for one.
const WIDTH: usize = 4;
/// Steps between looks at the eigenvalues.
const STRIDE: usize = 4;
/// Vectors before a search gives up on more than it has.
const LARGEST: usize = 160;
/// θ counts as converged where its residual over |θ| is below it.
const TOLERANCE: f64 = 1e-11;
/// A new vector shorter than this share of what it was made of lies in the basis.
const INVARIANT: f64 = 1e-11;

/// An eigenvalue with its right vector, of length one.
#[derive(Debug, Clone)]
pub(super) struct Pair {
    pub(super) value: c64,
    pub(super) vector: Vec<c64>,
}

/// What a search around a shift has found: all eigenvalues within a radius.
#[derive(Debug, Clone)]
pub(super) struct Found {
    /// By rising distance from the shift.
    pub(super) pairs: Vec<Pair>,
    /// Every eigenvalue nearer to the shift has converged.
    pub(super) radius: f64,
}

/// All eigenvalues within the asked distance of the factor's shift, or as far out as the largest basis reaches.
pub(super) fn search(
    problem: &Quadratic,
    factor: &ShiftedFactor,
    side: Side,
    asked: f64,
    seed: u64,
) -> Result<Found, StructureError> {
    let mut basis = Basis::start(problem, factor, side, asked, seed)?;
    let mut seen = None;
    loop {
        let mut open = true;
        for _ in 0..STRIDE {
            open = open && basis.grow()?;
        }
        let ritz = basis.ritz(asked)?;
        let done = !open || basis.filled + WIDTH > LARGEST;
        // a value that comes late shows within one more look
        let settled = ritz.radius >= asked && seen == Some(ritz.inside(asked));
        if done || settled {
            return Ok(basis.found(&ritz, if open { ritz.radius } else { f64::INFINITY }));
        }
        seen = (ritz.radius >= asked).then(|| ritz.inside(asked));
    }
}

/// An orthonormal basis and the operator on it.
struct Basis<'a> {
    problem: &'a Quadratic,
    factor: &'a ShiftedFactor,
    side: Side,
    reach: f64,
    /// Columns (x, u), 2n long; those beyond `filled` are room.
    vectors: Mat<c64>,
    filled: usize,
    /// The newest block: columns from here on have not been through the operator.
    fresh: usize,
    /// The operator between the vectors: a column for each that has been through.
    projected: Mat<c64>,
}

/// Eigenvalues of the operator on the basis by falling |θ|, and how many of the first have converged.
struct Ritz {
    values: Vec<c64>,
    vectors: Mat<c64>,
    order: Vec<usize>,
    converged: usize,
    /// The distance within which all have converged.
    radius: f64,
    reach: f64,
}

impl<'a> Basis<'a> {
    fn start(
        problem: &'a Quadratic,
        factor: &'a ShiftedFactor,
        side: Side,
        reach: f64,
        seed: u64,
    ) -> Result<Self, StructureError> {
        let rows = 2 * problem.size();
        let room = LARGEST.min(rows) + WIDTH;
        let mut basis = Self {
            problem,
            factor,
            side,
            reach,
            vectors: Mat::zeros(rows, room),
            filled: 0,
            fresh: 0,
            projected: Mat::zeros(room, room),
        };
        let random = |row: usize, column: usize| {
            let at = (2 * (column * rows + row)) as u64;
            c64::new(uniform(seed, at) - 0.5, uniform(seed, at + 1) - 0.5)
        };
        // once through the operator: nothing is left that has no mass
        let block = basis.through(Mat::from_fn(rows, WIDTH.min(rows), random).as_ref())?;
        basis.take_in(block);
        Ok(basis)
    }

    /// The operator on a block of vectors.
    fn through(&self, block: MatRef<'_, c64>) -> Result<Mat<c64>, StructureError> {
        let (size, width) = (self.problem.size(), block.ncols());
        let (x, u) = (block.subrows(0, size), block.subrows(size, size));
        let mut image = self.problem.slope(self.side, self.factor.shift(), x);
        self.problem.add_mass(self.side, c64::new(self.reach, 0.0), u, &mut image);
        self.factor.solve(self.side, &mut image)?;
        Ok(Mat::from_fn(2 * size, width, |row, column| {
            if row < size { image[(row, column)] * -self.reach } else { x[(row - size, column)] }
        }))
    }

    /// One more block; false where the space is invariant.
    fn grow(&mut self) -> Result<bool, StructureError> {
        let (from, width) = (self.fresh, self.filled - self.fresh);
        if width == 0 {
            return Ok(false);
        }
        let image = self.through(self.vectors.subcols(from, width))?;
        self.fresh = self.filled;
        let shares = self.take_in(image);
        for (k, shares) in shares.iter().enumerate() {
            for (row, share) in shares.iter().enumerate() {
                self.projected[(row, from + k)] = *share;
            }
        }
        Ok(self.filled > self.fresh)
    }

    /// Makes a block orthonormal and a part of the basis; gives the coordinates of each of its vectors.
    fn take_in(&mut self, mut block: Mat<c64>) -> Vec<Vec<c64>> {
        let lengths: Vec<f64> = (0..block.ncols()).map(|k| block.col(k).norm_l2()).collect();
        let before = self.filled;
        let mut shares = Mat::zeros(before, block.ncols());
        // twice is enough (W. Kahan, B. N. Parlett)
        for _ in 0..2 {
            shares += project_out(self.vectors.subcols(0, before), &mut block);
        }
        let mut coordinates = Vec::new();
        for (k, length) in lengths.iter().enumerate() {
            let mut column: Vec<c64> = (0..before).map(|row| shares[(row, k)]).collect();
            let mut vector = Mat::from_fn(block.nrows(), 1, |row, _| block[(row, k)]);
            let mut within = Mat::zeros(self.filled - before, 1);
            for _ in 0..2 {
                within += project_out(self.vectors.subcols(before, self.filled - before), &mut vector);
            }
            column.extend((0..self.filled - before).map(|row| within[(row, 0)]));
            let left = vector.norm_l2();
            if left > INVARIANT * length {
                column.push(c64::new(left, 0.0));
                for row in 0..block.nrows() {
                    self.vectors[(row, self.filled)] = vector[(row, 0)] / left;
                }
                self.filled += 1;
            }
            coordinates.push(column);
        }
        coordinates
    }

    fn ritz(&self, asked: f64) -> Result<Ritz, StructureError> {
        let done = self.fresh;
        let (values, vectors) = complex_eigen(self.projected.submatrix(0, 0, done, done))
            .ok_or(StructureError::NoDenseEigenvalues { rows: done })?;
        let mut order: Vec<usize> = (0..done).collect();
        order.sort_by(|a, b| values[*b].norm().total_cmp(&values[*a].norm()));
        let open = self.projected.submatrix(done, 0, self.filled - done, done);
        let mut rests = Mat::zeros(open.nrows(), done);
        matmul(rests.as_mut(), Accum::Replace, open, vectors.as_ref(), c64::new(1.0, 0.0), Par::Seq);
        let residual = |k: usize| rests.col(k).norm_l2() / vectors.col(k).norm_l2();
        let has_converged = |k: &&usize| residual(**k) <= TOLERANCE * values[**k].norm();
        let converged = order.iter().take_while(has_converged).count();
        let distance = |k: usize| self.reach / values[k].norm();
        let radius = match (order.get(converged), converged) {
            // what has not converged may lie as much nearer as it is far
            (Some(k), _) => 0.9 * distance(*k),
            (None, 0) => 0.0,
            (None, _) => asked,
        };
        Ok(Ritz { values, vectors, order, converged, radius, reach: self.reach })
    }

    fn found(&self, ritz: &Ritz, radius: f64) -> Found {
        let (size, done) = (self.problem.size(), self.fresh);
        let pairs = ritz.finite().map(|k| {
            let mut vector = Mat::zeros(size, 1);
            let (basis, shares) = (self.vectors.submatrix(0, 0, size, done), ritz.vectors.subcols(k, 1));
            matmul(vector.as_mut(), Accum::Replace, basis, shares, c64::new(1.0, 0.0), Par::Seq);
            let length = vector.norm_l2();
            Pair {
                value: self.factor.shift() + self.reach / ritz.values[k],
                vector: (0..size).map(|row| vector[(row, 0)] / length).collect(),
            }
        });
        Found { pairs: pairs.collect(), radius }
    }
}

impl Ritz {
    /// The converged eigenvalues that are not infinite.
    fn finite(&self) -> impl Iterator<Item = usize> + '_ {
        const INFINITE: f64 = 1e-8;
        self.order[..self.converged].iter().copied().filter(|k| self.values[*k].norm() > INFINITE)
    }

    /// How many lie within a distance of the shift.
    fn inside(&self, distance: f64) -> usize {
        self.finite().filter(|k| self.reach / self.values[*k].norm() <= distance).count()
    }
}

/// B ← B − V Vᴴ B; gives Vᴴ B.
fn project_out(basis: MatRef<'_, c64>, block: &mut Mat<c64>) -> Mat<c64> {
    let mut shares = Mat::zeros(basis.ncols(), block.ncols());
    matmul(shares.as_mut(), Accum::Replace, basis.adjoint(), block.as_ref(), c64::new(1.0, 0.0), Par::Seq);
    matmul(block.as_mut(), Accum::Add, basis, shares.as_ref(), c64::new(-1.0, 0.0), Par::Seq);
    shares
}
