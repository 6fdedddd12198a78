//! `[structure]`: elements with materials and supports.

use super::chamfer::ChamferSettings;
use super::disc::DiscSettings;
use super::extent::LENGTH;
use super::file_of_format;
use super::lists::length;
use super::orientation::Orientation;
use super::problem::StructureProblem;
use judder_keys::cause::Cause;
use judder_keys::declared::{Allowed, Fixed, Number, NumberPair, Setting, Several, Whole, all};
use judder_keys::dimension::Dimension;
use judder_keys::document::{Data, Entry, Node};
use judder_keys::error::Fault;
use judder_keys::file_reference::FileReference;
use judder_keys::problem::Placed;
use judder_keys::section::{Section, wrong_type};
use judder_keys::{Choice, Settings};
use judder_structure::element::ElementKind;
use judder_structure::grid;
use judder_structure::material::Elastic;
use serde_json::Value as Json;
use std::path::Path;

/// A body of elements.
#[derive(Debug, Clone, PartialEq, Settings)]
#[settings(check = BodySettings::fits)]
pub struct BodySettings {
    /// Where its elements come from.
    #[key(flatten)]
    pub geometry: BodyGeometry,
    /// The unit of the lengths of a mesh file, and with newtons and seconds of what it says of materials; metres where left out.
    #[key(omitted)]
    pub unit: Option<LengthUnit>,
    /// How the third direction of a body of the plane is meant; a mesh file may say it.
    #[key(usual = PlaneSection::PlaneStress)]
    pub section: Option<PlaneSection>,
    /// Width of a body of the plane across its plane; that of a mesh file, else 1 m where left out.
    #[key(rule = LENGTH, symbol = "a")]
    pub width: Option<f64>,
    /// The material of all elements that have no other; a beam, a block and a disc must have one.
    pub material: Option<Elastic>,
    /// Materials by the names of a mesh file.
    #[key(default = Materials(Vec::new()))]
    pub materials: Materials,
    /// What holds sets of nodes.
    #[key(rule = SUPPORTS, default = Vec::new())]
    pub supports: Vec<Support>,
}

/// A unit of length.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Choice)]
#[choice(what = "unit of length")]
#[allow(missing_docs)]
pub enum LengthUnit {
    M,
    Cm,
    Mm,
    Um,
}

impl LengthUnit {
    /// In metres.
    pub fn metres(self) -> f64 {
        match self {
            Self::M => 1.0,
            Self::Cm => 1e-2,
            Self::Mm => 1e-3,
            Self::Um => 1e-6,
        }
    }
}

/// Where elements come from.
#[derive(Debug, Clone, PartialEq, Settings)]
#[settings(check = BodyGeometry::is_one)]
pub enum BodyGeometry {
    /// A straight beam of eight-node quadrilaterals.
    Beam(BeamSettings),
    /// A rectangle or box of equal cells.
    Block(Block),
    /// A disc or ring about the z-axis.
    Disc(DiscSettings),
    /// A mesh file, .msh or .inp, relative to the case file.
    Mesh(FileReference),
}

/// A straight beam in the plane.
#[derive(Debug, Clone, PartialEq, Settings)]
pub struct BeamSettings {
    /// Length of a beam.
    #[key(rule = LENGTH, symbol = "l")]
    pub length: f64,
    /// Thickness of a beam in its plane.
    #[key(rule = LENGTH, symbol = "b")]
    pub thickness: f64,
    /// Elements of a beam along and across.
    #[key(rule = ELEMENTS_TWICE, example = "[100, 2], along and across")]
    pub elements: [usize; 2],
    /// From the x-axis to the axis of the beam, counter-clockwise.
    #[key(rule = Number::any(Dimension::ANGLE), symbol = "ϑ", default = 0.0)]
    pub angle: f64,
    /// Where the middle of a beam's start lies.
    #[key(rule = PLACE, symbol = "x, y", default = [0.0; 2])]
    pub origin: [f64; 2],
    /// How the start of a beam is held.
    #[key(default = EndCondition::Free)]
    pub start: EndCondition,
    /// How the end of a beam is held.
    #[key(default = EndCondition::Free)]
    pub end: EndCondition,
}

/// How an end of a beam is held.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Choice)]
#[choice(what = "end condition")]
pub enum EndCondition {
    /// Not at all.
    Free,
    /// Every node of its face.
    Clamped,
    /// The face stays as it is, held along x and moving as one along y.
    Guided,
}

/// A rectangle or box of equal cells.
#[derive(Debug, Clone, PartialEq, Settings)]
#[settings(check = Block::complete)]
pub struct Block {
    /// The shape of a block's elements; `quad8` in the plane and `hexahedron20` in space where left out.
    pub element: Option<ElementKind>,
    /// Lengths of a block, two in the plane, three in space.
    #[key(rule = SIDES, symbol = "l_x, l_y, l_z", example = "[\"1 m\", \"0.1 m\", \"0.1 m\"]")]
    pub size: Vec<f64>,
    /// Cells along each side of a block.
    #[key(rule = CELLS, example = "[20, 2, 2]")]
    pub cells: Vec<usize>,
    /// Where the corner of a block with the smallest coordinates lies; at zero where left out.
    #[key(rule = CORNER, symbol = "x, y, z", omitted)]
    pub origin: Option<Vec<f64>>,
    /// How a block is turned about that corner; its sets keep their names.
    #[key(omitted)]
    pub orientation: Option<Orientation>,
    /// What is cut off a block where a face of it ends, as at the leading and the trailing edge of a brake pad; none where left out.
    #[key(
        omitted,
        example = "{ face = \"y-min\", x-min = { length = \"5 mm\", depth = \"2 mm\", cells = 2 } }"
    )]
    pub chamfer: Option<ChamferSettings>,
}

impl Block {
    /// The shape of its elements.
    pub fn element(&self) -> ElementKind {
        let usual = if self.size.len() == 2 { ElementKind::Quad8 } else { ElementKind::Hexahedron20 };
        self.element.unwrap_or(usual)
    }

    /// Fills in the shape that is left out, and refuses lengths and cells of another dimension.
    fn complete(&mut self, section: &Section<'_>) -> Result<(), Fault> {
        let element = self.element();
        self.element = Some(element);
        let expected = if element.dimension() == 2 { "two in the plane" } else { "three in space" };
        let of_origin = self.origin.as_ref().map_or(0, Vec::len);
        for (key, found) in [("size", self.size.len()), ("cells", self.cells.len()), ("origin", of_origin)] {
            if let Some(node) = section.get(key).filter(|_| found != element.dimension()) {
                return Err(length(section, key, expected, node));
            }
        }
        let orientation = self.orientation.as_ref();
        orientation.map_or(Ok(()), |own| own.fits(element.dimension() == 2, section))?;
        let chamfer = self.chamfer.as_ref();
        chamfer.map_or(Ok(()), |own| own.fits(&self.size, &self.cells, section))
    }
}

/// How the third direction of a body of the plane is meant.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Choice)]
#[choice(what = "section")]
pub enum PlaneSection {
    /// A plate that is free to change its thickness.
    PlaneStress,
    /// A slice of a long body.
    PlaneStrain,
}

/// What holds the nodes of a set.
#[derive(Debug, Clone, PartialEq, Eq, Settings)]
#[settings(check = Support::holds, title = "a support")]
pub struct Support {
    /// The name of the set of nodes.
    #[key(example = "\"…\", a set of nodes")]
    pub set: String,
    /// Directions in which the nodes are held.
    #[key(default = [false; 3])]
    pub fixed: [bool; 3],
    /// Directions in which the nodes move as one.
    #[key(default = [false; 3])]
    pub tied: [bool; 3],
}

impl Support {
    /// Refuses a support without a direction.
    fn holds(&mut self, section: &Section<'_>) -> Result<(), Fault> {
        if self.fixed == [false; 3] && self.tied == [false; 3] {
            return Err(StructureProblem::EmptySupport { set: self.set.clone() }.at(section.place));
        }
        Ok(())
    }
}

const ELEMENTS_TWICE: Fixed<Whole> = Fixed { of: grid::CELLS, what: "two numbers, along and across" };
const PLACE: NumberPair =
    NumberPair { of: Number::any(Dimension::LENGTH), what: "two lengths, x and y", is_ascending: false };
const SIDES: Several<Number> = Several { of: LENGTH, length: [2, 3] };
const SUPPORTS: Several<()> = Several { of: (), length: [0, usize::MAX] };
const CORNER: Several<Number> = Several { of: Number::any(Dimension::LENGTH), length: [2, 3] };
const CELLS: Several<Whole> = Several { of: grid::CELLS, length: [2, 3] };

/// The endings of mesh files that are read.
pub const MESH_ENDINGS: [&str; 2] = [".msh", ".inp"];

/// Materials by their names.
#[derive(Debug, Clone, PartialEq)]
pub struct Materials(pub Vec<(String, Elastic)>);

impl Setting for Materials {
    type Rule = ();

    fn form((): &()) -> Allowed {
        Allowed::Named(Box::new(Elastic::form(&())))
    }

    fn read(section: &Section<'_>, key: &str, node: &Node, (): &()) -> Result<Self, Fault> {
        let path = section.path(key);
        let Data::Table(table) = &node.data else { return Err(wrong_type(&path, "a table", node)) };
        let section = Section::of_table(node, &path, "")?;
        let read = |entry: &Entry| {
            Elastic::read(&section, &entry.key, &entry.node, &()).map(|own| (entry.key.clone(), own))
        };
        all(table.entries.iter().map(read)).map(Self)
    }

    fn write(&self, (): &()) -> Json {
        let entries = self.0.iter().map(|(name, own)| (name.clone(), Setting::write(own, &())));
        Json::Object(entries.collect())
    }
}

impl BodyGeometry {
    /// The keys of which a body has one.
    pub(super) const KEYS: [&'static str; 4] = ["beam", "block", "disc", "mesh"];

    /// Refuses none and several.
    fn is_one(section: &Section<'_>) -> Result<(), Fault> {
        let found: Vec<_> = Self::KEYS.into_iter().filter(|key| section.get(key).is_some()).collect();
        if found.len() == 1 {
            return Ok(());
        }
        let place = found.last().and_then(|key| section.get(key)).map_or(section.place, |node| node.place);
        Err(StructureProblem::OneGeometry { section: section.name().to_owned(), found }.at(place))
    }
}

impl BodySettings {
    /// Refuses what has no meaning beside its elements, and elements without a material.
    fn fits(&mut self, section: &Section<'_>) -> Result<(), Fault> {
        let (is_solid, is_mesh) = (self.is_solid(), matches!(self.geometry, BodyGeometry::Mesh(_)));
        let refused = [
            ("section", "elements of space", is_solid),
            ("width", "elements of space", is_solid),
            ("materials", "a body of one material", !is_mesh),
            ("unit", "lengths that have their own", !is_mesh),
        ];
        for (key, with, is_refused) in refused {
            if let Some(node) = section.get(key).filter(|_| is_refused) {
                return Err(Cause::Meaningless { key, with: with.to_owned() }.at(node.place));
            }
        }
        if self.material.is_some() || is_mesh {
            return Ok(());
        }
        let example =
            "material = { youngs_modulus = \"210 GPa\", poisson_ratio = 0.3, density = \"7850 kg/m^3\" }";
        let what = match self.geometry {
            BodyGeometry::Beam(_) => "a beam",
            BodyGeometry::Disc(_) => "a disc",
            BodyGeometry::Block(_) | BodyGeometry::Mesh(_) => "a block",
        };
        Err(StructureProblem::Needs { what, key: "material", example }.at(section.place))
    }

    /// Whether its elements are of space.
    pub fn is_solid(&self) -> bool {
        match &self.geometry {
            BodyGeometry::Block(block) => block.element().dimension() == 3,
            BodyGeometry::Disc(_) => true,
            BodyGeometry::Beam(_) | BodyGeometry::Mesh(_) => false,
        }
    }

    /// Finds its mesh file, which is relative to `folder`.
    pub(crate) fn found(mut self, section: &Section<'_>, folder: &Path) -> Result<Self, Fault> {
        if let BodyGeometry::Mesh(file) = &mut self.geometry {
            *file = read_mesh(section, folder)?;
        }
        Ok(self)
    }

    /// A canonical form of its keys without what means nothing to elements of space.
    pub(crate) fn written(&self, mut json: Json) -> Json {
        if let Json::Object(keys) = &mut json
            && self.is_solid()
        {
            ["section", "width"].iter().for_each(|key| drop(keys.remove(*key)));
        }
        json
    }
}

fn read_mesh(section: &Section<'_>, folder: &Path) -> Result<FileReference, Fault> {
    file_of_format(section, "mesh", folder, &MESH_ENDINGS)
}
