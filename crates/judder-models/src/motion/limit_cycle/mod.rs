//! `limit-cycle`: the cycle that a motion settles to, made exact.

mod run;

pub(crate) use run::shooting;
pub(super) use run::{run, summary_keys};

use super::pictures;
use judder_study::case::analysis::Picture;

/// The figure.
pub(crate) const PICTURE: Picture = Picture {
    draw: pictures::limit_cycle,
    caption: "One period with the contact state shaded (white: slip), the phase portrait with the changes of the contact state, and the Floquet \
        multipliers: the cycle is stable where all but the one at 1 lie within the unit circle.",
};
