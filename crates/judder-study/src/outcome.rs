//! What an analysis leaves.

use judder_store::{Dataset, Results, StoreError, Table};
use serde::{Deserialize, Deserializer, Serialize};
use serde_json::{Map, Value};

/// Scalars, arrays, a table, checks and warnings of one analysis.
#[derive(Debug, Clone, Default)]
pub struct Outcome {
    /// What `summary.json` shows of it.
    pub scalars: Map<String, Value>,
    /// Every array, with coordinates and units.
    pub dataset: Dataset,
    /// Whether the arrays are in the study folder already: they grew there while the analysis ran.
    pub is_stored: bool,
    /// What a spreadsheet wants, where the result is a table.
    pub table: Option<Table>,
    /// The comparisons that were made.
    pub checks: Vec<CheckRecord>,
    /// Files beside arrays and table, each with its path in the study folder: fields, laws.
    pub files: Vec<(String, Vec<u8>)>,
    /// What the user has to know before trusting the numbers.
    pub warnings: Vec<String>,
    /// Requested results that are missing (unresolved points, failed searches); any makes the run exit with 1.
    pub missing: usize,
}

impl Outcome {
    /// What these results are: scalars, arrays and table.
    ///
    /// # Errors
    /// Arrays or columns that cannot be stored together.
    pub fn of(results: &impl Results) -> Result<Self, StoreError> {
        let dataset = results.add_arrays(Dataset::new())?;
        let table = results.add_columns(Table::new())?;
        let table = (table != Table::new()).then_some(table);
        Ok(Self { scalars: results.scalars(), dataset, table, ..Self::default() })
    }

    /// Adds to the scalars of each curve what its part of the results makes: with a family there is an object a curve.
    pub fn add_to_curves<'a, T: 'a>(
        &mut self,
        parts: impl Iterator<Item = &'a [T]>,
        add: impl Fn(&mut Map<String, Value>, &[T]),
    ) {
        match self.scalars.get_mut("curves").and_then(Value::as_array_mut) {
            Some(curves) => {
                let objects = curves.iter_mut().filter_map(Value::as_object_mut);
                objects.zip(parts).for_each(|(scalars, part)| add(scalars, part));
            }
            None => parts.for_each(|part| add(&mut self.scalars, part)),
        }
    }
}

/// A number doubted by another number.
///
/// How many were compared follows from what was compared: nobody can state it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct CheckRecord {
    /// What is checked.
    pub name: String,
    /// What was compared with what, and how often.
    pub compared: String,
    /// The largest disagreement; infinite where one side was missing.
    #[serde(deserialize_with = "number_or_infinite")]
    pub figure: f64,
    /// What it may be at most.
    pub limit: f64,
    /// How many numbers were compared; `None` of a study that was stored before they were counted.
    #[serde(default)]
    numbers: Option<usize>,
}

/// How far some numbers are from what they are compared with.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Disagreement {
    figure: f64,
    numbers: usize,
}

impl CheckRecord {
    /// What is checked, what was compared with what, how far it was off and what that may be at most.
    pub fn new(
        name: impl Into<String>,
        compared: impl Into<String>,
        found: Disagreement,
        limit: f64,
    ) -> Self {
        let Disagreement { figure, numbers } = found;
        Self { name: name.into(), compared: compared.into(), figure, limit, numbers: Some(numbers) }
    }

    /// Whether numbers were compared, and the disagreement is within its limit.
    #[must_use]
    pub fn passed(&self) -> bool {
        !self.compared_nothing() && self.figure <= self.limit
    }

    /// Whether there was nothing to compare.
    #[must_use]
    pub fn compared_nothing(&self) -> bool {
        self.numbers == Some(0)
    }

    /// How many numbers were compared; `None` of a study that was stored before they were counted.
    #[must_use]
    pub fn numbers(&self) -> Option<usize> {
        self.numbers
    }

    /// Why it has not passed, in words; `None` where it has.
    #[must_use]
    pub fn failure(&self) -> Option<String> {
        let Self { name, figure, limit, .. } = self;
        match (self.passed(), self.compared_nothing()) {
            (true, _) => None,
            (false, true) => Some(format!("check compared nothing: {name}")),
            (false, false) => Some(format!("check failed: {name}: {figure:.1e}, at most {limit:.0e}")),
        }
    }
}

impl Disagreement {
    /// Takes one more number into account; a disagreement that is no number is infinite, one below zero is none.
    pub fn add(&mut self, disagreement: f64) {
        self.figure = if disagreement.is_nan() { f64::INFINITY } else { self.figure.max(disagreement) };
        self.numbers += 1;
    }

    /// How many numbers were compared.
    pub fn numbers(&self) -> usize {
        self.numbers
    }

    /// The number of exceptions.
    pub fn exceptions(is_wrong: impl IntoIterator<Item = bool>) -> Self {
        let of = |so_far: Self, wrong: bool| Self {
            figure: so_far.figure + f64::from(u8::from(wrong)),
            numbers: so_far.numbers + 1,
        };
        is_wrong.into_iter().fold(Self::default(), of)
    }

    /// The share of exceptions.
    pub fn share(is_wrong: impl IntoIterator<Item = bool>) -> Self {
        let Self { figure, numbers } = Self::exceptions(is_wrong);
        Self { figure: figure / numbers.max(1) as f64, numbers }
    }
}

/// The largest of some disagreements, each that of one number.
impl FromIterator<f64> for Disagreement {
    fn from_iter<I: IntoIterator<Item = f64>>(disagreements: I) -> Self {
        let mut found = Self::default();
        disagreements.into_iter().for_each(|disagreement| found.add(disagreement));
        found
    }
}

/// That of one number.
impl From<f64> for Disagreement {
    fn from(disagreement: f64) -> Self {
        [disagreement].into_iter().collect()
    }
}

/// JSON has no infinity and writes `null` for it.
fn number_or_infinite<'de, D: Deserializer<'de>>(deserializer: D) -> Result<f64, D::Error> {
    Ok(Option::deserialize(deserializer)?.unwrap_or(f64::INFINITY))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_check_without_a_number_stays_a_failed_check() {
        let check = CheckRecord::new("", "", f64::NAN.into(), 1.0);
        assert_eq!(check.figure, f64::INFINITY);
        let text = serde_json::to_string(&check).unwrap();
        let kept: CheckRecord = serde_json::from_str(&text).unwrap();
        assert!(kept == check && !kept.passed());
    }

    /// The largest of none is zero, which is within every limit.
    #[test]
    fn a_check_that_compared_nothing_has_not_passed() {
        let nothing: [Disagreement; 3] = [
            std::iter::empty::<f64>().collect(),
            Disagreement::exceptions(std::iter::empty()),
            Disagreement::share(std::iter::empty()),
        ];
        for found in nothing {
            let check = CheckRecord::new("rows agree", "", found, 1.0);
            assert!(check.compared_nothing() && !check.passed());
            assert_eq!(check.failure().as_deref(), Some("check compared nothing: rows agree"));
        }
    }

    #[test]
    fn numbers_are_counted_and_none_is_dropped() {
        let largest: Disagreement = [0.5, -3.0, f64::NAN, 0.25].into_iter().collect();
        assert_eq!((largest.figure, largest.numbers), (f64::INFINITY, 4));
        let exceptions = [true, false, false, true];
        assert_eq!(Disagreement::exceptions(exceptions), Disagreement { figure: 2.0, numbers: 4 });
        assert_eq!(Disagreement::share(exceptions), Disagreement { figure: 0.5, numbers: 4 });
    }

    /// How many numbers a study compared that was stored before they were counted is not known.
    #[test]
    fn a_check_stored_without_its_count_is_still_read() {
        let kept: CheckRecord =
            serde_json::from_str(r#"{"name": "a", "compared": "b", "figure": 0.5, "limit": 1.0}"#).unwrap();
        assert!(kept.passed() && kept.numbers().is_none());
    }
}
