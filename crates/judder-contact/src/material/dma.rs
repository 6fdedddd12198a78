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
    /// Data whose frequencies rise from point to point; `row` numbers in errors count points from 1.
    ///
    /// # Errors
    /// [`DmaError::Empty`], [`DmaError::Value`] for a number that is not positive and finite, [`DmaError::Order`] where the
    /// frequency does not rise.
    pub fn new(points: Vec<DmaPoint>) -> Result<Self, DmaError> {
        let rows = points.into_iter().enumerate().map(|(index, point)| (index + 1, point)).collect();
        Self::from_rows(rows)
    }

    /// [`DmaData::new`] for points that know the row of the file they come from.
    pub(super) fn from_rows(rows: Vec<(usize, DmaPoint)>) -> Result<Self, DmaError> {
        if rows.is_empty() {
            return Err(DmaError::Empty);
        }
        for (row, point) in &rows {
            if let Some((name, value)) = point.unusable() {
                return Err(DmaError::Value { row: *row, name, found: value.to_string() });
            }
        }
        for pair in rows.windows(2) {
            let [before, after] = [&pair[0].1, &pair[1].1].map(|point| point.angular_frequency);
            if after <= before {
                return Err(DmaError::Order { row: pair[1].0, before, after });
            }
        }
        Ok(Self { points: rows.into_iter().map(|(_, point)| point).collect() })
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
