//! Quantities as case files write them: `"3.5 kN/m"`, `"30 mm/s"`, `"1e-7 1/Pa"`.
//!
//! A number, then a unit: factors joined by a space, `*` or `·`, then `/` before each divisor, powers as `^2`, `²` or
//! `2` (`N/mm2`, `s-1`). What follows a quotient must be a quotient again (`N/m/s`), so that no reading has to be guessed.

use std::f64::consts::PI;
use std::fmt;
use std::ops::Range;

use thiserror::Error;

use crate::dimension::Dimension;
use crate::document::{Data, Node};

/// A number in SI units with its dimension.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Quantity {
    /// The number in m, kg, s, rad, K, mol and their products; always finite.
    pub number: f64,
    /// Its dimension.
    pub dimension: Dimension,
}

/// Why a text is not a quantity.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum QuantityError {
    /// The text does not begin with a decimal number.
    #[error("a quantity begins with a number")]
    NoNumber,
    /// The number, or its value in SI units, exceeds the range of `f64`.
    #[error("the number is too large")]
    TooLarge,
    /// A unit that is not in the list of units.
    #[error("unknown unit `{unit}`")]
    UnknownUnit {
        /// The word that was read as a unit.
        unit: String,
    },
    /// A power that is not a whole number from −9 to 9.
    #[error("a power of a unit is a whole number from -9 to 9")]
    Power,
    /// A factor after a quotient: `N/m s` could mean N s/m or N/(m s).
    #[error("a factor after `/` is ambiguous")]
    FactorAfterQuotient,
    /// A sign without a unit beside it, or a character that cannot stand in a unit.
    #[error("a unit is missing or misplaced here")]
    Misplaced,
}

/// A unit without prefix: symbol, factor and power of ten to SI, dimension, whether prefixes apply.
struct Unit(&'static str, f64, i32, Dimension, bool);

const UNITS: [Unit; 16] = [
    Unit("m", 1.0, 0, Dimension::LENGTH, true),
    Unit("g", 1.0, -3, Dimension::MASS, true),
    Unit("s", 1.0, 0, Dimension::TIME, true),
    Unit("min", 60.0, 0, Dimension::TIME, false),
    Unit("h", 3600.0, 0, Dimension::TIME, false),
    Unit("rad", 1.0, 0, Dimension::ANGLE, true),
    Unit("deg", PI / 180.0, 0, Dimension::ANGLE, false),
    Unit("°", PI / 180.0, 0, Dimension::ANGLE, false),
    Unit("Hz", 2.0 * PI, 0, Dimension::ANGULAR_FREQUENCY, true),
    Unit("rpm", PI / 30.0, 0, Dimension::ANGULAR_FREQUENCY, false),
    Unit("N", 1.0, 0, Dimension::FORCE, true),
    Unit("Pa", 1.0, 0, Dimension::STRESS, true),
    Unit("J", 1.0, 0, Dimension::new(2, 1, -2, 0), true),
    Unit("W", 1.0, 0, Dimension::new(2, 1, -3, 0), true),
    Unit("K", 1.0, 0, Dimension::TEMPERATURE, true),
    Unit("mol", 1.0, 0, Dimension::AMOUNT, true),
];

/// The number 1 stands as a unit at the beginning: `1/Pa`.
const ONE: Unit = Unit("1", 1.0, 0, Dimension::NUMBER, false);

/// The ways of writing degrees Celsius, which stand alone: their zero is not that of the kelvin.
const CELSIUS: [&str; 2] = ["degC", "°C"];

/// 0 °C in kelvin.
pub const CELSIUS_ZERO: f64 = 273.15;

/// Powers of ten, summed over a whole unit and applied once: 30 mm/s is then exactly 0.03 m/s.
const PREFIXES: [(char, i32); 10] = [
    ('p', -12),
    ('n', -9),
    ('µ', -6),
    ('μ', -6),
    ('u', -6),
    ('m', -3),
    ('c', -2),
    ('k', 3),
    ('M', 6),
    ('G', 9),
];

/// The units and prefixes that [`Quantity::parse`] knows, for help texts.
pub const UNIT_LIST: &str =
    "m g s min h N Pa J W K mol degC Hz rpm rad deg, with the prefixes p n µ (or u) m c k M G";

impl Quantity {
    /// Parses `"3.5 kN/m"` and the like; `Hz` is 2π rad/s, `rpm` π/30 rad/s.
    ///
    /// # Errors
    /// The cause and the byte range of `text` that it concerns.
    pub fn parse(text: &str) -> Result<Self, (QuantityError, Range<usize>)> {
        let start = text.len() - text.trim_start().len();
        let (number, length) =
            leading_number(&text[start..]).ok_or((QuantityError::NoNumber, 0..text.len()))?;
        let unit_start = start + length;
        let (number, dimension) = if CELSIUS.contains(&text[unit_start..].trim()) {
            (number + CELSIUS_ZERO, Dimension::TEMPERATURE)
        } else {
            let (factor, exponent, dimension) = parse_unit(&text[unit_start..])
                .map_err(|(cause, range)| (cause, range.start + unit_start..range.end + unit_start))?;
            (scale(number * factor, exponent), dimension)
        };
        if !number.is_finite() {
            return Err((QuantityError::TooLarge, start..text.trim_end().len()));
        }
        Ok(Self { number, dimension })
    }

    /// Whether the text is a temperature in degrees Celsius, whose number was moved to the zero of the kelvin.
    pub fn is_celsius(text: &str) -> bool {
        CELSIUS.iter().any(|unit| text.trim_end().ends_with(unit))
    }
}

/// A unit as a case file writes it, in which values that vary are shown.
#[derive(Debug, Clone, PartialEq)]
pub struct WrittenUnit {
    /// As written, `mm/s`; empty of plain numbers.
    pub name: String,
    /// One of it in SI units, beside its zero.
    factor: f64,
    /// Its zero in SI units, which only that of degrees Celsius is not.
    zero: f64,
}

impl WrittenUnit {
    /// That of a quantity such as `"30 mm/s"`; `None` where the text is no quantity.
    pub fn of(text: &str) -> Option<Self> {
        let text = text.trim();
        let (_, length) = leading_number(text)?;
        Self::called(text[length..].trim())
    }

    /// The unit of this name; `None` where there is none.
    pub fn called(name: &str) -> Option<Self> {
        let of = |number: u8| Quantity::parse(&format!("{number} {name}")).ok().map(|own| own.number);
        let (zero, one) = (of(0)?, of(1)?);
        Some(Self { name: name.to_owned(), factor: one - zero, zero })
    }

    /// That in which values are kept.
    pub fn si(dimension: Dimension) -> Self {
        let name = if dimension.is_number() { String::new() } else { dimension.unit() };
        Self { name, factor: 1.0, zero: 0.0 }
    }

    /// A value in SI units, in this one.
    pub fn value(&self, si: f64) -> f64 {
        self.difference(si - self.zero)
    }

    /// By how much values in SI units differ, in this one.
    pub fn difference(&self, si: f64) -> f64 {
        let own = si / self.factor;
        // 0.03 m/s is 30 mm/s, and not what rounding makes of it
        let rounded = || format!("{own:.12e}").parse().unwrap_or(own);
        if self.factor == 1.0 && self.zero == 0.0 { si } else { rounded() }
    }

    /// A value in SI units in words, with the unit.
    pub fn text(&self, si: f64) -> String {
        let value = self.value(si);
        if self.name.is_empty() { value.to_string() } else { format!("{value} {}", self.name) }
    }
}

/// A number as a case file has it, for messages.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct WrittenNumber(String);

impl WrittenNumber {
    /// That of a node, read as this number.
    pub fn of(node: &Node, number: f64) -> Self {
        match &node.data {
            Data::Text(text) => Self(text.trim().to_owned()),
            _ => number.into(),
        }
    }

    /// Whether it was written in degrees Celsius.
    pub fn is_celsius(&self) -> bool {
        Quantity::is_celsius(&self.0)
    }
}

/// As a plain number.
impl From<f64> for WrittenNumber {
    fn from(number: f64) -> Self {
        Self(format!("{number:?}"))
    }
}

impl fmt::Display for WrittenNumber {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.0)
    }
}

/// The decimal number with which `text` begins, and its length in bytes; infinite where it exceeds `f64`.
pub fn leading_number(text: &str) -> Option<(f64, usize)> {
    let bytes = text.as_bytes();
    let digits = |from: usize| bytes[from..].iter().take_while(|byte| byte.is_ascii_digit()).count();
    let sign = usize::from(matches!(bytes.first(), Some(b'+' | b'-')));
    let whole = digits(sign);
    let mut end = sign + whole;
    if bytes.get(end) == Some(&b'.') {
        let fraction = digits(end + 1);
        if whole + fraction == 0 {
            return None;
        }
        end += 1 + fraction;
    } else if whole == 0 {
        return None;
    }
    if matches!(bytes.get(end), Some(b'e' | b'E')) {
        let sign = usize::from(matches!(bytes.get(end + 1), Some(b'+' | b'-')));
        let exponent = bytes.get(end + 1 + sign..).map_or(0, |_| digits(end + 1 + sign));
        if exponent > 0 {
            end += 1 + sign + exponent;
        }
    }
    text[..end].parse().ok().map(|number| (number, end))
}

/// `number · 10^exponent` with one rounding for every exponent that units can produce in practice.
fn scale(number: f64, exponent: i32) -> f64 {
    if exponent < 0 { number / 10_f64.powi(-exponent) } else { number * 10_f64.powi(exponent) }
}

type PlacedResult<T> = Result<T, (QuantityError, Range<usize>)>;

/// Reads a whole unit: factor, power of ten, dimension.
fn parse_unit(text: &str) -> PlacedResult<(f64, i32, Dimension)> {
    let (mut factor, mut exponent, mut dimension) = (1.0, 0, Dimension::NUMBER);
    let (mut divides, mut wants_unit, mut first) = (false, false, true);
    let mut at = 0;
    while let Some(next) = text[at..].chars().next() {
        let sign = at..at + next.len_utf8();
        match next {
            _ if next.is_whitespace() => at = sign.end,
            '/' | '*' | '·' if wants_unit || (first && next != '/') => {
                return Err((QuantityError::Misplaced, sign));
            }
            '*' | '·' if divides => return Err((QuantityError::FactorAfterQuotient, sign)),
            '/' | '*' | '·' => (at, wants_unit, divides) = (sign.end, true, next == '/'),
            _ => {
                let (word, power, length) = split_factor(&text[at..])
                    .map_err(|(cause, range)| (cause, at + range.start..at + range.end))?;
                let here = at..at + length;
                if divides && !wants_unit {
                    return Err((QuantityError::FactorAfterQuotient, here));
                }
                let power = if divides { -power } else { power };
                let Some((unit, prefix)) = find_unit(word, first) else {
                    return Err((QuantityError::UnknownUnit { unit: word.to_owned() }, at..at + word.len()));
                };
                factor *= unit.1.powi(i32::from(power));
                exponent += (unit.2 + prefix) * i32::from(power);
                dimension = dimension.times(unit.3, power).ok_or((QuantityError::Power, here.clone()))?;
                (at, wants_unit) = (here.end, false);
            }
        }
        first &= next.is_whitespace();
    }
    if wants_unit {
        let end = text.trim_end().len();
        let last = text[..end].chars().next_back().map_or(0, char::len_utf8);
        return Err((QuantityError::Misplaced, end - last..end));
    }
    Ok((factor, exponent, dimension))
}

/// Splits the factor that begins `text` into its word, its power, and the length of both.
fn split_factor(text: &str) -> PlacedResult<(&str, i8, usize)> {
    let is_word = |character: char| character.is_alphabetic() || character == '°';
    let word = match text.strip_prefix('1') {
        Some(_) => 1,
        None => text.find(|character| !is_word(character)).unwrap_or(text.len()),
    };
    if word == 0 {
        let length = text.chars().next().map_or(0, char::len_utf8);
        return Err((QuantityError::Misplaced, 0..length));
    }
    let rest = &text[word..];
    let caret = usize::from(rest.starts_with('^'));
    let sign = usize::from(rest[caret..].starts_with('-'));
    let digits = rest[caret + sign..].bytes().take_while(u8::is_ascii_digit).count();
    if caret == 0 && (digits == 0 || text.starts_with('1')) {
        let (power, length) = superscript(rest).unwrap_or((1, 0));
        return Ok((&text[..word], power, word + length));
    }
    let end = caret + sign + digits;
    match rest[caret..end].parse::<i8>() {
        Ok(power @ -9..=9) => Ok((&text[..word], power, word + end)),
        _ => Err((QuantityError::Power, word..word + end)),
    }
}

/// The power written as `²`, `³` or `⁻¹` at the beginning of `text`, and its length in bytes.
fn superscript(text: &str) -> Option<(i8, usize)> {
    [("²", 2), ("³", 3), ("⁻¹", -1), ("⁻²", -2)]
        .into_iter()
        .find(|(sign, _)| text.starts_with(sign))
        .map(|(sign, power)| (power, sign.len()))
}

/// The unit and the power of ten of its prefix; the number 1 counts as a unit at the beginning (`1/Pa`).
fn find_unit(word: &str, first: bool) -> Option<(&'static Unit, i32)> {
    if word == "1" {
        return first.then_some((&ONE, 0));
    }
    if let Some(unit) = UNITS.iter().find(|unit| unit.0 == word) {
        return Some((unit, 0));
    }
    PREFIXES.iter().find_map(|(prefix, exponent)| {
        let symbol = word.strip_prefix(*prefix)?;
        UNITS.iter().find(|unit| unit.4 && unit.0 == symbol).map(|unit| (unit, *exponent))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn number(text: &str) -> f64 {
        Quantity::parse(text).unwrap_or_else(|error| panic!("{text}: {error:?}")).number
    }

    #[test]
    fn the_quantities_of_the_interface() {
        let cases = [
            ("30 mm/s", 0.03, Dimension::SPEED),
            ("0.2 N", 0.2, Dimension::FORCE),
            ("1 MPa", 1e6, Dimension::STRESS),
            ("30 deg", PI / 6.0, Dimension::ANGLE),
            ("7 kHz", 14e3 * PI, Dimension::ANGULAR_FREQUENCY),
            ("40 rad/s", 40.0, Dimension::ANGULAR_FREQUENCY),
            ("3.5 kN/m", 3500.0, Dimension::STIFFNESS),
            ("10 ms", 0.01, Dimension::TIME),
            ("1e-7 1/Pa", 1e-7, Dimension::COMPLIANCE),
            ("0.9e-6/Pa", 0.9e-6, Dimension::COMPLIANCE),
            ("25 degC", 298.15, Dimension::TEMPERATURE),
            ("-10 °C", 263.15, Dimension::TEMPERATURE),
            ("300 K", 300.0, Dimension::TEMPERATURE),
            ("80 kJ/mol", 8e4, Dimension::MOLAR_ENERGY),
            ("2 µm", 2e-6, Dimension::LENGTH),
            ("2 kg·m/s²", 2.0, Dimension::FORCE),
            ("2 kg m s^-2", 2.0, Dimension::FORCE),
            ("5 N/mm^2", 5e6, Dimension::STRESS),
            ("5 N/mm2", 5e6, Dimension::STRESS),
            ("2 kg m s-2", 2.0, Dimension::FORCE),
            (" 3m ", 3.0, Dimension::LENGTH),
            ("4", 4.0, Dimension::NUMBER),
        ];
        for (text, expected, dimension) in cases {
            assert_eq!(Quantity::parse(text).unwrap().dimension, dimension, "{text}");
            assert!((number(text) - expected).abs() <= 1e-15 * expected.abs(), "{text}: {}", number(text));
        }
    }

    #[test]
    fn prefixes_round_once() {
        assert_eq!(number("10 mm"), 0.01);
        assert_eq!(number("30 mm/s"), 0.03);
        assert_eq!(number("10 ms"), 0.01);
        assert_eq!(number("1 GPa"), 1e9);
    }

    #[test]
    fn errors_say_what_and_where() {
        let cases = [
            ("", QuantityError::NoNumber, 0..0),
            ("fast", QuantityError::NoNumber, 0..4),
            (".", QuantityError::NoNumber, 0..1),
            ("nan m", QuantityError::NoNumber, 0..5),
            ("1e999 m", QuantityError::TooLarge, 0..7),
            ("1e999 degC", QuantityError::TooLarge, 0..10),
            ("3 degC/s", QuantityError::UnknownUnit { unit: "degC".into() }, 2..6),
            ("3 furlong/s", QuantityError::UnknownUnit { unit: "furlong".into() }, 2..9),
            ("3 m/", QuantityError::Misplaced, 3..4),
            ("0m·", QuantityError::Misplaced, 2..4),
            ("3 m//s", QuantityError::Misplaced, 4..5),
            ("3,5 m", QuantityError::Misplaced, 1..2),
            ("3 N/m s", QuantityError::FactorAfterQuotient, 6..7),
            ("3 N/m*s", QuantityError::FactorAfterQuotient, 5..6),
            ("3 m^x", QuantityError::Power, 3..4),
            ("3 m^99", QuantityError::Power, 3..6),
            ("3 m99", QuantityError::Power, 3..5),
            ("3 12", QuantityError::Misplaced, 3..4),
            ("3 *m", QuantityError::Misplaced, 2..3),
        ];
        for (text, cause, range) in cases {
            assert_eq!(Quantity::parse(text), Err((cause, range)), "{text:?}");
        }
    }

    proptest! {
        #[test]
        fn any_text_is_a_quantity_or_an_error_inside_it(text in "\\PC{0,40}") {
            if let Err((_, range)) = Quantity::parse(&text) {
                prop_assert!(text.get(range).is_some());
            }
        }

        #[test]
        fn near_quantities_never_panic(text in "[-+0-9.eE]{1,6}[ /*·^²mkgNPaHzsrdµ°1⁻¹9-]{0,10}") {
            if let Err((_, range)) = Quantity::parse(&text) {
                prop_assert!(text.get(range).is_some());
            }
        }

        #[test]
        fn a_number_in_si_units_comes_back(number in proptest::num::f64::NORMAL) {
            prop_assert_eq!(Quantity::parse(&format!("{number:e} N/m")).unwrap().number, number);
        }
    }

    #[test]
    fn values_are_shown_in_the_unit_in_which_they_were_written() {
        for (written, si, shown) in [
            ("30 mm/s", 0.03, "30 mm/s"),
            ("1.5", 0.25, "0.25"),
            ("20 °C", 293.15, "20 °C"),
            ("2e9 N/m^3", 2.5e9, "2500000000 N/m^3"),
            ("45 deg", PI / 6.0, "30 deg"),
        ] {
            assert_eq!(WrittenUnit::of(written).unwrap().text(si), shown);
        }
        assert!((WrittenUnit::called("°C").unwrap().difference(3.0) - 3.0).abs() < 1e-12);
        assert!(WrittenUnit::of("30 furlong").is_none() && WrittenUnit::of("mm").is_none());
    }
}
