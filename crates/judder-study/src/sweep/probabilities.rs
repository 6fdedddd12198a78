//! How probable conditions on the quantities of a sweep are.

use super::plan::{StoredColumn, SweepPlan};
use crate::case::study_sweep::condition::{ConditionBound, SweptCondition};
use judder_numerics::share::wilson;
use serde_json::{Value, json};

/// How often a condition holds.
#[derive(Debug, Clone)]
pub(super) struct ConditionCount {
    condition: SweptCondition,
    /// The column of its quantity.
    column: usize,
    /// The analysis of its quantity as reasons begin with it.
    analysis: Option<String>,
    holds: usize,
    known: usize,
    unknown: usize,
    /// 1 where it holds, 0 where it does not, not a number where that is not known, at all points; where sensitivity needs them.
    indicator: Option<Vec<f64>>,
}

impl ConditionCount {
    /// None counted yet, of each condition.
    pub(super) fn all(plan: &SweepPlan) -> Vec<Self> {
        let (sweep, columns) = (plan.sweep(), plan.layout().quantities().len());
        let indicator = sweep.sensitivity.map(|_| Vec::new());
        let new = |condition: &SweptCondition| {
            let column = columns - sweep.quantities.len() + condition.quantity;
            let analysis = match &plan.columns[column] {
                StoredColumn::Scalar { name, .. } => Some(format!("{name}: ")),
                _ => None,
            };
            let indicator = indicator.clone();
            Self { condition: condition.clone(), column, analysis, holds: 0, known: 0, unknown: 0, indicator }
        };
        sweep.conditions.iter().map(new).collect()
    }

    /// Takes a point in: its place in its row of points, its values, why something of it is missing. What is missing may add to a count or be louder: of such a point it is known
    /// alone that a bound from below holds.
    pub(super) fn take(&mut self, (member, row): (u64, u64), values: &[f64], failure: Option<&str>) {
        let value = values[self.column];
        let holds = self.condition.holds(value);
        let has_failed = failure.is_some_and(|reason| {
            value.is_nan() || self.analysis.as_ref().is_some_and(|name| reason.contains(name))
        });
        let is_known =
            !has_failed || (holds && matches!(self.condition.bound, ConditionBound::Within(_, None)));
        let holds = is_known && holds;
        if let Some(indicator) = &mut self.indicator {
            indicator.push(if is_known { f64::from(u8::from(holds)) } else { f64::NAN });
        }
        // of a row of sensitivity only the first point and the last are drawn independently
        if member != 0 && member + 1 != row {
            return;
        }
        match is_known {
            true => self.known += 1,
            false => self.unknown += 1,
        }
        self.holds += usize::from(holds);
    }

    /// The condition in words.
    pub(super) fn words(&self, plan: &SweepPlan) -> String {
        self.condition.words(&plan.layout().quantities()[self.column].name)
    }

    /// Whether it holds at each point, where sensitivity needs it.
    pub(super) fn indicator(&self) -> Option<&[f64]> {
        self.indicator.as_deref()
    }

    /// The share of the points at which it holds. Where it is not known of some, the interval reaches from what it would be if it held at none of them to what it would be if it
    /// held at all.
    pub(super) fn told(&self, plan: &SweepPlan) -> Value {
        let all = self.known + self.unknown;
        let [from, to] = [wilson(self.holds, all)[0], wilson(self.holds + self.unknown, all)[1]];
        let (above, below, is) = match &self.condition.bound {
            ConditionBound::Within(above, below) => (*above, *below, None),
            ConditionBound::Class(_, word) => (None, None, Some(word)),
        };
        json!({
            "quantity": plan.layout().quantities()[self.column].name, "above": above, "below": below, "is": is,
            "condition": self.words(plan), "value": self.holds as f64 / self.known as f64, "from": from, "to": to,
            "confidence": 0.95, "holds": self.holds, "count": self.known, "unknown": self.unknown,
        })
    }
}
