//! What presses on the substrate: shapes in closed form, measured height maps, generated rough surfaces.
//!
//! - [`shape`]: the indenters by name, as a height over every point.
//! - [`height_map`]: heights on a lattice, interpolated between its points.
//! - [`mod@height_table`]: the numbers of a file before they become a map.
//! - [`height_file`]: which reader serves the bytes of which file.
//! - [`npy`], [`text_matrix`], [`netcdf`]: the readers, from bytes.
//! - [`rough`]: generated self-affine surfaces.

pub mod error;
pub mod height_file;
pub mod height_map;
pub mod height_table;
pub mod netcdf;
pub mod npy;
pub mod rough;
pub mod shape;
pub mod text_matrix;

pub use error::IndenterError;
pub use height_file::height_table;
pub use height_map::HeightMap;
pub use height_table::HeightTable;
pub use rough::{RoughSurface, Roughness};
pub use shape::Shape;
