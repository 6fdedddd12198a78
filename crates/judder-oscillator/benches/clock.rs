//! Wall times of the 1000 × 1000 maps of Figs. 9 and 10 on one thread, as one line of JSON a panel: the Rust side of `benches/compare.py`.
//!
//! `clock [FIGURE LOAD [FILE]]`: one panel or all of them; `FILE` receives the class codes, row by row, one byte a point.

#[path = "../tests/panels/mod.rs"]
mod panels;

use judder_oscillator::map::{adaptive, every_point};
use judder_oscillator::mechanism::StabilityClass;
use multiversion::multiversion;
use panels::Panel;
use std::hint::black_box;
use std::time::Instant;

const POINTS: usize = 1000;

/// The median wall time of `repeats` calls, in seconds, and the last result.
fn median_seconds<T>(repeats: usize, mut work: impl FnMut() -> T) -> (f64, T) {
    let mut result = work();
    let mut seconds: Vec<f64> = (0..repeats)
        .map(|_| {
            let start = Instant::now();
            result = black_box(work());
            start.elapsed().as_secs_f64()
        })
        .collect();
    seconds.sort_by(f64::total_cmp);
    (seconds[repeats / 2], result)
}

/// Independent products and sums: enough to hide the latency of each, few enough for the registers.
const CHAINS: usize = 64;

/// Multiplications and additions that never leave the registers, as many of each: what the core can do at most without
/// fused operations, which the decision does not use either.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl", "x86_64+avx2", "aarch64+neon"))]
fn multiply_and_add(rounds: usize) -> f64 {
    let (mut products, mut sums) = ([1.0_f64; CHAINS], [0.0_f64; CHAINS]);
    let (factor, term) = (black_box(1.000_000_1), black_box(1e-9));
    for _ in 0..rounds {
        for k in 0..CHAINS {
            products[k] *= factor;
            sums[k] += term;
        }
    }
    products.iter().chain(&sums).sum()
}

fn peak_operations_per_second() -> f64 {
    const ROUNDS: usize = 1_000_000;
    let (seconds, _) = median_seconds(5, || multiply_and_add(black_box(ROUNDS)));
    (2 * CHAINS * ROUNDS) as f64 / seconds
}

fn report(panel: &Panel, file: Option<&String>) -> std::io::Result<()> {
    let (brute, map) = median_seconds(5, || every_point(&panel.contact, &panel.plane));
    let (fast, adaptive_map) = median_seconds(31, || adaptive(&panel.contact, &panel.plane));
    if let Some(file) = file {
        std::fs::write(file, &map.classes)?;
    }
    let counts: Vec<usize> = StabilityClass::ALL.into_iter().map(|class| map.count(class)).collect();
    println!(
        "{{\"figure\": \"{}\", \"friction_load\": \"{}\", \"points\": {}, \"every_point_seconds\": {brute}, \
         \"adaptive_seconds\": {fast}, \"adaptive_decisions\": {}, \"maps_agree\": {}, \"class_counts\": {counts:?}, \
         \"unstable_fraction\": {}, \"peak_operations_per_second\": {}}}",
        panel.figure,
        panel.load_name(),
        map.decisions,
        adaptive_map.decisions,
        map.classes == adaptive_map.classes,
        map.unstable_fraction(),
        peak_operations_per_second(),
    );
    Ok(())
}

fn main() -> std::io::Result<()> {
    // cargo passes `--bench`
    let arguments: Vec<String> = std::env::args().skip(1).filter(|a| !a.starts_with("--")).collect();
    let asked =
        |p: &Panel| arguments.is_empty() || arguments.starts_with(&[p.figure.into(), p.load_name().into()]);
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().map_err(std::io::Error::other)?;
    pool.install(|| {
        panels::panels(POINTS).iter().filter(|p| asked(p)).try_for_each(|p| report(p, arguments.get(2)))
    })
}
