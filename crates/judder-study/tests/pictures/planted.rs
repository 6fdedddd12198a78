//! Rows of every kind of figure: branches, gaps, lists of roots, modes that swap their order.

use judder_store::{Data, Dataset, Variable};
use num_complex::Complex64;
use serde_json::{Value, json};
use std::f64::consts::TAU;

pub(super) type Point = (f64, f64);

/// A dataset, and what of it may be joined: neighbours of a run, both of which are.
pub(super) struct Planted {
    pub(super) dataset: Dataset,
    pub(super) runs: Vec<Vec<Point>>,
    /// Labels of lines and titles of panels that show no rows.
    pub(super) shapes: &'static [&'static str],
}

type Plant = fn(u64) -> Vec<Planted>;

pub(super) const PLANTED: [(&str, Plant); 23] = [
    ("equivalent-damping", equivalent_damping),
    ("spectrum", spectrum),
    ("critical-shear-strength", critical),
    ("critical-load", critical),
    ("stability-map", stability_map),
    ("contact", contact),
    ("contact-law", contact_law),
    ("fit", fit),
    ("modulus", modulus),
    ("transient", transient),
    ("motion", motion),
    ("limit-cycle", limit_cycle),
    ("bifurcation", bifurcation),
    ("basin", basin),
    ("engines", engines),
    ("modes", modes),
    ("reduction", reduction),
    ("eigen", eigen),
    ("eigen-sweep", eigen_sweep),
    ("locus", locus),
    ("growth", growth),
    ("march", march),
    ("spectrogram", spectrogram),
];

const NAN: f64 = f64::NAN;

/// Numbers between 0 and 1, the same for the same seed.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        // splitmix64
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn is(&mut self, share: f64) -> bool {
        self.next() < share
    }

    /// Values above `base`; one in six is none.
    fn gappy(&mut self, count: usize, base: f64) -> Vec<f64> {
        (0..count).map(|_| if self.is(0.17) { NAN } else { base + self.next() }).collect()
    }
}

fn steps(count: usize) -> Vec<f64> {
    (0..count).map(|k| 1.0 + k as f64).collect()
}

fn along(name: &str, dimension: &str, values: impl Into<Data>) -> Variable {
    let values = values.into();
    Variable::new(name, &[dimension], &[values.len()], values)
}

fn over(name: &str, dimensions: &[&str], shape: &[usize], values: impl Into<Data>) -> Variable {
    Variable::new(name, dimensions, shape, values)
}

fn dataset(variables: Vec<Variable>, attributes: &[(&str, Value)]) -> Dataset {
    let whole =
        variables.into_iter().fold(Dataset::new(), |dataset, variable| dataset.with(variable).unwrap());
    attributes.iter().fold(whole, |dataset, (name, value)| dataset.attribute(name, value.clone()).unwrap())
}

fn run(x: &[f64], y: &[f64]) -> Vec<Point> {
    x.iter().copied().zip(y.iter().copied()).collect()
}

fn alone(dataset: Dataset, runs: Vec<Vec<Point>>) -> Vec<Planted> {
    vec![Planted { dataset, runs, shapes: &[] }]
}

fn equivalent_damping(seed: u64) -> Vec<Planted> {
    let (velocity, values) = (steps(12), Random(seed).gappy(24, 0.1));
    let runs = values.chunks(12).map(|curve| run(&velocity, curve)).collect();
    let variables = vec![
        Variable::coordinate("normal_load", vec![1.0, 2.0]),
        Variable::coordinate("velocity", velocity),
        over("equivalent_damping", &["normal_load", "velocity"], &[2, 12], values),
    ];
    alone(dataset(variables, &[]), runs)
}

/// Two modes whose frequencies cross while their growth rates stay apart; a spectrum is stored by frequency.
fn spectrum(seed: u64) -> Vec<Planted> {
    const COUNT: usize = 15;
    let mut random = Random(seed);
    let velocity = steps(COUNT);
    let is_missing: Vec<bool> = velocity.iter().map(|_| random.is(0.12)).collect();
    let apart = 0.5 + random.next();
    let full = |k: usize| {
        let t = k as f64 / (COUNT - 1) as f64;
        [Complex64::new(0.1 * t, 1.0 + t), Complex64::new(apart - 0.1 * t, 2.0 - t)]
    };
    let bare =
        |k: usize| [Complex64::new(0.0, 3.0 + 0.1 * k as f64), Complex64::new(0.0, 9.0 - 0.1 * k as f64)];
    let stored = |of: &dyn Fn(usize) -> [Complex64; 2]| -> Vec<Complex64> {
        let row = |k: usize| {
            let mut row: Vec<Complex64> = of(k).into_iter().flat_map(|value| [value, value.conj()]).collect();
            row.sort_by(|a, b| a.im.total_cmp(&b.im).then(a.re.total_cmp(&b.re)));
            if is_missing[k] { vec![Complex64::new(NAN, NAN); 4] } else { row }
        };
        (0..COUNT).flat_map(row).collect()
    };
    let mut runs = Vec::new();
    for of in [&full as &dyn Fn(usize) -> [Complex64; 2], &bare] {
        for mode in 0..2 {
            for part in [|value: Complex64| value.re, |value: Complex64| value.im] {
                let at = |k: usize| (velocity[k], if is_missing[k] { NAN } else { part(of(k)[mode]) });
                runs.push((0..COUNT).map(at).collect());
            }
        }
    }
    let variables = vec![
        Variable::coordinate("velocity", velocity.clone()),
        over("eigenvalues", &["velocity", "mode"], &[COUNT, 4], stored(&full)),
        over("conservative_eigenvalues", &["velocity", "mode"], &[COUNT, 4], stored(&bare)),
    ];
    alone(dataset(variables, &[]), runs)
}

/// One threshold that leaves the range below while another enters it above, and a pair that is born and dies; some rows have none.
fn critical(seed: u64) -> Vec<Planted> {
    const COUNT: usize = 20;
    let mut random = Random(seed);
    let velocity = steps(COUNT);
    let (born, dies) = (2 + (4.0 * random.next()) as usize, 11 + (3.0 * random.next()) as usize);
    let leaves = 14 + (3.0 * random.next()) as usize;
    let is_missing: Vec<bool> = velocity.iter().map(|_| random.is(0.1)).collect();
    let middle = 0.5 * (born + dies - 1) as f64;
    let root = |curve: usize, k: usize| {
        let at = k as f64;
        let apart = 1.0 - ((at - middle) / (0.5 * (dies - born) as f64)).powi(2);
        let value = match curve {
            0 if k < leaves => 0.1 - 0.001 * at,
            1 if (born..dies).contains(&k) => 3.0 - 0.5 * apart,
            2 if (born..dies).contains(&k) => 3.5 + 0.5 * apart,
            3 if k >= leaves => 900.0 - 5.0 * at,
            _ => NAN,
        };
        if is_missing[k] { NAN } else { value }
    };
    let mut runs: Vec<Vec<Point>> =
        (0..4).map(|curve| (0..COUNT).map(|k| (velocity[k], root(curve, k))).collect()).collect();
    let (mut full, mut fold) = (Vec::new(), Vec::new());
    let mut folds = vec![Vec::new(); 4];
    for k in 0..COUNT {
        let mut here: Vec<(f64, usize)> =
            (0..4).map(|curve| (root(curve, k), curve)).filter(|(root, _)| root.is_finite()).collect();
        here.sort_by(|a, b| a.0.total_cmp(&b.0));
        for place in 0..3 {
            let own = here.get(place);
            let back = own.map_or(NAN, |(root, _)| if random.is(0.3) { NAN } else { 0.7 * root });
            full.push(own.map_or(NAN, |(root, _)| *root));
            fold.push(back);
        }
        for (curve, folds) in folds.iter_mut().enumerate() {
            let place = here.iter().position(|(_, own)| *own == curve);
            folds.push((velocity[k], place.map_or(NAN, |place| fold[3 * k + place])));
        }
    }
    runs.extend(folds);
    let conservative: Vec<f64> = (0..COUNT).map(|k| 30.0 + k as f64).collect();
    runs.push(run(&velocity, &conservative));
    let codes: Vec<u8> = full.iter().map(|root| if root.is_finite() { 2 } else { 0 }).collect();
    let variables = vec![
        Variable::coordinate("velocity", velocity),
        over("full", &["velocity", "full_root"], &[COUNT, 3], full.clone()),
        over("fold", &["velocity", "full_root"], &[COUNT, 3], fold),
        over("reaches", &["velocity", "full_root"], &[COUNT, 3], full),
        over("criticality", &["velocity", "full_root"], &[COUNT, 3], codes),
        over("conservative", &["velocity", "conservative_root"], &[COUNT, 1], conservative),
    ];
    alone(dataset(variables, &[]), runs)
}

fn stability_map(seed: u64) -> Vec<Planted> {
    let mut random = Random(seed);
    let pieces = 1 + (3.0 * random.next()) as usize;
    let piece = |random: &mut Random| -> Vec<Point> {
        let length = 2 + (5.0 * random.next()) as usize;
        (0..length).map(|_| (random.next(), random.next())).collect()
    };
    let runs: Vec<Vec<Point>> = (0..pieces).map(|_| piece(&mut random)).collect();
    let (x, y): (Vec<f64>, Vec<f64>) =
        runs.iter().flat_map(|piece| piece.iter().copied().chain([(NAN, NAN)])).unzip();
    let variables = vec![
        Variable::coordinate("speed", vec![0.0, 1.0]),
        Variable::coordinate("load", vec![0.0, 1.0]),
        over("stability", &["load", "speed"], &[2, 2], vec![0_u8, 1, 2, 3]),
        along("full_boundary_speed", "point", x),
        along("full_boundary_load", "point", y),
    ];
    alone(dataset(variables, &[]), runs)
}

fn contact(seed: u64) -> Vec<Planted> {
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

fn contact_law(seed: u64) -> Vec<Planted> {
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

fn fit(seed: u64) -> Vec<Planted> {
    let names = ["force", "area", "friction", "fitted_force", "fitted_area", "fitted_friction"];
    let (variables, runs) = law(seed, &names);
    alone(dataset(variables, &[]), runs)
}

fn modulus(seed: u64) -> Vec<Planted> {
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

fn transient(seed: u64) -> Vec<Planted> {
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
        along("oscillation_period", "oscillation", vec![50.0]),
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

fn motion(seed: u64) -> Vec<Planted> {
    let mut random = Random(seed);
    let (mut variables, mut runs) = histories(&mut random);
    let (frequency, amplitude) = (steps(18), random.gappy(18, 0.5));
    runs.push(run(&frequency, &amplitude));
    variables.push(along("frequency", "frequency", frequency));
    variables.push(along("amplitude", "frequency", amplitude));
    variables.push(along("section_x", "meeting", random.gappy(9, 0.0)));
    alone(dataset(variables, &[]), runs)
}

fn limit_cycle(seed: u64) -> Vec<Planted> {
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

pub(super) fn diagram(seed: u64) -> (Dataset, Vec<Point>) {
    let (variables, _, stable) = branched(seed);
    (dataset(variables, &[("kind", json!("bifurcation"))]), stable)
}

fn bifurcation(seed: u64) -> Vec<Planted> {
    let (variables, runs, _) = branched(seed);
    let simulated = dataset(settled(&mut Random(seed)), &[]);
    let branched = Planted { dataset: dataset(variables, &[]), runs, shapes: &[] };
    vec![branched, Planted { dataset: simulated, runs: Vec::new(), shapes: &[] }]
}

fn basin(seed: u64) -> Vec<Planted> {
    let mut random = Random(seed);
    let variables = vec![
        along("x", "start", random.gappy(9, 0.0)),
        along("settling_time", "start", random.gappy(9, 0.0)),
        along("fate", "start", vec![0_u8, 1, 0, 1, 2, 0, 1, 0, 3]),
    ];
    alone(dataset(variables, &[("drawn", json!(["x"]))]), Vec::new())
}

fn engines(seed: u64) -> Vec<Planted> {
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

fn modes(seed: u64) -> Vec<Planted> {
    let mut random = Random(seed);
    let places: Vec<f64> = (0..6).flat_map(|_| [random.next(), random.next(), 0.0]).collect();
    let shape: Vec<f64> = (0..36).map(|_| random.next()).collect();
    let lines = [[0_i64, 1], [1, 2], [4, 5]];
    let at = |point: i64| (places[3 * point as usize], places[3 * point as usize + 1]);
    let runs = lines.iter().map(|[a, b]| vec![at(*a), at(*b)]).collect();
    let variables = vec![
        along("frequency", "mode", vec![1.0, 2.0]),
        over("place", &["point", "axis"], &[6, 3], places),
        over("shape", &["mode", "point", "axis"], &[2, 6, 3], shape),
        over("line", &["edge", "end"], &[3, 2], lines.concat()),
    ];
    alone(dataset(variables, &[]), runs)
}

fn reduction(seed: u64) -> Vec<Planted> {
    let mut random = Random(seed);
    let full = steps(9);
    let column = |random: &mut Random| -> Vec<f64> {
        (0..9).map(|_| if random.is(0.2) { 1e-15 } else { 0.1 + random.next() }).collect()
    };
    let (error, bound) = (column(&mut random), column(&mut random));
    let shown = |values: &[f64]| values.iter().map(|v| if *v > 1e-12 { *v } else { NAN }).collect::<Vec<_>>();
    let runs = vec![run(&full, &shown(&error)), run(&full, &shown(&bound))];
    let variables =
        vec![along("full", "mode", full), along("error", "mode", error), along("bound", "mode", bound)];
    alone(dataset(variables, &[]), runs)
}

/// Complex numbers of a table, one in six none.
fn eigenvalues(random: &mut Random, count: usize) -> Vec<Complex64> {
    let value = |random: &mut Random| match random.is(0.17) {
        true => Complex64::new(NAN, NAN),
        false => Complex64::new(random.next() - 0.5, 10.0 * random.next()),
    };
    (0..count).map(|_| value(random)).collect()
}

fn eigen(seed: u64) -> Vec<Planted> {
    let values: Vec<Complex64> =
        eigenvalues(&mut Random(seed), 9).into_iter().filter(|value| value.re.is_finite()).collect();
    let verdicts: Vec<u8> = values.iter().map(|value| if value.re > 0.0 { 2 } else { 0 }).collect();
    let variables = vec![along("eigenvalue", "mode", values), along("verdict", "mode", verdicts)];
    alone(dataset(variables, &[]), Vec::new())
}

fn eigen_sweep(seed: u64) -> Vec<Planted> {
    let (friction, values) = (steps(15), eigenvalues(&mut Random(seed), 45));
    let mut runs = Vec::new();
    for branch in 0..3 {
        let own: Vec<Complex64> = values.iter().skip(branch).step_by(3).copied().collect();
        let (growth, hertz): (Vec<f64>, Vec<f64>) =
            own.iter().map(|value| (value.re, value.im / TAU)).unzip();
        runs.extend([run(&friction, &hertz), run(&friction, &growth), run(&growth, &hertz)]);
    }
    let variables = vec![
        Variable::coordinate("friction", friction),
        over("eigenvalue", &["friction", "branch"], &[15, 3], values),
        over("verdict", &["friction", "branch"], &[15, 3], vec![0_u8; 45]),
    ];
    alone(dataset(variables, &[]), runs)
}

/// More positions than are drawn, and holes that may lie between two that are.
fn locus(seed: u64) -> Vec<Planted> {
    const COUNT: usize = 1000;
    const STEP: usize = 3;
    let mut random = Random(seed);
    let position = steps(COUNT);
    let values: Vec<Complex64> = (0..2 * COUNT)
        .map(|_| match random.is(0.02) {
            true => Complex64::new(NAN, NAN),
            false => Complex64::new(-random.next(), 10.0 + random.next()),
        })
        .collect();
    let shown: Vec<usize> = (0..COUNT).step_by(STEP).collect();
    let mut runs = Vec::new();
    for branch in 0..2 {
        for part in [|value: Complex64| value.re, |value: Complex64| value.im / TAU] {
            let own: Vec<f64> = values.iter().skip(branch).step_by(2).map(|value| part(*value)).collect();
            let mut line = Vec::new();
            for (k, row) in shown.iter().enumerate() {
                if k > 0 && own[shown[k - 1]..=*row].iter().any(|value| value.is_nan()) {
                    line.push((NAN, NAN));
                }
                line.push((1e3 * position[*row], own[*row]));
            }
            runs.push(line);
        }
    }
    let force = random.gappy(COUNT, 50.0);
    let along_mm: Vec<f64> = position.iter().map(|at| 1e3 * at).collect();
    runs.push(run(&along_mm, &force));
    let none = |name: &str| along(name, "zone", Vec::<f64>::new());
    let mut variables = vec![
        Variable::coordinate("position", position),
        over("eigenvalue", &["position", "branch"], &[COUNT, 2], values),
        along("normal_force", "position", force),
    ];
    variables.extend(["zone_from", "zone_to", "zone_peak", "zone_growth_rate", "zone_frequency"].map(none));
    alone(dataset(variables, &[]), runs)
}

fn growth(seed: u64) -> Vec<Planted> {
    let (time, amplitude) = (steps(20), Random(seed).gappy(20, 1.0));
    let promised = time.iter().map(|time| (1e3 * time, 2.0 * (0.1 * time).exp())).collect();
    let variables = vec![
        along("time", "time", time),
        along("amplitude", "time", amplitude),
        along("measured", "rate", vec![Complex64::new(0.1, 5.0)]),
        along("predicted", "rate", vec![Complex64::new(0.1, 5.0)]),
    ];
    let attributes =
        [("start_amplitude_n", json!(2.0)), ("measured_until_s", json!(9.0)), ("position_m", json!(0.1))];
    alone(dataset(variables, &attributes), vec![promised])
}

/// A signal of more samples than are drawn: columns with the smallest and the largest, and where one sample is none a gap.
fn march(seed: u64) -> Vec<Planted> {
    const COUNT: usize = 1500;
    const WIDTH: usize = 3;
    let mut random = Random(seed);
    let time = steps(COUNT);
    let (mut runs, mut variables) = (Vec::new(), vec![Variable::coordinate("time", time.clone())]);
    for (base, name) in ["normal_force", "sliding_velocity"].into_iter().enumerate() {
        let value = |_| if random.is(0.01) { NAN } else { base as f64 + random.next() };
        let values: Vec<f64> = (0..COUNT).map(value).collect();
        let (mut envelope, mut amplitude) = (Vec::new(), Vec::new());
        for (times, values) in time.chunks(WIDTH).zip(values.chunks(WIDTH)) {
            let middle = 0.5 * (times[0] + times[WIDTH - 1]);
            if values.iter().any(|value| value.is_nan()) {
                envelope.push((NAN, NAN));
                amplitude.push((NAN, NAN));
                continue;
            }
            let by = |a: &usize, b: &usize| values[*a].total_cmp(&values[*b]);
            let (low, high) = ((0..WIDTH).min_by(by).unwrap(), (0..WIDTH).max_by(by).unwrap());
            envelope.extend([low.min(high), low.max(high)].map(|k| (times[k], values[k])));
            let mean = values.iter().sum::<f64>() / WIDTH as f64;
            let square = values.iter().map(|value| (value - mean).powi(2)).sum::<f64>() / WIDTH as f64;
            amplitude.push((middle, (2.0 * square).sqrt()));
        }
        runs.push(envelope);
        if name == "normal_force" {
            runs.push(amplitude);
        }
        variables.push(along(name, "time", values));
    }
    variables.push(along("position", "time", time));
    alone(dataset(variables, &[("signal", json!("normal_force"))]), runs)
}

/// Two spectra one behind the other, with levels so low that nothing is hidden; frames about two zones.
fn spectrogram(seed: u64) -> Vec<Planted> {
    let mut random = Random(seed);
    let frequency: Vec<f64> = steps(9).iter().map(|step| 1e3 * step).collect();
    let level: Vec<f64> =
        random.gappy(18, 0.0).iter().map(|level| if level.is_nan() { NAN } else { 1e-3 * level }).collect();
    // 4 times the distance of two spectra for the whole range
    let rise = |level: f64| 4.0 * 1e3 * level / 100.0;
    let spectrum = |k: usize| -> Vec<Point> {
        let own = &level[9 * k..9 * (k + 1)];
        steps(9)
            .iter()
            .zip(own)
            .map(|(kilohertz, level)| (*kilohertz, 1e3 * (1 + k) as f64 + rise(*level)))
            .collect()
    };
    let runs = vec![spectrum(0), spectrum(1)];
    let variables = vec![
        Variable::coordinate("time", vec![0.0, 1.0]),
        Variable::coordinate("frequency", frequency),
        over("level", &["time", "frequency"], &[2, 9], level),
        along("position", "time", vec![1.0, 2.0]),
    ];
    alone(dataset(variables, &[("signal", json!("y")), ("range_db", json!([0.0, 100.0]))]), runs)
}
