//! Contact points that travel along an edge of their track, in the plane.
//!
//! In a step a point touches the edge where that lies at the step's end, moved as without contact and by the impulses of the step before: equations (14)
//! and (16) of the beams paper, for any number of points. Couplings and compliance between the points are those of these places.

mod edge;
mod forms;
mod kept;

use crate::NonsmoothError;
use crate::bodies::MovingBodies;
use crate::contact::ContactPoints;
use crate::contact_problem::Delassus;
use edge::TravelledEdge;
use forms::{PointForm, TravelForms};
use judder_assembly::interface::Interface;
use judder_assembly::row::Row;
use judder_sliding::edge::{EdgePoint, Interpolation, RunOff, combined};
use judder_sliding::plane::{PlaneVector, dot, minus, plus};

pub(crate) use kept::TravelledPoint;

/// A node of an edge.
#[derive(Debug, Clone, PartialEq)]
pub struct EdgeNode {
    /// Where it lies, in m.
    pub place: PlaneVector,
    /// Its displacements along x and y, as forms on the freedoms of the assembly.
    pub rows: [Row; 2],
}

/// An interface whose points travel along an edge of the track.
#[derive(Debug, Clone, PartialEq)]
pub struct TravellingContact {
    /// The interface, by its place in the assembly.
    pub interface: usize,
    /// The displacements of the slider along x and y at each of its points, as forms on the freedoms of the assembly.
    pub points: Vec<[Row; 2]>,
    /// How the edge runs between its nodes.
    pub interpolation: Interpolation,
    /// The nodes of the edge, in order.
    pub nodes: Vec<EdgeNode>,
}

/// What a step knows before its contact is solved.
#[derive(Debug, Clone, Copy)]
pub(crate) struct StepView<'a> {
    /// z and v at its beginning, v at its end without contact.
    pub(crate) states: [&'a [f64]; 3],
    /// How far z goes in it, as multiples of the velocities before and after, in s.
    pub(crate) shares: [f64; 2],
    /// How long the track would have moved beside the slider at its full speed when the step ends, in s.
    pub(crate) way: f64,
}

/// A point that travels.
#[derive(Debug, Clone)]
pub(crate) struct TravellingPoint {
    interface: String,
    /// Counted from 1 within its interface.
    number: usize,
    edge: usize,
    place: PlaneVector,
    /// V, the velocity of the track beside the slider in m/s.
    velocity: PlaneVector,
    /// Whether V goes along the edge, 1, or against it, −1.
    sign: f64,
    /// Where it was at the step before,
    at: EdgePoint,
    /// where it started.
    start: EdgePoint,
    /// V along normal and slip where it is, in m/s.
    pub(crate) imposed: [f64; 2],
    /// g at the step's end, without contact until that is solved, in m.
    pub(crate) gap: f64,
}

/// Points that travel, among those that stay.
#[derive(Debug, Clone)]
pub(crate) struct Travel {
    edges: Vec<TravelledEdge>,
    /// Of all contact points; `None` of those that stay.
    points: Vec<Option<TravellingPoint>>,
    forms: TravelForms,
}

impl Travel {
    /// With the rows that forms are sums of: two of each contact point, of a travelling one the slider's displacements, then two of each node of an edge.
    ///
    /// # Errors
    /// [`NonsmoothError::TravelInSpace`]; [`NonsmoothError::Edge`] for nodes that make no edge.
    pub(crate) fn new(
        contact: &ContactPoints<'_>,
        names: &[Interface],
        travelling: &[TravellingContact],
    ) -> Result<(Self, Vec<Row>), NonsmoothError> {
        if contact.dimension != 2 {
            return Err(NonsmoothError::TravelInSpace);
        }
        let mut rows = contact.rows.clone();
        let mut points = vec![None; contact.points.len()];
        let mut edges = Vec::with_capacity(travelling.len());
        for own in travelling {
            let numbers: Vec<usize> =
                (0..points.len()).filter(|k| contact.points[*k].interface == own.interface).collect();
            let Some(first) = numbers.first() else { continue };
            let name = &names[own.interface].name;
            if numbers.iter().any(|point| contact.points[*point].point.convected.is_some()) {
                return Err(NonsmoothError::TravelsOnTurning { interface: name.clone() });
            }
            let edge = TravelledEdge::new(own, plane(contact.points[*first].point.normal), rows.len())?;
            rows.extend(own.nodes.iter().flat_map(|node| node.rows.iter().cloned()));
            for ((number, point), of_slider) in numbers.iter().enumerate().zip(&own.points) {
                let framed = contact.points[*point].point;
                let (place, velocity) = (plane(framed.place), plane(framed.velocity));
                rows[2 * point..2 * point + 2].clone_from_slice(of_slider);
                let start = edge.beneath(place);
                points[*point] = Some(TravellingPoint {
                    interface: name.clone(),
                    number: number + 1,
                    edge: edges.len(),
                    place,
                    velocity,
                    sign: if dot(velocity, edge.direction) < 0.0 { -1.0 } else { 1.0 },
                    at: start,
                    start,
                    imposed: [0.0; 2],
                    gap: 0.0,
                });
            }
            edges.push(edge);
        }
        let forms = TravelForms::new(points.len(), rows.len());
        Ok((Self { edges, points, forms }, rows))
    }

    /// Takes H A⁻¹ Hᵀ of its rows, column after column, and gives that of the points where they start, of bodies at rest.
    ///
    /// # Errors
    /// [`RunOffPoint`] where a point starts beyond an end of its edge.
    pub(crate) fn first(
        &mut self,
        entries: Vec<f64>,
        bodies: &MovingBodies,
    ) -> Result<Delassus, RunOffPoint> {
        self.forms.compliance = entries;
        let components = 2 * self.points.len();
        let (rest, impulses) = (vec![0.0; bodies.size()], vec![0.0; components]);
        let mut delassus = Delassus::new(2, vec![0.0; components * components]);
        let view = StepView { states: [&rest; 3], shares: [0.0; 2], way: 0.0 };
        self.locate(bodies, view, &impulses, &mut delassus)?;
        Ok(delassus)
    }

    /// The points that travel, by their numbers among all.
    pub(crate) fn points(&self) -> impl Iterator<Item = (usize, &TravellingPoint)> {
        self.points.iter().enumerate().filter_map(|(point, own)| Some((point, own.as_ref()?)))
    }

    /// The same, to be changed.
    pub(crate) fn points_mut(&mut self) -> impl Iterator<Item = (usize, &mut TravellingPoint)> {
        self.points.iter_mut().enumerate().filter_map(|(point, own)| Some((point, own.as_mut()?)))
    }

    /// What the components of all points see of z, v, or v without contact, by `which`, in the step that was located.
    pub(crate) fn see(&mut self, bodies: &MovingBodies, view: StepView<'_>, which: usize, out: &mut [f64]) {
        self.forms.relative(bodies, view, which, out);
    }

    /// Impulses of the components on the rows.
    pub(crate) fn on_rows(&mut self, impulses: &[f64]) -> &[f64] {
        self.forms.on_rows(impulses)
    }

    /// Begins where the points lay when nothing had moved.
    pub(crate) fn begin(&mut self) {
        self.points.iter_mut().flatten().for_each(|own| own.at = own.start);
    }

    /// Finds where the points touch in a step, and the compliance between all of them there; `impulses` are those of the step before.
    ///
    /// # Errors
    /// [`RunOffPoint`].
    pub(crate) fn locate(
        &mut self,
        bodies: &MovingBodies,
        view: StepView<'_>,
        impulses: &[f64],
        delassus: &mut Delassus,
    ) -> Result<(), RunOffPoint> {
        let Self { edges, points, forms } = self;
        forms.begin(impulses);
        for (number, own) in points.iter_mut().enumerate() {
            let Some(own) = own else { continue };
            let edge = &edges[own.edge];
            let rigid = plus(own.place, -view.way, own.velocity);
            let predicted = forms.predicted(bodies, view, 2 * number);
            let pushed = forms.pushed_slider(number);
            let guess = plus(plus(rigid, 1.0, predicted), view.shares[1], pushed);
            let before = own.at;
            let found = edge.edge.touch(guess, before, |segment| {
                let near = edge.near(before.seen_from(segment));
                edge.displaced(segment, &forms.pushed_nodes(bodies, view, number, &near))
            });
            let touch = found.map_err(|end| RunOffPoint {
                interface: own.interface.clone(),
                point: own.number,
                end,
            })?;
            own.at = touch.at;
            let near = edge.near(touch.at);
            let moved = forms.predicted_nodes(bodies, view, &near);
            let nodes = combined(&near.weights, &edge.displaced(touch.at.segment, &moved));
            own.gap = dot(touch.normal, minus(plus(rigid, 1.0, predicted), nodes));
            let tangent = touch.tangent.map(|part| own.sign * part);
            own.imposed = [touch.normal, tangent].map(|along| dot(along, own.velocity));
            forms.next[number] = Some(PointForm { directions: [touch.normal, tangent], near });
        }
        forms.go_on(delassus);
        Ok(())
    }
}

/// A point that has run off its edge.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct RunOffPoint {
    interface: String,
    point: usize,
    end: RunOff,
}

impl RunOffPoint {
    /// As an error at a time in s.
    pub(crate) fn at(self, time: f64) -> NonsmoothError {
        let Self { interface, point, end } = self;
        NonsmoothError::RunOff { interface, point, end, time }
    }
}

fn plane([x, y, _]: [f64; 3]) -> PlaneVector {
    [x, y]
}
