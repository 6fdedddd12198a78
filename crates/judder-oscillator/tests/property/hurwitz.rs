//! The sign of the Hurwitz conditions is the sign of the growth rate.
//!
//! On random points there is no band at all: every verdict is that of the eigenvalues. On points driven into the boundary by
//! bisection no verdict contradicts the eigenvalues either; what is called marginal there has a growth rate below 1e-9 of the
//! largest eigenvalue on the oscillator, and below 3e-6 on general systems with damping down to 1e-16. (That much only where two
//! nearly undamped modes merge: there the growth rate is as the square root of the margin.)

use crate::sampling::{any_contact, any_groups, any_system, for_each, linearised};
use judder_oscillator::characteristic::Characteristic;
use judder_oscillator::linear_system::{LinearSystem, ReducedSystem};
use judder_oscillator::spectrum::{eigenvalues, growth_rate};
use judder_oscillator::{Groups, Verdict};
use num_complex::Complex64;
use proptest::prelude::*;
use proptest::test_runner::TestCaseResult;

/// Refuses numbers that are not the eigenvalues: each must solve det(λ² + λC + K) = 0 to rounding, and with the right sum.
fn check_spectrum(system: &ReducedSystem, values: &[Complex64; 4]) -> TestCaseResult {
    let ReducedSystem { damping: c, stiffness: k } = system;
    for value in values {
        let entry = |i: usize, j: usize| {
            let inertia = if i == j { value * value } else { Complex64::ZERO };
            let size = inertia.norm() + (value * c[i][j]).norm() + k[i][j].abs();
            (inertia + value * c[i][j] + k[i][j], size)
        };
        let (a, b, d, e) = (entry(0, 0), entry(0, 1), entry(1, 0), entry(1, 1));
        let (determinant, size) = (a.0 * e.0 - b.0 * d.0, a.1 * e.1 + b.1 * d.1);
        prop_assert!(determinant.norm() <= 1e-13 * size, "{value} leaves {:e}", determinant.norm() / size);
    }
    let (sum, size) =
        values.iter().fold((Complex64::ZERO, 0.0), |(sum, size), value| (sum + value, size + value.norm()));
    prop_assert!((sum + c[0][0] + c[1][1]).norm() <= 1e-12 * size);
    Ok(())
}

/// Verdict, growth rate, and largest magnitude of an eigenvalue.
fn judge(system: &LinearSystem) -> Result<(Verdict, f64, f64), TestCaseError> {
    let reduced = system.reduced().unwrap();
    let values = eigenvalues(&reduced).unwrap();
    check_spectrum(&reduced, &values)?;
    let largest = values.iter().map(|value| value.norm()).fold(0.0, f64::max);
    Ok((Characteristic::new(&reduced).verdict(), growth_rate(&values), largest))
}

/// The verdict of the eigenvalues alone.
fn by_sign(growth: f64) -> Verdict {
    if growth > 0.0 { Verdict::Unstable } else { Verdict::Stable }
}

#[test]
fn every_verdict_on_the_oscillator_is_that_of_its_eigenvalues() {
    for_each(100_000, (any_contact(), any_groups()), |(contact, groups)| {
        let (verdict, growth, _) = judge(&linearised(&contact, &groups.coefficients().unwrap()).system())?;
        prop_assert_eq!(verdict, by_sign(growth), "growth rate {:e}", growth);
        Ok(())
    });
}

#[test]
fn every_verdict_on_a_general_system_is_that_of_its_eigenvalues() {
    for_each(100_000, any_system(), |system| {
        let (verdict, growth, _) = judge(&system)?;
        prop_assert_eq!(verdict, by_sign(growth), "growth rate {:e}", growth);
        Ok(())
    });
}

/// Bisects a path from 0 to 1 for the change of verdict and checks every point that it visits. `band`: the largest growth
/// rate that may be called marginal, over the largest magnitude of an eigenvalue.
fn drive_into_the_boundary(band: f64, system: impl Fn(f64) -> LinearSystem) -> TestCaseResult {
    let check = |position: f64| {
        let (verdict, growth, largest) = judge(&system(position))?;
        if verdict == Verdict::Marginal {
            prop_assert!(growth.abs() <= band * largest, "marginal with {:e}", growth.abs() / largest);
        } else {
            prop_assert_eq!(verdict, by_sign(growth), "growth rate {:e}", growth);
        }
        Ok(verdict)
    };
    let (mut near, mut far) = (0.0, 1.0);
    let start = check(near)?;
    if start == check(far)? {
        return Ok(());
    }
    for _ in 0..52 {
        let middle = 0.5 * (near + far);
        if check(middle)? == start { near = middle } else { far = middle }
    }
    Ok(())
}

fn between(a: [[f64; 2]; 2], b: [[f64; 2]; 2], position: f64) -> [[f64; 2]; 2] {
    std::array::from_fn(|i| std::array::from_fn(|j| a[i][j] + position * (b[i][j] - a[i][j])))
}

#[test]
fn no_verdict_on_a_general_system_turns_at_its_boundary() {
    for_each(20_000, (any_system(), any_system()), |(a, b)| {
        drive_into_the_boundary(3e-6, |position| LinearSystem {
            mass: between(a.mass, b.mass, position),
            damping: between(a.damping, b.damping, position),
            stiffness: between(a.stiffness, b.stiffness, position),
        })
    });
}

#[test]
fn no_verdict_on_the_oscillator_turns_at_its_boundary() {
    for_each(20_000, (any_contact(), any_groups(), any_groups()), |(contact, a, b)| {
        let blend = |from: f64, to: f64, position: f64| (from.ln() + position * (to / from).ln()).exp();
        drive_into_the_boundary(1e-9, |position| {
            let groups = Groups {
                velocity: blend(a.velocity, b.velocity, position),
                normal_load: blend(a.normal_load, b.normal_load, position),
                shear_strength: a.shear_strength + position * (b.shear_strength - a.shear_strength),
                ..a
            };
            linearised(&contact, &groups.coefficients().unwrap()).system()
        })
    });
}
