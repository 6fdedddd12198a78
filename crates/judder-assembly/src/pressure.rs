//! The normal law of a compliant interface: pressure against closure.

use crate::AssemblyError;
use crate::friction::{check_table, piece_of};
#[cfg(feature = "keys")]
use judder_keys::{
    declared::{Number, Several},
    dimension::Dimension,
};
use judder_numerics::ramp::straight;

#[cfg(feature = "keys")]
const CLOSURES: Several<Number> =
    Several { of: Number::non_negative(Dimension::LENGTH), length: [2, usize::MAX] };
#[cfg(feature = "keys")]
const PRESSURES: Several<Number> =
    Several { of: Number::non_negative(Dimension::STRESS), length: [2, usize::MAX] };
#[cfg(feature = "keys")]
const STIFFNESS: Number = Number::positive(Dimension::new(-2, 1, -2, 0));
#[cfg(feature = "keys")]
const POINT_STIFFNESS: Number = Number::positive(Dimension::STIFFNESS);
#[cfg(feature = "keys")]
const ABOUT: Number = Number::non_negative(Dimension::LENGTH);
#[cfg(feature = "keys")]
const CUBIC_STIFFNESS: Number = Number::positive(Dimension::new(-4, 1, -2, 0));
#[cfg(feature = "keys")]
const POINT_CUBIC_STIFFNESS: Number = Number::positive(Dimension::new(-2, 1, -2, 0));

/// p(d), the pressure in Pa at a closure d = −g in m, or the force of a point in N; zero where the interface is open, d ≤ 0.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "keys", derive(judder_keys::Settings))]
pub enum Pressure {
    /// Pressure over closure.
    ///
    /// p = k_n d, with k_n in N/m³.
    #[cfg_attr(feature = "keys", key(rule = STIFFNESS, symbol = "k_n"))]
    Stiffness(f64),
    /// Force over closure of each contact point, whatever its area, in place of a pressure.
    ///
    /// N = k d, with k in N/m: what minimal models have, whose bodies have no faces.
    #[cfg_attr(feature = "keys", key(rule = POINT_STIFFNESS, symbol = "k"))]
    PointStiffness(f64),
    /// A pressure that stiffens with the closure, as linings do.
    Cubic(CubicPressure),
    /// The same of each contact point, whatever its area.
    PointCubic(CubicPointForce),
    /// Pressures at closures, in place of a stiffness.
    Table(PressureTable),
}

/// p = k_n d + k_3 d³.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "keys", derive(judder_keys::Settings))]
pub struct CubicPressure {
    /// Pressure over a small closure, Pa/m.
    #[cfg_attr(feature = "keys", key(rule = STIFFNESS, symbol = "k_n"))]
    pub stiffness: f64,
    /// What stiffens it, Pa/m³.
    #[cfg_attr(feature = "keys", key(rule = CUBIC_STIFFNESS, symbol = "k_3", example = "\"1e20 N/m^5\""))]
    pub cubic_stiffness: f64,
}

/// N = k d + k_3 [(d − d_0)³ + d_0³] of a contact point.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "keys", derive(judder_keys::Settings))]
pub struct CubicPointForce {
    /// Force over a small closure, N/m.
    #[cfg_attr(feature = "keys", key(rule = POINT_STIFFNESS, symbol = "k"))]
    pub stiffness: f64,
    /// What stiffens it, N/m³.
    #[cfg_attr(feature = "keys", key(rule = POINT_CUBIC_STIFFNESS, symbol = "k_3", example = "\"1e14 N/m^3\""))]
    pub cubic_stiffness: f64,
    /// The closure from which the cube is reckoned, m: in minimal models that of steady sliding.
    #[cfg_attr(feature = "keys", key(rule = ABOUT, symbol = "d_0", default = 0.0))]
    pub about: f64,
}

/// Pressures at closures.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "keys", derive(judder_keys::Settings))]
pub struct PressureTable {
    /// Closures, ascending from zero, m.
    #[cfg_attr(feature = "keys", key(rule = CLOSURES, symbol = "d", example = "[\"0 um\", \"1 um\"]"))]
    pub closure: Vec<f64>,
    /// Pressures there, ascending from zero, Pa: linear between the closures, and beyond the last as steep as before it.
    #[cfg_attr(feature = "keys", key(rule = PRESSURES, symbol = "p(d)", example = "[\"0 Pa\", \"1 MPa\"]"))]
    pub pressure: Vec<f64>,
}

/// The columns of a table, in messages.
const COLUMNS: [&str; 2] = ["the closures of a contact interface", "the pressures of a contact interface"];

/// A pressure and its slope; of a law of points a force in N and its slope in N/m.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct PressureAt {
    /// p in Pa.
    pub value: f64,
    /// dp/dd in Pa/m.
    pub slope: f64,
}

impl Pressure {
    /// Whether its numbers make a pressure that rises with the closure.
    ///
    /// # Errors
    /// [`AssemblyError::InvalidNumber`], [`AssemblyError::Length`].
    pub fn check(&self) -> Result<(), AssemblyError> {
        let invalid =
            |name, value, requirement| Err(AssemblyError::InvalidNumber { name, value, requirement });
        match self {
            Self::Stiffness(value) | Self::PointStiffness(value) if value.is_finite() && *value > 0.0 => {
                Ok(())
            }
            Self::Stiffness(value) | Self::PointStiffness(value) => {
                invalid("the stiffness of a contact interface", *value, "positive")
            }
            Self::PointCubic(CubicPointForce { about, .. }) if !(*about >= 0.0 && about.is_finite()) => {
                invalid("the closure from which a cube is reckoned", *about, "zero or positive")
            }
            Self::Cubic(CubicPressure { stiffness, cubic_stiffness })
            | Self::PointCubic(CubicPointForce { stiffness, cubic_stiffness, .. }) => {
                let is_positive = |value: &f64| value.is_finite() && *value > 0.0;
                match [stiffness, cubic_stiffness].into_iter().find(|value| !is_positive(value)) {
                    Some(value) => invalid("the stiffness of a contact interface", *value, "positive"),
                    None => Ok(()),
                }
            }
            Self::Table(PressureTable { closure: closures, pressure: pressures }) => {
                check_table(COLUMNS, closures, pressures.len())?;
                check_table([COLUMNS[1], COLUMNS[0]], pressures, closures.len())?;
                match (closures[0], pressures[0]) {
                    _ if closures.len() < 2 => Err(AssemblyError::Length {
                        name: "the table of pressures",
                        found: closures.len(),
                        expected: 2,
                    }),
                    (0.0, 0.0) => Ok(()),
                    (0.0, first) => invalid("the first pressure of a contact interface", first, "zero"),
                    (first, _) => invalid("the first closure of a contact interface", first, "zero"),
                }
            }
        }
    }

    /// Whether it is the force of a point whatever its area.
    #[must_use]
    pub fn is_of_points(&self) -> bool {
        matches!(self, Self::PointStiffness(_) | Self::PointCubic(_))
    }

    /// The closure in m at which the cube presses a hundredth of what is linear; none of a law of straight pieces.
    #[must_use]
    pub fn bend(&self) -> Option<f64> {
        match self {
            Self::Cubic(CubicPressure { stiffness, cubic_stiffness })
            | Self::PointCubic(CubicPointForce { stiffness, cubic_stiffness, .. }) => {
                Some(0.1 * (stiffness / cubic_stiffness).sqrt())
            }
            Self::Stiffness(_) | Self::PointStiffness(_) | Self::Table(_) => None,
        }
    }

    /// p and dp/dd at a closure in m of an interface that stays closed: below zero it pulls as stiffly as it begins to press, a cubic law as it presses.
    #[must_use]
    pub fn extended_at(&self, closure: f64) -> PressureAt {
        if closure > 0.0 {
            return self.at(closure);
        }
        let slope = match self {
            Self::Cubic(own) => return own.at(closure),
            Self::PointCubic(own) => return own.at(closure),
            Self::Stiffness(stiffness) | Self::PointStiffness(stiffness) => *stiffness,
            Self::Table(PressureTable { closure: closures, pressure: pressures }) => {
                straight(closures, pressures, 0.0).1
            }
        };
        PressureAt { value: slope * closure, slope }
    }

    /// The number of the piece of a table at a closure in m.
    pub(crate) fn piece(&self, closure: f64) -> usize {
        match self {
            Self::Stiffness(_) | Self::PointStiffness(_) | Self::Cubic(_) | Self::PointCubic(_) => 0,
            // beyond the last as steep as before it
            Self::Table(PressureTable { closure: closures, .. }) => {
                piece_of(&closures[..closures.len().saturating_sub(1)], closure)
            }
        }
    }

    /// The largest dp/dd, in Pa/m; of a law of points in N/m, of a cubic one without bound.
    #[must_use]
    pub fn largest_slope(&self) -> f64 {
        match self {
            Self::Cubic(_) | Self::PointCubic(_) => f64::INFINITY,
            Self::Stiffness(stiffness) | Self::PointStiffness(stiffness) => *stiffness,
            Self::Table(PressureTable { closure, pressure }) => {
                let pieces = closure.windows(2).zip(pressure.windows(2));
                pieces.map(|(d, p)| (p[1] - p[0]) / (d[1] - d[0])).fold(0.0, f64::max)
            }
        }
    }

    /// p and dp/dd at a closure in m.
    #[must_use]
    pub fn at(&self, closure: f64) -> PressureAt {
        if closure <= 0.0 {
            return PressureAt::default();
        }
        match self {
            Self::Stiffness(stiffness) | Self::PointStiffness(stiffness) => {
                PressureAt { value: stiffness * closure, slope: *stiffness }
            }
            Self::Cubic(own) => own.at(closure),
            Self::PointCubic(own) => own.at(closure),
            Self::Table(PressureTable { closure: closures, pressure: pressures }) => {
                let last = closures.len() - 1;
                if closure < closures[last] {
                    let (value, slope) = straight(closures, pressures, closure);
                    return PressureAt { value, slope };
                }
                let slope = (pressures[last] - pressures[last - 1]) / (closures[last] - closures[last - 1]);
                PressureAt { value: pressures[last] + slope * (closure - closures[last]), slope }
            }
        }
    }
}

impl CubicPressure {
    /// At a closure of any sign.
    fn at(&self, closure: f64) -> PressureAt {
        let stiffening = self.cubic_stiffness * closure * closure;
        PressureAt {
            value: (self.stiffness + stiffening) * closure,
            slope: self.stiffness + 3.0 * stiffening,
        }
    }
}

impl CubicPointForce {
    /// At a closure of any sign.
    fn at(&self, closure: f64) -> PressureAt {
        let Self { stiffness, cubic_stiffness, about } = *self;
        let off = closure - about;
        PressureAt {
            value: stiffness * closure + cubic_stiffness * (off * off * off + about * about * about),
            slope: stiffness + 3.0 * cubic_stiffness * off * off,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table(closure: &[f64], pressure: &[f64]) -> Pressure {
        Pressure::Table(PressureTable { closure: closure.to_vec(), pressure: pressure.to_vec() })
    }

    #[test]
    fn pressures_have_the_slopes_of_their_differences() {
        for law in [
            Pressure::Stiffness(1e12),
            Pressure::PointStiffness(1e6),
            Pressure::Cubic(CubicPressure { stiffness: 1e12, cubic_stiffness: 2e23 }),
            Pressure::PointCubic(CubicPointForce { stiffness: 1e6, cubic_stiffness: 2e17, about: 1e-6 }),
            table(&[0.0, 1e-6, 3e-6], &[0.0, 1e5, 9e5]),
        ] {
            law.check().unwrap();
            for closure in [2e-7, 2.2e-6, 5e-6] {
                let step = 1e-4 * closure;
                let difference = (law.at(closure + step).value - law.at(closure - step).value) / (2.0 * step);
                let slope = law.at(closure).slope;
                assert!((slope - difference).abs() < 1e-6 * slope, "{law:?} at {closure}");
            }
            assert_eq!(law.at(-1e-6), PressureAt::default());
        }
    }

    #[test]
    fn what_is_no_pressure_is_refused() {
        assert!(Pressure::Stiffness(0.0).check().is_err());
        assert!(Pressure::Stiffness(-1.0).check().is_err());
        let cubic = |cubic_stiffness| Pressure::Cubic(CubicPressure { stiffness: 1e12, cubic_stiffness });
        assert!(cubic(0.0).check().is_err() && cubic(f64::NAN).check().is_err());
        assert!(table(&[0.0], &[0.0]).check().is_err());
        assert!(table(&[0.0, 1.0], &[1.0, 2.0]).check().is_err());
        assert!(table(&[0.0, 1.0], &[0.0, 0.0]).check().is_err());
    }
}
