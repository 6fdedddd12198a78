//! Meshes of other programs, with their sets and, where the file has them, materials and sections.

mod building;
mod inp;
mod msh;

use crate::cause::FileCause;
use crate::door::bytes_of;
use crate::error::ExchangeError;
use judder_memory::MemoryBudget;
use judder_structure::material::{Elastic, ElementSection};
use judder_structure::mesh::Mesh;
use std::collections::BTreeMap;
use std::fmt;
use std::path::Path;

/// A mesh as a file gives it. Lengths, and all that materials say, are taken as SI: files do not tell their units, see
/// [`MeshFile::in_si`].
#[derive(Debug, Clone, PartialEq, Default)]
pub struct MeshFile {
    /// The mesh; nodes that no element uses are left out. Blocks are named by their section (`.inp`: the element set of
    /// `*SOLID SECTION`) or their physical group (`.msh`), [`UNNAMED`] without one.
    pub mesh: Mesh,
    /// Materials by name.
    pub materials: BTreeMap<String, FileMaterial>,
    /// Sections by the name of the block.
    pub sections: BTreeMap<String, FileSection>,
    /// The file's number of each node of the mesh.
    pub node_labels: Vec<usize>,
    /// The file's number of each element of the mesh.
    pub element_labels: Vec<usize>,
    /// What was passed over.
    pub warnings: Vec<Warning>,
}

/// Bytes of memory a byte of the file: the node or element of a line stands in lists, in what finds doubles and in sets.
const MEMORY_A_BYTE: u64 = 12;

/// The name of blocks that have none.
pub const UNNAMED: &str = "unnamed";

/// A material of a file.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct FileMaterial {
    /// Young's modulus in Pa and Poisson's ratio.
    pub elastic: Option<[f64; 2]>,
    /// In kg/m³.
    pub density: Option<f64>,
}

/// The section of a block.
#[derive(Debug, Clone, PartialEq)]
pub struct FileSection {
    /// The name of its material; none where the file does not say.
    pub material: Option<String>,
    /// How the third direction is meant, by the types of the elements.
    pub section: ElementSection,
}

/// The consistent units in which a file was written.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Units {
    /// Of lengths, in m.
    pub length: f64,
    /// Of masses, in kg.
    pub mass: f64,
    /// Of times, in s.
    pub time: f64,
}

impl Units {
    /// mm, t, s: forces in N, moduli in MPa, densities in t/mm³.
    pub const MILLIMETRE_TONNE_SECOND: Self = Self { length: 1e-3, mass: 1e3, time: 1.0 };
}

/// Something that was passed over, and where.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Warning {
    /// The line, from 1; none where it is about the mesh as a whole.
    pub line: Option<usize>,
    /// What.
    pub text: String,
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.line {
            Some(line) => write!(f, "line {line}: {}", self.text),
            None => f.write_str(&self.text),
        }
    }
}

/// Reads a mesh; the extension of the file tells the format: `.msh` (Gmsh 4.1 and 2.2, text or binary) or `.inp` (Abaqus, CalculiX).
///
/// # Errors
/// What is wrong with the file and where.
pub fn read_mesh(path: &Path) -> Result<MeshFile, ExchangeError> {
    let extension =
        path.extension().and_then(|extension| extension.to_str()).unwrap_or("").to_ascii_lowercase();
    let read = match extension.as_str() {
        "msh" => msh::read_msh,
        "inp" => inp::read_inp,
        _ => {
            let known = ".msh (Gmsh 4.1, 2.2) and .inp (Abaqus, CalculiX)";
            return Err(
                ExchangeError::from(FileCause::UnknownExtension { found: extension, known }).in_file(path)
            );
        }
    };
    let bytes = bytes_of(path, MEMORY_A_BYTE, MemoryBudget::of_process())?;
    read(&bytes).map_err(|error| error.in_file(path))
}

impl MeshFile {
    /// The same in SI units, from a file that was written in others.
    #[must_use]
    pub fn in_si(mut self, units: Units) -> Self {
        let Units { length, mass, time } = units;
        self.mesh.nodes.iter_mut().flatten().for_each(|place| *place *= length);
        for material in self.materials.values_mut() {
            let stress = mass / (length * time * time);
            material.elastic = material.elastic.map(|[modulus, ratio]| [modulus * stress, ratio]);
            material.density = material.density.map(|density| density * mass / length.powi(3));
        }
        for section in self.sections.values_mut() {
            match &mut section.section {
                ElementSection::PlaneStress { thickness } | ElementSection::PlaneStrain { thickness } => {
                    *thickness *= length;
                }
                ElementSection::Solid => {}
            }
        }
        self
    }

    /// 2 in the plane, 3 in space.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.mesh.blocks.first().map_or(3, |block| block.kind.dimension())
    }

    /// The nodes of the set of this name: of a set of nodes, else of sides, else of elements. Those of sides and elements are
    /// ascending.
    #[must_use]
    pub fn nodes_of(&self, name: &str) -> Option<Vec<usize>> {
        if let Some(nodes) = self.mesh.node_sets.get(name) {
            return Some(nodes.clone());
        }
        let elements = building::elements_of(&self.mesh);
        let mut nodes: Vec<usize> = if let Some(sides) = self.mesh.side_sets.get(name) {
            let of_side = |side: &judder_structure::mesh::ElementSide| {
                let (kind, own) = elements.get(side.element)?;
                Some(kind.sides().get(side.side)?.iter().map(|k| own[*k]).collect::<Vec<usize>>())
            };
            sides.iter().filter_map(of_side).flatten().collect()
        } else {
            let set = self.mesh.element_sets.get(name)?;
            set.iter()
                .filter_map(|element| elements.get(*element))
                .flat_map(|(_, own)| own.iter().copied())
                .collect()
        };
        nodes.sort_unstable();
        nodes.dedup();
        Some(nodes)
    }

    /// Material and section of each block, as assembly takes them.
    ///
    /// # Errors
    /// [`FileCause::NoSection`] for a block to which the file gives none, [`FileCause::MaterialLacks`] for a material without modulus or
    /// density.
    pub fn materials_of_blocks(&self) -> Result<BTreeMap<String, (Elastic, ElementSection)>, ExchangeError> {
        let of_block = |name: &String| {
            let none = || FileCause::NoSection { block: name.clone() };
            let section = self.sections.get(name).ok_or_else(none)?;
            let material = section.material.as_ref().ok_or_else(none)?;
            let found = self.materials.get(material).ok_or_else(none)?;
            let lacks = |what| FileCause::MaterialLacks { material: material.clone(), what };
            let [youngs_modulus, poisson_ratio] = found.elastic.ok_or_else(|| lacks("modulus (*ELASTIC)"))?;
            let density = found.density.ok_or_else(|| lacks("density (*DENSITY)"))?;
            let elastic = Elastic::new(youngs_modulus, poisson_ratio, density)
                .map_err(|source| FileCause::Structure { source })?;
            Ok((name.clone(), (elastic, section.section)))
        };
        self.mesh.blocks.iter().map(|block| of_block(&block.material)).collect()
    }
}
