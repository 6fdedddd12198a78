//! Responses and branches by the balance of harmonics, as lines of JSON: the Rust side of `benches/compare_cycles.py`.
//!
//! - `stop`: two masses and a stop, example 3 of NLvib, from 0.8 to 0.5806 rad/s;
//! - `damper`: a mass with a friction damper, VM320, from 143 to 271 rad/s;
//! - `beam`: a cantilever of 60 elements over 50 stops, nine harmonics, through the folds of its first resonance;
//! - `branch`: 100 limit cycles of a block of 490 freedoms that touches at 50 points, nine harmonics, along the friction coefficient.

mod branch;
#[path = "../../../judder-nonsmooth/tests/common/mod.rs"]
#[allow(dead_code, clippy::unwrap_used)]
mod common;
mod problems;

use judder_cycles::forced::forced_response;
use problems::{Problem, beam, damper, stop};
use serde_json::json;
use std::error::Error;
use std::time::Instant;

/// Runs of which the least time counts.
const REPEATS: usize = 3;

fn response(name: &str, problem: &Problem) -> Result<(), Box<dyn Error>> {
    let mut seconds = f64::INFINITY;
    let mut told = json!(null);
    for _ in 0..REPEATS {
        let start = Instant::now();
        let balance = problem.balance()?;
        let guess = vec![0.0; balance.unknowns()];
        let found = forced_response(&balance, &guess, &problem.settings, &|| true)?;
        seconds = seconds.min(start.elapsed().as_secs_f64());
        let peak = problem.peak(&balance, &found)?;
        told = json!({
            "points": found.motions.len(),
            "end": format!("{:?}", found.end),
            "peak": peak[1],
            "frequency": peak[0],
            "unknowns": balance.unknowns(),
        });
    }
    told["case"] = json!(name);
    told["seconds"] = json!(seconds);
    println!("{told}");
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    let asked: Vec<String> = std::env::args().skip(1).filter(|own| !own.starts_with("--")).collect();
    let is_asked = |name: &str| asked.is_empty() || asked.iter().any(|own| own == name);
    if is_asked("stop") {
        response("stop", &stop()?)?;
    }
    if is_asked("damper") {
        response("damper", &damper()?)?;
    }
    if is_asked("beam") {
        response("beam", &beam()?)?;
    }
    if is_asked("branch") {
        branch::run()?;
    }
    Ok(())
}
