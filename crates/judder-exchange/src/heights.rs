//! Heights of surfaces: matrices as NumPy, programs that write text, and NetCDF's users hold them.

mod error;
mod netcdf;
mod numpy;
mod table;
mod text_matrix;

pub use error::HeightsError;
pub use table::HeightTable;

use std::path::Path;

/// Reads the bytes of a height map by the ending of its file's name: `.npy`, a text matrix (`.txt`, `.csv`, `.tsv`, `.dat`,
/// `.asc`) or NetCDF (`.nc`, `.nc4`, `.cdf`).
///
/// - `.npy`: a matrix of `f4` or `f8`, of either byte order, in C's or Fortran's order.
/// - Text: one row of heights a line, separated by spaces, tabs, commas or semicolons; `#` and `%` begin a comment.
/// - NetCDF: the matrix of the root group that is named `variable`, or the only one that there is. Packed numbers are unpacked
///   (`scale_factor`, `add_offset`). The spacing comes from the coordinates of both dimensions where the file has them. A matrix
///   over (x, y) is turned to (y, x); rows and columns whose coordinate falls are turned around. Masked heights are NaN.
///
/// # Errors
/// [`HeightsError`]: an ending that says nothing, an empty file, a variable that is named where none has a name, and what the
/// reader of the form refuses.
pub fn read_heights(
    file: &Path,
    bytes: Vec<u8>,
    variable: Option<&str>,
) -> Result<HeightTable, HeightsError> {
    let ending = file.extension().map(|ending| ending.to_string_lossy().to_ascii_lowercase());
    let form = match ending.as_deref() {
        Some("nc" | "nc4" | "cdf") => HeightForm::NetCdf,
        Some("npy") => HeightForm::NumPy,
        Some("txt" | "csv" | "tsv" | "dat" | "asc") => HeightForm::Text,
        _ => return Err(HeightsError::UnknownEnding { ending: ending.unwrap_or_default() }),
    };
    if bytes.is_empty() {
        return Err(HeightsError::Empty);
    }
    match (form, variable) {
        (HeightForm::NetCdf, variable) => netcdf::read_netcdf(bytes, variable),
        (_, Some(name)) => Err(HeightsError::VariableWithoutNames { name: name.to_owned() }),
        (HeightForm::NumPy, None) => numpy::read_numpy(&bytes),
        (HeightForm::Text, None) => text_matrix::read_text_matrix(&bytes),
    }
}

#[derive(Clone, Copy)]
enum HeightForm {
    NetCdf,
    NumPy,
    Text,
}
