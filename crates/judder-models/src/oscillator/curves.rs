//! Curves over one swept quantity.

#![deny(clippy::indexing_slicing, reason = "stored arrays may be of any length")]

use crate::motion::si::second_of;
use crate::oscillator::margins::NOT_KNOWN;
use judder_numerics::complex::ElementaryComplex;
use judder_report::runs::{Curve, alone, apart};
use judder_report::{Axis, Layer, Panel, Role};
use judder_study::pictures::{
    StoredArrays, SweptCoordinates, at, axis, codes, complexes, picked, reals, text,
};
use num_complex::Complex64;
use std::f64::consts::TAU;

/// ξ_eq over the swept quantity, on an axis that shows both signs over many decades.
pub(crate) fn equivalent_damping(dataset: &StoredArrays<'_>) -> Option<Vec<Panel>> {
    /// Half width of the linear part of the axis.
    const LINEAR: f64 = 0.01;
    let swept = SweptCoordinates::of(dataset, "equivalent_damping", 0)?;
    dataset.alike(&["equivalent_damping", "equivalent_damping_error"])?;
    let damping = reals(dataset, "equivalent_damping")?;
    let errors = reals(dataset, "equivalent_damping_error");
    let errors_of = |curve: usize| errors?.chunks(swept.values.len().max(1)).nth(curve);
    let mut layers = vec![Layer::horizontal_rule(0.0, "")];
    for (curve, values) in damping.chunks(swept.values.len().max(1)).enumerate() {
        layers.push(Layer::line(
            swept.label(curve, ""),
            swept.values.to_vec(),
            values.to_vec(),
            swept.role(curve).solid(),
        ));
        for (side, label) in [(-1.0, "within the law"), (1.0, "")] {
            let Some(errors) = errors_of(curve) else { continue };
            let edge = values.iter().zip(errors).map(|(value, error)| value + side * error).collect();
            let label = if curve == 0 { label } else { "" };
            layers.push(Layer::line(label, swept.values.to_vec(), edge, swept.role(curve).dotted()));
        }
    }
    let vertical = Axis::symmetric_log("Equivalent damping $ξ_{eq}$ (−)", LINEAR);
    Some(vec![Panel::new(axis(swept.axis), vertical, layers)])
}

/// What stands at axes and heads of growth rates and of frequencies.
pub(crate) struct SpectrumLabels {
    pub(crate) growth: &'static str,
    pub(crate) frequency: &'static str,
}

/// Those of a case that is written in SI.
const IN_SI: SpectrumLabels =
    SpectrumLabels { growth: "Growth rate Re $λ$ (1/s)", frequency: "Frequency Im $λ$/2π (Hz)" };

/// Values times a factor.
fn scaled(values: Vec<f64>, factor: f64) -> Vec<f64> {
    values.into_iter().map(|value| factor * value).collect()
}

/// Growth rates and frequencies, of the full system and without damping; in SI where the case is written in SI.
pub(crate) fn spectrum(dataset: &StoredArrays<'_>, labels: &SpectrumLabels) -> Option<Vec<Panel>> {
    let swept = SweptCoordinates::of(dataset, "eigenvalues", 1)?;
    dataset.alike(&["eigenvalues", "conservative_eigenvalues"])?;
    let before = dataset.variable("eigenvalues")?.shape.len().saturating_sub(1);
    dataset.shaped("eigenvalues", &[vec![None; before], vec![Some(4)]].concat())?;
    let full = complexes(dataset, "eigenvalues")?;
    let conservative = complexes(dataset, "conservative_eigenvalues")?;
    let units = second_of(dataset.attributes());
    let (per_second, hertz) =
        (units.map_or(1.0, f64::recip), units.map_or(1.0, |second| 1.0 / (TAU * second)));
    let labels = if units.is_some() { &IN_SI } else { labels };
    let (mut growth, mut frequency) = (Vec::new(), Vec::new());
    let points = swept.values.len();
    for (system, values) in [("without damping", conservative), ("full system", full)] {
        let is_full = system == "full system";
        for (curve, spectra) in values.chunks(4 * points.max(1)).enumerate() {
            let spectra = followed(spectra);
            for mode in 0..4 {
                let part = |pick: fn(&Complex64) -> f64| -> Vec<f64> {
                    spectra.iter().skip(mode).step_by(4).map(pick).collect()
                };
                let role = if swept.family.is_some() { swept.role(curve) } else { Role::Mode(mode % 2) };
                let style = if is_full { role.solid() } else { role.dashed() };
                let label = if mode == 0 { swept.label(curve, system) } else { String::new() };
                let label = if swept.family.is_some() && !is_full { String::new() } else { label };
                growth.push(Layer::line(
                    label.clone(),
                    swept.values.to_vec(),
                    scaled(part(|l| l.re), per_second),
                    style,
                ));
                // conjugates mirror each other: one half of the plane shows all
                let upper = part(|l| if l.im >= 0.0 { l.im } else { f64::NAN });
                frequency.push(Layer::line(label, swept.values.to_vec(), scaled(upper, hertz), style));
            }
        }
    }
    growth.insert(0, Layer::horizontal_rule(0.0, ""));
    Some(vec![
        Panel::new(axis(swept.axis), Axis::linear(labels.growth), growth),
        Panel::new(axis(swept.axis), Axis::linear(labels.frequency), frequency),
    ])
}

/// Spectra of four eigenvalues, which are stored in the order of their frequencies, in that of the modes: each row as near in all to the one before as
/// can be, so that modes whose frequencies cross stay apart.
fn followed(spectra: &[Complex64]) -> Vec<Complex64> {
    let orders = orders(4);
    let mut all: Vec<Complex64> = Vec::with_capacity(spectra.len());
    for row in spectra.chunks(4) {
        let before = all.get(all.len().saturating_sub(4)..).unwrap_or_default();
        let away = |order: &Vec<usize>| -> f64 {
            let picked = order.iter().filter_map(|k| row.get(*k));
            picked.zip(before).map(|(own, last)| (own - last).modulus()).sum()
        };
        // beside a missing row nothing is nearest, and the first order is that of the frequencies
        let order = orders.iter().min_by(|a, b| away(a).total_cmp(&away(b)));
        all.extend(order.into_iter().flatten().filter_map(|k| row.get(*k)));
    }
    all
}

/// All orders of so many things, first the one in which they stand.
fn orders(count: usize) -> Vec<Vec<usize>> {
    if count == 0 {
        return vec![Vec::new()];
    }
    let insert = |last: usize| {
        move |order: Vec<usize>| {
            (0..=order.len()).rev().map(move |at| {
                let mut longer = order.clone();
                longer.insert(at, last);
                longer
            })
        }
    };
    orders(count - 1).into_iter().flat_map(insert(count - 1)).collect()
}

/// Thresholds over the swept quantity, with what grows from them and the folds of the cycles that do.
pub(crate) fn critical(dataset: &StoredArrays<'_>) -> Option<Vec<Panel>> {
    let swept = SweptCoordinates::of(dataset, "full", 1)?;
    let points = dataset.variable("full")?.dimensions.iter().rev().skip(1).rev().map(String::as_str);
    let over = |last| points.clone().chain([last]).collect::<Vec<_>>();
    dataset.over("conservative", &over("conservative_root"))?;
    for end in ["full_within_law_from", "full_within_law_to"] {
        dataset.over(end, &over("full_range"))?;
    }
    let label = text(dataset.variable("full")?, "label").unwrap_or("Threshold");
    dataset.alike(&["full", "fold", "reaches", "criticality", "told"])?;
    let mut layers = Vec::new();
    for (name, is_full) in [("conservative", false), ("full", true)] {
        let roots = reals(dataset, name)?;
        let most = *dataset.variable(name)?.shape.last()?;
        if most == 0 || swept.values.is_empty() {
            continue;
        }
        for (curve, roots) in roots.chunks(most * swept.values.len()).enumerate() {
            let (x, y) = branches(&swept.values, roots, roots, most);
            let role = swept.role(curve);
            let style = if is_full { role.solid() } else { role.dashed() };
            let shown = match (swept.family.is_some(), is_full) {
                (true, true) => swept.label(curve, ""),
                (true, false) => String::new(),
                (false, true) => "full system".to_owned(),
                (false, false) => "without damping".to_owned(),
            };
            let (alone_x, alone_y) = alone(&x, &y);
            layers.push(Layer::line(shown, x, y, style));
            if !alone_x.is_empty() {
                layers.push(Layer::points("", alone_x, alone_y, role.crowded()));
            }
        }
    }
    if swept.family.is_some() {
        layers.push(Layer::key("full system", Role::FullBoundary.solid()));
        layers.push(Layer::key("without damping", Role::ConservativeBoundary));
    }
    layers.extend(folds(dataset, &swept));
    layers.extend(within_law(dataset, &swept));
    Some(vec![Panel::new(axis(swept.axis), Axis::log(label), layers)])
}

/// The ranges in which the errors of the law leave the thresholds of the full system, a stroke each.
fn within_law(dataset: &StoredArrays<'_>, swept: &SweptCoordinates<'_>) -> Option<Layer> {
    let (from, to) = (reals(dataset, "full_within_law_from")?, reals(dataset, "full_within_law_to")?);
    let most = *dataset.variable("full_within_law_from")?.shape.last()?;
    let values = swept.values.iter().flat_map(|value| std::iter::repeat_n(*value, most)).cycle();
    let ranges = values.zip(from.iter().zip(to));
    let known = ranges.filter(|(_, (from, to))| from.is_finite() && to.is_finite());
    let strokes = known.map(|(value, (from, to))| (vec![value; 2], vec![*from, *to]));
    let (x, y) = apart(strokes);
    (!x.is_empty()).then(|| Layer::line("full system, within the law", x, y, Role::Reference.solid()))
}

/// The folds beside the thresholds, how far lost branches are known, and which thresholds are sub- or supercritical; nothing
/// where no branch was followed, for then there are too many thresholds to mark them.
fn folds(dataset: &StoredArrays<'_>, swept: &SweptCoordinates<'_>) -> Vec<Layer> {
    const SUBCRITICAL: u8 = 2;
    let known = || {
        let numbers = (reals(dataset, "full")?, reals(dataset, "fold")?, reals(dataset, "reaches")?);
        Some((numbers, codes(dataset, "criticality")?, *dataset.variable("full")?.shape.last()?))
    };
    let Some(((roots, folds, reaches), criticality, most)) =
        known().filter(|known| known.2 * swept.values.len() > 0)
    else {
        return Vec::new();
    };
    let mut layers = Vec::new();
    let length = most * swept.values.len();
    for (curve, (roots, folds)) in roots.chunks(length).zip(folds.chunks(length)).enumerate() {
        let (x, y) = branches(&swept.values, roots, folds, most);
        let label = if curve == 0 { "least known fold" } else { "" };
        layers.push(Layer::line(label, x, y, swept.role(curve).dash_dotted()));
    }
    let points = |label: &str, of: &dyn Fn(usize) -> f64, series: usize| {
        let across = (0..roots.len()).map(|k| at(&swept.values, k % length / most)).collect();
        Layer::points(label, across, (0..roots.len()).map(of).collect(), Role::Series(series))
    };
    let is = |k: usize, code: u8| if criticality.get(k) == Some(&code) { at(roots, k) } else { f64::NAN };
    layers.push(points("supercritical", &|k| is(k, SUBCRITICAL - 1), 0));
    layers.push(points("subcritical", &|k| is(k, SUBCRITICAL), 1));
    let lost = |k: usize| if at(folds, k).is_nan() { at(reaches, k) } else { f64::NAN };
    if (0..roots.len()).any(|k| lost(k).is_finite()) {
        layers.push(points("no fold: motions up to here", &lost, 4));
    }
    let open = |k: usize| match codes(dataset, "told").and_then(|told| told.get(k).copied()) {
        Some(NOT_KNOWN) if at(folds, k).is_finite() => at(folds, k),
        Some(NOT_KNOWN) if at(reaches, k).is_finite() => at(reaches, k),
        Some(NOT_KNOWN) => at(roots, k),
        _ => f64::NAN,
    };
    if (0..roots.len()).any(|k| open(k).is_finite()) {
        layers.push(points("not known beyond", &open, 5));
    }
    layers
}

/// The roots along the sweep as curves, with a gap after each, in the order in which they end. A curve shows the `shown` that belong to its roots.
fn branches(values: &[f64], roots: &[f64], shown: &[f64], most: usize) -> Curve {
    let on = curves_of(roots, most);
    let of_curve = |curve: usize| {
        let own = on.iter().enumerate().filter(|(_, own)| **own == Some(curve));
        own.map(|(k, _)| k).collect::<Vec<usize>>()
    };
    let mut curves: Vec<Vec<usize>> =
        (0..on.iter().flatten().max().map_or(0, |last| last + 1)).map(of_curve).collect();
    curves.sort_by_key(|places| places.last().map(|k| k / most));
    apart(
        curves
            .into_iter()
            .map(|places| places.into_iter().map(|k| (at(values, k / most), at(shown, k))).unzip()),
    )
}

/// Roots of neighbouring values that differ by a larger factor are not of one curve, or of one that the sweep does not resolve.
const FAR: f64 = 10.0;

/// On which curve each root lies, `None` where there is none; a row of `most` roots a value of the sweep. Neighbours are joined in order, and where
/// their numbers differ, the nearest ones; what is left over begins or ends there, and so does what is too far.
pub fn curves_of(roots: &[f64], most: usize) -> Vec<Option<usize>> {
    let mut on = vec![None; roots.len()];
    let mut count = 0;
    let mut before: Vec<usize> = Vec::new();
    for row in 0..roots.len() / most.max(1) {
        let here: Vec<usize> = (row * most..(row + 1) * most).filter(|k| at(roots, *k).is_finite()).collect();
        let joined = pairs(&picked(roots, &before), &picked(roots, &here));
        for (place, k) in here.iter().enumerate() {
            let from = joined.iter().find(|(_, to)| *to == place).and_then(|(from, _)| before.get(*from));
            let is_near =
                |from: &&usize| libm::log(at(roots, **from) / at(roots, *k)).abs() <= libm::log(FAR);
            let last = from.filter(is_near).and_then(|from| on.get(*from).copied().flatten());
            let own = last.or_else(|| {
                count += 1;
                Some(count - 1)
            });
            if let Some(place) = on.get_mut(*k) {
                *place = own;
            }
        }
        before = here;
    }
    on
}

/// Joins two ascending lists of roots, by index, without crossing, leaving out of the longer one what would make the joints
/// longest.
fn pairs(left: &[f64], right: &[f64]) -> Vec<(usize, usize)> {
    if left.len() > right.len() {
        return pairs(right, left).into_iter().map(|(r, l)| (l, r)).collect();
    }
    let length = |joined: &[(usize, usize)]| {
        joined.iter().map(|(a, b)| libm::log(at(left, *a) / at(right, *b)).abs()).sum::<f64>()
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
