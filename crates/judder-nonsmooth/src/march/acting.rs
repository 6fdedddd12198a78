//! What acts on the bodies over time: the load by its course, excitations, and how fast the tracks move meanwhile.

use super::NonsmoothMarch;
use crate::NonsmoothError;
use crate::course::{Course, FactorIntegral};
use crate::excitation::{DrivingSignal, Excitation};

/// Forces on the coordinates of the bodies in one step, and the factors of that step.
#[derive(Debug, Clone)]
pub(super) struct Acting {
    course: Course,
    way: FactorIntegral,
    /// f of the assembly.
    full: Vec<f64>,
    /// Signals, each with its forces per unit.
    excitations: Vec<(DrivingSignal, Vec<f64>)>,
    /// f(t) where the scheme takes forces.
    now: Vec<f64>,
    /// How fast the tracks move where forces are taken, and where the velocities of the contact are.
    speed: [f64; 2],
    friction: f64,
}

impl Acting {
    /// The load of the assembly alone, on the coordinates.
    pub(super) fn new(full: Vec<f64>) -> Self {
        let (now, course) = (full.clone(), Course::default());
        let way = course.speed.integral();
        Self { course, way, full, excitations: Vec::new(), now, speed: [1.0; 2], friction: 1.0 }
    }

    /// Follows a course, with excitations whose forces `on_coordinates` projects.
    pub(super) fn follow(
        &mut self,
        course: Course,
        excitations: &[Excitation],
        on_coordinates: impl Fn(&[f64]) -> Vec<f64>,
    ) {
        self.way = course.speed.integral();
        self.course = course;
        let of = |own: &Excitation| (own.signal.clone(), on_coordinates(&own.forces));
        self.excitations = excitations.iter().map(of).collect();
    }

    /// Whether nothing changes over time.
    fn is_constant(&self) -> bool {
        self.excitations.is_empty() && self.course.is_constant()
    }

    /// Takes what acts when forces and velocities of a step are taken, in s.
    pub(super) fn look(&mut self, forces: f64, velocities: f64) {
        if self.is_constant() {
            return;
        }
        self.speed = [forces, velocities].map(|time| self.course.speed.at(time));
        self.friction = self.course.friction_at(forces);
        let load = self.course.load.at(forces);
        self.now.iter_mut().zip(&self.full).for_each(|(now, full)| *now = load * full);
        for (signal, per_unit) in &mut self.excitations {
            let value = signal.at(forces);
            self.now.iter_mut().zip(per_unit).for_each(|(now, own)| *now += value * *own);
        }
    }

    /// f(t) of the step.
    pub(super) fn forces(&self) -> &[f64] {
        &self.now
    }

    /// f of the assembly, of which the potential is.
    pub(super) fn full(&self) -> &[f64] {
        &self.full
    }

    /// What the excitations alone do at the start; `None` without any.
    pub(super) fn excited(&self) -> Option<Vec<f64>> {
        let load = self.course.load.at(0.0);
        let excited = || self.now.iter().zip(&self.full).map(|(now, full)| now - load * full).collect();
        (!self.excitations.is_empty()).then(excited)
    }

    /// How fast the tracks move where forces are taken, and where the velocities of the contact are, as shares.
    pub(super) fn speed(&self) -> [f64; 2] {
        self.speed
    }

    /// How long the tracks have moved at a time, as at full speed, both in s.
    pub(super) fn way(&self, time: f64) -> f64 {
        if self.course.speed.is_one() { time } else { self.way.at(time) }
    }

    /// What friction is multiplied by.
    pub(super) fn friction(&self) -> f64 {
        self.friction
    }

    /// What forces beyond the load of the assembly do in a step, in J: h (f(t) − f)ᵀ v̄, with these shares of the velocities before and after.
    pub(super) fn work(&self, step: f64, [first, second]: [f64; 2], [before, after]: [&[f64]; 2]) -> f64 {
        if self.is_constant() {
            return 0.0;
        }
        let forces = self.now.iter().zip(&self.full).map(|(now, full)| now - full);
        let velocities = before.iter().zip(after).map(|(before, after)| first * before + second * after);
        step * forces.zip(velocities).map(|(force, velocity)| force * velocity).sum::<f64>()
    }
}

impl NonsmoothMarch<'_> {
    /// Follows a course, with excitations on the freedoms; before a start.
    ///
    /// # Errors
    /// What [`Course::check`] and [`DrivingSignal::check`] say; [`NonsmoothError::SignalFreedoms`].
    pub fn follow(&mut self, course: Course, excitations: &[Excitation]) -> Result<(), NonsmoothError> {
        course.check()?;
        let expected = self.freedoms;
        for own in excitations {
            own.signal.check(self.settings.step)?;
            if own.forces.len() != expected {
                return Err(NonsmoothError::SignalFreedoms { found: own.forces.len(), expected });
            }
        }
        let bodies = &self.bodies;
        self.acting.follow(course, excitations, |forces| bodies.forces(forces));
        self.look();
        Ok(())
    }

    /// Of an explicit scheme, whose velocities lie half a step before the start: takes off what the excitations do in that half step.
    pub(super) fn kick_back(&mut self) {
        let lag = self.settings.velocities_lag();
        let Some(forces) = self.acting.excited().filter(|_| lag > 0.0) else { return };
        let rest = vec![0.0; self.z.len()];
        self.bodies.free(&rest, &rest, &forces, &mut self.next);
        let share = lag / self.settings.step;
        self.v.iter_mut().zip(&self.next).for_each(|(v, gained)| *v -= share * gained);
    }
}
