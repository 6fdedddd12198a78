//! Contact without tension and without penetration.

pub mod active_set;
pub mod problem;
pub mod symmetric;

pub use problem::{
    Loading, UnilateralError, UnilateralErrors, UnilateralLimits, UnilateralProblem, UnilateralSolution,
};
