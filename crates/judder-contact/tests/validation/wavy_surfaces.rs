//! Wavy surfaces on an elastic substrate: Westergaard (1939); Johnson, Greenwood and Higginson (1985).

use crate::questions::assert_close;
use judder_contact::indenter::HeightMap;
use judder_contact::kernel::substrate::SlidingSubstrate;
use judder_contact::periodic_contact::{PeriodicContact, PeriodicContactError, PeriodicQuestion, solve};
use judder_contact::unilateral::UnilateralLimits;
use std::f64::consts::PI;

/// Δ, over the wave length 1.
const AMPLITUDE: f64 = 0.01;

fn press(surface: &HeightMap, mean_pressure: f64, substrate: &SlidingSubstrate) -> PeriodicContact {
    let limits = UnilateralLimits { tolerance: 1e-9, ..UnilateralLimits::default() };
    let question = PeriodicQuestion { substrate, surface, mean_pressure, limits, memory: u64::MAX };
    let contact = solve(&question).unwrap();
    assert!(contact.solution.converged, "{:?}", contact.solution.errors);
    contact
}

fn surface(columns: usize, rows: usize, height: impl Fn(f64, f64) -> f64) -> HeightMap {
    let spacing = 1.0 / columns as f64;
    let places = (0..columns * rows).map(|index| (index % columns, index / columns));
    let heights = places.map(|(column, row)| height(column as f64 * spacing, row as f64 * spacing));
    HeightMap::new(heights.collect(), columns, rows, spacing, true).unwrap()
}

fn one_wave(columns: usize) -> HeightMap {
    surface(columns, 4, |x, _| -AMPLITUDE * (2.0 * PI * x).cos())
}

fn two_waves(side: usize) -> HeightMap {
    surface(side, side, |x, y| -AMPLITUDE * (2.0 * PI * x).cos() * (2.0 * PI * y).cos())
}

/// Half the contact length, a = (λ/π) asin √(p̄/p*); the pressure; the mean gap Δ (1 − r + r ln r) with r = p̄/p*, the
/// integral of the compliance of a row of punches, (2 λ/π E*) ln sin(π a/λ).
#[test]
fn one_wave_in_partial_contact() {
    let columns = 1024;
    let full = PI * AMPLITUDE;
    for part in [0.05, 0.3, 0.8] {
        let contact = press(&one_wave(columns), part * full, &SlidingSubstrate::elastic());
        let half_length = part.sqrt().asin() / PI;
        assert!((contact.contact_fraction - 2.0 * half_length).abs() < 1.5 / columns as f64);
        assert_close(contact.mean_gap, AMPLITUDE * (1.0 - part + part * part.ln()), 2e-3);
        for column in [0, 10, 30] {
            let wave = (PI * column as f64 / columns as f64).sin();
            let root = (part - wave * wave).sqrt();
            let pressure = 2.0 * full * (1.0 - wave * wave).sqrt() * root;
            assert_close(contact.solution.pressure[column], pressure, 2e-3);
        }
    }
}

/// p = p̄ + p* cos cos with p* = √2 π Δ/λ, and no gap.
#[test]
fn two_waves_in_full_contact() {
    let side = 32;
    let full = 2.0_f64.sqrt() * PI * AMPLITUDE;
    let contact = press(&two_waves(side), 1.1 * full, &SlidingSubstrate::elastic());
    assert_eq!(contact.contact_fraction, 1.0);
    assert!(contact.mean_gap.abs() < 1e-15);
    for (cell, pressure) in contact.solution.pressure.iter().enumerate() {
        let wave = |index: usize| (2.0 * PI * index as f64 / side as f64).cos();
        let wanted = full * (1.1 + wave(cell % side) * wave(cell / side));
        assert!((pressure - wanted).abs() < 1e-6 * full);
    }
}

/// A/A₀ = π (3 p̄/8π p*)^⅔ at light load, 1 − (3/2π)(1 − p̄/p*) near full contact.
#[test]
fn two_waves_near_both_ends() {
    let full = 2.0_f64.sqrt() * PI * AMPLITUDE;
    let area =
        |side, part: f64| press(&two_waves(side), part * full, &SlidingSubstrate::elastic()).contact_fraction;
    let light: f64 = 0.002;
    assert_close(area(256, light), PI * (3.0 * light / (8.0 * PI)).powf(2.0 / 3.0), 0.03);
    let heavy = 0.95;
    assert_close(1.0 - area(128, heavy), 3.0 / (2.0 * PI) * (1.0 - heavy), 0.06);
}

/// The shear stress of a sinusoid in full contact, q²Δ²E″(q v)/[4(1 − ν²)].
#[test]
fn one_wave_in_full_contact_that_slides() {
    let substrate = SlidingSubstrate::single(10.0, 0.08);
    let pressure = 20.0 * PI * AMPLITUDE;
    let contact = press(&one_wave(256), pressure, &substrate);
    let wave = 2.0 * PI;
    let loss = (1.0 / substrate.compliance(wave)).im.abs();
    assert_close(contact.friction * pressure, wave * wave * AMPLITUDE * AMPLITUDE * loss / 4.0, 1e-3);
}

#[test]
fn a_surface_that_ends_is_refused() {
    let wave = two_waves(8);
    let ends = HeightMap::new(wave.heights().to_vec(), 8, 8, wave.spacing(), false).unwrap();
    let substrate = &SlidingSubstrate::elastic();
    let limits = UnilateralLimits::default();
    let question =
        PeriodicQuestion { substrate, surface: &ends, mean_pressure: 0.1, limits, memory: u64::MAX };
    assert_eq!(solve(&question), Err(PeriodicContactError::NotPeriodic));
}
