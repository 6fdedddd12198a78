//! `basin`: the share of starts from which steady sliding is reached.

mod run;

pub(super) use run::{Draw, run};

use super::pictures;
use crate::model::Pictured;

/// The figure.
pub(crate) const PICTURED: Pictured = Pictured {
    kind: "basin",
    draw: pictures::basin,
    caption: "Starts, drawn evenly, and what becomes of them.",
};
