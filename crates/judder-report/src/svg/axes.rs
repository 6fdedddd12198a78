//! Frames, ticks, labels and colour bars.

use super::document::{SvgDocument, rectangle};
use super::path::strokes;
use super::text::{Anchor, Text};
use super::written::number;
use crate::figure::ValueMap;
use crate::layout::{BAR_GAP, BAR_WIDTH, DrawnAxis, DrawnPanel, Frame, TICK_GAP};
use crate::palette::INK;
use crate::raster;
use crate::second_axis::DrawnSecond;
use crate::typeface::{LABEL_SIZE, SMALL_SIZE, width};

/// Length of long and short ticks, which point inwards.
const LONG: f64 = 4.2;
const SHORT: f64 = 2.3;
/// From the middle of small digits down to their baseline.
const HALF_DIGIT: f64 = 0.36 * SMALL_SIZE;

/// Draws the frame of a panel with ticks on all four sides, its labels and its heading.
pub(super) fn draw(document: &mut SvgDocument, panel: &DrawnPanel, index: usize) {
    let frame = panel.frame;
    let (left, right) = (frame.x, frame.x + frame.width);
    let (top, bottom) = (frame.y, frame.y + frame.height);
    let across = |value: f64| left + panel.x.placed.fraction(value).unwrap_or(0.0) * frame.width;
    let up = |value: f64| bottom - panel.y.placed.fraction(value).unwrap_or(0.0) * frame.height;
    let below = strokes(marks(&panel.x).map(|(value, length)| upright(across(value), bottom, -length)));
    let beside = strokes(marks(&panel.y).map(|(value, length)| level(left, up(value), length)));
    let mirrored = [
        panel.second.is_none().then(|| format!("matrix(1 0 0 -1 0 {})", number(top + bottom))),
        Some(format!("matrix(-1 0 0 1 {} 0)", number(left + right))),
    ];
    let thin = format!("fill=\"none\" stroke=\"{INK}\" stroke-width=\"0.5\"");
    for ((ticks, mirror), axis) in [below, beside].into_iter().zip(mirrored).zip(["x", "y"]) {
        let id = document.id(&format!("ticks-{index}-{axis}"));
        document.put(format_args!("<path id=\"{id}\" d=\"{ticks}\" {thin}/>"));
        if let Some(mirror) = mirror {
            document.put(format_args!("<use href=\"#{id}\" transform=\"{mirror}\"/>"));
        }
    }
    if let Some(second) = &panel.second {
        let above = strokes(second_marks(second).map(|(value, length)| upright(across(value), top, length)));
        document.put(format_args!("<path d=\"{above}\" {thin}/>"));
    }
    let stroke = format!("fill=\"none\" stroke=\"{INK}\" stroke-width=\"0.7\"");
    document.put(format_args!("{}", rectangle(frame, &stroke)));
    draw_labels(document, panel);
}

/// Both ends of a stroke.
type Stroke = ((f64, f64), (f64, f64));

fn upright(x: f64, y: f64, length: f64) -> Stroke {
    ((x, y), (x, y + length))
}

fn level(x: f64, y: f64, length: f64) -> Stroke {
    ((x, y), (x + length, y))
}

/// Values and lengths of the ticks of an axis.
fn marks(axis: &DrawnAxis) -> impl Iterator<Item = (f64, f64)> + '_ {
    let long = axis.ticks.major.iter().map(|tick| (tick.value, LONG));
    long.chain(axis.ticks.minor.iter().map(|value| (*value, SHORT)))
}

/// The same of a second axis, at the abscissae where they stand.
fn second_marks(second: &DrawnSecond) -> impl Iterator<Item = (f64, f64)> + '_ {
    let long = second.major.iter().map(|tick| (tick.value, LONG));
    long.chain(second.minor.iter().map(|x| (*x, SHORT)))
}

/// Labels of the second axis above the frame.
fn draw_second(document: &mut SvgDocument, panel: &DrawnPanel, second: &DrawnSecond) {
    let frame = panel.frame;
    let above = frame.y - TICK_GAP;
    for tick in &second.major {
        let x = frame.x + panel.x.placed.fraction(tick.value).unwrap_or(0.0) * frame.width;
        document.text(&Text::new(&tick.label, SMALL_SIZE), x, above);
    }
    let centre = frame.x + frame.width / 2.0;
    document.text(&Text::new(&second.label, LABEL_SIZE), centre, above - 1.2 * LABEL_SIZE);
}

fn draw_labels(document: &mut SvgDocument, panel: &DrawnPanel) {
    let frame = panel.frame;
    let bottom = frame.y + frame.height;
    let below = bottom + TICK_GAP + 0.8 * SMALL_SIZE;
    for tick in &panel.x.ticks.major {
        let x = frame.x + panel.x.placed.fraction(tick.value).unwrap_or(0.0) * frame.width;
        document.text(&Text::new(&tick.label, SMALL_SIZE), x, below);
    }
    for tick in &panel.y.ticks.major {
        let y = bottom - panel.y.placed.fraction(tick.value).unwrap_or(0.0) * frame.height;
        let text = Text::new(&tick.label, SMALL_SIZE).anchored(Anchor::End);
        document.text(&text, frame.x - TICK_GAP, y + HALF_DIGIT);
    }
    let centre = frame.x + frame.width / 2.0;
    document.text(&Text::new(&panel.x.label, LABEL_SIZE), centre, below + 1.45 * LABEL_SIZE);
    let beside = frame.x - TICK_GAP - panel.tick_width - 0.62 * LABEL_SIZE;
    document.text(&Text::new(&panel.y.label, LABEL_SIZE).upright(), beside, frame.y + frame.height / 2.0);
    if let Some(second) = &panel.second {
        draw_second(document, panel, second);
    }
    let heading = frame.y - panel.heading_rise() - 5.5;
    let letter = Text::new(&panel.letter, LABEL_SIZE).anchored(Anchor::Start).bold();
    document.text(&letter, frame.x, heading);
    let indent = if panel.letter.is_empty() { 0.0 } else { 1.2 * LABEL_SIZE };
    let title = Text::new(&panel.title, LABEL_SIZE).anchored(Anchor::Start);
    document.text(&title, frame.x + indent, heading);
}

/// Draws the colour bar of a value map beside its frame.
pub(super) fn draw_bar(document: &mut SvgDocument, map: &ValueMap, panel: &DrawnPanel) {
    let (Some(axis), Some(address)) = (&panel.bar, raster::bar(map)) else { return };
    let frame = panel.frame;
    let bar = Frame { x: frame.x + frame.width + BAR_GAP, width: BAR_WIDTH, ..frame };
    document.put(format_args!(
        "<image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" preserveAspectRatio=\"none\" href=\"{address}\"/>",
        number(bar.x),
        number(bar.y),
        number(bar.width),
        number(bar.height),
    ));
    let stroke = format!("fill=\"none\" stroke=\"{INK}\" stroke-width=\"0.5\"");
    document.put(format_args!("{}", rectangle(bar, &stroke)));
    let mut widest = 0.0_f64;
    for tick in &axis.ticks.major {
        let y = bar.y + (1.0 - axis.placed.fraction(tick.value).unwrap_or(0.0)) * bar.height;
        let (from, end) = (number(bar.x + bar.width - 2.5), number(bar.x + bar.width));
        document.put(format_args!(
            "<path d=\"M{from} {y}H{end}\" stroke=\"{INK}\" stroke-width=\"0.5\"/>",
            y = number(y)
        ));
        let text = Text::new(&tick.label, SMALL_SIZE).anchored(Anchor::Start);
        document.text(&text, bar.x + bar.width + TICK_GAP, y + HALF_DIGIT);
        widest = widest.max(width(&tick.label, SMALL_SIZE));
    }
    let beside = bar.x + bar.width + TICK_GAP + widest + 1.2 * LABEL_SIZE;
    document.text(&Text::new(&axis.label, LABEL_SIZE).upright(), beside, bar.y + bar.height / 2.0);
}
