//! What holds at every point of the parameter space.

mod equilibrium;
mod groups;
mod growth;
mod hurwitz;
mod jacobian;
mod maps;
