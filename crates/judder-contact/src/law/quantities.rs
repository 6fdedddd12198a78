//! One number for each of the three quantities of a contact law.

use serde::{Deserialize, Serialize};

/// Something for each of normal force, contact area and viscoelastic friction.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PerQuantity<T> {
    /// For F̃_k.
    pub force: T,
    /// For Ã.
    pub area: T,
    /// For μ_visc.
    pub friction: T,
}

/// Values at knots, one array a quantity, speed fastest.
pub type KnotValues = PerQuantity<Vec<f64>>;

/// The names of the quantities in errors, in the order of [`PerQuantity`].
pub(crate) const NAMES: PerQuantity<&str> =
    PerQuantity { force: "force", area: "area", friction: "friction" };

impl<T> PerQuantity<T> {
    /// The same operation on each.
    pub fn map<U>(self, mut operation: impl FnMut(T) -> U) -> PerQuantity<U> {
        PerQuantity {
            force: operation(self.force),
            area: operation(self.area),
            friction: operation(self.friction),
        }
    }

    /// Pairs of two triples.
    pub fn zip<U>(self, other: PerQuantity<U>) -> PerQuantity<(T, U)> {
        PerQuantity {
            force: (self.force, other.force),
            area: (self.area, other.area),
            friction: (self.friction, other.friction),
        }
    }

    /// References to each.
    pub fn as_ref(&self) -> PerQuantity<&T> {
        PerQuantity { force: &self.force, area: &self.area, friction: &self.friction }
    }

    /// Force, area, friction.
    pub fn into_array(self) -> [T; 3] {
        [self.force, self.area, self.friction]
    }
}

impl<T: Copy> PerQuantity<T> {
    /// The same for each.
    pub const fn uniform(value: T) -> Self {
        Self { force: value, area: value, friction: value }
    }
}

/// How far a law may be from the exact contact, relative; each part an estimate.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LawErrors {
    /// The largest deviation, at knots that were left out, of the law made from the others: an upper estimate, because the
    /// law itself has those knots too.
    pub interpolation: PerQuantity<f64>,
    /// The largest error that the contact solver reported for its solutions at the knots.
    pub solver: PerQuantity<f64>,
}

impl LawErrors {
    /// Sum of both parts.
    #[must_use]
    pub fn total(&self) -> PerQuantity<f64> {
        self.interpolation.zip(self.solver).map(|(interpolation, solver)| interpolation + solver)
    }
}
