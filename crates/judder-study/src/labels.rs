//! How keys are called on axes and in tables, in the markup of the figures.

use crate::models::belt::case::BeltKey;
use crate::models::oscillator::keys::OscillatorKey;
use judder_keys::dimension::Dimension;
use judder_keys::numeric_key::Form;

/// A swept quantity: its name, its symbol and its unit.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Quantity {
    /// Name as it stands in arrays and tables, such as `velocity`.
    pub name: String,
    /// Quantity, symbol and unit for an axis.
    pub label: String,
    /// Symbol for a legend.
    pub symbol: String,
    /// Unit; `1` for a group.
    pub unit: String,
}

/// How a key of an oscillator case is called when its values are of this form.
pub(crate) fn oscillator_key(key: OscillatorKey, form: Form) -> Quantity {
    let entry = key.entry();
    let (words, group, symbol) = match key {
        OscillatorKey::RubberyModulus => ("Rubbery modulus", "", "E_{0}"),
        OscillatorKey::GlassyModulus => ("Glassy modulus", "", "E_{∞}"),
        OscillatorKey::RetardationTime => ("Retardation time", "", "τ"),
        OscillatorKey::RelaxationTime => ("Relaxation time", "", "τ_{r}"),
        OscillatorKey::PoissonRatio => ("Poisson ratio", "ν", "ν"),
        OscillatorKey::Radius => ("Radius", "", "R"),
        OscillatorKey::ShearStrength => ("Shear strength", "τ̃_{0}", "τ_{0}"),
        OscillatorKey::DampingX => ("Damping", "ξ_{x}", "ξ_{x}"),
        OscillatorKey::DampingY => ("Damping", "ξ_{y}", "ξ_{y}"),
        OscillatorKey::FrequencyRatio => ("Frequency ratio", "Ω", "Ω"),
        OscillatorKey::Coupling => ("Coupling", "η", "η"),
        OscillatorKey::CouplingAngle => ("Coupling angle", "", "α"),
        OscillatorKey::NaturalFrequency => ("Natural frequency", "", "ω_{nx}"),
        OscillatorKey::StiffnessX => ("Stiffness", "", "k_{x}"),
        OscillatorKey::Velocity => ("Substrate velocity", "v̂_{d}", "v_{d}"),
        OscillatorKey::NormalLoad => ("Normal load", "F̃_{n}", "F_{n}"),
    };
    let (symbol, unit) = match form {
        Form::Group => (group, "1".to_owned()),
        Form::Si if entry.dimension.is_number() => (symbol, "1".to_owned()),
        Form::Si => (symbol, entry.dimension.unit()),
    };
    let shown = if unit == "1" { "−" } else { &unit };
    Quantity {
        name: entry.name().to_owned(),
        label: format!("{words} ${symbol}$ ({shown})"),
        symbol: format!("${symbol}$"),
        unit,
    }
}

/// How a key of a belt case is called.
pub(crate) fn belt_key(key: BeltKey) -> Quantity {
    let (words, symbol) = match key {
        BeltKey::Damping => ("Damping", "ξ"),
        BeltKey::AtRest => ("Friction at rest", "μ_{0}"),
        BeltKey::AtSpeed => ("Friction at speed", "μ_{∞}"),
        BeltKey::DecaySpeed => ("Decay speed", "v_{0}"),
        BeltKey::Velocity => ("Belt velocity", "v"),
        BeltKey::NormalForce => ("Normal force", "N"),
    };
    Quantity {
        name: key.entry().name().to_owned(),
        label: format!("{words} ${symbol}$ (−)"),
        symbol: format!("${symbol}$"),
        unit: "1".to_owned(),
    }
}

/// How a parameter of a two-degrees case is called.
pub(crate) fn parameter(name: &str) -> Quantity {
    Quantity {
        name: name.to_owned(),
        label: format!("Parameter {name}"),
        symbol: name.to_owned(),
        unit: "1".to_owned(),
    }
}

/// How any number of a case is called, by its dotted path.
pub(crate) fn any_key(path: &str, dimension: Dimension) -> Quantity {
    let unit = if dimension.is_number() { "1".to_owned() } else { dimension.unit() };
    let shown = if unit == "1" { "−" } else { &unit };
    Quantity {
        name: path.to_owned(),
        label: format!("{path} ({shown})"),
        symbol: path.rsplit('.').next().unwrap_or(path).to_owned(),
        unit,
    }
}

/// A label without the markup of figures.
pub(crate) fn plain(label: &str) -> String {
    label.replace("_{", "").replace(['$', '{', '}'], "")
}

/// A number for a legend: powers of ten as such, others short.
pub fn short_number(value: f64) -> String {
    let exponent = value.abs().log10().floor();
    if value == 0.0 || (-2.0..4.0).contains(&exponent) {
        return format!("{value}").replace('-', "−");
    }
    let mantissa = value / 10_f64.powf(exponent);
    let rounded = (mantissa * 1e6).round() / 1e6;
    let power = format!("10^{{{exponent}}}").replace('-', "−");
    if rounded == 1.0 { power } else { format!("{rounded}·{power}").replace('-', "−") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short_and_typeset() {
        assert_eq!(short_number(1e-6), "10^{−6}");
        assert_eq!(short_number(7.5e-5), "7.5·10^{−5}");
        assert_eq!(short_number(0.05), "0.05");
        assert_eq!(short_number(0.0), "0");
    }

    #[test]
    fn an_axis_names_quantity_symbol_and_unit() {
        assert_eq!(
            oscillator_key(OscillatorKey::Velocity, Form::Group).label,
            "Substrate velocity $v̂_{d}$ (−)"
        );
        assert_eq!(
            oscillator_key(OscillatorKey::Velocity, Form::Si).label,
            "Substrate velocity $v_{d}$ (m/s)"
        );
    }
}
