//! Laws made from a contact solver: knots are added until the law no longer moves.
//!
//! The grid of knots starts coarse. As long as the values at every second knot are not predicted by the others to the asked
//! accuracy, along the speed or along the depth, that axis is halved. A level's points are independent and are solved in
//! parallel, so that nothing depends on the number of threads.

mod collapse;
mod plane;
mod solving;

pub use collapse::{CollapseRequest, collapse_sweep};
pub use plane::{SweepRange, SweepRequest, sweep};

use crate::law::error::LawError;
use crate::law::quantities::PerQuantity;
use serde::{Deserialize, Serialize};

/// What a contact solver says about one speed and depth.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LawSample {
    /// F̃ = F/(E0* R²).
    pub force: f64,
    /// Ã = A/R².
    pub area: f64,
    /// μ_visc.
    pub friction: f64,
    /// Estimated relative error of F̃.
    pub force_error: f64,
    /// Estimated relative error of Ã.
    pub area_error: f64,
    /// Estimated relative error of μ_visc.
    pub friction_error: f64,
}

impl LawSample {
    fn values(&self) -> PerQuantity<f64> {
        PerQuantity { force: self.force, area: self.area, friction: self.friction }
    }

    fn errors(&self) -> PerQuantity<f64> {
        PerQuantity { force: self.force_error, area: self.area_error, friction: self.friction_error }
    }
}

/// A solved point of a sweep: what is kept to resume it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SolvedLawPoint {
    /// v̂ = v τ/R.
    pub velocity: f64,
    /// ŷ = δ/R.
    pub indentation: f64,
    /// The solution.
    pub sample: LawSample,
}

/// Who watches a sweep.
pub trait SweepObserver: Sync {
    /// A level begins, of which so many points are yet to be solved.
    fn begins(&self, points: usize) {
        let _ = points;
    }

    /// A point was solved, the `done`-th of the `planned` points of this level; called from any thread, in any order.
    fn finished(&self, point: &SolvedLawPoint, done: usize, planned: usize) {
        let _ = (point, done, planned);
    }

    /// Whether to stop; asked before every point.
    fn interrupted(&self) -> bool {
        false
    }
}

/// Nobody watches.
impl SweepObserver for () {}

/// Why a sweep ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SweepEnd {
    /// The interpolation errors are below the asked accuracy.
    Accurate,
    /// The interpolation error no longer falls and is of the size of the solver's own error.
    SolverError,
    /// Another level would take more points than allowed.
    MostPoints,
}

/// One level of a sweep.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SweepLevel {
    /// Knots along the speed.
    pub columns: usize,
    /// Knots along the depth.
    pub rows: usize,
    /// Largest relative deviation at knots left out along the speed.
    pub along_speed: PerQuantity<f64>,
    /// Largest relative deviation at knots left out along the depth.
    pub along_indentation: PerQuantity<f64>,
}

/// A finished sweep.
#[derive(Debug, Clone, PartialEq)]
pub struct LawSweep<L> {
    /// The law; its errors tell what was reached.
    pub law: L,
    /// Why it ended.
    pub end: SweepEnd,
    /// The levels, coarse to fine.
    pub levels: Vec<SweepLevel>,
    /// The points of the table, by depth, then speed.
    pub points: Vec<SolvedLawPoint>,
}

/// The largest of the three errors over its accuracy.
fn excess(errors: PerQuantity<f64>, accuracy: PerQuantity<f64>) -> f64 {
    errors
        .zip(accuracy)
        .map(|(error, accuracy)| error / accuracy)
        .into_array()
        .into_iter()
        .fold(0.0, f64::max)
}

/// Whether an axis stopped converging at the solver's own error.
///
/// A C² cubic spline gains a factor of up to 16 a level; less than 2 on an error that the solver's own explains is noise.
fn is_solver_noise(
    before: PerQuantity<f64>,
    now: PerQuantity<f64>,
    solver: PerQuantity<f64>,
    accuracy: PerQuantity<f64>,
) -> bool {
    const LEAST_GAIN: f64 = 2.0;
    // a deviation compares one knot with a few others, each wrong by the solver's error
    const NOISE: f64 = 3.0;
    before
        .zip(now)
        .zip(solver.zip(accuracy))
        .into_array()
        .into_iter()
        .filter(|((_, now), (_, accuracy))| now > accuracy)
        .all(|((before, now), (solver, _))| now * LEAST_GAIN > before && now <= NOISE * solver)
}

/// Refuses an accuracy that no sweep reaches.
fn check_accuracy(accuracy: PerQuantity<f64>) -> Result<(), LawError> {
    for value in accuracy.into_array() {
        if !(value > 0.0 && value.is_finite()) {
            return Err(LawError::InvalidNumber {
                name: "accuracy",
                value,
                requirement: "positive and finite",
            });
        }
    }
    Ok(())
}
