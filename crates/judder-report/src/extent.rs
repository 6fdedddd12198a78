//! What layers span, for axes that take their range from the data.

use crate::figure::{Layer, Rule, RuleDirection};

/// What a layer spans along x.
pub(crate) fn abscissae(layer: &Layer) -> Box<dyn Iterator<Item = f64> + '_> {
    match layer {
        // a point without an ordinate is not drawn, so it does not widen the axis either
        Layer::Line(line) | Layer::Points(line) => {
            let drawn = line.x.iter().zip(&line.y).filter(|(_, y)| y.is_finite()).map(|(x, _)| *x);
            Box::new(drawn.chain(line.swing.iter().flat_map(|swing| reach(&line.x, &swing.x))))
        }
        Layer::Classes(map) => Box::new(map.x.iter().copied()),
        Layer::Values(map) => Box::new(map.x.iter().copied()),
        Layer::Rule(Rule { direction: RuleDirection::Vertical, value, .. }) => {
            Box::new(std::iter::once(*value))
        }
        Layer::Rule(_) => Box::new(std::iter::empty()),
        Layer::Region(region) => Box::new(region.x.into_iter().flat_map(|(from, to)| [from, to])),
        Layer::Note(note) => Box::new(std::iter::once(note.x)),
    }
}

/// What a layer spans along y.
pub(crate) fn ordinates(layer: &Layer) -> Box<dyn Iterator<Item = f64> + '_> {
    match layer {
        Layer::Line(line) | Layer::Points(line) => {
            let drawn = line.y.iter().zip(&line.x).filter(|(_, x)| x.is_finite()).map(|(y, _)| *y);
            Box::new(drawn.chain(line.swing.iter().flat_map(|swing| reach(&line.y, &swing.y))))
        }
        Layer::Classes(map) => Box::new(map.y.iter().copied()),
        Layer::Values(map) => Box::new(map.y.iter().copied()),
        Layer::Rule(Rule { direction: RuleDirection::Horizontal, value, .. }) => {
            Box::new(std::iter::once(*value))
        }
        Layer::Rule(_) => Box::new(std::iter::empty()),
        Layer::Region(region) => Box::new(region.y.into_iter().flat_map(|(from, to)| [from, to])),
        Layer::Note(note) => Box::new(std::iter::once(note.y)),
    }
}

/// The furthest that swinging points come to both sides of their rest.
fn reach<'a>(drawn: &'a [f64], [real, imaginary]: &'a [Vec<f64>; 2]) -> impl Iterator<Item = f64> + 'a {
    drawn.iter().zip(real.iter().zip(imaginary)).flat_map(|(drawn, (a, b))| {
        let (rest, amplitude) = (drawn - a, libm::hypot(*a, *b));
        [rest - amplitude, rest + amplitude]
    })
}
