//! How long bodies are that are made of cells, and of how many.

use judder_keys::declared::{Number, Whole};
use judder_keys::dimension::Dimension;

/// A length of a body.
pub(super) const LENGTH: Number = Number::positive(Dimension::LENGTH);
/// Elements along a side.
pub(super) const ELEMENTS_RANGE: Whole = Whole { from: ELEMENTS.0, to: ELEMENTS.1 };

/// The most elements along a side of a beam or a block.
pub const ELEMENTS: (usize, usize) = (1, 100_000);
