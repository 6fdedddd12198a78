//! The map decided on a coarse grid, then along its boundaries.
//!
//! Between neighbouring points of the coarse grid that differ in class, bisection finds two neighbouring points of the map
//! that differ: a boundary passes between them. Each boundary is followed from there at the full resolution: on both sides of
//! such a pair the next pair is decided, until no boundary has an open end. All other points are filled with the class
//! of a decided point beside them. Then every pair of neighbouring points that differ is looked at: a filled one among them is
//! decided and followed in its turn. What can be missed is a region that lies wholly inside a coarse cell.

mod canvas;

use super::{Plane, StabilityMap, every_point};
use crate::Contact;
use canvas::Canvas;

/// Intervals of the coarse grid along each side: what is narrower than the map's side over this can escape.
const COARSE_INTERVALS: usize = 40;

/// Decides the map on a coarse grid, then along its boundaries.
#[must_use]
pub fn adaptive(contact: &Contact, plane: &impl Plane) -> StabilityMap {
    AdaptiveMap::new(contact, plane).decide()
}

/// A map whose memory is laid out, so that all that is left to do is to decide it.
pub struct AdaptiveMap<'a, P> {
    contact: &'a Contact,
    plane: &'a P,
    canvas: Canvas<'a, P>,
}

impl<'a, P: Plane> AdaptiveMap<'a, P> {
    /// Lays out the memory: about five bytes a grid point.
    #[must_use]
    pub fn new(contact: &'a Contact, plane: &'a P) -> Self {
        Self { contact, plane, canvas: Canvas::new(contact, plane) }
    }

    /// Decides the map.
    #[must_use]
    pub fn decide(self) -> StabilityMap {
        let Self { contact, plane, mut canvas } = self;
        if plane.columns() == 0 || plane.rows() == 0 {
            return every_point(contact, plane);
        }
        let (across, up) = (coarse_lines(plane.columns()), coarse_lines(plane.rows()));
        canvas.decide_grid(&across, &up);
        let pairs = neighbours_on(&canvas, &across, &up);
        let mut fresh = bisect(&mut canvas, pairs);
        loop {
            follow(&mut canvas, fresh);
            canvas.fill();
            fresh = canvas.decide_filled_points_that_differ();
            if fresh.is_empty() {
                return canvas.into_map();
            }
        }
    }
}

/// The lines of the coarse grid, the first and the last of the map among them.
fn coarse_lines(count: usize) -> Vec<usize> {
    let mut lines: Vec<usize> = (0..count).step_by((count / COARSE_INTERVALS).max(1)).collect();
    if lines.last().is_some_and(|last| last + 1 < count) {
        lines.push(count - 1);
    }
    lines
}

/// Two points of one row or one column, and the step that leads from point to point between them.
#[derive(Clone, Copy)]
struct Pair {
    points: [usize; 2],
    step: usize,
}

/// All pairs of points that are neighbours on the grid of these lines.
fn neighbours_on<P: Plane>(canvas: &Canvas<'_, P>, across: &[usize], up: &[usize]) -> Vec<Pair> {
    let pair = |a: (usize, usize), b: (usize, usize), step: usize| Pair {
        points: [canvas.index(a.0, a.1), canvas.index(b.0, b.1)],
        step,
    };
    let mut pairs = Vec::with_capacity(2 * across.len() * up.len());
    for &row in up {
        pairs.extend(across.windows(2).map(|w| pair((w[0], row), (w[1], row), 1)));
    }
    for &column in across {
        pairs.extend(up.windows(2).map(|w| pair((column, w[0]), (column, w[1]), canvas.stride())));
    }
    pairs
}

/// Halves the pairs that differ until they are neighbours on the map; returns one point of each.
fn bisect<P: Plane>(canvas: &mut Canvas<'_, P>, mut pairs: Vec<Pair>) -> Vec<usize> {
    let mut ends = Vec::new();
    while !pairs.is_empty() {
        let mut halves = Vec::new();
        for Pair { points: [a, b], step } in pairs {
            if !canvas.differ(a, b) {
                continue;
            }
            let middle = a + (b - a) / step / 2 * step;
            if middle == a {
                ends.push(a);
                continue;
            }
            canvas.ask(middle, 0.5 * (canvas.ln_indentation(a) + canvas.ln_indentation(b)));
            halves.extend([Pair { points: [a, middle], step }, Pair { points: [middle, b], step }]);
        }
        canvas.decide();
        pairs = halves;
    }
    ends
}

/// Decides what lies beside pairs of neighbours that differ, as long as that shows further pairs. `fresh` are decided
/// points whose neighbours were not looked at yet.
fn follow<P: Plane>(canvas: &mut Canvas<'_, P>, mut fresh: Vec<usize>) {
    let stride = canvas.stride();
    while !fresh.is_empty() {
        for point in fresh {
            for (neighbour, aside) in
                [(point - 1, stride), (point + 1, stride), (point - stride, 1), (point + stride, 1)]
            {
                if !canvas.differ(point, neighbour) {
                    continue;
                }
                if canvas.is_decided(neighbour) {
                    for end in [point, neighbour] {
                        canvas.ask_beyond(end - aside, end);
                        canvas.ask_beyond(end + aside, end);
                    }
                } else {
                    canvas.ask(neighbour, canvas.ln_indentation(point));
                }
            }
        }
        fresh = canvas.decide();
    }
}
