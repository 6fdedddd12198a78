//! `[[spring]]` and `[[tie]]`: what joins structures beside contacts.

use super::contact::SurfaceOf;
use super::named_list::NamedItem;
use super::problem::AssemblyProblem;
use super::structure::AssemblyStructure;
use super::vector::{VECTOR, check_direction};
use crate::sliding::case::plain_name::PlainName;
use judder_keys::Settings;
use judder_keys::declared::{Allowed, Number, Setting, both};
use judder_keys::dimension::Dimension;
use judder_keys::document::{Data, Node};
use judder_keys::error::Fault;
use judder_keys::problem::Placed;
use judder_keys::section::{Section, word};
use serde_json::{Value as Json, json};

/// A spring with a damper beside it, between nodes of two structures or to the ground.
#[derive(Debug, Clone, Settings)]
#[settings(check = SpringSettings::check)]
pub struct SpringSettings {
    /// By which keys call this spring.
    #[key(rule = "spring", example = "\"…\", by which keys call this spring")]
    pub name: PlainName,
    /// One end: nodes of a structure, which share its force alike; it feels the mean of their displacements.
    #[key(example = "{ structure = \"…\", set = \"…\" }")]
    pub from: SurfaceOf,
    /// The other end: nodes of a structure, or `ground`, which does not move.
    #[key(default = SpringEnd::Ground)]
    pub to: SpringEnd,
    /// The direction in which it acts, of any length; along the line between the middles of its ends where left out.
    #[key(rule = VECTOR, omitted, example = "[0, 1]")]
    pub direction: Option<Vec<f64>>,
    /// The stiffness of the spring.
    #[key(rule = Number::non_negative(Dimension::STIFFNESS), symbol = "k", default = 0.0)]
    pub stiffness: f64,
    /// The damping of the damper beside it.
    #[key(rule = Number::non_negative(Dimension::DAMPING), symbol = "c", default = 0.0)]
    pub damping: f64,
}

/// What a spring ends at.
#[derive(Debug, Clone, PartialEq)]
pub enum SpringEnd {
    /// What does not move.
    Ground,
    /// Nodes of a structure.
    Nodes(SurfaceOf),
}

impl SpringEnd {
    /// The end in words.
    pub(crate) fn words(&self) -> String {
        match self {
            Self::Ground => GROUND.to_owned(),
            Self::Nodes(nodes) => nodes.words(),
        }
    }
}

/// Nodes of a structure that are bonded to another.
#[derive(Debug, Clone, Settings)]
pub struct Tie {
    /// By which keys call this tie.
    #[key(rule = "tie", example = "\"…\", by which keys call this tie")]
    pub name: PlainName,
    /// The nodes that move as what they are bonded to.
    #[key(example = "{ structure = \"…\", set = \"…\" }")]
    pub from: SurfaceOf,
    /// What they are bonded to: the faces between nodes of another structure, whose mesh need not match, or one node of it.
    #[key(example = "{ structure = \"…\", set = \"…\" }")]
    pub to: SurfaceOf,
}

impl NamedItem for SpringSettings {
    const WHAT: &'static str = "spring";

    fn name(&self) -> &PlainName {
        &self.name
    }
}

impl NamedItem for Tie {
    const WHAT: &'static str = "tie";

    fn name(&self) -> &PlainName {
        &self.name
    }
}

impl SpringSettings {
    /// Refuses a spring that does nothing, and one to the ground that has no direction.
    fn check(&mut self, section: &Section<'_>) -> Result<(), Fault> {
        if self.stiffness == 0.0 && self.damping == 0.0 {
            return Err(AssemblyProblem::IdleSpring.at(section.place));
        }
        match (&self.direction, &self.to) {
            (Some(direction), _) => check_direction(direction, section, &["direction"]),
            (None, SpringEnd::Ground) => Err(AssemblyProblem::GroundWithoutDirection.at(section.place)),
            (None, SpringEnd::Nodes(_)) => Ok(()),
        }
    }

    /// Finds the structures, and refuses nodes that they cannot have.
    pub(super) fn admit(
        &mut self,
        section: &Section<'_>,
        structures: &[AssemblyStructure],
    ) -> Result<(), Fault> {
        let from = admit_end(&mut self.from, "from", section, structures);
        let to = match &mut self.to {
            SpringEnd::Ground => Ok(()),
            SpringEnd::Nodes(nodes) => admit_end(nodes, "to", section, structures),
        };
        both(from, to).map(drop)
    }
}

impl Tie {
    /// Finds the structures, refuses nodes that they cannot have, and a structure that is tied to itself.
    pub(super) fn admit(
        &mut self,
        section: &Section<'_>,
        structures: &[AssemblyStructure],
    ) -> Result<(), Fault> {
        let from = admit_end(&mut self.from, "from", section, structures);
        both(from, admit_end(&mut self.to, "to", section, structures))?;
        if self.from.structure == self.to.structure {
            let name = self.to.structure.name.clone();
            return Err(AssemblyProblem::TiedToItself { name }.at(section.place_of(&["to"])));
        }
        Ok(())
    }
}

fn admit_end(
    nodes: &mut SurfaceOf,
    key: &str,
    section: &Section<'_>,
    structures: &[AssemblyStructure],
) -> Result<(), Fault> {
    section.inner(key)?.map_or(Ok(()), |own| nodes.admit(&own, structures))
}

/// The word for what does not move.
const GROUND: &str = "ground";

impl Setting for SpringEnd {
    type Rule = ();

    fn form((): &()) -> Allowed {
        let ground = Allowed::Choice { words: &[(GROUND, "what does not move")] };
        Allowed::Either(vec![ground, SurfaceOf::form(&())])
    }

    fn read(section: &Section<'_>, key: &str, node: &Node, (): &()) -> Result<Self, Fault> {
        match node.data {
            Data::Table(_) => SurfaceOf::read(section, key, node, &()).map(Self::Nodes),
            _ => word(&section.path(key), "end of a spring", node, &[(GROUND, ())]).map(|()| Self::Ground),
        }
    }

    fn write(&self, (): &()) -> Json {
        match self {
            Self::Ground => json!(GROUND),
            Self::Nodes(nodes) => Setting::write(nodes, &()),
        }
    }
}
