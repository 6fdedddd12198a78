//! Curves as path data: cut at the surroundings of the frame, broken at gaps, without points that fall together.

use super::written::append;
use crate::layout::Frame;
use std::f64::consts::{PI, TAU};

/// How far beyond the frame a curve is kept, so that the ends of thick strokes stay hidden.
const BEYOND: f64 = 12.0;

/// How far from a curve its drawing may pass, in points: less than ink spreads.
const ASIDE: f64 = 0.02;

/// Path data of a polyline; `None` is a gap.
pub(super) fn polyline(points: impl Iterator<Item = Option<(f64, f64)>>, frame: Frame) -> String {
    let mut path = SvgPath { pen: Pen::default(), run: None };
    let mut last: Option<(f64, f64)> = None;
    for point in points {
        if let (Some(from), Some(to)) = (last, point)
            && let Some((from, to)) = cut(from, to, frame)
        {
            path.segment(from, to);
        }
        last = point;
    }
    path.end();
    path.pen.data
}

/// Path data of strokes that stand apart, such as ticks.
pub(super) fn strokes(ends: impl Iterator<Item = ((f64, f64), (f64, f64))>) -> String {
    let mut pen = Pen::default();
    for (from, to) in ends {
        pen.move_to(from);
        pen.line_to(to);
    }
    pen.data
}

/// A polyline that is being written, without the points that it passes anyway.
struct SvgPath {
    pen: Pen,
    run: Option<StraightRun>,
}

/// The straight stroke that comes next: from where the pen is to the last point, past all points between them.
struct StraightRun {
    anchor: (f64, f64),
    tip: (f64, f64),
    /// The furthest from the anchor.
    reach: f64,
    /// A direction, and how far a stroke may turn from it to both sides.
    sector: Option<(f64, f64, f64)>,
}

impl StraightRun {
    fn from(anchor: (f64, f64)) -> Self {
        Self { anchor, tip: anchor, reach: 0.0, sector: None }
    }

    /// Goes on to a point, if a straight stroke there passes all points before.
    fn takes(&mut self, point: (f64, f64)) -> bool {
        let (dx, dy) = (point.0 - self.anchor.0, point.1 - self.anchor.1);
        let length = libm::hypot(dx, dy);
        if length < self.reach - ASIDE {
            return false;
        }
        if length > ASIDE {
            let (direction, half) = (libm::atan2(dy, dx), libm::asin(ASIDE / length));
            let (middle, low, high) = self.sector.unwrap_or((direction, -half, half));
            let turn = (direction - middle + PI).rem_euclid(TAU) - PI;
            if !(low..=high).contains(&turn) {
                return false;
            }
            self.sector = Some((middle, low.max(turn - half), high.min(turn + half)));
        }
        (self.tip, self.reach) = (point, self.reach.max(length));
        true
    }
}

impl SvgPath {
    fn segment(&mut self, from: (f64, f64), to: (f64, f64)) {
        if self.run.as_ref().is_none_or(|run| run.tip != from) {
            self.end();
            self.pen.move_to(from);
            self.run = Some(StraightRun::from(from));
        }
        let Some(run) = &mut self.run else { return };
        if !run.takes(to) {
            self.pen.line_to(run.tip);
            *run = StraightRun::from(run.tip);
            run.takes(to);
        }
    }

    /// Draws what is left.
    fn end(&mut self) {
        if let Some(run) = self.run.take() {
            self.pen.line_to(run.tip);
        }
    }
}

/// Path data and the point at which it stands, in hundredths; steps are written from point to point, which is shorter.
#[derive(Default)]
struct Pen {
    data: String,
    at: Option<(i64, i64)>,
    /// Where the next stroke begins.
    from: (i64, i64),
}

fn hundredths(x: f64, y: f64) -> (i64, i64) {
    ((100.0 * x).round() as i64, (100.0 * y).round() as i64)
}

impl Pen {
    fn move_to(&mut self, place: (f64, f64)) {
        self.from = hundredths(place.0, place.1);
    }

    /// A stroke; none to where the pen is.
    fn line_to(&mut self, place: (f64, f64)) {
        let (to, from) = (hundredths(place.0, place.1), self.from);
        if to == from {
            return;
        }
        match self.at {
            None => self.command('M', from.0, from.1),
            Some(at) if at == from => {}
            Some(at) => self.command('m', from.0 - at.0, from.1 - at.1),
        }
        match (to.0 - from.0, to.1 - from.1) {
            (along, 0) => append(&mut self.data, format_args!("h{}", short(along))),
            (0, along) => append(&mut self.data, format_args!("v{}", short(along))),
            (along, down) => self.command('l', along, down),
        }
        (self.at, self.from) = (Some(to), to);
    }

    /// A letter with two numbers; a sign parts them as well as a blank does.
    fn command(&mut self, letter: char, x: i64, y: i64) {
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
        assert_eq!(polyline(points.into_iter(), FRAME), "M0 0l10 10m40 40v62");
    }

    #[test]
    fn steps_add_up_to_the_points_and_are_short() {
        let points = [(0.5, 0.25), (1.004, 0.2), (0.9, 12.0)].map(Some);
        assert_eq!(polyline(points.into_iter(), FRAME), "M.5 .25l.5-.05l-.1 11.8");
    }

    #[test]
    fn points_that_fall_together_are_drawn_once() {
        let points = [(0.0, 0.0), (0.001, 0.0), (0.002, 0.0), (5.0, 0.0)].map(Some);
        assert_eq!(polyline(points.into_iter(), FRAME), "M0 0h5");
    }

    #[test]
    fn points_on_the_way_are_left_out_and_turns_are_kept() {
        let straight = (0..100).map(|k| Some((f64::from(k), 0.5 * f64::from(k))));
        assert_eq!(polyline(straight, FRAME), "M0 0l99 49.5");
        let back = [(0.0, 0.0), (50.0, 0.0), (20.0, 0.0), (60.0, 0.0)].map(Some);
        assert_eq!(polyline(back.into_iter(), FRAME), "M0 0h50h-30h40");
    }

    /// Every point of a dense curve lies within a hundredth of a millimetre of what is drawn.
    #[test]
    fn drawings_keep_to_their_curves() {
        let curve: Vec<(f64, f64)> = (0..=4000)
            .map(|k| 0.025 * f64::from(k))
            .map(|x| (x, 50.0 + 40.0 * (0.3 * x).sin() * (0.002 * x * x).cos()))
            .collect();
        let data = polyline(curve.iter().copied().map(Some), FRAME);
        let drawn = corners(&data);
        assert!(drawn.len() < 500, "{}", drawn.len());
        for point in &curve {
            let nearest =
                drawn.windows(2).map(|ends| distance(*point, ends[0], ends[1])).fold(f64::MAX, f64::min);
            assert!(nearest < ASIDE + 0.01, "{point:?} is {nearest} away");
        }
    }

    /// The corners of path data that begins with its only `M`.
    fn corners(data: &str) -> Vec<(f64, f64)> {
        let mut at = (0.0, 0.0);
        let letters: Vec<usize> =
            data.char_indices().filter(|(_, c)| c.is_alphabetic()).map(|(k, _)| k).collect();
        let ends = letters.iter().skip(1).copied().chain([data.len()]);
        letters
            .iter()
            .zip(ends)
            .map(|(start, end)| {
                let spaced = data[start + 1..end].replace('-', " -");
                let numbers: Vec<f64> =
                    spaced.split_whitespace().map(|number| number.parse().unwrap()).collect();
                let (dx, dy) = match &data[*start..start + 1] {
                    "h" => (numbers[0], 0.0),
                    "v" => (0.0, numbers[0]),
                    _ => (numbers[0], numbers[1]),
                };
                at = (at.0 + dx, at.1 + dy);
                at
            })
            .collect()
    }

    fn distance(point: (f64, f64), from: (f64, f64), to: (f64, f64)) -> f64 {
        let (dx, dy) = (to.0 - from.0, to.1 - from.1);
        let share = ((point.0 - from.0) * dx + (point.1 - from.1) * dy) / (dx * dx + dy * dy);
        let share = share.clamp(0.0, 1.0);
        (point.0 - from.0 - share * dx).hypot(point.1 - from.1 - share * dy)
    }

    #[test]
    fn what_passes_the_frame_by_is_left_out() {
        assert_eq!(polyline([Some((500.0, 0.0)), Some((500.0, 90.0))].into_iter(), FRAME), "");
        assert_eq!(polyline([Some((f64::INFINITY, 0.0)), Some((5.0, 9.0))].into_iter(), FRAME), "");
    }
}
