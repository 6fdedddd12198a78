//! Modes that grow: how loud their cycles are, beside how fast they grow.

#![deny(clippy::indexing_slicing, reason = "stored arrays may be of any length")]

use super::small_motions::FATES;
use super::told::STABILITIES;
use judder_report::{Axis, Layer, Legend, Panel, Role};
use judder_study::pictures::{StoredArrays, codes, picked, reals};

/// Room beside the outermost frequencies, over the span, and over a frequency that is alone.
const BESIDE: [f64; 2] = [0.08, 0.05];

/// Levels over the frequency of the cycles, growth rates over the frequency of the modes, and their margins where these are known.
pub(super) fn squeal(dataset: &StoredArrays<'_>) -> Option<Vec<Panel>> {
    let [of_modes, growth, of_cycles, level] =
        ["mode_frequency", "growth_rate", "frequency", "level"].map(|name| reals(dataset, name));
    dataset.shaped("stability", &[None])?;
    dataset.alike(&["stability", "mode_frequency", "growth_rate", "frequency", "level", "margin"])?;
    let codes = codes(dataset, "stability")?;
    let across = across(of_modes?, of_cycles?);
    // nothing where no mode has such a value
    let panel = |up: Axis, place: [&[f64]; 2], title: &str| {
        let layers = STABILITIES.iter().enumerate().filter_map(|(k, (code, words))| {
            let [x, y]: [Vec<f64>; 2] = place.map(|values| picked(values, &of_code(codes, *code)));
            let is_shown = x.iter().zip(&y).any(|(x, y)| x.is_finite() && y.is_finite());
            is_shown.then(|| Layer::points(*words, x, y, Role::Series(k)))
        });
        let layers: Vec<Layer> = layers.collect();
        (!layers.is_empty())
            .then(|| Panel::new(across.clone(), up, layers).with_legend(Legend::Below).with_title(title))
    };
    let margins = reals(dataset, "margin").unwrap_or_default();
    let asked = [
        panel(
            Axis::linear("Level of the cycle (dB re 1 µm/s^{2})"),
            [of_cycles?, level?],
            "how loud they are where they are loudest",
        ),
        panel(Axis::linear("Growth rate of the mode (1/s)"), [of_modes?, growth?], "how fast modes grow"),
        panel(
            Axis::linear("Margin, of the value at the onset (1)"),
            [of_modes?, margins],
            "how far before their onset cycles exist already",
        ),
        knocks(dataset),
    ];
    Some(asked.into_iter().flatten().collect())
}

/// The places that have a code.
fn of_code(codes: &[u8], code: u8) -> Vec<usize> {
    codes.iter().enumerate().filter(|(_, own)| **own == code).map(|(place, _)| place).collect()
}

/// The energy that is left of knocks over their impulse.
fn knocks(dataset: &StoredArrays<'_>) -> Option<Panel> {
    dataset.alike(&["impulse", "knock_energy", "knock_fate"])?;
    let [impulse, energy] = ["impulse", "knock_energy"].map(|name| reals(dataset, name));
    let (impulse, energy, fates) = (impulse?, energy?, codes(dataset, "knock_fate")?);
    let layers = FATES.iter().enumerate().filter_map(|(k, (code, words))| {
        let [x, y] = [impulse, energy].map(|values| picked(values, &of_code(fates, *code)));
        (!x.is_empty()).then(|| Layer::points(*words, x, y, Role::Series(k)))
    });
    let axes = [Axis::linear("Impulse of the knock (N s)"), Axis::linear("Energy at the end (J)")];
    let [across, up] = axes;
    Some(
        Panel::new(across, up, layers.collect())
            .with_legend(Legend::Below)
            .with_title("what is left of the energy of knocks"),
    )
}

/// One axis of frequencies for both.
fn across(of_modes: &[f64], of_cycles: &[f64]) -> Axis {
    let all = of_modes.iter().chain(of_cycles).copied().filter(|own| own.is_finite());
    let (low, high) =
        all.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), own| (low.min(own), high.max(own)));
    let room = (BESIDE[0] * (high - low)).max(BESIDE[1] * high.abs());
    let axis = Axis::linear("Frequency (Hz)");
    if room > 0.0 && room.is_finite() { axis.over(low - room, high + room) } else { axis }
}
