//! The freedoms that a reduction keeps.

use super::body::nodes_of;
use super::{Structure, Unbuilt};
use judder_case::StructureProblem;
use judder_case::structure::reduction::{Kept, KeptNodes, Reduction};

/// The freedoms of the kept nodes, each once, in the order of the case.
pub(super) fn kept(reduction: &Reduction, structure: &Structure) -> Result<Vec<usize>, Unbuilt> {
    let mut freedoms = Vec::new();
    let mut is_kept = vec![false; structure.family.size()];
    for (index, kept) in reduction.kept.iter().enumerate() {
        for freedom in of_nodes(kept, structure, index)? {
            // a tied face has one freedom for all its nodes, and sets may overlap
            if !std::mem::replace(&mut is_kept[freedom], true) {
                freedoms.push(freedom);
            }
        }
    }
    let all = structure.family.size();
    let what = match freedoms.len() {
        0 => "no freedom that is free",
        count if count == all => "all freedoms, which leaves nothing to reduce",
        _ => return Ok(freedoms),
    };
    Err(Unbuilt::new("reduction.kept", StructureProblem::KeptFreedoms { what }))
}

fn of_nodes(kept: &Kept, structure: &Structure, index: usize) -> Result<Vec<usize>, Unbuilt> {
    let Some(layout) = &structure.layout else { return Ok(Vec::new()) };
    let points: Vec<usize> = match (&kept.nodes, &structure.mesh) {
        (KeptNodes::Set(set), Some(mesh)) => {
            nodes_of(mesh, set, &format!("reduction.kept.{index}.set"))?.to_vec()
        }
        (KeptNodes::Set(_), None) => Vec::new(),
        (KeptNodes::Numbers(nodes), _) => nodes
            .iter()
            .map(|node| {
                layout.names.iter().position(|name| name == node).ok_or_else(|| {
                    Unbuilt::new(
                        format!("reduction.kept.{index}.nodes"),
                        StructureProblem::UnknownNode { node: *node },
                    )
                })
            })
            .collect::<Result<_, _>>()?,
    };
    let of_point = |point: &usize| {
        layout.freedoms[*point]
            .into_iter()
            .zip(kept.directions)
            .filter(|(_, taken)| *taken)
            .filter_map(|(k, _)| k)
    };
    Ok(points.iter().flat_map(of_point).collect())
}
