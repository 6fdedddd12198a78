//! From `[indenter]` to the surface that presses on the substrate.

use crate::contact::case::ContactCase;
use crate::contact::shape::{GeneratedSurface, HeightFile, ShapeSettings};
use crate::error::ModelError;
use crate::oscillator::keys::OscillatorKey;
use judder_contact::indenter::{HeightMap, IndenterShape as Surface, RoughSurface, Roughness};
use judder_contact::law::{LawIndenter, LawLayer};
use judder_contact::steady::profile::Profile;
use judder_exchange::heights::{HeightsError, read_heights};
use judder_memory::MemoryBudget;
use judder_study::StudyError;
use judder_study::input_file::{bytes, unusable};
use judder_study::model::PROGRAM_BYTES;

/// The surface of an indenter, in units of the radius (in m).
///
/// # Errors
/// A height file that cannot be read, a rough surface that cannot be.
pub(crate) fn profile(shape: &ShapeSettings, radius: f64) -> Result<Box<dyn Profile>, ModelError> {
    Ok(Box::new(match shape {
        ShapeSettings::Paraboloid => Surface::Paraboloid { radius: 1.0 },
        ShapeSettings::Sphere => Surface::Sphere { radius: 1.0 },
        ShapeSettings::Cylinder => Surface::Cylinder { radius: 1.0 },
        ShapeSettings::Heights(_) | ShapeSettings::Rough(_) => Surface::HeightMap(height_map(shape, radius)?),
    }))
}

/// The heights of a shape that has such, in units of the radius (in m).
///
/// # Errors
/// As [`profile`]; a shape without heights of its own.
pub(crate) fn height_map(shape: &ShapeSettings, radius: f64) -> Result<HeightMap, ModelError> {
    match shape {
        ShapeSettings::Heights(heights) => from_file(heights, radius),
        ShapeSettings::Rough(rough) => {
            admit(rough)?;
            Ok(generated(rough, radius).generate()?)
        }
        other => Err(ModelError::Unsupported(format!("the shape `{}` has no height map", other.name()))),
    }
}

fn from_file(heights: &HeightFile, radius: f64) -> Result<HeightMap, ModelError> {
    let path = &heights.file.path;
    let refused = |error: HeightsError| unusable(path, &error);
    let table = read_heights(path, bytes(path)?, heights.variable.as_deref()).map_err(refused)?;
    let spacing = table.spacing_in_metres(heights.unit, heights.spacing).map_err(refused)?;
    let metres = table.heights.iter().map(|height| height * heights.unit).collect();
    let map = HeightMap::new(metres, table.columns, table.rows, spacing, heights.periodic)
        .map_err(|error| unusable(path, &error))?;
    let map = map.in_units_of(radius);
    Ok(if heights.turned_over { map.turned_over() } else { map })
}

/// Refuses a rough surface that there is no memory for.
fn admit(rough: &GeneratedSurface) -> Result<(), ModelError> {
    /// Bytes a cell while it is made, transforms among them: measured of 1024², 2048² and 4096² cells 38.
    const CELL_BYTES: u128 = 38;
    let cells = rough.cells as u128;
    MemoryBudget::of_process_beside(PROGRAM_BYTES).ask(cells * cells * CELL_BYTES).map_err(|source| {
        let what = format!("a rough surface of {cells} × {cells} cells");
        StudyError::Memory { what, source }.into()
    })
}

fn generated(rough: &GeneratedSurface, radius: f64) -> RoughSurface {
    RoughSurface {
        period: rough.period / radius,
        cells: rough.cells,
        hurst: rough.hurst,
        roll_off: rough.roll_off() / radius,
        cut_off: rough.cut_off() / radius,
        roughness: match rough.roughness() {
            Roughness::Height(height) => Roughness::Height(height / radius),
            slope @ Roughness::Slope(_) => slope,
        },
        seed: rough.seed as u64,
    }
}

/// The indenter of a case as a law knows it; its radius is in m.
///
/// # Errors
/// A shape without a law.
pub(crate) fn of_law(case: &ContactCase, radius: f64) -> Result<LawIndenter, ModelError> {
    let poisson_ratio = case.inputs.number(OscillatorKey::PoissonRatio);
    match (&case.shape, case.substrate.thickness) {
        (ShapeSettings::Paraboloid, _) => Ok(LawIndenter::Paraboloid),
        (ShapeSettings::Sphere, _) => Ok(LawIndenter::Sphere),
        (ShapeSettings::Cylinder, Some(thickness)) => {
            Ok(LawIndenter::Cylinder(LawLayer { thickness: thickness / radius, poisson_ratio }))
        }
        (other, _) => {
            Err(ModelError::Unsupported(format!("there is no law for the shape `{}`", other.name())))
        }
    }
}
