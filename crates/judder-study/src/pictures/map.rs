//! Stability maps.

use super::{axis, reals};
use judder_oscillator::mechanism::StabilityClass;
use judder_report::figure::{Class, ClassMap};
use judder_report::{Layer, Panel, Role};
use judder_store::{Data, Dataset};

/// Colour and legend of a class; `neither` names what is neither flutter nor negative damping.
fn class(class: StabilityClass, neither: &str) -> Class {
    let (label, role) = match class {
        StabilityClass::Stable => ("stable", Role::Stable),
        StabilityClass::Flutter => ("flutter", Role::Flutter),
        StabilityClass::NegativeDamping => ("negative damping", Role::NegativeDamping),
        StabilityClass::Both => ("both", Role::Both),
        StabilityClass::NormalForceCoupling => (neither, Role::NormalForceCoupling),
        StabilityClass::Marginal => ("marginal", Role::Reference),
        StabilityClass::Unresolved => ("unresolved", Role::Unresolved),
    };
    Class::new(label, role)
}

/// Mechanisms by colour, boundaries on top.
pub(super) fn stability_map(dataset: &Dataset) -> Option<Panel> {
    let map = dataset.variable("stability")?;
    let [y_name, x_name] = map.dimensions.as_slice() else { return None };
    let Data::U8(codes) = &map.data else { return None };
    let (x, y) = (dataset.variable(x_name)?, dataset.variable(y_name)?);
    let (columns, rows) = (reals(dataset, x_name)?, reals(dataset, y_name)?);
    let neither = match dataset.attributes().get("neither").and_then(|name| name.as_str()) {
        Some("destabilised-by-damping") => "destabilised by damping",
        _ => "normal-force coupling",
    };
    let mut layers = vec![Layer::Classes(ascending(columns, rows, codes, neither))];
    for (name, label, role) in [
        ("decoupled_boundary", "boundary for $η = 0$", Role::DecoupledBoundary),
        ("full_boundary", "boundary, full system", Role::FullBoundary),
        ("conservative_boundary", "boundary without damping", Role::ConservativeBoundary),
    ] {
        let along = |quantity: &str| reals(dataset, &format!("{name}_{quantity}"));
        if let (Some(x), Some(y)) = (along(x_name), along(y_name))
            && !x.is_empty()
        {
            layers.push(Layer::line(label, x.to_vec(), y.to_vec(), role));
        }
    }
    Some(Panel::new(axis(x), axis(y), layers))
}

/// Points along each side of a drawn map: more than a panel has pixels would only make the page heavy.
const DRAWN_SIDE: usize = 400;

/// The class map with ascending axes, whichever way they were swept, and only the classes that occur.
fn ascending(columns: &[f64], rows: &[f64], codes: &[u8], neither: &str) -> ClassMap {
    let order = |values: &[f64]| {
        let mut indices: Vec<usize> = (0..values.len()).collect();
        indices.sort_by(|a, b| values[*a].total_cmp(&values[*b]));
        let drawn = indices.len().min(DRAWN_SIDE);
        (0..drawn).map(|k| indices[k * (indices.len() - 1) / (drawn - 1).max(1)]).collect::<Vec<usize>>()
    };
    let (across, up) = (order(columns), order(rows));
    let present: Vec<StabilityClass> =
        StabilityClass::ALL.into_iter().filter(|class| codes.contains(&(*class as u8))).collect();
    let index = |code: u8| present.iter().position(|class| *class as u8 == code).unwrap_or(0) as u8;
    let at = |row: &usize, column: &usize| index(codes[row * columns.len() + column]);
    ClassMap {
        x: across.iter().map(|k| columns[*k]).collect(),
        y: up.iter().map(|k| rows[*k]).collect(),
        codes: up.iter().flat_map(|row| across.iter().map(move |column| at(row, column))).collect(),
        classes: present.into_iter().map(|c| class(c, neither)).collect(),
    }
}
