//! Growth with the contact held at one place: what a march measures, against the eigenvalue there.

use crate::SlidingError;
use crate::coupling::{Coupling, Sliding};
use crate::march::{March, MarchSettings, Method, Predictor, Reached, Sample, Start};
use crate::motion::{Motion, Noise, Ramps};
use crate::pair::Pair;
use crate::shape::mode_shape;
use crate::statics::Equilibrium;
use judder_numerics::signal::window::Window;
use num_complex::Complex64;
use std::f64::consts::TAU;

/// Where and how growth is measured.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GrowthSettings {
    /// By which march; Subs is held on the undeformed edge, the others on the deformed one.
    pub method: Method,
    /// Its step, s.
    pub step: f64,
    /// Rigid distance of C from the track's first node, m.
    pub position: f64,
    /// The speed of steady sliding, m/s.
    pub velocity: f64,
    /// The load, N.
    pub load: f64,
}

/// Growth that a march shows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Growth {
    /// Growth rate in 1/s and angular frequency in rad/s, as one number.
    pub measured: Complex64,
    /// The eigenvalue that the mode was started with.
    pub predicted: Complex64,
    /// By how much the two halves of the measurement differ in growth rate, 1/s.
    pub spread: f64,
    /// Steps of the measurement.
    pub steps: u64,
}

/// The linear coupling of the pair held at a place, and the state about which it swings.
#[derive(Debug, Clone, PartialEq)]
pub struct Held {
    /// With geometry and friction that follow the motion, where the method's do.
    pub coupling: Coupling,
    /// Modal coordinates at rest, √kg m.
    pub state: Vec<f64>,
    /// Normal force at rest, N.
    pub normal_force: f64,
}

impl Held {
    /// What a method sees when held.
    ///
    /// # Errors
    /// As of [`Equilibrium::new`].
    pub fn new(pair: &Pair, settings: &GrowthSettings) -> Result<Self, SlidingError> {
        let sliding = Sliding::at(pair.friction(), settings.velocity);
        let (equilibrium, coupling) = if matches!(settings.method, Method::Subs { static_slope: false }) {
            let rest = Equilibrium::undeformed(pair, settings.position, settings.load, sliding)?;
            let coupling = Coupling::new(pair, &rest.touch, sliding).with_falling_friction(
                pair,
                &rest.touch,
                sliding,
                rest.normal_force,
            );
            (rest, coupling)
        } else {
            let rest = Equilibrium::new(pair, settings.position, settings.load, sliding)?;
            let coupling = rest.coupling(pair, sliding);
            (rest, coupling)
        };
        Ok(Self { coupling, state: equilibrium.state, normal_force: equilibrium.normal_force })
    }
}

/// Share of the normal force by which the mode swings at first: small against what the geometry does not follow linearly.
pub const AMPLITUDE: f64 = 1e-5;
/// Periods in a measurement, at least.
const PERIODS: f64 = 60.0;
/// By how many e-folds the mode may grow or decay in a measurement.
const FOLDS: f64 = 2.0;
/// Quarters of a measurement, and by how many a watched march goes on, so that what follows is seen too.
const QUARTERS: u64 = 4;
const BEYOND: u64 = 1;

/// Sees every step of a held march: the time in s and the deviation of the normal force from its rest in N.
pub type Watcher<'a> = dyn FnMut(f64, f64) + 'a;

/// Marches with the contact held, from rest disturbed by the mode of an eigenvalue, and measures its growth in the normal force.
///
/// Three windows lie one after the other, each over half of the march. What a window sees of e^{st} differs from the one before by the
/// factor e^{s Δ} alone, whatever its shape; a Blackman–Harris window keeps other modes out.
///
/// # Errors
/// As of [`March::held`] and [`March::advance`]; [`SlidingError::InvalidNumber`] for an eigenvalue that does not swing,
/// [`SlidingError::OffTrack`] where the contact starts beside the track, [`SlidingError::RunsOff`] where it leaves it.
pub fn frozen_growth(
    pair: &Pair,
    settings: &GrowthSettings,
    held: &Held,
    eigenvalue: Complex64,
) -> Result<Growth, SlidingError> {
    measured_growth(pair, settings, held, eigenvalue, None)
}

/// [`frozen_growth`] whose steps a watcher sees, up to a quarter of the measurement beyond its end.
///
/// # Errors
/// As of [`frozen_growth`].
pub fn watched_growth(
    pair: &Pair,
    settings: &GrowthSettings,
    held: &Held,
    eigenvalue: Complex64,
    watcher: &mut Watcher<'_>,
) -> Result<Growth, SlidingError> {
    measured_growth(pair, settings, held, eigenvalue, Some(watcher))
}

fn measured_growth(
    pair: &Pair,
    settings: &GrowthSettings,
    held: &Held,
    eigenvalue: Complex64,
    mut watcher: Option<&mut Watcher<'_>>,
) -> Result<Growth, SlidingError> {
    if !(eigenvalue.is_finite() && eigenvalue.im > 0.0) {
        return Err(SlidingError::InvalidNumber {
            name: "the imaginary part of the eigenvalue".to_owned(),
            value: eigenvalue.im,
            requirement: "finite and above zero: growth is measured on a mode that swings",
        });
    }
    let shape = mode_shape(&held.coupling, (&pair.eigenvalues(), &pair.damping()), eigenvalue);
    let size = AMPLITUDE * held.normal_force;
    let at = |time: f64| -> Vec<f64> {
        let swing = size * (eigenvalue * time).exp();
        held.state.iter().zip(&shape).map(|(rest, mode)| rest + (swing * mode).re).collect()
    };
    let sliding = Sliding::at(pair.friction(), settings.velocity);
    let rest = held.force_at_rest(pair, settings, sliding)?;
    let force = |time: f64| rest.map(|along| along * (1.0 + AMPLITUDE * (eigenvalue * time).exp().re));
    let start =
        Start { now: at(0.0), before: at(-settings.step), forces: [force(0.0), force(-settings.step)] };
    let motion = Motion {
        start: settings.position,
        end: settings.position,
        velocity: settings.velocity,
        load: settings.load,
        initial_gap: 0.0,
        noise: Noise::default(),
        ramps: Ramps::default(),
        initial_damping: None,
    };
    let march_settings = MarchSettings {
        method: settings.method,
        predictor: Predictor::default(),
        step: settings.step,
        motion,
    };
    let mut march = March::held(pair, march_settings, &start)?;
    let periods = (PERIODS * TAU / eigenvalue.im.abs())
        .max((FOLDS / eigenvalue.re.abs()).min(10.0 * PERIODS * TAU / eigenvalue.im.abs()));
    // of the quarters two make a window
    let quarter = (periods / (QUARTERS as f64 * settings.step)).ceil() as u64;
    let quarters = QUARTERS + if watcher.is_some() { BEYOND } else { 0 };
    let mut windows = [Complex64::ZERO; 3];
    let mut count = 0_u64;
    let mut take = |sample: &Sample, _: &[f64]| {
        let value = sample.normal_force - held.normal_force;
        if let Some(watcher) = watcher.as_deref_mut() {
            watcher(sample.time, value);
        }
        let turned = value * (Complex64::new(0.0, -eigenvalue.im) * sample.time).exp();
        for (k, window) in windows.iter_mut().enumerate() {
            let begin = k as u64 * quarter;
            if count >= begin && count < begin + 2 * quarter {
                *window += turned * Window::BlackmanHarris.at((count - begin) as f64 / (2 * quarter) as f64);
            }
        }
        count += 1;
    };
    if let Reached::RunOff(end) = march.advance(quarters * quarter, &mut take)? {
        return Err(SlidingError::RunsOff { position: settings.position, length: pair.length(), end });
    }
    let apart = quarter as f64 * settings.step;
    let rate = |from: usize, to: usize| (windows[to] / windows[from]).ln() / ((to - from) as f64 * apart);
    let measured = rate(0, 2) + Complex64::new(0.0, eigenvalue.im);
    let spread = (rate(0, 1) - rate(1, 2)).re.abs();
    Ok(Growth { measured, predicted: eigenvalue, spread, steps: QUARTERS * quarter })
}

impl Held {
    /// The contact's force on the slider at rest.
    fn force_at_rest(
        &self,
        pair: &Pair,
        settings: &GrowthSettings,
        sliding: Sliding,
    ) -> Result<[f64; 2], SlidingError> {
        let touch = match settings.method {
            Method::Subs { static_slope: false } => pair.undeformed(settings.position)?,
            _ => pair.deformed(settings.position, &self.state)?,
        };
        Ok(sliding.push(&touch).map(|along| self.normal_force * along))
    }
}
