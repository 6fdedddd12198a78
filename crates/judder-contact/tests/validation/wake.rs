//! The wake kernel against its definition, integrated in 40 digits by `wake_oracle.py` (mpmath).

use judder_contact::kernel::substrate::{SlidingSubstrate, WakeTerm};
use judder_contact::kernel::wake::WakeKernel;
use std::collections::BTreeMap;

/// x, y, wake length (all in cells), displacement.
const ORACLE: &str = include_str!("wake_oracle.csv");

/// Half the width, in cells, of a kernel that covers every place of the oracle.
const CELLS: usize = 129;

/// The printed tolerance of the kernel.
const TOLERANCE: f64 = 1e-10;

fn numbers(line: &str) -> [f64; 4] {
    let numbers: Vec<f64> = line.split(',').map(|number| number.parse().unwrap()).collect();
    numbers.try_into().unwrap()
}

#[test]
fn the_kernel_agrees_with_its_definition_from_the_shortest_wake_to_the_longest() {
    let mut kernels = BTreeMap::new();
    let mut places = 0;
    for [x, y, length, expected] in ORACLE.lines().map(numbers) {
        let column = x.ceil();
        let kernel = kernels.entry((length.to_bits(), (column - x).to_bits())).or_insert_with(|| {
            let terms = vec![WakeTerm { compliance: 1.0, length }];
            WakeKernel::new(
                CELLS,
                CELLS,
                column - x,
                &SlidingSubstrate { instantaneous: 0.0, terms, layer: None },
            )
        });
        let index = y as usize * (2 * CELLS - 1) + (column + CELLS as f64 - 1.0) as usize;
        let error = kernel.values[index] / expected - 1.0;
        assert!(error.abs() < TOLERANCE, "x {x}, y {y}, length {length}: {error:.1e}");
        places += 1;
    }
    assert_eq!(places, 308);
}
