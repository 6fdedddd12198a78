//! What is different where the indenter goes on for ever across the direction of sliding: the line contact.
//!
//! A plane half-space has no absolute displacement: a load moves its surface by an amount that grows with the logarithm of the
//! distance to what is held. Pressure, width and friction under a load do not depend on it. The depth that is told is
//! measured against the surface that the same force on a line would leave at the distance R; a body that is held
//! D below the surface goes down by (2/π) (ln D/R − ν/(2(1−ν))) F/E0* more
//! ([`reference_at_depth`](crate::kernel::line::reference_at_depth)). The surface of a layer on a rigid base has a place at rest: there the
//! depth is what it is, and may be imposed.

use super::SteadyQuestion;
use super::error::SteadyError;
use super::posed::Posed;
use super::start::LevelStart;
use crate::kernel::sliding::SlidingOperator;
use crate::surface::grid::SurfaceGrid;
use crate::unilateral::Loading;
use std::f64::consts::{E, FRAC_2_PI};

/// The problem of one row of strips.
///
/// The solver measures its errors by the depth. So the operator's reference distance is chosen such that the depth is as
/// large as the undeformed indenter is high at twice the half width of the contact that is started from; with a
/// reference far away the depth would be that of a body and hide gaps as large as the contact is high.
pub(super) fn pose(
    question: &SteadyQuestion<'_>,
    grid: &SurfaceGrid,
    start: &LevelStart,
) -> Result<Posed, SteadyError> {
    if let Some(layer) = &question.substrate.layer {
        let operator = SlidingOperator::on_layer(*grid, question.substrate, layer, question.memory)?;
        let loading = match question.loading {
            Loading::Load(load) => Loading::Load(load * grid.cell),
            depth @ Loading::Indentation(_) => depth,
        };
        return Ok(Posed { operator, loading, indentation: start.indentation, datum: 0.0 });
    }
    let Loading::Load(load) = question.loading else {
        return Err(SteadyError::LineIndentation);
    };
    // What the depth gains when the reference distance grows by a factor e.
    let gain = FRAC_2_PI * load * question.substrate.relaxed();
    let (depth, reference) = match start.half_width() {
        Some(half_width) => {
            let depth = question.profile.height(2.0 * half_width, 0.0);
            (depth, libm::exp((depth - start.indentation) / gain))
        }
        None => {
            // Nothing is known but that the depth is positive beyond the contact and its wakes.
            let longest = question.substrate.terms.iter().map(|term| term.length).fold(0.0, f64::max);
            (start.indentation, E * (grid.cell * grid.columns as f64 + longest))
        }
    };
    let operator = SlidingOperator::line(*grid, question.substrate, reference, question.memory)?;
    // A strip's force per length is p h, and the solver knows squares with p h².
    let loading = Loading::Load(load * grid.cell);
    Ok(Posed { operator, loading, indentation: depth, datum: gain * libm::log(reference) })
}
