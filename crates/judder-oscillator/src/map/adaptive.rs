//! The map decided on a coarse grid, then only where neighbours differ.
//!
//! Cells whose corners differ in class are split, level by level; the others are filled with the class of their corners.
//! Then every pair of neighbouring grid points that differ is looked at: a filled one among them is decided, and so on along
//! the boundary until all pairs that differ were decided. So each boundary that any decided pair shows is followed
//! to its end at the full resolution; what can be missed is a region that lies wholly inside a coarse cell.

use super::every_point::sweep_rows;
use super::{Plane, StabilityMap};
use crate::Contact;
use crate::block::{Block, LANES};
use crate::mechanism::StabilityClass;
use rayon::prelude::*;

/// Intervals of the coarse grid along each side: what is narrower than the map's side over this can escape.
const COARSE_INTERVALS: usize = 40;
/// A grid point that nothing is known of.
const UNKNOWN: u8 = 0xFF;
/// A grid point that waits for its decision.
const WAITING: u8 = 0xFE;
/// Marks the class of a grid point that was filled, not decided.
const FILLED: u8 = 0x80;

/// A rectangle of grid points between two columns and two rows.
#[derive(Clone, Copy)]
struct Cell {
    left: usize,
    right: usize,
    bottom: usize,
    top: usize,
}

impl Cell {
    fn corners(&self) -> [(usize, usize); 4] {
        [(self.left, self.bottom), (self.right, self.bottom), (self.left, self.top), (self.right, self.top)]
    }

    /// The cells that it splits into: up to four.
    fn children(&self) -> impl Iterator<Item = Self> + use<> {
        let halves = |from: usize, to: usize| {
            let middle = from.midpoint(to);
            // an interval without a point inside stays whole
            if middle == from { ([(from, to); 2], 1) } else { ([(from, middle), (middle, to)], 2) }
        };
        let ((across, count_across), (up, count_up)) =
            (halves(self.left, self.right), halves(self.bottom, self.top));
        (0..count_across * count_up).map(move |k| {
            let ((left, right), (bottom, top)) = (across[k % count_across], up[k / count_across]);
            Self { left, right, bottom, top }
        })
    }

    /// The corners of its children that are not its own: middles of edges first, then the centre.
    fn middles(&self) -> [(usize, usize); 5] {
        let (column, row) = (self.left.midpoint(self.right), self.bottom.midpoint(self.top));
        [(column, self.bottom), (column, self.top), (self.left, row), (self.right, row), (column, row)]
    }

    fn has_inside(&self) -> bool {
        self.right - self.left > 1 || self.top - self.bottom > 1
    }
}

/// The map in the making.
struct Canvas<'a, P> {
    contact: &'a Contact,
    plane: &'a P,
    columns: usize,
    rows: usize,
    /// Class codes, with the marks above.
    classes: Vec<u8>,
    /// ln ŷ_e where decided: a starting value for neighbours, which does not need more digits.
    ln_indentation: Vec<f32>,
    decisions: usize,
}

/// Decides the map on a coarse grid, then wherever neighbouring points differ.
#[must_use]
pub fn adaptive(contact: &Contact, plane: &impl Plane) -> StabilityMap {
    let (columns, rows) = (plane.columns(), plane.rows());
    let mut canvas = Canvas {
        contact,
        plane,
        columns,
        rows,
        classes: vec![UNKNOWN; columns * rows],
        ln_indentation: vec![0.0; columns * rows],
        decisions: 0,
    };
    let (lines_across, lines_up) = (coarse_lines(columns), coarse_lines(rows));
    canvas.decide_coarse_grid(&lines_across, &lines_up);
    let uniform = canvas.refine(coarse_cells(&lines_across, &lines_up));
    canvas.fill(&uniform);
    canvas.follow_boundaries();
    let Canvas { mut classes, decisions, .. } = canvas;
    classes.iter_mut().for_each(|c| *c &= !FILLED);
    StabilityMap { columns, rows, classes, decisions }
}

/// The grid lines of the coarse grid, the first and the last among them.
fn coarse_lines(count: usize) -> Vec<usize> {
    let mut lines: Vec<usize> = (0..count).step_by((count / COARSE_INTERVALS).max(1)).collect();
    if lines.last().is_some_and(|last| last + 1 < count) {
        lines.push(count - 1);
    }
    lines
}

fn coarse_cells(across: &[usize], up: &[usize]) -> Vec<Cell> {
    let intervals = |lines: &[usize]| -> Vec<(usize, usize)> {
        // one line alone still makes a cell, of no width
        if lines.len() == 1 {
            vec![(lines[0], lines[0])]
        } else {
            lines.windows(2).map(|w| (w[0], w[1])).collect()
        }
    };
    let across = intervals(across);
    intervals(up)
        .into_iter()
        .flat_map(|(bottom, top)| across.iter().map(move |&(left, right)| Cell { left, right, bottom, top }))
        .collect()
}

impl<P: Plane> Canvas<'_, P> {
    fn index(&self, column: usize, row: usize) -> usize {
        row * self.columns + column
    }

    fn decide_coarse_grid(&mut self, across: &[usize], up: &[usize]) {
        let (contact, plane) = (self.contact, self.plane);
        let strips: Vec<Vec<(usize, u8, f32)>> = across
            .par_chunks(LANES)
            .map(|strip| {
                let mut decided = Vec::with_capacity(strip.len() * up.len());
                let at = |lane: usize, row: usize| plane.coefficients(strip[lane], up[row]);
                sweep_rows(contact, strip.len(), up.len(), at, |row, block| {
                    decided.extend(strip.iter().enumerate().map(|(lane, column)| {
                        (
                            up[row] * plane.columns() + column,
                            block.class(lane) as u8,
                            block.ln_indentation[lane] as f32,
                        )
                    }));
                });
                decided
            })
            .collect();
        self.record(strips);
    }

    fn record(&mut self, decided: Vec<Vec<(usize, u8, f32)>>) {
        for (index, class, ln_indentation) in decided.into_iter().flatten() {
            self.classes[index] = class;
            self.ln_indentation[index] = ln_indentation;
            self.decisions += 1;
        }
    }

    /// Decides the points in the queue, each with its starting value.
    fn decide(&mut self, queue: &[(usize, f32)]) {
        let (contact, plane, columns) = (self.contact, self.plane, self.columns);
        let decided: Vec<Vec<(usize, u8, f32)>> = queue
            .par_chunks(LANES)
            .with_min_len(4)
            .map_init(Block::default, |block, points| {
                for (lane, (index, guess)) in points.iter().enumerate() {
                    block.set(lane, &plane.coefficients(index % columns, index / columns), f64::from(*guess));
                }
                block.decide(contact, points.len());
                let result = |(lane, (index, _)): (usize, &(usize, f32))| {
                    (*index, block.class(lane) as u8, block.ln_indentation[lane] as f32)
                };
                points.iter().enumerate().map(result).collect()
            })
            .collect();
        self.record(decided);
    }

    fn differs(&self, cell: &Cell) -> bool {
        let [first, others @ ..] = cell.corners().map(|(column, row)| self.classes[self.index(column, row)]);
        others.iter().any(|class| *class != first)
    }

    /// Splits cells whose corners differ down to single grid steps; returns the cells whose corners agree.
    fn refine(&mut self, cells: Vec<Cell>) -> Vec<Cell> {
        let mut uniform = Vec::new();
        let mut level = cells;
        while !level.is_empty() {
            let (split, whole): (Vec<Cell>, Vec<Cell>) =
                level.into_iter().partition(|cell| self.differs(cell));
            uniform.extend(whole);
            let mut queue = Vec::new();
            level = Vec::new();
            for cell in split.iter().filter(|cell| cell.has_inside()) {
                let [a, b, c, d] =
                    cell.corners().map(|(column, row)| self.ln_indentation[self.index(column, row)]);
                let means =
                    [0.5 * (a + b), 0.5 * (c + d), 0.5 * (a + c), 0.5 * (b + d), 0.25 * (a + b + c + d)];
                for ((column, row), mean) in cell.middles().into_iter().zip(means) {
                    let index = self.index(column, row);
                    if self.classes[index] == UNKNOWN {
                        self.classes[index] = WAITING;
                        queue.push((index, mean));
                    }
                }
                level.extend(cell.children());
            }
            self.decide(&queue);
        }
        uniform
    }

    /// Gives the points of cells whose corners agree the class of the corners.
    fn fill(&mut self, cells: &[Cell]) {
        for cell in cells {
            let class = self.classes[self.index(cell.left, cell.bottom)] | FILLED;
            for row in cell.bottom..=cell.top {
                let (from, to) = (self.index(cell.left, row), self.index(cell.right, row));
                for point in &mut self.classes[from..=to] {
                    *point = if *point == UNKNOWN { class } else { *point };
                }
            }
        }
    }

    /// Decides filled points next to a point of another class, until none is left.
    fn follow_boundaries(&mut self) {
        let mut queue = self.filled_points_that_differ();
        while !queue.is_empty() {
            self.decide(&queue);
            let mut next = Vec::new();
            for (index, _) in queue {
                for neighbour in self.neighbours(index) {
                    if self.classes[neighbour] & FILLED != 0
                        && self.classes[neighbour] != WAITING
                        && self.classes[neighbour] & !FILLED != self.classes[index]
                    {
                        self.classes[neighbour] = WAITING;
                        next.push((neighbour, self.ln_indentation[index]));
                    }
                }
            }
            queue = next;
        }
    }

    fn neighbours(&self, index: usize) -> impl Iterator<Item = usize> + use<P> {
        let (column, row) = (index % self.columns, index / self.columns);
        let (columns, rows) = (self.columns, self.rows);
        [
            (column > 0).then(|| index - 1),
            (column + 1 < columns).then_some(index + 1),
            (row > 0).then(|| index - columns),
            (row + 1 < rows).then_some(index + columns),
        ]
        .into_iter()
        .flatten()
    }

    /// All filled points with a neighbour of another class, marked as waiting, each with a starting value.
    fn filled_points_that_differ(&mut self) -> Vec<(usize, f32)> {
        let mut pairs: Vec<(usize, usize)> = Vec::new();
        for row in 0..self.rows {
            let start = row * self.columns;
            let here = &self.classes[start..start + self.columns];
            collect_differing(&here[..self.columns - 1], &here[1..], start, 1, &mut pairs);
            if row + 1 < self.rows {
                let above = &self.classes[start + self.columns..start + 2 * self.columns];
                collect_differing(here, above, start, self.columns, &mut pairs);
            }
        }
        let mut queue = Vec::new();
        for (a, b) in pairs {
            for (point, other) in [(a, b), (b, a)] {
                if self.classes[point] & FILLED != 0 && self.classes[point] != WAITING {
                    self.classes[point] = WAITING;
                    let known = self.ln_indentation[other];
                    // 0 stands for a neighbour that was filled too: then the point is solved from nothing
                    queue.push((point, if known == 0.0 { f32::NAN } else { known }));
                }
            }
        }
        queue
    }
}

/// Appends the pairs (start + k, start + k + offset) whose classes differ and of which one at least was filled.
fn collect_differing(a: &[u8], b: &[u8], start: usize, offset: usize, pairs: &mut Vec<(usize, usize)>) {
    const CHUNK: usize = 256;
    let differ = |x: u8, y: u8| u8::from((x ^ y) & !FILLED != 0) & ((x | y) >> 7);
    for (chunk, (a, b)) in a.chunks(CHUNK).zip(b.chunks(CHUNK)).enumerate() {
        let mut any = 0;
        for (x, y) in a.iter().zip(b) {
            any |= differ(*x, *y);
        }
        if any != 0 {
            let first = start + chunk * CHUNK;
            let found = a.iter().zip(b).enumerate().filter(|(_, (x, y))| differ(**x, **y) != 0);
            pairs.extend(found.map(|(k, _)| (first + k, first + k + offset)));
        }
    }
}

const _: () = assert!((StabilityClass::Unresolved as u8) < FILLED);
