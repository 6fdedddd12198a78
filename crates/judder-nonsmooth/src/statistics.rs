//! What the points of a march do on average.

use crate::NonsmoothError;
use crate::contact_problem::PointMotion;
use crate::march::NonsmoothMarch;
use serde::{Deserialize, Serialize};

/// Sums over the steps of a march, point by point; written and read back they go on as they were.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Statistics {
    steps: u64,
    points: Vec<PointSums>,
    /// Steps of a batch.
    length: u64,
    /// The batches, the last of them growing, each of all points.
    batches: usize,
    of_batches: Vec<BatchSums>,
}

#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
struct PointSums {
    stick: u64,
    slip: u64,
    open: u64,
    /// About its first value, so that a small motion on a large mean keeps its digits.
    origin: f64,
    velocity: f64,
    squared: f64,
    normal: f64,
    friction: f64,
}

/// Batches that errors are taken from, at least; twice as many become half as many of twice the length.
const BATCHES: usize = 20;

/// Sums over one batch of steps.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
struct BatchSums {
    stick: u64,
    slip: u64,
    open: u64,
    velocity: f64,
    squared: f64,
    normal: f64,
    friction: f64,
}

/// What a point did.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PointStatistics {
    /// Share of the steps in which it moved with the track.
    pub stick_share: f64,
    /// In which it slid.
    pub slip_share: f64,
    /// In which it carried no force.
    pub open_share: f64,
    /// Root mean square of the velocity along the slip about its mean, in m/s.
    pub tangential_velocity_rms: f64,
    /// Mean N in N.
    pub normal_force_mean: f64,
    /// Mean friction on the slider along the slip of steady sliding, in N.
    pub friction_force_mean: f64,
    /// How far they may be off; none of less than 20 steps.
    pub errors: Option<StatisticErrors>,
}

/// Standard errors of averages over a motion whose steps hang on each other, by batch means: the scatter of the averages over twenty to forty batches of
/// steps, over √(their number). They hold where a batch is longer than the motion remembers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StatisticErrors {
    /// Of the share of stick.
    pub stick_share: f64,
    /// Of slip.
    pub slip_share: f64,
    /// Of the steps without force.
    pub open_share: f64,
    /// Of the rms: that of the mean square about the mean, over twice the rms; in m/s.
    pub tangential_velocity_rms: f64,
    /// Of the mean N in N.
    pub normal_force_mean: f64,
    /// Of the mean friction in N.
    pub friction_force_mean: f64,
}

impl Statistics {
    /// Of so many points, before the first step.
    #[must_use]
    pub fn new(points: usize) -> Self {
        Self {
            steps: 0,
            points: vec![PointSums::default(); points],
            length: 1,
            batches: 0,
            of_batches: vec![BatchSums::default(); 2 * BATCHES * points],
        }
    }

    /// Goes on with the sums of an earlier run.
    ///
    /// # Errors
    /// [`NonsmoothError::ForeignCheckpoint`] where they are those of other points.
    pub fn resume(&mut self, kept: &Self) -> Result<(), NonsmoothError> {
        let fits = kept.points.len() == self.points.len()
            && kept.of_batches.len() == self.of_batches.len()
            && kept.batches <= 2 * BATCHES;
        if !fits {
            return Err(NonsmoothError::ForeignCheckpoint);
        }
        self.clone_from(kept);
        Ok(())
    }

    /// Takes the step that a march is at.
    pub fn take(&mut self, march: &NonsmoothMarch<'_>) {
        self.begin_step();
        for point in 0..self.points.len() {
            let [_, velocity, _] = march.velocity(point);
            let [normal, friction, _] = march.force(point);
            self.take_point(point, march.motion(point), velocity, [normal, friction]);
        }
    }

    fn begin_step(&mut self) {
        if self.steps == self.length * self.batches as u64 {
            if self.batches == 2 * BATCHES {
                self.join_batches();
            }
            self.batches += 1;
        }
        self.steps += 1;
    }

    /// Makes one batch of each two.
    fn join_batches(&mut self) {
        let points = self.points.len();
        for (joined, k) in (0..BATCHES).flat_map(|batch| (0..points).map(move |point| (batch, point))) {
            let [a, b] = [0, 1].map(|half| self.of_batches[(2 * joined + half) * points + k]);
            self.of_batches[joined * points + k] = BatchSums {
                stick: a.stick + b.stick,
                slip: a.slip + b.slip,
                open: a.open + b.open,
                velocity: a.velocity + b.velocity,
                squared: a.squared + b.squared,
                normal: a.normal + b.normal,
                friction: a.friction + b.friction,
            };
        }
        self.of_batches[BATCHES * points..].fill(BatchSums::default());
        (self.length, self.batches) = (2 * self.length, BATCHES);
    }

    fn take_point(&mut self, point: usize, motion: PointMotion, velocity: f64, [normal, friction]: [f64; 2]) {
        let points = self.points.len();
        let sums = &mut self.points[point];
        let batch = &mut self.of_batches[(self.batches - 1) * points + point];
        let [all, own] = match motion {
            PointMotion::Stick => [&mut sums.stick, &mut batch.stick],
            PointMotion::Slip => [&mut sums.slip, &mut batch.slip],
            PointMotion::Open => [&mut sums.open, &mut batch.open],
        };
        *all += 1;
        *own += 1;
        if self.steps == 1 {
            sums.origin = velocity;
        }
        let deviation = velocity - sums.origin;
        sums.velocity += deviation;
        sums.squared += deviation * deviation;
        batch.velocity += deviation;
        batch.squared += deviation * deviation;
        batch.normal += normal;
        batch.friction += friction;
        sums.normal += normal;
        sums.friction += friction;
    }

    /// Steps taken.
    #[must_use]
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// What a point did; of no steps nothing.
    #[must_use]
    pub fn of(&self, point: usize) -> Option<PointStatistics> {
        let sums = self.points.get(point).filter(|_| self.steps > 0)?;
        let steps = self.steps as f64;
        let mean = sums.velocity / steps;
        let rms = (sums.squared / steps - mean * mean).max(0.0).sqrt();
        Some(PointStatistics {
            stick_share: sums.stick as f64 / steps,
            slip_share: sums.slip as f64 / steps,
            open_share: sums.open as f64 / steps,
            tangential_velocity_rms: rms,
            normal_force_mean: sums.normal / steps,
            friction_force_mean: sums.friction / steps,
            errors: self.errors(point, mean, rms),
        })
    }

    /// Standard errors of the means of N and friction of all points together, in N; none of less than 20 steps.
    #[must_use]
    pub fn force_errors(&self) -> Option<[f64; 2]> {
        let points = self.points.len();
        let of_batch = |batch: usize| &self.of_batches[batch * points..(batch + 1) * points];
        let error = |pick: fn(&BatchSums) -> f64| {
            self.error(&|batch| of_batch(batch).iter().map(pick).sum::<f64>() / self.length as f64)
        };
        Some([error(|own| own.normal)?, error(|own| own.friction)?])
    }

    /// The standard error of an average by those of the batches that are complete.
    fn error(&self, of_batch: &dyn Fn(usize) -> f64) -> Option<f64> {
        let is_whole = self.steps == self.length * self.batches as u64;
        let batches = if is_whole { self.batches } else { self.batches.saturating_sub(1) };
        if batches < BATCHES {
            return None;
        }
        standard_error(&(0..batches).map(of_batch).collect::<Vec<_>>())
    }

    fn errors(&self, point: usize, mean: f64, rms: f64) -> Option<StatisticErrors> {
        let (length, points) = (self.length as f64, self.points.len());
        let error = |of: &dyn Fn(&BatchSums) -> f64| {
            self.error(&|batch| of(&self.of_batches[batch * points + point]) / length)
        };
        let about_mean = |own: &BatchSums| own.squared - 2.0 * mean * own.velocity + length * mean * mean;
        Some(StatisticErrors {
            stick_share: error(&|own| own.stick as f64)?,
            slip_share: error(&|own| own.slip as f64)?,
            open_share: error(&|own| own.open as f64)?,
            tangential_velocity_rms: if rms > 0.0 { error(&about_mean)? / (2.0 * rms) } else { 0.0 },
            normal_force_mean: error(&|own| own.normal)?,
            friction_force_mean: error(&|own| own.friction)?,
        })
    }
}

/// The standard error of an average over batches of one length, from what each of them has: their scatter over √(their number). None of less than two.
#[must_use]
pub fn standard_error(of_batches: &[f64]) -> Option<f64> {
    if of_batches.len() < 2 {
        return None;
    }
    let count = of_batches.len() as f64;
    let average = of_batches.iter().sum::<f64>() / count;
    let scatter = of_batches.iter().map(|value| (value - average).powi(2)).sum::<f64>() / (count - 1.0);
    Some((scatter / count).sqrt())
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::Statistics;
    use crate::contact_problem::PointMotion;
    use judder_numerics::counter::uniform;
    use std::f64::consts::TAU;

    /// v' = φ v + ε of unit normal ε, which sticks where v < 0: the variance is 1/(1 − φ²), and its estimate from N steps has the variance
    /// 2 σ⁴ (1 + φ²)/(1 − φ²)/N; that of the share is Σ asin(φ^|k|)/(2π N) over all k.
    #[test]
    fn errors_are_those_of_a_process_that_remembers() {
        let (phi, steps) = (0.9_f64, 100_000_u64);
        let mut statistics = Statistics::new(1);
        let mut velocity = 0.0;
        for step in 0..steps {
            let [a, b] = [1, 2].map(|stream| uniform(stream, step));
            velocity = phi * velocity + (-2.0 * (1.0 - a).ln()).sqrt() * (TAU * b).cos();
            let motion = if velocity < 0.0 { PointMotion::Stick } else { PointMotion::Slip };
            statistics.begin_step();
            statistics.take_point(0, motion, velocity, [1.0, 2.0 * velocity]);
        }
        let told = statistics.of(0).unwrap();
        let errors = told.errors.unwrap();
        let rms = (1.0 - phi * phi).sqrt().recip();
        let exact = 0.5 * rms * (2.0 * (1.0 + phi * phi) / (1.0 - phi * phi) / steps as f64).sqrt();
        assert!((errors.tangential_velocity_rms / exact - 1.0).abs() < 0.4, "{errors:?} {exact}");
        assert!((told.tangential_velocity_rms - rms).abs() < 4.0 * exact);
        let sum: f64 = (1..400).map(|k| 2.0 * phi.powi(k).asin()).sum::<f64>() + TAU / 4.0;
        let exact = (sum / TAU / steps as f64).sqrt();
        assert!((errors.stick_share / exact - 1.0).abs() < 0.4, "{errors:?} {exact}");
        assert!((told.stick_share - 0.5).abs() < 4.0 * exact);
        assert_eq!((errors.open_share, errors.normal_force_mean), (0.0, 0.0));
        // of a mean σ² (1 + φ)/(1 − φ)/N; of one point the force is that of all
        let exact = 2.0 * rms * ((1.0 + phi) / (1.0 - phi) / steps as f64).sqrt();
        assert!((errors.friction_force_mean / exact - 1.0).abs() < 0.4, "{errors:?} {exact}");
        assert_eq!(statistics.force_errors(), Some([0.0, errors.friction_force_mean]));
    }

    #[test]
    fn few_steps_have_no_errors() {
        let mut statistics = Statistics::new(2);
        for step in 0..20 {
            assert!(statistics.of(0).is_none_or(|own| own.errors.is_none()));
            statistics.begin_step();
            (0..2)
                .for_each(|point| statistics.take_point(point, PointMotion::Slip, f64::from(step), [0.0; 2]));
        }
        assert!(statistics.of(1).unwrap().errors.is_some());
    }
}
