//! What is known of a locus at its values while it is searched, as an interrupted run keeps it: states of rest and spectra.

use super::rest_state::RestState;
use judder_sliding::SlidingError;
use judder_sliding::spectrum::Spectrum;
use judder_study::kept::{KeptLines, KeptResults};
use num_complex::Complex64;
use serde::{Deserialize, Serialize};

/// All of it, each by the bits of its value.
pub(super) struct KeptValues<'a> {
    states: KeptResults<'a, RestState>,
    /// Of values that are shown, and of those at which zones are sought.
    spectra: KeptResults<'a, KeptSpectrum>,
    /// Of values by themselves, where others fail.
    alone: KeptResults<'a, KeptSpectrum>,
}

/// A spectrum as it is kept.
#[derive(Clone, Serialize, Deserialize)]
struct KeptSpectrum {
    /// Real and imaginary part of each, 1/s.
    eigenvalues: Vec<[f64; 2]>,
    errors: Vec<f64>,
    limit: f64,
}

/// What finds a result that is not known.
type Solve<'a, T> = &'a dyn Fn() -> Result<T, SlidingError>;

impl<'a> KeptValues<'a> {
    pub(super) fn new(kept: KeptLines<'a>) -> Self {
        let [spectra, alone] = ["spectra", "spectra alone"].map(|part| KeptResults::of(part, kept));
        Self { states: KeptResults::of("states of rest", kept), spectra, alone }
    }

    /// The state of rest at a value.
    pub(super) fn state(&self, value: f64, solve: Solve<'_, RestState>) -> Result<RestState, SlidingError> {
        self.states.at(value.to_bits(), solve)
    }

    /// The spectrum by which branches are followed.
    pub(super) fn spectrum(&self, value: f64, solve: Solve<'_, Spectrum>) -> Result<Spectrum, SlidingError> {
        KeptSpectrum::at(&self.spectra, value, solve)
    }

    /// The spectrum of a value by itself.
    pub(super) fn alone(&self, value: f64, solve: Solve<'_, Spectrum>) -> Result<Spectrum, SlidingError> {
        KeptSpectrum::at(&self.alone, value, solve)
    }
}

impl KeptSpectrum {
    fn at(
        kept: &KeptResults<'_, Self>,
        value: f64,
        solve: Solve<'_, Spectrum>,
    ) -> Result<Spectrum, SlidingError> {
        let Self { eigenvalues, errors, limit } =
            kept.at(value.to_bits(), || solve().map(|own| Self::new(&own)))?;
        let eigenvalues = eigenvalues.into_iter().map(|[re, im]| Complex64::new(re, im)).collect();
        Ok(Spectrum { eigenvalues, errors, limit })
    }

    fn new(spectrum: &Spectrum) -> Self {
        let eigenvalues = spectrum.eigenvalues.iter().map(|own| [own.re, own.im]).collect();
        Self { eigenvalues, errors: spectrum.errors.clone(), limit: spectrum.limit }
    }
}
