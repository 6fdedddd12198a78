//! A value of a numeric key that comes from a program and not from a case file, read by the same rules.

use crate::oscillator::keys::OscillatorKey;
use judder_keys::document::{Data, Node};
use judder_keys::error::{CaseError, Place, Sources};
use judder_keys::numeric_key::read_value;
use judder_keys::numeric_key::{Form, Value};

/// A value as a case file would have it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Given<'a> {
    /// A plain number: the group of the key, or its pure number.
    Number(f64),
    /// A number with its unit, such as `30 mm/s`.
    Text(&'a str),
}

impl OscillatorKey {
    /// The value of this key, as a case file that says `given` would have it; errors call it by its dotted path, and their
    /// source `argument`.
    ///
    /// # Errors
    /// [`CaseError`] for a unit of another dimension or none, a text that is no quantity, a number that is out of range or not finite.
    pub fn read(self, given: Given<'_>) -> Result<Value, CaseError> {
        let entry = self.entry();
        let (data, text) = match given {
            Given::Number(value) if entry.group.is_some() && entry.range.contains(value) => {
                return Ok(Value { number: value, form: Form::Group });
            }
            Given::Number(value) => (Data::Number { value, whole: None }, value.to_string()),
            Given::Text(text) => (Data::Text(text.to_owned()), format!("\"{text}\"")),
        };
        let node = Node { place: Place { source: 0, start: 0, end: text.len() }, data };
        let sources = Sources::new("argument", &text, &[]);
        read_value(entry, entry.path, &node).map_err(|fault| sources.error(fault))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::oscillator::keys::OscillatorKey::{DampingX, Radius, Velocity};
    use judder_keys::cause::Cause;

    #[test]
    fn values_are_read_as_a_case_file_reads_them() {
        assert_eq!(Velocity.read(Given::Number(1e-4)).unwrap(), Value::group(1e-4));
        assert_eq!(Velocity.read(Given::Text("30 mm/s")).unwrap(), Value::si(0.03));
        assert!(matches!(Radius.read(Given::Number(0.01)).unwrap_err().cause(), Cause::NeedsUnit { .. }));
        let error = Velocity.read(Given::Text("30 N")).unwrap_err();
        assert!(matches!(error.cause(), Cause::WrongDimension { .. }));
        assert_eq!((error.source_name(), error.line_and_column()), ("argument", Some((1, 1))));
        for number in [f64::NAN, -1.0, f64::INFINITY] {
            assert!(
                Velocity.read(Given::Number(number)).is_err()
                    && DampingX.read(Given::Number(number)).is_err()
            );
        }
    }
}
