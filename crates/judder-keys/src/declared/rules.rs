//! The rules by which the types of declared keys are read.

use crate::dimension::Dimension;
use crate::numeric_key::Range;

/// A number: its dimension and its range, in SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Number {
    /// The dimension.
    pub dimension: Dimension,
    /// The numbers allowed, in SI units.
    pub range: Range,
}

/// The largest whole number: no limit.
pub const UNLIMITED: usize = usize::MAX >> 1;

/// A whole number from one to another.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Whole {
    /// The smallest.
    pub from: usize,
    /// The largest.
    pub to: usize,
}

/// Two numbers, what they are, and whether the second must be larger.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NumberPair {
    /// What each may be.
    pub of: Number,
    /// What they are, in words.
    pub what: &'static str,
    /// Whether the second must be larger.
    pub is_ascending: bool,
}

/// A list as long as its type, and what stands in it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fixed<R> {
    /// What each may be.
    pub of: R,
    /// What they are, in words.
    pub what: &'static str,
}

/// A list, and how long it may be: that is told, and the settings check it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Several<R> {
    /// What each may be.
    pub of: R,
    /// The fewest and the most.
    pub length: [usize; 2],
}

impl Number {
    /// Above zero.
    pub const fn positive(dimension: Dimension) -> Self {
        Self { dimension, range: Range::Positive }
    }

    /// Zero or above.
    pub const fn non_negative(dimension: Dimension) -> Self {
        Self { dimension, range: Range::NonNegative }
    }

    /// Any finite number.
    pub const fn any(dimension: Dimension) -> Self {
        Self { dimension, range: Range::Any }
    }
}
