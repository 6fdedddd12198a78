//! Times of the elastic contact of rough periodic surfaces on one thread: the Rust side of `benches/compare_rough.py`.
//!
//! `rough [HEIGHTS.npy MEAN_PRESSURE TOLERANCE PRESSURE.f64]`: one line of JSON a surface. The surface is a square of side 1,
//! pressures are in E0*; the pressure is written as little-endian doubles. Without arguments: generated surfaces.

use judder_contact::indenter::{HeightMap, RoughSurface, Roughness};
use judder_contact::kernel::substrate::SlidingSubstrate;
use judder_contact::periodic_contact::level::PeriodicLevel;
use judder_contact::periodic_contact::{PeriodicLoading, PeriodicQuestion, solve};
use judder_contact::unilateral::UnilateralLimits;
use judder_exchange::heights::read_heights;
use std::error::Error;
use std::path::Path;
use std::time::Instant;

fn press(surface: &HeightMap, mean_pressure: f64, tolerance: f64) -> Result<PeriodicLevel, Box<dyn Error>> {
    let question = PeriodicQuestion {
        substrate: &SlidingSubstrate::elastic(),
        surface,
        loading: PeriodicLoading::MeanPressure(mean_pressure),
        accuracy: None,
        limits: UnilateralLimits { tolerance, ..UnilateralLimits::default() },
        memory: u64::MAX,
    };
    let clock = Instant::now();
    let contact = solve(&question)?.finest;
    println!(
        "{{\"seconds\": {:.6}, \"cells\": {}, \"converged\": {}, \"products\": {}, \"sets\": {}, \"worst\": {:e}}}",
        clock.elapsed().as_secs_f64(),
        contact.grid.columns,
        contact.solution.converged,
        contact.solution.products,
        contact.solution.iterations,
        contact.solution.errors.worst()
    );
    Ok(contact)
}

fn main() -> Result<(), Box<dyn Error>> {
    // Cargo adds `--bench`.
    let arguments: Vec<String> = std::env::args().skip(1).filter(|argument| argument != "--bench").collect();
    if let [heights, mean_pressure, tolerance, output] = arguments.as_slice() {
        let table = read_heights(Path::new(heights), std::fs::read(heights)?, None)?;
        let spacing = 1.0 / table.columns as f64;
        let surface = HeightMap::new(table.heights, table.columns, table.rows, spacing, true)?;
        let contact = press(&surface, mean_pressure.parse()?, tolerance.parse()?)?;
        let bytes: Vec<u8> = contact.solution.pressure.iter().flat_map(|value| value.to_le_bytes()).collect();
        std::fs::write(output, bytes)?;
        return Ok(());
    }
    for cells in [256, 512, 1024] {
        let roughness = Roughness::Slope(1.0);
        let cut_off = 8.0 / cells as f64;
        let rough =
            RoughSurface { period: 1.0, cells, hurst: 0.8, roll_off: 0.25, cut_off, roughness, seed: 1 };
        press(&rough.generate()?, 0.05, 1e-6)?;
    }
    Ok(())
}
