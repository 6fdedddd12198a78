mod disc_brake;
mod height_files;
mod matrices;
mod meshes;
