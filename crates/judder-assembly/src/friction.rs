//! The friction coefficient against the slip speed.

use crate::AssemblyError;
pub use judder_contact::FallingFriction;
#[cfg(feature = "keys")]
use judder_keys::{
    declared::{Allowed, Number, Setting, Several},
    dimension::Dimension,
    document::{Data, Node},
    error::Fault,
    section::Section,
};
use judder_numerics::ramp::straight;

#[cfg(feature = "keys")]
const COEFFICIENT: Number = Number::non_negative(Dimension::NUMBER);
#[cfg(feature = "keys")]
const COEFFICIENTS: Several<Number> = Several { of: COEFFICIENT, length: [1, usize::MAX] };
#[cfg(feature = "keys")]
const SPEEDS: Several<Number> =
    Several { of: Number::non_negative(Dimension::SPEED), length: [1, usize::MAX] };

/// μ(|v|).
#[derive(Debug, Clone, PartialEq)]
pub enum Friction {
    /// One coefficient for all speeds.
    Constant(f64),
    /// One that falls from rest, or rises.
    Falling(FallingFriction),
    /// A table.
    Table(FrictionTable),
}

/// Friction coefficients at slip speeds.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "keys", derive(judder_keys::Settings))]
pub struct FrictionTable {
    /// Slip speeds, ascending, m/s.
    #[cfg_attr(feature = "keys", key(rule = SPEEDS, symbol = "v", example = "[\"0 mm/s\", \"10 mm/s\"]"))]
    pub velocity: Vec<f64>,
    /// Friction coefficients there, linear between the speeds and constant beyond them.
    #[cfg_attr(feature = "keys", key(rule = COEFFICIENTS, symbol = "μ(v)", example = "[0.4, 0.3]"))]
    pub coefficient: Vec<f64>,
}

/// A friction coefficient and its slope.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrictionAt {
    /// μ.
    pub coefficient: f64,
    /// dμ/d|v| in s/m; at a corner of a table that of the piece above it.
    pub slope: f64,
}

impl Friction {
    /// Whether there is none, at no speed.
    #[must_use]
    pub fn is_none(&self) -> bool {
        match self {
            Self::Constant(value) => *value == 0.0,
            Self::Falling(FallingFriction { at_rest, at_speed, .. }) => [*at_rest, *at_speed] == [0.0; 2],
            Self::Table(table) => table.coefficient.iter().all(|own| *own == 0.0),
        }
    }

    /// Whether its numbers make a friction coefficient.
    ///
    /// # Errors
    /// [`AssemblyError::InvalidNumber`] for a coefficient that is negative or not finite, a decay speed that is not positive, speeds
    /// that do not ascend; [`AssemblyError::Length`] for a table whose columns differ.
    pub fn check(&self) -> Result<(), AssemblyError> {
        let coefficient = |value: f64| match value.is_finite() && value >= 0.0 {
            true => Ok(()),
            false => Err(AssemblyError::InvalidNumber {
                name: "a friction coefficient",
                value,
                requirement: "finite and not negative",
            }),
        };
        match self {
            Self::Constant(value) => coefficient(*value),
            Self::Falling(FallingFriction { at_rest, at_speed, decay_speed }) => {
                coefficient(*at_rest)?;
                coefficient(*at_speed)?;
                match decay_speed.is_finite() && *decay_speed > 0.0 {
                    true => Ok(()),
                    false => Err(AssemblyError::InvalidNumber {
                        name: "the decay speed of a friction coefficient",
                        value: *decay_speed,
                        requirement: "positive",
                    }),
                }
            }
            Self::Table(FrictionTable { velocity: speeds, coefficient: coefficients }) => {
                coefficients.iter().try_for_each(|value| coefficient(*value))?;
                check_table(
                    ["the speeds of a friction table", "the coefficients of a friction table"],
                    speeds,
                    coefficients.len(),
                )
            }
        }
    }

    /// The same, multiplied.
    #[must_use]
    pub fn scaled(&self, factor: f64) -> Self {
        match self {
            Self::Constant(value) => Self::Constant(factor * value),
            Self::Falling(FallingFriction { at_rest, at_speed, decay_speed }) => {
                let [at_rest, at_speed] = [at_rest, at_speed].map(|value| factor * value);
                Self::Falling(FallingFriction { at_rest, at_speed, decay_speed: *decay_speed })
            }
            Self::Table(FrictionTable { velocity, coefficient }) => {
                let coefficient = coefficient.iter().map(|value| factor * value).collect();
                Self::Table(FrictionTable { velocity: velocity.clone(), coefficient })
            }
        }
    }

    /// μ and its slope at a slip speed in m/s.
    #[must_use]
    pub fn at(&self, speed: f64) -> FrictionAt {
        match self {
            Self::Constant(coefficient) => FrictionAt { coefficient: *coefficient, slope: 0.0 },
            Self::Falling(falling) => {
                let (coefficient, slope) = falling.at(speed);
                FrictionAt { coefficient, slope }
            }
            Self::Table(FrictionTable { velocity: speeds, coefficient: coefficients }) => {
                let (coefficient, slope) = straight(speeds, coefficients, speed);
                FrictionAt { coefficient, slope }
            }
        }
    }
}

impl Friction {
    /// Pieces on which it is smooth: between the speeds of a table, and beyond.
    pub(crate) fn pieces(&self) -> usize {
        match self {
            Self::Constant(_) | Self::Falling(_) => 1,
            Self::Table(FrictionTable { velocity, .. }) => velocity.len() + 1,
        }
    }

    /// The number of that at a slip speed in m/s.
    pub(crate) fn piece(&self, speed: f64) -> usize {
        match self {
            Self::Constant(_) | Self::Falling(_) => 0,
            Self::Table(FrictionTable { velocity, .. }) => piece_of(velocity, speed),
        }
    }
}

/// The number of the piece of a table at a place; a corner belongs to the piece above it.
pub(crate) fn piece_of(places: &[f64], at: f64) -> usize {
    places.partition_point(|place| *place <= at)
}

/// Whether a table has as many values as places, and these ascend; the first name is that of the places.
///
/// # Errors
/// [`AssemblyError::Length`], [`AssemblyError::InvalidNumber`].
pub fn check_table(
    [name, of_values]: [&'static str; 2],
    places: &[f64],
    values: usize,
) -> Result<(), AssemblyError> {
    if places.is_empty() || places.len() != values {
        return Err(AssemblyError::Length { name: of_values, found: values, expected: places.len().max(1) });
    }
    if let Some(value) = places.iter().find(|place| !place.is_finite()) {
        return Err(AssemblyError::InvalidNumber { name, value: *value, requirement: "finite" });
    }
    match places.windows(2).find(|pair| pair[1] <= pair[0]) {
        Some(pair) => {
            Err(AssemblyError::InvalidNumber { name, value: pair[1], requirement: "above the one before" })
        }
        None => Ok(()),
    }
}

/// A number, or a table against the slip speed.
#[cfg(feature = "keys")]
impl Setting for Friction {
    type Rule = ();

    fn form((): &()) -> Allowed {
        Allowed::Either(vec![f64::form(&COEFFICIENT), FallingFriction::form(&()), FrictionTable::form(&())])
    }

    fn read(section: &Section<'_>, key: &str, node: &Node, (): &()) -> Result<Self, Fault> {
        let Data::Table(table) = &node.data else {
            return f64::read(section, key, node, &COEFFICIENT).map(Self::Constant);
        };
        let falls = table
            .entries
            .iter()
            .any(|entry| ["at_rest", "at_speed", "decay_speed"].contains(&entry.key.as_str()));
        match falls {
            true => FallingFriction::read(section, key, node, &()).map(Self::Falling),
            false => FrictionTable::read(section, key, node, &()).map(Self::Table),
        }
    }

    fn write(&self, (): &()) -> serde_json::Value {
        match self {
            Self::Constant(coefficient) => coefficient.write(&COEFFICIENT),
            Self::Falling(falling) => falling.write(&()),
            Self::Table(table) => table.write(&()),
        }
    }
}
