//! Sobol' indices: which share of the variance of an output each input carries, alone and with the others.
//!
//! The inputs are independent, each evenly distributed over its range (on its own scale). With V the variance of the output,
//!
//! - first order, S_j = V[E(f | x_j)]/V: the share that is gone once x_j is known;
//! - total, T_j = E[V(f | all but x_j)]/V: the share that is left once all others are known; T_j − S_j is what x_j does together with
//!   others.
//!
//! The output is known on rows f(A), f(AB_1) … f(AB_k), f(B): A and B two independent points, AB_j the point A with the coordinate j of B.
//! From them, with f centred about its mean (A. Saltelli et al., *Variance based sensitivity analysis of model output*, Comput. Phys.
//! Commun. 181 (2010) 259–270, Table 2 (b) and (f), the second after M. J. W. Jansen, Comput. Phys. Commun. 117 (1999) 35–43):
//!
//! S_j = ⟨f(B) (f(AB_j) − f(A))⟩/V, T_j = ⟨(f(A) − f(AB_j))²⟩/(2V), V the variance of all f(A) and f(B).

use thiserror::Error;

use crate::counter;
use crate::order::sort_numbers;

/// What the confidence intervals of indices are made with.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bootstrap {
    /// The confidence of the intervals, between 0 and 1, both excluded.
    pub confidence: f64,
    /// How often the rows are drawn anew, at least 2.
    pub resamples: usize,
    /// Which rows are drawn.
    pub seed: u64,
}

/// An index with its confidence interval.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Index {
    /// The estimate from all rows. Its true value lies in [0, 1], the estimate may lie a little outside.
    pub value: f64,
    /// The lower end of the interval.
    pub lower: f64,
    /// The upper end of the interval.
    pub upper: f64,
}

/// The indices of one output.
#[derive(Debug, Clone, PartialEq)]
pub struct SobolIndices {
    /// S_j of every input.
    pub first: Vec<Index>,
    /// T_j of every input.
    pub total: Vec<Index>,
    /// How many rows they come from.
    pub rows: usize,
    /// How many rows were left out because one of their values is not finite.
    pub left_out: usize,
    /// The mean of all f(A) and f(B).
    pub mean: f64,
    /// Their variance V; infinite where a double cannot hold it.
    pub variance: f64,
}

/// Why there are no indices.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum SensitivityError {
    /// Values that do not fill rows.
    #[error("{values} values do not fill rows of {row}, the number of inputs and two")]
    Shape {
        /// How many values there are.
        values: usize,
        /// How many a row has.
        row: usize,
    },
    /// A confidence outside (0, 1), or too few resamples for an interval.
    #[error("intervals of the confidence {confidence} cannot be taken from {resamples} resamples")]
    Bootstrap {
        /// The confidence that was asked for.
        confidence: f64,
        /// The resamples that were asked for.
        resamples: usize,
    },
    /// Too few rows whose values are all finite.
    #[error("{rows} rows are finite ({left_out} are not), at least {LEAST_ROWS} are needed")]
    TooFewRows {
        /// The rows whose values are all finite.
        rows: usize,
        /// The other rows.
        left_out: usize,
    },
    /// An output that is the same everywhere, so that nothing has a share in its variance.
    #[error("the output is {mean} at both points of all {rows} rows: it has no variance to share out")]
    NoVariance {
        /// The output; its mean, where rounding alone makes it differ.
        mean: f64,
        /// The rows.
        rows: usize,
    },
}

/// The standard deviation, over the mean, that rounding alone gives an output.
const ROUNDING: f64 = 1e-15;

/// The fewest rows from which indices are estimated.
pub const LEAST_ROWS: usize = 4;

/// The first-order and total indices of an output, from its values on rows f(A), f(AB_1) … f(AB_inputs), f(B).
///
/// Rows with a value that is not finite are left out and counted: the indices then are those of the part of the cube where the output
/// exists. The intervals are the quantiles of a bootstrap over rows (B. Efron, *Bootstrap methods*, Ann. Statist. 7 (1979) 1–26; percentile
/// method), the same for the same seed. Points of a Sobol' sequence are more even than the rows that are drawn: with them the intervals are
/// too wide rather than too narrow. The work is `resamples` times the number of values.
///
/// # Errors
/// [`SensitivityError`] for values that do not fill rows, settings without an interval, too few finite rows, an output without variance.
pub fn sobol_indices(
    values: &[f64],
    inputs: usize,
    bootstrap: &Bootstrap,
) -> Result<SobolIndices, SensitivityError> {
    let row = inputs.saturating_add(2);
    if inputs == 0 || !values.len().is_multiple_of(row) {
        return Err(SensitivityError::Shape { values: values.len(), row });
    }
    let Bootstrap { confidence, resamples, .. } = *bootstrap;
    if !(confidence > 0.0 && confidence < 1.0) || resamples < 2 {
        return Err(SensitivityError::Bootstrap { confidence, resamples });
    }
    let all = values.chunks_exact(row);
    let rows: Vec<&[f64]> = all.clone().filter(|row| row.iter().all(|value| value.is_finite())).collect();
    let left_out = all.len() - rows.len();
    if rows.len() < LEAST_ROWS {
        return Err(SensitivityError::TooFewRows { rows: rows.len(), left_out });
    }
    let rows = ScaledRows::new(&rows);
    let estimate = rows.estimate(0..rows.count);
    let mean = rows.middle + rows.scale * estimate.mean;
    let deviation = rows.scale * estimate.variance.sqrt();
    if deviation <= ROUNDING * mean.abs() {
        return Err(SensitivityError::NoVariance { mean, rows: rows.count });
    }
    let (first, total) = rows.intervals(&estimate, bootstrap);
    let variance = deviation * deviation;
    Ok(SobolIndices { first, total, rows: rows.count, left_out, mean, variance })
}

/// Values of finite rows, moved and scaled to magnitude 1, so that squares neither overflow nor vanish.
struct ScaledRows {
    values: Vec<f64>,
    inputs: usize,
    count: usize,
    middle: f64,
    scale: f64,
}

/// What one selection of rows gives.
struct SelectionEstimate {
    first: Vec<f64>,
    total: Vec<f64>,
    mean: f64,
    variance: f64,
}

impl ScaledRows {
    fn new(rows: &[&[f64]]) -> Self {
        let values = || rows.iter().flat_map(|row| row.iter().copied());
        let (low, high) = values()
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)));
        // halved first: the difference of finite numbers may be infinite
        let (middle, scale) = (0.5 * low + 0.5 * high, 0.5 * high - 0.5 * low);
        let scale = if scale > 0.0 { scale } else { 1.0 };
        let values = values().map(|value| (value - middle) / scale).collect();
        Self { values, inputs: rows[0].len() - 2, count: rows.len(), middle, scale }
    }

    /// The indices of these rows, each counted as often as it is named.
    fn estimate(&self, selected: impl Iterator<Item = usize> + Clone) -> SelectionEstimate {
        let row = |k: usize| &self.values[k * (self.inputs + 2)..(k + 1) * (self.inputs + 2)];
        let (mut sum, mut count) = (0.0, 0.0);
        for values in selected.clone().map(row) {
            sum += values[0] + values[self.inputs + 1];
            count += 2.0;
        }
        let mean = sum / count;
        let (mut squares, mut first, mut total) = (0.0, vec![0.0; self.inputs], vec![0.0; self.inputs]);
        for values in selected.map(row) {
            let (a, b) = (values[0] - mean, values[self.inputs + 1] - mean);
            squares += a * a + b * b;
            for (j, value) in values[1..=self.inputs].iter().enumerate() {
                let change = value - mean - a;
                first[j] += b * change;
                total[j] += change * change;
            }
        }
        // every sum of the products is over half as many rows as the squares
        first.iter_mut().for_each(|sum| *sum *= 2.0 / squares);
        total.iter_mut().for_each(|sum| *sum /= squares);
        SelectionEstimate { first, total, mean, variance: squares / count }
    }

    /// Estimates with the quantiles of resamples as their intervals.
    fn intervals(&self, estimate: &SelectionEstimate, bootstrap: &Bootstrap) -> (Vec<Index>, Vec<Index>) {
        let (mut first, mut total) = (vec![Vec::new(); self.inputs], vec![Vec::new(); self.inputs]);
        for resample in 0..bootstrap.resamples {
            let stream = counter::bits(bootstrap.seed, resample as u64);
            let drawn = (0..self.count as u64)
                .map(|k| ((u128::from(counter::bits(stream, k)) * self.count as u128) >> 64) as usize);
            let again = self.estimate(drawn);
            // a resample of equal values has no indices
            if again.variance > 0.0 {
                first.iter_mut().zip(again.first).for_each(|(all, index)| all.push(index));
                total.iter_mut().zip(again.total).for_each(|(all, index)| all.push(index));
            }
        }
        let index = |(value, mut drawn): (&f64, Vec<f64>)| {
            sort_numbers(&mut drawn);
            let tail = 0.5 * (1.0 - bootstrap.confidence);
            let [lower, upper] = [tail, 1.0 - tail].map(|share| quantile(&drawn, share));
            Index { value: *value, lower, upper }
        };
        let first = estimate.first.iter().zip(first).map(index).collect();
        (first, estimate.total.iter().zip(total).map(index).collect())
    }
}

/// The quantile of sorted numbers, linear between them; NaN of none.
fn quantile(sorted: &[f64], share: f64) -> f64 {
    let Some(last) = sorted.len().checked_sub(1) else { return f64::NAN };
    let place = share * last as f64;
    let below = place.floor() as usize;
    let above = (below + 1).min(last);
    sorted[below] + (place - below as f64) * (sorted[above] - sorted[below])
}
