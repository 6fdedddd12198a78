//! Why an indenter cannot be had.

use thiserror::Error;

/// Why an indenter cannot be had.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum IndenterError {
    /// A height is NaN or infinite, or masked.
    #[error(
        "the height at row {row}, column {column} (counted from 0) is {value}, not a finite number; fill the gaps first"
    )]
    HeightNotFinite {
        /// Row of the height, from 0.
        row: usize,
        /// Column of the height, from 0.
        column: usize,
        /// The height.
        value: f64,
    },
    /// Too few heights.
    #[error("{rows} × {columns} heights are too few; at least {least} × {least} are needed")]
    TooFewHeights {
        /// Rows.
        rows: usize,
        /// Columns.
        columns: usize,
        /// The fewest.
        least: usize,
    },
    /// A count that does not fill the lattice.
    #[error("{found} heights do not fill {rows} × {columns} places")]
    HeightsDoNotFit {
        /// Heights given.
        found: usize,
        /// Rows.
        rows: usize,
        /// Columns.
        columns: usize,
    },
    /// A number that must be positive is not.
    #[error("the {what} is {value}: it must be a positive number")]
    NotPositive {
        /// What it is.
        what: &'static str,
        /// Its value.
        value: f64,
    },
    /// The Hurst exponent is outside its range.
    #[error("the Hurst exponent is {value}: it must lie above 0 and not above 1")]
    Hurst {
        /// Its value.
        value: f64,
    },
    /// Wave lengths in the wrong order.
    #[error("the {longer} ({from}) must be longer than the {shorter} ({to})")]
    WaveLengths {
        /// The wave that must be longer.
        longer: &'static str,
        /// Its length.
        from: f64,
        /// The wave that must be shorter.
        shorter: &'static str,
        /// Its length.
        to: f64,
    },
}
