//! Where everything stands: frames, axes, legends and colour bars of a figure, in points (1/72 inch).

use crate::axis::{Axis, Scale};
use crate::corner::{LegendBox, Room, legend_box};
use crate::extent::{abscissae, ordinates};
use crate::figure::{Figure, Layer, Legend, Panel, ValueMap};
use crate::legend::{self, LegendEntry};
use crate::palette::ColourMap;
use crate::scale::PlacedAxis;
use crate::second_axis::{self, DrawnSecond};
use crate::ticks::{Ticks, named, thin_labels, ticks};
use crate::typeface::{SMALL_SIZE, width};

/// Between the frame and its tick labels.
pub(crate) const TICK_GAP: f64 = 4.0;
/// Width of a colour bar, and its distance from the frame.
pub(crate) const BAR_WIDTH: f64 = 9.0;
pub(crate) const BAR_GAP: f64 = 7.0;
/// Height of a line of text.
const LINE: f64 = 11.5;
/// Around the whole figure.
const MARGIN: f64 = 5.0;
/// Between a panel's margins and those of the next.
const GUTTER: f64 = 10.0;

/// A rectangle; y runs down.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Frame {
    pub(crate) x: f64,
    pub(crate) y: f64,
    pub(crate) width: f64,
    pub(crate) height: f64,
}

/// An axis with its range and ticks settled.
#[derive(Debug, Clone)]
pub(crate) struct DrawnAxis {
    pub(crate) placed: PlacedAxis,
    pub(crate) ticks: Ticks,
    /// Markup, with the power of ten that the tick labels leave out.
    pub(crate) label: String,
}

/// A panel with its place.
#[derive(Debug, Clone)]
pub(crate) struct DrawnPanel {
    pub(crate) frame: Frame,
    pub(crate) x: DrawnAxis,
    pub(crate) y: DrawnAxis,
    /// Along the upper side.
    pub(crate) second: Option<DrawnSecond>,
    /// The colour bar of each value map, in the order of the layers (one panel has room for one).
    pub(crate) bar: Option<DrawnAxis>,
    /// Letter (empty where there is one panel) and title.
    pub(crate) letter: String,
    pub(crate) title: String,
    /// Widest tick label of the vertical axis.
    pub(crate) tick_width: f64,
    /// The legend inside the frame, measured from the frame's upper left corner.
    pub(crate) legend: Option<LegendBox>,
}

impl DrawnPanel {
    /// From the frame up to its heading.
    pub(crate) fn heading_rise(&self) -> f64 {
        let labelled = |second: &DrawnSecond| if second.label.is_empty() { 0.0 } else { LINE + 2.0 };
        self.second.as_ref().map_or(0.0, |second| TICK_GAP + LINE - 2.0 + labelled(second))
    }

    /// The place of a value pair, where it has one.
    pub(crate) fn point(&self, x: f64, y: f64) -> Option<(f64, f64)> {
        let (across, up) = (self.x.placed.fraction(x)?, self.y.placed.fraction(y)?);
        let frame = self.frame;
        Some((frame.x + across * frame.width, frame.y + (1.0 - up) * frame.height))
    }
}

/// A figure with everything placed.
#[derive(Debug, Clone)]
pub(crate) struct Layout {
    pub(crate) width: f64,
    pub(crate) height: f64,
    pub(crate) panels: Vec<DrawnPanel>,
    /// Entries of the common legend and where each begins.
    pub(crate) legend: Vec<(LegendEntry, f64, f64)>,
}

/// Room that a panel needs around its frame.
#[derive(Debug, Clone, Copy, Default)]
struct Around {
    left: f64,
    right: f64,
    top: f64,
    bottom: f64,
}

impl Around {
    fn widest(self, other: Self) -> Self {
        Self {
            left: self.left.max(other.left),
            right: self.right.max(other.right),
            top: self.top.max(other.top),
            bottom: self.bottom.max(other.bottom),
        }
    }
}

/// Lays out a figure that has been found in order.
pub(crate) fn layout(figure: &Figure) -> Layout {
    let columns = figure.columns.min(figure.panels.len()).max(1);
    let (frame_width, frame_height) = frame_size(columns);
    let mut panels: Vec<DrawnPanel> = figure
        .panels
        .iter()
        .enumerate()
        .map(|(index, panel)| draw_panel(panel, letter(figure, index), frame_width, frame_height))
        .collect();
    // the same room in a column, and in a row, keeps frames aligned
    let around: Vec<Around> = panels.iter().map(room_around).collect();
    let widest = |belongs: &dyn Fn(usize) -> bool| {
        let members = around.iter().enumerate().filter(|(index, _)| belongs(*index));
        members.fold(Around::default(), |widest, (_, around)| widest.widest(*around))
    };
    let rows = panels.len().div_ceil(columns);
    let across: Vec<Around> = (0..columns).map(|column| widest(&|index| index % columns == column)).collect();
    let down: Vec<Around> = (0..rows).map(|row| widest(&|index| index / columns == row)).collect();
    let (lefts, right) = starts(across.iter().map(|around| around.left + frame_width + around.right));
    let (tops, below) = starts(down.iter().map(|around| around.top + frame_height + around.bottom));
    for (row, (top, above)) in panels.chunks_mut(columns).zip(tops.iter().zip(&down)) {
        for (panel, (left, beside)) in row.iter_mut().zip(lefts.iter().zip(&across)) {
            (panel.frame.x, panel.frame.y) = (left + beside.left, top + above.top);
        }
    }
    let (width, bottom) = (right - GUTTER + MARGIN, below - GUTTER);
    let entries = place_legends(figure, &mut panels);
    let margin = MARGIN + across.first().map_or(0.0, |first| first.left);
    let (legend, end) = legend_rows(entries, margin, width - MARGIN, bottom + GUTTER);
    Layout { width, height: end.max(0.0) + MARGIN, panels, legend }
}

/// Where cells of these sizes begin, and where one more would.
fn starts(sizes: impl Iterator<Item = f64>) -> (Vec<f64>, f64) {
    let mut next = MARGIN;
    let begin = |size: f64| {
        let start = next;
        next += size + GUTTER;
        start
    };
    let starts = sizes.map(begin).collect();
    (starts, next)
}

/// Frames shrink as they share a page's width.
fn frame_size(columns: usize) -> (f64, f64) {
    match columns {
        1 => (330.0, 225.0),
        2 => (206.0, 152.0),
        3 => (146.0, 118.0),
        _ => (120.0, 100.0),
    }
}

/// The letter of a panel, or nothing where there is only one.
pub(crate) fn letter(figure: &Figure, index: usize) -> String {
    match figure.panels.len() {
        0 | 1 => String::new(),
        _ => char::from(b'a' + (index % 26) as u8).to_string(),
    }
}

/// Settles the axes of a panel; its frame still stands at the origin.
fn draw_panel(panel: &Panel, letter: String, width_of_frame: f64, height: f64) -> DrawnPanel {
    let has_map = panel.layers.iter().any(|l| matches!(l, Layer::Classes(_) | Layer::Values(_)));
    let has_points = panel.layers.iter().any(|layer| matches!(layer, Layer::Points(_)));
    let (pad_x, pad_y) = match (has_map, has_points) {
        (true, _) => (0.0, 0.0),
        (false, true) => (0.03, 0.05),
        (false, false) => (0.0, 0.05),
    };
    let placed_x = PlacedAxis::new(&panel.x, panel.layers.iter().flat_map(abscissae), pad_x);
    let placed_y = PlacedAxis::new(&panel.y, panel.layers.iter().flat_map(ordinates), pad_y);
    let mut ticks_x = axis_ticks(&panel.x, &placed_x, (width_of_frame / 30.0) as usize);
    let widest = widest_label(&ticks_x);
    thin_labels(&placed_x, &mut ticks_x, (widest + 5.0) / width_of_frame);
    let mut ticks_y = axis_ticks(&panel.y, &placed_y, (height / 22.0) as usize);
    thin_labels(&placed_y, &mut ticks_y, LINE / height);
    let tick_width = widest_label(&ticks_y);
    let (room, share) = ((width_of_frame / 30.0) as usize, (widest + 5.0) / width_of_frame);
    let second = panel.second.as_ref().map(|second| second_axis::drawn(second, &placed_x, room, share));
    DrawnPanel {
        frame: Frame { x: 0.0, y: 0.0, width: width_of_frame, height },
        x: drawn_axis(&panel.x, placed_x, ticks_x),
        y: drawn_axis(&panel.y, placed_y, ticks_y),
        second,
        bar: panel.layers.iter().find_map(value_map).map(|map| bar_axis(map, height)),
        letter,
        title: panel.title.clone(),
        tick_width,
        legend: None,
    }
}

fn axis_ticks(axis: &Axis, placed: &PlacedAxis, room: usize) -> Ticks {
    if axis.names.is_empty() { ticks(placed, room) } else { named(placed, &axis.names) }
}

fn value_map(layer: &Layer) -> Option<&ValueMap> {
    match layer {
        Layer::Values(map) => Some(map),
        _ => None,
    }
}

/// The axis of a colour bar; symmetric about zero for diverging colours.
fn bar_axis(map: &ValueMap, height: f64) -> DrawnAxis {
    let placed = bar_range(map);
    let mut marks = ticks(&placed, (height / 22.0) as usize);
    thin_labels(&placed, &mut marks, LINE / height);
    drawn_axis(&map.bar, placed, marks)
}

/// The range of values that the colours of a map span.
pub(crate) fn bar_range(map: &ValueMap) -> PlacedAxis {
    let mirrored = map.colours == ColourMap::Diverging && map.bar.scale != Scale::Log;
    let values = map.z.iter().flat_map(|z| [*z, if mirrored { -z } else { *z }]);
    PlacedAxis::new(&map.bar, values, 0.0)
}

fn drawn_axis(axis: &Axis, placed: PlacedAxis, ticks: Ticks) -> DrawnAxis {
    let label = match ticks.exponent {
        Some(power) => format!("{} (×10^{{{}}})", axis.label, power.to_string().replace('-', "−")),
        None => axis.label.clone(),
    };
    DrawnAxis { placed, ticks, label }
}

fn widest_label(ticks: &Ticks) -> f64 {
    ticks.major.iter().map(|tick| width(&tick.label, SMALL_SIZE)).fold(0.0, f64::max)
}

fn room_around(panel: &DrawnPanel) -> Around {
    let label_room = |axis: &DrawnAxis| if axis.label.is_empty() { 0.0 } else { LINE + 2.0 };
    let bar = panel
        .bar
        .as_ref()
        .map_or(0.0, |bar| BAR_GAP + BAR_WIDTH + TICK_GAP + widest_label(&bar.ticks) + label_room(bar));
    Around {
        left: TICK_GAP + panel.tick_width + label_room(&panel.y),
        // half a tick label may stand out to the right
        right: bar.max(widest_label(&panel.x.ticks) / 2.0),
        top: panel.heading_rise()
            + if panel.letter.is_empty() && panel.title.is_empty() { 4.0 } else { LINE + 5.0 },
        bottom: TICK_GAP + LINE + label_room(&panel.x),
    }
}

/// Gives panels their legends inside; the entries of those that stand below are returned, each once.
///
/// One legend without room inside sends all of them below, so that nothing is explained twice.
fn place_legends(figure: &Figure, panels: &mut [DrawnPanel]) -> Vec<LegendEntry> {
    let entries: Vec<Vec<LegendEntry>> = figure.panels.iter().map(legend::entries).collect();
    let mut crowded = false;
    for ((panel, drawn), entries) in figure.panels.iter().zip(panels.iter_mut()).zip(&entries) {
        let Frame { width, height, .. } = drawn.frame;
        let room = Room { x: &drawn.x.placed, y: &drawn.y.placed, width, height };
        drawn.legend = legend_box(panel, room, entries);
        crowded |= panel.legend == Legend::Inside && drawn.legend.is_none() && !entries.is_empty();
    }
    let mut below = Vec::new();
    for ((panel, drawn), entries) in figure.panels.iter().zip(panels).zip(entries) {
        let leaves = crowded && panel.legend == Legend::Inside;
        if leaves {
            drawn.legend = None;
        }
        if leaves || panel.legend == Legend::Below {
            below.extend(entries);
        }
    }
    legend::merge(below.into_iter())
}

/// Sets entries in rows from `left` to `right`, the first row under `top`; also the lower end of the last row.
fn legend_rows(
    entries: Vec<LegendEntry>,
    left: f64,
    right: f64,
    top: f64,
) -> (Vec<(LegendEntry, f64, f64)>, f64) {
    const BETWEEN: f64 = 14.0;
    let (mut x, mut y, mut end) = (left, top, top - GUTTER);
    let mut placed = Vec::with_capacity(entries.len());
    for entry in entries {
        let entry_width = legend::entry_width(&entry);
        if x > left && x + entry_width > right {
            (x, y) = (left, y + legend::ROW);
        }
        end = y + legend::ROW;
        placed.push((entry, x, y));
        x = x + entry_width + BETWEEN;
    }
    (placed, end)
}
