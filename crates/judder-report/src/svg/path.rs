//! Curves as path data: cut at the surroundings of the frame, broken at gaps, without points that fall together.

use super::document::append;
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

/// Path data and the point at which it stands, in hundredths; steps are written from point to point, which is shorter.
struct Path {
    data: String,
    at: Option<(i64, i64)>,
}

impl Path {
    fn segment(&mut self, from: (f64, f64), to: (f64, f64)) {
        let hundredths = |(x, y): (f64, f64)| ((100.0 * x).round() as i64, (100.0 * y).round() as i64);
        let (from, to) = (hundredths(from), hundredths(to));
        if self.at != Some(from) {
            self.command('M', from);
        } else if from == to {
            return;
        }
        self.command('l', (to.0 - from.0, to.1 - from.1));
        self.at = Some(to);
    }

    /// A letter with two numbers; a sign parts them as well as a blank does.
    fn command(&mut self, letter: char, (x, y): (i64, i64)) {
        let blank = if y < 0 { "" } else { " " };
        append(&mut self.data, format_args!("{letter}{}{blank}{}", short(x), short(y)));
    }
}

/// Hundredths as a number without what it does not need: `12`, `.5`, `-.05`.
fn short(hundredths: i64) -> String {
    let (sign, size) = (if hundredths < 0 { "-" } else { "" }, hundredths.unsigned_abs());
    let (whole, rest) = (size / 100, size % 100);
    let whole = if whole == 0 && rest > 0 { String::new() } else { whole.to_string() };
    match (rest, rest % 10) {
        (0, _) => format!("{sign}{whole}"),
        (_, 0) => format!("{sign}{whole}.{}", rest / 10),
        _ => format!("{sign}{whole}.{rest:02}"),
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
        assert_eq!(polyline(points.into_iter(), FRAME), "M0 0l10 10M50 50l0 62");
    }

    #[test]
    fn steps_add_up_to_the_points_and_are_short() {
        let points = [(0.5, 0.25), (1.004, 0.2), (0.9, 12.0)].map(Some);
        assert_eq!(polyline(points.into_iter(), FRAME), "M.5 .25l.5-.05l-.1 11.8");
    }

    #[test]
    fn points_that_fall_together_are_drawn_once() {
        let points = [(0.0, 0.0), (0.001, 0.0), (0.002, 0.0), (5.0, 0.0)].map(Some);
        assert_eq!(polyline(points.into_iter(), FRAME), "M0 0l0 0l5 0");
    }

    #[test]
    fn what_passes_the_frame_by_is_left_out() {
        assert_eq!(polyline([Some((500.0, 0.0)), Some((500.0, 90.0))].into_iter(), FRAME), "");
        assert_eq!(polyline([Some((f64::INFINITY, 0.0)), Some((5.0, 9.0))].into_iter(), FRAME), "");
    }
}
