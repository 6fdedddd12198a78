//! Tables over time, or over temperature, in files.

use crate::error::ModelError;
use judder_exchange::number_table::{TableColumn, read_number_table};
use judder_keys::dimension::Dimension;
use judder_keys::file_reference::FileReference;
use judder_keys::quantity::Quantity;
use judder_study::input_file::{text, unusable};

/// Two columns in SI units; `header` is what the file could begin with.
pub(super) fn columns(
    file: &FileReference,
    dimensions: [Dimension; 2],
    header: &str,
) -> Result<[Vec<f64>; 2], ModelError> {
    let found: [TableColumn; 2] =
        read_number_table(&text(&file.path)?, header).map_err(|error| unusable(&file.path, &error))?;
    let mut columns = found.into_iter().zip(dimensions).map(|(column, dimension)| {
        in_si(column, dimension)
            .map_err(|reason| unusable(&file.path, &format!("{reason}, as in `{header}`")))
    });
    let mut next = || columns.next().unwrap_or(Ok(Vec::new()));
    Ok([next()?, next()?])
}

/// The numbers of a column in SI units, or why these are not known.
fn in_si(column: TableColumn, dimension: Dimension) -> Result<Vec<f64>, String> {
    let unit = match (&column.unit, dimension.is_number()) {
        (None, true) => return Ok(column.values),
        (Some(unit), true) => {
            return Err(format!("a column of numbers without a unit has the unit `{unit}`"));
        }
        (None, false) => return Err(format!("the column of {dimension} has no unit in brackets")),
        (Some(unit), false) => unit,
    };
    let read = |number: f64| match Quantity::parse(&format!("{number} {unit}")) {
        Ok(found) if found.dimension == dimension => Ok(found.number),
        Ok(_) => Err(format!("`{unit}` is no unit of {dimension}")),
        Err((problem, _)) => Err(format!("`{unit}` is no unit of {dimension}: {problem}")),
    };
    // degrees Celsius have a zero of their own
    let (zero, one) = (read(0.0)?, read(1.0)?);
    Ok(column
        .values
        .into_iter()
        .map(|value| if zero == 0.0 { one * value } else { zero + (one - zero) * value })
        .collect())
}
