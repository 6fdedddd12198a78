//! Contacts that are a sphere on the substrate of the case: an oscillator's contact, carried by bodies.

use super::Unassembled;
use crate::assembly::case::AssemblyCase;
use crate::assembly::case::contact::ContactForceSettings;
use crate::assembly::case::problem::AssemblyProblem;
use crate::bridge::{self, CaseContact};
use crate::error::ModelError;
use crate::known_substrate::KnownSubstrate;
use crate::oscillator::case::OscillatorCase;
use crate::oscillator::keys::OscillatorKey;
use crate::oscillator::law_name::LawName;
use crate::oscillator::quasi_steady::{QuasiSteadyCondition, SlidingTimes};
use judder_assembly::assembly::Assembly;
use judder_assembly::compliance::Compliance;
use judder_assembly::interface::{Asperity, ForceAt, InterfaceLaw, PointForces};
use judder_assembly::steady::{PointState, steady_sliding};
use judder_contact::{ContactLaw, ContactResponse};
use judder_keys::numeric_key::Value;
use judder_oscillator::groups::Scales;
use judder_oscillator::quasi_steady::excited;
use judder_oscillator::sphere::{SlidingSphere, SphereForce, SphereForces};
use judder_study::{Progress, Silent};
use std::sync::{Arc, OnceLock};

/// A sphere on the substrate of the case.
#[derive(Debug)]
pub(crate) struct SubstrateSphere {
    /// As an oscillator case has it, its material told and its load found.
    case: OscillatorCase,
    /// Where its law has to be computed, found before the first analysis.
    found: OnceLock<FoundSphere>,
}

/// A sphere whose law is known.
#[derive(Debug)]
struct FoundSphere {
    sphere: SlidingSphere,
    substrate: KnownSubstrate,
    /// What makes the law doubtful whatever the sphere does.
    warnings: Vec<String>,
}

/// A sphere in steady sliding.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SphereState {
    /// v τ/R.
    pub(crate) velocity: f64,
    /// y/R.
    pub(crate) indentation: f64,
    /// F_n in N.
    pub(crate) normal_load: f64,
    /// A in m².
    pub(crate) area: f64,
    /// a/R, half the length of the contact along the sliding.
    pub(crate) half_length: f64,
    pub(crate) response: ContactResponse,
}

/// The spheres of an assembly, each the law of its interface; presses those that loads of their own do.
///
/// F_n, the load that presses a sphere, is the force with which the loads of the case press its place on a rigid track without friction that it just touches: of
/// a mass on springs the force on the mass, as in (1) of the oscillator paper.
pub(super) fn spheres(
    case: &AssemblyCase,
    assembly: &mut Assembly,
) -> Result<Vec<Option<Arc<SubstrateSphere>>>, Unassembled> {
    let pressing = pressing(case, assembly)?;
    let mut made = Vec::with_capacity(case.contacts.len());
    for (index, (contact, sphere)) in case.contacts.iter().zip(&case.spheres).enumerate() {
        let (ContactForceSettings::Asperity(keys), Some(sphere)) = (&contact.forces, sphere) else {
            made.push(None);
            continue;
        };
        let path = |key: &str| format!("contact.{}.asperity{key}", contact.name);
        let told = bridge::with_material(sphere);
        let mut sphere = told.map_err(|error| Unassembled::because(path(""), &error))?;
        let given = keys.normal_load.map(|_| load_of(&sphere));
        match (pressing[index], given) {
            (Some(pressing), Some(given)) if (given - pressing).abs() > SAME_LOAD * pressing.abs() => {
                let contact = contact.name.to_string();
                let problem = AssemblyProblem::OtherLoad { contact, given, pressing };
                return Err(Unassembled::new(path(".normal_load"), problem));
            }
            (Some(pressing), None) => sphere.inputs.set(OscillatorKey::NormalLoad, Value::si(pressing)),
            (None, Some(given)) => press(assembly, index, given),
            _ => {}
        }
        let sphere = Arc::new(SubstrateSphere { case: sphere, found: OnceLock::new() });
        if sphere.case.law != LawName::Bem {
            sphere.find(&Silent).map_err(|error| Unassembled::because(path(".law"), &error))?;
        }
        assembly.interfaces[index].law = InterfaceLaw::Asperity(sphere.clone());
        made.push(Some(sphere));
    }
    Ok(made)
}

/// A load that was given may differ from the one that presses by so much of it.
const SAME_LOAD: f64 = 1e-6;

/// The force in N with which the loads of the case press each contact that is a sphere.
fn pressing(case: &AssemblyCase, assembly: &Assembly) -> Result<Vec<Option<f64>>, Unassembled> {
    let first = case.contacts.iter().zip(&case.spheres).find(|(_, sphere)| sphere.is_some());
    let Some((first, _)) = first.filter(|_| !case.loads.is_empty()) else {
        return Ok(vec![None; case.contacts.len()]);
    };
    // until its load is known a sphere has the law of a rigid point without friction
    let found = Compliance::new(assembly).and_then(|compliance| steady_sliding(assembly, &compliance));
    let path = format!("contact.{}.asperity", first.name);
    let steady = found.map_err(|error| Unassembled::because(path, &error))?;
    let of_interface = |index: usize| {
        let own = steady.points.iter().filter(|point| point.interface == index);
        own.map(|point| point.normal_force).sum()
    };
    let spheres = case.spheres.iter().enumerate();
    Ok(spheres.map(|(index, sphere)| sphere.is_some().then(|| of_interface(index))).collect())
}

/// F_n of the case of a sphere, in N.
fn load_of(sphere: &OscillatorCase) -> f64 {
    let Scales { reduced_modulus, radius, .. } = sphere.inputs.scales();
    bridge::groups(&sphere.inputs).normal_load * reduced_modulus * radius * radius
}

/// Presses the sides of an interface on each other.
fn press(assembly: &mut Assembly, interface: usize, force: f64) {
    for point in &assembly.interfaces[interface].points {
        point.form(point.normal).add_to(-force, &mut assembly.load);
    }
}

impl SubstrateSphere {
    /// Finds its law, where that is not known yet.
    ///
    /// # Errors
    /// A law that cannot be computed or read, [`ModelError::Interrupted`].
    pub(crate) fn find(&self, progress: &dyn Progress) -> Result<(), ModelError> {
        if self.found.get().is_none() {
            let substrate = KnownSubstrate::of(&self.case)?;
            let CaseContact { contact, mut warnings } = bridge::contact_of(&self.case, progress)?;
            warnings.extend(substrate.temperature_warning.clone());
            let inputs = &self.case.inputs;
            let (Scales { reduced_modulus, radius, .. }, groups) = (inputs.scales(), bridge::groups(inputs));
            let sphere = SlidingSphere {
                contact,
                reduced_modulus,
                radius,
                retardation_time: inputs.number(OscillatorKey::RetardationTime),
                normal_load: groups.normal_load,
                shear_strength: groups.shear_strength,
            };
            // another thread finds the same
            let _ = self.found.set(FoundSphere { sphere, substrate, warnings });
        }
        Ok(())
    }

    /// v τ/R at a speed in m/s.
    pub(crate) fn velocity(&self, speed: f64) -> f64 {
        let inputs = &self.case.inputs;
        speed * inputs.number(OscillatorKey::RetardationTime) / inputs.number(OscillatorKey::Radius)
    }

    /// F_n in N.
    pub(crate) fn normal_load(&self) -> f64 {
        load_of(&self.case)
    }

    /// The sphere in steady sliding at a speed in m/s; `None` where its law is not known or it is in the air.
    pub(crate) fn state(&self, point: &PointState, speed: f64) -> Option<SphereState> {
        let sphere = &self.found.get().filter(|_| point.is_closed)?.sphere;
        let (velocity, response) = (sphere.velocity(speed), sphere.response(-point.gap, speed));
        Some(SphereState {
            velocity,
            indentation: -point.gap / sphere.radius,
            normal_load: self.normal_load(),
            area: response.area.value * sphere.radius * sphere.radius,
            half_length: sphere.contact.law.half_length(response.area.value),
            response,
        })
    }

    /// What is to be said of its law in this state, a sentence each.
    pub(crate) fn doubts(&self, state: &SphereState) -> Vec<String> {
        let Some(found) = self.found.get() else { return Vec::new() };
        let law = &found.sphere.contact.law;
        let concern = law.concern(state.velocity, state.indentation).map(|concern| concern.to_string());
        let band = found.substrate.band.filter(|_| !law.is_formula());
        let of_band = band.and_then(|band| band.warning([excited(state.velocity, state.half_length)]));
        found.warnings.iter().cloned().chain(concern).chain(of_band).collect()
    }

    /// Eq. (3) for small motions of a frequency in rad/s; `None` on an elastic substrate.
    pub(crate) fn condition(&self, state: &SphereState, frequency: f64) -> Option<QuasiSteadyCondition> {
        let sliding = SlidingTimes { velocity: state.velocity, half_length: state.half_length };
        QuasiSteadyCondition::of_motion(
            frequency,
            &self.case.inputs,
            sliding,
            &self.found.get()?.substrate.terms,
        )
    }
}

impl Asperity for SubstrateSphere {
    fn forces(&self, closure: f64, speed: f64) -> PointForces {
        let unknown = SphereForce { value: f64::NAN, by_depth: f64::NAN, by_speed: f64::NAN };
        let unknown = SphereForces { normal: unknown, friction: unknown };
        let forces = self.found.get().map_or(unknown, |found| found.sphere.forces(closure, speed));
        let at =
            |SphereForce { value, by_depth, by_speed }| ForceAt { value, by_closure: by_depth, by_speed };
        PointForces { normal: at(forces.normal), friction: at(forces.friction) }
    }
}
