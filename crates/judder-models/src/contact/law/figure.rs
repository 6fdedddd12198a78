//! Contact laws over speed and indentation, and fits to them.

#![deny(clippy::indexing_slicing, reason = "stored arrays may be of any length")]

use judder_report::figure::ValueMap;
use judder_report::palette::ColourMap;
use judder_report::{Axis, Layer, Panel, Role};
use judder_study::labels::short_number;
use judder_study::pictures::{StoredArrays, at, axis, reals};
use std::f64::consts::PI;

/// At most so many curves of equal indentation are drawn.
const CURVES: usize = 5;

/// A law's plane: speeds, indentations, and a quantity row by row.
struct DrawnPlane<'a> {
    velocities: &'a [f64],
    indentations: &'a [f64],
}

impl<'a> DrawnPlane<'a> {
    fn of(dataset: &StoredArrays<'a>) -> Option<Self> {
        for name in ["force", "area", "friction", "fitted_force", "fitted_area", "fitted_friction"] {
            dataset.over(name, &["indentation", "velocity"])?;
        }
        for name in ["rest_force", "rest_area"] {
            dataset.over(name, &["indentation"])?;
        }
        Some(Self { velocities: reals(dataset, "velocity")?, indentations: reals(dataset, "indentation")? })
    }

    /// The rows that are drawn as curves, shallow to deep.
    fn drawn(&self) -> Vec<usize> {
        let (rows, last) = (self.indentations.len(), self.indentations.len().saturating_sub(1));
        let count = rows.min(CURVES);
        (0..count).map(|k| if count > 1 { k * last / (count - 1) } else { 0 }).collect()
    }

    fn row(&self, values: &[f64], row: usize) -> Vec<f64> {
        let columns = self.velocities.len();
        values.iter().skip(row * columns).take(columns).copied().collect()
    }
}

/// Force, area and friction over speed for several indentations with their elastic limits, and as maps.
pub(crate) fn contact_law(dataset: &StoredArrays<'_>) -> Option<Vec<Panel>> {
    let plane = DrawnPlane::of(dataset)?;
    let contrast = dataset.attributes().get("contrast")?.as_f64()?;
    let line = reals(dataset, "rest_force").zip(reals(dataset, "rest_area"));
    let elastic = |quantity: &str, row: usize| {
        let depth = at(plane.indentations, row);
        let (force, area) = line.map_or((4.0 / 3.0 * libm::pow(depth, 1.5), PI * depth), |(force, area)| {
            (at(force, row), at(area, row))
        });
        match quantity {
            "force" => vec![force, contrast * force],
            "area" => vec![area],
            _ => Vec::new(),
        }
    };
    let (quantities, limits) = match line {
        Some(_) => (QUANTITIES_OF_A_LINE, "elastic limits"),
        None => (QUANTITIES, "elastic limits (Hertz)"),
    };
    let mut panels = Vec::new();
    for (quantity, label) in quantities {
        let values = reals(dataset, quantity)?;
        let rows = plane.drawn();
        let mut layers = Vec::new();
        for (index, row) in rows.iter().enumerate() {
            let depth = at(plane.indentations, *row);
            let role = Role::Graded { index, count: rows.len() };
            let name = format!("$δ$/$R$ = {}", short_number(depth));
            layers.push(Layer::line(name, plane.velocities.to_vec(), plane.row(values, *row), role.solid()));
            for limit in elastic(quantity, *row) {
                let level = vec![limit; plane.velocities.len()];
                layers.push(Layer::line("", plane.velocities.to_vec(), level, role.dashed().with_width(0.7)));
            }
        }
        if quantity != "friction" {
            layers.push(Layer::key(limits, Role::Reference.dashed()));
        }
        panels.push(Panel::new(axis(dataset.variable("velocity")?), Axis::log(label), layers));
        panels.push(map(dataset, &plane, values.to_vec(), Axis::log(label), ColourMap::Sequential)?);
    }
    Some(panels)
}

const QUANTITIES: [(&str, &str); 3] = [
    ("force", "Force $F$/($E_{0}^{*}$ $R^{2}$) (−)"),
    ("area", "Area $A$/$R^{2}$ (−)"),
    ("friction", "Friction $μ_{visc}$ (−)"),
];

const QUANTITIES_OF_A_LINE: [(&str, &str); 3] =
    [("force", "Force per length $F$/($E_{0}^{*}$ $R$) (−)"), ("area", "Width $w$/$R$ (−)"), QUANTITIES[2]];

fn map(
    dataset: &StoredArrays<'_>,
    plane: &DrawnPlane<'_>,
    z: Vec<f64>,
    bar: Axis,
    colours: ColourMap,
) -> Option<Panel> {
    let map = ValueMap { x: plane.velocities.to_vec(), y: plane.indentations.to_vec(), z, bar, colours };
    let (x, y) = (axis(dataset.variable("velocity")?), axis(dataset.variable("indentation")?));
    Some(Panel::new(x, y, vec![Layer::Values(map)]))
}

/// Computed and fitted curves, and the residuals of the fit, over the largest value at each indentation.
pub(crate) fn fit(dataset: &StoredArrays<'_>) -> Option<Vec<Panel>> {
    let plane = DrawnPlane::of(dataset)?;
    let mut panels = Vec::new();
    for (quantity, label) in QUANTITIES {
        let (computed, fitted) = (reals(dataset, quantity)?, reals(dataset, &format!("fitted_{quantity}"))?);
        let rows = plane.drawn();
        let mut layers = Vec::new();
        for (index, row) in rows.iter().enumerate() {
            let role = Role::Graded { index, count: rows.len() };
            let name = format!("$δ$/$R$ = {}", short_number(at(plane.indentations, *row)));
            let x = plane.velocities.to_vec();
            layers.push(Layer::points(name, x.clone(), plane.row(computed, *row), role));
            layers.push(Layer::line("", x, plane.row(fitted, *row), role.solid()));
        }
        // a bell that falls to nothing would stretch the axis over its tail
        let vertical = if quantity == "friction" { Axis::linear(label) } else { Axis::log(label) };
        panels.push(Panel::new(axis(dataset.variable("velocity")?), vertical, layers));
        let columns = plane.velocities.len().max(1);
        let residuals =
            fitted.chunks(columns).zip(computed.chunks(columns)).flat_map(|(fitted, computed)| {
                let largest = computed.iter().copied().fold(0.0, f64::max);
                fitted.iter().zip(computed).map(move |(f, c)| (f - c) / largest)
            });
        let bar = Axis::linear("Fit − computed, over the largest (−)");
        panels.push(map(dataset, &plane, residuals.collect(), bar, ColourMap::Diverging)?);
    }
    Some(panels)
}
