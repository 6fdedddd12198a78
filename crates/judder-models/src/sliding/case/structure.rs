//! `[[structure]]`: the two structures of a sliding case.

use std::path::Path;

use super::plain_name::PlainName;
use super::problem::SlidingProblem;
use crate::entries::Scope;
use crate::structure::case::damping::Damping;
use crate::structure::case::reduction::ReductionSettings;
use crate::structure::case::{Matrices, StructureSource};
use judder_keys::Settings;
use judder_keys::declared::{Allowed, Setting, both, read_settings};
use judder_keys::document::{Data, Node};
use judder_keys::error::Fault;
use judder_keys::problem::Placed;
use judder_keys::section::{Section, list};
use serde_json::Value as Json;

/// One of the two structures: a beam, a block, a mesh or matrices.
#[derive(Debug, Clone, Settings)]
#[settings(check = SlidingStructure::complete)]
pub struct SlidingStructure {
    /// By which keys call this structure.
    #[key(rule = "structure", example = "\"…\", by which keys call this structure")]
    pub name: PlainName,
    /// Where it comes from.
    #[key(flatten)]
    pub source: StructureSource,
    /// Its own damping; matrices have theirs.
    #[key(omitted)]
    damping: Option<Damping>,
    /// The modes that its reduction keeps, and what freedoms it keeps beside those that contact, load and observed points need.
    #[key(default)]
    pub reduction: ReductionSettings,
}

impl SlidingStructure {
    /// Fills in the damping of a body.
    fn complete(&mut self, _: &Section<'_>) -> Result<(), Fault> {
        if let StructureSource::Body(_) = self.source {
            self.damping.get_or_insert_default();
        }
        Ok(())
    }

    /// Its own damping; none of matrices, which have theirs.
    pub fn damping(&self) -> Damping {
        self.damping.clone().unwrap_or_default()
    }

    /// The canonical form.
    pub(super) fn written(&self) -> Json {
        match &self.source {
            StructureSource::Body(body) => body.written(self.write(&())),
            StructureSource::Matrices(_) => self.write(&()),
        }
    }

    /// How messages call it and its keys, by its name where it has one.
    fn titles(section: &Section<'_>) -> (String, String) {
        let name = section.get("name").map(|node| PlainName::read(section, "name", node, &"structure"));
        match name {
            Some(Ok(name)) => (format!("structure.{name}"), format!("the structure `{name}`")),
            _ => ("structure".to_owned(), "a structure".to_owned()),
        }
    }

    fn read_item(node: &Node) -> Result<Self, Fault> {
        let (path, title) = Self::titles(&Section::of_table(node, "structure", "a structure")?);
        read_settings(node, &path, &title)
    }

    /// Finds the files, which are relative to `folder`, compiles factors, and refuses kept freedoms that it cannot have.
    fn found(mut self, node: &Node, scope: &Scope<'_>, folder: &Path) -> Result<Self, Fault> {
        let (path, title) = (format!("structure.{}", self.name), format!("the structure `{}`", self.name));
        let section = Section::of_table(node, &path, &title)?;
        self.source = self.source.found(&section, scope, folder)?;
        if let StructureSource::Matrices(Matrices::Arrays(_)) = self.source {
            let problem = SlidingProblem::Arrays { name: self.name.to_string() };
            return Err(problem.at(section.place_of(&["matrices"])));
        }
        match section.inner("reduction")? {
            Some(own) => self.reduction.admit(&own, &self.source).map(|()| self),
            None => Ok(self),
        }
    }
}

/// The two structures in the order of the case file.
#[derive(Debug)]
pub(crate) struct Structures([SlidingStructure; 2]);

impl Structures {
    /// Finds the files of both, which are relative to `folder`; factors of matrices are expressions of the parameters.
    pub(super) fn found(
        self,
        root: &Section<'_>,
        scope: &Scope<'_>,
        folder: &Path,
    ) -> Result<[SlidingStructure; 2], Fault> {
        let Self([one, other]) = self;
        let Some(Node { data: Data::List(nodes), .. }) = root.get("structure") else {
            return Ok([one, other]);
        };
        let [first, second] = &nodes[..] else { return Ok([one, other]) };
        let found = both(one.found(first, scope, folder), other.found(second, scope, folder));
        found.map(|(one, other)| [one, other])
    }
}

impl Setting for Structures {
    type Rule = ();

    fn form((): &()) -> Allowed {
        Allowed::List { of: Box::new(SlidingStructure::form(&())), length: [2, 2] }
    }

    fn read(_: &Section<'_>, key: &str, node: &Node, (): &()) -> Result<Self, Fault> {
        let nodes = list(key, node)?;
        let [first, second] = nodes else {
            return Err(SlidingProblem::StructureCount { found: nodes.len() }.at(node.place));
        };
        let (one, other) = both(SlidingStructure::read_item(first), SlidingStructure::read_item(second))?;
        if one.name == other.name {
            let (what, name) = ("structure", other.name.to_string());
            return Err(SlidingProblem::NameTwice { what, name }.at(second.place));
        }
        Ok(Self([one, other]))
    }

    fn write(&self, (): &()) -> Json {
        self.0.iter().map(SlidingStructure::written).collect()
    }
}
