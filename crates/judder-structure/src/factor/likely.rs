//! How many numbers the factors of a matrix are likely to hold, before an order of elimination is sought: those of boxes that are halved.
//!
//! A. George, *Nested dissection of a regular finite element mesh*, SIAM Journal on Numerical Analysis 10 (1973).

use crate::assembly::Sparse;

/// Orders that are found hold so much more than halves of a perfect box: measured of plates, bars, slabs and cubes of four kinds of elements with 6000 to 250 000 rows
/// 1.1 to 1.45; nearer to the lower end the larger they are.
const FOUND: f64 = 1.2;
/// Sides that a box has at most.
const SIDES: usize = 3;

/// Numbers that the factors of a symmetric matrix are likely to hold, 8 bytes each, from the extent of its graph alone: within a third where it is of a mesh of some
/// thousand rows. Both triangles are read.
#[must_use]
pub fn likely_entries(matrix: &Sparse) -> f64 {
    let mut search = Search::new(matrix);
    let mut entries = 0.0;
    for row in 0..matrix.nrows() {
        if search.marks[row] == NEVER_FOUND {
            entries += search.filled_box(row).entries();
        }
    }
    entries
}

/// A part of a graph, as the box that it fills.
struct GraphBox {
    rows: f64,
    /// Rows from side to side, in steps of the graph; none where all are neighbours.
    sides: Vec<f64>,
    /// Entries a row.
    neighbours: f64,
}

impl GraphBox {
    /// Entries of the factors where the longest side is halved until nothing is left to halve: each cut is a dense block with what bounds its part.
    fn entries(mut self) -> f64 {
        if self.sides.is_empty() {
            return self.rows * self.rows;
        }
        let density = self.rows / self.sides.iter().product::<f64>();
        // of rows within a step of each other only some are neighbours: fewer have to go to part them
        let within = density * self.sides.iter().map(|side| 3.0 - 2.0 / side).product::<f64>();
        let thickness = (self.neighbours / within).sqrt().min(1.0);
        let (mut parts, mut total) = (1.0, 0.0);
        // sides at which a part ends at an earlier cut, two at most each way
        let mut bounds = vec![0.0; self.sides.len()];
        loop {
            let rows = density * self.sides.iter().product::<f64>();
            let across = |side: &f64| thickness * rows / side;
            let bounding: f64 =
                self.sides.iter().zip(&bounds).map(|(side, bounds)| bounds * across(side)).sum();
            let longest = self.sides.iter_mut().zip(&mut bounds).max_by(|(a, _), (b, _)| a.total_cmp(b));
            match longest {
                Some((side, bounds)) if *side > 2.0 => {
                    let cut = thickness * rows / *side;
                    total += parts * cut * (cut + bounding);
                    *side = 0.5 * (*side - 1.0);
                    *bounds = 1.0 + 0.5 * *bounds;
                    parts *= 2.0;
                }
                _ => return FOUND * (total + parts * rows * (rows + bounding)),
            }
        }
    }
}

/// The mark of rows that no search has found.
const NEVER_FOUND: u32 = 0;

/// Searches through the graph of a matrix, from neighbours to neighbours.
struct Search<'a> {
    matrix: &'a Sparse,
    /// Which search has found a row last.
    marks: Vec<u32>,
    last_mark: u32,
}

impl<'a> Search<'a> {
    fn new(matrix: &'a Sparse) -> Self {
        Self { matrix, marks: vec![NEVER_FOUND; matrix.nrows()], last_mark: NEVER_FOUND }
    }

    /// The box that all rows fill to which a way leads from this one: as long as it is far from end to end, the sections halfway as wide as they are far, and so on.
    fn filled_box(&mut self, row: usize) -> GraphBox {
        let mut levels = self.levels_of_an_end(row);
        let found = levels.rows.len() as f64;
        let entries: usize = levels.rows.iter().map(|row| self.matrix.val_of_col(*row).len()).sum();
        let mut sides = Vec::new();
        while levels.count() > 2 && sides.len() < SIDES {
            sides.push(levels.count() as f64);
            let section = levels.level(levels.count() / 2);
            self.mark(section);
            levels = self.levels_of_an_end(section[0]);
        }
        GraphBox { rows: found, sides, neighbours: entries as f64 / found }
    }

    /// Levels from all rows that are as far from this one as any with the same mark: from a whole side they go straight to the other.
    fn levels_of_an_end(&mut self, row: usize) -> GraphLevels {
        let levels = self.levels(&[row]);
        self.levels(levels.level(levels.count() - 1))
    }

    /// Rows with the mark of these by their distance from them.
    fn levels(&mut self, from: &[usize]) -> GraphLevels {
        let sought = self.marks[from[0]];
        self.mark(from);
        let (mut rows, mut starts) = (from.to_vec(), vec![0]);
        let mut start = 0;
        while start < rows.len() {
            let end = rows.len();
            starts.push(end);
            for k in start..end {
                for row in self.matrix.row_idx_of_col(rows[k]) {
                    if self.marks[row] == sought {
                        self.marks[row] = self.last_mark;
                        rows.push(row);
                    }
                }
            }
            start = end;
        }
        GraphLevels { rows, starts }
    }

    /// Gives rows a mark of their own.
    fn mark(&mut self, rows: &[usize]) {
        self.last_mark += 1;
        for row in rows {
            self.marks[*row] = self.last_mark;
        }
    }
}

/// Rows by their distance from some.
struct GraphLevels {
    rows: Vec<usize>,
    /// Where each distance begins, and the end.
    starts: Vec<usize>,
}

impl GraphLevels {
    fn count(&self) -> usize {
        self.starts.len() - 1
    }

    fn level(&self, level: usize) -> &[usize] {
        &self.rows[self.starts[level]..self.starts[level + 1]]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::assembly::assemble;
    use crate::element::ElementKind;
    use crate::factor::FactorPattern;
    use crate::freedom::{Direction, Numbering, Supports};
    use crate::grid::Grid;
    use crate::material::{Elastic, ElementSection};
    use faer::sparse::Triplet;

    /// The stiffness of a box of so many cells that is held at one side.
    fn stiffness(kind: ElementKind, cells: [usize; 3]) -> Sparse {
        let size = cells.map(|cells| cells as f64);
        let mesh = Grid { kind, size, cells }.mesh("steel", |place| place).unwrap();
        let dimension = kind.dimension();
        let held = mesh.node_sets["x-min"].iter();
        let fixed =
            held.flat_map(|node| Direction::ALL[..dimension].iter().map(|axis| (*node, *axis))).collect();
        let numbering = Numbering::new(&mesh, dimension, &Supports { fixed, ..Supports::default() }).unwrap();
        let section = match dimension {
            3 => ElementSection::Solid,
            _ => ElementSection::PlaneStress { thickness: 1.0 },
        };
        let steel = (Elastic::new(2.1e11, 0.3, 7800.0).unwrap(), section);
        assemble(&mesh, &[("steel".to_owned(), steel)].into(), &numbering).unwrap().stiffness
    }

    #[test]
    fn what_is_likely_is_what_the_best_order_holds() {
        use ElementKind::{Hexahedron8, Hexahedron20, Quad4, Quad8};
        let meshes = [
            (Quad4, [60, 40, 1]),
            (Quad4, [600, 6, 1]),
            (Quad8, [40, 30, 1]),
            (Hexahedron8, [12, 12, 12]),
            (Hexahedron8, [50, 6, 4]),
            (Hexahedron8, [25, 25, 2]),
            (Hexahedron20, [20, 3, 2]),
            (Hexahedron20, [7, 7, 6]),
        ];
        for (kind, cells) in meshes {
            let matrix = stiffness(kind, cells);
            let held = FactorPattern::new(&matrix).unwrap().entries() as f64;
            let ratio = likely_entries(&matrix) / held;
            assert!((0.7..1.4).contains(&ratio), "{kind:?} {cells:?}: {ratio}");
        }
    }

    #[test]
    fn parts_that_nothing_joins_fill_for_themselves() {
        let size = 12;
        let full = |first: usize| {
            (0..size).flat_map(move |i| (0..size).map(move |j| Triplet::new(first + i, first + j, 1.0)))
        };
        let entries: Vec<_> = full(0).chain(full(size)).collect();
        let matrix = Sparse::try_new_from_triplets(2 * size, 2 * size, &entries).unwrap();
        assert_eq!(likely_entries(&matrix), 2.0 * (size * size) as f64);
    }
}
