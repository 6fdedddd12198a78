//! What a computed law was computed for.

use crate::law::limits::LawIndenter;
use crate::law::material::LawMaterial;

/// Material and indenter of a computed law, and where its numbers come from.
#[derive(Debug, Clone, PartialEq)]
pub struct LawOrigin {
    /// The substrate.
    pub material: LawMaterial,
    /// The indenter.
    pub indenter: LawIndenter,
    /// Who computed the values, and how, in words.
    pub source: String,
}
