//! Rows of figures of structures, loci and marches.

use super::*;

pub(super) fn modes(seed: u64) -> Vec<Planted> {
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

pub(super) fn reduction(seed: u64) -> Vec<Planted> {
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

/// Imaginary parts are positive: no phase jumps from 180° to −180°.
pub(super) fn receptance(seed: u64) -> Vec<Planted> {
    let (hertz, values) = (steps(12), eigenvalues(&mut Random(seed), 12));
    let magnitudes: Vec<f64> = values.iter().map(|value| value.norm()).collect();
    let phases: Vec<f64> = values.iter().map(|value| value.arg().to_degrees()).collect();
    let runs = vec![run(&hertz, &magnitudes), run(&hertz, &phases)];
    let variables = vec![along("frequency", "frequency", hertz), along("receptance", "frequency", values)];
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

pub(super) fn eigen(seed: u64) -> Vec<Planted> {
    let values: Vec<Complex64> =
        eigenvalues(&mut Random(seed), 9).into_iter().filter(|value| value.re.is_finite()).collect();
    let verdicts: Vec<u8> = values.iter().map(|value| if value.re > 0.0 { 2 } else { 0 }).collect();
    let variables = vec![along("eigenvalue", "mode", values), along("verdict", "mode", verdicts)];
    alone(dataset(variables, &[]), Vec::new())
}

/// Points of two contacts, one along a line and one over a surface, which nothing joins.
pub(super) fn steady_sliding(seed: u64) -> Vec<Planted> {
    let mut random = Random(seed);
    let contacts: Vec<String> = (0..12).map(|k| if k < 5 { "line" } else { "surface" }.to_owned()).collect();
    let mut place = |is_flat: bool| -> Vec<f64> {
        (0..12).map(|k| if is_flat || k < 5 { 0.0 } else { random.next() }).collect()
    };
    let (y, z) = (place(false), place(true));
    let variables = vec![
        along("contact", "contact_point", contacts),
        along("x", "contact_point", steps(12)),
        along("y", "contact_point", y),
        along("z", "contact_point", z),
        along("normal_force", "contact_point", Random(seed + 1).gappy(12, -0.2)),
        along("gap", "contact_point", steps(12)),
    ];
    alone(dataset(variables, &[]), Vec::new())
}

/// Points of a boundary, which nothing joins.
pub(super) fn assembly_map(seed: u64) -> Vec<Planted> {
    let mut random = Random(seed);
    let mut places = || -> Vec<f64> { (0..5).map(|_| random.next()).collect() };
    let (x, y) = (places(), places());
    let variables = vec![
        Variable::coordinate("x", vec![0.0, 1.0]),
        Variable::coordinate("y", vec![0.0, 1.0]),
        over("stability", &["y", "x"], &[2, 2], vec![0_u8, 1, 2, 7]),
        along("boundary_x", "boundary_point", x),
        along("boundary_y", "boundary_point", y),
    ];
    alone(dataset(variables, &[]), Vec::new())
}

pub(super) fn eigen_sweep(seed: u64) -> Vec<Planted> {
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
pub(super) fn locus(seed: u64) -> Vec<Planted> {
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

pub(super) fn growth(seed: u64) -> Vec<Planted> {
    growth_from(seed, 2.0)
}

/// The amplitude of a mode starts at one.
pub(super) fn mode_growth(seed: u64) -> Vec<Planted> {
    growth_from(seed, 1.0)
}

fn growth_from(seed: u64, start: f64) -> Vec<Planted> {
    let (time, amplitude) = (steps(20), Random(seed).gappy(20, 1.0));
    let promised = time.iter().map(|time| (1e3 * time, start * (0.1 * time).exp())).collect();
    let variables = vec![
        along("time", "time", time),
        along("amplitude", "time", amplitude),
        over("measured", &[], &[], vec![Complex64::new(0.1, 5.0)]),
        over("predicted", &[], &[], vec![Complex64::new(0.1, 5.0)]),
    ];
    let attributes =
        [("start_amplitude_n", json!(start)), ("measured_until_s", json!(9.0)), ("position_m", json!(0.1))];
    alone(dataset(variables, &attributes), vec![promised])
}

/// A signal of more samples than are drawn: columns with the smallest and the largest, and where one sample is none a gap.
pub(super) fn march(seed: u64) -> Vec<Planted> {
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

/// Forces of a contact, one sample of which is none, and states of its two points.
pub(super) fn assembly_march(seed: u64) -> Vec<Planted> {
    let mut random = Random(seed);
    let time = steps(20);
    let (mut runs, mut variables) = (Vec::new(), vec![Variable::coordinate("time", time.clone())]);
    let forces = ["sole.normal_force", "sole.friction_force"].map(|name| (name, "N"));
    let driven = [("course.speed", "1"), ("course.friction", "1"), ("base.1.y", "m/s^2"), ("force.2.x", "N")];
    for (base, (name, unit)) in forces.into_iter().chain(driven).enumerate() {
        let values = random.gappy(20, base as f64);
        runs.push(run(&time, &values));
        variables.push(along(name, "time", values).units(unit));
    }
    variables.push(along("contact", "contact_point", vec!["sole".to_owned(); 2]));
    variables.push(Variable::coordinate("state_time", vec![0.0, 1.0]));
    variables.push(over("state", &["state_time", "contact_point"], &[2, 2], vec![0_u8, 1, 2, 3]));
    alone(dataset(variables, &[("transient_s", json!(3.0))]), runs)
}

/// Motions of a mode one of which has no growth rate, and a period with two points of a contact: the second swings most, its portrait is closed.
pub(super) fn assembly_cycle(seed: u64) -> Vec<Planted> {
    let mut random = Random(seed);
    let (amplitude, growth) = (steps(9), random.gappy(9, -0.5));
    let phase: Vec<f64> = steps(20).iter().map(|step| (step - 1.0) / 20.0).collect();
    let mut runs = vec![run(&amplitude, &growth)];
    let mut variables = vec![
        along("amplitude", "motion", amplitude),
        along("growth_rate", "motion", growth),
        Variable::coordinate("phase", phase.clone()),
    ];
    let forces = ["sole.normal_force", "sole.friction_force"].map(|name| (name, "N"));
    for (base, (name, unit)) in forces.into_iter().chain([("edge.x", "m/s^2")]).enumerate() {
        let values = random.gappy(20, base as f64);
        runs.push(run(&phase, &values));
        variables.push(along(name, "phase", values).units(unit));
    }
    variables.push(along("contact", "contact_point", vec!["sole".to_owned(); 2]));
    let states = (0..40).map(|k| (k % 4) as u8).collect::<Vec<u8>>();
    variables.push(over("state", &["phase", "contact_point"], &[20, 2], states));
    let [displacement, velocity] = [1e-6, 1.0].map(|unit| {
        let of_points = (0..40).map(|k| unit * (if k % 2 == 0 { 0.1 } else { 2.0 }) * random.next());
        of_points.collect::<Vec<f64>>()
    });
    let second = |all: &[f64]| all.iter().skip(1).step_by(2).copied().collect::<Vec<f64>>();
    let mut portrait =
        run(&second(&displacement).iter().map(|own| 1e6 * own).collect::<Vec<_>>(), &second(&velocity));
    portrait.push(portrait[0]);
    runs.push(portrait);
    for (name, values) in [("slip_displacement", displacement), ("slip_velocity", velocity)] {
        variables.push(over(name, &["phase", "contact_point"], &[20, 2], values));
    }
    let (frequencies, shares) = (steps(5), random.gappy(5, 0.0));
    runs.extend(frequencies.iter().zip(&shares).map(|(at, share)| run(&[*at; 2], &[0.0, *share])));
    variables.push(along("mode_frequency", "mode", frequencies));
    variables.push(along("mode_contribution", "mode", shares));
    let multipliers = [Complex64::ONE, Complex64::new(0.3, 0.8), Complex64::new(0.3, -0.8)];
    variables.push(along("floquet_multipliers", "multiplier", multipliers.to_vec()));
    let dataset = dataset(variables, &[("cycle_amplitude", json!(3.0))]);
    vec![Planted { dataset, runs, shapes: &["unit circle"] }]
}

/// Modes of which some have no cycle: points alone.
pub(super) fn assembly_squeal(seed: u64) -> Vec<Planted> {
    let mut random = Random(seed);
    let frequency = random.gappy(8, 1.0);
    let codes = frequency.iter().map(|own| if own.is_nan() { 3 } else { (random.next() * 3.0) as u8 });
    let codes: Vec<u8> = codes.collect();
    let variables = vec![
        along("mode_frequency", "mode", steps(8)),
        along("growth_rate", "mode", random.gappy(8, 1.0)),
        along("frequency", "mode", frequency),
        along("level", "mode", random.gappy(8, 100.0)),
        along("stability", "mode", codes),
    ];
    alone(dataset(variables, &[]), Vec::new())
}

/// A branch of cycles that is unstable, stable, and unknown.
pub(super) fn cycle_branch(seed: u64) -> Vec<Planted> {
    let mut random = Random(seed);
    let value = steps(9);
    let stable: [u8; 9] = [0, 0, 0, 1, 1, 1, 2, 2, 2];
    let mut runs = Vec::new();
    let mut variables =
        vec![along("value", "cycle", value.clone()), along("stable", "cycle", stable.to_vec())];
    for name in ["rms", "frequency"] {
        let up: Vec<f64> = (0..9).map(|k| 1.0 + k as f64 + 0.5 * random.next()).collect();
        // a stretch between unlike cycles is drawn as the one after it
        for own in [0..3, 2..6, 5..9] {
            runs.push(run(&value[own.clone()], &up[own]));
        }
        variables.push(along(name, "cycle", up));
    }
    let dataset = dataset(variables, &[]);
    vec![Planted { dataset, runs, shapes: &[] }]
}

/// Two observed coordinates along a branch that turns twice, one measure of which is none now and then.
pub(super) fn assembly_response(seed: u64) -> Vec<Planted> {
    let mut random = Random(seed);
    let frequency: Vec<f64> = (0..20).map(|k: i32| f64::from(k - 3 * (k - 8).clamp(0, 4))).collect();
    let (mut runs, mut variables) = (Vec::new(), vec![along("frequency", "motion", frequency.clone())]);
    variables.push(along("fold_motion", "fold", vec![8_i64, 12]));
    for (base, measure) in ["amplitude", "rms", "rms_about_mean", "largest"].into_iter().enumerate() {
        for (k, name) in ["tip.x", "tip.y"].into_iter().enumerate() {
            let values = random.gappy(20, (2 * base + k) as f64);
            if measure != "rms_about_mean" {
                runs.push(run(&frequency, &values));
            }
            variables.push(along(&format!("{name}.{measure}"), "motion", values).units("m"));
        }
    }
    alone(dataset(variables, &[]), runs)
}

/// Two spectra one behind the other, with levels so low that nothing is hidden; frames about two zones.
pub(super) fn spectrogram(seed: u64) -> Vec<Planted> {
    spectra(seed, Some(vec![1.0, 2.0]))
}

/// The same of a march along no path.
pub(super) fn timed_spectrogram(seed: u64) -> Vec<Planted> {
    spectra(seed, None)
}

fn spectra(seed: u64, positions: Option<Vec<f64>>) -> Vec<Planted> {
    let mut random = Random(seed);
    let frequency: Vec<f64> = steps(9).iter().map(|step| 1e3 * step).collect();
    let level: Vec<f64> =
        random.gappy(18, 0.0).iter().map(|level| if level.is_nan() { NAN } else { 1e-3 * level }).collect();
    let time = vec![0.0, 1.0];
    let places = positions.as_ref().unwrap_or(&time);
    // 4 times the distance of two spectra for the whole range
    let rise = |level: f64| 4.0 * 1e3 * level / 100.0;
    let spectrum = |k: usize| -> Vec<Point> {
        let own = &level[9 * k..9 * (k + 1)];
        steps(9)
            .iter()
            .zip(own)
            .map(|(kilohertz, level)| (*kilohertz, 1e3 * places[k] + rise(*level)))
            .collect()
    };
    let runs = vec![spectrum(0), spectrum(1)];
    let mut variables = vec![
        Variable::coordinate("time", time.clone()),
        Variable::coordinate("frequency", frequency),
        over("level", &["time", "frequency"], &[2, 9], level),
    ];
    variables.extend(positions.map(|positions| along("position", "time", positions)));
    alone(dataset(variables, &[("signal", json!("y")), ("range_db", json!([0.0, 100.0]))]), runs)
}
