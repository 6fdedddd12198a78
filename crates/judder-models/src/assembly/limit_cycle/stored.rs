//! A cycle as a study has it stored, so that another begins there: with a key of another value, with more harmonics, on another machine.
//!
//! The harmonics of the contact forces and the mean gaps are all that a cycle is: what its points do over a period follows from them.

#![deny(clippy::indexing_slicing, reason = "stored arrays may be of any length")]

use crate::assembly::AssemblySubject;
use crate::assembly::build::Unassembled;
use crate::assembly::case::problem::AssemblyProblem;
use crate::error::ModelError;
use faer::Mat;
use judder_cycles::cycle::AssemblyCycle;
use judder_cycles::near::ForcesOverPeriod;
use judder_keys::cause::Cause;
use judder_keys::declared::{Allowed, Setting};
use judder_keys::document::Node;
use judder_keys::error::Fault;
use judder_keys::file_reference::{FileReference, PathFault, find_folder};
use judder_keys::problem::Placed;
use judder_keys::section::{Section, text};
use judder_nonsmooth::contact::ContactPoints;
use judder_store::{DatasetHead, StoreError, StudyReader, Variable, VariableValues};
use judder_study::WrongArray;
use num_complex::Complex64;
use serde_json::{Value as Json, json};
use std::f64::consts::TAU;
use std::path::{Path, PathBuf};

/// The variables and attributes of which a cycle is made again.
const FORCES: &str = "point_force_harmonics";
pub(super) const GAP: &str = "gap";
const CONTACT: &str = "contact";
pub(super) const FREQUENCY: &str = "frequency_hz";
pub(super) const SCALED_AT: &str = "scaled_at_hz";

/// Λ_h of the points.
pub(super) fn force_harmonics(cycle: &AssemblyCycle<'_>) -> Result<[Variable; 3], ModelError> {
    let signals = cycle.balance.signals_at(&cycle.motion.unknown, cycle.motion.turning)?;
    let (width, points) = (cycle.balance.contact().dimension, cycle.points.len());
    let harmonics = cycle.balance.series().harmonics();
    let value = |h: usize, component: usize| match h {
        0 => Complex64::from(signals.forces[(0, component)]),
        h => Complex64::new(signals.forces[(2 * h - 1, component)], -signals.forces[(2 * h, component)]),
    };
    let values = (0..=harmonics).flat_map(|h| (0..points * width).map(move |component| (h, component)));
    let values: Vec<Complex64> = values.map(|(h, component)| value(h, component)).collect();
    let directions = ["normal", "along the slip", "across the slip"].map(str::to_owned);
    let shape = [harmonics + 1, points, width];
    Ok([
        Variable::coordinate("harmonic", (0..=harmonics as i64).collect::<Vec<_>>())
            .long_name("number of the harmonic, 0 the mean"),
        Variable::coordinate("direction", directions.into_iter().take(width).collect::<Vec<_>>())
            .long_name("direction of a contact force"),
        Variable::new(FORCES, &["harmonic", "contact_point", "direction"], &shape, values)
            .units("N")
            .long_name("harmonics of the force on the slider at each contact point, Re Λ exp(i h ω t)"),
    ])
}

/// A finished study.
#[derive(Debug, Clone, PartialEq)]
pub struct StudyReference {
    /// Its folder as the case file has it.
    given: String,
    /// The path from the folder in which the program runs.
    path: PathBuf,
    /// The files of it that results depend on.
    files: Vec<FileReference>,
}

impl Setting for StudyReference {
    type Rule = ();

    fn form((): &()) -> Allowed {
        Allowed::File
    }

    fn read(section: &Section<'_>, key: &str, node: &Node, (): &()) -> Result<Self, Fault> {
        let given = text(&section.path(key), node)?.to_owned();
        Ok(Self { path: PathBuf::from(&given), given, files: Vec::new() })
    }

    fn write(&self, (): &()) -> Json {
        json!(self.given)
    }
}

impl StudyReference {
    /// Finds the study under `key` of a section, relative to `folder`, and in it the files of an analysis.
    pub(super) fn find(
        &mut self,
        section: &Section<'_>,
        key: &str,
        folder: &Path,
        analysis: &str,
    ) -> Result<(), Fault> {
        let Some(node) = section.get(key) else { return Ok(()) };
        let refused = |path, fault| Cause::File { key: section.path(key), path, fault }.at(node.place);
        self.path = find_folder(&self.given, node, folder).map_err(|(path, fault)| refused(path, fault))?;
        let no_study = |error: StoreError| match error {
            StoreError::NoStudy { path } => refused(path, PathFault::NotStudy),
            error => {
                let reason = self.damage(&error).unwrap_or_else(|| error.to_string());
                AssemblyProblem::Refused { reason }.at(node.place)
            }
        };
        let study = StudyReader::open(&self.path).map_err(no_study)?;
        let known = study.names().map_err(no_study)?;
        if !known.iter().any(|name| name == analysis) {
            let reason = self.without(analysis, &known);
            return Err(AssemblyProblem::Refused { reason }.at(section.place_of(&["analysis"])));
        }
        let files = study.files_of(analysis, &[FORCES, GAP, CONTACT]).map_err(no_study)?;
        let reference = |path: PathBuf| {
            let below = path.strip_prefix(study.path()).unwrap_or(&path);
            let parts: Vec<_> = below.iter().map(|own| own.to_string_lossy()).collect();
            FileReference { given: format!("{}/{}", self.given, parts.join("/")), path }
        };
        self.files = files.into_iter().map(reference).collect();
        Ok(())
    }

    /// That it has no results of an analysis, but of others.
    fn without(&self, analysis: &str, known: &[String]) -> String {
        let known: Vec<String> = known.iter().map(|name| format!("`{name}`")).collect();
        let others = if known.is_empty() {
            "and none at all".to_owned()
        } else {
            format!("but of {}", known.join(", "))
        };
        format!("the study `{}` has no results of `{analysis}`, {others}", self.given)
    }

    /// What of it is damaged, where an error says so, and what mends it: it is another study than the one that is run.
    fn damage(&self, error: &StoreError) -> Option<String> {
        let (path, what) = match error {
            StoreError::DatasetUnreadable { path, source } => (path, source.to_string()),
            StoreError::SummaryUnreadable { path, source } => (path, source.to_string()),
            StoreError::Damaged { path, damage } => (path, damage.to_string()),
            StoreError::Oversized { path, size, .. } => (path, format!("it has {size} bytes")),
            _ => return None,
        };
        let root = self.path.canonicalize().unwrap_or_else(|_| self.path.clone());
        let below = path.strip_prefix(&root).unwrap_or(path);
        Some(self.damaged(&format!("`{}` cannot be read ({what})", below.display())))
    }

    fn damaged(&self, what: &str) -> String {
        format!(
            "the study `{}` at which the cycle begins is damaged: {what}; run the case of that study again with `-o {}`, or name another study",
            self.given,
            self.path.display()
        )
    }

    /// The files of it that results depend on.
    pub(super) fn files(&self) -> &[FileReference] {
        &self.files
    }

    /// The cycle that an analysis of it has found, for an assembly of the same contact points.
    pub(super) fn cycle(
        &self,
        analysis: &str,
        of: &AssemblySubject<'_>,
    ) -> Result<Result<ForcesOverPeriod, Unassembled>, ModelError> {
        let refused = |reason: &str| Ok(Err(Unassembled::because("start.study", &reason)));
        let unread = |error: StoreError| match self.damage(&error) {
            Some(reason) => refused(&reason),
            None => Err(error.into()),
        };
        let study = StudyReader::open(&self.path)?;
        let head = match study.head(analysis) {
            Ok(head) => head,
            Err(error) => return unread(error),
        };
        if let Err(reason) = holds_a_cycle(&head, analysis) {
            return Ok(Err(Unassembled::because("start.analysis", &reason)));
        }
        let read = |name: &str| study.read_rows(analysis, name, 0..usize::MAX);
        let all = read(FORCES).and_then(|forces| Ok((forces, read(GAP)?, read(CONTACT)?)));
        let (forces, gaps, contacts) = match all {
            Ok(all) => all,
            Err(error) => return unread(error),
        };
        let stored = match StoredCycle::new(&head, &forces, &gaps, contacts) {
            Ok(stored) => stored,
            Err(wrong) => return refused(&self.damaged(&format!("of `{analysis}` {wrong}"))),
        };
        let width = ContactPoints::new(&of.built.assembly, &[])?.dimension;
        let own = of.built.assembly.interfaces.iter();
        let own: Vec<(&str, usize)> = own.map(|own| (own.name.as_str(), own.points.len())).collect();
        match stored.is_of(&own, width) {
            Ok(()) => Ok(Ok(stored.known())),
            Err(reason) => refused(&reason),
        }
    }
}

/// Why an analysis has stored no cycle to begin from.
fn holds_a_cycle(head: &DatasetHead, analysis: &str) -> Result<(), String> {
    let has = |name: &str| head.variables.iter().any(|own| own.name == name);
    let kind = head.attributes.get("kind").and_then(Json::as_str).unwrap_or("sweep");
    if kind != super::KIND.name {
        return Err(format!(
            "`{analysis}` of the study is a `{kind}`: a cycle begins at one that a `{}` has found",
            super::KIND.name
        ));
    }
    match [has(GAP), has(FORCES)] {
        [true, true] => Ok(()),
        [true, false] => Err(format!(
            "`{analysis}` of the study is of an earlier version, which stored no harmonics of contact forces: run its case again"
        )),
        [false, _] => {
            Err(format!("`{analysis}` of the study has found no cycle, or is not one of an assembly"))
        }
    }
}

/// What is stored of a cycle.
struct StoredCycle<'a> {
    /// ω and that at which the scales were taken, in rad/s.
    turning: [f64; 2],
    forces: &'a [Complex64],
    /// Harmonics with the mean, points, directions.
    shape: [usize; 3],
    gaps: &'a [f64],
    /// The contact of each point.
    contacts: Vec<String>,
}

impl<'a> StoredCycle<'a> {
    /// In words what of it is not what judder writes.
    fn new(
        head: &DatasetHead,
        forces: &'a Variable,
        gaps: &'a Variable,
        contacts: Variable,
    ) -> Result<Self, String> {
        let wrong = |own: &Variable, expected: &str| {
            let WrongArray { array, found, expected, .. } = WrongArray::of(own, expected.to_owned());
            format!("the array `{array}` is {found}, where {expected} is right")
        };
        let turning = [FREQUENCY, SCALED_AT].map(|name| head.attributes.get(name).and_then(Json::as_f64));
        let [Some(frequency), Some(scaled_at)] = turning.map(|own| own.map(|own| TAU * own)) else {
            return Err(format!("the attributes have no numbers `{FREQUENCY}` and `{SCALED_AT}`"));
        };
        let of_forces = "one of finite complex numbers over harmonics, points and directions";
        let (Ok(shape), VariableValues::Complex(values)) =
            (<[usize; 3]>::try_from(forces.shape.clone()), &forces.data)
        else {
            return Err(wrong(forces, of_forces));
        };
        let of_gaps = "one of finite real numbers over instants and points";
        let (VariableValues::F64(own_gaps), [_, _]) = (&gaps.data, gaps.shape.as_slice()) else {
            return Err(wrong(gaps, of_gaps));
        };
        let of_contacts = wrong(&contacts, "one of words over points");
        let VariableValues::Text(contacts) = contacts.data else { return Err(of_contacts) };
        let [harmonics, points, _] = shape;
        if harmonics < 2 || points == 0 || values.iter().any(|own| !own.is_finite()) {
            return Err(wrong(forces, of_forces));
        }
        if own_gaps.is_empty()
            || gaps.shape.last() != Some(&points)
            || own_gaps.iter().any(|own| !own.is_finite())
        {
            return Err(wrong(gaps, of_gaps));
        }
        if contacts.len() != points {
            return Err(of_contacts);
        }
        if ![frequency, scaled_at].iter().all(|own| own.is_finite() && *own > 0.0) {
            return Err(format!("the attributes `{FREQUENCY}` and `{SCALED_AT}` are no frequencies"));
        }
        Ok(Self { turning: [frequency, scaled_at], forces: values, shape, gaps: own_gaps, contacts })
    }

    /// Whether its points are those of contacts with so many points each, in as many directions; in words why not.
    fn is_of(&self, contacts: &[(&str, usize)], width: usize) -> Result<(), String> {
        let mut stored: Vec<(&str, usize)> = Vec::new();
        for name in &self.contacts {
            match stored.last_mut() {
                Some((last, count)) if last == name => *count += 1,
                _ => stored.push((name, 1)),
            }
        }
        let touching: Vec<(&str, usize)> = contacts.iter().copied().filter(|(_, count)| *count > 0).collect();
        if stored == touching && self.shape[2] == width {
            return Ok(());
        }
        let words = |all: &[(&str, usize)], width: usize| {
            let each: Vec<String> = all.iter().map(|(name, count)| format!("{count} of `{name}`")).collect();
            format!("{}, {}", each.join(", "), if width == 2 { "in the plane" } else { "in space" })
        };
        Err(format!(
            "the stored cycle is one of other contact points: {}; the case has {}",
            words(&stored, self.shape[2]),
            words(&touching, width),
        ))
    }

    fn known(&self) -> ForcesOverPeriod {
        let [with_mean, points, width] = self.shape;
        let components = points * width;
        let coefficients = Mat::from_fn(2 * with_mean - 1, components, |row, component| {
            let own = self.forces.get(row.div_ceil(2) * components + component).copied().unwrap_or_default();
            if row > 0 && row % 2 == 0 { -own.im } else { own.re }
        });
        let instants = (self.gaps.len() / points) as f64;
        let mean = |point: usize| self.gaps.iter().skip(point).step_by(points).sum::<f64>() / instants;
        let [frequency, scaled_at] = self.turning;
        ForcesOverPeriod::balanced(
            frequency,
            scaled_at,
            coefficients.as_ref(),
            (0..points).map(mean).collect(),
        )
    }
}
