//! `chamfer` of a block: what is cut off where a face of it ends.

use judder_keys::Settings;
use judder_keys::error::Fault;
use judder_keys::problem::{Placed, Problem};
use judder_keys::section::Section;
use judder_structure::chamfer::{BoxSide, Chamfer, ChamferedFace, LEFT};
use judder_study::text::short;
use thiserror::Error;

/// A face of a block, and what is cut off where it ends.
#[derive(Debug, Clone, PartialEq, Settings)]
pub struct ChamferSettings {
    /// The face that is cut. Its set of nodes is what the chamfers leave of it, each flank is a set of its own, `chamfer-x-min`, …, and `y-min-whole` the face with its flanks.
    pub face: BoxSide,
    /// What is cut off where the face meets the side `x-min`.
    #[key(name = "x-min", omitted)]
    pub x_min: Option<Chamfer>,
    /// What is cut off where it meets `x-max`.
    #[key(name = "x-max", omitted)]
    pub x_max: Option<Chamfer>,
    /// What is cut off where it meets `y-min`.
    #[key(name = "y-min", omitted)]
    pub y_min: Option<Chamfer>,
    /// What is cut off where it meets `y-max`.
    #[key(name = "y-max", omitted)]
    pub y_max: Option<Chamfer>,
    /// What is cut off where it meets `z-min`, in space.
    #[key(name = "z-min", omitted)]
    pub z_min: Option<Chamfer>,
    /// What is cut off where it meets `z-max`, in space.
    #[key(name = "z-max", omitted)]
    pub z_max: Option<Chamfer>,
}

impl ChamferSettings {
    /// The face as it is cut.
    pub(crate) fn chamfered(&self) -> ChamferedFace {
        let (end, _) =
            self.cuts().next().unwrap_or((self.face, Chamfer { length: 0.0, depth: 0.0, cells: 0 }));
        let along = end.axis();
        let at = |end: BoxSide| self.cuts().find(|(own, _)| *own == end).map(|(_, own)| own);
        ChamferedFace { face: self.face, along, cuts: BoxSide::BY_AXIS[along].map(at) }
    }

    /// The sides at which the face is cut.
    fn cuts(&self) -> impl Iterator<Item = (BoxSide, Chamfer)> {
        let own = [self.x_min, self.x_max, self.y_min, self.y_max, self.z_min, self.z_max];
        BoxSide::BY_AXIS.into_iter().flatten().zip(own).filter_map(|(side, cut)| Some((side, cut?)))
    }

    /// Refuses what a block of this size and with these cells cannot have: sides that are not there, and chamfers that would fold its elements.
    pub(super) fn fits(&self, size: &[f64], cells: &[usize], block: &Section<'_>) -> Result<(), Fault> {
        let Some(section) = block.inner("chamfer")? else { return Ok(()) };
        let face = self.face;
        let sides = || BoxSide::BY_AXIS.into_iter().take(size.len()).flatten();
        if face.axis() >= size.len() {
            let problem = ChamferProblem::NoSide { side: face, known: listed(sides()) };
            return Err(problem.at(section.place_of(&["face"])));
        }
        let ends = || sides().filter(|side| side.axis() != face.axis());
        if let Some((side, _)) = self.cuts().find(|(side, _)| !ends().any(|end| end == *side)) {
            let problem = ChamferProblem::NotAnEnd { face, side, ends: listed(ends()) };
            return Err(problem.at(section.place_of(&[&side.to_string()])));
        }
        let Some((first, _)) = self.cuts().next() else {
            let problem = ChamferProblem::Nothing { face, ends: listed(ends()) };
            return Err(problem.at(section.place));
        };
        if let Some((other, _)) = self.cuts().find(|(side, _)| side.axis() != first.axis()) {
            let problem = ChamferProblem::TwoDirections { face, sides: [first, other] };
            return Err(problem.at(section.place_of(&[&other.to_string()])));
        }
        let place = |end: BoxSide, key: &str| {
            let own = section.inner(&end.to_string())?;
            Ok(own.map_or(section.place, |own| own.place_of(&[key])))
        };
        let (height, width, row) = (size[face.axis()], size[first.axis()], cells[first.axis()]);
        if let Some((end, Chamfer { depth, .. })) =
            self.cuts().find(|(_, own)| own.depth > (1.0 - LEFT) * height)
        {
            return Err(ChamferProblem::Deep { face, end, depth, height }.at(place(end, "depth")?));
        }
        let last = self.cuts().last().map_or(first, |(end, _)| end);
        let length: f64 = self.cuts().map(|(_, own)| own.length).sum();
        if length > (1.0 - LEFT) * width {
            return Err(ChamferProblem::Long { face, length, width }.at(place(last, "length")?));
        }
        let taken: usize = self.cuts().map(|(_, own)| own.cells).sum();
        match taken >= row {
            true => Err(ChamferProblem::Cells { face, taken, row }.at(place(last, "cells")?)),
            false => Ok(()),
        }
    }
}

fn listed(sides: impl Iterator<Item = BoxSide>) -> String {
    sides.map(|side| side.to_string()).collect::<Vec<_>>().join(", ")
}

/// A chamfer that a block cannot have.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum ChamferProblem {
    /// A face that a block of the plane does not have.
    #[error("a block of the plane has no side {side}")]
    NoSide {
        /// As written.
        side: BoxSide,
        /// Its sides.
        known: String,
    },
    /// A face without chamfers.
    #[error("nothing is cut off the face {face}")]
    Nothing {
        /// The face.
        face: BoxSide,
        /// Where it ends.
        ends: String,
    },
    /// A side that does not meet the face.
    #[error("the face {face} does not end at {side}")]
    NotAnEnd {
        /// The face.
        face: BoxSide,
        /// As written.
        side: BoxSide,
        /// Where it ends.
        ends: String,
    },
    /// Chamfers that would meet in a corner.
    #[error("the face {face} is cut at {} and at {}: chamfers that meet in a corner have no grid", sides[0], sides[1])]
    TwoDirections {
        /// The face.
        face: BoxSide,
        /// Across two axes.
        sides: [BoxSide; 2],
    },
    /// A chamfer through the whole block.
    #[error(
        "the chamfer at {end} is {} m deep, and the block {} m high across {face}: it would fold elements",
        short(*.depth), short(*.height)
    )]
    Deep {
        /// The face.
        face: BoxSide,
        /// Where it is cut.
        end: BoxSide,
        /// m.
        depth: f64,
        /// m.
        height: f64,
    },
    /// Chamfers that leave nothing of the face.
    #[error(
        "{} m of the face {face} are cut off, and it is {} m long: the chamfers would fold elements",
        short(*.length), short(*.width)
    )]
    Long {
        /// The face.
        face: BoxSide,
        /// Of all its chamfers, m.
        length: f64,
        /// m.
        width: f64,
    },
    /// Chamfers that leave no cell of the face.
    #[error(
        "chamfers take {taken} cells of the face {face}, which has {row} that way: none is left between them"
    )]
    Cells {
        /// The face.
        face: BoxSide,
        /// By all its chamfers.
        taken: usize,
        /// Of the block.
        row: usize,
    },
}

impl Problem for ChamferProblem {
    fn kind(&self) -> &'static str {
        "Structure"
    }

    fn label(&self) -> &'static str {
        match self {
            Self::NoSide { .. } | Self::NotAnEnd { .. } => "no such side",
            Self::Nothing { .. } => "without effect",
            Self::TwoDirections { .. } => "another direction",
            Self::Deep { .. } => "too deep",
            Self::Long { .. } => "too long",
            Self::Cells { .. } => "too many",
        }
    }

    fn help(&self) -> Option<String> {
        Some(match self {
            Self::NoSide { known, .. } => format!("its sides are {known}"),
            Self::Nothing { ends, .. } => {
                let first = ends.split(',').next().unwrap_or(ends);
                format!(
                    "give a chamfer where it ends, at {ends}, as in {first} = {{ length = \"5 mm\", depth = \"2 mm\", cells = 2 }}"
                )
            }
            Self::NotAnEnd { ends, .. } => format!("it ends at {ends}"),
            Self::TwoDirections { sides, .. } => {
                let [first, other] = sides.map(|side| listed(BoxSide::BY_AXIS[side.axis()].into_iter()));
                format!("cut it at {first} or at {other}; a mesh file may have any shape")
            }
            Self::Deep { height, .. } => format!("give a depth below {} m", short(*height)),
            Self::Long { width, .. } => format!("give lengths that are below {} m together", short(*width)),
            Self::Cells { row, .. } => {
                format!("give chamfers at most {} cells together, or the block more", row.saturating_sub(1))
            }
        })
    }
}
