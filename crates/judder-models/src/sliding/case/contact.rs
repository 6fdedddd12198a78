//! `[contact]`: who slides on what, and the friction between them.

use super::plain_name::find_structure;
use super::problem::SlidingProblem;
use super::structure::SlidingStructure;
use crate::structure::case::reduction::KeptNodes;
use judder_keys::Settings;
use judder_keys::cause::Cause;
use judder_keys::declared::{Allowed, Named, Number, Setting, Several, both};
use judder_keys::dimension::Dimension;
use judder_keys::document::{Data, Node};
use judder_keys::error::Fault;
use judder_keys::problem::Placed;
use judder_keys::section::Section;
use judder_sliding::edge::Interpolation;
use serde_json::Value as Json;

/// Who slides on what, and friction.
#[derive(Debug, Clone, PartialEq, Settings)]
pub struct SlidingContact {
    /// The slider, and its contact point C, one node.
    #[key(example = "{ structure = \"…\", set = \"end-lower\" }")]
    pub slider: NodesOf,
    /// The other structure, and the nodes of its edge in their order: positions count from the first.
    #[key(example = "{ structure = \"…\", set = \"upper-corners\" }")]
    pub track: NodesOf,
    /// Friction coefficient, or a table against the sliding speed.
    #[key(name = "friction_coefficient", symbol = "μ", default = FrictionCoefficient::Constant(0.3))]
    pub friction: FrictionCoefficient,
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

/// The friction coefficient.
#[derive(Debug, Clone, PartialEq)]
pub enum FrictionCoefficient {
    /// μ, whatever the speed.
    Constant(f64),
    /// μ against the sliding speed.
    Table(FrictionTableSettings),
}

/// Friction against the sliding speed.
#[derive(Debug, Clone, PartialEq, Settings)]
#[settings(check = FrictionTableSettings::check)]
pub struct FrictionTableSettings {
    /// Sliding speeds, ascending, two at least.
    #[key(rule = SPEEDS, symbol = "v", example = "[\"0 mm/s\", \"10 mm/s\"]")]
    pub velocity: Vec<f64>,
    /// Friction coefficients there, linear between the speeds and constant beyond them.
    #[key(rule = COEFFICIENTS, symbol = "μ(v)", example = "[0.4, 0.3]")]
    pub coefficient: Vec<f64>,
}

const COEFFICIENT: Number = Number::non_negative(Dimension::NUMBER);
const COEFFICIENTS: Several<Number> = Several { of: COEFFICIENT, length: [2, usize::MAX] };
const SPEEDS: Several<Number> =
    Several { of: Number::non_negative(Dimension::SPEED), length: [2, usize::MAX] };

impl SlidingContact {
    /// Finds the structures, and refuses nodes that they cannot have and a structure that slides on itself.
    pub(super) fn admit(
        &mut self,
        section: &Section<'_>,
        structures: &[SlidingStructure; 2],
    ) -> Result<(), Fault> {
        let slider = self.slider.admit(section, "slider", structures).and_then(|()| {
            check_one_node(&section.path("slider"), &self.slider.nodes)
                .map_err(|problem| problem.at(section.place_of(&["slider"])))
        });
        both(slider, self.track.admit(section, "track", structures))?;
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

impl Setting for FrictionCoefficient {
    type Rule = ();

    fn form((): &()) -> Allowed {
        Allowed::Either(vec![f64::form(&COEFFICIENT), FrictionTableSettings::form(&())])
    }

    fn read(section: &Section<'_>, key: &str, node: &Node, (): &()) -> Result<Self, Fault> {
        match node.data {
            Data::Table(_) => FrictionTableSettings::read(section, key, node, &()).map(Self::Table),
            _ => f64::read(section, key, node, &COEFFICIENT).map(Self::Constant),
        }
    }

    fn write(&self, (): &()) -> Json {
        match self {
            Self::Constant(coefficient) => coefficient.write(&COEFFICIENT),
            Self::Table(table) => table.write(&()),
        }
    }
}

impl FrictionTableSettings {
    /// Refuses columns of different lengths, and speeds that do not ascend.
    fn check(&mut self, section: &Section<'_>) -> Result<(), Fault> {
        let (speeds, coefficients) = (self.velocity.len(), self.coefficient.len());
        if speeds != coefficients || speeds < 2 {
            let problem = SlidingProblem::FrictionTable { speeds, coefficients };
            return Err(problem.at(section.place_of(&["coefficient"])));
        }
        match self.velocity.windows(2).find(|pair| pair[0] >= pair[1]) {
            Some(pair) => {
                let problem = SlidingProblem::UnsortedSpeeds { before: pair[0], speed: pair[1] };
                Err(problem.at(section.place_of(&["velocity"])))
            }
            None => Ok(()),
        }
    }
}
