//! The shape in which a coupled pair swings.

use crate::coupling::{Coupling, product};
use judder_numerics::complex::ElementaryComplex;
use num_complex::Complex64;

/// The shape of the mode of an eigenvalue s in modal coordinates, under a normal force of 1 N.
///
/// q_i = (e_i N + Σ b_ki y_k)/(s² + d_i s + λ_i), where the feedbacks y_k = r_k q, or s r_k q, follow from the shape itself.
#[must_use]
pub fn mode_shape(coupling: &Coupling, eigenvalues: &[f64], damping: &[f64], s: Complex64) -> Vec<Complex64> {
    let yields: Vec<Complex64> =
        eigenvalues.iter().zip(damping).map(|(value, d)| 1.0 / (s * s + d * s + value)).collect();
    let sees = |row: &[f64], column: &[f64]| -> Complex64 {
        row.iter().zip(column).zip(&yields).map(|((r, c), y)| r * c * y).sum()
    };
    let factor = |velocity: bool| if velocity { s } else { Complex64::ONE };
    let rows = coupling.feedback.iter().map(|feedback| {
        let factor = factor(feedback.follows_velocity);
        let mut row: Vec<Complex64> =
            coupling.feedback.iter().map(|other| -factor * sees(&feedback.row, &other.column)).collect();
        row.push(factor * sees(&feedback.row, &coupling.equilibrium));
        row
    });
    let mut system: Vec<Vec<Complex64>> = rows.collect();
    for (k, row) in system.iter_mut().enumerate() {
        row[k] += 1.0;
    }
    let feedbacks = solved(system);
    let pushed = |mode: usize| {
        let of_feedback = coupling.feedback.iter().zip(&feedbacks).map(|(f, y)| f.column[mode] * y);
        coupling.equilibrium[mode] + of_feedback.sum::<Complex64>()
    };
    yields.iter().enumerate().map(|(mode, y)| y * pushed(mode)).collect()
}

/// c q of a shape, relative to what its modes give without cancelling: 0 where s is an eigenvalue.
#[must_use]
pub fn gap_residual(coupling: &Coupling, shape: &[Complex64]) -> f64 {
    let [re, im]: [Vec<f64>; 2] =
        [shape.iter().map(|q| q.re).collect(), shape.iter().map(|q| q.im).collect()];
    let gap = Complex64::new(product(&coupling.compatibility, &re), product(&coupling.compatibility, &im));
    let size: f64 = coupling.compatibility.iter().zip(shape).map(|(c, q)| (c * q).modulus()).sum();
    gap.modulus() / size
}

/// The solution of a small system whose last column is the right-hand side.
fn solved(mut rows: Vec<Vec<Complex64>>) -> Vec<Complex64> {
    let size = rows.len();
    for k in 0..size {
        let pivot =
            (k..size).max_by(|a, b| rows[*a][k].modulus().total_cmp(&rows[*b][k].modulus())).unwrap_or(k);
        rows.swap(k, pivot);
        let pivot = rows[k].clone();
        for (_, row) in rows.iter_mut().enumerate().filter(|(i, _)| *i != k) {
            let factor = row[k] / pivot[k];
            for (entry, taken) in row.iter_mut().zip(&pivot) {
                *entry -= factor * taken;
            }
        }
    }
    rows.iter().enumerate().map(|(k, row)| row[size] / row[k]).collect()
}
