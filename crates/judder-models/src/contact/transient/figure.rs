//! Histories of a contact that is followed in time.

#![deny(clippy::indexing_slicing, reason = "stored arrays may be of any length")]

use judder_report::{Axis, Layer, Panel, Role};
use judder_study::pictures::{StoredArrays, axis, reals};

/// Force and friction force, area; the loop of a cycle where the path repeats itself.
pub(crate) fn transient(dataset: &StoredArrays<'_>) -> Option<Vec<Panel>> {
    dataset.alike(&["time", "position", "indentation", "force", "friction_force", "area"])?;
    let time = reals(dataset, "time")?;
    let horizontal = || dataset.variable("time").map(axis);
    let line = |over: &[f64], name: &str, label: &str, role: Role| {
        Some(Layer::line(label, over.to_vec(), reals(dataset, name)?.to_vec(), role.solid()))
    };
    let forces = vec![
        line(time, "force", "normal force", Role::Series(0))?,
        line(time, "friction_force", "friction force", Role::Series(1))?,
    ];
    let area = vec![line(time, "area", "", Role::Series(2))?];
    let mut panels = vec![
        Panel::new(horizontal()?, Axis::linear("Force $F$/($E_{0}$* $R$²) (−)"), forces),
        Panel::new(horizontal()?, Axis::linear("Area $A$/$R$² (−)"), area),
    ];
    let over = dataset.attributes().get("loop_over").and_then(|over| over.as_str()).unwrap_or_default();
    let (name, across, up) = match over {
        "position" => ("friction_force", "Position $x$/$R$ (−)", "Friction force/($E_{0}$* $R$²) (−)"),
        "indentation" => ("force", "Indentation $δ$/$R$ (−)", "Force $F$/($E_{0}$* $R$²) (−)"),
        _ => return Some(panels),
    };
    let cycle = vec![line(reals(dataset, over)?, name, "", Role::Series(3))?];
    panels.push(Panel::new(Axis::linear(across), Axis::linear(up), cycle));
    Some(panels)
}
