//! No step of a march allocates memory.
#![allow(clippy::unwrap_used, unsafe_code, reason = "an allocator that counts")]
mod common;

use judder_sliding::march::{ContactMethod, March, MarchSample, MarchSettings, Predictor, Reached};
use judder_sliding::motion::{InitialDamping, Motion, Noise, Ramps};
use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

thread_local! {
    static ALLOCATIONS: Cell<usize> = const { Cell::new(0) };
}

struct Counting;

// SAFETY: every request goes to the system's allocator as it is.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        let _ = ALLOCATIONS.try_with(|count| count.set(count.get() + 1));
        // SAFETY: the caller's own request.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, place: *mut u8, layout: Layout) {
        // SAFETY: the caller's own request.
        unsafe { System.dealloc(place, layout) }
    }
}

#[global_allocator]
static COUNTING: Counting = Counting;

/// Ramps, noise, nodes passed, damping released: the steps of all of it by each method.
#[test]
fn no_step_allocates() {
    let pair = common::pair();
    let motion = Motion {
        start: 0.0898,
        end: 0.0921,
        noise: Noise { force: 1e-4, seed: 1 },
        ramps: Ramps { velocity: 0.005, load: 0.005, friction: 0.005, gap: 0.005 },
        initial_damping: Some(InitialDamping { alpha: 40.0, beta: 4e-8, hold: 0.01, release: 0.01 }),
        ..common::motion()
    };
    let methods = [
        ContactMethod::Subs { static_slope: false },
        ContactMethod::Subs { static_slope: true },
        ContactMethod::EnSubs,
        ContactMethod::Film,
    ];
    for method in methods {
        let settings = MarchSettings { method, predictor: Predictor::WithForce, step: 3e-7, motion };
        assert_eq!(allocations(March::new(&pair, settings).unwrap()), 0, "{method:?}");
    }
    let method = ContactMethod::ResidualFlexibility { cut_off: 60e3 };
    let settings = MarchSettings { method, predictor: Predictor::WithForce, step: 2e-6, motion };
    assert_eq!(allocations(March::new(&pair, settings).unwrap()), 0);
}

fn allocations(mut march: March<'_>) -> usize {
    let mut passed = 0.0;
    let mut take = |sample: &MarchSample, _: &[f64]| passed += sample.normal_force;
    let before = ALLOCATIONS.with(Cell::get);
    assert_eq!(march.advance(u64::MAX, &mut take), Ok(Reached::End));
    ALLOCATIONS.with(Cell::get) - before
}
