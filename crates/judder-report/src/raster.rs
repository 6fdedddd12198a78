//! Maps as little pictures: one pixel a cell where the grid is even on its axes, resampled where it is not.

use crate::figure::{ClassMap, ValueMap};
use crate::palette::{Colour, Role};
use crate::scale::PlacedAxis;
use base64::{Engine, engine::general_purpose::STANDARD};

/// A picture and where it stands, as fractions of the frame (0 at the left and lower ends, 1 at the others).
#[derive(Debug, Clone)]
pub(crate) struct MapPicture {
    /// `data:image/png;base64,…`
    pub(crate) address: String,
    pub(crate) across: (f64, f64),
    pub(crate) up: (f64, f64),
}

/// Pixels along an axis whose cells are not even, or are more than this.
const RESAMPLED: usize = 2048;

/// The picture of a class map; unresolved cells are clear, so that the hatch under the picture shows.
pub(crate) fn classes(map: &ClassMap, x: &PlacedAxis, y: &PlacedAxis) -> Option<MapPicture> {
    let palette: Vec<[u8; 4]> =
        map.classes.iter().map(|class| opaque_unless_unresolved(class.role)).collect();
    picture(&map.x, &map.y, x, y, &palette, |cell| map.codes.get(cell).copied().unwrap_or(0))
}

fn opaque_unless_unresolved(role: Role) -> [u8; 4] {
    let Colour(red, green, blue) = role.colour();
    [red, green, blue, if role == Role::Unresolved { 0 } else { 255 }]
}

/// Cells of one class that stand in one column, one on the other, as fractions of the frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ClassColumn {
    pub(crate) across: (f64, f64),
    pub(crate) up: (f64, f64),
}

/// All cells of a class map that have this meaning.
pub(crate) fn blocks(map: &ClassMap, role: Role, x: &PlacedAxis, y: &PlacedAxis) -> Vec<ClassColumn> {
    let (Some(across), Some(up)) = (columns(&map.x, x), columns(&map.y, y)) else { return Vec::new() };
    let has_role = |column: usize, row: usize| {
        let code = map.codes.get(row * map.x.len() + column);
        code.and_then(|code| map.classes.get(usize::from(*code))).is_some_and(|class| class.role == role)
    };
    let edge = |line: &Columns, index: usize| {
        line.from + (line.to - line.from) * index as f64 / line.cells.len() as f64
    };
    // neighbouring columns that look alike are one block
    let runs = |column: usize| -> Vec<(usize, usize)> {
        let rows: Vec<bool> = up.cells.iter().map(|row| has_role(column, *row)).collect();
        let mut start = 0;
        let alike = rows.chunk_by(|one, next| one == next).map(|run| {
            let from = start;
            start += run.len();
            (run.first() == Some(&true)).then_some((from, start))
        });
        alike.flatten().collect()
    };
    let columns: Vec<Vec<(usize, usize)>> = across.cells.iter().map(|column| runs(*column)).collect();
    let mut blocks = Vec::new();
    let mut first = 0;
    for alike in columns.chunk_by(|a, b| a == b) {
        let span = (edge(&across, first), edge(&across, first + alike.len()));
        first += alike.len();
        blocks.extend(
            alike
                .first()
                .into_iter()
                .flatten()
                .map(|(from, to)| ClassColumn { across: span, up: (edge(&up, *from), edge(&up, *to)) }),
        );
    }
    blocks
}

/// The last index of a value map's palette: cells without a value.
const NO_VALUE: u8 = 255;

/// The picture of a value map in 255 shades over the range of its colour bar; cells without a value are clear.
pub(crate) fn values(map: &ValueMap, x: &PlacedAxis, y: &PlacedAxis, bar: &PlacedAxis) -> Option<MapPicture> {
    let shades = f64::from(NO_VALUE) - 1.0;
    let palette: Vec<[u8; 4]> = (0..=NO_VALUE)
        .map(|index| {
            let Colour(red, green, blue) = map.colours.at(f64::from(index) / shades);
            [red, green, blue, if index == NO_VALUE { 0 } else { 255 }]
        })
        .collect();
    picture(&map.x, &map.y, x, y, &palette, |cell| {
        let fraction = map.z.get(cell).and_then(|z| bar.fraction(*z));
        fraction.map_or(NO_VALUE, |fraction| (fraction.clamp(0.0, 1.0) * shades).round() as u8)
    })
}

/// Cells of a map along one axis: which one each pixel shows, and the fractions between which they stand.
struct Columns {
    cells: Vec<usize>,
    from: f64,
    to: f64,
}

/// `None` where there are no cells, or none in the frame.
fn columns(centres: &[f64], axis: &PlacedAxis) -> Option<Columns> {
    let places: Vec<f64> = centres.iter().filter_map(|centre| axis.fraction(*centre)).collect();
    let (&[first, second, ..], &[.., before, last]) = (places.as_slice(), places.as_slice()) else {
        let only = *places.first()?;
        return Some(Columns { cells: vec![0], from: only - 0.5, to: only + 0.5 });
    };
    let count = places.len();
    let mean = (last - first) / (count - 1) as f64;
    let pairs = || places.iter().zip(places.iter().skip(1));
    let even = pairs().all(|(one, next)| (next - one - mean).abs() <= 1e-3 * mean);
    let (from, to) = (first - (second - first) / 2.0, last + (last - before) / 2.0);
    if even && count <= RESAMPLED {
        return Some(Columns { cells: (0..count).collect(), from, to });
    }
    let edges: Vec<f64> = pairs().map(|(one, next)| (one + next) / 2.0).collect();
    // only what the frame shows, so that far cells do not coarsen the picture
    let (from, to) = (from.max(0.0), to.min(1.0));
    if from >= to {
        return None;
    }
    let cells = (0..RESAMPLED)
        .map(|pixel| {
            let place = from + (to - from) * (pixel as f64 + 0.5) / RESAMPLED as f64;
            edges.partition_point(|edge| *edge < place)
        })
        .collect();
    Some(Columns { cells, from, to })
}

fn picture(
    x: &[f64],
    y: &[f64],
    axis_x: &PlacedAxis,
    axis_y: &PlacedAxis,
    palette: &[[u8; 4]],
    index: impl Fn(usize) -> u8,
) -> Option<MapPicture> {
    let (across, up) = (columns(x, axis_x)?, columns(y, axis_y)?);
    // rows of a picture run down, those of a map up
    let pixels: Vec<u8> = up
        .cells
        .iter()
        .rev()
        .flat_map(|row| across.cells.iter().map(move |column| row * x.len() + column))
        .map(index)
        .collect();
    let png = indexed_png(across.cells.len(), up.cells.len(), &pixels, palette).ok()?;
    Some(MapPicture {
        address: format!("data:image/png;base64,{}", STANDARD.encode(png)),
        across: (across.from, across.to),
        up: (up.from, up.to),
    })
}

/// A palette picture, which for maps of few classes is a tenth of a full-colour one.
fn indexed_png(
    width: usize,
    height: usize,
    pixels: &[u8],
    palette: &[[u8; 4]],
) -> Result<Vec<u8>, png::EncodingError> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, width as u32, height as u32);
    encoder.set_color(png::ColorType::Indexed);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_palette(
        palette.iter().flat_map(|[red, green, blue, _]| [*red, *green, *blue]).collect::<Vec<u8>>(),
    );
    encoder.set_trns(palette.iter().map(|[.., alpha]| *alpha).collect::<Vec<u8>>());
    encoder.set_compression(png::Compression::High);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(pixels)?;
    writer.finish()?;
    Ok(bytes)
}

/// The colours of a colour bar from its lower to its upper end, as an upright picture.
pub(crate) fn bar(map: &ValueMap) -> Option<String> {
    let palette: Vec<[u8; 4]> = (0..=255_u8)
        .map(|index| {
            let Colour(red, green, blue) = map.colours.at(f64::from(index) / 255.0);
            [red, green, blue, 255]
        })
        .collect();
    let pixels: Vec<u8> = (0..=255).rev().collect();
    let png = indexed_png(1, pixels.len(), &pixels, &palette).ok()?;
    Some(format!("data:image/png;base64,{}", STANDARD.encode(png)))
}
