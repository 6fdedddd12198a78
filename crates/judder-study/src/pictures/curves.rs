//! Curves over one swept quantity.

use super::{Swept, axis, codes, complexes, reals, text};
use judder_report::{Axis, Layer, Panel, Role};
use judder_store::Dataset;

/// ξ_eq over the swept quantity, on an axis that shows both signs over many decades.
pub(super) fn equivalent_damping(dataset: &Dataset) -> Option<Panel> {
    /// Half width of the linear part of the axis.
    const LINEAR: f64 = 0.01;
    let swept = Swept::of(dataset, "equivalent_damping")?;
    let damping = reals(dataset, "equivalent_damping")?;
    let mut layers = vec![Layer::horizontal_rule(0.0, "")];
    for (curve, values) in damping.chunks(swept.values.len()).enumerate() {
        layers.push(Layer::line(
            swept.label(curve, ""),
            swept.values.to_vec(),
            values.to_vec(),
            swept.role(curve).solid(),
        ));
    }
    let vertical = Axis::symmetric_log("Equivalent damping $ξ_{eq}$ (−)", LINEAR);
    Some(Panel::new(axis(swept.axis), vertical, layers))
}

/// Growth rates and frequencies, of the full system and without damping.
pub(super) fn spectrum(dataset: &Dataset) -> Option<Vec<Panel>> {
    let swept = Swept::of(dataset, "eigenvalues")?;
    let full = complexes(dataset, "eigenvalues")?;
    let conservative = complexes(dataset, "conservative_eigenvalues")?;
    let (mut growth, mut frequency) = (Vec::new(), Vec::new());
    let points = swept.values.len();
    for (system, values) in [("without damping", conservative), ("full system", full)] {
        let is_full = system == "full system";
        for (curve, spectra) in values.chunks(4 * points).enumerate() {
            for mode in 0..4 {
                let part = |pick: fn(&num_complex::Complex64) -> f64| -> Vec<f64> {
                    spectra.iter().skip(mode).step_by(4).map(pick).collect()
                };
                let role = if swept.family.is_some() { swept.role(curve) } else { Role::Mode(mode % 2) };
                let style = if is_full { role.solid() } else { role.dashed() };
                let label = if mode == 0 { swept.label(curve, system) } else { String::new() };
                let label = if swept.family.is_some() && !is_full { String::new() } else { label };
                growth.push(Layer::line(label.clone(), swept.values.to_vec(), part(|l| l.re), style));
                // conjugates mirror each other: one half of the plane shows all
                let upper = part(|l| if l.im >= 0.0 { l.im } else { f64::NAN });
                frequency.push(Layer::line(label, swept.values.to_vec(), upper, style));
            }
        }
    }
    growth.insert(0, Layer::horizontal_rule(0.0, ""));
    Some(vec![
        Panel::new(axis(swept.axis), Axis::linear("Growth rate Re $λ$/$ω_{nx}$ (−)"), growth),
        Panel::new(axis(swept.axis), Axis::linear("Frequency Im $λ$/$ω_{nx}$ (−)"), frequency),
    ])
}

/// Thresholds over the swept quantity, with what grows from them and the folds of the cycles that do.
pub(super) fn critical(dataset: &Dataset) -> Option<Panel> {
    let swept = Swept::of(dataset, "full")?;
    let label = text(dataset.variable("full")?, "label").unwrap_or("Threshold");
    let mut layers = Vec::new();
    for (name, is_full) in [("conservative", false), ("full", true)] {
        let roots = reals(dataset, name)?;
        let most = *dataset.variable(name)?.shape.last()?;
        if most == 0 {
            continue;
        }
        for (curve, roots) in roots.chunks(most * swept.values.len()).enumerate() {
            let (x, y) = branches(swept.values, roots, roots, most);
            let role = swept.role(curve);
            let style = if is_full { role.solid() } else { role.dashed() };
            let shown = match (swept.family.is_some(), is_full) {
                (true, true) => swept.label(curve, ""),
                (true, false) => String::new(),
                (false, true) => "full system".to_owned(),
                (false, false) => "without damping".to_owned(),
            };
            layers.push(Layer::line(shown, x, y, style));
        }
    }
    if swept.family.is_some() {
        layers.push(Layer::key("full system", Role::FullBoundary.solid()));
        layers.push(Layer::key("without damping", Role::ConservativeBoundary));
    }
    layers.extend(folds(dataset, &swept));
    Some(Panel::new(axis(swept.axis), Axis::log(label), layers))
}

/// The folds beside the thresholds, how far lost branches are known, and which thresholds are sub- or supercritical; nothing
/// where no branch was followed, for then there are too many thresholds to mark them.
fn folds(dataset: &Dataset, swept: &Swept<'_>) -> Vec<Layer> {
    const SUBCRITICAL: u8 = 2;
    let known = || {
        let numbers = (reals(dataset, "full")?, reals(dataset, "fold")?, reals(dataset, "reaches")?);
        Some((numbers, codes(dataset, "criticality")?, *dataset.variable("full")?.shape.last()?))
    };
    let Some(((roots, folds, reaches), criticality, most)) = known().filter(|known| known.2 > 0) else {
        return Vec::new();
    };
    let mut layers = Vec::new();
    let length = most * swept.values.len();
    for (curve, (roots, folds)) in roots.chunks(length).zip(folds.chunks(length)).enumerate() {
        let (x, y) = branches(swept.values, roots, folds, most);
        let label = if curve == 0 { "fold of the cycles" } else { "" };
        layers.push(Layer::line(label, x, y, swept.role(curve).dash_dotted()));
    }
    let points = |label: &str, of: &dyn Fn(usize) -> f64, series: usize| {
        let across = (0..roots.len()).map(|k| swept.values[k % length / most]).collect();
        Layer::points(label, across, (0..roots.len()).map(of).collect(), Role::Series(series))
    };
    let is = |k: usize, code: u8, value: f64| if criticality[k] == code { value } else { f64::NAN };
    layers.push(points("supercritical", &|k| is(k, SUBCRITICAL - 1, roots[k]), 0));
    layers.push(points("subcritical", &|k| is(k, SUBCRITICAL, roots[k]), 1));
    let lost = |k: usize| if folds[k].is_nan() { reaches[k] } else { f64::NAN };
    if (0..roots.len()).any(|k| lost(k).is_finite()) {
        layers.push(points("no fold: cycles up to here", &lost, 4));
    }
    layers
}

/// A curve of roots in the making.
type Chain = (Vec<f64>, Vec<f64>);

/// The roots along the sweep as curves, with a gap after each: neighbours are joined in order, and where their numbers differ,
/// the nearest ones; what is left over begins or ends there. A curve shows the `shown` that belong to its roots.
fn branches(values: &[f64], roots: &[f64], shown: &[f64], most: usize) -> Chain {
    let finite = |roots: &[f64]| roots.iter().copied().filter(|root| root.is_finite()).collect();
    let lists: Vec<Vec<f64>> = roots.chunks(most).map(finite).collect();
    let (mut done, mut open): (Vec<Chain>, Vec<Chain>) = (Vec::new(), Vec::new());
    for (k, (value, list)) in values.iter().zip(&lists).enumerate() {
        let before: &[f64] = if k > 0 { &lists[k - 1] } else { &[] };
        let joined = pairs(before, list);
        let mut next: Vec<Chain> = vec![Chain::default(); list.len()];
        for (from, chain) in open.into_iter().enumerate() {
            match joined.iter().find(|(left, _)| *left == from) {
                Some((_, to)) => next[*to] = chain,
                None => done.push(chain),
            }
        }
        // roots stand first in their row
        for ((x, y), shown) in next.iter_mut().zip(&shown[k * most..]) {
            x.push(*value);
            y.push(*shown);
        }
        open = next;
    }
    let mut all = Chain::default();
    for (x, y) in done.into_iter().chain(open) {
        all.0.extend(x.iter().copied().chain(x.last().copied()));
        all.1.extend(y.into_iter().chain([f64::NAN]));
    }
    all
}

/// Joins two ascending lists of roots, by index, without crossing, leaving out of the longer one what would make the joints
/// longest.
fn pairs(left: &[f64], right: &[f64]) -> Vec<(usize, usize)> {
    if left.len() > right.len() {
        return pairs(right, left).into_iter().map(|(r, l)| (l, r)).collect();
    }
    let length = |joined: &[(usize, usize)]| {
        joined.iter().map(|(a, b)| (left[*a] / right[*b]).ln().abs()).sum::<f64>()
    };
    let surplus = right.len() - left.len();
    // roots are born and die in neighbouring pairs: what is left out stands together
    let leaving_out = |first: usize| -> Vec<(usize, usize)> {
        (0..left.len()).zip((0..right.len()).filter(|k| *k < first || *k >= first + surplus)).collect()
    };
    (0..=left.len()).map(leaving_out).min_by(|a, b| length(a).total_cmp(&length(b))).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pair_that_dies_ends_two_curves_and_leaves_the_third_whole() {
        let nan = f64::NAN;
        let roots = [1.0, 10.0, 20.0, 1.1, 14.0, 15.0, 1.2, nan, nan, 1.3, nan, nan];
        let (x, y) = branches(&[1.0, 2.0, 3.0, 4.0], &roots, &roots, 3);
        let curves: Vec<&[f64]> = y.split(|v| v.is_nan()).filter(|curve| !curve.is_empty()).collect();
        assert_eq!(curves, [&[10.0, 14.0][..], &[20.0, 15.0], &[1.0, 1.1, 1.2, 1.3]]);
        assert_eq!(x.len(), y.len());
    }
}
