//! Sweeps: accurate, reproducible, resumable, without holes.

use crate::synthetic::{contact, material, origin, sample};
use judder_contact::law::sweep::{
    CollapseRequest, LawSample, SolvedLawPoint, SweepEnd, SweepObserver, SweepRange, SweepRequest,
    collapse_sweep, sweep,
};
use judder_contact::law::{LawError, LawIndenter, LawMaterial, PerQuantity};
use judder_contact::{ContactLaw, LawPoint};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

fn request(accuracy: f64) -> SweepRequest {
    SweepRequest {
        origin: origin(LawIndenter::Sphere),
        range: SweepRange::covering((1e-6, 1e2), (1e-4, 0.3), &material()).unwrap(),
        accuracy: PerQuantity::uniform(accuracy),
        most_points: 4000,
    }
}

/// Collects, and stops after a number of points.
struct Watch {
    points: Mutex<Vec<SolvedLawPoint>>,
    begun: AtomicUsize,
    limit: usize,
}

impl Watch {
    fn new(limit: usize) -> Self {
        Self { points: Mutex::default(), begun: AtomicUsize::new(0), limit }
    }
}

impl SweepObserver for Watch {
    fn finished(&self, point: &SolvedLawPoint, done: usize, planned: usize) {
        assert!(done >= 1 && done <= planned);
        self.points.lock().unwrap().push(*point);
    }

    fn interrupted(&self) -> bool {
        self.begun.fetch_add(1, Ordering::Relaxed) >= self.limit
    }
}

#[test]
fn as_accurate_as_asked_and_no_finer() {
    let coarse = sweep(&request(1e-2), &[], &sample(LawIndenter::Sphere), &()).unwrap();
    let fine = sweep(&request(1e-3), &[], &sample(LawIndenter::Sphere), &()).unwrap();
    for (sweep, accuracy) in [(&coarse, 1e-2), (&fine, 1e-3)] {
        assert_eq!(sweep.end, SweepEnd::Accurate);
        let last = sweep.levels.last().unwrap();
        assert_eq!(sweep.points.len(), last.columns * last.rows);
        for (v, y) in [(3e-5, 3e-4), (1e-2, 1e-2), (0.3, 0.2), (4.0, 7e-3)] {
            let force = sweep.law.evaluate(&LawPoint::new(v, y)).force.value;
            assert!((force / contact(LawIndenter::Sphere, v, y).force - 1.0).abs() < accuracy);
        }
        assert_eq!(sweep.law.data().errors().solver, PerQuantity { force: 1e-4, area: 2e-4, friction: 3e-4 });
    }
    assert!(coarse.points.len() < fine.points.len() && coarse.points.len() < 400);
}

#[test]
fn the_same_on_any_number_of_threads_and_after_an_interruption() {
    let run = |threads: usize, known: &[SolvedLawPoint], observer: &dyn SweepObserver| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| sweep(&request(1e-2), known, &sample(LawIndenter::Sphere), observer))
    };
    let alone = run(1, &[], &()).unwrap();
    assert_eq!(run(5, &[], &()).unwrap(), alone);
    let watch = Watch::new(70);
    let stopped = run(3, &[], &watch);
    let Err(LawError::Interrupted { finished }) = stopped else { panic!("{stopped:?}") };
    let kept = watch.points.into_inner().unwrap();
    assert_eq!(kept.len(), finished);
    assert!((27..=70).contains(&finished));
    // through the text in which a study keeps them
    let kept: Vec<SolvedLawPoint> = serde_json::from_str(&serde_json::to_string(&kept).unwrap()).unwrap();
    let rest = Watch::new(usize::MAX);
    assert_eq!(run(2, &kept, &rest).unwrap(), alone);
    assert_eq!(rest.points.into_inner().unwrap().len() + finished, alone.points.len());
}

#[test]
fn points_that_fail_are_all_named_and_nothing_is_guessed() {
    let failing = |v: f64, y: f64| {
        if v > 1.0 && y > 0.1 { Err("stalled") } else { Ok(sample(LawIndenter::Sphere)(v, y).unwrap()) }
    };
    let Err(LawError::FailedPoints { attempted, failures }) = sweep(&request(1e-2), &[], &failing, &())
    else {
        panic!("a law with holes")
    };
    assert_eq!(attempted, 27);
    assert!(!failures.is_empty() && failures.iter().all(|f| f.velocity > 1.0 && f.cause == "stalled"));
    let nan = |v: f64, y: f64| sample(LawIndenter::Sphere)(v, y).map(|s| LawSample { area: f64::NAN, ..s });
    assert!(matches!(sweep(&request(1e-2), &[], &nan, &()), Err(LawError::FailedPoints { .. })));
}

#[test]
fn a_solver_that_is_not_accurate_enough_ends_the_sweep_and_says_so() {
    // noise of half a percent, a different one at every point
    let noisy = |v: f64, y: f64| {
        sample(LawIndenter::Sphere)(v, y).map(|s| {
            let bits = (v.to_bits() ^ y.to_bits().rotate_left(17)).wrapping_mul(0x9E37_79B9_7F4A_7C15);
            let noise = 5e-3 * ((bits >> 11) as f64 / (1_u64 << 52) as f64 - 1.0);
            LawSample { friction: s.friction * (1.0 + noise), friction_error: 5e-3, ..s }
        })
    };
    let request = SweepRequest { most_points: 100_000, ..request(1e-3) };
    let sweep = sweep(&request, &[], &noisy, &()).unwrap();
    assert_eq!(sweep.end, SweepEnd::SolverError);
    assert!(sweep.law.data().errors().interpolation.friction > 1e-3);
}

#[test]
fn a_paraboloid_needs_one_curve() {
    let request = CollapseRequest {
        material: material(),
        source: "test".to_owned(),
        ln_speeds: SweepRange::all_speeds(&material()),
        indentation: 0.01,
        accuracy: PerQuantity::uniform(2e-3),
        most_points: 200,
    };
    let made = collapse_sweep(&request, &[], &sample(LawIndenter::Paraboloid), &()).unwrap();
    assert_eq!(made.end, SweepEnd::Accurate);
    for (v, y) in [(1e-9, 1e-7), (1e-3, 1e-4), (2.0, 0.05)] {
        let response = made.law.evaluate(&LawPoint::new(v, y));
        let exact = contact(LawIndenter::Paraboloid, v, y);
        assert!((response.force.value / exact.force - 1.0).abs() < 2e-3);
        assert!((response.area.value / exact.area - 1.0).abs() < 2e-3);
        assert!((response.friction.value / exact.friction - 1.0).abs() < 2e-3);
    }
    let few = CollapseRequest { most_points: 9, ..request };
    let few = collapse_sweep(&few, &[], &sample(LawIndenter::Paraboloid), &()).unwrap();
    assert_eq!((few.end, few.points.len()), (SweepEnd::MostPoints, 9));
}

#[test]
fn requests_without_sense_are_refused() {
    let covering = |v, y| SweepRange::covering(v, y, &material());
    assert!(covering((0.0, 1.0), (1e-3, 0.1)).is_err());
    assert!(covering((1e-3, f64::NAN), (1e-3, 0.1)).is_err());
    assert!(covering((1e-3, 1.0), (0.1, 1e-3)).is_err());
    let none = LawMaterial { modulus_ratio: f64::NAN, ..material() };
    assert!(SweepRange::covering((1e-3, 1.0), (1e-3, 0.1), &none).is_err());
    // windows wholly in a tail still give a table
    assert!(covering((1e-12, 1e-11), (1e-3, 0.1)).is_ok() && covering((1e9, 1e10), (1e-3, 0.1)).is_ok());
    let asked = |accuracy| sweep(&request(accuracy), &[], &sample(LawIndenter::Sphere), &());
    assert!(matches!(asked(0.0), Err(LawError::InvalidNumber { .. })));
    let too_deep = SweepRequest { range: covering((1e-3, 1.0), (1e-3, 2.0)).unwrap(), ..request(1e-2) };
    assert!(sweep(&too_deep, &[], &sample(LawIndenter::Sphere), &()).is_err());
}
