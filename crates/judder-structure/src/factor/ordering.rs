//! The order of elimination of a sparse symmetric matrix: the best of nested dissections and a minimum degree.
//!
//! A. George, *Nested dissection of a regular finite element mesh*, SIAM Journal on Numerical Analysis 10 (1973); P. R. Amestoy,
//! T. A. Davis and I. S. Duff, *An approximate minimum degree ordering algorithm*, SIAM Journal on Matrix Analysis 17 (1996).

use crate::StructureError;
use crate::assembly::Sparse;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::sparse::SymbolicSparseColMat;
use faer::sparse::linalg::amd;
use faer::sparse::linalg::cholesky::simplicial::{
    prefactorize_symbolic_cholesky, prefactorize_symbolic_cholesky_scratch,
};
use feral_scotch::{CscPattern, ScotchOptions, scotch_order_full};
use judder_numerics::parallel;

/// Factorisations of fewer operations are done before a dissection is.
const WORTH_DISSECTING: f64 = 5e8;
/// Seeds of the dissections that are tried; their counts of operations differ by a third on a cube.
const SEEDS: [u64; 4] = [1, 2, 3, 4];
/// How far the two sides of a separator may differ.
const IMBALANCE: f64 = 0.1;

/// The rows of the matrix in the order in which they are eliminated.
///
/// # Errors
/// [`StructureError::OutOfMemory`].
pub(super) fn order(matrix: &Sparse) -> Result<Vec<usize>, StructureError> {
    let full = Graph::of_lower_triangle(matrix);
    let (groups, graph) = full.grouped();
    let mut best = minimum_degree(&graph, matrix.nrows())?;
    let mut fewest = operations(&graph, &best)?;
    let rows_of_group = matrix.nrows() as f64 / groups.len().max(1) as f64;
    if fewest * rows_of_group.powi(3) > WORTH_DISSECTING {
        let dissected = |seed: &u64| -> Result<_, StructureError> {
            dissection(&graph, *seed).map(|order| Ok((operations(&graph, &order)?, order))).transpose()
        };
        let dissected = parallel::try_each(&SEEDS, dissected)?;
        for (operations, order) in dissected.into_iter().flatten() {
            // of equals the first
            if operations < fewest {
                (fewest, best) = (operations, order);
            }
        }
    }
    Ok(best.iter().flat_map(|group| groups[*group].iter().copied()).collect())
}

/// Neighbours of vertices, each with itself, ascending.
struct Graph {
    starts: Vec<usize>,
    neighbours: Vec<usize>,
}

impl Graph {
    fn of(&self, vertex: usize) -> &[usize] {
        &self.neighbours[self.starts[vertex]..self.starts[vertex + 1]]
    }

    fn vertices(&self) -> usize {
        self.starts.len() - 1
    }

    fn of_lower_triangle(matrix: &Sparse) -> Self {
        let size = matrix.nrows();
        let below = |column: usize| matrix.row_idx_of_col(column).filter(move |row| *row > column);
        let mut counts = vec![1; size];
        for column in 0..size {
            for row in below(column) {
                counts[row] += 1;
                counts[column] += 1;
            }
        }
        let mut starts = vec![0; size + 1];
        for (k, count) in counts.iter().enumerate() {
            starts[k + 1] = starts[k] + count;
        }
        let mut next = starts.clone();
        let mut neighbours = vec![0; starts[size]];
        let mut put = |vertex: usize, neighbour: usize| {
            neighbours[next[vertex]] = neighbour;
            next[vertex] += 1;
        };
        // columns before a vertex come first: its list ascends
        for column in 0..size {
            put(column, column);
            for row in below(column) {
                put(column, row);
                put(row, column);
            }
        }
        Self { starts, neighbours }
    }

    /// Vertices with the same neighbours, as the displacements of a node have them, become one.
    fn grouped(&self) -> (Vec<Vec<usize>>, Self) {
        const NONE: usize = usize::MAX;
        let mut group_of = vec![NONE; self.vertices()];
        let mut groups: Vec<Vec<usize>> = Vec::new();
        for vertex in 0..self.vertices() {
            if group_of[vertex] != NONE {
                continue;
            }
            let own = self.of(vertex);
            let same: Vec<usize> = own
                .iter()
                .copied()
                .filter(|other| *other >= vertex && group_of[*other] == NONE && self.of(*other) == own)
                .collect();
            for member in &same {
                group_of[*member] = groups.len();
            }
            groups.push(same);
        }
        let (mut starts, mut neighbours) = (vec![0], Vec::new());
        for members in &groups {
            let start = neighbours.len();
            neighbours.extend(self.of(members[0]).iter().map(|vertex| group_of[*vertex]));
            neighbours[start..].sort_unstable();
            let mut own = neighbours.split_off(start);
            own.dedup();
            neighbours.append(&mut own);
            starts.push(neighbours.len());
        }
        (groups, Self { starts, neighbours })
    }
}

/// `None` where the graph is too large for its numbers, or cannot be cut.
fn dissection(graph: &Graph, seed: u64) -> Option<Vec<usize>> {
    let short = |numbers: &[usize]| -> Option<Vec<i32>> {
        numbers.iter().map(|number| i32::try_from(*number).ok()).collect()
    };
    let (starts, neighbours) = (short(&graph.starts)?, short(&graph.neighbours)?);
    let pattern = CscPattern::new(graph.vertices(), &starts, &neighbours)?;
    let options =
        ScotchOptions { seed, max_imbalance: IMBALANCE, compress: false, ..ScotchOptions::default() };
    let (order, _, _) = scotch_order_full(&pattern, &options).ok()?;
    let order: Vec<usize> = order.iter().map(|k| usize::try_from(*k).ok()).collect::<Option<_>>()?;
    is_permutation(&order, graph.vertices()).then_some(order)
}

fn is_permutation(order: &[usize], size: usize) -> bool {
    let mut seen = vec![false; size];
    order.len() == size && order.iter().all(|k| *k < size && !std::mem::replace(&mut seen[*k], true))
}

fn minimum_degree(graph: &Graph, rows: usize) -> Result<Vec<usize>, StructureError> {
    let size = graph.vertices();
    let out_of_memory = || StructureError::OutOfMemory { rows };
    let pattern =
        SymbolicSparseColMat::new_checked(size, size, graph.starts.clone(), None, graph.neighbours.clone());
    let (mut forward, mut inverse) = (vec![0; size], vec![0; size]);
    let needed = amd::order_scratch::<usize>(size, graph.neighbours.len());
    let mut memory = MemBuffer::try_new(needed).map_err(|_| out_of_memory())?;
    amd::order(
        &mut forward,
        &mut inverse,
        pattern.as_ref(),
        amd::Control::default(),
        MemStack::new(&mut memory),
    )
    .map_err(|_| out_of_memory())?;
    Ok(forward)
}

/// Σ c² over the columns of the factor with c entries each: half the multiplications and additions of the factorisation.
fn operations(graph: &Graph, order: &[usize]) -> Result<f64, StructureError> {
    let size = order.len();
    let mut place = vec![0; size];
    for (k, vertex) in order.iter().enumerate() {
        place[*vertex] = k;
    }
    let (mut starts, mut rows) = (vec![0], Vec::with_capacity(graph.neighbours.len() / 2 + size));
    for (column, vertex) in order.iter().enumerate() {
        // of the upper triangle
        let start = rows.len();
        rows.extend(graph.of(*vertex).iter().map(|other| place[*other]).filter(|row| *row <= column));
        rows[start..].sort_unstable();
        starts.push(rows.len());
    }
    let nonzeros = rows.len();
    let pattern = SymbolicSparseColMat::new_checked(size, size, starts, None, rows);
    let (mut tree, mut counts) = (vec![0; size], vec![0_usize; size]);
    let needed = prefactorize_symbolic_cholesky_scratch::<usize>(size, nonzeros);
    let mut memory = MemBuffer::try_new(needed).map_err(|_| StructureError::OutOfMemory { rows: size })?;
    prefactorize_symbolic_cholesky(&mut tree, &mut counts, pattern.as_ref(), MemStack::new(&mut memory));
    Ok(counts.iter().map(|count| (*count as f64).powi(2)).sum())
}

#[cfg(test)]
mod tests {
    use super::*;
    use faer::sparse::Triplet;

    /// The pattern of so many freedoms at each point of a cube's grid, each with its 26 neighbours.
    fn cube(side: usize, freedoms: usize) -> Sparse {
        let points: Vec<[usize; 3]> =
            (0..side.pow(3)).map(|k| [k % side, k / side % side, k / side / side]).collect();
        let mut entries = Vec::new();
        for (a, p) in points.iter().enumerate() {
            for (b, q) in points.iter().enumerate() {
                if p.iter().zip(q).all(|(p, q)| p.abs_diff(*q) <= 1) {
                    for (i, j) in (0..freedoms).flat_map(|i| (0..freedoms).map(move |j| (i, j))) {
                        entries.push(Triplet::new(freedoms * a + i, freedoms * b + j, 1.0));
                    }
                }
            }
        }
        let size = freedoms * points.len();
        Sparse::try_new_from_triplets(size, size, &entries).unwrap()
    }

    #[test]
    fn freedoms_of_a_node_are_one_group() {
        let (groups, graph) = Graph::of_lower_triangle(&cube(3, 3)).grouped();
        assert_eq!(groups.len(), 27);
        assert!(groups.iter().all(|group| group.len() == 3));
        assert_eq!(graph.of(13).len(), 27);
    }

    #[test]
    fn a_dissected_cube_takes_fewer_operations_than_by_minimum_degree_and_every_row_once() {
        let matrix = cube(12, 3);
        let graph = Graph::of_lower_triangle(&matrix);
        let by_degree = operations(&graph, &minimum_degree(&graph, 1).unwrap()).unwrap();
        let best = order(&matrix).unwrap();
        assert!(is_permutation(&best, matrix.nrows()));
        let operations = operations(&graph, &best).unwrap();
        assert!(operations < 0.8 * by_degree, "{operations:e} {by_degree:e}");
    }
}
