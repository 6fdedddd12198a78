//! The function whose zero set is the boundary, over positions in the unit square.

use super::continuation::Curve;
use super::{Boundary, BoundaryPoint, Condition};
use crate::Contact;
use crate::block::{Block, LANES};
use crate::characteristic::Characteristic;
use crate::critical::Range;
use crate::equilibrium::equilibrium_at;
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

/// Value and gradient at a position, with the indentation as a starting value for the next.
#[derive(Clone, Copy)]
pub(super) struct Local {
    pub(super) value: f64,
    pub(super) gradient: [f64; 2],
    pub(super) ln_indentation: f64,
}

impl Field<'_> {
    fn at(&self, position: [f64; 2]) -> Coefficients {
        (self.coefficients)(self.x.value(position[0]), self.y.value(position[1]))
    }

    /// The boundary function of a decided lane.
    fn value(&self, block: &Block, lane: usize) -> f64 {
        match self.condition {
            _ if block.ln_indentation[lane].is_nan() => f64::NAN,
            Condition::Full => block.hopf_margin[lane],
            Condition::Conservative => block.conservative_margin[lane],
        }
    }

    /// The margin whose sign is the stability, which the seeds are taken from.
    fn margin(&self, block: &Block, lane: usize) -> f64 {
        match self.condition {
            _ if block.ln_indentation[lane].is_nan() => f64::NAN,
            Condition::Full => block.margin[lane],
            Condition::Conservative => block.conservative_margin[lane],
        }
    }

    /// Value and central-difference gradient, from one block of five points; `None` without an equilibrium.
    pub(super) fn local(&self, position: [f64; 2], guess: f64) -> Option<Local> {
        /// Balances truncation (h²) against rounding (ε/h) of a function of order one.
        const STEP: f64 = 1e-5;
        let [s, t] = position;
        let mut block = Block::default();
        for (lane, at) in
            [[s, t], [s + STEP, t], [s - STEP, t], [s, t + STEP], [s, t - STEP]].into_iter().enumerate()
        {
            block.set(lane, &self.at(at), guess);
        }
        block.decide(self.contact, 5);
        let value = |lane: usize| self.value(&block, lane);
        let gradient = [(value(1) - value(2)) / (2.0 * STEP), (value(3) - value(4)) / (2.0 * STEP)];
        let length = gradient[0].hypot(gradient[1]);
        (length.is_finite() && length > 0.0).then(|| Local {
            value: value(0),
            gradient,
            ln_indentation: block.ln_indentation[0],
        })
    }

    /// Pairs of neighbouring points of a grid between which the stability changes.
    pub(super) fn sign_changes(&self, intervals: usize) -> Vec<[[f64; 2]; 2]> {
        let side = intervals + 1;
        let position = |k: usize| k as f64 / intervals as f64;
        let mut margins = Vec::with_capacity(side * side);
        let mut block = Block::default();
        for row in 0..side {
            for first in (0..side).step_by(LANES) {
                let width = LANES.min(side - first);
                for lane in 0..width {
                    block.set(lane, &self.at([position(first + lane), position(row)]), f64::NAN);
                }
                block.decide(self.contact, width);
                margins.extend((0..width).map(|lane| self.margin(&block, lane)));
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
        let mut block = Block::default();
        let margin = |share: f64| {
            block.set(0, &self.at(between(share)), f64::NAN);
            block.decide(self.contact, 1);
            self.margin(&block, 0)
        };
        bracketed_root(margin, 0.0, 1.0, 1e-12).ok().map(between)
    }

    /// The curve in the swept quantities, with what belongs to each point.
    pub(super) fn boundary(&self, curve: &Curve) -> Boundary {
        let points = curve.positions.iter().zip(&curve.ln_indentations).map(|(position, ln_indentation)| {
            let c = self.at(*position);
            let e = equilibrium_at(self.contact, &c, *ln_indentation);
            let l = Linearisation::new(self.contact.friction_load, &c, &e.response);
            let frequency = match self.condition {
                Condition::Full => {
                    let system = ReducedSystem { damping: l.damping(), stiffness: l.stiffness() };
                    Characteristic::new(&system).hopf_frequency()
                }
                Condition::Conservative => (0.5 * (l.k11 + l.k22)).sqrt(),
            };
            let (x, y) = (self.x.value(position[0]), self.y.value(position[1]));
            BoundaryPoint { x, y, indentation: e.indentation, frequency }
        });
        Boundary { points: points.collect(), folds: curve.folds.clone(), end: curve.end }
    }
}
