//! Numbers that may be expressions of parameters: said once of all declared keys, and worked out in the tree before it is read.

use super::{Allowed, Declaration, all};
use crate::cause::Cause;
use crate::dimension::Dimension;
use crate::document::{Data, Node, name_of};
use crate::error::Fault;
use crate::expression::Expression;
use crate::quantity::Quantity;
use crate::section::Section;
use serde_json::{Value as Json, json};

const EXPRESSION: &str = "expression";
const UNIT: &str = "unit";
/// What a unit is parsed behind.
const ONE: &str = "1 ";

impl Declaration {
    /// The same key, whose numbers may be expressions of parameters.
    pub fn with_expressions(self) -> Self {
        Self { form: self.form.with_expressions(), ..self }
    }
}

impl Allowed {
    /// Counts, and what a type tells of itself, stay as they are.
    fn with_expressions(self) -> Self {
        match self {
            Self::Number(_) | Self::Scaled(_) => Self::Expressed(Box::new(self)),
            Self::List { of, length } => Self::List { of: Box::new(of.with_expressions()), length },
            Self::Named(of) => Self::Named(Box::new(of.with_expressions())),
            Self::Either(forms) => Self::Either(forms.into_iter().map(Self::with_expressions).collect()),
            Self::Table { doc, keys } => {
                Self::Table { doc, keys: keys.into_iter().map(Declaration::with_expressions).collect() }
            }
            other => other,
        }
    }

    /// The dimension of a number that may be an expression, and what it is without a unit, where it may stand so.
    fn expressed(&self) -> Option<(Dimension, Option<&'static str>)> {
        match self {
            Self::Expressed(of) => match of.as_ref() {
                Self::Number(number) => Some((number.dimension, None)),
                Self::Scaled(scaled) => Some((scaled.dimension, scaled.group)),
                _ => None,
            },
            _ => None,
        }
    }

    fn expressed_dimension(&self) -> Option<Dimension> {
        self.expressed().map(|(dimension, _)| dimension)
    }

    /// Whether a text there is something else than an expression.
    fn takes_text(&self) -> bool {
        match self {
            Self::Text
            | Self::File
            | Self::Choice { .. }
            | Self::Expression
            | Self::Quantity
            | Self::Told { .. } => true,
            _ => self.expressed_dimension().is_some_and(|own| !own.is_number()),
        }
    }

    /// Whether a table there may be something else than an expression.
    fn takes_table(&self) -> bool {
        matches!(self, Self::Table { .. } | Self::Named(_) | Self::Told { .. })
    }
}

/// The schema of an expression in the place of a number, in short where no unit is wanted.
pub(super) fn expression_schema(of: &Allowed) -> Vec<Json> {
    let is_number = matches!(of, Allowed::Number(number) if number.dimension.is_number());
    let table = json!({
        "type": "object", "required": [EXPRESSION], "propertyNames": { "enum": [EXPRESSION, UNIT] },
        "additionalProperties": { "type": "string" },
    });
    is_number.then(|| json!({ "type": "string" })).into_iter().chain([table]).collect()
}

/// An expression that stands in a case in the place of a number.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NumberExpression {
    /// The dotted path of the number, items of lists by their names.
    pub path: String,
    /// The expression.
    pub text: String,
    /// The unit in which it gives the number; empty where it has none.
    pub unit: String,
}

/// A tree, and what stood where its numbers are.
#[derive(Debug)]
pub struct EvaluatedTree {
    /// With numbers in the place of expressions.
    pub root: Node,
    /// The expressions, in the order of the tree.
    pub expressions: Vec<NumberExpression>,
}

/// What expressions may name, and the values of it.
#[derive(Debug, Clone, Copy)]
pub struct ExpressionScope<'a> {
    /// The names of the parameters.
    pub names: &'a [String],
    /// Their values, in the same order.
    pub values: &'a [f64],
}

impl ExpressionScope<'_> {
    /// A tree with all expressions worked out that stand in the place of numbers of these keys.
    ///
    /// A number without a unit may be `"0.45 - 4e-4*temperature"`, any number `{ expression = "210 - 0.05*temperature", unit = "GPa" }`.
    ///
    /// # Errors
    /// All that is wrong with them: unknown names, what is no expression, values that are not finite, units of another dimension.
    pub fn evaluated(self, root: &Node, keys: &[Declaration]) -> Result<EvaluatedTree, Fault> {
        let (mut root, mut expressions) = (root.clone(), Vec::new());
        let table = Allowed::Table { doc: "", keys: keys.to_vec() };
        self.walk(&mut root, &[&table], "", &mut expressions)?;
        Ok(EvaluatedTree { root, expressions })
    }

    fn walk(
        self,
        node: &mut Node,
        forms: &[&Allowed],
        path: &str,
        found: &mut Vec<NumberExpression>,
    ) -> Result<(), Fault> {
        let forms: Vec<&Allowed> = forms.iter().flat_map(|form| form.alternatives()).collect();
        if is_expression(node, &forms) {
            let dimensions: Vec<_> = forms.iter().filter_map(|form| form.expressed_dimension()).collect();
            let (data, expression) = self.number(node, &dimensions, path)?;
            node.data = data;
            found.push(expression);
            return Ok(());
        }
        self.refuse_without_unit(node, &forms, path)?;
        let under = |step: &str| if path.is_empty() { step.to_owned() } else { format!("{path}.{step}") };
        match &mut node.data {
            Data::Table(table) => all(table.entries.iter_mut().map(|entry| {
                let inner: Vec<&Allowed> = forms.iter().flat_map(|form| form.under_key(&entry.key)).collect();
                self.walk(&mut entry.node, &inner, &under(&entry.key), found)
            })),
            Data::List(items) => {
                let inner: Vec<&Allowed> = forms.iter().filter_map(|form| form.of_items()).collect();
                all(items.iter_mut().enumerate().map(|(place, item)| {
                    let step = name_of(item).map_or_else(|| place.to_string(), str::to_owned);
                    self.walk(item, &inner, &under(&step), found)
                }))
            }
            _ => Ok(Vec::new()),
        }
        .map(drop)
    }

    /// Refuses a text that is an expression of parameters where nothing but a quantity may stand.
    fn refuse_without_unit(self, node: &Node, forms: &[&Allowed], path: &str) -> Result<(), Fault> {
        let Data::Text(text) = &node.data else { return Ok(()) };
        let numbers: Option<Vec<_>> = forms.iter().map(|form| form.expressed()).collect();
        let Some(&[(dimension, group)]) = numbers.as_deref() else { return Ok(()) };
        let names_a_parameter = Expression::compile(text, self.names)
            .is_ok_and(|own| (0..self.names.len()).any(|index| own.depends_on(index)));
        if names_a_parameter && Quantity::parse(text).is_err() {
            let (key, text) = (path.to_owned(), text.clone());
            return Err(Cause::ExpressionWithoutUnit { key, text, dimension, group }.at(node.place));
        }
        Ok(())
    }

    /// What an expression gives, as the number that stands in its place.
    fn number(
        self,
        node: &Node,
        dimensions: &[Dimension],
        path: &str,
    ) -> Result<(Data, NumberExpression), Fault> {
        let (written, unit) = match &node.data {
            Data::Table(_) => {
                let section = Section::open(node, path, &format!("`{path}`"), &[EXPRESSION, UNIT])?;
                let wanted = "expression = \"…\", an expression of the parameters";
                (section.required(EXPRESSION, wanted)?, section.get(UNIT))
            }
            _ => (node, None),
        };
        let text = crate::section::text(path, written)?;
        let value = self.value(path, written, text)?;
        let unit = unit.map(|unit| unit_at(path, unit, dimensions)).transpose()?;
        let data = match &unit {
            None => Data::Number { value, whole: None },
            // of a ratio of units what it multiplies by
            Some((_, one)) if one.dimension.is_number() => {
                Data::Number { value: value * one.number, whole: None }
            }
            Some((unit, _)) => {
                let text = format!("{value:?} {unit}");
                Quantity::parse(&text).map_err(|(problem, _)| {
                    let (key, dimension) = (path.to_owned(), dimensions[0]);
                    Cause::Quantity { key, dimension, problem }.at(node.place)
                })?;
                Data::Text(text)
            }
        };
        let unit = unit.map_or(String::new(), |(unit, _)| unit);
        Ok((data, NumberExpression { path: path.to_owned(), text: text.to_owned(), unit }))
    }

    fn value(self, path: &str, node: &Node, text: &str) -> Result<f64, Fault> {
        let expression = Expression::compile(text, self.names).map_err(|(problem, range)| {
            Cause::Expression { problem, parameters: self.names.to_vec() }.at(node.part(range))
        })?;
        let value = expression.evaluate(self.values);
        if value.is_finite() {
            return Ok(value);
        }
        let used = self.names.iter().zip(self.values).enumerate();
        let used = used.filter(|(index, _)| expression.depends_on(*index));
        let point: Vec<_> = used.map(|(_, (name, value))| format!("{name} = {value}")).collect();
        let (key, point) = (path.to_owned(), point.join(", "));
        Err(Cause::NotFiniteExpression { key, value, point }.at(node.part(0..text.len())))
    }
}

/// Whether an expression stands in the place of a number of one of these forms.
fn is_expression(node: &Node, forms: &[&Allowed]) -> bool {
    let is_number = forms.iter().any(|form| form.expressed_dimension().is_some());
    is_number
        && match &node.data {
            Data::Table(table) => {
                table.get(EXPRESSION).is_some() || !forms.iter().any(|form| form.takes_table())
            }
            Data::Text(_) => !forms.iter().any(|form| form.takes_text()),
            _ => false,
        }
}

/// The unit at a node and one of it, of one of these dimensions or a number.
fn unit_at(path: &str, node: &Node, dimensions: &[Dimension]) -> Result<(String, Quantity), Fault> {
    let unit = crate::section::text(&format!("{path}.{UNIT}"), node)?;
    let (key, expected) = (path.to_owned(), dimensions[0]);
    match Quantity::parse(&format!("{ONE}{unit}")) {
        Ok(one) if one.dimension.is_number() || dimensions.contains(&one.dimension) => {
            Ok((unit.trim().to_owned(), one))
        }
        Ok(Quantity { dimension: found, .. }) => {
            Err(Cause::WrongDimension { key, expected, found, group: None }.at(node.place))
        }
        Err((problem, range)) => {
            let part = range.start.saturating_sub(ONE.len())..range.end.saturating_sub(ONE.len());
            Err(Cause::Quantity { key, dimension: expected, problem }.at(node.part(part)))
        }
    }
}

impl Allowed {
    /// What may stand under a key of a table.
    fn under_key(&self, key: &str) -> Vec<&Self> {
        match self {
            Self::Table { keys, .. } => {
                keys.iter().filter(|own| own.name == key).map(|own| &own.form).collect()
            }
            Self::Named(of) => vec![of],
            _ => Vec::new(),
        }
    }

    /// What each item of a list may be.
    fn of_items(&self) -> Option<&Self> {
        if let Self::List { of, .. } = self { Some(of) } else { None }
    }
}

#[cfg(test)]
mod tests {
    use super::super::Number;
    use super::*;
    use crate::document::parse;

    fn declared() -> Vec<Declaration> {
        let key = |name, form| Declaration {
            name,
            doc: "what it is",
            symbol: "",
            default: None,
            is_required: false,
            alternative: None,
            form,
        };
        let number = |dimension| Allowed::Number(Number::any(dimension));
        let table = vec![key("modulus", number(Dimension::STRESS))];
        let keys = vec![
            key("friction", Allowed::Either(vec![number(Dimension::NUMBER), Allowed::Flag])),
            key("kind", Allowed::Either(vec![number(Dimension::NUMBER), Allowed::Text])),
            key("inner", Allowed::Table { doc: "", keys: table }),
            key("places", Allowed::List { of: Box::new(number(Dimension::LENGTH)), length: [0, 9] }),
        ];
        keys.into_iter().map(Declaration::with_expressions).collect()
    }

    fn evaluated(text: &str) -> Result<EvaluatedTree, Fault> {
        let names = ["t".to_owned()];
        ExpressionScope { names: &names, values: &[20.0] }.evaluated(&parse(text).unwrap(), &declared())
    }

    #[test]
    fn numbers_stand_where_expressions_were() {
        let text = "friction = \"0.5 - t/100\"\nkind = \"t\"\ninner = { modulus = { expression = \"t + 1\", unit = \"GPa\" } }\nplaces = [\"1 m\", { expression = \"2*t\", unit = \"mm\" }]";
        let EvaluatedTree { root, expressions } = evaluated(text).unwrap();
        assert!(matches!(root.entry("friction").unwrap().data, Data::Number { value: 0.3, .. }));
        let text = |node: &Node| match &node.data {
            Data::Text(text) => text.clone(),
            _ => String::new(),
        };
        assert_eq!(text(root.entry("kind").unwrap()), "t");
        assert_eq!(text(root.entry("inner").unwrap().entry("modulus").unwrap()), "21.0 GPa");
        assert_eq!(text(root.entry("places").unwrap().step("1").unwrap()), "40.0 mm");
        let paths: Vec<_> = expressions.iter().map(|own| own.path.as_str()).collect();
        assert_eq!(paths, ["friction", "inner.modulus", "places.1"]);
    }

    #[test]
    fn what_is_wrong_is_told() {
        let cause = |text: &str| evaluated(text).unwrap_err().into_cause().to_string();
        assert_eq!(cause("friction = \"u\""), "unknown symbol `u`");
        assert_eq!(cause("friction = \"1/(t - 20)\""), "`friction` is inf, at t = 20");
        let inner = |own: &str| cause(&format!("inner.modulus = {{ expression = \"t\", unit = \"{own}\" }}"));
        assert_eq!(inner("mm"), "`inner.modulus` must be a stress, but this is a length");
        assert_eq!(inner("GPx"), "`inner.modulus` is not a stress: unknown unit `GPx`");
        assert!(cause("inner.modulus = { expresion = \"t\" }").contains("expresion"));
        let ratio = evaluated("friction = { expression = \"t\", unit = \"mm/m\" }").unwrap().root;
        assert!(matches!(ratio.entry("friction").unwrap().data, Data::Number { value: 0.02, .. }));
        let fault = evaluated("inner.modulus = \"21 - t\"").unwrap_err().into_cause();
        assert_eq!(fault.to_string(), "`inner.modulus` is an expression without a unit");
        assert_eq!(fault.help().unwrap(), "write { expression = \"21 - t\", unit = \"MPa\" }");
    }
}
