//! How large the grids of an analysis will be.

use super::single::run::grid;
use crate::contact::case::ContactCase;
use crate::contact::settings::{ContactSettings, LawSettings};
use crate::contact::shape::ShapeSettings;
use crate::error::ModelError;
use crate::indenter::height_map;
use crate::material::ContactScales;
use judder_contact::law::boundary_elements::sweep_accuracy;
use judder_contact::periodic_contact::FINEST;
use judder_contact::steady::GridChoice;

/// Columns and rows that a contact will need.
///
/// # Errors
/// Heights that cannot be read.
pub(crate) fn lattice(
    case: &ContactCase,
    settings: &ContactSettings,
    scales: &ContactScales,
) -> Result<[usize; 2], ModelError> {
    let cells = match (&case.shape, grid(settings, scales)) {
        (ShapeSettings::Cylinder, _) => {
            return Ok([settings.cells().unwrap_or_else(|| strips_for(settings.accuracy)), 1]);
        }
        (ShapeSettings::Rough(rough), _) => return Ok(refined([rough.cells; 2], settings.accuracy)),
        (shape, _) if shape.is_periodic() => {
            let heights = height_map(shape, scales.scales.radius)?.grid();
            return Ok(refined([heights.columns, heights.rows], settings.accuracy));
        }
        (_, GridChoice::Automatic) => cells_for(settings.accuracy),
        (_, GridChoice::Cells(cells) | GridChoice::Fixed { cells, .. }) => cells,
    };
    Ok([cells; 2])
}

/// Columns and rows that the contacts of a law usually need.
pub(crate) fn lattice_of_law(shape: &ShapeSettings, law: &LawSettings) -> [usize; 2] {
    lattice_of_contacts(*shape == ShapeSettings::Cylinder, sweep_accuracy(law.accuracy).contacts)
}

/// Columns and rows that contacts of an accuracy usually need, of a line or not.
pub(crate) fn lattice_of_contacts(is_line: bool, accuracy: f64) -> [usize; 2] {
    if is_line { [strips_for(accuracy), 1] } else { [cells_for(accuracy); 2] }
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

/// Columns and rows that an accuracy usually needs of a surface that repeats itself, whose heights are its coarsest grid.
fn refined(mut lattice: [usize; 2], accuracy: f64) -> [usize; 2] {
    for _ in 0..if accuracy >= 1e-2 { 2 } else { 4 } {
        let finer = lattice.map(|cells| 2 * cells);
        if finer[0] * finer[1] > FINEST {
            break;
        }
        lattice = finer;
    }
    lattice
}

/// Strips that an accuracy of a line contact usually needs.
fn strips_for(accuracy: f64) -> usize {
    match accuracy {
        a if a >= 1e-2 => 512,
        a if a >= 1e-3 => 2048,
        _ => 16384,
    }
}
