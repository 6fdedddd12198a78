//! Where a legend fits inside a frame: the corner where it hides nothing, or the least.

use crate::figure::{Corner, Layer, Legend, Panel, RuleDirection};
use crate::legend::{INSET, LegendEntry, ROW, entry_width};
use crate::scale::PlacedAxis;

/// Between the box of a legend and the frame.
const CLEAR: f64 = 6.0;
/// Length of curve, in points, that a legend may hide before it has to leave the frame.
const HIDDEN: f64 = 3.0;

/// A box inside a frame, measured from the frame's upper left corner.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct LegendBox {
    pub(crate) x: f64,
    pub(crate) y: f64,
    pub(crate) width: f64,
    pub(crate) height: f64,
}

impl LegendBox {
    fn contains(&self, x: f64, y: f64) -> bool {
        (self.x..=self.x + self.width).contains(&x) && (self.y..=self.y + self.height).contains(&y)
    }
}

/// A frame of some size with its axes.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Room<'a> {
    pub(crate) x: &'a PlacedAxis,
    pub(crate) y: &'a PlacedAxis,
    pub(crate) width: f64,
    pub(crate) height: f64,
}

impl Room<'_> {
    fn point(&self, x: f64, y: f64) -> Option<(f64, f64)> {
        Some((self.x.fraction(x)? * self.width, (1.0 - self.y.fraction(y)?) * self.height))
    }
}

/// The box of a panel's legend; `None` where it has no entries, stands elsewhere, or would hide data.
pub(crate) fn legend_box(panel: &Panel, room: Room<'_>, entries: &[LegendEntry]) -> Option<LegendBox> {
    let widest = entries.iter().map(entry_width).reduce(f64::max)?;
    let (width, height) = (widest + 2.0 * INSET, entries.len() as f64 * ROW + 2.0 * INSET - 2.0);
    let (right, bottom) = (room.width - CLEAR - width, room.height - CLEAR - height);
    let at = |corner: Corner| {
        let (x, y) = match corner {
            Corner::TopLeft => (CLEAR, CLEAR),
            Corner::TopRight => (right, CLEAR),
            Corner::BottomLeft => (CLEAR, bottom),
            Corner::BottomRight => (right, bottom),
        };
        LegendBox { x, y, width, height }
    };
    match panel.legend {
        Legend::At(corner) => Some(at(corner)),
        Legend::Inside => [Corner::TopRight, Corner::TopLeft, Corner::BottomRight, Corner::BottomLeft]
            .map(|corner| (hidden(panel, room, &at(corner)), at(corner)))
            .into_iter()
            .min_by(|(one, _), (other, _)| one.total_cmp(other))
            .filter(|(length, place)| *length <= HIDDEN && place.x >= 0.0 && place.y >= 0.0)
            .map(|(_, place)| place),
        Legend::Below | Legend::Hidden => None,
    }
}

/// Length of the curves and rules that a box would hide; a point counts as much as may be hidden.
fn hidden(panel: &Panel, room: Room<'_>, place: &LegendBox) -> f64 {
    panel.layers.iter().map(|layer| hidden_of_layer(layer, room, place)).sum()
}

fn hidden_of_layer(layer: &Layer, room: Room<'_>, place: &LegendBox) -> f64 {
    match layer {
        Layer::Line(line) => {
            let mut last = None;
            let mut length = 0.0;
            for (x, y) in line.x.iter().zip(&line.y) {
                let here = room.point(*x, *y);
                if let (Some(from), Some(to)) = (last, here) {
                    length += hidden_of_segment(from, to, place);
                }
                last = here;
            }
            length
        }
        Layer::Points(points) => {
            let places = points.x.iter().zip(&points.y).filter_map(|(x, y)| room.point(*x, *y));
            places.filter(|(x, y)| place.contains(*x, *y)).count() as f64 * 2.0 * HIDDEN
        }
        Layer::Rule(rule) => {
            let (from, to) = match rule.direction {
                RuleDirection::Vertical => {
                    let x = room.x.fraction(rule.value).map(|fraction| fraction * room.width);
                    (x.map(|x| (x, 0.0)), x.map(|x| (x, room.height)))
                }
                RuleDirection::Horizontal => {
                    let y = room.y.fraction(rule.value).map(|fraction| (1.0 - fraction) * room.height);
                    (y.map(|y| (0.0, y)), y.map(|y| (room.width, y)))
                }
            };
            from.zip(to).map_or(0.0, |(from, to)| hidden_of_segment(from, to, place))
        }
        Layer::Note(note) => {
            let hit = room.point(note.x, note.y).is_some_and(|(x, y)| place.contains(x, y));
            if hit { 2.0 * HIDDEN } else { 0.0 }
        }
        Layer::Classes(_) | Layer::Values(_) | Layer::Region(_) => 0.0,
    }
}

/// Length of a segment inside a box, by samples two points apart.
fn hidden_of_segment(from: (f64, f64), to: (f64, f64), place: &LegendBox) -> f64 {
    let (dx, dy) = (to.0 - from.0, to.1 - from.1);
    let length = libm::hypot(dx, dy).min(1e4);
    let samples = (length / 2.0).ceil().max(1.0);
    let inside = (0..samples as usize).filter(|index| {
        let share = (*index as f64 + 0.5) / samples;
        place.contains(from.0 + share * dx, from.1 + share * dy)
    });
    inside.count() as f64 * length / samples
}
