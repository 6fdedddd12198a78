//! How far a zero of D may be from that of the exact function.

use super::{CharacteristicEvaluator, determinant};
use judder_numerics::complex::ElementaryComplex;
use num_complex::Complex64;

/// The precision of the numbers of which D is made, relative: frequencies, damping and shapes come out of eigenproblems.
pub(crate) const PRECISION: f64 = 1e-12;

impl CharacteristicEvaluator<'_> {
    /// How far a zero s is from the exact one, in 1/s: to first order in relative disturbances ε of every ω², d and product,
    ///
    /// δ = ε Σ_ab |C_ab| Σ_i |r_a,i c_b,i| (1/|p_i| + (ω_i² + |d_i s|)/|p_i|²)/|D′(s)|
    ///
    /// with the cofactors C_ab of the matrix whose determinant is D; no less than ε |s|. Infinite where the zero is double.
    pub fn error(&mut self, s: Complex64) -> f64 {
        let slope = self.at(s).slope.modulus();
        let change: f64 =
            (0..self.function.products.len()).map(|k| self.cofactor(k) * self.moved(k, s)).sum();
        let error = if change == 0.0 { 0.0 } else { PRECISION * change / slope };
        error.max(PRECISION * s.modulus())
    }

    /// By how much an entry of the matrix changes with its numbers, over their relative change.
    fn moved(&self, entry: usize, s: Complex64) -> f64 {
        let function = self.function;
        let [re, im] = &self.inverses.value;
        let of_mode = |mode: usize| {
            let inverse = libm::hypot(re[mode], im[mode]);
            let own = function.frequencies[mode].powi(2) + function.damping[mode] * s.modulus();
            let product = function.products[entry][mode].abs();
            // a mode that is not coupled has no part in it, even on its pole
            if product == 0.0 { 0.0 } else { product * inverse * (1.0 + own * inverse) }
        };
        let sum: f64 = (0..function.modes).map(of_mode).sum();
        if function.follows_velocity[entry / function.order] { sum * s.modulus() } else { sum }
    }

    /// |C| of an entry of the matrix.
    fn cofactor(&mut self, entry: usize) -> f64 {
        let order = self.function.order;
        let (own, column) = (entry / order, entry % order);
        self.replaced.copy_from_slice(&self.matrix);
        for row in 0..order {
            self.replaced[row * order + column] = if row == own { Complex64::ONE } else { Complex64::ZERO };
        }
        determinant(&mut self.replaced, order).modulus()
    }
}
