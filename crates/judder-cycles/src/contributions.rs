//! Of which modes a cycle is made up: shares of the modes of frictionless contact in the kinetic energy of its swing.
//!
//! These modes are orthogonal in the mass, so that their shares are none of each other's and sum to one or less: what is left over is
//! swing that no mode told of has.

use crate::CyclesError;
use crate::cycle::AssemblyCycle;
use faer::c64;
use judder_assembly::linearised::Linearised;
use judder_numerics::order::sort_by_number;
use judder_structure::StructureError;
use judder_structure::assembly::Sparse;
use judder_structure::modes::{Mode, WantedModes, modes};
use judder_structure::statics::product;
use std::f64::consts::TAU;

/// Modes that are told, those with the largest shares.
const TOLD: usize = 20;
/// What harmonics may have of the kinetic energy of the swing above which no mode is sought.
const LITTLE: f64 = 0.01;
/// How far above the last harmonic that matters, and the mode of the cycle, modes are sought.
const BEYOND: f64 = 1.5;
/// What is left over no more than this is rounding.
const ROUNDING: f64 = 1e-12;

/// The modes of frictionless contact in a cycle.
#[derive(Debug, Clone, PartialEq)]
pub struct ModeContributions {
    /// Those with the largest shares, 20 at most, by rising frequency.
    pub modes: Vec<ModeContribution>,
    /// The share of the kinetic energy that they have not.
    pub left_over: f64,
}

/// A mode of frictionless contact in a cycle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ModeContribution {
    /// Its frequency, in Hz.
    pub frequency_hz: f64,
    /// Its share in the kinetic energy of the swing.
    pub share: f64,
}

impl ModeContributions {
    /// Those of a cycle beside a mode of so many rad/s about the steady sliding of `about`; the error of the structure where its modes are not found.
    ///
    /// With φᵀ M φ = 1 and the harmonics X_h of the displacements the share of a mode is Σ h² |φᵀ M X_h|² / Σ h² X_hᴴ M X_h. Modes are sought up to 1.5 times the
    /// last harmonic above which less than 1 % of the energy lies, or that frequency where it is higher.
    ///
    /// # Errors
    /// [`CyclesError::Assembly`] where contact stiffness does not fit the bodies; those of the balance at the cycle.
    pub fn of(
        cycle: &AssemblyCycle<'_>,
        about: &Linearised,
        mode: f64,
    ) -> Result<Result<Self, StructureError>, CyclesError> {
        let swing = CycleSwing::of(cycle, &about.structures[0])?;
        let highest = BEYOND * (swing.matters() as f64 * cycle.frequency()).max(mode);
        let (mass, stiffness) = about.frictionless()?;
        let found = match modes(&stiffness, &mass, WantedModes::Band(0.0, highest / TAU)) {
            Ok(found) => found.modes,
            Err(error) => return Ok(Err(error)),
        };
        let share = |mode: &Mode| ModeContribution {
            frequency_hz: mode.frequency_hz(),
            share: swing.share(&about.expanded_real(&mode.shape)),
        };
        let mut told: Vec<ModeContribution> = found.iter().map(share).collect();
        // stable: of equal shares the lower modes
        sort_by_number(&mut told, |own| -own.share);
        told.truncate(TOLD);
        sort_by_number(&mut told, |own| own.frequency_hz);
        let left_over = 1.0 - told.iter().map(|own| own.share).sum::<f64>();
        let left_over = if left_over > ROUNDING { left_over } else { 0.0 };
        Ok(Ok(Self { modes: told, left_over }))
    }
}

/// Velocities of a cycle at all freedoms, but for the factor ω.
struct CycleSwing {
    /// M h X of each harmonic, real and imaginary parts.
    momenta: Vec<[Vec<f64>; 2]>,
    /// h² Xᴴ M X of each.
    energies: Vec<f64>,
}

impl CycleSwing {
    fn of(cycle: &AssemblyCycle<'_>, mass: &Sparse) -> Result<Self, CyclesError> {
        let (_, harmonics) = cycle.balance.coordinates(&cycle.motion.unknown, cycle.motion.turning)?;
        let bodies = cycle.balance.bodies();
        let velocities = |(harmonic, own): (f64, &Vec<c64>)| {
            [|x: &c64| x.re, |x: &c64| x.im].map(|part: fn(&c64) -> f64| {
                bodies.freedoms(&own.iter().map(|x| harmonic * part(x)).collect::<Vec<f64>>())
            })
        };
        let numbered = (1..).map(f64::from).zip(&harmonics);
        let velocities: Vec<[Vec<f64>; 2]> = numbered.map(velocities).collect();
        let momenta: Vec<_> =
            velocities.iter().map(|own| own.each_ref().map(|part| product(mass, part))).collect();
        let energy = |(velocity, momentum): (&[Vec<f64>; 2], &[Vec<f64>; 2])| -> f64 {
            velocity.iter().zip(momentum).map(|(a, b)| dot(a, b)).sum()
        };
        let energies = velocities.iter().zip(&momenta).map(energy).collect();
        Ok(Self { momenta, energies })
    }

    /// Twice the mean kinetic energy of all harmonics.
    fn energy(&self) -> f64 {
        self.energies.iter().sum()
    }

    /// The last harmonic that matters.
    fn matters(&self) -> usize {
        let mut above = self.energy();
        let little = LITTLE * above;
        let falls = self.energies.iter().position(|own| {
            above -= own;
            above <= little
        });
        falls.map_or(self.energies.len(), |place| place + 1)
    }

    /// The share of a mode with φᵀ M φ = 1.
    fn share(&self, shape: &[f64]) -> f64 {
        let own: f64 = self.momenta.iter().flatten().map(|part| dot(shape, part).powi(2)).sum();
        if own > 0.0 { own / self.energy() } else { 0.0 }
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
