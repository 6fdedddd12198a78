//! The compiled part of the Python package `judder`; what users call, with its types and docs, is in `python/judder`.
//!
//! In the order in which the data flows:
//!
//! - `arrays`, `choice`: arrays and words from Python, checked.
//! - `constructed`: classes that are called with wrong arguments.
//! - `shown`: how objects show themselves in a notebook.
//! - `pool`, `watched`: long calls without the interpreter's lock, which Ctrl-C ends and whose progress is told.
//! - `oscillator`, `contact`, `sliding`: one module a crate of the second floor.
//! - `cases`: whole cases, and the command. `analyses`: one more analysis of a case. `held`: their results in memory.
//! - `programs`: what the command does besides: templates, schema, examples, reports, papers, the page.
//! - `signatures`: the classes of the models, as Python makes them.
//! - `sweep`: a sweep of a case, chunk by chunk, for whoever hands the chunks out himself.
//! - `errors`: errors of the crates as exceptions, with their fields.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod analyses;
mod arrays;
mod cases;
mod choice;
mod constructed;
mod contact;
mod errors;
mod held;
mod oscillator;
mod pool;
mod programs;
mod shown;
mod signatures;
mod sliding;
mod sweep;
mod watched;

#[pyo3::pymodule]
mod _judder {
    use pyo3::prelude::*;

    #[pymodule_export]
    use crate::analyses::{computed_analysis, declared_models, held_analysis, text_of_case};
    #[pymodule_export]
    use crate::cases::{checked_case, command, held_case, run_case};
    #[pymodule_export]
    use crate::contact::{PyLaw, contact_solution};
    #[pymodule_export]
    use crate::held::{PyHeldStudy, copied_study};
    #[pymodule_export]
    use crate::oscillator::{
        OscillatorPoint, oscillator_map, oscillator_points, point, rebuilt_point, repeated_points,
    };
    #[pymodule_export]
    use crate::programs::{
        ServedPage, bytes_of_memory, embedded_examples, foreign_chunk, limit_memory, listed_files,
        rebuilt_report, reproduced_paper, schema_text, template_text, unusable_chunk, verified_study,
        vouch_for_content, vouch_for_summary, written_example,
    };
    #[pymodule_export]
    use crate::sliding::{PyPair, sliding_locus, sliding_march};
    #[pymodule_export]
    use crate::sweep::{HeldSweep, PySweep};
    #[pymodule_export]
    const CONTACT_STATES: [&str; 4] = {
        let [stick, slip, slip_ahead, lift_off] = judder_sliding::march::ContactState::CODES;
        [stick.1, slip.1, slip_ahead.1, lift_off.1]
    };
    #[pymodule_export]
    const LARGEST_DOCUMENT: u64 = judder_store::LARGEST_DOCUMENT;
    #[pymodule_export]
    const VERSION: &str = env!("CARGO_PKG_VERSION");
    #[pymodule_export]
    const BUILD: &str = judder_cli::VERSION;

    #[pymodule_init]
    fn name_version(_module: &Bound<'_, PyModule>) -> PyResult<()> {
        judder_study::name_version(judder_cli::VERSION);
        Ok(())
    }
}
