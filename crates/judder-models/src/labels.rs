//! How the keys of the models are called on axes and in tables.

use crate::belt::case::BeltKey;
use crate::oscillator::keys::OscillatorKey;
use judder_keys::numeric_key::Form;
use judder_study::labels::Quantity;

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

#[cfg(test)]
mod tests {
    use super::*;

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
