//! Where the stability of motions changes along a branch, and how.

use super::{CycleStability, FloquetMultipliers};
use faer::c64;
use judder_numerics::complex::ElementaryComplex;
use judder_numerics::order::sort_by_number;

/// Which multipliers cross the unit circle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CircleCrossing {
    /// A real one at 1: a fold, or a branch point.
    AtOne,
    /// A real one at −1: the period doubles.
    AtMinusOne,
    /// A complex pair: a second frequency comes in.
    Pair,
    /// Which ones is not known from the multipliers on either side.
    Unknown,
}

/// Motions along a branch between which multipliers cross the unit circle; those amid them are undecided.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct StabilityChange {
    /// The places of the last motion before and the first one after.
    pub between: [usize; 2],
    /// How.
    pub crossing: CircleCrossing,
    /// What those outside of the circle say alone, on the side that has them.
    pub outside: CircleCrossing,
}

impl FloquetMultipliers {
    /// How many lie outside the unit circle, where all are off it by more than their error.
    fn outside(&self) -> Option<usize> {
        let is_clear = self.values.iter().all(|own| (own.modulus() - 1.0).abs() > self.error);
        let decided = self.verdict() != CycleStability::Undecided;
        (is_clear && decided).then(|| self.values.iter().filter(|own| own.modulus() > 1.0).count())
    }
}

/// The changes along a branch, of whose motions multipliers are known or not.
#[must_use]
pub fn stability_changes(along: &[Option<&FloquetMultipliers>]) -> Vec<StabilityChange> {
    let clear = along.iter().enumerate().filter_map(|(place, own)| {
        let own = (*own)?;
        Some((place, own, own.outside()?))
    });
    let clear: Vec<_> = clear.collect();
    let changes = clear.windows(2).filter(|pair| pair[0].2 != pair[1].2).map(|pair| {
        let (more, fewer) = if pair[0].2 > pair[1].2 { (&pair[0], &pair[1]) } else { (&pair[1], &pair[0]) };
        let [crossing, outside] = crossing(more.1, fewer.1, more.2 - fewer.2);
        StabilityChange { between: [pair[0].0, pair[1].0], crossing, outside }
    });
    changes.collect()
}

/// How so many multipliers crossed: those next to the circle outside on the one side and inside on the other are of one kind, or it is not known; and what those outside say alone.
fn crossing(more: &FloquetMultipliers, fewer: &FloquetMultipliers, count: usize) -> [CircleCrossing; 2] {
    let off = |own: &c64| (own.modulus() - 1.0).abs();
    let next = |of: &FloquetMultipliers, outside: bool| {
        let mut own: Vec<c64> =
            of.values.iter().copied().filter(|own| (own.modulus() > 1.0) == outside).collect();
        sort_by_number(&mut own, off);
        own.truncate(count);
        own
    };
    let kind = |own: &[c64]| match own {
        [one] if one.im == 0.0 && one.re > 0.0 => CircleCrossing::AtOne,
        [one] if one.im == 0.0 => CircleCrossing::AtMinusOne,
        [one, other] if one.im != 0.0 && *other == one.conj() => CircleCrossing::Pair,
        _ => CircleCrossing::Unknown,
    };
    let [out, inside] = [kind(&next(more, true)), kind(&next(fewer, false))];
    [if out == inside { out } else { CircleCrossing::Unknown }, out]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn known(values: &[[f64; 2]], error: f64) -> FloquetMultipliers {
        let values = values.iter().map(|[re, im]| c64::new(*re, *im)).collect();
        FloquetMultipliers { values, phase: None, steps: 1, error }
    }

    #[test]
    fn what_crosses_is_named_where_both_sides_agree() {
        let inside = known(&[[0.9, 0.0], [-0.8, 0.0]], 0.01);
        let near = known(&[[1.005, 0.0], [-0.8, 0.0]], 0.01);
        let beyond = known(&[[1.1, 0.0], [-0.7, 0.0]], 0.01);
        let doubled = known(&[[-1.2, 0.0], [0.5, 0.0]], 0.01);
        let [pair, swings] = [[0.8, 0.5], [0.9, 0.6]].map(|[re, im]| known(&[[re, im], [re, -im]], 0.01));
        let changes = |along: &[&FloquetMultipliers]| -> Vec<([usize; 2], CircleCrossing)> {
            let along: Vec<_> = along.iter().map(|own| Some(*own)).collect();
            stability_changes(&along).iter().map(|own| (own.between, own.crossing)).collect()
        };
        // what is undecided is passed over
        assert_eq!(changes(&[&inside, &near, &beyond]), [([0, 2], CircleCrossing::AtOne)]);
        assert_eq!(changes(&[&pair, &swings]), [([0, 1], CircleCrossing::Pair)]);
        let flip = known(&[[-0.97, 0.0], [0.5, 0.0]], 0.01);
        assert_eq!(changes(&[&doubled, &flip]), [([0, 1], CircleCrossing::AtMinusOne)]);
        // where a mass begins to stick a multiplier jumps from zero
        let sticks = known(&[[0.0, 0.0], [0.0, 0.0]], 0.01);
        let slips = known(&[[1.3, 0.0], [0.0, 0.0]], 0.01);
        let jumps = stability_changes(&[Some(&sticks), Some(&slips)]);
        assert_eq!([jumps[0].crossing, jumps[0].outside], [CircleCrossing::Unknown, CircleCrossing::AtOne]);
        // inside it is one at 0.9, outside one at −1.2
        assert_eq!(changes(&[&inside, &doubled]), [([0, 1], CircleCrossing::Unknown)]);
        assert!(changes(&[&inside, &pair]).is_empty());
        assert!(stability_changes(&[None, Some(&inside), None]).is_empty());
    }
}
