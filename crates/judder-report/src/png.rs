//! A figure as pixels.

use crate::error::ReportError;
use crate::figure::Figure;
use crate::svg::svg;
use crate::typeface::{BOLD, ITALIC, REGULAR};
use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{ImageHrefResolver, ImageKind, Options, Tree, fontdb};
use std::collections::BTreeMap;
use std::fmt::Write;
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
        image_href_resolver: ImageHrefResolver {
            resolve_data: Box::new(|_, bytes, _| traced(&bytes)),
            resolve_string: Box::new(|_, _| None),
        },
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

/// A map as a drawing of its cells: for embedded pictures resvg brings decoders of formats that no figure has.
fn traced(png: &[u8]) -> Option<ImageKind> {
    let picture = Pixmap::decode_png(png).ok()?;
    let (width, height) = (picture.width(), picture.height());
    let mut shapes: BTreeMap<[u8; 3], String> = BTreeMap::new();
    for (y, row) in picture.pixels().chunks(width as usize).enumerate() {
        let mut x = 0;
        for run in row.chunk_by(PartialEq::eq) {
            let (Some(colour), cells) = (run.first(), run.len()) else { continue };
            if colour.is_opaque() {
                let shape = shapes.entry([colour.red(), colour.green(), colour.blue()]).or_default();
                write!(shape, "M{x} {y}h{cells}v1h-{cells}z").ok()?;
            }
            x += cells;
        }
    }
    let mut text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" shape-rendering=\"crispEdges\">"
    );
    for ([red, green, blue], shape) in shapes {
        write!(text, "<path fill=\"rgb({red},{green},{blue})\" d=\"{shape}\"/>").ok()?;
    }
    text.push_str("</svg>");
    Tree::from_str(&text, &Options::default()).ok().map(ImageKind::SVG)
}
