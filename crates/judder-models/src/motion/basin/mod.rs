//! `basin`: the share of starts from which steady sliding is reached.

mod run;

pub(super) use run::{Draw, run, summary_keys};

use super::pictures;
use judder_study::case::analysis::Picture;

/// The figure.
pub(crate) const PICTURE: Picture =
    Picture { draw: pictures::basin, caption: "Starts, drawn evenly, and what becomes of them." };
