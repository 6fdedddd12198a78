//! The analyses of a contact case.

use crate::contact::problem::ContactProblem;
use crate::contact::shape::ShapeSettings;
use crate::oscillator::inputs::OscillatorInputs;
use crate::oscillator::law_name::LawName;
use judder_keys::cause::Cause;
use judder_keys::declared::{
    Allowed, Declaration, Ladder, Number, Scaled, Setting, Settings, Whole, all, both,
};
use judder_keys::dimension::Dimension;
use judder_keys::document::{Data, Node};
use judder_keys::error::Fault;
use judder_keys::memory::Memory;
use judder_keys::numeric_key::{Form, Range, Value};
use judder_keys::problem::Placed;
use judder_keys::quantity::Quantity;
use judder_keys::section::{Section, whole};
use judder_keys::span::Span;
use judder_keys::{Choice, Settings};
use serde_json::{Value as Json, json};

/// One contact.
#[derive(Debug, Clone, Copy, PartialEq, Settings)]
pub struct ContactSettings {
    /// Sliding speed; 0 at rest.
    #[key(rule = Scaled { range: Range::NonNegative, ..VELOCITY }, symbol = "v", example = "1e-2 (v τ/R), or \"30 mm/s\"")]
    pub velocity: Value,
    /// Indentation.
    #[key(rule = INDENTATION, symbol = "δ", omitted)]
    indentation: Option<Value>,
    /// Normal load, in place of the indentation; of a cylinder per length, F/(E0* R) or in N/m.
    #[key(symbol = "F", omitted)]
    load: Option<UnreadLoad>,
    /// Relative accuracy of the force; area and friction may be five times as far off.
    #[key(rule = ACCURACY, symbol = "ε", default = 1e-3)]
    pub accuracy: f64,
    /// Cells along a side, an even number; chosen and refined from the accuracy where left out.
    cells: Option<EvenCells>,
    /// Side of the computed square; chosen from the accuracy where left out.
    #[key(rule = Scaled::positive(Dimension::LENGTH, "L/R"), symbol = "L")]
    pub domain: Option<Value>,
    /// What the largest grid may take; as much as the case says where left out.
    #[key(name = "memory_limit")]
    pub memory: Memory,
}

/// What presses the indenter down.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum LoadingSettings {
    /// δ, as δ/R or in m.
    Indentation(Value),
    /// F, as F/(E0* R²) or in N; of a cylinder per length, as F/(E0* R) or in N/m.
    Load(Value),
}

/// A law over speed and indentation.
#[derive(Debug, Clone, PartialEq, Settings)]
pub struct LawSettings {
    /// Speeds.
    #[key(rule = Ladder { of: VELOCITY, usual: LAW_VELOCITY.points, most: SPAN_POINTS }, symbol = "v", default = LAW_VELOCITY)]
    pub velocity: Span,
    /// Indentations.
    #[key(rule = Ladder { of: INDENTATION, usual: LAW_INDENTATION.points, most: SPAN_POINTS }, symbol = "δ", default = LAW_INDENTATION)]
    pub indentation: Span,
    /// Relative accuracy of the law.
    #[key(rule = ACCURACY, symbol = "ε", default = LAW_ACCURACY)]
    pub accuracy: f64,
    /// How the plane is covered; of another shape than a paraboloid `sweep` where left out.
    #[key(default = LawMethod::Collapse)]
    pub method: LawMethod,
    /// What the largest grid of each of its contacts may take; as much as the case says where left out.
    #[key(name = "memory_limit")]
    pub memory: Memory,
}

/// The three functions of the oscillator paper through a law.
#[derive(Debug, Clone, PartialEq)]
pub struct FitSettings {
    /// What is computed.
    pub law: LawSettings,
    /// How it is read.
    pub reading: FitReading,
}

/// How the three functions are read off a law.
#[derive(Debug, Clone, PartialEq, Settings)]
pub struct FitReading {
    /// Factor of v τ/R at which the fits are read.
    #[key(rule = Number::positive(Dimension::NUMBER), symbol = "s", default = 0.01)]
    pub velocity_scale: f64,
}

/// Moduli over frequency.
#[derive(Debug, Clone, PartialEq, Settings)]
pub struct ModulusSettings {
    /// Angular frequencies; chosen from the spectrum where left out.
    #[key(rule = Ladder { of: FREQUENCY, usual: FREQUENCIES, most: SPAN_POINTS }, symbol = "ω")]
    pub frequency: Option<Span>,
}

/// How a law covers the plane of speed and indentation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Choice)]
#[choice(what = "method")]
pub enum LawMethod {
    /// One curve over z = v τ/√(R δ) serves the whole plane: exact for a paraboloid.
    Collapse,
    /// A table over speed and indentation, refined where it must be.
    Sweep,
}

/// v, above zero.
pub(crate) const VELOCITY: Scaled = Scaled::positive(Dimension::SPEED, "v τ/R");
/// δ.
pub(crate) const INDENTATION: Scaled = Scaled::positive(Dimension::LENGTH, "δ/R");
/// F.
pub(crate) const LOAD: Scaled = Scaled::positive(Dimension::FORCE, "F/(E0* R²)");
/// F of a cylinder, per length.
const LINE_LOAD: Scaled = Scaled::positive(Dimension::STIFFNESS, "F/(E0* R)");
/// ω.
pub(crate) const FREQUENCY: Scaled = Scaled::positive(Dimension::ANGULAR_FREQUENCY, "ω τ");
/// ε of a force.
pub(crate) const ACCURACY: Number =
    Number { dimension: Dimension::NUMBER, range: Range::Interval { above: 0.0, up_to: 0.2 } };

/// The default accuracy of `contact-law` and `fit`.
pub const LAW_ACCURACY: f64 = 1e-2;

/// The default range of speeds of `contact-law` and `fit`, v τ/R: a hundredfold of the paper's axis, as its fits are read at
/// v τ/(100 R).
pub const LAW_VELOCITY: Span = Span { from: 1e-6, to: 1e4, points: 51, form: Form::Group };
/// The default range of indentations of `contact-law` and `fit`, δ/R.
pub const LAW_INDENTATION: Span = Span { from: 1e-4, to: 1e-1, points: 16, form: Form::Group };

/// The cells along a side that a contact may be given, an even number: a coarser grid of half as many, at least 32, says
/// how exact the finest is.
pub const CELLS: [usize; 2] = [64, 4096];

/// The points that a span of a law or of frequencies may have.
const SPAN_POINTS: usize = 2000;

/// The default number of frequencies.
pub const FREQUENCIES: usize = 200;

/// What the analyses of a contact case need to know of it.
pub(crate) struct ContactScope {
    pub(crate) shape: ShapeSettings,
    /// Length of a cylinder, m, where it is given.
    pub(crate) length: Option<f64>,
    pub(crate) inputs: OscillatorInputs,
    /// Whether the substrate is a layer of given thickness.
    pub(crate) is_layer: bool,
    /// Whether the moduli are known: measured data decide them later.
    pub(crate) moduli_known: bool,
    /// The memory limit of the case.
    pub(crate) memory: Memory,
}

impl ContactScope {
    /// The memory limit of an analysis: its own, or that of the case.
    pub(crate) fn memory_limit(&self, section: &Section<'_>, own: Memory) -> Memory {
        section.get("memory_limit").map_or(self.memory, |_| own)
    }

    /// Refuses an analysis of a law where the moduli are known, and have none.
    fn has_moduli(&self, section: &Section<'_>) -> Result<(), Fault> {
        let checked = if self.moduli_known { self.inputs.check(LawName::Bem) } else { Ok(()) };
        checked.map_err(|cause| cause.at(section.place))
    }

    /// Refuses an analysis of a law where the indenter has none: a cylinder has one on a layer.
    fn has_law(&self, kind: &'static str, section: &Section<'_>) -> Result<(), Fault> {
        match self.shape {
            ShapeSettings::Cylinder if kind != "contact-law" => self.is_round(kind, section),
            ShapeSettings::Cylinder if self.is_layer => Ok(()),
            ShapeSettings::Cylinder => {
                Err(ContactProblem::NoThickness { what: "the contact law" }.at(section.place))
            }
            _ => self.is_round(kind, section),
        }
    }

    /// Refuses an analysis of this kind where the indenter is neither a paraboloid nor a sphere.
    pub(crate) fn is_round(&self, kind: &'static str, section: &Section<'_>) -> Result<(), Fault> {
        if matches!(self.shape, ShapeSettings::Paraboloid | ShapeSettings::Sphere) {
            return Ok(());
        }
        let (shapes, shape) = ("a paraboloid or a sphere", self.shape.name());
        Err(ContactProblem::Shape { kind, shapes, shape }.at(section.place))
    }
}

impl LoadingSettings {
    /// The one of two that presses the indenter down.
    pub(crate) fn of(indentation: Option<Value>, load: Option<Value>) -> Self {
        match (indentation, load) {
            (_, Some(load)) => Self::Load(load),
            (indentation, None) => Self::Indentation(indentation.unwrap_or(Value::group(0.0))),
        }
    }

    /// Its value.
    pub(crate) fn value(self) -> Value {
        let (Self::Indentation(own) | Self::Load(own)) = self;
        own
    }

    /// Refuses both, and neither; of a cylinder a load is one per length, and on a half-space it has no depth.
    pub(crate) fn is_one(section: &Section<'_>, is_line: bool, is_layer: bool) -> Result<(), Fault> {
        match (section.get("indentation"), section.get("load")) {
            (Some(_), Some(node)) => {
                let (first, second) = ("indentation".to_owned(), "load".to_owned());
                Err(Cause::OneOfTwo { first, second }.at(node.place))
            }
            (None, None) if is_line && !is_layer => {
                Err(section.missing("load", "load = 1e-2 (F/(E0* R)), or \"600 N/mm\""))
            }
            (None, None) if is_line => {
                Err(section.missing("indentation", "indentation = 1e-2 (δ/R), or load = 1e-2 (F/(E0* R))"))
            }
            (None, None) => {
                Err(section.missing("indentation", "indentation = 1e-2 (δ/R), or load = 1e-4 (F/(E0* R²))"))
            }
            _ => Ok(()),
        }
    }
}

impl ContactSettings {
    /// Reads them for an indenter: its shape decides what a load is, and which keys have a meaning.
    pub(super) fn of(scope: Option<&ContactScope>, section: &Section<'_>) -> Result<Self, Fault> {
        let Some(scope) = scope else { return Self::read_table(section) };
        let is_line = scope.shape == ShapeSettings::Cylinder;
        let (endless, what): (&[_], _) = match &scope.shape {
            ShapeSettings::Cylinder => (&["domain"], "a cylinder, whose contact is a strip and no square"),
            shape if shape.is_periodic() => {
                (&["domain", "cells"], "a surface that repeats itself, whose heights are the coarsest grid")
            }
            _ => (&[], ""),
        };
        let refused = all(endless.iter().map(|key| match section.get(key) {
            Some(node) => Err(ContactProblem::Endless { key, what }.at(node.place)),
            None => Ok(()),
        }));
        let on_half_space = match section.get("indentation") {
            Some(node) if is_line && !scope.is_layer => {
                Err(ContactProblem::NoThickness { what: "the indentation" }.at(node.place))
            }
            _ => Ok(()),
        };
        let loading = both(refused, on_half_space)
            .and_then(|_| LoadingSettings::is_one(section, is_line, scope.is_layer));
        let load = section.get("load").map(|node| load(node, scope).map(UnreadLoad));
        let (settings, (load, ())) = both(Self::read_table(section), both(load.transpose(), loading))?;
        Ok(Self { load, memory: scope.memory_limit(section, settings.memory), ..settings })
    }

    /// Whether speed, depth or load are written in SI.
    pub(crate) fn is_in_si(&self) -> bool {
        [self.velocity, self.loading().value()].iter().any(|own| own.form == Form::Si)
    }

    /// What presses the indenter down.
    pub fn loading(&self) -> LoadingSettings {
        LoadingSettings::of(self.indentation, self.load.map(|UnreadLoad(load)| load))
    }

    /// Cells along a side; chosen and refined from the accuracy where left out.
    pub fn cells(&self) -> Option<usize> {
        self.cells.map(|EvenCells(cells)| cells)
    }
}

impl LawSettings {
    /// Reads them of this kind for an indenter, whose shape decides how the plane may be covered.
    pub(super) fn of(
        kind: &'static str,
        scope: Option<&ContactScope>,
        section: &Section<'_>,
    ) -> Result<Self, Fault> {
        let Some(scope) = scope else { return Self::read_table(section) };
        let has_law = scope.has_law(kind, section).and_then(|()| scope.has_moduli(section));
        let ((), mut settings) = both(has_law, Self::read_table(section))?;
        settings.memory = scope.memory_limit(section, settings.memory);
        match section.get("method") {
            Some(node)
                if settings.method == LawMethod::Collapse && scope.shape != ShapeSettings::Paraboloid =>
            {
                let shape = scope.shape.name();
                return Err(ContactProblem::Collapse { shape }.at(node.place));
            }
            None if scope.shape != ShapeSettings::Paraboloid => settings.method = LawMethod::Sweep,
            _ => (),
        }
        Ok(settings)
    }
}

impl FitSettings {
    /// The keys of the law, and of how it is read.
    pub(super) fn declarations() -> Vec<Declaration> {
        let mut keys = LawSettings::declarations();
        // the memory limit stays the last
        let end = keys.len().saturating_sub(1);
        keys.splice(end..end, FitReading::declarations());
        keys
    }
}

/// A load, of a cylinder one per length.
fn load(node: &Node, scope: &ContactScope) -> Result<Value, Fault> {
    if scope.shape != ShapeSettings::Cylinder {
        return LOAD.read("load", node);
    }
    let length = scope.length;
    const FORCE: Scaled = Scaled { range: Range::Any, ..LOAD };
    LINE_LOAD.read("load", node).map_err(|fault| match FORCE.read("load", node) {
        Ok(Value { number, form: Form::Si }) => {
            ContactProblem::WholeLoad { force: number, length }.at(node.place)
        }
        _ => match &node.data {
            Data::Text(text) if is_of_another_kind(text) => {
                ContactProblem::NotPerLength { text: text.clone() }.at(node.place)
            }
            _ => fault,
        },
    })
}

/// Whether a text is a quantity, and no force per length.
fn is_of_another_kind(text: &str) -> bool {
    Quantity::parse(text).is_ok_and(|own| own.dimension != LINE_LOAD.dimension)
}

/// A load, read as soon as the shape has decided whether it is one per length.
#[derive(Debug, Clone, Copy, PartialEq)]
struct UnreadLoad(Value);

impl Setting for UnreadLoad {
    type Rule = ();

    fn form((): &()) -> Allowed {
        Value::form(&LOAD)
    }

    fn read(_: &Section<'_>, _: &str, _: &Node, (): &()) -> Result<Self, Fault> {
        Ok(Self(Value::group(0.0)))
    }

    fn write(&self, (): &()) -> Json {
        self.0.write(&LOAD)
    }
}

/// An even number of cells, which two grids are made of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct EvenCells(usize);

impl Setting for EvenCells {
    type Rule = ();

    fn form((): &()) -> Allowed {
        let [from, to] = CELLS;
        let schema = json!({ "type": "integer", "minimum": from, "maximum": to, "multipleOf": 2 });
        Allowed::Told { schema, words: format!("an even number from {from} to {to}"), keys: Vec::new() }
    }

    fn read(section: &Section<'_>, key: &str, node: &Node, (): &()) -> Result<Self, Fault> {
        let [from, to] = CELLS;
        // one cell is a number of cells as well: the message of those that cannot be halved says more
        match whole(&section.path(key), node, 1, to)? {
            found if found < from || !found.is_multiple_of(2) => {
                Err(ContactProblem::Cells { from, to, found }.at(node.place))
            }
            cells => Ok(Self(cells)),
        }
    }

    fn write(&self, (): &()) -> Json {
        Setting::write(&self.0, &Whole { from: CELLS[0], to: CELLS[1] })
    }
}
