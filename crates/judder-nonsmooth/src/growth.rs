//! The growth of a mode in a march that is started in it, against its eigenvalue.

use crate::NonsmoothError;
use crate::contact_problem::PointMotion;
use crate::march::{NonsmoothMarch, NonsmoothSettings};
use crate::mode_share::ModeShare;
use faer::c64;
use judder_assembly::assembly::Assembly;
use judder_assembly::linearised::Linearised;
use judder_assembly::steady::SteadySliding;
use judder_numerics::complex::ElementaryComplex;
use judder_structure::complex_modes::ComplexMode;
use std::f64::consts::TAU;

/// Growth that a march shows.
#[derive(Debug, Clone, PartialEq)]
pub struct MarchGrowth {
    /// Growth rate in 1/s and angular frequency in rad/s, as one number.
    pub measured: c64,
    /// The eigenvalue.
    pub predicted: c64,
    /// By how much the two halves of the measurement differ in growth rate, 1/s.
    pub spread: f64,
    /// Steps of the measurement.
    pub steps: u64,
    /// Times in s and amplitudes |a| of the mode over the amplitude that it started with, some in every period.
    pub history: Vec<[f64; 2]>,
    /// Whether every point went on as in steady sliding, so that the motion was small.
    pub is_small: bool,
}

/// Slip velocities of the start over the slip speed, at most.
const AMPLITUDE: f64 = 1e-5;
/// How often a start that is not small enough is made smaller, and by what.
const SMALLER: (usize, f64) = (4, 0.05);
/// Periods in a measurement, at most and at least, and e-folds at most.
const PERIODS: [f64; 2] = [4.0, 100.0];
const FOLDS: f64 = 3.0;
/// Steps in a period, at least, and in a measurement, at most.
const SHORTEST: f64 = 12.0;
const MOST_STEPS: f64 = 1e9;
/// Amplitudes that are kept of each period.
const KEPT: f64 = 4.0;

/// Starts a march from steady sliding disturbed by a mode, and measures how the mode's amplitude grows.
///
/// # Errors
/// [`NonsmoothError::InvalidNumber`] for an eigenvalue that does not swing, what [`NonsmoothMarch::new`] and [`NonsmoothMarch::advance`] say.
pub fn growth(
    assembly: &Assembly,
    steady: &SteadySliding,
    about: &Linearised,
    mode: &ComplexMode,
    settings: NonsmoothSettings,
) -> Result<MarchGrowth, NonsmoothError> {
    let value = mode.eigenvalue.value;
    if !(value.im > 0.0 && value.re.is_finite()) {
        return Err(NonsmoothError::InvalidNumber {
            name: "the imaginary part of the eigenvalue",
            value: value.im,
            requirement: "above zero: growth is measured on a mode that swings",
        });
    }
    let period = TAU / value.im;
    let most = period / SHORTEST;
    if settings.step > most || PERIODS[1] * period / settings.step > MOST_STEPS {
        let (step, least) = (settings.step, PERIODS[1] * period / MOST_STEPS);
        return Err(NonsmoothError::StepForMode { step, least, most, frequency: value.im / TAU });
    }
    let (right, left) = (about.expanded(&mode.right), about.expanded_left(&mode.left));
    let mut march = NonsmoothMarch::new(assembly, &[], settings)?;
    let share = ModeShare::new(&march, about, value, [&right, &left], &steady.displacement);
    let closed = steady.points.iter().map(|point| point.normal_force.abs());
    let forces: Vec<[f64; 2]> =
        steady.points.iter().map(|point| [point.normal_force, point.friction_force]).collect();
    march.set_force_scale(closed.fold(0.0, f64::max));
    let mut size = AMPLITUDE * smallest_ratio(&march, &right, value, &steady.displacement);
    let mut found = None;
    for _ in 0..SMALLER.0 {
        let scaled = |k: usize, factor: c64| (size * factor * right[k]).re;
        let one = c64::new(1.0, 0.0);
        let displacement: Vec<f64> =
            steady.displacement.iter().enumerate().map(|(k, q)| q + scaled(k, one)).collect();
        // of central differences the velocity lies half a step back
        let back = if settings.scheme.implicitness() == 0.0 { -0.5 * settings.step } else { 0.0 };
        let velocity: Vec<f64> =
            (0..right.len()).map(|k| scaled(k, value * (value * back).exponential())).collect();
        march.start(&displacement, &velocity);
        march.guess(&forces);
        let measured = measure(&mut march, &share, value, steady)?;
        let is_small = measured.is_small;
        found = Some(measured);
        if is_small {
            break;
        }
        size *= SMALLER.1;
    }
    found.ok_or(NonsmoothError::NotFinite { time: 0.0 })
}

/// The largest factor of a mode whose slip velocities nowhere exceed the slip speed, nor its displacements the largest of steady sliding.
fn smallest_ratio(march: &NonsmoothMarch<'_>, right: &[c64], value: c64, steady: &[f64]) -> f64 {
    let contact = march.contact();
    let ratio = |point: usize| {
        let form = &contact.points[point].frame.slip;
        contact.speed(point) / (value * form.of_complex(right)).modulus()
    };
    let largest = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0, f64::max);
    let moved = largest(&mut steady.iter().map(|own| own.abs()));
    let of_bodies = moved / largest(&mut right.iter().map(|own| own.modulus()));
    let of_bodies = if of_bodies > 0.0 { of_bodies } else { 1.0 };
    (0..contact.points.len()).map(ratio).filter(|ratio| ratio.is_finite()).fold(of_bodies, f64::min)
}

fn measure(
    march: &mut NonsmoothMarch<'_>,
    share: &ModeShare,
    value: c64,
    steady: &SteadySliding,
) -> Result<MarchGrowth, NonsmoothError> {
    let step = march.settings().step;
    let period = TAU / value.im;
    let wanted = (FOLDS / value.re.abs() / period).clamp(PERIODS[0], PERIODS[1]);
    // whole periods in each half
    let half = ((0.5 * wanted).ceil() * period / step).round() as u64;
    let every = ((period / KEPT / step).floor() as u64).max(1);
    // a point that turned within a step slides again, but the other way
    let as_before = |march: &NonsmoothMarch<'_>| {
        steady.points.iter().enumerate().all(|(k, point)| match point.is_closed {
            true => march.motion(k) == PointMotion::Slip && march.force(k)[1] * point.friction_force >= 0.0,
            false => march.motion(k) == PointMotion::Open,
        })
    };
    let mut amplitudes = [c64::ZERO; 3];
    let (mut turns, mut last) = (0.0_f64, 0.0_f64);
    let (mut angles, mut history, mut is_small) = ([0.0; 3], Vec::new(), true);
    for taken in 0..=2 * half {
        march.advance()?;
        is_small &= as_before(march);
        let amplitude = share.of(march);
        // the angle without jumps
        let angle = libm::atan2(amplitude.im, amplitude.re);
        turns += ((angle - last + 0.5 * TAU) / TAU).floor();
        last = angle;
        let unwrapped = angle - TAU * turns;
        if taken % half == 0 {
            let place = (taken / half) as usize;
            (amplitudes[place], angles[place]) = (amplitude, unwrapped);
        }
        if taken % every == 0 {
            history.push([taken as f64 * step, amplitude.modulus() / amplitudes[0].modulus()]);
        }
    }
    let time = half as f64 * step;
    let rate = |from: usize, to: usize| {
        libm::log(amplitudes[to].modulus() / amplitudes[from].modulus()) / ((to - from) as f64 * time)
    };
    Ok(MarchGrowth {
        measured: c64::new(rate(0, 2), (angles[2] - angles[0]) / (2.0 * time)),
        predicted: value,
        spread: (rate(0, 1) - rate(1, 2)).abs(),
        steps: 2 * half,
        history,
        is_small,
    })
}
