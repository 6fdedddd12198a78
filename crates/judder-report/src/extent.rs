//! What layers span, for axes that take their range from the data.

use crate::figure::{Direction, Layer, Rule};

/// What a layer spans along x.
pub(crate) fn abscissae(layer: &Layer) -> Box<dyn Iterator<Item = f64> + '_> {
    match layer {
        // a point without an ordinate is not drawn, so it does not widen the axis either
        Layer::Line(line) | Layer::Points(line) => {
            Box::new(line.x.iter().zip(&line.y).filter(|(_, y)| y.is_finite()).map(|(x, _)| *x))
        }
        Layer::Classes(map) => Box::new(map.x.iter().copied()),
        Layer::Values(map) => Box::new(map.x.iter().copied()),
        Layer::Rule(Rule { direction: Direction::Vertical, value, .. }) => Box::new(std::iter::once(*value)),
        Layer::Rule(_) => Box::new(std::iter::empty()),
        Layer::Region(region) => Box::new(region.x.into_iter().flat_map(|(from, to)| [from, to])),
        Layer::Note(note) => Box::new(std::iter::once(note.x)),
    }
}

/// What a layer spans along y.
pub(crate) fn ordinates(layer: &Layer) -> Box<dyn Iterator<Item = f64> + '_> {
    match layer {
        Layer::Line(line) | Layer::Points(line) => {
            Box::new(line.y.iter().zip(&line.x).filter(|(_, x)| x.is_finite()).map(|(y, _)| *y))
        }
        Layer::Classes(map) => Box::new(map.y.iter().copied()),
        Layer::Values(map) => Box::new(map.y.iter().copied()),
        Layer::Rule(Rule { direction: Direction::Horizontal, value, .. }) => {
            Box::new(std::iter::once(*value))
        }
        Layer::Rule(_) => Box::new(std::iter::empty()),
        Layer::Region(region) => Box::new(region.y.into_iter().flat_map(|(from, to)| [from, to])),
        Layer::Note(note) => Box::new(std::iter::once(note.y)),
    }
}
