//! Rows of figures of motions, what they settle to, and branches.

use super::*;

/// Histories, a path and its events.
fn histories(random: &mut Random) -> (Vec<Variable>, Vec<Vec<Point>>) {
    let time = steps(24);
    let (mut runs, mut variables) = (Vec::new(), vec![Variable::coordinate("time", time.clone())]);
    for name in ["x", "relative_velocity", "contact_area"] {
        let values = random.gappy(24, 0.0);
        runs.push(run(&time, &values));
        variables.push(along(name, "time", values));
    }
    let (x, velocity) = (random.gappy(20, 0.0), random.gappy(20, 0.0));
    runs.push(run(&x, &velocity));
    variables.extend([
        along("velocity_x", "time", vec![0.0; 24]),
        along("contact_state", "time", vec![1_u8; 24]),
        along("oscillation_period", "oscillation", vec![50.0; 9]),
        along("path_time", "path_point", steps(20)),
        along("path_x", "path_point", x),
        along("path_velocity_x", "path_point", velocity),
        along("event_time", "event", vec![5.0, 9.0]),
        along("event_x", "event", vec![0.1, 0.2]),
        along("event_velocity_x", "event", vec![0.1, 0.2]),
        along("event_from", "event", vec![1_u8, 0]),
        along("event_to", "event", vec![0_u8, 1]),
    ]);
    (variables, runs)
}

pub(super) fn motion(seed: u64) -> Vec<Planted> {
    let mut random = Random(seed);
    let (mut variables, mut runs) = histories(&mut random);
    let (frequency, amplitude) = (steps(18), random.gappy(18, 0.5));
    runs.push(run(&frequency, &amplitude));
    variables.push(along("frequency", "frequency", frequency));
    variables.push(along("amplitude", "frequency", amplitude));
    variables.push(along("section_x", "oscillation", random.gappy(9, 0.0)));
    alone(dataset(variables, &[]), runs)
}

pub(super) fn limit_cycle(seed: u64) -> Vec<Planted> {
    let (mut variables, runs) = histories(&mut Random(seed));
    let multipliers = vec![Complex64::new(1.0, 0.0), Complex64::new(0.2, 0.1)];
    variables.push(along("floquet_multipliers", "multiplier", multipliers));
    vec![Planted { dataset: dataset(variables, &[]), runs, shapes: &["unit circle"] }]
}

/// What motions settle to, without branches: nothing is known between them.
fn settled(random: &mut Random) -> Vec<Variable> {
    let texts = |values: [&str; 2]| values.map(str::to_owned).to_vec();
    let mut variables = vec![
        Variable::coordinate("direction", texts(["forward", "backward"])),
        Variable::coordinate("load", steps(8)),
    ];
    for name in ["rms", "stick_fraction", "lift_off_fraction"] {
        variables.push(over(name, &["direction", "load"], &[2, 8], random.gappy(16, 0.1)));
    }
    let becomes: Vec<u8> = (0..16).map(|_| (3.0 * random.next()) as u8).collect();
    variables.extend([
        over("becomes", &["direction", "load"], &[2, 8], becomes),
        along("section_value", "section", vec![1.0, 2.0]),
        along("section_x", "section", vec![0.1, 0.2]),
        along("section_direction", "section", texts(["forward", "backward"])),
    ]);
    variables
}

/// A diagram with branches: its variables, what may be joined, and the cycles that are stable.
fn branched(seed: u64) -> (Vec<Variable>, Vec<Vec<Point>>, Vec<Point>) {
    let mut random = Random(seed);
    let mut variables = settled(&mut random);
    let (mut value, mut rms, mut stable, mut number) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
    let mut runs: Vec<Vec<Point>> = Vec::new();
    for branch in 0..1 + (4.0 * random.next()) as i64 {
        let mut points = Vec::new();
        for _ in 0..1 + (8.0 * random.next()) as usize {
            points.push((random.next(), if random.is(0.1) { NAN } else { random.next() }));
            stable.push(u8::from(random.is(0.5)));
            number.push(branch);
        }
        value.extend(points.iter().map(|point| point.0));
        rms.extend(points.iter().map(|point| point.1));
        runs.push(points);
    }
    let steady: Vec<f64> = steps(12).iter().map(|step| 10.0 + step).collect();
    let rate: Vec<f64> = (0..12).map(|_| if random.is(0.2) { NAN } else { random.next() - 0.5 }).collect();
    runs.push(
        steady.iter().zip(&rate).map(|(at, rate)| (*at, if rate.is_nan() { NAN } else { 0.0 })).collect(),
    );
    let is_stable = |k: &usize| stable[*k] == 1;
    let known: Vec<Point> = (0..value.len()).filter(is_stable).map(|k| (value[k], rms[k])).collect();
    variables.extend([
        along("branch_value", "branch_point", value),
        along("branch_rms", "branch_point", rms),
        along("branch_stable", "branch_point", stable),
        along("branch_number", "branch_point", number),
        along("steady_value", "steady_point", steady),
        along("growth_rate", "steady_point", rate),
        along("hopf_value", "hopf_point", vec![0.5]),
        along("fold_value", "fold", vec![0.5]),
        along("fold_rms", "fold", vec![0.5]),
    ]);
    (variables, runs, known)
}

pub(in crate::pictures) fn diagram(seed: u64) -> (Dataset, Vec<Point>) {
    let (variables, _, stable) = branched(seed);
    (dataset(variables, &[("kind", json!("bifurcation"))]), stable)
}

pub(super) fn bifurcation(seed: u64) -> Vec<Planted> {
    let (variables, runs, _) = branched(seed);
    let simulated = dataset(settled(&mut Random(seed)), &[]);
    let branched = Planted { dataset: dataset(variables, &[]), runs, shapes: &[] };
    vec![branched, Planted { dataset: simulated, runs: Vec::new(), shapes: &[] }]
}

pub(super) fn basin(seed: u64) -> Vec<Planted> {
    let mut random = Random(seed);
    let variables = vec![
        along("x", "start", random.gappy(9, 0.0)),
        along("settling_time", "start", random.gappy(9, 0.0)),
        along("fate", "start", vec![0_u8, 1, 0, 1, 2, 0, 1, 0, 3]),
    ];
    alone(dataset(variables, &[("drawn", json!(["x"]))]), Vec::new())
}

pub(super) fn engines(seed: u64) -> Vec<Planted> {
    let mut random = Random(seed);
    let (mut runs, mut variables) = (Vec::new(), Vec::new());
    for (varied, engine) in [("time_step", "time_stepping"), ("width", "smoothed")] {
        let steps = steps(7);
        for quantity in ["rms", "period"] {
            let errors = random.gappy(7, -0.5);
            runs.push(run(&steps, &errors.iter().map(|error| error.abs()).collect::<Vec<_>>()));
            variables.push(along(&format!("{engine}_{quantity}_error"), varied, errors));
        }
        variables.insert(0, Variable::coordinate(varied, steps));
    }
    vec![Planted { dataset: dataset(variables, &[]), runs, shapes: &["first order"] }]
}
