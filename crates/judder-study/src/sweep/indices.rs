//! Which swept key decides what: Sobol' indices of every quantity.

use super::plan::SweepPlan;
use judder_numerics::sensitivity::{Bootstrap, Index, sobol_indices};
use serde_json::{Map, Value, json};

/// First-order and total indices of one quantity for the summary, from its values at all points; or why there are none.
///
/// # Errors
/// The reason in words.
pub(super) fn indices(plan: &SweepPlan, values: &[f64]) -> Result<Value, String> {
    let sweep = plan.sweep();
    let Some(asked) = sweep.sensitivity else { return Ok(Value::Null) };
    let seed = sweep.method.seed().unwrap_or_default();
    let bootstrap = Bootstrap { confidence: asked.confidence, resamples: asked.resamples, seed };
    let found = sobol_indices(values, sweep.axes.len(), &bootstrap).map_err(|error| error.to_string())?;
    let by_key = |indices: &[Index]| -> Map<String, Value> {
        let told =
            indices.iter().map(|own| json!({ "value": own.value, "from": own.lower, "to": own.upper }));
        sweep.axes.iter().map(|axis| axis.path.clone()).zip(told).collect()
    };
    Ok(json!({
        "rows": found.rows, "left_out": found.left_out, "mean": found.mean, "variance": found.variance,
        "confidence": asked.confidence, "first": by_key(&found.first), "total": by_key(&found.total),
    }))
}
