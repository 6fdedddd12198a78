//! Evidence for the pictures and the page, one module a question.

// helpers outside of test functions may unwrap like the tests they serve
#![allow(clippy::unwrap_used)]

mod data;
mod pictures;
mod refusals;
mod report;
mod samples;
