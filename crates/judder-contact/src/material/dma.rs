//! Measured moduli: dynamic mechanical analysis (DMA), read from a table of text.

use super::error::{DmaError, MaterialError, positive};
use super::shift::TemperatureShift;

/// Moduli measured at one frequency.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DmaPoint {
    /// ω [rad/s].
    pub angular_frequency: f64,
    /// E′ \[Pa\].
    pub storage_modulus: f64,
    /// E″ \[Pa\].
    pub loss_modulus: f64,
}

impl DmaPoint {
    /// The first part that is not positive and finite, with its name.
    fn unusable(&self) -> Option<(&'static str, f64)> {
        let parts = [
            ("frequency", self.angular_frequency),
            ("storage modulus", self.storage_modulus),
            ("loss modulus", self.loss_modulus),
        ];
        parts.into_iter().find(|(name, value)| positive(name, *value).is_err())
    }
}

/// Moduli measured over frequency at one temperature, or shifted to one; frequencies ascend.
#[derive(Debug, Clone, PartialEq)]
pub struct DmaData {
    points: Vec<DmaPoint>,
}

impl DmaData {
    /// Data whose frequencies rise from point to point; the lines of errors count points from 1.
    ///
    /// # Errors
    /// [`DmaError::Empty`], [`DmaError::Value`] for a number that is not positive and finite, [`DmaError::Order`] where the
    /// frequency does not rise.
    pub fn new(points: Vec<DmaPoint>) -> Result<Self, DmaError> {
        let lines = points.into_iter().enumerate().map(|(index, point)| (index + 1, point)).collect();
        Self::from_lines(lines, ("rad/s", 1.0))
    }

    /// [`DmaData::new`] for points that know the line of the file they come from; the unit of the file's frequencies, with its
    /// factor to rad/s, is for errors.
    pub(super) fn from_lines(
        lines: Vec<(usize, DmaPoint)>,
        (unit, factor): (&'static str, f64),
    ) -> Result<Self, DmaError> {
        if lines.is_empty() {
            return Err(DmaError::Empty);
        }
        for (line, point) in &lines {
            if let Some((name, value)) = point.unusable() {
                return Err(DmaError::Value { line: *line, name, found: value.to_string() });
            }
        }
        for pair in lines.windows(2) {
            let [before, after] = [&pair[0].1, &pair[1].1].map(|point| point.angular_frequency);
            if after <= before {
                let [before, after] = [before, after].map(|frequency| rounded(frequency / factor));
                return Err(DmaError::Order { line: pair[1].0, before, after, unit });
            }
        }
        Ok(Self { points: lines.into_iter().map(|(_, point)| point).collect() })
    }

    /// The points, ascending in frequency.
    #[must_use]
    pub fn points(&self) -> &[DmaPoint] {
        &self.points
    }

    /// Lowest and highest ω [rad/s].
    #[must_use]
    pub fn band(&self) -> (f64, f64) {
        let frequency = |point: Option<&DmaPoint>| point.map_or(f64::NAN, |point| point.angular_frequency);
        (frequency(self.points.first()), frequency(self.points.last()))
    }
}

/// The number as the file has it, without what its way to rad/s and back has added.
fn rounded(value: f64) -> f64 {
    format!("{value:.12e}").parse().unwrap_or(value)
}

/// Moduli measured over frequency at several temperatures, each with its own band.
#[derive(Debug, Clone, PartialEq)]
pub struct DmaSweeps {
    /// (T \[K\], data) in the order of the file.
    pub sweeps: Vec<(f64, DmaData)>,
}

impl DmaSweeps {
    /// The master curve at T_ref: what was measured at ω and T stands at ω a_T.
    ///
    /// # Errors
    /// As [`TemperatureShift::factor`], and [`MaterialError::Dma`] without data.
    pub fn master_curve(&self, shift: &TemperatureShift) -> Result<DmaData, MaterialError> {
        let factors = self.sweeps.iter().map(|(temperature, _)| shift.factor(*temperature));
        self.shifted_by(&factors.collect::<Result<Vec<_>, _>>()?)
    }

    /// The master curve for given a_T, one a sweep. Points of different sweeps may come to stand at one frequency.
    ///
    /// # Errors
    /// [`MaterialError::NotPositive`] for a factor or a frequency that leaves the numbers, [`MaterialError::Dma`] without data, for a number of factors that is not
    /// that of the sweeps.
    pub fn shifted_by(&self, factors: &[f64]) -> Result<DmaData, MaterialError> {
        if factors.len() != self.sweeps.len() {
            return Err(DmaError::Factors { factors: factors.len(), sweeps: self.sweeps.len() }.into());
        }
        let mut points = Vec::new();
        for ((_, data), factor) in self.sweeps.iter().zip(factors) {
            positive("the shift factor a_T", *factor)?;
            points.extend(
                data.points
                    .iter()
                    .map(|point| DmaPoint { angular_frequency: point.angular_frequency * factor, ..*point }),
            );
        }
        if let Some((_, value)) = points.iter().find_map(DmaPoint::unusable) {
            return Err(MaterialError::NotPositive { name: "a shifted frequency [rad/s]", value });
        }
        if points.is_empty() {
            return Err(DmaError::Empty.into());
        }
        points.sort_by(|a, b| a.angular_frequency.total_cmp(&b.angular_frequency));
        Ok(DmaData { points })
    }
}
