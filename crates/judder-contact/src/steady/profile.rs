//! The indenter's surface.

/// Height, in R, given to points where there is no indenter, as beyond the equator of a sphere: no contact reaches there.
pub(crate) const OUT_OF_REACH: f64 = 1e3;

/// The surface of a rigid indenter, lowest at the origin; lengths in R.
pub trait Profile: Sync {
    /// Height of the surface above its lowest point at (x, y); very large where the indenter does not reach.
    fn height(&self, x: f64, y: f64) -> f64;

    /// Distance from the origin within which the height stays below `depth`.
    fn extent(&self, depth: f64) -> f64;

    /// The depth at which the indenter ends, or is taken to.
    fn deepest(&self) -> f64 {
        OUT_OF_REACH
    }

    /// Depth at which the force of an elastic contact with unit modulus is `force`, or a guess of it.
    fn elastic_depth(&self, force: f64) -> f64;

    /// Whether the indenter goes on for ever along y: a line contact, whose force and area are per length.
    fn is_line(&self) -> bool {
        false
    }
}

/// h = (x² + y²)/2, the shallow sphere of Hertz with R = 1.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Paraboloid;

impl Profile for Paraboloid {
    fn height(&self, x: f64, y: f64) -> f64 {
        0.5 * (x * x + y * y)
    }

    fn extent(&self, depth: f64) -> f64 {
        (2.0 * depth).sqrt()
    }

    fn elastic_depth(&self, force: f64) -> f64 {
        libm::pow(0.75 * force, 2.0 / 3.0)
    }
}

/// h = 1 − √(1 − x² − y²), a true sphere with R = 1.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Sphere;

impl Profile for Sphere {
    fn height(&self, x: f64, y: f64) -> f64 {
        let squared = x * x + y * y;
        // 1 − √(1 − s) cancels for small s; s/(1 + √(1 − s)) does not.
        if squared < 1.0 { squared / (1.0 + (1.0 - squared).sqrt()) } else { OUT_OF_REACH }
    }

    fn extent(&self, depth: f64) -> f64 {
        if depth < 1.0 { (depth * (2.0 - depth)).sqrt() } else { 1.0 }
    }

    /// Beyond its equator a sphere does not touch the surface that it passed.
    fn deepest(&self) -> f64 {
        1.0
    }

    fn elastic_depth(&self, force: f64) -> f64 {
        Paraboloid.elastic_depth(force)
    }
}
