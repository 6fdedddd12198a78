//! The square in which contact is sought.

use super::level::Level;
use super::profile::Profile;
use crate::surface::grid::SurfaceGrid;
use crate::unilateral::Loading;

/// Free cells wanted on each side of the contact, as a fraction of the domain's side.
const MARGIN: f64 = 0.09;
/// A domain is good when the contact spans this part of it.
const FILLED: f64 = 0.72;

/// A square domain; lengths in R.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Domain {
    /// Its centre.
    pub centre: [f64; 2],
    /// Half its side.
    pub half_width: f64,
}

impl Domain {
    /// The square in which the undeformed indenter lies below the undeformed surface; contact is smaller.
    ///
    /// Under an imposed force the depth is that of the rubbery contact, which is the deepest.
    #[must_use]
    pub fn overlap(profile: &dyn Profile, loading: Loading) -> Self {
        let depth = match loading {
            Loading::Indentation(depth) => depth,
            Loading::Load(force) => profile.elastic_depth(force),
        };
        Self { centre: [0.0, 0.0], half_width: 1.02 * profile.extent(depth) }
    }

    /// The domain as a grid.
    #[must_use]
    pub fn grid(&self, side: usize) -> SurfaceGrid {
        SurfaceGrid::square(side, self.centre, self.half_width)
    }

    /// The domain as one row of strips, for a line contact.
    #[must_use]
    pub fn strips(&self, side: usize) -> SurfaceGrid {
        let square = self.grid(side);
        SurfaceGrid { rows: 1, origin: [square.origin[0], -0.5 * square.cell], ..square }
    }

    /// A domain that the contact fills better, or `None` when it fills this one well.
    #[must_use]
    pub fn fitted(&self, level: &Level) -> Option<Self> {
        let [left, right, top, bottom] = level.bounds()?;
        let half = 0.5 * (right - left).max(bottom - top);
        if level.touches_edge() {
            return Some(Self { half_width: 1.5 * self.half_width, ..*self });
        }
        if half > FILLED * self.half_width {
            return None;
        }
        // A contact of few cells is known only to within them.
        let half_width = (half + level.grid.cell) / (1.0 - 2.0 * MARGIN);
        Some(Self { centre: [0.5 * (left + right), 0.5 * (top + bottom)], half_width })
    }

    /// Half the side of a domain about this one's centre that holds another.
    #[must_use]
    pub fn half_width_around(&self, other: &Self) -> f64 {
        let off = |axis: usize| (other.centre[axis] - self.centre[axis]).abs();
        off(0).max(off(1)) + other.half_width
    }
}
