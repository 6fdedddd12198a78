//! One contact: its pressure, its sections, its grids.

#![deny(clippy::indexing_slicing, reason = "stored arrays may be of any length")]

use crate::contact::drawn_unit::DrawnUnit;
use judder_report::figure::ValueMap;
use judder_report::palette::ColourMap;
use judder_report::{Axis, Layer, Panel, Role};
use judder_study::pictures::{FRAME, StoredArrays, at, reals};

/// What the arrays are over that are read row by row.
const OVER: [(&str, [&str; 2]); 3] =
    [("pressure", ["y", "x"]), ("displacement", ["y", "x_surface"]), ("height", ["y", "x_surface"])];

/// Friction of a contact at rest is rounding, and so is how far each grid's is from it.
const NOTHING: f64 = 1e-12;

/// Pressure with the contact's boundary, pressure and surfaces along y = 0, values over grids.
pub(crate) fn contact(dataset: &StoredArrays<'_>) -> Option<Vec<Panel>> {
    for (name, dimensions) in OVER {
        dataset.over(name, &dimensions)?;
    }
    let length = DrawnUnit::of(dataset, "x", "$R$")?;
    let (x, y) = (&length.values(reals(dataset, "x")?), &length.values(reals(dataset, "y")?));
    let load = DrawnUnit::of(dataset, "pressure", "$E_{0}^{*}$")?;
    let pressure = &load.values(reals(dataset, "pressure")?);
    let mut panels = Vec::new();
    if y.len() > 1 {
        panels.push(pressure_map([x, y], pressure, [&length, &load])?);
    }
    let middle = y.iter().enumerate().min_by(|a, b| a.1.abs().total_cmp(&b.1.abs()))?.0;
    let row = |values: &[f64], width: usize| -> Option<Vec<f64>> {
        Some(values.get(middle * width..(middle + 1) * width)?.to_vec())
    };
    let along = || Axis::linear(length.label("Position $x$"));
    let section = Layer::line("", x.to_vec(), row(pressure, x.len())?, Role::Series(0));
    panels.push(
        Panel::new(along(), Axis::linear(load.label("Pressure $p$")), vec![section])
            .with_title("pressure along $y$ = 0"),
    );
    if let Some(at) = reals(dataset, "x_surface")
        && let Some(displacement) = row(reals(dataset, "displacement")?, at.len())
        && let Some(height) = row(reals(dataset, "height")?, at.len())
        && let Some(depth) = dataset.attributes().get("indentation").and_then(serde_json::Value::as_f64)
    {
        let depths = DrawnUnit::of(dataset, "displacement", "$R$")?;
        let surface: Vec<f64> = displacement.iter().map(|u| -u).collect();
        // what stands far above the contact would flatten the picture
        let touching = height.iter().zip(row(pressure, x.len())?).filter(|(_, pressure)| *pressure > 0.0);
        let highest = 4.0 * touching.map(|(height, _)| *height).fold(0.0, f64::max);
        let indenter: Vec<f64> =
            height.iter().map(|h| if *h < highest { h - depth } else { f64::NAN }).collect();
        let layers = vec![
            Layer::line(
                "surface of the substrate",
                length.values(at),
                depths.values(&surface),
                Role::Series(0),
            ),
            Layer::line("indenter", length.values(at), depths.values(&indenter), Role::Reference.dashed()),
        ];
        panels.push(
            Panel::new(along(), Axis::linear(depths.label("Height $z$")), layers)
                .with_title("surfaces along $y$ = 0"),
        );
    }
    panels.extend(history(dataset));
    Some(panels)
}

fn pressure_map([x, y]: [&[f64]; 2], pressure: &[f64], [length, load]: [&DrawnUnit; 2]) -> Option<Panel> {
    let half = 0.5 * (y.last()? - y.first()?) * FRAME;
    let centre = 0.5 * (x.last()? + x.first()?);
    let map = ValueMap {
        x: x.to_vec(),
        y: y.to_vec(),
        z: pressure.to_vec(),
        bar: Axis::linear(load.label("Pressure $p$")),
        colours: ColourMap::Sequential,
    };
    let (boundary_x, boundary_y) = boundary(x, y, pressure);
    let layers =
        vec![Layer::Values(map), Layer::line("", boundary_x, boundary_y, Role::FullBoundary.solid())];
    let across = Axis::linear(length.label("Position $x$")).over(centre - half, centre + half);
    let up = Axis::linear(length.label("Position $y$"));
    Some(Panel::new(across, up, layers).with_title("pressure, contact boundary"))
}

/// The sides of cells between contact and gap, with a gap after each run of them.
fn boundary(x: &[f64], y: &[f64], pressure: &[f64]) -> (Vec<f64>, Vec<f64>) {
    let (columns_at, rows_at) = (x, y);
    let (columns, rows) = (x.len(), y.len());
    let (mut along, mut up) = (Vec::new(), Vec::new());
    if columns < 2 || rows < 2 {
        return (along, up);
    }
    let half = [x, y].map(|places| 0.5 * (at(places, 1) - at(places, 0)));
    let touches = |row: usize, column: usize| at(pressure, row * columns + column) > 0.0;
    let mut run = |points: [(f64, f64); 2]| {
        for (px, py) in points {
            along.push(px);
            up.push(py);
        }
        along.push(f64::NAN);
        up.push(f64::NAN);
    };
    // upright sides, then level ones; neighbours in a row are one run
    for (column, x) in x.iter().enumerate().skip(1) {
        let differs = |row: &usize| touches(*row, column - 1) != touches(*row, column);
        for (first, last) in runs((0..rows).filter(differs)) {
            let place = x - half[0];
            run([(place, at(rows_at, first) - half[1]), (place, at(rows_at, last) + half[1])]);
        }
    }
    for (row, y) in y.iter().enumerate().skip(1) {
        let differs = |column: &usize| touches(row - 1, *column) != touches(row, *column);
        for (first, last) in runs((0..columns).filter(differs)) {
            let place = y - half[1];
            run([(at(columns_at, first) - half[0], place), (at(columns_at, last) + half[0], place)]);
        }
    }
    (along, up)
}

/// Runs of consecutive numbers: first and last of each.
fn runs(numbers: impl Iterator<Item = usize>) -> Vec<(usize, usize)> {
    let mut runs: Vec<(usize, usize)> = Vec::new();
    for number in numbers {
        match runs.last_mut() {
            Some((_, last)) if *last + 1 == number => *last = number,
            _ => runs.push((number, number)),
        }
    }
    runs
}

/// How far each grid's values are from those that stand in the summary.
fn history(dataset: &StoredArrays<'_>) -> Option<Panel> {
    dataset.alike(&["level_cell", "level_force", "level_area", "level_friction"])?;
    let side = DrawnUnit::of(dataset, "level_cell", "$R$")?;
    let cells = side.values(reals(dataset, "level_cell")?);
    if cells.len() < 2 {
        return None;
    }
    let mut layers = Vec::new();
    for (index, name) in ["force", "area", "friction"].into_iter().enumerate() {
        let values = reals(dataset, &format!("level_{name}"))?;
        let best = dataset.attributes().get(name)?.as_f64()?;
        if best.abs() < NOTHING {
            continue;
        }
        // the grid that gave the value itself has no place on a logarithmic axis: a gap
        let distance = values.iter().map(|value| (value / best - 1.0).abs());
        let distance: Vec<f64> =
            distance.map(|distance| if distance > 1e-15 { distance } else { f64::NAN }).collect();
        if !distance.iter().any(|distance| distance.is_finite()) {
            continue;
        }
        let role = Role::Series(index);
        layers.push(Layer::line(name, cells.clone(), distance.clone(), role));
        layers.push(Layer::points(name, cells.clone(), distance, role));
    }
    let vertical = Axis::log("Distance from the result (−)");
    Some(Panel::new(Axis::log(side.label("Cell $h$")), vertical, layers).with_title("grids"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_boundary_of_one_cell_is_its_four_sides() {
        let axis = [0.0, 1.0, 2.0];
        let (x, y) = boundary(&axis, &axis, &[0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0]);
        assert_eq!(x.iter().filter(|x| x.is_nan()).count(), 4);
        assert!(x.iter().chain(&y).filter(|v| v.is_finite()).all(|v| *v == 0.5 || *v == 1.5));
        assert_eq!(runs([1, 2, 3, 7, 9, 10].into_iter()), [(1, 3), (7, 7), (9, 10)]);
    }
}
