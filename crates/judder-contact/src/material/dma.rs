//! Measured moduli: dynamic mechanical analysis (DMA).

use super::error::{DmaError, MaterialError, positive};
use super::shift::TemperatureShift;
use judder_numerics::order::sort_by_number;

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
    /// Data whose frequencies rise from point to point.
    ///
    /// # Errors
    /// [`DmaError::Empty`], [`DmaError::Value`] for a number that is not positive and finite, [`DmaError::Order`] where the
    /// frequency does not rise.
    pub fn new(points: Vec<DmaPoint>) -> Result<Self, DmaError> {
        Self::counted_from(0, points)
    }

    /// [`DmaData::new`] for points before which others were measured.
    fn counted_from(before: usize, points: Vec<DmaPoint>) -> Result<Self, DmaError> {
        if points.is_empty() {
            return Err(DmaError::Empty);
        }
        for (index, point) in points.iter().enumerate() {
            if let Some((name, value)) = point.unusable() {
                return Err(DmaError::Value { index: before + index + 1, name, value });
            }
        }
        for (index, pair) in points.windows(2).enumerate() {
            let [lower, upper] = [&pair[0], &pair[1]].map(|point| point.angular_frequency);
            if upper <= lower {
                return Err(DmaError::Order { index: before + index + 2, before: lower, after: upper });
            }
        }
        Ok(Self { points })
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
    /// One sweep for every run of equal temperatures.
    fn of_runs(points: &[DmaPoint], temperature: &[f64]) -> Result<Self, DmaError> {
        let mut sweeps = Vec::new();
        let mut before = 0;
        for run in temperature.chunk_by(|a, b| a == b) {
            positive("temperature", run[0]).map_err(|_| DmaError::Value {
                index: before + 1,
                name: "temperature",
                value: run[0],
            })?;
            let own = points[before..before + run.len()].to_vec();
            sweeps.push((run[0], DmaData::counted_from(before, own)?));
            before += run.len();
        }
        Ok(Self { sweeps })
    }

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
        sort_by_number(&mut points, |own| own.angular_frequency);
        Ok(DmaData { points })
    }
}

/// What was measured, as tables have it.
#[derive(Debug, Clone, PartialEq)]
pub enum DmaMeasurement {
    /// Without temperatures: one sweep over frequency.
    Sweep(DmaData),
    /// With temperatures: one sweep for every run of measurements at one temperature.
    Sweeps(DmaSweeps),
}

impl DmaMeasurement {
    /// Columns of equal length: ω [rad/s], E′ and E″ \[Pa\], T \[K\].
    ///
    /// # Errors
    /// [`DmaError`]: no measurements, columns of different lengths, a number that is not positive and finite, a frequency that
    /// does not rise above the one before at the same temperature.
    pub fn of_columns(
        angular_frequency: &[f64],
        storage_modulus: &[f64],
        loss_modulus: &[f64],
        temperature: Option<&[f64]>,
    ) -> Result<Self, DmaError> {
        let frequencies = angular_frequency.len();
        let others = [Some(storage_modulus), Some(loss_modulus), temperature].into_iter().flatten();
        if let Some(other) = others.into_iter().find(|other| other.len() != frequencies) {
            return Err(DmaError::Columns { length: other.len(), frequencies });
        }
        let moduli = storage_modulus.iter().zip(loss_modulus);
        let points: Vec<DmaPoint> = angular_frequency
            .iter()
            .zip(moduli)
            .map(|(frequency, (storage, loss))| DmaPoint {
                angular_frequency: *frequency,
                storage_modulus: *storage,
                loss_modulus: *loss,
            })
            .collect();
        match temperature {
            None => Ok(Self::Sweep(DmaData::new(points)?)),
            Some([]) => Err(DmaError::Empty),
            Some(temperature) => Ok(Self::Sweeps(DmaSweeps::of_runs(&points, temperature)?)),
        }
    }

    /// The data, where there is only one temperature.
    ///
    /// # Errors
    /// [`DmaError::SeveralTemperatures`].
    pub fn single(self) -> Result<DmaData, DmaError> {
        match self {
            Self::Sweep(data) => Ok(data),
            Self::Sweeps(DmaSweeps { mut sweeps }) if sweeps.len() == 1 => Ok(sweeps.remove(0).1),
            Self::Sweeps(DmaSweeps { sweeps }) => Err(DmaError::SeveralTemperatures { sweeps: sweeps.len() }),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const FREQUENCIES: [f64; 3] = [1.0, 10.0, 1.0];

    fn measured(frequencies: &[f64], temperatures: &[f64]) -> Result<DmaMeasurement, DmaError> {
        DmaMeasurement::of_columns(frequencies, &[5.0, 6.0, 4.0], &[1.0; 3], Some(temperatures))
    }

    #[test]
    fn a_run_of_equal_temperatures_is_a_sweep() {
        let DmaMeasurement::Sweeps(sweeps) = measured(&FREQUENCIES, &[293.15, 293.15, 303.15]).unwrap()
        else {
            panic!("no sweeps")
        };
        assert_eq!(sweeps.sweeps.len(), 2);
        assert_eq!(sweeps.sweeps[1].0, 303.15);
        let master = sweeps.shifted_by(&[1.0, 0.1]).unwrap();
        let frequencies: Vec<f64> = master.points().iter().map(|p| p.angular_frequency).collect();
        assert_eq!(frequencies, [0.1, 1.0, 10.0]);
        assert!(sweeps.shifted_by(&[1.0]).is_err());
    }

    #[test]
    fn measurements_that_cannot_be_used_are_refused_by_number() {
        let order = measured(&[1.0, 10.0, 2.0], &[293.15; 3]).unwrap_err();
        assert_eq!(order, DmaError::Order { index: 3, before: 10.0, after: 2.0 });
        let negative = measured(&[1.0, 10.0, -1.0], &[293.15, 293.15, 303.15]).unwrap_err();
        assert_eq!(negative, DmaError::Value { index: 3, name: "frequency", value: -1.0 });
        assert_eq!(measured(&FREQUENCIES, &[293.15]), Err(DmaError::Columns { length: 1, frequencies: 3 }));
        assert_eq!(DmaMeasurement::of_columns(&[], &[], &[], None), Err(DmaError::Empty));
    }
}
