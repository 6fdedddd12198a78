//! Which eigenvalues are asked for: those of a rectangle, or those of a band of frequencies with damping ratios.

use crate::complex_modes::Eigenvalue;
use crate::quadratic::Region;
use judder_numerics::complex::ElementaryComplex;

/// Two plain numbers.
#[cfg(feature = "keys")]
const RANGE: judder_keys::declared::NumberPair = judder_keys::declared::NumberPair {
    of: judder_keys::declared::Number::any(judder_keys::dimension::Dimension::NUMBER),
    what: "two numbers, from and to",
    is_ascending: true,
};

/// Two frequencies.
#[cfg(feature = "keys")]
const BAND: judder_keys::declared::NumberPair = judder_keys::declared::NumberPair {
    of: judder_keys::declared::Number::non_negative(judder_keys::dimension::Dimension::ANGULAR_FREQUENCY),
    what: "two frequencies, from and to",
    is_ascending: true,
};

/// Two damping ratios: one of magnitude 1 belongs to a motion that does not oscillate, and reaches along the whole real axis.
#[cfg(feature = "keys")]
const RATIOS: judder_keys::declared::NumberPair = judder_keys::declared::NumberPair {
    of: judder_keys::declared::Number {
        dimension: judder_keys::dimension::Dimension::NUMBER,
        range: judder_keys::numeric_key::Range::Closed { from: -0.999, to: 0.999 },
    },
    what: "two damping ratios, from and to",
    is_ascending: true,
};

/// The eigenvalues λ = re + i im that are asked for.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "keys", derive(judder_keys::Settings))]
pub enum AskedRegion {
    /// Those of a rectangle.
    Rectangle {
        /// Growth rates from and to, 1/s.
        #[cfg_attr(feature = "keys", key(rule = RANGE, example = "[-50.0, 1000.0], growth rates in 1/s"))]
        re: [f64; 2],
        /// Angular frequencies from and to, rad/s.
        #[cfg_attr(
            feature = "keys",
            key(rule = RANGE, example = "[0.0, 20000.0], angular frequencies in rad/s")
        )]
        im: [f64; 2],
    },
    /// Those of a band of frequencies with damping ratios ζ = −re/|λ|.
    Ratios {
        /// Frequencies im/2π from and to, in place of re and im.
        #[cfg_attr(feature = "keys", key(rule = BAND, example = "[\"0 Hz\", \"8 kHz\"]"))]
        frequency: [f64; 2],
        /// Damping ratios −re/|λ| from and to; those of growing modes are negative.
        #[cfg_attr(feature = "keys", key(rule = RATIOS, symbol = "ζ", example = "[-0.1, 0.1]"))]
        damping_ratio: [f64; 2],
    },
}

impl From<Region> for AskedRegion {
    fn from(Region { re, im }: Region) -> Self {
        Self::Rectangle { re, im }
    }
}

impl AskedRegion {
    /// The smallest rectangle that holds all of them: re = −ζ im/√(1 − ζ²) is steepest at the ends of both ranges.
    #[must_use]
    pub fn rectangle(&self) -> Region {
        match *self {
            Self::Rectangle { re, im } => Region { re, im },
            Self::Ratios { frequency, damping_ratio: [low, high] } => {
                let growth = |ratio: f64, omega: f64| -ratio * omega / (1.0 - ratio * ratio).sqrt();
                let least =
                    frequency.map(|omega| growth(high, omega)).into_iter().fold(f64::INFINITY, f64::min);
                let most =
                    frequency.map(|omega| growth(low, omega)).into_iter().fold(f64::NEG_INFINITY, f64::max);
                Region { re: [least, most], im: frequency }
            }
        }
    }

    /// Whether modes that neither grow nor decay are among them.
    #[must_use]
    pub fn has_undamped(&self) -> bool {
        match *self {
            Self::Rectangle { .. } => true,
            Self::Ratios { damping_ratio: [low, high], .. } => low <= 0.0 && high >= 0.0,
        }
    }

    /// Whether an eigenvalue of the rectangle is asked for, as far as its error tells.
    #[must_use]
    pub fn has(&self, eigenvalue: &Eigenvalue) -> bool {
        match *self {
            Self::Rectangle { .. } => true,
            Self::Ratios { damping_ratio: [low, high], .. } => {
                let (value, error) = (eigenvalue.value, eigenvalue.error);
                -high * value.modulus() - error <= value.re && value.re <= error - low * value.modulus()
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use faer::c64;

    fn of(value: c64) -> Eigenvalue {
        let (residual, left_residual, condition, defective) = (0.0, 0.0, 1.0, false);
        Eigenvalue { value, residual, left_residual, condition, error: 1e-9, defective }
    }

    /// A value of any frequency and ratio of the ranges lies in the rectangle, and the corners on its edge.
    #[test]
    fn the_rectangle_holds_what_is_asked_for_and_no_more() {
        for damping_ratio in [[-0.1, 0.3], [0.05, 0.2], [-0.6, -0.2]] {
            let frequency = [30.0, 200.0];
            let asked = AskedRegion::Ratios { frequency, damping_ratio };
            let Region { re, im } = asked.rectangle();
            assert_eq!(im, frequency);
            let mut reached = [f64::INFINITY, f64::NEG_INFINITY];
            for k in 0..=40 {
                let ratio = damping_ratio[0] + (damping_ratio[1] - damping_ratio[0]) * f64::from(k) / 40.0;
                for omega in frequency {
                    // λ = |λ| (−ζ + i √(1 − ζ²))
                    let size = omega / (1.0 - ratio * ratio).sqrt();
                    let value = c64::new(-ratio * size, omega);
                    assert!(asked.has(&of(value)), "{value}");
                    reached = [reached[0].min(value.re), reached[1].max(value.re)];
                }
            }
            assert!((re[0] - reached[0]).abs() < 1e-12 * im[1] && (re[1] - reached[1]).abs() < 1e-12 * im[1]);
            assert!(!asked.has(&of(c64::new(re[1] + 1e-3, im[0]))));
        }
    }

    /// What moves without oscillating has the ratio ±1, but zero any.
    #[test]
    fn real_eigenvalues_have_ratios_of_one() {
        let asked = AskedRegion::Ratios { frequency: [0.0, 10.0], damping_ratio: [-0.9, 0.9] };
        assert!(!asked.has(&of(c64::new(1.0, 0.0))) && !asked.has(&of(c64::new(-1.0, 0.0))));
        assert!(asked.has(&of(c64::new(1e-10, 0.0))));
        assert!(AskedRegion::Rectangle { re: [-2.0, 2.0], im: [0.0, 1.0] }.has(&of(c64::new(1.0, 0.0))));
    }
}
