//! Observed points as forms on the freedoms of an assembly.

use super::{BuiltBody, Unassembled};
use crate::assembly::case::AssemblyCase;
use crate::structure::build::points_of;
use judder_assembly::row::Row;
use judder_structure::freedom::Direction;

/// The displacement of an observed point along one direction.
pub(crate) struct WatchedRow {
    /// As signals call it, such as `edge.x`.
    pub(crate) name: String,
    pub(crate) row: Row,
}

/// The observed points of a case, along the directions in which they move.
pub(super) fn watched(case: &AssemblyCase, bodies: &[BuiltBody]) -> Result<Vec<WatchedRow>, Unassembled> {
    let mut all = Vec::new();
    for own in &case.watched {
        let body = &bodies[*own.nodes.structure];
        let path = format!("observe.points.{}", own.name);
        let points = points_of(&own.nodes.nodes, &body.structure, &path)?;
        let share = 1.0 / points.len().max(1) as f64;
        for direction in Direction::ALL {
            let forms: Vec<Row> = points.iter().map(|point| body.seen(*point, direction)).collect();
            let row = Row::sum(forms.iter().map(|form| (share, form)));
            if !row.is_empty() {
                all.push(WatchedRow { name: format!("{}.{}", own.name, direction.name()), row });
            }
        }
    }
    Ok(all)
}
