//! The functions that vanish where modes begin or cease to grow.

use super::StabilityAt;
use crate::complex_modes::{Eigenvalue, Region, Verdict};
use judder_numerics::complex::ElementaryComplex;
use judder_numerics::order::sort_by_number;
use std::f64::consts::TAU;

/// A function of the eigenvalues that vanishes at an onset.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Crossing {
    pub(super) vanishing: Vanishing,
    /// Of the mode, in Hz.
    pub(super) frequency: f64,
    /// By which the function changes with the parameter.
    pub(super) slope: f64,
    /// The region whose eigenvalues it is of.
    pub within: Region,
}

impl Crossing {
    /// By how much the onset of a problem that differs little lies higher, by a step of Newton's method; `stability` is what is known of
    /// that problem in the crossing's region, at the value of the onset.
    #[must_use]
    pub fn shift(&self, stability: &StabilityAt) -> f64 {
        -self.vanishing.value(stability, self.frequency) / self.slope
    }
}

/// What vanishes at an onset.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Vanishing {
    /// Among damped modes the growth rate that so many reach: as many as grow beyond the onset.
    Growth(usize),
    /// (λ₁ − λ₂)² of two undamped modes, whose eigenvalues meet: below zero before they do.
    Difference,
    /// λ² of an undamped mode whose eigenvalue comes to zero.
    Square,
}

impl Vanishing {
    /// By what is known beside the onset, where the mode does not grow, and by how many modes grow where it does.
    pub(super) fn of(stable: &StabilityAt, growing: usize, frequency: f64) -> Self {
        let is_marginal = |own: &&Eigenvalue| own.verdict() == Verdict::Marginal;
        let is_undamped = nearest(stable, frequency, 1).first().is_some_and(is_marginal);
        // an undamped mode that locks in has another to do it with; one of its kind alone is damped, and near its onset
        let has_another = stable.eigenvalues.iter().filter(is_marginal).count() > 1;
        match (is_undamped, frequency > 0.0) {
            (true, true) if has_another => Self::Difference,
            (true, false) => Self::Square,
            _ => Self::Growth(growing),
        }
    }

    /// Its value; NaN where the modes are not there.
    pub(super) fn value(self, stability: &StabilityAt, frequency: f64) -> f64 {
        match (self, &nearest(stability, frequency, 2)[..]) {
            (Self::Growth(growing), _) => ranked(stability, growing).map_or(f64::NAN, |own| own.value.re),
            (Self::Difference, [one, other]) => {
                let apart = one.value - other.value;
                (apart * apart).re
            }
            (Self::Square, [one, ..]) => (one.value * one.value).re,
            _ => f64::NAN,
        }
    }

    /// The frequency in Hz of the mode that it is of; the one that is given where there is none.
    pub(super) fn frequency(self, stability: &StabilityAt, frequency: f64) -> f64 {
        let own = match self {
            Self::Growth(growing) => ranked(stability, growing),
            Self::Difference | Self::Square => nearest(stability, frequency, 1).first().copied(),
        };
        own.map_or(frequency, Eigenvalue::frequency_hz)
    }

    /// How far it may be off at its root, by its errors beside and there: where eigenvalues meet they are ill-conditioned, their difference is not.
    pub(super) fn unknown(self, beside: f64, here: f64) -> f64 {
        match self {
            Self::Growth(_) => here,
            Self::Difference | Self::Square => beside.min(here),
        }
    }

    /// How far it may be off, by the errors of the eigenvalues.
    pub(super) fn error(self, stability: &StabilityAt, frequency: f64) -> f64 {
        match (self, &nearest(stability, frequency, 2)[..]) {
            (Self::Growth(growing), _) => ranked(stability, growing).map_or(f64::NAN, |own| own.error),
            (Self::Difference, [one, other]) => {
                let (apart, error) = ((one.value - other.value).modulus(), one.error + other.error);
                (2.0 * apart + error) * error
            }
            (Self::Square, [one, ..]) => (2.0 * one.value.modulus() + one.error) * one.error,
            _ => f64::NAN,
        }
    }
}

/// The eigenvalue of the so many-th largest growth rate.
fn ranked(stability: &StabilityAt, rank: usize) -> Option<&Eigenvalue> {
    let mut all: Vec<&Eigenvalue> = stability.eigenvalues.iter().collect();
    sort_by_number(&mut all, |own| -own.value.re);
    all.get(rank.checked_sub(1)?).copied()
}

/// The eigenvalues whose frequencies are nearest to one in Hz.
pub(super) fn nearest(stability: &StabilityAt, frequency: f64, count: usize) -> Vec<&Eigenvalue> {
    let mut all: Vec<&Eigenvalue> = stability.eigenvalues.iter().collect();
    let distance = |own: &Eigenvalue| (own.value.im / TAU - frequency).abs();
    sort_by_number(&mut all, |own| distance(own));
    all.truncate(count);
    all
}
