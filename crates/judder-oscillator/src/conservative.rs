//! The system without damping, C = 0: eigenvalues (24), (25), their coalescence (26), and the threshold of the shear strength in closed form (27).
//!
//! The paper calls it conservative; its stiffness matrix is not symmetric, so it can flutter.

use crate::FrictionLoad;
use crate::groups::Coefficients;
use judder_contact::ContactResponse;
use judder_numerics::complex::ElementaryComplex;
use judder_numerics::order::sort_by_numbers;
use num_complex::Complex64;

/// 4 k12 k21 + (k11 − k22)², the radicand of (24), (25): negative where the two modes have merged into flutter.
#[inline(always)]
#[must_use]
pub fn discriminant(stiffness: &[[f64; 2]; 2]) -> f64 {
    let [[k11, k12], [k21, k22]] = *stiffness;
    let difference = k11 - k22;
    4.0 * (k12 * k21) + difference * difference
}

/// [`discriminant`] over the magnitudes of its terms: between −1 and 1, with its sign. 0 where all vanish.
#[inline(always)]
#[must_use]
pub fn discriminant_share(stiffness: &[[f64; 2]; 2]) -> f64 {
    let [[k11, k12], [k21, k22]] = *stiffness;
    let difference = k11 - k22;
    let scale = 4.0 * (k12 * k21).abs() + difference * difference;
    if scale > 0.0 { discriminant(stiffness) / scale } else { 0.0 }
}

/// The four eigenvalues (24), (25) of q̈ + K q = 0, sorted by imaginary, then real part.
#[must_use]
pub fn conservative_eigenvalues(stiffness: &[[f64; 2]; 2]) -> [Complex64; 4] {
    let sum = stiffness[0][0] + stiffness[1][1];
    let product = stiffness[0][0] * stiffness[1][1] - stiffness[0][1] * stiffness[1][0];
    let outer_square = 0.5 * (-sum - Complex64::new(discriminant(stiffness), 0.0).square_root());
    let outer = outer_square.square_root();
    let inner = if outer_square.im != 0.0 {
        outer.conj()
    } else if outer_square.re != 0.0 {
        // λ² of the inner pair from the product of both: the sum in (25) would cancel
        Complex64::new(product / outer_square.re, 0.0).square_root()
    } else {
        Complex64::ZERO
    };
    let mut all = [outer, -outer, inner, -inner];
    sort_by_numbers(&mut all, |own| [own.im, own.re]);
    all
}

/// (26): the contact's coupling stiffness k12c at which the two modes merge, −(k11 − k22)²/(4 k12) − k12.
#[must_use]
pub fn coalescence_coupling(k11: f64, k12: f64, k22: f64) -> f64 {
    -(k11 - k22) * (k11 - k22) / (4.0 * k12) - k12
}

/// The first bracket of (27): k̃_x (D²/(2 η² sin 2α) + η² sin 2α/2), D = 1 + η² cos 2α − Ω² − F̃_k′/k̃_x = k11 − k22.
fn stiffness_bracket(c: &Coefficients, response: &ContactResponse) -> f64 {
    let k22 = c.k22 + response.force.by_indentation / c.stiffness;
    -c.stiffness * coalescence_coupling(c.k11, c.k12, k22)
}

/// (27): the shear strength τ̃0 at which the modes merge, for the indentation at which `response` was taken.
///
/// Implicit as it stands: the indentation depends on τ̃0. The self-consistent thresholds are in [`crate::critical`].
/// With [`FrictionLoad::ContactForce`] the term F̃_n ∂μ/∂ŷ becomes ∂(F̃_k μ)/∂ŷ. Infinite or NaN for k12 = 0.
#[must_use]
pub fn critical_shear_strength(load: FrictionLoad, c: &Coefficients, response: &ContactResponse) -> f64 {
    let without_adhesion = Coefficients { shear_strength: 0.0, ..*c };
    let viscoelastic = crate::friction::friction_force(load, &without_adhesion, response).by_indentation;
    (stiffness_bracket(c, response) - viscoelastic) / response.area.by_indentation
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn merging_is_where_the_discriminant_vanishes() {
        let (k11, k12, k22) = (1.5, 0.5, 1.9);
        let stiffness = [[k11, k12 + coalescence_coupling(k11, k12, k22)], [k12, k22]];
        assert!(discriminant(&stiffness).abs() < 1e-15);
        let eigenvalues = conservative_eigenvalues(&stiffness);
        assert!((eigenvalues[3].im - ((k11 + k22) / 2.0_f64).sqrt()).abs() < 1e-7);
    }

    #[test]
    fn minimal_flutter_model_at_unit_friction() {
        // K = [[2, 1 − 4μ/3], [1, 2]], μ = 1: λ² = −2 ± i/√3
        let eigenvalues = conservative_eigenvalues(&[[2.0, -1.0 / 3.0], [1.0, 2.0]]);
        let growth = eigenvalues.iter().map(|l| l.re).fold(f64::MIN, f64::max);
        let exact = Complex64::new(-2.0, 1.0 / 3_f64.sqrt()).sqrt().re;
        assert!((growth - exact).abs() < 1e-15);
        assert!((growth - 0.202_071_768_8).abs() < 1e-10);
    }
}
