//! One step of a march after the other.

use super::compliance::{ModalCompliance, in_frame};
use super::lock::SliderLock;
use super::oscillators::ROWS;
use super::reaction::{Approach, Reaction, projected, sliding};
use super::view::{MarchView, vectors};
use super::{ContactMethod, March, MarchSample, MarchStart, Predictor, Reached, Scheme, Sink, damping_of};
use crate::SlidingError;
use crate::edge::{RunOff, STENCIL, Touch, combined};
use crate::motion::Drive;
use crate::pair::PairSide;
use crate::plane::{PlaneVector, dot, minus, plus, turned};

/// How much of the initial damping may go before the exact recurrences are tuned anew.
const STAIR: f64 = 0.002;
/// Times that the exact scheme finds geometry and force, each from the other, in a step.
const PASSES: usize = 3;

impl March<'_> {
    /// The largest stable step, s.
    #[must_use]
    pub fn step_limit(&self) -> f64 {
        self.step_limit
    }

    /// Gap between C and the undeformed track at the start, m: closed over its ramp.
    #[must_use]
    pub fn first_gap(&self) -> f64 {
        self.first_gap
    }

    /// Steps done.
    #[must_use]
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// Steps from the start to the end of the path.
    #[must_use]
    pub fn all_steps(&self) -> u64 {
        (self.settings.motion.duration() / self.settings.step).ceil() as u64
    }

    /// Modal coordinates of those modes that move, the slider's first, √kg m.
    #[must_use]
    pub fn state(&self) -> Vec<f64> {
        [self.slider.state(), self.track.state()].concat()
    }

    /// Goes on by so many steps at most.
    ///
    /// # Errors
    /// [`SlidingError::SpragSlip`] where the slider locks, [`SlidingError::LiftedOff`] where it is open and farther from the track than
    /// that is long, [`SlidingError::NotFinite`] where a mode has grown without bound. What was taken before stands.
    pub fn advance(&mut self, steps: u64, sink: &mut impl Sink) -> Result<Reached, SlidingError> {
        let is_path = self.settings.motion.velocity != 0.0;
        let last = if is_path { self.all_steps() } else { u64::MAX };
        for _ in 0..steps {
            if self.steps >= last {
                return Ok(Reached::End);
            }
            match self.step()? {
                Ok(sample) => {
                    for (point, own) in self.observed.iter().enumerate() {
                        sink.displaced(point, own[1], sample.position);
                    }
                    sink.take(&sample, &self.accelerations);
                }
                Err(end) => return Ok(Reached::RunOff(end)),
            }
        }
        Ok(if self.steps >= last { Reached::End } else { Reached::Steps })
    }

    /// One step.
    fn step(&mut self) -> Result<Result<MarchSample, RunOff>, SlidingError> {
        let step = self.settings.step;
        let drive = self.settings.motion.at((self.steps + 1) as f64 * step);
        let friction = drive.friction * self.pair.friction().at(self.velocity.abs()).coefficient;
        let disturbance = self.disturb(drive.noise);
        let (touch, approach, reaction) = match self.meet(&drive, friction)? {
            Ok(met) => met,
            Err(end) => return Ok(Err(end)),
        };
        let Reaction { normal, tangential, grip } = reaction;
        let force = plus([touch.normal[0] * normal, touch.normal[1] * normal], tangential, touch.tangent);
        let [nn, nt, tn, tt] = approach.compliance;
        let gap = approach.gap + nn * normal + nt * tangential;
        let slip = approach.slip + tn * normal + tt * tangential;
        self.watch(&touch, force, drive.acceleration);
        self.tune(&drive);
        self.drive = drive;
        self.move_on(&touch, force, disturbance);
        self.steps += 1;
        self.at = touch.at;
        self.velocity = slip / step;
        Ok(Ok(MarchSample {
            time: self.steps as f64 * step,
            position: drive.position,
            normal_force: normal,
            tangential_force: tangential,
            sliding_velocity: self.velocity,
            gap,
            friction,
            state: grip.state(self.velocity * self.settings.motion.velocity.signum()),
        }))
    }

    /// The random force on C, which the prediction of its displacement takes in.
    #[inline]
    fn disturb(&mut self, noise: f64) -> PlaneVector {
        if noise == 0.0 {
            return [0.0; 2];
        }
        let left = turned(self.pair.direction());
        let disturbance = left.map(|along| along * noise * self.pair.edge().side);
        self.contact[1] = plus(self.contact[1], 1.0, self.compliance.of_contact(disturbance));
        for (k, own) in self.observed.iter_mut().enumerate() {
            own[2] += self.compliance.of_observed_on_slider(k, disturbance);
        }
        disturbance
    }

    /// Where the contact is in the next step, and its force there.
    #[inline]
    fn meet(
        &mut self,
        drive: &Drive,
        friction: f64,
    ) -> Result<Result<(Touch, Approach, Reaction), RunOff>, SlidingError> {
        if self.scheme == Scheme::CentralDifferences {
            let force = match self.settings.predictor {
                Predictor::Printed => [0.0; 2],
                Predictor::WithForce => self.force,
            };
            return self.meet_under(drive, friction, force);
        }
        let mut force = plus(plus([0.0; 2], 2.0, self.force), -1.0, self.force_before);
        let mut met = self.meet_under(drive, friction, force)?;
        for _ in 1..PASSES {
            let Ok((touch, _, Reaction { normal, tangential, .. })) = &met else { break };
            force = plus([touch.normal[0] * normal, touch.normal[1] * normal], *tangential, touch.tangent);
            met = self.meet_under(drive, friction, force)?;
        }
        Ok(met)
    }

    /// The same where the geometry is that under a force on the slider.
    #[inline]
    fn meet_under(
        &mut self,
        drive: &Drive,
        friction: f64,
        guess: PlaneVector,
    ) -> Result<Result<(Touch, Approach, Reaction), RunOff>, SlidingError> {
        let rigid = self.pair.rigid_place(drive.position);
        let touch = match self.touch(drive, rigid, guess) {
            Ok(touch) => touch,
            Err(end) => return self.beyond(end, drive.position, rigid).map(Err),
        };
        let weights = &touch.weights.value;
        let between = self.compliance.between(&self.view.compliance, weights);
        let [now, predicted] = self.contact;
        let nodes = combined(weights, &self.view.displaced(&self.view.predicted));
        let target = self.first_gap * drive.gap;
        let gap = dot(touch.normal, minus(plus(rigid, 1.0, predicted), nodes))
            + self.settings.motion.initial_gap
            - target;
        // a held contact slides on all the same
        let advance = (drive.position - self.drive.position) * dot(self.pair.direction(), touch.tangent)
            + self.steady * self.settings.step;
        let of_track = minus(combined(weights, &self.view.predicted), combined(weights, &self.view.now));
        let slip = advance + dot(touch.tangent, minus(minus(predicted, now), of_track));
        // a mode without bound carries C away long before its numbers end
        if !slip.is_finite() || gap.is_nan() || gap.abs() > self.pair.length() {
            return Err(self.away(gap, drive.position));
        }
        let approach = Approach { gap, slip, compliance: in_frame(&between, &touch), friction };
        let reaction = match self.settings.method {
            ContactMethod::Film => projected(&approach),
            _ => sliding(&approach, self.direction),
        };
        match reaction {
            Ok(reaction) => Ok(Ok((touch, approach, reaction))),
            Err(locked) => {
                Err(SliderLock { touch, position: drive.position, friction, locked }.error(self.pair))
            }
        }
    }

    /// The touch on the geometry that the method sees.
    #[inline]
    fn touch(&mut self, drive: &Drive, rigid: PlaneVector, guess: PlaneVector) -> Result<Touch, RunOff> {
        let Self { pair, track, view, compliance, contact, at, static_path, .. } = self;
        let edge = pair.edge();
        match (self.settings.method, static_path) {
            (ContactMethod::Subs { .. }, None) => {
                let touch = edge.touch(rigid, *at, |segment| pair.stencil(segment, |_| [0.0; 2]))?;
                look(view, pair, track, compliance, touch.at.segment);
                Ok(touch)
            }
            (_, Some(path)) => {
                // what the full load does, as far as the load is there
                let share = drive.load / self.settings.motion.load;
                let point = plus(rigid, share, path.of_contact(drive.position));
                let of_node = |node| plus([0.0; 2], share, path.of_node(drive.position, node));
                let touch = edge.touch(point, *at, |segment| pair.stencil(segment, of_node))?;
                look(view, pair, track, compliance, touch.at.segment);
                Ok(touch)
            }
            _ => {
                let point = plus(plus(rigid, 1.0, contact[1]), 1.0, compliance.of_contact(guess));
                let is_guessed = guess != [0.0; 2];
                edge.touch(point, *at, |segment| {
                    look(view, pair, track, compliance, segment);
                    let mut by = view.predicted;
                    if is_guessed {
                        let weights = edge.weights(at.seen_from(segment)).value;
                        let moved = view.compliance.of_nodes(&weights, guess);
                        by = std::array::from_fn(|k| plus(by[k], 1.0, moved[k]));
                    }
                    view.displaced(&by)
                })
            }
        }
    }

    /// Accelerations of what is observed, by central differences.
    #[inline]
    fn watch(&mut self, touch: &Touch, force: PlaneVector, rigid: f64) {
        let square = self.settings.step * self.settings.step;
        let (first, count) = (self.view.first, self.view.count);
        for (k, [before, now, predicted]) in self.observed.iter_mut().enumerate() {
            let next = *predicted + self.compliance.of_observed(k, first, count, touch, force);
            self.accelerations[k] =
                (next - 2.0 * *now + *before) / square + self.pair.observed()[k].rigid * rigid;
            (*before, *now) = (*now, next);
        }
    }

    /// Takes over damping, load and inertia of this time into the next prediction.
    #[inline]
    fn tune(&mut self, drive: &Drive) {
        let stair = if self.scheme == Scheme::CentralDifferences { 0.0 } else { STAIR };
        let ends = drive.initial_damping == 0.0 && self.tuned != 0.0;
        let is_retuned = (drive.initial_damping - self.tuned).abs() > stair || ends;
        if is_retuned {
            self.set_recurrences(drive.initial_damping);
        }
        let changed =
            is_retuned || drive.load != self.drive.load || drive.acceleration != self.drive.acceleration;
        if changed {
            self.set_push(drive);
        }
    }

    pub(super) fn set_recurrences(&mut self, share: f64) {
        let step = self.settings.step;
        let bodies =
            [(&self.pair.slider().body, &mut self.slider), (&self.pair.track().body, &mut self.track)];
        for (body, oscillators) in bodies {
            for (mode, value) in body.eigenvalues.iter().enumerate() {
                if self.scheme.moves(*value) {
                    let damping = damping_of(share, &self.settings.motion, body, mode);
                    let recurrence = self.scheme.while_damped(step, *value, body.damping(mode), damping);
                    oscillators.set_recurrence(mode, recurrence);
                }
            }
        }
        for (mode, factor) in self.push_factors.iter_mut().enumerate() {
            *factor = self.slider.recurrence(mode).on_steady_force();
        }
        self.tuned = share;
    }

    /// What load and inertia do to each mode from step to step; both change slowly against a step.
    pub(super) fn set_push(&mut self, drive: &Drive) {
        let (slider, factors) = (self.pair.slider(), &self.push_factors);
        let of = |mode: usize| {
            factors[mode] * (drive.load * slider.load[mode] - drive.acceleration * slider.inertia[mode])
        };
        self.slider.set_push(of);
    }

    /// Both bodies to the next step under the contact's force, and what is seen of them then.
    #[inline]
    fn move_on(&mut self, touch: &Touch, force: PlaneVector, disturbance: PlaneVector) {
        let weights = &touch.weights.value;
        let (on_slider, on_track) = rows_of(force, disturbance, &self.view, weights);
        let moved = self.view.compliance.of_nodes(weights, force);
        for (k, moved) in moved.iter().enumerate().take(self.view.count) {
            self.view.now[k] = plus(self.view.predicted[k], 1.0, *moved);
        }
        self.contact[0] = plus(self.contact[1], 1.0, self.compliance.of_contact(force));
        let (of_slider, of_track) = (self.slider.advance(&on_slider), self.track.advance(&on_track));
        self.contact[1] = self.with_yielding(&of_slider);
        self.view.predicted = vectors(&of_track, self.view.count);
        self.predict_observed(&of_slider, &of_track);
        (self.force_before, self.force) = (self.force, force);
    }

    /// The displacement of C by the rows of its moving modes, with what load and inertia do to the others; both change slowly.
    #[inline]
    pub(super) fn with_yielding(&self, seen: &[f64; ROWS]) -> PlaneVector {
        let Drive { load, acceleration, .. } = self.drive;
        [0, 1].map(|k| {
            let [by_load, by_acceleration] = self.contact_yielding[k];
            seen[k] + load * by_load + acceleration * by_acceleration
        })
    }

    #[inline]
    pub(super) fn predict_observed(&mut self, of_slider: &[f64; ROWS], of_track: &[f64; ROWS]) {
        let mut places = [2, 2 * self.view.count];
        let points = self.pair.observed().iter().zip(&self.observed_yielding);
        for (own, (point, yields)) in self.observed.iter_mut().zip(points) {
            let (seen, k) = if point.side == PairSide::Slider { (of_slider, 0) } else { (of_track, 1) };
            own[2] = seen[places[k]] + self.drive.load * yields[0] + self.drive.acceleration * yields[1];
            places[k] += 1;
        }
    }

    /// Starts from a state at this time, with its prediction.
    pub(super) fn begin(&mut self, start: &MarchStart) {
        self.set_push(&self.drive.clone());
        let at_rows = |force: PlaneVector| {
            rows_of(force, [0.0; 2], &self.view, &self.pair.edge().weights(self.at).value)
        };
        let [(slider_now, track_now), (slider_before, track_before)] = start.forces.map(at_rows);
        let of_slider = self.pair.slider().body.modes();
        let [now, before] = [&start.now, &start.before].map(|state| state.split_at(of_slider));
        self.slider.set_state([now.0, before.0], [&slider_now, &slider_before]);
        self.track.set_state([now.1, before.1], [&track_now, &track_before]);
        let segment = self.view.segment;
        self.view = MarchView::new(self.pair, &mut self.track, &self.compliance, segment);
        let ([now, next], [track_now, track_next]) = (self.slider.seen(), self.track.seen());
        self.contact = [self.with_yielding(&now), self.with_yielding(&next)];
        self.predict_observed(&now, &track_now);
        for own in &mut self.observed {
            (own[0], own[1]) = (own[2], own[2]);
        }
        self.predict_observed(&next, &track_next);
        [self.force, self.force_before] = start.forces;
    }
}

/// Forces at the rows of slider and track, of the contact on the slider and of a disturbance on C.
#[inline(always)]
fn rows_of(
    force: PlaneVector,
    disturbance: PlaneVector,
    view: &MarchView,
    weights: &[f64; STENCIL],
) -> ([f64; ROWS], [f64; ROWS]) {
    let (mut on_slider, mut on_track) = ([0.0; ROWS], [0.0; ROWS]);
    on_slider[..2].copy_from_slice(&plus(force, 1.0, disturbance));
    for (pair, weight) in on_track.as_chunks_mut::<2>().0.iter_mut().zip(weights).take(view.count) {
        *pair = [-weight * force[0], -weight * force[1]];
    }
    (on_slider, on_track)
}

/// Watches the track about another segment.
#[inline(always)]
fn look(
    view: &mut MarchView,
    pair: &crate::pair::Pair,
    track: &mut super::oscillators::Oscillators,
    compliance: &ModalCompliance,
    segment: usize,
) {
    if view.segment != segment {
        *view = MarchView::new(pair, track, compliance, segment);
    }
}
