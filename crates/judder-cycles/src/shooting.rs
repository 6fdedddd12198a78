//! Limit cycles by shooting: the second opinion.
//!
//! The implicit march of `judder-nonsmooth`, with stick, slip and lift-off solved for at every step and no harmonics, goes once around from a state; sought is the state that
//! comes back, φ(x, T) = x, and its period T. Newton's method takes the derivative by x from the monodromy matrix of a cycle that is near, by harmonics, and that by T from
//! a difference. What comes out has the error of the steps, of first order where points stick.

pub(crate) mod course;

use crate::CyclesError;
use crate::backbone::PeriodicMotion;
use crate::balance::HarmonicBalance;
use crate::path::GoOn;
use crate::stability::{beginning, monodromy};
use course::ShotCourse;
use faer::Mat;
use judder_assembly::assembly::Assembly;
use judder_dense::general::solve;
use judder_nonsmooth::gauss_seidel::ContactAccuracy;
use judder_nonsmooth::march::{NonsmoothMarch, NonsmoothSettings};
use judder_nonsmooth::scheme::ContactScheme;
use judder_nonsmooth::statistics::Statistics;
use std::f64::consts::TAU;

/// How a cycle is shot at.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShootingSettings {
    /// Steps of a period.
    pub steps: usize,
    /// The most steps of Newton's method.
    pub iterations: usize,
    /// What a period may miss, of the swing of the state.
    pub tolerance: f64,
}

impl Default for ShootingSettings {
    fn default() -> Self {
        Self { steps: 2048, iterations: 20, tolerance: 1e-7 }
    }
}

/// A cycle that was shot.
#[derive(Debug, Clone)]
pub struct ShotCycle {
    /// ω in rad/s.
    pub frequency: f64,
    /// Displacements and velocities of the freedoms where it begins.
    pub state: [Vec<f64>; 2],
    /// What its points do over a period.
    pub statistics: Statistics,
    /// What a period misses, of the swing of the state.
    pub residual: f64,
    /// Steps of Newton's method.
    pub iterations: usize,
}

/// A march once around.
struct OncePeriod<'a> {
    go_on: &'a GoOn<'a>,
    assembly: &'a Assembly,
    steps: usize,
    /// A force in N by which residuals of the contact are measured.
    force: f64,
}

impl OncePeriod<'_> {
    /// The state a period later; each step is told.
    fn from(
        &self,
        [q, v]: &[Vec<f64>; 2],
        period: f64,
        tell: &mut dyn FnMut(&NonsmoothMarch<'_>),
    ) -> Result<[Vec<f64>; 2], CyclesError> {
        let settings = NonsmoothSettings {
            scheme: ContactScheme::MoreauJean { restitution: 0.0, implicitness: 0.5 },
            step: period / self.steps as f64,
            accuracy: ContactAccuracy::default(),
            cut_off: None,
        };
        let mut march = NonsmoothMarch::new(self.assembly, &[], settings)?;
        march.set_force_scale(self.force);
        march.start(q, v);
        for _ in 0..self.steps {
            if !(self.go_on)() {
                return Err(CyclesError::Stopped);
            }
            march.advance()?;
            tell(&march);
        }
        Ok(march.state())
    }
}

/// The cycle near one that harmonics have found.
///
/// # Errors
/// [`CyclesError::NotReturned`], [`CyclesError::Singular`], and what the march says.
pub fn shoot(
    assembly: &Assembly,
    balance: &HarmonicBalance<'_>,
    near: &PeriodicMotion,
    settings: &ShootingSettings,
    go_on: &GoOn<'_>,
) -> Result<ShotCycle, CyclesError> {
    /// A period that misses so many swings leads nowhere.
    const FAR: f64 = 1e3;
    /// A difference of the period, of itself.
    const DIFFERENCE: f64 = 1e-5;
    let bodies = balance.bodies();
    let size = bodies.coordinates();
    let omega = near.turning.frequency;
    let around = OncePeriod { go_on, assembly, steps: settings.steps, force: balance.force_scale() };
    let freedoms = |x: &[f64]| {
        let velocities: Vec<f64> = x[size..].iter().map(|own| omega * own).collect();
        [bodies.freedoms(&x[..size]), bodies.freedoms(&velocities)]
    };
    let coordinates = |[q, v]: &[Vec<f64>; 2]| -> Vec<f64> {
        let velocities = bodies.to_coordinates(v).into_iter().map(|own| own / omega);
        bodies.to_coordinates(q).into_iter().chain(velocities).collect()
    };
    let (mut x, direction, swing) = beginning(balance, near)?;
    let mut period = TAU / omega;
    let matrix = monodromy(balance, near, settings.steps, go_on)?.matrix;
    let mut left = f64::INFINITY;
    for iteration in 0..=settings.iterations {
        let mut statistics = Statistics::new(balance.contact().points.len());
        let end = around.from(&freedoms(&x), period, &mut |march| statistics.take(march))?;
        let end = coordinates(&end);
        let missed: Vec<f64> = end.iter().zip(&x).map(|(a, b)| a - b).collect();
        left = length(&missed) / swing;
        if left <= settings.tolerance {
            return Ok(ShotCycle {
                frequency: TAU / period,
                state: freedoms(&x),
                statistics,
                residual: left,
                iterations: iteration,
            });
        }
        if left.is_nan() || left > FAR {
            break;
        }
        let later = around.from(&freedoms(&x), (1.0 + DIFFERENCE) * period, &mut |_| ())?;
        let later = coordinates(&later);
        let by_period: Vec<f64> = later.iter().zip(&end).map(|(a, b)| (a - b) / DIFFERENCE).collect();
        let (step, longer) = returning(&matrix, [&by_period, &direction, &missed])?;
        x.iter_mut().zip(step).for_each(|(own, step)| *own += step);
        period *= 1.0 + longer;
        if !(period.is_finite() && period > 0.0) {
            break;
        }
    }
    Err(CyclesError::NotReturned { iterations: settings.iterations, missed: left })
}

/// The march of a cycle that was shot, once more around.
///
/// # Errors
/// What the march says.
pub(crate) fn course_of(
    assembly: &Assembly,
    balance: &HarmonicBalance<'_>,
    shot: &ShotCycle,
    go_on: &GoOn<'_>,
) -> Result<ShotCourse, CyclesError> {
    let steps = shot.statistics.steps() as usize;
    let around = OncePeriod { go_on, assembly, steps, force: balance.force_scale() };
    let mut course = ShotCourse::new(balance);
    around.from(&shot.state, TAU / shot.frequency, &mut |march| course.take(balance, march))?;
    Ok(course)
}

/// A step of Newton's method towards a state that comes back, and that of the period, of itself: from the derivatives of the state a period later by the state and by
/// the period, and the direction along which no step goes, so that the phase stays.
fn returning(
    by_state: &Mat<f64>,
    [by_period, direction, missed]: [&[f64]; 3],
) -> Result<(Vec<f64>, f64), CyclesError> {
    let size = missed.len();
    let bordered = Mat::from_fn(size + 1, size + 1, |i, j| match (i == size, j == size) {
        (false, false) => by_state[(i, j)] - f64::from(u8::from(i == j)),
        (false, true) => by_period[i],
        (true, false) => direction[j],
        (true, true) => 0.0,
    });
    let mut right = Mat::from_fn(size + 1, 1, |i, _| if i < size { -missed[i] } else { 0.0 });
    solve(bordered, &mut right).ok_or(CyclesError::Singular)?;
    let right = right.col_as_slice(0);
    Ok((right[..size].to_vec(), right[size]))
}

fn length(values: &[f64]) -> f64 {
    values.iter().map(|own| own * own).sum::<f64>().sqrt()
}
