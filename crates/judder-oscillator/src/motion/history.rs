//! The history of one motion: states on a uniform grid of time, changes of the contact state, oscillations, averages.

mod recorder;

use super::measures::Measures;
use super::{ContactState, Interrupted, SlidingSystem};
use crate::quasi_steady;
use judder_numerics::piecewise::{Advance, GuardCrossing, MarchError, PiecewiseMarch, StepSettings};
use recorder::MotionRecorder;
use std::collections::VecDeque;
use thiserror::Error;

/// What of a motion is kept.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TimeWindow {
    /// How long it is followed.
    pub duration: f64,
    /// The first part of the time, which averages and oscillations leave out.
    pub transient: f64,
    /// Points of the grid of time, both ends included; at least 2.
    pub points: usize,
}

/// A state on the grid of time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StateSample<const N: usize> {
    /// When.
    pub time: f64,
    /// In which contact state.
    pub contact_state: ContactState,
    /// The state.
    pub state: [f64; N],
}

/// Steps that are kept of a path at most.
pub const PATH_POINTS: usize = 20_000;

/// One oscillation, from one largest x to the next.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Oscillation<const N: usize> {
    /// When it ends.
    pub time: f64,
    /// How long it takes.
    pub period: f64,
    /// Half the distance between its smallest and its largest x.
    pub amplitude: f64,
    /// The state at its end, on the section.
    pub state: [f64; N],
}

impl<const N: usize> Oscillation<N> {
    /// (ω − v_d/A_x) τ, eq. (3) of the oscillator paper: a law of steady sliding holds in motion where it is small against 1.
    ///
    /// With ω = 2π over the period and A_x the amplitude, in the units of the oscillator: ṽ_d and τ̃.
    #[must_use]
    pub fn quasi_steady_condition(&self, belt_velocity: f64, retardation_time: f64) -> f64 {
        quasi_steady::in_motion(self.period, self.amplitude, belt_velocity, retardation_time)
    }
}

/// A motion that was followed to the end of its time.
#[derive(Debug, Clone, PartialEq)]
pub struct MotionHistory<const N: usize> {
    /// The states on the grid.
    pub samples: Vec<StateSample<N>>,
    /// The ends of the last [`PATH_POINTS`] steps that do not end in stick, changes of state among them: a slip between two
    /// points of the grid keeps its shape.
    pub path: VecDeque<StateSample<N>>,
    /// All changes of the contact state, those of the transient too.
    pub events: Vec<GuardCrossing<ContactState, N>>,
    /// The oscillations after the transient.
    pub oscillations: Vec<Oscillation<N>>,
    /// Averages and work after the transient.
    pub measures: Measures,
    /// The energy at the end less that at the end of the transient.
    pub energy_change: f64,
    /// The largest energy at the two ends times the tolerance of a step, as often as there are steps: what the motion does not
    /// resolve.
    pub energy_resolution: f64,
    /// Steps used.
    pub steps: usize,
}

impl<const N: usize> MotionHistory<N> {
    /// What the works after the transient leave of the change of energy beyond what the motion resolves, over the largest of them;
    /// zero where nothing moved.
    #[must_use]
    pub fn energy_residual(&self) -> f64 {
        let work = self.measures.work;
        let parts = [work.friction, work.normal, work.damping, self.energy_change];
        let largest = parts.iter().fold(0.0_f64, |largest, part| largest.max(part.abs()));
        let rest = (work.friction + work.normal + work.damping - self.energy_change).abs();
        let beyond = rest - self.energy_resolution;
        if beyond <= 0.0 { 0.0 } else { beyond / largest }
    }
}

/// A motion that cannot be followed to its end, with the last state that was reached.
#[derive(Debug, Clone, PartialEq, Error)]
#[error("{source}; it is in {contact_state}, at the state {state:?}")]
pub struct LostMotion {
    /// Why.
    pub source: MarchError,
    /// The contact state there.
    pub contact_state: ContactState,
    /// The state there: displacements, then their velocities.
    pub state: Vec<f64>,
}

/// What a step of a motion brought that the history keeps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct News<'a, const N: usize> {
    /// The points of the grid of time that it passed.
    pub samples: &'a [StateSample<N>],
    /// The change of the contact state at its end, if there is one.
    pub events: &'a [GuardCrossing<ContactState, N>],
}

/// Follows a motion over a time.
///
/// # Errors
/// The motion cannot be followed: budget of steps, accumulation, a state that is not finite; or it was interrupted.
pub fn follow<const N: usize>(
    system: &impl SlidingSystem<N>,
    start: [f64; N],
    settings: StepSettings<N>,
    window: &TimeWindow,
    interrupted: Interrupted<'_>,
) -> Result<MotionHistory<N>, LostMotion> {
    follow_watched(system, start, settings, window, interrupted, |_| ())
}

/// Follows a motion over a time, and hands each step's [`News`] to `watch` while it goes on: together they are the samples and the
/// events of the history, which is that of [`follow`] to the bit.
///
/// # Errors
/// As [`follow`].
pub fn follow_watched<const N: usize>(
    system: &impl SlidingSystem<N>,
    start: [f64; N],
    settings: StepSettings<N>,
    window: &TimeWindow,
    interrupted: Interrupted<'_>,
    mut watch: impl FnMut(News<'_, N>),
) -> Result<MotionHistory<N>, LostMotion> {
    let mut march = begin(system, start, settings)?;
    let mut recorder = MotionRecorder::new(system, window, settings.relative);
    let mut told = (0, 0);
    for until in [window.transient, window.duration] {
        recorder.begin(&march);
        while march.time() < until {
            if interrupted() {
                return Err(lost(&march, MarchError::Interrupted { time: march.time() }));
            }
            recorder.add(&advance(system, &mut march, until)?);
            told = tell(&recorder.history, told, &mut watch);
        }
    }
    let history = recorder.finish(&march);
    tell(&history, told, &mut watch);
    Ok(history)
}

/// Hands on what has come to a history since `told` samples and events; gives how many there are now.
fn tell<const N: usize>(
    history: &MotionHistory<N>,
    told: (usize, usize),
    watch: &mut impl FnMut(News<'_, N>),
) -> (usize, usize) {
    let (samples, events) = (&history.samples[told.0..], &history.events[told.1..]);
    if !samples.is_empty() || !events.is_empty() {
        watch(News { samples, events });
    }
    (history.samples.len(), history.events.len())
}

/// Follows a cycle once around: from `start`, moved onto the section, for so many returns, which take `period`.
///
/// # Errors
/// As [`follow`].
pub fn follow_cycle<const N: usize>(
    system: &impl SlidingSystem<N>,
    mut start: [f64; N],
    settings: StepSettings<N>,
    returns: usize,
    period: f64,
    points: usize,
) -> Result<MotionHistory<N>, LostMotion> {
    start[N / 2] = 0.0;
    let window = TimeWindow { duration: period, transient: 0.0, points };
    let mut march = begin(system, start, settings)?;
    let mut recorder = MotionRecorder::new(system, &window, settings.relative);
    recorder.begin(&march);
    while recorder.history.oscillations.len() < returns {
        recorder.add(&advance(system, &mut march, f64::INFINITY)?);
    }
    Ok(recorder.finish(&march))
}

fn begin<S: SlidingSystem<N>, const N: usize>(
    system: &S,
    start: [f64; N],
    settings: StepSettings<N>,
) -> Result<PiecewiseMarch<'_, S, N>, LostMotion> {
    let mode = system.starting_mode(&start);
    let march = PiecewiseMarch::new(system, mode, start, settings);
    let march =
        march.map_err(|source| LostMotion { source, contact_state: mode.into(), state: start.to_vec() })?;
    Ok(march.with_section(system.section()))
}

fn advance<S: SlidingSystem<N>, const N: usize>(
    system: &S,
    march: &mut PiecewiseMarch<'_, S, N>,
    until: f64,
) -> Result<Advance<S::Mode, N>, LostMotion> {
    system.advance(march, until).map_err(|source| lost(march, source))
}

fn lost<S: SlidingSystem<N>, const N: usize>(
    march: &PiecewiseMarch<'_, S, N>,
    source: MarchError,
) -> LostMotion {
    LostMotion { source, contact_state: march.mode().into(), state: march.state().to_vec() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::{BeltOscillator, FallingFriction};

    fn belt(damping: f64, velocity: f64) -> BeltOscillator {
        let friction = FallingFriction::exponential([1.0, 0.5], 0.5);
        BeltOscillator::new(damping, 1.0, velocity, friction).unwrap()
    }

    fn settings(steps: usize) -> StepSettings<2> {
        StepSettings { relative: 1e-10, absolute: [1e-10; 2], longest_step: 1.0, steps }
    }

    #[test]
    fn a_stick_slip_motion_is_kept_with_its_events_and_its_energy() {
        let window = TimeWindow { duration: 100.0, transient: 40.0, points: 1001 };
        let history = follow(&belt(0.05, 1.0), [1.0, 1.0], settings(1_000_000), &window, &|| false).unwrap();
        assert_eq!(history.samples.len(), 1001);
        assert_eq!((history.samples[0].time, history.samples[1000].time), (0.0, 100.0));
        for crossing in &history.events {
            // a sticking mass moves with the belt
            let before = history.samples.iter().rev().find(|s| s.time < crossing.time);
            if let Some(sample) = before.filter(|s| s.contact_state == ContactState::Stick) {
                assert_eq!((crossing.from, sample.state[1]), (ContactState::Stick, 1.0));
            }
        }
        // the ends of stick stand on its path, its middle does not
        let stick = |sample: &&StateSample<2>| sample.contact_state == ContactState::Stick;
        let ends = history.events.iter().filter(|event| event.from == ContactState::Stick).count();
        assert_eq!(history.path.iter().filter(stick).count(), ends);
        // a cycle: nothing is stored, what the belt feeds in is dissipated
        assert!(history.energy_residual() < 1e-7, "{:e}", history.energy_residual());
        assert!(history.measures.work.friction > 0.0 && history.measures.work.damping < 0.0);
        let [.., before, last] = history.oscillations[..] else { unreachable!("oscillations") };
        assert!(
            (before.period - last.period).abs() < 1e-6 && (before.amplitude - last.amplitude).abs() < 1e-6
        );
    }

    #[test]
    fn who_watches_sees_it_all_and_changes_nothing() {
        for transient in [0.0, 40.0] {
            let window = TimeWindow { duration: 100.0, transient, points: 1001 };
            let (system, start) = (belt(0.05, 1.0), [1.0, 1.0]);
            let alone = follow(&system, start, settings(1_000_000), &window, &|| false).unwrap();
            let (mut samples, mut events, mut times) = (Vec::new(), Vec::new(), 0);
            let watched = follow_watched(&system, start, settings(1_000_000), &window, &|| false, |news| {
                samples.extend_from_slice(news.samples);
                events.extend_from_slice(news.events);
                times += 1;
            });
            assert_eq!(watched.unwrap(), alone);
            assert_eq!((samples, events), (alone.samples, alone.events));
            assert!(times > 100, "{times}");
        }
    }

    #[test]
    fn an_undamped_swing_has_the_period_and_the_amplitude_of_its_frequency() {
        // far above the speeds of the swing friction is constant
        let window = TimeWindow { duration: 50.0, transient: 0.0, points: 2 };
        let history =
            follow(&belt(0.0, 1000.0), [0.5 + 0.25, 0.0], settings(1_000_000), &window, &|| false).unwrap();
        for oscillation in &history.oscillations {
            assert!((oscillation.period - std::f64::consts::TAU).abs() < 1e-8);
            assert!((oscillation.amplitude - 0.25).abs() < 1e-8);
        }
        assert_eq!(history.oscillations.len(), 7);
    }

    #[test]
    fn at_rest_the_energy_is_kept_to_what_the_motion_resolves() {
        let window = TimeWindow { duration: 50.0, transient: 0.0, points: 2 };
        let system = belt(0.5, 1.0);
        let start = system.steady_sliding();
        let history = follow(&system, start, settings(1_000_000), &window, &|| false).unwrap();
        assert!(history.energy_residual() < 1e-4, "{:e}", history.energy_residual());
    }

    #[test]
    fn an_interrupted_motion_says_where_it_stands() {
        let window = TimeWindow { duration: 100.0, transient: 0.0, points: 2 };
        let asked = std::sync::atomic::AtomicUsize::new(0);
        let interrupted = || asked.fetch_add(1, std::sync::atomic::Ordering::Relaxed) == 5;
        let lost = follow(&belt(0.05, 1.0), [1.0, 1.0], settings(1000), &window, &interrupted).unwrap_err();
        assert!(matches!(lost.source, MarchError::Interrupted { time } if time > 0.0), "{lost}");
    }

    #[test]
    fn a_spent_budget_says_where_the_motion_stands() {
        let window = TimeWindow { duration: 100.0, transient: 0.0, points: 2 };
        let lost = follow(&belt(0.05, 1.0), [1.0, 1.0], settings(50), &window, &|| false).unwrap_err();
        assert!(matches!(lost.source, MarchError::StepsSpent { steps: 50, .. }));
        assert_eq!(lost.state.len(), 2);
        assert!(lost.to_string().contains("at the state ["), "{lost}");
    }
}
