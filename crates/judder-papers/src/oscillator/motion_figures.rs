//! Figs. 11 and 12 with every way to read section 5, and the engines against each other, from what is stored.

#![deny(clippy::indexing_slicing, reason = "stored arrays may be of any length")]

use super::motion_exhibits::{ComputedPart, ENGINES, LOAD, OF_CAPTIONS, ReadingWay, WAYS};
use crate::claim::ClaimLine;
use crate::drawn::{StoredAnalysis, block};
use judder_models::motion::pictures::ending;
use judder_models::oscillator::MODEL as OSCILLATOR;
use judder_report::{Axis, Figure, Layer, Legend, PageBlock, PageSection, Panel, Role};
use judder_store::{StudyFolder, Summary};
use judder_study::StudyError;
use judder_study::pictures::{StoredArrays, axis, reals};

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
    let mut sections = vec![PageSection::new("Fig. 11", figure_11(store, summary)?)];
    let (captions, text) = WAYS.split_at(OF_CAPTIONS);
    let mut blocks = Vec::new();
    for (ways, name, title) in [
        (captions, "fig-12", "Motion over time, the paper's Fig. 12"),
        (text, "fig-12-text", "Motion over time with the text's speed"),
    ] {
        blocks.extend(figure_12(store, summary, ways, name, title)?);
    }
    sections.push(PageSection::new("Fig. 12", blocks));
    if let Some(engines) = StoredAnalysis::read(store, summary, ENGINES) {
        let blocks = block(store, ENGINES, &[&engines], |arrays| {
            let arrays = arrays.first()?;
            let panels = Some(OSCILLATOR.panels_of(arrays)).filter(|panels| !panels.is_empty())?;
            let figure = Figure::new(ENGINES, "One cycle of section 5 by three engines", panels);
            Some(figure.with_caption(OSCILLATOR.caption(arrays.dataset())))
        })?;
        sections.push(PageSection::new("Three engines", blocks));
    }
    sections.retain(|section| !section.blocks.is_empty());
    Ok(sections)
}

fn stored(
    store: &StudyFolder,
    summary: &Summary,
    part: ComputedPart,
    way: &ReadingWay,
) -> Option<StoredAnalysis> {
    StoredAnalysis::read(store, summary, &part.name(way))
}

/// One curve of Fig. 11 with its colour.
struct DiagramCurve<'a> {
    way: &'static ReadingWay,
    role: Role,
    arrays: &'a StoredArrays<'a>,
}

impl DiagramCurve<'_> {
    /// A quantity along τ̃0, upwards (0) or downwards (1).
    fn along(&self, name: &str, direction: usize) -> Option<(Vec<f64>, Vec<f64>)> {
        self.arrays.shaped(name, &[Some(2), None])?;
        let swept = reals(self.arrays, self.arrays.variable(name)?.dimensions.last()?)?;
        let part = direction * swept.len()..(direction + 1) * swept.len();
        Some((swept.to_vec(), reals(self.arrays, name)?.get(part)?.to_vec()))
    }

    /// Upwards and downwards as points, the latter small: what lies between motions that have settled is not known.
    fn layers(&self, name: &str) -> Option<Vec<Layer>> {
        let (x, up) = self.along(name, 0)?;
        let (_, down) = self.along(name, 1)?;
        let upwards = Layer::points(self.way.label, x.clone(), up, self.role);
        Some(vec![upwards, Layer::points("", x, down, self.role.crowded())])
    }
}

fn figure_11(store: &StudyFolder, summary: &Summary) -> Result<Vec<PageBlock>, StudyError> {
    let done = |(k, way): (usize, &'static ReadingWay)| {
        Some((Role::Series(k), way, stored(store, summary, ComputedPart::Diagram, way)?))
    };
    let diagrams: Vec<_> = WAYS.iter().enumerate().filter_map(done).collect();
    if diagrams.is_empty() {
        return Ok(Vec::new());
    }
    let analyses: Vec<&StoredAnalysis> = diagrams.iter().map(|(_, _, analysis)| analysis).collect();
    block(store, "fig-11", &analyses, |all| {
        let own = diagrams.iter().zip(all);
        let curves = own.map(|((role, way, _), arrays)| DiagramCurve { way, role: *role, arrays });
        draw_figure_11(&curves.collect::<Vec<_>>())
    })
}

fn draw_figure_11(diagrams: &[DiagramCurve<'_>]) -> Option<Figure> {
    let first = diagrams.first()?.arrays;
    let strength = first.variable(first.variable("rms")?.dimensions.last()?)?;
    let layers = |name: &str| -> Option<Vec<Layer>> {
        Some(diagrams.iter().map(|own| own.layers(name)).collect::<Option<Vec<_>>>()?.concat())
    };
    let (most, highest) = BEGINNING;
    let beginning = Axis::linear(axis(strength).label).with_range(0.0, most);
    let panels = vec![
        Panel::new(axis(strength), Axis::log("rms of $x̃$ (−)"), layers("rms")?),
        Panel::new(beginning, Axis::linear("rms of $x̃$ (−)").with_range(0.0, highest), layers("rms")?),
        Panel::new(axis(strength), Axis::linear("Share of the time in stick (−)"), layers("stick_fraction")?),
        Panel::new(axis(strength), Axis::linear("Share of the time off (−)"), layers("lift_off_fraction")?),
    ];
    let panels = panels.into_iter().map(|panel| panel.with_legend(Legend::Below)).collect();
    let figure =
        Figure::new("fig-11", "Vibration amplitude over shear strength, the paper's Fig. 11", panels);
    Some(figure.with_caption(format!(
        "Motions at $F̃_{{n}}$ = {LOAD:e}, each from the end of the one before: $τ̃_{{0}}$ upwards (large) and downwards (small points); steady sliding, with no amplitude, is a \
         gap on the logarithmic axis. The captions' $ṽ_{{d}}$ = 5 × 10^{{−3}} is $v̂_{{d}}$ = 4 × 10^{{−4}}."
    )))
}

fn figure_12(
    store: &StudyFolder,
    summary: &Summary,
    ways: &'static [ReadingWay],
    name: &str,
    title: &str,
) -> Result<Vec<PageBlock>, StudyError> {
    let part = |part, way| stored(store, summary, part, way);
    let done = |way: &'static ReadingWay| {
        Some((way, [part(ComputedPart::Strong, way)?, part(ComputedPart::Weak, way)?]))
    };
    let motions: Vec<_> = ways.iter().filter_map(done).collect();
    if motions.is_empty() {
        return Ok(Vec::new());
    }
    let analyses: Vec<&StoredAnalysis> = motions.iter().flat_map(|(_, both)| both).collect();
    block(store, name, &analyses, |arrays| {
        let of_way = |((way, _), pair): (&(&ReadingWay, _), &[StoredArrays<'_>])| {
            let [strong, weak] = pair else { return None };
            both(strong, weak, way)
        };
        let pairs = motions.iter().zip(arrays.chunks(2));
        let columns: Vec<Vec<Panel>> = pairs.map(of_way).collect::<Option<_>>()?;
        let rows = columns.first()?.len();
        let row = |row: usize| columns.iter().filter_map(move |column| column.get(row).cloned());
        let panels: Vec<Panel> = (0..rows).flat_map(row).collect();
        Some(Figure::new(name, title, panels).with_columns(columns.len()).with_caption(
            "Black: $τ̃_{0}$ = 5 × 10^{−2}, the last oscillations with the contact state shaded (white: slip). Blue, dashed: $τ̃_{0}$ = 10^{−4}. Last row: phase portraits of $τ̃_{0}$ = 5 × 10^{−2} with the changes of the contact state.",
        ))
    })
}

/// The panels of one way: the strong motion, and over its histories the weak one.
fn both(strong: &StoredArrays<'_>, weak: &StoredArrays<'_>, way: &ReadingWay) -> Option<Vec<Panel>> {
    let mut panels = ending(strong, SHOWN)?;
    for (panel, quantity) in panels.iter_mut().zip(["x", "relative_velocity", "contact_area"]) {
        let (from, to) = panel.x.range?;
        weak.over(quantity, &["time"])?;
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
            Layer::line("$τ̃_{0}$ = 10^{−4}", time.get(part)?.to_vec(), weak, Role::Series(0).dashed())
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
