//! Whether a symmetric matrix is clearly positive, told by products with it alone: what elements make is, and its factors would take as long as modes.

use crate::assembly::Sparse;
use crate::statics::{dot, symmetric_product};
use judder_numerics::counter::uniform;
use std::f64::consts::TAU;

/// Steps of Lanczos' method at most: masses of twenty-node bricks, whose eigenvalues spread most, take about 250.
const STEPS: usize = 400;
/// The probability that a matrix with an eigenvalue of zero or less is taken for one without.
const DOUBT: f64 = 1e-12;

/// Whether all eigenvalues of a symmetric matrix, whose diagonal is of ones, are surely above zero; if not so, nothing is known.
///
/// Gershgorin's circles tell it of masses that are lumped. Of others Lanczos' method from a random vector: after k of its steps the lowest eigenvalue θ of its
/// tridiagonal matrix lies above the lowest λ of all n by more than ε (λ_max − λ) with a probability below 1.648 √n exp(−√ε (2k − 1)) (J. Kuczyński and
/// H. Woźniakowski, *Estimating the largest eigenvalue by the power and Lanczos algorithms with a random start*, SIAM Journal on Matrix Analysis and
/// Applications 13, 1992, theorem 4.2). Were λ not above zero, ε would be θ/λ_max or more.
pub(super) fn is_clearly_positive(matrix: &Sparse) -> bool {
    let size = matrix.nrows();
    if (0..size).any(|k| matrix.get(k, k).is_none_or(|value| *value <= 0.0)) {
        return false;
    }
    let of_column = |k: usize| matrix.val_of_col(k).iter().map(|value| value.abs()).sum::<f64>();
    let largest = (0..size).map(of_column).fold(0.0, f64::max);
    // each circle is about one
    if largest < 2.0 {
        return true;
    }
    let asked = libm::log(1.648 * (size as f64).sqrt() / DOUBT);
    let least = |step: usize| largest * (asked / (2 * step - 1) as f64).powi(2);
    let mut course = LanczosCourse::new(matrix);
    for step in 1..=STEPS.min(size) {
        if !course.advance() || !course.lies_above(least(STEPS)) {
            return false;
        }
        if course.lies_above(least(step)) {
            return true;
        }
    }
    false
}

/// Lanczos' method without orthogonalisation: it tells the ends of the spectrum, later and twice at worst.
struct LanczosCourse<'a> {
    matrix: &'a Sparse,
    last: Vec<f64>,
    vector: Vec<f64>,
    diagonal: Vec<f64>,
    /// Before each entry of the diagonal.
    beside: Vec<f64>,
}

impl<'a> LanczosCourse<'a> {
    fn new(matrix: &'a Sparse) -> Self {
        let size = matrix.nrows();
        let mut vector: Vec<f64> = (0..size as u64).map(gaussian).collect();
        let length = dot(&vector, &vector).sqrt();
        vector.iter_mut().for_each(|value| *value /= length);
        Self { matrix, last: vec![0.0; size], vector, diagonal: Vec::new(), beside: vec![0.0] }
    }

    /// One more step; whether there may be another.
    fn advance(&mut self) -> bool {
        let mut image = symmetric_product(self.matrix, &self.vector);
        let own = dot(&image, &self.vector);
        let before = self.beside.last().copied().unwrap_or(0.0);
        for ((image, vector), last) in image.iter_mut().zip(&self.vector).zip(&self.last) {
            *image -= own * vector + before * last;
        }
        let length = dot(&image, &image).sqrt();
        self.diagonal.push(own);
        self.beside.push(length);
        image.iter_mut().for_each(|value| *value /= length);
        self.last = std::mem::replace(&mut self.vector, image);
        length.is_normal()
    }

    /// Whether all eigenvalues of the tridiagonal matrix lie above a value, by the signs of its pivots.
    fn lies_above(&self, value: f64) -> bool {
        let mut pivot = f64::INFINITY;
        self.diagonal.iter().zip(&self.beside).all(|(own, beside)| {
            pivot = own - value - beside * beside / pivot;
            pivot > 0.0
        })
    }
}

/// A normally distributed number by its place (G. E. P. Box and M. E. Muller, 1958): directions of such vectors are even.
fn gaussian(place: u64) -> f64 {
    let (radius, angle) = (1.0 - uniform(0, 2 * place), uniform(0, 2 * place + 1));
    (-2.0 * libm::log(radius)).sqrt() * libm::cos(TAU * angle)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::assembly::assemble;
    use crate::definiteness::scaled;
    use crate::element::ElementKind;
    use crate::freedom::{Numbering, Supports};
    use crate::grid::Grid;
    use crate::material::{Elastic, ElementSection};
    use faer::sparse::Triplet;

    /// The mass of a box of so many cells, stretched along one direction.
    fn mass(kind: ElementKind, cells: [usize; 3]) -> Sparse {
        let size = [1.0, 2.0, 0.1];
        let mesh = Grid { kind, size, cells }.mesh("steel", |place| place).unwrap();
        let numbering = Numbering::new(&mesh, kind.dimension(), &Supports::default()).unwrap();
        let section = match kind.dimension() {
            3 => ElementSection::Solid,
            _ => ElementSection::PlaneStress { thickness: 1.0 },
        };
        let steel = (Elastic::new(2.1e11, 0.3, 7800.0).unwrap(), section);
        assemble(&mesh, &[("steel".to_owned(), steel)].into(), &numbering).unwrap().mass
    }

    #[test]
    fn masses_of_elements_are_clearly_positive() {
        for kind in ElementKind::ALL {
            let cells = if kind.dimension() == 3 { [5, 4, 3] } else { [14, 11, 1] };
            assert!(is_clearly_positive(&scaled(&mass(kind, cells)).unwrap()), "{kind:?}");
        }
    }

    /// One motion without mass, or with less, among all of a mesh.
    #[test]
    fn what_is_not_positive_is_not_clearly_so() {
        let whole = mass(ElementKind::Hexahedron8, [7, 6, 4]);
        for share in [1.0, 1.0 + 1e-6, 1.5] {
            for node in [0, 100, whole.nrows() - 1] {
                // two freedoms more that share the mass of one
                let entries = whole.col_ptr().len() - 1;
                let mut triplets = vec![
                    Triplet::new(entries, entries, 1.0),
                    Triplet::new(entries, node, share * whole.get(node, node).unwrap().sqrt()),
                    Triplet::new(node, entries, share * whole.get(node, node).unwrap().sqrt()),
                ];
                for column in 0..whole.ncols() {
                    for (row, value) in whole.row_idx_of_col(column).zip(whole.val_of_col(column)) {
                        triplets.push(Triplet::new(row, column, *value));
                    }
                }
                let size = entries + 1;
                let matrix = Sparse::try_new_from_triplets(size, size, &triplets).unwrap();
                assert!(!is_clearly_positive(&scaled(&matrix).unwrap()), "{share} {node}");
            }
        }
    }
}
