//! Verdict and mechanism.

use crate::characteristic::Characteristic;
use crate::conservative::discriminant;
use crate::linear_system::ReducedSystem;

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

/// What carries an instability.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mechanism {
    /// Nothing: not unstable.
    None,
    /// The modes have merged already without damping (mode coupling).
    Flutter,
    /// c11 < 0: friction falls with speed (Stribeck).
    NegativeDamping,
    /// Flutter and negative damping.
    Both,
    /// Neither: a normal force (or any cross term of C) that depends on velocity, through c21 (k12 + k12c) in p1.
    NormalForceCoupling,
}

impl Mechanism {
    /// The name that files and reports use.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Flutter => "flutter",
            Self::NegativeDamping => "negative-damping",
            Self::Both => "both",
            Self::NormalForceCoupling => "normal-force-coupling",
        }
    }
}

/// Verdict and mechanism of one point, as one small code: what a stability map holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
pub enum StabilityClass {
    /// Stable.
    Stable = 0,
    /// Unstable by flutter.
    Flutter = 1,
    /// Unstable by negative damping.
    NegativeDamping = 2,
    /// Unstable by both.
    Both = 3,
    /// Unstable by neither.
    NormalForceCoupling = 4,
    /// Marginal.
    Marginal = 5,
    /// No answer here.
    Unresolved = 6,
}

impl StabilityClass {
    /// All classes, in the order of their codes.
    pub const ALL: [Self; 7] = [
        Self::Stable,
        Self::Flutter,
        Self::NegativeDamping,
        Self::Both,
        Self::NormalForceCoupling,
        Self::Marginal,
        Self::Unresolved,
    ];

    /// The class of a system with unit mass matrix.
    ///
    /// Flutter: unstable with C = 0. Negative damping: c11 < 0 or c22 < 0 (for the oscillator c22 = 2ξ_yΩ ≥ 0, so this is
    /// ξ_eq < 0).
    #[inline(always)]
    #[must_use]
    pub fn of(system: &ReducedSystem) -> Self {
        Self::from_code(Self::code(system) as u8)
    }

    /// [`StabilityClass::of`] as a number, in arithmetic that has a vector form.
    #[inline(always)]
    pub(crate) fn code(system: &ReducedSystem) -> f64 {
        let characteristic = Characteristic::new(system);
        let flutters = (discriminant(&system.stiffness) < 0.0)
            | (characteristic.p0 < 0.0)
            | (system.stiffness[0][0] + system.stiffness[1][1] < 0.0);
        let falls = (system.damping[0][0] < 0.0) | (system.damping[1][1] < 0.0);
        let mechanism = if flutters { 1.0 } else { 0.0 } + if falls { 2.0 } else { 0.0 };
        let unstable = if mechanism == 0.0 { 4.0 } else { mechanism };
        let sign = characteristic.stability_sign();
        let not_stable = if sign < 0.0 { unstable } else { 5.0 };
        if sign > 0.0 { 0.0 } else { not_stable }
    }

    /// The class of a code; anything that is no code is [`StabilityClass::Unresolved`].
    #[inline(always)]
    #[must_use]
    pub fn from_code(code: u8) -> Self {
        Self::ALL[usize::from(code.min(6))]
    }

    /// Whether the point is unstable.
    #[must_use]
    pub fn is_unstable(self) -> bool {
        matches!(self, Self::Flutter | Self::NegativeDamping | Self::Both | Self::NormalForceCoupling)
    }

    /// The verdict in it; `None` where unresolved.
    #[must_use]
    pub fn verdict(self) -> Option<Verdict> {
        match self {
            Self::Stable => Some(Verdict::Stable),
            Self::Marginal => Some(Verdict::Marginal),
            Self::Unresolved => None,
            _ => Some(Verdict::Unstable),
        }
    }

    /// The mechanism in it.
    #[must_use]
    pub fn mechanism(self) -> Mechanism {
        match self {
            Self::Flutter => Mechanism::Flutter,
            Self::NegativeDamping => Mechanism::NegativeDamping,
            Self::Both => Mechanism::Both,
            Self::NormalForceCoupling => Mechanism::NormalForceCoupling,
            Self::Stable | Self::Marginal | Self::Unresolved => Mechanism::None,
        }
    }

    /// The name that files and reports use.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Stable => "stable",
            Self::Marginal => "marginal",
            Self::Unresolved => "unresolved",
            _ => self.mechanism().name(),
        }
    }
}
