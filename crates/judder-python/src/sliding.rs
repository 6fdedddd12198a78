//! Two structures in sliding contact, from Python.
//!
//! - `pair`: a slider on its track, from modal data or from a case.
//! - `march`: the pair through time.
//! - `locus`: its eigenvalues against the position of the contact.

mod locus;
mod march;
mod pair;

pub(crate) use locus::sliding_locus;
pub(crate) use march::sliding_march;
pub(crate) use pair::PyPair;
