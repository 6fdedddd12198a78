//! The questions that the tests ask.

use judder_contact::kernel::substrate::SlidingSubstrate;
use judder_contact::steady::profile::{Paraboloid, Profile};
use judder_contact::steady::{GridChoice, MEMORY, SteadyContact, SteadyQuestion, solve};
use judder_contact::transient::{
    CreepingSubstrate, IndenterPath, TransientGrid, TransientHistory, TransientQuestion, run,
};
use judder_contact::unilateral::{Loading, UnilateralLimits};
use std::ops::ControlFlow;

/// A paraboloid on a fitted grid, solved to 1e-7 of the depth.
pub(crate) fn paraboloid(substrate: &SlidingSubstrate, loading: Loading, cells: usize) -> SteadyContact {
    on_grid(substrate, &Paraboloid, loading, GridChoice::Cells(cells), 1e-7)
}

pub(crate) fn on_grid(
    substrate: &SlidingSubstrate,
    profile: &dyn Profile,
    loading: Loading,
    grid: GridChoice,
    tolerance: f64,
) -> SteadyContact {
    let limits = UnilateralLimits { tolerance, ..UnilateralLimits::default() };
    solve(&SteadyQuestion { substrate, profile, loading, accuracy: 1e-2, grid, limits, memory: MEMORY })
        .unwrap()
}

/// |found/wanted − 1| within a tolerance.
#[track_caller]
pub(crate) fn assert_close(found: f64, wanted: f64, tolerance: f64) {
    let deviation = (found / wanted - 1.0).abs();
    assert!(
        deviation <= tolerance,
        "{found} should be {wanted}: off by {deviation:.2e}, allowed {tolerance:.1e}"
    );
}

/// A paraboloid followed along a path; every step solved within the tolerance.
pub(crate) fn follow(question: &TransientQuestion<'_>) -> TransientHistory {
    let history = run(question, &mut |_| ControlFlow::Continue(())).unwrap();
    assert!(history.completed && history.converged);
    history
}

/// A question about a paraboloid with this many cells a side.
pub(crate) fn transient<'a>(
    substrate: &'a CreepingSubstrate,
    path: &'a IndenterPath,
    duration: f64,
    cells: usize,
) -> TransientQuestion<'a> {
    let question = TransientQuestion::new(substrate, &Paraboloid, path, duration);
    TransientQuestion { grid: TransientGrid { cells, ..question.grid }, ..question }
}
