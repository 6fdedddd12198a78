//! Dimensionless groups (section 2.2), to and from quantities with units.

use crate::error::OscillatorError;

/// The dimensionless groups (9), (11) that determine the oscillator; the default is the paper's set (14) at the
/// operating point v̂_d = 1e-4, F̃_n = 1e-6, τ̃0 = 0.01.
///
/// R̃ = R/x0 is not among them: it is k̃_x/F̃_n ([`Groups::radius`]).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Groups {
    /// k̃_x = k_x/(E0* R).
    pub stiffness: f64,
    /// τ̃ = ω_nx τ, with the retardation time τ.
    pub retardation_time: f64,
    /// v̂_d = v_d τ/R.
    pub velocity: f64,
    /// F̃_n = F_n/(E0* R²).
    pub normal_load: f64,
    /// τ̃0 = τ0/E0*.
    pub shear_strength: f64,
    /// ξ_x = c_x/(2 √(k_x m)).
    pub damping_x: f64,
    /// ξ_y = c_y/(2 √(k_y m)).
    pub damping_y: f64,
    /// Ω = ω_ny/ω_nx.
    pub frequency_ratio: f64,
    /// η = ω_nxy/ω_nx.
    pub coupling: f64,
    /// α, the inclination of the coupling spring, in rad.
    pub coupling_angle: f64,
}

impl Default for Groups {
    fn default() -> Self {
        Self {
            stiffness: 0.00375,
            retardation_time: 0.4,
            velocity: 1e-4,
            normal_load: 1e-6,
            shear_strength: 0.01,
            damping_x: 0.01,
            damping_y: 0.01,
            frequency_ratio: 1.0,
            coupling: 1.0,
            coupling_angle: std::f64::consts::FRAC_PI_4,
        }
    }
}

impl Groups {
    /// R̃ = R/x0 = k̃_x/F̃_n, with the reference displacement x0 = F_n/k_x of (10).
    #[must_use]
    pub fn radius(&self) -> f64 {
        self.stiffness / self.normal_load
    }

    /// The numbers of the equations of motion, with the angle resolved; see [`Coefficients`].
    ///
    /// # Errors
    /// [`OscillatorError::InvalidGroup`] names the first group that is not finite or out of its range.
    pub fn coefficients(&self) -> Result<Coefficients, OscillatorError> {
        let positive: fn(f64) -> bool = |v| v.is_finite() && v > 0.0;
        let not_negative: fn(f64) -> bool = |v| v.is_finite() && v >= 0.0;
        let rules = [
            ("stiffness k_x/(E0* R)", self.stiffness, positive, "positive"),
            ("retardation time ω_nx τ", self.retardation_time, positive, "positive"),
            ("velocity v τ/R", self.velocity, positive, "positive"),
            ("normal load F/(E0* R²)", self.normal_load, positive, "positive"),
            ("shear strength τ0/E0*", self.shear_strength, not_negative, "zero or positive"),
            ("damping ξ_x", self.damping_x, not_negative, "zero or positive"),
            ("damping ξ_y", self.damping_y, not_negative, "zero or positive"),
            ("frequency ratio Ω", self.frequency_ratio, not_negative, "zero or positive"),
            ("coupling η", self.coupling, not_negative, "zero or positive"),
            ("coupling angle α", self.coupling_angle, |v| v.is_finite(), "finite"),
        ];
        if let Some((name, value, _, requirement)) =
            rules.into_iter().find(|(_, value, holds, _)| !holds(*value))
        {
            return Err(OscillatorError::InvalidGroup { name, value, requirement });
        }
        Ok(self.resolve())
    }

    /// The coefficients without the checks, for groups that were checked at the ends of a sweep.
    #[must_use]
    pub fn resolve(&self) -> Coefficients {
        let (sine, cosine) = libm::sincos(self.coupling_angle);
        let coupling_squared = self.coupling * self.coupling;
        let (k11, k12) = (1.0 + coupling_squared * cosine * cosine, coupling_squared * sine * cosine);
        Coefficients {
            velocity: self.velocity,
            normal_load: self.normal_load,
            shear_strength: self.shear_strength,
            stiffness: self.stiffness,
            retardation_time: self.retardation_time,
            damping_x: 2.0 * self.damping_x,
            damping_y: 2.0 * self.damping_y * self.frequency_ratio,
            k11,
            k12,
            k22: self.frequency_ratio * self.frequency_ratio + coupling_squared * sine * sine,
            spring: self.frequency_ratio * self.frequency_ratio + coupling_squared * sine * sine / k11,
            coupling_ratio: k12 / k11,
        }
    }

    /// The quantities with units that these groups stand for, given the three scales that the groups do not hold.
    #[must_use]
    pub fn dimensional(&self, scales: &Scales) -> Dimensional {
        let Scales { reduced_modulus, radius, natural_frequency } = *scales;
        let retardation_time = self.retardation_time / natural_frequency;
        Dimensional {
            reduced_modulus,
            radius,
            retardation_time,
            natural_frequency,
            stiffness_x: self.stiffness * reduced_modulus * radius,
            velocity: self.velocity * radius / retardation_time,
            normal_load: self.normal_load * reduced_modulus * radius * radius,
            shear_strength: self.shear_strength * reduced_modulus,
            damping_x: self.damping_x,
            damping_y: self.damping_y,
            frequency_ratio: self.frequency_ratio,
            coupling: self.coupling,
            coupling_angle: self.coupling_angle,
        }
    }
}

/// What is needed beside the groups to go back to quantities with units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scales {
    /// E0* = E0/(1 − ν²), in Pa.
    pub reduced_modulus: f64,
    /// R, in m.
    pub radius: f64,
    /// ω_nx, in rad/s.
    pub natural_frequency: f64,
}

/// The oscillator in SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dimensional {
    /// E0* = E0/(1 − ν²), in Pa.
    pub reduced_modulus: f64,
    /// R, in m.
    pub radius: f64,
    /// τ, the retardation (creep) time, in s.
    pub retardation_time: f64,
    /// ω_nx = √(k_x/m), in rad/s.
    pub natural_frequency: f64,
    /// k_x, in N/m.
    pub stiffness_x: f64,
    /// v_d, in m/s.
    pub velocity: f64,
    /// F_n, in N.
    pub normal_load: f64,
    /// τ0, in Pa.
    pub shear_strength: f64,
    /// ξ_x.
    pub damping_x: f64,
    /// ξ_y.
    pub damping_y: f64,
    /// Ω.
    pub frequency_ratio: f64,
    /// η.
    pub coupling: f64,
    /// α, in rad.
    pub coupling_angle: f64,
}

impl Dimensional {
    /// The dimensionless groups (9), (11).
    #[must_use]
    pub fn groups(&self) -> Groups {
        Groups {
            stiffness: self.stiffness_x / (self.reduced_modulus * self.radius),
            retardation_time: self.natural_frequency * self.retardation_time,
            velocity: self.velocity * self.retardation_time / self.radius,
            normal_load: self.normal_load / (self.reduced_modulus * self.radius * self.radius),
            shear_strength: self.shear_strength / self.reduced_modulus,
            damping_x: self.damping_x,
            damping_y: self.damping_y,
            frequency_ratio: self.frequency_ratio,
            coupling: self.coupling,
            coupling_angle: self.coupling_angle,
        }
    }

    /// The scales that [`Groups::dimensional`] needs to come back here.
    #[must_use]
    pub fn scales(&self) -> Scales {
        Scales {
            reduced_modulus: self.reduced_modulus,
            radius: self.radius,
            natural_frequency: self.natural_frequency,
        }
    }

    /// m = k_x/ω_nx², in kg.
    #[must_use]
    pub fn mass(&self) -> f64 {
        self.stiffness_x / (self.natural_frequency * self.natural_frequency)
    }
}

/// The numbers that stand in (12), (15) and (20), with products and angles resolved: what a solver reads at each point.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Coefficients {
    /// v̂_d.
    pub velocity: f64,
    /// F̃_n.
    pub normal_load: f64,
    /// τ̃0.
    pub shear_strength: f64,
    /// k̃_x.
    pub stiffness: f64,
    /// τ̃.
    pub retardation_time: f64,
    /// 2 ξ_x.
    pub damping_x: f64,
    /// 2 ξ_y Ω; (12) as printed lacks the Ω that the definition (9) of ξ_y brings.
    pub damping_y: f64,
    /// 1 + η² cos² α.
    pub k11: f64,
    /// η² sin α cos α.
    pub k12: f64,
    /// Ω² + η² sin² α, the structure's part of k22.
    pub k22: f64,
    /// k12/k11, the part of a force along x that acts along y when x follows.
    pub coupling_ratio: f64,
    /// k22 − k12²/k11 = Ω² + η² sin² α/(1 + η² cos² α), the spring that is left along y when x follows.
    pub spring: f64,
}

impl Coefficients {
    /// R̃ = k̃_x/F̃_n.
    #[inline(always)]
    #[must_use]
    pub fn radius(&self) -> f64 {
        self.stiffness / self.normal_load
    }

    /// ṽ_d = v̂_d R̃/τ̃, the speed of the substrate in the units of the oscillator's own.
    #[inline(always)]
    #[must_use]
    pub fn belt_velocity(&self) -> f64 {
        self.velocity * self.radius() / self.retardation_time
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Section 2.1 and (14): E0 = 1 MPa, ν = 0.5, R = 10 mm, τ = 10 ms, ω_nx = 40 rad/s, k_x = 50 N/m.
    fn paper() -> Dimensional {
        Groups::default().dimensional(&Scales {
            reduced_modulus: 1e6 / (1.0 - 0.25),
            radius: 0.01,
            natural_frequency: 40.0,
        })
    }

    #[test]
    fn the_papers_groups_come_from_its_quantities() {
        let d = paper();
        assert!((d.stiffness_x - 50.0).abs() < 1e-12);
        assert!((d.retardation_time - 0.01).abs() < 1e-16);
        assert!((d.mass() - 50.0 / 1600.0).abs() < 1e-15);
    }

    #[test]
    fn there_and_back() {
        let groups = Groups { velocity: 3.7e-5, coupling_angle: 0.3, damping_y: 0.02, ..Groups::default() };
        let d = groups.dimensional(&paper().scales());
        let back = d.groups();
        assert!((back.velocity / groups.velocity - 1.0).abs() < 1e-15);
        assert!((back.normal_load / groups.normal_load - 1.0).abs() < 1e-15);
        assert_eq!(back.coupling_angle, groups.coupling_angle);
    }

    #[test]
    fn a_group_out_of_range_is_named() {
        let error = Groups { stiffness: -1.0, ..Groups::default() }.coefficients().unwrap_err();
        assert_eq!(error.to_string(), "stiffness k_x/(E0* R) = -1 must be positive");
        assert!(Groups { velocity: f64::NAN, ..Groups::default() }.coefficients().is_err());
    }

    #[test]
    fn damping_in_y_carries_the_frequency_ratio() {
        let c = Groups { frequency_ratio: 3.0, damping_y: 0.02, ..Groups::default() }.coefficients().unwrap();
        assert!((c.damping_y - 0.12).abs() < 1e-16);
    }
}
