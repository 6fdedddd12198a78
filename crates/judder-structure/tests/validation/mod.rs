mod bending;
mod craig_bampton;
mod damping;
mod modes;
mod patch;
