//! Rows of figures of an oscillator along a key, and its maps.

use super::*;

pub(super) fn equivalent_damping(seed: u64) -> Vec<Planted> {
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
pub(super) fn spectrum(seed: u64) -> Vec<Planted> {
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
pub(super) fn critical(seed: u64) -> Vec<Planted> {
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

pub(super) fn stability_map(seed: u64) -> Vec<Planted> {
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
        along("full_boundary_speed", "full_boundary_point", x),
        along("full_boundary_load", "full_boundary_point", y),
    ];
    alone(dataset(variables, &[]), runs)
}
