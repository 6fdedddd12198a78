//! Under what small motions of the pair are meant.

use crate::sliding::case::SlidingCase;
use crate::sliding::locus::settings::LocusAnalysis;
use judder_sliding::locus::Conditions;

/// Under what the pair of a case slides.
pub(crate) fn conditions(case: &SlidingCase, settings: &LocusAnalysis) -> Conditions {
    Conditions {
        configuration: settings.configuration,
        is_damped: settings.damping,
        velocity: case.motion.velocity,
        load: case.motion.load.force,
    }
}
