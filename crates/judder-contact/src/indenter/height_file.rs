//! Height-map files: which reader serves which ending.

use super::error::IndenterError;
use super::height_table::HeightTable;
use super::netcdf::read_netcdf;
use super::npy::read_npy;
use super::text_matrix::read_text_matrix;
use std::path::Path;

/// Reads the bytes of a height map by the ending of its file's name: `.npy`, a text matrix (`.txt`, `.csv`, `.tsv`, `.dat`,
/// `.asc`) or NetCDF (`.nc`, `.nc4`, `.cdf`).
///
/// `variable` names the matrix of a NetCDF file that holds several.
///
/// # Errors
/// [`IndenterError::UnknownEnding`], [`IndenterError::Empty`], [`IndenterError::VariableWithoutNames`], and what the reader of
/// the form refuses.
pub fn height_table(
    file: &Path,
    bytes: Vec<u8>,
    variable: Option<&str>,
) -> Result<HeightTable, IndenterError> {
    let ending = file.extension().map(|ending| ending.to_string_lossy().to_ascii_lowercase());
    let reader = match ending.as_deref() {
        Some("nc" | "nc4" | "cdf") => Reader::NetCdf,
        Some("npy") => Reader::Npy,
        Some("txt" | "csv" | "tsv" | "dat" | "asc") => Reader::Text,
        _ => return Err(IndenterError::UnknownEnding { ending: ending.unwrap_or_default() }),
    };
    if bytes.is_empty() {
        return Err(IndenterError::Empty);
    }
    match (reader, variable) {
        (Reader::NetCdf, variable) => read_netcdf(bytes, variable),
        (_, Some(name)) => Err(IndenterError::VariableWithoutNames { name: name.to_owned() }),
        (Reader::Npy, None) => read_npy(&bytes),
        (Reader::Text, None) => read_text_matrix(&bytes),
    }
}

#[derive(Clone, Copy)]
enum Reader {
    NetCdf,
    Npy,
    Text,
}
