//! From the keys of a structure case to its matrices.
//!
//! - `body`, `mesh_file`: bodies that a case describes, meshes of other programs.
//! - `assembled`: elements with materials and supports, assembled.
//! - `sums`: matrices of other programs, read. `arrays`: matrices that stand in the case.
//! - `layout`: where freedoms lie, and the lines that show a shape.
//! - `memory`: what matrices of elements take.
//! - `kept`: the freedoms that a reduction keeps.

mod arrays;
mod assembled;
mod body;
mod kept;
mod layout;
mod memory;
mod mesh_file;
mod sums;

use assembled::nodes_of;
pub(crate) use kept::{freedoms_of, points_of};
pub(crate) use layout::{StructureLayout, mesh_lines};

use crate::error::ModelError;
use crate::structure::case::problem::StructureProblem;
use crate::structure::case::{Matrices, StructureCase, StructureSource};
use judder_structure::affine::{AffineFamily, Factors};
use judder_structure::assembly::Sparse;
use judder_structure::freedom::Numbering;
use judder_structure::material::{Elastic, ElementSection};
use judder_structure::mesh::Mesh;
use judder_structure::quadratic::Quadratic;
use judder_study::case::text::CaseText;
use std::collections::BTreeMap;

/// A structure whose files are read and whose elements are assembled.
pub(crate) struct Structure {
    /// Its matrices as sums.
    pub(crate) family: AffineFamily,
    /// Where its freedoms lie; `None` where nothing tells.
    pub(crate) layout: Option<StructureLayout>,
    /// Its elements, where it has any.
    pub(crate) elements: Option<Elements>,
    /// The freedoms that a reduction keeps.
    pub(crate) kept: Vec<usize>,
    /// What the user has to know of it.
    pub(crate) warnings: Vec<String>,
}

/// Elements with what they are made of and how their freedoms are numbered.
pub(crate) struct Elements {
    pub(crate) mesh: Mesh,
    pub(crate) materials: BTreeMap<String, (Elastic, ElementSection)>,
    pub(crate) numbering: Numbering,
}

/// Why a structure cannot be, and at which dotted path of the case.
#[derive(Debug)]
pub(crate) struct Unbuilt {
    pub(crate) path: String,
    pub(crate) problem: StructureProblem,
}

impl Unbuilt {
    fn new(path: impl Into<String>, problem: StructureProblem) -> Self {
        Self { path: path.into(), problem }
    }

    /// The same of a structure that is one of several, by its name.
    pub(crate) fn of_structure(self, name: &str) -> Self {
        let path = self.path.strip_prefix("structure").unwrap_or(&self.path).trim_start_matches('.');
        let path =
            if path.is_empty() { format!("structure.{name}") } else { format!("structure.{name}.{path}") };
        Self { path, ..self }
    }

    /// With a reason in words.
    fn because(path: impl Into<String>, reason: &impl ToString) -> Self {
        Self::new(path, StructureProblem::Unbuilt { reason: reason.to_string() })
    }

    /// As an error at its place in the case file.
    pub(crate) fn placed(self, file: &CaseText) -> ModelError {
        file.error(&self.path, self.problem).into()
    }
}

impl From<Unbuilt> for ModelError {
    fn from(unbuilt: Unbuilt) -> Self {
        Self::Unsupported(unbuilt.problem.to_string())
    }
}

impl Structure {
    /// Reads and assembles what a case describes.
    pub(crate) fn new(case: &StructureCase) -> Result<Self, Unbuilt> {
        let mut structure = match &case.source {
            StructureSource::Body(body) => body::structure(body, &case.damping),
            StructureSource::Matrices(Matrices::Files(sums)) => sums::structure(sums),
            StructureSource::Matrices(Matrices::Arrays(arrays)) => arrays::structure(arrays),
        }?;
        if let Some(reduction) = &case.reduction {
            structure.kept = kept::kept(reduction, &structure)?;
        }
        Ok(structure)
    }

    /// The mesh of its elements, where it has any.
    pub(crate) fn mesh(&self) -> Option<&Mesh> {
        self.elements.as_ref().map(|elements| &elements.mesh)
    }

    /// The points of a set that the case names at `path`.
    pub(crate) fn set(&self, name: &str, path: &str) -> Result<&[usize], Unbuilt> {
        match (self.mesh(), &self.layout) {
            (Some(mesh), _) => nodes_of(&mesh.node_sets, name, path),
            (None, Some(layout)) => nodes_of(&layout.sets, name, path),
            (None, None) => Ok(&[]),
        }
    }

    /// M, C and K where the parameters of a case are `values`.
    ///
    /// # Errors
    /// Factors that are not finite, a mass or stiffness that vanishes.
    pub(crate) fn at(&self, case: &StructureCase, values: &[f64]) -> Result<Quadratic, ModelError> {
        Ok(self.family.at(&factors(case, values)?)?)
    }
}

/// The factors of the terms where the parameters are `values`.
pub(crate) fn factors(case: &StructureCase, values: &[f64]) -> Result<Factors, ModelError> {
    match &case.source {
        StructureSource::Body(_) => Ok(assembled::factors(&case.damping)),
        StructureSource::Matrices(matrices) => {
            let factors = match matrices {
                Matrices::Files(sums) => sums::factors(sums, values),
                Matrices::Arrays(arrays) => arrays::factors(arrays, values),
            };
            factors.map_err(|cause| ModelError::Unsupported(cause.to_string()))
        }
    }
}

/// (A + Aᵀ)/2 and ‖A − Aᵀ‖/‖A‖, largest entry over largest entry.
pub(crate) fn symmetric_part(matrix: &Sparse) -> Result<(Sparse, f64), ModelError> {
    use faer::sparse::Triplet;
    let mut entries = Vec::with_capacity(2 * matrix.val().len());
    let (mut largest, mut difference) = (0.0_f64, 0.0_f64);
    for column in 0..matrix.ncols() {
        for (row, value) in matrix.row_idx_of_col(column).zip(matrix.val_of_col(column)) {
            let mirrored = matrix.get(column, row).copied().unwrap_or(0.0);
            largest = largest.max(value.abs());
            difference = difference.max((value - mirrored).abs());
            entries.push(Triplet::new(row, column, 0.5 * value));
            entries.push(Triplet::new(column, row, 0.5 * value));
        }
    }
    let rows = matrix.nrows();
    let part = Sparse::try_new_from_triplets(rows, rows, &entries)
        .map_err(|_| judder_structure::StructureError::OutOfMemory { rows })?;
    Ok((part, if largest > 0.0 { difference / largest } else { 0.0 }))
}
