//! `disc` of `[structure]`: discs and rings of bricks, with cells of another size where something touches them.

use super::extent::LENGTH;
use super::problem::StructureProblem;
use judder_keys::Settings;
use judder_keys::declared::{Number, NumberPair, Several, Whole};
use judder_keys::dimension::Dimension;
use judder_keys::error::Fault;
use judder_keys::problem::Placed;
use judder_keys::section::Section;
use judder_structure::disc::{Disc as Ring, steps};
use judder_structure::element::ElementKind;
use judder_structure::grid;
use std::f64::consts::TAU;

/// Radii of a disc.
const RADII: NumberPair = NumberPair { of: LENGTH, what: "two radii, inner and outer", is_ascending: true };
const ANGLES: NumberPair =
    NumberPair { of: Number::any(Dimension::ANGLE), what: "two angles, from and to", is_ascending: true };
const DISC_CELLS: Several<Whole> = Several { of: grid::CELLS, length: [3, 3] };
const AXIS: Several<Number> = Several { of: Number::any(Dimension::LENGTH), length: [3, 3] };

/// A disc with a hole, or a ring, about an axis along z.
#[derive(Debug, Clone, PartialEq, Settings)]
#[settings(check = DiscSettings::complete)]
pub struct DiscSettings {
    /// The shape of a disc's elements, `hexahedron8` or `hexahedron20`, which is the one where left out.
    pub element: Option<ElementKind>,
    /// Inner and outer radius of a disc.
    #[key(rule = RADII, symbol = "r_i, r_o", example = "[\"8 mm\", \"179 mm\"], inner and outer")]
    pub radii: [f64; 2],
    /// Thickness of a disc, along the axis.
    #[key(rule = LENGTH, symbol = "h")]
    pub thickness: f64,
    /// Cells of a disc along the radius, around the axis, through the thickness; what `band` and `sector` have is not among them.
    #[key(rule = DISC_CELLS, example = "[8, 96, 2], along the radius, around the axis, through the thickness")]
    pub cells: Vec<usize>,
    /// Where along the radius a disc has cells of another size, as under a pad.
    #[key(omitted)]
    pub band: Option<DiscBand>,
    /// Where around the axis a disc has cells of another size.
    #[key(omitted)]
    pub sector: Option<Sector>,
    /// Where the axis meets the lower face; at zero where left out.
    #[key(rule = AXIS, symbol = "x, y, z", omitted)]
    pub origin: Option<Vec<f64>>,
}

/// Radii between which a disc has cells of its own.
#[derive(Debug, Clone, PartialEq, Settings)]
pub struct DiscBand {
    /// From and to, within those of the disc.
    #[key(rule = RADII, symbol = "r", example = "[\"150 mm\", \"170 mm\"]")]
    pub radii: [f64; 2],
    /// Cells along the radius between them.
    #[key(rule = grid::CELLS)]
    pub cells: usize,
}

/// Angles between which a disc has cells of its own.
#[derive(Debug, Clone, PartialEq, Settings)]
pub struct Sector {
    /// From and to, counter-clockwise from the x-axis, less than a turn.
    #[key(rule = ANGLES, symbol = "ϑ", example = "[\"-20 deg\", \"20 deg\"]")]
    pub angles: [f64; 2],
    /// Cells around the axis between them.
    #[key(rule = grid::CELLS)]
    pub cells: usize,
}

impl DiscSettings {
    /// Fills in the shape that is left out; refuses elements of which no disc is made, a band beyond the disc and a sector of a turn or more.
    fn complete(&mut self, section: &Section<'_>) -> Result<(), Fault> {
        let element = *self.element.get_or_insert(ElementKind::Hexahedron20);
        if !matches!(element, ElementKind::Hexahedron8 | ElementKind::Hexahedron20) {
            return Err(StructureProblem::DiscElement { kind: element }.at(section.place_of(&["element"])));
        }
        let [inner, outer] = self.radii;
        if let Some(DiscBand { radii: [from, to], .. }) = self.band
            && !(inner <= from && to <= outer)
        {
            return Err(StructureProblem::BeyondDisc { inner, outer }.at(section.place_of(&["band"])));
        }
        match self.sector {
            Some(Sector { angles: [from, to], .. }) if to - from >= TAU => {
                Err(StructureProblem::WholeTurn.at(section.place_of(&["sector"])))
            }
            _ => Ok(()),
        }
    }

    /// The ring with its cells.
    pub(crate) fn ring(&self) -> Ring {
        let cells = |k: usize| self.cells.get(k).copied().unwrap_or(1).max(1);
        let kind = self.element.unwrap_or(ElementKind::Hexahedron20);
        let mut ring = Ring::even(kind, self.radii, self.thickness, [cells(0), cells(1), cells(2)]);
        let [inner, outer] = self.radii;
        if let Some(DiscBand { radii: [from, to], cells: within }) = self.band {
            let beside = [from - inner, outer - to];
            let share =
                |width: f64| ((cells(0) as f64 * width / (beside[0] + beside[1])).round() as usize).max(1);
            ring.radii = vec![inner];
            for (start, end, count) in
                [(inner, from, share(beside[0])), (from, to, within), (to, outer, share(beside[1]))]
            {
                if end > start {
                    ring.radii.extend(&steps([start, end], count)[1..]);
                }
            }
        }
        if let Some(Sector { angles: [from, to], cells: within }) = self.sector {
            ring.angles = steps([from, to], within);
            let around = steps([to, from + TAU], cells(1));
            ring.angles.extend(&around[1..cells(1)]);
        }
        ring
    }
}
