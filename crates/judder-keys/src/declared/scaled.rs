//! Numbers that a case gives as a dimensionless group or with a unit, and ranges of them.

use super::values::{exactly, items};
use super::{Allowed, Declaration, Setting, Whole};
use crate::cause::Cause;
use crate::document::Node;
use crate::error::Fault;
use crate::numeric_key::{Scaled, Value};
use crate::section::Section;
use crate::span::{Span, ascending, read_ends, written_items};
use serde_json::{Value as Json, json};

/// A range of such numbers: the points of one that does not say, and the most.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ladder {
    /// Its ends.
    pub of: Scaled,
    /// The points where none are given.
    pub usual: usize,
    /// The most points.
    pub most: usize,
}

/// Two such numbers in one form, the second larger.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ScaledPair {
    /// What each may be.
    pub of: Scaled,
    /// What they are, in words.
    pub what: &'static str,
}

impl Setting for [Value; 2] {
    type Rule = ScaledPair;

    fn form(rule: &ScaledPair) -> Allowed {
        Allowed::List { of: Box::new(Allowed::Scaled(rule.of)), length: [2, 2] }
    }

    fn read(section: &Section<'_>, key: &str, node: &Node, rule: &ScaledPair) -> Result<Self, Fault> {
        let [from, to]: Self = exactly(section, key, rule.what, node, items(section, key, node, &rule.of)?)?;
        if from.form != to.form {
            let keys = format!("the ends of `{}`", section.path(key));
            return Err(Cause::MixedForms { keys }.at(node.place));
        }
        let numbers = [from.number, to.number];
        ascending(numbers, || written_items(node, numbers), node.place)?;
        Ok([from, to])
    }

    fn write(&self, rule: &ScaledPair) -> Json {
        self.iter().map(|value| rule.of.write(*value)).collect()
    }
}

impl Scaled {
    /// What may stand there, as the reference says it.
    pub(super) fn words(&self) -> String {
        let (example, range) = (self.example().replace("\" or \"", " or "), self.range.signs());
        match (self.group, self.is_difference) {
            (Some(group), _) if self.dimension.is_number() => format!("a plain number ({group}), {range}"),
            (Some(group), _) => {
                format!("a plain number ({group}) or {} such as {example}, {range}", self.dimension)
            }
            (None, true) => format!("a difference of temperatures such as {example}, {range}"),
            (None, false) => format!("{} such as {example}, {range}", self.dimension),
        }
    }
}

impl Setting for Value {
    type Rule = Scaled;

    fn form(rule: &Scaled) -> Allowed {
        Allowed::Scaled(*rule)
    }

    fn read(section: &Section<'_>, key: &str, node: &Node, rule: &Scaled) -> Result<Self, Fault> {
        rule.read(&section.path(key), node)
    }

    fn write(&self, rule: &Scaled) -> Json {
        rule.write(*self)
    }
}

impl Setting for Span {
    type Rule = Ladder;

    fn form(rule: &Ladder) -> Allowed {
        let key = |name: &'static str, doc: &'static str, default: Option<Json>, form: Allowed| Declaration {
            name,
            doc,
            symbol: "",
            alternative: None,
            is_required: default.is_none(),
            default,
            form,
        };
        let points = Allowed::Whole(Whole { from: 2, to: rule.most });
        let keys = vec![
            key("from", "the lower end", None, Value::form(&rule.of)),
            key("to", "the upper end", None, Value::form(&rule.of)),
            key("points", "how many points, both ends included", Some(json!(rule.usual)), points),
        ];
        Allowed::Table { doc: "a range, with equal ratios between its points", keys }
    }

    fn read(section: &Section<'_>, key: &str, node: &Node, rule: &Ladder) -> Result<Self, Fault> {
        read_ends(&rule.of, &section.path(key), node, rule.usual, rule.most)
    }

    fn write(&self, rule: &Ladder) -> Json {
        let end = |number| rule.of.write(Value { number, form: self.form });
        json!({ "from": end(self.from), "to": end(self.to), "points": self.points })
    }
}
