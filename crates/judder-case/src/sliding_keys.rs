//! The numbers of a sliding case beside those of its structures, each with dimension, range and default.

use std::fmt;

use crate::dimension::Dimension;
use crate::keys::{Key, Range, number, quantity};

/// A number of a sliding case; its position in [`SLIDING_KEYS`] is `key as usize`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum SlidingKey {
    /// μ.
    FrictionCoefficient,
    /// v of a table of friction.
    FrictionSpeed,
    /// μ of a table of friction.
    FrictionAtSpeed,
    /// g_0.
    InitialGap,
    /// s_0.
    Start,
    /// s_1.
    End,
    /// v_x.
    Velocity,
    /// F_y.
    LoadForce,
    /// Time over which the velocity rises.
    VelocityRamp,
    /// Time over which the load rises.
    LoadRamp,
    /// Time over which friction rises.
    FrictionRamp,
    /// Time over which the initial gap closes.
    GapRamp,
    /// α_0.
    InitialMassProportional,
    /// β_0.
    InitialStiffnessProportional,
    /// Time for which the initial damping holds.
    InitialHold,
    /// Time over which it gives way.
    InitialRelease,
    /// Root mean square of the noise.
    NoiseForce,
    /// s at which a key is swept.
    At,
    /// An end of a range of positions.
    PositionsFrom,
    /// The other end of it.
    PositionsTo,
    /// s at which a march begins.
    From,
    /// s at which it ends.
    To,
    /// h.
    Step,
    /// ω above which modes are replaced by their flexibility.
    CutOff,
    /// ω up to which signals are kept.
    PassBand,
    /// Samples of signals per time.
    SampleRate,
    /// Of the window of a spectrogram.
    WindowLength,
    /// Share of a window that the next one has too.
    Overlap,
    /// x, y of an observed point.
    PointAt,
}

impl SlidingKey {
    /// The entry of this key in the table.
    pub fn entry(self) -> &'static Key<Self> {
        &SLIDING_KEYS[self as usize]
    }
}

impl fmt::Display for SlidingKey {
    /// The dotted path.
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(self.entry().path)
    }
}

/// A quantity with a default, of another range than the positive numbers.
const fn ranged(range: Range, entry: Key<SlidingKey>) -> Key<SlidingKey> {
    Key { range, ..entry }
}

/// An entry without a default: what stands for it is said in its doc.
const fn open(entry: Key<SlidingKey>) -> Key<SlidingKey> {
    Key { default: None, ..entry }
}

const LENGTH: Dimension = Dimension::LENGTH;
const TIME: Dimension = Dimension::TIME;
const FREQUENCY: Dimension = Dimension::ANGULAR_FREQUENCY;
const ZERO_OR_MORE: Range = Range::NonNegative;
/// 1 Hz in rad/s.
const HERTZ: f64 = std::f64::consts::TAU;

/// A position along the track.
const fn position(
    key: SlidingKey,
    path: &'static str,
    symbol: &'static str,
    doc: &'static str,
) -> Key<SlidingKey> {
    ranged(ZERO_OR_MORE, open(quantity(key, path, symbol, LENGTH, ("", 0.0), doc)))
}

/// A time of a ramp.
const fn ramp(key: SlidingKey, path: &'static str, doc: &'static str) -> Key<SlidingKey> {
    ranged(ZERO_OR_MORE, quantity(key, path, "T", TIME, ("0.1 s", 0.1), doc))
}

/// Every number of a sliding case, in the order of the case file. The defaults are those of the beams paper, or the readings of what
/// it does not print.
pub static SLIDING_KEYS: [Key<SlidingKey>; 29] = [
    number(
        SlidingKey::FrictionCoefficient,
        "contact.friction_coefficient",
        "μ",
        ZERO_OR_MORE,
        ("0.3", 0.3),
        "friction coefficient, or a table against the sliding speed",
    ),
    ranged(
        ZERO_OR_MORE,
        open(quantity(
            SlidingKey::FrictionSpeed,
            "contact.friction_coefficient.velocity",
            "v",
            Dimension::SPEED,
            ("", 0.0),
            "sliding speeds of the table, ascending, in a list",
        )),
    ),
    open(number(
        SlidingKey::FrictionAtSpeed,
        "contact.friction_coefficient.coefficient",
        "μ(v)",
        ZERO_OR_MORE,
        ("", 0.0),
        "friction coefficients there, linear between the speeds and constant beyond them, in a list",
    )),
    ranged(
        Range::Any,
        quantity(
            SlidingKey::InitialGap,
            "contact.initial_gap",
            "g_0",
            LENGTH,
            ("0 m", 0.0),
            "gap between the undeformed structures at the start; below zero a penetration",
        ),
    ),
    ranged(
        ZERO_OR_MORE,
        quantity(
            SlidingKey::Start,
            "motion.start",
            "s_0",
            LENGTH,
            ("10 mm", 0.01),
            "rigid distance of C from the first node of the track when the motion starts",
        ),
    ),
    ranged(
        ZERO_OR_MORE,
        quantity(SlidingKey::End, "motion.end", "s_1", LENGTH, ("98.5 mm", 0.0985), "where it ends"),
    ),
    ranged(
        Range::Any,
        quantity(
            SlidingKey::Velocity,
            "motion.velocity",
            "v_x",
            Dimension::SPEED,
            ("30 mm/s", 0.03),
            "velocity of the slider along the track; below zero towards the first node",
        ),
    ),
    ranged(
        Range::Any,
        quantity(
            SlidingKey::LoadForce,
            "motion.load.force",
            "F_y",
            Dimension::FORCE,
            ("-0.2 N", -0.2),
            "force on the slider",
        ),
    ),
    ramp(SlidingKey::VelocityRamp, "motion.ramps.velocity", "time over which the velocity rises from zero"),
    ramp(SlidingKey::LoadRamp, "motion.ramps.load", "time over which the load rises from zero"),
    ramp(SlidingKey::FrictionRamp, "motion.ramps.friction", "time over which friction rises from zero"),
    ramp(SlidingKey::GapRamp, "motion.ramps.gap", "time over which the initial gap closes"),
    ranged(
        ZERO_OR_MORE,
        quantity(
            SlidingKey::InitialMassProportional,
            "motion.initial_damping.alpha",
            "α_0",
            Dimension::RATE,
            ("40 1/s", 40.0),
            "damping of both structures in proportion to their mass at the start",
        ),
    ),
    ranged(
        ZERO_OR_MORE,
        quantity(
            SlidingKey::InitialStiffnessProportional,
            "motion.initial_damping.beta",
            "β_0",
            TIME,
            ("4e-8 s", 4e-8),
            "damping of both structures in proportion to their stiffness at the start",
        ),
    ),
    ranged(
        ZERO_OR_MORE,
        quantity(
            SlidingKey::InitialHold,
            "motion.initial_damping.hold",
            "T",
            TIME,
            ("0.2 s", 0.2),
            "time for which it holds",
        ),
    ),
    ranged(
        ZERO_OR_MORE,
        quantity(
            SlidingKey::InitialRelease,
            "motion.initial_damping.release",
            "T",
            TIME,
            ("0.05 s", 0.05),
            "time over which it then gives way to the structures' own",
        ),
    ),
    ranged(
        ZERO_OR_MORE,
        quantity(
            SlidingKey::NoiseForce,
            "motion.noise.force",
            "f_rms",
            Dimension::FORCE,
            ("0 N", 0.0),
            "root mean square of a random force on C across the track",
        ),
    ),
    position(SlidingKey::At, "analysis.at", "s", "of a `locus`: where the contact is while a key is swept"),
    position(
        SlidingKey::PositionsFrom,
        "analysis.positions.from",
        "s",
        "of a `locus`: the first position; that of the motion where left out",
    ),
    position(
        SlidingKey::PositionsTo,
        "analysis.positions.to",
        "s",
        "of a `locus`: the last position; that of the motion where left out",
    ),
    position(
        SlidingKey::From,
        "analysis.from",
        "s",
        "of a `march`: where it begins; `motion.start` where left out",
    ),
    position(SlidingKey::To, "analysis.to", "s", "of a `march`: where it ends; `motion.end` where left out"),
    open(quantity(
        SlidingKey::Step,
        "analysis.step",
        "h",
        TIME,
        ("", 0.0),
        "time step; where left out, 3e-7 s or 0.9 of the limit of stability, of `residual-flexibility` 3e-6 s or 0.75 of it, whichever is smaller",
    )),
    quantity(
        SlidingKey::CutOff,
        "analysis.cut_off",
        "ω_c",
        FREQUENCY,
        ("60 kHz", 60e3 * HERTZ),
        "of `residual-flexibility`: modes above are replaced by their flexibility",
    ),
    quantity(
        SlidingKey::PassBand,
        "analysis.signals.pass_band",
        "ω",
        FREQUENCY,
        ("50 kHz", 50e3 * HERTZ),
        "up to which sampled signals are kept as they are",
    ),
    quantity(
        SlidingKey::SampleRate,
        "analysis.signals.sample_rate",
        "2π f_s",
        FREQUENCY,
        ("400 kHz", 400e3 * HERTZ),
        "samples per time at least: the steps between samples are a whole number; every step where steps are longer",
    ),
    quantity(
        SlidingKey::WindowLength,
        "analysis.length",
        "T",
        TIME,
        ("5 ms", 5e-3),
        "of a `spectrogram`: length of its window",
    ),
    number(
        SlidingKey::Overlap,
        "analysis.overlap",
        "o",
        Range::Fraction,
        ("0.75", 0.75),
        "of a `spectrogram`: share of a window that the next one has too",
    ),
    ranged(
        Range::Any,
        open(quantity(
            SlidingKey::PointAt,
            "observe.points.at",
            "x, y",
            LENGTH,
            ("", 0.0),
            "of a point: where it lies in the undeformed structure, in a list; the nearest node is taken",
        )),
    ),
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quantity::Quantity;

    #[test]
    fn every_key_stands_at_its_index_and_its_default_reads_as_stated() {
        for (index, entry) in SLIDING_KEYS.iter().enumerate() {
            assert_eq!(entry.key as usize, index, "{}", entry.path);
            let Some((text, value)) = entry.default else { continue };
            let quantity = Quantity::parse(text).unwrap();
            assert!((quantity.number - value.number).abs() <= 1e-15 * value.number.abs(), "{}", entry.path);
            assert!(entry.range.contains(value.number), "{}", entry.path);
            assert_eq!(quantity.dimension, entry.dimension, "{}", entry.path);
        }
    }
}
