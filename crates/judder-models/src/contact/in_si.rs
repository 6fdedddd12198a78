//! What arrays of contacts are in SI: of one contact, and of one that is followed in time.

use crate::array_in_si::ArrayInSi;
use crate::error::ModelError;
use crate::material::ContactScales;
use judder_store::Dataset;

/// An array: what its unit is in SI, how many of that it is, and its words there.
type QuantityInSi = (&'static str, &'static str, f64, &'static str);

/// Fields and grids of one contact, of a line per length.
pub(super) fn fields(dataset: Dataset, scales: &ContactScales, is_line: bool) -> Result<Dataset, ModelError> {
    let radius = scales.scales.radius;
    let (force_unit, force, area_unit, area) = match is_line {
        true => ("N/m", scales.force_unit() / radius, "m", radius),
        false => ("N", scales.force_unit(), "m²", radius * radius),
    };
    let quantities = [
        ("x", "m", radius, "position along the direction in which the indenter slides"),
        ("y", "m", radius, "position across it"),
        ("x_surface", "m", radius, "position of the points where surfaces are compared"),
        ("pressure", "Pa", scales.scales.reduced_modulus, "pressure"),
        ("gap", "m", radius, "gap"),
        ("displacement", "m", radius, "displacement into the substrate"),
        ("height", "m", radius, "height of the indenter above its lowest point"),
        ("level_cell", "m", radius, "side of a cell"),
        ("level_force", force_unit, force, "force, of a line per length"),
        ("level_area", area_unit, area, "area, of a line its width"),
    ];
    told(dataset, &quantities)
}

/// The history of a contact.
pub(super) fn history(dataset: Dataset, scales: &ContactScales) -> Result<Dataset, ModelError> {
    let (radius, force) = (scales.scales.radius, scales.force_unit());
    let quantities = [
        ("time", "s", scales.time, "time"),
        ("position", "m", radius, "position of the indenter"),
        ("indentation", "m", radius, "indentation"),
        ("force", "N", force, "normal force"),
        ("friction_force", "N", force, "force that resists a motion to +x"),
        ("area", "m²", radius * radius, "contact area"),
        ("work", "J", force * radius, "work done since the start"),
    ];
    told(dataset, &quantities)
}

fn told(dataset: Dataset, quantities: &[QuantityInSi]) -> Result<Dataset, ModelError> {
    let said = |array: &str| {
        let own = quantities.iter().find(|(name, ..)| *name == array);
        own.map_or_else(Vec::new, |(_, unit, factor, words)| {
            ArrayInSi { factor: *factor, unit, words }.attributes()
        })
    };
    Ok(dataset.described(said)?)
}
