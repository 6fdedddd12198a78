//! What presses on the substrate: shapes in closed form, measured height maps, generated rough surfaces.
//!
//! - [`shape`]: the indenters by name, as a height over every point.
//! - [`height_map`]: heights on a lattice, interpolated between its points.
//! - [`rough`]: generated self-affine surfaces.

pub mod error;
pub mod height_map;
pub mod rough;
pub mod shape;

pub use error::IndenterError;
pub use height_map::HeightMap;
pub use rough::{RoughSurface, Roughness};
pub use shape::IndenterShape;
