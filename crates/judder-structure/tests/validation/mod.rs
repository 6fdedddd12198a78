mod bending;
mod patch;
