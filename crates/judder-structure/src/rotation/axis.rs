//! About which axis a body turns, how fast, and in which frame that is seen.

/// Turning about an axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rotation {
    /// ω in rad/s, along the axis.
    pub angular_velocity: [f64; 3],
    /// A place of the axis, in m.
    pub centre: [f64; 3],
}

/// Along which axes, and where, the displacements of a body that turns are taken.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "keys", derive(judder_keys::Choice), choice(what = "frame"))]
pub enum RotatingFrame {
    /// The frame that stands still, in which a body of revolution turns within its own shape.
    ///
    /// What touches the body stands still there.
    Fixed,
    /// The frame that turns with the body, of any shape.
    Rotating,
}

impl Rotation {
    /// ω × (x − centre), in m/s.
    #[must_use]
    pub fn velocity(&self, place: [f64; 3]) -> [f64; 3] {
        let spin = self.spin();
        let from: [f64; 3] = std::array::from_fn(|k| place[k] - self.centre[k]);
        std::array::from_fn(|i| (0..3).map(|j| spin[i][j] * from[j]).sum())
    }

    /// (ω² − ω ω·)(x − centre) in m/s², the centrifugal acceleration.
    #[must_use]
    pub fn outward(&self, place: [f64; 3]) -> [f64; 3] {
        let across = self.across();
        let from: [f64; 3] = std::array::from_fn(|k| place[k] - self.centre[k]);
        std::array::from_fn(|i| (0..3).map(|j| across[i][j] * from[j]).sum())
    }

    /// ω× as a matrix.
    pub(crate) fn spin(&self) -> [[f64; 3]; 3] {
        let [x, y, z] = self.angular_velocity;
        [[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]]
    }

    /// ω² − ω ω·.
    pub(crate) fn across(&self) -> [[f64; 3]; 3] {
        let spin = self.spin();
        std::array::from_fn(|i| {
            std::array::from_fn(|j| -(0..3).map(|k| spin[i][k] * spin[k][j]).sum::<f64>())
        })
    }
}
