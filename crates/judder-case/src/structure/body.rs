//! `[structure]`: elements with materials and supports.

use std::path::Path;

use super::lists::{directions, length, quantities, quantity, whole_numbers};
use super::problem::StructureProblem;
use crate::cause::Cause;
use crate::contact_problem::ContactProblem;
use crate::document::{Data, Node};
use crate::error::Fault;
use crate::file_reference::{FileReference, read_file_reference};
use crate::section::{Section, list, text, wrong_type};
use crate::structure_keys::StructureKey;

/// A body of elements.
#[derive(Debug, Clone, PartialEq)]
pub struct Body {
    /// Where its elements come from.
    pub geometry: Geometry,
    /// How the third direction of a body of the plane is meant; where the case does not say, as a mesh file says, else plane stress.
    pub section: Option<PlaneSection>,
    /// Its width across the plane, m; where the case gives none, that of a mesh file, else 1 m. In space without meaning.
    pub width: Option<f64>,
    /// The material of all elements that have none of their own; of a mesh file it may be missing.
    pub material: Option<Material>,
    /// Materials by the names that a mesh file has for them.
    pub materials: Vec<(String, Material)>,
    /// What holds it.
    pub supports: Vec<Support>,
}

/// Where elements come from.
#[derive(Debug, Clone, PartialEq)]
pub enum Geometry {
    /// A straight beam of eight-node quadrilaterals.
    Beam(Beam),
    /// A rectangle or box of equal elements.
    Block(Block),
    /// A mesh file of another program.
    Mesh(FileReference),
}

/// A straight beam in the plane.
#[derive(Debug, Clone, PartialEq)]
pub struct Beam {
    /// l, m.
    pub length: f64,
    /// b, in its plane, m.
    pub thickness: f64,
    /// Elements along and across.
    pub elements: [usize; 2],
    /// Where the middle of its start lies, m.
    pub origin: [f64; 2],
    /// ϑ, rad.
    pub angle: f64,
    /// How its start and its end are held.
    pub ends: [EndCondition; 2],
}

/// How an end of a beam is held.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum EndCondition {
    /// Not at all.
    Free,
    /// Every node of its face.
    Clamped,
    /// The face stays as it is, held along x and moving as one along y.
    Guided,
}

impl EndCondition {
    /// The conditions with their names in a case file.
    pub const ALL: [(&'static str, Self); 3] =
        [("free", Self::Free), ("clamped", Self::Clamped), ("guided", Self::Guided)];

    /// The name in a case file.
    pub fn name(self) -> &'static str {
        Self::ALL[self as usize].0
    }
}

/// A rectangle or box of equal cells.
#[derive(Debug, Clone, PartialEq)]
pub struct Block {
    /// The shape of its elements.
    pub element: BlockElement,
    /// Lengths in m, two in the plane, three in space.
    pub size: Vec<f64>,
    /// Cells along each side.
    pub cells: Vec<usize>,
}

/// The shape of a block's elements.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum BlockElement {
    Quad4,
    Quad8,
    Triangle6,
    Hexahedron8,
    Hexahedron20,
    Tetrahedron10,
}

impl BlockElement {
    /// The shapes with their names in a case file.
    pub const ALL: [(&'static str, Self); 6] = [
        ("quad4", Self::Quad4),
        ("quad8", Self::Quad8),
        ("triangle6", Self::Triangle6),
        ("hexahedron8", Self::Hexahedron8),
        ("hexahedron20", Self::Hexahedron20),
        ("tetrahedron10", Self::Tetrahedron10),
    ];

    /// The name in a case file.
    pub fn name(self) -> &'static str {
        Self::ALL[self as usize].0
    }

    /// 2 in the plane, 3 in space.
    pub fn dimension(self) -> usize {
        if matches!(self, Self::Quad4 | Self::Quad8 | Self::Triangle6) { 2 } else { 3 }
    }
}

/// How the third direction of a body of the plane is meant.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum PlaneSection {
    /// A plate that is free to change its thickness.
    PlaneStress,
    /// A slice of a long body.
    PlaneStrain,
}

impl PlaneSection {
    /// The sections with their names in a case file.
    pub const ALL: [(&'static str, Self); 2] =
        [("plane-stress", Self::PlaneStress), ("plane-strain", Self::PlaneStrain)];

    /// The name in a case file.
    pub fn name(self) -> &'static str {
        Self::ALL[self as usize].0
    }
}

/// An isotropic linear elastic material.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Material {
    /// E, Pa.
    pub youngs_modulus: f64,
    /// ν.
    pub poisson_ratio: f64,
    /// ρ, kg/m³.
    pub density: f64,
}

/// What holds the nodes of a set.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Support {
    /// The name of the set of nodes.
    pub set: String,
    /// Whether they are held along x, y, z.
    pub fixed: [bool; 3],
    /// Whether they move as one along x, y, z.
    pub tied: [bool; 3],
}

/// The most elements along a side of a beam or a block.
pub const ELEMENTS: (usize, usize) = (1, 100_000);

/// The endings of mesh files that are read.
pub const MESH_ENDINGS: &str = ".msh, .inp";

/// The keys of a body.
pub(crate) const KEYS: [&str; 8] =
    ["beam", "block", "mesh", "section", "width", "material", "materials", "supports"];

/// Reads the body that `section` describes; a mesh file is relative to `folder`.
pub(crate) fn read_body(section: &Section<'_>, folder: &Path) -> Result<Body, Fault> {
    let found: Vec<&'static str> =
        ["beam", "block", "mesh"].into_iter().filter(|key| section.get(key).is_some()).collect();
    let geometry = match found[..] {
        ["beam"] => Geometry::Beam(read_beam(section)?),
        ["block"] => Geometry::Block(read_block(section)?),
        ["mesh"] => Geometry::Mesh(read_mesh(section, folder)?),
        _ => {
            let place =
                found.last().and_then(|key| section.get(key)).map_or(section.place, |node| node.place);
            let section = section.name().to_owned();
            return Err(StructureProblem::OneGeometry { section, found }.at(place));
        }
    };
    let is_solid = matches!(&geometry, Geometry::Block(block) if block.element.dimension() == 3);
    for key in ["section", "width"] {
        if let (true, Some(node)) = (is_solid, section.get(key)) {
            let problem = ContactProblem::Meaningless { key, with: "elements of space".to_owned() };
            return Err(Cause::Contact { problem }.at(node.place));
        }
    }
    let width = match section.get(StructureKey::Width.entry().name()) {
        Some(_) => Some(quantity(section, StructureKey::Width)?),
        None => None,
    };
    let plane = section.choice("section", "section", &PlaneSection::ALL)?;
    let material = section.get("material").map(|node| read_material(&section.path("material"), node));
    let material = material.transpose()?;
    let is_mesh = matches!(geometry, Geometry::Mesh(_));
    if material.is_none() && !is_mesh {
        let example =
            "material = { youngs_modulus = \"210 GPa\", poisson_ratio = 0.3, density = \"7850 kg/m^3\" }";
        let what = if matches!(geometry, Geometry::Beam(_)) { "a beam" } else { "a block" };
        return Err(StructureProblem::Needs { what, key: "material", example }.at(section.place));
    }
    let materials = read_materials(section, is_mesh)?;
    let supports = read_supports(section)?;
    Ok(Body { geometry, section: plane, width, material, materials, supports })
}

fn read_beam(section: &Section<'_>) -> Result<Beam, Fault> {
    let node = section.required("beam", "beam = { … }")?;
    let keys = ["length", "thickness", "elements", "angle", "origin", "start", "end"];
    let beam = section.table("beam", node, &keys)?;
    let node = beam.required("elements", "elements = [100, 2], along and across")?;
    let two = |node| length(&beam, "elements", "two numbers, along and across", node);
    let elements =
        whole_numbers(&beam, "elements", node, ELEMENTS)?.try_into().map_err(|_: Vec<usize>| two(node))?;
    let origin = match beam.get("origin") {
        Some(node) => quantities(&beam, StructureKey::BeamOrigin.entry(), node)?
            .try_into()
            .map_err(|_: Vec<f64>| length(&beam, "origin", "two lengths, x and y", node))?,
        None => [0.0; 2],
    };
    let end = |key: &str| {
        Ok::<_, Fault>(beam.choice(key, "end condition", &EndCondition::ALL)?.unwrap_or(EndCondition::Free))
    };
    Ok(Beam {
        length: quantity(&beam, StructureKey::BeamLength)?,
        thickness: quantity(&beam, StructureKey::BeamThickness)?,
        elements,
        origin,
        angle: quantity(&beam, StructureKey::BeamAngle)?,
        ends: [end("start")?, end("end")?],
    })
}

fn read_block(section: &Section<'_>) -> Result<Block, Fault> {
    let node = section.required("block", "block = { … }")?;
    let block = section.table("block", node, &["element", "size", "cells"])?;
    let node = block.required("size", "size = [\"1 m\", \"0.1 m\", \"0.1 m\"]")?;
    let size = quantities(&block, StructureKey::BlockSize.entry(), node)?;
    let usual = if size.len() == 2 { BlockElement::Quad8 } else { BlockElement::Hexahedron20 };
    let element = block.choice("element", "element", &BlockElement::ALL)?.unwrap_or(usual);
    let expected = if element.dimension() == 2 { "two in the plane" } else { "three in space" };
    if size.len() != element.dimension() {
        return Err(length(&block, "size", expected, node));
    }
    let node = block.required("cells", "cells = [20, 2, 2]")?;
    let cells = whole_numbers(&block, "cells", node, ELEMENTS)?;
    if cells.len() != element.dimension() {
        return Err(length(&block, "cells", expected, node));
    }
    Ok(Block { element, size, cells })
}

fn read_mesh(section: &Section<'_>, folder: &Path) -> Result<FileReference, Fault> {
    let file = read_file_reference(section, "mesh", folder)?;
    let ending = file.path.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
    if ["msh", "inp"].contains(&ending.to_ascii_lowercase().as_str()) {
        return Ok(file);
    }
    let place = section.get("mesh").map_or(section.place, |node| node.place);
    let (key, known) = (section.path("mesh"), MESH_ENDINGS);
    Err(StructureProblem::Format { key, path: file.path, known }.at(place))
}

fn read_material(path: &str, node: &Node) -> Result<Material, Fault> {
    let keys = ["youngs_modulus", "poisson_ratio", "density"];
    let material = Section::open(node, path, &format!("`{path}`"), &keys)?;
    Ok(Material {
        youngs_modulus: quantity(&material, StructureKey::YoungsModulus)?,
        poisson_ratio: quantity(&material, StructureKey::PoissonRatio)?,
        density: quantity(&material, StructureKey::Density)?,
    })
}

fn read_materials(section: &Section<'_>, is_mesh: bool) -> Result<Vec<(String, Material)>, Fault> {
    let Some(node) = section.get("materials") else { return Ok(Vec::new()) };
    if !is_mesh {
        let problem =
            ContactProblem::Meaningless { key: "materials", with: "a body of one material".to_owned() };
        return Err(Cause::Contact { problem }.at(node.place));
    }
    let Data::Table(table) = &node.data else {
        return Err(wrong_type(&section.path("materials"), "a table", node));
    };
    let read = |entry: &crate::document::Entry| {
        let path = format!("{}.{}", section.path("materials"), entry.key);
        Ok((entry.key.clone(), read_material(&path, &entry.node)?))
    };
    table.entries.iter().map(read).collect()
}

fn read_supports(section: &Section<'_>) -> Result<Vec<Support>, Fault> {
    let Some(node) = section.get("supports") else { return Ok(Vec::new()) };
    let path = section.path("supports");
    let read = |node: &Node| {
        let support = Section::open(node, &path, "a support", &["set", "fixed", "tied"])?;
        let set = text(&support.path("set"), support.required("set", "set = \"…\", a set of nodes")?)?;
        let fixed = directions(&support, "fixed")?.unwrap_or_default();
        let tied = directions(&support, "tied")?.unwrap_or_default();
        if fixed == [false; 3] && tied == [false; 3] {
            return Err(StructureProblem::EmptySupport { set: set.to_owned() }.at(node.place));
        }
        Ok(Support { set: set.to_owned(), fixed, tied })
    };
    list(&path, node)?.iter().map(read).collect()
}
