//! Linear elastic materials, and how an element of the plane is meant.

use crate::StructureError;
#[cfg(feature = "keys")]
use judder_keys::{declared::Number, dimension::Dimension, numeric_key::Range};

/// Below a half by as much as elements bear.
#[cfg(feature = "keys")]
const POISSON_RATIO: Number =
    Number { dimension: Dimension::NUMBER, range: Range::Interval { above: -1.0, up_to: 0.499_999 } };

/// An isotropic linear elastic material.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "keys", derive(judder_keys::Settings))]
pub struct Elastic {
    /// Young's modulus.
    ///
    /// E in Pa.
    #[cfg_attr(feature = "keys", key(rule = Number::positive(Dimension::STRESS), symbol = "E"))]
    pub youngs_modulus: f64,
    /// Poisson's ratio.
    ///
    /// ν.
    #[cfg_attr(feature = "keys", key(rule = POISSON_RATIO, symbol = "ν"))]
    pub poisson_ratio: f64,
    /// Density.
    ///
    /// ρ in kg/m³.
    #[cfg_attr(feature = "keys", key(rule = Number::positive(Dimension::DENSITY), symbol = "ρ"))]
    pub density: f64,
}

impl Elastic {
    /// A material with E > 0, −1 < ν < ½, ρ ≥ 0.
    ///
    /// # Errors
    /// [`StructureError::InvalidNumber`] names the first number out of its range.
    pub fn new(youngs_modulus: f64, poisson_ratio: f64, density: f64) -> Result<Self, StructureError> {
        let invalid =
            |name, value, requirement| Err(StructureError::InvalidNumber { name, value, requirement });
        if !(youngs_modulus.is_finite() && youngs_modulus > 0.0) {
            return invalid("Young's modulus", youngs_modulus, "positive");
        }
        if !(poisson_ratio > -1.0 && poisson_ratio < 0.5) {
            return invalid("Poisson's ratio", poisson_ratio, "above −1 and below 0.5");
        }
        if !(density.is_finite() && density >= 0.0) {
            return invalid("density", density, "zero or positive");
        }
        Ok(Self { youngs_modulus, poisson_ratio, density })
    }

    /// Stress by strain, in the order xx, yy, xy in the plane and xx, yy, zz, xy, yz, zx in space, with engineering shear
    /// strains; what is beyond is zero.
    #[must_use]
    pub fn stiffness(&self, section: ElementSection) -> [[f64; 6]; 6] {
        let (e, nu) = (self.youngs_modulus, self.poisson_ratio);
        let shear = e / (2.0 * (1.0 + nu));
        let (normal, coupling, axes) = match section {
            ElementSection::PlaneStress { .. } => (e / (1.0 - nu * nu), nu * e / (1.0 - nu * nu), 2),
            ElementSection::PlaneStrain { .. } | ElementSection::Solid => {
                let lame = e * nu / ((1.0 + nu) * (1.0 - 2.0 * nu));
                (lame + 2.0 * shear, lame, section.dimension())
            }
        };
        let components = if axes == 2 { 3 } else { 6 };
        let entry = |i: usize, j: usize| match (i == j, i.max(j)) {
            (_, last) if last >= components => 0.0,
            (true, last) if last >= axes => shear,
            (true, _) => normal,
            (false, last) if last < axes => coupling,
            (false, _) => 0.0,
        };
        std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)))
    }
}

/// How the third direction is meant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ElementSection {
    /// A plate that is free to change its thickness.
    PlaneStress {
        /// In m.
        thickness: f64,
    },
    /// A slice of a long body, which cannot.
    PlaneStrain {
        /// In m.
        thickness: f64,
    },
    /// A body in space.
    Solid,
}

impl ElementSection {
    /// 2 in the plane, 3 in space.
    #[must_use]
    pub fn dimension(self) -> usize {
        if self == Self::Solid { 3 } else { 2 }
    }

    /// The thickness in m; 1 in space, where the volume has it.
    #[must_use]
    pub fn thickness(self) -> f64 {
        match self {
            Self::PlaneStress { thickness } | Self::PlaneStrain { thickness } => thickness,
            Self::Solid => 1.0,
        }
    }
}
