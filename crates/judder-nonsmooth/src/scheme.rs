//! How a step treats the contact.

use crate::NonsmoothError;
use crate::contact::ContactPoints;
use crate::contact_problem::{Delassus, NormalCondition};

/// A scheme of time integration with contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ContactScheme {
    /// Implicit, on velocities, with impacts: J. J. Moreau, *Unilateral contact and dry friction in finite freedom dynamics* (1988); M. Jean
    /// (1999), with z⁺ = z + h (θ v⁺ + (1 − θ) v). Of second order with θ = ½, of first above it; contact gives bodies no energy with θ = 1, and with less what it
    /// holds of a point that rises within a step, P (1 − θ) U: V. Acary, Z. Angew. Math. Mech. 96 (2016).
    MoreauJean {
        /// e: a point that meets the track with U_N leaves it with −e U_N.
        restitution: f64,
        /// θ, from ½ to 1/(1 + e), up to which impacts give no energy.
        implicitness: f64,
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
            Self::MoreauJean { implicitness, .. } => implicitness,
            Self::ForwardIncrement | Self::KnownSliding | Self::Smoothed => 0.0,
        }
    }

    /// Whether its numbers are those of a scheme.
    pub(crate) fn check(self) -> Result<(), NonsmoothError> {
        let Self::MoreauJean { restitution, implicitness } = self else { return Ok(()) };
        let refuse =
            |name, value, requirement| Err(NonsmoothError::InvalidNumber { name, value, requirement });
        if !(0.0..=1.0).contains(&restitution) {
            return refuse("the restitution", restitution, "from 0 to 1");
        }
        let is_stable = implicitness >= 0.5 && implicitness * (1.0 + restitution) <= 1.0;
        match is_stable {
            true => Ok(()),
            false => refuse("the implicitness", implicitness, "from 1/2 to 1/(1 + the restitution)"),
        }
    }

    /// When in a step forces are taken, and velocities at its end, as shares of it.
    pub(crate) fn instants(self) -> [f64; 2] {
        match self {
            Self::MoreauJean { implicitness, .. } => [implicitness, 1.0],
            Self::ForwardIncrement | Self::KnownSliding | Self::Smoothed => [0.0, 0.5],
        }
    }

    /// The velocity that does work in a step, as shares of those before and after.
    pub(crate) fn working(self) -> [f64; 2] {
        match self {
            Self::MoreauJean { .. } => self.shares(),
            Self::ForwardIncrement | Self::KnownSliding | Self::Smoothed => [0.5, 0.5],
        }
    }

    /// How far z goes in a step, as shares of the velocities before and after.
    pub(crate) fn shares(self) -> [f64; 2] {
        match self {
            Self::MoreauJean { implicitness, .. } => [1.0 - implicitness, implicitness],
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

/// An implicit step.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ImplicitStep {
    /// h in s.
    pub(crate) length: f64,
    /// 1 − θ and θ.
    pub(crate) shares: [f64; 2],
}

impl ImplicitStep {
    /// What is asked of a rigid point: one that would touch the track at the end of the step if it were held is held.
    pub(crate) fn at_velocities(
        self,
        before: PointBefore,
        restitution: f64,
        stays_closed: bool,
    ) -> NormalCondition {
        if stays_closed {
            return NormalCondition::Bilateral { velocity: 0.0, softness: 0.0 };
        }
        let nearing = before.opening.min(0.0);
        let touches = before.gap + self.shares[0] * self.length * nearing <= before.rounding;
        if touches {
            NormalCondition::Unilateral { velocity: restitution * nearing, softness: 0.0 }
        } else {
            NormalCondition::Open
        }
    }

    /// The closure of a compliant point where its force is taken, in a step that ends with the velocity `after`: −g − θ h (θ U⁺ + (1 − θ) U).
    pub(crate) fn closure(self, before: PointBefore, after: f64) -> f64 {
        let [first, second] = self.shares;
        -(before.gap + second * self.length * (second * after + first * before.opening))
    }

    /// What is asked of a point whose force follows from its closure within the step, about the closure `at`: with N ≈ N₀ + N′ (d − d₀) the
    /// point is a rigid one whose impulse softens it.
    pub(crate) fn about_closure(
        self,
        contact: &ContactPoints<'_>,
        point: usize,
        before: PointBefore,
        at: f64,
        speed: f64,
    ) -> NormalCondition {
        let Self { length: step, shares: [first, second] } = self;
        let stays_closed = contact.points[point].stays_closed;
        let closure = if stays_closed { at } else { at.max(0.0) };
        let forces = contact.forces(point, closure, speed).normal;
        let presses = closure > 0.0 || stays_closed;
        let slope = if presses { forces.by_closure } else { contact.first_stiffness(point) };
        if slope <= 0.0 || slope.is_nan() {
            return NormalCondition::Given { impulse: step * forces.value };
        }
        // how fast the closure follows the velocity at the end, in s, and the velocity that ends at this closure
        let reach = second * second * step;
        let there = -(closure + before.gap) / reach - first / second * before.opening;
        let softness = 1.0 / (reach * step * slope);
        let velocity = -there - softness * step * forces.value;
        match stays_closed {
            true => NormalCondition::Bilateral { velocity, softness },
            false => NormalCondition::Unilateral { velocity, softness },
        }
    }
}

/// What the explicit scheme asks of a rigid point, whose "velocity" is its gap at the end of the step over the step.
pub(crate) fn at_places(stays_closed: bool) -> NormalCondition {
    match stays_closed {
        true => NormalCondition::Bilateral { velocity: 0.0, softness: 0.0 },
        false => NormalCondition::Unilateral { velocity: 0.0, softness: 0.0 },
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
