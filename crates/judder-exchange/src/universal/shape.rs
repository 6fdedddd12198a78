//! Shapes of modes: dataset 55, data at nodes.

use super::record::{begin, end, exponential, text};
use crate::cause::FileCause;
use crate::error::ExchangeError;
use crate::geometry::Geometry;
use faer::c64;
use std::io::Write;

/// A real mode.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RealShape<'a> {
    /// From 1.
    pub number: usize,
    /// f in Hz.
    pub frequency_hz: f64,
    /// φᵀMφ in kg m².
    pub modal_mass: f64,
    /// ζ.
    pub damping_ratio: f64,
    /// φ at the nodes.
    pub shape: &'a [[f64; 3]],
}

/// A complex mode.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ComplexShape<'a> {
    /// From 1.
    pub number: usize,
    /// λ in 1/s.
    pub eigenvalue: c64,
    /// Modal a = ψᴴ(2λM + C)φ with the left vector ψ; modal b is −λ a.
    pub modal_a: c64,
    /// φ at the nodes.
    pub shape: &'a [[c64; 3]],
}

/// Writes a real mode: displacements, three values a node.
///
/// # Errors
/// [`FileCause::WrongCount`] for a shape that does not fill the nodes, [`FileCause::Unwritable`].
pub fn write_real_shape(
    to: &mut dyn Write,
    geometry: &Geometry,
    mode: &RealShape<'_>,
) -> Result<(), ExchangeError> {
    let title = format!("Mode {} at {:.6} Hz", mode.number, mode.frequency_hz);
    let head = ShapeHead { title, analysis: 2, data: 2, number: mode.number };
    let parameters = [mode.frequency_hz, mode.modal_mass, mode.damping_ratio, 0.0];
    write_shape(to, geometry, &head, &parameters, mode.shape.iter().map(|own| own.to_vec()))
}

/// Writes a complex mode: displacements, real and imaginary parts of three values a node.
///
/// # Errors
/// [`FileCause::WrongCount`] for a shape that does not fill the nodes, [`FileCause::Unwritable`].
pub fn write_complex_shape(
    to: &mut dyn Write,
    geometry: &Geometry,
    mode: &ComplexShape<'_>,
) -> Result<(), ExchangeError> {
    let (value, a) = (mode.eigenvalue, mode.modal_a);
    let b = c64::new(-(value.re * a.re - value.im * a.im), -(value.re * a.im + value.im * a.re));
    let title = format!("Mode {} at {:.6} + {:.6} i 1/s", mode.number, value.re, value.im);
    let head = ShapeHead { title, analysis: 3, data: 5, number: mode.number };
    let parameters = [value.re, value.im, a.re, a.im, b.re, b.im];
    let values = mode.shape.iter().map(|own| own.iter().flat_map(|value| [value.re, value.im]).collect());
    write_shape(to, geometry, &head, &parameters, values)
}

/// What tells shapes apart.
struct ShapeHead {
    title: String,
    /// 2: normal mode, 3: complex eigenvalue.
    analysis: u32,
    /// 2: real, 5: complex.
    data: u32,
    number: usize,
}

fn write_shape(
    to: &mut dyn Write,
    geometry: &Geometry,
    head: &ShapeHead,
    parameters: &[f64],
    values: impl ExactSizeIterator<Item = Vec<f64>>,
) -> Result<(), ExchangeError> {
    geometry.check()?;
    let (said, found) = (geometry.labels.len(), values.len());
    if said != found {
        return Err(FileCause::WrongCount { what: "displacements", said, found }.into());
    }
    begin(to, 55)?;
    writeln!(to, "{}\nNONE\nNONE\nNONE\nNONE", text(&head.title))?;
    // a structure; global translations; displacement; three values a node
    let (model, characteristic, specific, count) = (1, 2, 8, 3);
    let ShapeHead { analysis, data, number, .. } = head;
    writeln!(to, "{model:>10}{analysis:>10}{characteristic:>10}{specific:>10}{data:>10}{count:>10}")?;
    writeln!(to, "{:>10}{:>10}{:>10}{number:>10}", 2, parameters.len(), 0)?;
    write_numbers(to, parameters)?;
    for (label, values) in geometry.labels.iter().zip(values) {
        writeln!(to, "{label:>10}")?;
        write_numbers(to, &values)?;
    }
    end(to)
}

fn write_numbers(to: &mut dyn Write, numbers: &[f64]) -> Result<(), ExchangeError> {
    let line: String = numbers.iter().map(|number| exponential(*number, 13, 5)).collect();
    writeln!(to, "{line}")?;
    Ok(())
}
