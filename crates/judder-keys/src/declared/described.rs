//! Declarations as documents: for programs that make controls, signatures or docs of settings.

use super::allowed::as_written;
use super::{Allowed, Declaration, Number, UNLIMITED, Whole};
use crate::dimension::Dimension;
use crate::numeric_key::Range;
use serde_json::{Value as Json, json};

impl Declaration {
    /// The key as a document: its `name`, `doc` and `symbol`; `default`, as a case file says it, and `null` where there is none; whether it is
    /// `required`; its `alternative`, if it has one; `words`, what it may be in one line; and `form`, the same for programs.
    ///
    /// A form has a `kind`:
    ///
    /// | kind | with |
    /// | --- | --- |
    /// | `number` | `group`: what a plain number is, `null` where none may be given; `unit`: the SI unit of a quantity, `null` where none may be given; `range`; `expression`: true where an expression of parameters may stand in its place |
    /// | `whole` | `range` |
    /// | `flag`, `text` | |
    /// | `choice` | `words`: each with its `word` and `doc` |
    /// | `list` | `of`: a form; `range` of its length |
    /// | `table` | `keys` |
    /// | `named` | `of`: a form |
    /// | `either` | `forms` |
    /// | `other` | what only the schema says |
    ///
    /// A range has those of `from`, `above`, `to` and `below` that there are.
    pub fn document(&self) -> Json {
        json!({
            "name": self.name, "doc": self.doc, "symbol": self.symbol, "required": self.is_required,
            "default": self.default.as_ref().map(as_written), "alternative": self.alternative.as_ref().map(|own| own.of.start),
            "words": self.form.words(), "form": self.form.document(),
        })
    }
}

impl Allowed {
    fn document(&self) -> Json {
        let documents = |keys: &[Declaration]| keys.iter().map(Declaration::document).collect::<Vec<_>>();
        match self {
            Self::Number(Number { dimension, range }) => {
                number(*dimension, dimension.is_number().then_some(""), *range)
            }
            Self::Expressed(of) => {
                let mut json = of.document();
                json["expression"] = json!(true);
                json
            }
            Self::Scaled(scaled) => number(scaled.dimension, scaled.group, scaled.range),
            Self::Whole(Whole { from, to }) => json!({ "kind": "whole", "range": whole(*from, *to) }),
            Self::Flag => json!({ "kind": "flag" }),
            Self::Text => json!({ "kind": "text" }),
            Self::Choice { words } => {
                let word = |(word, doc): &(&str, &str)| json!({ "word": word, "doc": doc });
                json!({ "kind": "choice", "words": words.iter().map(word).collect::<Vec<_>>() })
            }
            Self::List { of, length: [least, most] } => {
                json!({ "kind": "list", "of": of.document(), "range": whole(*least, *most) })
            }
            Self::Table { keys, .. } => json!({ "kind": "table", "keys": documents(keys) }),
            Self::Named(of) => json!({ "kind": "named", "of": of.document() }),
            Self::Either(forms) => {
                json!({ "kind": "either", "forms": forms.iter().map(Self::document).collect::<Vec<_>>() })
            }
            Self::Told { keys, .. } if !keys.is_empty() => {
                json!({ "kind": "table", "keys": documents(keys) })
            }
            Self::File | Self::Expression | Self::Quantity | Self::Told { .. } => json!({ "kind": "other" }),
        }
    }
}

fn number(dimension: Dimension, group: Option<&str>, range: Range) -> Json {
    let unit = (!dimension.is_number()).then(|| dimension.unit());
    json!({ "kind": "number", "group": group, "unit": unit, "range": range.document() })
}

fn whole(from: usize, to: usize) -> Json {
    match to {
        UNLIMITED.. => json!({ "from": from }),
        to => json!({ "from": from, "to": to }),
    }
}

impl Range {
    /// Those of its ends that there are: `from` and `to` belong to it, `above` and `below` do not.
    pub fn document(self) -> Json {
        match self {
            Self::Positive => json!({ "above": 0.0 }),
            Self::NonNegative => json!({ "from": 0.0 }),
            Self::Fraction => json!({ "from": 0.0, "below": 1.0 }),
            Self::Any => json!({}),
            Self::Interval { above, up_to } => json!({ "above": above, "to": up_to }),
            Self::Closed { from, to } => json!({ "from": from, "to": to }),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::Scaled;
    use super::*;

    fn declaration(default: Option<Json>, form: Allowed) -> Declaration {
        let is_required = default.is_none();
        Declaration {
            name: "key",
            doc: "what it is",
            symbol: "t",
            default,
            is_required,
            alternative: None,
            form,
        }
    }

    #[test]
    fn a_key_says_what_a_control_of_it_needs() {
        let duration = Allowed::Scaled(Scaled::positive(Dimension::TIME, "ω_nx t"));
        let document = declaration(Some(json!({ "value": 0.005, "unit": "s" })), duration).document();
        assert_eq!((&document["default"], &document["required"]), (&json!("5 ms"), &json!(false)));
        let form = json!({ "kind": "number", "group": "ω_nx t", "unit": "s", "range": { "above": 0.0 } });
        assert_eq!(document["form"], form);
    }

    #[test]
    fn a_table_says_its_keys() {
        let own = declaration(Some(json!(3)), Allowed::Whole(Whole { from: 1, to: UNLIMITED }));
        let table = Allowed::Table { doc: "", keys: vec![own] };
        let document = declaration(None, table).document();
        let inner = &document["form"]["keys"][0];
        assert_eq!((&document["required"], &inner["default"]), (&json!(true), &json!(3)));
        assert_eq!(inner["form"], json!({ "kind": "whole", "range": { "from": 1 } }));
    }
}
