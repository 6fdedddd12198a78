//! The numbers and claims of the oscillator paper, each with the way it is measured: sections 2–5 here, the motions of section 5 in
//! [`motion`], the contact computation in [`contact`].

pub(super) mod contact;
mod damping;
mod equations;
mod maps;
pub(super) mod motion;
mod thresholds;

use crate::claim::MeasuredClaim;
use judder_oscillator::Contact;

/// All claims of the sections, in the order of the paper.
pub(super) const CLAIMS: [MeasuredClaim<Contact>; 31] = [
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
