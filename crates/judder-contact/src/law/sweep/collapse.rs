//! The sweep along the one curve of a paraboloid.

use super::solving::Solving;
use super::{
    LawSample, LawSweep, SolvedLawPoint, SweepEnd, SweepLevel, SweepObserver, check_accuracy, excess,
    is_solver_noise,
};
use crate::law::collapsed::CollapsedLaw;
use crate::law::error::LawError;
use crate::law::knots::Knots;
use crate::law::limits::LawIndenter;
use crate::law::material::LawMaterial;
use crate::law::quantities::PerQuantity;
use crate::law::scaled::{SPEED_AXIS, velocity};
use std::fmt::Display;

/// Knots of the first level: enough for a bell over six decades to be seen.
const FIRST_KNOTS: usize = 9;

/// What a sweep along z is asked for.
#[derive(Debug, Clone, PartialEq)]
pub struct CollapseRequest {
    /// The substrate.
    pub material: LawMaterial,
    /// Where the values come from, in words.
    pub source: String,
    /// ln z from slow to fast; [`SweepRange::all_speeds`](super::SweepRange::all_speeds) is all that matters.
    pub ln_speeds: (f64, f64),
    /// ŷ at which the contact is solved; by the collapse any will do.
    pub indentation: f64,
    /// The largest relative interpolation error of each quantity.
    pub accuracy: PerQuantity<f64>,
    /// The most points that may be solved.
    pub most_points: usize,
}

/// Solves the contact of a paraboloid along z = v̂/√ŷ until the curve through the solutions is as accurate as asked.
///
/// Sampler, known points, observer and reproducibility as in [`sweep`](super::sweep).
///
/// # Errors
/// As [`sweep`](super::sweep).
pub fn collapse_sweep<S, E>(
    request: &CollapseRequest,
    known: &[SolvedLawPoint],
    sampler: &S,
    observer: &dyn SweepObserver,
) -> Result<LawSweep<CollapsedLaw>, LawError>
where
    S: Fn(f64, f64) -> Result<LawSample, E> + Sync,
    E: Display,
{
    check_accuracy(request.accuracy)?;
    request.material.clone().checked()?;
    let indentation = request.indentation;
    if !(indentation > 0.0 && indentation.is_finite()) {
        let requirement = "positive and finite";
        return Err(LawError::InvalidNumber { name: "indentation δ/R", value: indentation, requirement });
    }
    let mut speeds = Knots::new(SPEED_AXIS, request.ln_speeds.0, request.ln_speeds.1, FIRST_KNOTS)?;
    let mut solving = Solving::new(sampler, observer, known);
    let mut levels: Vec<SweepLevel> = Vec::new();
    let mut before = PerQuantity::uniform(f64::INFINITY);
    loop {
        let points: Vec<(f64, f64)> =
            speeds.iter().map(|ln_speed| (velocity(ln_speed, libm::log(indentation)), indentation)).collect();
        solving.solve(&points)?;
        let (values, solver) = solving.values(LawIndenter::Paraboloid);
        let law =
            CollapsedLaw::new(request.material.clone(), request.source.clone(), speeds, values, solver)?;
        let errors = law.data().errors().interpolation;
        levels.push(SweepLevel {
            columns: speeds.count(),
            rows: 1,
            along_speed: errors,
            along_indentation: PerQuantity::uniform(0.0),
        });
        let end = if excess(errors, request.accuracy) <= 1.0 {
            Some(SweepEnd::Accurate)
        } else if is_solver_noise(before, errors, solver, request.accuracy) {
            Some(SweepEnd::SolverError)
        } else if speeds.refined().count() > request.most_points {
            Some(SweepEnd::MostPoints)
        } else {
            None
        };
        if let Some(end) = end {
            return Ok(LawSweep { law, end, levels, points: solving.into_points() });
        }
        before = errors;
        speeds = speeds.refined();
    }
}
