//! The numbers of a structure case, each with dimension and range.

use std::fmt;

use crate::dimension::Dimension;
use crate::keys::{Key, Range, number, quantity};

/// A number of a structure case; its position in [`STRUCTURE_KEYS`] is `key as usize`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum StructureKey {
    /// From end to end of a beam.
    BeamLength,
    /// Of a beam in its plane.
    BeamThickness,
    /// From the x-axis to the beam's own.
    BeamAngle,
    /// Where the middle of a beam's start lies.
    BeamOrigin,
    /// A side of a block.
    BlockSize,
    /// Of a body of the plane across its plane.
    Width,
    /// E.
    YoungsModulus,
    /// ν.
    PoissonRatio,
    /// ρ.
    Density,
    /// α.
    MassProportional,
    /// β.
    StiffnessProportional,
    /// ω at which a ratio is given.
    RatioFrequency,
    /// ζ.
    Ratio,
    /// η.
    LossFactor,
    /// ω at which structural damping is met.
    ReferenceFrequency,
    /// ω above which fixed-interface modes are left out.
    CutOff,
    /// An end of a band of frequencies.
    Band,
    /// Error that the projected method may have.
    Tolerance,
}

impl StructureKey {
    /// The entry of this key in the table.
    pub fn entry(self) -> &'static Key<Self> {
        &STRUCTURE_KEYS[self as usize]
    }
}

impl fmt::Display for StructureKey {
    /// The dotted path.
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(self.entry().path)
    }
}

/// An entry that must be given where its table is, as a quantity with a unit.
const fn given(
    key: StructureKey,
    path: &'static str,
    symbol: &'static str,
    (dimension, range): (Dimension, Range),
    doc: &'static str,
) -> Key<StructureKey> {
    Key { default: None, range, ..quantity(key, path, symbol, dimension, ("", 0.0), doc) }
}

/// An entry that must be given where its table is, as a pure number.
const fn pure(
    key: StructureKey,
    path: &'static str,
    symbol: &'static str,
    range: Range,
    doc: &'static str,
) -> Key<StructureKey> {
    Key { default: None, ..number(key, path, symbol, range, ("", 0.0), doc) }
}

const LENGTH: (Dimension, Range) = (Dimension::LENGTH, Range::Positive);
const FREQUENCY: (Dimension, Range) = (Dimension::ANGULAR_FREQUENCY, Range::Positive);

/// Every number of a structure case, in the order of the case file.
pub static STRUCTURE_KEYS: [Key<StructureKey>; 18] = [
    given(StructureKey::BeamLength, "structure.beam.length", "l", LENGTH, "length of a beam"),
    given(
        StructureKey::BeamThickness,
        "structure.beam.thickness",
        "b",
        LENGTH,
        "thickness of a beam in its plane",
    ),
    Key {
        range: Range::Any,
        ..quantity(
            StructureKey::BeamAngle,
            "structure.beam.angle",
            "ϑ",
            Dimension::ANGLE,
            ("0 deg", 0.0),
            "from the x-axis to the axis of a beam, counter-clockwise",
        )
    },
    Key {
        range: Range::Any,
        ..quantity(
            StructureKey::BeamOrigin,
            "structure.beam.origin",
            "x, y",
            Dimension::LENGTH,
            ("0 m", 0.0),
            "where the middle of a beam's start lies, two lengths in a list",
        )
    },
    given(
        StructureKey::BlockSize,
        "structure.block.size",
        "l_x, l_y, l_z",
        LENGTH,
        "lengths of a block, two or three in a list",
    ),
    given(
        StructureKey::Width,
        "structure.width",
        "a",
        LENGTH,
        "width of a body of the plane across its plane",
    ),
    given(
        StructureKey::YoungsModulus,
        "structure.material.youngs_modulus",
        "E",
        (Dimension::STRESS, Range::Positive),
        "Young's modulus",
    ),
    pure(
        StructureKey::PoissonRatio,
        "structure.material.poisson_ratio",
        "ν",
        Range::Interval { above: -1.0, up_to: 0.499_999 },
        "Poisson's ratio",
    ),
    given(
        StructureKey::Density,
        "structure.material.density",
        "ρ",
        (Dimension::DENSITY, Range::Positive),
        "density",
    ),
    Key {
        range: Range::NonNegative,
        ..quantity(
            StructureKey::MassProportional,
            "damping.rayleigh.alpha",
            "α",
            Dimension::RATE,
            ("0 1/s", 0.0),
            "damping in proportion to the mass, C = α M + β K",
        )
    },
    Key {
        range: Range::NonNegative,
        ..quantity(
            StructureKey::StiffnessProportional,
            "damping.rayleigh.beta",
            "β",
            Dimension::TIME,
            ("0 s", 0.0),
            "damping in proportion to the stiffness",
        )
    },
    given(
        StructureKey::RatioFrequency,
        "damping.rayleigh.ratios.frequency",
        "ω_k",
        FREQUENCY,
        "frequency at which a damping ratio is given, in place of α and β",
    ),
    pure(
        StructureKey::Ratio,
        "damping.rayleigh.ratios.ratio",
        "ζ_k",
        Range::NonNegative,
        "the damping ratio there, ζ = α/(2ω) + βω/2",
    ),
    pure(
        StructureKey::LossFactor,
        "damping.structural.loss_factor",
        "η",
        Range::NonNegative,
        "loss factor of structural damping, met by C = η K/ω_r at one frequency",
    ),
    given(
        StructureKey::ReferenceFrequency,
        "damping.structural.reference_frequency",
        "ω_r",
        FREQUENCY,
        "frequency at which it is met",
    ),
    given(
        StructureKey::CutOff,
        "reduction.cut_off",
        "ω_c",
        FREQUENCY,
        "fixed-interface modes up to this frequency are kept",
    ),
    given(
        StructureKey::Band,
        "analysis.band",
        "ω",
        (Dimension::ANGULAR_FREQUENCY, Range::NonNegative),
        "the ends of a band of frequencies, two in a list",
    ),
    number(
        StructureKey::Tolerance,
        "analysis.tolerance",
        "ε",
        Range::Interval { above: 0.0, up_to: 0.1 },
        ("1e-6", 1e-6),
        "relative error that the method `projected` may leave",
    ),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_key_stands_at_its_index_and_its_default_is_in_range() {
        for (index, entry) in STRUCTURE_KEYS.iter().enumerate() {
            assert_eq!(entry.key as usize, index, "{}", entry.path);
            assert!(
                entry.default.is_none_or(|(_, value)| entry.range.contains(value.number)),
                "{}",
                entry.path
            );
        }
    }
}
