//! What is checked of branches of cycles along a key.

use super::cycles_along_key::SOLVED;
use super::meant_mode::near_frequency;
use super::swept::SweptAssembly;
use crate::key_sweep::KeySweep;
use judder_cycles::branch::{AssemblyCycleBranch, CycleAtKey, CycleBranchEnd};
use judder_numerics::complex::ElementaryComplex;
use judder_study::outcome::CheckRecord;

/// What the eigenvalue may grow, of its modulus, where a branch shrinks to steady sliding.
const NEUTRAL: f64 = 1e-4;

/// Where a branch shrinks to steady sliding, and what the eigenvalue there says of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct ShrunkAt {
    /// The value of the key.
    pub(super) value: f64,
    /// How far that eigenvalue is from turning as the last cycle does without growing, of its modulus; infinite where there is none.
    pub(super) off: f64,
}

impl ShrunkAt {
    /// Of the last cycle of a branch, where that shrinks.
    pub(super) fn of(family: &SweptAssembly<'_>, branch: &AssemblyCycleBranch) -> Option<Self> {
        let last = branch.cycles.last().filter(|_| branch.end == CycleBranchEnd::SteadySliding)?;
        Some(Self { value: last.parameter, off: off_neutral(family, last) })
    }

    /// Whether an eigenvalue begins to grow there.
    pub(super) fn is_hopf(self) -> bool {
        self.off <= NEUTRAL
    }
}

fn off_neutral(family: &SweptAssembly<'_>, cycle: &CycleAtKey) -> f64 {
    let omega = cycle.motion.turning.frequency;
    let mode = family
        .state(&[cycle.parameter])
        .and_then(|state| family.about(&state))
        .and_then(|about| near_frequency(&about, omega));
    mode.map_or(f64::INFINITY, |mode| {
        let value = mode.eigenvalue.value;
        value.re.abs().max((value.im - omega).abs()) / value.modulus()
    })
}

/// The equations of each cycle, by their residuals.
pub(super) fn equations(residuals: impl Iterator<Item = f64>) -> CheckRecord {
    let worse = |(count, most): (usize, f64), own: f64| {
        (count + 1, if own.is_nan() { f64::INFINITY } else { most.max(own) })
    };
    let (count, largest) = residuals.fold((0, 0.0), worse);
    CheckRecord::new(
        "harmonics of the contact forces are those that the contact laws make of the motions",
        format!("largest residual over the largest normal force, {count} cycles"),
        largest.into(),
        SOLVED,
    )
}

/// The eigenvalue where a branch shrinks to steady sliding.
pub(super) fn shrinks(sweep: &KeySweep, at: ShrunkAt) -> CheckRecord {
    CheckRecord::new(
        "the branch shrinks to steady sliding where an eigenvalue begins to grow",
        format!(
            "eigenvalue at {} = {} against i times the frequency of the last cycle, over its modulus",
            sweep.path,
            sweep.text(at.value),
        ),
        at.off.into(),
        NEUTRAL,
    )
}
