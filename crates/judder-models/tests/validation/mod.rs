//! What one model says of what another has too.

mod sphere_on_springs;
