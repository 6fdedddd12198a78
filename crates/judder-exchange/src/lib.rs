//! The doors to other programs: their matrices and meshes in, shapes and test data out.
//!
//! - [`matrix`]: sparse matrices of Matrix Market, Abaqus, MATLAB and SciPy; [`system`] checks that they make one.
//! - [`mesh_file`]: meshes of Gmsh, Abaqus and CalculiX, with sets, materials and sections.
//! - [`freedom_table`]: what the rows of such matrices are.

mod bytes;
mod cause;
mod error;
pub mod freedom_table;
pub mod matrix;
mod matrix_market;
pub mod mesh_file;
mod npy;
mod quoted;
pub mod system;
mod text;

pub use cause::Cause;
pub use error::{ExchangeError, Place};
