//! What the solve on a grid starts from.

use super::SteadyQuestion;
use crate::surface::grid::SurfaceGrid;
use crate::unilateral::Loading;

/// What a grid's solve starts from: the solution on another grid.
pub struct LevelStart {
    pub(super) grid: Option<SurfaceGrid>,
    pub(super) pressure: Vec<f64>,
    pub(super) indentation: f64,
}

impl LevelStart {
    /// Nothing but the rubbery depth.
    #[must_use]
    pub fn none(question: &SteadyQuestion<'_>) -> Self {
        let indentation = match question.loading {
            Loading::Indentation(depth) => depth,
            Loading::Load(force) => question.profile.elastic_depth(force),
        };
        Self { grid: None, pressure: Vec::new(), indentation }
    }

    /// The pressure at the cells of another grid, linear between the cells of this one; zero where the nearest cell is
    /// free or outside.
    pub(super) fn on(&self, grid: &SurfaceGrid) -> Vec<f64> {
        let Some(from) = &self.grid else {
            return vec![0.0; grid.len()];
        };
        let columns: Vec<_> = (0..grid.columns)
            .map(|c| neighbours(grid.x(c), from.origin[0], from.cell, from.columns))
            .collect();
        let mut pressure = Vec::with_capacity(grid.len());
        for row in 0..grid.rows {
            let along_y = neighbours(grid.y(row), from.origin[1], from.cell, from.rows);
            pressure.extend(columns.iter().map(|along_x| self.between(from.columns, along_x, &along_y)));
        }
        pressure
    }

    /// Half the width of the contact that is started from.
    pub(super) fn half_width(&self) -> Option<f64> {
        let grid = self.grid.as_ref()?;
        let first = self.pressure.iter().position(|pressure| *pressure > 0.0)?;
        let last = self.pressure.iter().rposition(|pressure| *pressure > 0.0)?;
        Some(0.5 * (last + 1 - first) as f64 * grid.cell)
    }

    fn between(&self, columns: usize, along_x: &Option<Neighbours>, along_y: &Option<Neighbours>) -> f64 {
        let (Some(x), Some(y)) = (along_x, along_y) else {
            return 0.0;
        };
        let at = |row: usize, column: usize| self.pressure[row * columns + column];
        if at(y.nearest, x.nearest) <= 0.0 {
            return 0.0;
        }
        let line = |row: usize| at(row, x.nearest) * (1.0 - x.weight) + at(row, x.next) * x.weight;
        line(y.nearest) * (1.0 - y.weight) + line(y.next) * y.weight
    }
}

/// The two cells of a line between which a position lies.
struct Neighbours {
    nearest: usize,
    next: usize,
    /// Weight of the next cell.
    weight: f64,
}

fn neighbours(position: f64, origin: f64, cell: f64, count: usize) -> Option<Neighbours> {
    let place = (position - origin) / cell - 0.5;
    let nearest = place.round();
    if nearest < 0.0 || nearest >= count as f64 {
        return None;
    }
    let next = (nearest + (place - nearest).signum()).clamp(0.0, (count - 1) as f64);
    Some(Neighbours { nearest: nearest as usize, next: next as usize, weight: (place - nearest).abs() })
}
