//! Where the energy of a periodic motion comes from and goes to.
//!
//! Over a period the bodies keep what they have: what friction and normal forces give, ⟨λᵀ P ẋ⟩ with the forces of the contact laws at instants, and forces that drive,
//! ½ Σ Re ẋ_hᴴ f_h, is what their damping takes, ½ Σ (h ω)² x_hᴴ C x_h, and stiffness that is not symmetric gives.

use crate::CyclesError;
use crate::backbone::PeriodicMotion;
use crate::balance::HarmonicBalance;
use crate::cycle::{AssemblyCycle, PointsOverPeriod};
use crate::series::Series;
use faer::{Mat, c64};

/// What goes into the bodies over a period, on average, in W.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct CyclePower {
    /// From friction.
    pub friction: f64,
    /// From normal forces: none where they hold no energy and lose none.
    pub normal: f64,
    /// From damping: what it takes is negative.
    pub damping: f64,
    /// From stiffness that is not symmetric.
    pub circulation: f64,
    /// What becomes heat where bodies slide, −⟨T v⟩.
    pub heat: f64,
    /// From forces that drive: none in a limit cycle.
    pub driving: f64,
    /// What contacts and bodies exchange to and fro, Σ ⟨|λ − ⟨λ⟩| |P ẋ|⟩, and what drives gives: the size of what the balance is made of.
    pub exchanged: f64,
}

impl CyclePower {
    /// What is left of the balance, over what is exchanged.
    #[must_use]
    pub fn imbalance(&self) -> f64 {
        let left = self.friction + self.normal + self.damping + self.circulation + self.driving;
        left.abs() / self.exchanged.max(f64::MIN_POSITIVE)
    }
}

impl AssemblyCycle<'_> {
    /// What goes into the bodies, with the forces of the contact laws at so many instants of a period.
    ///
    /// # Errors
    /// [`CyclesError::Singular`].
    pub fn power(&self, instants: usize) -> Result<CyclePower, CyclesError> {
        power(&self.balance, &self.motion, instants)
    }
}

/// The same of any periodic motion.
///
/// # Errors
/// [`CyclesError::Singular`].
pub fn power(
    balance: &HarmonicBalance<'_>,
    motion: &PeriodicMotion,
    instants: usize,
) -> Result<CyclePower, CyclesError> {
    let bodies = balance.bodies();
    let (_, harmonics) = balance.coordinates(&motion.unknown, motion.turning)?;
    let (components, dimension) = (balance.components(), balance.contact().dimension);
    let series = Series::new(harmonics.len(), instants);
    let mut velocities = Mat::zeros(series.coefficients(), components);
    let mut power = CyclePower::default();
    for (k, x) in harmonics.iter().enumerate() {
        let turning = c64::new(0.0, (k + 1) as f64 * motion.turning.frequency);
        for component in 0..components {
            let own = turning * bodies.displaced(component, x);
            (velocities[(2 * k + 1, component)], velocities[(2 * k + 2, component)]) = (own.re, -own.im);
        }
        let velocity: Vec<c64> = x.iter().map(|own| turning * own).collect();
        let [damping, circulation] = bodies.power(x, &velocity);
        power.damping += damping;
        power.circulation += circulation;
        if let Some(force) = balance.forcing(k + 1) {
            power.driving +=
                0.5 * force.iter().zip(&velocity).map(|(force, own)| (force * own.conj()).re).sum::<f64>();
        }
    }
    let velocities = series.values(velocities.as_ref());
    let over = PointsOverPeriod::of(balance, motion, instants)?;
    let instants = series.samples() as f64;
    for component in 0..components {
        let force = over.forces.col_as_slice(component);
        let mean_of =
            |of: &[f64]| force.iter().zip(of).map(|(force, own)| force * own).sum::<f64>() / instants;
        let (velocity, slip) = (velocities.col_as_slice(component), over.motions.col_as_slice(component));
        if component.is_multiple_of(dimension) {
            power.normal += mean_of(velocity);
        } else {
            power.friction += mean_of(velocity);
            power.heat -= mean_of(slip);
        }
        let mean = force.iter().sum::<f64>() / instants;
        let exchanged = force.iter().zip(velocity).map(|(force, own)| ((force - mean) * own).abs());
        power.exchanged += exchanged.sum::<f64>() / instants;
    }
    power.exchanged += power.driving.abs();
    Ok(power)
}
