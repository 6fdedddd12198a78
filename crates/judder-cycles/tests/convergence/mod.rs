//! How errors fall, and derivatives against differences.

mod derivatives;
