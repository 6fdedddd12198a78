//! What holds of every search.

mod stopped;
