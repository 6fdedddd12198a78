//! The mechanical energy of a motion about steady sliding, and how it falls.

use crate::NonsmoothError;
use crate::march::NonsmoothMarch;
use judder_assembly::assembly::Assembly;
use judder_assembly::interface::InterfaceLaw;
use judder_assembly::pressure::Pressure;
use judder_assembly::steady::SteadySliding;

/// The mechanical energy of a motion about steady sliding, as far as it is known before the motion.
///
/// E = ½ vᵀ M v + ½ δqᵀ K δq + Σ ∫ (N_p − N(g)) dg over the contact points in J, with the displacements δq and the gaps g about steady sliding, at which
/// E = 0, and the symmetric part of K. N is that of a pressure or a table of forces; of an asperity that of its slope in steady sliding as far as it presses.
#[derive(Debug, Clone, PartialEq)]
pub struct EnergyAboutSliding {
    /// Steady sliding, on the coordinates of the march.
    place: Vec<f64>,
    points: Vec<PressedPoint>,
}

/// A contact point in steady sliding.
#[derive(Debug, Clone, PartialEq)]
struct PressedPoint {
    /// N_p in N.
    force: f64,
    /// −dN/dg there in N/m; infinite of a rigid point.
    stiffness: f64,
    gap: f64,
    /// Whether it pulls where it is open.
    stays_closed: bool,
    /// A law that bends, and what its energy is multiplied by.
    bent: Option<(Pressure, f64)>,
}

impl PressedPoint {
    /// ∫ (N_p − N(g)) dg from steady sliding to a gap; of a law that does not bend with the slope there as far as the point presses, and none beyond.
    fn potential(&self, gap: f64) -> f64 {
        if let Some((law, area)) = &self.bent {
            return area * law.excess_energy([-self.gap, -gap], self.stays_closed);
        }
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
    ///
    /// # Errors
    /// [`NonsmoothError::Assembly`] for contact points without a frame.
    pub fn new(
        assembly: &Assembly,
        steady: &SteadySliding,
        march: &NonsmoothMarch<'_>,
    ) -> Result<Self, NonsmoothError> {
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
            bent: match point.law {
                InterfaceLaw::Compliant(law, _) if law.bends() && state.is_closed => {
                    let area = if law.is_of_points() { 1.0 } else { point.point.area };
                    Some((law.clone(), area))
                }
                _ => None,
            },
        });
        Ok(Self { place: march.place().to_vec(), points: points.collect() })
    }

    /// In J, as the march is.
    #[must_use]
    pub fn of(&self, march: &NonsmoothMarch<'_>) -> f64 {
        let bodies = march.energy_about(&self.place);
        let contacts = self.points.iter().enumerate().map(|(k, own)| own.potential(march.gap(k)));
        bodies.kinetic + bodies.potential + contacts.sum::<f64>()
    }
}

/// The windows into which a motion is parted, and the standard errors by which its energy may fall faster than their means do.
const WINDOWS: usize = 16;
const FALL_ERRORS: f64 = 3.0;

/// Mean energies of a motion over windows of equal length, to tell how its energy falls whatever it swings by within them.
#[derive(Debug, Clone, PartialEq)]
pub struct EnergyWindows {
    sums: [f64; WINDOWS],
    counts: [u64; WINDOWS],
    steps: u64,
}

impl EnergyWindows {
    /// Windows into which so many steps are parted.
    #[must_use]
    pub fn new(steps: u64) -> Self {
        Self { sums: [0.0; WINDOWS], counts: [0; WINDOWS], steps }
    }

    /// How many steps there are.
    #[must_use]
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// Takes the energy in J after a step, counted from 0; steps beyond the last fall into its window.
    pub fn add(&mut self, step: u64, energy: f64) {
        let window = (u128::from(step) * WINDOWS as u128 / u128::from(self.steps.max(1))) as usize;
        let window = window.min(WINDOWS - 1);
        self.sums[window] += energy;
        self.counts[window] += 1;
    }

    /// The means over both halves, in J; zero of one without steps.
    #[must_use]
    pub fn halves(&self) -> [f64; 2] {
        [0..WINDOWS / 2, WINDOWS / 2..WINDOWS].map(|half| {
            let count: u64 = self.counts[half.clone()].iter().sum();
            self.sums[half].iter().sum::<f64>() / count.max(1) as f64
        })
    }

    /// The fastest fall of the energy that its means allow for, of itself a step: by least squares of their logarithms, with three standard errors of the slope;
    /// none where one of them is zero or a window is empty.
    #[must_use]
    pub fn fastest_fall(&self) -> Option<f64> {
        let logarithms: Vec<f64> =
            self.sums.iter().zip(self.counts).map(|(sum, count)| libm::log(sum / count as f64)).collect();
        let count = WINDOWS as f64;
        let mean = logarithms.iter().sum::<f64>() / count;
        let place = |k: usize| k as f64 - 0.5 * (count - 1.0);
        let spread: f64 = (0..WINDOWS).map(|k| place(k) * place(k)).sum();
        let slope = logarithms.iter().enumerate().map(|(k, own)| place(k) * own).sum::<f64>() / spread;
        let off = |(k, own): (usize, &f64)| (own - mean - slope * place(k)).powi(2);
        let left = logarithms.iter().enumerate().map(off).sum::<f64>();
        let error = (left / (count - 2.0) / spread).sqrt();
        let fall = (FALL_ERRORS * error - slope) * count / self.steps as f64;
        fall.is_finite().then_some(fall)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use judder_assembly::pressure::CubicPointForce;

    /// N = k d + k₃ d³ pressed by its force at 1 mm: what both polynomials store, less the work of that force.
    #[test]
    fn a_spring_that_bends_has_the_integral_of_its_force() {
        let law = Pressure::PointCubic(CubicPointForce { stiffness: 4.0, cubic_stiffness: 8e6, about: 0.0 });
        let force = law.at(1e-3).value;
        let point = PressedPoint {
            force,
            stiffness: law.at(1e-3).slope,
            gap: -1e-3,
            stays_closed: true,
            bent: Some((law, 1.0)),
        };
        let stored = |d: f64| 2.0 * d * d + 2e6 * d.powi(4);
        for gap in [-3e-3, -1e-3, -0.5e-3, 2e-3] {
            let known = stored(-gap) - stored(1e-3) - force * (-gap - 1e-3);
            assert!((point.potential(gap) - known).abs() < 1e-15, "{gap}");
        }
    }

    /// N = k d pressed by 2 N on 4 N/m lifts off at 0.5 m, from where on the load alone works.
    #[test]
    fn a_point_that_lifts_off_has_the_work_of_its_load() {
        let point = PressedPoint { force: 2.0, stiffness: 4.0, gap: -0.5, stays_closed: false, bent: None };
        for (gap, known) in [(-0.5, 0.0), (-0.75, 0.125), (-0.25, 0.125), (0.0, 0.5), (1.0, 2.5)] {
            assert!((point.potential(gap) - known).abs() < 1e-15, "{gap}");
        }
        let rigid = PressedPoint { stiffness: f64::INFINITY, gap: 0.0, ..point.clone() };
        assert!(rigid.potential(0.25) == 0.5 && rigid.potential(-1e-9) == 0.0);
        let held = PressedPoint { stays_closed: true, ..point };
        assert!((held.potential(0.5) - 2.0).abs() < 1e-15);
    }

    #[test]
    fn windows_tell_how_an_energy_falls() {
        let mut windows = EnergyWindows::new(1600);
        // e falls by 1e-3 of itself a step, and swings
        for step in 0..1600_u64 {
            let at = step as f64;
            windows.add(step, (-1e-3 * at).exp() * (1.0 + 0.1 * (0.7 * at).sin()));
        }
        let fall = windows.fastest_fall().unwrap();
        assert!((fall / 1e-3 - 1.0).abs() < 0.05, "{fall}");
        let [earlier, last] = windows.halves();
        assert!((last / earlier - (-0.8_f64).exp()).abs() < 1e-2);
        assert!(EnergyWindows::new(1600).fastest_fall().is_none());
    }
}
