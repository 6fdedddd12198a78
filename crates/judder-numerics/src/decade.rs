//! Powers of ten.

/// The largest whole power of ten that a double holds exactly is 10²².
const EXACT: f64 = 22.0;

/// 10 to the power of `exponent`, the double nearest to it where that is a whole number from −22 to 22, and to one unit in the last place elsewhere.
///
/// A range over decades has 10⁻⁵ among its points and not 9.999999999999999·10⁻⁶.
#[must_use]
pub fn power_of_ten(exponent: f64) -> f64 {
    if exponent.fract() != 0.0 || exponent.abs() > EXACT {
        return libm::pow(10.0, exponent);
    }
    // products of tens are exact so far, and one division rounds once
    let power = 10_f64.powi(exponent.abs() as i32);
    if exponent < 0.0 { power.recip() } else { power }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whole_powers_are_as_written() {
        for exponent in -22..=22 {
            let written: f64 = format!("1e{exponent}").parse().unwrap();
            assert_eq!(power_of_ten(f64::from(exponent)), written);
        }
    }

    #[test]
    fn other_powers_are_right_to_the_last_place() {
        let root = 10_f64.sqrt();
        assert!((power_of_ten(0.5) - root).abs() <= f64::EPSILON * root);
        assert!((power_of_ten(-1.5) * 10.0 * root - 1.0).abs() <= 2.0 * f64::EPSILON);
        assert!((power_of_ten(300.0) / 1e300 - 1.0).abs() <= f64::EPSILON);
    }

    #[test]
    fn what_has_no_power_has_none() {
        assert!(power_of_ten(f64::NAN).is_nan());
        assert_eq!([power_of_ten(400.0), power_of_ten(-400.0)], [f64::INFINITY, 0.0]);
    }
}
