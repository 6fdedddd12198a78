//! What a material refuses.

use judder_numerics::words::plain;
use std::f64::consts::TAU;
use thiserror::Error;

/// Why numbers do not make a viscoelastic material.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum MaterialError {
    /// A quantity that must be positive and finite is not.
    #[error("{name} is {value}; it must be a positive, finite number")]
    NotPositive {
        /// What it is, with its symbol.
        name: &'static str,
        /// Its value.
        value: f64,
    },
    /// A term of a spectrum has a part that is not positive and finite.
    #[error("term {index} of the spectrum has the {name} {value}; it must be a positive, finite number")]
    Term {
        /// The term, counted from 1 in the order given.
        index: usize,
        /// `"retardation time"`, `"compliance"`, `"relaxation time"` or `"modulus"`.
        name: &'static str,
        /// Its value.
        value: f64,
    },
    /// The rubbery modulus is not below the glassy one.
    #[error(
        "the rubbery modulus E0 = {rubbery} Pa is not below the glassy modulus E∞ = {glassy} Pa; give a larger glassy modulus",
        rubbery = plain(*.rubbery), glassy = plain(*.glassy),
    )]
    RubberyNotBelowGlassy {
        /// E0 \[Pa\].
        rubbery: f64,
        /// E∞ \[Pa\].
        glassy: f64,
    },
    /// The sum of a spectrum leaves the range of floating-point numbers.
    #[error("the spectrum adds up to {sum}: moduli or compliances are too far apart to be added")]
    Sum {
        /// The sum.
        sum: f64,
    },
    /// The WLF formula has no value this far below its reference.
    #[error(
        "the temperature {temperature:.2} K is too low for the WLF formula; it holds above T_ref − C2 = {lowest:.2} K"
    )]
    BelowVogel {
        /// T \[K\].
        temperature: f64,
        /// T_ref − C2 \[K\].
        lowest: f64,
    },
    /// A shift beyond what numbers hold.
    #[error(
        "at {temperature:.2} K the times shift by {decades:.0} decades, which no number holds; give a temperature nearer to the reference"
    )]
    ShiftTooLarge {
        /// T \[K\].
        temperature: f64,
        /// log10 a_T.
        decades: f64,
    },
    /// A term of the other form would be too small or too large for a floating-point number.
    #[error(
        "term {index} of the spectrum has no counterpart in the other form that a number can hold; leave it out"
    )]
    NoCounterpart {
        /// The term, counted from 1 in ascending order of times.
        index: usize,
    },
    /// A continuous spectrum is negative or not a number somewhere, or nothing everywhere.
    #[error(
        "the continuous spectrum is {value} at the retardation time {time} s; it must be positive, or zero in places",
        time = plain(*.time),
    )]
    Density {
        /// τ \[s\].
        time: f64,
        /// 𝒞(τ) [1/(Pa s)], or its integral where it is nothing.
        value: f64,
    },
    /// Too few samples of a continuous spectrum.
    #[error("{samples} samples of a continuous spectrum were given; at least two are needed")]
    Samples {
        /// Their number.
        samples: usize,
    },
    /// The range of a continuous spectrum is empty, or samples of it do not ascend.
    #[error(
        "the retardation time {after} s of the continuous spectrum comes after {before} s; times must ascend",
        after = plain(*.after), before = plain(*.before),
    )]
    Range {
        /// The earlier time \[s\].
        before: f64,
        /// The later one \[s\].
        after: f64,
    },
    /// A number of terms that no series has.
    #[error("{terms} terms were asked for; at least 1 and at most {most} are possible")]
    Terms {
        /// Terms asked for.
        terms: usize,
        /// Largest number.
        most: usize,
    },
    /// A tolerance that no series meets.
    #[error(
        "{terms} terms come within {error} of the spectrum, not within {tolerance}; allow a larger error",
        error = plain(*.error), tolerance = plain(*.tolerance),
    )]
    ToleranceNotMet {
        /// Terms tried last.
        terms: usize,
        /// Error with them.
        error: f64,
        /// Tolerance asked for.
        tolerance: f64,
    },
    /// The measured band ends before the rubbery plateau, and no modulus at rest was given.
    #[error(
        "the data, down to {lowest} rad/s ({:.4e} Hz), do not show a modulus at rest (the best fit has E0 = 0); give the \
         rubbery modulus", lowest / TAU, lowest = plain(*.lowest),
    )]
    NoPlateau {
        /// Lowest ω [rad/s].
        lowest: f64,
    },
    /// The given rubbery modulus is not below the measured ones.
    #[error(
        "the rubbery modulus {rubbery} Pa is not below the lowest measured storage modulus, {lowest} Pa; give a smaller one, or none",
        rubbery = plain(*.rubbery), lowest = plain(*.lowest),
    )]
    RubberyAboveData {
        /// E0 \[Pa\].
        rubbery: f64,
        /// Lowest E′ \[Pa\].
        lowest: f64,
    },
    /// A least-squares problem with NaN, an infinity, or parts that do not fit.
    #[error("a least-squares problem holds a number that is not finite, or its parts do not fit together")]
    LeastSquares,
    /// Measured moduli that cannot be used.
    #[error(transparent)]
    Dma(#[from] DmaError),
}

/// Why measured moduli cannot be used.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum DmaError {
    /// No data.
    #[error("there are no measurements")]
    Empty,
    /// Columns of different lengths.
    #[error(
        "the columns of the moduli have different lengths, one of them {length}, the frequencies {frequencies}"
    )]
    Columns {
        /// The length of one.
        length: usize,
        /// That of the frequencies.
        frequencies: usize,
    },
    /// A number that is not positive and finite.
    #[error("the {name} of measurement {index} is {value}; it must be a positive, finite number")]
    Value {
        /// The measurement, from 1.
        index: usize,
        /// What it is.
        name: &'static str,
        /// Its value.
        value: f64,
    },
    /// A frequency that does not rise.
    #[error(
        "the frequency of measurement {index} is {after} rad/s and does not rise above {before} rad/s, the one before; sort them by \
         temperature, then frequency, and leave doubles out"
    )]
    Order {
        /// The measurement, from 1.
        index: usize,
        /// The ω before [rad/s].
        before: f64,
        /// Its own [rad/s].
        after: f64,
    },
    /// Several temperatures where one is needed.
    #[error(
        "the data are of {sweeps} temperature sweeps; a rule that shifts them to a master curve is needed"
    )]
    SeveralTemperatures {
        /// Number of sweeps.
        sweeps: usize,
    },
    /// Shift factors that do not belong to the sweeps.
    #[error("{factors} shift factors were given for {sweeps} temperature sweeps; one a sweep is needed")]
    Factors {
        /// Number of factors.
        factors: usize,
        /// Number of sweeps.
        sweeps: usize,
    },
}

/// `value`, if it is positive and neither infinite nor so small that its inverse is.
pub(super) fn positive(name: &'static str, value: f64) -> Result<f64, MaterialError> {
    if value.is_normal() && value > 0.0 { Ok(value) } else { Err(MaterialError::NotPositive { name, value }) }
}
