//! What holds of every structure, on random ones.

mod planted;
mod reduction;
