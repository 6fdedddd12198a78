//! What holds at every point of the parameter space.

mod computed_laws;
mod confirmed_kinds;
mod equilibrium;
mod groups;
mod growth;
mod hurwitz;
mod jacobian;
mod maps;
mod mechanism;
mod within_law;
