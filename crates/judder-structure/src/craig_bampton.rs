//! Craig–Bampton reduction: the freedoms that are kept, and the lowest modes of the rest with these held.
//!
//! R. R. Craig and M. C. C. Bampton, *Coupling of substructures for dynamic analyses*, AIAA Journal 6 (1968).

use crate::StructureError;
use crate::assembly::Sparse;
use crate::dense::{Eigen, generalised};
use crate::factor::SymmetricFactor;
use crate::modes::{Mode, Wanted, modes};
use crate::statics::product;
use faer::Mat;
use faer::sparse::Triplet;

/// A structure on its kept freedoms and its fixed-interface modes.
///
/// u = T q with q = (u_b, η): on the kept freedoms u = u_b, on the others u = Ψ u_b + Φ η, where Ψ = −K_ii⁻¹ K_ib are the
/// constraint modes and Φ the modes of K_ii, M_ii.
#[derive(Debug, Clone)]
pub struct CraigBampton {
    /// Mᵣ = Tᵀ M T in kg, (kept + modes)², kept freedoms first in the order in which they were named.
    pub mass: Mat<f64>,
    /// Kᵣ = Tᵀ K T in N/m, of the same shape.
    pub stiffness: Mat<f64>,
    /// T, all freedoms by reduced coordinates.
    pub basis: Mat<f64>,
    /// The fixed-interface modes, their shapes on the freedoms that are not kept.
    pub fixed_interface: Vec<Mode>,
}

impl CraigBampton {
    /// Reduces a structure to kept freedoms and so many fixed-interface modes.
    ///
    /// # Errors
    /// [`StructureError::KeptTwice`] for a freedom that is named twice or is not there, what [`modes`] says of the rest.
    pub fn new(
        stiffness: &Sparse,
        mass: &Sparse,
        kept: &[usize],
        count: usize,
    ) -> Result<Self, StructureError> {
        let size = stiffness.nrows();
        let role = roles(size, kept)?;
        let inner: Vec<usize> = (0..size).filter(|k| role[*k].is_none()).collect();
        let mut number = vec![0; size];
        for (k, freedom) in inner.iter().enumerate() {
            number[*freedom] = k;
        }
        let part = |matrix: &Sparse| inner_part(matrix, &role, &number, inner.len());
        let (inner_stiffness, inner_mass) = (part(stiffness)?, part(mass)?);
        let fixed_interface = modes(&inner_stiffness, &inner_mass, Wanted::Lowest(count))?.modes;
        let factor = SymmetricFactor::new(&inner_stiffness)?;
        let mut basis = Mat::zeros(size, kept.len() + fixed_interface.len());
        for (column, freedom) in kept.iter().enumerate() {
            basis[(*freedom, column)] = 1.0;
            let mut load = vec![0.0; inner.len()];
            let values = stiffness.val_of_col(*freedom);
            for (row, value) in stiffness.row_idx_of_col(*freedom).zip(values) {
                if role[row].is_none() {
                    load[number[row]] = -value;
                }
            }
            factor.solve(&mut load);
            for (freedom, value) in inner.iter().zip(&load) {
                basis[(*freedom, column)] = *value;
            }
        }
        for (column, mode) in fixed_interface.iter().enumerate() {
            for (freedom, value) in inner.iter().zip(&mode.shape) {
                basis[(*freedom, kept.len() + column)] = *value;
            }
        }
        let reduced = |matrix: &Sparse| projected(matrix, &basis);
        Ok(Self { mass: reduced(mass), stiffness: reduced(stiffness), basis, fixed_interface })
    }

    /// Its modal form: eigenvalues ω² by rising size and shapes Q in reduced coordinates with Qᵀ Mᵣ Q = I, Qᵀ Kᵣ Q = diag ω².
    ///
    /// # Errors
    /// [`StructureError::NoModalForm`] where the mass is not positive definite.
    pub fn modal_form(&self) -> Result<(Vec<f64>, Mat<f64>), StructureError> {
        let eigen = generalised(self.stiffness.clone(), &self.mass);
        let Eigen { values, vectors } = eigen.ok_or(StructureError::NoModalForm)?;
        Ok((values, vectors))
    }
}

/// The place of each freedom among the kept ones.
fn roles(size: usize, kept: &[usize]) -> Result<Vec<Option<usize>>, StructureError> {
    let mut roles = vec![None; size];
    for (place, freedom) in kept.iter().enumerate() {
        match roles.get_mut(*freedom) {
            Some(role @ None) => *role = Some(place),
            _ => return Err(StructureError::KeptTwice { freedom: *freedom, freedoms: size }),
        }
    }
    Ok(roles)
}

/// The part of a matrix on the freedoms that are not kept.
fn inner_part(
    matrix: &Sparse,
    role: &[Option<usize>],
    number: &[usize],
    size: usize,
) -> Result<Sparse, StructureError> {
    let mut entries = Vec::new();
    for column in (0..matrix.ncols()).filter(|k| role[*k].is_none()) {
        for (row, value) in matrix.row_idx_of_col(column).zip(matrix.val_of_col(column)) {
            if role[row].is_none() {
                entries.push(Triplet::new(number[row], number[column], *value));
            }
        }
    }
    Sparse::try_new_from_triplets(size, size, &entries)
        .map_err(|_| StructureError::OutOfMemory { rows: size })
}

/// Tᵀ A T.
fn projected(matrix: &Sparse, basis: &Mat<f64>) -> Mat<f64> {
    let column = |k: usize| -> Vec<f64> { (0..basis.nrows()).map(|i| basis[(i, k)]).collect() };
    let images: Vec<Vec<f64>> = (0..basis.ncols()).map(|k| product(matrix, &column(k))).collect();
    let image = Mat::from_fn(basis.nrows(), basis.ncols(), |i, k| images[k][i]);
    let product = basis.transpose() * &image;
    // symmetric but for rounding
    Mat::from_fn(basis.ncols(), basis.ncols(), |i, j| 0.5 * (product[(i, j)] + product[(j, i)]))
}
