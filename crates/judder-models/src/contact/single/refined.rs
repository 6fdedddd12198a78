//! What every contact on a sequence of grids tells: its results with their errors, and the grids.

use crate::error::ModelError;
use crate::material::ContactScales;
use judder_contact::steady::refinement::{LevelSummary, Refinement};
use judder_store::{Results, Table};

/// A contact on a sequence of grids.
pub(super) struct Refined<'a> {
    pub(super) refinement: &'a Refinement,
    pub(super) friction_from_dissipation: f64,
    pub(super) friction_difference: f64,
    pub(super) converged: bool,
    /// Whether forces and areas are per length.
    pub(super) is_line: bool,
    /// The length across the sliding, in m, of a line that has one.
    pub(super) length: Option<f64>,
}

/// What is told of a contact.
#[derive(Results)]
pub(super) struct ToldContact {
    #[result(unit = "1")]
    force: f64,
    #[result(unit = "1")]
    area: f64,
    #[result(unit = "1")]
    friction: f64,
    #[result(unit = "1")]
    indentation: f64,
    peak_pressure: f64,
    #[result(unit = "1")]
    velocity: f64,
    #[result(unit = "1")]
    force_error: f64,
    #[result(unit = "1")]
    area_error: f64,
    #[result(unit = "1")]
    friction_error: f64,
    #[result(unit = "1")]
    friction_from_dissipation: f64,
    #[result(unit = "1")]
    friction_difference: f64,
    #[result(optional)]
    force_newton_per_metre: Option<f64>,
    #[result(optional)]
    width_metre: Option<f64>,
    #[result(optional)]
    force_newton: Option<f64>,
    #[result(optional)]
    area_square_metre: Option<f64>,
    indentation_metre: f64,
    peak_pressure_pascal: f64,
    velocity_metre_per_second: f64,
    /// along a side of the finest grid
    cells: usize,
    iterations: usize,
    products: usize,
    #[result(unit = "1")]
    residual: f64,
    converged: bool,
    errors: ContactErrors,
}

/// How far each result may be off.
#[derive(Results)]
struct ContactErrors {
    #[result(unit = "1")]
    force: f64,
    #[result(unit = "1")]
    area: f64,
    #[result(unit = "1")]
    friction: f64,
    #[result(unit = "1")]
    indentation: f64,
    peak_pressure: f64,
}

impl Refined<'_> {
    /// Results in groups and with units, and their errors.
    pub(super) fn told(&self, scales: &ContactScales, velocity: f64) -> ToldContact {
        let r = self.refinement;
        let radius = scales.scales.radius;
        let of_shape = |is_line: bool, value: f64| (self.is_line == is_line).then_some(value);
        let sum = |value: fn(&LevelSummary) -> usize| r.levels.iter().map(value).sum::<usize>();
        ToldContact {
            force: r.force.value,
            area: r.area.value,
            friction: r.friction.value,
            indentation: r.indentation.value,
            peak_pressure: r.peak_pressure.value,
            velocity,
            force_error: r.force.error,
            area_error: r.area.error,
            friction_error: r.friction.error,
            friction_from_dissipation: self.friction_from_dissipation,
            friction_difference: self.friction_difference,
            force_newton_per_metre: of_shape(true, r.force.value * (scales.force_unit() / radius)),
            width_metre: of_shape(true, r.area.value * radius),
            force_newton: self.over_length(r.force.value * scales.force_unit(), radius),
            area_square_metre: self.over_length(r.area.value * (radius * radius), radius),
            indentation_metre: r.indentation.value * radius,
            peak_pressure_pascal: r.peak_pressure.value * scales.scales.reduced_modulus,
            velocity_metre_per_second: velocity * radius / scales.time,
            cells: r.levels.last().map_or(0, |level| level.cells),
            iterations: sum(|level| level.iterations),
            products: sum(|level| level.products),
            residual: r.levels.last().map_or(f64::NAN, |level| level.residual),
            converged: self.converged,
            errors: ContactErrors {
                force: r.force.error,
                area: r.area.error,
                friction: r.friction.error,
                indentation: r.indentation.error,
                peak_pressure: r.peak_pressure.error,
            },
        }
    }

    /// A quantity of a contact that ends, or of the length R of a line, which is that of its length where it has one.
    fn over_length(&self, value: f64, radius: f64) -> Option<f64> {
        if self.is_line { self.length.map(|length| value * (length / radius)) } else { Some(value) }
    }

    /// The grids from coarse to fine.
    pub(super) fn history(&self) -> Result<Table, ModelError> {
        let levels = &self.refinement.levels;
        let column = |value: fn(&LevelSummary) -> f64| levels.iter().map(value).collect::<Vec<f64>>();
        let count =
            |value: fn(&LevelSummary) -> usize| levels.iter().map(|l| value(l) as i64).collect::<Vec<i64>>();
        let (force_unit, area_unit) = if self.is_line { ("E0* R", "R") } else { ("E0* R²", "R²") };
        Ok(Table::new()
            .column("cells", "1", count(|l| l.cells))?
            .column("cell", "R", column(|l| l.cell))?
            .column("force", force_unit, column(|l| l.force))?
            .column("area", area_unit, column(|l| l.area))?
            .column("friction", "1", column(|l| l.friction))?
            .column("indentation", "R", column(|l| l.indentation))?
            .column("peak_pressure", "E0*", column(|l| l.peak_pressure))?
            .column("iterations", "1", count(|l| l.iterations))?
            .column("products", "1", count(|l| l.products))?
            .column("residual", "1", column(|l| l.residual))?)
    }

    /// Why the contact does not count as solved, where it does not.
    pub(super) fn missed(&self, accuracy: f64) -> Option<String> {
        if self.converged {
            return None;
        }
        let r = self.refinement;
        let size = |level: &LevelSummary| {
            if self.is_line {
                format!("{} strips", level.cells)
            } else {
                format!("{0} × {0} cells", level.cells)
            }
        };
        let stalled = r.levels.iter().filter(|level| !level.converged);
        let stalled: Vec<String> =
            stalled.map(|level| format!("{} (residual {:.1e})", size(level), level.residual)).collect();
        if !stalled.is_empty() {
            return Some(format!("the contact was not solved on {}", stalled.join(", ")));
        }
        let finest = r.levels.last().map(size).unwrap_or_default();
        if r.area.error.is_infinite() || r.friction.error.is_infinite() {
            return Some(format!(
                "the errors of area and friction are not known on {finest}: it takes three grids to tell them; give 128 or more, or \
                 leave `cells` out"
            ));
        }
        Some(format!(
            "the accuracy {accuracy:.0e} is not met on {finest}: estimated errors of force {:.1e}, depth {:.1e}, area {:.1e}, \
             friction {:.1e} (area and friction may have five times the accuracy)",
            r.force.error, r.indentation.error, r.area.error, r.friction.error
        ))
    }
}
