//! The few numerical tools that two rooms of judder share.
//!
//! - [`elementary`]: `exp`, `ln`, `erf` without branches, the same bits on every machine and at every vector width.
//! - [`cancellation`]: sums whose terms cancel.
//! - [`complex`]: elementary functions of complex numbers, with portable bits.
//! - [`root`]: one root in a bracket, and all roots of a scalar function over an interval.
//! - [`polynomial`]: all roots of a small real polynomial, conjugate pairs exact.
//! - [`quadrature`]: the rule of Gauss and Legendre.
//! - [`gmres`]: a large, non-symmetric system known only by its products.
//! - [`decade`]: powers of ten, exact where they can be.
//! - [`dense`]: a small system of linear equations.
//! - [`contact_state`]: stick, slip, lift-off, and their numbers in results.
//! - [`counter`]: even random numbers, each computed from its place alone.
//! - [`piecewise`]: motion whose equations change from mode to mode, with located events.
//! - [`order`]: things in the order of their numbers.
//! - [`parallel`]: the same work on many things, over all threads.
//! - [`ramp`]: from value to value: straight between places, half a cosine.
//! - [`sampling`]: points that fill a cube evenly: Sobol' sequences, Latin hypercubes.
//! - [`sensitivity`]: Sobol' indices of first order and total, with confidence intervals.
//! - [`share`]: how well a share is known from a sample.
//! - [`signal`]: sampled histories: decimation, resampling, spectrograms, bursts.
//! - [`stopping`]: long computations that may be stopped.
//! - [`verdict`]: stable, marginal, unstable.
//! - [`words`]: numbers in sentences.
//!
//! What a library does is called, not wrapped; these stand here because no library gives them in this form.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

pub mod cancellation;
pub mod complex;
pub mod contact_state;
pub mod counter;
pub mod decade;
pub mod dense;
pub mod elementary;
pub mod gmres;
pub mod order;
pub mod parallel;
pub mod piecewise;
pub mod polynomial;
pub mod quadrature;
pub mod ramp;
pub mod root;
pub mod sampling;
pub mod sensitivity;
pub mod share;
pub mod signal;
pub mod stopping;
pub mod verdict;
pub mod words;
