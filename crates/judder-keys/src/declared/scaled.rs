//! Numbers that a case gives as a dimensionless group or with a unit, and ranges of them.

use super::{Allowed, Declaration, Setting, Whole};
use crate::dimension::Dimension;
use crate::document::Node;
use crate::error::Fault;
use crate::numeric_key::read_value;
use crate::numeric_key::{Form, Key, Range, Value};
use crate::reference::allowed;
use crate::section::Section;
use crate::span::{Span, read_ends};
use serde_json::{Value as Json, json};

/// A number that is a dimensionless group, or a quantity of this dimension.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scaled {
    /// The dimension of a quantity with a unit.
    pub dimension: Dimension,
    /// What a plain number is.
    pub group: &'static str,
    /// What it may be.
    pub range: Range,
}

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

impl Scaled {
    /// Above zero.
    pub const fn positive(dimension: Dimension, group: &'static str) -> Self {
        Self { dimension, group, range: Range::Positive }
    }

    /// The entry of a table of keys that reads as this number does.
    pub const fn entry(&self) -> Key<()> {
        Key {
            key: (),
            path: "",
            symbol: "",
            dimension: self.dimension,
            group: Some(self.group),
            difference: false,
            range: self.range,
            default: None,
            typical: None,
            doc: "",
        }
    }

    /// What may stand there, as the reference says it.
    pub(super) fn words(&self) -> String {
        let (group, range) = (self.group, allowed(self.range));
        if self.dimension.is_number() {
            return format!("a plain number ({group}), {range}");
        }
        let example = self.dimension.example().replace("\" or \"", " or ");
        format!("a plain number ({group}) or {} such as {example}, {range}", self.dimension)
    }

    fn write(&self, number: f64, given: Form) -> Json {
        match given {
            Form::Group => json!(number),
            Form::Si => json!({ "value": number, "unit": self.dimension.unit() }),
        }
    }
}

impl Setting for Value {
    type Rule = Scaled;

    fn form(rule: &Scaled) -> Allowed {
        Allowed::Scaled(*rule)
    }

    fn read(section: &Section<'_>, key: &str, node: &Node, rule: &Scaled) -> Result<Self, Fault> {
        read_value(&rule.entry(), &section.path(key), node)
    }

    fn write(&self, rule: &Scaled) -> Json {
        rule.write(self.number, self.form)
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
        read_ends(&rule.of.entry(), &section.path(key), node, rule.usual, rule.most)
    }

    fn write(&self, rule: &Ladder) -> Json {
        let end = |end| rule.of.write(end, self.form);
        json!({ "from": end(self.from), "to": end(self.to), "points": self.points })
    }
}
