//! Contact points: where the slider meets the track, and how their displacements beside each other follow from the freedoms.

use crate::AssemblyError;
use crate::row::Row;
use crate::vector::{Vector, along, cross, dot, length, unit};

/// A place on the slider and its partner on the track.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactPoint {
    /// Where it lies on the slider, in m.
    pub place: Vector,
    /// n, out of the track towards the slider, of length one.
    pub normal: Vector,
    /// V, the velocity of the track beside the slider at this place, in m/s.
    pub velocity: Vector,
    /// Of a track at rest, whose V is zero: the direction along which it would move, of any length.
    pub rest_direction: Option<Vector>,
    /// a, the tributary area in m².
    pub area: f64,
    /// g₀, the gap of the undeformed bodies in m.
    pub gap: f64,
    /// u_slider − Σ w_k u_k along x, y and z, as forms on the freedoms of the assembly; in the plane the third is empty.
    pub relative: [Row; 3],
    /// How the slip velocity follows the displacements along x, y and z, in 1/s, where the track's material passes: (V·∇) u_track + ω × (u_slider − u_track), with
    /// V = ω × r.
    pub convected: Option<[Row; 3]>,
    /// The face of the track, where the normal turns with it.
    pub foot: Option<Foot>,
}

/// The face of the track around a contact point: how it turns as its nodes move, and how the point moves along it.
#[derive(Debug, Clone, PartialEq)]
pub struct Foot {
    /// a_α = ∂P/∂ξ_α: one on an edge, two on a quadrilateral, in m.
    pub tangents: Vec<Vector>,
    /// Σ (∂w_k/∂ξ_α) u_k along x, y and z.
    pub slopes: Vec<[Row; 3]>,
    /// ∂²P/∂ξ₁∂ξ₂ of a quadrilateral, in m.
    pub twist: Vector,
}

/// The forms of a contact point in its own directions.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactFrame {
    /// c = n·(u_slider − Σ w u): what the gap gains, the compatibility row.
    pub normal: Row,
    /// t·(u_slider − Σ w u) with t = P V/|P V|: the direction in which friction drags the slider in steady sliding; of a track at rest, in which it would.
    pub slip: Row,
    /// (n × t)·(u_slider − Σ w u), across the slip; empty in the plane.
    pub across: Row,
    /// |P V|, the slip speed of steady sliding in m/s; zero of a track at rest.
    pub speed: f64,
    /// t,
    pub(crate) tangent: Vector,
    /// How the slip velocity along the slip and across it follows the displacements; empty where the track's material stays.
    pub convected: [Row; 2],
}

impl ContactPoint {
    /// P V, the slip velocity of steady sliding: V without its part along the normal.
    #[must_use]
    pub fn slip_velocity(&self) -> Vector {
        self.tangential(self.velocity)
    }

    /// P of a vector: without its part along the normal.
    fn tangential(&self, vector: Vector) -> Vector {
        along(vector, -dot(vector, self.normal), self.normal)
    }

    /// Whether its track is at rest.
    #[must_use]
    pub fn is_at_rest(&self) -> bool {
        self.rest_direction.is_some() && length(self.velocity) == 0.0
    }

    /// |P V|, the slip speed of steady sliding in m/s.
    #[must_use]
    pub fn slip_speed(&self) -> f64 {
        length(self.slip_velocity())
    }

    /// Its forms along the normal, along the slip and across it.
    ///
    /// # Errors
    /// [`AssemblyError::NoSlip`] where the track neither moves along the contact nor has a direction along it in which it rests.
    pub fn frame(&self, interface: &str) -> Result<ContactFrame, AssemblyError> {
        let way = self.rest_direction.filter(|_| self.is_at_rest()).unwrap_or(self.velocity);
        let slip = self.tangential(way);
        // what is left of a vector along the normal is rounding
        let is_along = length(slip) > 1e-9 * length(way);
        let tangent = unit(slip).filter(|_| is_along).ok_or_else(|| AssemblyError::NoSlip {
            interface: interface.to_owned(),
            place: self.place,
            velocity: self.velocity,
            normal: self.normal,
        })?;
        let across = cross(self.normal, tangent);
        Ok(ContactFrame {
            normal: self.form(self.normal),
            slip: self.form(tangent),
            across: self.form(across),
            speed: self.slip_speed(),
            tangent,
            convected: [tangent, across].map(|direction| match &self.convected {
                Some(convected) => Row::sum(direction.into_iter().zip(convected)),
                None => Row::default(),
            }),
        })
    }

    /// a·(u_slider − Σ w u) of a direction a.
    #[must_use]
    pub fn form(&self, direction: Vector) -> Row {
        Row::sum(direction.into_iter().zip(&self.relative))
    }
}

impl Foot {
    /// How the forces of a point at N and T follow as the face turns and the point moves along it: columns and rows of −∂f/∂q, the stiffness.
    ///
    /// The point moves by δξ = A⁻¹ a·δ(u_slider − Σ w u), with A = a·a; the normal turns by δn = −Σ a^α (n·δa_α), with the reciprocal a^α and δa_α = Σ (∂w/∂ξ_α) δu +
    /// (∂²P/∂ξ_α∂ξ_β) δξ_β, and the slip direction with it. The force f = N n + T t turns, and its shares on the nodes of the face are those of the place.
    pub(crate) fn stiffness(
        &self,
        point: &ContactPoint,
        frame: &ContactFrame,
        [n, t]: [f64; 2],
    ) -> Vec<(Row, Row)> {
        let (normal, tangent) = (point.normal, frame.tangent);
        let Some(reciprocal) = self.reciprocal() else { return Vec::new() };
        let force = along(normal.map(|part| n * part), t, tangent);
        let places: Vec<Row> = reciprocal.iter().map(|own| point.form(*own)).collect();
        // at rest there is no velocity that could lean
        let lean = if frame.speed > 0.0 { dot(point.velocity, normal) / frame.speed } else { 0.0 };
        let mut terms = Vec::new();
        for (k, own) in reciprocal.iter().enumerate() {
            let of_nodes = Row::sum(normal.into_iter().zip(&self.slopes[k]));
            let twist = dot(normal, self.twist);
            // of a quadrilateral a_1 changes with ξ_2 and a_2 with ξ_1
            let angle = match places.get(1 - k.min(1)).filter(|_| self.tangents.len() == 2) {
                Some(other) => Row::sum([(1.0, &of_nodes), (twist, other)]),
                None => of_nodes,
            };
            let turned = own.map(|part| -part);
            let across = cross(normal, tangent);
            let with_it =
                along(normal.map(|part| -dot(tangent, turned) * part), -lean * dot(across, turned), across);
            let turns = along(turned.map(|part| n * part), t, with_it);
            terms.push((Row::sum([(-1.0, &point.form(turns))]), angle));
            let shares = Row::sum(force.into_iter().zip(&self.slopes[k]));
            terms.push((shares, places[k].clone()));
        }
        terms
    }

    /// a^α with a^α·a_β = 1 where α = β, else 0.
    pub(crate) fn reciprocal(&self) -> Option<Vec<Vector>> {
        match self.tangents[..] {
            [a] => Some(vec![a.map(|part| part / dot(a, a))]),
            [a, b] => {
                let determinant = dot(a, a) * dot(b, b) - dot(a, b) * dot(a, b);
                let raised = |own: Vector, other: Vector| {
                    along(own.map(|part| part * dot(other, other)), -dot(a, b), other)
                        .map(|part| part / determinant)
                };
                Some(vec![raised(a, b), raised(b, a)])
            }
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::search::{KeptOfFaces, Sliding, TouchingBody, Track, contact_points};
    use judder_structure::element::ElementKind;
    use judder_structure::freedom::Direction;
    use judder_structure::grid::Grid;
    use judder_structure::mesh::Mesh;

    /// A track of two bricks that are moved a little, and a node on it; each node has three freedoms, the slider's are the last.
    struct Touching {
        track: Mesh,
        slider: Mesh,
    }

    impl Touching {
        fn new() -> Self {
            let grid = Grid { kind: ElementKind::Hexahedron8, size: [2.0, 1.0, 0.5], cells: [2, 1, 1] };
            let bent =
                |[x, y, z]: [f64; 3]| [x + 0.05 * y, y - 0.03 * x * y, z + 0.08 * x * y - 0.05 * x * x];
            let track = grid.mesh("m", bent).unwrap();
            Self { track, slider: Mesh { nodes: vec![[0.7, 0.4, 0.6]], ..Mesh::default() } }
        }

        fn freedoms(&self) -> usize {
            3 * self.track.nodes.len() + 3
        }

        /// The contact point where all nodes are displaced.
        fn at(&self, q: &[f64], sliding: Sliding) -> ContactPoint {
            let moved = |mesh: &Mesh, first: usize| {
                let mut mesh = mesh.clone();
                for (k, node) in mesh.nodes.iter_mut().enumerate() {
                    *node = std::array::from_fn(|axis| node[axis] + q[first + 3 * k + axis]);
                }
                mesh
            };
            let last = 3 * self.track.nodes.len();
            let (track, slider) = (moved(&self.track, 0), moved(&self.slider, last));
            let body = |mesh, displacement| TouchingBody {
                mesh,
                width: 1.0,
                displacement,
                displaced: &|_| [0.0; 3],
                kept: KeptOfFaces { turns: true, passes: true },
            };
            let of_track = |node: usize, direction: Direction| Row::of_freedom(3 * node + direction as usize);
            let of_slider = |_: usize, direction: Direction| Row::of_freedom(last + direction as usize);
            let set = self.track.node_sets["z-max"].clone();
            let found = contact_points(
                &body(&slider, &of_slider),
                &[0],
                &Track::Body(body(&track, &of_track), &set),
                sliding,
                1.0,
            );
            found.unwrap().points.remove(0)
        }
    }

    /// The slider comes down on the track, then all nodes are displaced one by one: the forces change as the matrix says.
    #[test]
    fn forces_follow_the_turning_face_as_their_differences_do() {
        const STEP: f64 = 1e-5;
        let touching = Touching::new();
        let sliding = Sliding::Translation([1.0, 0.4, 0.0]);
        let (n, t) = (3.0, 1.3);
        let mut q: Vec<f64> = (0..touching.freedoms()).map(|k| 0.01 * (1.7 * k as f64).sin()).collect();
        let above = touching.at(&q, sliding);
        let last = q.len() - 3;
        (0..3).for_each(|axis| q[last + axis] -= above.gap * above.normal[axis]);
        let force = |q: &[f64]| {
            let frame = touching.at(q, sliding).frame("").unwrap();
            let mut force = vec![0.0; q.len()];
            frame.normal.add_to(n, &mut force);
            frame.slip.add_to(t, &mut force);
            force
        };
        let point = touching.at(&q, sliding);
        assert!(point.gap.abs() < 1e-15);
        let terms = point.foot.as_ref().unwrap().stiffness(&point, &point.frame("").unwrap(), [n, t]);
        assert_eq!(terms.len(), 4);
        for freedom in 0..q.len() {
            let moved = |by: f64| {
                let mut q = q.clone();
                q[freedom] += by;
                force(&q)
            };
            let (more, less) = (moved(STEP), moved(-STEP));
            let mut unit = vec![0.0; q.len()];
            unit[freedom] = 1.0;
            let mut expected = vec![0.0; q.len()];
            terms.iter().for_each(|(column, row)| column.add_to(row.of(&unit), &mut expected));
            for k in 0..q.len() {
                let difference = -(more[k] - less[k]) / (2.0 * STEP);
                assert!(
                    (difference - expected[k]).abs() < 1e-7,
                    "{freedom} {k}: {difference} {}",
                    expected[k]
                );
            }
        }
    }

    /// Of displacements that are linear in the place, (V·∇) u is exact.
    #[test]
    fn what_passes_carries_its_displacement_along() {
        let mut touching = Touching::new();
        // a flat track: V is along it
        let flat = Grid { kind: ElementKind::Hexahedron8, size: [2.0, 1.0, 0.5], cells: [2, 1, 1] };
        touching.track = flat.mesh("m", |place| place).unwrap();
        let spin = [0.0, 0.0, 3.0];
        let sliding = Sliding::Rotation { angular_velocity: spin, centre: [0.2, -1.0, 0.0] };
        let point = touching.at(&vec![0.0; touching.freedoms()], sliding);
        let slope = [[0.1, 0.2, -0.3], [0.4, -0.1, 0.7], [0.5, 0.3, 0.2]];
        let field = |x: Vector| -> Vector { std::array::from_fn(|i| dot(slope[i], x)) };
        let of_slider = [0.3, -0.2, 0.1];
        let q: Vec<f64> =
            touching.track.nodes.iter().flat_map(|node| field(*node)).chain(of_slider).collect();
        let foot = [0.7, 0.4, 0.5];
        let between = along(of_slider, -1.0, field(foot));
        let expected = along(field(point.velocity), 1.0, cross(spin, between));
        let convected = point.convected.unwrap();
        for k in 0..3 {
            assert!((convected[k].of(&q) - expected[k]).abs() < 1e-12, "{k}");
        }
    }
}
