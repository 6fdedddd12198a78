//! Matrices in NetCDF files: classic (1, 2, 5) and NetCDF-4.

use super::error::HeightsError;
use super::table::{EQUAL, HeightTable};
use crate::door::check_unpacked;
use judder_memory::MemoryBudget;
use ndarray::Array1;
use netcdf_reader::masked::MaskParams;
use netcdf_reader::unpack::{SignParams, UnpackParams};
use netcdf_reader::{NcFile, NcType, NcVariable};

/// Reads the matrix named `variable`, or the only one that there is, of the file's root group.
///
/// Packed numbers are unpacked (`scale_factor`, `add_offset`). The spacing comes from the coordinates of both dimensions
/// where the file has them. A matrix over (x, y) is turned to (y, x); rows and columns whose coordinate falls are turned
/// around. Masked heights come out as NaN, for the map to refuse with their place.
///
/// # Errors
/// A damaged file, no matrix, several without a name, unequal steps, cells that are not squares, heights and
/// coordinates in different units.
pub(super) fn read_netcdf(bytes: Vec<u8>, variable: Option<&str>) -> Result<HeightTable, HeightsError> {
    let packed = bytes.len() as u64;
    let file = NcFile::from_vec(bytes).map_err(unreadable)?;
    let matrix = chosen(file.variables().map_err(unreadable)?, variable)?;
    check_room(matrix, packed, MemoryBudget::of_process())?;
    let mut table = oriented(numbers(&file, matrix)?, matrix)?;
    let transposed = is_transposed(matrix);
    let names = matrix.dimensions().iter().map(|dimension| dimension.name.as_str());
    let names: Vec<&str> = if transposed { names.rev().collect() } else { names.collect() };
    let across = step_of(&file, matrix, names[0])?;
    let along = step_of(&file, matrix, names[1])?;
    if along.is_some_and(|step| step < 0.0) {
        table.heights.chunks_exact_mut(table.columns).for_each(<[f64]>::reverse);
    }
    if across.is_some_and(|step| step < 0.0) {
        let rows: Vec<&[f64]> = table.heights.chunks_exact(table.columns).rev().collect();
        table.heights = rows.concat();
    }
    if let (Some(x), Some(y)) = (along.map(f64::abs), across.map(f64::abs)) {
        if (x - y).abs() > EQUAL * x {
            return Err(HeightsError::NotSquare { x, y });
        }
        table.spacing = Some(x);
    }
    Ok(table)
}

/// Whether the file can hold the heights, and the memory their numbers: as they are unpacked, as they are handed out and as they are kept.
fn check_room(matrix: &NcVariable, packed: u64, budget: MemoryBudget) -> Result<(), HeightsError> {
    let count = matrix.shape().iter().fold(1_u64, |product, size| product.saturating_mul(*size));
    let said = count.saturating_mul(matrix.dtype().size().unwrap_or(1) as u64);
    check_unpacked(said, packed, budget, u128::from(count) * 24)
        .map_err(|cause| HeightsError::NetCdf { reason: cause.to_string() })
}

/// The numbers of a variable, unpacked, masked ones as NaN.
fn numbers(file: &NcFile, variable: &NcVariable) -> Result<Vec<f64>, HeightsError> {
    let mut stored = match file.as_classic() {
        Some(classic) => classic.read_variable_as_f64(variable.name()).map_err(unreadable)?,
        // the reader's own way to numbers is compiled once for every type
        None => {
            let bytes = file.read_variable_native_bytes(variable.name()).map_err(unreadable)?;
            Array1::from_vec(promoted(&bytes, variable)?).into_dyn()
        }
    };
    // the order of the CF conventions
    if let Some(signs) = SignParams::from_variable(variable) {
        signs.apply(&mut stored);
    }
    if let Some(mask) = MaskParams::from_variable(variable) {
        mask.apply(&mut stored);
    }
    if let Some(unpacking) = UnpackParams::from_variable(variable) {
        unpacking.apply(&mut stored);
    }
    Ok(stored.into_iter().collect())
}

/// Stored numbers of any type of numbers, in the byte order of this machine.
fn promoted(bytes: &[u8], variable: &NcVariable) -> Result<Vec<f64>, HeightsError> {
    let wrong = |what: &str| HeightsError::NetCdf { reason: format!("`{}` {what}", variable.name()) };
    let numbers = match variable.dtype() {
        NcType::Byte => each(bytes, |own| f64::from(i8::from_ne_bytes(own))),
        NcType::UByte => each(bytes, |own| f64::from(u8::from_ne_bytes(own))),
        NcType::Short => each(bytes, |own| f64::from(i16::from_ne_bytes(own))),
        NcType::UShort => each(bytes, |own| f64::from(u16::from_ne_bytes(own))),
        NcType::Int => each(bytes, |own| f64::from(i32::from_ne_bytes(own))),
        NcType::UInt => each(bytes, |own| f64::from(u32::from_ne_bytes(own))),
        NcType::Int64 => each(bytes, |own| i64::from_ne_bytes(own) as f64),
        NcType::UInt64 => each(bytes, |own| u64::from_ne_bytes(own) as f64),
        NcType::Float => each(bytes, |own| f64::from(f32::from_ne_bytes(own))),
        NcType::Double => each(bytes, f64::from_ne_bytes),
        _ => return Err(wrong("holds no numbers")),
    };
    numbers.ok_or_else(|| wrong("ends within a number"))
}

/// The numbers of so many bytes each; none where bytes are left.
fn each<const SIZE: usize>(bytes: &[u8], number: impl Fn([u8; SIZE]) -> f64) -> Option<Vec<f64>> {
    let (numbers, rest) = bytes.as_chunks();
    rest.is_empty().then(|| numbers.iter().map(|own| number(*own)).collect())
}

fn unreadable(error: netcdf_reader::Error) -> HeightsError {
    HeightsError::NetCdf { reason: error.to_string() }
}

/// The variable that holds the heights.
fn chosen<'a>(variables: &'a [NcVariable], name: Option<&str>) -> Result<&'a NcVariable, HeightsError> {
    let matrices: Vec<&NcVariable> = variables.iter().filter(|variable| is_matrix(variable)).collect();
    let names = || matrices.iter().map(|variable| variable.name().to_owned()).collect();
    match (name, matrices.as_slice()) {
        (Some(name), _) => matrices
            .iter()
            .find(|variable| variable.name() == name)
            .copied()
            .ok_or_else(|| HeightsError::NoSuchVariable { name: name.to_owned(), variables: names() }),
        (None, [only]) => Ok(only),
        (None, []) => Err(HeightsError::NoMatrix {
            variables: variables.iter().map(|variable| variable.name().to_owned()).collect(),
        }),
        (None, _) => Err(HeightsError::SeveralMatrices { variables: names() }),
    }
}

fn is_matrix(variable: &NcVariable) -> bool {
    let numbers = variable.dtype().is_primitive() && variable.dtype().size().is_ok();
    numbers && variable.ndim() == 2 && variable.shape().iter().all(|size| *size > 1)
}

fn is_transposed(matrix: &NcVariable) -> bool {
    let initial = |index: usize| {
        let name = matrix.dimensions().get(index).map_or("", |dimension| dimension.name.as_str());
        name.chars().next().map(|letter| letter.to_ascii_lowercase())
    };
    initial(0) == Some('x') && initial(1) == Some('y')
}

/// The values as rows along x.
fn oriented(values: Vec<f64>, matrix: &NcVariable) -> Result<HeightTable, HeightsError> {
    let shape: Vec<usize> = matrix.shape().iter().filter_map(|size| usize::try_from(*size).ok()).collect();
    let (first, second) = match shape.as_slice() {
        [first, second] if first.checked_mul(*second) == Some(values.len()) => (*first, *second),
        _ => {
            return Err(HeightsError::NetCdf {
                reason: String::from("its matrix has not the size that it states"),
            });
        }
    };
    if !is_transposed(matrix) {
        return Ok(HeightTable { columns: second, rows: first, heights: values, spacing: None });
    }
    let places = (0..second).flat_map(|row| (0..first).map(move |column| column * second + row));
    let heights = places.map(|place| values[place]).collect();
    Ok(HeightTable { columns: first, rows: second, heights, spacing: None })
}

/// The equal step of a dimension's coordinate, negative where it falls; `None` where it has no coordinate.
fn step_of(file: &NcFile, matrix: &NcVariable, name: &str) -> Result<Option<f64>, HeightsError> {
    let Ok(coordinate) = file.coordinate_variable(name) else {
        return Ok(None);
    };
    if let (Some(heights), Some(coordinates)) = (unit(matrix), unit(coordinate))
        && heights != coordinates
    {
        let coordinate = name.to_owned();
        return Err(HeightsError::UnitsDiffer { heights, coordinate, coordinates });
    }
    let values = numbers(file, coordinate)?;
    let steps: Vec<f64> = values.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let Some(first) = steps.first().copied() else {
        return Ok(None);
    };
    // NaN fails the comparison and is refused with the rest.
    let unequal =
        steps.iter().position(|step| !((step - first).abs() <= EQUAL * first.abs() && *step != 0.0));
    match unequal {
        Some(at) => {
            Err(HeightsError::UnequalSteps { name: name.to_owned(), first, other: steps[at], step: at + 1 })
        }
        None => Ok(Some((values[values.len() - 1] - values[0]) / steps.len() as f64)),
    }
}

fn unit(variable: &NcVariable) -> Option<String> {
    variable.attribute("units").and_then(|attribute| attribute.value.as_string())
}
