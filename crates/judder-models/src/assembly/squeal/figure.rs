//! Modes that grow: how loud their cycles are, beside how fast they grow.

use super::small_motions::FATES;
use super::told::STABILITIES;
use judder_report::{Axis, Layer, Legend, Panel, Role};
use judder_store::Dataset;
use judder_study::pictures::{codes, reals};

/// Room beside the outermost frequencies, over the span, and over a frequency that is alone.
const BESIDE: [f64; 2] = [0.08, 0.05];

/// Levels over the frequency of the cycles, growth rates over the frequency of the modes, and their margins where these are known.
pub(super) fn squeal(dataset: &Dataset) -> Option<Vec<Panel>> {
    let [of_modes, growth, of_cycles, level] =
        ["mode_frequency", "growth_rate", "frequency", "level"].map(|name| reals(dataset, name));
    let codes = codes(dataset, "stability")?;
    let across = across(of_modes?, of_cycles?);
    // nothing where no mode has such a value
    let panel = |up: Axis, place: [&[f64]; 2], title: &str| {
        let layers = STABILITIES.iter().enumerate().filter_map(|(k, (code, words))| {
            let own: Vec<usize> = (0..codes.len()).filter(|mode| codes[*mode] == *code).collect();
            let at = |values: &[f64]| {
                own.iter().map(|mode| values.get(*mode).copied().unwrap_or(f64::NAN)).collect()
            };
            let [x, y]: [Vec<f64>; 2] = place.map(at);
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

/// The energy that is left of knocks over their impulse.
fn knocks(dataset: &Dataset) -> Option<Panel> {
    let [impulse, energy] = ["impulse", "knock_energy"].map(|name| reals(dataset, name));
    let (impulse, energy, fates) = (impulse?, energy?, codes(dataset, "knock_fate")?);
    let layers = FATES.iter().enumerate().filter_map(|(k, (code, words))| {
        let own: Vec<usize> = (0..fates.len()).filter(|knock| fates[*knock] == *code).collect();
        let [x, y] =
            [impulse, energy].map(|values| own.iter().map(|knock| values[*knock]).collect::<Vec<f64>>());
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
