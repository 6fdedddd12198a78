//! One eigenvalue over a part of a parameter's range, as the samples foretell it.

use super::PairFamily;
use super::meeting::{EigenvalueGroup, Sheet, StabilityMargin};
use num_complex::Complex64;

/// Places of a branch and its eigenvalues there, in the order of the parameter.
pub(super) type EigenvaluePath = Vec<(f64, Complex64)>;

/// The samples do not foretell what lies between them.
pub(super) struct TooCoarse;

/// One eigenvalue over a part.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct PartBranch {
    pub(super) group: EigenvalueGroup,
    pub(super) sheet: Sheet,
    /// Where the part starts and ends.
    pub(super) ends: [f64; 2],
    pub(super) is_conservative: bool,
}

impl PartBranch {
    /// The parameter at a share of the part.
    pub(super) fn place(&self, share: f64) -> f64 {
        self.ends[0] + share * (self.ends[1] - self.ends[0])
    }

    /// As the samples foretell it.
    pub(super) fn foretold(&self, share: f64) -> StabilityMargin {
        self.group.foretold(share, self.sheet, self.is_conservative)
    }

    /// As it is; `None` where the pair does not exist there or has other eigenvalues.
    pub(super) fn found(&self, family: &dyn PairFamily, share: f64) -> Option<StabilityMargin> {
        let function = family.at(self.place(share)).ok()?;
        self.group.found(share, self.sheet, &function)
    }

    /// Its bound at a share of the part; at an end it is cut, and may go on beyond.
    pub(super) fn bound(&self, share: f64) -> Bound {
        let eigenvalue = self.foretold(share).eigenvalue;
        Bound { at: self.place(share), eigenvalue, is_cut: share == 0.0 || share == 1.0 }
    }
}

/// An end of a strip.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Bound {
    pub(super) at: f64,
    pub(super) eigenvalue: Complex64,
    /// Whether the part ends here, not the instability.
    pub(super) is_cut: bool,
}
