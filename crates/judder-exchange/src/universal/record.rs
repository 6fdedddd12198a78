//! Records of universal files: fixed widths.

use crate::error::ExchangeError;
use std::io::Write;

pub(super) fn begin(to: &mut dyn Write, dataset: u32) -> Result<(), ExchangeError> {
    writeln!(to, "{:>6}\n{dataset:>6}", -1)?;
    Ok(())
}

pub(super) fn end(to: &mut dyn Write) -> Result<(), ExchangeError> {
    writeln!(to, "{:>6}", -1)?;
    Ok(())
}

/// A line of text: 80 characters, not empty.
pub(super) fn text(line: &str) -> String {
    let line: String =
        line.chars().filter(char::is_ascii).filter(|letter| !letter.is_control()).take(80).collect();
    if line.trim().is_empty() { String::from("NONE") } else { line }
}

/// A number as Fortran's E format writes it, `-1.50000e+00`.
pub(super) fn exponential(value: f64, width: usize, digits: usize) -> String {
    let plain = format!("{value:.digits$e}");
    let (mantissa, exponent) = plain.split_once('e').unwrap_or((&plain, "0"));
    let (sign, exponent) = match exponent.strip_prefix('-') {
        Some(exponent) => ('-', exponent),
        None => ('+', exponent),
    };
    format!("{:>width$}", format!("{mantissa}e{sign}{exponent:0>2}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_their_widths() {
        assert_eq!(exponential(-1.5, 13, 5), " -1.50000e+00");
        assert_eq!(exponential(1.234_567_8e-7, 13, 5), "  1.23457e-07");
        assert_eq!(exponential(-1e-300, 13, 5), "-1.00000e-300");
        assert_eq!(exponential(0.0, 20, 12), "  0.000000000000e+00");
        assert_eq!(text("a\nb"), "ab");
        assert_eq!(text("  "), "NONE");
    }
}
