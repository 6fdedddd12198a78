//! What an operator is not made for.

use judder_contact::kernel::check::KernelError;
use judder_contact::kernel::sliding::SlidingOperator;
use judder_contact::kernel::substrate::{SlidingSubstrate, WakeTerm};
use judder_contact::surface::grid::SurfaceGrid;

const GRID: SurfaceGrid = SurfaceGrid { columns: 8, rows: 4, cell: 0.1, origin: [0.0, 0.0] };

fn one_term(instantaneous: f64, compliance: f64, length: f64) -> SlidingSubstrate {
    SlidingSubstrate { instantaneous, terms: vec![WakeTerm { compliance, length }], layer: None }
}

/// Why there is no operator.
fn refusal(grid: &SurfaceGrid, substrate: &SlidingSubstrate, allowed: u64) -> Option<KernelError> {
    SlidingOperator::new(*grid, substrate, allowed).err()
}

#[test]
fn every_bad_number_is_named() {
    let sound = SlidingSubstrate::single(10.0, 1.0);
    assert_eq!(refusal(&GRID, &sound, u64::MAX), None);
    for cell in [0.0, -1.0, f64::INFINITY] {
        assert_eq!(
            refusal(&SurfaceGrid { cell, ..GRID }, &sound, u64::MAX),
            Some(KernelError::Cell { cell })
        );
    }
    assert!(matches!(
        refusal(&SurfaceGrid { cell: f64::NAN, ..GRID }, &sound, u64::MAX),
        Some(KernelError::Cell { cell }) if cell.is_nan()
    ));
    assert_eq!(
        refusal(&SurfaceGrid { rows: 0, ..GRID }, &sound, u64::MAX),
        Some(KernelError::NoCells { columns: 8, rows: 0 })
    );
    for value in [-0.1, f64::INFINITY] {
        assert_eq!(
            refusal(&GRID, &one_term(value, 0.5, 1.0), u64::MAX),
            Some(KernelError::Instantaneous { value })
        );
        assert_eq!(
            refusal(&GRID, &one_term(0.1, value, 1.0), u64::MAX),
            Some(KernelError::Compliance { term: 0, value })
        );
        assert_eq!(
            refusal(&GRID, &one_term(0.1, 0.5, value), u64::MAX),
            Some(KernelError::Length { term: 0, value })
        );
    }
    assert_eq!(refusal(&GRID, &one_term(0.0, 0.0, 1.0), u64::MAX), Some(KernelError::Rigid));
}

#[test]
fn memory_is_asked_for_before_it_is_taken() {
    let needed = SlidingOperator::memory_bytes(1 << 20, 1 << 20);
    let grid = SurfaceGrid { columns: 1 << 20, rows: 1 << 20, ..GRID };
    let (columns, rows, allowed) = (1 << 20, 1 << 20, 1 << 40);
    assert_eq!(
        refusal(&grid, &SlidingSubstrate::elastic(), allowed),
        Some(KernelError::Memory { columns, rows, needed, allowed })
    );
}

#[test]
fn a_line_has_one_row_and_a_reference() {
    let sound = SlidingSubstrate::elastic();
    let line = SurfaceGrid { rows: 1, ..GRID };
    assert_eq!(
        SlidingOperator::line(GRID, &sound, 10.0, u64::MAX).err(),
        Some(KernelError::Rows { rows: 4 })
    );
    assert_eq!(
        SlidingOperator::line(line, &sound, 0.0, u64::MAX).err(),
        Some(KernelError::Reference { value: 0.0 })
    );
}

#[test]
fn a_wake_that_reaches_into_the_next_period_is_refused_with_what_it_carries() {
    let refused = SlidingOperator::periodic(GRID, &SlidingSubstrate::single(10.0, 0.4), u64::MAX).err();
    let Some(KernelError::LongWake { period, length, memory, .. }) = refused else { panic!("{refused:?}") };
    assert_eq!((period, length), (0.8, 0.4));
    assert!((memory - 0.9 * (-2.0_f64).exp()).abs() < 1e-15);
    assert!(SlidingOperator::periodic(GRID, &SlidingSubstrate::single(10.0, 0.1), u64::MAX).is_ok());
}
