//! What `judder check` shows of sweeps: their keys, points, chunks and columns.

use super::Resolved;
use crate::case::file::CaseFile;
use crate::case::study_sweep::SweptKey;
use crate::error::StudyError;
use crate::run;
use crate::sweep::SweepPlan;
use crate::text::columns;
use serde_json::{Value, json};

/// Adds the sweeps of a case to what is shown of it.
///
/// # Errors
/// What a run would refuse of them.
pub(super) fn added(mut resolved: Resolved, file: &CaseFile) -> Result<Resolved, StudyError> {
    if file.sweeps.is_empty() {
        return Ok(resolved);
    }
    let plans = run::plans(file, &[])?;
    resolved
        .text
        .push_str("\nsweeps: keys and quantities; `judder run --dry-run` estimates time and memory\n");
    let rows: Vec<Vec<String>> = plans.iter().flat_map(rows).collect();
    resolved.text.push_str(&columns(&rows));
    for (plan, advice) in plans.iter().filter_map(|plan| Some((plan, plan.advice()?))) {
        resolved.text.push_str(&format!("{}: {advice}\n", plan.layout().name()));
    }
    resolved.document["sweeps"] = plans.iter().map(document).collect();
    Ok(resolved)
}

fn rows(plan: &SweepPlan) -> Vec<Vec<String>> {
    let (sweep, layout) = (plan.sweep(), plan.layout());
    let (points, chunks) = (counted(sweep.points(), "point"), counted(layout.chunk_count() as u64, "chunk"));
    let mut rows: Vec<Vec<String>> =
        vec![vec![sweep.name.clone(), sweep.method.name().to_owned(), points, format!("in {chunks}")]];
    rows.extend(sweep.axes.iter().map(key_row));
    rows.extend(sweep.quantities.iter().map(|quantity| vec![String::new(), format!("→ {quantity}")]));
    if let Some(asked) = sweep.sensitivity {
        let told = format!("{} %, {} resamples", 100.0 * asked.confidence, asked.resamples);
        rows.push(vec![String::new(), "→ sensitivity".to_owned(), told]);
    }
    rows
}

fn counted(count: u64, what: &str) -> String {
    if count == 1 { format!("1 {what}") } else { format!("{count} {what}s") }
}

fn key_row(axis: &SweptKey) -> Vec<String> {
    let [from, to] = axis.range();
    let mut row = vec![String::new(), axis.path.clone(), format!("{} to {}", axis.text(from), axis.text(to))];
    row.push(axis.count().map_or_else(
        || axis.scale.name().to_owned(),
        |count| format!("{count} values, {}", axis.scale.name()),
    ));
    row
}

fn document(plan: &SweepPlan) -> Value {
    let (sweep, layout) = (plan.sweep(), plan.layout());
    let keys = sweep.axes.iter().map(|axis| {
        let [from, to] = axis.range();
        json!({ "key": axis.path, "from": from, "to": to, "scale": axis.scale.name(), "values": axis.count() })
    });
    let dimensions = layout.dimensions().iter();
    let quantities = layout.quantities().iter().map(|own| own.name.as_str());
    json!({
        "name": sweep.name, "method": sweep.method.name(), "keys": keys.collect::<Vec<_>>(), "points": sweep.points(),
        "chunks": layout.chunk_count(),
        "chunk_shape": dimensions.map(|dimension| dimension.chunk).collect::<Vec<_>>(),
        "columns": quantities.collect::<Vec<_>>(),
        "sensitivity": sweep.sensitivity.map(|own| json!({ "confidence": own.confidence, "resamples": own.resamples })),
    })
}
