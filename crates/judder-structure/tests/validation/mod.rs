mod bending;
mod complex_modes;
mod craig_bampton;
mod damping;
mod diagnosis;
mod eigen_sweep;
mod modes;
mod patch;
