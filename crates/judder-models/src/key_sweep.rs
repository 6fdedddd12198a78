//! Sweeps of any number of a case: each value is a case of its own.

use crate::structure::case::problem::StructureProblem;
use judder_keys::cause::Cause;
use judder_keys::declared::{Allowed, Number, Setting, both, read_settings};
use judder_keys::dimension::Dimension;
use judder_keys::document::{Data, Node, PARAMETER, STEPS_LIMIT};
use judder_keys::error::Fault;
use judder_keys::problem::{Placed, Problem};
use judder_keys::quantity::{Quantity, WrittenUnit};
use judder_keys::section::Section;
use judder_numerics::words::plain;
use judder_study::axis::SweptAxis;
use judder_study::case::key_sweep::{AnyNumber, Ends, VariedKey, of_one_dimension, written};
use judder_study::case::scale::{Spacing, spaced};
use judder_study::labels::{SweptQuantity, any_key};
use serde_json::{Value as Json, json};
use std::fmt;
use std::path::{Path, PathBuf};
use thiserror::Error;

/// The sections of a case whose numbers can be swept, with keys as examples.
#[derive(Debug)]
pub struct SweptSections {
    /// Their names.
    pub names: &'static [&'static str],
    /// What they describe, and dotted paths of a few of their numbers.
    pub advice: &'static str,
    /// A key, for who forgets it.
    pub example: &'static str,
}

/// The most points of a sweep: each is a case of its own.
pub const SWEEP_LIMIT: usize = 100_000;

/// Any number of a case with the values that it takes one after the other.
#[derive(Debug, Clone, PartialEq)]
pub struct KeySweep {
    /// Its dotted path, such as `structure.oblique.beam.angle`.
    pub path: String,
    /// The values, two at least, ascending or descending, in SI units.
    pub values: Vec<f64>,
    /// Their dimension.
    pub dimension: Dimension,
    /// How they are spaced, for the axis of figures.
    pub scale: Spacing,
    /// In which unit the case has them, and they are shown.
    pub unit: WrittenUnit,
}

impl KeySweep {
    /// A value with its unit, in a sentence: to six digits.
    pub fn text(&self, value: f64) -> String {
        format!("{} {}", plain(self.unit.value(value)), self.unit.name).trim_end().to_owned()
    }

    /// The name of the unit in which values are shown; `1` of plain numbers.
    pub fn shown_unit(&self) -> String {
        if self.unit.name.is_empty() { "1".to_owned() } else { self.unit.name.clone() }
    }

    /// Its values as an axis of this name.
    pub(crate) fn axis(&self, name: &str) -> SweptAxis {
        let quantity = SweptQuantity { name: name.to_owned(), ..any_key(&self.path, self.dimension) };
        SweptAxis { quantity, values: self.values.clone(), scale: self.scale, shown: Some(self.unit.clone()) }
    }

    /// A value as a case file would have it.
    pub fn data(&self, value: f64) -> Data {
        written(value, self.dimension)
    }
}

/// `{ key, from, to, points, scale }` or `{ key, values }`.
impl Setting for KeySweep {
    type Rule = SweptSections;

    fn form(_: &SweptSections) -> Allowed {
        VariedKey::<SWEEP_LIMIT>::form(&())
    }

    fn read(section: &Section<'_>, key: &str, node: &Node, rule: &SweptSections) -> Result<Self, Fault> {
        let (path, title) = (section.path(key), section.title(key));
        let varied: VariedKey<SWEEP_LIMIT> = read_settings(node, &path, &title)?;
        let table = Section::of_table(node, &path, &title)?;
        let expected = format!("the dotted path of a number of the case, key = \"{}\"", rule.example);
        let node_of_key = table.required("key", &expected)?;
        let mut steps = varied.key.split('.');
        if !steps.next().is_some_and(|first| rule.names.contains(&first)) || steps.count() > STEPS_LIMIT {
            let (key, advice) = (varied.key, rule.advice);
            return Err(KeySweepProblem::NotSwept { key, advice }.at(node_of_key.place));
        }
        match (table.get("values"), &varied.values) {
            (Some(node_of_values), Some(values)) => {
                Section::open(node, "sweep", "`sweep` with `values`", &["key", "values"])?;
                of_list(&varied.key, node_of_values, values)
            }
            _ => of_range(&varied, &table),
        }
    }

    fn write(&self, _: &SweptSections) -> Json {
        let rule = Number::any(self.dimension);
        let values: Json = self.values.iter().map(|value| value.write(&rule)).collect();
        json!({ "key": self.path, "values": values, "scale": self.scale.name() })
    }
}

impl KeySweep {
    /// Tries both ends on a case, which has the sweep at `node`; `at` is the case at a value.
    pub(crate) fn admit<T>(
        &self,
        node: &Node,
        at: impl Fn(f64) -> Result<T, KeySweepProblem>,
    ) -> Result<(), Fault> {
        for value in self.values.first().into_iter().chain(self.values.last()) {
            at(*value).map_err(|problem| {
                let key = node.entry("key").filter(|_| matches!(problem, KeySweepProblem::SweptKey { .. }));
                problem.at(key.unwrap_or(node).place)
            })?;
        }
        Ok(())
    }

    /// Tries a value amid them on a case as well, for what follows the key from one end to the other: keys of whole numbers have none there.
    pub(crate) fn admit_between<T>(
        &self,
        node: &Node,
        at: impl Fn(f64) -> Result<T, KeySweepProblem>,
    ) -> Result<(), Fault> {
        /// Of the range: no simple fraction, which whole numbers might meet.
        const AMID: f64 = 0.381_966_011_250_105;
        let [first, last] = [self.values[0], self.values[self.values.len() - 1]];
        match at(first + AMID * (last - first)) {
            Ok(_) => Ok(()),
            Err(problem) => {
                let problem = KeySweepProblem::SweptKey {
                    key: self.path.clone(),
                    reason: format!("what follows it needs every value between the ends, and {problem}"),
                    advice: "give a key that changes without steps, such as a friction coefficient"
                        .to_owned(),
                };
                Err(problem.at(node.entry("key").unwrap_or(node).place))
            }
        }
    }
}

/// What a case was read from, to read it anew with other values.
pub(crate) struct Origin {
    root: Node,
    /// The same with numbers in the place of expressions, where there are any.
    evaluated: Option<Node>,
    /// What its files are relative to.
    pub(crate) folder: PathBuf,
}

impl fmt::Debug for Origin {
    /// The folder alone: the typed case says what the tree held.
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.debug_struct("Origin").field("folder", &self.folder).finish_non_exhaustive()
    }
}

impl Origin {
    /// A number that the case gives at a dotted path, in SI units, with its dimension.
    pub(crate) fn number(&self, path: &str) -> Option<(f64, Dimension)> {
        let node = self.at_path(path)?;
        match &node.data {
            Data::Number { value, .. } => Some((*value, Dimension::NUMBER)),
            Data::Text(text) => {
                Quantity::parse(text).ok().map(|Quantity { number, dimension }| (number, dimension))
            }
            _ => None,
        }
    }

    /// The unit in which the case gives a number at a dotted path.
    pub(crate) fn unit(&self, path: &str) -> Option<WrittenUnit> {
        let node = self.at_path(path)?;
        self.number(path).map(|(_, dimension)| unit_of(Some(node), dimension))
    }

    /// The dotted paths of all numbers that the case gives, items of lists by their names.
    pub(crate) fn numbers(&self) -> Vec<String> {
        let mut found = Vec::new();
        self.collect(self.evaluated(), "", &mut found);
        found
    }

    fn collect(&self, node: &Node, path: &str, found: &mut Vec<String>) {
        let under = |step: &str| if path.is_empty() { step.to_owned() } else { format!("{path}.{step}") };
        match &node.data {
            Data::Table(table) => {
                table.entries.iter().for_each(|own| self.collect(&own.node, &under(&own.key), found));
            }
            Data::List(items) => {
                for (place, item) in items.iter().enumerate() {
                    let step = match item.entry("name").map(|name| &name.data) {
                        Some(Data::Text(name)) => name.clone(),
                        _ => place.to_string(),
                    };
                    self.collect(item, &under(&step), found);
                }
            }
            _ => {
                if self.number(path).is_some() {
                    found.push(path.to_owned());
                }
            }
        }
    }

    pub(crate) fn new(root: &Node, folder: &Path) -> Self {
        Self { root: root.clone(), evaluated: None, folder: folder.to_owned() }
    }

    /// The same with what its expressions give.
    pub(crate) fn with_evaluated(self, evaluated: Node) -> Self {
        Self { evaluated: Some(evaluated), ..self }
    }

    /// What stands at a dotted path.
    fn at_path(&self, path: &str) -> Option<&Node> {
        path.split('.').try_fold(self.evaluated(), |node, step| node.step(step))
    }

    fn evaluated(&self) -> &Node {
        self.evaluated.as_ref().unwrap_or(&self.root)
    }

    /// The case with swept keys at these values, in SI units, as `read` has it.
    ///
    /// # Errors
    /// [`KeySweepProblem::SweptKey`] where the case has no such key, [`KeySweepProblem::SweptValue`] where there is no such case.
    pub(crate) fn at<T>(
        &self,
        swept: &[(&KeySweep, f64)],
        read: impl Fn(&Node, &Path) -> Result<T, Fault>,
    ) -> Result<T, KeySweepProblem> {
        let mut root = self.root.clone();
        let place = root.place;
        let set = swept.iter().try_for_each(|(sweep, value)| {
            root.vary(&sweep.path, place, Node { place, data: sweep.data(*value) })
        });
        set.and_then(|()| read(&root, &self.folder)).map_err(|fault| {
            let cause = fault.into_cause();
            let word = |(sweep, value): &(&KeySweep, f64)| (sweep.path.clone(), sweep.text(*value));
            let (keys, values): (Vec<String>, Vec<String>) = swept.iter().map(word).unzip();
            let (key, value) = (keys.join("`, `"), values.join(", "));
            let advice = cause.help().unwrap_or_else(|| "sweep values that the key can take".to_owned());
            let reason = cause.to_string();
            match cause {
                Cause::UnknownKey { .. } | Cause::UnknownName { what: PARAMETER, .. } => {
                    KeySweepProblem::SweptKey { key, reason, advice }
                }
                _ => KeySweepProblem::SweptValue { key, value, reason, advice },
            }
        })
    }
}

/// The unit in which a number of this dimension is written.
pub(crate) fn unit_of(node: Option<&Node>, dimension: Dimension) -> WrittenUnit {
    let written = node.and_then(|node| match &node.data {
        Data::Text(text) => WrittenUnit::of(text),
        _ => None,
    });
    written.unwrap_or_else(|| WrittenUnit::si(dimension))
}

fn of_list(path: &str, node: &Node, values: &[AnyNumber]) -> Result<KeySweep, Fault> {
    let (values, _, dimension) = of_one_dimension("sweep.values", node, values, 2)?;
    if !values.is_sorted_by(|a, b| a < b) && !values.is_sorted_by(|a, b| a > b) {
        return Err(StructureProblem::UnsortedValues.at(node.place));
    }
    let first = if let Data::List(nodes) = &node.data { nodes.first() } else { None };
    let unit = unit_of(first, dimension);
    Ok(KeySweep { path: path.to_owned(), values, dimension, scale: Spacing::Linear, unit })
}

fn of_range(varied: &VariedKey<SWEEP_LIMIT>, table: &Section<'_>) -> Result<KeySweep, Fault> {
    let points = varied
        .points
        .ok_or_else(|| table.missing("points", "points = 101, the number of points, both ends included"));
    let (ends, points) = both(varied.ends(table), points)?;
    let points = points as u64;
    let values = (0..points).map(|index| spaced(ends.values, points, ends.scale, index)).collect();
    let Ends { dimension, scale, .. } = ends;
    let unit = unit_of(table.get("from"), dimension);
    Ok(KeySweep { path: varied.key.clone(), values, dimension, scale, unit })
}

/// What can be wrong with a sweep of any number of a case.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum KeySweepProblem {
    /// A swept key of a section whose numbers cannot be swept.
    #[error("`{key}` cannot be swept")]
    NotSwept {
        /// The key as written.
        key: String,
        /// What can be.
        advice: &'static str,
    },
    /// A value of a swept key with which the case cannot be.
    #[error("with `{key}` = {value}: {reason}")]
    SweptValue {
        /// The swept key.
        key: String,
        /// Its value, with the unit.
        value: String,
        /// What is wrong then.
        reason: String,
        /// What would be right.
        advice: String,
    },
    /// Something else than a key of the case that a sweep should vary.
    #[error("`{key}` cannot be swept: {reason}")]
    SweptKey {
        /// The key as written.
        key: String,
        /// What is wrong with it.
        reason: String,
        /// What would be right.
        advice: String,
    },
}

impl Problem for KeySweepProblem {
    fn kind(&self) -> &'static str {
        "Sweep"
    }

    fn label(&self) -> &'static str {
        match self {
            Self::NotSwept { .. } | Self::SweptKey { .. } => "not to be swept",
            Self::SweptValue { .. } => "a value of this sweep",
        }
    }

    fn help(&self) -> Option<String> {
        Some(match self {
            Self::NotSwept { advice, .. } => (*advice).to_owned(),
            Self::SweptValue { advice, .. } | Self::SweptKey { advice, .. } => advice.clone(),
        })
    }
}
