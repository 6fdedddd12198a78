//! What is known of a pair before anything is computed.

use crate::sliding::case::SlidingCase;
use crate::sliding::march::settings::{CUT_OFF, MarchAnalysis};
use crate::sliding::system::{self, ReducedPair};
use judder_numerics::order::sort_numbers;
use judder_sliding::SlidingError;
use judder_sliding::coupling::{Coupling, SteadyFriction};
use judder_sliding::march::ContactMethod;
use judder_sliding::statics::PairEquilibrium;
use judder_study::text::{columns, number};
use serde_json::{Value, json};
use std::f64::consts::TAU;

/// The pair as a document and in words, with what speaks against it.
pub(super) struct KnownPair {
    pub(super) document: Value,
    pub(super) text: String,
    pub(super) warnings: Vec<String>,
}

pub(super) fn known(case: &SlidingCase, system: &ReducedPair) -> KnownPair {
    let mut text = "\nstructures\n".to_owned();
    let head = ["", "degrees of freedom", "kept", "fixed-interface modes", "modes", "highest (Hz)"];
    let mut rows = vec![head.map(str::to_owned).to_vec()];
    let mut structures = Vec::new();
    for (part, own) in system.parts.iter().zip(&case.structures[..]) {
        let eigenvalues = &part.reduced.body.eigenvalues;
        let highest = eigenvalues.last().copied().unwrap_or(0.0).sqrt() / TAU;
        let counts = [part.structure.family.size(), part.kept.len(), part.fixed_modes, eigenvalues.len()];
        let mut row = vec![own.name.to_string()];
        row.extend(counts.map(|count| count.to_string()));
        row.push(number(highest));
        rows.push(row);
        structures.push(json!({
            "name": *own.name, "degrees_of_freedom": counts[0], "kept_freedoms": counts[1],
            "fixed_interface_modes": counts[2], "modes": counts[3], "highest_hz": highest,
            "alpha": part.reduced.body.alpha, "beta": part.reduced.body.beta,
        }));
    }
    text.push_str(&columns(&rows));
    let mut warnings = system.warnings.clone();
    warnings.extend(system.beyond_friction());
    let (pair, shown) = pair(case, system, &mut warnings);
    text.push_str(&shown);
    let (limits, shown) = limits(case, system);
    text.push_str(&shown);
    let document = json!({ "structures": structures, "pair": pair, "step_limits_s": limits });
    KnownPair { document, text, warnings }
}

/// Modes, track, gap at the start, states of rest.
fn pair(case: &SlidingCase, system: &ReducedPair, warnings: &mut Vec<String>) -> (Value, String) {
    let (pair, motion) = (&system.pair, &system.motion);
    let length = pair.node_positions().last().copied().unwrap_or_default();
    let gap = pair.undeformed(motion.start).map_or(f64::NAN, |touch| touch.gap + motion.initial_gap);
    let side = if pair.edge().side > 0.0 { "left" } else { "right" };
    let [x, y] = system.moved;
    let mut rows = vec![
        vec!["degrees of freedom".to_owned(), pair.modes().to_string()],
        vec!["track".to_owned(), format!("{} nodes, {} m", pair.edge().nodes, number(length))],
        vec!["the slider lies".to_owned(), format!("to the {side} of the track, from its first node on")],
        vec![
            "moved to the start".to_owned(),
            format!("`{}` by ({}, {}) m", case.slider().name, number(x), number(y)),
        ],
        vec!["gap at the start".to_owned(), format!("{} m", number(gap))],
    ];
    let sliding = SteadyFriction::at(pair.friction(), motion.velocity);
    let mut rests = Vec::new();
    for position in [motion.start, motion.end] {
        let place = format!("at {} m", number(position));
        match PairEquilibrium::new(pair, position, motion.load, sliding) {
            Ok(rest) => {
                let slope = libm::atan2(rest.touch.tangent[1], rest.touch.tangent[0])
                    - libm::atan2(pair.direction()[1], pair.direction()[0]);
                rows.push(vec![
                    format!("at rest {place}"),
                    format!(
                        "normal force {} N, edge turned by {} rad",
                        number(rest.normal_force),
                        number(slope)
                    ),
                ]);
                rests.push(
                    json!({ "position_m": position, "normal_force": rest.normal_force, "turn_rad": slope }),
                );
            }
            Err(error) => warnings.push(error.to_string()),
        }
    }
    if let Some(error) = locked(system, sliding) {
        warnings.push(error.to_string());
    }
    let document = json!({
        "degrees_of_freedom": pair.modes(), "track_nodes": pair.edge().nodes, "track_length_m": length,
        "side": side, "moved_m": system.moved, "gap_at_start_m": gap, "at_rest": rests,
    });
    (document, format!("\nthe pair\n{}", columns(&rows)))
}

/// Where the slider locks first, of all nodes on its path and the places between them.
fn locked(system: &ReducedPair, sliding: SteadyFriction) -> Option<SlidingError> {
    let (pair, motion) = (&system.pair, &system.motion);
    let (from, to) = (motion.start.min(motion.end), motion.start.max(motion.end));
    let nodes = pair.node_positions();
    let between = nodes.windows(2).map(|two| 0.5 * (two[0] + two[1]));
    let mut places: Vec<f64> =
        nodes.iter().copied().chain(between).filter(|place| *place > from && *place < to).collect();
    places.extend([from, to]);
    sort_numbers(&mut places);
    places.into_iter().find_map(|position| {
        let touch = pair.undeformed(position).ok()?;
        Coupling::new(pair, &touch, sliding).check(position, sliding.friction).err()
    })
}

/// The largest step of every method along the path, s.
fn limits(case: &SlidingCase, system: &ReducedPair) -> (Value, String) {
    let own =
        case.analyses.iter().find_map(|analysis| match analysis.settings::<MarchAnalysis>()?.method() {
            ContactMethod::ResidualFlexibility { cut_off } => Some(cut_off),
            _ => None,
        });
    let methods = [
        ("subs", ContactMethod::Subs { static_slope: false }),
        ("ensubs", ContactMethod::EnSubs),
        ("film", ContactMethod::Film),
        (
            "residual-flexibility",
            ContactMethod::ResidualFlexibility { cut_off: own.unwrap_or(CUT_OFF / TAU) },
        ),
    ];
    let mut rows = Vec::new();
    let mut document = serde_json::Map::new();
    for (name, method) in methods {
        let (value, shown) = match system::step(&system.pair, method, None, system.motion) {
            Ok(step) => (json!(step.limit), format!("{} s", number(step.limit))),
            Err(error) => (Value::Null, error.to_string()),
        };
        rows.push(vec![name.to_owned(), shown]);
        document.insert(name.to_owned(), value);
    }
    (Value::Object(document), format!("\nlargest stable steps of marches\n{}", columns(&rows)))
}
