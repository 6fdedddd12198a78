//! How long bodies are that are made of cells.

use judder_keys::declared::Number;
use judder_keys::dimension::Dimension;

/// A length of a body.
pub(super) const LENGTH: Number = Number::positive(Dimension::LENGTH);
