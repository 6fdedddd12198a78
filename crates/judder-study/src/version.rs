//! Which judder this is: what studies are stamped with, and what the hashes of their results name.

use std::sync::OnceLock;

static OF_THE_PROGRAM: OnceLock<&'static str> = OnceLock::new();

/// Names the version of the program that the engine is a part of, with the sources it was built from: another one computes everything again.
/// The first name stays, since a program has one.
pub fn name_version(version: &'static str) {
    let _ = OF_THE_PROGRAM.set(version);
}

/// The version that studies are stamped with: the number, a `+` and the sources where the program knows them, such as `0.1.0+4d3b94b50f1e`;
/// the number of the library where no program has named one.
#[must_use]
pub fn version() -> &'static str {
    OF_THE_PROGRAM.get().copied().unwrap_or(env!("CARGO_PKG_VERSION"))
}
