//! Curves over one swept quantity.

use super::{Swept, axis, complexes, reals, text};
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

/// Thresholds over the swept quantity.
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
            let (x, y) = branches(swept.values, roots, most);
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
    Some(Panel::new(axis(swept.axis), Axis::log(label), layers))
}

/// The roots along the sweep as segments between neighbouring values, a gap after each: neighbours are joined in order, and where
/// their numbers differ, the nearest ones.
fn branches(values: &[f64], roots: &[f64], most: usize) -> (Vec<f64>, Vec<f64>) {
    let lists: Vec<Vec<f64>> = roots
        .chunks(most)
        .map(|roots| roots.iter().copied().filter(|root| root.is_finite()).collect())
        .collect();
    let (mut x, mut y) = (Vec::new(), Vec::new());
    for (values, lists) in values.windows(2).zip(lists.windows(2)) {
        for (from, to) in pairs(&lists[0], &lists[1]) {
            x.extend([values[0], values[1], values[1]]);
            y.extend([from, to, f64::NAN]);
        }
    }
    (x, y)
}

/// Joins two ascending lists of roots without crossing, leaving out of the longer one what makes the joints longest.
fn pairs(left: &[f64], right: &[f64]) -> Vec<(f64, f64)> {
    if left.len() > right.len() {
        return pairs(right, left).into_iter().map(|(r, l)| (l, r)).collect();
    }
    let length = |joined: &[(f64, f64)]| joined.iter().map(|(a, b)| (a / b).ln().abs()).sum::<f64>();
    let surplus = right.len() - left.len();
    // roots are born and die in neighbouring pairs: what is left out stands together
    let leaving_out = |first: usize| -> Vec<(f64, f64)> {
        let kept = right.iter().enumerate().filter(|(k, _)| *k < first || *k >= first + surplus);
        left.iter().copied().zip(kept.map(|(_, root)| *root)).collect()
    };
    (0..=left.len()).map(leaving_out).min_by(|a, b| length(a).total_cmp(&length(b))).unwrap_or_default()
}
