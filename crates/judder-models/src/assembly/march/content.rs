//! Which complex modes a motion contains, against what their eigenvalues promised.

use crate::assembly::AssemblySubject;
use crate::assembly::eigen::lowest;
use crate::error::ModelError;
use judder_assembly::linearised::{Linearised, LinearisedTerms};
use judder_assembly::steady::SteadySliding;
use judder_nonsmooth::march::NonsmoothMarch;
use judder_nonsmooth::mode_share::{ModalContent, ModalSums, ModeShare};
use judder_numerics::complex::ElementaryComplex;
use judder_store::Results;
use judder_structure::complex_modes::{ComplexMode, Verdict};
use std::f64::consts::TAU;

/// Samples of a mode in a period, at least.
const SAMPLES: f64 = 12.0;
/// How far below the loudest mode an unstable one is still heard, in dB, and how far from its own frequency it may turn: one that turns
/// otherwise is carried along by others.
const HEARD: (f64, f64) = (-20.0, 0.1);

/// The modes that are looked for.
pub(super) struct SoughtContent {
    modes: Vec<ComplexMode>,
    /// The largest displacement of each mode's shape as it is.
    largest: Vec<f64>,
    content: ModalContent,
    every: u64,
}

/// A mode in a motion.
#[derive(Clone, Results)]
pub(super) struct ModeInMotion {
    /// number of the mode, by rising frequency
    mode: usize,
    /// its frequency about steady sliding, in Hz
    frequency_hz: f64,
    /// its growth rate about steady sliding
    #[result(unit = "1/s")]
    growth_rate: f64,
    /// whether it grows there
    unstable: bool,
    /// its amplitude after the transient where it moves most
    #[result(unit = "m/s")]
    velocity: f64,
    /// that beside the loudest of these modes, in dB
    level_db: f64,
    /// how fast it turns in the motion, in Hz
    turning_hz: f64,
    /// of an unstable one whether it is heard: not more than 20 dB below the loudest, within a tenth of its own frequency
    heard: Option<bool>,
}

impl SoughtContent {
    /// The lowest modes about steady sliding.
    pub(super) fn new(
        of: &AssemblySubject<'_>,
        steady: &SteadySliding,
        march: &NonsmoothMarch<'_>,
        count: usize,
    ) -> Result<Self, ModelError> {
        let about = Linearised::new(&of.built.assembly, steady, LinearisedTerms::default())?;
        let (_, found) = lowest(&about, count)?;
        let (mut shares, mut largest) = (Vec::new(), Vec::new());
        for mode in &found.modes {
            let (right, left) = (about.expanded(&mode.right), about.expanded_left(&mode.left));
            let value = mode.eigenvalue.value;
            shares.push(ModeShare::new(march, &about, value, [&right, &left], &steady.displacement));
            let moved = of.built.expanded(&right);
            largest.push(moved.iter().map(|own| own.modulus()).fold(0.0, f64::max));
        }
        let fastest = found.modes.iter().map(|mode| mode.eigenvalue.value.im).fold(0.0, f64::max);
        let every = (TAU / fastest / SAMPLES / march.settings().step).floor().max(1.0);
        let every = if every.is_finite() { every as u64 } else { 1 };
        Ok(Self { modes: found.modes, largest, content: ModalContent::new(shares), every })
    }

    /// Takes the step that a march has come to, the `taken`-th.
    pub(super) fn take(&mut self, march: &NonsmoothMarch<'_>, taken: u64) {
        if taken.is_multiple_of(self.every) {
            self.content.take(march);
        }
    }

    /// What its samples add up to.
    pub(super) fn so_far(&self) -> &ModalSums {
        self.content.so_far()
    }

    /// Goes on with the sums of an earlier run.
    pub(super) fn resume(&mut self, kept: &ModalSums) -> Result<(), ModelError> {
        Ok(self.content.resume(kept)?)
    }

    /// What is told of the modes.
    pub(super) fn told(&self) -> Vec<ModeInMotion> {
        let velocity = |k: usize| {
            let [rms, turning] = self.content.of(k)?;
            // of a real motion the mode has one half, its conjugate the other
            Some([2.0 * rms * self.largest[k] * self.modes[k].eigenvalue.value.modulus(), turning])
        };
        let all: Vec<(usize, [f64; 2])> =
            (0..self.modes.len()).filter_map(|k| Some((k, velocity(k)?))).collect();
        let loudest = all.iter().map(|(_, [velocity, _])| *velocity).fold(f64::MIN_POSITIVE, f64::max);
        let told = |(k, [velocity, turning]): (usize, [f64; 2])| {
            let eigenvalue = &self.modes[k].eigenvalue;
            let level_db = 20.0 * libm::log10(velocity / loudest);
            let unstable = eigenvalue.verdict() == Verdict::Unstable;
            let is_near = (turning / eigenvalue.value.im - 1.0).abs() <= HEARD.1;
            ModeInMotion {
                mode: k + 1,
                frequency_hz: eigenvalue.value.im / TAU,
                growth_rate: eigenvalue.value.re,
                unstable,
                velocity,
                level_db,
                turning_hz: turning / TAU,
                heard: unstable.then_some(level_db >= HEARD.0 && is_near),
            }
        };
        all.into_iter().map(told).collect()
    }
}
