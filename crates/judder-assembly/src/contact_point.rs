//! Contact points: where the slider meets the track, and how their displacements beside each other follow from the freedoms.

use crate::AssemblyError;
use crate::row::Row;
use crate::vector::{Vector, along, cross, dot, length, unit};

/// A place on the slider and its partner on the track.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactPoint {
    /// Where it lies on the slider, in m.
    pub place: Vector,
    /// n, out of the track towards the slider, of length one.
    pub normal: Vector,
    /// V, the velocity of the track beside the slider at this place, in m/s.
    pub velocity: Vector,
    /// a, the tributary area in m².
    pub area: f64,
    /// g₀, the gap of the undeformed bodies in m.
    pub gap: f64,
    /// u_slider − Σ w_k u_k along x, y and z, as forms on the freedoms of the assembly; in the plane the third is empty.
    pub relative: [Row; 3],
}

/// The forms of a contact point in its own directions.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactFrame {
    /// c = n·(u_slider − Σ w u): what the gap gains, the compatibility row.
    pub normal: Row,
    /// t·(u_slider − Σ w u) with t = P V/|P V|: the direction in which friction drags the slider in steady sliding.
    pub slip: Row,
    /// (n × t)·(u_slider − Σ w u), across the slip; empty in the plane.
    pub across: Row,
    /// |P V|, the slip speed of steady sliding in m/s.
    pub speed: f64,
}

impl ContactPoint {
    /// P V, the slip velocity of steady sliding: V without its part along the normal.
    #[must_use]
    pub fn slip_velocity(&self) -> Vector {
        along(self.velocity, -dot(self.velocity, self.normal), self.normal)
    }

    /// |P V|, the slip speed of steady sliding in m/s.
    #[must_use]
    pub fn slip_speed(&self) -> f64 {
        length(self.slip_velocity())
    }

    /// Its forms along the normal, along the slip and across it.
    ///
    /// # Errors
    /// [`AssemblyError::NoSlip`] where the track does not move along the contact.
    pub fn frame(&self, interface: &str) -> Result<ContactFrame, AssemblyError> {
        let slip = self.slip_velocity();
        // what is left of a velocity along the normal is rounding
        let is_moving = length(slip) > 1e-9 * length(self.velocity);
        let tangent = unit(slip).filter(|_| is_moving).ok_or_else(|| AssemblyError::NoSlip {
            interface: interface.to_owned(),
            place: self.place,
            velocity: self.velocity,
            normal: self.normal,
        })?;
        Ok(ContactFrame {
            normal: self.form(self.normal),
            slip: self.form(tangent),
            across: self.form(cross(self.normal, tangent)),
            speed: length(slip),
        })
    }

    /// a·(u_slider − Σ w u) of a direction a.
    #[must_use]
    pub fn form(&self, direction: Vector) -> Row {
        Row::sum(direction.into_iter().zip(&self.relative))
    }
}
