//! Meshes with fields for ParaView: VTK unstructured grids (`.vtu`), and series of them (`.pvd`).
//!
//! XML with inline arrays: base64 of blocks compressed by zlib, little-endian. Kitware, *VTK File Formats*.

use crate::cause::FileCause;
use crate::error::ExchangeError;
use crate::geometry::{Geometry, at_phase};
use crate::whole_file::{write_file, write_next};
use base64::{Engine, engine::general_purpose::STANDARD};
use faer::c64;
use flate2::{Compression, write::ZlibEncoder};
use judder_numerics::complex::ElementaryComplex;
use judder_structure::element::ElementKind;
use std::f64::consts::TAU;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// A field of one number or vector a node, or a cell.
#[derive(Debug, Clone, PartialEq)]
pub struct VtuField {
    /// Its name in ParaView.
    pub name: String,
    /// Its values.
    pub values: FieldValues,
}

/// The values of a field, one a node or one a cell.
#[derive(Debug, Clone, PartialEq)]
pub enum FieldValues {
    /// Numbers.
    Scalars(Vec<f64>),
    /// Vectors.
    Vectors(Vec<[f64; 3]>),
}

impl FieldValues {
    pub(crate) fn len(&self) -> usize {
        match self {
            Self::Scalars(values) => values.len(),
            Self::Vectors(values) => values.len(),
        }
    }
}

/// The fields of a complex shape φ: `NAME real`, `NAME imaginary`, `NAME amplitude` (|φ| of each component) and `NAME phase` (arg φ of
/// each component in rad).
#[must_use]
pub fn complex_fields(name: &str, shape: &[[c64; 3]]) -> Vec<VtuField> {
    let field = |part: &str, of: fn(c64) -> f64| VtuField {
        name: format!("{name} {part}"),
        values: FieldValues::Vectors(shape.iter().map(|own| own.map(of)).collect()),
    };
    vec![
        field("real", |value| value.re),
        field("imaginary", |value| value.im),
        field("amplitude", ElementaryComplex::modulus),
        field("phase", ElementaryComplex::argument),
    ]
}

/// Writes a mesh, or points, with fields at the nodes.
///
/// # Errors
/// [`FileCause::WrongCount`] for a field that does not fill the nodes, [`FileCause::WrongNodes`] and [`FileCause::Unknown`] for cells without their nodes,
/// [`FileCause::Unwritable`].
pub fn write_vtu(to: &mut dyn Write, geometry: &Geometry, fields: &[VtuField]) -> Result<(), ExchangeError> {
    geometry.check()?;
    let said = geometry.places.len();
    if let Some(field) = fields.iter().find(|field| field.values.len() != said) {
        return Err(
            FileCause::WrongCount { what: "values of a field", said, found: field.values.len() }.into()
        );
    }
    Ok(write_piece(to, &Piece::from(geometry), Some(fields), None)?)
}

/// Points and cells as they stand in a file.
pub(crate) struct Piece {
    /// Three coordinates a point.
    pub(crate) places: Vec<u8>,
    /// The points of one cell after the other.
    pub(crate) connectivity: Vec<u8>,
    /// Where each cell ends among them.
    pub(crate) ends: Vec<u8>,
    /// VTK's number of the kind of each cell.
    pub(crate) types: Vec<u8>,
}

impl From<&Geometry> for Piece {
    fn from(geometry: &Geometry) -> Self {
        let places = array_bytes(geometry.places.iter().flatten().copied());
        if geometry.cells.is_empty() {
            let points = geometry.places.len();
            let (connectivity, ends) = (index_bytes(0..points), index_bytes(1..=points));
            return Self { places, connectivity, ends, types: vec![VERTEX; points] };
        }
        let mut end = 0;
        let ends = geometry.cells.iter().map(|(_, nodes)| {
            end += nodes.len();
            end
        });
        Self {
            places,
            ends: index_bytes(ends),
            connectivity: index_bytes(geometry.cells.iter().flat_map(|(_, nodes)| nodes.iter().copied())),
            types: geometry.cells.iter().map(|(kind, _)| cell_type(*kind)).collect(),
        }
    }
}

/// Writes a file of one piece, with the fields of its points or of its cells.
pub(crate) fn write_piece(
    to: &mut dyn Write,
    piece: &Piece,
    of_points: Option<&[VtuField]>,
    of_cells: Option<&[VtuField]>,
) -> io::Result<()> {
    let (points, cells) = (piece.places.len() / 24, piece.types.len());
    writeln!(
        to,
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" \
         header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n<UnstructuredGrid>\n\
         <Piece NumberOfPoints=\"{points}\" NumberOfCells=\"{cells}\">"
    )?;
    write_fields(to, "PointData", of_points)?;
    writeln!(to, "<Points>")?;
    array(to, "type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"", &piece.places)?;
    writeln!(to, "</Points>\n<Cells>")?;
    array(to, "type=\"Int64\" Name=\"connectivity\"", &piece.connectivity)?;
    array(to, "type=\"Int64\" Name=\"offsets\"", &piece.ends)?;
    array(to, "type=\"UInt8\" Name=\"types\"", &piece.types)?;
    writeln!(to, "</Cells>")?;
    write_fields(to, "CellData", of_cells)?;
    writeln!(to, "</Piece>\n</UnstructuredGrid>\n</VTKFile>")
}

/// The fields of points or of cells, where there are any to be written.
fn write_fields(to: &mut dyn Write, owner: &str, fields: Option<&[VtuField]>) -> io::Result<()> {
    let Some(fields) = fields else { return Ok(()) };
    writeln!(to, "<{owner}>")?;
    for field in fields {
        let name = escaped(&field.name);
        match &field.values {
            FieldValues::Scalars(values) => {
                let numbers = array_bytes(values.iter().copied());
                array(to, &format!("type=\"Float64\" Name=\"{name}\""), &numbers)?;
            }
            FieldValues::Vectors(values) => {
                let attributes = format!("type=\"Float64\" Name=\"{name}\" NumberOfComponents=\"3\"");
                array(to, &attributes, &array_bytes(values.iter().flatten().copied()))?;
            }
        }
    }
    writeln!(to, "</{owner}>")
}

const VERTEX: u8 = 1;

/// VTK's number of a kind; its order of nodes is ours.
pub(crate) fn cell_type(kind: ElementKind) -> u8 {
    match kind {
        ElementKind::Quad4 => 9,
        ElementKind::Quad8 => 23,
        ElementKind::Triangle6 => 22,
        ElementKind::Hexahedron8 => 12,
        ElementKind::Hexahedron20 => 25,
        ElementKind::Tetrahedron10 => 24,
    }
}

/// Numbers as a file holds them.
pub(crate) fn array_bytes(values: impl Iterator<Item = f64>) -> Vec<u8> {
    values.flat_map(f64::to_le_bytes).collect()
}

/// Indices as a file holds them.
pub(crate) fn index_bytes(indices: impl Iterator<Item = usize>) -> Vec<u8> {
    indices.flat_map(|index| (index as i64).to_le_bytes()).collect()
}

/// One array as one compressed block: the number of blocks, their size, that of the last, the compressed size; the block.
fn array(to: &mut dyn Write, attributes: &str, bytes: &[u8]) -> io::Result<()> {
    let mut encoder = ZlibEncoder::new(Vec::new(), Compression::default());
    encoder.write_all(bytes)?;
    let block = encoder.finish()?;
    let size = bytes.len() as u64;
    let header: Vec<u8> =
        [1, size, size, block.len() as u64].into_iter().flat_map(u64::to_le_bytes).collect();
    let (header, block) = (STANDARD.encode(header), STANDARD.encode(block));
    writeln!(to, "<DataArray {attributes} format=\"binary\">{header}{block}</DataArray>")
}

/// A text in an attribute; characters that XML does not have become spaces.
fn escaped(text: &str) -> String {
    let escape = |letter: char| match letter {
        '&' => String::from("&amp;"),
        '<' => String::from("&lt;"),
        '>' => String::from("&gt;"),
        '"' => String::from("&quot;"),
        letter if letter.is_control() => String::from(" "),
        letter => letter.to_string(),
    };
    text.chars().map(escape).collect()
}

/// Writes a series of files: times in s with the names of files beside this one.
///
/// # Errors
/// [`FileCause::Unwritable`].
pub fn write_pvd(to: &mut dyn Write, frames: &[(f64, String)]) -> Result<(), ExchangeError> {
    writeln!(
        to,
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n<Collection>"
    )?;
    for (time, file) in frames {
        writeln!(to, "<DataSet timestep=\"{time}\" part=\"0\" file=\"{}\"/>", escaped(file))?;
    }
    writeln!(to, "</Collection>\n</VTKFile>")?;
    Ok(())
}

/// A shape that moves through one period.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Animation<'a> {
    /// The name of the field, and of the files.
    pub name: &'a str,
    /// φ at the nodes.
    pub shape: &'a [[c64; 3]],
    /// T in s.
    pub period: f64,
    /// Pictures of the period.
    pub frames: usize,
}

/// Writes Re(φ exp(2πi t/T)) at t = 0, T/n, … as `NAME-000.vtu`, … and the series `NAME.pvd`, which is returned first: ParaView plays it.
/// The name is that of a file in `folder`.
///
/// # Errors
/// [`FileCause::WrongCount`] for a shape that does not fill the nodes, [`FileCause::Unwritable`].
pub fn write_animation(
    folder: &Path,
    geometry: &Geometry,
    animation: &Animation<'_>,
) -> Result<Vec<PathBuf>, ExchangeError> {
    let Animation { name, shape, period, frames } = *animation;
    let share = |frame: usize| frame as f64 / frames as f64;
    let files: Vec<String> = (0..frames).map(|frame| format!("{name}-{frame:03}.vtu")).collect();
    for (frame, file) in files.iter().enumerate() {
        let values = FieldValues::Vectors(at_phase(shape, TAU * share(frame)));
        let field = VtuField { name: name.to_owned(), values };
        write_next(&folder.join(file), |to| write_vtu(to, geometry, &[field]))?;
    }
    let series = folder.join(format!("{name}.pvd"));
    let timed: Vec<(f64, String)> =
        files.iter().enumerate().map(|(frame, file)| (period * share(frame), file.clone())).collect();
    // the series last: what it names is there
    write_file(&series, |to| write_pvd(to, &timed))?;
    Ok(std::iter::once(series).chain(files.iter().map(|file| folder.join(file))).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn two_points() -> Geometry {
        Geometry { places: vec![[0.0; 3], [1.0, 0.0, 0.0]], cells: Vec::new(), labels: vec![1, 2] }
    }

    #[test]
    fn a_field_of_the_wrong_size_is_refused() {
        let field = VtuField { name: String::from("a"), values: FieldValues::Scalars(vec![0.0; 3]) };
        let error = write_vtu(&mut Vec::new(), &two_points(), &[field]).unwrap_err();
        assert!(matches!(error.cause(), FileCause::WrongCount { said: 2, found: 3, .. }));
    }

    #[test]
    fn the_same_fields_give_the_same_bytes() {
        let shape = [[c64::new(1.0, -1.0); 3]; 2];
        let write = || {
            let mut file = Vec::new();
            write_vtu(&mut file, &two_points(), &complex_fields("a<b", &shape)).unwrap();
            file
        };
        let text = String::from_utf8(write()).unwrap();
        assert_eq!(text.as_bytes(), write());
        for part in
            ["Name=\"a&lt;b real\"", "Name=\"a&lt;b phase\"", "NumberOfPoints=\"2\" NumberOfCells=\"2\""]
        {
            assert!(text.contains(part), "{part}");
        }
    }

    #[test]
    fn an_animation_is_a_series_over_one_period() {
        let folder = tempfile::tempdir().unwrap();
        let shape = [[c64::new(1.0, 0.0); 3]; 2];
        let animation = Animation { name: "mode-1", shape: &shape, period: 0.5, frames: 4 };
        let files = write_animation(folder.path(), &two_points(), &animation).unwrap();
        assert_eq!(files.len(), 5);
        let series = std::fs::read_to_string(&files[0]).unwrap();
        assert!(
            series.contains("<DataSet timestep=\"0.375\" part=\"0\" file=\"mode-1-003.vtu\"/>"),
            "{series}"
        );
    }
}
