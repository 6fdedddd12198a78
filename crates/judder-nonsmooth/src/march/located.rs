//! Where a march is beside its track.

use super::{ContactRecord, NonsmoothMarch, Works};
use crate::NonsmoothError;
use crate::contact_problem::ContactSolution;
use crate::travel::{StepView, Travel};

impl NonsmoothMarch<'_> {
    /// Begins anew from displacements and velocities of the freedoms.
    pub fn start(&mut self, displacement: &[f64], velocity: &[f64]) {
        self.z = self.bodies.coordinates(displacement);
        self.v = self.bodies.coordinates(velocity);
        (self.steps, self.works, self.record) = (0, Works::default(), ContactRecord::default());
        self.solution = ContactSolution::none(&self.delassus);
        if let Some(travel) = &mut self.travel {
            travel.begin();
        }
        self.look();
        self.kick_back();
        let mut seen = vec![0.0; self.gap.len()];
        self.bodies.seen(&self.z, 0, self.contact.dimension, &mut seen);
        let farthest = seen.iter().zip(0..).fold(0.0_f64, |most, (moved, point)| {
            most.max(moved.abs()).max(self.contact.first_gap(point).abs())
        });
        let fastest = (0..self.gap.len()).map(|point| self.contact.speed(point)).fold(0.0, f64::max);
        self.rounding = 1e-11 * farthest.max(self.settings.step * fastest);
        self.bodies.seen(&self.v, 0, 1, &mut self.relative);
        self.begin_travel();
        self.before_step.copy_from_slice(&self.relative);
    }

    /// Gaps where the bodies are, and what acts in the step from here.
    pub(super) fn look(&mut self) {
        let at = |share: f64| (self.steps as f64 + share) * self.settings.step;
        let [forces, velocities] = self.settings.scheme.instants().map(at);
        self.acting.look(forces, velocities);
        self.bodies.seen(&self.z, 0, self.contact.dimension, &mut self.gap);
        for (point, gap) in self.gap.iter_mut().enumerate() {
            *gap += self.contact.first_gap(point);
        }
        for (point, own) in self.travel.iter().flat_map(Travel::points) {
            self.gap[point] = own.gap;
        }
        let first = self.rows + self.observed;
        self.bodies.seen(&self.z, first, 1, &mut self.carried);
        let dimension = self.contact.dimension;
        for (component, imposed) in self.imposed.iter_mut().enumerate() {
            let is_along = component % dimension == 1;
            *imposed = if is_along { self.contact.speed(component / dimension) } else { 0.0 };
        }
        for (component, carried) in self.convected.iter().zip(&self.carried) {
            self.imposed[*component] += carried;
        }
        let [amid, after] = self.acting.speed();
        for (imposed, dragging) in self.imposed.iter_mut().zip(&mut self.dragging) {
            (*imposed, *dragging) = (after * *imposed, amid * *imposed);
        }
    }

    /// How long the track has moved beside the slider after so many steps, as at full speed, in s.
    fn way(&self, steps: u64) -> f64 {
        self.acting.way(steps as f64 * self.settings.step)
    }

    /// Takes the forms of travelling points where they start.
    fn begin_travel(&mut self) {
        let Some(travel) = &mut self.travel else { return };
        let view = StepView { states: [&self.z, &self.v, &self.v], shares: [0.0; 2], way: 0.0 };
        // a point off its edge is told by the first step
        if travel.locate(&self.bodies, view, &self.solution.impulse, &mut self.delassus).is_ok() {
            travel.see(&self.bodies, view, 1, &mut self.relative);
            travel.points().for_each(|(point, own)| self.gap[point] = own.gap);
        }
    }

    /// What the contact sees of the velocities `next` with which the step ends without it: where points travel they touch it first, and what was before is taken along the
    /// directions of these places.
    pub(super) fn locate(&mut self, next: &[f64]) -> Result<(), NonsmoothError> {
        let step = self.settings.step;
        let shares = self.settings.scheme.shares().map(|share| share * step);
        let [before, after] = [self.steps, self.steps + 1].map(|steps| self.way(steps));
        let Some(travel) = &mut self.travel else {
            self.bodies.seen(next, 0, 1, &mut self.free);
            return Ok(());
        };
        let view = StepView { states: [&self.z, &self.v, next], shares, way: after };
        travel
            .locate(&self.bodies, view, &self.solution.impulse, &mut self.delassus)
            .map_err(|end| end.at((self.steps + 1) as f64 * step))?;
        self.solution.forget();
        travel.see(&self.bodies, view, 1, &mut self.relative);
        travel.see(&self.bodies, view, 2, &mut self.free);
        self.before_step.copy_from_slice(&self.relative);
        for (point, own) in travel.points() {
            let first = 2 * point;
            let imposed = own.imposed.map(|full| full * (after - before) / step);
            self.imposed[first..first + 2].copy_from_slice(&imposed);
            self.dragging[first..first + 2].copy_from_slice(&imposed);
            let [now, then] = [self.relative[first], self.free[first]].map(|normal| normal - imposed[0]);
            self.gap[point] = own.gap - shares[0] * now - shares[1] * then;
        }
        Ok(())
    }

    /// The gaps of travelling points when the step ends.
    pub(super) fn end_travel(&mut self) {
        let [before, after] = self.settings.scheme.shares().map(|share| share * self.settings.step);
        let Some(travel) = &mut self.travel else { return };
        for (point, own) in travel.points_mut() {
            let normal = 2 * point;
            let moved =
                [self.before_step[normal], self.relative[normal]].map(|own| own - self.imposed[normal]);
            own.gap = self.gap[point] + before * moved[0] + after * moved[1];
        }
    }
}
