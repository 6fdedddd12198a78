//! Few vectors that carry many: proper orthogonal decomposition of snapshots.

use crate::statics::dot;
use faer::Mat;
use judder_dense::symmetric::{Eigen, symmetric};
use rayon::prelude::*;

/// Directions that hold less than this share of the largest are left out.
const CUT: f64 = 1e-6;

/// Orthonormal columns that carry the snapshots, all of one length; `None` where they have no finite directions.
pub(super) fn decomposed(snapshots: &[Vec<f64>]) -> Option<Vec<Vec<f64>>> {
    let products: Vec<Vec<f64>> = (0..snapshots.len())
        .into_par_iter()
        .map(|i| (0..=i).map(|j| dot(&snapshots[i], &snapshots[j])).collect())
        .collect();
    let gram = Mat::from_fn(snapshots.len(), snapshots.len(), |i, j| products[i.max(j)][i.min(j)]);
    let Eigen { values, vectors } = symmetric(&gram)?;
    let largest = values.last().copied().filter(|value| *value > 0.0)?;
    let kept = (0..values.len()).rev().filter(|k| values[*k] > CUT * CUT * largest);
    let directions: Vec<Vec<f64>> = kept
        .collect::<Vec<_>>()
        .into_par_iter()
        .map(|k| {
            let mut sum = vec![0.0; snapshots[0].len()];
            for (i, snapshot) in snapshots.iter().enumerate() {
                add(&mut sum, vectors[(i, k)] / values[k].sqrt(), snapshot);
            }
            sum
        })
        .collect();
    Some(orthonormal(directions))
}

/// Gram–Schmidt, twice: the squares in the products have cost half of the digits of small directions.
fn orthonormal(directions: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
    let mut basis: Vec<Vec<f64>> = Vec::with_capacity(directions.len());
    for mut direction in directions {
        for _ in 0..2 {
            for vector in &basis {
                let share = dot(vector, &direction);
                add(&mut direction, -share, vector);
            }
        }
        let length = dot(&direction, &direction).sqrt();
        for entry in &mut direction {
            *entry /= length;
        }
        basis.push(direction);
    }
    basis
}

/// y += a x.
fn add(y: &mut [f64], a: f64, x: &[f64]) {
    for (y, x) in y.iter_mut().zip(x) {
        *y += a * x;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_basis_is_orthonormal_and_carries_its_snapshots() {
        let snapshots: Vec<Vec<f64>> = (0..9)
            .map(|k| (0..40).map(|i| (f64::from(k % 6) * 0.3 + 0.1 * f64::from(i)).sin()).collect())
            .collect();
        let basis = decomposed(&snapshots).unwrap();
        assert_eq!(basis.len(), 2, "sines of one frequency are sums of two");
        assert!(dot(&basis[0], &basis[1]).abs() < 1e-14);
        for snapshot in &snapshots {
            let carried: f64 = basis.iter().map(|vector| dot(vector, snapshot).powi(2)).sum();
            assert!((carried / dot(snapshot, snapshot) - 1.0).abs() < 1e-12);
        }
        assert!(decomposed(&[vec![0.0; 3]]).is_none());
    }
}
