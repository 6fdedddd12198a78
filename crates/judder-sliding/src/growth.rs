//! Growth with the contact held at one place: what a march measures, against the eigenvalue there.

use crate::SlidingError;
use crate::coupling::{Coupling, SteadyFriction};
use crate::march::{ContactMethod, March, MarchSample, MarchSettings, MarchStart, Predictor, Reached};
use crate::motion::{Motion, Noise, Ramps};
use crate::pair::Pair;
use crate::shape::mode_shape;
use crate::statics::PairEquilibrium;
use judder_numerics::complex::ElementaryComplex;
use judder_numerics::signal::window::Window;
use num_complex::Complex64;
use std::f64::consts::TAU;

/// Where and how growth is measured.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GrowthSettings {
    /// By which march; Subs is held on the undeformed edge, the others on the deformed one.
    pub method: ContactMethod,
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
    /// As of [`PairEquilibrium::new`].
    pub fn new(pair: &Pair, settings: &GrowthSettings) -> Result<Self, SlidingError> {
        let sliding = SteadyFriction::at(pair.friction(), settings.velocity);
        let (equilibrium, coupling) =
            if matches!(settings.method, ContactMethod::Subs { static_slope: false }) {
                let rest = PairEquilibrium::undeformed(pair, settings.position, settings.load, sliding)?;
                let coupling = Coupling::new(pair, &rest.touch, sliding).with_falling_friction(
                    pair,
                    &rest.touch,
                    sliding,
                    rest.normal_force,
                );
                (rest, coupling)
            } else {
                let rest = PairEquilibrium::new(pair, settings.position, settings.load, sliding)?;
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
/// By how many times the fewest periods that may prolong a measurement, at most.
const MOST: f64 = 10.0;
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
    let start = held.disturbed(pair, settings, eigenvalue)?;
    let mut march = March::held(pair, settings.march(), &start)?;
    let mut windows = Windows::new(eigenvalue, settings.step);
    let steps = windows.quarter * (QUARTERS + if watcher.is_some() { BEYOND } else { 0 });
    let mut take = |sample: &MarchSample, _: &[f64]| {
        let deviation = sample.normal_force - held.normal_force;
        if let Some(watcher) = watcher.as_deref_mut() {
            watcher(sample.time, deviation);
        }
        windows.take(sample.time, deviation);
    };
    if let Reached::RunOff(end) = march.advance(steps, &mut take)? {
        return Err(SlidingError::RunsOff { position: settings.position, length: pair.length(), end });
    }
    Ok(windows.growth(settings.step))
}

impl GrowthSettings {
    /// A march that slides on without ramps or noise.
    fn march(&self) -> MarchSettings {
        let motion = Motion {
            start: self.position,
            end: self.position,
            velocity: self.velocity,
            load: self.load,
            initial_gap: 0.0,
            noise: Noise::default(),
            ramps: Ramps::default(),
            initial_damping: None,
        };
        MarchSettings { method: self.method, predictor: Predictor::default(), step: self.step, motion }
    }
}

/// Three windows, one after the other by a quarter of the measurement, on what swings with an eigenvalue.
struct Windows {
    eigenvalue: Complex64,
    /// Steps of a quarter; two make a window.
    quarter: u64,
    count: u64,
    sums: [Complex64; 3],
}

impl Windows {
    /// Long enough for some periods and, where the mode grows or decays slowly, for what can be told of that.
    fn new(eigenvalue: Complex64, step: f64) -> Self {
        let fewest = PERIODS * TAU / eigenvalue.im;
        let length = fewest.max((FOLDS / eigenvalue.re.abs()).min(MOST * fewest));
        let quarter = (length / (QUARTERS as f64 * step)).ceil() as u64;
        Self { eigenvalue, quarter, count: 0, sums: [Complex64::ZERO; 3] }
    }

    /// Takes in what swings, at the time of the next step.
    fn take(&mut self, time: f64, deviation: f64) {
        let turned = deviation * (Complex64::new(0.0, -self.eigenvalue.im) * time).exponential();
        let length = 2 * self.quarter;
        for (k, sum) in self.sums.iter_mut().enumerate() {
            let begin = k as u64 * self.quarter;
            if self.count >= begin && self.count < begin + length {
                *sum += turned * Window::BlackmanHarris.at((self.count - begin) as f64 / length as f64);
            }
        }
        self.count += 1;
    }

    /// What the windows say once all steps are taken in.
    fn growth(&self, step: f64) -> Growth {
        let apart = self.quarter as f64 * step;
        let rate = |from: usize, to: usize| {
            (self.sums[to] / self.sums[from]).logarithm() / ((to - from) as f64 * apart)
        };
        Growth {
            measured: rate(0, 2) + Complex64::new(0.0, self.eigenvalue.im),
            predicted: self.eigenvalue,
            spread: (rate(0, 1) - rate(1, 2)).re.abs(),
            steps: QUARTERS * self.quarter,
        }
    }
}

impl Held {
    /// The state of rest disturbed by the mode of an eigenvalue, with the forces that belong to both.
    fn disturbed(
        &self,
        pair: &Pair,
        settings: &GrowthSettings,
        eigenvalue: Complex64,
    ) -> Result<MarchStart, SlidingError> {
        let shape = mode_shape(&self.coupling, &pair.eigenvalues(), &pair.damping(), eigenvalue);
        let size = AMPLITUDE * self.normal_force;
        let at = |time: f64| -> Vec<f64> {
            let swing = size * (eigenvalue * time).exponential();
            self.state.iter().zip(&shape).map(|(rest, mode)| rest + (swing * mode).re).collect()
        };
        let rest =
            self.force_at_rest(pair, settings, SteadyFriction::at(pair.friction(), settings.velocity))?;
        let force =
            |time: f64| rest.map(|along| along * (1.0 + AMPLITUDE * (eigenvalue * time).exponential().re));
        let before = -settings.step;
        Ok(MarchStart { now: at(0.0), before: at(before), forces: [force(0.0), force(before)] })
    }

    /// The contact's force on the slider at rest.
    fn force_at_rest(
        &self,
        pair: &Pair,
        settings: &GrowthSettings,
        sliding: SteadyFriction,
    ) -> Result<[f64; 2], SlidingError> {
        let touch = match settings.method {
            ContactMethod::Subs { static_slope: false } => pair.undeformed(settings.position)?,
            _ => pair.deformed(settings.position, &self.state)?,
        };
        Ok(sliding.push(&touch).map(|along| self.normal_force * along))
    }
}
