//! What the modes of a solid cost: the Rust side of `benches/compare_modes.py`.
//!
//! `modes KIND X Y Z COUNT [FOLDER]`: one line of JSON for the lowest modes of a box of so many cells, `hex8` or `hex20`, held at one
//! side, and the peak of the memory of the process in bytes where the system tells it. With a folder the matrices are written there, as
//! `NAME-starts.i64`, `NAME-rows.i64`, `NAME-values.f64` of their columns. Without arguments: a small box.

use judder_structure::assembly::{Assembled, Sparse, assemble};
use judder_structure::element::ElementKind;
use judder_structure::factor::{FactorPattern, SymmetricFactor};
use judder_structure::freedom::{Direction, Numbering, Supports};
use judder_structure::grid::Grid;
use judder_structure::material::{Elastic, ElementSection};
use judder_structure::modes::{Mode, WantedModes, modes};
use std::error::Error;
use std::path::Path;
use std::time::Instant;

fn main() -> Result<(), Box<dyn Error>> {
    // Cargo adds `--bench`.
    let arguments: Vec<String> = std::env::args().skip(1).filter(|argument| argument != "--bench").collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    match arguments.as_slice() {
        [kind, x, y, z, count, folder @ ..] => {
            let kind = if *kind == "hex20" { ElementKind::Hexahedron20 } else { ElementKind::Hexahedron8 };
            let cells = [x.parse()?, y.parse()?, z.parse()?];
            time(kind, cells, count.parse()?, folder.first().map(Path::new))
        }
        _ => time(ElementKind::Hexahedron8, [12, 12, 12], 20, None),
    }
}

fn time(
    kind: ElementKind,
    cells: [usize; 3],
    count: usize,
    folder: Option<&Path>,
) -> Result<(), Box<dyn Error>> {
    let clock = Instant::now();
    let solid = solid(kind, cells)?;
    let assembly = clock.elapsed().as_secs_f64();
    if let Some(folder) = folder {
        write(folder, "stiffness", &solid.stiffness)?;
        write(folder, "mass", &solid.mass)?;
    }
    let (clock, processors) = (Instant::now(), processor_seconds());
    let found = modes(&solid.stiffness, &solid.mass, WantedModes::Lowest(count))?;
    let seconds = clock.elapsed().as_secs_f64();
    let processors = processor_seconds() - processors;
    let peak = peak();
    let clock = Instant::now();
    let pattern = FactorPattern::new(&solid.stiffness)?;
    let ordering = clock.elapsed().as_secs_f64();
    let clock = Instant::now();
    let factor = SymmetricFactor::with_pattern(&pattern, &solid.stiffness)?;
    let factorisation = clock.elapsed().as_secs_f64();
    let clock = Instant::now();
    let mut right = vec![1.0; solid.mass.nrows()];
    factor.solve(&mut right);
    let solve = clock.elapsed().as_secs_f64();
    let frequencies: Vec<f64> = found.modes.iter().map(Mode::frequency_hz).collect();
    let residual = found.modes.iter().map(|mode| mode.residual).fold(0.0, f64::max);
    println!(
        r#"{{"freedoms": {}, "assembly_seconds": {assembly}, "seconds": {seconds}, "processor_seconds": {processors}, "peak_bytes": {peak}, "ordering_seconds": {ordering}, "factorisation_seconds": {factorisation}, "solve_seconds": {solve}, "factor_entries": {}, "operations": {}, "residual": {residual:e}, "frequencies": {frequencies:?}}}"#,
        solid.mass.nrows(),
        pattern.entries(),
        pattern.operations(),
    );
    Ok(())
}

/// A box of steel with cells of 1 cm, held at one side.
fn solid(kind: ElementKind, cells: [usize; 3]) -> Result<Assembled, Box<dyn Error>> {
    let mesh = Grid { kind, size: cells.map(|cells| 0.01 * cells as f64), cells }.mesh("steel", |p| p)?;
    let fixed = mesh.node_sets["x-min"].iter().flat_map(|node| Direction::ALL.map(|d| (*node, d))).collect();
    let numbering = Numbering::new(&mesh, 3, &Supports { fixed, ..Supports::default() })?;
    let steel = (Elastic::new(2.1e11, 0.3, 7800.0)?, ElementSection::Solid);
    Ok(assemble(&mesh, &[("steel".to_owned(), steel)].into(), &numbering)?)
}

fn write(folder: &Path, name: &str, matrix: &Sparse) -> Result<(), Box<dyn Error>> {
    let numbers =
        |numbers: &[usize]| numbers.iter().flat_map(|n| (*n as u64).to_le_bytes()).collect::<Vec<_>>();
    std::fs::write(folder.join(format!("{name}-starts.i64")), numbers(matrix.col_ptr()))?;
    std::fs::write(folder.join(format!("{name}-rows.i64")), numbers(matrix.row_idx()))?;
    let values: Vec<u8> = matrix.val().iter().flat_map(|value| value.to_le_bytes()).collect();
    Ok(std::fs::write(folder.join(format!("{name}-values.f64")), values)?)
}

/// Of all threads so far, in hundredths as Linux counts them; zero where the system does not tell.
fn processor_seconds() -> f64 {
    let status = std::fs::read_to_string("/proc/self/stat").unwrap_or_default();
    // in user and in system mode: the 14th and 15th field, the second in brackets
    let after = status.rsplit(')').next().unwrap_or_default().split_whitespace().skip(11).take(2);
    after.filter_map(|ticks| ticks.parse::<f64>().ok()).sum::<f64>() / 100.0
}

/// VmHWM; zero where the system does not tell.
fn peak() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    line.and_then(|line| line.split_whitespace().next()?.parse::<u64>().ok())
        .map_or(0, |kibibytes| 1024 * kibibytes)
}
