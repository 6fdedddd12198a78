//! Where along a parameter modes begin or cease to grow, and what is told of it.

use judder_store::Results;
use judder_structure::complex_modes::Region;
use judder_structure::onset::{Onset, StabilityAt, StabilityOf, onsets};
use std::fmt::Display;

/// Where modes begin or cease to grow.
#[derive(Debug, Clone, PartialEq, Results)]
pub(crate) struct ToldOnset {
    /// value of the parameter
    value: f64,
    /// how far the onset may be from it
    error: f64,
    /// frequency there, in Hz; zero of a divergence
    frequency_hz: f64,
    /// `flutter` or `divergence`
    kind: &'static str,
    /// whether stability is gained with rising values
    gains: bool,
    /// whether the spectrum jumps there, for contact points open or close
    jumps: bool,
}

impl From<&Onset> for ToldOnset {
    fn from(onset: &Onset) -> Self {
        let Onset { value, error, frequency_hz, kind, gains, jumps, .. } = *onset;
        Self { value, error, frequency_hz, kind: kind.name(), gains, jumps }
    }
}

/// Onsets, and between which values they could not be located.
#[derive(Default)]
pub(crate) struct LocatedOnsets {
    pub(crate) onsets: Vec<Onset>,
    pub(crate) warnings: Vec<String>,
}

impl LocatedOnsets {
    /// What is told of them.
    pub(crate) fn told(&self) -> Vec<ToldOnset> {
        self.onsets.iter().map(ToldOnset::from).collect()
    }

    /// The onsets between neighbours of the values, ascending or descending, at which stability in a region is known; `at` tells it at
    /// any other.
    pub(crate) fn new<E: Display>(
        values: &[f64],
        known: &[Option<StabilityAt>],
        region: &Region,
        at: &mut StabilityOf<'_, E>,
    ) -> Self {
        let mut sorted: Vec<(f64, Option<&StabilityAt>)> =
            values.iter().copied().zip(known.iter().map(Option::as_ref)).collect();
        sorted.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut located = Self::default();
        for pair in sorted.windows(2) {
            let [(from, Some(low)), (to, Some(high))] = pair else { continue };
            match onsets(&[(*from, (*low).clone()), (*to, (*high).clone())], region, at) {
                Ok(found) => located.onsets.extend(found),
                Err(error) => {
                    located.warnings.push(format!("onsets between {from} and {to} are not located: {error}"));
                }
            }
        }
        located
    }
}
