//! What can be wrong with a file of another program.

use crate::npy::error::NpyError;
use crate::triangle::Triangle;
use crate::wav::error::SoundError;
use judder_memory::BeyondMemory;
use judder_structure::StructureError;
use judder_structure::element::ElementKind;
use std::io;
use thiserror::Error;

/// Why a file was not read or written. Every variant says what was found and what would be right.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum FileCause {
    /// The system does not give the file.
    #[error("cannot be read: {source}")]
    Unreadable {
        /// What the system said.
        source: io::Error,
    },
    /// What is there is a folder, a device or a pipe.
    #[error("is no file; give a regular one")]
    NotAFile,
    /// It would take more memory than there is for it.
    #[error("{what}: {source}; {}", source.remedy())]
    Memory {
        /// What would take it.
        what: &'static str,
        /// How much, and how much there is.
        source: BeyondMemory,
    },
    /// The system does not take the file.
    #[error("cannot be written: {source}")]
    Unwritable {
        /// What the system said.
        source: io::Error,
    },
    /// The name of the file does not tell its format.
    #[error("the extension `{found}` names no format that is read here; there are {known}")]
    UnknownExtension {
        /// The extension; empty where there is none.
        found: String,
        /// Those that are read.
        known: &'static str,
    },
    /// The file is not of the format that its name tells.
    #[error("is no {format}: {found}; {remedy}")]
    Foreign {
        /// The format that its name tells.
        format: &'static str,
        /// What is there.
        found: String,
        /// What would be right.
        remedy: &'static str,
    },
    /// A text holds bytes that are none.
    #[error("is no text: byte {byte} is not UTF-8")]
    NotText {
        /// The first such byte.
        byte: usize,
    },
    /// A word should be a number.
    #[error("`{text}` is no finite number ({what})")]
    NotANumber {
        /// The word.
        text: String,
        /// What it stands for.
        what: &'static str,
    },
    /// An entry of a Matrix Market file whose field is `integer` is written otherwise.
    #[error(
        "`{text}` is no integer, and the first line of the file says that all entries are; if it means numbers with fractions, write `real` \
         there in the place of `integer`"
    )]
    NotAnInteger {
        /// The word.
        text: String,
    },
    /// A word should be a whole number.
    #[error("`{text}` is no whole number from {least} on ({what})")]
    NotACount {
        /// The word.
        text: String,
        /// The least that it can be.
        least: usize,
        /// What it stands for.
        what: &'static str,
    },
    /// A line has too few or too many entries.
    #[error("{what} takes {expected}, found are {found}")]
    WrongEntries {
        /// What the line is.
        what: &'static str,
        /// What it needs.
        expected: &'static str,
        /// Entries found.
        found: usize,
    },
    /// The file ends too early.
    #[error("ends within {what}: {needed} bytes are needed, {left} are left; was the file cut?")]
    Cut {
        /// What is not whole.
        what: &'static str,
        /// Bytes that it needs.
        needed: usize,
        /// Bytes that there are.
        left: usize,
    },
    /// The file says another number of things than it holds.
    #[error("says {said} {what}, holds {found}")]
    WrongCount {
        /// The things.
        what: &'static str,
        /// Their number as the file says.
        said: usize,
        /// Their number as counted.
        found: usize,
    },
    /// The file says more things than its bytes can hold.
    #[error("says {said} {what}, but the {left} bytes that are left hold {room} at most")]
    TooMany {
        /// The things.
        what: &'static str,
        /// Their number as the file says.
        said: usize,
        /// Bytes that are left.
        left: usize,
        /// The most that they can hold.
        room: usize,
    },
    /// Compressed or archived data does not unpack.
    #[error("{what} does not unpack: {problem}")]
    Damaged {
        /// What was packed.
        what: &'static str,
        /// What is wrong.
        problem: String,
    },
    /// A form that the format knows and judder does not read.
    #[error("{what} is {found}; read is {read}")]
    Unsupported {
        /// What it is about.
        what: &'static str,
        /// What the file has.
        found: String,
        /// What is read, and how to get it.
        read: &'static str,
    },
    /// A part of the file contradicts another.
    #[error("{what}: {problem}")]
    Inconsistent {
        /// What is inconsistent.
        what: &'static str,
        /// In which way.
        problem: String,
    },
    /// A matrix is larger than any that is solved here.
    #[error("has {rows} rows and {columns} columns; read are {most} at most: is a number damaged?")]
    TooLarge {
        /// Its rows.
        rows: usize,
        /// Its columns.
        columns: usize,
        /// The most that are read.
        most: usize,
    },
    /// An entry lies outside the matrix.
    #[error("the entry at row {row}, column {column} (from 1) lies outside the matrix of {rows} × {columns}")]
    OutsideMatrix {
        /// Its row, from 1.
        row: usize,
        /// Its column, from 1.
        column: usize,
        /// Rows of the matrix.
        rows: usize,
        /// Columns of the matrix.
        columns: usize,
    },
    /// A matrix whose storage claims one triangle has entries on both sides.
    #[error(
        "is stored as one triangle of a {symmetry} matrix, but has entries on both sides of the diagonal, such as row {row}, column {column} \
         (from 1); store one triangle, or all of it as general"
    )]
    BothTriangles {
        /// `symmetric` or `skew-symmetric`.
        symmetry: &'static str,
        /// The row of one of them, from 1.
        row: usize,
        /// Its column, from 1.
        column: usize,
    },
    /// A skew-symmetric matrix has a diagonal.
    #[error(
        "a skew-symmetric matrix has {value} on its diagonal at row {row} (from 1), where only zero can be"
    )]
    SkewDiagonal {
        /// The row, from 1.
        row: usize,
        /// The entry.
        value: f64,
    },
    /// A matrix that should be whole has entries on one side of the diagonal only.
    #[error(
        "holds entries ({entries}) in its {triangle} triangle and none in the other, though its storage claims the whole matrix; if it is one \
         triangle of a symmetric matrix, say so (triangle = \"{triangle}\"); if it is triangular indeed, say that (triangle = \"as-stored\"); \
         otherwise write it whole"
    )]
    OneTriangle {
        /// The triangle that has entries.
        triangle: Triangle,
        /// How many, without the diagonal.
        entries: usize,
    },
    /// A matrix to be mirrored has entries on the wrong side.
    #[error(
        "should hold the {triangle} triangle of a symmetric matrix, but has an entry on the other side at row {row}, column {column} (from 1)"
    )]
    NotThatTriangle {
        /// The triangle that was named.
        triangle: Triangle,
        /// The row of the entry, from 1.
        row: usize,
        /// Its column, from 1.
        column: usize,
    },
    /// A matrix is not square.
    #[error("{name} has {rows} rows and {columns} columns; matrices of structures are square")]
    NotSquare {
        /// Which.
        name: String,
        /// Its rows.
        rows: usize,
        /// Its columns.
        columns: usize,
    },
    /// Matrices of one structure have different sizes.
    #[error(
        "{first} has {first_rows} rows, {second} has {second_rows}; matrices of one structure have the same"
    )]
    SizesDiffer {
        /// One.
        first: String,
        /// Its rows.
        first_rows: usize,
        /// Another.
        second: String,
        /// Its rows.
        second_rows: usize,
    },
    /// There is no mass or stiffness.
    #[error("there is no {what} matrix; a structure needs mass and stiffness")]
    Missing {
        /// `mass` or `stiffness`.
        what: &'static str,
    },
    /// Rows of the mass are empty.
    #[error(
        "{count} of {rows} rows of the mass have no entry that is not zero, the first is row {first} (from 1); condense these freedoms out \
         of all matrices, or write the mass whole"
    )]
    NoMass {
        /// Rows without mass.
        count: usize,
        /// Rows of the matrix.
        rows: usize,
        /// The first of them, from 1.
        first: usize,
    },
    /// The table of freedoms does not fit the matrices.
    #[error(
        "the table of freedoms has {freedoms} rows, the matrices have {rows}; each row of the matrices needs one row of the table, in their order"
    )]
    TableDiffers {
        /// Rows of the table.
        freedoms: usize,
        /// Rows of the matrices.
        rows: usize,
    },
    /// Something is named twice.
    #[error("{what} {label} is there twice, first {first}")]
    Twice {
        /// What kind of thing.
        what: &'static str,
        /// Its number or name.
        label: String,
        /// Where it was first.
        first: String,
    },
    /// A table lacks a column.
    #[error("the header of the table lacks the column `{missing}`; it needs node, direction, x, y, z")]
    MissingColumn {
        /// The column.
        missing: &'static str,
    },
    /// A direction is none.
    #[error("`{text}` is no direction; there are x, y and z (or 1, 2 and 3)")]
    NotADirection {
        /// The word.
        text: String,
    },
    /// Something is named that is not there.
    #[error("there is no {what} {label}")]
    Unknown {
        /// What kind of thing.
        what: &'static str,
        /// Its number or name.
        label: String,
    },
    /// Sets that name sets have grown beyond the file.
    #[error(
        "the sets name more than {most} nodes or elements, far more than the file has; do sets name each other again and again?"
    )]
    SetsTooLarge {
        /// The most that are read.
        most: usize,
    },
    /// A keyword lacks a parameter.
    #[error("*{keyword} needs the parameter {parameter}")]
    MissingParameter {
        /// The keyword.
        keyword: String,
        /// The parameter.
        parameter: &'static str,
    },
    /// A keyword changes the meaning of the mesh and is not read.
    #[error("*{keyword} is not read: {why}")]
    Refused {
        /// The keyword.
        keyword: String,
        /// Why, and what would be right.
        why: &'static str,
    },
    /// A property that takes one line has none or several.
    #[error("{what} takes one line, found are {found}; what depends on temperature or a field is not read")]
    WrongLines {
        /// The property.
        what: &'static str,
        /// Data lines.
        found: usize,
    },
    /// An element has too few or too many nodes.
    #[error(
        "a {kind} takes {needed} nodes, found are {found}; a comma at the end of a line lets it go on in the next"
    )]
    WrongNodes {
        /// Its shape.
        kind: ElementKind,
        /// Its nodes.
        needed: usize,
        /// Nodes found.
        found: usize,
    },
    /// A side that an element does not have.
    #[error("a {kind} has the sides S1 to S{sides}, not S{side}")]
    NoSuchSide {
        /// The shape.
        kind: ElementKind,
        /// The side, from 1.
        side: usize,
        /// Sides that there are.
        sides: usize,
    },
    /// A section of a file does not end.
    #[error("the section ${section} has no $End{section}; was the file cut?")]
    NoEnd {
        /// Its name.
        section: String,
    },
    /// There are no elements to compute with.
    #[error("has no elements of the plane or of space")]
    NoElements,
    /// Elements of the plane and of space in one mesh.
    #[error(
        "element {first} and element {other} have different dimensions; a mesh is all of the plane or all of space"
    )]
    MixedDimensions {
        /// The number of one in the file.
        first: usize,
        /// The number of another.
        other: usize,
    },
    /// A mesh of the plane has nodes off it.
    #[error("node {node} lies at z = {z}; a mesh of the plane has all its nodes at z = 0")]
    OffPlane {
        /// Its number in the file.
        node: usize,
        /// Its place.
        z: f64,
    },
    /// The file gives a block no material.
    #[error("the elements `{block}` have no section with a material in the file; give it in the case")]
    NoSection {
        /// The name of the block.
        block: String,
    },
    /// A material is not whole.
    #[error("the material `{material}` has no {what}")]
    MaterialLacks {
        /// Its name.
        material: String,
        /// What is missing.
        what: &'static str,
    },
    /// An array of an archive cannot be used.
    #[error("a NumPy array {source}; write it with scipy.sparse.save_npz")]
    Array {
        /// Why.
        source: NpyError,
    },
    /// A sound cannot be written.
    #[error("{source}")]
    Sound {
        /// Why.
        source: SoundError,
    },
    /// The mesh or the material is none.
    #[error("{source}")]
    Structure {
        /// Why.
        source: StructureError,
    },
}
