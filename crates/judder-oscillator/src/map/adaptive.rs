//! The map decided on a coarse grid, then along its boundaries.
//!
//! Between neighbouring points of the coarse grid that differ in class, bisection finds two neighbouring points of the map
//! that differ: a boundary passes between them. Each boundary is followed from there at the full resolution: on both sides of
//! such a pair the next pair is decided, until no boundary has an open end. All other points are filled with the class
//! of a decided point beside them. Then every pair of neighbouring points that differ is looked at: a filled one among them is
//! decided and followed in its turn. What can be missed is a region that lies wholly inside a coarse cell.

mod canvas;

use super::{OperatingPlane, StabilityMap, coarse_lines};
use crate::Contact;
use canvas::Canvas;
use std::convert::Infallible;

/// Decides the map on a coarse grid, then along its boundaries.
#[must_use]
pub fn adaptive(contact: &Contact, plane: &impl OperatingPlane) -> StabilityMap {
    AdaptiveMap::new(contact, plane).decide()
}

/// A map whose memory is laid out, so that all that is left to do is to decide it.
pub struct AdaptiveMap<'a, P> {
    canvas: Canvas<'a, P>,
}

/// A map whose coarse grid is decided: a first picture, from which the whole map follows.
pub struct CoarselyDecided<'a, P> {
    canvas: Canvas<'a, P>,
    across: Vec<usize>,
    up: Vec<usize>,
}

/// The classes on the coarse grid of a map.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CoarseMap {
    /// The columns of the map that the coarse grid has, ascending, the first and the last among them.
    pub columns: Vec<usize>,
    /// The rows of the map that the coarse grid has, ascending, the first and the last among them.
    pub rows: Vec<usize>,
    /// Codes of [`StabilityClass`](crate::mechanism::StabilityClass), row by row: index `row · columns.len() + column`.
    pub classes: Vec<u8>,
}

/// The map was given up before it was whole.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct GivenUp;

impl<'a, P: OperatingPlane> AdaptiveMap<'a, P> {
    /// Lays out the memory: about five bytes a grid point.
    #[must_use]
    pub fn new(contact: &'a Contact, plane: &'a P) -> Self {
        Self { canvas: Canvas::new(contact, plane) }
    }

    /// Decides the map.
    #[must_use]
    pub fn decide(self) -> StabilityMap {
        let Ok(map) = self.decide_coarse().refine(&|| Ok::<(), Infallible>(()));
        map
    }

    /// Decides the points of the coarse grid alone: some 41 × 41, for a map of any size.
    #[must_use]
    pub fn decide_coarse(self) -> CoarselyDecided<'a, P> {
        let Self { mut canvas } = self;
        let (across, up) = (coarse_lines(canvas.columns()), coarse_lines(canvas.rows()));
        canvas.decide_grid(&across, &up);
        CoarselyDecided { canvas, across, up }
    }
}

impl<P: OperatingPlane> CoarselyDecided<'_, P> {
    /// What the coarse grid shows.
    #[must_use]
    pub fn coarse_map(&self) -> CoarseMap {
        let Self { canvas, across, up } = self;
        let at = |row: usize| across.iter().map(move |column| canvas.class(*column, row));
        CoarseMap {
            columns: across.clone(),
            rows: up.clone(),
            classes: up.iter().flat_map(|row| at(*row)).collect(),
        }
    }

    /// Decides the rest, and asks before each batch of decisions whether to stop; `None` where it was stopped. The map is that of
    /// [`AdaptiveMap::decide`] to the bit.
    #[must_use]
    pub fn decide_rest(self, interrupted: &dyn Fn() -> bool) -> Option<StabilityMap> {
        self.refine(&|| if interrupted() { Err(GivenUp) } else { Ok(()) }).ok()
    }

    /// Follows the boundaries that the coarse grid shows, as long as it is let go on.
    fn refine<E>(self, go_on: &dyn Fn() -> Result<(), E>) -> Result<StabilityMap, E> {
        let Self { mut canvas, across, up } = self;
        if across.is_empty() || up.is_empty() {
            return Ok(canvas.into_map());
        }
        let pairs = neighbours_on(&canvas, &across, &up);
        let mut fresh = bisect(&mut canvas, pairs, go_on)?;
        loop {
            follow(&mut canvas, fresh, go_on)?;
            canvas.fill();
            fresh = canvas.decide_filled_points_that_differ();
            if fresh.is_empty() {
                return Ok(canvas.into_map());
            }
        }
    }
}

/// Two points of one row or one column, and the step that leads from point to point between them.
#[derive(Clone, Copy)]
struct PointPair {
    points: [usize; 2],
    step: usize,
}

/// All pairs of points that are neighbours on the grid of these lines.
fn neighbours_on<P: OperatingPlane>(
    canvas: &Canvas<'_, P>,
    across: &[usize],
    up: &[usize],
) -> Vec<PointPair> {
    let pair = |a: (usize, usize), b: (usize, usize), step: usize| PointPair {
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
fn bisect<P: OperatingPlane, E>(
    canvas: &mut Canvas<'_, P>,
    mut pairs: Vec<PointPair>,
    go_on: &dyn Fn() -> Result<(), E>,
) -> Result<Vec<usize>, E> {
    let mut ends = Vec::new();
    while !pairs.is_empty() {
        go_on()?;
        let mut halves = Vec::new();
        for PointPair { points: [a, b], step } in pairs {
            if !canvas.differ(a, b) {
                continue;
            }
            let middle = a + (b - a) / step / 2 * step;
            if middle == a {
                ends.push(a);
                continue;
            }
            canvas.ask(middle, 0.5 * (canvas.ln_indentation(a) + canvas.ln_indentation(b)));
            halves.extend([PointPair { points: [a, middle], step }, PointPair { points: [middle, b], step }]);
        }
        canvas.decide();
        pairs = halves;
    }
    Ok(ends)
}

/// Decides what lies beside pairs of neighbours that differ, as long as that shows further pairs. `fresh` are decided
/// points whose neighbours were not looked at yet.
fn follow<P: OperatingPlane, E>(
    canvas: &mut Canvas<'_, P>,
    mut fresh: Vec<usize>,
    go_on: &dyn Fn() -> Result<(), E>,
) -> Result<(), E> {
    let stride = canvas.stride();
    while !fresh.is_empty() {
        go_on()?;
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
    Ok(())
}
