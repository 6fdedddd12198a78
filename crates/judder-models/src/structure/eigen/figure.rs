//! Complex modes: where they lie, how damped they are, their shapes.

#![deny(clippy::indexing_slicing, reason = "stored arrays may be of any length")]

use super::super::shape_panels::{mac, panels as shape_panels, significant};
use judder_numerics::complex::ElementaryComplex;
use judder_numerics::order::sort_by_number;
use judder_report::{Axis, Layer, Panel, Role};
use judder_study::pictures::{StoredArrays, at, codes, complexes};
use num_complex::Complex64;
use std::f64::consts::TAU;

/// How verdicts are called and drawn: by colour and marker, so that they differ in grey too.
pub(crate) const VERDICTS: [(&str, Role); 3] =
    [("stable", Role::Series(0)), ("marginal", Role::Series(2)), ("unstable", Role::Series(1))];
/// Of the largest growth rate, what the even part of its axis takes.
const EVEN: f64 = 1e-3;
/// Where a logarithmic axis ends, over the largest value.
const ROOM: f64 = 3.0;
/// The diameter of the largest bubble over that of a usual marker.
pub(crate) const LARGEST: f64 = 4.0;
/// Shapes that a figure shows: the unstable ones first.
const SHOWN: usize = 4;

/// Where nothing is drawn.
const NOWHERE: (f64, f64) = (f64::NAN, f64::NAN);

/// The complex plane, damping ratios, shapes of the unstable modes, shapes against each other.
pub(crate) fn eigen(dataset: &StoredArrays<'_>) -> Option<Vec<Panel>> {
    dataset.over("eigenvalue", &["mode"])?;
    dataset.over("verdict", &["mode"])?;
    let (values, verdicts) = (complexes(dataset, "eigenvalue")?, codes(dataset, "verdict")?);
    let mut panels = vec![plane(values, verdicts), bubbles(values, verdicts)];
    let mut order: Vec<(usize, &Complex64)> = values.iter().enumerate().collect();
    sort_by_number(&mut order, |own| -own.1.re);
    let title = |k: usize| {
        let value = values.get(k).copied().unwrap_or(Complex64::new(f64::NAN, f64::NAN));
        let ratio = -value.re / value.modulus();
        format!("{} Hz, $ζ$ = {} %", significant(value.im / TAU), significant(100.0 * ratio))
    };
    let fastest = order.into_iter().take(SHOWN).map(|(k, _)| k);
    panels.extend(shape_panels(dataset, fastest, &title));
    panels.extend(mac(dataset));
    Some(panels)
}

/// An axis of growth rates that shows both signs over many decades.
pub(crate) fn growth_axis(values: &[Complex64]) -> Axis {
    let finite = values.iter().map(|value| value.re.abs()).filter(|growth| growth.is_finite());
    let largest = finite.fold(0.0, f64::max);
    let label = "Growth rate Re $λ$ (1/s)";
    match largest > 0.0 {
        true => Axis::symmetric_log(label, EVEN * largest).over(-ROOM * largest, ROOM * largest),
        false => Axis::linear(label),
    }
}

/// An axis of the frequencies of eigenvalues, with room beside the outermost.
pub(crate) fn frequency_axis(values: &[Complex64]) -> Axis {
    /// Room on both sides, over the span; and over the frequency itself, where it is one.
    const BESIDE: [f64; 2] = [0.08, 0.01];
    let hertz = values.iter().map(|value| value.im / TAU).filter(|hertz| hertz.is_finite());
    let (low, high) = hertz.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), f| (l.min(f), h.max(f)));
    let room = (BESIDE[0] * (high - low)).max(BESIDE[1] * high.abs());
    let axis = Axis::linear("Frequency Im $λ$/2π (Hz)");
    if room > 0.0 && room.is_finite() { axis.over(low - room, high + room) } else { axis }
}

/// The eigenvalues of each verdict as points.
pub(crate) fn by_verdict(
    verdicts: &[u8],
    place: &dyn Fn(usize) -> (f64, f64),
    size: Option<&dyn Fn(usize) -> f64>,
) -> Vec<Layer> {
    let layer = |(code, (label, role)): (usize, &(&str, Role))| {
        let of_it = verdicts.iter().enumerate().filter(|(_, own)| usize::from(**own) == code);
        let own: Vec<usize> = of_it.map(|(k, _)| k).collect();
        let (x, y): (Vec<f64>, Vec<f64>) = own.iter().map(|k| place(*k)).unzip();
        (!own.is_empty()).then(|| match size {
            Some(size) => Layer::bubbles(*label, x, y, own.iter().map(|k| size(*k)).collect(), *role),
            None => Layer::points(*label, x, y, *role),
        })
    };
    VERDICTS.iter().enumerate().filter_map(layer).collect()
}

fn plane(values: &[Complex64], verdicts: &[u8]) -> Panel {
    let mut layers = vec![Layer::vertical_rule(0.0, "")];
    layers.extend(by_verdict(
        verdicts,
        &|k| values.get(k).map_or(NOWHERE, |own| (own.re, own.im / TAU)),
        None,
    ));
    Panel::new(growth_axis(values), frequency_axis(values), layers).with_title("eigenvalues")
}

/// Damping ratios over frequency; a bubble's area is the magnitude of its ratio.
fn bubbles(values: &[Complex64], verdicts: &[u8]) -> Panel {
    let ratios: Vec<f64> = values.iter().map(|own| -own.re / own.modulus()).collect();
    let largest = ratios.iter().map(|ratio| ratio.abs()).fold(f64::MIN_POSITIVE, f64::max);
    let mut layers = vec![Layer::horizontal_rule(0.0, "")];
    let size = |k: usize| LARGEST * bubble(at(&ratios, k), largest);
    let place = |k: usize| values.get(k).map_or(NOWHERE, |own| (own.im / TAU, at(&ratios, k)));
    layers.extend(by_verdict(verdicts, &place, Some(&size)));
    let vertical =
        Axis::symmetric_log("Damping ratio $ζ$ (−)", EVEN * largest).over(-ROOM * largest, ROOM * largest);
    Panel::new(frequency_axis(values), vertical, layers).with_title("damping ratios")
}

/// The diameter of a bubble over that of the largest: its area is in proportion to the ratio, and never too small to be seen.
pub(crate) fn bubble(ratio: f64, largest: f64) -> f64 {
    const SMALLEST: f64 = 0.15;
    (ratio.abs() / largest).sqrt().max(SMALLEST)
}
