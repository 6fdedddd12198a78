//! The contact edge of a track: its interpolation between nodes, and the place where the slider touches it.

use crate::plane::{PlaneVector, dot, length, minus, plus, turned};
use std::cmp::Ordering;
use std::fmt;

/// Nodes that an interpolation uses at most.
pub const STENCIL: usize = 4;

/// How the edge runs between its nodes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "keys", derive(judder_keys::Choice), choice(what = "interpolation"))]
pub enum Interpolation {
    /// Straight: the slope jumps at a node.
    ///
    /// So does the contact row.
    #[default]
    Linear,
    /// Cubic, with continuous slope.
    ///
    /// C¹: with the slope of the chord between a node's neighbours (Hermite; Catmull and Rom).
    Hermite,
}

impl fmt::Display for Interpolation {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            Self::Linear => "linear",
            Self::Hermite => "hermite",
        })
    }
}

/// A place on the edge: a segment, counted from 0, and how far along it, from 0 to 1.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct EdgePoint {
    /// From node `segment` to the next.
    pub segment: usize,
    /// ξ.
    pub fraction: f64,
}

impl EdgePoint {
    /// The place of another segment that is nearest to this one: of a neighbour, the node that both share.
    #[inline]
    #[must_use]
    pub fn seen_from(self, segment: usize) -> Self {
        match segment.cmp(&self.segment) {
            Ordering::Equal => self,
            Ordering::Greater => Self { segment, fraction: 0.0 },
            Ordering::Less => Self { segment, fraction: 1.0 },
        }
    }
}

/// Weights of the nodes of a stencil: P = Σ w_k x_k, and its derivatives by ξ.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Weights {
    /// w.
    pub value: [f64; STENCIL],
    /// dw/dξ.
    pub slope: [f64; STENCIL],
    /// d²w/dξ².
    pub bend: [f64; STENCIL],
}

/// Where and how a point touches the edge.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Touch {
    /// The place on the edge that is nearest.
    pub at: EdgePoint,
    /// Weights of the stencil's nodes there.
    pub weights: Weights,
    /// Unit tangent, from node to node.
    pub tangent: PlaneVector,
    /// Unit normal, towards the slider.
    pub normal: PlaneVector,
    /// |dP/dξ|, m.
    pub stretch: f64,
    /// dθ/dξ: how fast the tangent turns to the left.
    pub turn: f64,
    /// n·(x_C − P), m: negative where the point is inside the track.
    pub gap: f64,
}

/// The point has run off an end of the edge.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RunOff {
    /// That of its first node.
    First,
    /// That of its last node.
    Last,
}

impl fmt::Display for RunOff {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            Self::First => "run off the track beyond its first node",
            Self::Last => "run off the track beyond its last node",
        })
    }
}

/// An edge of so many nodes, without their places.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Edge {
    /// How it runs between nodes.
    pub interpolation: Interpolation,
    /// How many nodes it has.
    pub nodes: usize,
    /// 1 where the slider lies to the left of the edge's direction, −1 where it lies to the right.
    pub side: f64,
}

/// Newton steps for the nearest place of a cubic segment; they start within a step of it.
const NEWTON_STEPS: usize = 8;

impl Edge {
    /// That of so many nodes; fewer than a smooth one needs run straight.
    #[must_use]
    pub fn new(interpolation: Interpolation, nodes: usize, is_left: bool) -> Self {
        let interpolation = if nodes < STENCIL { Interpolation::Linear } else { interpolation };
        Self { interpolation, nodes, side: if is_left { 1.0 } else { -1.0 } }
    }

    /// How many nodes a stencil has.
    #[must_use]
    pub fn stencil_nodes(&self) -> usize {
        match self.interpolation {
            Interpolation::Linear => 2,
            Interpolation::Hermite => STENCIL.min(self.nodes),
        }
    }

    /// Whether its normal may jump at a node.
    pub(crate) fn has_corners(&self) -> bool {
        self.interpolation == Interpolation::Linear
    }

    /// The first node of a segment's stencil.
    #[inline]
    #[must_use]
    pub fn first_node(&self, segment: usize) -> usize {
        match self.interpolation {
            Interpolation::Linear => segment,
            Interpolation::Hermite => segment.saturating_sub(1).min(self.nodes.saturating_sub(STENCIL)),
        }
    }

    /// Weights of the stencil's nodes.
    #[inline]
    #[must_use]
    pub fn weights(&self, at: EdgePoint) -> Weights {
        let x = at.fraction;
        match self.interpolation {
            Interpolation::Linear => {
                Weights { value: [1.0 - x, x, 0.0, 0.0], slope: [-1.0, 1.0, 0.0, 0.0], bend: [0.0; STENCIL] }
            }
            Interpolation::Hermite => self.cubic_weights(at.segment, x),
        }
    }

    fn cubic_weights(&self, segment: usize, x: f64) -> Weights {
        // the basis on values at both ends, then slopes at both ends
        let value = [
            (2.0 * x - 3.0) * x * x + 1.0,
            (3.0 - 2.0 * x) * x * x,
            ((x - 2.0) * x + 1.0) * x,
            (x - 1.0) * x * x,
        ];
        let slope =
            [6.0 * (x - 1.0) * x, 6.0 * (1.0 - x) * x, (3.0 * x - 4.0) * x + 1.0, (3.0 * x - 2.0) * x];
        let bend = [12.0 * x - 6.0, 6.0 - 12.0 * x, 6.0 * x - 4.0, 6.0 * x - 2.0];
        let first = self.first_node(segment);
        let mut weights = Weights::default();
        let mut add = |node: usize, factors: [f64; 4]| {
            let sum = |basis: &[f64; 4]| basis.iter().zip(factors).map(|(b, f)| b * f).sum::<f64>();
            weights.value[node - first] += sum(&value);
            weights.slope[node - first] += sum(&slope);
            weights.bend[node - first] += sum(&bend);
        };
        add(segment, [1.0, 0.0, 0.0, 0.0]);
        add(segment + 1, [0.0, 1.0, 0.0, 0.0]);
        for (end, node) in [segment, segment + 1].into_iter().enumerate() {
            let (before, after) = (node.saturating_sub(1), (node + 1).min(self.nodes - 1));
            let share = 1.0 / (after - before) as f64;
            let along =
                |factor: f64| if end == 0 { [0.0, 0.0, factor, 0.0] } else { [0.0, 0.0, 0.0, factor] };
            add(after, along(share));
            add(before, along(-share));
        }
        weights
    }

    /// The place of the edge that is nearest to `point`, sought from `from` on; `nodes` gives the places of a segment's stencil.
    ///
    /// # Errors
    /// [`RunOff`] where the point lies beyond an end.
    #[inline]
    pub fn touch(
        &self,
        point: PlaneVector,
        from: EdgePoint,
        mut nodes: impl FnMut(usize) -> [PlaneVector; STENCIL],
    ) -> Result<Touch, RunOff> {
        let last = self.nodes - 2;
        let mut at = EdgePoint { segment: from.segment.min(last), ..from };
        let mut came_from = at.segment;
        let mut places = nodes(at.segment);
        loop {
            at.fraction = self.nearest(point, at, &places);
            let next = if at.fraction > 1.0 {
                at.segment + 1
            } else if at.fraction < 0.0 {
                at.segment.wrapping_sub(1)
            } else {
                break;
            };
            // an outer corner: the nearest place is the node that both segments share
            if next == came_from && came_from != at.segment {
                at.fraction = at.fraction.clamp(0.0, 1.0);
                break;
            }
            if next > last {
                return Err(if at.fraction < 0.0 { RunOff::First } else { RunOff::Last });
            }
            came_from = at.segment;
            at = EdgePoint { segment: next, fraction: if next > at.segment { 0.0 } else { 1.0 } };
            places = nodes(next);
        }
        Ok(self.touch_at(point, at, &places))
    }

    /// How a point touches the edge at a given place of it.
    #[inline]
    #[must_use]
    pub fn touch_at(&self, point: PlaneVector, at: EdgePoint, places: &[PlaneVector; STENCIL]) -> Touch {
        let weights = self.weights(at);
        let along = combined(&weights.slope, places);
        let stretch = length(along);
        let tangent = [along[0] / stretch, along[1] / stretch];
        let left = turned(tangent);
        let normal = [self.side * left[0], self.side * left[1]];
        let gap = dot(normal, minus(point, combined(&weights.value, places)));
        let turn = dot(left, combined(&weights.bend, places)) / stretch;
        Touch { at, weights, tangent, normal, stretch, turn, gap }
    }

    /// ξ of the place of a segment, continued beyond its ends, that is nearest to `point`.
    #[inline]
    pub(crate) fn nearest(
        &self,
        point: PlaneVector,
        from: EdgePoint,
        places: &[PlaneVector; STENCIL],
    ) -> f64 {
        match self.interpolation {
            Interpolation::Linear => {
                let along = minus(places[1], places[0]);
                dot(minus(point, places[0]), along) / dot(along, along)
            }
            Interpolation::Hermite => {
                let mut fraction = from.fraction;
                for _ in 0..NEWTON_STEPS {
                    let weights = self.cubic_weights(from.segment, fraction);
                    let away = minus(point, combined(&weights.value, places));
                    let along = combined(&weights.slope, places);
                    let bend = combined(&weights.bend, places);
                    let step = dot(away, along) / (dot(along, along) - dot(away, bend));
                    fraction = (fraction + step).clamp(-1.0, 2.0);
                    if step.abs() < f64::EPSILON {
                        break;
                    }
                }
                fraction
            }
        }
    }
}

/// Σ w_k x_k.
#[inline(always)]
#[must_use]
pub fn combined(weights: &[f64; STENCIL], places: &[PlaneVector; STENCIL]) -> PlaneVector {
    (0..STENCIL).fold([0.0; 2], |sum, k| plus(sum, weights[k], places[k]))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Nodes on a circle of radius 10.
    fn arc(nodes: usize) -> Vec<PlaneVector> {
        (0..nodes)
            .map(|k| 0.1 * k as f64)
            .map(|angle| [10.0 * f64::sin(angle), 10.0 * f64::cos(angle)])
            .collect()
    }

    fn edge(interpolation: Interpolation, nodes: usize) -> Edge {
        Edge { interpolation, nodes, side: 1.0 }
    }

    fn places(edge: Edge, nodes: &[PlaneVector]) -> impl Fn(usize) -> [PlaneVector; STENCIL] {
        move |segment| {
            let first = edge.first_node(segment);
            std::array::from_fn(|k| nodes.get(first + k).copied().unwrap_or_default())
        }
    }

    /// Both pass through the nodes, and their weights sum to one with slopes that sum to zero.
    #[test]
    fn weights_make_one() {
        for interpolation in [Interpolation::Linear, Interpolation::Hermite] {
            let edge = edge(interpolation, 7);
            for segment in 0..6 {
                for fraction in [0.0, 0.3, 0.5, 1.0] {
                    let Weights { value, slope, bend } = edge.weights(EdgePoint { segment, fraction });
                    assert!((value.iter().sum::<f64>() - 1.0).abs() < 1e-15);
                    assert!(
                        slope.iter().sum::<f64>().abs() < 1e-15 && bend.iter().sum::<f64>().abs() < 1e-14
                    );
                }
                let node = edge.weights(EdgePoint { segment, fraction: 0.0 }).value;
                assert_eq!(node[segment - edge.first_node(segment)], 1.0);
            }
        }
    }

    /// At a node the cubic edge has one slope from both sides, the straight one has two.
    #[test]
    fn hermite_is_smooth_at_nodes() {
        let nodes = arc(7);
        let slope = |edge: Edge, segment, fraction| {
            let weights = edge.weights(EdgePoint { segment, fraction });
            combined(&weights.slope, &places(edge, &nodes)(segment))
        };
        for (interpolation, is_smooth) in [(Interpolation::Linear, false), (Interpolation::Hermite, true)] {
            let edge = edge(interpolation, 7);
            for segment in 0..5 {
                let jump = length(minus(slope(edge, segment, 1.0), slope(edge, segment + 1, 0.0)));
                assert_eq!(jump < 1e-14, is_smooth, "{interpolation} {segment}: {jump}");
            }
        }
    }

    /// A point above the arc touches it where the radius through the point meets it, from whichever segment the search starts.
    #[test]
    fn the_nearest_place_is_found_from_anywhere() {
        let nodes = arc(7);
        for (interpolation, tolerance) in [(Interpolation::Linear, 2e-2), (Interpolation::Hermite, 2e-4)] {
            let edge = edge(interpolation, 7);
            for angle in [0.15_f64, 0.2, 0.33, 0.471] {
                for start in 0..6 {
                    let point = [10.5 * angle.sin(), 10.5 * angle.cos()];
                    let from = EdgePoint { segment: start, fraction: 0.5 };
                    let touch = edge.touch(point, from, places(edge, &nodes)).unwrap();
                    assert!((touch.gap - 0.5).abs() < 2e-2, "{interpolation} {angle} {start}: {touch:?}");
                    let found = 0.1 * (touch.at.segment as f64 + touch.at.fraction);
                    assert!((found - angle).abs() < tolerance, "{interpolation} {angle} {start}: {found}");
                }
            }
        }
    }

    /// Over an outer corner the nearest place is the corner itself.
    #[test]
    fn a_corner_is_touched_at_its_node() {
        let nodes = [[0.0, 0.0], [1.0, 0.0], [2.0, -1.0]];
        let edge = edge(Interpolation::Linear, 3);
        for segment in [0, 1] {
            let touch =
                edge.touch([1.1, 0.5], EdgePoint { segment, fraction: 0.5 }, places(edge, &nodes)).unwrap();
            let place = combined(&touch.weights.value, &places(edge, &nodes)(touch.at.segment));
            assert!(length(minus(place, [1.0, 0.0])) < 1e-15, "{touch:?}");
        }
    }

    #[test]
    fn beyond_an_end_is_off() {
        let nodes = arc(5);
        let edge = edge(Interpolation::Linear, 5);
        let from = EdgePoint { segment: 2, fraction: 0.0 };
        assert_eq!(edge.touch([-1.0, 10.0], from, places(edge, &nodes)), Err(RunOff::First));
        assert_eq!(edge.touch([6.0, 9.0], from, places(edge, &nodes)), Err(RunOff::Last));
    }
}
