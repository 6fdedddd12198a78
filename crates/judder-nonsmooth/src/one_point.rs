//! The contact of one point by itself, solved exactly.
//!
//! With the normal impulse eliminated, N = n₀ + m·t, the friction impulse t meets S t + c = U_T. It sticks where |t| of U_T = 0 is not
//! beyond μ N; else U_T = −λ t with λ > 0, t(λ) = −(S + λ)⁻¹ c, and |t(λ)| = μ N(λ) is one equation in λ: beyond μ N at λ = 0, below it
//! where λ is large.

use crate::contact_problem::{FrictionNow, MOST, NormalCondition, PointMotion, length};

/// Steps to λ at most: it takes three to five.
const STEPS: usize = 100;

/// The part of W that is of one point.
#[derive(Debug, Clone, Copy)]
pub(crate) struct PointDelassus {
    entries: [[f64; MOST]; MOST],
}

/// A point whose normal impulse is eliminated.
struct Eliminated {
    /// S.
    tangential: [[f64; 2]; 2],
    /// c.
    free: [f64; 2],
    /// n₀.
    alone: f64,
    /// m.
    coupled: [f64; 2],
}

impl PointDelassus {
    pub(crate) fn new(entries: [[f64; MOST]; MOST]) -> Self {
        Self { entries }
    }

    /// W_NN.
    pub(crate) fn normal(&self) -> f64 {
        self.entries[0][0]
    }

    /// The larger of the two of W_TT; one where nothing moves along the contact.
    pub(crate) fn tangential(&self) -> f64 {
        let largest = self.entries[1][1].max(self.entries[2][2]);
        if largest > 0.0 { largest } else { 1.0 }
    }

    /// Whether impulses along the normal move it.
    pub(crate) fn yields(&self) -> bool {
        self.normal() > 0.0 && self.normal().is_finite()
    }

    /// Its velocity without its own impulse.
    pub(crate) fn without(&self, velocity: [f64; MOST], impulse: [f64; MOST]) -> [f64; MOST] {
        let own = |k: usize| (0..MOST).map(|j| self.entries[k][j] * impulse[j]).sum::<f64>();
        [0, 1, 2].map(|k| velocity[k] - own(k))
    }

    /// The impulse at a point whose velocity without it is `free`.
    pub(crate) fn solve(
        &self,
        free: [f64; MOST],
        condition: NormalCondition,
        friction: FrictionNow,
    ) -> ([f64; MOST], PointMotion) {
        let eliminated = match condition {
            NormalCondition::Open => return ([0.0; MOST], PointMotion::Open),
            NormalCondition::Unilateral { velocity, .. } if free[0] + velocity >= 0.0 => {
                return ([0.0; MOST], PointMotion::Open);
            }
            NormalCondition::Given { impulse: 0.0 } => return ([0.0; MOST], PointMotion::Open),
            // a point that is held closed and pulls has no friction
            NormalCondition::Given { impulse } if impulse < 0.0 => {
                return ([impulse, 0.0, 0.0], PointMotion::Slip);
            }
            NormalCondition::Unilateral { velocity, softness }
            | NormalCondition::Bilateral { velocity, softness } => {
                self.eliminated(free, free[0] + velocity, softness)
            }
            NormalCondition::Given { impulse } => Eliminated {
                tangential: [1, 2].map(|i| [1, 2].map(|j| self.entries[i][j])),
                free: [1, 2].map(|i| free[i] + self.entries[i][0] * impulse),
                alone: impulse,
                coupled: [0.0; 2],
            },
        };
        match friction {
            FrictionNow::Coulomb { at_rest, now } => eliminated.solve(at_rest, now),
            FrictionNow::Sliding { coefficient } => (eliminated.sliding(coefficient), PointMotion::Slip),
        }
    }

    fn eliminated(&self, free: [f64; MOST], closing: f64, softness: f64) -> Eliminated {
        let w = &self.entries;
        let normal = w[0][0] + softness;
        Eliminated {
            tangential: [1, 2].map(|i| [1, 2].map(|j| w[i][j] - w[i][0] * w[0][j] / normal)),
            free: [1, 2].map(|i| free[i] - w[i][0] * closing / normal),
            alone: -closing / normal,
            coupled: [1, 2].map(|j| -w[0][j] / normal),
        }
    }
}

impl Eliminated {
    /// t(λ): in the plane without the part across the slip.
    fn friction(&self, lambda: f64) -> [f64; 2] {
        let [[a, b], [c, d]] = self.tangential;
        let (a, d) = (a + lambda, d + lambda);
        if self.is_plane() {
            return [-self.free[0] / a, 0.0];
        }
        let determinant = a * d - b * c;
        [
            (b * self.free[1] - d * self.free[0]) / determinant,
            (c * self.free[0] - a * self.free[1]) / determinant,
        ]
    }

    fn is_plane(&self) -> bool {
        self.tangential[1][1] == 0.0
    }

    /// N(t).
    fn normal(&self, t: [f64; 2]) -> f64 {
        self.alone + self.coupled[0] * t[0] + self.coupled[1] * t[1]
    }

    fn solve(&self, at_rest: f64, now: f64) -> ([f64; MOST], PointMotion) {
        // nothing moves along the contact: it carries no friction
        if self.tangential[0][0] <= 0.0 {
            return ([self.alone, 0.0, 0.0], PointMotion::Slip);
        }
        let stuck = self.friction(0.0);
        let pressed = self.normal(stuck);
        if length(stuck) <= at_rest * pressed {
            return ([pressed, stuck[0], stuck[1]], PointMotion::Stick);
        }
        let t = if self.is_plane() { self.slip_in_plane(now) } else { self.slip_in_space(now) };
        ([self.normal(t), t[0], t[1]], PointMotion::Slip)
    }

    /// t = μ N along the slip of steady sliding. Where a point locks, so that no such force closes it, it is left without friction, which is no solution.
    fn sliding(&self, coefficient: f64) -> [f64; MOST] {
        let yields = 1.0 - coefficient * self.coupled[0];
        if self.alone <= 0.0 || yields <= 0.0 {
            return [self.alone, 0.0, 0.0];
        }
        let pressed = self.alone / yields;
        [pressed, coefficient * pressed, 0.0]
    }

    /// |t| = μ N with the sign that drags against the slip.
    fn slip_in_plane(&self, coefficient: f64) -> [f64; 2] {
        let against = -self.free[0].signum();
        let size = coefficient * self.alone / (1.0 - coefficient * self.coupled[0] * against);
        // a point that is held closed and pulls has no friction; no friction drives beyond what sticks
        [against * size.clamp(0.0, self.friction(0.0)[0].abs()), 0.0]
    }

    fn slip_in_space(&self, coefficient: f64) -> [f64; 2] {
        if coefficient * self.alone <= 0.0 {
            return [0.0; 2];
        }
        let mut lambda = 0.0;
        let (mut lower, mut upper) = (0.0, f64::INFINITY);
        for _ in 0..STEPS {
            let (ratio, slope) = self.carried(lambda, coefficient);
            // on a law that rises from rest nothing is to be found beyond λ = 0
            if ratio >= 0.0 && lambda == 0.0 {
                return self.friction(0.0);
            }
            if ratio < 0.0 {
                lower = lambda;
            } else {
                upper = lambda;
            }
            let next = lambda - ratio / slope;
            let inside = next > lower && next < upper;
            let last = std::mem::replace(
                &mut lambda,
                match (inside, upper.is_finite()) {
                    (true, _) => next,
                    (false, true) => 0.5 * (lower + upper),
                    (false, false) => 8.0 * lower.max(self.tangential[0][0]),
                },
            );
            if (lambda - last).abs() <= f64::EPSILON * (lambda + self.tangential[0][0]) {
                break;
            }
        }
        self.friction(lambda)
    }

    /// μ N/|t| − 1 at λ, which is nearly straight, and its slope.
    fn carried(&self, lambda: f64, coefficient: f64) -> (f64, f64) {
        let [[a, b], [c, d]] = self.tangential;
        let (a, d) = (a + lambda, d + lambda);
        let t = self.friction(lambda);
        let determinant = a * d - b * c;
        // dt/dλ = −(S + λ)⁻¹ t
        let turned = [(b * t[1] - d * t[0]) / determinant, (c * t[0] - a * t[1]) / determinant];
        let size = length(t);
        let by_size = (t[0] * turned[0] + t[1] * turned[1]) / size;
        let pressed = self.normal(t);
        let by_pressed = self.coupled[0] * turned[0] + self.coupled[1] * turned[1];
        let bound = coefficient / size;
        (bound * pressed - 1.0, bound * (by_pressed - pressed * by_size / size))
    }
}
