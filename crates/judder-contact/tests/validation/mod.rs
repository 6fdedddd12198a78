//! Closed forms, literature, statistics, other algorithms.

mod appendix_b;
mod dense_solve;
mod elastic_limits;
mod friction_limits;
mod hertz_by_gradients;
mod high_contrast;
mod hunter;
mod layer_contact;
mod line_contact;
mod line_kernel;
mod material;
mod periodic_surface;
mod prony_fit;
mod quasi_steady_law;
mod rough_surface;
mod slow_sliding;
mod spectrum;
mod stated_errors;
mod transient_at_rest;
mod transient_sliding;
mod wake;
mod wavy_surfaces;
