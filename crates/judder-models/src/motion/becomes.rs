//! What a motion becomes: one list for diagrams, basins and their pictures.

use judder_oscillator::cycle::Confirmed;
use judder_oscillator::motion::attractor::Settled;

/// The words of what a motion becomes; the place is the number in stored results.
pub(crate) const BECOMES: [(u8, &str); 5] = [
    (STEADY_SLIDING, "steady sliding"),
    (CYCLE, "cycle"),
    (IRREGULAR, "irregular"),
    (LOST, "lost"),
    (UNCONFIRMED, "unconfirmed"),
];
/// The motion dies out.
pub const STEADY_SLIDING: u8 = 0;
/// The motion comes back to itself.
pub const CYCLE: u8 = 1;
pub(crate) const IRREGULAR: u8 = 2;
pub(crate) const LOST: u8 = 3;
pub(crate) const UNCONFIRMED: u8 = 4;

/// What a motion that could be followed becomes.
pub(super) fn becomes<const N: usize>(confirmed: &Confirmed<N>) -> u8 {
    match confirmed.attractor.settled {
        _ if !confirmed.is_confirmed => UNCONFIRMED,
        Settled::SteadySliding => STEADY_SLIDING,
        Settled::Cycle { .. } => CYCLE,
        Settled::Irregular => IRREGULAR,
    }
}
