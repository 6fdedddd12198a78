//! Chamfers: a face of a box that is cut at its ends, as those of brake pads are.

use crate::StructureError;
#[cfg(feature = "keys")]
use crate::grid::CELLS;
#[cfg(feature = "keys")]
use judder_keys::{declared::Number, dimension::Dimension};
use std::fmt;
use std::ops::RangeInclusive;

/// The share of the height and of the length of a box that chamfers leave at least, so that rounding leaves no flat elements.
pub const LEFT: f64 = 1e-6;

/// What an element has at least that is no sliver: at one end of the Jacobian at its other end, along the face of the length in an even grid.
pub const SLIVER: f64 = 1.0 / 30.0;

/// Which elements of a chamfered box would be slivers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ChamferSlivers {
    /// Those at the end of a chamfer, which is nearly as deep as the box is high.
    Deep(BoxSide),
    /// Those along a chamfer, which is short for its cells.
    Short(BoxSide),
    /// Those that the chamfers leave of the face.
    Between,
}

/// A side of a box, by the axis across it and the end of it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
#[cfg_attr(feature = "keys", derive(judder_keys::Choice), choice(what = "side of a block"))]
pub enum BoxSide {
    /// Where x is least.
    XMin,
    /// Where x is largest.
    XMax,
    /// Where y is least.
    YMin,
    /// Where y is largest.
    YMax,
    /// Where z is least.
    ZMin,
    /// Where z is largest.
    ZMax,
}

/// A face of a box with chamfers where two other sides, across one axis, meet it.
///
/// Lines of the grid stand on the edges of the chamfers, so that the mesh keeps its topology and follows lengths and depths smoothly. Along the face
/// each chamfer has cells of its own, and the rest shares what is left; towards the face cells are shorter where a chamfer takes of them.
///
/// With the lengths l, the depths d and the sizes L along the face and H across it the box loses ½ Σ l d of its section L H.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ChamferedFace {
    /// The face.
    pub face: BoxSide,
    /// The axis along which it is cut at its ends: 0, 1 or 2.
    pub along: usize,
    /// The chamfers at the start and at the end of that axis.
    pub cuts: [Option<Chamfer>; 2],
}

/// What is cut off where two sides of a box meet: a straight flank.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "keys", derive(judder_keys::Settings))]
pub struct Chamfer {
    /// How far it reaches along the face, which is so much shorter.
    ///
    /// l in m.
    #[cfg_attr(feature = "keys", key(rule = Number::positive(Dimension::LENGTH), symbol = "l", example = "\"5 mm\""))]
    pub length: f64,
    /// How far it reaches into the block at its end.
    ///
    /// d in m.
    #[cfg_attr(feature = "keys", key(rule = Number::positive(Dimension::LENGTH), symbol = "d", example = "\"2 mm\""))]
    pub depth: f64,
    /// Cells of the block along the chamfer, of those along its face: they stay when its length varies.
    #[cfg_attr(feature = "keys", key(rule = CELLS, example = "2"))]
    pub cells: usize,
}

impl BoxSide {
    /// All of them, by their axes.
    pub const BY_AXIS: [[Self; 2]; 3] =
        [[Self::XMin, Self::XMax], [Self::YMin, Self::YMax], [Self::ZMin, Self::ZMax]];

    /// The axis across it: 0, 1 or 2.
    #[must_use]
    pub fn axis(self) -> usize {
        match self {
            Self::XMin | Self::XMax => 0,
            Self::YMin | Self::YMax => 1,
            Self::ZMin | Self::ZMax => 2,
        }
    }

    /// Whether it lies at the end of its axis, and not at the start.
    #[must_use]
    pub fn is_max(self) -> bool {
        matches!(self, Self::XMax | Self::YMax | Self::ZMax)
    }
}

/// As `y-min`, which is how its set of nodes is called.
impl fmt::Display for BoxSide {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}-{}", ["x", "y", "z"][self.axis()], if self.is_max() { "max" } else { "min" })
    }
}

impl ChamferedFace {
    /// Where a corner of the grid lies, which is so many steps from the start along each axis.
    pub(crate) fn place(
        &self,
        size: [f64; 3],
        cells: [usize; 3],
        steps: [usize; 3],
        even: [f64; 3],
    ) -> [f64; 3] {
        let (across, along) = (self.face.axis(), self.along);
        let (step, whole) = (steps[along], cells[along]);
        let [from, to] = self.cuts.map(|cut| cut.map_or(0, |own| own.cells));
        let [before, after] = self.cuts.map(|cut| cut.map_or(0.0, |own| own.length));
        let flank = |cut: Option<Chamfer>, left: usize| {
            cut.map_or((0.0, 0.0), |own| {
                let share = left as f64 / own.cells as f64;
                (share * own.length, (1.0 - share) * own.depth)
            })
        };
        let (distance, depth) = if step < from {
            flank(self.cuts[0], step)
        } else if step > whole - to {
            let (left, depth) = flank(self.cuts[1], whole - step);
            (size[along] - left, depth)
        } else {
            let share = (step - from) as f64 / (whole - from - to) as f64;
            (before + share * (size[along] - before - after), 0.0)
        };
        let mut place = even;
        place[along] = distance;
        let height = even[across] / size[across];
        place[across] = match self.face.is_max() {
            true => even[across] - depth * height,
            false => even[across] + depth * (1.0 - height),
        };
        place
    }

    /// Whether a corner of the grid, so many steps along the face, is on what the chamfers leave of it.
    pub(crate) fn is_flat(&self, step: usize, cells: [usize; 3]) -> bool {
        let [from, to] = self.cuts.map(|cut| cut.map_or(0, |own| own.cells));
        (from..=cells[self.along] - to).contains(&step)
    }

    /// The flanks: the name of each, as `chamfer-x-min`, and the steps along the face that are on it.
    pub(crate) fn flanks(&self, cells: [usize; 3]) -> impl Iterator<Item = (String, RangeInclusive<usize>)> {
        let (along, whole) = (self.along, cells[self.along]);
        let ends = BoxSide::BY_AXIS[along];
        self.cuts.into_iter().zip(ends).filter_map(move |(cut, end)| {
            let cells = cut?.cells;
            Some((format!("chamfer-{end}"), if end.is_max() { whole - cells..=whole } else { 0..=cells }))
        })
    }

    /// Which elements of a box of this size and with these cells would be slivers, and what is left of them, less than [`SLIVER`]: of the
    /// outermost along a chamfer of the depth d and with c cells the Jacobian (H − d)/(H − d + d/c), of the others the length of an even grid.
    #[must_use]
    pub fn slivers(&self, size: [f64; 3], cells: [usize; 3]) -> Option<(ChamferSlivers, f64)> {
        let (height, width) = (size[self.face.axis()], size[self.along]);
        let even = width / cells[self.along] as f64;
        let cuts = || {
            self.cuts.into_iter().zip(BoxSide::BY_AXIS[self.along]).filter_map(|(cut, end)| Some((cut?, end)))
        };
        let ends = cuts().flat_map(|(own, end)| {
            let (left, cells) = (height - own.depth, own.cells as f64);
            [
                (ChamferSlivers::Deep(end), left / (left + own.depth / cells)),
                (ChamferSlivers::Short(end), own.length / cells / even),
            ]
        });
        let taken: usize = cuts().map(|(own, _)| own.cells).sum();
        let left = width - cuts().map(|(own, _)| own.length).sum::<f64>();
        let between = left / cells[self.along].saturating_sub(taken) as f64 / even;
        ends.chain([(ChamferSlivers::Between, between)]).find(|(_, left)| *left < SLIVER)
    }

    /// Whether it leaves a box of this size and with these cells elements that are neither folded nor slivers.
    pub(crate) fn check(
        &self,
        dimension: usize,
        size: [f64; 3],
        cells: [usize; 3],
    ) -> Result<(), StructureError> {
        let (across, along) = (self.face.axis(), self.along);
        if across >= dimension || along >= dimension || across == along {
            return Err(StructureError::NoChamfer {
                what: "a face is cut along an axis of the box that lies in it",
            });
        }
        let cuts = || self.cuts.iter().flatten();
        let is_positive = |value: f64| value.is_finite() && value > 0.0;
        if cuts().any(|own| !(is_positive(own.length) && is_positive(own.depth) && own.cells > 0)) {
            return Err(StructureError::NoChamfer {
                what: "its length, its depth and its cells must be positive",
            });
        }
        if cuts().any(|own| own.depth > (1.0 - LEFT) * size[across]) {
            return Err(StructureError::NoChamfer { what: "it must be less deep than the box" });
        }
        if cuts().map(|own| own.length).sum::<f64>() > (1.0 - LEFT) * size[along] {
            return Err(StructureError::NoChamfer { what: "it must leave some of the length of the face" });
        }
        if cuts().fold(0, |sum: usize, own| sum.saturating_add(own.cells)) >= cells[along] {
            return Err(StructureError::NoChamfer { what: "it must leave a cell of the face" });
        }
        match self.slivers(size, cells) {
            Some(_) => Err(StructureError::NoChamfer { what: "some of its elements would be slivers" }),
            None => Ok(()),
        }
    }
}
