//! Where a motion begins.

use super::field::PlaceExpression;
use super::settings::AssemblyStart;
use crate::assembly::AssemblySubject;
use crate::assembly::eigen::lowest;
use crate::error::ModelError;
use judder_assembly::linearised::{Linearised, LinearisedTerms};
use judder_assembly::steady::SteadySliding;
use judder_numerics::complex::ElementaryComplex;
use num_complex::Complex64;

/// Displacements and velocities on the freedoms of an assembly.
pub(in crate::assembly) struct MotionState {
    pub(in crate::assembly) displacement: Vec<f64>,
    pub(in crate::assembly) velocity: Vec<f64>,
}

impl MotionState {
    /// Steady sliding with the values that a course starts with, the second, and what the start adds to it, modes about that with the case's own values, the first;
    /// velocities are those of a time `back` before, in s.
    pub(in crate::assembly) fn new(
        of: &AssemblySubject<'_>,
        [steady, first]: [&SteadySliding; 2],
        start: Option<&AssemblyStart>,
        back: f64,
    ) -> Result<Self, ModelError> {
        let mut state =
            Self { displacement: first.displacement.clone(), velocity: vec![0.0; first.displacement.len()] };
        match start {
            Some(AssemblyStart { velocity: Some(field), .. }) => {
                state.velocity = of.built.on_freedoms(&|place| values(field, place))?;
            }
            Some(AssemblyStart { mode: Some(number), amplitude: Some(amplitude), .. }) => {
                state.disturb(of, steady, *number, *amplitude, back)?;
            }
            _ => {}
        }
        Ok(state)
    }

    /// Adds a complex mode whose largest displacement is so large, with the velocities of a time `back` before.
    fn disturb(
        &mut self,
        of: &AssemblySubject<'_>,
        steady: &SteadySliding,
        number: usize,
        amplitude: f64,
        back: f64,
    ) -> Result<(), ModelError> {
        let about = Linearised::new(&of.built.assembly, steady, LinearisedTerms::default())?;
        let (_, found) = lowest(&about, number)?;
        let Some(mode) = found.modes.get(number - 1) else {
            let known = found.modes.len();
            return Err(ModelError::Unsupported(format!(
                "there is no mode {number} to start with: {known} were found"
            )));
        };
        let shape = about.expanded(&mode.right);
        let moved = of.built.expanded(&shape);
        let largest = moved.iter().map(|own| own.modulus()).fold(0.0, f64::max);
        let factor = Complex64::from(amplitude / largest);
        for (k, own) in shape.iter().enumerate() {
            self.displacement[k] += (factor * own).re;
            let value = mode.eigenvalue.value;
            self.velocity[k] += (factor * value * (-value * back).exponential() * own).re;
        }
        Ok(())
    }
}

fn values(field: &[PlaceExpression], place: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|k| field.get(k).map_or(0.0, |own| own.at(place)))
}
