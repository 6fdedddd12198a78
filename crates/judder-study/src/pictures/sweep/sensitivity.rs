//! Which swept key decides what: first-order and total Sobol' indices with their confidence intervals.

use super::{DrawnSweep, PANELS, left_out, part};
use judder_numerics::order::sort_by_number;
use judder_report::{Axis, Figure, Layer, Legend, Panel, Role};
use serde_json::Value;

/// Keys that a panel has room for.
const KEYS: usize = 16;
/// How far the two indices of a key stand apart, over the distance of two keys.
const APART: f64 = 0.14;
/// Room beside 0 and 1.
const ROOM: f64 = 0.05;

/// The indices of all quantities that have some.
pub(super) fn figure(name: &str, sweep: &DrawnSweep<'_>) -> Option<Figure> {
    let all = sweep.sensitivity?;
    let known: Vec<(&str, &Value)> = sweep
        .columns
        .iter()
        .filter_map(|column| {
            Some((column.name.as_str(), all.get(&column.name).filter(|own| own.is_object())?))
        })
        .collect();
    let panels: Vec<Panel> = known.iter().take(PANELS).map(|(name, own)| panel(sweep, name, own)).collect();
    let confidence = known.first().and_then(|(_, own)| own.get("confidence")?.as_f64())?;
    let caption = format!(
        "Sobol' indices: the share of the variance that a key explains alone (first order) and with all others (total), with {} % \
         confidence intervals.{}{}",
        100.0 * confidence,
        left_out(panels.len(), known.len(), "quantities"),
        left_out(KEYS.min(sweep.keys.len()), sweep.keys.len(), "keys, by their largest total index"),
    );
    let title = format!("{name}: sensitivity");
    Some(Figure::new(format!("{name}-sensitivity"), title, panels).with_caption(caption))
}

fn panel(sweep: &DrawnSweep<'_>, quantity: &str, indices: &Value) -> Panel {
    let total = |path: &str| part(indices, &["total", path, "value"]).as_f64().unwrap_or(f64::NEG_INFINITY);
    let mut keys: Vec<&super::KeyColumn> = sweep.keys.iter().collect();
    sort_by_number(&mut keys, |own| -total(&own.path));
    keys.truncate(KEYS);
    // the largest stands above
    keys.reverse();
    let mut layers = Vec::new();
    let (mut low, mut high) = (0.0_f64, 1.0_f64);
    for (order, label, role, shift) in
        [("first", "first order", Role::Series(0), APART), ("total", "total", Role::Series(1), -APART)]
    {
        let (mut across, mut up, mut bars) = (Vec::new(), Vec::new(), (Vec::new(), Vec::new()));
        for (place, key) in keys.iter().enumerate() {
            let of = |end: &str| part(indices, &[order, &key.path, end]).as_f64().unwrap_or(f64::NAN);
            let [value, from, to] = ["value", "from", "to"].map(of);
            let at = place as f64 + shift;
            (low, high) = (low.min(from).min(value), high.max(to).max(value));
            across.push(value);
            up.push(at);
            bars.0.extend([from, to, to]);
            bars.1.extend([at, at, f64::NAN]);
        }
        layers.push(Layer::line("", bars.0, bars.1, role.solid()));
        layers.push(Layer::points(label, across, up, role));
    }
    let x = Axis::linear("Share of the variance (−)").over(low - ROOM, high + ROOM);
    let y = Axis::named("", keys.iter().map(|key| without_unit(&key.label)));
    layers.push(Layer::vertical_rule(0.0, ""));
    Panel::new(x, y, layers).with_title(quantity).with_legend(Legend::Below)
}

/// A label without the unit in brackets at its end.
fn without_unit(label: &str) -> String {
    label.rsplit_once(" (").map_or(label, |(name, _)| name).to_owned()
}
