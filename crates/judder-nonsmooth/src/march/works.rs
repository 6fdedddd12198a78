//! What a march keeps account of.

use serde::{Deserialize, Serialize};

/// Where work went since the start, in J: what it added to the bodies.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Works {
    /// Of friction on the bodies, Σ T·(velocity of the slider beside the track's undisturbed motion).
    pub friction: f64,
    /// What became heat between the bodies, Σ −T·(slip velocity).
    pub heat: f64,
    /// Of normal forces: what impacts took, and what compliant contacts hold,
    pub normal: f64,
    /// with what the track's slope lifts of them, Σ N·(velocity of the track along the normal), where points travel.
    pub slope: f64,
    /// Of the damping.
    pub damping: f64,
    /// Of stiffness that brings circulation.
    pub circulation: f64,
    /// Of forces beyond the load of the assembly: of excitations, and of what a course adds to the load or takes of it.
    pub excitation: f64,
    /// Of modes that only yield.
    pub flexibility: f64,
    /// Of the scheme itself, which with θ above ½ takes energy: −(θ − ½) (Δvᵀ M Δv + Δzᵀ K Δz) of each step.
    pub scheme: f64,
}

impl Works {
    /// What the energy of the bodies changes by, part by part.
    #[must_use]
    pub fn parts(&self) -> [f64; 7] {
        let Self { friction, normal, damping, circulation, excitation, flexibility, scheme, .. } = *self;
        [friction, normal, damping, circulation, excitation, flexibility, scheme]
    }
}

/// How well the contact was solved, over all steps.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct ContactRecord {
    /// Sweeps, all together.
    pub iterations: u64,
    /// The largest residual of a step.
    pub residual: f64,
    /// Steps beyond the tolerance.
    pub unsolved: u64,
    /// The first of them, its time in s, its point.
    pub first_unsolved: Option<(f64, usize)>,
    /// Of sliding that is known: steps in which a pressed point does not slide as is known,
    pub against: u64,
    /// the first of them, its time in s, its point.
    pub first_against: Option<(f64, usize)>,
}
