//! Against closed forms, marches, published cases.

mod belt;
mod block;
mod branch;
mod forced;
mod hill;
mod lumped_brake;
mod near;
mod own_engine;
mod shooting;
mod sphere;
mod stability;
