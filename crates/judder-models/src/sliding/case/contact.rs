//! `[contact]`: who slides on what, and the friction between them.

use super::plain_name::find_structure;
use super::problem::SlidingProblem;
use super::structure::SlidingStructure;
use crate::friction::FrictionSettings;
use crate::structure::case::reduction::KeptNodes;
use judder_keys::Settings;
use judder_keys::cause::Cause;
use judder_keys::declared::{Named, Number, both};
use judder_keys::dimension::Dimension;
use judder_keys::error::Fault;
use judder_keys::problem::Placed;
use judder_keys::section::Section;
use judder_sliding::edge::Interpolation;
use std::path::Path;

/// Who slides on what, and friction.
#[derive(Debug, Clone, PartialEq, Settings)]
pub struct SlidingContact {
    /// The slider, and its contact point C, one node.
    #[key(example = "{ structure = \"…\", set = \"end-lower\" }")]
    pub slider: NodesOf,
    /// The other structure, and the nodes of its edge in their order: positions count from the first.
    #[key(example = "{ structure = \"…\", set = \"upper-corners\" }")]
    pub track: NodesOf,
    /// Friction coefficient: a number, one that falls from rest and may rise again, or a table against the sliding speed.
    #[key(name = "friction_coefficient", symbol = "μ", default = FrictionSettings::Constant(0.3))]
    pub friction: FrictionSettings,
    /// How the edge runs between its nodes.
    #[key(default = Interpolation::Linear)]
    pub interpolation: Interpolation,
    /// Gap between the undeformed structures at the start, closed over the ramp of the gap; below zero a penetration.
    #[key(rule = Number::any(Dimension::LENGTH), symbol = "g_0", default = 0.0)]
    pub initial_gap: f64,
}

/// Nodes of one of the two structures.
#[derive(Debug, Clone, PartialEq, Settings)]
pub struct NodesOf {
    /// The name of a structure.
    #[key(later)]
    pub structure: Named<usize>,
    /// The nodes.
    #[key(flatten)]
    pub nodes: KeptNodes,
}

impl SlidingContact {
    /// Finds the structures, and refuses nodes that they cannot have and a structure that slides on itself.
    pub(super) fn admit(
        &mut self,
        section: &Section<'_>,
        structures: &[SlidingStructure; 2],
        folder: &Path,
    ) -> Result<(), Fault> {
        let friction = self.friction.admit(section, "friction_coefficient", folder);
        let slider = self.slider.admit(section, "slider", structures).and_then(|()| {
            check_one_node(&section.path("slider"), &self.slider.nodes)
                .map_err(|problem| problem.at(section.place_of(&["slider"])))
        });
        both(both(slider, self.track.admit(section, "track", structures)), friction)?;
        let Some(node) = section.get("track") else { return Ok(()) };
        if self.slider.structure == self.track.structure {
            let name = self.track.structure.name.clone();
            return Err(SlidingProblem::SameStructure { name }.at(node.place));
        }
        let KeptNodes::Numbers(nodes) = &self.track.nodes else { return Ok(()) };
        if nodes.len() < 2 {
            let (key, expected) = (section.path("track"), "two nodes at least");
            return Err(Cause::Length { key, expected, found: nodes.len() }.at(node.place));
        }
        let mut own = nodes.iter().enumerate();
        let Some((_, twice)) = own.find(|(index, own)| nodes[..*index].contains(own)) else {
            return Ok(());
        };
        let name = nodes.iter().map(usize::to_string).collect::<Vec<_>>().join(", ");
        let place = node.entry("nodes").map_or(node.place, |nodes| nodes.place);
        Err(SlidingProblem::Track { name, reason: format!("names node {twice} twice") }.at(place))
    }
}

impl NodesOf {
    fn admit(
        &mut self,
        contact: &Section<'_>,
        key: &str,
        structures: &[SlidingStructure; 2],
    ) -> Result<(), Fault> {
        let Some(section) = contact.inner(key)? else { return Ok(()) };
        find_structure(&mut self.structure, structures.iter().map(|own| &own.name), &section)?;
        KeptNodes::admit(&section, &structures[*self.structure].source)
    }
}

/// Refuses numbers of several nodes; a set is counted when there is a mesh.
pub(super) fn check_one_node(key: &str, nodes: &KeptNodes) -> Result<(), SlidingProblem> {
    match nodes {
        KeptNodes::Numbers(nodes) if nodes.len() != 1 => {
            Err(SlidingProblem::NotOneNode { key: key.to_owned(), found: nodes.len() })
        }
        _ => Ok(()),
    }
}
