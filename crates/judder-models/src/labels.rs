//! How the keys of the models are called on axes and in tables.

use judder_keys::keys::Keys;
use judder_keys::numeric_key::Form;
use judder_study::labels::SweptQuantity;

/// How a number that analyses vary is called when its values are of this form.
pub(crate) fn key<K: Keys>(key: K, form: Form) -> SweptQuantity {
    let entry = key.entry();
    let unit = match form {
        Form::Si if !entry.rule.dimension.is_number() => entry.rule.dimension.unit(),
        _ => "1".to_owned(),
    };
    let (words, symbol, shown) = (entry.label, entry.markup(form), if unit == "1" { "−" } else { &unit });
    SweptQuantity {
        name: entry.name().to_owned(),
        label: format!("{words} ${symbol}$ ({shown})"),
        symbol: format!("${symbol}$"),
        unit,
    }
}

/// How a parameter of a two-degrees case is called.
pub(crate) fn parameter(name: &str) -> SweptQuantity {
    SweptQuantity {
        name: name.to_owned(),
        label: format!("Parameter {name} (−)"),
        symbol: name.to_owned(),
        unit: "1".to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::oscillator::keys::OscillatorKey;

    #[test]
    fn an_axis_names_quantity_symbol_and_unit() {
        assert_eq!(key(OscillatorKey::Velocity, Form::Group).label, "Substrate velocity $v̂_{d}$ (−)");
        assert_eq!(key(OscillatorKey::Velocity, Form::Si).label, "Substrate velocity $v_{d}$ (m/s)");
    }
}
