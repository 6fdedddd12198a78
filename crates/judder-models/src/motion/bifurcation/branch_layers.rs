//! The branches of a bifurcation diagram: cycles and steady sliding, stable solid, unstable dashed.

use judder_report::palette::{Marker, Style};
use judder_report::runs::through;
use judder_report::{Layer, Role};
use judder_store::{Dataset, VariableValues};
use judder_study::pictures::{codes, reals};

/// The branches under the simulated motions, and the folds and Hopf points on them; `None` where none were followed.
pub(crate) fn layers(dataset: &Dataset) -> Option<Vec<Layer>> {
    let along = |name: &str| reals(dataset, name).map(<[f64]>::to_vec);
    let (value, rms) = (reals(dataset, "branch_value")?, reals(dataset, "branch_rms")?);
    let stable: Vec<bool> = codes(dataset, "branch_stable")?.iter().map(|code| *code == 1).collect();
    let VariableValues::I64(number) = &dataset.variable("branch_number")?.data else { return None };
    let (steady_value, growth) = (reals(dataset, "steady_value")?, reals(dataset, "growth_rate")?);
    let at_rest = vec![0.0; growth.len()];
    let rests: Vec<bool> = growth.iter().map(|rate| *rate < 0.0).collect();
    let has_state = |k: usize| growth[k].is_finite() && growth[k + 1].is_finite();
    let mut layers = Vec::new();
    for (is_stable, cycles, sliding) in [
        (true, "stable cycles", "stable steady sliding"),
        (false, "unstable cycles", "unstable steady sliding"),
    ] {
        let style = |role: Role| if is_stable { role.solid() } else { role.dashed() };
        let line = |label: &str, role: Role, (x, y): (Vec<f64>, Vec<f64>)| {
            (!x.is_empty()).then(|| Layer::line(label, x, y, Style { width: 1.0, ..style(role) }))
        };
        let sliding_runs =
            through(steady_value, &at_rest, |k| has_state(k) && (rests[k] && rests[k + 1]) == is_stable);
        layers.extend(line(sliding, Role::Reference, sliding_runs));
        let cycle_runs =
            through(value, rms, |k| number[k] == number[k + 1] && (stable[k] && stable[k + 1]) == is_stable);
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
