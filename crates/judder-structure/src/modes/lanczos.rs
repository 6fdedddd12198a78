//! Lanczos' method on (K − σ M)⁻¹ M, which is symmetric in the inner product of M.

use crate::StructureError;
use crate::assembly::Sparse;
use crate::dense::{Eigen, symmetric};
use crate::factor::SymmetricFactor;
use crate::statics::{dot, product};
use faer::Mat;
use judder_numerics::counter::uniform;

/// A Krylov basis that grows until enough eigenvalues have converged.
pub(super) struct Lanczos<'a> {
    factor: &'a SymmetricFactor,
    mass: &'a Sparse,
    shift: f64,
    /// Orthonormal in M.
    basis: Vec<Vec<f64>>,
    /// M times each.
    with_mass: Vec<Vec<f64>>,
    /// The projected operator: diagonal, and what couples each vector to the next.
    diagonal: Vec<f64>,
    coupling: Vec<f64>,
    /// What the next vector is made of, and its length in M.
    next: Option<(Vec<f64>, f64)>,
    starts: u64,
}

/// An eigenvalue λ counts as converged where the residual of (K − σM)⁻¹M over its eigenvalue is below it.
const TOLERANCE: f64 = 1e-13;
/// A new vector shorter than this share of what it was made of lies in the basis: the space is invariant.
const INVARIANT: f64 = 1e-10;
/// Vectors between looks at the eigenvalues.
const STRIDE: usize = 5;

impl<'a> Lanczos<'a> {
    pub(super) fn new(factor: &'a SymmetricFactor, mass: &'a Sparse, shift: f64) -> Self {
        Self {
            factor,
            mass,
            shift,
            basis: Vec::new(),
            with_mass: Vec::new(),
            diagonal: Vec::new(),
            coupling: Vec::new(),
            next: None,
            starts: 0,
        }
    }

    /// Goes on from a random vector: what the space so far has missed is in it.
    pub(super) fn start_anew(&mut self) {
        self.next = None;
    }

    /// The eigenvalues nearest above the shift, so many at least, with shapes of unit modal mass, by rising eigenvalue.
    pub(super) fn converged(&mut self, count: usize) -> Result<Vec<(f64, Vec<f64>)>, StructureError> {
        let size = self.mass.nrows();
        loop {
            for _ in 0..STRIDE {
                if self.basis.len() < size {
                    self.grow()?;
                }
            }
            let ritz = self.ritz()?;
            if ritz.values.len() >= count || self.basis.len() == size {
                let pairs = ritz.values.iter().enumerate();
                return pairs.map(|(k, value)| Ok((*value, self.shape(&ritz, k)?))).collect();
            }
        }
    }

    /// One more vector.
    fn grow(&mut self) -> Result<(), StructureError> {
        let (mut vector, length) = match self.next.take() {
            Some(next) => next,
            None => self.random_vector()?,
        };
        if !self.basis.is_empty() {
            self.coupling.push(length);
        }
        let mut with_mass = product(self.mass, &vector);
        for v in vector.iter_mut().chain(&mut with_mass) {
            *v /= if length == 0.0 { 1.0 } else { length };
        }
        let mut image = with_mass.clone();
        self.factor.solve(&mut image)?;
        self.diagonal.push(dot(&image, &with_mass));
        self.basis.push(vector);
        self.with_mass.push(with_mass);
        let before = self.length_in_mass(&image);
        self.orthogonalise(&mut image);
        let after = self.length_in_mass(&image);
        // an invariant space couples to nothing: the next vector is a new start
        self.next = (after > INVARIANT * before).then_some((image, after));
        Ok(())
    }

    /// A random vector outside the basis; it is not coupled to it.
    fn random_vector(&mut self) -> Result<(Vec<f64>, f64), StructureError> {
        let size = self.mass.nrows();
        self.starts += 1;
        let mut vector: Vec<f64> = (0..size as u64).map(|k| uniform(self.starts, k) - 0.5).collect();
        // once through the operator: nothing is left that has no mass
        vector = product(self.mass, &vector);
        self.factor.solve(&mut vector)?;
        self.orthogonalise(&mut vector);
        let length = self.length_in_mass(&vector);
        for v in &mut vector {
            *v /= length;
        }
        Ok((vector, 0.0))
    }

    /// Twice is enough (W. Kahan, B. N. Parlett).
    fn orthogonalise(&self, vector: &mut [f64]) {
        for _ in 0..2 {
            for (basis, with_mass) in self.basis.iter().zip(&self.with_mass) {
                let share = dot(vector, with_mass);
                for (v, b) in vector.iter_mut().zip(basis) {
                    *v -= share * b;
                }
            }
        }
    }

    fn length_in_mass(&self, vector: &[f64]) -> f64 {
        dot(vector, &product(self.mass, vector)).max(0.0).sqrt()
    }

    /// The converged eigenvalues.
    fn ritz(&self) -> Result<Ritz, StructureError> {
        let size = self.basis.len();
        let tridiagonal = Mat::from_fn(size, size, |i, j| match i.abs_diff(j) {
            0 => self.diagonal[i],
            1 => self.coupling[i.min(j)],
            _ => 0.0,
        });
        let Eigen { values: inverse, vectors } =
            symmetric(&tridiagonal).ok_or(StructureError::MissingModes { wanted: size })?;
        let open = self.next.as_ref().map_or(0.0, |(_, length)| *length);
        let has_converged = |k: &usize| {
            inverse[*k] > 0.0 && (open * vectors[(size - 1, *k)]).abs() <= TOLERANCE * inverse[*k]
        };
        // the largest eigenvalues of the inverse are the lowest of the structure
        let columns: Vec<usize> = (0..size).rev().take_while(has_converged).collect();
        Ok(Ritz {
            values: columns.iter().map(|k| self.shift + 1.0 / inverse[*k]).collect(),
            vectors: columns.iter().map(|k| (0..size).map(|i| vectors[(i, *k)]).collect()).collect(),
        })
    }

    /// A shape of unit modal mass, once more through the operator: that leaves less of the high modes in it.
    fn shape(&self, ritz: &Ritz, k: usize) -> Result<Vec<f64>, StructureError> {
        let mut shape = vec![0.0; self.mass.nrows()];
        for (basis, share) in self.basis.iter().zip(&ritz.vectors[k]) {
            for (s, b) in shape.iter_mut().zip(basis) {
                *s += share * b;
            }
        }
        shape = product(self.mass, &shape);
        self.factor.solve(&mut shape)?;
        let length = self.length_in_mass(&shape);
        for s in &mut shape {
            *s /= length;
        }
        Ok(shape)
    }
}

/// Eigenvalues λ by rising size, with their coordinates in the basis.
struct Ritz {
    values: Vec<f64>,
    vectors: Vec<Vec<f64>>,
}
