//! The normal law of a compliant interface: pressure against closure.

use crate::AssemblyError;
use crate::friction::{TableInterpolation, check_table, piece_of};
use judder_contact::table::TableColumns;
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
const DEFLECTIONS: Several<Number> = Several { of: Number::any(Dimension::LENGTH), length: [2, usize::MAX] };
#[cfg(feature = "keys")]
const FORCES: Several<Number> = Several { of: Number::any(Dimension::FORCE), length: [2, usize::MAX] };
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
    /// Forces of each contact point at closures, whatever its area: a spring of one's own.
    PointTable(ForceTable),
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

/// Forces of a contact point at closures.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "keys", derive(judder_keys::Settings))]
pub struct ForceTable {
    /// Closures, ascending, zero among them, m; those below zero are of a contact whose points all stay closed, which pulls there.
    #[cfg_attr(feature = "keys", key(rule = DEFLECTIONS, symbol = "d", example = "[\"-1 mm\", \"0 mm\", \"1 mm\"]"))]
    pub closure: Vec<f64>,
    /// Forces there, ascending, zero at the closure zero, N; beyond the closures as steep as at their ends.
    #[cfg_attr(feature = "keys", key(rule = FORCES, symbol = "N(d)", example = "[\"-5 N\", \"0 N\", \"8 N\"]"))]
    pub force: Vec<f64>,
    /// How the force runs between the closures.
    #[cfg_attr(feature = "keys", key(default = TableInterpolation::Monotone))]
    pub interpolation: TableInterpolation,
}

/// The columns of a table of forces, in messages.
const FORCE_COLUMNS: [&str; 2] = ["the closures of a table of forces", "the forces of a table of forces"];

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
            Self::PointTable(own) => own.check(),
        }
    }

    /// Whether it bends: not one stiffness at all closures.
    #[must_use]
    pub fn bends(&self) -> bool {
        !matches!(self, Self::Stiffness(_) | Self::PointStiffness(_))
    }

    /// Whether it is the force of a point whatever its area.
    #[must_use]
    pub fn is_of_points(&self) -> bool {
        matches!(self, Self::PointStiffness(_) | Self::PointCubic(_) | Self::PointTable(_))
    }

    /// The closure in m at which the cube presses a hundredth of what is linear, of a table of forces a tenth of its narrowest piece; none of a law of
    /// straight pieces.
    #[must_use]
    pub fn bend(&self) -> Option<f64> {
        match self {
            Self::Cubic(CubicPressure { stiffness, cubic_stiffness })
            | Self::PointCubic(CubicPointForce { stiffness, cubic_stiffness, .. }) => {
                Some(0.1 * (stiffness / cubic_stiffness).sqrt())
            }
            Self::PointTable(own) if own.interpolation == TableInterpolation::Monotone => {
                let widths = own.closure.windows(2).map(|pair| pair[1] - pair[0]);
                Some(0.1 * widths.fold(f64::INFINITY, f64::min))
            }
            Self::Stiffness(_) | Self::PointStiffness(_) | Self::Table(_) | Self::PointTable(_) => None,
        }
    }

    /// ∫ (p(x) − p(d)) dx from a closure d in m to another, in J/m²; of a law of points in J: what is stored beyond what a constant force takes.
    ///
    /// Exact: between corners every law is a polynomial of the third degree at most, which two places of Gauss integrate.
    #[must_use]
    pub fn excess_energy(&self, [from, to]: [f64; 2], stays_closed: bool) -> f64 {
        let at = |closure: f64| if stays_closed { self.extended_at(closure) } else { self.at(closure) }.value;
        let (first, low, high) = (at(from), from.min(to), from.max(to));
        let corners = match self {
            Self::Table(own) => own.closure.as_slice(),
            Self::PointTable(own) => own.closure.as_slice(),
            // where the interface opens
            _ => &[0.0],
        };
        let inside = corners.iter().copied().filter(|corner| *corner > low && *corner < high);
        let mut energy = 0.0;
        let mut start = low;
        for end in inside.chain([high]) {
            let (middle, half) = (0.5 * (start + end), 0.5 * (end - start));
            let off = half / 3.0_f64.sqrt();
            energy += half * (at(middle - off) - first + (at(middle + off) - first));
            start = end;
        }
        if to < from { -energy } else { energy }
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
            Self::PointTable(own) => return own.at(closure),
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
            Self::PointTable(ForceTable { closure: closures, interpolation, .. }) => match interpolation {
                TableInterpolation::Linear => {
                    piece_of(closures.get(1..closures.len().saturating_sub(1)).unwrap_or_default(), closure)
                }
                TableInterpolation::Monotone => 0,
            },
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
            Self::PointTable(own) => own.columns().largest_slope(),
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
            Self::PointTable(own) => own.at(closure),
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

impl ForceTable {
    fn columns(&self) -> TableColumns<'_> {
        TableColumns { places: &self.closure, values: &self.force, interpolation: self.interpolation }
    }

    /// At a closure of any sign.
    fn at(&self, closure: f64) -> PressureAt {
        let (value, slope) = self.columns().at_and_beyond(closure);
        PressureAt { value, slope }
    }

    fn check(&self) -> Result<(), AssemblyError> {
        let Self { closure, force, .. } = self;
        check_table(FORCE_COLUMNS, closure, force.len())?;
        check_table([FORCE_COLUMNS[1], FORCE_COLUMNS[0]], force, closure.len())?;
        if closure.len() < 2 {
            return Err(AssemblyError::Length {
                name: "the table of forces",
                found: closure.len(),
                expected: 2,
            });
        }
        let at_rest = closure.iter().zip(force).find(|(closure, _)| **closure == 0.0);
        match at_rest {
            Some((_, 0.0)) => Ok(()),
            Some((_, force)) => Err(AssemblyError::InvalidNumber {
                name: "the force of a contact point at the closure zero",
                value: *force,
                requirement: "zero",
            }),
            None => Err(AssemblyError::InvalidNumber {
                name: "the first closure of a table of forces without a zero",
                value: closure[0],
                requirement: "zero, or a later one",
            }),
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
            forces(TableInterpolation::Linear),
            forces(TableInterpolation::Monotone),
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

    fn forces(interpolation: TableInterpolation) -> Pressure {
        let (closure, force) = (vec![-2e-6, 0.0, 1e-6, 3e-6], vec![-1.0, 0.0, 2.0, 9.0]);
        Pressure::PointTable(ForceTable { closure, force, interpolation })
    }

    /// Of k d + k₃ d³ it is k d²/2 + k₃ d⁴/4, less what a constant force takes; of the others the sum over small steps.
    #[test]
    fn energies_are_the_integrals_of_the_forces() {
        let cubic =
            Pressure::PointCubic(CubicPointForce { stiffness: 1e6, cubic_stiffness: 2e17, about: 0.0 });
        let stored = |d: f64| 0.5e6 * d * d + 0.5e17 * d * d * d * d;
        for [from, to] in [[1e-6, 3e-6], [3e-6, 1e-6], [1e-6, -1e-6]] {
            let energy = cubic.excess_energy([from, to], true);
            let expected = stored(to) - stored(from) - cubic.extended_at(from).value * (to - from);
            assert!((energy / expected - 1.0).abs() < 1e-9, "{energy} {expected}");
        }
        // a motion that is a millionth of the closure is not lost in rounding
        let small = cubic.excess_energy([2e-6, 2e-6 + 1e-12], true);
        assert!((small / (0.5 * cubic.at(2e-6).slope * 1e-24) - 1.0).abs() < 1e-4, "{small}");
        for law in [
            table(&[0.0, 1e-6, 3e-6], &[0.0, 1e5, 9e5]),
            forces(TableInterpolation::Linear),
            forces(TableInterpolation::Monotone),
            Pressure::PointStiffness(1e6),
        ] {
            for (stays_closed, [from, to]) in
                [(true, [2e-6, -3e-6]), (false, [2e-6, -3e-6]), (true, [-1e-6, 4e-6])]
            {
                let at = |d: f64| if stays_closed { law.extended_at(d) } else { law.at(d) }.value;
                let step = (to - from) / 1e5;
                let middles = (0..100_000).map(|k| from + step * (f64::from(k) + 0.5));
                let sum: f64 = middles.map(|d| step * (at(d) - at(from))).sum();
                let energy = law.excess_energy([from, to], stays_closed);
                assert!((energy / sum - 1.0).abs() < 1e-6, "{law:?}: {energy} {sum}");
            }
        }
    }

    #[test]
    fn a_spring_of_ones_own_pulls_where_it_stays_closed() {
        let own = forces(TableInterpolation::Linear);
        assert!((own.extended_at(-1e-6).value + 0.5).abs() < 1e-12 && own.at(-1e-6).value == 0.0);
        assert!((own.extended_at(-4e-6).value + 2.0).abs() < 1e-12);
        assert!((own.largest_slope() - 3.5e6).abs() < 1e-6 && own.is_of_points());
        assert_eq!([-3e-6, -1e-6, 0.5e-6, 2e-6, 9e-6].map(|d| own.piece(d)), [0, 0, 1, 2, 2]);
        assert!(own.bend().is_none() && forces(TableInterpolation::Monotone).bend().is_some());
    }

    #[test]
    fn what_is_no_pressure_is_refused() {
        let own = |closure: &[f64], force: &[f64]| {
            let (closure, force) = (closure.to_vec(), force.to_vec());
            let interpolation = TableInterpolation::Monotone;
            Pressure::PointTable(ForceTable { closure, force, interpolation }).check()
        };
        assert!(own(&[-1.0, 0.0, 1.0], &[-1.0, 0.0, 3.0]).is_ok());
        assert!(own(&[-1.0, 1.0], &[-1.0, 1.0]).is_err() && own(&[0.0, 1.0], &[0.5, 1.0]).is_err());
        assert!(own(&[0.0, 1.0, 2.0], &[0.0, 2.0, 1.0]).is_err() && own(&[0.0], &[0.0]).is_err());
        assert!(Pressure::Stiffness(0.0).check().is_err());
        assert!(Pressure::Stiffness(-1.0).check().is_err());
        let cubic = |cubic_stiffness| Pressure::Cubic(CubicPressure { stiffness: 1e12, cubic_stiffness });
        assert!(cubic(0.0).check().is_err() && cubic(f64::NAN).check().is_err());
        assert!(table(&[0.0], &[0.0]).check().is_err());
        assert!(table(&[0.0, 1.0], &[1.0, 2.0]).check().is_err());
        assert!(table(&[0.0, 1.0], &[0.0, 0.0]).check().is_err());
    }
}
