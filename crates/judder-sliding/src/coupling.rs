//! Compatibility row and equilibrium column: what couples the two structures where they touch.
//!
//! J. Brunetti, W. D'Ambrogio, A. Fregolent, *Dynamic substructuring with time variant coupling conditions for the analysis of
//! friction induced vibrations* (2020), equations (3) to (8): one row c of B_C, and e = −B_Eᵀ, so that N > 0 presses.

use crate::SlidingError;
use crate::body::ModalPoint;
use crate::edge::{Touch, Weights};
use crate::pair::Pair;
use crate::plane::{PlaneVector, plus};
use judder_contact::friction::{Friction, FrictionAt};

/// The coupling of two structures at one place of contact, linear.
///
/// q̈ + C q̇ + K q = f + e N + Σ b (r q or r q̇), c q + gap = 0, in modal coordinates, M = I. Friction makes c ≠ e.
#[derive(Debug, Clone, PartialEq)]
pub struct Coupling {
    /// c: what the gap gains from modal coordinates, 1/√kg.
    pub compatibility: Vec<f64>,
    /// e: what a unit normal force with its friction does to them, 1/√kg.
    pub equilibrium: Vec<f64>,
    /// Forces that follow the motion, none where geometry and friction coefficient are constant.
    pub feedback: Vec<Feedback>,
}

/// A force b (r q), or b (r q̇).
#[derive(Debug, Clone, PartialEq)]
pub struct Feedback {
    /// r.
    pub row: Vec<f64>,
    /// b.
    pub column: Vec<f64>,
    /// Whether it follows velocities, not displacements.
    pub follows_velocity: bool,
}

/// Friction in steady sliding.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SteadyFriction {
    /// μ.
    pub friction: f64,
    /// dμ/dv, s/m.
    pub slope: f64,
    /// 1 along the track, −1 against it.
    pub direction: f64,
}

impl SteadyFriction {
    /// That of a speed in m/s, negative against the track.
    #[must_use]
    pub fn at(friction: &Friction, velocity: f64) -> Self {
        let direction = if velocity < 0.0 { -1.0 } else { 1.0 };
        let FrictionAt { coefficient, slope } = friction.at(velocity.abs());
        Self { friction: coefficient, slope, direction }
    }

    /// n − σ μ t: the direction in which the contact pushes the slider.
    pub(crate) fn push(&self, touch: &Touch) -> PlaneVector {
        plus(touch.normal, -self.direction * self.friction, touch.tangent)
    }
}

impl Coupling {
    /// The coupling at a touch whose geometry and friction coefficient stay: that of prescribed motion.
    #[must_use]
    pub fn new(pair: &Pair, touch: &Touch, sliding: SteadyFriction) -> Self {
        let push = sliding.push(touch);
        let Weights { value, .. } = &touch.weights;
        Self {
            compatibility: spread(pair, touch, touch.normal, touch.normal, value),
            equilibrium: spread(pair, touch, push, push, value),
            feedback: Vec::new(),
        }
    }

    /// The same under a normal force N, whose friction coefficient follows the sliding speed.
    ///
    /// With v = t·(u̇_C − Σ w u̇_k) beside the steady speed, the friction gains −N σ (dμ/d|v|) σ v along t.
    #[must_use]
    pub fn with_falling_friction(
        mut self,
        pair: &Pair,
        touch: &Touch,
        sliding: SteadyFriction,
        force: f64,
    ) -> Self {
        if sliding.slope != 0.0 {
            let Weights { value, .. } = &touch.weights;
            let row = spread(pair, touch, touch.tangent, touch.tangent, value);
            let column = row.iter().map(|entry| -force * sliding.slope * entry).collect();
            self.feedback.push(Feedback { row, column, follows_velocity: true });
        }
        self
    }

    /// The same under a normal force N, with a geometry that follows the deformation.
    ///
    /// A disturbance δq turns the edge by δθ and moves the contact along it by δξ; e, which depends on both, then pushes with
    /// N (∂e/∂θ δθ + ∂e/∂ξ δξ).
    #[must_use]
    pub fn with_wandering(mut self, pair: &Pair, touch: &Touch, sliding: SteadyFriction, force: f64) -> Self {
        let Touch { normal, tangent, stretch, weights, turn, .. } = touch;
        let (side, none) = (pair.edge().side, [0.0; 2]);
        let sized = |vector: &PlaneVector, factor: f64| [vector[0] * factor, vector[1] * factor];
        // the left of the edge is side·n: with θ, t turns towards it and n towards −side·t
        let left = sized(normal, side / stretch);
        let along = sized(tangent, 1.0 / stretch);
        let place = spread(pair, touch, along, along, &weights.value);
        let by_slope = spread(pair, touch, none, sized(&left, -1.0), &weights.slope);
        let angle = by_slope.iter().zip(&place).map(|(slope, place)| slope + turn * place).collect();
        let turned = plus(sized(tangent, -side), -sliding.direction * sliding.friction * side, *normal);
        let forced = |column: Vec<f64>| column.into_iter().map(|entry| force * entry).collect::<Vec<_>>();
        let by_angle = forced(spread(pair, touch, turned, turned, &weights.value));
        let by_place = forced(spread(pair, touch, none, sliding.push(touch), &weights.slope));
        for (row, column) in [(angle, by_angle), (place, by_place)] {
            self.feedback.push(Feedback { row, column, follows_velocity: false });
        }
        self
    }

    /// c·M⁻¹e, 1/kg: what a unit normal force opens.
    #[must_use]
    pub fn mobility(&self) -> f64 {
        product(&self.compatibility, &self.equilibrium)
    }

    /// Whether a normal force can open the contact, c·M⁻¹e > 0; `position` in m and the friction coefficient are for the message.
    ///
    /// # Errors
    /// [`SlidingError::SpragSlip`] where it cannot: friction then presses harder than the contact can push back, and the slider locks.
    pub fn check(&self, position: f64, friction: f64) -> Result<(), SlidingError> {
        let mobility = self.mobility();
        if mobility > 0.0 { Ok(()) } else { Err(SlidingError::SpragSlip { position, mobility, friction }) }
    }
}

/// Φ_Cᵀ a on the slider, −Σ w_k Φ_kᵀ b on the track.
fn spread(
    pair: &Pair,
    touch: &Touch,
    on_slider: PlaneVector,
    on_track: PlaneVector,
    weights: &[f64],
) -> Vec<f64> {
    let along = |point: &ModalPoint, direction: PlaneVector, mode: usize| {
        direction[0] * point.rows[0][mode] + direction[1] * point.rows[1][mode]
    };
    let of_slider =
        (0..pair.slider().body.modes()).map(|mode| along(&pair.slider().contact, on_slider, mode));
    let first = pair.edge().first_node(touch.at.segment);
    let nodes = &pair.track().nodes[first..first + pair.edge().stencil_nodes()];
    let of_track = (0..pair.track().body.modes()).map(|mode| {
        let entry = |(node, weight): (&ModalPoint, &f64)| weight * along(node, on_track, mode);
        -nodes.iter().zip(weights).map(entry).sum::<f64>()
    });
    of_slider.chain(of_track).collect()
}

pub(crate) fn product(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
