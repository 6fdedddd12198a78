//! The ranges of a swept quantity in which the errors of the contact law decide whether steady sliding is stable.
//!
//! A threshold is a number; with the errors of a law it is a range. All thresholds that the law may have lie in these ranges, those too that
//! its own numbers do not show.

use crate::Contact;
use crate::critical::ParameterRange;
use crate::equilibrium::equilibrium;
use crate::groups::Coefficients;
use crate::within_law::WithinLaw;
use judder_numerics::order::sort_by_number;

/// Ranges of a quantity, ascending, each from where to where.
pub type Ranges = Vec<[f64; 2]>;

/// Where a law does not decide.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Undecided {
    /// Whether the full system is stable.
    pub full: Ranges,
    /// Whether the modes without damping have merged.
    pub conservative: Ranges,
}

/// Halvings of a sample interval at the end of a range.
const HALVINGS: usize = 20;

/// Where the law does not decide over `range`, looked for at `samples` evenly spaced positions; a range narrower than their distance may
/// escape, unless one of the `thresholds` (of the full system, of the conservative one) lies in it. Where the errors of the law are not known it decides nothing.
#[must_use]
pub fn undecided(
    contact: &Contact,
    range: &ParameterRange,
    samples: usize,
    thresholds: [&[f64]; 2],
    coefficients: impl Fn(f64) -> Coefficients,
) -> Undecided {
    if contact.law.is_formula() {
        return Undecided::default();
    }
    // without steady sliding there is nothing to decide
    let decided = |value: f64| {
        let c = coefficients(value);
        let Ok(state) = equilibrium(contact, &c) else { return [true; 2] };
        WithinLaw::new(contact, &c, &state)
            .map_or([false; 2], |within| [within.is_decided(), within.is_merging_decided()])
    };
    let last = samples.max(2) - 1;
    let even: Vec<(f64, [bool; 2])> = (0..=last)
        .map(|k| range.value(k as f64 / last as f64))
        .map(|value| (value, decided(value)))
        .collect();
    let [full, conservative] = [0, 1].map(|system| {
        let mut places: Vec<(f64, bool)> = even.iter().map(|(value, is)| (*value, is[system])).collect();
        // a threshold lies where the law does not decide, however well it is known
        places.extend(thresholds[system].iter().map(|threshold| (*threshold, false)));
        sort_by_number(&mut places, |own| own.0);
        ranges(&places, |value| decided(value)[system])
    });
    Undecided { full, conservative }
}

/// The ranges of places that are not decided, their ends found by halving.
fn ranges(places: &[(f64, bool)], is_decided: impl Fn(f64) -> bool) -> Ranges {
    let end = |mut inside: f64, mut outside: f64| {
        for _ in 0..HALVINGS {
            let middle =
                if inside * outside > 0.0 { (inside * outside).sqrt() } else { 0.5 * (inside + outside) };
            if is_decided(middle) { outside = middle } else { inside = middle }
        }
        outside
    };
    let mut found = Ranges::new();
    for (k, (value, decided)) in places.iter().enumerate() {
        if *decided {
            continue;
        }
        let before = k.checked_sub(1).and_then(|k| places.get(k));
        let after = places.get(k + 1);
        match (before, found.last_mut()) {
            (Some((_, false)), Some(range)) => range[1] = *value,
            (Some((before, true)), _) => found.push([end(*value, *before), *value]),
            _ => found.push([*value; 2]),
        }
        if let (Some((after, true)), Some(range)) = (after, found.last_mut()) {
            range[1] = end(*value, *after);
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Between samples the ends are found, at the ends of the search a range is cut off, and neighbours are one.
    #[test]
    fn ranges_end_where_the_decision_does() {
        let is_decided = |value: f64| !(value < 1.5 || (3.2..=6.7).contains(&value));
        let places: Vec<(f64, bool)> =
            (1..=9).map(f64::from).map(|value| (value, is_decided(value))).collect();
        let found = ranges(&places, is_decided);
        let expected = [[1.0, 1.5], [3.2, 6.7]];
        assert_eq!(found.len(), 2);
        for (found, expected) in found.iter().flatten().zip(expected.iter().flatten()) {
            assert!((found - expected).abs() < 1e-5, "{found} {expected}");
        }
        assert!(ranges(&[(1.0, true), (2.0, true)], |_| true).is_empty());
    }
}
