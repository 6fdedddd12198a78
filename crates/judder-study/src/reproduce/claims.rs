//! The numbers and claims of the oscillator paper, each with the way it is measured: sections 2–5 here, the motions of section 5 in
//! [`motion`], the contact computation in [`contact`].

pub(super) mod contact;
mod damping;
mod equations;
mod maps;
pub(super) mod motion;
mod thresholds;

use super::scoreboard::Measured;
use judder_oscillator::Contact;

/// What kind of line a claim is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    /// It agrees where we find what the paper says.
    Statement,
    /// The print is wrong and the right value known; the measurement shows the right value.
    Misprint,
}

/// A claim of the paper, and what it is measured on.
pub(super) struct Claim<T = Contact> {
    pub(super) place: &'static str,
    pub(super) says: &'static str,
    pub(super) kind: Kind,
    pub(super) measure: fn(&T) -> Measured,
    pub(super) why: &'static str,
}

pub(super) const fn statement<T>(
    place: &'static str,
    says: &'static str,
    measure: fn(&T) -> Measured,
    why: &'static str,
) -> Claim<T> {
    Claim { place, says, kind: Kind::Statement, measure, why }
}

const fn misprint(
    place: &'static str,
    says: &'static str,
    measure: fn(&Contact) -> Measured,
    why: &'static str,
) -> Claim {
    Claim { place, says, kind: Kind::Misprint, measure, why }
}

pub(super) fn measured(ours: impl Into<String>, holds: bool) -> Measured {
    Measured { ours: ours.into(), holds }
}

/// A number with three digits, in the markup of the page.
pub(super) fn short(value: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    if (0.01..1000.0).contains(&value.abs()) {
        let digits = 2 - value.abs().max(1e-2).log10().floor() as i32;
        return format!("{value:.*}", digits.max(0) as usize).replace('-', "−");
    }
    let text = format!("{value:.2e}");
    match text.split_once('e') {
        Some((mantissa, exponent)) => format!("{mantissa} × 10^{{{exponent}}}").replace('-', "−"),
        None => text,
    }
}

/// All claims of the sections, in the order of the paper.
pub(super) const CLAIMS: [Claim; 31] = [
    equations::HERTZ_LIMIT,
    equations::AREA_HAS_A_MINIMUM,
    equations::FRICTION_OVER_DEPTH,
    equations::FORCE_GROWS,
    equations::DAMPING_IN_Y,
    equations::DISPLACEMENT_IN_16,
    equations::CHAIN_RULE_17,
    equations::SIGN_OF_C21,
    damping::LIMITS,
    damping::LARGE_DAMPING,
    damping::NEGATIVE_NEAR,
    damping::STRENGTH_REDUCES,
    damping::NEGATIVE_AT_LOW_LOAD,
    damping::STRENGTH_RAISES_AT_HIGH_SPEED,
    thresholds::OUTER_PAIR,
    thresholds::FIG_5,
    thresholds::FIG_6,
    thresholds::DERIVATIVES_IN_27,
    thresholds::FIG_7_GROWS,
    thresholds::FIG_7_EASY,
    thresholds::FIG_8_TRENDS,
    maps::FIG_9A_AGREEMENT,
    maps::WORSE_AT_LARGER_LOAD,
    maps::FIG_9B_ENDS,
    maps::LARGER_REGION,
    maps::PREVAILING,
    maps::DECOUPLED,
    maps::FIG_10_ENDS,
    maps::FIG_10_ENLARGES,
    thresholds::SPEED_OF_SECTION_5,
    thresholds::SECTION_5,
];
