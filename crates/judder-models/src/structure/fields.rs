//! Shapes of modes as files: for ParaView, still and moving, and for test engineers.

use crate::error::ModelError;
use crate::structure::build::StructureLayout;
use crate::written::written;
use judder_exchange::ExchangeError;
use judder_exchange::geometry::{Geometry, at_phase};
use judder_exchange::universal::{
    ComplexShape, RealShape, write_complex_shape, write_lines, write_nodes, write_real_shape, write_units,
};
use judder_exchange::vtu::{FieldValues, VtuField, complex_fields, write_pvd, write_vtu};
use judder_structure::mesh::Mesh;
use num_complex::Complex64;
use std::f64::consts::TAU;

/// Modes that move, at most.
const MOVING: usize = 6;
/// Pictures of a period.
const FRAMES: usize = 16;
/// What the numbers of all pictures may take, bytes.
const MOVING_BYTES: usize = 64 << 20;

/// A shape with its name and its frequency.
pub(super) struct NamedShape {
    /// Its name in ParaView, such as `mode 1 (45.5 Hz)`.
    pub(super) name: String,
    /// Displacements of all freedoms.
    pub(super) vector: Vec<Complex64>,
    /// Im λ/2π, Hz; zero for what does not swing.
    pub(super) frequency: f64,
    /// What else test engineers want to know of it.
    pub(super) mode: ModeKind,
}

/// A mode whose shape is real or complex.
pub(super) enum ModeKind {
    /// An undamped one, mass-normalised.
    Real {
        /// ζ, zero where there is none.
        damping_ratio: f64,
    },
    /// A complex one.
    Complex {
        /// λ in 1/s.
        eigenvalue: Complex64,
        /// ψᴴ(2λM + C)φ.
        modal_a: Complex64,
    },
}

impl NamedShape {
    fn at_points(&self, layout: &StructureLayout) -> Vec<[Complex64; 3]> {
        layout.displacements(&self.vector).chunks_exact(3).map(|u| [u[0], u[1], u[2]]).collect()
    }
}

/// The fields of all shapes in one file, and the first that swing as series of files.
pub(super) fn fields(
    name: &str,
    layout: Option<&StructureLayout>,
    mesh: Option<&Mesh>,
    shapes: &[NamedShape],
) -> Result<Vec<(String, Vec<u8>)>, ModelError> {
    let Some(layout) = layout else { return Ok(Vec::new()) };
    let geometry = match mesh {
        Some(mesh) => Geometry { labels: labels(layout), ..Geometry::from(mesh) },
        None => Geometry { places: layout.points.clone(), labels: labels(layout), ..Geometry::default() },
    };
    let mut still = Vec::new();
    for shape in shapes {
        let values = shape.at_points(layout);
        match shape.mode {
            ModeKind::Complex { .. } => still.extend(complex_fields(&shape.name, &values)),
            ModeKind::Real { .. } => {
                let real = values.iter().map(|u| u.map(|u| u.re)).collect();
                still.push(VtuField { name: shape.name.clone(), values: FieldValues::Vectors(real) });
            }
        }
    }
    let mut files = vec![
        (format!("fields/{name}.vtu"), written(|to| write_vtu(to, &geometry, &still))?),
        (format!("fields/{name}.unv"), written(|to| universal(to, &geometry, layout, shapes))?),
    ];
    let most = MOVING.min(MOVING_BYTES / (FRAMES * 24 * geometry.places.len().max(1)));
    let swinging = shapes.iter().enumerate().filter(|(_, shape)| shape.frequency > 0.0);
    for (number, shape) in swinging.take(most) {
        files.extend(series(&format!("{name}-mode-{}", number + 1), &geometry, layout, shape)?);
    }
    Ok(files)
}

/// The numbers of the points in files for test engineers: those that they have, or one more where there is a zero.
fn labels(layout: &StructureLayout) -> Vec<usize> {
    let shift = label_shift(layout);
    layout.names.iter().map(|name| name + shift).collect()
}

/// How far numbers of points move because labels are positive.
pub(super) fn label_shift(layout: &StructureLayout) -> usize {
    usize::from(layout.names.contains(&0))
}

/// Shapes with their places and lines, for test engineers.
fn universal(
    to: &mut dyn std::io::Write,
    geometry: &Geometry,
    layout: &StructureLayout,
    shapes: &[NamedShape],
) -> Result<(), ExchangeError> {
    write_units(to)?;
    write_nodes(to, geometry)?;
    write_lines(to, geometry)?;
    for (k, own) in shapes.iter().enumerate() {
        let (number, values) = (k + 1, own.at_points(layout));
        match own.mode {
            ModeKind::Real { damping_ratio } => {
                let shape: Vec<[f64; 3]> = values.iter().map(|u| u.map(|u| u.re)).collect();
                let frequency_hz = own.frequency;
                let mode = RealShape { number, frequency_hz, modal_mass: 1.0, damping_ratio, shape: &shape };
                write_real_shape(to, geometry, &mode)?;
            }
            ModeKind::Complex { eigenvalue, modal_a } => {
                write_complex_shape(
                    to,
                    geometry,
                    &ComplexShape { number, eigenvalue, modal_a, shape: &values },
                )?;
            }
        }
    }
    Ok(())
}

/// One period of a shape: a file a picture, and the list of them with their times.
fn series(
    stem: &str,
    geometry: &Geometry,
    layout: &StructureLayout,
    shape: &NamedShape,
) -> Result<Vec<(String, Vec<u8>)>, ModelError> {
    let values = shape.at_points(layout);
    let mut files = Vec::with_capacity(FRAMES + 1);
    let mut frames = Vec::with_capacity(FRAMES);
    for frame in 0..FRAMES {
        let share = frame as f64 / FRAMES as f64;
        let moved = FieldValues::Vectors(at_phase(&values, TAU * share));
        let field = VtuField { name: "displacement".to_owned(), values: moved };
        let file = format!("{stem}-{frame:02}.vtu");
        files.push((format!("fields/{file}"), written(|to| write_vtu(to, geometry, &[field]))?));
        frames.push((share / shape.frequency, file));
    }
    files.push((format!("fields/{stem}.pvd"), written(|to| write_pvd(to, &frames))?));
    Ok(files)
}
