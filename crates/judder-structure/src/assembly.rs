//! Sparse stiffness and mass of a mesh.

use crate::StructureError;
use crate::element::{BlockElements, ElementMatrices};
use crate::freedom::{Direction, Numbering};
use crate::material::{Elastic, ElementSection};
use crate::mesh::Mesh;
use faer::sparse::{SparseColMat, SymbolicSparseColMat};
use judder_numerics::parallel;
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
struct ElementTask<'a> {
    elements: usize,
    nodes: &'a [usize],
}

/// An element that is computed.
pub(crate) struct OneElement<'a> {
    /// How.
    pub(crate) elements: &'a BlockElements,
    /// Its number in the mesh.
    pub(crate) number: usize,
    /// Its nodes,
    pub(crate) nodes: &'a [usize],
    /// and their places.
    pub(crate) places: Vec<[f64; 3]>,
}

/// Stiffness and mass of a mesh whose blocks have the material and section of their name.
///
/// Elements are computed side by side and added in their order, so the sums do not depend on the number of threads.
///
/// # Errors
/// A mesh that is not whole, a folded element, a material that is not given.
pub fn assemble(
    mesh: &Mesh,
    materials: &BTreeMap<String, (Elastic, ElementSection)>,
    numbering: &Numbering,
) -> Result<Assembled, StructureError> {
    let of_element = |one: &OneElement<'_>| {
        let ElementMatrices { stiffness, mass, .. } = one.elements.matrices(one.number, &one.places)?;
        Ok([stiffness, mass])
    };
    let [stiffness, mass] = assembled_of(mesh, materials, numbering, of_element)?;
    Ok(Assembled { stiffness, mass })
}

/// Matrices of a mesh with one pattern from those of its elements, each square and row by row.
pub(crate) fn assembled_of<const N: usize>(
    mesh: &Mesh,
    materials: &BTreeMap<String, (Elastic, ElementSection)>,
    numbering: &Numbering,
    of_element: impl Fn(&OneElement<'_>) -> Result<[Vec<f64>; N], StructureError> + Sync,
) -> Result<[Sparse; N], StructureError> {
    mesh.check()?;
    let kinds = kinds(mesh, materials)?;
    let tasks: Vec<ElementTask<'_>> = mesh
        .blocks
        .iter()
        .enumerate()
        .flat_map(|(k, block)| {
            block.connectivity.chunks(block.kind.nodes()).map(move |nodes| ElementTask { elements: k, nodes })
        })
        .collect();
    let pattern = Pattern::new(&tasks, numbering);
    let mut values: [Vec<f64>; N] = std::array::from_fn(|_| vec![0.0; pattern.rows.len()]);
    for (batch, tasks) in tasks.chunks(BATCH).enumerate() {
        let matrices: Vec<[Vec<f64>; N]> = parallel::try_each_place(tasks.len(), |k| {
            let task = &tasks[k];
            let places = task.nodes.iter().map(|node| mesh.nodes[*node]).collect();
            let (elements, number) = (&kinds[task.elements], batch * BATCH + k);
            of_element(&OneElement { elements, number, nodes: task.nodes, places })
        })?;
        for (task, matrices) in tasks.iter().zip(&matrices) {
            pattern.add(&mut values, task, numbering, matrices);
        }
    }
    Ok(values.map(|values| pattern.matrix(values)))
}

/// M a of a mesh that moves with one acceleration a in m/s², in N on the free displacements: its inertia load.
///
/// Held displacements move too, so that what their mass pushes on free ones is counted: for held structures the product of the mass
/// on the free displacements alone would lack it.
///
/// # Errors
/// As of [`assemble`].
pub fn inertia_load(
    mesh: &Mesh,
    materials: &BTreeMap<String, (Elastic, ElementSection)>,
    numbering: &Numbering,
    acceleration: [f64; 3],
) -> Result<Vec<f64>, StructureError> {
    let mut load = vec![0.0; numbering.freedoms().len()];
    each_element(mesh, materials, |one| {
        let matrices = one.elements.matrices(one.number, &one.places)?;
        for (i, freedom) in numbering.of_element(one.nodes).enumerate() {
            let Some(freedom) = freedom else { continue };
            let row = &matrices.mass[i * matrices.size..(i + 1) * matrices.size];
            let along = |j: usize| acceleration[j % numbering.dimension()];
            load[freedom] += row.iter().enumerate().map(|(j, mass)| mass * along(j)).sum::<f64>();
        }
        Ok(())
    })?;
    Ok(load)
}

/// −K u of held displacements u in m, in N on the free displacements: what displaced supports do.
///
/// # Errors
/// As of [`assemble`].
pub fn displacement_load(
    mesh: &Mesh,
    materials: &BTreeMap<String, (Elastic, ElementSection)>,
    numbering: &Numbering,
    displaced: &BTreeMap<(usize, Direction), f64>,
) -> Result<Vec<f64>, StructureError> {
    let mut load = vec![0.0; numbering.freedoms().len()];
    each_element(mesh, materials, |one| {
        let directions = &Direction::ALL[..numbering.dimension()];
        let own =
            one.nodes.iter().flat_map(|node| directions.iter().map(|along| displaced.get(&(*node, *along))));
        let moved: Vec<f64> = own.map(|moved| moved.copied().unwrap_or(0.0)).collect();
        if moved.iter().all(|moved| *moved == 0.0) {
            return Ok(());
        }
        let matrices = one.elements.matrices(one.number, &one.places)?;
        for (i, freedom) in numbering.of_element(one.nodes).enumerate() {
            let Some(freedom) = freedom else { continue };
            let row = &matrices.stiffness[i * matrices.size..(i + 1) * matrices.size];
            load[freedom] -= row.iter().zip(&moved).map(|(stiffness, moved)| stiffness * moved).sum::<f64>();
        }
        Ok(())
    })?;
    Ok(load)
}

/// All elements one after the other.
pub(crate) fn each_element(
    mesh: &Mesh,
    materials: &BTreeMap<String, (Elastic, ElementSection)>,
    mut with: impl FnMut(&OneElement<'_>) -> Result<(), StructureError>,
) -> Result<(), StructureError> {
    mesh.check()?;
    let kinds = kinds(mesh, materials)?;
    let elements = mesh.blocks.iter().zip(&kinds).flat_map(|(block, elements)| {
        block.connectivity.chunks(block.kind.nodes()).map(move |nodes| (elements, nodes))
    });
    for (number, (elements, nodes)) in elements.enumerate() {
        let places = nodes.iter().map(|node| mesh.nodes[*node]).collect();
        with(&OneElement { elements, number, nodes, places })?;
    }
    Ok(())
}

/// What computes each block's elements.
fn kinds(
    mesh: &Mesh,
    materials: &BTreeMap<String, (Elastic, ElementSection)>,
) -> Result<Vec<BlockElements>, StructureError> {
    mesh.blocks
        .iter()
        .map(|block| {
            let (material, section) =
                materials.get(&block.material).ok_or_else(|| StructureError::UnknownMaterial {
                    name: block.material.clone(),
                    known: materials.keys().cloned().collect(),
                })?;
            BlockElements::new(block.kind, material, *section)
        })
        .collect()
}

/// Where entries can be that are not zero, by columns with ascending rows.
struct Pattern {
    starts: Vec<usize>,
    rows: Vec<usize>,
}

impl Pattern {
    fn new(tasks: &[ElementTask<'_>], numbering: &Numbering) -> Self {
        let count = numbering.freedoms().len();
        let mut touching: Vec<Vec<usize>> = vec![Vec::new(); count];
        for (k, task) in tasks.iter().enumerate() {
            for freedom in numbering.of_element(task.nodes).flatten() {
                if touching[freedom].last() != Some(&k) {
                    touching[freedom].push(k);
                }
            }
        }
        let columns: Vec<Vec<usize>> = parallel::each(&touching, |elements| {
            let own = |k: &usize| numbering.of_element(tasks[*k].nodes).flatten();
            let mut rows: Vec<usize> = elements.iter().flat_map(own).collect();
            rows.sort_unstable();
            rows.dedup();
            rows
        });
        let mut starts = Vec::with_capacity(count + 1);
        starts.push(0);
        for column in &columns {
            starts.push(starts[starts.len() - 1] + column.len());
        }
        Self { starts, rows: columns.concat() }
    }

    fn add<const N: usize>(
        &self,
        values: &mut [Vec<f64>; N],
        task: &ElementTask<'_>,
        numbering: &Numbering,
        matrices: &[Vec<f64>; N],
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
                    for (values, matrix) in values.iter_mut().zip(matrices) {
                        values[start + place] += matrix[i * numbers.len() + j];
                    }
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::beam::Beam;
    use crate::freedom::{Direction, Supports};

    /// A free body pushes back with its whole mass, and the load is the product of mass and acceleration.
    #[test]
    fn a_free_body_pushes_back_with_its_whole_mass() {
        let beam = Beam { length: 0.3, thickness: 0.02, elements: [5, 2], origin: [0.0; 2], angle: 0.3 }
            .mesh("m")
            .unwrap();
        let own =
            (Elastic::new(71e9, 0.33, 2770.0).unwrap(), ElementSection::PlaneStress { thickness: 0.01 });
        let materials = BTreeMap::from([("m".to_owned(), own)]);
        let numbering = Numbering::new(&beam, 2, &Supports::default()).unwrap();
        let load = inertia_load(&beam, &materials, &numbering, [2.0, -1.0, 0.0]).unwrap();
        let along = |direction| {
            let own = numbering
                .freedoms()
                .iter()
                .zip(&load)
                .filter(move |(freedom, _)| freedom.direction == direction);
            own.map(|(_, load)| load).sum::<f64>()
        };
        let mass = 0.3 * 0.02 * 0.01 * 2770.0;
        assert!(
            (along(Direction::X) - 2.0 * mass).abs() < 1e-12 && (along(Direction::Y) + mass).abs() < 1e-12
        );
        let assembled = assemble(&beam, &materials, &numbering).unwrap();
        let moved: Vec<f64> = numbering
            .freedoms()
            .iter()
            .map(|f| if f.direction == Direction::X { 2.0 } else { -1.0 })
            .collect();
        let product = crate::statics::product(&assembled.mass, &moved);
        assert!(load.iter().zip(&product).all(|(a, b)| (a - b).abs() < 1e-15));
    }
}
