//! How keys are called on axes and in tables, in the markup of the figures.

use crate::text::four_digits;
use judder_keys::dimension::Dimension;
use judder_numerics::decade::power_of_ten;

/// A swept quantity: its name, its symbol and its unit.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SweptQuantity {
    /// Name as it stands in arrays and tables, such as `velocity`.
    pub name: String,
    /// Quantity, symbol and unit for an axis.
    pub label: String,
    /// Symbol for a legend.
    pub symbol: String,
    /// Unit; `1` for a group.
    pub unit: String,
}

/// How any number of a case is called, by its dotted path.
pub fn any_key(path: &str, dimension: Dimension) -> SweptQuantity {
    let unit = if dimension.is_number() { "1".to_owned() } else { dimension.unit() };
    SweptQuantity {
        name: path.to_owned(),
        label: with_unit(path, &unit),
        symbol: path.rsplit('.').next().unwrap_or(path).to_owned(),
        unit,
    }
}

/// A label without the markup of figures.
pub fn plain(label: &str) -> String {
    label.replace("_{", "").replace(['$', '{', '}'], "")
}

/// A name with its unit, a dash of plain numbers; alone where it has none.
pub fn with_unit(name: &str, unit: &str) -> String {
    match unit {
        "" => name.to_owned(),
        "1" => format!("{name} (−)"),
        unit => format!("{name} ({unit})"),
    }
}

/// A number to four digits, for a legend: powers of ten as such, others short.
pub fn short_number(value: f64) -> String {
    let value = four_digits(value);
    let exponent = libm::log10(value.abs()).floor();
    if value == 0.0 || (-2.0..4.0).contains(&exponent) {
        return format!("{value}").replace('-', "−");
    }
    let mantissa = value / power_of_ten(exponent);
    let rounded = (mantissa * 1e6).round() / 1e6;
    let power = format!("10^{{{exponent}}}").replace('-', "−");
    if rounded == 1.0 { power } else { format!("{rounded}·{power}").replace('-', "−") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short_and_typeset() {
        assert_eq!(short_number(1e-6), "10^{−6}");
        assert_eq!(short_number(7.5e-5), "7.5·10^{−5}");
        assert_eq!(short_number(0.05), "0.05");
        assert_eq!(short_number(0.0), "0");
        assert_eq!(short_number(147.0 * 1e-4), "0.0147", "what rounding left of 0.014700000000000001");
        assert_eq!(short_number(-1.0 / 3.0), "−0.3333");
        assert_eq!(short_number(9.99996e-7), "10^{−6}");
    }
}
