//! The friction coefficient against the sliding speed, of every model whose contacts know no more of theirs.
//!
//! - [`falling`]: one that falls from rest and may rise again.
//! - tables of one's own are [`ValueTable`]s of speeds and coefficients.

pub mod falling;

pub use crate::table::{TableFault, TableInterpolation, ValueTable};
pub use falling::FallingFriction;

use judder_numerics::words::plain;
use thiserror::Error;

/// μ(|v|).
#[derive(Debug, Clone, PartialEq)]
pub enum Friction {
    /// One coefficient for all speeds.
    Constant(f64),
    /// One that falls from rest, or rises.
    Falling(FallingFriction),
    /// A table against the speed, m/s; constant beyond its speeds.
    Table(ValueTable),
}

/// A friction coefficient and its slope.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrictionAt {
    /// μ.
    pub coefficient: f64,
    /// dμ/d|v| in s/m; at a corner of a table that of the piece above it.
    pub slope: f64,
}

/// A slip speed beyond those of a table: the coefficient is kept constant there, which is assumed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BeyondSpeeds {
    /// The slip speed.
    pub speed: f64,
    /// The first and the last speed of the table.
    pub known: [f64; 2],
}

impl BeyondSpeeds {
    /// What is told of it, with speeds in a unit; of a model without units the unit is empty.
    #[must_use]
    pub fn text(&self, unit: &str) -> String {
        let own = |speed: f64| format!("{} {unit}", plain(speed)).trim_end().to_owned();
        let [from, to] = self.known.map(own);
        let speed = own(self.speed);
        format!(
            "the slip speed {speed} lies beyond the table of friction, which goes from {from} to {to}: that the coefficient neither falls nor rises there is \
             assumed"
        )
    }

    /// The same with speeds in another unit.
    #[must_use]
    pub fn scaled(&self, factor: f64) -> Self {
        Self { speed: factor * self.speed, known: self.known.map(|speed| factor * speed) }
    }
}

/// Why numbers make no friction coefficient.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum FrictionError {
    /// A coefficient out of its range.
    #[error("a friction coefficient is {value}: it must be finite and not negative", value = plain(*.value))]
    Coefficient {
        /// Its value.
        value: f64,
    },
    /// Another number of the law out of its range.
    #[error("the {name} of a friction coefficient is {value}: it must be {requirement}", value = plain(*.value))]
    Number {
        /// Which.
        name: &'static str,
        /// Its value.
        value: f64,
        /// What it must be.
        requirement: &'static str,
    },
    /// Speeds that do not ascend.
    #[error("the speeds of the table of friction must ascend, but {speed} follows {before}", speed = plain(*.speed), before = plain(*.before))]
    Speeds {
        /// The earlier one.
        before: f64,
        /// The later one.
        speed: f64,
    },
    /// Columns of different lengths, or none.
    #[error("the table of friction has {speeds} speeds and {coefficients} coefficients")]
    Columns {
        /// How many speeds.
        speeds: usize,
        /// How many coefficients.
        coefficients: usize,
    },
}

impl From<FallingFriction> for Friction {
    fn from(falling: FallingFriction) -> Self {
        Self::Falling(falling)
    }
}

fn coefficient(value: f64) -> Result<(), FrictionError> {
    match value.is_finite() && value >= 0.0 {
        true => Ok(()),
        false => Err(FrictionError::Coefficient { value }),
    }
}

impl Friction {
    /// Coefficients at ascending speeds.
    ///
    /// # Errors
    /// [`FrictionError`] for a coefficient that is negative or not finite, speeds that do not ascend or are below zero, columns whose
    /// lengths differ.
    pub fn table(
        speeds: Vec<f64>,
        coefficients: Vec<f64>,
        interpolation: TableInterpolation,
    ) -> Result<Self, FrictionError> {
        let columns = [speeds.len(), coefficients.len()];
        if columns[0] == columns[1] {
            coefficients.iter().try_for_each(|value| coefficient(*value))?;
        }
        if let Some(value) = speeds.iter().find(|speed| !(speed.is_finite() && **speed >= 0.0)) {
            let requirement = "finite and not negative";
            return Err(FrictionError::Number { name: "speed", value: *value, requirement });
        }
        ValueTable::new(speeds, coefficients, interpolation).map(Self::Table).map_err(|fault| match fault {
            TableFault::NotAscending { before, place } => FrictionError::Speeds { before, speed: place },
            TableFault::NotFinite(value) => FrictionError::Coefficient { value },
            TableFault::Lengths { .. } => {
                FrictionError::Columns { speeds: columns[0], coefficients: columns[1] }
            }
        })
    }

    /// Whether there is none, at no speed.
    #[must_use]
    pub fn is_none(&self) -> bool {
        match self {
            Self::Constant(value) => *value == 0.0,
            Self::Falling(FallingFriction { at_rest, at_speed, viscous, .. }) => {
                [*at_rest, *at_speed, *viscous] == [0.0; 3]
            }
            Self::Table(table) => table.values().iter().all(|own| *own == 0.0),
        }
    }

    /// Whether its numbers make a friction coefficient; those of a table do.
    ///
    /// # Errors
    /// [`FrictionError`] for a coefficient that is negative or not finite, a decay speed that is not positive, a viscous part below zero, an
    /// exponent below one.
    pub fn check(&self) -> Result<(), FrictionError> {
        match self {
            Self::Constant(value) => coefficient(*value),
            Self::Falling(FallingFriction { at_rest, at_speed, decay_speed, viscous, exponent }) => {
                coefficient(*at_rest)?;
                coefficient(*at_speed)?;
                let number = |name, value: f64, is_right: bool, requirement| match is_right {
                    true => Ok(()),
                    false => Err(FrictionError::Number { name, value, requirement }),
                };
                let is_decay = decay_speed.is_finite() && *decay_speed > 0.0;
                number("decay speed", *decay_speed, is_decay, "positive")?;
                let is_viscous = viscous.is_finite() && *viscous >= 0.0;
                number("viscous rise", *viscous, is_viscous, "finite and not negative")?;
                let is_exponent = (1.0..=falling::LARGEST_EXPONENT).contains(exponent);
                number("exponent", *exponent, is_exponent, "from 1 to 10")
            }
            Self::Table(_) => Ok(()),
        }
    }

    /// The same, multiplied.
    #[must_use]
    pub fn scaled(&self, factor: f64) -> Self {
        match self {
            Self::Constant(value) => Self::Constant(factor * value),
            Self::Falling(own) => Self::Falling(FallingFriction {
                at_rest: factor * own.at_rest,
                at_speed: factor * own.at_speed,
                viscous: factor * own.viscous,
                ..*own
            }),
            Self::Table(table) => Self::Table(table.scaled(factor)),
        }
    }

    /// μ and its slope at a slip speed |v| ≥ 0.
    #[must_use]
    pub fn at(&self, speed: f64) -> FrictionAt {
        self.on_piece(self.piece(speed), speed)
    }

    /// Whether a slip speed lies beyond those of its table, and how.
    #[must_use]
    pub fn beyond(&self, speed: f64) -> Option<BeyondSpeeds> {
        let Self::Table(table) = self else { return None };
        let known = [*table.places().first()?, *table.places().last()?];
        (speed < known[0] || speed > known[1]).then_some(BeyondSpeeds { speed, known })
    }

    /// How many pieces it has on which it is smooth: between the speeds of a table, and beyond.
    #[must_use]
    pub fn pieces(&self) -> usize {
        match self {
            Self::Constant(_) | Self::Falling(_) => 1,
            Self::Table(table) => table.pieces(),
        }
    }

    /// The number of that at a slip speed.
    #[must_use]
    pub fn piece(&self, speed: f64) -> usize {
        match self {
            Self::Constant(_) | Self::Falling(_) => 0,
            Self::Table(table) => table.piece(speed),
        }
    }

    /// μ and its slope on a piece, beyond its ends too: as it goes on there.
    #[must_use]
    pub fn on_piece(&self, piece: usize, speed: f64) -> FrictionAt {
        match self {
            Self::Constant(coefficient) => FrictionAt { coefficient: *coefficient, slope: 0.0 },
            Self::Falling(falling) => falling.at(speed),
            Self::Table(table) => {
                let (coefficient, slope) = table.on_piece(piece, speed);
                FrictionAt { coefficient, slope }
            }
        }
    }

    /// The speeds between which a piece lies; none where it goes on to rest, or for ever.
    #[must_use]
    pub fn ends(&self, piece: usize) -> [Option<f64>; 2] {
        match self {
            Self::Constant(_) | Self::Falling(_) => [None; 2],
            Self::Table(table) => {
                let end = |index: Option<usize>| table.places().get(index?).copied();
                [end(piece.checked_sub(1)).filter(|speed| *speed > 0.0), end(Some(piece))]
            }
        }
    }

    /// A coefficient that it does not pass at speeds from rest to this one.
    #[must_use]
    pub fn bound(&self, up_to: f64) -> f64 {
        match self {
            Self::Constant(coefficient) => *coefficient,
            Self::Falling(FallingFriction { at_rest, at_speed, viscous, .. }) => {
                at_rest.max(*at_speed) + viscous * up_to
            }
            Self::Table(table) => table.values().iter().copied().fold(0.0, f64::max),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn a_table_is_straight_between_its_speeds_and_constant_outside() {
        let friction = Friction::table(vec![0.01, 0.03], vec![0.4, 0.2], TableInterpolation::Linear).unwrap();
        for (speed, expected) in [(0.0, 0.4), (0.01, 0.4), (0.02, 0.3), (0.03, 0.2), (1.0, 0.2)] {
            assert!((friction.at(speed).coefficient - expected).abs() < 1e-15, "{speed}");
        }
        assert!((friction.at(0.02).slope + 10.0).abs() < 1e-12);
        assert_eq!((friction.at(0.0).slope, friction.at(0.1).slope, friction.bound(0.0)), (0.0, 0.0, 0.4));
        assert_eq!(friction.ends(1), [Some(0.01), Some(0.03)]);
        assert_eq!((friction.ends(0), friction.ends(2)), ([None, Some(0.01)], [Some(0.03), None]));
    }

    #[test]
    fn speeds_beyond_a_table_are_named() {
        let friction = Friction::table(vec![0.01, 0.03], vec![0.4, 0.2], TableInterpolation::Linear).unwrap();
        assert_eq!((friction.beyond(0.01), friction.beyond(0.03)), (None, None));
        assert!(friction.beyond(0.0).is_some() && Friction::Constant(0.3).beyond(1e9).is_none());
        let told = friction.beyond(0.04).unwrap();
        assert!(told.scaled(1e3).text("mm/s").starts_with("the slip speed 40 mm/s lies beyond"), "{told:?}");
        assert!(told.text("").contains("from 0.01 to 0.03:"), "{}", told.text(""));
    }

    #[test]
    fn a_curve_of_stribeck_has_its_least_where_its_slope_is_zero() {
        // of μ = a + b exp(−v/s) + c v the least is at v = s ln(b/(s c))
        let own = FallingFriction { viscous: 0.1, ..FallingFriction::exponential([0.5, 0.3], 0.2) };
        let speed = 0.2 * (0.2_f64 / (0.2 * 0.1)).ln();
        assert!(own.at(speed).slope.abs() < 1e-15);
        assert!((own.at(speed).coefficient - (0.3 + 0.02 + 0.1 * speed)).abs() < 1e-15);
        let gauss = FallingFriction { exponent: 2.0, ..own };
        let at_rest = FrictionAt { coefficient: 0.5, slope: 0.1 };
        assert_eq!(gauss.at(0.0), at_rest);
        assert!((gauss.at(0.2).coefficient - (0.3 + 0.2 * (-1.0_f64).exp() + 0.02)).abs() < 1e-15);
    }

    #[test]
    fn numbers_that_make_no_sense_are_refused() {
        let table = |speeds: &[f64], coefficients: &[f64]| {
            Friction::table(speeds.to_vec(), coefficients.to_vec(), TableInterpolation::Linear).unwrap_err()
        };
        assert!(Friction::Constant(-0.1).check().is_err() && Friction::Constant(f64::NAN).check().is_err());
        assert_eq!(table(&[0.0; 2], &[0.1; 2]), FrictionError::Speeds { before: 0.0, speed: 0.0 });
        assert_eq!(table(&[0.0, 1.0], &[0.1]), FrictionError::Columns { speeds: 2, coefficients: 1 });
        assert_eq!(table(&[], &[]), FrictionError::Columns { speeds: 0, coefficients: 0 });
        assert_eq!(table(&[0.0], &[-0.1]), FrictionError::Coefficient { value: -0.1 });
        assert!(matches!(table(&[-1.0, 1.0], &[0.1; 2]), FrictionError::Number { .. }));
        let usual = FallingFriction::exponential([0.4, 0.3], 1.0);
        for wrong in [
            FallingFriction { at_rest: -0.1, ..usual },
            FallingFriction { decay_speed: 0.0, ..usual },
            FallingFriction { viscous: -1.0, ..usual },
            FallingFriction { exponent: 0.5, ..usual },
            FallingFriction { exponent: f64::NAN, ..usual },
        ] {
            assert!(Friction::from(wrong).check().is_err(), "{wrong:?}");
        }
    }

    proptest! {
        #[test]
        fn slopes_are_those_of_differences(
            [at_rest, at_speed, viscous] in prop::array::uniform3(0.0..1.0_f64),
            decay_speed in 0.1..2.0_f64,
            exponent in 1.0..4.0_f64,
            speed in 0.01..3.0_f64,
        ) {
            let own = Friction::from(FallingFriction { at_rest, at_speed, decay_speed, viscous, exponent });
            let h = 1e-5 * speed;
            let difference = (own.at(speed + h).coefficient - own.at(speed - h).coefficient) / (2.0 * h);
            prop_assert!((own.at(speed).slope - difference).abs() < 1e-5, "{} {}", own.at(speed).slope, difference);
            prop_assert!(own.at(speed).coefficient <= own.bound(speed) + 1e-15);
            let double = own.scaled(2.0).at(speed);
            prop_assert!((double.coefficient - 2.0 * own.at(speed).coefficient).abs() < 1e-14);
        }
    }
}
