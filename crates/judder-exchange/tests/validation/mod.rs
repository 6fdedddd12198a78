mod disc_brake;
mod matrices;
