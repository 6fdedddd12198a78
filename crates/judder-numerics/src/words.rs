//! Numbers in sentences.

use num_complex::Complex64;

/// A number as a person writes it: six digits, no zeros behind the last one, a power of ten only where it is very large or small.
///
/// `0.1` of 0.1, `440.25` of 440.25, `1.5e-5` of 1.5e-5, `12345700` of 12345678.
#[must_use]
pub fn plain(value: f64) -> String {
    let size = value.abs();
    // the six digits, read back: the shortest that are the same
    let rounded: f64 = format!("{value:.5e}").parse().unwrap_or(value);
    if size == 0.0 || !size.is_finite() || (1e-4..1e8).contains(&size) {
        format!("{rounded}")
    } else {
        format!("{rounded:e}")
    }
}

/// A complex number as a person writes it, both parts as of [`plain`]: `-1.5+440.25i`.
#[must_use]
pub fn plain_complex(value: Complex64) -> String {
    let sign = if value.im.is_sign_negative() { "" } else { "+" };
    format!("{}{sign}{}i", plain(value.re), plain(value.im))
}

#[cfg(test)]
mod tests {
    use super::{plain, plain_complex};
    use num_complex::Complex64;

    #[test]
    fn numbers_read_as_a_person_writes_them() {
        let words = [
            (0.1, "0.1"),
            (-0.05, "-0.05"),
            (1.0 / 3.0, "0.333333"),
            (440.25, "440.25"),
            (12_345_678.0, "12345700"),
            (1.5e-5, "1.5e-5"),
            (6.02e23, "6.02e23"),
            (0.0, "0"),
        ];
        for (value, expected) in words {
            assert_eq!(plain(value), expected);
        }
        assert_eq!(plain_complex(Complex64::new(-1.5, 440.25)), "-1.5+440.25i");
        assert_eq!(plain_complex(Complex64::new(2e-9, -1.0)), "2e-9-1i");
        assert_eq!((plain(f64::NAN), plain(f64::INFINITY)), ("NaN".to_owned(), "inf".to_owned()));
    }
}
