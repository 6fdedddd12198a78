//! What joins bodies beside contacts: springs as forms on their freedoms, ties as forms that stay zero.

use super::interface::{apart, mesh_of, places, points_beside};
use super::{BuiltBody, Unassembled};
use crate::assembly::case::AssemblyCase;
use crate::assembly::case::contact::SurfaceOf;
use crate::assembly::case::joint::{SpringEnd, SpringSettings, Tie};
use crate::assembly::case::problem::AssemblyProblem;
use crate::structure::build::points_of;
use judder_assembly::row::Row;
use judder_assembly::spring::Spring;
use judder_structure::freedom::Direction;

/// The springs of a case.
pub(super) fn springs(case: &AssemblyCase, bodies: &[BuiltBody]) -> Result<Vec<Spring>, Unassembled> {
    case.springs.iter().map(|own| spring(own, bodies)).collect()
}

fn spring(own: &SpringSettings, bodies: &[BuiltBody]) -> Result<Spring, Unassembled> {
    let path = format!("spring.{}", own.name);
    let from = End::new(&own.from, bodies, &format!("{path}.from"))?;
    let to = match &own.to {
        SpringEnd::Ground => End::default(),
        SpringEnd::Nodes(nodes) => End::new(nodes, bodies, &format!("{path}.to"))?,
    };
    let along: [f64; 3] = match &own.direction {
        Some(given) => std::array::from_fn(|k| given.get(k).copied().unwrap_or(0.0)),
        None => std::array::from_fn(|k| to.place[k] - from.place[k]),
    };
    let length = along.iter().map(|part| part * part).sum::<f64>().sqrt();
    if length == 0.0 {
        return Err(Unassembled::new(path, AssemblyProblem::NoLength));
    }
    let direction = along.map(|part| part / length);
    let parts = direction.iter().zip(from.moved.iter().zip(&to.moved));
    let elongation = Row::sum(parts.flat_map(|(part, (from, to))| [(-part, from), (*part, to)]));
    if elongation.is_empty() {
        return Err(Unassembled::new(path, AssemblyProblem::HeldSpring));
    }
    let imposed = (0..3).map(|k| direction[k] * (to.displaced[k] - from.displaced[k])).sum();
    Ok(Spring { elongation, imposed, stiffness: own.stiffness, damping: own.damping })
}

/// An end of a spring: the mean of its nodes.
#[derive(Default)]
struct End {
    place: [f64; 3],
    moved: [Row; 3],
    /// What of it is imposed.
    displaced: [f64; 3],
}

impl End {
    fn new(nodes: &SurfaceOf, bodies: &[BuiltBody], path: &str) -> Result<Self, Unassembled> {
        let body = &bodies[*nodes.structure];
        let points = points_of(&nodes.nodes, &body.structure, path)?;
        let share = 1.0 / points.len() as f64;
        let mean = |of: &dyn Fn(usize) -> [f64; 3]| {
            let parts = points.iter().map(|point| of(*point));
            parts.fold([0.0; 3], |sum, own| std::array::from_fn(|k| sum[k] + share * own[k]))
        };
        let mesh = mesh_of(&body.structure);
        let moved = Direction::ALL.map(|direction| {
            let displacements: Vec<Row> =
                points.iter().map(|point| body.displacement(*point, direction)).collect();
            Row::sum(displacements.iter().map(|own| (share, own)))
        });
        Ok(Self {
            place: mean(&|point| mesh.nodes[point]),
            moved,
            displaced: mean(&|point| body.displaced(point)),
        })
    }
}

/// A form that a tie holds at zero, and the tie, by its place in the case.
pub(super) struct TiedForm {
    pub(super) form: Row,
    pub(super) tie: usize,
}

/// The forms of all ties.
pub(super) fn ties(
    case: &AssemblyCase,
    bodies: &[BuiltBody],
    warnings: &mut Vec<String>,
) -> Result<Vec<TiedForm>, Unassembled> {
    let mut forms = Vec::new();
    for (tie, own) in case.ties.iter().enumerate() {
        let rows = tied_rows(own, bodies, warnings)?;
        forms.extend(rows.into_iter().filter(|row| !row.is_empty()).map(|form| TiedForm { form, tie }));
    }
    Ok(forms)
}

fn tied_rows(own: &Tie, bodies: &[BuiltBody], warnings: &mut Vec<String>) -> Result<Vec<Row>, Unassembled> {
    let path = |key: &str| format!("tie.{}.{key}", own.name);
    let side = |nodes: &SurfaceOf, key: &str| {
        let body = &bodies[*nodes.structure];
        let points = points_of(&nodes.nodes, &body.structure, &path(key))?;
        match points.iter().any(|point| body.displaced(*point) != [0.0; 3]) {
            true => Err(Unassembled::new(path(key), AssemblyProblem::DisplacedTie { set: nodes.words() })),
            false => Ok((body, points)),
        }
    };
    let ((from, from_points), (to, to_points)) = (side(&own.from, "from")?, side(&own.to, "to")?);
    if let [node] = to_points[..] {
        let row = |point: usize, direction: Direction| {
            let (own, other) = (from.displacement(point, direction), to.displacement(node, direction));
            Row::sum([(1.0, &own), (-1.0, &other)])
        };
        let of_point = |point: &usize| Direction::ALL.map(|direction| row(*point, direction));
        return Ok(from_points.iter().flat_map(of_point).collect());
    }
    let found = points_beside([*own.from.structure, *own.to.structure], [&from_points, &to_points], bodies)
        .map_err(|error| Unassembled::because(path("from"), &error))?;
    if found.found.points.is_empty() {
        let sets = [(own.from.words(), places(from, &from_points)), (own.to.words(), places(to, &to_points))];
        return Err(apart(path("to"), sets, found.reach));
    }
    let alone = found.found.without_partner.len();
    if alone > 0 {
        warnings.push(format!(
            "{alone} of {} nodes that `{}` ties have no partner: they are not bonded",
            from_points.len(),
            own.name,
        ));
    }
    Ok(found.found.points.into_iter().flat_map(|point| point.relative).collect())
}
