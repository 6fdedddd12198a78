//! Pictures and the page: figures as data, drawn and described, and one self-contained report.
//!
//! This crate knows no physics: it gets labels, arrays and colour roles. In the order in which the data flows:
//!
//! - [`figure`]: a figure as data: panels, layers; `axis`: their axes.
//! - [`runs`]: lines through rows of tables, broken wherever the next row does not go on from the one before.
//! - [`palette`]: colours, dashes and markers by meaning, the same in every picture.
//! - `validate`: whether arrays and ranges fit together; what is wrong is a [`ReportError`].
//! - `markup`, `typeface`: labels with sub- and superscripts and symbols; how wide they are.
//! - `scale`, `ticks`, `extent`: where values stand on an axis, where an axis is marked, what the data span.
//! - `second_axis`: a second scale along the upper side of a frame.
//! - `legend`, `corner`, `layout`: what is explained, where that hides no data, and where everything stands.
//! - `raster`: maps as little pictures, one pixel a cell.
//! - [`svg`], [`png`]: the figure as a drawing and as pixels.
//! - [`json`]: the figure for the one interactive chart, which is that of the page of `judder explore`.
//! - [`page`]: sections of text, figures, tables, scoreboards and checks as one HTML file.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]
#![cfg_attr(
    not(test),
    deny(clippy::indexing_slicing, reason = "arrays of stored studies may be of any length")
)]

mod axis;
mod corner;
mod error;
mod extent;
pub mod figure;
mod layout;
mod legend;
mod markup;
pub mod page;
pub mod palette;
mod png;
mod raster;
pub mod runs;
mod scale;
mod second_axis;
#[cfg(test)]
mod shared;
mod svg;
mod ticks;
mod typeface;
mod validate;
mod wire;

pub use axis::{Axis, Scale};
pub use error::{PanelError, ReportError};
pub use figure::{Figure, Layer, Legend, Panel, SecondAxis, Swing};
pub use page::{Page, PageBlock, PageSection, UndrawnFigure, html};
pub use palette::{Role, Style};
pub use png::png;
pub use svg::svg;
pub use typeface::web_font;
pub use wire::json;
