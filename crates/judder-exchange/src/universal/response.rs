//! Responses over time or frequency: dataset 58, function at a nodal degree of freedom.

use super::record::{begin, end, exponential, text};
use crate::cause::FileCause;
use crate::error::ExchangeError;
use faer::c64;
use judder_structure::freedom::Direction;
use std::io::Write;

/// What a response is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ResponseKind {
    /// Values over time in s.
    TimeHistory,
    /// Response by excitation over frequency in Hz.
    FrequencyResponse,
}

/// What is measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MeasuredQuantity {
    /// In m.
    Displacement,
    /// In m/s.
    Velocity,
    /// In m/s².
    Acceleration,
    /// In N.
    Force,
}

/// Where the values are.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Abscissa<'a> {
    /// At `start`, `start + step`, …; the file holds six digits of both.
    Even {
        /// The first, in s or Hz.
        start: f64,
        /// From one to the next, in s or Hz.
        step: f64,
    },
    /// Here, in s or Hz, one for each value; the file holds six digits.
    Uneven(&'a [f64]),
}

/// The values.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Ordinates<'a> {
    /// Real ones.
    Real(&'a [f64]),
    /// Complex ones.
    Complex(&'a [c64]),
}

/// A response of one degree of freedom.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct UniversalResponse<'a> {
    /// Shown as its title.
    pub title: &'a str,
    /// What it is.
    pub kind: ResponseKind,
    /// The label of the node, and the direction, that responds.
    pub at: (usize, Direction),
    /// What it is that responds.
    pub quantity: MeasuredQuantity,
    /// The label of the node, and the direction, of the exciting force; of frequency responses.
    pub excited_at: Option<(usize, Direction)>,
    /// Where the values are.
    pub abscissa: Abscissa<'a>,
    /// The values.
    pub ordinates: Ordinates<'a>,
}

/// Writes a response in double precision.
///
/// # Errors
/// [`FileCause::WrongCount`] for values that are not one for each abscissa, [`FileCause::Unwritable`].
pub fn write_response(to: &mut dyn Write, response: &UniversalResponse<'_>) -> Result<(), ExchangeError> {
    let values: Vec<Vec<f64>> = match response.ordinates {
        Ordinates::Real(values) => values.iter().map(|value| vec![*value]).collect(),
        Ordinates::Complex(values) => values.iter().map(|value| vec![value.re, value.im]).collect(),
    };
    if let Abscissa::Uneven(places) = response.abscissa
        && places.len() != values.len()
    {
        let (said, found) = (places.len(), values.len());
        return Err(FileCause::WrongCount { what: "values of a response", said, found }.into());
    }
    begin(to, 58)?;
    write_head(to, response, values.len())?;
    match response.abscissa {
        Abscissa::Even { .. } => {
            let numbers: Vec<String> =
                values.iter().flatten().map(|value| exponential(*value, 20, 12)).collect();
            for line in numbers.chunks(4) {
                writeln!(to, "{}", line.concat())?;
            }
        }
        Abscissa::Uneven(places) => {
            for (place, values) in places.iter().zip(&values) {
                let numbers: String = values.iter().map(|value| exponential(*value, 20, 12)).collect();
                writeln!(to, "{}{numbers}", exponential(*place, 13, 5))?;
            }
        }
    }
    end(to)
}

fn write_head(
    to: &mut dyn Write,
    response: &UniversalResponse<'_>,
    count: usize,
) -> Result<(), ExchangeError> {
    let (function, axis) = match response.kind {
        ResponseKind::TimeHistory => (1, ResponseAxis::TIME),
        ResponseKind::FrequencyResponse => (4, ResponseAxis::FREQUENCY),
    };
    let data = if matches!(response.ordinates, Ordinates::Real(_)) { 4 } else { 6 };
    let (even, start, step) = match response.abscissa {
        Abscissa::Even { start, step } => (1, start, step),
        Abscissa::Uneven(_) => (0, 0.0, 0.0),
    };
    let direction = |direction: Direction| direction as usize + 1;
    let (node, way) = (response.at.0, direction(response.at.1));
    let (by_node, by_way) = response.excited_at.map_or((0, 0), |(node, way)| (node, direction(way)));
    writeln!(to, "{}\nNONE\nNONE\nNONE\nNONE", text(response.title))?;
    writeln!(
        to,
        "{function:>5}{:>10}{:>5}{:>10} {:<10}{node:>10}{way:>4} {:<10}{by_node:>10}{by_way:>4}",
        1, 0, 0, "NONE", "NONE"
    )?;
    let [start, step, z] = [start, step, 0.0].map(|value| exponential(value, 13, 5));
    writeln!(to, "{data:>10}{count:>10}{even:>10}{start}{step}{z}")?;
    let excitation = if response.excited_at.is_some() {
        ResponseAxis::of(MeasuredQuantity::Force)
    } else {
        ResponseAxis::NONE
    };
    for axis in [axis, ResponseAxis::of(response.quantity), excitation, ResponseAxis::NONE] {
        let ResponseAxis { kind, length, force, name, unit } = axis;
        writeln!(to, "{kind:>10}{length:>5}{force:>5}{:>5} {name:<20} {unit:<20}", 0)?;
    }
    Ok(())
}

/// What an axis shows: its number in the format, the exponents of length and force in its unit, its name and unit.
struct ResponseAxis {
    kind: u32,
    length: u32,
    force: u32,
    name: &'static str,
    unit: &'static str,
}

impl ResponseAxis {
    const TIME: Self = Self { kind: 17, length: 0, force: 0, name: "Time", unit: "s" };
    const FREQUENCY: Self = Self { kind: 18, length: 0, force: 0, name: "Frequency", unit: "Hz" };
    const NONE: Self = Self { kind: 0, length: 0, force: 0, name: "NONE", unit: "NONE" };

    fn of(quantity: MeasuredQuantity) -> Self {
        let (kind, length, force, name, unit) = match quantity {
            MeasuredQuantity::Displacement => (8, 1, 0, "Displacement", "m"),
            MeasuredQuantity::Velocity => (11, 1, 0, "Velocity", "m/s"),
            MeasuredQuantity::Acceleration => (12, 1, 0, "Acceleration", "m/s^2"),
            MeasuredQuantity::Force => (13, 0, 1, "Force", "N"),
        };
        Self { kind, length, force, name, unit }
    }
}
