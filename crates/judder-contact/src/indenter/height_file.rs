//! Height-map files: which reader serves which ending.

use super::error::IndenterError;
use super::height_table::HeightTable;
use super::netcdf::read_netcdf;
use super::npy::read_npy;
use super::text_matrix::read_text_matrix;
use std::path::Path;

/// Reads a height map: `.npy`, a text matrix (`.txt`, `.csv`, `.tsv`, `.dat`, `.asc`) or NetCDF (`.nc`, `.nc4`, `.cdf`).
///
/// `variable` names the matrix of a NetCDF file that holds several.
///
/// # Errors
/// [`IndenterError::Unreadable`], [`IndenterError::UnknownEnding`], [`IndenterError::VariableWithoutNames`], and what the
/// reader of the file refuses.
pub fn read_height_table(path: &Path, variable: Option<&str>) -> Result<HeightTable, IndenterError> {
    let ending = path.extension().and_then(|ending| ending.to_str()).map(str::to_ascii_lowercase);
    let reader = match ending.as_deref() {
        Some("nc" | "nc4" | "cdf") => Reader::NetCdf,
        Some("npy") => Reader::Npy,
        Some("txt" | "csv" | "tsv" | "dat" | "asc") => Reader::Text,
        _ => return Err(IndenterError::UnknownEnding { path: path.to_owned() }),
    };
    if let (Reader::Npy | Reader::Text, Some(name)) = (reader, variable) {
        return Err(IndenterError::VariableWithoutNames { name: name.to_owned() });
    }
    let bytes = std::fs::read(path)
        .map_err(|error| IndenterError::Unreadable { path: path.to_owned(), reason: error.to_string() })?;
    match reader {
        Reader::NetCdf => read_netcdf(bytes, variable),
        Reader::Npy => read_npy(&bytes),
        Reader::Text => read_text_matrix(&bytes),
    }
}

#[derive(Clone, Copy)]
enum Reader {
    NetCdf,
    Npy,
    Text,
}
