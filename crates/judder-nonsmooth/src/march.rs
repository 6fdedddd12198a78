//! A motion, step by step.

mod acting;
mod checkpoint;
mod limit;
mod located;
mod step;
#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod widths;
mod works;

use crate::NonsmoothError;
use crate::bodies::{BodyEnergy, MovingBodies, StepRule};
use crate::contact::ContactPoints;
use crate::contact_problem::{
    ContactProgress, ContactSolution, Delassus, FrictionCondition, NormalCondition, PointMotion,
};
use crate::gauss_seidel::ContactAccuracy;
use crate::scheme::{ContactScheme, SmoothContact};
use crate::travel::{Travel, TravellingContact};
use acting::Acting;
use judder_assembly::assembly::Assembly;
use judder_assembly::row::Row;
use std::f64::consts::TAU;

pub use checkpoint::MarchCheckpoint;
pub use works::{ContactRecord, Works};

/// What a march is to do.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NonsmoothSettings {
    /// How.
    pub scheme: ContactScheme,
    /// h in s.
    pub step: f64,
    /// How well the contact is solved.
    pub accuracy: ContactAccuracy,
    /// Of an explicit scheme: modes from this frequency on only yield, in Hz.
    pub cut_off: Option<f64>,
}

/// A march: bodies, contact, and where they are.
#[derive(Debug, Clone)]
pub struct NonsmoothMarch<'a> {
    settings: NonsmoothSettings,
    bodies: MovingBodies,
    /// The largest angular frequency of the bodies in rad/s and damping rate in 1/s; of explicit steps.
    fastest: [f64; 2],
    contact: ContactPoints<'a>,
    delassus: Delassus,
    smooth: SmoothContact,
    /// Points that travel.
    travel: Option<Travel>,
    /// Rows before those of what is observed.
    rows: usize,
    /// Forms on the coordinates of how slip follows displacements, as rows after those of the contact and the observed ones.
    convected: Vec<usize>,
    observed: usize,
    /// Of the assembly.
    freedoms: usize,
    acting: Acting,
    z: Vec<f64>,
    v: Vec<f64>,
    next: Vec<f64>,
    /// g at the beginning of the next step.
    gap: Vec<f64>,
    /// H v, without what the track moves.
    relative: Vec<f64>,
    free: Vec<f64>,
    carried: Vec<f64>,
    /// The velocity of the track beside its undisturbed place of each component, with what its passing material brings, where the velocities of the contact are taken,
    imposed: Vec<f64>,
    /// and where its forces are.
    dragging: Vec<f64>,
    normal: Vec<NormalCondition>,
    friction: Vec<FrictionCondition<'a>>,
    /// H v before the last step.
    before_step: Vec<f64>,
    solution: ContactSolution,
    rounding: f64,
    /// An impulse by which residuals are measured.
    scale: f64,
    steps: u64,
    works: Works,
    record: ContactRecord,
}

impl NonsmoothSettings {
    /// The rule for the bodies.
    fn rule(&self) -> StepRule {
        let cut_off = self.cut_off.map_or(f64::INFINITY, |frequency| TAU * frequency);
        StepRule { step: self.step, implicitness: self.scheme.implicitness(), cut_off }
    }

    fn check(&self) -> Result<(), NonsmoothError> {
        let refuse =
            |name, value, requirement| Err(NonsmoothError::InvalidNumber { name, value, requirement });
        if !(self.step.is_finite() && self.step > 0.0) {
            return refuse("the step", self.step, "finite and positive");
        }
        self.scheme.check()?;
        match self.cut_off {
            Some(cut_off) if !(cut_off.is_finite() && cut_off > 0.0) => {
                refuse("the cut-off", cut_off, "finite and positive")
            }
            Some(cut_off) if self.scheme.implicitness() > 0.0 => refuse(
                "the cut-off",
                cut_off,
                "of an explicit scheme: the implicit one lets fast modes yield by itself",
            ),
            _ => Ok(()),
        }
    }

    /// How far behind the places the velocities of its states lie, in s: half a step of an explicit one.
    #[must_use]
    pub fn velocities_lag(&self) -> f64 {
        if self.scheme.implicitness() == 0.0 { 0.5 * self.step } else { 0.0 }
    }
}

impl<'a> NonsmoothMarch<'a> {
    /// A march from rest of the undeformed bodies, with rows on the freedoms that are observed.
    ///
    /// # Errors
    /// [`NonsmoothError::InvalidNumber`], [`NonsmoothError::StepOverLimit`], [`NonsmoothError::NoMass`], [`NonsmoothError::HeldPoint`], and what
    /// [`ContactPoints::new`] says.
    pub fn new(
        assembly: &'a Assembly,
        observed: &[Row],
        settings: NonsmoothSettings,
    ) -> Result<Self, NonsmoothError> {
        Self::travelling(assembly, &[], observed, settings)
    }

    /// The same where the points of these interfaces travel along their track.
    ///
    /// # Errors
    /// As [`NonsmoothMarch::new`]; [`NonsmoothError::TravelInSpace`], [`NonsmoothError::TravelsOnTurning`], [`NonsmoothError::Edge`],
    /// [`NonsmoothError::RunOff`].
    pub fn travelling(
        assembly: &'a Assembly,
        travelling: &[TravellingContact],
        observed: &[Row],
        settings: NonsmoothSettings,
    ) -> Result<Self, NonsmoothError> {
        settings.check()?;
        let step = settings.step;
        let contact = ContactPoints::new(assembly, travelling)?;
        let carried = contact.convected();
        let (mut travel, own) = match travelling {
            [] => (None, contact.rows.clone()),
            _ => Travel::new(&contact, &assembly.interfaces, travelling)
                .map(|(travel, own)| (Some(travel), own))?,
        };
        let rows: Vec<Row> =
            own.iter().chain(observed).chain(carried.iter().map(|(_, row)| row)).cloned().collect();
        let mut bodies = MovingBodies::new(assembly, &rows, settings.rule())?;
        let compliance = bodies.compliance(own.len());
        let delassus = match &mut travel {
            None => Delassus::new(contact.dimension, compliance),
            Some(travel) => travel.first(compliance, &bodies).map_err(|end| end.at(0.0))?,
        };
        if let Some(point) = delassus.held_point() {
            let interface = contact.points[point].interface;
            let before = contact.points.iter().filter(|own| own.interface < interface).count();
            let name = assembly.interfaces[interface].name.clone();
            return Err(NonsmoothError::HeldPoint { interface: name, point: point - before + 1 });
        }
        let load = bodies.forces(&assembly.load);
        let force = assembly.load.iter().fold(0.0_f64, |most, own| most.max(own.abs()));
        let (size, points, components) = (bodies.size(), contact.points.len(), contact.rows.len());
        let solution = ContactSolution::none(&delassus);
        let mut march = Self {
            settings,
            smooth: SmoothContact::new(&delassus, step),
            travel,
            rows: own.len(),
            convected: carried.iter().map(|(component, _)| *component).collect(),
            observed: observed.len(),
            freedoms: assembly.size(),
            acting: Acting::new(load),
            z: vec![0.0; size],
            v: vec![0.0; size],
            next: vec![0.0; size],
            gap: vec![0.0; points],
            relative: vec![0.0; components],
            free: vec![0.0; components],
            carried: vec![0.0; carried.len()],
            imposed: vec![0.0; components],
            dragging: vec![0.0; components],
            normal: vec![NormalCondition::Open; points],
            friction: Vec::with_capacity(points),
            before_step: vec![0.0; components],
            solution,
            rounding: 0.0,
            scale: step * if force > 0.0 { force } else { 1.0 },
            steps: 0,
            works: Works::default(),
            record: ContactRecord::default(),
            fastest: if settings.scheme.implicitness() > 0.0 { [0.0; 2] } else { bodies.fastest() },
            bodies,
            contact,
            delassus,
        };
        march.check_step()?;
        march.start(&vec![0.0; assembly.size()], &vec![0.0; assembly.size()]);
        Ok(march)
    }

    /// Goes on with vectors of another width.
    #[cfg(test)]
    fn set_arch(&mut self, arch: pulp::Arch) {
        self.bodies.set_arch(arch);
        self.delassus.set_arch(arch);
        self.solution = ContactSolution::none(&self.delassus);
    }

    /// What a step's impulses are measured by, in N: of the order of the contact forces of steady sliding; the largest load where nothing is said, or
    /// nothing presses.
    pub fn set_force_scale(&mut self, force: f64) {
        if force > 0.0 && force.is_finite() {
            self.scale = force * self.settings.step;
        }
    }

    /// Starts the contact solver from these forces along normal and slip of each point, in N.
    pub fn guess(&mut self, forces: &[[f64; 2]]) {
        let dimension = self.contact.dimension;
        for (point, [normal, friction]) in forces.iter().enumerate() {
            self.solution.impulse[point * dimension] = normal * self.settings.step;
            self.solution.impulse[point * dimension + 1] = friction * self.settings.step;
        }
    }

    /// Steps since the start.
    #[must_use]
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// The time in s.
    #[must_use]
    pub fn time(&self) -> f64 {
        self.steps as f64 * self.settings.step
    }

    /// What it is to do.
    #[must_use]
    pub fn settings(&self) -> &NonsmoothSettings {
        &self.settings
    }

    /// The contact points.
    #[must_use]
    pub fn contact(&self) -> &ContactPoints<'a> {
        &self.contact
    }

    /// Whether its coordinates are the modes of all bodies together.
    #[must_use]
    pub fn is_modal(&self) -> bool {
        self.bodies.are_modal()
    }

    /// What a point does after the last step.
    #[must_use]
    pub fn motion(&self, point: usize) -> PointMotion {
        self.solution.motion[point]
    }

    /// N and the friction along and across the slip on the slider, over the last step, in N.
    #[must_use]
    pub fn force(&self, point: usize) -> [f64; 3] {
        self.component(&self.solution.impulse, point).map(|impulse| impulse / self.settings.step)
    }

    /// The velocity of the slider beside the track's undisturbed place, along normal, slip and across it, in m/s.
    #[must_use]
    pub fn velocity(&self, point: usize) -> [f64; 3] {
        self.component(&self.relative, point)
    }

    /// g in m.
    #[must_use]
    pub fn gap(&self, point: usize) -> f64 {
        self.gap[point]
    }

    fn component(&self, values: &[f64], point: usize) -> [f64; 3] {
        let dimension = self.contact.dimension;
        let mut own = [0.0; 3];
        own[..dimension].copy_from_slice(&values[point * dimension..(point + 1) * dimension]);
        own
    }

    /// The observed displacements in m.
    pub fn observed_displacements(&self, out: &mut [f64]) {
        self.bodies.seen(&self.z, self.rows, 1, &mut out[..self.observed]);
    }

    /// The observed velocities in m/s; of the explicit schemes half a step before the displacements.
    pub fn observed_velocities(&self, out: &mut [f64]) {
        self.bodies.seen(&self.v, self.rows, 1, &mut out[..self.observed]);
    }

    /// Displacements and velocities of the freedoms.
    #[must_use]
    pub fn state(&self) -> [Vec<f64>; 2] {
        [self.bodies.freedoms(&self.z), self.bodies.freedoms(&self.v)]
    }

    /// A sum over the displacements of the freedoms, ready to be taken at every step.
    #[must_use]
    pub fn functional(&self, on_freedoms: &[f64]) -> Vec<f64> {
        self.bodies.forces(on_freedoms)
    }

    /// w·q + u·q̇ of two functionals, at the beginning of the last step: the velocity is the mean of those before and after, which is that of
    /// the place to the second order of the step.
    #[must_use]
    pub fn middle(&self, on_displacement: &[f64], on_velocity: &[f64]) -> f64 {
        let [before, after] = self.settings.scheme.shares().map(|share| share * self.settings.step);
        let (mut sum, explicit) = (0.0, self.settings.scheme.implicitness() == 0.0);
        for k in 0..self.z.len() {
            // after a step `next` holds the velocities before it
            let (old, new) = (self.next[k], self.v[k]);
            let place = self.z[k] - before * old - after * new;
            let velocity = if explicit { 0.5 * (old + new) } else { old };
            sum += on_displacement[k] * place + on_velocity[k] * velocity;
        }
        sum
    }

    /// The energy of the bodies, with the potential of the load of the assembly.
    #[must_use]
    pub fn energy(&self) -> BodyEnergy {
        self.bodies.energy(&self.z, &self.v, self.acting.full())
    }

    /// Where it is, on its own coordinates.
    #[must_use]
    pub fn place(&self) -> &[f64] {
        &self.z
    }

    /// The energy of the bodies about a place of this march, ½ vᵀ M v and ½ δzᵀ K δz, without that of contacts.
    #[must_use]
    pub fn energy_about(&self, place: &[f64]) -> BodyEnergy {
        let off: Vec<f64> = self.z.iter().zip(place).map(|(own, other)| own - other).collect();
        self.bodies.energy(&off, &self.v, &vec![0.0; off.len()])
    }

    /// Where work went since the start.
    #[must_use]
    pub fn works(&self) -> Works {
        self.works
    }

    /// How well the contact was solved.
    #[must_use]
    pub fn record(&self) -> ContactRecord {
        self.record
    }

    /// The last step's iterations and residual.
    fn note(&mut self, progress: ContactProgress) {
        let record = &mut self.record;
        record.iterations += progress.iterations as u64;
        record.residual = record.residual.max(progress.residual);
        if progress.residual > self.settings.accuracy.tolerance || progress.residual.is_nan() {
            record.unsolved += 1;
            let time = (self.steps + 1) as f64 * self.settings.step;
            record.first_unsolved.get_or_insert((time, progress.point));
        }
    }

    /// Whether a pressed point slides otherwise than is known: its friction would drive it.
    fn note_against(&mut self) {
        let (dimension, solution) = (self.contact.dimension, &self.solution);
        let slides_against = |point: &usize| {
            let first = point * dimension;
            solution.impulse[first] > 0.0 && solution.velocity[first + 1] >= 0.0
        };
        if let Some(point) = (0..self.gap.len()).find(slides_against) {
            self.record.against += 1;
            let time = (self.steps + 1) as f64 * self.settings.step;
            self.record.first_against.get_or_insert((time, point));
        }
    }
}
