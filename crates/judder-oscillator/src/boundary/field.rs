//! The function whose zero set is the boundary, over positions in the unit square.

use super::continuation::Curve;
use super::{Boundary, BoundaryPoint, Condition};
use crate::Contact;
use crate::block::{Block, LANES};
use crate::characteristic::Characteristic;
use crate::conservative::discriminant_share;
use crate::critical::Range;
use crate::equilibrium::{Equilibrium, equilibrium};
use crate::groups::Coefficients;
use crate::linear_system::ReducedSystem;
use crate::linearisation::Linearisation;
use judder_numerics::root::bracketed_root;

/// The boundary function over the unit square.
pub(super) struct Field<'a> {
    pub(super) contact: &'a Contact,
    pub(super) condition: Condition,
    pub(super) x: &'a Range,
    pub(super) y: &'a Range,
    pub(super) coefficients: &'a (dyn Fn(f64, f64) -> Coefficients + Sync),
}

impl Field<'_> {
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
        let position = |k: usize| k as f64 / intervals as f64;
        let mut margins: Vec<f64> = Vec::with_capacity(side * side);
        let mut block = Block::default();
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
        let mut pairs = Vec::new();
        for row in 0..side {
            for column in 0..side {
                let here = row * side + column;
                let mut compare = |other: usize, to: [f64; 2]| {
                    if margins[here] * margins[other] < 0.0 {
                        pairs.push([[position(column), position(row)], to]);
                    }
                };
                if column < intervals {
                    compare(here + 1, [position(column + 1), position(row)]);
                }
                if row < intervals {
                    compare(here + side, [position(column), position(row + 1)]);
                }
            }
        }
        pairs
    }

    /// The point between two grid points at which the stability changes.
    pub(super) fn root_between(&self, [a, b]: [[f64; 2]; 2]) -> Option<[f64; 2]> {
        let between = |share: f64| [a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])];
        bracketed_root(|share| self.margin(between(share)), 0.0, 1.0, 1e-12).ok().map(between)
    }

    /// The curve in the swept quantities, with what belongs to each point.
    pub(super) fn boundary(&self, curve: &Curve) -> Boundary {
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
