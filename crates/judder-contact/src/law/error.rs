//! Why a law cannot be made, read or swept.

use crate::cylinder_on_layer::CylinderError;
use crate::kernel::check::KernelError;
use std::fmt;
use thiserror::Error;

/// Why a computed law cannot be had.
#[derive(Debug, Error)]
pub enum LawError {
    /// An axis has too few knots for a spline.
    #[error("{axis}: {count} knots, at least {least} are needed")]
    TooFewKnots {
        /// The axis, with its symbol.
        axis: &'static str,
        /// Knots given.
        count: usize,
        /// Knots needed.
        least: usize,
    },
    /// The ends of an axis are not finite, or not ascending.
    #[error("{axis}: knots from {first} to {last} must be finite and ascending")]
    NotAscending {
        /// The axis, with its symbol.
        axis: &'static str,
        /// Logarithm at the first knot.
        first: f64,
        /// Logarithm at the last knot.
        last: f64,
    },
    /// A knot is not where even spacing puts it.
    #[error("{axis}: knot {index} is at {found}, even spacing puts it at {expected}")]
    NotUniform {
        /// The axis, with its symbol.
        axis: &'static str,
        /// The knot, from 0.
        index: usize,
        /// Its logarithm.
        found: f64,
        /// The logarithm that even spacing asks for.
        expected: f64,
    },
    /// An array of values has the wrong length.
    #[error("{quantity}: {found} values for {expected} knots")]
    WrongCount {
        /// Force, area or friction.
        quantity: &'static str,
        /// Values given.
        found: usize,
        /// Values needed.
        expected: usize,
    },
    /// A value is not a finite positive number.
    #[error(
        "{quantity} at speed knot {column}, indentation knot {row} is {value}; it must be positive and finite"
    )]
    InvalidValue {
        /// Force, area or friction.
        quantity: &'static str,
        /// Knot along the speed, from 0.
        column: usize,
        /// Knot along the indentation, from 0.
        row: usize,
        /// The value.
        value: f64,
    },
    /// A knot of a sampled law is not positive, finite and above the one before.
    #[error(
        "{axis}: knot {index} is {value}; knots must be positive and finite, each above the one before ({before})"
    )]
    KnotOrder {
        /// The axis, with its symbol.
        axis: &'static str,
        /// The knot, from 0.
        index: usize,
        /// Its value.
        value: f64,
        /// The one before; 0 for the first.
        before: f64,
    },
    /// A friction coefficient of a sampled law is not finite.
    #[error("friction at speed knot {column}, indentation knot {row} is {value}; it must be finite")]
    InvalidFriction {
        /// Knot along the speed, from 0.
        column: usize,
        /// Knot along the indentation, from 0.
        row: usize,
        /// The value.
        value: f64,
    },
    /// A number is outside the values for which it makes sense.
    #[error("{name} = {value} must be {requirement}")]
    InvalidNumber {
        /// The number, with its symbol.
        name: &'static str,
        /// Its value.
        value: f64,
        /// What it must be.
        requirement: &'static str,
    },
    /// The compliances of the terms do not bridge the two moduli.
    #[error("the terms' compliances C_k E0 sum to {sum}, but 1 - E0/E∞ is {expected}")]
    ComplianceSum {
        /// Σ C_k E0.
        sum: f64,
        /// 1 − E0/E∞.
        expected: f64,
    },
    /// A layer under a cylinder that cannot be.
    #[error(transparent)]
    Layer(#[from] KernelError),
    /// A cylinder that its layer cannot hold at a depth.
    #[error(transparent)]
    Cylinder(#[from] CylinderError),
    /// A law file is not JSON, or lacks a field, or has one too many.
    #[error("law file: {0}")]
    Json(#[from] serde_json::Error),
    /// A JSON file of something else.
    #[error(
        "law file: `format` is {found:?}, not {expected:?}: this is no file that a contact-law analysis has left"
    )]
    WrongFormat {
        /// What the file says; empty where it says nothing.
        found: String,
        /// What a law file says.
        expected: &'static str,
    },
    /// A law file of another version.
    #[error("law file: version {found} cannot be read, only version {understood}")]
    WrongVersion {
        /// The file's version.
        found: u32,
        /// The version that is understood.
        understood: u32,
    },
    /// The limits in a law file are not those of its material and indenter.
    #[error("law file: {name} is {found}, but the material and the indenter make it {expected}")]
    LimitsDisagree {
        /// Which limit.
        name: &'static str,
        /// The number in the file.
        found: f64,
        /// The number that follows from the material and the indenter.
        expected: f64,
    },
    /// A sweep was asked to stop; what it had finished was handed out.
    #[error("interrupted after {finished} solved points")]
    Interrupted {
        /// Points solved, those given at the start included.
        finished: usize,
    },
    /// Points that could not be solved; a law has no holes, so there is none.
    #[error("{} of {attempted} points could not be solved, the first at {}", failures.len(), first_failure(failures))]
    FailedPoints {
        /// Points of the refinement level in which it happened.
        attempted: usize,
        /// The points and their causes, in order of depth, then speed.
        failures: Vec<FailedPoint>,
    },
}

fn first_failure(failures: &[FailedPoint]) -> String {
    failures.first().map_or_else(String::new, ToString::to_string)
}

/// A point of a sweep without a solution.
#[derive(Debug, Clone, PartialEq)]
pub struct FailedPoint {
    /// v̂.
    pub velocity: f64,
    /// ŷ.
    pub indentation: f64,
    /// What the solver said.
    pub cause: String,
}

impl fmt::Display for FailedPoint {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "v τ/R = {:.4e}, δ/R = {:.4e}: {}", self.velocity, self.indentation, self.cause)
    }
}
