//! The analyses of a contact case.

use crate::analysis::Kind;
use crate::cause::Cause;
use crate::contact_keys::{CONTACT_KEYS, ContactKey};
use crate::contact_problem::ContactProblem;
use crate::dimension::Dimension;
use crate::error::Fault;
use crate::inputs::{LawName, OscillatorInputs};
use crate::keys::{Key, Value};
use crate::memory::{MEMORY_LIMIT, Memory, read_memory_limit};
use crate::section::Section;
use crate::shape::Shape;
use crate::span::{Span, read_span};
use crate::swept_keys::read_value;
use crate::transient_analysis::{TRANSIENT_KEYS, TransientSettings, read_transient};

/// What an analysis of a contact case computes.
#[derive(Debug, Clone, PartialEq)]
pub enum ContactAnalysis {
    /// `contact`: one contact, with its fields.
    Contact(ContactSettings),
    /// `contact-law`: force, area and friction over speed and indentation.
    ContactLaw(LawSettings),
    /// `fit`: the three functions of the oscillator paper through a computed law.
    Fit(FitSettings),
    /// `modulus`: storage and loss modulus and loss tangent.
    Modulus(ModulusSettings),
    /// `transient`: a contact that is followed in time.
    Transient(TransientSettings),
}

/// One contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactSettings {
    /// v, as v τ/R or in m/s; at rest it is 0.
    pub velocity: Value,
    /// What presses the indenter down.
    pub loading: Loading,
    /// Relative accuracy of the force.
    pub accuracy: f64,
    /// Cells along a side; chosen and refined from the accuracy where left out.
    pub cells: Option<usize>,
    /// Side of the computed square, as L/R or in m; chosen where left out.
    pub domain: Option<Value>,
    /// What the largest grid may take.
    pub memory: Memory,
}

/// What presses the indenter down.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Loading {
    /// δ, as δ/R or in m.
    Indentation(Value),
    /// F, as F/(E0* R²) or in N; of a cylinder per length, as F/(E0* R) or in N/m.
    Load(Value),
}

/// A law over speed and indentation.
#[derive(Debug, Clone, PartialEq)]
pub struct LawSettings {
    /// Speeds, as v τ/R or in m/s.
    pub velocity: Span,
    /// Indentations, as δ/R or in m.
    pub indentation: Span,
    /// Relative accuracy of the law.
    pub accuracy: f64,
    /// How the plane is covered.
    pub method: LawMethod,
    /// What the largest grid of each of its contacts may take.
    pub memory: Memory,
}

/// The three functions of the oscillator paper through a law.
#[derive(Debug, Clone, PartialEq)]
pub struct FitSettings {
    /// What is computed.
    pub law: LawSettings,
    /// The factor of v τ/R at which the functions are read.
    pub velocity_scale: f64,
}

/// Moduli over frequency.
#[derive(Debug, Clone, PartialEq)]
pub struct ModulusSettings {
    /// The frequencies, as ω τ or in rad/s; chosen from the spectrum where left out.
    pub frequency: Option<Span>,
}

/// How a law covers the plane of speed and indentation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum LawMethod {
    /// One curve over z = v τ/√(R δ) serves the whole plane: exact for a paraboloid.
    Collapse,
    /// A table over speed and indentation, refined where it must be.
    Sweep,
}

impl LawMethod {
    /// The methods with their names in a case file.
    pub const ALL: [(&'static str, Self); 2] = [("collapse", Self::Collapse), ("sweep", Self::Sweep)];

    /// The name in a case file.
    pub fn name(self) -> &'static str {
        Self::ALL[self as usize].0
    }
}

/// The default accuracy of `contact-law` and `fit`.
pub const LAW_ACCURACY: f64 = 1e-2;

/// The default range of speeds of `contact-law` and `fit`, v τ/R: a hundredfold of the paper's axis, as its fits are read at
/// v τ/(100 R).
pub const LAW_VELOCITY: (f64, f64, usize) = (1e-6, 1e4, 51);
/// The default range of indentations of `contact-law` and `fit`, δ/R.
pub const LAW_INDENTATION: (f64, f64, usize) = (1e-4, 1e-1, 16);

/// The cells along a side that a contact may be given, an even number: a coarser grid of half as many, at least 32, says
/// how exact the finest is.
pub const CELLS: [usize; 2] = [64, 4096];

/// The points that a span of a law or of frequencies may have.
pub(crate) const SPAN_POINTS: usize = 2000;

/// The default number of frequencies.
pub const FREQUENCIES: usize = 200;

/// What the analyses of a contact case need to know of it.
pub(crate) struct ContactScope {
    pub(crate) shape: Shape,
    pub(crate) inputs: OscillatorInputs,
    /// Whether the moduli are known: measured data decide them later.
    pub(crate) moduli_known: bool,
    /// The memory limit of the case.
    pub(crate) memory: Memory,
}

impl ContactScope {
    /// The memory limit of an analysis: its own, or that of the case.
    pub(crate) fn memory_limit(&self, section: &Section<'_>) -> Result<Memory, Fault> {
        Ok(read_memory_limit(section)?.unwrap_or(self.memory))
    }
}

/// The kinds of a contact case.
pub(crate) const KINDS: [Kind<ContactScope, ContactAnalysis>; 5] = [
    Kind {
        name: "contact",
        keys: &["velocity", "indentation", "load", "accuracy", "cells", "domain", MEMORY_LIMIT],
        declared: None,
        doc: "one contact: force, area, friction, fields",
        read: |scope, section| read_contact(scope, section).map(ContactAnalysis::Contact),
    },
    Kind {
        name: "contact-law",
        keys: &["velocity", "indentation", "accuracy", "method", MEMORY_LIMIT],
        declared: None,
        doc: "force, area and friction over speed and indentation, as a law for an oscillator",
        read: |scope, section| read_law("contact-law", scope, section).map(ContactAnalysis::ContactLaw),
    },
    Kind {
        name: "fit",
        keys: &["velocity", "indentation", "accuracy", "method", "velocity_scale", MEMORY_LIMIT],
        declared: None,
        doc: "the three functions of the oscillator paper, fitted to a computed law",
        read: |scope, section| {
            let law = read_law("fit", scope, section)?;
            let velocity_scale = read_pure(section, ContactKey::VelocityScale)?;
            Ok(ContactAnalysis::Fit(FitSettings { law, velocity_scale }))
        },
    },
    Kind {
        name: "modulus",
        keys: &["frequency"],
        declared: None,
        doc: "storage and loss modulus and loss tangent over frequency",
        read: |_, section| {
            let frequency = match section.get("frequency") {
                Some(_) => Some(span(section, ContactKey::Frequency, None)?),
                None => None,
            };
            Ok(ContactAnalysis::Modulus(ModulusSettings { frequency }))
        },
    },
    Kind {
        name: "transient",
        keys: TRANSIENT_KEYS,
        declared: None,
        doc: "a contact that is followed in time: histories of force, friction and area, work of a cycle",
        read: |scope, section| read_transient(scope, section).map(ContactAnalysis::Transient),
    },
];

/// The keys of a contact that have no meaning for a shape, and why.
fn endless_keys(shape: &Shape) -> (&'static [&'static str], &'static str) {
    match shape {
        Shape::Cylinder => {
            (&["indentation", "domain"], "a cylinder, whose depth depends on how far away it is measured")
        }
        shape if shape.is_periodic() => {
            (&["domain", "cells"], "a surface that repeats itself, whose heights are the coarsest grid")
        }
        _ => (&[], ""),
    }
}

/// The load of a line contact, per length.
static LINE_LOAD: Key<ContactKey> = Key {
    dimension: Dimension::STIFFNESS,
    group: Some("F/(E0* R)"),
    ..CONTACT_KEYS[ContactKey::Load as usize]
};

fn read_contact(scope: &ContactScope, section: &Section<'_>) -> Result<ContactSettings, Fault> {
    let is_line = scope.shape == Shape::Cylinder;
    for key in endless_keys(&scope.shape).0 {
        if let Some(node) = section.get(key) {
            let what = endless_keys(&scope.shape).1;
            return Err(Cause::Contact { problem: ContactProblem::Endless { key, what } }.at(node.place));
        }
    }
    let value = |key: ContactKey| {
        let entry = match key {
            ContactKey::Load if is_line => &LINE_LOAD,
            key => key.entry(),
        };
        section.get(entry.name()).map(|node| read_value(entry, entry.name(), node)).transpose()
    };
    section.required("velocity", "velocity = 1e-2 (v τ/R), or \"30 mm/s\"")?;
    let loading = match (value(ContactKey::Indentation)?, value(ContactKey::Load)?) {
        (Some(indentation), None) => Loading::Indentation(indentation),
        (None, Some(load)) => Loading::Load(load),
        (Some(_), Some(_)) => {
            let place = section.get("load").map_or(section.place, |node| node.place);
            let (first, second) = ("indentation".to_owned(), "load".to_owned());
            return Err(Cause::Contact { problem: ContactProblem::OneOfTwo { first, second } }.at(place));
        }
        (None, None) => {
            if is_line {
                section.required("load", "load = 1e-2 (F/(E0* R)), or \"600 N/mm\"")?;
            }
            section.required("indentation", "indentation = 1e-2 (δ/R), or load = 1e-4 (F/(E0* R²))")?;
            Loading::Indentation(Value::group(0.0))
        }
    };
    Ok(ContactSettings {
        velocity: value(ContactKey::Velocity)?.unwrap_or(Value::group(0.0)),
        loading,
        accuracy: read_pure(section, ContactKey::Accuracy)?,
        cells: read_cells(section)?,
        domain: value(ContactKey::Domain)?,
        memory: scope.memory_limit(section)?,
    })
}

/// Reads `cells`, which two grids must be made of.
fn read_cells(section: &Section<'_>) -> Result<Option<usize>, Fault> {
    let [from, to] = CELLS;
    // one cell is a number of cells as well: the message of those that cannot be halved says more
    let cells = section.whole("cells", 1, to)?;
    match (cells, section.get("cells")) {
        (Some(found), Some(node)) if found < from || !found.is_multiple_of(2) => {
            Err(Cause::Contact { problem: ContactProblem::Cells { from, to, found } }.at(node.place))
        }
        _ => Ok(cells),
    }
}

/// Reads a pure number that has a default.
pub(crate) fn read_pure(section: &Section<'_>, key: ContactKey) -> Result<f64, Fault> {
    let entry = key.entry();
    match section.get(entry.name()) {
        Some(node) => Ok(read_value(entry, entry.name(), node)?.number),
        None => Ok(entry.default.map_or(0.0, |(_, value)| value.number)),
    }
}

fn read_law(kind: &'static str, scope: &ContactScope, section: &Section<'_>) -> Result<LawSettings, Fault> {
    let shape = scope.shape.name();
    if !matches!(scope.shape, Shape::Paraboloid | Shape::Sphere) {
        let shapes = "a paraboloid or a sphere";
        return Err(
            Cause::Contact { problem: ContactProblem::Shape { kind, shapes, shape } }.at(section.place)
        );
    }
    if scope.moduli_known {
        scope.inputs.check(LawName::Bem).map_err(|cause| cause.at(section.place))?;
    }
    let is_paraboloid = scope.shape == Shape::Paraboloid;
    let method = match section.choice("method", "method", &LawMethod::ALL)? {
        Some(LawMethod::Collapse) if !is_paraboloid => {
            let place = section.get("method").map_or(section.place, |node| node.place);
            return Err(Cause::Contact { problem: ContactProblem::Collapse { shape } }.at(place));
        }
        Some(method) => method,
        None if is_paraboloid => LawMethod::Collapse,
        None => LawMethod::Sweep,
    };
    let accuracy = match section.get("accuracy") {
        Some(_) => read_pure(section, ContactKey::Accuracy)?,
        None => LAW_ACCURACY,
    };
    Ok(LawSettings {
        velocity: span(section, ContactKey::Velocity, Some(LAW_VELOCITY))?,
        indentation: span(section, ContactKey::Indentation, Some(LAW_INDENTATION))?,
        accuracy,
        method,
        memory: scope.memory_limit(section)?,
    })
}

fn span(section: &Section<'_>, key: ContactKey, default: Option<(f64, f64, usize)>) -> Result<Span, Fault> {
    let points = default.map_or(FREQUENCIES, |(_, _, points)| points);
    read_span(section, key.entry(), default, (points, SPAN_POINTS))
}
