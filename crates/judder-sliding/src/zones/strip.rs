//! Where one eigenvalue is unstable within a part of a parameter's range.

use super::PairFamily;
use super::branch::{Bound, EigenvaluePath, PartBranch, TooCoarse};
use super::highest::highest;
use super::meeting::StabilityMargin;
use judder_numerics::complex::ElementaryComplex;
use judder_numerics::order::sort_by_number;
use judder_numerics::root::bracketed_root;
use num_complex::Complex64;

/// A range in which one eigenvalue is unstable, within one part.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Strip {
    pub(super) from: Bound,
    pub(super) to: Bound,
    /// Where it grows fastest, as a share of the part, and how fast, as the samples foretell it.
    pub(super) peak: (f64, f64),
    pub(super) branch: PartBranch,
    /// Whether its eigenvalue is among those counted.
    pub(super) is_counted: bool,
}

/// How many steps a part has in which what the samples foretell is looked at.
const KNOTS: usize = 32;
/// A growth rate that is not known better than this share of the eigenvalue is not decided on.
const DECIDED: f64 = 1e-6;
/// Bounds are located to this share of a part.
const BOUND: f64 = 1e-9;
/// Steps of the path of a strip.
const POINTS: usize = 8;

/// All ranges of a part in which the branch is unstable.
pub(super) fn strips(family: &dyn PairFamily, branch: &PartBranch) -> Result<Vec<Strip>, TooCoarse> {
    let share = |k: usize| k as f64 / KNOTS as f64;
    let even: Vec<(f64, StabilityMargin)> =
        (0..=KNOTS).map(|k| (share(k), branch.foretold(share(k)))).collect();
    if is_far_below(&even) {
        return Ok(Vec::new());
    }
    let knots = with_extremes(branch, &even)?;
    let mut found = Vec::new();
    let mut from = (knots[0].1.value > 0.0).then_some(0.0);
    for pair in knots.windows(2) {
        let [(left, before), (right, after)] = [pair[0], pair[1]];
        if (before.value > 0.0) == (after.value > 0.0) {
            continue;
        }
        let root = crossing(family, branch, [left, right])?;
        match from.take() {
            None => from = Some(root),
            Some(from) => found.push(strip(branch, [from, root], &knots)),
        }
    }
    if let Some(from) = from {
        found.push(strip(branch, [from, 1.0], &knots));
    }
    Ok(found)
}

/// Whether no value is nearer to zero than all values are to each other.
fn is_far_below(knots: &[(f64, StabilityMargin)]) -> bool {
    let values = || knots.iter().map(|knot| knot.1.value);
    let (most, least) = (values().fold(f64::NEG_INFINITY, f64::max), values().fold(f64::INFINITY, f64::min));
    let doubt = knots.iter().map(|knot| knot.1.doubt).fold(0.0, f64::max);
    most + (most - least) + doubt < 0.0
}

/// What is foretold at even shares, with its extremes between them where a sign may hide.
fn with_extremes(
    branch: &PartBranch,
    even: &[(f64, StabilityMargin)],
) -> Result<Vec<(f64, StabilityMargin)>, TooCoarse> {
    let mut knots = Vec::with_capacity(even.len());
    for (k, (at, margin)) in even.iter().copied().enumerate() {
        let (from, before) = even[k.saturating_sub(1)];
        let (to, after) = even[(k + 1).min(KNOTS)];
        knots.push((at, margin));
        // a highest place below zero, or a lowest above it
        let sign = if margin.value > 0.0 { -1.0 } else { 1.0 };
        if sign * margin.value < sign * before.value || sign * margin.value < sign * after.value {
            continue;
        }
        let at = highest(|share| sign * branch.foretold(share).value, [from, to]);
        if at == 0.0 || at == 1.0 {
            continue;
        }
        let extreme = branch.foretold(at);
        let decided = DECIDED * extreme.eigenvalue.modulus();
        let decided = if branch.is_conservative { decided * decided } else { decided };
        if extreme.value.abs() <= extreme.doubt && extreme.doubt > decided {
            return Err(TooCoarse);
        }
        knots.push((at, extreme));
    }
    sort_by_number(&mut knots, |own| own.0);
    Ok(knots)
}

/// The share at which stability changes between two, by the eigenvalue itself.
fn crossing(family: &dyn PairFamily, branch: &PartBranch, [left, right]: [f64; 2]) -> Result<f64, TooCoarse> {
    // at the ends of a part the samples are the eigenvalues
    let itself = |share: f64| {
        let is_sample = share == 0.0 || share == 1.0;
        let margin = if is_sample { Some(branch.foretold(share)) } else { branch.found(family, share) };
        margin.map_or(f64::NAN, |margin| margin.value)
    };
    bracketed_root(itself, left, right, BOUND).map_err(|_| TooCoarse)
}

fn strip(branch: &PartBranch, [from, to]: [f64; 2], knots: &[(f64, StabilityMargin)]) -> Strip {
    let growth = |share: f64| branch.foretold(share).eigenvalue.re;
    let within = knots.iter().map(|knot| knot.0).filter(|share| *share > from && *share < to);
    let best = within.chain([from, to]).max_by(|a, b| growth(*a).total_cmp(&growth(*b))).unwrap_or(from);
    let step = 1.0 / KNOTS as f64;
    let at = highest(growth, [(best - step).max(from), (best + step).min(to)]);
    Strip {
        from: branch.bound(from),
        to: branch.bound(to),
        peak: (at, growth(at)),
        branch: *branch,
        is_counted: true,
    }
}

/// Where the strip's growth rate is highest, by the eigenvalue itself: the parameter and the eigenvalue; `None` where it is not found.
pub(super) fn peak(family: &dyn PairFamily, strip: &Strip) -> Option<(f64, Complex64)> {
    let Strip { from, to, peak, branch, .. } = strip;
    let width = branch.ends[1] - branch.ends[0];
    let share = |at: f64| (at - branch.ends[0]) / width;
    let step = 1.0 / KNOTS as f64;
    let range = [(peak.0 - step).max(share(from.at)), (peak.0 + step).min(share(to.at))];
    let itself = |share: f64| branch.found(family, share).map(|margin| margin.eigenvalue);
    let at = highest(|share| itself(share).map_or(f64::NEG_INFINITY, |value| value.re), range);
    Some((branch.place(at), itself(at)?))
}

/// Places of a strip from its start to its end, with the eigenvalues there.
pub(super) fn path(family: &dyn PairFamily, strip: &Strip) -> EigenvaluePath {
    let Strip { from, to, branch, .. } = strip;
    let width = branch.ends[1] - branch.ends[0];
    let share = |k: usize| (from.at + (to.at - from.at) * k as f64 / POINTS as f64 - branch.ends[0]) / width;
    let inner = (1..POINTS)
        .filter_map(|k| Some((branch.place(share(k)), branch.found(family, share(k))?.eigenvalue)));
    std::iter::once((from.at, from.eigenvalue)).chain(inner).chain([(to.at, to.eigenvalue)]).collect()
}
