//! The mechanical energy of a motion about steady sliding.

use crate::error::ModelError;
use judder_assembly::assembly::Assembly;
use judder_assembly::interface::InterfaceLaw;
use judder_assembly::steady::SteadySliding;
use judder_nonsmooth::march::NonsmoothMarch;

/// What is known of it before the motion: E = ½ vᵀ M v + ½ δqᵀ K δq + Σ ∫ (N_p − N(g)) dg over the contact points, with δq and g about steady sliding, at which E = 0.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct EnergyAboutSliding {
    /// Steady sliding, on the coordinates of the march.
    place: Vec<f64>,
    points: Vec<PressedPoint>,
}

/// A contact point in steady sliding.
#[derive(Debug, Clone, Copy, PartialEq)]
struct PressedPoint {
    /// N_p in N.
    force: f64,
    /// −dN/dg there in N/m; infinite of a rigid point.
    stiffness: f64,
    gap: f64,
    /// Whether it pulls where it is open.
    stays_closed: bool,
}

impl PressedPoint {
    /// ∫ (N_p − N(g)) dg from steady sliding to a gap, with the slope of the law there as far as the point presses, and none beyond.
    fn potential(&self, gap: f64) -> f64 {
        let opened = gap - self.gap;
        // where the force has fallen to nothing
        let lifted = if self.stiffness > 0.0 { self.force / self.stiffness } else { f64::INFINITY };
        match self.stiffness.is_finite() {
            false if self.stays_closed => 0.0,
            _ if !self.stays_closed && opened > lifted => self.force * (opened - 0.5 * lifted),
            // rounding and what a step leaves of a rigid gap
            false => 0.0,
            true => 0.5 * self.stiffness * opened * opened,
        }
    }
}

impl EnergyAboutSliding {
    /// Of a march that stands in steady sliding.
    pub(super) fn new(
        assembly: &Assembly,
        steady: &SteadySliding,
        march: &NonsmoothMarch<'_>,
    ) -> Result<Self, ModelError> {
        let framed = assembly.framed()?;
        let points = framed.iter().zip(&steady.points).map(|(point, state)| PressedPoint {
            force: state.normal_force.max(0.0),
            stiffness: match point.law {
                _ if !state.is_closed => 0.0,
                InterfaceLaw::Rigid(_) => f64::INFINITY,
                _ => point.forces_at(state.gap - point.point.gap).normal.by_closure,
            },
            gap: state.gap,
            stays_closed: point.stays_closed,
        });
        Ok(Self { place: march.place().to_vec(), points: points.collect() })
    }

    /// In J, as the march is.
    pub(super) fn of(&self, march: &NonsmoothMarch<'_>) -> f64 {
        let bodies = march.energy_about(&self.place);
        let contacts = self.points.iter().enumerate().map(|(k, own)| own.potential(march.gap(k)));
        bodies.kinetic + bodies.potential + contacts.sum::<f64>()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// N = k d pressed by 2 N on 4 N/m lifts off at 0.5 m, from where on the load alone works.
    #[test]
    fn a_point_that_lifts_off_has_the_work_of_its_load() {
        let point = PressedPoint { force: 2.0, stiffness: 4.0, gap: -0.5, stays_closed: false };
        for (gap, known) in [(-0.5, 0.0), (-0.75, 0.125), (-0.25, 0.125), (0.0, 0.5), (1.0, 2.5)] {
            assert!((point.potential(gap) - known).abs() < 1e-15, "{gap}");
        }
        let rigid = PressedPoint { stiffness: f64::INFINITY, gap: 0.0, ..point };
        assert!(rigid.potential(0.25) == 0.5 && rigid.potential(-1e-9) == 0.0);
        let held = PressedPoint { stays_closed: true, ..point };
        assert!((held.potential(0.5) - 2.0).abs() < 1e-15);
    }
}
