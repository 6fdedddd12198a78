//! Stable, marginal, unstable: one set of verdicts of every model and in every result.

/// Whether steady sliding is linearly stable, as all its eigenvalues say or one of them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    /// Disturbances decay: eigenvalues in the left half-plane.
    Stable,
    /// On the boundary within rounding or within the error of the eigenvalue, which of a defective one is that of a square root; and purely imaginary eigenvalues
    /// of an undamped system.
    Marginal,
    /// Disturbances grow: an eigenvalue in the right half-plane.
    Unstable,
}

impl Verdict {
    /// `"stable"`, `"marginal"` or `"unstable"`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Stable => "stable",
            Self::Marginal => "marginal",
            Self::Unstable => "unstable",
        }
    }
}
