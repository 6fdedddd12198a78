//! Stability maps.

#![deny(clippy::indexing_slicing, reason = "stored arrays may be of any length")]

use super::{NONE_MOVED, ONE_WAY, STARTS_IT, UNKNOWN, WITHIN_LAW};
use judder_oscillator::map::LawStanding;
use judder_oscillator::mechanism::StabilityClass;
use judder_report::figure::{Class, ClassMap};
use judder_report::{Layer, Panel, Role};
use judder_study::pictures::{StoredArrays, ascending_order, axis, codes as stored_codes, picked, reals};

/// Colour and legend of a class; `one_way` names the coupling of the directions by speed.
fn class(class: StabilityClass, one_way: &str) -> Class {
    let (label, role) = match class {
        StabilityClass::Stable => ("stable", Role::Stable),
        StabilityClass::Flutter => ("flutter", Role::Flutter),
        StabilityClass::NegativeDamping => ("negative damping", Role::NegativeDamping),
        StabilityClass::Both => ("both", Role::Both),
        StabilityClass::NormalForceCoupling => (one_way, Role::NormalForceCoupling),
        StabilityClass::DestabilisedByDamping => ("destabilised by damping", Role::DestabilisedByDamping),
        StabilityClass::Marginal => ("marginal", Role::Reference),
        StabilityClass::Unresolved => ("unresolved", Role::Unresolved),
    };
    Class::new(label, role)
}

/// Mechanisms by colour, boundaries on top.
pub(crate) fn stability_map(dataset: &StoredArrays<'_>) -> Option<Vec<Panel>> {
    dataset.shaped("stability", &[None, None])?;
    dataset.alike(&["stability", "knock", WITHIN_LAW])?;
    let codes = stored_codes(dataset, "stability")?;
    let [y_name, x_name] = dataset.variable("stability")?.dimensions.as_slice() else { return None };
    let (x, y) = (dataset.variable(x_name)?, dataset.variable(y_name)?);
    let (columns, rows) = (reals(dataset, x_name)?, reals(dataset, y_name)?);
    let one_way = match dataset.attributes().get("one_way").and_then(|name| name.as_str()) {
        Some(ONE_WAY) => "one-way coupling by speed",
        _ => "normal-force coupling",
    };
    let (codes, mut classes) = drawn_classes(codes, stored_codes(dataset, "knock"), one_way);
    let codes = match stored_codes(dataset, WITHIN_LAW) {
        Some(standing) => without_verdict(codes, &mut classes, standing),
        None => codes,
    };
    let mut layers = vec![Layer::Classes(ascending(columns, rows, &codes, classes))];
    for (name, label, role) in [
        ("decoupled_boundary", "boundary for $η = 0$", Role::DecoupledBoundary),
        ("full_boundary", "boundary, full system", Role::FullBoundary),
        ("conservative_boundary", "boundary without damping", Role::ConservativeBoundary),
    ] {
        let of = |quantity: &str| format!("{name}_{quantity}");
        for name_of in [x_name, y_name] {
            dataset.over(&of(name_of), &[&format!("{name}_point")])?;
        }
        let along = |quantity: &str| reals(dataset, &of(quantity));
        if let (Some(x), Some(y)) = (along(x_name), along(y_name))
            && !x.is_empty()
        {
            layers.push(Layer::line(label, x.to_vec(), y.to_vec(), role));
        }
    }
    let fold = [x_name, y_name].map(|name| format!("fold_{name}"));
    for name in &fold {
        dataset.over(name, &["fold"])?;
    }
    if let (Some(x), Some(y)) = (reals(dataset, &fold[0]), reals(dataset, &fold[1]))
        && !x.is_empty()
    {
        layers.push(Layer::points("least known fold", x.to_vec(), y.to_vec(), Role::FullBoundary));
    }
    Some(vec![Panel::new(axis(x), axis(y), layers)])
}

/// The classes that occur, and every point's place among them: the stable ones told apart by what a knock does there.
fn drawn_classes(codes: &[u8], knock: Option<&[u8]>, one_way: &str) -> (Vec<u8>, Vec<Class>) {
    let third = [
        (STARTS_IT, "stable, but a knock starts it", Role::Knock),
        (UNKNOWN, "stable, effect of a knock unknown", Role::KnockUnknown),
        (NONE_MOVED, "stable, no start of a search moved", Role::Stable),
    ];
    let keys: Vec<(u8, u8)> = match knock {
        Some(knock) => codes.iter().copied().zip(knock.iter().copied()).collect(),
        None => codes.iter().map(|code| (*code, 0)).collect(),
    };
    let mut classes: Vec<((u8, u8), Class)> = StabilityClass::ALL
        .into_iter()
        .map(|stability| ((stability as u8, 0), class(stability, one_way)))
        .collect();
    let stable = StabilityClass::Stable as u8;
    classes.splice(1..1, third.map(|(code, label, role)| ((stable, code), Class::new(label, role))));
    classes.retain(|(key, _)| keys.contains(key));
    let place = |key: (u8, u8)| classes.iter().position(|class| class.0 == key).unwrap_or(0) as u8;
    let places = keys.into_iter().map(place).collect();
    (places, classes.into_iter().map(|(_, class)| class).collect())
}

/// The places with one more class, for points whose verdict the errors of the law decide: none of theirs is drawn. The classes that still occur stay.
fn without_verdict(mut places: Vec<u8>, classes: &mut Vec<Class>, standing: &[u8]) -> Vec<u8> {
    let marginal = classes.len() as u8;
    for (place, standing) in places.iter_mut().zip(standing) {
        if *standing == LawStanding::Marginal as u8 {
            *place = marginal;
        }
    }
    classes.push(Class::new("marginal within the law", Role::WithinLaw));
    let kept: Vec<u8> = (0..=marginal).filter(|place| places.contains(place)).collect();
    *classes = kept.iter().filter_map(|place| classes.get(usize::from(*place)).cloned()).collect();
    let place = |old: &u8| kept.iter().position(|kept| kept == old).unwrap_or(0) as u8;
    places.iter().map(place).collect()
}

/// The class map with ascending axes.
pub(crate) fn ascending(columns: &[f64], rows: &[f64], codes: &[u8], classes: Vec<Class>) -> ClassMap {
    let (across, up) = (ascending_order(columns), ascending_order(rows));
    let code =
        |row: &usize, column: &usize| codes.get(row * columns.len() + column).copied().unwrap_or_default();
    ClassMap {
        x: picked(columns, &across),
        y: picked(rows, &up),
        codes: up.iter().flat_map(|row| across.iter().map(move |column| code(row, column))).collect(),
        classes,
    }
}
