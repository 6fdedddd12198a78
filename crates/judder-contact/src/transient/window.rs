//! The square of cells that moves with the indenter, and the strip of material that it remembers.
//!
//! Cells are those of the material: column i has its centre at x = (i + ½) h whatever the indenter does. The window
//! follows the indenter by whole cells; the indenter's surface is taken where it is, between the cells.

use super::error::TransientError;
use super::path::{IndenterPath, NormalCourse};
use super::substrate::{CreepingSubstrate, positive};
use super::{TransientGrid, TransientQuestion};
use crate::kernel::sliding::SlidingOperator;
use crate::surface::grid::SurfaceGrid;

/// The fewest cells a side of a window.
const FEWEST: usize = 12;
/// Free cells on each side of the square that the undeformed indenter cuts from the surface.
const FREE: f64 = 2.0;
/// The part of a pressure's creep that may be left when it is forgotten.
const FORGOTTEN: f64 = 1e-4;

/// The window's cells and the length of the strip.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct ContactWindow {
    /// Cells a side.
    pub(super) side: usize,
    /// h, side of a cell.
    pub(super) cell: f64,
    /// Columns of the strip of material that is remembered; rows are those of the window.
    pub(super) strip: usize,
    /// The depth that errors are measured by: the largest of the path.
    pub(super) depth: f64,
}

impl ContactWindow {
    /// The window that holds the contact on the whole path, and the strip that holds what it remembers.
    pub(super) fn of(question: &TransientQuestion<'_>) -> Result<Self, TransientError> {
        let memory_limit = question.grid.memory_limit;
        let window = Self::unlimited(question)?;
        let needed = window.memory_bytes(question.substrate.terms.len());
        if needed > memory_limit {
            let (columns, rows) = (window.strip, window.side);
            return Err(TransientError::Memory { columns, rows, needed, allowed: memory_limit });
        }
        Ok(window)
    }

    /// [`ContactWindow::of`] whatever it takes.
    fn unlimited(question: &TransientQuestion<'_>) -> Result<Self, TransientError> {
        let TransientGrid { cells, half_width, .. } = question.grid;
        if cells < FEWEST {
            return Err(TransientError::TooFewCells { cells, least: FEWEST });
        }
        let depth = largest_depth(question)?;
        let reach = question.profile.extent(depth) / (1.0 - 2.0 * FREE / cells as f64);
        let half_width = half_width.unwrap_or(reach);
        positive("half width of the window", half_width)?;
        let cell = 2.0 * half_width / cells as f64;
        question.refuse_too_many_steps(cell)?;
        let travelled = travelled(question.path, question.substrate, question.duration);
        let columns = (travelled / cell).ceil() + 2.0 * (question.steps.cells_a_step + 1.0).ceil();
        let strip = if travelled > 0.0 { cells.saturating_add(columns as usize) } else { cells };
        Ok(Self { side: cells, cell, strip, depth })
    }

    /// Columns and rows of the strip that a question needs, and the bytes that it takes.
    pub(super) fn needs(question: &TransientQuestion<'_>) -> Result<([usize; 2], u64), TransientError> {
        let window = Self::unlimited(question)?;
        Ok(([window.strip, window.side], window.memory_bytes(question.substrate.terms.len())))
    }

    /// Bytes of the operators of window and strip and of the fields on them.
    fn memory_bytes(&self, terms: usize) -> u64 {
        let fields = (self.strip as u64).saturating_mul(self.side as u64).saturating_mul(terms as u64 + 4);
        SlidingOperator::memory_bytes(self.strip, self.side)
            .saturating_add(SlidingOperator::memory_bytes(self.side, self.side))
            .saturating_add(fields.saturating_mul(size_of::<f64>() as u64))
    }

    /// The material column at which the window begins when the indenter is at `position`.
    pub(super) fn first_column(&self, position: f64) -> i64 {
        (position / self.cell - 0.5 * self.side as f64).round() as i64
    }

    /// The window that begins at a material column, with x measured from `position`.
    pub(super) fn grid(&self, first_column: i64, position: f64) -> SurfaceGrid {
        let half_width = 0.5 * self.cell * self.side as f64;
        let origin = [first_column as f64 * self.cell - position, -half_width];
        SurfaceGrid { columns: self.side, rows: self.side, cell: self.cell, origin }
    }

    /// A grid of the strip's size; where it lies makes no difference to its operator.
    pub(super) fn strip_grid(&self) -> SurfaceGrid {
        SurfaceGrid { columns: self.strip, rows: self.side, cell: self.cell, origin: [0.0; 2] }
    }
}

/// The largest depth on the path; under an imposed force that of the rubbery contact, which is the deepest.
fn largest_depth(question: &TransientQuestion<'_>) -> Result<f64, TransientError> {
    let largest = question.path.normal_course().range(question.duration)[1];
    let (what, depth) = match question.path.normal {
        NormalCourse::Indentation(_) => ("indentation", largest),
        NormalCourse::Load(_) => {
            ("load", question.profile.elastic_depth(largest.max(0.0) * question.substrate.relaxed()))
        }
    };
    if largest > 0.0 && depth.is_finite() {
        Ok(depth)
    } else {
        Err(TransientError::NeverTouches { what, value: largest })
    }
}

/// The longest piece of the path that is remembered at a time.
fn travelled(path: &IndenterPath, substrate: &CreepingSubstrate, duration: f64) -> f64 {
    let [left, right] = path.position.range(duration);
    let memory = -libm::log(FORGOTTEN) * substrate.longest_time();
    (right - left).min(path.position.largest_rate() * memory)
}
