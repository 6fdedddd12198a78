//! What the points of a march do on average.

use crate::contact_problem::PointMotion;
use crate::march::NonsmoothMarch;

/// Sums over the steps of a march, point by point.
#[derive(Debug, Clone)]
pub struct Statistics {
    steps: u64,
    points: Vec<PointSums>,
}

#[derive(Debug, Clone, Copy, Default)]
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
}

impl Statistics {
    /// Of so many points, before the first step.
    #[must_use]
    pub fn new(points: usize) -> Self {
        Self { steps: 0, points: vec![PointSums::default(); points] }
    }

    /// Takes the step that a march is at.
    pub fn take(&mut self, march: &NonsmoothMarch<'_>) {
        let is_first = self.steps == 0;
        self.steps += 1;
        for (point, sums) in self.points.iter_mut().enumerate() {
            match march.motion(point) {
                PointMotion::Stick => sums.stick += 1,
                PointMotion::Slip => sums.slip += 1,
                PointMotion::Open => sums.open += 1,
            }
            let [_, velocity, _] = march.velocity(point);
            if is_first {
                sums.origin = velocity;
            }
            let deviation = velocity - sums.origin;
            sums.velocity += deviation;
            sums.squared += deviation * deviation;
            let [normal, friction, _] = march.force(point);
            sums.normal += normal;
            sums.friction += friction;
        }
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
        Some(PointStatistics {
            stick_share: sums.stick as f64 / steps,
            slip_share: sums.slip as f64 / steps,
            open_share: sums.open as f64 / steps,
            tangential_velocity_rms: (sums.squared / steps - mean * mean).max(0.0).sqrt(),
            normal_force_mean: sums.normal / steps,
            friction_force_mean: sums.friction / steps,
        })
    }
}
