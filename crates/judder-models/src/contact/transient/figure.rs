//! Histories of a contact that is followed in time.

#![deny(clippy::indexing_slicing, reason = "stored arrays may be of any length")]

use crate::contact::drawn_unit::DrawnUnit;
use judder_report::{Axis, Layer, Panel, Role};
use judder_study::pictures::{StoredArrays, reals};

/// What a force is over.
const FORCE: &str = "($E_{0}$* $R$²)";

/// Force and friction force, area; the loop of a cycle where the path repeats itself.
pub(crate) fn transient(dataset: &StoredArrays<'_>) -> Option<Vec<Panel>> {
    dataset.alike(&["time", "position", "indentation", "force", "friction_force", "area"])?;
    let drawn = |name: &str, over| {
        let unit = DrawnUnit::of(dataset, name, over)?;
        Some((unit.values(reals(dataset, name)?), unit))
    };
    let (time, seconds) = drawn("time", "$τ$")?;
    let (force, newtons) = drawn("force", FORCE)?;
    let (area, square) = drawn("area", "$R$²")?;
    let friction = reals(dataset, "friction_force")?;
    let horizontal = || Axis::linear(seconds.label("Time $t$"));
    let line = |label: &str, over: &[f64], up: Vec<f64>, series: usize| {
        Layer::line(label, over.to_vec(), up, Role::Series(series).solid())
    };
    let forces = vec![
        line("normal force", &time, force.clone(), 0),
        line("friction force", &time, newtons.values(friction), 1),
    ];
    let mut panels = vec![
        Panel::new(horizontal(), Axis::linear(newtons.label("Force $F$")), forces),
        Panel::new(horizontal(), Axis::linear(square.label("Area $A$")), vec![line("", &time, area, 2)]),
    ];
    let over = dataset.attributes().get("loop_over").and_then(|over| over.as_str()).unwrap_or_default();
    let (up, upwards, across) = match over {
        "position" => {
            let (friction, unit) = drawn("friction_force", FORCE)?;
            (friction, unit.label("Friction force"), "Position $x$")
        }
        "indentation" => (force, newtons.label("Force $F$"), "Indentation $δ$"),
        _ => return Some(panels),
    };
    let (places, unit) = drawn(over, "$R$")?;
    let cycle = vec![line("", &places, up, 3)];
    panels.push(Panel::new(Axis::linear(unit.label(across)), Axis::linear(upwards), cycle));
    Some(panels)
}
