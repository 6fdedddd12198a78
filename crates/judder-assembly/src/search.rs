//! Contact search: for each node of the slider's surface its partner on the track, whose mesh need not match.

use crate::AssemblyError;
use crate::contact_point::{ContactPoint, Foot};
use crate::row::Row;
use crate::surface::{Face, OnFace, Surface};
use crate::vector::{Vector, along, cross, dot, length, minus, scaled, unit};
use judder_structure::freedom::Direction;
use judder_structure::mesh::Mesh;
use rstar::{AABB, RTree, RTreeObject};
use std::array;
use std::collections::BTreeMap;

/// A body of an assembly where it may touch others.
pub struct TouchingBody<'a> {
    /// Its mesh.
    pub mesh: &'a Mesh,
    /// Its width across the plane in m; one for a body of space.
    pub width: f64,
    /// A displacement of a node as a form on the freedoms of the assembly; empty where it is held.
    pub displacement: &'a dyn Fn(usize, Direction) -> Row,
    /// How a node is displaced whatever happens, in m: by supports that loads move.
    pub displaced: &'a dyn Fn(usize) -> [f64; 3],
    /// What of its faces contact points keep, where it is a track.
    pub kept: KeptOfFaces,
}

/// What contact points keep of the faces of their track beside the shape functions.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct KeptOfFaces {
    /// That their normals turn: the mesh is that of the deformed body.
    pub turns: bool,
    /// That their material passes: the body is one of revolution and turns within its shape.
    pub passes: bool,
}

/// What the slider slides on.
pub enum Track<'a> {
    /// A rigid plane through the foremost node of the slider, with its normal out of it, of any length.
    Plane([f64; 3]),
    /// Such a plane that moves as a node of a body does.
    Carried(TouchingBody<'a>, usize, [f64; 3]),
    /// The surface of a body between the nodes of a set.
    Body(TouchingBody<'a>, &'a [usize]),
}

/// How the track moves beside the slider.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Sliding {
    /// With one velocity, in m/s.
    Translation([f64; 3]),
    /// About an axis: ω × (x − centre).
    Rotation {
        /// ω in rad/s, along the axis.
        angular_velocity: [f64; 3],
        /// A place of the axis, in m.
        centre: [f64; 3],
    },
    /// Not at all; it would along this direction, of any length.
    Rest([f64; 3]),
}

impl Sliding {
    /// The velocity at a place, in m/s.
    #[must_use]
    pub fn at(&self, place: [f64; 3]) -> [f64; 3] {
        match self {
            Self::Translation(velocity) => *velocity,
            Self::Rotation { angular_velocity, centre } => cross(*angular_velocity, minus(place, *centre)),
            Self::Rest(_) => [0.0; 3],
        }
    }

    fn rest_direction(self) -> Option<[f64; 3]> {
        if let Self::Rest(direction) = self { Some(direction) } else { None }
    }
}

/// What a search found.
#[derive(Debug, Clone, PartialEq)]
pub struct FoundPoints {
    /// The contact points, by the order of the slider's nodes.
    pub points: Vec<ContactPoint>,
    /// The slider's node of each.
    pub nodes: Vec<usize>,
    /// Nodes of the slider that have no partner.
    pub without_partner: Vec<usize>,
}

/// The contact points between nodes of the slider and a track that lies no farther from them than `reach` in m.
///
/// Each node is projected on the nearest face of the track; its gap is as meshed, its normal that of the face. A node whose surface looks
/// away from the face, or whose projection falls on the edge of the track, has no partner. A single node without faces of its own has no
/// area.
///
/// # Errors
/// [`AssemblyError::QuadraticFace`]; [`AssemblyError::NoNormal`], [`AssemblyError::WrongNormal`] for a plane.
pub fn contact_points(
    slider: &TouchingBody<'_>,
    nodes: &[usize],
    track: &Track<'_>,
    sliding: Sliding,
    reach: f64,
) -> Result<FoundPoints, AssemblyError> {
    let surface = Surface::of_nodes(slider.mesh, nodes)?;
    let (areas, normals) = (surface.tributary(slider.mesh), surface.normals(slider.mesh));
    let opposite = match track {
        Track::Plane(normal) => above_plane(slider, nodes, *normal, &normals, Default::default())?,
        Track::Carried(body, node, normal) => {
            let carried = (body.displacement(*node), (body.displaced)(*node));
            above_plane(slider, nodes, *normal, &normals, carried)?
        }
        Track::Body(body, nodes) => {
            let (faces, normals) = (TrackFaces::new(body, nodes)?, &normals);
            Box::new(move |node| {
                faces.opposite(body, slider.mesh.nodes[node], normals.get(&node).copied(), reach)
            })
        }
    };
    let kept = match track {
        Track::Plane(_) | Track::Carried(..) => KeptOfFaces::default(),
        Track::Body(body, _) => body.kept,
    };
    let mut found = FoundPoints { points: Vec::new(), nodes: Vec::new(), without_partner: Vec::new() };
    for node in nodes {
        let Some(partner) = opposite(*node) else {
            found.without_partner.push(*node);
            continue;
        };
        let place = slider.mesh.nodes[*node];
        let own = slider.displacement(*node);
        let relative = array::from_fn(|k| Row::sum([(1.0, &own[k]), (-1.0, &partner.moved[k])]));
        let convected = match (&partner.foot, sliding) {
            (Some(foot), Sliding::Rotation { angular_velocity, .. }) if kept.passes => {
                convected(foot, sliding.at(place), angular_velocity, &relative)
            }
            _ => None,
        };
        found.nodes.push(*node);
        found.points.push(ContactPoint {
            place,
            normal: partner.normal,
            velocity: sliding.at(place),
            rest_direction: sliding.rest_direction(),
            area: slider.width * areas.get(node).copied().unwrap_or(0.0),
            gap: partner.gap + dot(partner.normal, minus((slider.displaced)(*node), partner.displaced)),
            relative,
            convected,
            foot: partner.foot.filter(|_| kept.turns),
        });
    }
    Ok(found)
}

/// Finds what lies opposite a node of the slider, where anything does.
type Opposite<'a> = Box<dyn Fn(usize) -> Option<Partner> + 'a>;

/// What lies opposite a node above the plane through the foremost one, which is carried so.
fn above_plane<'a>(
    slider: &'a TouchingBody<'_>,
    nodes: &[usize],
    normal: Vector,
    outward: &BTreeMap<usize, Vector>,
    (moved, displaced): ([Row; 3], Vector),
) -> Result<Opposite<'a>, AssemblyError> {
    let normal = unit(normal).ok_or(AssemblyError::NoNormal { normal })?;
    let mean = outward.values().fold([0.0; 3], |sum, own| along(sum, 1.0 / outward.len() as f64, *own));
    // a surface all around has no direction; nor has a node without faces
    if let Some(outward) = unit(mean).filter(|_| length(mean) > AGAINST)
        && dot(outward, normal) > -AGAINST
    {
        return Err(AssemblyError::WrongNormal { normal, outward });
    }
    let height = move |node: &usize| dot(normal, slider.mesh.nodes[*node]);
    let foremost = nodes.iter().map(height).fold(f64::INFINITY, f64::min);
    Ok(Box::new(move |node| {
        Some(Partner { normal, gap: height(&node) - foremost, moved: moved.clone(), displaced, foot: None })
    }))
}

/// A plane looks against a surface where the cosine between their normals is below minus this.
const AGAINST: f64 = 0.1;

impl TouchingBody<'_> {
    /// The displacement of a node along x, y and z.
    fn displacement(&self, node: usize) -> [Row; 3] {
        Direction::ALL.map(|direction| (self.displacement)(node, direction))
    }
}

/// What lies opposite a node.
struct Partner {
    normal: Vector,
    gap: f64,
    /// Σ w_k u_k along x, y and z,
    moved: [Row; 3],
    /// and what of it is imposed.
    displaced: Vector,
    foot: Option<Foot>,
}

/// (V·∇) u + ω × (u_slider − u), of the track's displacement u.
fn convected(foot: &Foot, velocity: Vector, spin: Vector, relative: &[Row; 3]) -> Option<[Row; 3]> {
    let shares: Vec<f64> = foot.reciprocal()?.iter().map(|own| dot(*own, velocity)).collect();
    Some(array::from_fn(|k| {
        let carried = shares.iter().zip(&foot.slopes).map(|(share, slopes)| (*share, &slopes[k]));
        // ω × u along axis k
        let (next, last) = ((k + 1) % 3, (k + 2) % 3);
        Row::sum(carried.chain([(spin[next], &relative[last]), (-spin[last], &relative[next])]))
    }))
}

/// A face in its box.
struct BoxedFace {
    face: Face,
    bounds: AABB<[f64; 3]>,
}

impl RTreeObject for BoxedFace {
    type Envelope = AABB<[f64; 3]>;

    fn envelope(&self) -> Self::Envelope {
        self.bounds
    }
}

/// The faces of a track in a tree of boxes.
struct TrackFaces {
    tree: RTree<BoxedFace>,
}

impl TrackFaces {
    fn new(body: &TouchingBody<'_>, nodes: &[usize]) -> Result<Self, AssemblyError> {
        let boxed = |face: Face| {
            let (from, to) = face.bounds(body.mesh);
            BoxedFace { face, bounds: AABB::from_corners(from, to) }
        };
        let faces = Surface::of_nodes(body.mesh, nodes)?.faces;
        Ok(Self { tree: RTree::bulk_load(faces.into_iter().map(boxed).collect()) })
    }

    /// The nearest place of a face that looks at a place, where that lies above the track.
    fn opposite(
        &self,
        body: &TouchingBody<'_>,
        place: Vector,
        outward: Option<Vector>,
        reach: f64,
    ) -> Option<Partner> {
        let near = AABB::from_corners(place.map(|x| x - reach), place.map(|x| x + reach));
        let feet = self.tree.locate_in_envelope_intersecting(&near).filter_map(|boxed| {
            let foot = boxed.face.nearest(body.mesh, place);
            let normal = unit(foot.area)?;
            let faces_each_other = outward.is_none_or(|outward| dot(outward, normal) < 0.0);
            faces_each_other.then_some((&boxed.face, foot, normal))
        });
        let distance = |foot: &OnFace| length(minus(place, foot.place));
        let (face, foot, normal) = feet.min_by(|(a, at_a, _), (b, at_b, _)| {
            // on an edge of two faces both are as near: that of the lower nodes
            distance(at_a).total_cmp(&distance(at_b)).then_with(|| a.nodes.cmp(&b.nodes))
        })?;
        let off = minus(place, foot.place);
        let gap = dot(normal, off);
        let beside = length(along(off, -gap, normal));
        let size = {
            let (from, to) = face.bounds(body.mesh);
            length(minus(to, from))
        };
        // beside the track what is nearest lies on its edge, aslant; between faces that bend it does a little
        if gap.abs() > reach || beside > EDGE * size + BEND * gap.abs() {
            return None;
        }
        let moved = array::from_fn(|k| {
            let displaced = face.nodes.iter().map(|node| body.displacement(*node)[k].clone());
            let parts: Vec<Row> = displaced.collect();
            Row::sum(foot.weights.iter().copied().zip(&parts))
        });
        let imposed = face.nodes.iter().zip(&foot.weights);
        let displaced =
            imposed.fold([0.0; 3], |sum, (node, weight)| along(sum, *weight, (body.displaced)(*node)));
        let foot = Some(foot_on(body, face, &foot));
        Some(Partner { normal, gap, moved, displaced, foot })
    }
}

/// The face around a place.
fn foot_on(body: &TouchingBody<'_>, face: &Face, at: &OnFace) -> Foot {
    let slopes = face.slopes(at.own);
    let tangents = slopes.iter().map(|weights| face.sum(body.mesh, weights)).collect();
    let displacements: Vec<[Row; 3]> = face.nodes.iter().map(|node| body.displacement(*node)).collect();
    let moved = |weights: &Vec<f64>| {
        array::from_fn(|k| Row::sum(weights.iter().copied().zip(displacements.iter().map(|own| &own[k]))))
    };
    let twist = match face.nodes.len() {
        4 => face.sum(body.mesh, &[0.25, -0.25, 0.25, -0.25]),
        _ => [0.0; 3],
    };
    Foot { tangents, slopes: slopes.iter().map(moved).collect(), twist }
}

/// A foot on the edge of a face counts where the node lies beside the edge by less than so much of the face,
const EDGE: f64 = 1e-6;
/// and of the gap.
const BEND: f64 = 0.3;

/// The least distance between places of two sets, in m; infinite where one has none.
#[must_use]
pub fn least_distance(places: &[[f64; 3]], others: &[[f64; 3]]) -> f64 {
    let tree = RTree::bulk_load(others.to_vec());
    let distance = |place: &[f64; 3]| Some(length(minus(*place, *tree.nearest_neighbor(place)?)));
    places.iter().filter_map(distance).fold(f64::INFINITY, f64::min)
}

/// Half of the longest diagonal of the faces between nodes: how far a partner may lie that nobody bounded.
#[must_use]
pub fn usual_reach(mesh: &Mesh, surface: &Surface) -> f64 {
    let diagonal = |face: &Face| {
        let (from, to) = face.bounds(mesh);
        length(scaled(0.5, minus(to, from)))
    };
    surface.faces.iter().map(diagonal).fold(0.0, f64::max)
}
