//! What can be wrong with an array of NumPy.

use thiserror::Error;

/// Why an array in NumPy's format is not read; every message goes on from the name of the array.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum NpyError {
    /// It is in another format.
    #[error("does not begin with \\x93NUMPY, and so is none")]
    Foreign,
    /// It does not unpack from its archive.
    #[error("does not unpack: {problem}")]
    Damaged {
        /// What is wrong.
        problem: String,
    },
    /// Its header is not whole.
    #[error("ends within its header")]
    Cut,
    /// Its header is longer than any.
    #[error("has a header of {length} bytes, and {most} are read at most")]
    LongHeader {
        /// Bytes of the header.
        length: usize,
        /// The most that are read.
        most: usize,
    },
    /// A version of the format that is not known.
    #[error("has version {version} of the format, and versions 1, 2 and 3 are read")]
    Version {
        /// The version.
        version: u8,
    },
    /// Its header is not UTF-8.
    #[error("has a header that is no text")]
    NotText,
    /// Its header lacks a key.
    #[error("has no {key} in its header")]
    MissingKey {
        /// The key.
        key: &'static str,
    },
    /// Its order is neither that of C nor that of Fortran.
    #[error("has the fortran_order {found}, which is neither True nor False")]
    Order {
        /// What its header says.
        found: String,
    },
    /// Its shape is none.
    #[error("has the shape {found} in its header, which is none")]
    Shape {
        /// What its header says.
        found: String,
    },
    /// Its numbers are of a type that is not read.
    #[error("holds numbers of type {found}, and real and whole numbers of up to eight bytes are read")]
    Numbers {
        /// Their type, as NumPy writes it.
        found: String,
    },
    /// Its header says more than any memory holds.
    #[error("has a shape of {} numbers, larger than any memory", sizes(shape))]
    TooLarge {
        /// The shape.
        shape: Vec<usize>,
    },
    /// Its data are not those of its header.
    #[error(
        "holds {} bytes of data, which are not the {} numbers that its header says",
        found.map_or_else(|| String::from("more"), |found| found.to_string()), sizes(shape)
    )]
    WrongSize {
        /// Bytes found, where they are fewer than those of the header.
        found: Option<usize>,
        /// The shape.
        shape: Vec<usize>,
    },
    /// It holds texts.
    #[error("holds texts where numbers are needed")]
    Texts,
    /// It holds numbers that are no indices.
    #[error("holds numbers that are negative or not whole where indices are needed")]
    NotIndices,
}

/// `4 × 4`.
fn sizes(shape: &[usize]) -> String {
    shape.iter().map(usize::to_string).collect::<Vec<_>>().join(" × ")
}
