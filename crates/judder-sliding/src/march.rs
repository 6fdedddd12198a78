//! Marches: the coupled structures through time, with a contact point that moves.
//!
//! The four methods differ in the geometry and the force of the contact only, and in how a mode goes from step to step; structures,
//! interpolation and outputs are the same.

mod checkpoint;
mod compliance;
mod departure;
mod lock;
mod oscillators;
mod reaction;
mod scheme;
mod statically;
mod step;
mod view;
#[cfg(test)]
mod widths;

use crate::SlidingError;
use crate::body::Body;
use crate::coupling::SteadyFriction;
use crate::edge::{EdgePoint, Interpolation, RunOff, STENCIL};
use crate::motion::{Drive, Motion};
use crate::pair::{Observed, Pair, PairSide};
use crate::plane::PlaneVector;
pub use checkpoint::Checkpoint;
use compliance::ModalCompliance;
pub use judder_numerics::contact_state::ContactState;
use oscillators::{ModalRecurrence, Oscillators, ROWS};
use scheme::Scheme;
use statically::StaticPath;
use std::f64::consts::TAU;
use view::MarchView;

/// How the contact is found and its force computed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ContactMethod {
    /// Sliding that is known beforehand, on the undeformed edge (section 2.2), or on the edge that steady sliding deforms.
    Subs {
        /// Whether the edge has the slope of steady sliding.
        static_slope: bool,
    },
    /// Sliding on the deformed edge (section 3).
    EnSubs,
    /// Stick, slip or lift-off on the deformed edge by forward increment Lagrange multipliers (section 2.1).
    Film,
    /// Sliding on the deformed edge; modes integrated exactly between contacts, those above a cut-off only with their flexibility.
    ResidualFlexibility {
        /// Modes from this frequency on only yield, Hz.
        cut_off: f64,
    },
}

impl ContactMethod {
    fn scheme(self) -> Scheme {
        match self {
            Self::ResidualFlexibility { cut_off } => Scheme::Exact { cut_off: TAU * cut_off },
            _ => Scheme::CentralDifferences,
        }
    }
}

/// Which displacements of the next step the geometry of the contact is taken from, by EnSubs and FiLM.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "keys", derive(judder_keys::Choice), choice(what = "predictor"))]
pub enum Predictor {
    /// Those without the contact's force, as equation (16) of the beams paper has them.
    ///
    /// What the force does to the slope at the contact is then missing, an error of second order in the step, but of about 1 % in the
    /// bursts of the paper's pair at its step.
    Printed,
    /// Those under the force of the last step.
    #[default]
    WithForce,
}

/// What a march is to do.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MarchSettings {
    /// By which method.
    pub method: ContactMethod,
    /// Where its geometry comes from.
    pub predictor: Predictor,
    /// The time step, s.
    pub step: f64,
    /// What is prescribed.
    pub motion: Motion,
}

/// One step of a march.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MarchSample {
    /// Since the start, s.
    pub time: f64,
    /// Distance of C from the track's first node without deformation, m.
    pub position: f64,
    /// N, on the slider along the normal, N.
    pub normal_force: f64,
    /// T, on the slider along the tangent, N: negative where it is dragged back.
    pub tangential_force: f64,
    /// How fast C moves along the track's own material, m/s.
    pub sliding_velocity: f64,
    /// Between C and the track after the step, m, on the geometry of the step.
    pub gap: f64,
    /// μ in this step.
    pub friction: f64,
    /// Stick, slip along the path or against it, lift-off.
    pub state: ContactState,
}

/// What takes the steps of a march as they come.
pub trait Sink {
    /// One step, with the accelerations of the observed displacements in m/s² (those of the step before: they are central
    /// differences).
    fn take(&mut self, sample: &MarchSample, accelerations: &[f64]);

    /// Before that, each observed displacement in m after this step, without what the slider's frame has moved, and where that frame
    /// is; passed over where nobody wants it.
    fn displaced(&mut self, _point: usize, _displacement: f64, _position: f64) {}
}

impl<F: FnMut(&MarchSample, &[f64])> Sink for F {
    fn take(&mut self, sample: &MarchSample, accelerations: &[f64]) {
        self(sample, accelerations);
    }
}

/// How far a march has come.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reached {
    /// All steps that were asked for.
    Steps,
    /// The end of the path.
    End,
    /// An end of the track, before the end of the path.
    RunOff(RunOff),
}

/// Gap at the start that is rounding, as a share of a segment.
const GAP_ROUNDING: f64 = 1e-12;

/// A march: its structures' states and the contact between them.
#[derive(Debug, Clone)]
pub struct March<'a> {
    pair: &'a Pair,
    settings: MarchSettings,
    scheme: Scheme,
    step_limit: f64,
    /// Gap at the start, as the structures lie undeformed, m.
    first_gap: f64,
    /// σ.
    direction: f64,
    slider: Oscillators,
    track: Oscillators,
    compliance: ModalCompliance,
    static_path: Option<StaticPath>,
    view: MarchView,
    steps: u64,
    at: EdgePoint,
    drive: Drive,
    /// Displacements of C now and without contact in the next step.
    contact: [PlaneVector; 2],
    /// Observed displacements: before, now, predicted.
    observed: Vec<[f64; 3]>,
    accelerations: Vec<f64>,
    velocity: f64,
    /// Sliding velocity along the tangent that a held contact has beside its motion, m/s.
    steady: f64,
    force: PlaneVector,
    force_before: PlaneVector,
    /// Share of the initial damping that the recurrences have.
    tuned: f64,
    /// How far C yields in the modes that do not move, per unit of load and of acceleration of the slider's frame.
    contact_yielding: [[f64; 2]; 2],
    /// The same of the observed displacements.
    observed_yielding: Vec<[f64; 2]>,
    /// What a unit of steady modal force does to each of the slider's modes in a step.
    push_factors: Vec<f64>,
}

/// A state from which a march starts.
#[derive(Debug, Clone, PartialEq)]
pub struct MarchStart {
    /// Modal coordinates, √kg m.
    pub now: Vec<f64>,
    /// Those one step before.
    pub before: Vec<f64>,
    /// The contact's force on the slider now and one step before, N.
    pub forces: [PlaneVector; 2],
}

impl<'a> March<'a> {
    /// A march from rest without load.
    ///
    /// # Errors
    /// [`SlidingError::StepOverLimit`], [`SlidingError::InvalidNumber`] for a motion or step that is none, [`SlidingError::OffTrack`],
    /// [`SlidingError::OpenAtStart`] for a gap that has no ramp to close it, and what [`crate::statics::PairEquilibrium::new`] says where
    /// the static slope is asked for.
    pub fn new(pair: &'a Pair, settings: MarchSettings) -> Result<Self, SlidingError> {
        settings.motion.check()?;
        let march = Self::beyond_limit(pair, settings)?;
        if settings.step > march.step_limit {
            return Err(SlidingError::StepOverLimit { step: settings.step, limit: march.step_limit });
        }
        Ok(march)
    }

    /// A march with the contact held at the start of its motion, from a given state; friction is that of its speed.
    ///
    /// # Errors
    /// [`SlidingError::StepOverLimit`], [`SlidingError::InvalidNumber`], [`SlidingError::OffTrack`], and what
    /// [`crate::statics::PairEquilibrium::new`] says, as of [`March::new`]; [`SlidingError::Length`] for a state of other modes. The gap is
    /// that of the state: a track that is curved without load may lie away from C.
    pub fn held(pair: &'a Pair, settings: MarchSettings, start: &MarchStart) -> Result<Self, SlidingError> {
        for (name, state) in [("the state now", &start.now), ("the state before", &start.before)] {
            if state.len() != pair.modes() {
                let (name, found) = (name.to_owned(), state.len());
                return Err(SlidingError::Length { name, found, expected: pair.modes() });
            }
        }
        let motion = settings.motion.held(settings.motion.start);
        let mut march = Self::of_any_step(pair, MarchSettings { motion, ..settings })?;
        if settings.step > march.step_limit {
            return Err(SlidingError::StepOverLimit { step: settings.step, limit: march.step_limit });
        }
        march.direction = if settings.motion.velocity < 0.0 { -1.0 } else { 1.0 };
        (march.steady, march.velocity) = (settings.motion.velocity, settings.motion.velocity);
        if !matches!(settings.method, ContactMethod::Subs { .. }) {
            march.at = pair.deformed(motion.start, &start.now)?.at;
            march.view = MarchView::new(pair, &mut march.track, &march.compliance, march.at.segment);
        }
        march.begin(start);
        Ok(march)
    }

    /// As [`March::new`], with any step: to see what the limit guards against.
    ///
    /// # Errors
    /// As of [`March::new`], but for the limit.
    pub fn beyond_limit(pair: &'a Pair, settings: MarchSettings) -> Result<Self, SlidingError> {
        let motion = settings.motion;
        let touch = pair.undeformed(motion.start)?;
        let gap = touch.gap + motion.initial_gap;
        if motion.ramps.gap == 0.0 && gap.abs() > GAP_ROUNDING * touch.stretch {
            return Err(SlidingError::OpenAtStart { gap, position: motion.start });
        }
        Self::of_any_step(pair, settings)
    }

    /// From rest, whatever the step and the gap.
    fn of_any_step(pair: &'a Pair, settings: MarchSettings) -> Result<Self, SlidingError> {
        let MarchSettings { method, step, motion, .. } = settings;
        if !(step.is_finite() && step > 0.0) {
            let (name, requirement) = ("the step".to_owned(), "finite and positive");
            return Err(SlidingError::InvalidNumber { name, value: step, requirement });
        }
        pair.edge_point(motion.end)?;
        let touch = pair.undeformed(motion.start)?;
        let first_gap = touch.gap + motion.initial_gap;
        let scheme = method.scheme();
        let initial = motion.initial_damping.map(|damping| (damping.alpha, damping.beta));
        let friction = pair.friction().bound(motion.velocity.abs());
        let step_limit = scheme::step_limit(pair, scheme, initial, [motion.start, motion.end], friction)?;
        let drive = motion.at(0.0);
        let damping = damping(pair, &motion, drive.initial_damping);
        let [slider, mut track] = oscillators(pair, scheme, step, &damping)?;
        let push_factors =
            (0..slider.modes()).map(|mode| slider.recurrence(mode).on_steady_force()).collect();
        let modes = pair.eigenvalues().into_iter().zip(pair.damping());
        let factors: Vec<f64> = modes.map(|(v, own)| scheme.at_once(step, v, own)).collect();
        let compliance = ModalCompliance::new(pair, &factors);
        let static_path = if method == (ContactMethod::Subs { static_slope: true }) {
            let sliding = SteadyFriction::at(pair.friction(), motion.velocity);
            Some(StaticPath::new(pair, [motion.start, motion.end], motion.load, sliding)?)
        } else {
            None
        };
        let view = MarchView::new(pair, &mut track, &compliance, touch.at.segment);
        let watched = pair.observed().len();
        let mut march = Self {
            pair,
            settings,
            scheme,
            step_limit,
            first_gap,
            direction: if motion.velocity < 0.0 { -1.0 } else { 1.0 },
            slider,
            track,
            compliance,
            static_path,
            view,
            steps: 0,
            at: touch.at,
            drive,
            contact: [[0.0; 2]; 2],
            observed: vec![[0.0; 3]; watched],
            accelerations: vec![0.0; watched],
            velocity: drive.velocity,
            steady: 0.0,
            force: [0.0; 2],
            force_before: [0.0; 2],
            tuned: drive.initial_damping,
            contact_yielding: [0, 1].map(|k| yielding(pair, scheme, &pair.slider().contact.rows[k])),
            observed_yielding: observed_yielding(pair, scheme),
            push_factors,
        };
        let rest = vec![0.0; pair.modes()];
        march.begin(&MarchStart { now: rest.clone(), before: rest, forces: [[0.0; 2]; 2] });
        Ok(march)
    }
}

/// α + β λ of a mode, with this share of the initial damping in place of the structure's own, 1/s.
fn damping_of(share: f64, motion: &Motion, body: &Body, mode: usize) -> f64 {
    let own = body.damping(mode);
    motion.initial_damping.map_or(own, |initial| {
        share * (initial.alpha + initial.beta * body.eigenvalues[mode]) + (1.0 - share) * own
    })
}

/// The same of all modes, the slider's first.
fn damping(pair: &Pair, motion: &Motion, share: f64) -> Vec<f64> {
    let of =
        |body: &Body| (0..body.modes()).map(|mode| damping_of(share, motion, body, mode)).collect::<Vec<_>>();
    [of(&pair.slider().body), of(&pair.track().body)].concat()
}

/// Slider and track as the modes that move, with rows for the contact and behind them those of the observed displacements.
fn oscillators(
    pair: &Pair,
    scheme: Scheme,
    step: f64,
    damping: &[f64],
) -> Result<[Oscillators; 2], SlidingError> {
    let observed = observed_rows(pair)?;
    let (eigenvalues, slider_modes) = (pair.eigenvalues(), pair.slider().body.modes());
    let modes = eigenvalues.iter().zip(pair.damping()).zip(damping);
    let recurrences: Vec<ModalRecurrence> =
        modes.map(|((v, own), d)| scheme.while_damped(step, *v, own, *d)).collect();
    let moving = |from: usize, to: usize| {
        let count = eigenvalues[from..to].iter().filter(|value| scheme.moves(**value)).count();
        &recurrences[from..from + count]
    };
    let mut places = [2, 2 * pair.edge().stencil_nodes()];
    let mut slider = Oscillators::new(moving(0, slider_modes), places[0] + observed[0]);
    let mut track = Oscillators::new(moving(slider_modes, pair.modes()), places[1] + observed[1]);
    slider.set_row(0, &pair.slider().contact.rows[0]);
    slider.set_row(1, &pair.slider().contact.rows[1]);
    for point in pair.observed() {
        let (body, k) = if point.side == PairSide::Slider { (&mut slider, 0) } else { (&mut track, 1) };
        body.set_row(places[k], &point.row);
        places[k] += 1;
    }
    Ok([slider, track])
}

/// How far a displacement of the slider yields in the modes that do not move, under a unit load, m/N, and a unit acceleration of the
/// slider's frame, s².
fn yielding(pair: &Pair, scheme: Scheme, row: &[f64]) -> [f64; 2] {
    let slider = pair.slider();
    let of = |forces: &[f64], sign: f64| {
        let modes = slider.body.eigenvalues.iter().zip(row).zip(forces);
        modes.filter(|((value, _), _)| !scheme.moves(**value)).map(|((v, r), f)| sign * r * f / v).sum()
    };
    [of(&slider.load, 1.0), of(&slider.inertia, -1.0)]
}

/// The same of every observed displacement; those of the track feel neither load nor inertia.
fn observed_yielding(pair: &Pair, scheme: Scheme) -> Vec<[f64; 2]> {
    let of = |point: &Observed| match point.side {
        PairSide::Slider => yielding(pair, scheme, &point.row),
        PairSide::Track => [0.0; 2],
    };
    pair.observed().iter().map(of).collect()
}

/// How many displacements of a body a march can watch: the contact takes its part of the rows.
#[must_use]
pub fn most_observed(side: PairSide, interpolation: Interpolation) -> usize {
    match side {
        PairSide::Slider => ROWS - 2,
        PairSide::Track => match interpolation {
            Interpolation::Linear => ROWS - 2 * 2,
            Interpolation::Hermite => ROWS - 2 * STENCIL,
        },
    }
}

/// Observed displacements of slider and track, as many as there is room for.
fn observed_rows(pair: &Pair) -> Result<[usize; 2], SlidingError> {
    let sides = [PairSide::Slider, PairSide::Track];
    let observed = sides.map(|side| pair.observed().iter().filter(|point| point.side == side).count());
    let most = sides.map(|side| most_observed(side, pair.edge().interpolation));
    match (0..2).find(|k| observed[*k] > most[*k]) {
        Some(k) => {
            let name = "the list of observed displacements".to_owned();
            Err(SlidingError::Length { name, found: observed[k], expected: most[k] })
        }
        None => Ok(observed),
    }
}
