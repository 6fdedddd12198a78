//! The doors to other programs: their matrices, meshes, heights and moduli in, shapes, test data and sound out.
//!
//! - [`matrix`]: sparse matrices of Matrix Market, Abaqus, MATLAB and SciPy; [`system`] checks that they make one.
//! - [`mesh_file`]: meshes of Gmsh, Abaqus and CalculiX, with sets, materials and sections.
//! - [`freedom_table`]: what the rows of such matrices are.
//! - [`heights`]: surfaces of NumPy, text and NetCDF; [`dma_table`]: measured moduli; [`number_table`]: signals over time and other tables of numbers.
//! - [`geometry`]: what is drawn, with displacements at its nodes; [`vtu`] writes it for ParaView, [`square_cells`] fields on a plane of cells, [`universal`] for test engineers.
//! - [`wav`]: signals as sound.
//! - [`matrix_market`]: matrices for other programs; [`whole_file`]: files whole or not at all.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod bytes;
mod cause;
pub mod dma_table;
mod door;
mod error;
mod fields;
pub mod freedom_table;
pub mod geometry;
pub mod heights;
pub mod matrix;
pub mod mesh_file;
mod npy;
pub mod number_table;
mod quoted;
pub mod square_cells;
pub mod system;
mod text;
mod triangle;
pub mod universal;
pub mod vtu;
pub mod wav;
pub mod whole_file;

pub use cause::FileCause;
pub use error::{ExchangeError, FilePlace};
pub use matrix::matrix_market;
pub use npy::NpyError;

#[cfg(doctest)]
#[doc = include_str!("../../../docs/src/files.md")]
mod chapter_of_the_book {}
