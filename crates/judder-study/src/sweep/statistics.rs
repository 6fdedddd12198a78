//! What the values of a column say together, taken in one after the other.

use judder_store::SweepQuantity;
use serde_json::{Value, json};

/// Extremes, mean and deviation of the numbers of a column, or how often each of its codes stands there.
#[derive(Debug, Clone)]
pub(super) struct ColumnStatistics {
    /// How many values there are.
    count: usize,
    min: f64,
    max: f64,
    mean: f64,
    /// Σ (x − mean)².
    squares: f64,
    /// How often each code stands there; empty for numbers.
    codes: Vec<usize>,
}

impl ColumnStatistics {
    pub(super) fn new(quantity: &SweepQuantity) -> Self {
        let codes = vec![0; quantity.flags.len()];
        Self { count: 0, min: f64::INFINITY, max: f64::NEG_INFINITY, mean: 0.0, squares: 0.0, codes }
    }

    /// Takes a value in; what is not finite is no value. Mean and squares by Welford's recurrence (Technometrics 4 (1962) 419–420).
    pub(super) fn take(&mut self, value: f64) {
        if !value.is_finite() {
            return;
        }
        self.count += 1;
        self.min = self.min.min(value);
        self.max = self.max.max(value);
        let difference = value - self.mean;
        self.mean += difference / self.count as f64;
        self.squares += difference * (value - self.mean);
        if let Some(code) = self.codes.get_mut(value as usize) {
            *code += 1;
        }
    }

    /// For the summary: of a class its shares by meaning, of numbers extremes, mean and deviation.
    pub(super) fn told(&self, quantity: &SweepQuantity) -> Value {
        if !self.codes.is_empty() {
            let meanings = quantity.flags.iter().map(|(_, meaning)| meaning.clone());
            let counts = meanings.zip(self.codes.iter().map(|count| json!(count)));
            return json!({ "count": self.count, "of": counts.collect::<serde_json::Map<_, _>>() });
        }
        let deviation = (self.squares / self.count.saturating_sub(1).max(1) as f64).sqrt();
        let known = |value: f64| if self.count > 0 { json!(value) } else { Value::Null };
        json!({
            "count": self.count, "min": known(self.min), "max": known(self.max), "mean": known(self.mean),
            "standard_deviation": known(deviation), "units": quantity.units,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_extremes_mean_and_deviation() {
        let quantity = SweepQuantity::new("growth_rate", "1", "growth rate");
        let mut statistics = ColumnStatistics::new(&quantity);
        for value in [1e9 + 4.0, 1e9 + 7.0, f64::NAN, 1e9 + 13.0, 1e9 + 16.0] {
            statistics.take(value);
        }
        let told = statistics.told(&quantity);
        assert_eq!((&told["count"], &told["units"]), (&json!(4), &json!("1")));
        assert_eq!(told["mean"], 1e9 + 10.0);
        // NIST's example of a shifted sample: variance 30
        assert_eq!(told["standard_deviation"], 30f64.sqrt());
        assert_eq!((&told["min"], &told["max"]), (&json!(1e9 + 4.0), &json!(1e9 + 16.0)));
    }

    #[test]
    fn a_column_without_values_says_so() {
        let quantity = SweepQuantity::new("growth_rate", "1", "growth rate");
        let told = ColumnStatistics::new(&quantity).told(&quantity);
        assert_eq!((&told["count"], &told["min"]), (&json!(0), &Value::Null));
    }

    #[test]
    fn codes_are_counted() {
        let quantity = SweepQuantity::new("verdict", "", "verdict").flags(&[(0, "stable"), (1, "unstable")]);
        let mut statistics = ColumnStatistics::new(&quantity);
        for value in [0.0, 1.0, 1.0, f64::NAN] {
            statistics.take(value);
        }
        assert_eq!(statistics.told(&quantity), json!({ "count": 3, "of": { "stable": 1, "unstable": 2 } }));
    }
}
