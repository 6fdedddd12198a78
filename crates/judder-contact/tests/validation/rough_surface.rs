//! Generated surfaces have the spectrum that was asked for.

use judder_contact::indenter::{HeightMap, RoughSurface, Roughness};
use std::f64::consts::PI;

const SIDE: usize = 128;

fn surface(roughness: Roughness) -> HeightMap {
    RoughSurface {
        period: 1.0,
        cells: SIDE,
        hurst: 0.8,
        roll_off: 0.25,
        cut_off: 1.0 / 32.0,
        roughness,
        seed: 3,
    }
    .generate()
    .unwrap()
}

/// |ĥ|² of one mode by its sum, without the library's transforms.
fn power(heights: &[f64], along: i32, across: i32) -> f64 {
    let (mut real, mut imaginary) = (0.0, 0.0);
    for (index, height) in heights.iter().enumerate() {
        let turns = (index % SIDE) as f64 * f64::from(along) + (index / SIDE) as f64 * f64::from(across);
        let (sine, cosine) = (2.0 * PI * turns / SIDE as f64).sin_cos();
        real += height * cosine;
        imaginary += height * sine;
    }
    (real * real + imaginary * imaginary) / (SIDE * SIDE) as f64
}

/// The mean power over the modes of a ring of wave numbers.
fn ring(heights: &[f64], from: f64, to: f64) -> f64 {
    let modes = (0..=32).flat_map(|along| (-32..=32).map(move |across| (along, across)));
    let inside =
        |(along, across): &(i32, i32)| (from..to).contains(&f64::from(*along).hypot(f64::from(*across)));
    let powers: Vec<f64> = modes.filter(inside).step_by(3).map(|(x, y)| power(heights, x, y)).collect();
    powers.iter().sum::<f64>() / powers.len() as f64
}

fn root_mean_square(values: impl ExactSizeIterator<Item = f64>) -> f64 {
    let count = values.len() as f64;
    (values.map(|value| value * value).sum::<f64>() / count).sqrt()
}

#[test]
fn the_density_falls_with_the_hurst_exponent_between_roll_off_and_cut_off() {
    let map = surface(Roughness::Height(0.01));
    let (long, short) = (ring(map.heights(), 5.0, 7.0), ring(map.heights(), 22.0, 27.0));
    let exponent = (short / long).ln() / (24.6_f64 / 6.0).ln();
    assert!((exponent + 2.0 + 2.0 * 0.8).abs() < 0.4, "{exponent}");
    let plateau = ring(map.heights(), 1.0, 4.0) / ring(map.heights(), 3.9, 5.0);
    assert!(plateau > 0.4 && plateau < 2.5, "{plateau}");
    let beyond = ring(map.heights(), 32.5, 45.0);
    assert!(beyond < 1e-20 * short, "{beyond}");
}

#[test]
fn the_roughness_is_that_asked_for() {
    let map = surface(Roughness::Height(0.01));
    let mean = map.heights().iter().sum::<f64>() / map.heights().len() as f64;
    let height = root_mean_square(map.heights().iter().map(|height| height - mean));
    assert!((height / 0.01 - 1.0).abs() < 1e-12, "{height}");
    assert_eq!(map.heights().iter().copied().fold(f64::INFINITY, f64::min), 0.0);
}

#[test]
fn the_slope_is_that_asked_for() {
    // Central differences of the interpolation over a small step; the interpolation itself is off by (q h)⁴.
    let map = surface(Roughness::Slope(0.3));
    let grid = map.grid();
    let step = 0.5 * grid.cell;
    let squares = (0..grid.len()).map(|cell| {
        let (x, y) = (grid.x(cell % SIDE), grid.y(cell / SIDE));
        let along = (map.height(x + step, y) - map.height(x - step, y)) / (2.0 * step);
        let across = (map.height(x, y + step) - map.height(x, y - step)) / (2.0 * step);
        along.hypot(across)
    });
    let slope = root_mean_square(squares);
    assert!((slope / 0.3 - 1.0).abs() < 0.05, "{slope}");
}
