//! Periodic signals as their mean and harmonics.
//!
//! x(τ) = a₀ + Σ (a_h cos hτ + b_h sin hτ), τ = ω t. The coefficients of a signal stand as a₀, a₁, b₁, a₂, b₂, …; those of many as columns
//! of a matrix, as do their values at even instants of a period.

use faer::{Mat, MatRef};
use judder_dense::product::{product, product_into};
use std::f64::consts::TAU;

/// Harmonics, and the instants of a period at which signals are known.
#[derive(Debug, Clone)]
pub struct Series {
    harmonics: usize,
    samples: usize,
    /// 1, cos τ, sin τ, … up to twice as many harmonics, a row an instant.
    table: Mat<f64>,
    /// What takes values to coefficients: the transpose of the table, weighted.
    back: Mat<f64>,
}

/// The mean value of a factor times harmonics: ⟨f cos mτ⟩ and ⟨f sin mτ⟩ for m up to twice the harmonics.
#[derive(Debug, Clone, Copy)]
struct Means<'a> {
    coefficients: &'a [f64],
}

impl Means<'_> {
    fn cosine(&self, order: usize) -> f64 {
        match order {
            0 => self.coefficients[0],
            _ => 0.5 * self.coefficients[2 * order - 1],
        }
    }

    fn sine(&self, order: usize) -> f64 {
        match order {
            0 => 0.0,
            _ => 0.5 * self.coefficients[2 * order],
        }
    }

    /// ⟨f sin (i − j)τ⟩.
    fn sine_between(&self, i: usize, j: usize) -> f64 {
        if i >= j { self.sine(i - j) } else { -self.sine(j - i) }
    }
}

impl Series {
    /// So many harmonics beside the mean, known at so many instants; at least four a harmonic and one, so that products keep what they are.
    #[must_use]
    pub fn new(harmonics: usize, samples: usize) -> Self {
        let samples = samples.max(4 * harmonics + 1);
        let wide = 4 * harmonics + 1;
        let entry = |instant: usize, column: usize| {
            let order = column.div_ceil(2);
            // an exact multiple of a turn is taken off before it is rounded
            let angle = TAU * ((order * instant) % samples) as f64 / samples as f64;
            if column % 2 == 1 || column == 0 { libm::cos(angle) } else { libm::sin(angle) }
        };
        let table = Mat::from_fn(samples, wide, entry);
        let weight = |column: usize| if column == 0 { 1.0 } else { 2.0 } / samples as f64;
        let back = Mat::from_fn(wide, samples, |row, instant| weight(row) * table[(instant, row)]);
        Self { harmonics, samples, table, back }
    }

    /// Bytes of its tables.
    #[must_use]
    pub fn bytes(harmonics: usize, samples: usize) -> u128 {
        let [harmonics, samples] = [harmonics, samples].map(|own| own as u128);
        8 * 2 * samples.max(4 * harmonics + 1) * (4 * harmonics + 1)
    }

    /// H.
    #[must_use]
    pub fn harmonics(&self) -> usize {
        self.harmonics
    }

    /// Instants of a period.
    #[must_use]
    pub fn samples(&self) -> usize {
        self.samples
    }

    /// 2 H + 1.
    #[must_use]
    pub fn coefficients(&self) -> usize {
        2 * self.harmonics + 1
    }

    /// The values of signals: instants × signals.
    #[must_use]
    pub fn values(&self, coefficients: MatRef<'_, f64>) -> Mat<f64> {
        product(self.table.subcols(0, self.coefficients()), coefficients)
    }

    /// The same into a matrix that there is, which takes their size.
    pub(crate) fn values_into(&self, coefficients: MatRef<'_, f64>, values: &mut Mat<f64>) {
        sized(values, self.samples, coefficients.ncols());
        product_into(values.as_mut(), self.table.subcols(0, self.coefficients()), coefficients);
    }

    /// The coefficients of signals: 2 H + 1 × signals.
    #[must_use]
    pub fn of_values(&self, values: MatRef<'_, f64>) -> Mat<f64> {
        product(self.back.subrows(0, self.coefficients()), values)
    }

    /// The coefficients of signals that are known at any number of even instants of a period: 2 H + 1 × signals; harmonics that those do not tell are zero.
    pub(crate) fn of_period(&self, values: MatRef<'_, f64>) -> Mat<f64> {
        let told = values.nrows().saturating_sub(1) / 2;
        let weight = |row: usize| if row == 0 { 1.0 } else { 2.0 } / values.nrows() as f64;
        let factor = |row: usize, instant: usize| {
            let angle = TAU * ((row.div_ceil(2) * instant) % values.nrows()) as f64 / values.nrows() as f64;
            if row % 2 == 1 || row == 0 { libm::cos(angle) } else { libm::sin(angle) }
        };
        Mat::from_fn(self.coefficients(), values.ncols(), |row, signal| {
            if row > 2 * told {
                return 0.0;
            }
            let column = values.col(signal);
            weight(row)
                * (0..values.nrows()).map(|instant| factor(row, instant) * column[instant]).sum::<f64>()
        })
    }

    /// The same into a matrix that there is, which takes their size.
    pub(crate) fn of_values_into(&self, values: MatRef<'_, f64>, coefficients: &mut Mat<f64>) {
        sized(coefficients, self.coefficients(), values.ncols());
        product_into(coefficients.as_mut(), self.back.subrows(0, self.coefficients()), values);
    }

    /// The coefficients of factors up to twice the harmonics, for [`Series::multiplication`].
    #[must_use]
    pub fn of_factors(&self, values: MatRef<'_, f64>) -> Mat<f64> {
        product(self.back.as_ref(), values)
    }

    /// The same into a matrix that there is, which takes their size.
    pub(crate) fn of_factors_into(&self, values: MatRef<'_, f64>, factors: &mut Mat<f64>) {
        sized(factors, self.back.nrows(), values.ncols());
        product_into(factors.as_mut(), self.back.as_ref(), values);
    }

    /// What multiplication with a factor does to the coefficients of a signal, those beyond H left out; column after column.
    ///
    /// With p = f x: the derivative of its coefficients by those of x, exactly as sums over the instants give it.
    pub fn multiplication(&self, factor: &[f64], out: &mut [f64]) {
        let size = self.coefficients();
        let means = Means { coefficients: factor };
        for column in 0..size {
            let (j, by_cosine) = (column.div_ceil(2), column % 2 == 1 || column == 0);
            for row in 0..size {
                let (i, of_cosine) = (row.div_ceil(2), row % 2 == 1 || row == 0);
                let (apart, together) = (i.abs_diff(j), i + j);
                let mean = match (of_cosine, by_cosine) {
                    (true, true) => 0.5 * (means.cosine(apart) + means.cosine(together)),
                    (false, false) => 0.5 * (means.cosine(apart) - means.cosine(together)),
                    (false, true) => 0.5 * (means.sine(together) + means.sine_between(i, j)),
                    (true, false) => 0.5 * (means.sine(together) + means.sine_between(j, i)),
                };
                out[column * size + row] = if row == 0 { mean } else { 2.0 * mean };
            }
        }
    }
}

/// A matrix that is written over takes a size.
pub(crate) fn sized(matrix: &mut Mat<f64>, rows: usize, columns: usize) {
    if [matrix.nrows(), matrix.ncols()] != [rows, columns] {
        *matrix = Mat::zeros(rows, columns);
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    fn column(values: &[f64]) -> Mat<f64> {
        Mat::from_fn(values.len(), 1, |row, _| values[row])
    }

    #[test]
    fn coefficients_come_back_from_values() {
        let series = Series::new(4, 32);
        let own: Vec<f64> = (0..9).map(|k| (1.3 * k as f64).sin()).collect();
        let values = series.values(column(&own).as_ref());
        let tau = TAU * 5.0 / 32.0;
        let expected: f64 = own[0]
            + (1..=4)
                .map(|h| own[2 * h - 1] * (h as f64 * tau).cos() + own[2 * h] * (h as f64 * tau).sin())
                .sum::<f64>();
        assert!((values[(5, 0)] - expected).abs() < 1e-14);
        let back = series.of_values(values.as_ref());
        (0..9).for_each(|k| assert!((back[(k, 0)] - own[k]).abs() < 1e-14));
    }

    /// A factor with jumps, which has more harmonics than are kept.
    #[test]
    fn a_factor_multiplies_as_its_values_do() {
        let series = Series::new(3, 24);
        let factor: Vec<f64> = (0..24).map(|k| if k % 7 < 3 { 1.0 } else { -0.4 * k as f64 }).collect();
        let own: Vec<f64> = (0..7).map(|k| (2.1 * k as f64).cos()).collect();
        let values = series.values(column(&own).as_ref());
        let multiplied = Mat::from_fn(24, 1, |k, _| factor[k] * values[(k, 0)]);
        let expected = series.of_values(multiplied.as_ref());
        let of_factor = series.of_factors(column(&factor).as_ref());
        let mut matrix = vec![0.0; 49];
        series.multiplication(of_factor.col_as_slice(0), &mut matrix);
        for row in 0..7 {
            let found: f64 = (0..7).map(|column| matrix[column * 7 + row] * own[column]).sum();
            assert!((found - expected[(row, 0)]).abs() < 1e-13, "{row}");
        }
    }
}
