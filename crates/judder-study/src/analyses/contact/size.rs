//! How large the grids of an analysis will be.

use super::line::STRIPS;
use super::single::grid;

use crate::error::StudyError;
use crate::indenter::height_map;
use crate::material::ContactScales;
use judder_case::{ContactCase, ContactSettings, LawSettings, Shape};
use judder_contact::law::boundary_elements::sweep_accuracy;
use judder_contact::steady::GridChoice;

/// Columns and rows that a contact will need; the heights of a surface that repeats itself are its grid.
///
/// # Errors
/// Heights that cannot be read.
pub(crate) fn lattice(
    case: &ContactCase,
    settings: &ContactSettings,
    scales: &ContactScales,
) -> Result<[usize; 2], StudyError> {
    let cells = match (&case.shape, grid(settings, scales)) {
        (Shape::Cylinder, _) => return Ok([settings.cells.unwrap_or(STRIPS), 1]),
        (Shape::Rough(rough), _) => rough.cells,
        (shape, _) if shape.is_periodic() => {
            let heights = height_map(shape, scales.scales.radius)?.grid();
            return Ok([heights.columns, heights.rows]);
        }
        (_, GridChoice::Automatic) => cells_for(settings.accuracy),
        (_, GridChoice::Cells(cells) | GridChoice::Fixed { cells, .. }) => cells,
    };
    Ok([cells; 2])
}

/// Cells a side that the contacts of a law usually need.
pub(crate) fn cells_of_law(law: &LawSettings) -> usize {
    cells_for(sweep_accuracy(law.accuracy).contacts)
}

/// Cells a side that an accuracy of the force usually needs.
fn cells_for(accuracy: f64) -> usize {
    match accuracy {
        a if a >= 1e-2 => 64,
        a if a >= 3e-3 => 128,
        a if a >= 3e-4 => 256,
        a if a >= 1e-4 => 512,
        _ => 1024,
    }
}
