mod bending;
mod complex_modes;
mod craig_bampton;
mod modes;
mod patch;
