//! The map in the making: what is decided, what is filled, what waits.

use crate::Contact;
use crate::block::{LANES, PointBlock};
use crate::map::every_point::sweep_rows;
use crate::map::{OperatingPlane, StabilityMap};
use crate::mechanism::StabilityClass;
use judder_numerics::parallel;
use rayon::prelude::*;

/// Marks a point that was not decided; beside it stands the class that it was filled with.
const UNDECIDED: u8 = 0x80;
/// A point that nothing is known of.
const UNKNOWN: u8 = 0xFF;
/// A point that waits for its decision, or one of the frame, which never gets one.
const CLOSED: u8 = 0xFE;

/// The map in the making, with a frame one point wide around it, so that every point has four neighbours.
///
/// Points are addressed by their index in the framed map.
pub(super) struct Canvas<'a, P> {
    contact: &'a Contact,
    plane: &'a P,
    /// Class codes, with the marks above.
    classes: Vec<u8>,
    /// ln ŷ_e where decided: a starting value for neighbours, which does not need more digits.
    ln_indentation: Vec<f32>,
    /// Points that wait, each with its starting value.
    queue: Vec<(usize, f32)>,
    decisions: usize,
}

impl<'a, P: OperatingPlane> Canvas<'a, P> {
    pub(super) fn new(contact: &'a Contact, plane: &'a P) -> Self {
        let (columns, rows) = (plane.columns(), plane.rows());
        let size = (columns + 2) * (rows + 2);
        let mut canvas = Self {
            contact,
            plane,
            classes: vec![CLOSED; size],
            // written, not zeroed: memory that is only promised would be fetched page by page among the decisions
            ln_indentation: vec![f32::NAN; size],
            queue: Vec::new(),
            decisions: 0,
        };
        for row in 0..rows {
            canvas.row_mut(row).fill(UNKNOWN);
        }
        canvas
    }

    pub(super) fn columns(&self) -> usize {
        self.plane.columns()
    }

    pub(super) fn rows(&self) -> usize {
        self.plane.rows()
    }

    /// The code at a decided grid point.
    pub(super) fn class(&self, column: usize, row: usize) -> u8 {
        self.classes[self.index(column, row)]
    }

    /// What leads from a point to the one above it.
    pub(super) fn stride(&self) -> usize {
        self.plane.columns() + 2
    }

    /// The index of a grid point.
    pub(super) fn index(&self, column: usize, row: usize) -> usize {
        (row + 1) * self.stride() + column + 1
    }

    fn row(&self, row: usize) -> &[u8] {
        &self.classes[self.index(0, row)..][..self.plane.columns()]
    }

    fn row_mut(&mut self, row: usize) -> &mut [u8] {
        let start = self.index(0, row);
        &mut self.classes[start..][..self.plane.columns()]
    }

    pub(super) fn is_decided(&self, point: usize) -> bool {
        self.classes[point] & UNDECIDED == 0
    }

    /// Whether two points are of different classes, as far as both have one.
    pub(super) fn differ(&self, a: usize, b: usize) -> bool {
        let (a, b) = (self.classes[a], self.classes[b]);
        a < CLOSED && b < CLOSED && (a ^ b) & !UNDECIDED != 0
    }

    /// ln ŷ_e at a decided point.
    pub(super) fn ln_indentation(&self, point: usize) -> f32 {
        self.ln_indentation[point]
    }

    /// Decides the points of the grid of these lines.
    pub(super) fn decide_grid(&mut self, across: &[usize], up: &[usize]) {
        let (contact, plane) = (self.contact, self.plane);
        let strips: Vec<&[usize]> = across.chunks(LANES).collect();
        let found = parallel::each(&strips, |strip| {
            let mut decided: Vec<(u8, f32)> = Vec::with_capacity(strip.len() * up.len());
            let at = |lane: usize, row: usize| plane.coefficients(strip[lane], up[row]);
            sweep_rows(contact, strip.len(), up.len(), at, |_, block| {
                decided.extend((0..strip.len()).map(|lane| result(block, lane)));
            });
            decided
        });
        for (strip, decided) in strips.into_iter().zip(found) {
            let points = up.iter().flat_map(|&row| strip.iter().map(move |&column| (column, row)));
            for ((column, row), (class, ln_indentation)) in points.zip(decided) {
                self.record(self.index(column, row), class, ln_indentation);
            }
        }
    }

    fn record(&mut self, point: usize, class: u8, ln_indentation: f32) {
        self.classes[point] = class;
        self.ln_indentation[point] = ln_indentation;
        self.decisions += 1;
    }

    /// Puts a point into the queue, unless it is decided or waits already.
    pub(super) fn ask(&mut self, point: usize, guess: f32) {
        let class = self.classes[point];
        if class & UNDECIDED != 0 && class != CLOSED {
            self.classes[point] = CLOSED;
            self.queue.push((point, guess));
        }
    }

    /// Asks for the neighbour `point` of a decided point `near`, with a starting value on the line through `near` and what
    /// lies behind it.
    pub(super) fn ask_beyond(&mut self, point: usize, near: usize) {
        let behind = 2 * near - point;
        let here = self.ln_indentation[near];
        let rise = if self.is_decided(behind) { here - self.ln_indentation[behind] } else { 0.0 };
        self.ask(point, here + rise);
    }

    /// Decides the points in the queue, and returns them.
    pub(super) fn decide(&mut self) -> Vec<usize> {
        let (contact, plane, stride) = (self.contact, self.plane, self.stride());
        let queue = std::mem::take(&mut self.queue);
        let mut results = vec![(UNKNOWN, 0.0); queue.len()];
        queue.par_chunks(LANES).zip(results.par_chunks_mut(LANES)).with_min_len(4).for_each_init(
            PointBlock::default,
            |block, (points, results)| {
                for (lane, (point, guess)) in points.iter().enumerate() {
                    let c = plane.coefficients(point % stride - 1, point / stride - 1);
                    block.set(lane, &c, f64::from(*guess));
                }
                block.decide(contact, points.len());
                for (lane, slot) in results.iter_mut().enumerate() {
                    *slot = result(block, lane);
                }
            },
        );
        for ((point, _), (class, ln_indentation)) in queue.iter().zip(results) {
            self.record(*point, class, ln_indentation);
        }
        queue.into_iter().map(|(point, _)| point).collect()
    }

    /// Gives every undecided point the class of the last decided one before it in its row, and at the start of a row
    /// that of the row before.
    pub(super) fn fill(&mut self) {
        const CHUNK: usize = 16;
        let mut start = UNKNOWN;
        for row in 0..self.plane.rows() {
            let mut class = start;
            let (chunks, rest) = self.row_mut(row).as_chunks_mut::<CHUNK>();
            for chunk in chunks {
                class = fill_from(chunk, class);
            }
            fill_from(rest, class);
            start = self.row(row)[0] & !UNDECIDED;
        }
    }

    /// Decides all filled points with a neighbour of another class, and returns them.
    pub(super) fn decide_filled_points_that_differ(&mut self) -> Vec<usize> {
        let mut pairs: Vec<[usize; 2]> = Vec::new();
        for row in 0..self.plane.rows() {
            let (start, here) = (self.index(0, row), self.row(row));
            collect_differing(&here[..here.len() - 1], &here[1..], start, 1, &mut pairs);
            if row + 1 < self.plane.rows() {
                collect_differing(here, self.row(row + 1), start, self.stride(), &mut pairs);
            }
        }
        for [a, b] in pairs {
            for (point, other) in [(a, b), (b, a)] {
                let guess = if self.is_decided(other) { self.ln_indentation[other] } else { f32::NAN };
                self.ask(point, guess);
            }
        }
        self.decide()
    }

    /// The finished map, without frame and marks.
    pub(super) fn into_map(mut self) -> StabilityMap {
        let (columns, rows) = (self.plane.columns(), self.plane.rows());
        for row in 0..rows {
            let start = self.index(0, row);
            self.classes.copy_within(start..start + columns, row * columns);
        }
        self.classes.truncate(columns * rows);
        self.classes.iter_mut().for_each(|class| *class &= !UNDECIDED);
        StabilityMap { columns, rows, classes: self.classes, decisions: self.decisions }
    }
}

/// What is kept of a decided lane.
fn result(block: &PointBlock, lane: usize) -> (u8, f32) {
    (block.class(lane) as u8, block.ln_indentation[lane] as f32)
}

/// Gives undecided points the class of the last decided one before them, the first ones `class`; returns the last class.
#[inline(always)]
fn fill_from(points: &mut [u8], mut class: u8) -> u8 {
    let is_other = |point: u8, class: u8| if point & UNDECIDED == 0 { point ^ class } else { 0 };
    // almost everywhere no decided point is of another class, and then this is vector code
    if points.iter().fold(0, |any, point| any | is_other(*point, class)) == 0 {
        points.iter_mut().for_each(|point| *point = class | (*point & UNDECIDED));
        return class;
    }
    for point in points {
        class ^= is_other(*point, class);
        *point = class | (*point & UNDECIDED);
    }
    class
}

/// Appends the pairs (start + k, start + k + offset) whose classes differ and of which one at least was not decided.
fn collect_differing(a: &[u8], b: &[u8], start: usize, offset: usize, pairs: &mut Vec<[usize; 2]>) {
    const CHUNK: usize = 256;
    let differ = |x: u8, y: u8| u8::from((x ^ y) & !UNDECIDED != 0) & ((x | y) >> 7);
    for (chunk, (a, b)) in a.chunks(CHUNK).zip(b.chunks(CHUNK)).enumerate() {
        let mut any = 0;
        for (x, y) in a.iter().zip(b) {
            any |= differ(*x, *y);
        }
        if any != 0 {
            let first = start + chunk * CHUNK;
            let found = a.iter().zip(b).enumerate().filter(|(_, (x, y))| differ(**x, **y) != 0);
            pairs.extend(found.map(|(k, _)| [first + k, first + k + offset]));
        }
    }
}

const _: () = assert!((StabilityClass::Unresolved as u8) < UNDECIDED);
