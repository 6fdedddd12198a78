//! Points of a sweep as an interrupted run keeps them: their eigenvalues and branches, without the vectors by which they are followed.

use judder_structure::complex_modes::Eigenvalue;
use judder_structure::eigen_sweep::{FollowedPoints, PointEigenvalues, Tracked};
use judder_study::kept::{KeptLines, KeptResults};
use num_complex::Complex64;
use serde::{Deserialize, Serialize};

/// The points of one sweep.
pub(crate) struct KeptPoints<'a>(KeptResults<'a, KeptPoint>);

/// A point at which no eigenvalue is missing; others are solved again.
#[derive(Serialize, Deserialize)]
struct KeptPoint {
    eigenvalues: Vec<KeptEigenvalue>,
    full: bool,
}

/// An eigenvalue and its branch.
#[derive(Serialize, Deserialize)]
struct KeptEigenvalue {
    /// Real and imaginary part, both residuals, condition and error, by their bits: the condition may be infinite.
    bits: [u64; 6],
    defective: bool,
    branch: usize,
}

impl<'a> KeptPoints<'a> {
    /// Those of a part of an analysis.
    pub(crate) fn of(part: &'static str, kept: KeptLines<'a>) -> Self {
        Self(KeptResults::of(part, kept))
    }

    /// Whether a point is known.
    pub(crate) fn has(&self, number: usize) -> bool {
        self.0.known(number as u64).is_some()
    }
}

impl FollowedPoints for KeptPoints<'_> {
    fn known(&self, number: usize) -> Option<PointEigenvalues> {
        let KeptPoint { eigenvalues, full } = self.0.known(number as u64)?;
        let eigenvalues = eigenvalues.iter().map(KeptEigenvalue::tracked).collect();
        Some(PointEigenvalues { eigenvalues, gaps: Vec::new(), full: *full })
    }

    fn keep(&self, number: usize, point: &PointEigenvalues) {
        if point.gaps.is_empty() {
            let eigenvalues = point.eigenvalues.iter().map(KeptEigenvalue::new).collect();
            self.0.keep(number as u64, &KeptPoint { eigenvalues, full: point.full });
        }
    }
}

impl KeptEigenvalue {
    fn new(tracked: &Tracked) -> Self {
        let Tracked { eigenvalue, branch } = *tracked;
        let Eigenvalue { value, residual, left_residual, condition, error, defective } = eigenvalue;
        let bits = [value.re, value.im, residual, left_residual, condition, error].map(f64::to_bits);
        Self { bits, defective, branch }
    }

    fn tracked(&self) -> Tracked {
        let [re, im, residual, left_residual, condition, error] = self.bits.map(f64::from_bits);
        let value = Complex64::new(re, im);
        let defective = self.defective;
        let eigenvalue = Eigenvalue { value, residual, left_residual, condition, error, defective };
        Tracked { eigenvalue, branch: self.branch }
    }
}
