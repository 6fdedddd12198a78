//! Stability over two keys.

#![deny(clippy::indexing_slicing, reason = "stored arrays may be of any length")]

use super::point::PointVerdict;
use crate::oscillator::stability_map::figure::ascending;
use judder_report::figure::Class;
use judder_report::{Layer, Panel, Role};
use judder_study::pictures::{StoredArrays, axis, codes, reals, shown};

/// Verdicts by colour, the located boundary on top.
pub(super) fn stability_map(dataset: &StoredArrays<'_>) -> Option<Vec<Panel>> {
    dataset.over("stability", &["y", "x"])?;
    for name in ["boundary_x", "boundary_y"] {
        dataset.over(name, &["boundary_point"])?;
    }
    let codes = codes(dataset, "stability")?;
    let (x, y) = (dataset.variable("x")?, dataset.variable("y")?);
    let drawn: Vec<PointVerdict> =
        PointVerdict::ALL.into_iter().filter(|own| codes.contains(&own.code())).collect();
    let place = |code: &u8| drawn.iter().position(|own| own.code() == *code).unwrap_or_default() as u8;
    let places: Vec<u8> = codes.iter().map(place).collect();
    let classes = drawn.iter().map(|own| Class::new(own.words(), own.role())).collect();
    let map = ascending(&shown(x, reals(dataset, "x")?), &shown(y, reals(dataset, "y")?), &places, classes);
    let mut layers = vec![Layer::Classes(map)];
    let (across, up) = (reals(dataset, "boundary_x")?, reals(dataset, "boundary_y")?);
    if !across.is_empty() {
        let (across, up) = (shown(x, across).into_owned(), shown(y, up).into_owned());
        layers.push(Layer::points("boundary", across, up, Role::FullBoundary));
    }
    Some(vec![Panel::new(axis(x), axis(y), layers)])
}
