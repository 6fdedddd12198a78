//! The freedoms that a reduction keeps.

use super::{Structure, Unbuilt};
use crate::structure::case::problem::StructureProblem;
use crate::structure::case::reduction::{KeptFreedoms, KeptNodes, ReductionSettings};

/// The freedoms of the kept nodes, each once, in the order of the case.
pub(super) fn kept(reduction: &ReductionSettings, structure: &Structure) -> Result<Vec<usize>, Unbuilt> {
    let freedoms = freedoms_of(reduction, structure)?;
    let all = structure.family.size();
    let what = match freedoms.len() {
        0 => "no freedom that is free",
        count if count == all => "all freedoms, which leaves nothing to reduce",
        _ => return Ok(freedoms),
    };
    Err(Unbuilt::new("reduction.kept", StructureProblem::KeptFreedoms { what }))
}

/// The same, which may be none or all.
pub(crate) fn freedoms_of(
    reduction: &ReductionSettings,
    structure: &Structure,
) -> Result<Vec<usize>, Unbuilt> {
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
    Ok(freedoms)
}

/// The points of the layout that nodes at the dotted path `path` of the case name, in their order.
pub(crate) fn points_of(nodes: &KeptNodes, structure: &Structure, path: &str) -> Result<Vec<usize>, Unbuilt> {
    match (nodes, &structure.layout) {
        (KeptNodes::Set(set), ..) => Ok(structure.set(set, &format!("{path}.set"))?.to_vec()),
        (KeptNodes::Numbers(nodes), Some(layout)) => {
            let point = |node: &usize| {
                let unknown = StructureProblem::UnknownNode { node: *node };
                let place = layout.names.iter().position(|name| name == node);
                place.ok_or_else(|| Unbuilt::new(format!("{path}.nodes"), unknown))
            };
            nodes.iter().map(point).collect()
        }
        _ => Ok(Vec::new()),
    }
}

fn of_nodes(kept: &KeptFreedoms, structure: &Structure, index: usize) -> Result<Vec<usize>, Unbuilt> {
    let Some(layout) = &structure.layout else { return Ok(Vec::new()) };
    let points = points_of(&kept.nodes, structure, &format!("reduction.kept.{index}"))?;
    let of_point = |point: &usize| {
        layout.freedoms[*point]
            .into_iter()
            .zip(kept.directions)
            .filter(|(_, taken)| *taken)
            .filter_map(|(k, _)| k)
    };
    Ok(points.iter().flat_map(of_point).collect())
}
