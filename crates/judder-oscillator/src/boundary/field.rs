//! The function whose zero set is the boundary, over positions in the unit square.

use super::continuation::FollowedCurve;
use super::{Boundary, BoundaryPoint, Condition};
use crate::Contact;
use crate::block::{LANES, PointBlock};
use crate::characteristic::Characteristic;
use crate::conservative::discriminant_share;
use crate::critical::ParameterRange;
use crate::equilibrium::{Equilibrium, equilibrium};
use crate::groups::Coefficients;
use crate::linear_system::ReducedSystem;
use crate::linearisation::Linearisation;

/// The boundary function over the unit square.
pub(super) struct BoundaryField<'a> {
    pub(super) contact: &'a Contact,
    pub(super) condition: Condition,
    pub(super) x: &'a ParameterRange,
    pub(super) y: &'a ParameterRange,
    pub(super) coefficients: &'a (dyn Fn(f64, f64) -> Coefficients + Sync),
}

impl BoundaryField<'_> {
    fn at(&self, position: [f64; 2]) -> Coefficients {
        (self.coefficients)(self.x.value(position[0]), self.y.value(position[1]))
    }

    /// The margin whose sign is the stability, by the scalar path; NaN without an equilibrium. Outside the square, where the
    /// quantities may make no sense any more, it is then that of the nearest point of the border.
    pub(super) fn margin(&self, position: [f64; 2]) -> f64 {
        let clamped = position.map(|s| s.clamp(0.0, 1.0));
        let Some((_, system)) = self.state(position).or_else(|| self.state(clamped)) else { return f64::NAN };
        match self.condition {
            Condition::Full => Characteristic::new(&system).margin(),
            Condition::Conservative => discriminant_share(&system.stiffness),
        }
    }

    fn state(&self, position: [f64; 2]) -> Option<(Equilibrium, ReducedSystem)> {
        let c = self.at(position);
        let state = equilibrium(self.contact, &c).ok()?;
        let l = Linearisation::new(self.contact.friction_load, &c, &state.response);
        Some((state, ReducedSystem { damping: l.damping(), stiffness: l.stiffness() }))
    }

    /// Pairs of neighbouring points of a grid between which the stability changes.
    pub(super) fn sign_changes(&self, intervals: usize) -> Vec<[[f64; 2]; 2]> {
        let side = intervals + 1;
        let position = |k: usize| grid_position(k, intervals);
        let mut margins: Vec<f64> = Vec::with_capacity(side * side);
        let mut block = PointBlock::default();
        for row in 0..side {
            for first in (0..side).step_by(LANES) {
                let width = LANES.min(side - first);
                for lane in 0..width {
                    block.set(lane, &self.at([position(first + lane), position(row)]), f64::NAN);
                }
                block.decide(self.contact, width);
                block.measure_margins(self.contact);
                margins.extend(match self.condition {
                    Condition::Full => &block.margin[..width],
                    Condition::Conservative => &block.conservative_margin[..width],
                });
            }
        }
        pairs_that_differ(&margins, intervals)
    }

    /// The curve in the swept quantities, with what belongs to each point.
    pub(super) fn boundary(&self, curve: &FollowedCurve) -> Boundary {
        let points = curve.positions.iter().map(|position| {
            let (indentation, frequency) = match self.state(*position) {
                Some((state, system)) => (state.indentation, self.frequency(&system)),
                None => (f64::NAN, f64::NAN),
            };
            BoundaryPoint {
                x: self.x.value(position[0]),
                y: self.y.value(position[1]),
                indentation,
                frequency,
            }
        });
        Boundary { points: points.collect(), folds: curve.folds.clone(), end: curve.end }
    }

    /// The frequency of the oscillation that is born on the boundary.
    fn frequency(&self, system: &ReducedSystem) -> f64 {
        match self.condition {
            Condition::Full => Characteristic::new(system).hopf_frequency(),
            Condition::Conservative => (0.5 * (system.stiffness[0][0] + system.stiffness[1][1])).sqrt(),
        }
    }
}

/// Positions of a grid with so many intervals along each side.
pub(super) fn grid_position(k: usize, intervals: usize) -> f64 {
    k as f64 / intervals as f64
}

/// Pairs of neighbouring grid points, row by row, whose margins differ in sign.
pub(super) fn pairs_that_differ(margins: &[f64], intervals: usize) -> Vec<[[f64; 2]; 2]> {
    let side = intervals + 1;
    let position =
        |column: usize, row: usize| [grid_position(column, intervals), grid_position(row, intervals)];
    // a margin that vanishes on a grid line counts with the positive ones, so that the boundary there has two sides
    let differ = |a: f64, b: f64| !a.is_nan() && !b.is_nan() && (a >= 0.0) != (b >= 0.0);
    let mut pairs = Vec::new();
    for row in 0..side {
        for column in 0..side {
            let here = row * side + column;
            if column < intervals && differ(margins[here], margins[here + 1]) {
                pairs.push([position(column, row), position(column + 1, row)]);
            }
            if row < intervals && differ(margins[here], margins[here + side]) {
                pairs.push([position(column, row), position(column, row + 1)]);
            }
        }
    }
    pairs
}
