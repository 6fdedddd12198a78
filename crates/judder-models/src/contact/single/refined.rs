//! What every contact on a sequence of grids tells: its results with their errors, and the grids.

use crate::error::ModelError;
use crate::material::ContactScales;
use judder_contact::steady::refinement::{LevelSummary, Refinement};
use judder_store::{Table, number};
use serde_json::{Map, Value, json};

/// A contact on a sequence of grids.
pub(super) struct Refined<'a> {
    pub(super) refinement: &'a Refinement,
    pub(super) friction_from_dissipation: f64,
    pub(super) friction_difference: f64,
    pub(super) converged: bool,
    /// Whether forces and areas are per length.
    pub(super) is_line: bool,
}

impl Refined<'_> {
    /// Results in groups and with units, and their errors.
    pub(super) fn scalars(&self, scales: &ContactScales, velocity: f64) -> Map<String, Value> {
        let r = self.refinement;
        let radius = scales.scales.radius;
        let (force, force_unit, area, area_unit) = if self.is_line {
            ("force_newton_per_metre", scales.force_unit() / radius, "width_metre", radius)
        } else {
            ("force_newton", scales.force_unit(), "area_square_metre", radius * radius)
        };
        let peak = r.peak_pressure.value;
        let sum = |value: fn(&LevelSummary) -> usize| r.levels.iter().map(value).sum::<usize>();
        let errors = json!({
            "force": number(r.force.error), "area": number(r.area.error), "friction": number(r.friction.error),
            "indentation": number(r.indentation.error), "peak_pressure": number(r.peak_pressure.error),
        });
        Map::from_iter([
            ("force".to_owned(), number(r.force.value)),
            ("area".to_owned(), number(r.area.value)),
            ("friction".to_owned(), number(r.friction.value)),
            ("indentation".to_owned(), number(r.indentation.value)),
            ("peak_pressure".to_owned(), number(peak)),
            ("velocity".to_owned(), number(velocity)),
            ("force_error".to_owned(), number(r.force.error)),
            ("area_error".to_owned(), number(r.area.error)),
            ("friction_error".to_owned(), number(r.friction.error)),
            ("friction_from_dissipation".to_owned(), number(self.friction_from_dissipation)),
            ("friction_difference".to_owned(), number(self.friction_difference)),
            (force.to_owned(), number(r.force.value * force_unit)),
            (area.to_owned(), number(r.area.value * area_unit)),
            ("indentation_metre".to_owned(), number(r.indentation.value * radius)),
            ("peak_pressure_pascal".to_owned(), number(peak * scales.scales.reduced_modulus)),
            ("velocity_metre_per_second".to_owned(), number(velocity * radius / scales.time)),
            ("cells".to_owned(), json!(r.levels.last().map_or(0, |level| level.cells))),
            ("iterations".to_owned(), json!(sum(|level| level.iterations))),
            ("products".to_owned(), json!(sum(|level| level.products))),
            ("residual".to_owned(), number(r.levels.last().map_or(f64::NAN, |level| level.residual))),
            ("converged".to_owned(), json!(self.converged)),
            ("errors".to_owned(), errors),
        ])
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
