//! Rows of figures of contacts, laws and moduli.

use super::*;

pub(super) fn contact(seed: u64) -> Vec<Planted> {
    let mut random = Random(seed);
    let side: Vec<f64> = steps(6).iter().map(|step| step - 3.2).collect();
    let pressure: Vec<f64> = (0..36).map(|_| if random.is(0.5) { random.next() } else { 0.0 }).collect();
    let cells: Vec<f64> = steps(8).iter().map(|step| 1.0 / step).collect();
    let level = |random: &mut Random| -> Vec<f64> {
        // grids without a value, and that which gave the value itself
        let value = |_| {
            if random.is(0.15) {
                1.0
            } else if random.is(0.15) {
                NAN
            } else {
                1.0 + random.next()
            }
        };
        (0..8).map(value).collect()
    };
    let levels = [level(&mut random), level(&mut random), level(&mut random)];
    let middle = &pressure[12..18];
    let mut runs = vec![run(&side, middle)];
    for values in &levels {
        let away = |value: &f64| if *value == 1.0 { NAN } else { value - 1.0 };
        runs.push(run(&cells, &values.iter().map(away).collect::<Vec<_>>()));
    }
    let [force, area, friction] = levels;
    let variables = vec![
        Variable::coordinate("x", side.clone()),
        Variable::coordinate("y", side),
        over("pressure", &["y", "x"], &[6, 6], pressure),
        along("level_cell", "level", cells),
        along("level_force", "level", force),
        along("level_area", "level", area),
        along("level_friction", "level", friction),
    ];
    let best = ["force", "area", "friction"].map(|name| (name, json!(1.0)));
    vec![Planted { dataset: dataset(variables, &best), runs, shapes: &["pressure, contact boundary"] }]
}

/// Speeds, depths and a law with holes.
fn law(seed: u64, names: &[&str]) -> (Vec<Variable>, Vec<Vec<Point>>) {
    let mut random = Random(seed);
    let (velocity, depth) = (steps(9), steps(4));
    let mut runs = Vec::new();
    let mut variables =
        vec![Variable::coordinate("velocity", velocity.clone()), Variable::coordinate("indentation", depth)];
    for name in names {
        let values = random.gappy(36, 1.0);
        if names.len() == 3 || name.starts_with("fitted") {
            runs.extend(values.chunks(9).map(|row| run(&velocity, row)));
        }
        variables.push(over(name, &["indentation", "velocity"], &[4, 9], values));
    }
    (variables, runs)
}

pub(super) fn contact_law(seed: u64) -> Vec<Planted> {
    let (variables, mut runs) = law(seed, &["force", "area", "friction"]);
    let velocity = steps(9);
    for depth in steps(4) {
        let force = 4.0 / 3.0 * f64::powf(depth, 1.5);
        for level in [force, 10.0 * force, 0.5 * TAU * depth] {
            runs.push(run(&velocity, &[level; 9]));
        }
    }
    alone(dataset(variables, &[("contrast", json!(10.0))]), runs)
}

pub(super) fn fit(seed: u64) -> Vec<Planted> {
    let names = ["force", "area", "friction", "fitted_force", "fitted_area", "fitted_friction"];
    let (variables, runs) = law(seed, &names);
    alone(dataset(variables, &[]), runs)
}

pub(super) fn modulus(seed: u64) -> Vec<Planted> {
    let mut random = Random(seed);
    let frequency = steps(12);
    let (mut runs, mut variables) = (Vec::new(), vec![Variable::coordinate("frequency", frequency.clone())]);
    for (base, name) in ["storage_modulus", "loss_modulus", "loss_tangent"].into_iter().enumerate() {
        let values = random.gappy(12, base as f64);
        runs.push(run(&frequency, &values));
        variables.push(along(name, "frequency", values));
    }
    alone(dataset(variables, &[]), runs)
}

pub(super) fn transient(seed: u64) -> Vec<Planted> {
    let mut random = Random(seed);
    let (time, position) = (steps(16), random.gappy(16, 5.0));
    let (mut runs, mut variables) = (Vec::new(), vec![Variable::coordinate("time", time.clone())]);
    for name in ["force", "friction_force", "area"] {
        let values = random.gappy(16, 0.0);
        runs.push(run(&time, &values));
        if name == "friction_force" {
            runs.push(run(&position, &values));
        }
        variables.push(along(name, "time", values));
    }
    variables.push(along("position", "time", position));
    alone(dataset(variables, &[("loop_over", json!("position"))]), runs)
}
