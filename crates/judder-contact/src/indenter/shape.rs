//! The indenters by name.

use super::height_map::HeightMap;
use crate::steady::profile::{OUT_OF_REACH, Paraboloid, Profile, Sphere};
use std::f64::consts::PI;

/// The surface of a rigid indenter, lowest at the origin; lengths in the problem's unit, mostly R.
#[derive(Debug, Clone, PartialEq)]
pub enum IndenterShape {
    /// h = (x² + y²)/2R, the shallow sphere of Hertz.
    Paraboloid {
        /// R, radius of curvature.
        radius: f64,
    },
    /// h = R − √(R² − x² − y²); points beyond the equator are out of reach.
    Sphere {
        /// R, radius.
        radius: f64,
    },
    /// h = x²/2R for every y: a line contact, whose forces are per length.
    Cylinder {
        /// R, radius of curvature.
        radius: f64,
    },
    /// Heights on a lattice.
    HeightMap(HeightMap),
}

impl IndenterShape {
    /// Whether the surface repeats itself, so that only the periodic kernel applies.
    #[must_use]
    pub fn is_periodic(&self) -> bool {
        matches!(self, Self::HeightMap(map) if map.is_periodic())
    }
}

impl Profile for IndenterShape {
    fn height(&self, x: f64, y: f64) -> f64 {
        match self {
            Self::Paraboloid { radius } => radius * Paraboloid.height(x / radius, y / radius),
            Self::Sphere { radius } => radius * Sphere.height(x / radius, y / radius),
            Self::Cylinder { radius } => 0.5 * x * x / radius,
            Self::HeightMap(map) => map.height(x, y),
        }
    }

    fn extent(&self, depth: f64) -> f64 {
        match self {
            Self::Paraboloid { radius } | Self::Cylinder { radius } => {
                radius * Paraboloid.extent(depth / radius)
            }
            Self::Sphere { radius } => radius * Sphere.extent(depth / radius),
            Self::HeightMap(map) => map.extent(depth),
        }
    }

    fn deepest(&self) -> f64 {
        match self {
            Self::Sphere { radius } => radius * Sphere.deepest(),
            Self::Paraboloid { radius } | Self::Cylinder { radius } => radius * Paraboloid.deepest(),
            Self::HeightMap(_) => OUT_OF_REACH,
        }
    }

    /// For a cylinder `force` is per length, and the depth is that at which the undeformed cylinder is as wide as the
    /// contact of Hertz, a² = 4 F R/π: the depth of a line contact itself has no meaning without a datum.
    fn elastic_depth(&self, force: f64) -> f64 {
        match self {
            Self::Paraboloid { radius } | Self::Sphere { radius } => {
                radius * Paraboloid.elastic_depth(force / (radius * radius))
            }
            Self::Cylinder { .. } => 2.0 * force / PI,
            Self::HeightMap(map) => map.elastic_depth(force),
        }
    }

    fn is_line(&self) -> bool {
        matches!(self, Self::Cylinder { .. })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sphere_is_exact_and_out_of_reach_beyond_its_equator() {
        let sphere = IndenterShape::Sphere { radius: 2.0 };
        assert!((sphere.height(1.2, 0.0) - 0.4).abs() < 1e-15);
        assert!(sphere.height(2.0, 0.5) > 100.0 && sphere.height(2.0, 0.5).is_finite());
        assert!((sphere.extent(0.4) - 1.2).abs() < 1e-15);
    }

    #[test]
    fn depth_of_a_paraboloid_scales_with_its_radius() {
        let force: f64 = 4.0 / 3.0 * 3.0_f64.sqrt() * 0.1_f64.powf(1.5);
        let depth = IndenterShape::Paraboloid { radius: 3.0 }.elastic_depth(force);
        assert!((depth - 0.1).abs() < 1e-14);
    }

    #[test]
    fn cylinder_is_as_wide_as_the_contact_of_hertz() {
        let cylinder = IndenterShape::Cylinder { radius: 0.5 };
        let half_width = cylinder.extent(cylinder.elastic_depth(0.01));
        assert!((half_width * half_width - 4.0 * 0.01 * 0.5 / PI).abs() < 1e-15);
        assert!(cylinder.is_line() && cylinder.height(0.1, 0.0) == cylinder.height(0.1, 7.0));
    }
}
