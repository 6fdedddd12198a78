//! `chamfer` of a block: what is cut off where a face of it ends.

use crate::key_sweep::unit_of;
use judder_keys::Settings;
use judder_keys::dimension::Dimension;
use judder_keys::error::Fault;
use judder_keys::problem::{Placed, Problem};
use judder_keys::quantity::WrittenUnit;
use judder_keys::section::Section;
use judder_structure::chamfer::{BoxSide, Chamfer, ChamferSlivers, ChamferedFace, LEFT, SLIVER};
use judder_study::text::short;
use thiserror::Error;

/// What lengths are advised beside the limit, so that as rounded as they are told they are right.
const ROUNDED: f64 = 5e-4;

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
        self.leaves_elements(size, cells, &section)
    }

    /// Refuses chamfers that would fold elements, or leave slivers; lengths are told in the unit of the key that is to blame.
    fn leaves_elements(&self, size: &[f64], cells: &[usize], section: &Section<'_>) -> Result<(), Fault> {
        let (face, chamfered) = (self.face, self.chamfered());
        let (height, width, row) = (size[face.axis()], size[chamfered.along], cells[chamfered.along]);
        let blame = |end: BoxSide, key: &str, of: &dyn Fn(&WrittenUnit) -> ChamferProblem| {
            let own = section.inner(&end.to_string())?;
            let node = own.as_ref().and_then(|own| own.get(key));
            let problem = of(&unit_of(node, Dimension::LENGTH));
            Err(problem.at(node.map_or(section.place, |node| node.place)))
        };
        let text = |unit: &WrittenUnit, si: f64| format!("{} {}", short(unit.value(si)), unit.name);
        if let Some((end, own)) = self.cuts().find(|(_, own)| own.depth > (1.0 - LEFT) * height) {
            return blame(end, "depth", &|unit| {
                let (depth, height) = (text(unit, own.depth), text(unit, height));
                ChamferProblem::Deep { face, end, depth, height }
            });
        }
        // of two that are too long together neither is wrong alone: the larger one is the first to look at
        let largest = |of: fn(&Chamfer) -> f64| {
            let own = self.cuts().max_by(|(_, a), (_, b)| of(a).total_cmp(&of(b)));
            own.map_or(face, |(end, _)| end)
        };
        let longest = largest(|own| own.length);
        let length: f64 = self.cuts().map(|(_, own)| own.length).sum();
        if length > (1.0 - LEFT) * width {
            return blame(longest, "length", &|unit| {
                let (length, width) = (text(unit, length), text(unit, width));
                ChamferProblem::Long { face, length, width }
            });
        }
        let taken: usize = self.cuts().map(|(_, own)| own.cells).sum();
        if taken >= row {
            let finest = largest(|own| own.cells as f64);
            return blame(finest, "cells", &|_| ChamferProblem::Cells { face, taken, row });
        }
        let in_space = |of: &[f64]| [of[0], of[1], of.get(2).copied().unwrap_or(1.0)];
        let cells_in_space = [cells[0], cells[1], cells.get(2).copied().unwrap_or(1)];
        let Some((slivers, left)) = chamfered.slivers(in_space(size), cells_in_space) else { return Ok(()) };
        let end = match slivers {
            ChamferSlivers::Deep(end) | ChamferSlivers::Short(end) => end,
            ChamferSlivers::Between => longest,
        };
        let own_cells = self.cuts().find(|(own, _)| *own == end).map_or(1, |(_, own)| own.cells) as f64;
        let key = if matches!(slivers, ChamferSlivers::Deep(_)) { "depth" } else { "length" };
        blame(end, key, &|unit| {
            let (what, advice) = match slivers {
                ChamferSlivers::Deep(end) => {
                    let deepest = height * (1.0 - SLIVER) / (1.0 - SLIVER + SLIVER / own_cells);
                    let deepest = text(unit, (1.0 - ROUNDED) * deepest);
                    (
                        format!("at the end of the chamfer at {end} an element would have"),
                        format!("give a depth of at most {deepest}, or more cells along the chamfer"),
                    )
                }
                ChamferSlivers::Short(end) => {
                    let shortest = text(unit, (1.0 + ROUNDED) * SLIVER * own_cells * width / row as f64);
                    (
                        format!("elements along the chamfer at {end} would have"),
                        format!("give a length of at least {shortest}, or fewer cells along the chamfer"),
                    )
                }
                ChamferSlivers::Between => {
                    let most = width * (1.0 - SLIVER * (row - taken) as f64 / row as f64);
                    let longest = text(unit, (1.0 - ROUNDED) * most);
                    (
                        format!("elements that are left of the face {face} would have"),
                        format!("give lengths that are at most {longest} together"),
                    )
                }
            };
            ChamferProblem::Slivers { what, left, advice }
        })
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
        "the chamfer at {end} is {depth} deep, and the block {height} high across {face}: it would fold elements"
    )]
    Deep {
        /// The face.
        face: BoxSide,
        /// Where it is cut.
        end: BoxSide,
        /// With its unit, as the case has it.
        depth: String,
        /// With the same unit.
        height: String,
    },
    /// Chamfers that leave nothing of the face.
    #[error(
        "{length} of the face {face} are cut off, and it is {width} long: the chamfers would fold elements"
    )]
    Long {
        /// The face.
        face: BoxSide,
        /// Of all its chamfers, with the unit that the case has.
        length: String,
        /// With the same unit.
        width: String,
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
    /// Chamfers with elements that are far narrower at one end than at the other, or than the others are.
    #[error("{what} {} % of what there is beside it: slivers", short(100.0 * left))]
    Slivers {
        /// Which elements.
        what: String,
        /// Of the Jacobian, or of the length.
        left: f64,
        /// What would be right.
        advice: String,
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
            Self::Slivers { .. } => "leaves slivers",
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
            Self::Deep { height, .. } => format!("give a depth below {height}"),
            Self::Long { width, .. } => format!("give lengths that are below {width} together"),
            Self::Cells { row, .. } => {
                format!("give chamfers at most {} cells together, or the block more", row.saturating_sub(1))
            }
            Self::Slivers { advice, .. } => advice.clone(),
        })
    }
}
