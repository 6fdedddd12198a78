//! `[[load]]`: forces, pressures and imposed displacements on sets of nodes.

use super::problem::AssemblyProblem;
use super::structure::AssemblyStructure;
use crate::sliding::case::plain_name::find_structure;
use crate::structure::case::reduction::KeptNodes;
use judder_keys::Settings;
use judder_keys::declared::{Named, Number};
use judder_keys::dimension::Dimension;
use judder_keys::error::Fault;
use judder_keys::problem::Placed;
use judder_keys::section::Section;
use judder_structure::freedom::Direction;

/// What acts on the nodes of a set.
#[derive(Debug, Clone, PartialEq, Settings)]
#[settings(title = "a load", check = Load::check)]
pub struct Load {
    /// The name of a structure.
    #[key(later)]
    pub structure: Named<usize>,
    /// The nodes.
    #[key(flatten)]
    pub nodes: KeptNodes,
    /// The direction of a force or a displacement.
    #[key(omitted)]
    pub direction: Option<Direction>,
    /// What acts.
    #[key(flatten)]
    pub amount: LoadAmount,
}

/// What acts on the nodes of a set.
#[derive(Debug, Clone, Copy, PartialEq, Settings)]
pub enum LoadAmount {
    /// The force on all nodes together, along the direction, which all nodes share alike.
    #[key(rule = Number::any(Dimension::FORCE), symbol = "F")]
    Force(f64),
    /// The pressure on the surface between the nodes.
    #[key(rule = Number::any(Dimension::STRESS), symbol = "p")]
    Pressure(f64),
    /// The displacement of nodes that a support holds in this direction.
    #[key(rule = Number::any(Dimension::LENGTH), symbol = "u")]
    Displacement(f64),
}

impl Load {
    /// Refuses a force or displacement without a direction, and a pressure with one.
    fn check(&mut self, section: &Section<'_>) -> Result<(), Fault> {
        let (kind, wants) = match self.amount {
            LoadAmount::Force(_) => ("force", true),
            LoadAmount::Pressure(_) => ("pressure", false),
            LoadAmount::Displacement(_) => ("displacement", true),
        };
        match (wants, self.direction) {
            (true, None) => {
                Err(AssemblyProblem::LoadDirection { kind, what: "needs a `direction`" }.at(section.place))
            }
            (false, Some(_)) => {
                let problem = AssemblyProblem::LoadDirection { kind, what: "has no `direction`" };
                Err(problem.at(section.place_of(&["direction"])))
            }
            _ => Ok(()),
        }
    }

    /// The nodes in words.
    pub(crate) fn set(&self) -> String {
        self.nodes.words()
    }

    /// Finds the structure, and refuses nodes that it cannot have.
    pub(super) fn admit(
        &mut self,
        section: &Section<'_>,
        structures: &[AssemblyStructure],
    ) -> Result<(), Fault> {
        find_structure(&mut self.structure, structures.iter().map(|own| &own.name), section)?;
        KeptNodes::admit(section, &structures[*self.structure].source)
    }
}
