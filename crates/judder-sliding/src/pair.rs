//! A slider and its track.

use crate::SlidingError;
use crate::body::{Body, ModalPoint, finite};
use crate::edge::{Edge, EdgePoint, Interpolation, STENCIL, Touch};
use crate::plane::{PlaneVector, along_chord, dot, plus};
use judder_contact::friction::Friction;

/// The structure that carries the contact point C.
///
/// Its displacements are those relative to a frame that moves with the prescribed motion.
#[derive(Debug, Clone, PartialEq)]
pub struct Slider {
    /// Its modes.
    pub body: Body,
    /// C.
    pub contact: ModalPoint,
    /// Φᵀ f of a unit load where the slider is pressed, 1/√kg.
    pub load: Vec<f64>,
    /// Φᵀ M 1: what a unit acceleration of the frame along the track's direction pushes back, √kg.
    pub inertia: Vec<f64>,
}

/// The structure along which the slider moves.
#[derive(Debug, Clone, PartialEq)]
pub struct TrackBody {
    /// Its modes.
    pub body: Body,
    /// The nodes of its contact edge, in order.
    pub nodes: Vec<ModalPoint>,
}

/// Of which structure a point is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum PairSide {
    /// The slider.
    Slider,
    /// The track.
    Track,
}

/// A displacement that is watched.
#[derive(Debug, Clone, PartialEq)]
pub struct Observed {
    /// Of which structure.
    pub side: PairSide,
    /// Its row of Φ, 1/√kg.
    pub row: Vec<f64>,
    /// What a unit displacement of the slider's frame along the track's direction adds to it: 0 on the track.
    pub rigid: f64,
}

/// A slider on a track, with the friction between them.
///
/// Modal coordinates are those of the slider, then those of the track.
#[derive(Debug, Clone, PartialEq)]
pub struct Pair {
    slider: Slider,
    track: TrackBody,
    edge: Edge,
    friction: Friction,
    observed: Vec<Observed>,
    direction: PlaneVector,
    arc: Vec<f64>,
}

impl Pair {
    /// A slider to the left or right of an edge.
    ///
    /// `is_left` says on which side of the edge, seen from its first node to its last, the slider lies.
    ///
    /// # Errors
    /// [`SlidingError::InvalidNumber`] and [`SlidingError::Length`] for modes, rows and loads that are not finite or of the wrong
    /// length; [`SlidingError::ShortTrack`] and [`SlidingError::Unordered`] for an edge that is none.
    pub fn new(
        slider: Slider,
        track: TrackBody,
        interpolation: Interpolation,
        is_left: bool,
        friction: Friction,
        observed: Vec<Observed>,
    ) -> Result<Self, SlidingError> {
        slider.body.check("slider")?;
        track.body.check("track")?;
        slider.contact.check(slider.body.modes(), "the contact point")?;
        for (name, list) in [("the slider's load", &slider.load), ("the slider's inertia", &slider.inertia)] {
            expect_length(name, list.len(), slider.body.modes())?;
            finite(list.iter(), name)?;
        }
        for (k, node) in track.nodes.iter().enumerate() {
            node.check(track.body.modes(), &format!("node {k} of the track"))?;
        }
        for (k, point) in observed.iter().enumerate() {
            let modes = if point.side == PairSide::Slider { slider.body.modes() } else { track.body.modes() };
            expect_length(&format!("observed displacement {k}"), point.row.len(), modes)?;
            finite(point.row.iter(), &format!("observed displacement {k}"))?;
        }
        friction.check()?;
        let places: Vec<PlaneVector> = track.nodes.iter().map(|node| node.place).collect();
        let (arc, direction) = along_chord(&places)?;
        let edge = Edge::new(interpolation, places.len(), is_left);
        Ok(Self { slider, track, edge, friction, observed, direction, arc })
    }

    /// The structure that slides.
    #[must_use]
    pub fn slider(&self) -> &Slider {
        &self.slider
    }

    /// The structure on which it slides.
    #[must_use]
    pub fn track(&self) -> &TrackBody {
        &self.track
    }

    /// The contact edge.
    #[must_use]
    pub fn edge(&self) -> Edge {
        self.edge
    }

    /// The friction between them.
    #[must_use]
    pub fn friction(&self) -> &Friction {
        &self.friction
    }

    /// The displacements that are watched.
    #[must_use]
    pub fn observed(&self) -> &[Observed] {
        &self.observed
    }

    /// Unit vector from the track's first node to its last: along it the slider's frame moves.
    #[must_use]
    pub fn direction(&self) -> PlaneVector {
        self.direction
    }

    /// Modes of both.
    #[must_use]
    pub fn modes(&self) -> usize {
        self.slider.body.modes() + self.track.body.modes()
    }

    /// λ of all modes, 1/s².
    #[must_use]
    pub fn eigenvalues(&self) -> Vec<f64> {
        [&self.slider.body, &self.track.body]
            .iter()
            .flat_map(|body| body.eigenvalues.iter().copied())
            .collect()
    }

    /// α + β λ of all modes, 1/s.
    #[must_use]
    pub fn damping(&self) -> Vec<f64> {
        let of = |body: &Body| (0..body.modes()).map(|mode| body.damping(mode)).collect::<Vec<_>>();
        [of(&self.slider.body), of(&self.track.body)].concat()
    }

    /// Distances of the track's nodes from its first, measured along the prescribed motion, m.
    #[must_use]
    pub fn node_positions(&self) -> &[f64] {
        &self.arc
    }

    /// Distance of the track's last node from its first, along the prescribed motion, m.
    #[must_use]
    pub fn length(&self) -> f64 {
        self.arc.last().copied().unwrap_or_default()
    }

    /// Where C is, undeformed, when it has been moved so far from the track's first node.
    #[inline]
    #[must_use]
    pub fn rigid_place(&self, position: f64) -> PlaneVector {
        plus(self.track.nodes[0].place, position, self.direction)
    }

    /// The segment of the undeformed edge over which the position lies, and how far along it.
    ///
    /// # Errors
    /// [`SlidingError::OffTrack`] for a position before the first node or after the last.
    pub fn edge_point(&self, position: f64) -> Result<EdgePoint, SlidingError> {
        let last = self.arc.len() - 1;
        if !(position >= 0.0 && position <= self.arc[last]) {
            return Err(SlidingError::OffTrack { position, length: self.arc[last] });
        }
        let segment = self.arc.partition_point(|node| *node <= position).clamp(1, last) - 1;
        let fraction = (position - self.arc[segment]) / (self.arc[segment + 1] - self.arc[segment]);
        Ok(EdgePoint { segment, fraction })
    }

    /// The places of a segment's stencil where `displacement` moves the track's nodes.
    #[inline]
    pub(crate) fn stencil(
        &self,
        segment: usize,
        displacement: impl Fn(usize) -> PlaneVector,
    ) -> [PlaneVector; STENCIL] {
        let first = self.edge.first_node(segment);
        let count = self.edge.stencil_nodes();
        std::array::from_fn(|k| {
            let node = first + k.min(count - 1);
            plus(self.track.nodes[node].place, 1.0, displacement(node))
        })
    }

    /// How C touches the undeformed edge.
    ///
    /// # Errors
    /// [`SlidingError::OffTrack`].
    pub fn undeformed(&self, position: f64) -> Result<Touch, SlidingError> {
        let from = self.edge_point(position)?;
        self.touch_with(position, from, [0.0; 2], |_| [0.0; 2])
    }

    /// How C touches the edge that a state of both structures deforms.
    ///
    /// # Errors
    /// [`SlidingError::OffTrack`].
    pub fn deformed(&self, position: f64, q: &[f64]) -> Result<Touch, SlidingError> {
        let from = self.edge_point(position)?;
        let (of_slider, of_track) = q.split_at(self.slider.body.modes());
        let displaced = self.slider.contact.displacement(of_slider);
        self.touch_with(position, from, displaced, |node| self.track.nodes[node].displacement(of_track))
    }

    pub(crate) fn touch_with(
        &self,
        position: f64,
        from: EdgePoint,
        displaced: PlaneVector,
        of_node: impl Fn(usize) -> PlaneVector,
    ) -> Result<Touch, SlidingError> {
        let point = plus(self.rigid_place(position), 1.0, displaced);
        let found = self.edge.touch(point, from, |segment| self.stencil(segment, &of_node));
        let length = self.arc.last().copied().unwrap_or_default();
        found.map_err(|_| SlidingError::OffTrack {
            position: position + dot(displaced, self.direction),
            length,
        })
    }
}

fn expect_length(name: &str, found: usize, expected: usize) -> Result<(), SlidingError> {
    if found == expected {
        return Ok(());
    }
    Err(SlidingError::Length { name: name.to_owned(), found, expected })
}
