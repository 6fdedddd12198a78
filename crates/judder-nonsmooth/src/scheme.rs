//! How a step treats the contact.

use crate::contact::ContactPoints;
use crate::contact_problem::{Delassus, NormalCondition};

/// A scheme of time integration with contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ContactScheme {
    /// Implicit, on velocities, with impacts: J. J. Moreau, *Unilateral contact and dry friction in finite freedom dynamics* (1988); M. Jean
    /// (1999), with θ = ½.
    MoreauJean {
        /// e: a point that meets the track with U_N leaves it with −e U_N.
        restitution: f64,
    },
    /// Explicit, on places: forward increment Lagrange multipliers, N. J. Carpenter, R. L. Taylor, M. G. Katona, Int. J. Numer. Methods Eng. 32
    /// (1991). The forces of a step close the gaps at its end.
    ForwardIncrement,
    /// The same where sliding is known to go on: points may lift off, but none sticks or turns, and friction is μ N along the slip of steady sliding. The enriched
    /// substructuring of the beams paper (section 3), for any number of points.
    KnownSliding,
    /// Explicit, with springs and dampers in place of the unilateral condition and friction that turns smoothly: no contact problem is solved.
    Smoothed,
}

/// Freedom of the step that an explicit contact may take.
const SHARE: f64 = 0.25;

impl ContactScheme {
    /// θ.
    #[must_use]
    pub fn implicitness(self) -> f64 {
        match self {
            Self::MoreauJean { .. } => 0.5,
            Self::ForwardIncrement | Self::KnownSliding | Self::Smoothed => 0.0,
        }
    }

    /// How far z goes in a step, as shares of the velocities before and after.
    pub(crate) fn shares(self) -> [f64; 2] {
        match self {
            Self::MoreauJean { .. } => [0.5, 0.5],
            Self::ForwardIncrement | Self::KnownSliding | Self::Smoothed => [0.0, 1.0],
        }
    }
}

/// A point when a step begins.
#[derive(Debug, Clone, Copy)]
pub(crate) struct PointBefore {
    /// g in m.
    pub(crate) gap: f64,
    /// ġ in m/s.
    pub(crate) opening: f64,
    /// A distance below which a point touches, in m.
    pub(crate) rounding: f64,
}

/// What the implicit scheme asks of a rigid point.
pub(crate) fn at_velocities(
    before: PointBefore,
    step: f64,
    restitution: f64,
    stays_closed: bool,
) -> NormalCondition {
    if stays_closed {
        return NormalCondition::Bilateral { velocity: 0.0, softness: 0.0 };
    }
    let touches = before.gap + 0.5 * step * before.opening.min(0.0) <= before.rounding;
    if touches {
        NormalCondition::Unilateral { velocity: restitution * before.opening.min(0.0), softness: 0.0 }
    } else {
        NormalCondition::Open
    }
}

/// What the explicit scheme asks of a rigid point, whose "velocity" is its gap at the end of the step over the step.
pub(crate) fn at_places(stays_closed: bool) -> NormalCondition {
    match stays_closed {
        true => NormalCondition::Bilateral { velocity: 0.0, softness: 0.0 },
        false => NormalCondition::Unilateral { velocity: 0.0, softness: 0.0 },
    }
}

/// The closure of a compliant point amid an implicit step that ends with the velocity `after`, g_mid = g + h θ (θ U⁺ + (1 − θ) U) with θ = ½.
pub(crate) fn middle_closure(before: PointBefore, after: f64, step: f64) -> f64 {
    -(before.gap + 0.25 * step * (after + before.opening))
}

/// What the implicit scheme asks of a point whose force follows from its closure amid the step, about the closure `at`: with N ≈ N₀ + N′ (d − d₀) the
/// point is a rigid one whose impulse softens it.
pub(crate) fn about_closure(
    contact: &ContactPoints<'_>,
    point: usize,
    before: PointBefore,
    at: f64,
    speed: f64,
    step: f64,
) -> NormalCondition {
    let stays_closed = contact.points[point].stays_closed;
    let closure = if stays_closed { at } else { at.max(0.0) };
    let forces = contact.forces(point, closure, speed).normal;
    let slope = if closure > 0.0 { forces.by_closure } else { contact.first_stiffness(point) };
    if slope <= 0.0 || slope.is_nan() {
        return NormalCondition::Given { impulse: step * forces.value };
    }
    // the velocity that ends at this closure
    let there = -4.0 * (closure + before.gap) / step - before.opening;
    let softness = 4.0 / (step * step * slope);
    let velocity = -there - softness * step * forces.value;
    match stays_closed {
        true => NormalCondition::Bilateral { velocity, softness },
        false => NormalCondition::Unilateral { velocity, softness },
    }
}

/// A contact of springs and dampers that a step of this length still follows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct SmoothContact {
    /// N/m.
    pub(crate) stiffness: f64,
    /// N s/m.
    pub(crate) damping: f64,
    /// The slip speed over which friction turns, per unit of its impulse, in 1/kg.
    pub(crate) turning: f64,
}

impl SmoothContact {
    pub(crate) fn new(delassus: &Delassus, step: f64) -> Self {
        let row_sum =
            |row: usize| -> f64 { (0..delassus.size()).map(|k| delassus.column(k)[row].abs()).sum() };
        let largest = (0..delassus.size()).map(row_sum).fold(f64::MIN_POSITIVE, f64::max);
        Self {
            stiffness: SHARE / (step * step * largest),
            damping: SHARE / (step * largest),
            turning: largest / SHARE,
        }
    }

    /// P_N in a step.
    pub(crate) fn normal(&self, before: PointBefore, step: f64) -> f64 {
        if before.gap >= 0.0 {
            return 0.0;
        }
        step * (-self.stiffness * before.gap - self.damping * before.opening).max(0.0)
    }
}
