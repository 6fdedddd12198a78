//! Eq. (3) of the oscillator paper, the law's own condition: forces of steady sliding hold in motion where motion is slow against the memory
//! of the contact.
//!
//! A term of the substrate with time τ_k obeys u + τ_k (∂_t − v ∂_x) u = C_k W\[p\]. A law of steady sliding leaves ∂_t out. To a motion
//! e^{iωt} and a pressure as long as the contact, ∂_x ~ 1/a, the term answers by C_k/(1 + i τ_k (v/a + ω)), and to first order in ω all of
//! them together are behind by the time
//!
//! T = |Σ C_k τ_k/(1 + i z_k)²|/|Σ C_k/(1 + i z_k)|,    z_k = v τ_k/a.
//!
//! A slow contact has T = Σ C_k τ_k/Σ C_k, the mean retardation time τ of the groups, so that ω T ≪ 1 is eq. (3) for a small motion; a fast
//! one T = a/v, the time in which it has left its own length. So terms count that creep while the contact passes.

use judder_contact::law::material::LawTerm;
use judder_numerics::complex::ElementaryComplex;
use num_complex::Complex64;
use std::f64::consts::TAU;

/// Eq. (3) where x oscillates with a period and an amplitude: (ω − v_d/A_x) τ, to be small against 1; in the units of the oscillator.
#[must_use]
pub fn in_motion(period: f64, amplitude: f64, belt_velocity: f64, retardation_time: f64) -> f64 {
    (TAU / period - belt_velocity / amplitude) * retardation_time
}

/// How far a condition ≪ 1 holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Standing {
    /// At most 0.1.
    Holds,
    /// Up to 1. At 0.4, the paper's value, the contact is behind by a quarter to a third of a radian.
    Borderline,
    /// Above 1.
    Broken,
}

impl Standing {
    /// That of a figure.
    #[must_use]
    pub fn of(figure: f64) -> Self {
        match figure.abs() {
            figure if figure <= 0.1 => Self::Holds,
            figure if figure <= 1.0 => Self::Borderline,
            _ => Self::Broken,
        }
    }

    /// `"holds"`, `"borderline"` or `"broken"`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Holds => "holds",
            Self::Borderline => "borderline",
            Self::Broken => "broken",
        }
    }
}

/// Eq. (3) for small motions about steady sliding, ω = ω_nx: what is to be small against 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct QuasiSteady {
    /// ω_nx τ with the mean retardation time, the τ̃ of the groups.
    pub figure: f64,
    /// ω_nx τ_k with the longest time that has a hundredth of the compliance.
    pub longest: f64,
    /// ω_nx T with the time T by which the contact is behind.
    pub memory: f64,
}

impl QuasiSteady {
    /// Eq. (3) at τ̃ = ω_nx τ and v̂ = v τ/R, in a contact of half length a/R, on a substrate of these terms; `None` for one without.
    #[must_use]
    pub fn new(retardation_time: f64, velocity: f64, half_length: f64, terms: &[LawTerm]) -> Option<Self> {
        /// Of the compliance: a term with less is no part of what creeps.
        const SHARE: f64 = 0.01;
        let whole: f64 = terms.iter().map(|term| term.compliance).sum();
        let counted = terms.iter().filter(|term| term.compliance >= SHARE * whole);
        let longest = counted.map(|term| term.retardation_time).reduce(f64::max)?;
        Some(Self {
            figure: retardation_time,
            longest: retardation_time * longest,
            memory: retardation_time * memory_time(excited(velocity, half_length), terms),
        })
    }
}

/// ω τ at which sliding excites its substrate: v τ/a, for v τ/R and half the length of the contact, a/R.
#[must_use]
pub fn excited(velocity: f64, half_length: f64) -> f64 {
    velocity / half_length
}

/// T/τ at v τ/a.
fn memory_time(passing: f64, terms: &[LawTerm]) -> f64 {
    let answer = |term: &LawTerm| Complex64::new(1.0, passing * term.retardation_time).inv();
    let behind: Complex64 =
        terms.iter().map(|term| term.compliance * term.retardation_time * answer(term) * answer(term)).sum();
    let all: Complex64 = terms.iter().map(|term| term.compliance * answer(term)).sum();
    behind.modulus() / all.modulus()
}

#[cfg(test)]
mod tests {
    use super::*;

    const fn term(retardation_time: f64, compliance: f64) -> LawTerm {
        LawTerm { retardation_time, compliance }
    }

    /// Mean time 1: 0.6 · 0.5 + 0.3 · 2 over 0.9.
    const TWO: [LawTerm; 2] = [term(0.5, 0.6), term(2.0, 0.3)];

    #[test]
    fn a_slow_contact_remembers_the_mean_time_and_a_fast_one_its_passing() {
        assert!((memory_time(1e-9, &TWO) - 1.0).abs() < 1e-15);
        assert!((memory_time(1e9, &TWO) * 1e9 - 1.0).abs() < 1e-8);
        // one time: τ/√(1 + z²)
        assert!((memory_time(3.0, &[term(1.0, 0.9)]) - 0.1_f64.sqrt()).abs() < 1e-15);
    }

    #[test]
    fn the_memory_is_the_first_order_of_the_answer_in_the_frequency() {
        let answer = |rate: f64| -> Complex64 {
            TWO.iter().map(|t| t.compliance / Complex64::new(1.0, rate * t.retardation_time)).sum()
        };
        for passing in [0.01, 0.7, 40.0] {
            let step = 1e-6 * passing;
            let change = (answer(passing + step) - answer(passing - step)).norm() / (2.0 * step);
            let expected = change / answer(passing).norm();
            assert!((memory_time(passing, &TWO) / expected - 1.0).abs() < 1e-8);
        }
    }

    #[test]
    fn terms_that_stand_for_one_are_one() {
        let at = |terms: &[LawTerm]| QuasiSteady::new(0.4, 0.02, 1e-2, terms).unwrap();
        let (one, two) = (at(&[term(1.0, 0.9)]), at(&[term(1.0, 0.45), term(1.0, 0.45)]));
        assert!((one.memory - two.memory).abs() < 1e-15 && one.figure == 0.4 && one.longest == 0.4);
        // a term of a thousandth is not the one that decides
        assert_eq!(at(&[term(1.0, 0.9), term(1e3, 9e-4)]).longest, 0.4);
        assert_eq!(QuasiSteady::new(0.4, 0.02, 1e-2, &[]), None);
    }

    #[test]
    fn the_papers_value_is_borderline() {
        let standings = [0.1, 0.4, -1.0, 164.0, f64::NAN].map(Standing::of);
        use Standing::{Borderline, Broken, Holds};
        assert_eq!(standings, [Holds, Borderline, Borderline, Broken, Broken]);
    }
}
