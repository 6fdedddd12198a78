//! What analyses would take, as `judder check` tells.

use crate::sweep::MAP_BYTES_PER_POINT;
use judder_memory::{BeyondMemory, MemoryBudget};
use judder_study::text::columns;
use serde_json::{Value, json};

/// Seconds a point on one core, measured in the release build; good to a factor of a few.
pub(crate) mod cost {
    /// One decision of a map, and one growth rate.
    pub(crate) const DECISION: f64 = 5e-8;
    pub(crate) const EIGENVALUES: f64 = 5e-6;
    /// The search for thresholds at one point.
    pub(crate) const THRESHOLDS: f64 = 2e-4;
    /// Following the cycles beside a threshold back to their fold, and seeking others beyond.
    pub(crate) const MARGIN: f64 = 5.0;
    /// Lines of a map along which they are followed, at most.
    pub(crate) const MARGIN_LINES: usize = 30;
    /// Following the branches of an oscillator through a diagram: seconds to a minute.
    pub(crate) const BRANCHES: f64 = 10.0;
    /// Following the three boundaries of a map.
    pub(crate) const BOUNDARIES: f64 = 0.3;
    /// A motion over a radian of its time: of the oscillator, of a mass on a belt.
    pub(crate) const RADIAN: f64 = 1e-5;
    pub(crate) const RADIAN_ON_BELT: f64 = 2e-7;
    /// A step of the time-stepping.
    pub(crate) const TIME_STEP: f64 = 2.5e-6;
    /// One figure as SVG and PNG.
    pub(crate) const FIGURE: f64 = 0.2;
}

/// Bytes of the program with its figures and its report: what small cases take beyond their arrays in an optimised build. Without optimisation it
/// is about twice as much.
pub(crate) const PROCESS_BYTES: u128 = 36_000_000;

/// Bytes a point of curves: arrays, tables, figure and report together, measured of 100 000 to 400 000 points.
pub(crate) mod curve_bytes {
    /// Of eigenvalues and their derived quantities.
    pub(crate) const EIGENVALUES: u128 = 5500;
    /// Of equivalent damping.
    pub(crate) const DAMPING: u128 = 582;
}

/// Bytes of curves of so many points, each of which takes `each`.
///
/// # Errors
/// There is not so much memory.
pub(crate) fn ask_for_curves(points: usize, each: u128) -> Result<u128, BeyondMemory> {
    let bytes = PROCESS_BYTES + points as u128 * each;
    MemoryBudget::of_process().ask(bytes).map(|()| bytes)
}

/// What an analysis would take.
pub struct Estimate {
    /// The name of the analysis.
    pub name: String,
    /// Points.
    pub points: usize,
    /// Time, s.
    pub seconds: f64,
    /// The most time, s, where it depends on what comes out.
    pub seconds_at_most: Option<f64>,
    /// Memory, bytes.
    pub bytes: u128,
}

impl Estimate {
    /// Of an analysis of so many points in so many seconds, without its figure.
    pub(crate) fn of_points(name: &str, points: usize, seconds: f64) -> Self {
        let (seconds, bytes) = (seconds + cost::FIGURE, PROCESS_BYTES + points as u128 * MAP_BYTES_PER_POINT);
        Self { name: name.to_owned(), points, seconds, seconds_at_most: None, bytes }
    }
}

/// The first line of what is shown of a case.
pub(crate) fn title(title: &str) -> &str {
    if title.is_empty() { "An untitled case" } else { title }
}

pub(crate) fn estimate_json(estimates: &[Estimate]) -> Value {
    estimates
        .iter()
        .map(|e| {
            let mut json =
                json!({ "name": e.name, "points": e.points, "seconds": e.seconds, "bytes": e.bytes as u64 });
            if let Some(most) = e.seconds_at_most {
                json["seconds_at_most"] = json!(most);
            }
            json
        })
        .collect()
}

pub(crate) fn estimate_text(estimates: &[Estimate]) -> String {
    if estimates.is_empty() {
        return "\nno analyses\n".to_owned();
    }
    let rows: Vec<Vec<String>> = estimates
        .iter()
        .map(|e| {
            let memory = format!("{:.1} MB", e.bytes as f64 / 1e6);
            let most = e.seconds_at_most.map(|most| format!(", at most {most:.0} s")).unwrap_or_default();
            let time = format!("about {:.1} s{most}", e.seconds);
            vec![e.name.clone(), format!("{} points", e.points), time, memory]
        })
        .collect();
    format!("\nanalyses: size, time on one core, memory\n{}", columns(&rows))
}
