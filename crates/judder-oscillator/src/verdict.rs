//! Whether steady sliding is stable.

/// Whether steady sliding is linearly stable.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    /// Every eigenvalue in the left half-plane.
    Stable,
    /// On the boundary within rounding, or purely imaginary eigenvalues of an undamped system.
    Marginal,
    /// An eigenvalue in the right half-plane.
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
