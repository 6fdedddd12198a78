//! One step of a march.

use super::March;
use crate::NonsmoothError;
use crate::contact_problem::{ContactProblem, NormalCondition, PointMotion, Progress, add};
use crate::gauss_seidel::solve;
use crate::scheme::{PointBefore, Scheme, about_closure, at_places, at_velocities, middle_closure};

/// Times that the law of a compliant point is taken about a new closure in a step: straight laws take one.
const ROUNDS: usize = 12;

impl March<'_> {
    /// One step.
    ///
    /// # Errors
    /// [`NonsmoothError::NotFinite`].
    pub fn advance(&mut self) -> Result<(), NonsmoothError> {
        let mut next = std::mem::take(&mut self.next);
        self.bodies.free(&self.z, &self.v, &self.load, &mut next);
        self.bodies.seen(&next, 0, 1, &mut self.free);
        self.set_off();
        match self.settings.scheme {
            Scheme::MoreauJean { restitution } => self.solve_velocities(restitution),
            Scheme::ForwardIncrement => self.solve_places(),
            Scheme::Smoothed => self.smooth_contact(),
        }
        self.bodies.push(&self.solution.impulse, &mut next);
        self.take_account(&next);
        let [before, after] = self.settings.scheme.shares().map(|share| share * self.settings.step);
        for ((z, v), next) in self.z.iter_mut().zip(&self.v).zip(&next) {
            *z += before * v + after * next;
        }
        std::mem::swap(&mut self.v, &mut next);
        self.next = next;
        self.steps += 1;
        self.look();
        let is_finite = self.relative.iter().chain(&self.gap).all(|value| value.is_finite());
        if is_finite { Ok(()) } else { Err(NonsmoothError::NotFinite { time: self.time() }) }
    }

    /// Takes what the track moves off the free velocities: they are slip velocities then.
    fn set_off(&mut self) {
        let dimension = self.contact.dimension;
        for point in 0..self.gap.len() {
            self.free[point * dimension + 1] -= self.contact.speed(point);
        }
        for (component, carried) in self.convected.iter().zip(&self.carried) {
            self.free[*component] -= carried;
        }
    }

    fn before(&self, point: usize) -> PointBefore {
        /// A share of how far the largest force moves the point in a step, which the scheme does not resolve: what solving the contact to its
        /// tolerance adds up to over millions of steps is less.
        const UNRESOLVED: f64 = 1e-4;
        let opening = self.relative[point * self.contact.dimension];
        let in_step = self.settings.step * self.scale * self.delassus.block(point).normal();
        PointBefore { gap: self.gap[point], opening, rounding: self.rounding.max(UNRESOLVED * in_step) }
    }

    /// The slip speed that a point ended the last step with.
    fn slip_speed(&self, point: usize) -> f64 {
        let [_, along, across] = self.velocity(point);
        (along - self.contact.speed(point)).hypot(across)
    }

    /// The contact of the implicit scheme.
    fn solve_velocities(&mut self, restitution: f64) {
        let step = self.settings.step;
        let dimension = self.contact.dimension;
        let mut is_curved = false;
        for point in 0..self.gap.len() {
            let before = self.before(point);
            self.normal[point] = if self.contact.is_compliant(point) {
                is_curved = true;
                let closure = middle_closure(before, before.opening, step);
                about_closure(&self.contact, point, before, closure, self.slip_speed(point), step)
            } else {
                at_velocities(before, step, restitution, self.contact.points[point].stays_closed)
            };
        }
        let mut progress = self.solve_contact();
        for _ in 0..ROUNDS {
            if !is_curved {
                break;
            }
            let mut off = 0.0_f64;
            for point in (0..self.gap.len()).filter(|point| self.contact.is_compliant(*point)) {
                let before = self.before(point);
                let after = self.solution.velocity[point * dimension];
                let closure = middle_closure(before, after, step);
                let speed = self.slip_speed(point);
                let force = self.contact.forces(point, closure, speed).normal.value;
                off = off.max((step * force - self.solution.impulse[point * dimension]).abs());
                self.normal[point] = about_closure(&self.contact, point, before, closure, speed, step);
            }
            if off <= self.settings.accuracy.tolerance * self.scale {
                break;
            }
            let again = self.solve_contact();
            progress = Progress { iterations: progress.iterations + again.iterations, ..again };
        }
        self.note(progress);
        self.relative.copy_from_slice(&self.solution.velocity);
        self.put_back();
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
            let coefficient = self.contact.friction(point, -before.gap, speed).at(speed);
            let turning = self.smooth.turning * coefficient * normal;
            let size = if normal > 0.0 { coefficient * normal / speed.hypot(turning) } else { 0.0 };
            for k in 1..dimension {
                let own = self.relative[first + k];
                let slip = if k == 1 { own - self.contact.speed(point) } else { own };
                self.solution.impulse[first + k] = -size * slip;
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
    fn solve_contact(&mut self) -> Progress {
        let (contact, relative, gap) = (&self.contact, &self.relative, &self.gap);
        let dimension = contact.dimension;
        let friction = |point: usize| {
            let along = relative[point * dimension + 1] - contact.speed(point);
            let across = if dimension == 3 { relative[point * dimension + 2] } else { 0.0 };
            contact.friction(point, -gap[point], along.hypot(across))
        };
        self.friction.clear();
        self.friction.extend((0..gap.len()).map(friction));
        let problem = ContactProblem {
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
        let dimension = self.contact.dimension;
        for point in 0..self.gap.len() {
            self.relative[point * dimension + 1] += self.contact.speed(point);
        }
        for (component, carried) in self.convected.iter().zip(&self.carried) {
            self.relative[*component] += carried;
        }
    }

    /// Works of a step whose velocities go from `v` to `next`.
    fn take_account(&mut self, next: &[f64]) {
        let dimension = self.contact.dimension;
        for point in 0..self.gap.len() {
            for k in 0..dimension {
                let component = point * dimension + k;
                let mean = 0.5 * (self.before_step[component] + self.relative[component]);
                let impulse = self.solution.impulse[component];
                match k {
                    0 => self.works.normal += impulse * mean,
                    _ => {
                        self.works.friction += impulse * mean;
                        let speed = if k == 1 { self.contact.speed(point) } else { 0.0 };
                        self.works.heat -= impulse * (mean - speed);
                    }
                }
            }
        }
        self.before_step.copy_from_slice(&self.relative);
        let taken = self.bodies.work(&self.z, &self.v, next);
        self.works.damping += taken.damping;
        self.works.circulation += taken.circulation;
    }
}
