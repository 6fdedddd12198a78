//! Against closed forms, marches, published cases.

mod belt;
mod block;
mod branch;
mod forced;
mod shooting;
mod stability;
