//! Why a table of measured moduli is not read.

use judder_numerics::words::plain;
use thiserror::Error;

/// Why a table of measured moduli cannot be used. Lines are those of the file, counted from 1.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum DmaTableError {
    /// No data.
    #[error(
        "there are no measurements; a header line such as `frequency [Hz],E' [MPa],E'' [MPa]` and lines of numbers are needed"
    )]
    Empty,
    /// No column of the header is the quantity.
    #[error("the header, line {line}, has the columns {}; one for the {quantity} is needed", quoted(found))]
    MissingColumn {
        /// The header's line.
        line: usize,
        /// What is missing, and how it may be called.
        quantity: &'static str,
        /// The columns found.
        found: Vec<String>,
    },
    /// Two columns of the header are the quantity.
    #[error(
        "the header, line {line}, has two columns for the {quantity}: `{first}` and `{second}`; keep one, or rename the other"
    )]
    AmbiguousColumn {
        /// The header's line.
        line: usize,
        /// What is there twice.
        quantity: &'static str,
        /// The first of them.
        first: String,
        /// The second.
        second: String,
    },
    /// A column without a unit, or with one that is not known or does not belong to it.
    #[error(
        "the column `{column}` of the header, line {line}, is without a unit that it can have; write it in brackets, one of {}",
        quoted(expected)
    )]
    Unit {
        /// The header's line.
        line: usize,
        /// The column as found.
        column: String,
        /// Units that it may have.
        expected: Vec<String>,
    },
    /// A line with more or fewer fields than the header.
    #[error(
        "line {line} has {found} fields, the header has {expected}; every line needs as many, with the separator of the header"
    )]
    Fields {
        /// The line.
        line: usize,
        /// Its fields.
        found: usize,
        /// Those of the header.
        expected: usize,
    },
    /// What is no finite number.
    #[error("the {name} in line {line} is `{found}`; it must be a finite number with a decimal point")]
    Value {
        /// The line.
        line: usize,
        /// What it is.
        name: &'static str,
        /// What was found.
        found: String,
    },
    /// A number that is not positive.
    #[error("the {name} in line {line} is {}; it must be positive{}", plain(*found), convention(name, *found))]
    NotPositive {
        /// The line.
        line: usize,
        /// What it is.
        name: &'static str,
        /// What was found, in the unit of the column.
        found: f64,
    },
    /// A number that leaves the numbers in SI units.
    #[error("the {name} in line {line} is {} {unit}, which is too large", plain(*found))]
    TooLarge {
        /// The line.
        line: usize,
        /// What it is.
        name: &'static str,
        /// What was found, in the unit of the column.
        found: f64,
        /// That unit.
        unit: &'static str,
    },
    /// A temperature that there is not.
    #[error("the {name} in line {line} is {} {unit}; it must be above absolute zero, {zero} {unit}", plain(*found))]
    BelowAbsoluteZero {
        /// The line.
        line: usize,
        /// What it is.
        name: &'static str,
        /// What was found, in the unit of the column.
        found: f64,
        /// Absolute zero in that unit.
        zero: f64,
        /// That unit.
        unit: &'static str,
    },
    /// A frequency that does not rise.
    #[error(
        "the frequency in line {line} is {after} {unit} and does not rise above {before} {unit}, the one before; sort the lines by \
         temperature, then frequency, and leave doubles out"
    )]
    Order {
        /// The line.
        line: usize,
        /// The frequency before.
        before: f64,
        /// The one of the line.
        after: f64,
        /// The unit of both, that of the file.
        unit: &'static str,
    },
}

/// What a loss modulus of the other sign comes from.
fn convention(name: &str, found: f64) -> &'static str {
    match name {
        LOSS if found < 0.0 => {
            ": E = E' + iE'' with E'' > 0 belongs to motions as e^(+iωt); of moduli for e^(−iωt) take the complex conjugate"
        }
        _ => "",
    }
}

/// How messages call E″.
pub(super) const LOSS: &str = "loss modulus";

/// Names in backquotes, with commas.
fn quoted(names: &[String]) -> String {
    let quoted: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
    quoted.join(", ")
}
