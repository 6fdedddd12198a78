//! Pressure, gap and displacement as arrays and for ParaView.

use crate::contact::in_si;
use crate::error::ModelError;
use crate::material::ContactScales;
use crate::written::written;
use judder_contact::periodic_contact::level::PeriodicLevel;
use judder_contact::steady::level::Level;
use judder_contact::steady::profile::Profile;
use judder_contact::steady::refinement::{LevelSummary, Refinement};
use judder_contact::surface::grid::SurfaceGrid;
use judder_contact::unilateral::UnilateralSolution;
use judder_exchange::square_cells::SquareCells;
use judder_exchange::vtu::{FieldValues, VtuField};
use judder_store::{Dataset, Variable};

/// The fields of one contact, row-major, lengths in R, pressures in E0*.
pub(super) struct ContactFields<'a> {
    /// Whether forces and areas are per length.
    is_line: bool,
    grid: SurfaceGrid,
    solution: &'a UnilateralSolution,
    /// x of the cells' centres, where pressures are.
    x: Vec<f64>,
    /// x of the points where surfaces are compared, a little upstream.
    x_surface: Vec<f64>,
    y: Vec<f64>,
    /// Height of the indenter above its lowest point.
    height: Vec<f64>,
    /// Displacement into the substrate.
    displacement: Vec<f64>,
}

/// A number of one grid.
type OfLevel = fn(&LevelSummary) -> f64;

/// Heights beyond this, in R, say that the indenter does not reach there.
const REACH: f64 = 100.0;

impl<'a> ContactFields<'a> {
    /// The fields of the finest grid of a contact.
    pub(super) fn new(level: &'a Level, profile: &dyn Profile) -> Self {
        let (grid, shift) = (level.grid, level.collocation_shift);
        let rows = (0..grid.rows).map(|row| grid.y(row));
        let height = |y: f64| (0..grid.columns).map(move |column| profile.height(grid.x(column) - shift, y));
        let own = Self::of(grid, &level.solution, shift, rows.flat_map(height).collect());
        Self { is_line: profile.is_line(), ..own }
    }

    /// The fields of one period of a surface.
    pub(super) fn of_period(level: &'a PeriodicLevel) -> Self {
        Self::of(level.grid, &level.solution, level.collocation_shift, level.heights.clone())
    }

    fn of(grid: SurfaceGrid, solution: &'a UnilateralSolution, shift: f64, height: Vec<f64>) -> Self {
        let x: Vec<f64> = (0..grid.columns).map(|column| grid.x(column)).collect();
        let x_surface: Vec<f64> = x.iter().map(|x| x - shift).collect();
        let y: Vec<f64> = (0..grid.rows).map(|row| grid.y(row)).collect();
        let displacement = solution
            .gap
            .iter()
            .zip(&height)
            .map(|(gap, height)| if *height < REACH { gap + solution.indentation - height } else { f64::NAN })
            .collect();
        Self { is_line: false, grid, solution, x, x_surface, y, height, displacement }
    }

    /// `pressure` over y and x; `gap`, `displacement` and `height` over y and `x_surface`.
    pub(super) fn surfaces(&self) -> Result<Dataset, ModelError> {
        let shape = [self.y.len(), self.x.len()];
        let field = |name: &str, x: &str, values: &[f64], long_name: &str| {
            Variable::new(name, &["y", x], &shape, values.to_vec()).units("1").long_name(long_name)
        };
        let coordinate = |name: &str, values: &[f64], long_name: &str| {
            Variable::coordinate(name, values.to_vec()).units("1").long_name(long_name)
        };
        let dataset = Dataset::new()
            .with(coordinate("x", &self.x, "x/R along the direction in which the indenter slides"))?
            .with(coordinate("y", &self.y, "y/R across it"))?
            .with(coordinate("x_surface", &self.x_surface, "x/R of the points where surfaces are compared"))?
            .with(field("pressure", "x", &self.solution.pressure, "pressure p/E0*"))?
            .with(field("gap", "x_surface", &self.solution.gap, "gap g/R"))?
            .with(field(
                "displacement",
                "x_surface",
                &self.displacement,
                "displacement u/R into the substrate",
            ))?
            .with(field(
                "height",
                "x_surface",
                &self.height,
                "height of the indenter h/R above its lowest point",
            ))?
            .attribute("indentation", self.solution.indentation)?;
        Ok(dataset)
    }

    /// The surfaces, and the grids from coarse to fine; with what they are in SI where that is asked.
    pub(super) fn dataset(
        &self,
        refinement: &Refinement,
        scales: &ContactScales,
        is_in_si: bool,
    ) -> Result<Dataset, ModelError> {
        let mut dataset = self.surfaces()?;
        let coordinate = |name: &str, values: &[f64], long_name: &str| {
            Variable::coordinate(name, values.to_vec()).units("1").long_name(long_name)
        };
        let levels = &refinement.levels;
        let cells: Vec<f64> = levels.iter().map(|level| level.cells as f64).collect();
        dataset = dataset.with(coordinate("level", &cells, "cells a side, grid by grid"))?;
        let rows: [(&str, OfLevel, &str); 5] = [
            ("level_cell", |l| l.cell, "side of a cell h/R"),
            ("level_force", |l| l.force, "force F/(E0* R²), of a line F/(E0* R)"),
            ("level_area", |l| l.area, "area A/R², of a line its width over R"),
            ("level_friction", |l| l.friction, "friction coefficient"),
            ("level_residual", |l| l.residual, "largest error of the unilateral conditions"),
        ];
        for (name, value, long_name) in rows {
            let values: Vec<f64> = levels.iter().map(value).collect();
            dataset = dataset
                .with(Variable::new(name, &["level"], &[values.len()], values).long_name(long_name))?;
        }
        if is_in_si {
            dataset = in_si::fields(dataset, scales, self.is_line)?;
        }
        Ok(dataset
            .attribute("force", refinement.force.value)?
            .attribute("area", refinement.area.value)?
            .attribute("friction", refinement.friction.value)?
            .attribute("radius_metre", scales.scales.radius)?
            .attribute("reduced_modulus_pascal", scales.scales.reduced_modulus)?)
    }

    /// The fields as cells of a grid for ParaView: lengths in R, pressures in E0*.
    pub(super) fn vtu(&self) -> Result<Vec<u8>, ModelError> {
        let grid = &self.grid;
        let cells =
            SquareCells { columns: grid.columns, rows: grid.rows, side: grid.cell, origin: grid.origin };
        let field = |name: &str, values: &[f64]| VtuField {
            name: name.to_owned(),
            values: FieldValues::Scalars(values.to_vec()),
        };
        let fields = [
            field("pressure", &self.solution.pressure),
            field("gap", &self.solution.gap),
            field("displacement", &self.displacement),
        ];
        written(|to| cells.write_vtu(to, &fields))
    }
}
