//! The few numerical tools that two rooms of judder share.
//!
//! - [`elementary`]: `exp`, `ln`, `erf` without branches, the same bits on every machine and at every vector width.
//! - [`root`]: one root in a bracket, and all roots of a scalar function over an interval.
//! - [`polynomial`]: all roots of a small real polynomial, conjugate pairs exact.
//!
//! What a library does is called, not wrapped; these three stand here because no library gives them in this form.

pub mod elementary;
pub mod polynomial;
pub mod root;
