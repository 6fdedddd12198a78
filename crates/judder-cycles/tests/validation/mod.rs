//! Against closed forms, marches, published cases.

mod belt;
mod block;
mod forced;
mod stability;
