mod bending;
mod craig_bampton;
mod modes;
mod patch;
