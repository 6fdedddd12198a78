//! The branches of a bifurcation diagram: cycles and steady sliding, stable solid, unstable dashed.

use super::{codes, reals};
use judder_report::palette::Style;
use judder_report::{Layer, Role};
use judder_store::{Data, Dataset};

/// The branches under the simulated motions, and the folds and Hopf points on them; `None` where none were followed.
pub(super) fn layers(dataset: &Dataset) -> Option<Vec<Layer>> {
    let along = |name: &str| reals(dataset, name).map(<[f64]>::to_vec);
    let (value, rms) = (reals(dataset, "branch_value")?, reals(dataset, "branch_rms")?);
    let stable: Vec<bool> = codes(dataset, "branch_stable")?.iter().map(|code| *code == 1).collect();
    let Data::I64(number) = &dataset.variable("branch_number")?.data else { return None };
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
            runs(steady_value, &at_rest, |k| has_state(k) && (rests[k] && rests[k + 1]) == is_stable);
        layers.extend(line(sliding, Role::Reference, sliding_runs));
        let cycle_runs =
            runs(value, rms, |k| number[k] == number[k + 1] && (stable[k] && stable[k + 1]) == is_stable);
        layers.extend(line(cycles, Role::FullBoundary, cycle_runs));
    }
    let hopf = along("hopf_value")?;
    let at_rest = vec![0.0; hopf.len()];
    layers.push(Layer::points("Hopf points", hopf, at_rest, Role::Series(3)));
    layers.push(Layer::points("folds", along("fold_value")?, along("fold_rms")?, Role::Series(2)));
    Some(layers)
}

/// The segments from one point to the next that are wanted, with gaps between their runs.
fn runs(x: &[f64], y: &[f64], is_wanted: impl Fn(usize) -> bool) -> (Vec<f64>, Vec<f64>) {
    let (mut across, mut up) = (Vec::new(), Vec::new());
    let mut is_open = false;
    for k in 0..x.len().saturating_sub(1) {
        if !is_wanted(k) {
            is_open = false;
            continue;
        }
        if !is_open {
            across.extend([f64::NAN, x[k]]);
            up.extend([f64::NAN, y[k]]);
        }
        across.push(x[k + 1]);
        up.push(y[k + 1]);
        is_open = true;
    }
    (across, up)
}
