//! What a sweep keeps of every point: quantities of the operating point, or scalars of the results of an analysis.

use std::fmt;

use super::problem::SweepProblem;
use crate::model::OperatingQuantity;
use judder_keys::document::STEPS_LIMIT;

/// What results call the time that a clock on the wall has shown.
const WALL_TIME: &str = "seconds";

/// The path of a quantity: `growth_rate`, `cycle.rms`, `thresholds.full.0.min`.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct QuantityPath {
    /// As the case file has it: unique in its sweep.
    pub text: String,
    /// Where the quantity comes from.
    pub source: QuantitySource,
}

/// Where a quantity comes from.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub enum QuantitySource {
    /// The operating point: a name without a dot.
    Point {
        /// The quantity of this name.
        quantity: OperatingQuantity,
    },
    /// The results of an analysis.
    Analysis {
        /// The position of the analysis in its case.
        index: usize,
        /// Its name.
        name: String,
        /// The way from its results to a number; never empty.
        steps: Vec<QuantityStep>,
        /// Unit symbol of the number, as its result declares it.
        unit: String,
    },
}

/// A step from results to a number.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub enum QuantityStep {
    /// Into an object, or into every object of a list; at the end of a path, one of [`ListReduction::ALL`] reduces a list.
    Name(String),
    /// To an item of a list, counted from 0.
    Item(usize),
}

/// What makes one number of a list.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum ListReduction {
    /// The smallest.
    Min,
    /// The largest.
    Max,
    /// The first.
    First,
    /// The last.
    Last,
    /// How many there are.
    Count,
}

impl ListReduction {
    /// The reductions with their names in a path.
    pub const ALL: [(&'static str, Self); 5] = [
        ("min", Self::Min),
        ("max", Self::Max),
        ("first", Self::First),
        ("last", Self::Last),
        ("count", Self::Count),
    ];

    /// The reduction of this name.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.iter().find(|(known, _)| *known == name).map(|(_, reduction)| *reduction)
    }
}

impl fmt::Display for QuantityPath {
    /// As the case file has it.
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.text)
    }
}

impl QuantityPath {
    /// Reads a path in a case with these analyses, whose operating point has these quantities.
    pub(super) fn parse(
        path: &str,
        analyses: &[&str],
        quantities: &[OperatingQuantity],
    ) -> Result<Self, SweepProblem> {
        let malformed = |reason| SweepProblem::QuantityPath { path: path.to_owned(), reason };
        let steps: Vec<&str> = path.split('.').collect();
        if steps.contains(&"") {
            return Err(malformed(if path.is_empty() { "it is empty" } else { "a step of it is empty" }));
        }
        if steps.len() > STEPS_LIMIT {
            return Err(malformed("it has more steps than results are deep"));
        }
        let plain = |byte: u8| byte.is_ascii_alphanumeric() || matches!(byte, b'_' | b'-' | b'.');
        if !path.bytes().all(plain) {
            return Err(malformed("its steps are names of A-Z a-z 0-9 _ - and numbers"));
        }
        let text = path.to_owned();
        if steps.len() == 1 {
            if analyses.contains(&path) {
                return Err(malformed("it names a whole analysis"));
            }
            let known = || quantities.iter().map(|own| own.name.to_owned()).collect();
            let found = quantities.iter().find(|own| own.name == path);
            let quantity =
                *found.ok_or_else(|| SweepProblem::UnknownQuantity { name: text.clone(), known: known() })?;
            return Ok(Self { source: QuantitySource::Point { quantity }, text });
        }
        if steps.contains(&WALL_TIME) {
            return Err(malformed("it is a wall time, which no two runs share"));
        }
        // a name of an analysis may have dots itself: the longest that fits
        let rest_of = |name: &str| path.strip_prefix(name).and_then(|rest| rest.strip_prefix('.'));
        let found = analyses.iter().enumerate().filter_map(|(k, name)| Some((k, *name, rest_of(name)?)));
        let Some((index, name, rest)) = found.max_by_key(|(_, name, _)| name.len()) else {
            let known = analyses.iter().map(|name| (*name).to_owned()).collect();
            return Err(SweepProblem::UnknownAnalysis { name: steps[0].to_owned(), path: text, known });
        };
        let step = |step: &str| match step.parse() {
            Ok(item) => QuantityStep::Item(item),
            Err(_) => QuantityStep::Name(step.to_owned()),
        };
        let steps = rest.split('.').map(step).collect();
        let (name, unit) = (name.to_owned(), String::new());
        Ok(Self { text, source: QuantitySource::Analysis { index, name, steps, unit } })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_lead_into_the_analysis_with_the_longest_name() {
        let analyses = ["cycle", "cycle.fine", "other"];
        let quantity = OperatingQuantity {
            name: "growth_rate",
            units: "1",
            long_name: "",
            label: None,
            flags: &[],
            is_sought: false,
        };
        let source = |path: &str| QuantityPath::parse(path, &analyses, &[quantity]).map(|path| path.source);
        let name = |text: &str| QuantityStep::Name(text.to_owned());
        let expected = |index: usize, steps: &[QuantityStep]| {
            let (name, steps, unit) = (analyses[index].to_owned(), steps.to_vec(), String::new());
            Ok(QuantitySource::Analysis { index, name, steps, unit })
        };
        assert_eq!(source("cycle.rms"), expected(0, &[name("rms")]));
        assert_eq!(source("cycle.fine.rms"), expected(1, &[name("rms")]));
        assert_eq!(
            source("other.full.3.min"),
            expected(2, &[name("full"), QuantityStep::Item(3), name("min")])
        );
        assert_eq!(source("growth_rate"), Ok(QuantitySource::Point { quantity }));
        assert!(["rms", "other", "a.b", "cycle.seconds"].into_iter().all(|path| source(path).is_err()));
        assert!(ListReduction::ALL.iter().all(|(name, kind)| ListReduction::from_name(name) == Some(*kind)));
    }
}
