//! Elementary functions of complex numbers, with the same bits whatever C library the machine has.
//!
//! `num_complex` takes them from the system's libm, which chooses its code by the processor; these rest on the crate `libm`.

use num_complex::Complex64;

/// What `num_complex` offers as `norm`, `arg`, `exp`, `sqrt` and `ln`, in portable arithmetic.
pub trait ElementaryComplex: Copy {
    /// |z| ≥ 0, without overflow of the squares.
    #[must_use]
    fn modulus(self) -> f64;
    /// arg z in (−π, π], in rad.
    #[must_use]
    fn argument(self) -> f64;
    /// e^z.
    #[must_use]
    fn exponential(self) -> Complex64;
    /// The root with Re √z ≥ 0; on the cut, the negative real axis, Im √z has the sign of Im z.
    #[must_use]
    fn square_root(self) -> Complex64;
    /// ln |z| + i arg z.
    #[must_use]
    fn logarithm(self) -> Complex64;
}

impl ElementaryComplex for Complex64 {
    fn modulus(self) -> f64 {
        libm::hypot(self.re, self.im)
    }

    fn argument(self) -> f64 {
        libm::atan2(self.im, self.re)
    }

    fn exponential(self) -> Complex64 {
        // e^−∞ is 0 in every direction, also where the angle is none
        if self.re == f64::NEG_INFINITY { Complex64::ZERO } else { from_polar(libm::exp(self.re), self.im) }
    }

    fn square_root(self) -> Complex64 {
        // the larger part first: its formula cancels nothing
        let large = (0.5 * self.modulus() + 0.5 * self.re.abs()).sqrt();
        if large == 0.0 {
            return Complex64::new(0.0, self.im);
        }
        let small = 0.5 * self.im / large;
        if self.re >= 0.0 {
            Complex64::new(large, small)
        } else {
            Complex64::new(small.abs(), large.copysign(self.im))
        }
    }

    fn logarithm(self) -> Complex64 {
        Complex64::new(libm::log(self.modulus()), self.argument())
    }
}

/// `modulus` · e^{i `argument`}, the argument in rad.
#[must_use]
pub fn from_polar(modulus: f64, argument: f64) -> Complex64 {
    let (sine, cosine) = libm::sincos(argument);
    Complex64::new(modulus * cosine, modulus * sine)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Points in every quadrant, on the axes, and where squares overflow or vanish.
    fn points() -> Vec<Complex64> {
        let parts = [0.0, -0.0, 1.0, -1.0, 3.5, -0.25, 1e-200, -1e-200, 1e200];
        parts.iter().flat_map(|re| parts.iter().map(|im| Complex64::new(*re, *im))).collect()
    }

    #[test]
    fn agree_with_num_complex_to_rounding() {
        for z in points() {
            let scale = z.norm();
            assert!((z.modulus() - scale).abs() <= 4e-16 * scale, "{z}");
            assert!((z.argument() - z.arg()).abs() <= 1e-15, "{z}");
            let root = z.square_root();
            assert!((root - z.sqrt()).norm() <= 1e-15 * scale.sqrt(), "{z}: {root}");
            if scale > 0.0 {
                assert!((z.logarithm() - z.ln()).norm() <= 1e-13, "{z}");
            }
            if z.re.abs() < 100.0 {
                assert!((z.exponential() - z.exp()).norm() <= 1e-15 * z.re.exp(), "{z}");
            }
        }
    }

    #[test]
    fn a_root_squared_is_its_number() {
        for z in points().into_iter().filter(|z| z.norm() < 1e150 && z.norm() > 1e-150) {
            let root = z.square_root();
            assert!(root.re >= 0.0 && (root * root - z).norm() <= 1e-15 * z.norm(), "{z}: {root}");
        }
    }

    #[test]
    fn limits_of_the_exponential_are_numbers() {
        assert_eq!(Complex64::new(f64::NEG_INFINITY, f64::INFINITY).exponential(), Complex64::ZERO);
    }
}
