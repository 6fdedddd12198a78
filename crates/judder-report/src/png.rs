//! A figure as pixels.

use crate::error::ReportError;
use crate::figure::Figure;
use crate::svg::svg;
use crate::typeface::{BOLD, ITALIC, REGULAR};
use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{Options, Tree, fontdb};
use std::sync::{Arc, LazyLock};

/// Pixels along the longer side that are still made.
const LARGEST: f64 = 16384.0;

/// The bundled fonts: no text depends on what the machine has installed.
static FONTS: LazyLock<Arc<fontdb::Database>> = LazyLock::new(|| {
    let mut fonts = fontdb::Database::new();
    for font in [REGULAR, ITALIC, BOLD] {
        fonts.load_font_data(font.to_vec());
    }
    fonts.set_sans_serif_family("Noto Sans");
    Arc::new(fonts)
});

/// The figure as a PNG with `scale` pixels per point (1/72 inch): 4 gives 288 dots per inch.
///
/// # Errors
/// As [`svg`], and [`ReportError::PictureSize`] where a side would not lie in 1..=16384 pixels.
pub fn png(figure: &Figure, scale: f64) -> Result<Vec<u8>, ReportError> {
    let failed = |reason: String| ReportError::Raster { figure: figure.name.clone(), reason };
    let text = svg(figure)?;
    let options = Options {
        fontdb: Arc::clone(&FONTS),
        font_family: "Noto Sans".to_owned(),
        // a unit of the drawing is a point, so that the size of the tree is in points too
        dpi: 72.0,
        ..Options::default()
    };
    let tree = Tree::from_str(&text, &options).map_err(|error| failed(error.to_string()))?;
    let size = tree.size();
    let (width, height) =
        ((f64::from(size.width()) * scale).round(), (f64::from(size.height()) * scale).round());
    if !(1.0..=LARGEST).contains(&width) || !(1.0..=LARGEST).contains(&height) {
        return Err(ReportError::PictureSize { width, height });
    }
    let mut pixels =
        Pixmap::new(width as u32, height as u32).ok_or(ReportError::PictureSize { width, height })?;
    resvg::render(&tree, Transform::from_scale(scale as f32, scale as f32), &mut pixels.as_mut());
    pixels.encode_png().map_err(|error| failed(error.to_string()))
}
