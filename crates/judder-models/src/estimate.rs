//! What analyses would take, as `judder check` tells.

use judder_study::model::NeededMemory;
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
    /// Steps of motions that branches through a diagram are followed by: seconds to a minute.
    pub(crate) const BRANCH_STEPS: f64 = 4e6;
    /// Following the three boundaries of a map.
    pub(crate) const BOUNDARIES: f64 = 0.3;
    /// A step of a motion: of the oscillator, of a mass on a belt. Measured of 20 000 to 5 000 000 steps.
    pub(crate) const MOTION_STEP: f64 = 1.3e-6;
    pub(crate) const STEP_ON_BELT: f64 = 6e-7;
    /// A point of a motion that is kept: arrays, table, figures. Measured of 4096 and 1 000 000.
    pub(crate) const MOTION_POINT: f64 = 2.8e-6;
    /// The figures and the report of a motion.
    pub(crate) const MOTION_FIGURES: f64 = 0.35;
    /// Steps of a motion over a radian, where nothing is known of it.
    pub(crate) const STEPS_OF_RADIAN: f64 = 25.0;
    /// A step of the time-stepping.
    pub(crate) const TIME_STEP: f64 = 2.5e-6;
    /// One figure as SVG and PNG.
    pub(crate) const FIGURE: f64 = 0.2;
}

/// Bytes a point: arrays, tables, figure and report together, measured of the installed package.
pub(crate) mod point_bytes {
    /// Of eigenvalues and their derived quantities: of 20 000 to 500 000 points.
    pub(crate) const EIGENVALUES: u128 = 5500;
    /// Of equivalent damping: of 400 000 points.
    pub(crate) const DAMPING: u128 = 860;
    /// Of thresholds: of 20 000 points.
    pub(crate) const THRESHOLDS: u128 = 3500;
    /// Of the search for them along a parameter: of 100 000 points.
    pub(crate) const SEARCHED: u128 = 16;
    /// Of a motion that is kept: of 64 to 4 194 304 points.
    pub(crate) const MOTION: u128 = 352;
    /// The same of one that has seconds: of 400 000 and 1 000 000 points.
    pub(crate) const MOTION_IN_SI: u128 = 556;
    /// Of a sample of the sound of a motion.
    pub(crate) const HEARD: u128 = 37;
    /// Of a change of the contact state in a motion, with its part of an oscillation: 150 of 58 000, 220 of 289 000 on a belt.
    pub(crate) const CHANGE: u128 = 200;
    /// Of a map whose regions are decided by their borders: of 4 000 000 points.
    pub(crate) const MAP: u128 = 5;
    /// Of one with the growth rate of every point: 39 of 360 000, 30 of 4 000 000.
    pub(crate) const GROWTH_MAP: u128 = 32;
}

/// What so many points need, each so many bytes.
pub(crate) fn memory_of_points(points: u128, each: u128, keys: &'static [&'static str]) -> NeededMemory {
    NeededMemory {
        beside: points.saturating_mul(each),
        what: format!("{points} points").into(),
        keys,
        advice: "take fewer points",
        ..NeededMemory::LITTLE
    }
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
}

impl Estimate {
    /// Of an analysis of so many points in so many seconds, without its figure.
    pub(crate) fn of_points(name: &str, points: usize, seconds: f64) -> Self {
        let seconds = seconds + cost::FIGURE;
        Self { name: name.to_owned(), points, seconds, seconds_at_most: None }
    }
}

/// What analyses that are told in words would take, a line each.
pub(crate) fn words_text(names: &[&str], estimates: &[(String, NeededMemory)]) -> String {
    let row = |(name, (asked, memory)): (&&str, &(String, NeededMemory))| {
        vec![(*name).to_owned(), format!("{asked}, {} of memory", memory.words())]
    };
    columns(&names.iter().zip(estimates).map(row).collect::<Vec<_>>())
}

/// The same in a document.
pub(crate) fn words_json(names: &[&str], estimates: &[(String, NeededMemory)]) -> Value {
    let entry = |(name, (asked, memory)): (&&str, &(String, NeededMemory))| {
        with_memory(json!({ "name": name, "asked": asked }), memory)
    };
    names.iter().zip(estimates).map(entry).collect()
}

/// An entry of a document with the memory that an analysis needs.
pub(crate) fn with_memory(mut entry: Value, memory: &NeededMemory) -> Value {
    entry["bytes"] = json!(u64::try_from(memory.bytes()).unwrap_or(u64::MAX));
    entry["bytes_are"] = json!(memory.bound.name());
    entry
}

/// The first line of what is shown of a case.
pub(crate) fn title(title: &str) -> &str {
    if title.is_empty() { "An untitled case" } else { title }
}

pub(crate) fn estimate_json(estimates: &[(Estimate, NeededMemory)]) -> Value {
    let entry = |(e, memory): &(Estimate, NeededMemory)| {
        let mut json = json!({ "name": e.name, "points": e.points, "seconds": e.seconds });
        if let Some(most) = e.seconds_at_most {
            json["seconds_at_most"] = json!(most);
        }
        with_memory(json, memory)
    };
    estimates.iter().map(entry).collect()
}

pub(crate) fn estimate_text(estimates: &[(Estimate, NeededMemory)]) -> String {
    if estimates.is_empty() {
        return "\nno analyses\n".to_owned();
    }
    let row = |(e, memory): &(Estimate, NeededMemory)| {
        let most = e.seconds_at_most.map(|most| format!(", at most {most:.0} s")).unwrap_or_default();
        let time = format!("about {:.1} s{most}", e.seconds);
        vec![e.name.clone(), format!("{} points", e.points), time, memory.words()]
    };
    let rows: Vec<Vec<String>> = estimates.iter().map(row).collect();
    format!("\nanalyses: size, time on one core, memory\n{}", columns(&rows))
}
