//! The friction coefficient, constant or falling with speed.

use crate::SlidingError;

/// μ against sliding speed.
#[derive(Debug, Clone, PartialEq)]
pub struct SlidingFriction {
    speeds: Vec<f64>,
    coefficients: Vec<f64>,
}

impl SlidingFriction {
    /// One coefficient for all speeds.
    ///
    /// # Errors
    /// [`SlidingError::InvalidNumber`] for one that is negative or not finite.
    pub fn constant(coefficient: f64) -> Result<Self, SlidingError> {
        Self::table(vec![0.0], vec![coefficient])
    }

    /// Coefficients at ascending speeds in m/s, straight between them and constant outside.
    ///
    /// # Errors
    /// [`SlidingError::InvalidNumber`] for a negative coefficient or a speed that does not ascend, [`SlidingError::Length`] for
    /// lists of different lengths.
    pub fn table(speeds: Vec<f64>, coefficients: Vec<f64>) -> Result<Self, SlidingError> {
        if speeds.is_empty() || speeds.len() != coefficients.len() {
            return Err(SlidingError::Length {
                name: "the list of friction coefficients".to_owned(),
                found: coefficients.len(),
                expected: speeds.len().max(1),
            });
        }
        if let Some(value) = coefficients.iter().find(|value| !(value.is_finite() && **value >= 0.0)) {
            return Err(SlidingError::InvalidNumber {
                name: "a friction coefficient".to_owned(),
                value: *value,
                requirement: "finite and not negative",
            });
        }
        let ascends = |pair: &[f64]| pair[0].is_finite() && pair[1].is_finite() && pair[1] > pair[0];
        if let Some(pair) = speeds.windows(2).find(|pair| !ascends(pair)) {
            return Err(SlidingError::InvalidNumber {
                name: "a speed of the friction table".to_owned(),
                value: pair[1],
                requirement: "finite and above the one before",
            });
        }
        Ok(Self { speeds, coefficients })
    }

    /// μ at a sliding speed in m/s; the sign of the speed does not matter.
    #[inline]
    #[must_use]
    pub fn at(&self, speed: f64) -> f64 {
        let last = self.speeds.len() - 1;
        let speed = speed.abs();
        if last == 0 || speed <= self.speeds[0] {
            return self.coefficients[0];
        }
        if speed >= self.speeds[last] {
            return self.coefficients[last];
        }
        let above = self.speeds.partition_point(|known| *known <= speed);
        let share = (speed - self.speeds[above - 1]) / (self.speeds[above] - self.speeds[above - 1]);
        self.coefficients[above - 1] + share * (self.coefficients[above] - self.coefficients[above - 1])
    }

    /// dμ/dv at a sliding speed, s/m: of the piece above it.
    #[must_use]
    pub fn slope(&self, speed: f64) -> f64 {
        let above = self.speeds.partition_point(|known| *known <= speed.abs());
        if above == 0 || above == self.speeds.len() {
            return 0.0;
        }
        (self.coefficients[above] - self.coefficients[above - 1])
            / (self.speeds[above] - self.speeds[above - 1])
    }

    /// The largest coefficient.
    #[must_use]
    pub fn largest(&self) -> f64 {
        self.coefficients.iter().copied().fold(0.0, f64::max)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_table_is_straight_between_its_speeds_and_constant_outside() {
        let friction = SlidingFriction::table(vec![0.01, 0.03], vec![0.4, 0.2]).unwrap();
        for (speed, expected) in [(0.0, 0.4), (0.01, 0.4), (0.02, 0.3), (-0.02, 0.3), (0.03, 0.2), (1.0, 0.2)]
        {
            assert!((friction.at(speed) - expected).abs() < 1e-15, "{speed}");
        }
        assert!((friction.slope(0.02) + 10.0).abs() < 1e-12);
        assert_eq!((friction.slope(0.0), friction.slope(0.1), friction.largest()), (0.0, 0.0, 0.4));
    }

    #[test]
    fn tables_that_make_no_sense_are_refused() {
        assert!(SlidingFriction::constant(-0.1).is_err());
        assert!(SlidingFriction::constant(f64::NAN).is_err());
        assert!(SlidingFriction::table(vec![0.0, 0.0], vec![0.1, 0.1]).is_err());
        assert!(SlidingFriction::table(vec![0.0, 1.0], vec![0.1]).is_err());
        assert!(SlidingFriction::table(vec![], vec![]).is_err());
    }
}
