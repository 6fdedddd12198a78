//! `[[structure]]`: the bodies of an assembly.

use super::named_list::NamedItem;
use super::rotation::BodyRotation;
use crate::entries::Scope;
use crate::sliding::case::plain_name::PlainName;
use crate::structure::case::damping::Damping;
use crate::structure::case::reduction::{FIXED_MODES_LIMIT, FixedModes};
use crate::structure::case::{Matrices, StructureSource};
use judder_keys::cause::Cause;
use judder_keys::declared::{Allowed, Number, Setting, Settings as _, Several, Whole};
use judder_keys::dimension::Dimension;
use judder_keys::document::{Data, Node};
use judder_keys::error::Fault;
use judder_keys::section::{Section, word};
use judder_keys::{Settings, declared};
use serde_json::{Map, Value as Json, json};
use std::path::Path;

/// A body of an assembly: a beam, a block, a disc, a mesh or matrices.
#[derive(Debug, Clone, Settings)]
#[settings(check = AssemblyStructure::complete)]
pub struct AssemblyStructure {
    /// By which keys call this structure.
    #[key(rule = "structure", example = "\"…\", by which keys call this structure")]
    pub name: PlainName,
    /// Where it comes from.
    #[key(flatten)]
    pub source: StructureSource,
    /// Its own damping; matrices have theirs.
    #[key(omitted)]
    damping: Option<Damping>,
    /// Point masses on sets of nodes.
    #[key(rule = MASSES, default = Vec::new())]
    pub masses: Vec<PointMass>,
    /// How it turns; a body that does not where left out.
    #[key(omitted)]
    pub rotation: Option<BodyRotation>,
    /// Whether it is reduced to the freedoms that contacts and loads need and so many of its modes; `none` keeps the whole body.
    #[key(default = BodyReduction::None)]
    pub reduction: BodyReduction,
}

/// A mass on the nodes of a set.
#[derive(Debug, Clone, PartialEq, Settings)]
#[settings(title = "an entry of `{path}`")]
pub struct PointMass {
    /// The set of nodes.
    #[key(example = "\"…\", a set of nodes")]
    pub set: String,
    /// The mass of all nodes of the set together, which share it alike.
    #[key(rule = Number::positive(Dimension::MASS), symbol = "m")]
    pub mass: f64,
}

const MASSES: Several<()> = Several { of: (), length: [0, usize::MAX] };

/// Whether a body is reduced.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum BodyReduction {
    /// The whole body.
    None,
    /// The freedoms that contacts and loads need, and fixed-interface modes.
    Modes(ReducedBody),
}

/// What is left of a body that is reduced.
#[derive(Debug, Clone, Copy, PartialEq, Settings)]
pub struct ReducedBody {
    /// The fixed-interface modes that are kept.
    #[key(flatten)]
    pub modes: FixedModes,
    /// Interface modes to which the freedoms of its contacts are reduced, all of which must be compliant; none where left out: each freedom is kept.
    #[key(rule = Whole { from: 1, to: FIXED_MODES_LIMIT }, omitted)]
    pub interface_modes: Option<usize>,
}

impl AssemblyStructure {
    /// Fills in the damping of a body, and refuses masses where there are no sets, and rotation of what cannot turn.
    fn complete(&mut self, section: &Section<'_>) -> Result<(), Fault> {
        if let Some(rotation) = &self.rotation {
            rotation.admit(section, &self.source)?;
        }
        match (&self.source, section.get("masses")) {
            (StructureSource::Body(_), _) => {
                self.damping.get_or_insert_default();
                Ok(())
            }
            (StructureSource::Matrices(Matrices::Files(_)), Some(node)) if !self.masses.is_empty() => {
                Err(Cause::Meaningless { key: "masses", with: section.path("matrices") }.at(node.place))
            }
            (StructureSource::Matrices(_), _) => Ok(()),
        }
    }

    /// Its own damping; none of matrices, which have theirs.
    pub fn damping(&self) -> Damping {
        self.damping.clone().unwrap_or_default()
    }

    /// Finds the files, which are relative to `folder`, and compiles factors and entries.
    pub(super) fn found(
        mut self,
        section: &Section<'_>,
        scope: &Scope<'_>,
        folder: &Path,
    ) -> Result<Self, Fault> {
        self.source = self.source.found(section, scope, folder)?;
        Ok(self)
    }
}

impl NamedItem for AssemblyStructure {
    const WHAT: &'static str = "structure";

    fn name(&self) -> &PlainName {
        &self.name
    }

    fn written(&self) -> Json {
        let mut json = Map::new();
        self.write_table(&mut json);
        match &self.source {
            StructureSource::Body(body) => body.written(Json::Object(json)),
            StructureSource::Matrices(_) => Json::Object(json),
        }
    }
}

/// The word for no reduction.
const NONE: &str = "none";

impl Setting for BodyReduction {
    type Rule = ();

    fn form((): &()) -> Allowed {
        let whole = Allowed::Choice { words: &[(NONE, "the whole body")] };
        Allowed::Either(vec![whole, ReducedBody::form(&())])
    }

    fn read(section: &Section<'_>, key: &str, node: &Node, (): &()) -> Result<Self, Fault> {
        match node.data {
            Data::Table(_) => {
                let path = section.path(key);
                declared::read_settings(node, &path, &format!("`{path}`")).map(Self::Modes)
            }
            _ => word(&section.path(key), "reduction", node, &[(NONE, Self::None)]),
        }
    }

    fn write(&self, (): &()) -> Json {
        match self {
            Self::None => json!(NONE),
            Self::Modes(modes) => Setting::write(modes, &()),
        }
    }
}
