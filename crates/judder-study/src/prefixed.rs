//! Quantities in SI for readers: with the prefix that leaves one to three digits before the point.

use judder_numerics::decade::power_of_ten;

/// A unit with a prefix.
#[derive(Debug, Clone, PartialEq)]
pub struct PrefixedUnit {
    /// How many of it are one of the unit without a prefix.
    pub factor: f64,
    /// Its name.
    pub name: String,
}

/// Prefixes and their powers of ten, the smallest first.
const PREFIXES: [(&str, i32); 7] = [("n", -9), ("µ", -6), ("m", -3), ("", 0), ("k", 3), ("M", 6), ("G", 9)];

impl PrefixedUnit {
    /// That in which the largest of some values is best read; lengths, areas and times take none above metre and second.
    #[must_use]
    pub fn of(unit: &str, largest: f64) -> Self {
        let power = if unit.ends_with('²') { 2 } else { 1 };
        let most = if unit.starts_with(['m', 's']) { 0 } else { 9 };
        // as a table rounds it: 999999.9 Pa are 1 MPa there, not 1000 kPa
        let largest = format!("{:.5e}", largest.abs()).parse().unwrap_or(largest);
        let fits = |(_, exponent): &&(&str, i32)| {
            *exponent <= most && largest >= power_of_ten(f64::from(power * exponent))
        };
        let has_size = largest > 0.0 && largest.is_finite();
        let smallest = if has_size { PREFIXES[0] } else { ("", 0) };
        let (prefix, exponent) =
            PREFIXES.iter().rev().filter(|_| has_size).find(fits).copied().unwrap_or(smallest);
        Self { factor: power_of_ten(f64::from(-power * exponent)), name: format!("{prefix}{unit}") }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_value_has_one_to_three_digits_before_the_point() {
        for (unit, value, factor, name) in [
            ("Pa", 188_428.0, 1e-3, "kPa"),
            ("m", 1.01e-4, 1e6, "µm"),
            ("m", 3e3, 1.0, "m"),
            ("s", 2e3, 1.0, "s"),
            ("m²", 6.09e-5, 1e6, "mm²"),
            ("N/m", 15.0, 1.0, "N/m"),
            ("N", 2e-12, 1e9, "nN"),
            ("N", 0.0, 1.0, "N"),
            ("Pa", f64::NAN, 1.0, "Pa"),
            ("Pa", -1e9, 1e-9, "GPa"),
            ("Pa", 999_999.999, 1e-6, "MPa"),
        ] {
            assert_eq!(
                PrefixedUnit::of(unit, value),
                PrefixedUnit { factor, name: name.to_owned() },
                "{value} {unit}"
            );
        }
    }
}
