//! The figures of the beams paper, put together from several marches where the paper compares them.

#![deny(clippy::indexing_slicing, reason = "stored arrays may be of any length")]

use super::passage::Passage;
use judder_models::sliding::MODEL as SLIDING;
use judder_models::sliding::march::figure::{history, logarithmic, panel, swing, trace};
use judder_report::{Axis, Figure, Layer, Legend, Panel, Role, Style};
use judder_study::pictures::{StoredArrays, axis, reals};
use serde_json::Value;

/// The signal of Figs. 3 to 5: the vertical acceleration of the free end T.
pub(super) const SIGNAL: &str = "T.y";
/// How a method is drawn, in every picture.
const SUBS: Role = Role::Series(4);
const ENSUBS: Role = Role::Series(0);
const FILM: Role = Role::Series(2);
const RESIDUAL: Role = Role::Series(6);
/// How far about the loudest moment single swings are shown, s.
const ABOUT: f64 = 1.5e-3;
/// What single swings rise to of their axis, so that the legend has room.
const OVER: f64 = 1.1;

/// The figure that an analysis has by itself.
pub(super) fn own(arrays: &StoredArrays<'_>, name: &str, title: &str) -> Option<Figure> {
    let panels = Some(SLIDING.panels_of(arrays)).filter(|panels| !panels.is_empty())?;
    Some(Figure::new(name, title, panels).with_caption(SLIDING.caption(arrays.dataset())))
}

/// Fig. 3: what Subs and FiLM find, each on its axis and both on one.
pub(super) fn subs_and_film(arrays: &[StoredArrays<'_>]) -> Option<Figure> {
    let [subs, film] = arrays else { return None };
    let own = |arrays, label: &str, role: Role| {
        history(arrays, SIGNAL, role.solid()).map(|panel| panel.with_title(label))
    };
    let both = logarithmic(panel(
        film,
        SIGNAL,
        vec![swing(film, SIGNAL, "FiLM", FILM.solid())?, swing(subs, SIGNAL, "Subs", SUBS.solid())?],
    )?);
    let mut panels = vec![own(subs, "Subs", SUBS)?, own(film, "FiLM", FILM)?];
    panels.push(both.with_title("amplitude: √2 rms of a column"));
    let caption = "Each on an axis of its own, then both on a logarithmic one. What both have in common are clicks at the nodes of the track, every millimetre; \
                   bursts has FiLM alone.";
    Some(Figure::new("fig-3", "Vertical acceleration of T: Subs and FiLM", panels).with_caption(caption))
}

/// Fig. 4: both spectrograms with one scale of levels, and both waterfalls.
pub(super) fn spectrograms(arrays: &[StoredArrays<'_>]) -> Option<Figure> {
    let [subs, film] = arrays else { return None };
    let (of_subs, of_film) = (SLIDING.panels_of(subs), SLIDING.panels_of(film));
    let named = |method: &'static str| {
        move |panel: Panel| {
            let title = format!("{method}: {}", panel.title);
            panel.with_title(title)
        }
    };
    let all: Vec<Panel> =
        of_subs.into_iter().map(named("Subs")).chain(of_film.into_iter().map(named("FiLM"))).collect();
    let [a, b, c, d] = <[Panel; 4]>::try_from(all).ok()?;
    let figure = Figure::new("fig-4", "Spectrograms of the vertical acceleration of T", vec![a, c, b, d]);
    Some(figure.with_caption(
        "Levels on one scale, with the unstable zones of the undeformed pair over Subs and of the deformed one over FiLM. Below, spectra that stand on \
         the positions of the contact; bars are the zones. Horizontal lines are modes that the clicks at the nodes excite.",
    ))
}

/// Fig. 5: EnSubs over FiLM, the whole, the loudest moment, and their difference.
pub(super) fn ensubs_and_film(arrays: &[StoredArrays<'_>]) -> Option<Figure> {
    let [ensubs, film] = arrays else { return None };
    let both = vec![
        trace(ensubs, SIGNAL, "EnSubs", ENSUBS.solid())?,
        trace(film, SIGNAL, "FiLM", FILM.dashed().with_width(0.6))?,
    ];
    let whole = panel(ensubs, SIGNAL, both)?.with_title("whole path");
    let about = about_loudest(ensubs, &[(ensubs, "EnSubs", ENSUBS.solid()), (film, "FiLM", FILM.dashed())])?;
    let amplitudes = vec![
        swing(ensubs, SIGNAL, "EnSubs", ENSUBS.solid())?,
        difference(ensubs, film, "FiLM − EnSubs", FILM.solid())?,
    ];
    let amplitudes = logarithmic(panel(ensubs, SIGNAL, amplitudes)?);
    let amplitudes = Panel { y: Axis::log(amplitudes.y.label.clone()), ..amplitudes };
    let panels = vec![whole, about, amplitudes.with_title("amplitude, and that of the difference")];
    Some(
        Figure::new("fig-5", "Vertical acceleration of T: EnSubs and FiLM", panels)
            .with_caption("Both marches over the whole path, single swings at the loudest moment, and the difference of both on a logarithmic axis."),
    )
}

/// Fig. 6: sliding velocity and normal force of EnSubs, with zero on the axis and after the ramps.
pub(super) fn forces(ensubs: &StoredArrays<'_>) -> Option<Figure> {
    let mut panels = Vec::new();
    for name in ["sliding_velocity", "normal_force"] {
        panels.push(history(ensubs, name, ENSUBS.solid())?.with_title("whole path"));
    }
    for name in ["sliding_velocity", "normal_force"] {
        let own = history(ensubs, name, ENSUBS.solid())?;
        panels.push(settled(own, ensubs, name)?.with_title("after the ramps"));
    }
    let caption = "EnSubs. Above, with zero on the axis; below, what is left of that after the ramps. Both stay far from zero: the contact slides ahead and never opens. The extremes of every step stand in the scoreboard.";
    Some(Figure::new("fig-6", "Sliding velocity and normal force", panels).with_caption(caption))
}

/// What the zones promise and what EnSubs makes of it.
pub(super) fn zones(passages: &[Passage]) -> Figure {
    let quantity = "Amplitude of $ü_{y}$ of T (m/s^{2})";
    let panels: Vec<Panel> = passages.iter().map(|passage| passage.panel(quantity)).collect();
    let caption = "Every zone that promises one neper or more: the acceleration of T within 200 Hz of the zone's frequency, by a Hann window of 10 ms, and \
                   what ∫ σ dt of the locus promises from the start of the zone on. Steps at whole millimetres are clicks at the nodes of the track; a click \
                   inside a weak zone outdoes it. The whole signal holds the clicks of all modes, so that before a burst it is louder than the mode that \
                   grows, and the burst seems to grow by less than its zone promises.";
    Figure::new("zones", "What the unstable zones promise, and the mode in the march", panels)
        .with_caption(caption)
}

/// Growth with the contact held, four places a figure.
pub(super) fn growths(method: &str, name: &str, held: &[StoredArrays<'_>]) -> Option<Figure> {
    let panels = held.iter().map(|own| Some(SLIDING.panels_of(own)).filter(|panels| !panels.is_empty()));
    let panels: Vec<Panel> = panels.collect::<Option<Vec<_>>>()?.concat();
    let caption = SLIDING.caption(held.first()?.dataset());
    let title = format!("Growth with the contact held, by {method}");
    Some(Figure::new(name, title, panels).with_caption(caption))
}

/// Why Subs is quiet: with the static slope it is as loud as EnSubs.
pub(super) fn reason(arrays: &[StoredArrays<'_>]) -> Option<Figure> {
    let [subs, sloped, ensubs] = arrays else { return None };
    let layers = vec![
        swing(ensubs, SIGNAL, "EnSubs", ENSUBS.solid())?,
        swing(sloped, SIGNAL, "Subs with the static slope", SUBS.dashed())?,
        swing(subs, SIGNAL, "Subs", SUBS.solid())?,
    ];
    let amplitudes = logarithmic(panel(ensubs, SIGNAL, layers)?).with_title("amplitude: √2 rms of a column");
    let styles = [(ensubs, "EnSubs", ENSUBS.solid()), (sloped, "Subs with the static slope", SUBS.dashed())];
    let panels = vec![amplitudes, about_loudest(ensubs, &styles)?];
    let caption = "Of the deformation that Subs leaves out, the static slope of the track alone brings the bursts back. It \
                   grows with the load.";
    Some(Figure::new("static-slope", "Why Subs does not burst", panels).with_caption(caption))
}

/// The march with residual flexibility beside EnSubs.
pub(super) fn residual(arrays: &[StoredArrays<'_>]) -> Option<Figure> {
    let [ours, ensubs] = arrays else { return None };
    let layers = vec![
        swing(ensubs, SIGNAL, "EnSubs", ENSUBS.solid())?,
        swing(ours, SIGNAL, "residual flexibility", RESIDUAL.dashed().with_width(0.8))?,
    ];
    let amplitudes = logarithmic(panel(ensubs, SIGNAL, layers)?).with_title("amplitude: √2 rms of a column");
    let styles = [(ensubs, "EnSubs", ENSUBS.solid()), (ours, "residual flexibility", RESIDUAL.dashed())];
    let panels = vec![amplitudes, about_loudest(ensubs, &styles)?];
    let caption = "The march of our own, exact between contacts and with longer steps, beside EnSubs: the whole path, and single swings at the loudest moment.";
    Some(
        Figure::new("residual-flexibility", "The march with residual flexibility", panels)
            .with_caption(caption),
    )
}

/// Single swings of marches about the loudest moment of one of them.
fn about_loudest(loudest: &StoredArrays<'_>, marches: &[(&StoredArrays<'_>, &str, Style)]) -> Option<Panel> {
    loudest.over(SIGNAL, &["time"])?;
    let (time, values) = (reals(loudest, "time")?, reals(loudest, SIGNAL)?);
    let settled = loudest.attributes().get("settled_s").and_then(Value::as_f64)?;
    let after = time.iter().zip(values).filter(|(time, _)| **time > settled);
    let middle = *after.max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()))?.0;
    let mut layers = Vec::new();
    let mut peak = 0.0_f64;
    for (march, label, style) in marches {
        march.over(SIGNAL, &["time"])?;
        let (time, values) = (reals(*march, "time")?, reals(*march, SIGNAL)?);
        let range =
            time.partition_point(|t| *t < middle - ABOUT)..time.partition_point(|t| *t <= middle + ABOUT);
        let values = values.get(range.clone())?;
        peak = values.iter().fold(peak, |peak, value| peak.max(value.abs()));
        let milliseconds = time.get(range)?.iter().map(|t| 1e3 * (t - middle)).collect();
        layers.push(Layer::line(*label, milliseconds, values.to_vec(), *style));
    }
    let up = axis(loudest.variable(SIGNAL)?).with_range(-OVER * peak, OVER * peak);
    let across = Axis::linear(format!("Time after {middle:.4} s (ms)")).with_range(-1e3 * ABOUT, 1e3 * ABOUT);
    Some(Panel::new(across, up, layers).with_title("the loudest moment").with_legend(Legend::Below))
}

/// How far the difference of two marches with the same samples swings.
fn difference(a: &StoredArrays<'_>, b: &StoredArrays<'_>, label: &str, style: Style) -> Option<Layer> {
    let (first, second) = (reals(a, SIGNAL)?, reals(b, SIGNAL)?);
    let difference: Vec<f64> = second.iter().zip(first).map(|(b, a)| b - a).collect();
    let (x, y) = judder_models::sliding::march::figure::swings(reals(a, "time")?, &difference);
    Some(Layer::line(label, x, y, style))
}

/// A history from the end of the ramps on.
fn settled(own: Panel, dataset: &StoredArrays<'_>, name: &str) -> Option<Panel> {
    let (time, values) = (reals(dataset, "time")?, reals(dataset, name)?);
    let settled = dataset.attributes().get("settled_s").and_then(Value::as_f64)?;
    let first = time.partition_point(|t| *t <= settled);
    let (low, high) = values
        .get(first..)?
        .iter()
        .filter(|value| value.is_finite())
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(*value), high.max(*value)));
    let room = 0.05 * (high - low);
    let across = own.x.clone().with_range(settled, *time.last()?);
    Some(Panel { x: across, y: own.y.clone().with_range(low - room, high + room), ..own })
}
