//! Case files of judder: TOML text in, a typed and validated case out. No physics, and of numerics the points of sweeps alone.
//!
//! The modules in the order in which the data flows:
//!
//! - `document`: the TOML text as a tree whose every value knows its place; `--set` options are grafted onto it.
//! - [`dimension`] and [`quantity`]: `"3.5 kN/m"` becomes a number in SI units with its dimension.
//! - [`keys`]: **the one table of keys**, which drives reading, defaults, sweeps, schema and templates.
//! - `declared`: settings declared once, from whose fields reading, canonical form, schema and reference follow.
//! - `section`: typed reading of one table; unknown keys are refused first.
//! - [`inputs`]: the value of every numeric key at one operating point.
//! - [`given`]: a value that no case file has: a number or a text, read as a case file would.
//! - [`sweep`], [`span`], `swept_keys`, `read_sweep`: what an analysis varies, over which range.
//! - `analysis`, [`oscillator_analysis`], [`oscillator_case`]: the oscillator case and its analyses.
//! - [`substrate`], [`temperature`], [`shape`], [`contact_analysis`], [`transient_analysis`], [`contact_case`]: the contact case and its analyses;
//!   [`file_reference`]: the files that a case names; [`memory`]: what they may take; [`continuous`]: a spectrum without lines.
//! - [`motion_analysis`], [`engines_analysis`], [`belt_case`]: the analyses of motion, and the mass on a belt.
//! - [`expression`], `matrix`, [`mass`], [`two_degrees`]: the two-degrees case, matrices of expressions.
//! - [`structure`]: the structure case: bodies of elements, sums of matrices, their analyses.
//! - [`sliding`]: the sliding case: two structures, their contact, motion and analyses.
//! - [`key_sweep`], [`study_sweep`]: any number of a case that varies, and `[[sweep]]`, the whole case at many points.
//! - [`case_file`]: the way in. `resolved`: the way out, canonical JSON for the hash and the report.
//! - [`mod@compose`]: options, and one analysis, written into the text of a case; one of its analyses alone.
//!   [`mod@anywhere`]: its files by whole paths. `edited`: the text that is edited.
//! - [`cause`], [`problem`], `help`, `excerpt`, [`error`]: what is wrong, what would be right, where; [`contact_problem`],
//!   [`oscillator_problem`], `structure::problem`, `sliding::problem`, `study_sweep::problem`: what parts of a case say of themselves.
//! - [`mod@schema`], [`mod@template`]: the JSON Schema for editors and the commented cases of `judder new`.

pub mod analysis;
pub mod anywhere;
pub mod belt_case;
pub mod case_file;
pub mod compose;
pub mod contact_analysis;
pub mod contact_case;
pub mod contact_problem;
pub mod continuous;
pub mod engines_analysis;
pub mod given;
pub mod inputs;
pub mod key_sweep;
pub mod keys;
pub mod mass;
mod matrix;
pub mod motion_analysis;
pub mod oscillator_analysis;
pub mod oscillator_case;
pub mod oscillator_problem;
mod read_sweep;
pub mod reference;
mod resolved;
pub mod schema;
pub mod shape;
pub mod sliding;
pub mod structure;
pub mod study_sweep;
pub mod substrate;
pub mod sweep;
mod swept_keys;
pub mod temperature;
pub mod template;
pub mod transient_analysis;
pub mod two_degrees;

pub use analysis::Analysis;
pub use anywhere::anywhere;
pub use belt_case::{BELT_KEYS, BeltCase, BeltInputs, BeltKey};
pub use case_file::{Case, CaseFile};
pub use compose::{alone, compose, contact_case_of};
pub use contact_analysis::{
    ContactAnalysis, ContactSettings, FitReading, FitSettings, LawMethod, LawSettings, Loading,
    ModulusSettings,
};
pub use contact_case::ContactCase;
pub use contact_problem::ContactProblem;
pub use continuous::{ContinuousSource, Density, DensitySample, LogNormal, PowerLaw, TermChoice};
pub use engines_analysis::EnginesSettings;
pub use given::Given;
pub use inputs::{FrictionLoad, LawName, OscillatorInputs, TimeForm};
pub use keys::{KEYS, OscillatorKey};
pub use mass::{MassProblem, NoMass};
pub use motion_analysis::{
    Basin, Bifurcation, Diagram, Following, History, LimitCycle, MotionAnalysis, MotionStart, StartRanges,
    SweepDirection,
};
pub use oscillator_analysis::{
    CriticalThresholds, DampingCurves, OscillatorAnalysis, Sought, SpectrumCurves,
};
pub use oscillator_case::OscillatorCase;
pub use oscillator_problem::OscillatorProblem;
pub use schema::schema;
pub use shape::{HeightFile, RoughSurface, Roughness, Shape};
pub use sliding::SlidingCase;
pub use sliding::analysis::SlidingAnalysis;
pub use sliding::problem::SlidingProblem;
pub use structure::analysis::StructureAnalysis;
pub use structure::problem::StructureProblem;
pub use structure::{StructureCase, StructureSource};
pub use study_sweep::problem::SweepProblem;
pub use study_sweep::quantity_path::{QuantityPath, QuantitySource, QuantityStep, Reduction};
pub use study_sweep::{Design, Sensitivity, StudySweep, SweptKey, SweptValues};
pub use substrate::{PronyTerm, RelaxationSource, RelaxationTerm, Substrate, TermCount};
pub use sweep::{Family, MapMethod, MapOptions, ParameterKey, Scale, StabilityMap, Sweep, Within};
pub use temperature::{Arrhenius, Shift, Temperature, TemperatureDifference, Wlf};
pub use template::{TEMPLATES, template};
pub use transient_analysis::{Motion, MotionWord, Oscillation, TransientSettings};
pub use two_degrees::{
    Parameter, ParameterSpectrum, ParameterThresholds, TwoDegreesAnalysis, TwoDegreesCase, TwoDegreesMatrices,
};
