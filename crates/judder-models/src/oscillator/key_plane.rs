//! The plane of any two keys of an oscillator case: what a stability map is decided on.

use crate::bridge;
use crate::error::ModelError;
use crate::oscillator::inputs::OscillatorInputs;
use crate::oscillator::keys::OscillatorKey;
use crate::oscillator::steady_states::SteadyState;
use judder_keys::keys::Keys;
use judder_keys::numeric_key::{Form, Value};
use judder_oscillator::map::{
    AdaptiveMap, CoarseMap, CoefficientPlane, DecisionMethod, OperatingPlane, StabilityMap, SweptCoefficient,
    every_point, within_law,
};
use judder_oscillator::spectrum::{eigenvalues, growth_rate};
use judder_oscillator::{Coefficients, Contact};
use judder_study::Progress;
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
    /// Sets the key to one of its values.
    pub fn set(&self, inputs: &mut OscillatorInputs, index: usize) {
        inputs.set(self.key, Value { number: self.values[index], form: self.form });
    }

    /// The unit of the values: `1` of groups.
    #[must_use]
    pub fn units(&self) -> String {
        match self.form {
            Form::Group => "1".to_owned(),
            Form::Si => self.key.entry().rule.dimension.unit(),
        }
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

impl OperatingPlane for KeyPlane {
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
    pub fn decide(&self, contact: &Contact, method: DecisionMethod) -> (StabilityMap, f64) {
        match self.as_coefficients() {
            Some(plane) => timed(contact, &plane, method),
            None => timed(contact, self, method),
        }
    }

    /// The adaptive map, that of [`decide`](Self::decide) to the bit, in two stages: `show` is handed the coarse grid as soon as it is
    /// decided. `interrupted` is asked before each batch of decisions; `None` where it said so.
    #[must_use]
    pub fn decide_in_stages(
        &self,
        contact: &Contact,
        show: &mut dyn FnMut(CoarseMap),
        interrupted: &(dyn Fn() -> bool + Sync),
    ) -> Option<StabilityMap> {
        match self.as_coefficients() {
            Some(plane) => in_stages(contact, &plane, show, interrupted),
            None => in_stages(contact, self, show, interrupted),
        }
    }

    /// The short way: the same plane over coefficients, where both keys set one directly.
    fn as_coefficients(&self) -> Option<CoefficientPlane> {
        let (x, y) = (self.x.coefficient()?, self.y.coefficient()?);
        if self.columns() * self.rows() == 0 {
            return None;
        }
        let base = bridge::coefficients(&self.inputs(0, 0));
        Some(CoefficientPlane { base, x: (x, self.x.values.clone()), y: (y, self.y.values.clone()) })
    }

    /// What the errors of the law leave of the verdicts of a map of this plane: codes of [`LawStanding`](judder_oscillator::map::LawStanding), row by row.
    /// `None` where `interrupted` said so.
    #[must_use]
    pub fn within_law(
        &self,
        contact: &Contact,
        map: &StabilityMap,
        method: DecisionMethod,
        interrupted: &(dyn Fn() -> bool + Sync),
    ) -> Option<Vec<u8>> {
        within_law(contact, self, map, method, interrupted)
    }

    /// The growth rate at every point in units of ω_nx, row by row; NaN where there is no equilibrium.
    ///
    /// # Errors
    /// [`ModelError::Interrupted`].
    pub fn growth_rates(&self, contact: &Contact, progress: &dyn Progress) -> Result<Vec<f64>, ModelError> {
        let at = |column: usize, row: usize| {
            let state = SteadyState::new(contact, &self.inputs(column, row)).ok()?;
            let system = state.linearisation.system().reduced().ok()?;
            Some(growth_rate(&eigenvalues(&system).ok()?))
        };
        let mut rates = vec![f64::NAN; self.columns() * self.rows()];
        rates.par_chunks_mut(self.columns().max(1)).enumerate().try_for_each(|(row, rates)| {
            if progress.interrupted() {
                return Err(ModelError::Interrupted);
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
fn timed<P: OperatingPlane>(contact: &Contact, plane: &P, method: DecisionMethod) -> (StabilityMap, f64) {
    rayon::broadcast(|_| ());
    let layout = (method == DecisionMethod::Adaptive).then(|| AdaptiveMap::new(contact, plane));
    let start = Instant::now();
    let map = layout.map_or_else(|| every_point(contact, plane), AdaptiveMap::decide);
    (map, start.elapsed().as_secs_f64())
}

fn in_stages<P: OperatingPlane>(
    contact: &Contact,
    plane: &P,
    show: &mut dyn FnMut(CoarseMap),
    interrupted: &(dyn Fn() -> bool + Sync),
) -> Option<StabilityMap> {
    let decided = AdaptiveMap::new(contact, plane).decide_coarse();
    show(decided.coarse_map());
    decided.decide_rest(interrupted)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::oscillator::law_name::LawName;
    use judder_oscillator::FrictionLoad;
    use std::sync::atomic::{AtomicUsize, Ordering};

    fn axis(key: OscillatorKey, form: Form, from: f64, to: f64, points: usize) -> KeyAxis {
        let at = |k: usize| from * (to / from).powf(k as f64 / (points - 1) as f64);
        KeyAxis { key, form, values: (0..points).map(at).collect() }
    }

    fn contact() -> Contact {
        let law = bridge::formula(LawName::OscillatorPaper).unwrap();
        Contact { law, friction_load: FrictionLoad::NormalLoad }
    }

    /// Once by the short way, once by the long one.
    fn planes() -> [KeyPlane; 2] {
        let inputs = OscillatorInputs::default();
        let y = axis(OscillatorKey::ShearStrength, Form::Group, 1e-4, 1.0, 111);
        let x = axis(OscillatorKey::Velocity, Form::Group, 1e-8, 1e2, 120);
        let load = axis(OscillatorKey::StiffnessX, Form::Si, 1.0, 1e3, 120);
        [KeyPlane { inputs, x, y: y.clone() }, KeyPlane { inputs, x: load, y }]
    }

    #[test]
    fn stages_end_in_the_map_of_one_piece() {
        let contact = contact();
        for plane in planes() {
            let mut shown = Vec::new();
            let map = plane.decide_in_stages(&contact, &mut |coarse| shown.push(coarse), &|| false).unwrap();
            assert!(map == plane.decide(&contact, DecisionMethod::Adaptive).0);
            assert!(map.unstable_fraction() > 0.0 && map.unstable_fraction() < 1.0);
            let [coarse] = shown.as_slice() else { panic!("shown {} times", shown.len()) };
            assert_eq!(coarse.classes[0], map.classes[0]);
            assert_eq!(coarse.classes.len(), coarse.columns.len() * coarse.rows.len());
        }
    }

    #[test]
    fn an_interrupted_map_has_shown_its_coarse_grid() {
        let (contact, asked) = (contact(), AtomicUsize::new(0));
        for plane in planes() {
            let mut shown = 0;
            let third = || asked.fetch_add(1, Ordering::Relaxed) % 3 == 2;
            assert_eq!(plane.decide_in_stages(&contact, &mut |_| shown += 1, &third), None);
            assert_eq!(shown, 1);
        }
        assert_eq!(asked.into_inner(), 6);
    }
}
