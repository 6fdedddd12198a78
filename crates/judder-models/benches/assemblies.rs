//! The pad on the strip of `judder-assembly/benches/sliding_pad.rs` as a case, as a line of JSON: one Rust side of
//! `benches/compare_assemblies.py`.
//!
//! `sweep`: the `eigen` of the case, then its `eigen-sweep` of a hundred friction coefficients.

use judder_study::outcome::Outcome;
use judder_study::{Silent, analyses};
use serde_json::json;
use std::error::Error;
use std::time::Instant;

fn main() -> Result<(), Box<dyn Error>> {
    // Cargo adds `--bench`, and calls it with that alone.
    if !std::env::args().any(|argument| argument == "sweep") {
        eprintln!("SKIPPED: benches/compare_assemblies.py runs this with what it wants: sweep");
        return Ok(());
    }
    let file = judder_models::parse("assemblies.toml", include_str!("assemblies.toml"), &[])?;
    let run = |analysis: usize| -> Result<(f64, Outcome), Box<dyn Error>> {
        let start = Instant::now();
        let outcome = analyses::run(&file, analysis, &Silent)?;
        Ok((start.elapsed().as_secs_f64(), outcome))
    };
    let ((first, _), (again, one)) = (run(0)?, run(0)?);
    let (seconds, sweep) = run(1)?;
    let told = json!({
        "one_seconds": first.min(again), "one_missing": one.missing, "one": one.scalars,
        "sweep_seconds": seconds, "sweep_missing": sweep.missing, "sweep": sweep.scalars, "warnings": sweep.warnings,
    });
    println!("{told}");
    Ok(())
}
