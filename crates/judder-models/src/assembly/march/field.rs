//! Fields over the bodies: numbers or expressions of the place.

use judder_keys::cause::Cause;
use judder_keys::declared::{Allowed, Setting};
use judder_keys::document::{Data, Node};
use judder_keys::error::Fault;
use judder_keys::expression::Expression;
use judder_keys::section::{Section, finite_number};
use serde_json::{Value as Json, json};

/// A number, or an expression of x, y and z in m.
#[derive(Debug, Clone)]
pub struct PlaceExpression {
    text: String,
    expression: Expression,
}

impl PlaceExpression {
    /// Its value at a place in m.
    pub(super) fn at(&self, place: [f64; 3]) -> f64 {
        self.expression.evaluate(&place)
    }
}

impl PartialEq for PlaceExpression {
    fn eq(&self, other: &Self) -> bool {
        self.text == other.text
    }
}

impl Setting for PlaceExpression {
    type Rule = ();

    fn form((): &()) -> Allowed {
        Allowed::Expression
    }

    fn read(section: &Section<'_>, key: &str, node: &Node, (): &()) -> Result<Self, Fault> {
        let Data::Text(text) = &node.data else {
            let value = finite_number(&section.path(key), node)?;
            return Ok(Self { text: value.to_string(), expression: Expression::constant(value) });
        };
        let places = ["x", "y", "z"].map(str::to_owned).to_vec();
        let expression = Expression::compile(text, &places).map_err(|(problem, range)| {
            Cause::Expression { problem, parameters: places }.at(node.part(range))
        })?;
        Ok(Self { text: text.clone(), expression })
    }

    fn write(&self, (): &()) -> Json {
        json!(self.text)
    }
}
