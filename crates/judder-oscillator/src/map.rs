//! Stability maps over two swept quantities.

mod adaptive;
mod every_point;
mod within_law;

use crate::Contact;
use crate::groups::Coefficients;
use crate::mechanism::StabilityClass;

pub use adaptive::{AdaptiveMap, CoarseMap, CoarselyDecided, adaptive};
pub use every_point::{TILE_ROWS, every_point};
pub use within_law::{LawStanding, within_law};

/// Intervals of the coarse grid along each side: what is narrower than the map's side over this can escape.
const COARSE_INTERVALS: usize = 40;

/// A rectangular grid of operating points: columns along the first swept quantity, rows along the second.
pub trait OperatingPlane: Sync {
    /// Points along the first swept quantity.
    fn columns(&self) -> usize;
    /// Points along the second swept quantity.
    fn rows(&self) -> usize;
    /// The oscillator at a grid point.
    fn coefficients(&self, column: usize, row: usize) -> Coefficients;
}

/// A coefficient that a sweep sets directly.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SweptCoefficient {
    /// v̂_d.
    Velocity,
    /// F̃_n.
    NormalLoad,
    /// τ̃0.
    ShearStrength,
}

/// A plane over two of the coefficients that a map usually sweeps.
#[derive(Debug, Clone, PartialEq)]
pub struct CoefficientPlane {
    /// All other coefficients.
    pub base: Coefficients,
    /// What the columns sweep, and its values.
    pub x: (SweptCoefficient, Vec<f64>),
    /// What the rows sweep, and its values.
    pub y: (SweptCoefficient, Vec<f64>),
}

impl SweptCoefficient {
    #[inline(always)]
    fn set(self, c: &mut Coefficients, value: f64) {
        match self {
            Self::Velocity => c.velocity = value,
            Self::NormalLoad => c.normal_load = value,
            Self::ShearStrength => c.shear_strength = value,
        }
    }
}

impl OperatingPlane for CoefficientPlane {
    fn columns(&self) -> usize {
        self.x.1.len()
    }

    fn rows(&self) -> usize {
        self.y.1.len()
    }

    #[inline(always)]
    fn coefficients(&self, column: usize, row: usize) -> Coefficients {
        let mut c = self.base;
        self.x.0.set(&mut c, self.x.1[column]);
        self.y.0.set(&mut c, self.y.1[row]);
        c
    }
}

/// The classes of all grid points.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct StabilityMap {
    /// Points along the first swept quantity.
    pub columns: usize,
    /// Points along the second swept quantity.
    pub rows: usize,
    /// Codes of [`StabilityClass`], row by row: index `row · columns + column`.
    pub classes: Vec<u8>,
    /// Decisions that were made to fill the map.
    pub decisions: usize,
}

impl StabilityMap {
    /// The class at a grid point.
    #[must_use]
    pub fn class(&self, column: usize, row: usize) -> StabilityClass {
        StabilityClass::from_code(self.classes[row * self.columns + column])
    }

    /// How many grid points are of a class.
    #[must_use]
    pub fn count(&self, class: StabilityClass) -> usize {
        self.classes.iter().filter(|c| **c == class as u8).count()
    }

    /// Share of the grid points that is unstable, each weighted alike.
    #[must_use]
    pub fn unstable_fraction(&self) -> f64 {
        let unstable: usize =
            StabilityClass::ALL.into_iter().filter(|c| c.is_unstable()).map(|c| self.count(c)).sum();
        unstable as f64 / self.classes.len() as f64
    }
}

/// How a map decides its points.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "keys", derive(judder_keys::Choice), choice(what = "method"))]
pub enum DecisionMethod {
    /// Cells are refined only where a boundary crosses.
    ///
    /// A coarse grid first, then wherever neighbours differ.
    #[default]
    Adaptive,
    /// Every point is decided.
    EveryPoint,
}

/// The stability map of a plane; the result does not depend on the number of threads.
#[must_use]
pub fn stability_map(contact: &Contact, plane: &impl OperatingPlane, method: DecisionMethod) -> StabilityMap {
    match method {
        DecisionMethod::Adaptive => adaptive(contact, plane),
        DecisionMethod::EveryPoint => every_point(contact, plane),
    }
}

/// The lines of the coarse grid, the first and the last of the map among them.
fn coarse_lines(count: usize) -> Vec<usize> {
    let mut lines: Vec<usize> = (0..count).step_by((count / COARSE_INTERVALS).max(1)).collect();
    if lines.last().is_some_and(|last| last + 1 < count) {
        lines.push(count - 1);
    }
    lines
}
