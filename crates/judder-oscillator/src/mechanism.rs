//! The mechanism of an instability.
//!
//! The mechanism of an unstable system is the smallest part of it that is unstable by itself. Each label is a statement on what is left
//! when the rest is removed, and the first that holds is told:
//!
//! | mechanism | what is removed | what is left |
//! | --- | --- | --- |
//! | [`Mechanism::Flutter`] | all damping, C = 0 | unstable |
//! | [`Mechanism::NegativeDamping`] | all coupling, the entries beside the diagonals of C and K | a direction whose motion grows: c11 < 0 or c22 < 0 |
//! | [`Mechanism::Both`] | the one; the other | both times unstable |
//! | [`Mechanism::DestabilisedByDamping`] | the one-way coupling by speed ([`mutual`]; of the oscillator c21) | unstable |
//! | [`Mechanism::NormalForceCoupling`] | the same | not unstable |
//!
//! So the last two are not unstable without damping, and no direction feeds itself. Destabilisation by damping has unequal dampers as its cause:
//! with one damping in both directions, C = c I, every root of λ² + c λ + κ is as stable as the undamped one. Without cross terms
//!
//! H3 = c11 c22 [(k11 − k22)² + p1 p3] + p3² k12 k21,
//!
//! so it asks for K entries of opposite signs beside the diagonal, and for a c11 c22/p3² well below the 1/4 of equal dampers.

use crate::characteristic::Characteristic;
use crate::conservative::{discriminant, discriminant_share};
use crate::error::OscillatorError;
use crate::linear_system::{LinearSystem, ReducedSystem};
use judder_numerics::verdict::Verdict;

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
    /// Neither, and stable without c21: a normal force that depends on speed, through c21 (k12 + k12c) in p1. In a general system any
    /// one-way coupling by speed.
    NormalForceCoupling,
    /// Neither, and unstable without c21 too: dampers that are unequal (Ziegler).
    DestabilisedByDamping,
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
            Self::DestabilisedByDamping => "destabilised-by-damping",
        }
    }
}

/// C without its one-way coupling: of c12 and c21 the part stays that both share, the smaller one where they have one sign, else nothing.
///
/// Of the oscillator, where c12 = 0, it removes c21; a damper between the two directions stays.
#[inline(always)]
#[must_use]
pub fn mutual(damping: &[[f64; 2]; 2]) -> [[f64; 2]; 2] {
    let [[c11, c12], [c21, c22]] = *damping;
    let smaller = if c12.abs() < c21.abs() { c12 } else { c21 };
    let shared = if c12 * c21 > 0.0 { smaller } else { 0.0 };
    [[c11, shared], [shared, c22]]
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
    /// Unstable by a normal force that depends on speed.
    NormalForceCoupling = 4,
    /// Marginal.
    Marginal = 5,
    /// No answer here.
    Unresolved = 6,
    /// Unstable by unequal damping.
    DestabilisedByDamping = 7,
}

impl StabilityClass {
    /// All classes, in the order of their codes.
    pub const ALL: [Self; 8] = [
        Self::Stable,
        Self::Flutter,
        Self::NegativeDamping,
        Self::Both,
        Self::NormalForceCoupling,
        Self::Marginal,
        Self::Unresolved,
        Self::DestabilisedByDamping,
    ];

    /// The class of a system with unit mass matrix, by what is left when the rest is removed: see the [module](self). For the oscillator
    /// c22 = 2ξ_yΩ ≥ 0, so that negative damping is ξ_eq < 0.
    #[inline(always)]
    #[must_use]
    pub fn of(system: &ReducedSystem) -> Self {
        Self::from_code(Self::code(system) as u8)
    }

    /// The class of any system: its dampers are those of C itself, whatever M mixes into M⁻¹C.
    ///
    /// # Errors
    /// As [`LinearSystem::reduced`].
    pub fn of_system(system: &LinearSystem) -> Result<Self, OscillatorError> {
        let without = LinearSystem { damping: mutual(&system.damping), ..*system }.reduced()?;
        Ok(Self::from_code(Self::decide(&system.reduced()?, &without, &system.damping) as u8))
    }

    /// [`StabilityClass::of`] as a number, in arithmetic that has a vector form.
    #[inline(always)]
    pub(crate) fn code(system: &ReducedSystem) -> f64 {
        let without = ReducedSystem { damping: mutual(&system.damping), stiffness: system.stiffness };
        Self::decide(system, &without, &system.damping)
    }

    /// How far a system is from every change of its class but that of a damper's sign: the smallest of the conditions, each over the
    /// magnitudes of its terms.
    #[must_use]
    pub fn clearance(system: &ReducedSystem) -> f64 {
        let without = ReducedSystem { damping: mutual(&system.damping), stiffness: system.stiffness };
        let margins = [system, &without].map(|system| Characteristic::new(system).margin().abs());
        margins.into_iter().fold(discriminant_share(&system.stiffness).abs(), f64::min)
    }

    /// The code of a system, given the same without one-way coupling, and the C that has its dampers.
    #[inline(always)]
    fn decide(system: &ReducedSystem, without: &ReducedSystem, dampers: &[[f64; 2]; 2]) -> f64 {
        let characteristic = Characteristic::new(system);
        let flutters = (discriminant(&system.stiffness) < 0.0)
            | (characteristic.p0 < 0.0)
            | (system.stiffness[0][0] + system.stiffness[1][1] < 0.0);
        let falls = (dampers[0][0] < 0.0) | (dampers[1][1] < 0.0);
        let mechanism = if flutters { 1.0 } else { 0.0 } + if falls { 2.0 } else { 0.0 };
        let neither = if Characteristic::new(without).is_destabilised() { 7.0 } else { 4.0 };
        let unstable = if mechanism == 0.0 { neither } else { mechanism };
        let sign = characteristic.stability_sign();
        let not_stable = if sign < 0.0 { unstable } else { 5.0 };
        if sign > 0.0 { 0.0 } else { not_stable }
    }

    /// The class of a code; anything that is no code is [`StabilityClass::Unresolved`].
    #[inline(always)]
    #[must_use]
    pub fn from_code(code: u8) -> Self {
        Self::ALL.get(usize::from(code)).copied().unwrap_or(Self::Unresolved)
    }

    /// Whether the point is unstable.
    #[must_use]
    pub fn is_unstable(self) -> bool {
        matches!(self.verdict(), Some(Verdict::Unstable))
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
            Self::DestabilisedByDamping => Mechanism::DestabilisedByDamping,
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

#[cfg(test)]
mod tests {
    use super::*;

    const NEARLY_MERGED: [[f64; 2]; 2] = [[1.5, -0.3], [0.5, 2.5]];

    fn class(damping: [[f64; 2]; 2], stiffness: [[f64; 2]; 2]) -> StabilityClass {
        StabilityClass::of(&ReducedSystem { damping, stiffness })
    }

    /// c11 c22 [(k11 − k22)² + p1 p3] + p3² k12 k21 < 0, and only for unequal dampers.
    #[test]
    fn unequal_dampers_destabilise_where_the_closed_form_says() {
        let ([[k11, k12], [k21, k22]], c22) = (NEARLY_MERGED, 1e-3);
        for c11 in [1e-4, 1e-3, 1e-2, 1e-1] {
            let (p1, p3) = (c11 * k22 + c22 * k11, c11 + c22);
            let h3 = c11 * c22 * ((k11 - k22) * (k11 - k22) + p1 * p3) + p3 * p3 * k12 * k21;
            let expected =
                if h3 < 0.0 { StabilityClass::DestabilisedByDamping } else { StabilityClass::Stable };
            assert_eq!(class([[c11, 0.0], [0.0, c22]], NEARLY_MERGED), expected, "c11 = {c11}");
        }
        assert_eq!(class([[1e-3, 0.0], [0.0, 1e-3]], NEARLY_MERGED), StabilityClass::Stable);
    }

    /// Each of two causes is enough: the one that needs less is told. Both are needed: what is gone without c21 is told by it.
    #[test]
    fn of_two_causes_the_one_that_stands_without_the_other_is_told() {
        let by_normal_force = [[1e-3, 0.0], [-1.0, 1e-3]];
        assert_eq!(class(by_normal_force, NEARLY_MERGED), StabilityClass::NormalForceCoupling);
        assert_eq!(class([[1e-1, 0.0], [-1.0, 1e-3]], NEARLY_MERGED), StabilityClass::DestabilisedByDamping);
    }

    /// A damper between the directions is no one-way coupling, and M mixes no damper into another.
    #[test]
    fn dampers_are_those_of_the_system_itself() {
        assert_eq!(mutual(&[[1.0, -0.2], [-0.5, 1.0]]), [[1.0, -0.2], [-0.2, 1.0]]);
        assert_eq!(mutual(&[[1.0, 0.2], [-0.2, 1.0]]), [[1.0, 0.0], [0.0, 1.0]]);
        // C is positive definite, and the second entry on the diagonal of M⁻¹C is negative
        let mass = [[1.0, 0.9], [0.9, 1.0]];
        let system = |stiffness| LinearSystem { mass, damping: [[1e-2, 5e-3], [5e-3, 2.6e-3]], stiffness };
        let flutter = system([[1.0, 2.5], [-2.5, 1.0]]);
        assert!(flutter.reduced().unwrap().damping[1][1] < 0.0);
        assert_eq!(StabilityClass::of_system(&flutter), Ok(StabilityClass::Flutter));
    }
}
