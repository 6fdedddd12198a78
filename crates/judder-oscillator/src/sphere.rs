//! The sphere on its substrate in SI units: what presses it off and drags it along, whatever carries it.

use crate::Contact;
use crate::friction::friction_force;
use crate::groups::Coefficients;
use judder_contact::{ContactLaw, ContactResponse, LawPoint, WithDerivatives};

/// A sphere that slides on a substrate.
#[derive(Debug, Clone, PartialEq)]
pub struct SlidingSphere {
    /// Its contact.
    pub contact: Contact,
    /// E0* = E0/(1 − ν²), in Pa.
    pub reduced_modulus: f64,
    /// R, in m.
    pub radius: f64,
    /// τ, the retardation (creep) time, in s.
    pub retardation_time: f64,
    /// F̃_n = F_n/(E0* R²), which (5) as printed multiplies by μ_visc.
    pub normal_load: f64,
    /// τ̃0 = τ0/E0*.
    pub shear_strength: f64,
}

/// A force with its slopes.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct SphereForce {
    /// In N.
    pub value: f64,
    /// By the depth, in N/m.
    pub by_depth: f64,
    /// By the magnitude of the sliding speed, in N s/m.
    pub by_speed: f64,
}

/// What acts on a sphere.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct SphereForces {
    /// F_k, off the substrate.
    pub normal: SphereForce,
    /// |F_μ| of (5), along the motion of the substrate.
    pub friction: SphereForce,
}

impl SlidingSphere {
    /// v̂ = v τ/R at a speed in m/s.
    #[must_use]
    pub fn velocity(&self, speed: f64) -> f64 {
        speed * self.retardation_time / self.radius
    }

    /// What the law gives at a depth in m and a sliding speed in m/s.
    #[must_use]
    pub fn response(&self, depth: f64, speed: f64) -> ContactResponse {
        self.contact.law.evaluate(&LawPoint::new(self.velocity(speed), depth / self.radius))
    }

    /// F_k = E0* R² F̃_k and |F_μ| = E0* R² |F̃_μ| at a depth in m and a sliding speed in m/s, with all four slopes; nothing in the air.
    #[must_use]
    pub fn forces(&self, depth: f64, speed: f64) -> SphereForces {
        if depth <= 0.0 {
            return SphereForces::default();
        }
        let response = self.response(depth, speed);
        let Self { normal_load, shear_strength, .. } = *self;
        let loads = Coefficients { normal_load, shear_strength, ..Coefficients::default() };
        let friction = friction_force(self.contact.friction_load, &loads, &response);
        SphereForces { normal: self.in_newtons(&response.force), friction: self.in_newtons(&friction) }
    }

    fn in_newtons(&self, group: &WithDerivatives) -> SphereForce {
        let per_radius = self.reduced_modulus * self.radius;
        SphereForce {
            value: per_radius * self.radius * group.value,
            by_depth: per_radius * group.by_indentation,
            by_speed: per_radius * self.retardation_time * group.by_velocity,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::FrictionLoad;
    use judder_contact::{FittedLaw, Law};

    fn sphere(friction_load: FrictionLoad) -> SlidingSphere {
        SlidingSphere {
            contact: Contact { law: Law::Fitted(FittedLaw::oscillator_paper()), friction_load },
            reduced_modulus: 4e6 / 3.0,
            radius: 0.01,
            retardation_time: 0.01,
            normal_load: 1e-4,
            shear_strength: 0.03,
        }
    }

    #[test]
    fn slopes_are_those_of_differences() {
        for load in [FrictionLoad::NormalLoad, FrictionLoad::ContactForce] {
            let (sphere, depth, speed) = (sphere(load), 2e-5, 3e-3);
            let here = sphere.forces(depth, speed);
            let (h, k) = (1e-5 * depth, 1e-5 * speed);
            let along = |pick: fn(&SphereForces) -> f64| {
                let [deep, shallow] = [h, -h].map(|h| pick(&sphere.forces(depth + h, speed)));
                let [fast, slow] = [k, -k].map(|k| pick(&sphere.forces(depth, speed + k)));
                [(deep - shallow) / (2.0 * h), (fast - slow) / (2.0 * k)]
            };
            let pairs = [
                (along(|own| own.normal.value), [here.normal.by_depth, here.normal.by_speed]),
                (along(|own| own.friction.value), [here.friction.by_depth, here.friction.by_speed]),
            ];
            for (difference, slope) in pairs.iter().flat_map(|(a, b)| a.iter().zip(b)) {
                assert!((difference / slope - 1.0).abs() < 1e-7, "{load:?}: {difference} {slope}");
            }
        }
    }

    #[test]
    fn in_the_air_nothing_acts() {
        let forces = sphere(FrictionLoad::NormalLoad).forces(-1e-6, 0.1);
        assert_eq!(forces, SphereForces::default());
    }
}
