//! Start values for the fits, from the samples alone.

use super::FitError;
use super::least_squares::Observation;
use nalgebra::{DMatrix, DVector};

/// How far the plateaus are taken beyond the extreme samples, as a share of their distance.
const MARGIN: f64 = 0.02;

/// The smallest singular value, over the largest, that still determines a regression.
const RANK_TOLERANCE: f64 = 1e-10;

/// The smallest and the largest value; refuses values that are all the same.
fn extremes(function: &'static str, data: &[Observation]) -> Result<(f64, f64), FitError> {
    let low = data.iter().map(|o| o.value).fold(f64::INFINITY, f64::min);
    let high = data.iter().map(|o| o.value).fold(f64::NEG_INFINITY, f64::max);
    if high > 0.0 && high - low > 1e-9 * high {
        Ok((low, high))
    } else {
        Err(FitError::Undetermined { function })
    }
}

/// Weighted linear regression of `right` on the columns of `row`.
fn regression<const N: usize>(
    function: &'static str,
    data: &[Observation],
    row: impl Fn(&Observation) -> ([f64; N], f64, f64),
) -> Result<[f64; N], FitError> {
    let mut matrix = DMatrix::zeros(data.len(), N);
    let mut right = DVector::zeros(data.len());
    for (k, observation) in data.iter().enumerate() {
        let (columns, value, weight) = row(observation);
        for (n, column) in columns.into_iter().enumerate() {
            matrix[(k, n)] = weight * column;
        }
        right[k] = weight * value;
    }
    let decomposition = matrix.svd(true, true);
    let largest = decomposition.singular_values.max();
    let is_determined = decomposition.singular_values.min() > RANK_TOLERANCE * largest;
    let solution = decomposition.solve(&right, 0.0).ok().filter(|_| is_determined);
    let solution = solution.ok_or(FitError::Undetermined { function })?;
    let mut coefficients = [0.0; N];
    coefficients.copy_from_slice(solution.as_slice());
    Ok(coefficients)
}

/// a₁ … a₅: the plateaus from the extremes, the transition from a regression of its inverse.
pub(super) fn force(function: &'static str, data: &[Observation]) -> Result<[f64; 5], FitError> {
    let (low, high) = extremes(function, data)?;
    let margin = MARGIN * (high - low);
    let (low, high) = (low - margin, high + margin);
    let height = high - low;
    // erf(x) is tanh(1.2 x) to 2 %
    let [by_velocity, by_indentation, constant] = regression(function, data, |o| {
        let share = 2.0 * (o.value - low) / height - 1.0;
        let weight = 1.0 - share * share;
        ([o.log10_velocity, o.log10_indentation, 1.0], libm::atanh(share) / 1.2, weight)
    })?;
    Ok([height, (high + low) / height, by_velocity, by_indentation, constant])
}

/// Slope, centre and width of a bell, from the moments of its square.
fn bell(
    function: &'static str,
    data: &[Observation],
    height: impl Fn(&Observation) -> f64,
) -> Result<[f64; 3], FitError> {
    let [slope, centre] =
        regression(function, data, |o| ([o.log10_indentation, 1.0], o.log10_velocity, height(o)))?;
    let (mut weights, mut squares) = (0.0, 0.0);
    for o in data {
        let weight = height(o) * height(o);
        let distance = o.log10_velocity - (slope * o.log10_indentation + centre);
        weights += weight;
        squares += weight * distance * distance;
    }
    // the square of a bell is a bell of half the variance
    let width = (2.0 * squares / weights).sqrt();
    if width > 0.0 { Ok([slope, centre, width]) } else { Err(FitError::Undetermined { function }) }
}

/// b₁ … b₅: the level from the largest value, the dip from its moments.
pub(super) fn area(function: &'static str, data: &[Observation]) -> Result<[f64; 5], FitError> {
    let (low, high) = extremes(function, data)?;
    let depth = high - low;
    let [slope, centre, width] = bell(function, data, |o| (high - o.value) / depth)?;
    Ok([depth, high / depth, slope, centre, width])
}

/// c₁ … c₄: the height from the largest value, the rest from the moments.
pub(super) fn friction(function: &'static str, data: &[Observation]) -> Result<[f64; 4], FitError> {
    let (_, high) = extremes(function, data)?;
    let [slope, centre, width] = bell(function, data, |o| (o.value / high).max(0.0))?;
    Ok([high, slope, centre, width])
}
