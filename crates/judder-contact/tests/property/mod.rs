//! What must hold at every point.

mod kernel_check;
mod law_doubt;
mod law_file;
mod law_smoothness;
mod law_sweep;
mod line_law;
mod material;
mod rough_contact;
mod sliding_operator;
mod steady_sliding;
mod transient_contact;
