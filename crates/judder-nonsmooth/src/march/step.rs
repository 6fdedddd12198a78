//! One step of a march.

use super::NonsmoothMarch;
use crate::NonsmoothError;
use crate::contact_problem::{
    ContactProgress, FrictionCondition, ImpulseProblem, NormalCondition, PointMotion, add,
};
use crate::gauss_seidel::solve;
use crate::scheme::{ContactScheme, ImplicitStep, PointBefore, at_places};

/// Times that the law of a compliant point is taken about a new closure in a step: straight laws take one.
const ROUNDS: usize = 12;

impl NonsmoothMarch<'_> {
    /// One step.
    ///
    /// # Errors
    /// [`NonsmoothError::NotFinite`], [`NonsmoothError::RunOff`], where points travel [`NonsmoothError::StepOverLimit`]; the march is then where it was, and goes no farther.
    pub fn advance(&mut self) -> Result<(), NonsmoothError> {
        let mut next = std::mem::take(&mut self.next);
        self.bodies.free(&self.z, &self.v, self.acting.forces(), &mut next);
        if let Err(error) = self.locate(&next).and_then(|()| self.look_at_compliance()) {
            self.next = next;
            return Err(error);
        }
        self.set_off();
        match self.settings.scheme {
            ContactScheme::MoreauJean { restitution, .. } => self.solve_velocities(restitution),
            ContactScheme::ForwardIncrement | ContactScheme::KnownSliding => self.solve_places(),
            ContactScheme::Smoothed => self.smooth_contact(),
        }
        self.push(&mut next);
        if !(are_finite(&next) && are_finite(&self.relative)) {
            self.next = next;
            return Err(NonsmoothError::NotFinite { time: (self.steps + 1) as f64 * self.settings.step });
        }
        self.end_travel();
        self.take_account(&next);
        let [before, after] = self.settings.scheme.shares().map(|share| share * self.settings.step);
        for ((z, v), next) in self.z.iter_mut().zip(&self.v).zip(&next) {
            *z += before * v + after * next;
        }
        std::mem::swap(&mut self.v, &mut next);
        self.next = next;
        self.steps += 1;
        self.look();
        Ok(())
    }

    /// Adds what the impulses do to velocities.
    fn push(&mut self, v: &mut [f64]) {
        let impulse = &self.solution.impulse;
        match &mut self.travel {
            None => self.bodies.push(impulse, v),
            Some(travel) => self.bodies.push(travel.on_rows(impulse), v),
        }
    }

    /// Takes what the track moves off the free velocities: they are slip velocities then.
    fn set_off(&mut self) {
        self.free.iter_mut().zip(&self.imposed).for_each(|(free, imposed)| *free -= imposed);
    }

    fn before(&self, point: usize) -> PointBefore {
        /// A share of how far the largest force moves the point in a step, which the scheme does not resolve: what solving the contact to its
        /// tolerance adds up to over millions of steps is less.
        const UNRESOLVED: f64 = 1e-4;
        let normal = point * self.contact.dimension;
        let opening = self.relative[normal] - self.imposed[normal];
        let in_step = self.settings.step * self.scale * self.delassus.block(point).normal();
        PointBefore { gap: self.gap[point], opening, rounding: self.rounding.max(UNRESOLVED * in_step) }
    }

    /// The slip velocity that a point ended the last step with, along the slip of steady sliding and across it.
    fn slip(&self, point: usize) -> [f64; 2] {
        let dimension = self.contact.dimension;
        let along = |k: usize| {
            let component = point * dimension + k;
            if k < dimension { self.relative[component] - self.imposed[component] } else { 0.0 }
        };
        [along(1), along(2)]
    }

    fn slip_speed(&self, point: usize) -> f64 {
        let [along, across] = self.slip(point);
        libm::hypot(along, across)
    }

    fn implicit_step(&self) -> ImplicitStep {
        ImplicitStep { length: self.settings.step, shares: self.settings.scheme.shares() }
    }

    /// The contact of the implicit scheme.
    fn solve_velocities(&mut self, restitution: f64) {
        let step = self.implicit_step();
        let mut is_curved = false;
        for point in 0..self.gap.len() {
            let before = self.before(point);
            self.normal[point] = if self.contact.is_compliant(point) {
                is_curved = true;
                let closure = step.closure(before, before.opening);
                step.about_closure(&self.contact, point, before, closure, self.slip_speed(point))
            } else {
                step.at_velocities(before, restitution, self.contact.points[point].stays_closed)
            };
        }
        let mut progress = self.solve_contact();
        for _ in 0..if is_curved { ROUNDS } else { 0 } {
            let (off, point) = self.about_new_closures();
            if off <= self.settings.accuracy.tolerance {
                break;
            }
            let again = self.solve_contact();
            progress = ContactProgress { iterations: progress.iterations + again.iterations, ..again };
            // the law itself, not the straight line that stood for it
            let (off, of) = self.law_residual();
            if off > progress.residual {
                (progress.residual, progress.point) = (off, of.unwrap_or(point));
            }
        }
        self.note(progress);
        self.relative.copy_from_slice(&self.solution.velocity);
        self.put_back();
    }

    /// By how much impulses differ from those of the laws of compliant points at most, as a share of the scale, and at which point.
    fn law_residual(&self) -> (f64, Option<usize>) {
        let (step, dimension) = (self.implicit_step(), self.contact.dimension);
        let mut worst = (0.0, None);
        for point in (0..self.gap.len()).filter(|point| self.contact.is_compliant(*point)) {
            let after = self.solution.velocity[point * dimension];
            let closure = step.closure(self.before(point), after);
            let force = self.contact.forces(point, closure, self.slip_speed(point)).normal.value;
            let off = (step.length * force - self.solution.impulse[point * dimension]).abs() / self.scale;
            if off > worst.0 {
                worst = (off, Some(point));
            }
        }
        worst
    }

    /// Takes the laws of compliant points about where these are now, and says how far off they were.
    fn about_new_closures(&mut self) -> (f64, usize) {
        let (step, dimension) = (self.implicit_step(), self.contact.dimension);
        let (off, point) = self.law_residual();
        for point in (0..self.gap.len()).filter(|point| self.contact.is_compliant(*point)) {
            let before = self.before(point);
            let closure = step.closure(before, self.solution.velocity[point * dimension]);
            let speed = self.slip_speed(point);
            self.normal[point] = step.about_closure(&self.contact, point, before, closure, speed);
        }
        (off, point.unwrap_or(0))
    }

    /// The contact of forward increments.
    fn solve_places(&mut self) {
        let (step, dimension) = (self.settings.step, self.contact.dimension);
        for point in 0..self.gap.len() {
            let component = point * dimension;
            self.normal[point] = if self.contact.is_compliant(point) {
                let forces = self.contact.forces(point, -self.gap[point], self.slip_speed(point));
                NormalCondition::Given { impulse: step * forces.normal.value }
            } else {
                self.free[component] += self.gap[point] / step;
                at_places(self.contact.points[point].stays_closed)
            };
        }
        let progress = self.solve_contact();
        self.note(progress);
        if self.settings.scheme == ContactScheme::KnownSliding {
            self.note_against();
        }
        self.relative.copy_from_slice(&self.solution.velocity);
        for point in (0..self.gap.len()).filter(|point| !self.contact.is_compliant(*point)) {
            self.relative[point * dimension] -= self.gap[point] / step;
        }
        self.put_back();
    }

    /// The contact without a solver.
    fn smooth_contact(&mut self) {
        let (step, dimension) = (self.settings.step, self.contact.dimension);
        for point in 0..self.gap.len() {
            let first = point * dimension;
            let before = self.before(point);
            let speed = self.slip_speed(point);
            let normal = match self.contact.is_compliant(point) {
                true => step * self.contact.forces(point, -before.gap, speed).normal.value,
                false => self.smooth.normal(before, step),
            };
            self.solution.impulse[first] = normal;
            let coefficient =
                self.contact.friction(point, -before.gap, speed, self.acting.friction()).at(speed);
            let turning = self.smooth.turning * coefficient * normal;
            let size = if normal > 0.0 { coefficient * normal / libm::hypot(speed, turning) } else { 0.0 };
            let slip = self.slip(point);
            for k in 1..dimension {
                self.solution.impulse[first + k] = -size * slip[k - 1];
            }
            self.solution.motion[point] = match normal > 0.0 {
                false => PointMotion::Open,
                true if speed <= turning => PointMotion::Stick,
                true => PointMotion::Slip,
            };
        }
        self.relative.copy_from_slice(&self.free);
        for (component, impulse) in self.solution.impulse.iter().enumerate() {
            add(&mut self.relative, *impulse, self.delassus.column(component));
        }
        self.put_back();
    }

    /// Solves the conditions of the points.
    fn solve_contact(&mut self) -> ContactProgress {
        let mut friction = std::mem::take(&mut self.friction);
        friction.clear();
        let factor = self.acting.friction();
        friction.extend((0..self.gap.len()).map(|point| {
            let speed = self.slip_speed(point);
            let own = self.contact.friction(point, -self.gap[point], speed, factor);
            match self.settings.scheme {
                ContactScheme::KnownSliding => FrictionCondition::Sliding { coefficient: own.at(speed) },
                _ => own,
            }
        }));
        self.friction = friction;
        let problem = ImpulseProblem {
            delassus: &self.delassus,
            free: &self.free,
            normal: &self.normal,
            friction: &self.friction,
            scale: self.scale,
        };
        solve(&problem, self.settings.accuracy, &mut self.solution)
    }

    /// Makes velocities beside the track's undisturbed place of slip velocities.
    fn put_back(&mut self) {
        self.relative.iter_mut().zip(&self.imposed).for_each(|(relative, imposed)| *relative += imposed);
    }

    /// Works of a step whose velocities go from `v` to `next`.
    fn take_account(&mut self, next: &[f64]) {
        let (dimension, [first, second]) = (self.contact.dimension, self.settings.scheme.working());
        for point in 0..self.gap.len() {
            for k in 0..dimension {
                let component = point * dimension + k;
                let mean = first * self.before_step[component] + second * self.relative[component];
                let impulse = self.solution.impulse[component];
                match k {
                    0 => {
                        self.works.normal += impulse * mean;
                        self.works.slope += impulse * self.imposed[component];
                    }
                    _ => {
                        self.works.friction += impulse * mean;
                        self.works.heat -= impulse * (mean - self.dragging[component]);
                    }
                }
            }
        }
        self.before_step.copy_from_slice(&self.relative);
        let taken = self.bodies.work(&self.z, &self.v, next);
        self.works.damping += taken.damping;
        self.works.circulation += taken.circulation;
        self.works.excitation += self.acting.work(self.settings.step, [first, second], [&self.v, next]);
        self.works.flexibility += taken.flexibility;
        self.works.scheme += taken.scheme;
    }
}

/// Whether all are numbers, without a branch for each.
fn are_finite(values: &[f64]) -> bool {
    values.iter().fold(true, |all, value| all & value.is_finite())
}
