//! The numbers that a key takes.

use judder_numerics::words::plain;
use std::fmt;

/// The numbers that a key takes; every number must be finite besides.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Range {
    /// Above zero.
    Positive,
    /// Zero or above.
    NonNegative,
    /// Zero or above, below one.
    Fraction,
    /// Any finite number.
    Any,
    /// Above the first number, up to and including the second.
    Interval {
        /// Excluded lower end.
        above: f64,
        /// Included upper end.
        up_to: f64,
    },
    /// From the first number to the second, both included.
    Closed {
        /// Lower end.
        from: f64,
        /// Upper end.
        to: f64,
    },
}

impl Range {
    /// Whether `number` lies in the range; a NaN lies in none.
    pub fn contains(self, number: f64) -> bool {
        number.is_finite()
            && match self {
                Self::Positive => number > 0.0,
                Self::NonNegative => number >= 0.0,
                Self::Fraction => (0.0..1.0).contains(&number),
                Self::Any => true,
                Self::Interval { above, up_to } => number > above && number <= up_to,
                Self::Closed { from, to } => (from..=to).contains(&number),
            }
    }

    /// The range in signs.
    pub(crate) fn signs(self) -> String {
        match self {
            Self::Positive => "> 0".to_owned(),
            Self::NonNegative => "≥ 0".to_owned(),
            Self::Fraction => "≥ 0, < 1".to_owned(),
            Self::Any => "any".to_owned(),
            Self::Interval { above, up_to } => format!("> {above}, ≤ {up_to}").replace('-', "−"),
            Self::Closed { from, to } => format!("≥ {from}, ≤ {to}").replace('-', "−"),
        }
    }
}

impl fmt::Display for Range {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Positive => formatter.write_str("positive"),
            Self::NonNegative => formatter.write_str("zero or positive"),
            Self::Fraction => formatter.write_str("zero or positive, and below one"),
            Self::Any => formatter.write_str("finite"),
            Self::Interval { above, up_to } => {
                write!(formatter, "above {} and at most {}", plain(*above), plain(*up_to))
            }
            Self::Closed { from, to } => write!(formatter, "from {} to {}", plain(*from), plain(*to)),
        }
    }
}
