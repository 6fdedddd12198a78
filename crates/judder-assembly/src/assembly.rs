//! Structures that touch: matrices on the freedoms of all, loads, interfaces.

use crate::AssemblyError;
use crate::friction::Friction;
use crate::interface::{FramedPoint, Interface, InterfaceLaw};
use crate::row::Row;
use faer::sparse::Triplet;
use faer::sparse::ops::add;
use judder_structure::assembly::Sparse;
use std::sync::Arc;

/// Bodies that touch at any number of contact points.
///
/// M q̈ + (C + Σ G) q̇ + K q = f + Σ (N n + T) over the contact points, on the freedoms of all bodies one after the other. Assemblies of the same
/// bodies share their matrices.
#[derive(Debug, Clone)]
pub struct Assembly {
    /// M in kg.
    pub mass: Arc<Sparse>,
    /// C in N s/m, of the structures alone.
    pub damping: Arc<Sparse>,
    /// K in N/m, of the structures alone: of bodies that turn with what turning adds and takes, unsymmetric where they bring circulation.
    pub stiffness: Arc<Sparse>,
    /// G of each body that turns.
    pub gyroscopic: Vec<Gyroscopic>,
    /// f in N, with what imposed displacements do.
    pub load: Vec<f64>,
    /// Where the bodies touch.
    pub interfaces: Vec<Interface>,
}

/// The forces of a body that turns which follow its velocities.
#[derive(Debug, Clone)]
pub struct Gyroscopic {
    /// The name of the body.
    pub body: String,
    /// G in N s/m, skew, on the freedoms of all bodies.
    pub matrix: Arc<Sparse>,
}

impl Assembly {
    /// Freedoms of all bodies.
    #[must_use]
    pub fn size(&self) -> usize {
        self.load.len()
    }

    /// Refuses friction on tracks at rest, which has no direction.
    ///
    /// # Errors
    /// [`AssemblyError::AtRest`].
    pub fn check_sliding(&self) -> Result<(), AssemblyError> {
        match self.interfaces.iter().find(|own| own.rests_with_friction()) {
            Some(own) => Err(AssemblyError::AtRest { interface: own.name.clone() }),
            None => Ok(()),
        }
    }

    /// The same without friction on tracks at rest, of all states that it may hold the one in which it holds nothing; `None` where none rests so.
    #[must_use]
    pub fn without_friction_at_rest(&self) -> Option<Self> {
        self.check_sliding().err()?;
        let mut smooth = self.clone();
        for own in smooth.interfaces.iter_mut().filter(|own| own.rests_with_friction()) {
            if let InterfaceLaw::Rigid(friction) | InterfaceLaw::Compliant(_, friction) = &mut own.law {
                *friction = Friction::Constant(0.0);
            }
        }
        Some(smooth)
    }

    /// The contact points of all interfaces in their order, in their frames.
    ///
    /// # Errors
    /// [`AssemblyError::UnknownFreedom`], [`AssemblyError::Length`] for matrices of another size than the load, and what is wrong
    /// with an interface.
    pub fn framed(&self) -> Result<Vec<FramedPoint<'_>>, AssemblyError> {
        let gyroscopic = self.gyroscopic.iter().map(|own| ("rows of a gyroscopic matrix", &own.matrix));
        let all = [
            ("rows of the mass", &self.mass),
            ("rows of the damping", &self.damping),
            ("rows of the stiffness", &self.stiffness),
        ];
        for (name, matrix) in all.into_iter().chain(gyroscopic) {
            if let Some(found) =
                [matrix.nrows(), matrix.ncols()].into_iter().find(|found| *found != self.size())
            {
                return Err(AssemblyError::Length { name, found, expected: self.size() });
            }
        }
        let mut all = Vec::new();
        for (number, interface) in self.interfaces.iter().enumerate() {
            let freedoms = interface.points.iter().flat_map(|point| &point.relative).flat_map(Row::entries);
            if let Some((freedom, _)) = freedoms.into_iter().find(|(freedom, _)| *freedom >= self.size()) {
                let (interface, freedoms) = (interface.name.clone(), self.size());
                return Err(AssemblyError::UnknownFreedom { interface, freedom: *freedom, freedoms });
            }
            all.extend(interface.framed(number)?);
        }
        Ok(all)
    }
}

/// Matrices of bodies as one, each body's freedoms after those of the bodies before it.
///
/// # Errors
/// [`AssemblyError::Structure`] where it does not fit into memory.
pub fn stacked(parts: &[&Sparse]) -> Result<Sparse, AssemblyError> {
    let (mut first, mut entries) = (0, Vec::new());
    for part in parts {
        for column in 0..part.ncols() {
            let values = part.row_idx_of_col(column).zip(part.val_of_col(column));
            entries.extend(values.map(|(row, value)| Triplet::new(first + row, first + column, *value)));
        }
        first += part.nrows();
    }
    from_triplets(first, first, &entries)
}

/// A matrix of one body among the freedoms of all, which are so many; its own begin at `first`.
///
/// # Errors
/// [`AssemblyError::Structure`] where it does not fit into memory.
pub fn placed(matrix: &Sparse, first: usize, all: usize) -> Result<Sparse, AssemblyError> {
    let moved = triplets(matrix).map(|entry| Triplet::new(first + entry.row, first + entry.col, entry.val));
    from_triplets(all, all, &moved.collect::<Vec<_>>())
}

/// A matrix and others of its size, added.
///
/// # Errors
/// [`AssemblyError::Structure`] where it does not fit into memory.
pub fn sum<'a>(
    first: &Sparse,
    mut others: impl Iterator<Item = &'a Sparse>,
) -> Result<Sparse, AssemblyError> {
    let rows = first.nrows();
    let added = others.try_fold(first.clone(), |sum, other| add(sum.as_ref(), other.as_ref()));
    added.map_err(|_| judder_structure::StructureError::OutOfMemory { rows }.into())
}

/// Whether a matrix is its own transpose but for rounding, that is measured by the largest entries of the rows: bodies of different
/// stiffness stand in one matrix.
#[must_use]
pub fn is_symmetric(matrix: &Sparse) -> bool {
    /// What reductions leave is a hundred times less.
    const ROUNDING: f64 = 1e-11;
    let mut largest = vec![0.0_f64; matrix.nrows()];
    for entry in triplets(matrix) {
        for k in [entry.row, entry.col] {
            largest[k] = largest[k].max(entry.val.abs());
        }
    }
    triplets(matrix).all(|entry| {
        let mirrored = matrix.get(entry.col, entry.row).copied().unwrap_or(0.0);
        (mirrored - entry.val).abs() <= ROUNDING * largest[entry.row].max(largest[entry.col])
    })
}

/// (A + Aᵀ)/2.
///
/// # Errors
/// [`AssemblyError::Structure`] where it does not fit into memory.
pub fn symmetric_part(matrix: &Sparse) -> Result<Sparse, AssemblyError> {
    let halves = |entry: Triplet<usize, usize, f64>| {
        let half = 0.5 * entry.val;
        [Triplet::new(entry.row, entry.col, half), Triplet::new(entry.col, entry.row, half)]
    };
    let entries: Vec<_> = triplets(matrix).flat_map(halves).collect();
    from_triplets(matrix.nrows(), matrix.ncols(), &entries)
}

/// The entries of a matrix.
pub fn triplets(matrix: &Sparse) -> impl Iterator<Item = Triplet<usize, usize, f64>> + '_ {
    let of_column = |column: usize| {
        let values = matrix.row_idx_of_col(column).zip(matrix.val_of_col(column));
        values.map(move |(row, value)| Triplet::new(row, column, *value))
    };
    (0..matrix.ncols()).flat_map(of_column)
}

/// A sparse matrix from its entries; those of one place are added.
pub fn from_triplets(
    rows: usize,
    columns: usize,
    entries: &[Triplet<usize, usize, f64>],
) -> Result<Sparse, AssemblyError> {
    let made = Sparse::try_new_from_triplets(rows, columns, entries);
    made.map_err(|_| judder_structure::StructureError::OutOfMemory { rows }.into())
}
