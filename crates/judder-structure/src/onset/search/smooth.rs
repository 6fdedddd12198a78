//! Onsets as roots of the functions that vanish there.

use super::super::crossing::{Crossing, Vanishing};
use super::super::root::{RootSample, SampledRoot};
use super::{ModeChange, Onset, OnsetSearch, PRECISION, StabilitySample};
use crate::complex_modes::Region;

/// The spectrum runs smoothly over so much of the range.
const COARSE: f64 = 1e-3;
/// What is left at a root of the function that vanishes there, over its change along a smooth piece.
const VANISHED: f64 = 1e-2;
/// Less than this share of its error need not be left.
const IDLE: f64 = 1e-2;

impl<E> OnsetSearch<'_, '_, E> {
    /// The root of the function that vanishes at an onset; `None` where it does not vanish, or contact points come to other pieces of their laws.
    pub(super) fn root(
        &mut self,
        low: &StabilitySample,
        high: &StabilitySample,
        change: ModeChange,
        within: &Region,
    ) -> Result<Option<Onset>, E> {
        let (stable, unstable) = if change.gains { (high, low) } else { (low, high) };
        let vanishing =
            Vanishing::of(&stable.stability, unstable.those_that_grow(true).count(), change.frequency);
        let measured = |sample: &StabilitySample| {
            let is_same = sample.stability.pieces == low.stability.pieces;
            let value = vanishing.value(&sample.stability, change.frequency);
            let error = vanishing.error(&sample.stability, change.frequency);
            let frequency = vanishing.frequency(&sample.stability, change.frequency);
            RootSample { at: sample.value, value: if is_same { value } else { f64::NAN }, error, frequency }
        };
        let ends = [stable, unstable].map(measured);
        let beside = ends[0].error;
        let suffices = |own: &RootSample| own.value.abs() <= IDLE * vanishing.unknown(beside, own.error);
        let precision = PRECISION * self.range;
        let located = SampledRoot::between(ends, precision, &suffices, &mut |value| {
            Ok(measured(&self.sample(value, within)?))
        })?;
        // where the stable end does not tell whether the mode grows its onset is there
        let is_at_end = ends[0].value * ends[1].value >= 0.0 && ends[0].value.abs() <= ends[0].error;
        let Some(located) = located.or_else(|| is_at_end.then(|| SampledRoot::at_first(ends))) else {
            return Ok(None);
        };
        let (root, apart) = (located.root(), COARSE * self.range);
        let unknown = vanishing.unknown(located.least_error(), root.error);
        // where the mode has left the part of the region another takes its rank, and nothing vanishes
        let change_here = (ends[1].value - ends[0].value).abs() * (apart / (high.value - low.value)).min(1.0);
        let vanishes = root.value.abs() <= (VANISHED * change_here).max(unknown);
        if !vanishes {
            return Ok(None);
        }
        let slope = located.slope((0.5 * apart).min(0.25 * (high.value - low.value)));
        let frequency = root.frequency;
        let open = (unknown + root.value.abs()) / slope.abs();
        let error = if open.is_finite() { open.max(0.5 * precision) } else { high.value - low.value };
        let crossing = Some(Crossing { vanishing, frequency, slope, within: *within });
        Ok(Some(Onset { value: root.at, error, crossing, ..ModeChange { frequency, ..change }.onset() }))
    }
}
