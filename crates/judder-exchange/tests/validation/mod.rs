mod disc_brake;
mod matrices;
mod meshes;
