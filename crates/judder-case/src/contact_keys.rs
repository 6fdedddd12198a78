//! The numbers of a contact case beside those that it shares with an oscillator case, each with dimension, group and range.

use crate::dimension::Dimension;
use crate::keys::{Key, Range, number, quantity};

/// A number of a contact case that no sweep varies; its position in [`CONTACT_KEYS`] is `key as usize`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum ContactKey {
    /// τ_k of a creep term.
    PronyTime,
    /// C_k of a creep term.
    PronyCompliance,
    /// ρ_j of a term of the relaxation modulus.
    RelaxationTime,
    /// E_j of a term of the relaxation modulus.
    RelaxationModulus,
    /// Median of a log-normal spectrum.
    SpectrumMedian,
    /// Its standard deviation in decades.
    SpectrumWidth,
    /// Shortest time of a power-law spectrum.
    SpectrumFrom,
    /// Its longest time.
    SpectrumTo,
    /// The exponent of its compliance.
    SpectrumExponent,
    /// τ of a sample of a spectrum.
    SampleTime,
    /// 𝒞 of a sample of a spectrum.
    SampleDensity,
    /// Relative error that taking a spectrum apart may make.
    SpectrumAccuracy,
    /// T.
    Temperature,
    /// C1 of the WLF shift.
    WlfFirst,
    /// C2 of the WLF shift.
    WlfSecond,
    /// T_ref of the WLF shift.
    WlfReference,
    /// E_a of the Arrhenius shift.
    ActivationEnergy,
    /// T_ref of the Arrhenius shift.
    ArrheniusReference,
    /// Distance of neighbouring heights of a height map.
    Spacing,
    /// The length that a height of 1 in a height map stands for.
    HeightUnit,
    /// Side of a rough surface.
    Period,
    /// Hurst exponent.
    Hurst,
    /// Longest wave of the self-affine part.
    RollOff,
    /// Shortest wave.
    CutOff,
    /// Root mean square of the heights.
    RmsHeight,
    /// Root mean square of the slope.
    RmsSlope,
    /// v.
    Velocity,
    /// δ.
    Indentation,
    /// F.
    Load,
    /// Relative accuracy of the force.
    Accuracy,
    /// Side of the computed square.
    Domain,
    /// ω.
    Frequency,
    /// Factor of v̂ at which fits are read.
    VelocityScale,
    /// Amplitude of an oscillation.
    Amplitude,
    /// t.
    Duration,
}

/// The number of these keys.
pub const CONTACT_KEY_COUNT: usize = 35;

impl ContactKey {
    /// The entry of this key in the table.
    pub fn entry(self) -> &'static Key<Self> {
        static TABLE: [Key<ContactKey>; CONTACT_KEY_COUNT] = CONTACT_KEYS;
        &TABLE[self as usize]
    }
}

/// An entry that must be given where its table is, as a quantity with a unit.
const fn given(
    key: ContactKey,
    path: &'static str,
    symbol: &'static str,
    dimension: Dimension,
    doc: &'static str,
) -> Key<ContactKey> {
    Key { default: None, ..quantity(key, path, symbol, dimension, ("", 0.0), doc) }
}

/// An entry that must be given where its table is, as a pure number.
const fn pure(
    key: ContactKey,
    path: &'static str,
    symbol: &'static str,
    range: Range,
    doc: &'static str,
) -> Key<ContactKey> {
    Key { default: None, ..number(key, path, symbol, range, ("", 0.0), doc) }
}

/// An entry of an analysis that takes a group, or a quantity with a unit.
const fn either(
    key: ContactKey,
    path: &'static str,
    (symbol, group): (&'static str, &'static str),
    dimension: Dimension,
    doc: &'static str,
) -> Key<ContactKey> {
    Key { group: Some(group), ..given(key, path, symbol, dimension, doc) }
}

/// Every number of a contact case beside substrate and radius, in the order of the case file.
pub const CONTACT_KEYS: [Key<ContactKey>; CONTACT_KEY_COUNT] = [
    given(
        ContactKey::PronyTime,
        "substrate.prony.time",
        "τ_k",
        Dimension::TIME,
        "retardation (creep) time of a term",
    ),
    given(
        ContactKey::PronyCompliance,
        "substrate.prony.compliance",
        "C_k",
        Dimension::COMPLIANCE,
        "creep compliance of a term",
    ),
    given(
        ContactKey::RelaxationTime,
        "substrate.relaxation.time",
        "ρ_j",
        Dimension::TIME,
        "relaxation time of a term",
    ),
    given(
        ContactKey::RelaxationModulus,
        "substrate.relaxation.modulus",
        "E_j",
        Dimension::STRESS,
        "modulus of a term",
    ),
    given(
        ContactKey::SpectrumMedian,
        "substrate.continuous.log_normal.median",
        "τ_m",
        Dimension::TIME,
        "median of the retardation times",
    ),
    pure(
        ContactKey::SpectrumWidth,
        "substrate.continuous.log_normal.width",
        "w",
        Range::Interval { above: 0.0, up_to: 10.0 },
        "standard deviation in decades of time",
    ),
    given(
        ContactKey::SpectrumFrom,
        "substrate.continuous.power_law.from",
        "τ_1",
        Dimension::TIME,
        "shortest retardation time",
    ),
    given(
        ContactKey::SpectrumTo,
        "substrate.continuous.power_law.to",
        "τ_2",
        Dimension::TIME,
        "longest retardation time",
    ),
    pure(
        ContactKey::SpectrumExponent,
        "substrate.continuous.power_law.exponent",
        "m",
        Range::Any,
        "exponent of the compliance, which grows as t^m; at 0 the spectrum is even in ln τ",
    ),
    given(
        ContactKey::SampleTime,
        "substrate.continuous.samples.time",
        "τ",
        Dimension::TIME,
        "retardation time of a sample",
    ),
    Key {
        range: Range::NonNegative,
        ..given(
            ContactKey::SampleDensity,
            "substrate.continuous.samples.density",
            "𝒞",
            Dimension::COMPLIANCE_RATE,
            "spectrum at this time",
        )
    },
    number(
        ContactKey::SpectrumAccuracy,
        "substrate.continuous.accuracy",
        "ε",
        Range::Interval { above: 0.0, up_to: 0.2 },
        ("1e-3", 1e-3),
        "relative error of E(ω) that the terms may make at any frequency; or give `terms`",
    ),
    given(
        ContactKey::Temperature,
        "substrate.temperature",
        "T",
        Dimension::TEMPERATURE,
        "temperature of the substrate; needs `shift`",
    ),
    pure(
        ContactKey::WlfFirst,
        "substrate.shift.wlf.c1",
        "C1",
        Range::Positive,
        "first constant of the WLF shift",
    ),
    Key {
        difference: true,
        ..given(
            ContactKey::WlfSecond,
            "substrate.shift.wlf.c2",
            "C2",
            Dimension::TEMPERATURE,
            "second constant of the WLF shift, a difference of temperatures in K",
        )
    },
    given(
        ContactKey::WlfReference,
        "substrate.shift.wlf.reference_temperature",
        "T_ref",
        Dimension::TEMPERATURE,
        "temperature at which the times are as given",
    ),
    given(
        ContactKey::ActivationEnergy,
        "substrate.shift.arrhenius.activation_energy",
        "E_a",
        Dimension::MOLAR_ENERGY,
        "activation energy of the Arrhenius shift",
    ),
    given(
        ContactKey::ArrheniusReference,
        "substrate.shift.arrhenius.reference_temperature",
        "T_ref",
        Dimension::TEMPERATURE,
        "temperature at which the times are as given",
    ),
    given(
        ContactKey::Spacing,
        "indenter.shape.spacing",
        "h",
        Dimension::LENGTH,
        "distance of neighbouring heights; may be left out where the file has coordinates",
    ),
    Key {
        default: Some(("1 m", crate::keys::Value::si(1.0))),
        ..given(
            ContactKey::HeightUnit,
            "indenter.shape.unit",
            "",
            Dimension::LENGTH,
            "the length that a height of 1 in the file stands for",
        )
    },
    given(
        ContactKey::Period,
        "indenter.shape.rough.period",
        "L",
        Dimension::LENGTH,
        "side of the periodic square",
    ),
    pure(
        ContactKey::Hurst,
        "indenter.shape.rough.hurst",
        "H",
        Range::Interval { above: 0.0, up_to: 1.0 },
        "Hurst exponent of the self-affine part",
    ),
    given(
        ContactKey::RollOff,
        "indenter.shape.rough.roll_off",
        "λ_r",
        Dimension::LENGTH,
        "longest wave of the self-affine part; the period by default",
    ),
    given(
        ContactKey::CutOff,
        "indenter.shape.rough.cut_off",
        "λ_s",
        Dimension::LENGTH,
        "shortest wave; four cells by default",
    ),
    given(
        ContactKey::RmsHeight,
        "indenter.shape.rough.rms_height",
        "h_rms",
        Dimension::LENGTH,
        "root mean square of the heights; or give `rms_slope`",
    ),
    pure(
        ContactKey::RmsSlope,
        "indenter.shape.rough.rms_slope",
        "g_rms",
        Range::Positive,
        "root mean square of the slope",
    ),
    Key {
        range: Range::NonNegative,
        ..either(ContactKey::Velocity, "analysis.velocity", ("v", "v τ/R"), Dimension::SPEED, "sliding speed")
    },
    either(ContactKey::Indentation, "analysis.indentation", ("δ", "δ/R"), Dimension::LENGTH, "indentation"),
    either(
        ContactKey::Load,
        "analysis.load",
        ("F", "F/(E0* R²)"),
        Dimension::FORCE,
        "normal load, in place of the indentation; of a cylinder per length, F/(E0* R)",
    ),
    number(
        ContactKey::Accuracy,
        "analysis.accuracy",
        "ε",
        Range::Interval { above: 0.0, up_to: 0.2 },
        ("1e-3", 1e-3),
        "relative accuracy of the force; area and friction may be five times as far off",
    ),
    either(
        ContactKey::Domain,
        "analysis.domain",
        ("L", "L/R"),
        Dimension::LENGTH,
        "side of the computed square; chosen from the accuracy by default",
    ),
    either(
        ContactKey::Frequency,
        "analysis.frequency",
        ("ω", "ω τ"),
        Dimension::ANGULAR_FREQUENCY,
        "angular frequency",
    ),
    number(
        ContactKey::VelocityScale,
        "analysis.velocity_scale",
        "s",
        Range::Positive,
        ("0.01", 0.01),
        "factor of v τ/R at which the fits are read",
    ),
    either(
        ContactKey::Amplitude,
        "analysis.amplitude",
        ("a", "a/R"),
        Dimension::LENGTH,
        "amplitude of a reciprocation or an oscillation",
    ),
    either(ContactKey::Duration, "analysis.duration", ("t", "t/τ"), Dimension::TIME, "end of a transient"),
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::keys::Form;
    use crate::quantity::Quantity;

    #[test]
    fn every_key_stands_at_its_index_and_its_default_reads_as_stated() {
        for (index, entry) in CONTACT_KEYS.iter().enumerate() {
            assert_eq!(entry.key as usize, index, "{}", entry.path);
            let Some((text, value)) = entry.default else { continue };
            let quantity = Quantity::parse(text).unwrap();
            assert_eq!(quantity.number, value.number, "{}", entry.path);
            assert!(entry.range.contains(value.number), "{}", entry.path);
            let expected = if value.form == Form::Si { entry.dimension } else { Dimension::NUMBER };
            assert_eq!(quantity.dimension, expected, "{}", entry.path);
        }
    }
}
