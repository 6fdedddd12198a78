//! The branches of a bifurcation diagram: cycles and steady sliding, stable solid, unstable dashed.

#![deny(clippy::indexing_slicing, reason = "stored arrays may be of any length")]

use judder_report::palette::{Marker, Style};
use judder_report::runs::through;
use judder_report::{Layer, Role};
use judder_study::pictures::{StoredArrays, at, codes, reals, wholes};

/// What single points are over.
const OVER: [(&str, &str); 5] = [
    ("steady_value", "steady_point"),
    ("growth_rate", "steady_point"),
    ("fold_value", "fold"),
    ("fold_rms", "fold"),
    ("hopf_value", "hopf_point"),
];

/// The branches under the simulated motions, and the folds and Hopf points on them; `None` where none were followed.
pub(crate) fn layers(dataset: &StoredArrays<'_>) -> Option<Vec<Layer>> {
    dataset.alike(&["branch_value", "branch_rms", "branch_stable", "branch_number"])?;
    for (name, dimension) in OVER {
        dataset.over(name, &[dimension])?;
    }
    let along = |name: &str| reals(dataset, name).map(<[f64]>::to_vec);
    let (value, rms) = (reals(dataset, "branch_value")?, reals(dataset, "branch_rms")?);
    let stable: Vec<bool> = codes(dataset, "branch_stable")?.iter().map(|code| *code == 1).collect();
    let number = wholes(dataset, "branch_number")?;
    let (steady_value, growth) = (reals(dataset, "steady_value")?, reals(dataset, "growth_rate")?);
    let at_rest = vec![0.0; growth.len()];
    let pair = |list: &[bool], k: usize| list.get(k).copied().zip(list.get(k + 1).copied());
    let rests: Vec<bool> = growth.iter().map(|rate| *rate < 0.0).collect();
    let has_state = |k: usize| at(growth, k).is_finite() && at(growth, k + 1).is_finite();
    let is_of = |list: &[bool], k: usize, wanted: bool| {
        pair(list, k).is_some_and(|(own, next)| (own && next) == wanted)
    };
    let is_one = |k: usize| number.get(k).is_some_and(|own| number.get(k + 1) == Some(own));
    let mut layers = Vec::new();
    for (is_stable, cycles, sliding) in [
        (true, "stable cycles", "stable steady sliding"),
        (false, "unstable cycles", "unstable steady sliding"),
    ] {
        let style = |role: Role| if is_stable { role.solid() } else { role.dashed() };
        let line = |label: &str, role: Role, (x, y): (Vec<f64>, Vec<f64>)| {
            (!x.is_empty()).then(|| Layer::line(label, x, y, Style { width: 1.0, ..style(role) }))
        };
        let sliding_runs = through(steady_value, &at_rest, |k| has_state(k) && is_of(&rests, k, is_stable));
        layers.extend(line(sliding, Role::Reference, sliding_runs));
        let cycle_runs = through(value, rms, |k| is_one(k) && is_of(&stable, k, is_stable));
        layers.extend(line(cycles, Role::FullBoundary, cycle_runs));
    }
    let hopf = along("hopf_value")?;
    let at_rest = vec![0.0; hopf.len()];
    // of the branch's own colour: no kind of motion, no direction has it
    for (label, across, up, marker) in [
        ("Hopf points", hopf, at_rest, Marker::Diamond),
        ("folds", along("fold_value")?, along("fold_rms")?, Marker::Cross),
    ] {
        if !across.is_empty() {
            layers.push(Layer::points(
                label,
                across,
                up,
                Style { marker, ..Style::from(Role::FullBoundary) },
            ));
        }
    }
    Some(layers)
}
