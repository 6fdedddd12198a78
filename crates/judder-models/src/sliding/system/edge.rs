//! The contact edge of a track: its nodes in order, its direction, and on which side of it the slider lies.

use super::nodes::SystemNodes;
use super::{Uncoupled, part};
use crate::structure::build::Structure;
use judder_numerics::order::sort_by_number;
use judder_numerics::words::plain;
use judder_sliding::plane::PlaneVector;

/// A track's edge.
pub(super) struct TrackEdge {
    /// Its nodes, from which positions count.
    pub(super) points: Vec<usize>,
    /// Unit vector from the first to the last.
    pub(super) direction: PlaneVector,
    /// Whether the slider lies to the left of that direction.
    pub(super) is_left: bool,
    /// What was decided.
    pub(super) warnings: Vec<String>,
}

/// A body whose middle is nearer to the edge than this share of the edge's length lies on neither side of it.
const BESIDE: f64 = 1e-9;

impl TrackEdge {
    /// The edge of a slider's track.
    pub(super) fn new([slider, track]: [&Structure; 2], nodes: &SystemNodes) -> Result<Self, Uncoupled> {
        let mut points = nodes.track.clone();
        let mut warnings = Vec::new();
        let places = |points: &[usize]| points.iter().map(|at| part::place(track, *at)).collect::<Vec<_>>();
        if !is_ordered(&places(&points)) {
            sort_along(&mut points, track);
            if let (Some(first), true) = (points.first(), is_ordered(&places(&points))) {
                let [x, y] = part::place(track, *first);
                warnings.push(format!(
                    "the nodes of the track do not follow each other in their set: they are taken in the order along the edge, and \
                     positions count from ({}, {}) m",
                    plain(x),
                    plain(y)
                ));
            } else {
                points.clone_from(&nodes.track);
            }
        }
        let places = places(&points);
        let direction = match places[..] {
            [first, .., last] => direction([last[0] - first[0], last[1] - first[1]]),
            // too short: the pair says so
            _ => [1.0, 0.0],
        };
        let is_left = is_left([slider, track], nodes.contact, &places, direction, &mut warnings)?;
        Ok(Self { points, direction, is_left, warnings })
    }
}

fn direction(chord: PlaneVector) -> PlaneVector {
    let length = libm::hypot(chord[0], chord[1]);
    if length > 0.0 { [chord[0] / length, chord[1] / length] } else { [1.0, 0.0] }
}

/// Whether every node lies beyond the one before, along the line from the first to the last.
fn is_ordered(places: &[PlaneVector]) -> bool {
    let [first, .., last] = places else { return true };
    let along = direction([last[0] - first[0], last[1] - first[1]]);
    places
        .windows(2)
        .all(|pair| (pair[1][0] - pair[0][0]) * along[0] + (pair[1][1] - pair[0][1]) * along[1] > 0.0)
}

/// Sorts nodes along the line to which they lie nearest, towards +x, or +y where it is upright.
fn sort_along(points: &mut [usize], track: &Structure) {
    let places: Vec<PlaneVector> = points.iter().map(|at| part::place(track, *at)).collect();
    let middle = mean(places.iter().copied());
    let moment = |i: usize, j: usize| -> f64 {
        places.iter().map(|place| (place[i] - middle[i]) * (place[j] - middle[j])).sum()
    };
    let angle = 0.5 * libm::atan2(2.0 * moment(0, 1), moment(0, 0) - moment(1, 1));
    let (sin, cos) = libm::sincos(angle);
    let sign = if cos < -1e-9 || (cos.abs() <= 1e-9 && sin < 0.0) { -1.0 } else { 1.0 };
    let along = |at: &usize| {
        let [x, y] = part::place(track, *at);
        sign * (x * cos + y * sin)
    };
    sort_by_number(points, along);
}

fn mean(places: impl Iterator<Item = PlaneVector>) -> PlaneVector {
    let (sum, count) = places.fold(([0.0; 2], 0.0_f64), |(sum, count), place| {
        ([sum[0] + place[0], sum[1] + place[1]], count + 1.0)
    });
    [sum[0] / count.max(1.0), sum[1] / count.max(1.0)]
}

/// On which side the slider lies: that of its middle beside C, or where this says nothing the one away from the track's own middle.
fn is_left(
    [slider, track]: [&Structure; 2],
    contact: usize,
    places: &[PlaneVector],
    direction: PlaneVector,
    warnings: &mut Vec<String>,
) -> Result<bool, Uncoupled> {
    let length = match places {
        [first, .., last] => libm::hypot(last[0] - first[0], last[1] - first[1]),
        _ => 0.0,
    };
    let across = |to: PlaneVector, from: PlaneVector| {
        let away = direction[0] * (to[1] - from[1]) - direction[1] * (to[0] - from[0]);
        if away.abs() > BESIDE * length { away } else { 0.0 }
    };
    let of_slider = across(middle(slider), part::place(slider, contact));
    let of_track = across(mean(places.iter().copied()), middle(track));
    if of_slider * of_track < 0.0 {
        warnings.push(
            "slider and track lie on the same side of the contact edge: C is taken to touch the side on which the slider lies"
                .to_owned(),
        );
    }
    match (of_slider, of_track) {
        (side, _) if side != 0.0 => Ok(side > 0.0),
        (_, side) if side != 0.0 => Ok(side > 0.0),
        _ => Err(Uncoupled::because(
            "contact.track",
            "nothing tells on which side of the track the slider lies: the middles of both lie on the edge",
            "let the slider stand beside the edge, on the side that it touches",
        )),
    }
}

fn middle(structure: &Structure) -> PlaneVector {
    let points = structure.layout.iter().flat_map(|layout| layout.points.iter());
    mean(points.map(|[x, y, _]| [*x, *y]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nodes_follow_each_other_or_do_not() {
        let straight: Vec<PlaneVector> = (0..5).map(|k| [f64::from(k), 0.5 * f64::from(k)]).collect();
        assert!(is_ordered(&straight));
        let mut swapped = straight.clone();
        swapped.swap(1, 2);
        assert!(!is_ordered(&swapped));
        // both ends first, as mesh generators number them
        let ends: Vec<PlaneVector> = [0, 4, 1, 2, 3].map(|k: usize| straight[k]).to_vec();
        assert!(!is_ordered(&ends));
    }
}
