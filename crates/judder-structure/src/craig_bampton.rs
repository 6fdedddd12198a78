//! The Craig–Bampton reduction: the freedoms that are kept, and the lowest modes of the rest with these held.
//!
//! R. R. Craig and M. C. C. Bampton, *Coupling of substructures for dynamic analyses*, AIAA Journal 6 (1968).

use crate::StructureError;
use crate::assembly::Sparse;
use crate::definiteness::admit_mass;
use crate::factor::SymmetricFactor;
use crate::modes::{Mode, WantedModes, modes};
use crate::statics::symmetric_product;
use faer::linalg::matmul::matmul;
use faer::sparse::Triplet;
use faer::{Accum, Mat, Par};
use judder_numerics::parallel;
use rayon::prelude::*;
use std::f64::consts::TAU;

/// Where modes are cut off.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum CutOff {
    /// So many, the lowest, are kept.
    Count(usize),
    /// Those below a frequency in Hz are kept.
    Frequency(f64),
}

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
    /// How many freedoms are kept.
    pub kept: usize,
    /// What the fixed-interface modes that were left out would do.
    pub left_out: LeftOut,
}

/// The fixed-interface modes that were left out, as the kept freedoms feel them.
///
/// They make the dynamic stiffness of the kept freedoms smaller by λ² Σ mⱼ mⱼᵀ/(Ωⱼ² − λ) with mⱼ = (M_bi + Ψᵀ M_ii) φⱼ, which for
/// λ far below all Ωⱼ² is λ² G. Static loads do not move them: the static flexibility of a reduced structure is exact.
#[derive(Debug, Clone)]
pub struct LeftOut {
    /// G = Σ mⱼ mⱼᵀ/Ωⱼ² in kg s², kept².
    pub inertia: Mat<f64>,
    /// A value in 1/s² that no left-out Ω² lies below; infinite where none was left out.
    pub from: f64,
}

impl CraigBampton {
    /// Reduces a structure to kept freedoms and the fixed-interface modes below a cut-off.
    ///
    /// # Errors
    /// [`StructureError::KeptTwice`] for a freedom that is named twice or is not there, [`StructureError::Singular`] where the rest
    /// can move without force while the kept freedoms are held, [`StructureError::IndefiniteMass`], what [`modes`] says of the rest.
    pub fn new(
        stiffness: &Sparse,
        mass: &Sparse,
        kept: &[usize],
        cut_off: CutOff,
    ) -> Result<Self, StructureError> {
        let parts = FreedomParts::new(stiffness.nrows(), kept)?;
        // that of the rest alone may be positive where the whole is not
        admit_mass(mass, f64::INFINITY)?;
        let (inner_stiffness, inner_mass) = (parts.inner(stiffness)?, parts.inner(mass)?);
        let (fixed_interface, from) = fixed_interface(&inner_stiffness, &inner_mass, cut_off)?;
        let factor = SymmetricFactor::new(&inner_stiffness)?;
        let constraints = parts.constraint_modes(stiffness, &factor);
        let shapes = fixed_interface.iter().map(|mode| parts.outspread(&mode.shape));
        let columns: Vec<Vec<f64>> = constraints.into_iter().chain(shapes).collect();
        let images = |matrix: &Sparse| -> Vec<Vec<f64>> {
            parallel::each(&columns, |column| symmetric_product(matrix, column))
        };
        let with_mass = images(mass);
        let loads = parallel::each(&with_mass[..kept.len()], |load| parts.of_inner(load));
        let inertia = match from.is_finite() {
            true => left_out_inertia(loads, &fixed_interface, &inner_mass, &factor),
            false => Mat::zeros(kept.len(), kept.len()),
        };
        Ok(Self {
            mass: symmetric_gram(&columns, &with_mass),
            stiffness: symmetric_gram(&columns, &images(stiffness)),
            basis: Mat::from_fn(stiffness.nrows(), columns.len(), |i, k| columns[k][i]),
            fixed_interface,
            kept: kept.len(),
            left_out: LeftOut { inertia, from },
        })
    }
}

/// The modes below the cut-off, and a value that no other eigenvalue lies below.
fn fixed_interface(
    stiffness: &Sparse,
    mass: &Sparse,
    cut_off: CutOff,
) -> Result<(Vec<Mode>, f64), StructureError> {
    let size = stiffness.nrows();
    if size == 0 {
        return Ok((Vec::new(), f64::INFINITY));
    }
    let mut found = match cut_off {
        CutOff::Count(count) => {
            modes(stiffness, mass, WantedModes::Lowest(count.saturating_add(1).min(size)))?.modes
        }
        CutOff::Frequency(limit) if limit.is_finite() && limit > 0.0 => {
            modes(stiffness, mass, WantedModes::Band(0.0, limit))?.modes
        }
        CutOff::Frequency(value) => {
            let name = "the cut-off frequency";
            return Err(StructureError::InvalidNumber { name, value, requirement: "positive" });
        }
    };
    let from = match cut_off {
        // fewer than were asked for are all that have mass
        CutOff::Count(count) if found.len() <= count => f64::INFINITY,
        CutOff::Count(_) => found.pop().map_or(f64::INFINITY, |mode| mode.eigenvalue),
        CutOff::Frequency(_) if found.len() == size => f64::INFINITY,
        CutOff::Frequency(limit) => (TAU * limit).powi(2),
    };
    Ok((found, from))
}

/// G = mᵀ K_ii⁻¹ m, where m are the loads less what the kept modes take of them.
fn left_out_inertia(
    mut loads: Vec<Vec<f64>>,
    fixed_interface: &[Mode],
    inner_mass: &Sparse,
    factor: &SymmetricFactor,
) -> Mat<f64> {
    let with_mass = parallel::each(fixed_interface, |mode| symmetric_product(inner_mass, &mode.shape));
    loads.par_iter_mut().for_each(|load| {
        for (mode, with_mass) in fixed_interface.iter().zip(&with_mass) {
            let share: f64 = load.iter().zip(&mode.shape).map(|(m, u)| m * u).sum();
            for (m, w) in load.iter_mut().zip(with_mass) {
                *m -= share * w;
            }
        }
    });
    let moved: Vec<Vec<f64>> = parallel::each(&loads, |load| {
        let mut moved = load.clone();
        factor.solve(&mut moved);
        moved
    });
    symmetric_gram(&loads, &moved)
}

/// aᵢ · bⱼ, symmetric but for rounding, which is taken out.
fn symmetric_gram(a: &[Vec<f64>], b: &[Vec<f64>]) -> Mat<f64> {
    /// Rows that are worked together, in pieces that do not depend on the number of threads.
    const CHUNK: usize = 2048;
    let (count, rows) = (a.len(), a.first().map_or(0, Vec::len));
    let partial = |chunk: usize| {
        let (start, end) = (chunk * CHUNK, rows.min((chunk + 1) * CHUNK));
        let piece = |of: &[Vec<f64>]| Mat::from_fn(end - start, count, |i, k| of[k][start + i]);
        let mut product = Mat::zeros(count, count);
        matmul(&mut product, Accum::Replace, piece(a).transpose(), piece(b), 1.0, Par::Seq);
        product
    };
    // few at a time: each is as large as the sum
    let mut sum = Mat::<f64>::zeros(count, count);
    let chunks: Vec<usize> = (0..rows.div_ceil(CHUNK)).collect();
    for group in chunks.chunks(8) {
        let partials: Vec<Mat<f64>> = parallel::each(group, |chunk| partial(*chunk));
        for partial in &partials {
            sum += partial;
        }
    }
    Mat::from_fn(count, count, |i, j| 0.5 * (sum[(i, j)] + sum[(j, i)]))
}

/// Which freedoms are kept, and which are not.
struct FreedomParts<'a> {
    kept: &'a [usize],
    is_kept: Vec<bool>,
    inner: Vec<usize>,
    /// The number of each freedom among those that are not kept.
    number: Vec<usize>,
}

impl<'a> FreedomParts<'a> {
    fn new(size: usize, kept: &'a [usize]) -> Result<Self, StructureError> {
        let mut is_kept = vec![false; size];
        for freedom in kept {
            match is_kept.get_mut(*freedom) {
                Some(place @ false) => *place = true,
                _ => return Err(StructureError::KeptTwice { freedom: *freedom, freedoms: size }),
            }
        }
        let inner: Vec<usize> = (0..size).filter(|k| !is_kept[*k]).collect();
        let mut number = vec![0; size];
        for (k, freedom) in inner.iter().enumerate() {
            number[*freedom] = k;
        }
        Ok(Self { kept, is_kept, inner, number })
    }

    /// The part of a matrix on the freedoms that are not kept.
    fn inner(&self, matrix: &Sparse) -> Result<Sparse, StructureError> {
        let size = self.inner.len();
        let mut entries = Vec::new();
        for column in &self.inner {
            for (row, value) in matrix.row_idx_of_col(*column).zip(matrix.val_of_col(*column)) {
                if !self.is_kept[row] {
                    entries.push(Triplet::new(self.number[row], self.number[*column], *value));
                }
            }
        }
        Sparse::try_new_from_triplets(size, size, &entries)
            .map_err(|_| StructureError::OutOfMemory { rows: size })
    }

    fn of_inner(&self, values: &[f64]) -> Vec<f64> {
        self.inner.iter().map(|freedom| values[*freedom]).collect()
    }

    /// Values on the freedoms that are not kept, zero on the others.
    fn outspread(&self, values: &[f64]) -> Vec<f64> {
        let mut all = vec![0.0; self.is_kept.len()];
        for (freedom, value) in self.inner.iter().zip(values) {
            all[*freedom] = *value;
        }
        all
    }

    /// The columns (I, Ψ).
    fn constraint_modes(&self, stiffness: &Sparse, factor: &SymmetricFactor) -> Vec<Vec<f64>> {
        let of = |freedom: &usize| {
            let mut load = vec![0.0; self.inner.len()];
            let values = stiffness.val_of_col(*freedom);
            for (row, value) in stiffness.row_idx_of_col(*freedom).zip(values) {
                if !self.is_kept[row] {
                    load[self.number[row]] = -value;
                }
            }
            factor.solve(&mut load);
            let mut all = self.outspread(&load);
            all[*freedom] = 1.0;
            all
        };
        parallel::each(self.kept, of)
    }
}
