//! Analyses: a name that serves as a file name, and a kind with its settings.

use judder_keys::cause::Cause;
use judder_keys::declared::Declaration;
use judder_keys::document::{Data, Node};
use judder_keys::error::Fault;
use judder_keys::section::{Section, text, wrong_type};

/// One analysis of a case.
#[derive(Debug, Clone, PartialEq)]
pub struct Analysis<Kind> {
    /// Unique in its case, safe as a file name; the kind where the case gives none.
    pub name: String,
    /// What is computed.
    pub kind: Kind,
}

/// A kind of analysis: its name, what is said of its keys besides `name` and `kind`, and how those are read.
pub(crate) struct Kind<S, T> {
    pub(crate) name: &'static str,
    pub(crate) doc: &'static str,
    pub(crate) declared: fn() -> Vec<Declaration>,
    pub(crate) read: fn(&S, &Section<'_>) -> Result<T, Fault>,
}

impl<S, T> Kind<S, T> {
    /// A kind whose keys are declared.
    pub(crate) const fn declared(
        name: &'static str,
        doc: &'static str,
        declared: fn() -> Vec<Declaration>,
        read: fn(&S, &Section<'_>) -> Result<T, Fault>,
    ) -> Self {
        Self { name, doc, declared, read }
    }

    /// The names of its keys besides `name` and `kind`.
    pub(crate) fn keys(&self) -> Vec<&'static str> {
        (self.declared)().iter().map(|key| key.name).collect()
    }
}

/// Every other kind of any model.
const OTHER_MODELS: [&str; 24] = [
    "spectrum",
    "stability-map",
    "motion",
    "bifurcation",
    "limit-cycle",
    "basin",
    "engines",
    "equivalent-damping",
    "critical-shear-strength",
    "critical-load",
    "critical",
    "contact",
    "contact-law",
    "fit",
    "modulus",
    "transient",
    "modes",
    "reduction",
    "locus",
    "march",
    "growth",
    "spectrogram",
    "eigen",
    "eigen-sweep",
];

/// Reads `[[analysis]]`: each kind is looked up among `kinds`, and reads its own keys.
pub(crate) fn read_analyses<S, T>(
    root: &Section<'_>,
    keys: &S,
    kinds: &[Kind<S, T>],
) -> Result<Vec<Analysis<T>>, Fault> {
    let Some(node) = root.get("analysis") else { return Ok(Vec::new()) };
    let mut analyses: Vec<Analysis<T>> = Vec::new();
    let Data::List(nodes) = &node.data else {
        return Err(wrong_type("analysis", "a list, each item headed [[analysis]]", node));
    };
    // what is wrong with one analysis does not hide what is wrong with another
    let mut fault: Option<Fault> = None;
    for node in nodes {
        match read_analysis(node, keys, kinds, &analyses) {
            Ok(analysis) => analyses.push(analysis),
            Err(other) => {
                fault = Some(match fault {
                    Some(first) => first.and(other),
                    None => other,
                });
            }
        }
    }
    fault.map_or(Ok(analyses), Err)
}

/// Reads one analysis, whose name the ones before must not have.
fn read_analysis<S, T>(
    node: &Node,
    keys: &S,
    kinds: &[Kind<S, T>],
    before: &[Analysis<T>],
) -> Result<Analysis<T>, Fault> {
    let kind = find_kind(node, kinds)?;
    let known = [vec!["name", "kind"], kind.keys()].concat();
    let section = Section::open(node, "", &format!("an analysis of kind `{}`", kind.name), &known)?;
    let name = section.text("name")?.unwrap_or(kind.name).to_owned();
    let place = section.get("name").map_or(node.place, |name| name.place);
    if !is_file_name(&name) {
        return Err(Cause::BadName { name }.at(place));
    }
    if before.iter().any(|other| other.name.eq_ignore_ascii_case(&name)) {
        return Err(Cause::DuplicateName { name }.at(place));
    }
    Ok(Analysis { name, kind: (kind.read)(keys, &section)? })
}

/// The kind of one analysis; it decides which keys the analysis may have.
fn find_kind<'k, S, T>(node: &Node, kinds: &'k [Kind<S, T>]) -> Result<&'k Kind<S, T>, Fault> {
    let Data::Table(table) = &node.data else { return Err(wrong_type("analysis", "a table", node)) };
    let known: Vec<_> = kinds.iter().map(|kind| kind.name.to_owned()).collect();
    let Some(entry) = table.get("kind") else {
        let expected = format!("kind = \"…\", one of {}", known.join(", "));
        let (key, section) = ("kind".to_owned(), "this analysis".to_owned());
        return Err(Cause::MissingKey { key, section, expected }.at(node.place));
    };
    let name = text("kind", &entry.node)?;
    if let Some(kind) = kinds.iter().find(|kind| kind.name == name) {
        return Ok(kind);
    }
    let (what, place) = ("analysis kind", entry.node.part(0..name.len()));
    let name = name.to_owned();
    Err(if OTHER_MODELS.contains(&name.as_str()) {
        Cause::OtherModel { name, known }
    } else {
        Cause::UnknownName { what, name, known }
    }
    .at(place))
}

/// Whether a name is a plain file name on every system.
pub(crate) fn is_file_name(name: &str) -> bool {
    let plain = |byte: u8| byte.is_ascii_alphanumeric() || matches!(byte, b'.' | b'_' | b'-');
    (1..=100).contains(&name.len()) && !name.starts_with('.') && name.bytes().all(plain)
}
