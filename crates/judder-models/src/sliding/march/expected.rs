//! The growth that the unstable zones along the path promise, beside the bursts.

use super::Marched;
use judder_sliding::SlidingError;
use judder_sliding::amplification::{Amplification, amplifications};
use judder_sliding::locus::{Conditions, Configuration};
use judder_sliding::march::ContactMethod;
use judder_store::Results;

/// Branches whose zones are sought.
const BRANCHES: usize = 20;
/// A zone and a burst of one mode differ less in frequency.
const NEAR: f64 = 0.05;

/// The zones of the rest of the path after the ramps in the configuration that the method sees; or why they were not found.
pub(super) fn zones(of: &Marched<'_>) -> Result<Vec<Amplification>, SlidingError> {
    let start = of.motion.at(of.motion.settled()).position;
    let configuration = match of.march.method() {
        ContactMethod::Subs { static_slope: false } => Configuration::Undeformed,
        _ => Configuration::Deformed,
    };
    let conditions =
        Conditions { configuration, is_damped: true, velocity: of.motion.velocity, load: of.motion.load };
    // a march that ends within its ramps has no such rest
    if (of.motion.end - start) * of.motion.velocity <= 0.0 {
        return Ok(Vec::new());
    }
    amplifications(
        of.pair,
        &conditions,
        [start, of.motion.end],
        BRANCHES.min(of.pair.modes().saturating_sub(1)),
    )
}

/// The zone in which a burst has grown: of its frequency in Hz, passed between its start and its peak; of several the one that promises most.
pub(super) fn zone_of(
    zones: &[Amplification],
    frequency: Option<f64>,
    [start, peak]: [f64; 2],
) -> Option<&Amplification> {
    let frequency = frequency?;
    let (first, last) = (start.min(peak), start.max(peak));
    zones
        .iter()
        .filter(|zone| (zone.zone.frequency_hz / frequency - 1.0).abs() < NEAR)
        .filter(|zone| zone.zone.from <= last && zone.zone.to >= first)
        .max_by(|a, b| a.nepers.total_cmp(&b.nepers))
}

/// A zone for the summary.
#[derive(Results)]
pub(super) struct ToldAmplification {
    from_m: f64,
    to_m: f64,
    frequency_hz: f64,
    #[result(unit = "1/s")]
    max_growth_rate: f64,
    /// in nepers
    #[result(unit = "1")]
    expected_amplification: f64,
    error: f64,
}

impl ToldAmplification {
    pub(super) fn new(own: &Amplification) -> Self {
        Self {
            from_m: own.zone.from,
            to_m: own.zone.to,
            frequency_hz: own.zone.frequency_hz,
            max_growth_rate: own.zone.growth_rate,
            expected_amplification: own.nepers,
            error: own.error,
        }
    }
}
