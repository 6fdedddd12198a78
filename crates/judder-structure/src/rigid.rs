//! Which eigenvalues are those of rigid motions: zero but for rounding.

use crate::assembly::Sparse;

/// The value up to which an eigenvalue of K φ = λ M φ is that of a rigid motion, ε √n λ_max in 1/s²: what rounding makes of zero.
///
/// n are the rows of the matrices and λ_max their largest eigenvalue, or a bound of it such as [`largest_ratio`]. Every entry is
/// rounded by a share ε of itself, and what n rows leave adds up as the root of their number. An elastic mode that lies below is not
/// told from a rigid motion in this precision.
#[must_use]
pub fn rigid_limit(rows: usize, largest: f64) -> f64 {
    f64::EPSILON * (rows as f64).sqrt() * largest.max(0.0)
}

/// max Kᵢᵢ/Mᵢᵢ over the rows with mass, in 1/s²: the largest eigenvalue is no smaller (Rayleigh's quotient of one displacement).
#[must_use]
pub fn largest_ratio(stiffness: &Sparse, mass: &Sparse) -> f64 {
    let diagonal = |matrix: &Sparse, k: usize| matrix.get(k, k).copied().unwrap_or(0.0);
    let ratio = |k| {
        let of_mass = diagonal(mass, k);
        if of_mass > 0.0 { diagonal(stiffness, k) / of_mass } else { 0.0 }
    };
    (0..stiffness.nrows().min(mass.nrows())).map(ratio).fold(0.0, f64::max)
}
