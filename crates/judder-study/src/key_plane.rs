//! The plane of any two keys of an oscillator case: what a stability map is decided on.

use crate::analyses::SteadyState;
use crate::bridge;
use crate::error::StudyError;
use crate::progress::Progress;
use judder_case::{Form, OscillatorInputs, OscillatorKey, Value};
use judder_oscillator::map::{
    AdaptiveMap, CoefficientPlane, Method, Plane, StabilityMap, SweptCoefficient, every_point,
};
use judder_oscillator::spectrum::{eigenvalues, growth_rate};
use judder_oscillator::{Coefficients, Contact};
use rayon::prelude::*;
use std::time::Instant;

/// A key with the values that it takes along one side of a plane.
#[derive(Debug, Clone, PartialEq)]
pub struct KeyAxis {
    /// The key.
    pub key: OscillatorKey,
    /// Whether the values are groups or in SI units.
    pub form: Form,
    /// The values.
    pub values: Vec<f64>,
}

impl KeyAxis {
    fn set(&self, inputs: &mut OscillatorInputs, index: usize) {
        inputs.set(self.key, Value { number: self.values[index], form: self.form });
    }

    /// The coefficient that the key sets directly, if it is one.
    fn coefficient(&self) -> Option<SweptCoefficient> {
        match (self.key, self.form) {
            (OscillatorKey::Velocity, Form::Group) => Some(SweptCoefficient::Velocity),
            (OscillatorKey::NormalLoad, Form::Group) => Some(SweptCoefficient::NormalLoad),
            (OscillatorKey::ShearStrength, Form::Group) => Some(SweptCoefficient::ShearStrength),
            _ => None,
        }
    }
}

/// The operating points over two keys: columns along `x`, rows along `y`. The groups are resolved at every point.
#[derive(Debug, Clone, PartialEq)]
pub struct KeyPlane {
    /// The values of all other keys.
    pub inputs: OscillatorInputs,
    /// What the columns vary.
    pub x: KeyAxis,
    /// What the rows vary.
    pub y: KeyAxis,
}

impl Plane for KeyPlane {
    fn columns(&self) -> usize {
        self.x.values.len()
    }

    fn rows(&self) -> usize {
        self.y.values.len()
    }

    fn coefficients(&self, column: usize, row: usize) -> Coefficients {
        bridge::coefficients(&self.inputs(column, row))
    }
}

impl KeyPlane {
    /// The operating point of a column and a row.
    #[must_use]
    pub fn inputs(&self, column: usize, row: usize) -> OscillatorInputs {
        let mut inputs = self.inputs;
        self.x.set(&mut inputs, column);
        self.y.set(&mut inputs, row);
        inputs
    }

    /// The map, by the short way where both keys are coefficients, and the seconds that its decisions took.
    #[must_use]
    pub fn decide(&self, contact: &Contact, method: Method) -> (StabilityMap, f64) {
        let short = (self.x.coefficient()).zip(self.y.coefficient());
        let Some((x, y)) = short.filter(|_| self.columns() * self.rows() > 0) else {
            return timed(contact, self, method);
        };
        let base = bridge::coefficients(&self.inputs(0, 0));
        let (x, y) = ((x, self.x.values.clone()), (y, self.y.values.clone()));
        timed(contact, &CoefficientPlane { base, x, y }, method)
    }

    /// The growth rate at every point in units of ω_nx, row by row; NaN where there is no equilibrium.
    ///
    /// # Errors
    /// [`StudyError::Interrupted`].
    pub fn growth_rates(&self, contact: &Contact, progress: &dyn Progress) -> Result<Vec<f64>, StudyError> {
        let at = |column: usize, row: usize| {
            let state = SteadyState::new(contact, &self.inputs(column, row)).ok()?;
            let system = state.linearisation.system().reduced().ok()?;
            Some(growth_rate(&eigenvalues(&system).ok()?))
        };
        let mut rates = vec![f64::NAN; self.columns() * self.rows()];
        rates.par_chunks_mut(self.columns().max(1)).enumerate().try_for_each(|(row, rates)| {
            if progress.interrupted() {
                return Err(StudyError::Interrupted);
            }
            for (column, rate) in rates.iter_mut().enumerate() {
                *rate = at(column, row).unwrap_or(f64::NAN);
            }
            progress.advance();
            Ok(())
        })?;
        Ok(rates)
    }
}

/// The map of a plane and the seconds that its decisions took, without the start of the threads and the layout of the memory.
fn timed<P: Plane>(contact: &Contact, plane: &P, method: Method) -> (StabilityMap, f64) {
    rayon::broadcast(|_| ());
    let layout = (method == Method::Adaptive).then(|| AdaptiveMap::new(contact, plane));
    let start = Instant::now();
    let map = layout.map_or_else(|| every_point(contact, plane), AdaptiveMap::decide);
    (map, start.elapsed().as_secs_f64())
}
