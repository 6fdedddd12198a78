//! Lanczos' method on (K − σ M)⁻¹ M, which is symmetric in the inner product of M.

use crate::StructureError;
use crate::assembly::Sparse;
use crate::dense::{Eigen, symmetric};
use crate::factor::SymmetricFactor;
use crate::statics::{dot, product};
use faer::Mat;
use judder_numerics::counter::uniform;
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
}

/// What the operator makes of a vector outside the basis, or a random start.
struct Pending {
    vector: Vec<f64>,
    /// In M.
    length: f64,
    /// The vector that it comes from.
    from: Option<usize>,
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
            projected: Vec::new(),
            pending: VecDeque::new(),
            starts: 0,
        }
    }

    /// Takes in a random vector: what the space so far has missed is in it.
    pub(super) fn start_anew(&mut self) -> Result<(), StructureError> {
        let random = self.random()?;
        self.pending.push_front(random);
        Ok(())
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
        let vector = self.next_vector()?;
        let with_mass = product(self.mass, &vector);
        let mut image = with_mass.clone();
        self.factor.solve(&mut image);
        self.basis.push(vector);
        self.with_mass.push(with_mass);
        self.projected.push(self.with_mass.iter().map(|with_mass| dot(&image, with_mass)).collect());
        let before = self.length_in_mass(&image);
        self.orthogonalise(&mut image);
        let length = self.length_in_mass(&image);
        if length > INVARIANT * before {
            self.pending.push_back(Pending { vector: image, length, from: Some(self.basis.len() - 1) });
        }
        Ok(())
    }

    /// A vector of unit length outside the basis: of what is pending the first that is not in it by now, else a random one.
    fn next_vector(&mut self) -> Result<Vec<f64>, StructureError> {
        loop {
            let Pending { mut vector, length, from } = match self.pending.pop_front() {
                Some(pending) => pending,
                None => self.random()?,
            };
            self.orthogonalise(&mut vector);
            let left = self.length_in_mass(&vector);
            if left > INVARIANT * length {
                return Ok(vector.iter().map(|v| v / left).collect());
            }
            if from.is_none() {
                return Err(StructureError::MissingModes { wanted: self.basis.len() + 1 });
            }
        }
    }

    fn random(&mut self) -> Result<Pending, StructureError> {
        let size = self.mass.nrows();
        self.starts += 1;
        let vector: Vec<f64> = (0..size as u64).map(|k| uniform(self.starts, k) - 0.5).collect();
        // once through the operator: nothing is left that has no mass
        let mut vector = product(self.mass, &vector);
        self.factor.solve(&mut vector);
        let length = self.length_in_mass(&vector);
        Ok(Pending { vector, length, from: None })
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
        self.factor.solve(&mut shape);
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
