//! Sparse stiffness and mass of a mesh.

use crate::StructureError;
use crate::element::{ElementMatrices, Elements};
use crate::freedom::Numbering;
use crate::material::{Elastic, Section};
use crate::mesh::Mesh;
use faer::sparse::{SparseColMat, SymbolicSparseColMat};
use rayon::prelude::*;
use std::collections::BTreeMap;

/// A sparse matrix by columns.
pub type Sparse = SparseColMat<usize, f64>;

/// Stiffness and mass on the free displacements, with one pattern; both triangles are stored.
#[derive(Debug, Clone)]
pub struct Assembled {
    /// K in N/m.
    pub stiffness: Sparse,
    /// M in kg.
    pub mass: Sparse,
}

/// Elements computed at a time: enough for all cores, few enough to be held.
const BATCH: usize = 4096;

/// An element's nodes and how it is computed.
struct Task<'a> {
    elements: usize,
    nodes: &'a [usize],
}

/// Stiffness and mass of a mesh whose blocks have the material and section of their name.
///
/// Elements are computed side by side and added in their order, so the sums do not depend on the number of threads.
///
/// # Errors
/// A mesh that is not whole, a folded element, a material that is not given.
pub fn assemble(
    mesh: &Mesh,
    materials: &BTreeMap<String, (Elastic, Section)>,
    numbering: &Numbering,
) -> Result<Assembled, StructureError> {
    mesh.check()?;
    let kinds = kinds(mesh, materials)?;
    let tasks: Vec<Task<'_>> = mesh
        .blocks
        .iter()
        .enumerate()
        .flat_map(|(k, block)| {
            block.connectivity.chunks(block.kind.nodes()).map(move |nodes| Task { elements: k, nodes })
        })
        .collect();
    let pattern = Pattern::new(&tasks, numbering);
    let mut stiffness = vec![0.0; pattern.rows.len()];
    let mut mass = vec![0.0; pattern.rows.len()];
    for (batch, tasks) in tasks.chunks(BATCH).enumerate() {
        let matrices: Vec<ElementMatrices> = tasks
            .par_iter()
            .enumerate()
            .map(|(k, task)| {
                let places: Vec<[f64; 3]> = task.nodes.iter().map(|node| mesh.nodes[*node]).collect();
                kinds[task.elements].matrices(batch * BATCH + k, &places)
            })
            .collect::<Result<_, _>>()?;
        for (task, matrices) in tasks.iter().zip(&matrices) {
            pattern.add((&mut stiffness, &mut mass), task, numbering, matrices);
        }
    }
    Ok(Assembled { stiffness: pattern.matrix(stiffness), mass: pattern.matrix(mass) })
}

/// What computes each block's elements.
fn kinds(
    mesh: &Mesh,
    materials: &BTreeMap<String, (Elastic, Section)>,
) -> Result<Vec<Elements>, StructureError> {
    mesh.blocks
        .iter()
        .map(|block| {
            let (material, section) =
                materials.get(&block.material).ok_or_else(|| StructureError::UnknownMaterial {
                    name: block.material.clone(),
                    known: materials.keys().cloned().collect(),
                })?;
            Elements::new(block.kind, material, *section)
        })
        .collect()
}

/// Where entries can be that are not zero, by columns with ascending rows.
struct Pattern {
    starts: Vec<usize>,
    rows: Vec<usize>,
}

impl Pattern {
    fn new(tasks: &[Task<'_>], numbering: &Numbering) -> Self {
        let count = numbering.freedoms().len();
        let mut touching: Vec<Vec<usize>> = vec![Vec::new(); count];
        for (k, task) in tasks.iter().enumerate() {
            for freedom in numbering.of_element(task.nodes).flatten() {
                if touching[freedom].last() != Some(&k) {
                    touching[freedom].push(k);
                }
            }
        }
        let columns: Vec<Vec<usize>> = touching
            .par_iter()
            .map(|elements| {
                let own = |k: &usize| numbering.of_element(tasks[*k].nodes).flatten();
                let mut rows: Vec<usize> = elements.iter().flat_map(own).collect();
                rows.sort_unstable();
                rows.dedup();
                rows
            })
            .collect();
        let mut starts = Vec::with_capacity(count + 1);
        starts.push(0);
        for column in &columns {
            starts.push(starts[starts.len() - 1] + column.len());
        }
        Self { starts, rows: columns.concat() }
    }

    fn add(
        &self,
        (stiffness, mass): (&mut [f64], &mut [f64]),
        task: &Task<'_>,
        numbering: &Numbering,
        matrices: &ElementMatrices,
    ) {
        let numbers: Vec<Option<usize>> = numbering.of_element(task.nodes).collect();
        for (j, column) in numbers.iter().enumerate() {
            let Some(column) = *column else { continue };
            let start = self.starts[column];
            let rows = &self.rows[start..self.starts[column + 1]];
            for (i, row) in numbers.iter().enumerate() {
                if let Some(row) = row
                    && let Ok(place) = rows.binary_search(row)
                {
                    stiffness[start + place] += matrices.stiffness[i * matrices.size + j];
                    mass[start + place] += matrices.mass[i * matrices.size + j];
                }
            }
        }
    }

    fn matrix(&self, values: Vec<f64>) -> Sparse {
        let size = self.starts.len() - 1;
        let symbolic =
            SymbolicSparseColMat::new_checked(size, size, self.starts.clone(), None, self.rows.clone());
        Sparse::new(symbolic, values)
    }
}
