//! How much a page may ask for, and be sent.

use crate::refusal::{InTerminal, RequestRefusal};
use judder_memory::{MemoryBudget, in_words};
use judder_store::Variable;
use judder_study::model::PROGRAM_BYTES;
use serde_json::{Map, Value};

/// Requests of a pace that work at once.
pub(crate) const RUNNING: usize = 3;
/// Answers in one piece that are computed at once.
pub(crate) const SHORT: usize = 8;
/// Laws that are computed at once for such answers.
pub(crate) const LAWS: usize = 1;
/// Among how many streams the memory of the program is divided: three quarters are for those that may work at once, of both paces.
const STREAM_PARTS: u64 = 2 * RUNNING as u64 * 4 / 3;
/// The same of answers in one piece: a quarter is for all of them.
const SHORT_PARTS: u64 = (SHORT + LAWS) as u64 * 4;

/// Grid points of a map, at most.
pub(crate) const MAP_POINTS: u64 = 4_000_000;
/// Points, samples, modes of any other analysis, at most.
const COUNT: u64 = 1_000_000;
/// Bytes of an answer, at most.
const ANSWER_BYTES: usize = 256 << 20;
/// Keys of an analysis that count something.
const COUNTED: [&str; 5] = ["points", "samples", "count", "steps", "cells"];
/// Steps of one motion, at most.
const STEPS: u64 = 50_000_000;
/// Cells along a side of a contact, at most: the memory goes with their square.
const CELLS: u64 = 1024;

/// Does the work of a stream, which may take its part of the memory of the program.
pub(crate) fn with_memory_of_stream<T>(work: impl FnOnce() -> T) -> T {
    MemoryBudget::shared(STREAM_PARTS, work)
}

/// The same of an answer in one piece.
pub(crate) fn with_memory_of_answer<T>(work: impl FnOnce() -> T) -> T {
    MemoryBudget::shared(SHORT_PARTS, work)
}

/// That no analysis has room in its part of the memory, where that is so: each counts the program, as it does alone.
pub(crate) fn too_little_memory() -> Option<String> {
    let part = with_memory_of_stream(MemoryBudget::of_whole_process).most();
    let program = PROGRAM_BYTES as u64;
    (part < program).then(|| {
        let [part, program, all] =
            [part, program, program * (STREAM_PARTS + 1)].map(|bytes| in_words(u128::from(bytes)));
        format!(
            "each of {STREAM_PARTS} analyses that may work at once has {part} of memory, and the least takes {program}: the page will refuse \
             them; --memory \"{all}\" lets them in"
        )
    })
}

/// Whether a page may set a key of an analysis: not how much of this machine it takes.
pub(crate) fn is_settable(key: &str) -> bool {
    key != "memory_limit"
}

/// Refuses an analysis that is larger than a page needs, before memory is laid out for it.
///
/// # Errors
/// What is too large, and what would not be.
pub(crate) fn check_analysis(analysis: &Map<String, Value>) -> Result<(), RequestRefusal> {
    let side = |axis: &str| analysis.get(axis)?.get("points")?.as_u64();
    if let (Some(columns), Some(rows)) = (side("x"), side("y"))
        && columns.checked_mul(rows).is_none_or(|points| points > MAP_POINTS)
    {
        let what = format!("a map of {columns} × {rows} points is more than a page shows");
        let smaller = format!("ask for {MAP_POINTS} points at most");
        return Err(RequestRefusal::beyond_page(what, &smaller, InTerminal::Run));
    }
    if let Some(key) = analysis.keys().find(|key| !is_settable(key)) {
        return Err(RequestRefusal::wrong(format!(
            "`{key}` cannot be set from the page; export the case and set it there"
        )));
    }
    if names_file(analysis) {
        return Err(RequestRefusal::wrong("a page names no file; name it in the case".to_owned()));
    }
    check_counts(analysis)
}

/// Whether a table, or one within it, names a file.
fn names_file(table: &Map<String, Value>) -> bool {
    let of_value = |value: &Value| match value {
        Value::Object(table) => names_file(table),
        Value::Array(items) => items.iter().filter_map(Value::as_object).any(names_file),
        _ => false,
    };
    table.iter().any(|(key, value)| key == "file" || of_value(value))
}

fn check_counts(table: &Map<String, Value>) -> Result<(), RequestRefusal> {
    for (key, value) in table {
        let most = match key.as_str() {
            "steps" => STEPS,
            "cells" => CELLS,
            _ => COUNT,
        };
        match value {
            Value::Number(number)
                if COUNTED.contains(&key.as_str()) && number.as_f64().is_none_or(|n| n > most as f64) =>
            {
                let what = format!("`{key} = {number}` is more than a page asks for");
                return Err(RequestRefusal::beyond_page(
                    what,
                    &format!("give {most} at most"),
                    InTerminal::Run,
                ));
            }
            Value::Object(table) => check_counts(table)?,
            _ => {}
        }
    }
    Ok(())
}

/// Refuses arrays that are too large to send; what gives them whole is typed in a terminal.
///
/// # Errors
/// Their size.
pub(crate) fn check_answer(variables: &[Variable], instead: InTerminal) -> Result<(), RequestRefusal> {
    let bytes = |variable: &Variable| variable.data.value_size() * variable.data.len();
    check_bytes(variables.iter().map(bytes).sum(), instead)
}

/// Refuses an answer of so many bytes where they are too many to send.
///
/// # Errors
/// As [`check_answer`].
pub(crate) fn check_bytes(bytes: usize, instead: InTerminal) -> Result<(), RequestRefusal> {
    if bytes <= ANSWER_BYTES {
        return Ok(());
    }
    let what = format!(
        "the answer has {} MiB, where a page is sent {} MiB at most",
        bytes >> 20,
        ANSWER_BYTES >> 20
    );
    Err(RequestRefusal::beyond_page(what, "ask for less of it", instead))
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    /// What is to be had where this is called.
    fn had() -> f64 {
        MemoryBudget::of_process().ask(u128::MAX).unwrap_err().budget as f64
    }

    #[test]
    fn all_that_work_at_once_have_the_memory_of_one() {
        let whole = had();
        let together = 2.0 * RUNNING as f64 * with_memory_of_stream(had)
            + (SHORT + LAWS) as f64 * with_memory_of_answer(had);
        // what is free changes between two looks
        assert!((0.7..1.4).contains(&(together / whole)), "{together} of {whole}");
    }

    fn check(analysis: Value) -> Result<(), RequestRefusal> {
        check_analysis(analysis.as_object().unwrap())
    }

    #[test]
    fn what_a_page_shows_is_let_through() {
        assert!(check(json!({ "x": { "points": 2000 }, "y": { "points": 2000 } })).is_ok());
        assert!(check(json!({ "kind": "motion", "points": 20001, "steps": 1_000_000 })).is_ok());
    }

    #[test]
    fn who_is_refused_for_size_is_told_what_to_type() {
        let refused = [
            check(json!({ "x": { "points": 31623 }, "y": { "points": 31623 } })),
            check(json!({ "points": 1_000_000_000 })),
            check_bytes(ANSWER_BYTES + 1, InTerminal::Run),
        ];
        for refusal in refused {
            let document = refusal.unwrap_err().document();
            let help = document["help"].as_str().unwrap();
            assert!(help.contains(" or export the case and type `judder run CASE.toml`"), "{document}");
        }
        let of_study = check_bytes(ANSWER_BYTES + 1, InTerminal::Report).unwrap_err().document();
        assert!(of_study["help"].as_str().unwrap().contains("`judder report FOLDER`"), "{of_study}");
    }

    #[test]
    fn what_would_take_all_memory_is_not() {
        for analysis in [
            json!({ "x": { "points": 31623 }, "y": { "points": 31623 } }),
            json!({ "x": { "points": u64::MAX }, "y": { "points": 2 } }),
            json!({ "x": { "points": 1e9 }, "y": { "points": 1 } }),
            json!({ "points": 1_000_000_000 }),
            json!({ "points": 1e300 }),
            json!({ "sweep": { "points": 10_000_000 } }),
            json!({ "steps": 1_000_000_000_000_u64 }),
            json!({ "memory_limit": "100 GB" }),
            json!({ "kind": "contact", "cells": 4096 }),
        ] {
            assert!(check(analysis.clone()).is_err(), "{analysis}");
        }
    }
}
