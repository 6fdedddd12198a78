//! Where the indenter goes.

use super::error::TransientError;
use super::substrate::positive;
use crate::unilateral::Loading;
use judder_numerics::order::sort_numbers;
use std::f64::consts::TAU;

/// Steps in a period of an oscillation, at least.
const STEPS_A_PERIOD: f64 = 24.0;
/// Times that steps must end on are closer than this part of the run only if they are the same.
pub(super) const SAME: f64 = 1e-12;

/// A number as a function of time; from time 0 on.
#[derive(Debug, Clone, PartialEq)]
pub enum PathCourse {
    /// The same at all times.
    Constant(f64),
    /// From rest at 0 uniformly faster until `ramp`, from there at constant speed.
    Start {
        /// Speed that is reached.
        speed: f64,
        /// Time until then; 0 for a sudden start.
        ramp: f64,
    },
    /// In a straight line from one value to another, from there constant.
    Ramp {
        /// Value at time 0.
        from: f64,
        /// Value at the end.
        to: f64,
        /// Time until then.
        duration: f64,
    },
    /// mean + drift t + amplitude sin(ω t + phase).
    Oscillation {
        /// Value about which it oscillates at time 0.
        mean: f64,
        /// Mean rate: the speed of sliding, for a position.
        drift: f64,
        /// Amplitude.
        amplitude: f64,
        /// ω, in radians per time unit.
        angular_frequency: f64,
        /// Phase at time 0, in radians.
        phase: f64,
    },
    /// In straight lines between given values, constant after the last.
    Sampled {
        /// Ascending times, the first not after 0.
        times: Vec<f64>,
        /// The values there.
        values: Vec<f64>,
    },
}

impl PathCourse {
    /// mean + amplitude sin ωt.
    #[must_use]
    pub fn sine(mean: f64, amplitude: f64, angular_frequency: f64) -> Self {
        Self::Oscillation { mean, drift: 0.0, amplitude, angular_frequency, phase: 0.0 }
    }

    /// The value at a time.
    #[must_use]
    pub fn at(&self, time: f64) -> f64 {
        match self {
            Self::Constant(value) => *value,
            Self::Start { speed, ramp } if time < *ramp => 0.5 * speed * time * time / ramp,
            Self::Start { speed, ramp } => speed * (time - 0.5 * ramp),
            Self::Ramp { from, to, duration } => from + (to - from) * (time / duration).clamp(0.0, 1.0),
            Self::Oscillation { mean, drift, amplitude, angular_frequency, phase } => {
                mean + drift * time + amplitude * libm::sin(angular_frequency * time + phase)
            }
            Self::Sampled { times, values } => between(times, values, time),
        }
    }

    /// A bound of its rate of change.
    #[must_use]
    pub fn largest_rate(&self) -> f64 {
        match self {
            Self::Constant(_) => 0.0,
            Self::Start { speed, .. } => speed.abs(),
            Self::Ramp { from, to, duration } => ((to - from) / duration).abs(),
            Self::Oscillation { drift, amplitude, angular_frequency, .. } => {
                drift.abs() + (amplitude * angular_frequency).abs()
            }
            Self::Sampled { times, values } => {
                let rises = values.windows(2).map(|pair| pair[1] - pair[0]);
                let rates =
                    rises.zip(times.windows(2)).map(|(rise, pair)| (rise / (pair[1] - pair[0])).abs());
                rates.fold(0.0, f64::max)
            }
        }
    }

    /// Bounds of its values up to a time: smallest and largest.
    #[must_use]
    pub fn range(&self, until: f64) -> [f64; 2] {
        if let Self::Oscillation { mean, drift, amplitude, .. } = self {
            let end = mean + drift * until;
            return [mean.min(end) - amplitude.abs(), mean.max(end) + amplitude.abs()];
        }
        let mut range = [self.at(0.0), self.at(0.0)];
        for time in self.corners(until).into_iter().chain([until]) {
            let value = self.at(time);
            range = [range[0].min(value), range[1].max(value)];
        }
        range
    }

    /// The times up to a last one at which a step should end: where the rate jumps, and every half period.
    #[must_use]
    pub fn corners(&self, until: f64) -> Vec<f64> {
        let inside = |time: &f64| *time > 0.0 && *time < until * (1.0 - SAME);
        match self {
            Self::Constant(_) => Vec::new(),
            Self::Start { ramp, .. } => Some(*ramp).into_iter().filter(inside).collect(),
            Self::Ramp { duration, .. } => Some(*duration).into_iter().filter(inside).collect(),
            Self::Oscillation { angular_frequency, .. } => {
                let half = 0.5 * TAU / angular_frequency;
                (1_u64..).map(|count| count as f64 * half).take_while(inside).collect()
            }
            Self::Sampled { times, .. } => times.iter().copied().filter(inside).collect(),
        }
    }

    /// The longest step that does not miss what happens.
    #[must_use]
    pub fn longest_step(&self) -> f64 {
        match self {
            Self::Oscillation { angular_frequency, .. } => TAU / (angular_frequency * STEPS_A_PERIOD),
            _ => f64::INFINITY,
        }
    }

    /// Refuses numbers that are not finite, durations and frequencies that are not positive, samples out of order.
    ///
    /// # Errors
    /// [`TransientError::NotFinite`], [`TransientError::NotPositive`], [`TransientError::SampleTimes`],
    /// [`TransientError::SampleCount`].
    pub fn check(&self) -> Result<(), TransientError> {
        match self {
            Self::Constant(value) => finite("constant value", *value),
            Self::Start { speed, ramp } => {
                finite("speed", *speed)?;
                if *ramp == 0.0 { Ok(()) } else { positive("time of the start", *ramp) }
            }
            Self::Ramp { from, to, duration } => {
                finite("first value", *from)?;
                finite("last value", *to)?;
                positive("duration of the ramp", *duration)
            }
            Self::Oscillation { mean, drift, amplitude, angular_frequency, phase } => {
                finite("mean", *mean)?;
                finite("drift", *drift)?;
                finite("amplitude", *amplitude)?;
                finite("phase", *phase)?;
                positive("angular frequency", *angular_frequency)
            }
            Self::Sampled { times, values } => check_samples(times, values),
        }
    }
}

fn finite(what: &'static str, value: f64) -> Result<(), TransientError> {
    if value.is_finite() { Ok(()) } else { Err(TransientError::NotFinite { what, value }) }
}

fn check_samples(times: &[f64], values: &[f64]) -> Result<(), TransientError> {
    if times.len() != values.len() || times.len() < 2 {
        return Err(TransientError::SampleCount { times: times.len(), values: values.len() });
    }
    times.iter().try_for_each(|time| finite("time of a sample", *time))?;
    values.iter().try_for_each(|value| finite("value of a sample", *value))?;
    if times[0] > 0.0 {
        return Err(TransientError::SampleTimes { index: 0, time: times[0] });
    }
    match times.windows(2).position(|pair| pair[1] <= pair[0]) {
        Some(index) => Err(TransientError::SampleTimes { index: index + 1, time: times[index + 1] }),
        None => Ok(()),
    }
}

fn between(times: &[f64], values: &[f64], time: f64) -> f64 {
    let next = times.partition_point(|sample| *sample <= time);
    if next == 0 {
        return values[0];
    }
    if next == times.len() {
        return values[next - 1];
    }
    let part = (time - times[next - 1]) / (times[next] - times[next - 1]);
    values[next - 1] + part * (values[next] - values[next - 1])
}

/// What is imposed on the indenter across the surface.
#[derive(Debug, Clone, PartialEq)]
pub enum NormalCourse {
    /// δ(t), depth of the lowest point below the undeformed surface, in R; below 0 the indenter is lifted.
    Indentation(PathCourse),
    /// F(t), in E0* R²; without contact where it is not positive.
    Load(PathCourse),
}

/// The path of an indenter: along the surface by its position, across it by depth or force.
#[derive(Debug, Clone, PartialEq)]
pub struct IndenterPath {
    /// x of the indenter's lowest point, in R.
    pub position: PathCourse,
    /// Depth or force.
    pub normal: NormalCourse,
}

impl IndenterPath {
    /// An indenter at rest along the surface.
    #[must_use]
    pub fn at_rest(normal: NormalCourse) -> Self {
        Self { position: PathCourse::Constant(0.0), normal }
    }

    /// Start of sliding: uniformly faster until the time `ramp`, then steady.
    #[must_use]
    pub fn start_of_sliding(speed: f64, ramp: f64, normal: NormalCourse) -> Self {
        Self { position: PathCourse::Start { speed, ramp }, normal }
    }

    /// To and fro: x = amplitude · sin ωt.
    #[must_use]
    pub fn reciprocation(amplitude: f64, angular_frequency: f64, normal: NormalCourse) -> Self {
        Self { position: PathCourse::sine(0.0, amplitude, angular_frequency), normal }
    }

    pub(super) fn normal_course(&self) -> &PathCourse {
        match &self.normal {
            NormalCourse::Indentation(course) | NormalCourse::Load(course) => course,
        }
    }

    /// What is imposed at a time.
    #[must_use]
    pub fn loading(&self, time: f64) -> Loading {
        match &self.normal {
            NormalCourse::Indentation(course) => Loading::Indentation(course.at(time)),
            NormalCourse::Load(course) => Loading::Load(course.at(time)),
        }
    }

    /// The times at which steps end whatever their error: corners of both courses, given times, the end.
    pub(super) fn landings(&self, duration: f64, given: &[f64]) -> Vec<f64> {
        let mut times = self.position.corners(duration);
        times.extend(self.normal_course().corners(duration));
        times.extend(given.iter().copied().filter(|time| *time > 0.0));
        times.push(duration);
        sort_numbers(&mut times);
        times.dedup_by(|later, earlier| *later - *earlier <= SAME * duration);
        times
    }

    pub(super) fn longest_step(&self) -> f64 {
        self.position.longest_step().min(self.normal_course().longest_step())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_start_is_smooth_where_it_becomes_steady() {
        let start = PathCourse::Start { speed: 2.0, ramp: 0.5 };
        assert!((start.at(0.5) - 0.5).abs() < 1e-15 && (start.at(1.5) - 2.5).abs() < 1e-15);
        assert!((start.at(0.5 + 1e-7) - start.at(0.5 - 1e-7) - 4e-7).abs() < 1e-12);
        assert_eq!(start.corners(2.0), [0.5]);
    }

    #[test]
    fn samples_are_joined_by_straight_lines() {
        let course = PathCourse::Sampled { times: vec![0.0, 1.0, 3.0], values: vec![0.0, 2.0, -2.0] };
        assert_eq!([course.at(0.5), course.at(2.0), course.at(9.0)], [1.0, 0.0, -2.0]);
        assert_eq!((course.largest_rate(), course.range(3.0)), (2.0, [-2.0, 2.0]));
    }

    #[test]
    fn steps_end_on_corners_and_given_times_once() {
        let path = IndenterPath::reciprocation(1.0, TAU, NormalCourse::Load(PathCourse::Constant(1.0)));
        assert_eq!(path.landings(2.0, &[0.5, 0.7]), [0.5, 0.7, 1.0, 1.5, 2.0]);
    }

    #[test]
    fn samples_out_of_order_are_refused_with_their_number() {
        let course = PathCourse::Sampled { times: vec![0.0, 1.0, 1.0], values: vec![0.0; 3] };
        assert_eq!(course.check(), Err(TransientError::SampleTimes { index: 2, time: 1.0 }));
        let course = PathCourse::Sampled { times: vec![0.0, 1.0], values: vec![0.0, f64::NAN] };
        assert!(matches!(course.check(), Err(TransientError::NotFinite { .. })));
    }
}
