//! Contact from Python.
//!
//! - `law`: contact laws, by name, from files, from tables and functions of a user's own.
//! - `solution`: the contact of steady sliding, computed.

mod law;
mod solution;

pub(crate) use law::PyLaw;
pub(crate) use solution::contact_solution;
