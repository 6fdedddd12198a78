//! Responses to harmonic forces, against published cases.

use crate::common::{assembly, dense, diagonal, point_on_plane};
use faer::c64;
use judder_assembly::assembly::Assembly;
use judder_assembly::compliance::Compliance;
use judder_assembly::contact_point::ContactPoint;
use judder_assembly::friction::Friction;
use judder_assembly::interface::InterfaceLaw;
use judder_assembly::pressure::Pressure;
use judder_assembly::row::Row;
use judder_assembly::steady::{PointState, SteadySliding, steady_sliding};
use judder_cycles::balance::{HarmonicBalance, HarmonicForce};
use judder_cycles::forced::{ForcedResponse, ResponseEnd, ResponseSettings, StepMeasure, forced_response};
use judder_cycles::path::PathRule;
use judder_cycles::series::Series;
use judder_cycles::stability::{CycleStability, floquet_multipliers};
use std::f64::consts::TAU;

/// Coefficients of a freedom of each motion.
fn followed(balance: &HarmonicBalance<'_>, found: &ForcedResponse, row: &Row) -> Vec<(f64, Vec<f64>)> {
    let own = balance.bodies().on_coordinates(row);
    let of = |motion: &judder_cycles::backbone::PeriodicMotion| {
        let (mean, harmonics) = balance.coordinates(&motion.unknown, motion.turning).unwrap();
        let mut coefficients = vec![own.iter().zip(&mean).map(|(a, b)| a * b).sum::<f64>()];
        for harmonic in &harmonics {
            let sum: c64 = own.iter().zip(harmonic).map(|(a, b)| b * *a).sum();
            coefficients.extend([sum.re, -sum.im]);
        }
        (motion.turning.frequency, coefficients)
    };
    found.motions.iter().map(of).collect()
}

/// Untouched points, all forces zero.
fn untouched(case: &Assembly, gap: f64) -> SteadySliding {
    let mut steady = SteadySliding::untouched(case.size());
    steady.points =
        vec![PointState { interface: 0, gap, normal_force: 0.0, friction_force: 0.0, is_closed: false }];
    steady
}

/// NLvib, example 3: two masses (1, 1), springs (0, 1, 1), damping 0.03 times the stiffness, F₂ = 0.1 cos Ω t, a stop of stiffness 100 with the gap 1 at the
/// first mass, 21 harmonics (M. Krack, J. Gross, *Harmonic Balance for Nonlinear Vibration Problems*, 2019, whose code was run to 16384 samples: root mean square 1.01297 of
/// the first mass at 0.75375 rad/s; what it prints, 0.98 at 0.754, counts half of the mean).
#[test]
fn a_stop_bends_the_response_as_published() {
    let stiffness = [vec![1.0, -1.0], vec![-1.0, 2.0]];
    let damping = stiffness.clone().map(|row| row.iter().map(|own| 0.03 * own).collect::<Vec<f64>>());
    // the stop lies above: the gap closes as the mass rises
    let row = |factor: f64| Row::new(vec![(0, factor)]);
    let point = ContactPoint {
        relative: [Row::default(), row(-1.0), Row::default()],
        ..point_on_plane(&[0, 0], 1.0, 1.0)
    };
    let case = assembly(
        [diagonal(&[1.0; 2]), dense(&damping), dense(&stiffness)],
        vec![0.0; 2],
        vec![point],
        InterfaceLaw::Compliant(Pressure::PointStiffness(100.0), Friction::Constant(0.0)),
    );
    let steady = untouched(&case, 1.0);
    let force = HarmonicForce { harmonic: 1, amplitude: vec![c64::ZERO, c64::new(0.1, 0.0)] };
    let series = Series::new(21, 4096);
    let balance = HarmonicBalance::new(&case, &steady, 0.75, series, &[force]).unwrap();
    let settings = ResponseSettings {
        rule: PathRule { steps: [0.01, 0.05, 1e-8], ..PathRule::default() },
        between: [0.8, 0.5],
        points: 3000,
        pace: StepMeasure::Largest(2e-3),
    };
    let found = forced_response(&balance, &balance.steady(&steady), &settings, &|| true).unwrap();
    assert_eq!(found.end, ResponseEnd::Range);
    stability_is_that_of_the_motion_itself(&balance, &found, f64::INFINITY);
    let finer = balance.with_series(Series::new(41, 4096));
    let responded = forced_response(&finer, &vec![0.0; finer.unknowns()], &settings, &|| true).unwrap();
    stability_is_that_of_the_motion_itself(&finer, &responded, 1.0);
    let rms = |own: &[f64]| (own[0] * own[0] + 0.5 * own[1..].iter().map(|a| a * a).sum::<f64>()).sqrt();
    let all = followed(&balance, &found, &Row::of_freedom(0));
    let (frequency, peak) =
        all.iter().map(|(frequency, own)| (*frequency, rms(own))).max_by(|a, b| a.1.total_cmp(&b.1)).unwrap();
    assert!((peak / 1.01297 - 1.0).abs() < 1e-4, "{peak}");
    assert!((frequency - 0.75375).abs() < 1e-4, "{frequency}");
    // without the stop the first mass comes to it at 0.65344 rad/s, where the response turns, and turns again beyond the peak
    let folds: Vec<f64> = found.folds.iter().map(|(_, own)| *own).collect();
    let [lower, upper] = folds[..] else { panic!("{folds:?}") };
    assert!((lower - 0.65344).abs() < 1e-3 && (upper - 0.75562).abs() < 1e-4, "{folds:?}");
    assert_eq!(found.motions.last().unwrap().turning.frequency, 0.5);
}

/// The masses and the stop over a period of 2π/ω by steps of the method of Runge and Kutta, from displacements and velocities on.
fn a_period_later(state: [f64; 4], omega: f64) -> [f64; 4] {
    const STEPS: usize = 40_000;
    let step = TAU / omega / STEPS as f64;
    let slope = |t: f64, [x, y, u, v]: [f64; 4]| {
        let stop = 100.0 * (x - 1.0).max(0.0);
        let [pull, damping] = [x - y, 0.03 * (u - v)];
        let driven = 0.1 * (omega * t).cos() - y - 0.03 * v;
        [u, v, -pull - damping - stop, pull + damping + driven]
    };
    let ahead = |state: [f64; 4], slope: [f64; 4], by: f64| -> [f64; 4] {
        std::array::from_fn(|k| state[k] + by * slope[k])
    };
    (0..STEPS).fold(state, |state, k| {
        let t = k as f64 * step;
        let first = slope(t, state);
        let second = slope(t + 0.5 * step, ahead(state, first, 0.5 * step));
        let third = slope(t + 0.5 * step, ahead(state, second, 0.5 * step));
        let fourth = slope(t + step, ahead(state, third, step));
        std::array::from_fn(|k| {
            state[k] + step / 6.0 * (first[k] + 2.0 * second[k] + 2.0 * third[k] + fourth[k])
        })
    })
}

/// Multipliers against differences of the nonlinear motion from states beside: what they say is so, or undecided, and the largest one is off by no more than so many of its errors.
fn stability_is_that_of_the_motion_itself(
    balance: &HarmonicBalance<'_>,
    found: &ForcedResponse,
    errors: f64,
) {
    const BESIDE: f64 = 1e-6;
    let folds = [found.folds[0].0, found.folds[1].0];
    let middle = (folds[0] + folds[1]) / 2;
    for place in [0, middle, folds[1] + 100] {
        let motion = &found.motions[place];
        let omega = motion.turning.frequency;
        let (mean, harmonics) = balance.coordinates(&motion.unknown, motion.turning).unwrap();
        let sum = |k: usize, turned: bool| -> f64 {
            let of = |(h, own): (f64, &Vec<c64>)| {
                if turned { (c64::new(0.0, h * omega) * own[k]).re } else { own[k].re }
            };
            (1..=harmonics.len()).map(|h| h as f64).zip(&harmonics).map(of).sum()
        };
        let place_of = balance.bodies().freedoms(&[mean[0] + sum(0, false), mean[1] + sum(1, false)]);
        let velocity = balance.bodies().freedoms(&[sum(0, true), sum(1, true)]);
        let state = [place_of[0], place_of[1], velocity[0], velocity[1]];
        let later = a_period_later(state, omega);
        let columns: Vec<[f64; 4]> = (0..4)
            .map(|column| {
                let mut beside = state;
                beside[column] += BESIDE;
                let ended = a_period_later(beside, omega);
                std::array::from_fn(|row| (ended[row] - later[row]) / BESIDE)
            })
            .collect();
        let matrix = faer::Mat::from_fn(4, 4, |row, column| columns[column][row]);
        let values = judder_dense::general::real_eigenvalues(&matrix).unwrap();
        let expected = values.into_iter().max_by(|a, b| a.norm().total_cmp(&b.norm())).unwrap();
        let own = floquet_multipliers(balance, motion, &|| true).unwrap().unwrap();
        let largest = own.values[0];
        let off = (largest - expected).norm().min((largest - expected.conj()).norm());
        // that of the first motion, which is open all along, to the error of the steps
        let allowed = if place == 0 { 1e-4 } else { errors * own.error };
        assert!(own.phase.is_none() && off < allowed, "{place}: {largest} {expected} {}", own.error);
        let verdict = if expected.norm() > 1.0 { CycleStability::Unstable } else { CycleStability::Stable };
        assert!(
            [verdict, CycleStability::Undecided].contains(&own.verdict()),
            "{place}: {largest} {expected}"
        );
        assert!(place != 0 || own.verdict() == CycleStability::Stable);
        // between the folds one is above one
        assert!(errors.is_infinite() || place != middle || own.verdict() == CycleStability::Unstable);
    }
}

/// A mass on a spring, with a damper that slides: m 944.6, c 7700, k = k_d = 2.4e7, slip force 246.048, driven by half of it (ANSYS, Mechanical APDL Verification
/// Manual, VM320, after J. Guillen 1999: 1.50e-5 m at 209 rad/s).
#[test]
fn a_friction_damper_has_the_published_peak() {
    const SLIPS: f64 = 246.048;
    // the mass, the massless end of the damper's spring, and what presses it
    let stiffness = [vec![4.8e7, -2.4e7, 0.0], vec![-2.4e7, 2.4e7, 0.0], vec![0.0, 0.0, 1e7]];
    let case = assembly(
        [diagonal(&[944.6, 0.0, 0.0]), diagonal(&[7700.0, 0.0, 0.0]), dense(&stiffness)],
        vec![0.0, 0.0, -SLIPS],
        vec![ContactPoint { rest_direction: Some([1.0, 0.0, 0.0]), ..point_on_plane(&[1, 2], 0.0, 0.0) }],
        InterfaceLaw::Rigid(Friction::Constant(1.0)),
    );
    let smooth = case.without_friction_at_rest().unwrap();
    let steady = steady_sliding(&smooth, &Compliance::new(&smooth).unwrap()).unwrap();
    let force =
        HarmonicForce { harmonic: 1, amplitude: vec![c64::new(0.5 * SLIPS, 0.0), c64::ZERO, c64::ZERO] };
    let peaks = [9, 31].map(|harmonics| {
        let series = Series::new(harmonics, 1024);
        let forces = std::slice::from_ref(&force);
        let balance = HarmonicBalance::new(&case, &steady, 209.0, series, forces).unwrap();
        let settings = ResponseSettings {
            rule: PathRule { steps: [0.01, 0.01, 1e-7], ..PathRule::default() },
            between: [100.0, 300.0],
            points: 2000,
            pace: StepMeasure::Fixed(SLIPS),
        };
        let found = forced_response(&balance, &vec![0.0; balance.unknowns()], &settings, &|| true).unwrap();
        assert_eq!(found.end, ResponseEnd::Range);
        let amplitudes = followed(&balance, &found, &Row::of_freedom(0));
        let amplitudes = amplitudes.iter().map(|(frequency, own)| (*frequency, own[1].hypot(own[2])));
        amplitudes.max_by(|a, b| a.1.total_cmp(&b.1)).unwrap()
    });
    let [(_, few), (frequency, many)] = peaks;
    assert!((many / 1.50e-5 - 1.0).abs() < 0.01 && (frequency / 209.0 - 1.0).abs() < 0.01, "{peaks:?}");
    // what NLvib comes to, whose damper's force is computed instant by instant whatever the harmonics of the mass: 1.5054e-5 m at 209.30 rad/s
    assert!((many / 1.5054e-5 - 1.0).abs() < 0.4 * (few / 1.5054e-5 - 1.0).abs(), "{peaks:?}");
}
