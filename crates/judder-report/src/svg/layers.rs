//! What a panel shows: maps, regions, curves, points, reference lines and notes.

use super::document::{SvgDocument, rectangle};
use super::path::polyline;
use super::text::{Anchor, Text};
use super::written::number;
use crate::figure::{Layer, Line, Rule, RuleDirection, ShadedRegion};
use crate::layout::{DrawnPanel, Frame};
use crate::palette::{GROUND, Marker, QUIET, Role, Style};
use crate::raster::{self, MapPicture};
use crate::typeface::{SMALL_SIZE, width};

/// Draws a map or a region, which lie under everything else.
pub(super) fn draw_ground(document: &mut SvgDocument, layer: &Layer, panel: &DrawnPanel) {
    let (x, y) = (&panel.x.placed, &panel.y.placed);
    match layer {
        Layer::Classes(map) => {
            let open = map.classes.iter().any(|class| class.role == Role::Unresolved);
            draw_picture(document, raster::classes(map, x, y), panel.frame, open);
            for class in map.classes.iter().filter(|class| class.role.pattern().is_some()) {
                draw_patterned(document, &raster::blocks(map, class.role, x, y), class.role, panel.frame);
            }
        }
        Layer::Values(map) => {
            let open = map.z.iter().any(|z| !z.is_finite());
            let picture = panel.bar.as_ref().and_then(|bar| raster::values(map, x, y, &bar.placed));
            draw_picture(document, picture, panel.frame, open);
        }
        Layer::Region(region) => draw_region(document, region, panel),
        _ => {}
    }
}

/// Draws a picture, over a hatch that shows through its clear cells.
fn draw_picture(document: &mut SvgDocument, picture: Option<MapPicture>, frame: Frame, open: bool) {
    let Some(picture) = picture else { return };
    let place = Frame {
        x: frame.x + picture.across.0 * frame.width,
        y: frame.y + (1.0 - picture.up.1) * frame.height,
        width: (picture.across.1 - picture.across.0) * frame.width,
        height: (picture.up.1 - picture.up.0) * frame.height,
    };
    if open {
        let fill = format!("fill=\"{}\"", document.area_fill(Role::Unresolved));
        document.put(format_args!("{}", rectangle(place, &fill)));
    }
    document.put(format_args!(
        "<image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" preserveAspectRatio=\"none\" \
         image-rendering=\"optimizeSpeed\" style=\"image-rendering:pixelated\" href=\"{}\"/>",
        number(place.x),
        number(place.y),
        number(place.width),
        number(place.height),
        picture.address,
    ));
}

/// Fills blocks of cells, as fractions of the frame, with the pattern of their meaning.
fn draw_patterned(document: &mut SvgDocument, blocks: &[raster::ClassColumn], role: Role, frame: Frame) {
    let data: String = blocks
        .iter()
        .map(|block| {
            let (x, y) =
                (frame.x + block.across.0 * frame.width, frame.y + (1.0 - block.up.1) * frame.height);
            let (width, height) =
                ((block.across.1 - block.across.0) * frame.width, (block.up.1 - block.up.0) * frame.height);
            format!("M{} {}h{}v{}h-{}z", number(x), number(y), number(width), number(height), number(width))
        })
        .collect();
    let fill = document.area_fill(role);
    document.put(format_args!("<path d=\"{data}\" fill=\"{fill}\" shape-rendering=\"crispEdges\"/>"));
}

fn draw_region(document: &mut SvgDocument, region: &ShadedRegion, panel: &DrawnPanel) {
    let frame = panel.frame;
    let span = |ends: Option<(f64, f64)>, axis: &crate::scale::PlacedAxis| match ends {
        None => Some((0.0, 1.0)),
        Some((from, to)) => {
            let (from, to) = (axis.fraction(from)?, axis.fraction(to)?);
            Some((from.min(to).clamp(0.0, 1.0), from.max(to).clamp(0.0, 1.0)))
        }
    };
    let (Some(across), Some(up)) = (span(region.x, &panel.x.placed), span(region.y, &panel.y.placed)) else {
        return;
    };
    let place = Frame {
        x: frame.x + across.0 * frame.width,
        y: frame.y + (1.0 - up.1) * frame.height,
        width: (across.1 - across.0) * frame.width,
        height: (up.1 - up.0) * frame.height,
    };
    let fill = format!("fill=\"{}\"", document.area_fill(region.role));
    document.put(format_args!("{}", rectangle(place, &fill)));
}

/// Draws a curve, points or a reference line; rims of points would cut the curves on which they lie.
pub(super) fn draw_curve(document: &mut SvgDocument, layer: &Layer, panel: &DrawnPanel, has_curves: bool) {
    match layer {
        Layer::Line(line) => draw_line(document, line, panel),
        Layer::Points(points) => {
            let own = points.sizes.iter().flatten().copied();
            let sizes = own.chain(std::iter::repeat(1.0));
            let places = places(points, panel).zip(sizes).filter_map(|(place, size)| Some((place?, size)));
            let places = places.filter(|((x, y), _)| near(*x, *y, panel.frame));
            let is_rimmed = !points.style.crowded && (points.sizes.is_some() || !has_curves);
            document.put(format_args!("{}", marker_path(&points.style, is_rimmed, places)));
        }
        Layer::Rule(rule) => {
            if let Some((x, y, end_x, end_y)) = rule_ends(rule, panel) {
                document.put(format_args!(
                    "<path d=\"M{} {}L{} {}\" stroke=\"{QUIET}\" stroke-width=\"0.7\" stroke-dasharray=\"1.4 1.8\"/>",
                    number(x),
                    number(y),
                    number(end_x),
                    number(end_y),
                ));
            }
        }
        _ => {}
    }
}

/// Draws the light rim that lifts a curve off a map, and leaves it there under a name for the curve itself.
pub(super) fn draw_rim(document: &mut SvgDocument, layer: &Layer, panel: &DrawnPanel, number: &str) {
    let Layer::Line(line) = layer else { return };
    let data = polyline(places(line, panel), panel.frame);
    if !data.is_empty() {
        let (id, width) = (document.id(number), super::written::number(line.style.width + 1.3));
        document.put(format_args!(
            "<g fill=\"none\" stroke=\"{GROUND}\" stroke-opacity=\"0.8\" stroke-width=\"{width}\" \
             stroke-linejoin=\"round\"><path id=\"{id}\" d=\"{data}\"/></g>"
        ));
    }
}

/// Draws a curve that lies on its rim.
pub(super) fn draw_over_rim(document: &mut SvgDocument, line: &Line, panel: &DrawnPanel, number: &str) {
    if !polyline(places(line, panel), panel.frame).is_empty() {
        let id = document.id(number);
        document.put(format_args!("<use href=\"#{id}\" {}/>", line_attributes(&line.style)));
    }
}

fn places<'a>(line: &'a Line, panel: &'a DrawnPanel) -> impl Iterator<Item = Option<(f64, f64)>> + 'a {
    line.x.iter().zip(&line.y).map(|(x, y)| panel.point(*x, *y))
}

/// Markers outside the frame are left out, whole.
fn near(x: f64, y: f64, frame: Frame) -> bool {
    const SLACK: f64 = 0.01;
    (frame.x - SLACK..=frame.x + frame.width + SLACK).contains(&x)
        && (frame.y - SLACK..=frame.y + frame.height + SLACK).contains(&y)
}

fn draw_line(document: &mut SvgDocument, line: &Line, panel: &DrawnPanel) {
    let data = polyline(places(line, panel), panel.frame);
    if data.is_empty() {
        return;
    }
    document.put(format_args!("<path d=\"{data}\" {}/>", line_attributes(&line.style)));
}

/// Stroke, width and dash of a line.
pub(super) fn line_attributes(style: &Style) -> String {
    let dash: Vec<String> = style.dash.pattern().iter().map(|part| number(part * style.width)).collect();
    let dash =
        if dash.is_empty() { String::new() } else { format!(" stroke-dasharray=\"{}\"", dash.join(" ")) };
    format!(
        "fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" stroke-linejoin=\"round\"{dash}",
        style.role.colour(),
        number(style.width),
    )
}

/// The size of markers that crowd, over that of others.
const CROWDED: f64 = 0.45;

/// One path with a marker of its size at every place, each with a light rim where they are rimmed.
pub(super) fn marker_path(
    style: &Style,
    is_rimmed: bool,
    places: impl Iterator<Item = ((f64, f64), f64)>,
) -> String {
    let size = if style.crowded { CROWDED } else { 1.0 };
    let data: String = places.map(|((x, y), own)| marker(style.marker, x, y, own * size)).collect();
    let colour = style.role.colour();
    match (style.marker, is_rimmed) {
        (Marker::Cross, _) => {
            let width = number(1.1 * size);
            format!("<path d=\"{data}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"{width}\"/>")
        }
        (_, false) => format!("<path d=\"{data}\" fill=\"{colour}\"/>"),
        (_, true) => {
            format!("<path d=\"{data}\" fill=\"{colour}\" stroke=\"{GROUND}\" stroke-width=\"0.5\"/>")
        }
    }
}

/// One marker about a place.
fn marker(shape: Marker, x: f64, y: f64, size: f64) -> String {
    let scaled = |length: f64| number(size * length);
    let start = |dx: f64, dy: f64| format!("M{} {}", number(x + size * dx), number(y + size * dy));
    match shape {
        Marker::Circle => {
            let (r, d) = (scaled(2.1), scaled(4.2));
            format!("{}a{r} {r} 0 1 0 {d} 0a{r} {r} 0 1 0-{d} 0z", start(-2.1, 0.0))
        }
        Marker::Square => {
            let side = scaled(3.8);
            format!("{}h{side}v{side}h-{side}z", start(-1.9, -1.9))
        }
        Marker::Diamond => {
            let half = scaled(2.5);
            format!("{}l{half} {half}l-{half} {half}l-{half}-{half}z", start(0.0, -2.5))
        }
        Marker::Triangle => {
            format!("{}l{} {}h-{}z", start(0.0, -2.7), scaled(2.5), scaled(4.3), scaled(5.0))
        }
        Marker::Cross => {
            let side = scaled(4.0);
            format!("{}l{side} {side}m0-{side}l-{side} {side}", start(-2.0, -2.0))
        }
    }
}

/// Both ends of a reference line, where it crosses the frame.
fn rule_ends(rule: &Rule, panel: &DrawnPanel) -> Option<(f64, f64, f64, f64)> {
    let frame = panel.frame;
    let (right, bottom) = (frame.x + frame.width, frame.y + frame.height);
    match rule.direction {
        RuleDirection::Vertical if panel.x.placed.contains(rule.value) => {
            let x = frame.x + panel.x.placed.fraction(rule.value)? * frame.width;
            Some((x, frame.y, x, bottom))
        }
        RuleDirection::Horizontal if panel.y.placed.contains(rule.value) => {
            let y = bottom - panel.y.placed.fraction(rule.value)? * frame.height;
            Some((frame.x, y, right, y))
        }
        _ => None,
    }
}

/// Draws the text of a note or a reference line, with a light rim, inside the frame.
pub(super) fn draw_text(document: &mut SvgDocument, layer: &Layer, panel: &DrawnPanel) {
    let frame = panel.frame;
    let (label, x, y) = match layer {
        Layer::Note(note) => {
            let Some((x, y)) = panel.point(note.x, note.y).filter(|(x, y)| near(*x, *y, frame)) else {
                return;
            };
            (&note.text, x, y + 0.36 * SMALL_SIZE)
        }
        Layer::Rule(rule) => {
            let Some((_, y, x, _)) = rule_ends(rule, panel) else { return };
            match rule.direction {
                RuleDirection::Vertical => (&rule.label, x + 4.0, frame.y + 13.0),
                RuleDirection::Horizontal => (&rule.label, x, y - 3.0),
            }
        }
        _ => return,
    };
    let furthest = frame.x + frame.width - 6.0 - width(label, SMALL_SIZE);
    // a label that would leave the frame on the right of its line goes to the left of it
    let beside = match layer {
        Layer::Rule(rule) if rule.direction == RuleDirection::Vertical && x > furthest => {
            x - 8.0 - width(label, SMALL_SIZE)
        }
        _ => x.min(furthest),
    };
    let text = Text::new(label, SMALL_SIZE).anchored(Anchor::Start).with_halo().coloured(QUIET);
    document.text(&text, beside, y);
}
