//! The pictures of what motions become: along a key, and over their starts.

#![deny(clippy::indexing_slicing, reason = "stored arrays may be of any length")]

use super::{above_rounding, markers, of_direction, with_room};
use crate::motion::becomes::{BECOMES, CYCLE, IRREGULAR, UNCONFIRMED};
use crate::motion::bifurcation::branch_layers as branches;
use crate::motion::si;
use judder_numerics::order::sort_numbers;
use judder_report::{Axis, Layer, Legend, Panel, Role};
use judder_study::pictures::{StoredArrays, axis, codes, reals, text, words};

/// Starts of a basin that are shown at most.
const MOST_STARTS: usize = 4000;

/// rms, largest x, shares of stick and lift-off along the swept key.
pub(crate) fn bifurcation(dataset: &StoredArrays<'_>) -> Option<Vec<Panel>> {
    let shown = si::shown(dataset.dataset());
    let dataset = &dataset.replaced(&shown);
    dataset.shaped("rms", &[None, None])?;
    dataset.over("direction", &["direction"])?;
    dataset.alike(&["rms", "becomes", "stick_fraction", "lift_off_fraction"])?;
    let rms = dataset.variable("rms")?;
    let swept = dataset.variable(rms.dimensions.last()?)?;
    let values = reals(dataset, &swept.name)?;
    let directions = words(dataset, "direction")?;
    let (first, last) = (*values.first()?, *values.last()?);
    let along = || with_room(axis(swept), first.min(last), first.max(last));
    let branches = branches::layers(dataset);
    let has_branches = branches.is_some();
    let (mut amplitude, mut shares) = (branches.unwrap_or_default(), Vec::new());
    // the way up on top of the way down, and smaller: both are seen where they agree
    for (k, direction) in directions.iter().enumerate().rev() {
        let of = |name: &str| -> Option<Vec<f64>> {
            Some(reals(dataset, name)?.get(k * values.len()..(k + 1) * values.len())?.to_vec())
        };
        // neighbours may have settled to different motions: nothing is known between them
        amplitude.push(Layer::points(
            direction,
            values.to_vec(),
            of("rms")?,
            of_direction(Role::Series(k), k),
        ));
        let becomes = codes(dataset, "becomes")?.get(k * values.len()..(k + 1) * values.len())?;
        for (code, series) in [(IRREGULAR, 4), (UNCONFIRMED, 6)] {
            let word = BECOMES.get(usize::from(code))?.1;
            let of_kind = of("rms")?.into_iter().zip(becomes);
            let marked: Vec<f64> =
                of_kind.map(|(rms, becomes)| if *becomes == code { rms } else { f64::NAN }).collect();
            if marked.iter().any(|rms| rms.is_finite()) {
                let label = format!("{direction}, {word}");
                let style = of_direction(Role::Series(series + k), k);
                amplitude.push(Layer::points(label, values.to_vec(), marked, style));
            }
        }
        for (name, label, series) in [("stick_fraction", "stick", 0), ("lift_off_fraction", "lift-off", 2)] {
            let label = format!("{label}, {direction}");
            let style = of_direction(Role::Series(series + k), k);
            shares.push(Layer::points(label, values.to_vec(), of(name)?, style));
        }
    }
    let mut panels = vec![
        Panel::new(
            along(),
            amplitude_axis(text(rms, "label"), &settled_rms(dataset)?, has_branches),
            amplitude,
        ),
        Panel::new(along(), Axis::linear("Share of the time (−)"), shares),
    ];
    panels.extend(largest(dataset, directions, along()));
    Some(panels)
}

/// The rms of every cycle, or where there is none of every motion: that of a motion that has not settled can be as small as it likes.
fn settled_rms(dataset: &StoredArrays<'_>) -> Option<Vec<f64>> {
    let (rms, becomes) = (reals(dataset, "rms")?, codes(dataset, "becomes")?);
    let cycles: Vec<f64> =
        rms.iter().zip(becomes).filter(|(_, b)| **b == CYCLE).map(|(rms, _)| *rms).collect();
    Some(if cycles.is_empty() { rms.to_vec() } else { cycles })
}

/// Amplitudes that differ by more than this ask for a logarithmic axis.
const WIDE: f64 = 100.0;
/// Where branches are drawn, down to cycles of no amplitude, less is enough.
const WIDE_WITH_BRANCHES: f64 = 10.0;

/// The axis of an rms: logarithmic where motions differ widely; then steady sliding, with none, is a gap, or where its own line is
/// drawn the end of an axis that is linear next to zero.
fn amplitude_axis(label: Option<&str>, rms: &[f64], has_branches: bool) -> Axis {
    let moving = || rms.iter().copied().filter(|rms| *rms > 0.0);
    let (smallest, largest) = (moving().fold(f64::INFINITY, f64::min), moving().fold(0.0, f64::max));
    let label = label.unwrap_or("rms of $x$ (−)");
    let wide = if has_branches { WIDE_WITH_BRANCHES } else { WIDE };
    match (largest > wide * smallest, has_branches) {
        (false, _) => Axis::linear(label),
        (true, false) => Axis::log(label),
        (true, true) => Axis::symmetric_log(label, smallest),
    }
}

/// The largest x of every oscillation along the swept key.
fn largest(dataset: &StoredArrays<'_>, directions: &[String], along: Axis) -> Option<Panel> {
    dataset.alike(&["section_value", "section_x", "section_direction"])?;
    let (values, x) = (reals(dataset, "section_value")?, reals(dataset, "section_x")?);
    // steady sliding alone crosses no section
    if x.is_empty() {
        return None;
    }
    let of = words(dataset, "section_direction")?;
    let layers = directions.iter().enumerate().rev().map(|(k, direction)| {
        let points =
            || values.iter().zip(x).zip(of).filter(|(_, own)| *own == direction).map(|(point, _)| point);
        let across: Vec<f64> = points().map(|(value, _)| *value).collect();
        let crowd = markers(Role::Series(k), across.len());
        let style = if k == 0 { Role::Series(k).crowded() } else { crowd };
        Layer::points(direction, across, points().map(|(_, x)| *x).collect(), style)
    });
    let label =
        text(dataset.variable("section_x")?, "label").unwrap_or("x").replace("Displacement", "Largest");
    let mut sizes: Vec<f64> = x.iter().map(|x| x.abs()).collect();
    sort_numbers(&mut sizes);
    let usual = sizes.get(sizes.len() / 2).copied().unwrap_or(0.0);
    let up = match sizes.last() {
        Some(largest) if usual > 0.0 && *largest > WIDE * usual => Axis::symmetric_log(label, usual),
        _ => above_rounding(Axis::linear(label), x, usual),
    };
    Some(Panel::new(along, up, layers.collect()).with_title("Poincaré section"))
}

/// The starts by what becomes of them, over the first two coordinates that were drawn.
pub(crate) fn basin(dataset: &StoredArrays<'_>) -> Option<Vec<Panel>> {
    let shown = si::shown(dataset.dataset());
    let dataset = &dataset.replaced(&shown);
    let drawn: Vec<&str> =
        dataset.attributes().get("drawn")?.as_array()?.iter().filter_map(serde_json::Value::as_str).collect();
    let first = *drawn.first()?;
    let second = drawn.get(1).copied().unwrap_or("settling_time");
    dataset.alike(&["fate", first, second])?;
    let (x, y, fate) = (reals(dataset, first)?, reals(dataset, second)?, codes(dataset, "fate")?);
    let layers = BECOMES.iter().filter(|(code, _)| fate.contains(code)).map(|(code, label)| {
        let starts = x.iter().zip(y).zip(fate).take(MOST_STARTS);
        let (across, up) = starts.filter(|(_, own)| *own == code).map(|((x, y), _)| (*x, *y)).unzip();
        let style = markers(Role::Series(usize::from(*code)), fate.len());
        Layer::points(*label, across, up, style)
    });
    let along = |name: &str| dataset.variable(name).map(axis);
    Some(vec![Panel::new(along(first)?, along(second)?, layers.collect()).with_legend(Legend::Below)])
}
