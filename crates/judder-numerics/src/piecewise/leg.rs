//! What a motion is made of: legs within a mode, crossings between them, and the plane on which it is looked at.

use super::quartic::{self, Quartic};
use super::rate;
use std::array::from_fn;

/// Which method made a step.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StepMethod {
    /// Dormand and Prince's, explicit.
    Explicit,
    /// Radau's, implicit, for stiff legs.
    Implicit,
}

/// One accepted step within one mode.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Leg<M, const N: usize> {
    /// The mode.
    pub mode: M,
    /// The method of the step.
    pub method: StepMethod,
    /// Time at its start.
    pub time: f64,
    /// Its length.
    pub step: f64,
    /// Whether it begins or ends where the mode changes.
    pub is_at_edge: bool,
    /// The state at its end.
    pub end: [f64; N],
    /// The state along it, over the fraction of the step.
    pub dense: [Quartic; N],
}

impl<M, const N: usize> Leg<M, N> {
    /// The state at its start.
    #[must_use]
    pub fn start(&self) -> [f64; N] {
        from_fn(|i| self.dense[i][0])
    }

    /// The state at a fraction of the step.
    #[must_use]
    pub fn at(&self, fraction: f64) -> [f64; N] {
        from_fn(|i| quartic::value(&self.dense[i], fraction))
    }
}

/// A change of mode.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GuardCrossing<M, const N: usize> {
    /// When.
    pub time: f64,
    /// The mode that ends.
    pub from: M,
    /// The mode that begins.
    pub to: M,
    /// The guard of the ending mode that was crossed.
    pub guard: usize,
    /// The state on it.
    pub state: [f64; N],
}

/// A plane of the state space, n·u = offset, that a motion crosses from its positive to its negative side.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SectionPlane<const N: usize> {
    /// n.
    pub normal: [f64; N],
    /// The offset.
    pub offset: f64,
}

impl<const N: usize> SectionPlane<N> {
    /// n·u − offset.
    #[must_use]
    pub fn value(&self, state: &[f64; N]) -> f64 {
        rate(&self.normal, state) - self.offset
    }

    /// The state moved along the normal onto the plane; exactly for a plane on which one component is zero.
    #[must_use]
    pub fn project(&self, state: &[f64; N]) -> [f64; N] {
        let by = self.value(state) / rate(&self.normal, &self.normal);
        from_fn(|i| if self.normal[i] == 0.0 { state[i] } else { state[i] - by * self.normal[i] })
    }

    pub(super) fn along(&self, dense: &[Quartic; N]) -> Quartic {
        from_fn(|k| {
            let sum = (0..N).fold(0.0, |sum, i| sum + self.normal[i] * dense[i][k]);
            if k == 0 { sum - self.offset } else { sum }
        })
    }
}

/// What one advance brought.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Advance<M, const N: usize> {
    /// The step; `None` where the mode changed at once, without any time.
    pub leg: Option<Leg<M, N>>,
    /// The change of mode at its end.
    pub crossing: Option<GuardCrossing<M, N>>,
    /// Whether the step ends on the section.
    pub on_section: bool,
}
