//! Whether two documents agree: in numbers as far as processors do, in everything else exactly.

use serde_json::{Map, Value};

/// How far numbers may differ.
struct Allowed {
    /// Relative to their own size.
    relative: f64,
    /// Relative to the largest number of their array: sums of numbers of that size are rounded there.
    of_largest: f64,
    /// At most what rounding leaves of an array that should be zero.
    of_nothing: f64,
}

const CLOSE: Allowed = Allowed { relative: 1e-9, of_largest: 1e-12, of_nothing: 0.0 };
/// Measured between processors with AVX2 and with AVX-512: the condition of eigenvalues and the ends of searches amplify what sums differ by.
const FACTORED: Allowed = Allowed { relative: 1e-6, of_largest: 1e-10, of_nothing: 1e-15 };
/// How far a number that stands alone may differ: what should be zero is not, by its rounding.
const ALONE: f64 = 1e-12;
/// Names of what a search, a fit or the choice of a step finds only as exactly as its own tolerance, and how far it may differ.
const SOUGHT: [&str; 3] = ["floquet_multipliers", "fit", "fit.csv"];
const STEPS: &str = "path_";
/// The column of growth rates, and what rounding leaves of those of modes that swing at 10⁵ 1/s.
const RATES: &str = "re [";
const OF_NO_RATE: f64 = 1e-10;
const OF_SOUGHT: f64 = 1e-6;
/// Parts of the names of measured errors, of which rounding makes up some: their order of magnitude stays. In texts too.
const ERRORS: [&str; 2] = ["error", "residual"];
/// Whole names of others.
const OTHER_ERRORS: [&str; 4] = ["figure", "change", "along_indentation", "along_velocity"];
const ERROR_FACTOR: f64 = 10.0;
/// Below it an error, and a number within a text, is taken for what rounding has left.
const ROUNDING: f64 = 1e-9;
/// Fewer digits than these are hardly rounded otherwise because of the last bits of a number.
const DIGITS_THAT_MAY_FLIP: usize = 4;

/// The key under which the hash of floating-point bytes stands.
pub(super) const FLOAT_HASH: &str = "float_hash";

/// How numbers are compared.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Numbers {
    /// To the bit.
    Exact,
    /// As they agree between processors.
    Close,
    /// The same of what factorisations give, which choose the width of their sums by the processor.
    Factored,
}

/// One place where two documents differ.
pub(super) struct Difference {
    pub(super) place: String,
    pub(super) expected: String,
    pub(super) found: String,
}

/// All places where two documents differ.
pub(super) fn differences(expected: &Value, found: &Value, numbers: Numbers) -> Vec<Difference> {
    let mut comparison =
        Comparison { numbers, is_below_errors: false, place: Vec::new(), differences: Vec::new() };
    comparison.value(expected, found, 0.0);
    comparison.differences
}

struct Comparison {
    numbers: Numbers,
    /// Whether a text stands below a head that names errors.
    is_below_errors: bool,
    /// The way to what is compared.
    place: Vec<String>,
    differences: Vec<Difference>,
}

impl Comparison {
    /// Compares two values; `largest` is the size of the numbers among which they stand.
    fn value(&mut self, expected: &Value, found: &Value, largest: f64) {
        match (expected, found) {
            (Value::Object(expected), Value::Object(found)) => self.object(expected, found, largest),
            (Value::Array(expected), Value::Array(found)) => self.list(expected, found, largest),
            (Value::String(expected), Value::String(found)) => self.text(expected, found),
            _ if !self.is_same(expected, found, largest) => {
                self.differ(shortened(expected), shortened(found));
            }
            _ => (),
        }
    }

    fn object(&mut self, expected: &Map<String, Value>, found: &Map<String, Value>, largest: f64) {
        // both parts of a complex number are rounded as its magnitude is
        let parts = ["re", "im"].map(|part| expected.get(part).map_or(0.0, magnitude));
        let largest = parts.into_iter().fold(largest, f64::max);
        for (key, own) in expected {
            if key == FLOAT_HASH && self.numbers != Numbers::Exact {
                continue;
            }
            self.place.push(key.clone());
            match found.get(key) {
                Some(other) => self.value(own, other, largest),
                None => self.differ(shortened(own), "nothing".to_owned()),
            }
            self.place.pop();
        }
        for (key, other) in found.iter().filter(|(key, _)| !expected.contains_key(*key)) {
            self.place.push(key.clone());
            self.differ("nothing".to_owned(), shortened(other));
            self.place.pop();
        }
    }

    fn list(&mut self, expected: &[Value], found: &[Value], largest: f64) {
        let largest = expected.iter().map(magnitude).fold(largest, f64::max);
        for (index, (own, other)) in expected.iter().zip(found).enumerate() {
            self.is_below_errors = own.as_str().is_some_and(|line| self.is_of_errors(line));
            self.place.push(title(own).unwrap_or_else(|| index.to_string()));
            self.value(own, other, largest);
            self.place.pop();
        }
        if expected.len() != found.len() {
            let end = |list: &[Value], other: &[Value]| {
                let next = list
                    .get(other.len())
                    .map_or_else(String::new, |next| format!(", then {}", shortened(next)));
                format!("{} items{next}", list.len())
            };
            self.differ(end(expected, found), end(found, expected));
        }
        self.is_below_errors = false;
    }

    /// Whether a line of a list names errors, or goes on with the numbers below one that does.
    fn is_of_errors(&self, line: &str) -> bool {
        let has_fraction = words(line).iter().any(|word| word.contains('.') && word.parse::<f64>().is_ok());
        names_errors(line) || (self.is_below_errors && has_fraction)
    }

    /// Whether two values that are no lists, tables or texts agree at this place.
    fn is_same(&self, expected: &Value, found: &Value, largest: f64) -> bool {
        let are_floats = is_float(expected) && is_float(found) && self.numbers != Numbers::Exact;
        expected == found || (are_floats && self.is_close(float(expected), float(found), largest))
    }

    /// Whether two numbers agree at this place.
    fn is_close(&self, expected: f64, found: f64, largest: f64) -> bool {
        let is_error =
            |step: &str| OTHER_ERRORS.contains(&step) || ERRORS.iter().any(|part| step.contains(part));
        if self.is_within(is_error) && errors_agree(expected, found) {
            return true;
        }
        let high = expected.abs().max(found.abs());
        let is_sought = |step: &str| SOUGHT.contains(&step) || step.starts_with(STEPS);
        let Allowed { relative, of_largest, of_nothing } = match self.numbers {
            Numbers::Factored => FACTORED,
            _ => CLOSE,
        };
        let of_nothing = match self.is_within(|step| step.starts_with(RATES)) {
            true if of_nothing > 0.0 => OF_NO_RATE,
            _ => of_nothing,
        };
        let allowed = match self.is_within(is_sought) {
            true => OF_SOUGHT * high.max(largest),
            false if largest == 0.0 => (relative * high).max(ALONE),
            false => (relative * high).max(of_largest * largest).max(of_nothing),
        };
        (expected - found).abs() <= allowed
    }

    /// Whether a step of the way to this place is so.
    fn is_within(&self, is_so: impl Fn(&str) -> bool) -> bool {
        self.place.iter().any(|step| is_so(step))
    }

    fn text(&mut self, expected: &str, found: &str) {
        let agree = match self.numbers {
            Numbers::Exact => expected == found,
            _ => texts_agree(expected, found, self.is_below_errors || names_errors(expected)),
        };
        if !agree {
            let line = expected.lines().zip(found.lines()).find(|(own, other)| own != other);
            let (own, other) = line.unwrap_or((expected, found));
            self.differ(own.to_owned(), other.to_owned());
        }
    }

    fn differ(&mut self, expected: String, found: String) {
        self.differences.push(Difference { place: self.place.join(" / "), expected, found });
    }
}

/// What an item of a list is called: by its name, or by the arguments with which the command was called.
fn title(item: &Value) -> Option<String> {
    let arguments = || Some(format!("judder {}", item.get("arguments")?));
    item.get("name").and_then(Value::as_str).map(str::to_owned).or_else(arguments)
}

/// The first letters of a value.
fn shortened(value: &Value) -> String {
    const LETTERS: usize = 160;
    let text = value.to_string();
    match text.char_indices().nth(LETTERS) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text,
    }
}

/// Whether a value is a floating-point number; those that JSON does not know are words.
fn is_float(value: &Value) -> bool {
    value.is_f64()
}

fn float(value: &Value) -> f64 {
    value.as_f64().unwrap_or(f64::NAN)
}

/// The largest number of a list of numbers, of lists of them or of tables.
fn magnitude(value: &Value) -> f64 {
    match value {
        Value::Array(items) => items.iter().map(magnitude).fold(0.0, f64::max),
        Value::Number(_) if is_float(value) => float(value).abs(),
        _ => 0.0,
    }
}

/// Whether two measured errors are of one order, or what rounding has left.
fn errors_agree(expected: f64, found: f64) -> bool {
    let (low, high) = (expected.abs().min(found.abs()), expected.abs().max(found.abs()));
    high < ROUNDING || high <= ERROR_FACTOR * low
}

/// Whether a text speaks of measured errors.
fn names_errors(text: &str) -> bool {
    ERRORS.iter().any(|part| text.contains(part))
}

/// A text with one sign for minus, and without the spaces that fill the columns of tables.
fn plain(text: &str) -> String {
    text.replace('−', "-").split(' ').filter(|word| !word.is_empty()).collect::<Vec<_>>().join(" ")
}

/// Whether two texts agree but for the last digits of the numbers in them, those of errors in their order of magnitude.
fn texts_agree(expected: &str, found: &str, is_error: bool) -> bool {
    if expected == found {
        return true;
    }
    let (expected, found) = (&plain(expected), &plain(found));
    let agree = |(own, other): (&&str, &&str)| own == other || numbers_agree(own, other, is_error);
    let (own, other) = (words(expected), words(found));
    own.len() == other.len() && own.iter().zip(&other).all(agree)
}

/// The numbers of a text, and what stands between them.
fn words(text: &str) -> Vec<&str> {
    let mut words = Vec::new();
    let (mut start, mut is_number, mut before) = (0, false, ' ');
    for (place, letter) in text.char_indices() {
        let is_digit_next = text[place + letter.len_utf8()..].starts_with(|next: char| next.is_ascii_digit());
        let belongs = match letter {
            '0'..='9' | '.' => true,
            'e' => is_number,
            '-' => is_digit_next && (before == 'e' || !before.is_alphanumeric()),
            _ => false,
        };
        if belongs != is_number {
            words.push(&text[start..place]);
            (start, is_number) = (place, belongs);
        }
        before = letter;
    }
    words.push(&text[start..]);
    words
}

/// Whether two printed numbers are the same but for how they were rounded.
fn numbers_agree(expected: &str, found: &str, is_error: bool) -> bool {
    let (Ok(own), Ok(other)) = (expected.parse::<f64>(), found.parse::<f64>()) else { return false };
    let is_float = |text: &str| text.contains(['.', 'e']);
    if !is_float(expected) && !is_float(found) {
        return false;
    }
    let high = own.abs().max(other.abs());
    if high < ROUNDING || (is_error && errors_agree(own, other)) {
        return true;
    }
    let digits = digits(expected).max(digits(found));
    // one unit of the last digit, and what the decimal fractions themselves are rounded by
    let unit = 10_f64.powi(high.log10().floor() as i32 + 1 - digits as i32);
    digits >= DIGITS_THAT_MAY_FLIP && (own - other).abs() <= (1.001 * unit).max(CLOSE.relative * high)
}

/// Significant digits of a printed number.
fn digits(text: &str) -> usize {
    let mantissa = text.split('e').next().unwrap_or(text);
    let digits: String = mantissa.chars().filter(char::is_ascii_digit).collect();
    digits.trim_start_matches('0').len()
}

mod tests {
    use super::*;
    use serde_json::json;

    fn agree(expected: &Value, found: &Value) -> bool {
        differences(expected, found, Numbers::Close).is_empty()
    }

    #[test]
    fn numbers_may_differ_by_their_last_bits() {
        assert!(agree(&json!({ "a": [1.0, 1e-3] }), &json!({ "a": [1.0 + 5e-10, 1e-3] })));
        assert!(!agree(&json!({ "a": [1.0, 1e-3] }), &json!({ "a": [1.0, 1.000_001e-3] })));
        assert!(agree(&json!([1.0, 1e-17]), &json!([1.0, -3e-17])));
        assert!(agree(&json!(1e-17), &json!(-3e-17)) && !agree(&json!(1e-9), &json!(-3e-9)));
        let eigenvalue = |re: f64| json!({ "re": re, "im": 1e4, "other": 1.0 });
        assert!(agree(&eigenvalue(1e-10), &eigenvalue(-1e-10)));
        assert!(!agree(&eigenvalue(1e-6), &eigenvalue(-1e-6)));
        assert!(agree(&json!({ "residual": 1e-17 }), &json!({ "residual": 3e-17 })));
        assert!(!agree(&json!({ "residual": 1e-3 }), &json!({ "residual": 1.0 })));
        let exact = differences(&json!(1.0), &json!(1.0 + f64::EPSILON), Numbers::Exact);
        assert_eq!(exact.len(), 1);
    }

    #[test]
    fn nothing_else_may_differ() {
        for (expected, found) in [
            (json!(1), json!(2)),
            (json!(1), json!(1.0)),
            (json!("eq. (23)"), json!("eq. (24)")),
            (json!("0.4 Hz"), json!("0.5 Hz")),
            (json!([1.0]), json!([1.0, 2.0])),
            (json!({ "a": null }), json!({})),
            (json!({}), json!({ "a": null })),
        ] {
            assert!(!agree(&expected, &found), "{expected} {found}");
        }
    }

    #[test]
    fn printed_numbers_may_be_rounded_otherwise() {
        assert!(texts_agree("at 0.123456 m", "at 0.123457 m", false));
        assert!(!texts_agree("at 0.123456 m", "at 0.123466 m", false));
        assert!(texts_agree("start 0.1, 0, 2", "start 0.1, -5.2e-18, 2", false));
        assert!(texts_agree("1.3e-16 of 1e-6", "1.1e-16 of 1e-6", false));
        assert!(!texts_agree("1.3e-6 of 1e-6", "1.1e-6 of 1e-6", false));
        assert!(texts_agree("1 −80.0049 2.56228e−17", "1 −80.0049 3.98431e−17", false));
        assert!(!texts_agree("1 −80.0049 stable", "1 80.0049 stable", false));
    }

    #[test]
    fn errors_of_a_table_are_those_below_a_head_that_names_them() {
        let table = |error: &str| json!(["mode error", error, "modes", "0.0165867 kg"]);
        assert!(agree(&table("1 0.0165867"), &table("1 0.0165872")));
        assert!(!agree(
            &table("1 0.0165867"),
            &json!(["mode error", "1 0.0165867", "modes", "0.0165872 kg"])
        ));
        assert!(!agree(&json!(["1 0.0165867"]), &json!(["1 0.0165872"])));
    }

    #[test]
    fn what_is_factored_agrees_to_fewer_digits() {
        let agree = |a: &Value, b: &Value| differences(a, b, Numbers::Factored).is_empty();
        assert!(agree(&json!([1.0, 4.5e-17]), &json!([1.0 + 5e-8, 3e-18])));
        assert!(agree(&json!([4.5e-17, 1e-18]), &json!([3e-18, -2e-18])));
        assert!(!agree(&json!([1.0]), &json!([1.000_01])));
    }
}
