use crate::OscillatorError;
use judder_numerics::piecewise::MarchError;
use judder_numerics::polynomial::PolynomialError;
use judder_numerics::words::plain;
use thiserror::Error;

/// Why there is no cycle.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum CycleError {
    /// The motion cannot be followed.
    #[error(transparent)]
    Motion(#[from] MarchError),
    /// The oscillator has no steady sliding.
    #[error(transparent)]
    Oscillator(#[from] OscillatorError),
    /// The motion dies out.
    #[error(
        "the motion comes to steady sliding after a time of {time:.4}; a larger disturbance reaches a cycle if there is one beside it"
    )]
    ComesToRest {
        /// After which time.
        time: f64,
    },
    /// The motion does not repeat itself.
    #[error(
        "the motion does not repeat itself within a time of {time:.4}: it is irregular, or its transient is longer"
    )]
    Irregular {
        /// Within which time.
        time: f64,
    },
    /// The motion does not come back to the section.
    #[error("the motion does not come back to x' = 0 within a time of {time:.4}")]
    NoReturn {
        /// Within which time.
        time: f64,
    },
    /// Newton's method does not settle.
    #[error(
        "Newton's method does not settle: after {iterations} iterations the return misses its start by {residual} of the scale",
        residual = plain(*.residual),
    )]
    NotConverged {
        /// Iterations made.
        iterations: usize,
        /// Distance of the return from the start.
        residual: f64,
    },
    /// Whoever asked for the cycle has no more time for it.
    #[error("stopped after {flights} flights around cycles")]
    Stopped {
        /// Flights made.
        flights: usize,
    },
    /// Beside a Hopf point Newton's method goes elsewhere.
    #[error("beside the Hopf point no cycle is found that follows the amplitude law")]
    NotBorn,
    /// Newton's method leads to a solution that is no neighbour.
    #[error(
        "Newton's method leads to no neighbour of the last cycle, of period {from:.4}, but to steady sliding or another piece of the branch, of period {to:.4}"
    )]
    Elsewhere {
        /// Period of the last cycle.
        from: f64,
        /// Period of the solution.
        to: f64,
    },
    /// The derivative of the return map is singular or not finite.
    #[error("the derivative of the return map is singular or not finite: a fold, or a grazing event")]
    Singular,
    /// The Floquet multipliers did not come out.
    #[error("Floquet multipliers: {0}")]
    Multipliers(#[from] PolynomialError),
}
