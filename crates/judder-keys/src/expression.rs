//! Expressions of parameters: `"1 - 4*mu/3"`, compiled once, evaluated at every point.
//!
//! A compiler of our own: with it `-x^2` is −(x²) as on paper, no letter is taken but `pi`, and an error knows
//! its place.

use std::f64::consts::PI;
use std::ops::Range;

use thiserror::Error;

use crate::nearest::did_you_mean;
use crate::quantity::leading_number;

/// Why a text is not an expression.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum ExpressionError {
    /// A name that is neither a parameter nor a constant nor a function.
    #[error("unknown symbol `{name}`")]
    UnknownSymbol {
        /// The name as written.
        name: String,
    },
    /// A function without its argument in parentheses.
    #[error("the function `{name}` needs an argument in parentheses")]
    NoArgument {
        /// The function.
        name: &'static str,
    },
    /// A number, name or opening parenthesis is missing.
    #[error("a number, a name or `(` is missing")]
    NoOperand,
    /// Something follows where an operator or the end should be.
    #[error("an operator or the end is missing")]
    NoOperator,
    /// A parenthesis that is not closed.
    #[error("a `)` is missing")]
    NotClosed,
    /// A number beyond the range of `f64`.
    #[error("the number is too large")]
    TooLarge,
    /// More nesting than an expression may have.
    #[error("the expression is nested too deeply")]
    TooDeep,
}

impl ExpressionError {
    /// What would be right, with the names of the parameters that there are.
    pub fn help(&self, parameters: &[String]) -> String {
        let functions = FUNCTIONS.map(|(name, _)| name).join(" ");
        match self {
            Self::UnknownSymbol { name } => {
                let known: Vec<_> = parameters.iter().cloned().chain(["pi".to_owned()]).collect();
                format!("{}; functions: {functions}", did_you_mean(name, &known, "known symbols"))
            }
            _ => format!("as in \"1 - 4*mu/3\": + - * / ^ ( ), pi, {functions}"),
        }
    }
}

type Function = fn(f64) -> f64;

/// The functions of one argument; angles in radians.
const FUNCTIONS: [(&str, Function); 13] = [
    ("sin", libm::sin),
    ("cos", libm::cos),
    ("tan", libm::tan),
    ("asin", libm::asin),
    ("acos", libm::acos),
    ("atan", libm::atan),
    ("sinh", libm::sinh),
    ("cosh", libm::cosh),
    ("tanh", libm::tanh),
    ("exp", libm::exp),
    ("ln", libm::log),
    ("sqrt", f64::sqrt),
    ("abs", f64::abs),
];

/// Whether an expression reads `name` as one of its parameters.
pub fn is_parameter_name(name: &str) -> bool {
    let mut characters = name.chars();
    let begins = characters.next().is_some_and(|first| first.is_alphabetic() || first == '_');
    let taken = name == "pi" || name == "π" || FUNCTIONS.iter().any(|(function, _)| *function == name);
    begins && !taken && characters.all(is_name_character)
}

fn is_name_character(character: char) -> bool {
    character.is_alphanumeric() || character == '_'
}

/// One step of a compiled expression, in postfix order.
#[derive(Debug, Clone, Copy)]
enum ExpressionStep {
    Number(f64),
    Parameter(usize),
    Apply(Function),
    Combine(fn(f64, f64) -> f64),
}

/// Operands that may wait at once, so that evaluation needs no allocation; also the limit of nesting.
const DEPTH: usize = 32;

/// A compiled expression of some parameters.
#[derive(Debug, Clone)]
pub struct Expression {
    steps: Vec<ExpressionStep>,
}

impl Expression {
    /// A number.
    pub fn constant(value: f64) -> Self {
        Self { steps: vec![ExpressionStep::Number(value)] }
    }

    /// Compiles `text`, whose free names are `parameters`.
    pub fn compile(text: &str, parameters: &[String]) -> Result<Self, (ExpressionError, Range<usize>)> {
        let mut compiler = Compiler { text, at: 0, parameters, steps: Vec::new(), nesting: 0 };
        compiler.sum()?;
        if compiler.peek().is_some() {
            return Err((ExpressionError::NoOperator, compiler.at..text.trim_end().len()));
        }
        let mut waiting = 0_usize;
        for step in &compiler.steps {
            match step {
                ExpressionStep::Number(_) | ExpressionStep::Parameter(_) => waiting += 1,
                ExpressionStep::Apply(_) => (),
                ExpressionStep::Combine(_) => waiting -= 1,
            }
            if waiting > DEPTH {
                return Err((ExpressionError::TooDeep, 0..text.len()));
            }
        }
        Ok(Self { steps: compiler.steps })
    }

    /// Whether the expression contains the parameter at `index`.
    pub fn depends_on(&self, index: usize) -> bool {
        self.steps.iter().any(|step| matches!(step, ExpressionStep::Parameter(used) if *used == index))
    }

    /// The value where the parameters are `values`, in the order given to [`Expression::compile`].
    pub fn evaluate(&self, values: &[f64]) -> f64 {
        let mut stack = [0.0; DEPTH];
        let mut top = 0;
        for step in &self.steps {
            let pushed = match *step {
                ExpressionStep::Number(number) => number,
                ExpressionStep::Parameter(index) => values.get(index).copied().unwrap_or(f64::NAN),
                ExpressionStep::Apply(function) => {
                    top -= 1;
                    function(stack[top])
                }
                ExpressionStep::Combine(operator) => {
                    top -= 2;
                    operator(stack[top], stack[top + 1])
                }
            };
            stack[top] = pushed;
            top += 1;
        }
        stack[0]
    }
}

type Compiled = Result<(), (ExpressionError, Range<usize>)>;

/// Recursive descent: sum, product, sign, power, atom.
struct Compiler<'a> {
    text: &'a str,
    at: usize,
    parameters: &'a [String],
    steps: Vec<ExpressionStep>,
    nesting: usize,
}

impl Compiler<'_> {
    /// The next character that is not blank; `at` then stands before it.
    fn peek(&mut self) -> Option<char> {
        let rest = &self.text[self.at..];
        self.at += rest.len() - rest.trim_start().len();
        self.text[self.at..].chars().next()
    }

    fn take(&mut self, wanted: char) -> bool {
        let found = self.peek() == Some(wanted);
        self.at += if found { wanted.len_utf8() } else { 0 };
        found
    }

    fn sum(&mut self) -> Compiled {
        self.product()?;
        loop {
            let step = match self.peek() {
                Some('+') => ExpressionStep::Combine(std::ops::Add::add),
                Some('-') => ExpressionStep::Combine(std::ops::Sub::sub),
                _ => return Ok(()),
            };
            self.at += 1;
            self.product()?;
            self.steps.push(step);
        }
    }

    fn product(&mut self) -> Compiled {
        self.signed()?;
        loop {
            let step = match self.peek() {
                Some('*') => ExpressionStep::Combine(std::ops::Mul::mul),
                Some('/') => ExpressionStep::Combine(std::ops::Div::div),
                _ => return Ok(()),
            };
            self.at += 1;
            self.signed()?;
            self.steps.push(step);
        }
    }

    /// A power with any number of signs before it; every recursion of the grammar passes here.
    fn signed(&mut self) -> Compiled {
        self.nesting += 1;
        if self.nesting > DEPTH {
            return Err((ExpressionError::TooDeep, self.at..self.text.len()));
        }
        if self.take('-') {
            self.signed()?;
            self.steps.push(ExpressionStep::Apply(std::ops::Neg::neg));
        } else if self.take('+') {
            self.signed()?;
        } else {
            self.atom()?;
            if self.take('^') {
                self.signed()?;
                self.steps.push(ExpressionStep::Combine(libm::pow));
            }
        }
        self.nesting -= 1;
        Ok(())
    }

    fn atom(&mut self) -> Compiled {
        match self.peek() {
            Some('(') => self.parenthesis(),
            Some(first) if first.is_alphabetic() || first == '_' => self.name(),
            _ => self.number(),
        }
    }

    fn number(&mut self) -> Compiled {
        let rest = &self.text[self.at..];
        match leading_number(rest) {
            Some((number, length)) if number.is_finite() => {
                self.steps.push(ExpressionStep::Number(number));
                self.at += length;
                Ok(())
            }
            Some((_, length)) => Err((ExpressionError::TooLarge, self.at..self.at + length)),
            None => {
                let length = rest.chars().next().map_or(0, char::len_utf8);
                Err((ExpressionError::NoOperand, self.at..self.at + length))
            }
        }
    }

    fn parenthesis(&mut self) -> Compiled {
        let open = self.at;
        self.at += 1;
        self.sum()?;
        if self.take(')') { Ok(()) } else { Err((ExpressionError::NotClosed, open..self.at)) }
    }

    fn name(&mut self) -> Compiled {
        let rest = &self.text[self.at..];
        let length = rest.find(|character| !is_name_character(character)).unwrap_or(rest.len());
        let (name, here) = (&rest[..length], self.at..self.at + length);
        self.at = here.end;
        if let Some(index) = self.parameters.iter().position(|parameter| parameter == name) {
            self.steps.push(ExpressionStep::Parameter(index));
        } else if name == "pi" || name == "π" {
            self.steps.push(ExpressionStep::Number(PI));
        } else if let Some((name, function)) = FUNCTIONS.iter().find(|(function, _)| *function == name) {
            if self.peek() != Some('(') {
                return Err((ExpressionError::NoArgument { name }, here));
            }
            self.parenthesis()?;
            self.steps.push(ExpressionStep::Apply(*function));
        } else {
            return Err((ExpressionError::UnknownSymbol { name: name.to_owned() }, here));
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn value(text: &str) -> f64 {
        let parameters = ["mu", "k_1", "α"].map(String::from);
        let expression =
            Expression::compile(text, &parameters).unwrap_or_else(|error| panic!("{text}: {error:?}"));
        expression.evaluate(&[0.75, 2.0, 0.5])
    }

    fn error(text: &str) -> (ExpressionError, Range<usize>) {
        Expression::compile(text, &["mu".to_owned()]).unwrap_err()
    }

    #[test]
    fn expressions_read_as_on_paper() {
        let cases = [
            ("1 - 4*mu/3", 0.0),
            ("-2^2", -4.0),
            ("2^-1", 0.5),
            ("2^3^2", 512.0),
            ("8/2/2", 2.0),
            ("1 - 2 - 3", -4.0),
            ("-(k_1 + 1)*2", -6.0),
            ("sqrt(16) + cos(0) + sin(pi/2) + exp(0)", 7.0),
            ("2*π - 2*pi", 0.0),
            ("α*k_1", 1.0),
            ("--1", 1.0),
            ("1e-3*1000", 1.0),
            ("abs(-3) * ln(exp(1))", 3.0),
        ];
        for (text, expected) in cases {
            assert!((value(text) - expected).abs() < 1e-15, "{text} gave {}", value(text));
        }
    }

    #[test]
    fn errors_know_their_place() {
        assert_eq!(error("1 - nu"), (ExpressionError::UnknownSymbol { name: "nu".into() }, 4..6));
        assert_eq!(error("1 - "), (ExpressionError::NoOperand, 4..4));
        assert_eq!(error("2 mu "), (ExpressionError::NoOperator, 2..4));
        assert_eq!(error("2*(1 + mu"), (ExpressionError::NotClosed, 2..9));
        assert_eq!(error("sin mu"), (ExpressionError::NoArgument { name: "sin" }, 0..3));
        assert_eq!(error("1e999"), (ExpressionError::TooLarge, 0..5));
        assert_eq!(error(&"(".repeat(1000)).0, ExpressionError::TooDeep);
        assert_eq!(error(&"-".repeat(1000)).0, ExpressionError::TooDeep);
        assert_eq!(error(&"2^".repeat(1000)).0, ExpressionError::TooDeep);
    }

    proptest! {
        #[test]
        fn any_text_compiles_or_fails_inside_it(text in "[-+*/^() .0-9a-zπ]{0,40}") {
            match Expression::compile(&text, &["m".to_owned()]) {
                Ok(expression) => { let _ = expression.evaluate(&[1.0]); }
                Err((_, range)) => prop_assert!(text.get(range).is_some()),
            }
        }
    }
}
