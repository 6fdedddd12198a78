use judder_contact::friction::FrictionError;
use judder_numerics::polynomial::PolynomialError;
use judder_numerics::words::plain;
use thiserror::Error;

/// Why an oscillator has no answer.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum OscillatorError {
    /// A dimensionless group is outside the values for which the model makes sense.
    #[error("{name} = {value} must be {requirement}")]
    InvalidGroup {
        /// The group, with its symbol.
        name: &'static str,
        /// Its value.
        value: f64,
        /// What it must be.
        requirement: &'static str,
    },
    /// Numbers that make no friction coefficient.
    #[error(transparent)]
    Friction(#[from] FrictionError),
    /// No steady sliding with contact in the range that was searched.
    #[error(
        "no steady sliding with contact for indentations y/R between {searched_from} and {searched_to}",
        searched_from = plain(*.searched_from), searched_to = plain(*.searched_to),
    )]
    NoEquilibrium {
        /// Smallest ŷ that was looked at.
        searched_from: f64,
        /// Largest ŷ that was looked at.
        searched_to: f64,
    },
    /// More than one steady sliding state: the linear analysis of "the" equilibrium has no meaning.
    #[error("{} steady sliding states, at indentations y/R = {indentations:?}", indentations.len())]
    SeveralEquilibria {
        /// All ŷ_e found, ascending.
        indentations: Vec<f64>,
    },
    /// The equilibrium iteration did not settle.
    #[error(
        "equilibrium not converged after {iterations} iterations: y/R = {indentation}, residual {residual} of the load",
        indentation = plain(*.indentation), residual = plain(*.residual),
    )]
    EquilibriumNotConverged {
        /// Iterations made.
        iterations: usize,
        /// Last ŷ.
        indentation: f64,
        /// Force imbalance over the normal load.
        residual: f64,
    },
    /// A matrix entry is NaN or infinite.
    #[error("entry ({}, {}) of the {matrix} matrix is not finite: {value}", row + 1, column + 1)]
    NotFinite {
        /// `"mass"`, `"damping"` or `"stiffness"`.
        matrix: &'static str,
        /// Row, from 0.
        row: usize,
        /// Column, from 0.
        column: usize,
        /// The entry.
        value: f64,
    },
    /// The mass matrix is not symmetric and positive definite.
    #[error("the mass matrix {mass:?} is not symmetric and positive definite")]
    InvalidMass {
        /// The matrix, row by row.
        mass: [[f64; 2]; 2],
    },
    /// The eigenvalues are beyond the range of numbers.
    #[error("the eigenvalues are not finite: entries as large as {largest} overflow on the way", largest = plain(*.largest))]
    Overflow {
        /// The largest magnitude among the entries of C and K.
        largest: f64,
    },
    /// The eigenvalues did not come out.
    #[error("eigenvalues: {0}")]
    Spectrum(#[from] PolynomialError),
}
