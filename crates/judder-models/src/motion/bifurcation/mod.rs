//! `bifurcation`: what motions settle to along one key, up and down.

pub(super) mod branch_layers;
mod branches;
mod diagram;
mod run;

pub(super) use run::{Settings, run, summary_keys};

use super::pictures;
use judder_study::case::analysis::Picture;

/// The figure.
pub(crate) const PICTURE: Picture = Picture {
    draw: pictures::bifurcation,
    caption: "What motions settle to as the key goes up and down, each from the end of the one before: rms of $x$ about its mean, its largest values, the \
        shares of the time in stick and off the substrate. Irregular is a motion without a period from which nearby ones part; \
        unconfirmed is what has not settled within its time, or changes its kind with the tolerance. Points are simulated, and no line joins them: neighbours may have \
        settled to different motions. Where branches were followed, lines are cycles \
        and steady sliding, stable (solid) or not (dashed).",
};
