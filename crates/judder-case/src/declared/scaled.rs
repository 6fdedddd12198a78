//! Numbers that a case gives as a dimensionless group or with a unit, and ranges of them.

use super::{Declaration, Form, Setting, Whole};
use crate::dimension::Dimension;
use crate::document::Node;
use crate::error::Fault;
use crate::keys::{Form as Given, Key, Range, Value};
use crate::reference::allowed;
use crate::section::Section;
use crate::span::{Span, read_ends};
use crate::swept_keys::read_value;
use serde_json::{Value as Json, json};

/// A number that is a dimensionless group, or a quantity of this dimension.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Scaled {
    pub(crate) dimension: Dimension,
    /// What a plain number is.
    pub(crate) group: &'static str,
    pub(crate) range: Range,
}

/// A range of such numbers: the points of one that does not say, and the most.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Ladder {
    pub(crate) of: Scaled,
    pub(crate) usual: usize,
    pub(crate) most: usize,
}

impl Scaled {
    /// Above zero.
    pub(crate) const fn positive(dimension: Dimension, group: &'static str) -> Self {
        Self { dimension, group, range: Range::Positive }
    }

    /// The entry of a table of keys that reads as this number does.
    pub(crate) const fn entry(&self) -> Key<()> {
        Key {
            key: (),
            path: "",
            symbol: "",
            dimension: self.dimension,
            group: Some(self.group),
            difference: false,
            range: self.range,
            default: None,
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

    fn write(&self, number: f64, given: Given) -> Json {
        match given {
            Given::Group => json!(number),
            Given::Si => json!({ "value": number, "unit": self.dimension.unit() }),
        }
    }
}

impl Setting for Value {
    type Rule = Scaled;

    fn form(rule: &Scaled) -> Form {
        Form::Scaled(*rule)
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

    fn form(rule: &Ladder) -> Form {
        let key = |name: &'static str, doc: &'static str, default: Option<Json>, form: Form| Declaration {
            name,
            doc,
            symbol: "",
            alternative: None,
            is_required: default.is_none(),
            default,
            form,
        };
        let points = Form::Whole(Whole { from: 2, to: rule.most });
        let keys = vec![
            key("from", "the lower end", None, Value::form(&rule.of)),
            key("to", "the upper end", None, Value::form(&rule.of)),
            key("points", "how many points, both ends included", Some(json!(rule.usual)), points),
        ];
        Form::Table { doc: "a range, with equal ratios between its points", keys }
    }

    fn read(section: &Section<'_>, key: &str, node: &Node, rule: &Ladder) -> Result<Self, Fault> {
        read_ends(&rule.of.entry(), &section.path(key), node, (rule.usual, rule.most))
    }

    fn write(&self, rule: &Ladder) -> Json {
        let end = |end| rule.of.write(end, self.form);
        json!({ "from": end(self.from), "to": end(self.to), "points": self.points })
    }
}
