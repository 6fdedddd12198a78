//! Lanczos' method on (K − σ M)⁻¹ M, which is symmetric in the inner product of M.

use crate::StructureError;
use crate::assembly::Sparse;
use crate::factor::SymmetricFactor;
use crate::statics::{dot, symmetric_product};
use faer::Mat;
use judder_dense::symmetric::{Eigen, symmetric};
use judder_numerics::counter::uniform;
use judder_numerics::parallel;
use rayon::prelude::*;
use std::collections::VecDeque;

/// A Krylov basis that grows until enough eigenvalues have converged.
pub(super) struct Lanczos<'a> {
    factor: &'a SymmetricFactor,
    mass: &'a Sparse,
    shift: f64,
    /// Orthonormal in M.
    basis: Vec<Vec<f64>>,
    /// M times each.
    with_mass: Vec<Vec<f64>>,
    /// The operator between the vectors: of each its products with itself and those before it.
    projected: Vec<Vec<f64>>,
    /// What the next vectors are made of.
    pending: VecDeque<Pending>,
    starts: u64,
    /// Nothing with mass lies outside the basis.
    is_whole: bool,
}

/// A vector x of unit length and M x.
type WithMass = (Vec<f64>, Vec<f64>);

/// What the operator makes of a vector outside the basis, or a random start.
struct Pending {
    vector: Vec<f64>,
    /// In M.
    length: f64,
    /// The vector that it comes from.
    from: Option<usize>,
    /// How many vectors of the basis it is orthogonal to, from the first on.
    orthogonal_to: usize,
}

/// An eigenvalue λ counts as converged where the residual of (K − σM)⁻¹M over its eigenvalue is below it.
const TOLERANCE: f64 = 1e-11;
/// Relative distance of eigenvalues that are not one.
pub(super) const APART: f64 = 1e-6;
/// A new vector shorter than this share of what it was made of lies in the basis: the space is invariant.
const INVARIANT: f64 = 1e-10;
/// Pairs of vectors between looks at the eigenvalues: so many, or this part of the basis, as a look takes its cube.
const STRIDE: usize = 3;
const STRIDE_PART: usize = 32;
/// Entries of vectors that are worked together.
const CHUNK: usize = 4096;

impl<'a> Lanczos<'a> {
    pub(super) fn new(factor: &'a SymmetricFactor, mass: &'a Sparse, shift: f64) -> Self {
        Self {
            factor,
            mass,
            shift,
            basis: Vec::new(),
            with_mass: Vec::new(),
            projected: Vec::new(),
            pending: VecDeque::new(),
            starts: 0,
            is_whole: false,
        }
    }

    /// Takes in a random vector: what the space so far has missed is in it.
    pub(super) fn start_anew(&mut self) {
        let random = self.random();
        self.pending.push_front(random);
    }

    /// The eigenvalues nearest above the shift, so many at least, and where the next ones begin.
    pub(super) fn converged(&mut self, count: usize) -> Result<LanczosModes, StructureError> {
        let size = self.mass.nrows();
        loop {
            for _ in 0..STRIDE.max(self.basis.len() / STRIDE_PART) {
                self.grow()?;
            }
            self.is_whole |= self.basis.len() == size;
            if self.is_whole {
                // what is pending lies in the basis
                self.pending.clear();
            }
            let ritz = self.ritz()?;
            let last = ritz.values.last().copied().unwrap_or(0.0);
            let is_apart = ritz.next.is_some_and(|next| next - last > APART * next.abs());
            let enough = ritz.values.len() > count || ritz.values.len() == count && is_apart;
            if enough || self.is_whole {
                let pairs = ritz.vectors.iter().zip(&ritz.values);
                let shapes = pairs.map(|(shares, value)| self.iterated(shares, *value)).collect();
                return Ok(LanczosModes {
                    values: ritz.values,
                    shapes,
                    next: ritz.next,
                    is_whole: self.is_whole,
                });
            }
        }
    }

    /// Two more vectors, one where there is no other.
    fn grow(&mut self) -> Result<(), StructureError> {
        let size = self.mass.nrows();
        let first = self.basis.len();
        for _ in first..size.min(first + 2) {
            let Some((vector, with_mass)) = self.next_vector()? else {
                self.is_whole = true;
                break;
            };
            self.basis.push(vector);
            self.with_mass.push(with_mass);
        }
        let mut images = self.with_mass[first..].to_vec();
        match &mut images[..] {
            [one, other] => self.factor.solve_together([one, other]),
            others => others.iter_mut().for_each(|image| self.factor.solve(image)),
        }
        for (k, image) in images.into_iter().enumerate() {
            self.take_in(image, first + k);
        }
        Ok(())
    }

    /// What the operator has made of a vector of the basis.
    fn take_in(&mut self, mut image: Vec<f64>, from: usize) {
        let shares = self.orthogonalise(&mut image, 0);
        let length = length(self.mass, &image);
        let before = libm::hypot(shares.iter().map(|share| share * share).sum::<f64>().sqrt(), length);
        self.projected.push(shares);
        if length > INVARIANT * before {
            let orthogonal_to = self.basis.len();
            self.pending.push_back(Pending { vector: image, length, from: Some(from), orthogonal_to });
        }
    }

    /// A vector of unit length outside the basis, with M times it: of what is pending the first that is not in the basis by now,
    /// else a random one. `None` where the basis holds all that has mass.
    fn next_vector(&mut self) -> Result<Option<WithMass>, StructureError> {
        loop {
            let Pending { mut vector, length, from, orthogonal_to } = match self.pending.pop_front() {
                Some(pending) => pending,
                None => self.random(),
            };
            self.orthogonalise(&mut vector, orthogonal_to);
            let mut with_mass = symmetric_product(self.mass, &vector);
            let left = dot(&vector, &with_mass).max(0.0).sqrt();
            if left > INVARIANT * length {
                for value in vector.iter_mut().chain(&mut with_mass) {
                    *value /= left;
                }
                return Ok(Some((vector, with_mass)));
            }
            if from.is_none() {
                if self.holds_all_mass() {
                    return Ok(None);
                }
                return Err(StructureError::MissingModes { wanted: self.basis.len() + 1 });
            }
        }
    }

    /// Whether a random vector has no mass outside the basis. The operator must not be applied to it: of what is far above the
    /// shift it would leave nothing to be seen.
    fn holds_all_mass(&mut self) -> bool {
        self.starts += 1;
        let mut vector = random(self.starts, self.mass.nrows());
        let before = length(self.mass, &vector);
        self.orthogonalise(&mut vector, 0);
        length(self.mass, &vector) <= INVARIANT * before
    }

    fn random(&mut self) -> Pending {
        self.starts += 1;
        // once through the operator: nothing is left that has no mass
        let mut vector = symmetric_product(self.mass, &random(self.starts, self.mass.nrows()));
        self.factor.solve(&mut vector);
        let length = length(self.mass, &vector);
        Pending { vector, length, from: None, orthogonal_to: 0 }
    }

    /// Takes out the shares of the vectors of the basis from one on, which come back. Twice is enough (W. Kahan, B. N. Parlett).
    fn orthogonalise(&self, vector: &mut [f64], first: usize) -> Vec<f64> {
        let (basis, with_mass) = (&self.basis[first..], &self.with_mass[first..]);
        let mut total = vec![0.0; basis.len()];
        if basis.is_empty() {
            return total;
        }
        for _ in 0..2 {
            let shares: Vec<f64> = parallel::each(with_mass, |with_mass| dot(vector, with_mass));
            vector.par_chunks_mut(CHUNK).enumerate().for_each(|(k, chunk)| {
                for (basis, share) in basis.iter().zip(&shares) {
                    for (v, b) in chunk.iter_mut().zip(&basis[k * CHUNK..]) {
                        *v -= share * b;
                    }
                }
            });
            for (total, share) in total.iter_mut().zip(&shares) {
                *total += share;
            }
        }
        total
    }

    /// The converged eigenvalues.
    fn ritz(&self) -> Result<RitzVectors, StructureError> {
        let size = self.basis.len();
        let projected = Mat::from_fn(size, size, |i, j| self.projected[i.max(j)][i.min(j)]);
        let Eigen { values: inverse, vectors } =
            symmetric(&projected).ok_or(StructureError::MissingModes { wanted: size })?;
        let residual = |k: usize| -> f64 {
            let open = self.pending.iter().filter_map(|pending| Some((pending.from?, pending.length)));
            open.map(|(from, length)| (length * vectors[(from, k)]).abs()).sum()
        };
        let has_converged = |k: &usize| inverse[*k] > 0.0 && residual(*k) <= TOLERANCE * inverse[*k];
        // the largest eigenvalues of the inverse are the lowest of the structure
        let columns: Vec<usize> = (0..size).rev().take_while(has_converged).collect();
        // some eigenvalue lies as near as the residual tells
        let next = size
            .checked_sub(columns.len() + 1)
            .map(|k| inverse[k] + residual(k))
            .filter(|value| *value > 0.0);
        Ok(RitzVectors {
            next: next.map(|value| self.shift + 1.0 / value),
            values: columns.iter().map(|k| self.shift + 1.0 / inverse[*k]).collect(),
            vectors: columns.iter().map(|k| (0..size).map(|i| vectors[(i, *k)]).collect()).collect(),
        })
    }

    /// What the operator makes of a Ritz vector, over its eigenvalue: the vector and what is outside the basis, which has less of
    /// the high modes in it than the vector alone. It takes no solution.
    fn iterated(&self, shares: &[f64], value: f64) -> Vec<f64> {
        let mut shape = combined(&self.basis, |k| shares[k]);
        for pending in &self.pending {
            let share = pending.from.map_or(0.0, |from| shares[from] * (value - self.shift));
            for (s, v) in shape.iter_mut().zip(&pending.vector) {
                *s += share * v;
            }
        }
        shape
    }
}

/// The distance of the shift to the eigenvalue nearest it, from above: some steps of the power method on the operator.
pub(super) fn nearest(factor: &SymmetricFactor, mass: &Sparse) -> f64 {
    /// Enough to see an eigenvalue that is a thousand times nearer than the next.
    const STEPS: usize = 4;
    let mut vector = random(0, mass.nrows());
    let mut growth = 0.0;
    for _ in 0..STEPS {
        let before = length(mass, &vector);
        for value in &mut vector {
            *value /= before;
        }
        vector = symmetric_product(mass, &vector);
        factor.solve(&mut vector);
        growth = length(mass, &vector);
    }
    1.0 / growth
}

fn random(stream: u64, size: usize) -> Vec<f64> {
    (0..size as u64).map(|k| uniform(stream, k) - 0.5).collect()
}

/// In the inner product of the mass.
fn length(mass: &Sparse, vector: &[f64]) -> f64 {
    dot(vector, &symmetric_product(mass, vector)).max(0.0).sqrt()
}

/// Eigenvalues by rising size, with shapes.
pub(super) struct LanczosModes {
    pub(super) values: Vec<f64>,
    pub(super) shapes: Vec<Vec<f64>>,
    /// A value near above which the next seems to lie; `None` where there is none.
    pub(super) next: Option<f64>,
    /// Whether there are no others above the shift, but infinite ones of freedoms without mass.
    pub(super) is_whole: bool,
}

/// Σ shares of vectors.
pub(super) fn combined(vectors: &[Vec<f64>], share: impl Fn(usize) -> f64 + Sync) -> Vec<f64> {
    let mut sum = vec![0.0; vectors.first().map_or(0, Vec::len)];
    sum.par_chunks_mut(CHUNK).enumerate().for_each(|(chunk, sum)| {
        for (k, vector) in vectors.iter().enumerate() {
            let share = share(k);
            for (s, v) in sum.iter_mut().zip(&vector[chunk * CHUNK..]) {
                *s += share * v;
            }
        }
    });
    sum
}

/// Eigenvalues λ by rising size, with their coordinates in the basis.
struct RitzVectors {
    next: Option<f64>,
    values: Vec<f64>,
    vectors: Vec<Vec<f64>>,
}
