//! Figs. 11 and 12 with every way to read section 5, and the engines against each other, from what is stored.

use super::motion_exhibits::{ComputedPart, ENGINES, LOAD, OF_CAPTIONS, ReadingWay, WAYS};
use crate::claim::ClaimLine;
use crate::summary::is_done;
use judder_models::motion::pictures::ending;
use judder_report::{Axis, Figure, Layer, Legend, PageSection, Panel, Role};
use judder_store::{Dataset, StudyFolder, Summary};
use judder_study::StudyError;
use judder_study::pictures::{StoredArrays, axis, reals};
use judder_study::report::write_figure;

/// Oscillations that Fig. 12 shows.
const SHOWN: f64 = 2.5;
/// τ̃0 and rms up to which the beginning of the diagram is shown on even axes.
const BEGINNING: (f64, f64) = (6e-3, 0.06);
/// A motion that goes so many times as far as the frame is not drawn in it.
const FAR: f64 = 3.0;

/// What decides which speed and which load are the paper's.
pub(super) fn decision(motions: &[ClaimLine]) -> String {
    let count = |k: usize| motions.iter().filter(|line| line.holds.get(k) == Some(&true)).count();
    let counts: Vec<String> =
        WAYS.iter().enumerate().map(|(k, way)| format!("{} with {}", count(k), way.label)).collect();
    format!(
        "Section 5 gives its speed twice: the captions of Figs. 11 and 12 have $ṽ_{{d}}$ = 5 × 10^{{−3}}, which is $v̂_{{d}}$ = $ṽ_{{d}} τ̃/R̃$ = 4 × 10^{{−4}}; the \
         text has $v̂_{{d}}$ = 5 × 10^{{−3}}. Viscoelastic friction can be carried by the normal load, as printed, or by the contact force. Of {} statements hold {}. A \
         verdict is about the captions' speed.",
        motions.len(),
        counts.join(", ")
    )
}

/// The sections of Figs. 11 and 12 and of the engines.
pub(super) fn sections(store: &StudyFolder, summary: &Summary) -> Result<Vec<PageSection>, StudyError> {
    let mut sections = Vec::new();
    if let Some(figure) = figure_11(store, summary)? {
        sections.push(PageSection::new("Fig. 11", vec![write_figure(store, figure)?]));
    }
    let (captions, text) = WAYS.split_at(OF_CAPTIONS);
    let mut blocks = Vec::new();
    for (ways, name, title) in [
        (captions, "fig-12", "Motion over time, the paper's Fig. 12"),
        (text, "fig-12-text", "Motion over time with the text's speed"),
    ] {
        if let Some(figure) = figure_12(store, summary, ways, name, title)? {
            blocks.push(write_figure(store, figure)?);
        }
    }
    if !blocks.is_empty() {
        sections.push(PageSection::new("Fig. 12", blocks));
    }
    if is_done(summary, ENGINES) {
        let dataset = store.read_dataset(ENGINES)?;
        let title = "One cycle of section 5 by three engines";
        let drawn = judder_models::oscillator::MODEL.figure(ENGINES, title, &dataset);
        if let Some(figure) = drawn.map_err(|wrong| wrong.in_study(store.path(), ENGINES))? {
            sections.push(PageSection::new("Three engines", vec![write_figure(store, figure)?]));
        }
    }
    Ok(sections)
}

fn stored(
    store: &StudyFolder,
    summary: &Summary,
    part: ComputedPart,
    way: &ReadingWay,
) -> Result<Option<Dataset>, StudyError> {
    let name = part.name(way);
    if is_done(summary, &name) { Ok(Some(store.read_dataset(&name)?)) } else { Ok(None) }
}

/// One curve of Fig. 11 with its colour.
struct DiagramCurve {
    way: &'static ReadingWay,
    role: Role,
    dataset: Dataset,
}

impl DiagramCurve {
    /// A quantity along τ̃0, upwards (0) or downwards (1).
    fn along(&self, name: &str, direction: usize) -> Option<(Vec<f64>, Vec<f64>)> {
        let variable = self.dataset.variable(name)?;
        let swept = reals(&self.dataset, variable.dimensions.last()?)?;
        let part = direction * swept.len()..(direction + 1) * swept.len();
        Some((swept.to_vec(), reals(&self.dataset, name)?.get(part)?.to_vec()))
    }

    /// Upwards and downwards as points, the latter small: what lies between motions that have settled is not known.
    fn layers(&self, name: &str) -> Option<Vec<Layer>> {
        let (x, up) = self.along(name, 0)?;
        let (_, down) = self.along(name, 1)?;
        let upwards = Layer::points(self.way.label, x.clone(), up, self.role);
        Some(vec![upwards, Layer::points("", x, down, self.role.crowded())])
    }
}

fn figure_11(store: &StudyFolder, summary: &Summary) -> Result<Option<Figure>, StudyError> {
    let mut diagrams = Vec::new();
    for (k, way) in WAYS.iter().enumerate() {
        if let Some(dataset) = stored(store, summary, ComputedPart::Diagram, way)? {
            diagrams.push(DiagramCurve { way, role: Role::Series(k), dataset });
        }
    }
    let Some(first) = diagrams.first() else { return Ok(None) };
    let Some(strength) =
        first.dataset.variable("rms").and_then(|rms| first.dataset.variable(rms.dimensions.last()?))
    else {
        return Ok(None);
    };
    let layers =
        |name: &str| -> Vec<Layer> { diagrams.iter().filter_map(|d| d.layers(name)).flatten().collect() };
    let (most, highest) = BEGINNING;
    let beginning = Axis::linear(axis(strength).label).with_range(0.0, most);
    let panels = vec![
        Panel::new(axis(strength), Axis::log("rms of $x̃$ (−)"), layers("rms")),
        Panel::new(beginning, Axis::linear("rms of $x̃$ (−)").with_range(0.0, highest), layers("rms")),
        Panel::new(axis(strength), Axis::linear("Share of the time in stick (−)"), layers("stick_fraction")),
        Panel::new(axis(strength), Axis::linear("Share of the time off (−)"), layers("lift_off_fraction")),
    ];
    let panels = panels.into_iter().map(|panel| panel.with_legend(Legend::Below)).collect();
    let figure =
        Figure::new("fig-11", "Vibration amplitude over shear strength, the paper's Fig. 11", panels);
    Ok(Some(figure.with_caption(format!(
        "Motions at $F̃_{{n}}$ = {LOAD:e}, each from the end of the one before: $τ̃_{{0}}$ upwards (large) and downwards (small points); steady sliding, with no amplitude, is a \
         gap on the logarithmic axis. The captions' $ṽ_{{d}}$ = 5 × 10^{{−3}} is $v̂_{{d}}$ = 4 × 10^{{−4}}."
    ))))
}

fn figure_12(
    store: &StudyFolder,
    summary: &Summary,
    ways: &[ReadingWay],
    name: &str,
    title: &str,
) -> Result<Option<Figure>, StudyError> {
    let mut columns = Vec::new();
    for way in ways {
        let strong = stored(store, summary, ComputedPart::Strong, way)?;
        let weak = stored(store, summary, ComputedPart::Weak, way)?;
        if let Some(panels) = strong.zip(weak).and_then(|(strong, weak)| both(&strong, &weak, way)) {
            columns.push(panels);
        }
    }
    let rows = columns.first().map_or(0, Vec::len);
    let panels: Vec<Panel> =
        (0..rows).flat_map(|row| columns.iter().map(move |column| column[row].clone())).collect();
    if panels.is_empty() {
        return Ok(None);
    }
    let figure = Figure::new(name, title, panels).with_columns(columns.len()).with_caption(
        "Black: $τ̃_{0}$ = 5 × 10^{−2}, the last oscillations with the contact state shaded (white: slip). Blue, dashed: $τ̃_{0}$ = 10^{−4}. Last row: phase portraits of $τ̃_{0}$ = 5 × 10^{−2} with the changes of the contact state.",
    );
    Ok(Some(figure))
}

/// The panels of one way: the strong motion, and over its histories the weak one.
fn both(strong: &Dataset, weak: &Dataset, way: &ReadingWay) -> Option<Vec<Panel>> {
    let mut panels = ending(&StoredArrays::of(strong), SHOWN)?;
    for (panel, quantity) in panels.iter_mut().zip(["x", "relative_velocity", "contact_area"]) {
        let (from, to) = panel.x.range?;
        let time = reals(weak, "time")?;
        let part = time.partition_point(|t| *t < from)..time.partition_point(|t| *t <= to);
        let weak = reals(weak, quantity)?.get(part.clone())?.to_vec();
        if let Some(Layer::Line(line)) = panel.layers.last_mut() {
            line.label = "$τ̃_{0}$ = 5 × 10^{−2}".to_owned();
            panel.y.range = Some(around(&line.y));
        }
        let Some((least, most)) = panel.y.range else { continue };
        let largest = weak.iter().fold(0.0, |largest: f64, value| largest.max(value.abs()));
        panel.layers.push(if largest > FAR * (most - least) {
            let (x, y) = (from + 0.02 * (to - from), least + 0.08 * (most - least));
            Layer::note(x, y, "$τ̃_{0}$ = 10^{−4}: bounces, far beyond the frame")
        } else {
            Layer::line("$τ̃_{0}$ = 10^{−4}", time[part].to_vec(), weak, Role::Series(0).dashed())
        });
    }
    Some(panels.into_iter().map(|panel| panel.with_title(way.label).with_legend(Legend::Below)).collect())
}

/// The range of some values, and a little more.
fn around(values: &[f64]) -> (f64, f64) {
    let least = values.iter().copied().fold(f64::INFINITY, f64::min);
    let most = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let margin = 0.06 * (most - least);
    (least - margin, most + margin)
}
