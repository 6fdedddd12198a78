//! From creep to relaxation and back: the zeros of one form are the poles of the other, and the two interlace.

use super::creep::{CreepSpectrum, CreepTerm};
use super::error::MaterialError;
use super::relaxation::{RelaxationSpectrum, RelaxationTerm};
use judder_numerics::root::bracketed_root;

impl CreepSpectrum {
    /// The same material in relaxation form; for one term ρ = τ E0/E∞ and E_1 = E∞ − E0.
    ///
    /// # Errors
    /// [`MaterialError::NoCounterpart`] when a term is too weak to move a pole by any floating-point number.
    pub fn relaxation_form(&self) -> Result<RelaxationSpectrum, MaterialError> {
        let positions: Vec<f64> = self.terms().iter().map(|term| term.retardation_time).collect();
        let weights: Vec<f64> = self.terms().iter().map(|term| term.compliance).collect();
        let counterparts =
            Interlacing::new(1.0 / self.glassy_modulus(), &positions, &weights).counterparts()?;
        let term = |(relaxation_time, modulus)| RelaxationTerm { relaxation_time, modulus };
        RelaxationSpectrum::new(self.rubbery_modulus(), counterparts.into_iter().map(term).collect())
    }
}

impl RelaxationSpectrum {
    /// The same material in creep form; for one term τ = ρ E∞/E0 and C_1 = 1/E0 − 1/E∞.
    ///
    /// # Errors
    /// [`MaterialError::NoCounterpart`] when a term is too weak to move a pole by any floating-point number.
    pub fn creep_form(&self) -> Result<CreepSpectrum, MaterialError> {
        // the equation is that of the other direction, with rates in the place of times
        let rates: Vec<f64> = self.terms().iter().rev().map(|term| 1.0 / term.relaxation_time).collect();
        let weights: Vec<f64> = self.terms().iter().rev().map(|term| term.modulus).collect();
        let counterparts = Interlacing::new(self.rubbery_modulus(), &rates, &weights).counterparts()?;
        let term = |(rate, compliance): (f64, f64)| CreepTerm { retardation_time: 1.0 / rate, compliance };
        CreepSpectrum::new(self.glassy_modulus(), counterparts.into_iter().rev().map(term).collect())
    }
}

/// A(p) = a0 + Σ a_k/(1 − p_k/p), whose zeros are the poles of 1/A, ascending in p_k.
///
/// With times for p and 1/E∞, C_k for a0, a_k this is 1/E at iω = −1/p, and its zeros are the relaxation times. With rates
/// for p and E0, E_j it is E, and its zeros are the retardation rates 1/τ_k. Either way one zero lies below each p_k and above
/// p_{k−1}, and the residue of 1/A there gives the weight b = 1/Σ a_k (p_k/p)/(1 − p_k/p)².
///
/// A zero is kept as its logarithmic distance from the nearest p_k, so that weights far below the sum keep all their digits.
struct Interlacing<'a> {
    constant: f64,
    positions: &'a [f64],
    weights: &'a [f64],
}

/// Distances from a pole are searched in steps of this factor before they are bracketed.
const STEP: f64 = 16.0;

impl<'a> Interlacing<'a> {
    /// A(p) from its parts; positions ascend, everything is positive.
    fn new(constant: f64, positions: &'a [f64], weights: &'a [f64]) -> Self {
        Self { constant, positions, weights }
    }

    /// (position, weight) of every term of 1/A, ascending.
    ///
    /// # Errors
    /// [`MaterialError::NoCounterpart`] for a term whose weight is lost in floating-point numbers.
    fn counterparts(&self) -> Result<Vec<(f64, f64)>, MaterialError> {
        (0..self.positions.len())
            .map(|k| {
                let lost = MaterialError::NoCounterpart { index: k + 1 };
                let (pole, distance) = self.zero_below(k).ok_or(lost.clone())?;
                let position = self.positions[pole] * libm::exp(distance);
                let weight = self.counterweight(pole, distance);
                if position.is_normal() && weight.is_normal() { Ok((position, weight)) } else { Err(lost) }
            })
            .collect()
    }

    /// The zero between p_{k−1} and p_k: the nearer of the two poles, and ln(zero/pole).
    fn zero_below(&self, k: usize) -> Option<(usize, f64)> {
        let (pole, furthest) = if k == 0 {
            // the zero is at least a0/A(∞) of the pole, and just that if there is one term
            let sum: f64 = self.weights.iter().sum();
            (0, -2.0 * libm::log1p(sum / self.constant))
        } else {
            let half = 0.5 * logarithmic_distance(self.positions[k], self.positions[k - 1]);
            if self.value(k, -half) > 0.0 { (k, -half) } else { (k - 1, half) }
        };
        // A times the distance tends to a_k > 0 at the pole, from either side, and is negative beyond the zero
        let scaled = |distance: f64| self.value(pole, distance) * distance;
        let (mut outer, mut inner) = (furthest, furthest / STEP);
        while scaled(inner) <= 0.0 {
            (outer, inner) = (inner, inner / STEP);
            if inner == 0.0 {
                return None;
            }
        }
        let root = bracketed_root(scaled, outer.min(inner), outer.max(inner), 0.0).ok()?;
        Some((pole, root))
    }

    /// A at p = p_pole e^distance.
    fn value(&self, pole: usize, distance: f64) -> f64 {
        let terms = self.positions.iter().zip(self.weights);
        terms
            .map(|(p, a)| -a / libm::expm1(logarithmic_distance(*p, self.positions[pole]) - distance))
            .sum::<f64>()
            + self.constant
    }

    /// The weight of 1/A at its pole p = p_pole e^distance: 1/Σ a_k/(2 sinh(½ ln(p_k/p)))².
    fn counterweight(&self, pole: usize, distance: f64) -> f64 {
        let terms = self.positions.iter().zip(self.weights);
        let sum: f64 = terms
            .map(|(p, a)| {
                let half = 0.5 * (logarithmic_distance(*p, self.positions[pole]) - distance);
                a / (2.0 * libm::sinh(half)).powi(2)
            })
            .sum();
        1.0 / sum
    }
}

/// ln(a/b), also where a and b nearly agree and where a/b overflows.
fn logarithmic_distance(a: f64, b: f64) -> f64 {
    let relative = (a - b) / b;
    if relative.abs() < 0.5 { libm::log1p(relative) } else { libm::log(a) - libm::log(b) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_term_in_closed_form() {
        let relaxation = CreepSpectrum::single(1e6, 1e7, 0.01).unwrap().relaxation_form().unwrap();
        let [term] = relaxation.terms() else { panic!("{relaxation:?}") };
        assert!((term.relaxation_time / 1e-3 - 1.0).abs() < 1e-14);
        assert!((term.modulus / 9e6 - 1.0).abs() < 1e-14);
        assert!((relaxation.glassy_modulus() / 1e7 - 1.0).abs() < 1e-14);
    }

    #[test]
    fn a_term_that_hardly_exists_keeps_its_digits() {
        let term = |retardation_time, compliance| CreepTerm { retardation_time, compliance };
        let creep =
            CreepSpectrum::new(1e9, vec![term(1e-12, 1e-7), term(3.0, 1e-27), term(1e8, 1e-6)]).unwrap();
        let back = creep.relaxation_form().unwrap().creep_form().unwrap();
        for (a, b) in creep.terms().iter().zip(back.terms()) {
            assert!((a.compliance / b.compliance - 1.0).abs() < 1e-12, "{a:?} {b:?}");
            assert!((a.retardation_time / b.retardation_time - 1.0).abs() < 1e-12, "{a:?} {b:?}");
        }
    }
}
