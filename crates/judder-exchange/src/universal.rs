//! Universal files (`.unv`, `.uff`) of test engineers: nodes (dataset 2411), drawings (82), shapes (55), responses (58), units (164).
//!
//! University of Cincinnati, Structural Dynamics Research Laboratory, *Universal File Formats for Modal Analysis Testing*. Numbers have
//! the digits that the format gives them: six in shapes, thirteen in responses, seventeen in places.

mod record;
mod response;
mod shape;

pub use response::{Abscissa, MeasuredQuantity, Ordinates, ResponseKind, UniversalResponse, write_response};
pub use shape::{ComplexShape, RealShape, write_complex_shape, write_real_shape};

use crate::error::ExchangeError;
use crate::geometry::Geometry;
use record::{begin, end, exponential, text};
use std::io::Write;

/// Writes the units, dataset 164: SI.
///
/// # Errors
/// [`crate::FileCause::Unwritable`].
pub fn write_units(to: &mut dyn Write) -> Result<(), ExchangeError> {
    begin(to, 164)?;
    writeln!(to, "{:>10}{:<20}{:>10}", 1, "SI: Meter (newton)", 2)?;
    let factor = |value: f64| exponential(value, 25, 17).replace('e', "D");
    writeln!(to, "{}{}{}\n{}", factor(1.0), factor(1.0), factor(1.0), factor(273.15))?;
    end(to)
}

/// Writes places, dataset 2411, with the labels of the geometry.
///
/// # Errors
/// What is wrong with the geometry, and [`crate::FileCause::Unwritable`].
pub fn write_nodes(to: &mut dyn Write, geometry: &Geometry) -> Result<(), ExchangeError> {
    geometry.check()?;
    begin(to, 2411)?;
    for (label, place) in geometry.labels.iter().zip(&geometry.places) {
        writeln!(to, "{label:>10}{:>10}{:>10}{:>10}", 1, 1, 11)?;
        let [x, y, z] = place.map(|value| exponential(value, 25, 16).replace('e', "D"));
        writeln!(to, "{x}{y}{z}")?;
    }
    end(to)
}

/// Entries of a trace line: readers take 250, three a piece.
const PIECES: usize = 83;

/// Writes the lines of a drawing, datasets 82: the outer edges of the elements.
///
/// # Errors
/// What is wrong with the geometry, and [`crate::FileCause::Unwritable`].
pub fn write_lines(to: &mut dyn Write, geometry: &Geometry) -> Result<(), ExchangeError> {
    geometry.check()?;
    for (k, pieces) in geometry.lines().chunks(PIECES).enumerate() {
        begin(to, 82)?;
        // zero lifts the pen; the first node needs no zero
        let labels = pieces.iter().flat_map(|[a, b]| [0, geometry.labels[*a], geometry.labels[*b]]).skip(1);
        let labels: Vec<usize> = labels.collect();
        writeln!(to, "{:>10}{:>10}{:>10}\n{}", k + 1, labels.len(), 11, text("Edges"))?;
        for line in labels.chunks(8) {
            for label in line {
                write!(to, "{label:>10}")?;
            }
            writeln!(to)?;
        }
        end(to)?;
    }
    Ok(())
}
