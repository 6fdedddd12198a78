//! Conditions on the quantities of a sweep, of which it tells how probable they are.

use super::asked::AskedCondition;
use super::problem::SweepProblem;
use super::quantity_path::{QuantityPath, QuantitySource};
use judder_numerics::words::plain;

/// Something that holds at a point or not.
#[derive(Debug, Clone, PartialEq)]
pub struct SweptCondition {
    /// The position of its quantity among those of the sweep.
    pub quantity: usize,
    /// What is asked of it.
    pub bound: ConditionBound,
}

/// What is asked of a quantity.
#[derive(Debug, Clone, PartialEq)]
pub enum ConditionBound {
    /// That it lies above the first and below the second, where they are given; that it is not zero where neither is.
    Within(Option<f64>, Option<f64>),
    /// That a class has this code, called so.
    Class(u8, String),
}

impl SweptCondition {
    /// Finds the quantity of a condition, and whether it can be asked that.
    pub(super) fn new(asked: &AskedCondition, quantities: &[QuantityPath]) -> Result<Self, SweepProblem> {
        let known = || quantities.iter().map(|own| own.text.clone()).collect();
        if asked.quantity.is_empty() {
            return Err(SweepProblem::NoQuantity { known: known() });
        }
        let refuse = |reason: String| {
            Err(SweepProblem::Condition { quantity: asked.quantity.clone(), reason, known: known() })
        };
        let Some(quantity) = quantities.iter().position(|own| own.text == asked.quantity) else {
            return refuse("it is not among the `quantities` of this sweep".to_owned());
        };
        let flags = match &quantities[quantity].source {
            QuantitySource::Point { quantity } => quantity.flags,
            QuantitySource::Analysis { .. } => &[],
        };
        let bound = match (&asked.is, asked.above, asked.below) {
            (Some(word), None, None) if !flags.is_empty() => match flags.iter().position(|own| own == word) {
                Some(code) => ConditionBound::Class(code as u8, word.clone()),
                None => return refuse(format!("it is one of {}, and never {word}", flags.join(", "))),
            },
            (Some(_), None, None) => return refuse("it is no class: give `above` or `below`".to_owned()),
            (Some(_), ..) => return refuse("`is` has no bounds beside it".to_owned()),
            (None, ..) if !flags.is_empty() => {
                return refuse(format!("it is a class: say is = \"{}\"", flags.join("\", or \"")));
            }
            (None, Some(above), Some(below)) if above >= below => {
                return refuse("nothing lies above `above` and below `below`".to_owned());
            }
            (None, above, below) => ConditionBound::Within(above, below),
        };
        Ok(Self { quantity, bound })
    }

    /// As a case says it.
    pub(super) fn as_asked(&self, quantities: &[QuantityPath]) -> AskedCondition {
        let quantity = quantities[self.quantity].text.clone();
        match &self.bound {
            ConditionBound::Within(above, below) => {
                AskedCondition { quantity, above: *above, below: *below, is: None }
            }
            ConditionBound::Class(_, word) => {
                AskedCondition { quantity, above: None, below: None, is: Some(word.clone()) }
            }
        }
    }

    /// Whether it holds of a value. That has no number where there is nothing of the kind, of which no bound holds.
    #[must_use]
    pub fn holds(&self, value: f64) -> bool {
        match self.bound {
            ConditionBound::Within(None, None) => value != 0.0 && !value.is_nan(),
            ConditionBound::Within(above, below) => {
                !value.is_nan()
                    && above.is_none_or(|bound| value > bound)
                    && below.is_none_or(|bound| value < bound)
            }
            ConditionBound::Class(code, _) => value == f64::from(code),
        }
    }

    /// The same in words, of a quantity of this name.
    #[must_use]
    pub fn words(&self, quantity: &str) -> String {
        match &self.bound {
            ConditionBound::Within(None, None) => quantity.to_owned(),
            ConditionBound::Within(Some(above), None) => format!("{quantity} > {}", plain(*above)),
            ConditionBound::Within(None, Some(below)) => format!("{quantity} < {}", plain(*below)),
            ConditionBound::Within(Some(above), Some(below)) => {
                format!("{} < {quantity} < {}", plain(*above), plain(*below))
            }
            ConditionBound::Class(_, word) => format!("{quantity} is {word}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_has_no_number_lies_within_no_bound() {
        let condition =
            |above, below| SweptCondition { quantity: 0, bound: ConditionBound::Within(above, below) };
        for (above, below, words) in [
            (None, None, "level"),
            (Some(1.0), None, "level > 1"),
            (None, Some(3.0), "level < 3"),
            (Some(1.0), Some(3.0), "1 < level < 3"),
        ] {
            let own = condition(above, below);
            assert!(own.holds(2.0) && !own.holds(f64::NAN));
            assert_eq!(own.words("level"), words);
        }
        assert!(!condition(None, None).holds(0.0) && !condition(Some(2.0), None).holds(2.0));
        let class = SweptCondition { quantity: 0, bound: ConditionBound::Class(1, "unstable".to_owned()) };
        assert!(class.holds(1.0) && !class.holds(0.0) && class.words("verdict") == "verdict is unstable");
    }
}
