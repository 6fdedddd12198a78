mod bending;
mod modes;
mod patch;
