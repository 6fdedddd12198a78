//! Events of motions that are known in closed form: none missed, none invented, none repeated.

use judder_numerics::dense::product;
use judder_numerics::piecewise::tangent::{along_leg, identity, saltation};
use judder_numerics::piecewise::{MarchError, PiecewiseMarch, PiecewiseSmooth, SectionPlane, StepSettings};
use std::f64::consts::PI;

/// A mass on a spring, with a second spring of stiffness k behind x = w: x″ = −x − k max(x − w, 0).
struct Wall {
    place: f64,
    stiffness: f64,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Side {
    Free,
    Touching,
}

impl PiecewiseSmooth<2> for Wall {
    type Mode = Side;

    fn field(&self, mode: Side, [x, v]: &[f64; 2]) -> [f64; 2] {
        match mode {
            Side::Free => [*v, -x],
            Side::Touching => [*v, -x - self.stiffness * (x - self.place)],
        }
    }

    fn jacobian(&self, mode: Side, _state: &[f64; 2]) -> [[f64; 2]; 2] {
        match mode {
            Side::Free => [[0.0, 1.0], [-1.0, 0.0]],
            Side::Touching => [[0.0, 1.0], [-1.0 - self.stiffness, 0.0]],
        }
    }

    fn guards(&self, _mode: Side) -> usize {
        1
    }

    fn guard(&self, mode: Side, _guard: usize, state: &[f64; 2]) -> f64 {
        match mode {
            Side::Free => self.place - state[0],
            Side::Touching => state[0] - self.place,
        }
    }

    fn guard_gradient(&self, mode: Side, _guard: usize, _state: &[f64; 2]) -> [f64; 2] {
        match mode {
            Side::Free => [-1.0, 0.0],
            Side::Touching => [1.0, 0.0],
        }
    }

    fn cross(&self, mode: Side, _guard: usize, state: &[f64; 2]) -> (Side, [f64; 2]) {
        let next = if mode == Side::Free { Side::Touching } else { Side::Free };
        (next, [self.place, state[1]])
    }
}

fn settings(tolerance: f64) -> StepSettings<2> {
    StepSettings { relative: tolerance, absolute: [tolerance; 2], longest_step: 1.0, steps: 100_000_000 }
}

/// Times of the changes of mode up to a time.
fn changes(wall: &Wall, mode: Side, start: [f64; 2], until: f64, tolerance: f64) -> Vec<f64> {
    let mut march = PiecewiseMarch::new(wall, mode, start, settings(tolerance)).unwrap();
    let mut times = Vec::new();
    while march.time() < until {
        times.extend(march.advance(until).unwrap().crossing.map(|crossing| crossing.time));
    }
    times
}

#[test]
fn the_times_of_touching_and_leaving_are_those_of_the_closed_form() {
    // from x = 0, v = 2: touches w = 1 at asin(1/2), leaves half a period of the stiffer spring's arc later
    let wall = Wall { place: 1.0, stiffness: 3.0 };
    let found = changes(&wall, Side::Free, [0.0, 2.0], 5.0, 1e-13);
    let touch = (0.5_f64).asin();
    // about x = 3/4 with ω = 2: starts a quarter above it with v = √3
    let arc = (PI - 2.0 * (0.25 * 2.0 / 3.0_f64.sqrt()).atan()) / 2.0;
    assert_eq!(found.len(), 2);
    assert!((found[0] - touch).abs() < 1e-12 && (found[1] - touch - arc).abs() < 1e-11, "{found:?}");
}

#[test]
fn a_touch_as_deep_as_1e_minus_12_is_seen_and_a_miss_by_as_much_is_none() {
    let count = |amplitude: f64| {
        changes(&Wall { place: 1.0, stiffness: 3.0 }, Side::Free, [-amplitude, 0.0], 6.0, 1e-15).len()
    };
    assert_eq!(count(1.0 + 1e-12), 2);
    assert_eq!(count(1.0 - 1e-12), 0);
}

#[test]
fn a_start_on_the_wall_crosses_at_once_or_not_at_all() {
    let wall = Wall { place: 0.5, stiffness: 3.0 };
    let towards = changes(&wall, Side::Free, [0.5, 1.0], 0.3, 1e-12);
    assert_eq!(towards, [0.0]);
    assert!(changes(&wall, Side::Free, [0.5, -1.0], 0.3, 1e-12).is_empty());
    assert!(changes(&wall, Side::Touching, [0.5, 1.0], 0.3, 1e-12).is_empty());
    assert_eq!(changes(&wall, Side::Touching, [0.5, -1.0], 0.3, 1e-12), [0.0]);
}

#[test]
#[ignore = "expensive: run by make validate"]
fn a_million_events_are_all_counted() {
    let wall = Wall { place: 0.0, stiffness: 3.0 };
    // half a period at ω = 1 and one at ω = 2, touching and leaving once in each
    let period = PI + PI / 2.0;
    let periods = 500_000.0;
    let found = changes(&wall, Side::Free, [-1.0, 0.0], periods * period, 1e-10);
    assert_eq!(found.len(), 1_000_000);
    assert!((found[999_999] - (periods * period - 0.5 * PI)).abs() < 1e-2, "{}", found[999_999]);
}

#[test]
fn the_tangent_through_the_wall_is_a_difference_of_motions() {
    let wall = Wall { place: 0.3, stiffness: 20.0 };
    let until = 4.0;
    let end = |start: [f64; 2]| {
        let mut march = PiecewiseMarch::new(&wall, Side::Free, start, settings(1e-13)).unwrap();
        let mut tangent = identity();
        while march.time() < until {
            let advance = march.advance(until).unwrap();
            if let Some(leg) = &advance.leg {
                tangent = along_leg(&wall, leg, &tangent);
            }
            if let Some(crossing) = &advance.crossing {
                tangent = product(&saltation(&wall, crossing), &tangent);
            }
        }
        (march.state(), tangent)
    };
    let start = [-1.0, 0.4];
    let (_, tangent) = end(start);
    for column in 0..2 {
        let moved = |by: f64| {
            let mut start = start;
            start[column] += by;
            end(start).0
        };
        for row in 0..2 {
            let difference = (moved(1e-5)[row] - moved(-1e-5)[row]) / 2e-5;
            assert!((difference - tangent[row][column]).abs() < 1e-7, "{difference} {tangent:?}");
        }
    }
}

#[test]
fn returns_to_a_section_come_once_a_period() {
    let wall = Wall { place: 10.0, stiffness: 1.0 };
    let section = SectionPlane { normal: [0.0, 1.0], offset: 0.0 };
    let mut march =
        PiecewiseMarch::new(&wall, Side::Free, [1.0, 0.0], settings(1e-12)).unwrap().with_section(section);
    let mut times = Vec::new();
    while march.time() < 60.0 {
        if march.advance(60.0).unwrap().on_section {
            times.push(march.time());
        }
    }
    assert_eq!(times.len(), 9);
    for (k, time) in times.iter().enumerate() {
        assert!((time - 2.0 * PI * (k + 1) as f64).abs() < 1e-9, "{times:?}");
    }
}

/// A ball that loses half its speed at each bounce on x = 0, under a constant pull.
struct Ball;

impl PiecewiseSmooth<2> for Ball {
    type Mode = ();

    fn field(&self, (): (), [_, v]: &[f64; 2]) -> [f64; 2] {
        [*v, -1.0]
    }

    fn jacobian(&self, (): (), _state: &[f64; 2]) -> [[f64; 2]; 2] {
        [[0.0, 1.0], [0.0, 0.0]]
    }

    fn guards(&self, (): ()) -> usize {
        1
    }

    fn guard(&self, (): (), _guard: usize, state: &[f64; 2]) -> f64 {
        state[0]
    }

    fn guard_gradient(&self, (): (), _guard: usize, _state: &[f64; 2]) -> [f64; 2] {
        [1.0, 0.0]
    }

    fn cross(&self, (): (), _guard: usize, state: &[f64; 2]) -> ((), [f64; 2]) {
        ((), [0.0, -0.5 * state[1]])
    }
}

#[test]
fn bounces_that_accumulate_are_recognised_where_they_do() {
    let mut march = PiecewiseMarch::new(&Ball, (), [0.0, 1.0], settings(1e-12)).unwrap();
    let error = loop {
        if let Err(error) = march.advance(10.0) {
            break error;
        }
    };
    // flights of 2, 1, 1/2, … end at 4
    let MarchError::Accumulation { time, .. } = error else { panic!("{error}") };
    assert!((time - 4.0).abs() < 1e-9, "{time}");
}

/// A corner: two guards, x ≥ 0 and y ≥ 0, on a motion along the diagonal.
struct Corner;

impl PiecewiseSmooth<2> for Corner {
    type Mode = (bool, bool);

    fn field(&self, _mode: (bool, bool), _state: &[f64; 2]) -> [f64; 2] {
        [-1.0, -1.0]
    }

    fn jacobian(&self, _mode: (bool, bool), _state: &[f64; 2]) -> [[f64; 2]; 2] {
        [[0.0; 2]; 2]
    }

    fn guards(&self, mode: (bool, bool)) -> usize {
        usize::from(!mode.0) + usize::from(!mode.1)
    }

    fn guard(&self, mode: (bool, bool), guard: usize, state: &[f64; 2]) -> f64 {
        state[guard + usize::from(mode.0)]
    }

    fn guard_gradient(&self, mode: (bool, bool), guard: usize, _state: &[f64; 2]) -> [f64; 2] {
        if guard + usize::from(mode.0) == 0 { [1.0, 0.0] } else { [0.0, 1.0] }
    }

    fn cross(&self, mode: (bool, bool), guard: usize, state: &[f64; 2]) -> ((bool, bool), [f64; 2]) {
        if guard + usize::from(mode.0) == 0 {
            ((true, mode.1), [0.0, state[1]])
        } else {
            ((mode.0, true), [state[0], 0.0])
        }
    }
}

#[test]
fn two_events_at_one_instant_both_happen_once_and_in_order() {
    let mut march = PiecewiseMarch::new(&Corner, (false, false), [1.0, 1.0], settings(1e-12)).unwrap();
    let mut crossed = Vec::new();
    while march.time() < 3.0 {
        crossed.extend(march.advance(3.0).unwrap().crossing.map(|crossing| (crossing.to, crossing.time)));
    }
    // of two at one instant the first guard comes first
    assert_eq!(crossed.iter().map(|(to, _)| *to).collect::<Vec<_>>(), [(true, false), (true, true)]);
    assert_eq!(march.mode(), (true, true));
    assert!(crossed.iter().all(|(_, time)| (time - 1.0).abs() < 1e-14), "{crossed:?}");
}

/// A field that is not a number beyond x = 1.
#[derive(Debug)]
struct Cliff;

impl PiecewiseSmooth<1> for Cliff {
    type Mode = ();

    fn field(&self, (): (), state: &[f64; 1]) -> [f64; 1] {
        [if state[0] < 1.0 { 1.0 } else { f64::NAN }]
    }

    fn jacobian(&self, (): (), _state: &[f64; 1]) -> [[f64; 1]; 1] {
        [[0.0]]
    }

    fn guards(&self, (): ()) -> usize {
        0
    }

    fn guard(&self, (): (), _guard: usize, _state: &[f64; 1]) -> f64 {
        1.0
    }

    fn guard_gradient(&self, (): (), _guard: usize, _state: &[f64; 1]) -> [f64; 1] {
        [0.0]
    }

    fn cross(&self, (): (), _guard: usize, state: &[f64; 1]) -> ((), [f64; 1]) {
        ((), *state)
    }
}

#[test]
fn a_motion_without_a_future_ends_with_an_error_and_its_place() {
    let limits = StepSettings { relative: 1e-9, absolute: [1e-9], longest_step: 1.0, steps: 1000 };
    let run = |limits: StepSettings<1>| {
        let mut march = PiecewiseMarch::new(&Cliff, (), [0.0], limits).unwrap();
        loop {
            match march.advance(2.0) {
                Ok(_) if march.time() >= 2.0 => panic!("passed"),
                Ok(_) => {}
                Err(error) => return error,
            }
        }
    };
    assert!(matches!(run(limits), MarchError::StepTooShort { time, .. } if (time - 1.0).abs() < 1e-12));
    assert!(matches!(run(StepSettings { steps: 3, ..limits }), MarchError::StepsSpent { steps: 3, .. }));
    assert_eq!(
        PiecewiseMarch::new(&Cliff, (), [f64::NAN], limits).unwrap_err().to_string(),
        "component 0 of the state is not finite: NaN"
    );
}
