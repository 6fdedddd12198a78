//! `motion`: the history of one motion.

pub(super) mod run;
mod watched;

pub(super) use run::{run, summary_keys};

use super::pictures;
use judder_study::case::analysis::Picture;

/// The figure.
pub(crate) const PICTURE: Picture = Picture {
    draw: pictures::motion,
    caption: "The whole motion; its end with the contact state shaded (white: slip); the phase portrait of that end with the changes of the contact \
        state; the spectrum and the Poincaré section (where $x$ is largest) after the transient.",
};
