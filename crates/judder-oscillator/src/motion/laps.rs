//! Laps of a motion by the two other engines, from one largest x to a later one.
//!
//! A cycle is known from its return map, which the two other engines do not have. Laps take from an engine no more than its
//! states.

use super::{ContactState, Interrupted, Smoothed, TimeStepping};
use judder_numerics::piecewise::{Leg, MarchError, PiecewiseMarch, SectionPlane, StepSettings};
use judder_numerics::quadrature::gauss_legendre;
use std::ops::Add;
use std::sync::LazyLock;

/// Exact for the squares of the quartics along a step.
static NODES: LazyLock<[(f64, f64); 5]> = LazyLock::new(gauss_legendre::<5>);

/// What is averaged over a time: x about a fixed place.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Moments {
    /// The time.
    pub duration: f64,
    first: f64,
    second: f64,
}

impl Moments {
    /// The root mean square of x about its mean; NaN over no time.
    #[must_use]
    pub fn rms(&self) -> f64 {
        let mean = self.first / self.duration;
        (self.second / self.duration - mean * mean).max(0.0).sqrt()
    }

    /// Adds a time over which x goes straight from one value to another.
    fn add_straight(&mut self, duration: f64, from: f64, to: f64) {
        self.duration += duration;
        self.first += duration * 0.5 * (from + to);
        self.second += duration * (from * from + from * to + to * to) / 3.0;
    }

    fn add_leg<const N: usize>(&mut self, leg: &Leg<ContactState, N>, centre: f64) {
        self.duration += leg.step;
        for (node, weight) in NODES.iter() {
            let (x, share) = (leg.at(*node)[0] - centre, weight * leg.step);
            self.first += share * x;
            self.second += share * x * x;
        }
    }
}

impl Add for Moments {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            duration: self.duration + other.duration,
            first: self.first + other.first,
            second: self.second + other.second,
        }
    }
}

/// Which laps are followed, and how far.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LapCourse {
    /// Where the motion starts.
    pub start: [f64; 4],
    /// The place about which moments are taken; near the motion it keeps their digits.
    pub centre: f64,
    /// Returns to the section in a lap.
    pub returns: usize,
    /// Laps that are asked.
    pub laps: usize,
    /// The longest time.
    pub longest: f64,
    /// The most steps.
    pub steps: usize,
}

/// The laps that were followed, and the state at the end: fewer laps than asked where the time or the steps did
/// not do, and after an interruption.
#[derive(Debug, Clone, PartialEq)]
pub struct Laps {
    /// One by one.
    pub laps: Vec<Moments>,
    /// The last state.
    pub state: [f64; 4],
}

/// Counts returns and closes laps.
struct Counter {
    open: Moments,
    laps: Vec<Moments>,
    returns: usize,
}

impl Counter {
    fn new() -> Self {
        Self { open: Moments::default(), laps: Vec::new(), returns: 0 }
    }

    fn returned(&mut self, course: &LapCourse) {
        self.returns += 1;
        if self.returns.is_multiple_of(course.returns) {
            self.laps.push(std::mem::take(&mut self.open));
        }
    }

    fn is_done(&self, course: &LapCourse) -> bool {
        self.laps.len() >= course.laps
    }
}

/// The laps of a motion under time-stepping. A return within a step is where x̃′ is zero on the straight line between its ends.
#[must_use]
pub fn by_time_stepping(engine: &TimeStepping, course: &LapCourse, interrupted: Interrupted<'_>) -> Laps {
    let (mut counter, mut state) = (Counter::new(), course.start);
    let step = engine.step();
    let affordable = ((course.longest / step) as usize).min(course.steps);
    for _ in 0..affordable {
        if counter.is_done(course) || interrupted() {
            break;
        }
        let (next, _) = engine.advance(&state);
        let (from, to) = (state[0] - course.centre, next[0] - course.centre);
        if state[2] > 0.0 && next[2] <= 0.0 {
            let fraction = state[2] / (state[2] - next[2]);
            let turn = from + fraction * (to - from);
            counter.open.add_straight(fraction * step, from, turn);
            counter.returned(course);
            counter.open.add_straight((1.0 - fraction) * step, turn, to);
        } else {
            counter.open.add_straight(step, from, to);
        }
        state = next;
    }
    Laps { laps: counter.laps, state }
}

/// The laps of a motion with a smoothed sign.
///
/// # Errors
/// The motion cannot be followed.
pub fn with_smoothed_sign(
    system: &Smoothed,
    section: SectionPlane<4>,
    settings: StepSettings<4>,
    course: &LapCourse,
    interrupted: Interrupted<'_>,
) -> Result<Laps, MarchError> {
    let mut counter = Counter::new();
    let settings = StepSettings { steps: course.steps, ..settings };
    let start = section.project(&course.start);
    let mut march =
        PiecewiseMarch::new(system, system.contact_state(&start), start, settings)?.with_section(section);
    while !counter.is_done(course) && march.time() < course.longest && !interrupted() {
        let advance = march.advance(course.longest)?;
        if let Some(leg) = &advance.leg {
            counter.open.add_leg(leg, course.centre);
        }
        if advance.on_section {
            counter.returned(course);
        }
    }
    Ok(Laps { laps: counter.laps, state: march.state() })
}
