//! Where along a parameter modes begin or cease to grow, and what is told of it.

use crate::error::ModelError;
use judder_numerics::order::sort_by_number;
use judder_store::Results;
use judder_structure::asked_region::AskedRegion;
use judder_structure::complex_modes::Region;
use judder_structure::onset::{Onset, OnsetsBetween, StabilityAt, onsets_between};
use rayon::prelude::*;

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
    /// whether the spectrum jumps there, for contact points open or close, or pass a corner of a table
    jumps: bool,
}

impl From<&Onset> for ToldOnset {
    fn from(onset: &Onset) -> Self {
        let Onset { value, error, frequency_hz, kind, gains, jumps, .. } = *onset;
        Self { value, error, frequency_hz, kind: kind.name(), gains, jumps }
    }
}

/// Between which values onsets may be others than those that are told.
#[derive(Debug, Clone, PartialEq, Results)]
pub(crate) struct ToldDoubt {
    /// the lower value
    from: f64,
    /// the higher value
    to: f64,
    /// why
    reason: String,
}

/// Onsets, and where they are in doubt.
#[derive(Default)]
pub(crate) struct LocatedOnsets {
    pub(crate) onsets: Vec<Onset>,
    doubts: Vec<ToldDoubt>,
}

impl LocatedOnsets {
    /// What is told of them.
    pub(crate) fn told(&self) -> Vec<ToldOnset> {
        self.onsets.iter().map(ToldOnset::from).collect()
    }

    /// Those of a region that is asked for: none where its modes grow or decay all.
    pub(crate) fn asked_of(self, asked: &AskedRegion) -> Self {
        if asked.has_undamped() { self } else { Self::default() }
    }

    /// What is told of where they are in doubt.
    pub(crate) fn doubts(&self) -> Vec<ToldDoubt> {
        self.doubts.clone()
    }

    /// That onsets are in doubt, and the first reason; with values as `text` has them.
    pub(crate) fn warning(&self, text: &dyn Fn(f64) -> String) -> Option<String> {
        let ToldDoubt { from, to, reason } = self.doubts.first()?;
        let (from, to) = (text(*from), text(*to));
        let more = match self.doubts.len() - 1 {
            0 => String::new(),
            more => format!(", and for {more} more reasons (`onsets_in_doubt`)"),
        };
        Some(format!("between {from} and {to} onsets may be others than those that are told: {reason}{more}"))
    }

    /// The onsets between neighbours of the values, ascending or descending, at which stability in a region is known; `at` tells it at
    /// any other.
    ///
    /// # Errors
    /// That the run is to stop.
    pub(crate) fn new(
        values: &[f64],
        known: &[Option<StabilityAt>],
        region: &Region,
        at: &(dyn Fn(f64, &Region) -> Result<StabilityAt, ModelError> + Sync),
    ) -> Result<Self, ModelError> {
        let known = known.iter().cloned();
        let mut sorted: Vec<(f64, Option<StabilityAt>)> = values.iter().copied().zip(known).collect();
        sort_by_number(&mut sorted, |own| own.0);
        // no interval knows of another
        let each = sorted.par_windows(2).map(|pair| match pair {
            [low, high] => Self::between(low, high, region, at),
            _ => Ok(Self::default()),
        });
        let mut located = Self::default();
        for own in each.collect::<Vec<Result<Self, ModelError>>>() {
            let Self { onsets, doubts } = own?;
            located.onsets.extend(onsets);
            located.doubts.extend(doubts);
        }
        Ok(located)
    }

    /// The same of two neighbours.
    fn between(
        (from, low): &(f64, Option<StabilityAt>),
        (to, high): &(f64, Option<StabilityAt>),
        region: &Region,
        at: &(dyn Fn(f64, &Region) -> Result<StabilityAt, ModelError> + Sync),
    ) -> Result<Self, ModelError> {
        let (from, to) = (*from, *to);
        let doubt = |reason: String| ToldDoubt { from, to, reason };
        let (Some(low), Some(high)) = (low, high) else {
            let reason = format!(
                "there is no solution at the {} of them",
                if low.is_none() { "lower" } else { "higher" }
            );
            return Ok(Self { onsets: Vec::new(), doubts: vec![doubt(reason)] });
        };
        let ends = [(from, low.clone()), (to, high.clone())];
        match onsets_between(&ends[0], &ends[1], region, &mut |value, within| at(value, within)) {
            Ok(OnsetsBetween { onsets, doubts }) => {
                Ok(Self { onsets, doubts: doubts.iter().map(|own| doubt(own.to_string())).collect() })
            }
            Err(ModelError::Interrupted) => Err(ModelError::Interrupted),
            Err(error) => Ok(Self { onsets: Vec::new(), doubts: vec![doubt(error.to_string())] }),
        }
    }
}
