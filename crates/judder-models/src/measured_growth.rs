//! Growth that a march shows: which mode is meant, and how its growth is held against its eigenvalue.

use crate::told_quantities::ToldQuantity;
use judder_study::outcome::CheckRecord;
use num_complex::Complex64;
use std::f64::consts::TAU;

/// What measured and predicted growth may differ by.
const GROWTH_LIMIT: f64 = 1e-2;
/// What their frequencies may differ by: a march of three steps a radian is off by (ω h)²/24.
const FREQUENCY_LIMIT: f64 = 1e-3;
/// Eigenvalues so near the asked frequency, as a share of it, may be meant: of two that are coupled the growing one is.
const NEAR: f64 = 1e-2;
/// Up to which multiple of the asked frequency eigenvalues are sought.
pub(crate) const SOUGHT: f64 = 1.5;
/// An eigenvalue farther from the asked frequency, as a share of it, is not the one that is meant.
pub(crate) const FAR: f64 = 0.5;
/// One farther than this is meant, but worth a word.
const OFF: f64 = 0.03;

/// What the table of a growth tells, of any model that marches.
pub(crate) const TOLD: &[ToldQuantity] = &[
    ("measured", "growth rate in the march", "1/s"),
    ("predicted", "growth rate of the eigenvalue", "1/s"),
    ("spread", "how much it differs from half to half", "1/s"),
    ("measured_frequency_hz", "frequency in the march", "Hz"),
    ("frequency_hz", "frequency of the eigenvalue", "Hz"),
    ("position_m", "where the contact is held", "m"),
    ("normal_force", "normal force there, at rest", "N"),
    ("method", "marched by", ""),
    ("steps", "steps", ""),
    ("step_s", "step", "s"),
];

/// The mode that a frequency means, by its place in a list.
pub(crate) enum MeantMode {
    /// It is near enough.
    Found(usize),
    /// It is the nearest, and not meant.
    TooFar(usize),
}

/// The eigenvalue that is meant by a frequency in rad/s: of those near it the one that grows fastest, else the nearest; none of an empty list.
pub(crate) fn near(all: &[Complex64], frequency: f64) -> Option<MeantMode> {
    let away = |k: &usize| (all[*k].im - frequency).abs();
    let close = (0..all.len()).filter(|k| away(k) <= NEAR * frequency);
    let fastest = close.max_by(|a, b| all[*a].re.total_cmp(&all[*b].re));
    let nearest = (0..all.len()).min_by(|a, b| away(a).total_cmp(&away(b)));
    let found = fastest.or(nearest)?;
    Some(if away(&found) <= FAR * frequency { MeantMode::Found(found) } else { MeantMode::TooFar(found) })
}

/// What there is to say of a mode that swings otherwise than was asked, rad/s.
pub(crate) fn far_off(frequency: f64, asked: f64) -> Option<String> {
    let (hz, off) = (frequency / TAU, 100.0 * (frequency / asked - 1.0));
    (off.abs() > 100.0 * OFF)
        .then(|| format!("the mode nearest to the frequency asked for swings at {hz:.1} Hz, {off:.1} % off"))
}

/// Growth rate and frequency in the march against those of the eigenvalue, in 1/s.
pub(crate) fn checks(method: &str, measured: Complex64, predicted: Complex64) -> Vec<CheckRecord> {
    let compared = format!("{method} against {:.6} 1/s at {:.4} Hz", predicted.re, predicted.im / TAU);
    vec![
        CheckRecord::new(
            "the march grows as the eigenvalue says",
            format!("relative difference of growth rates, {compared}"),
            ((measured.re - predicted.re) / predicted.re).abs().into(),
            GROWTH_LIMIT,
        ),
        CheckRecord::new(
            "the march swings as the eigenvalue says",
            format!("relative difference of frequencies, {compared}"),
            ((measured.im - predicted.im) / predicted.im).abs().into(),
            FREQUENCY_LIMIT,
        ),
    ]
}
