//! The one table of keys: every numeric key of an oscillator case, with its dimension, group, range and default.
//!
//! Reading, defaults, unit errors, `--set`, sweeps, the schema and the templates are all driven by [`KEYS`].

use judder_keys::dimension::Dimension;
use judder_keys::numeric_key::{Key, Range, number, quantity};
use std::fmt;

/// A numeric key of an oscillator case; its position in [`KEYS`] is `key as usize`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum OscillatorKey {
    /// E0.
    RubberyModulus,
    /// E∞.
    GlassyModulus,
    /// τ, the creep time.
    RetardationTime,
    /// τ_r = τ E0/E∞.
    RelaxationTime,
    /// ν.
    PoissonRatio,
    /// R.
    Radius,
    /// τ0.
    ShearStrength,
    /// ξ_x.
    DampingX,
    /// ξ_y.
    DampingY,
    /// Ω.
    FrequencyRatio,
    /// η.
    Coupling,
    /// α.
    CouplingAngle,
    /// ω_nx.
    NaturalFrequency,
    /// k_x.
    StiffnessX,
    /// v_d.
    Velocity,
    /// F_n.
    NormalLoad,
}

/// The number of numeric keys.
pub const KEY_COUNT: usize = 16;

impl OscillatorKey {
    /// The entry of this key in the table.
    pub fn entry(self) -> &'static Key<Self> {
        &KEYS[self as usize]
    }

    /// The key of a dotted path such as `operation.velocity`.
    pub fn from_path(path: &str) -> Option<Self> {
        KEYS.iter().find(|entry| entry.path == path).map(|entry| entry.key)
    }
}

impl fmt::Display for OscillatorKey {
    /// The dotted path.
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(self.entry().path)
    }
}

/// Every numeric key of an oscillator case, in the order of the case file. The defaults are the oscillator paper's.
pub static KEYS: [Key<OscillatorKey>; KEY_COUNT] = [
    quantity(
        OscillatorKey::RubberyModulus,
        "substrate.rubbery_modulus",
        "E0",
        Dimension::STRESS,
        ("1 MPa", 1e6),
        "modulus of the substrate under slow loading",
    )
    .typically(1e4, 1e8),
    quantity(
        OscillatorKey::GlassyModulus,
        "substrate.glassy_modulus",
        "E∞",
        Dimension::STRESS,
        ("10 MPa", 1e7),
        "modulus of the substrate under fast loading, above the rubbery modulus",
    )
    .typically(1e5, 1e10),
    quantity(
        OscillatorKey::RetardationTime,
        "substrate.retardation_time",
        "τ",
        Dimension::TIME,
        ("10 ms", 0.01),
        "creep time of the substrate, the paper's τ",
    )
    .typically(1e-6, 10.0),
    Key {
        default: None,
        ..quantity(
            OscillatorKey::RelaxationTime,
            "substrate.relaxation_time",
            "τ_r",
            Dimension::TIME,
            ("", 0.0),
            "relaxation time of the substrate, τ E0/E∞; in place of retardation_time",
        )
        .typically(1e-6, 10.0)
    },
    number(
        OscillatorKey::PoissonRatio,
        "substrate.poisson_ratio",
        "ν",
        Range::Interval { above: -1.0, up_to: 0.5 },
        ("0.5", 0.5),
        "Poisson ratio of the substrate",
    )
    .typically(0.0, 0.5),
    quantity(
        OscillatorKey::Radius,
        "indenter.radius",
        "R",
        Dimension::LENGTH,
        ("10 mm", 0.01),
        "radius of the indenter",
    )
    .typically(1e-5, 1.0),
    Key {
        dimension: Dimension::STRESS,
        group: Some("τ0/E0*"),
        ..number(
            OscillatorKey::ShearStrength,
            "contact.shear_strength",
            "τ0",
            Range::NonNegative,
            ("0.01", 0.01),
            "interfacial shear strength",
        )
        .typically(1e-4, 1.0)
    },
    number(
        OscillatorKey::DampingX,
        "oscillator.damping_x",
        "ξ_x",
        Range::NonNegative,
        ("0.01", 0.01),
        "damping ratio along the sliding direction",
    )
    .typically(0.0, 0.2),
    number(
        OscillatorKey::DampingY,
        "oscillator.damping_y",
        "ξ_y",
        Range::NonNegative,
        ("0.01", 0.01),
        "damping ratio normal to the surface",
    )
    .typically(0.0, 0.2),
    number(
        OscillatorKey::FrequencyRatio,
        "oscillator.frequency_ratio",
        "Ω",
        Range::Positive,
        ("1.0", 1.0),
        "normal over tangential natural frequency, ω_ny/ω_nx",
    )
    .typically(0.1, 10.0),
    number(
        OscillatorKey::Coupling,
        "oscillator.coupling",
        "η",
        Range::NonNegative,
        ("1.0", 1.0),
        "coupling frequency ratio, ω_nxy/ω_nx; η² is k_xy/k_x",
    )
    .typically(0.0, 2.0),
    Key {
        range: Range::Any,
        ..quantity(
            OscillatorKey::CouplingAngle,
            "oscillator.coupling_angle",
            "α",
            Dimension::ANGLE,
            ("45 deg", std::f64::consts::FRAC_PI_4),
            "inclination of the oblique spring",
        )
        .typically(0.0, std::f64::consts::FRAC_PI_2)
    },
    quantity(
        OscillatorKey::NaturalFrequency,
        "oscillator.natural_frequency",
        "ω_nx",
        Dimension::ANGULAR_FREQUENCY,
        ("40 rad/s", 40.0),
        "tangential natural frequency; 1 Hz is 2π rad/s",
    )
    .typically(1.0, 1e5),
    quantity(
        OscillatorKey::StiffnessX,
        "oscillator.stiffness_x",
        "k_x",
        Dimension::STIFFNESS,
        ("50 N/m", 50.0),
        "tangential stiffness",
    )
    .typically(1e-1, 1e7),
    Key {
        dimension: Dimension::SPEED,
        group: Some("v_d τ/R"),
        ..number(
            OscillatorKey::Velocity,
            "operation.velocity",
            "v_d",
            Range::Positive,
            ("1e-4", 1e-4),
            "driving speed",
        )
        .typically(1e-8, 1e2)
    },
    Key {
        dimension: Dimension::FORCE,
        group: Some("F_n/(E0* R²)"),
        ..number(
            OscillatorKey::NormalLoad,
            "operation.normal_load",
            "F_n",
            Range::Positive,
            ("1e-6", 1e-6),
            "normal load",
        )
        .typically(1e-9, 1e-2)
    },
];

#[cfg(test)]
mod tests {
    use super::*;
    use judder_keys::numeric_key::Form;
    use judder_keys::quantity::Quantity;

    #[test]
    fn axes_are_labelled_in_both_forms() {
        let velocity = OscillatorKey::Velocity.entry();
        assert_eq!(
            (velocity.label(Form::Group).as_str(), velocity.label(Form::Si).as_str()),
            ("v_d τ/R", "v_d (m/s)")
        );
        assert_eq!(OscillatorKey::DampingX.entry().label(Form::Group), "ξ_x");
    }

    #[test]
    fn every_key_stands_at_its_index_and_its_default_reads_as_stated() {
        for (index, entry) in KEYS.iter().enumerate() {
            assert_eq!(entry.key as usize, index, "{}", entry.path);
            assert_eq!(OscillatorKey::from_path(entry.path), Some(entry.key));
            let Some((text, value)) = entry.default else { continue };
            let quantity = Quantity::parse(text).unwrap();
            assert_eq!(quantity.number, value.number, "{}", entry.path);
            assert!(entry.range.contains(value.number), "{}", entry.path);
            let expected = if value.form == Form::Si { entry.dimension } else { Dimension::NUMBER };
            assert_eq!(quantity.dimension, expected, "{}", entry.path);
        }
    }
}
