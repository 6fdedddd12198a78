//! Limit cycles along a key: stable solid, unstable dashed.

#![deny(clippy::indexing_slicing, reason = "stored arrays may be of any length")]

use judder_report::palette::Style;
use judder_report::runs::through;
use judder_report::{Layer, Legend, Panel, Role};
use judder_study::pictures::{StoredArrays, axis, codes, picked, reals};
use judder_study::shown::ShownValues;

/// How a cycle is drawn, by the code of its stability.
const KINDS: [(u8, &str); 3] =
    [(1, "stable cycles"), (0, "unstable cycles"), (2, "cycles of unknown stability")];

/// The amplitudes and the frequencies of the cycles over the key.
pub(super) fn bifurcation(dataset: &StoredArrays<'_>) -> Option<Vec<Panel>> {
    ["rms", "frequency"].into_iter().map(|name| over_key(dataset, name)).collect()
}

/// The bifurcations that there are, a kind a marker.
fn marked(dataset: &StoredArrays<'_>, name: &str, shown: &ShownValues) -> Vec<Layer> {
    let (Some(value), Some(up), Some(kinds)) = (
        reals(dataset, "bifurcation_value"),
        reals(dataset, &format!("bifurcation_{name}")),
        codes(dataset, "bifurcation_kind"),
    ) else {
        return Vec::new();
    };
    if dataset.alike(&["bifurcation_value", &format!("bifurcation_{name}"), "bifurcation_kind"]).is_none() {
        return Vec::new();
    }
    let value = shown.values(value);
    let of = |(code, label): (u8, &'static str)| {
        let own = kinds.iter().enumerate().filter(|(_, kind)| **kind == code);
        let own: Vec<usize> = own.map(|(place, _)| place).collect();
        let style = Role::Series(usize::from(code) + 1).solid();
        (!own.is_empty()).then(|| Layer::points(label, picked(&value, &own), picked(up, &own), style))
    };
    (0..).zip(super::named::KINDS).filter_map(of).collect()
}

fn over_key(dataset: &StoredArrays<'_>, name: &str) -> Option<Panel> {
    dataset.alike(&["value", name, "stable"])?;
    let (value, up) = (reals(dataset, "value")?, reals(dataset, name)?);
    let (key, stable) = (dataset.variable("value")?, codes(dataset, "stable")?);
    let shown = ShownValues::of_variable(key);
    let value = shown.values(value);
    let of = |code: u8| {
        // a stretch between unlike cycles is drawn as the one after it
        let (x, y) = through(&value, up, |k| stable.get(k + 1) == Some(&code));
        let style = match code {
            1 => Role::FullBoundary.solid(),
            0 => Role::FullBoundary.dashed(),
            _ => Role::Reference.solid(),
        };
        (x, y, Style { width: 1.0, ..style })
    };
    let layers = KINDS.iter().filter_map(|(code, label)| {
        let (x, y, style) = of(*code);
        (!x.is_empty()).then(|| Layer::line(*label, x, y, style))
    });
    let layers = layers.chain(marked(dataset, name, &shown));
    let (across, upwards) = (axis(key), axis(dataset.variable(name)?));
    Some(Panel::new(across, upwards, layers.collect()).with_legend(Legend::Below))
}
