//! Curves as path data: cut at the surroundings of the frame, broken at gaps, without points that fall together.

use super::document::{append, number};
use crate::layout::Frame;

/// How far beyond the frame a curve is kept, so that the ends of thick strokes stay hidden.
const BEYOND: f64 = 12.0;

/// Path data of a polyline; `None` is a gap.
pub(super) fn polyline(points: impl Iterator<Item = Option<(f64, f64)>>, frame: Frame) -> String {
    let mut path = Path { data: String::new(), at: None };
    let mut last: Option<(f64, f64)> = None;
    for point in points {
        if let (Some(from), Some(to)) = (last, point)
            && let Some((from, to)) = cut(from, to, frame)
        {
            path.segment(from, to);
        }
        last = point;
    }
    path.data
}

/// Path data and the point at which it stands, as written.
struct Path {
    data: String,
    at: Option<(String, String)>,
}

impl Path {
    fn segment(&mut self, from: (f64, f64), to: (f64, f64)) {
        let from = (number(from.0), number(from.1));
        let to = (number(to.0), number(to.1));
        if self.at.as_ref() != Some(&from) {
            append(&mut self.data, format_args!("M{} {}", from.0, from.1));
        } else if from == to {
            return;
        }
        append(&mut self.data, format_args!("L{} {}", to.0, to.1));
        self.at = Some(to);
    }
}

/// The part of a segment near the frame (Liang and Barsky).
fn cut(from: (f64, f64), to: (f64, f64), frame: Frame) -> Option<((f64, f64), (f64, f64))> {
    let (dx, dy) = (to.0 - from.0, to.1 - from.1);
    let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
    let sides = [
        (-dx, from.0 - (frame.x - BEYOND)),
        (dx, frame.x + frame.width + BEYOND - from.0),
        (-dy, from.1 - (frame.y - BEYOND)),
        (dy, frame.y + frame.height + BEYOND - from.1),
    ];
    for (towards, room) in sides {
        if towards == 0.0 {
            if room < 0.0 {
                return None;
            }
        } else if towards < 0.0 {
            enter = enter.max(room / towards);
        } else {
            leave = leave.min(room / towards);
        }
    }
    let at = |share: f64| (from.0 + share * dx, from.1 + share * dy);
    // ends that need no cutting stay as they are, bit for bit, so that segments join
    let start = if enter == 0.0 { from } else { at(enter) };
    let end = if leave == 1.0 { to } else { at(leave) };
    (enter <= leave && [start.0, start.1, end.0, end.1].iter().all(|c| c.is_finite())).then_some((start, end))
}

#[cfg(test)]
mod tests {
    use super::*;

    const FRAME: Frame = Frame { x: 0.0, y: 0.0, width: 100.0, height: 100.0 };

    #[test]
    fn gaps_break_and_far_ends_are_cut() {
        let points = [Some((0.0, 0.0)), Some((10.0, 10.0)), None, Some((50.0, 50.0)), Some((50.0, 1e9))];
        assert_eq!(polyline(points.into_iter(), FRAME), "M0 0L10 10M50 50L50 112");
    }

    #[test]
    fn points_that_fall_together_are_drawn_once() {
        let points = [(0.0, 0.0), (0.001, 0.0), (0.002, 0.0), (5.0, 0.0)].map(Some);
        assert_eq!(polyline(points.into_iter(), FRAME), "M0 0L0 0L5 0");
    }

    #[test]
    fn what_passes_the_frame_by_is_left_out() {
        assert_eq!(polyline([Some((500.0, 0.0)), Some((500.0, 90.0))].into_iter(), FRAME), "");
        assert_eq!(polyline([Some((f64::INFINITY, 0.0)), Some((5.0, 9.0))].into_iter(), FRAME), "");
    }
}
