//! The eigenvalues of a disc around a shift, with right and left vectors that belong together.

use super::krylov::{FoundAroundShift, search};
use super::linearised::LinearisedOperator;
use super::matching::one_to_one;
use super::shift::ShiftedFactor;
use super::vectors::{bilinear, column};
use crate::StructureError;
use crate::quadratic::{MatrixSide, Quadratic};
use faer::{Mat, c64};
use judder_dense::general::solve_complex;
use judder_memory::HeldMemory;
use judder_numerics::complex::ElementaryComplex;

/// An eigenvalue with its vectors, each of length one.
#[derive(Debug, Clone)]
pub(crate) struct Triple {
    /// λ.
    pub(crate) value: c64,
    /// x with Q(λ) x = 0.
    pub(crate) right: Vec<c64>,
    /// z with zᵀ Q(λ) = 0, the conjugate of the left vector.
    pub(crate) left: Vec<c64>,
}

/// A disc that was searched from both sides.
#[derive(Debug)]
pub(super) struct SearchedDisc {
    pub(super) factor: ShiftedFactor,
    /// Every eigenvalue nearer to the shift was found, but for the lonely ones.
    pub(super) radius: f64,
    /// As far as was asked and found.
    pub(super) reach: f64,
    pub(super) triples: Vec<Triple>,
    /// Eigenvalues are too many in one place: there may be more of them.
    pub(super) crowded: bool,
    /// Eigenvalues within the radius that only one side has found.
    pub(super) lonely: Vec<c64>,
}

/// Eigenvalues that two searches found may differ by this share of the radius: what rounding does to a defective one.
pub(super) const SAME: f64 = 1e-5;
/// Within this share of the radius both searches must have found the same.
const WELL_INSIDE: f64 = 0.98;
/// Eigenvalues nearer to each other than this share of the radius have vectors that mix.
const CLUSTER: f64 = 1e-7;

impl SearchedDisc {
    /// Searches around a centre, out to the asked radius or as far as one search reaches.
    pub(super) fn search(
        problem: &Quadratic,
        centre: c64,
        asked: f64,
        memory: &HeldMemory,
    ) -> Result<Self, StructureError> {
        const SEEDS: (u64, u64) = (101, 202);
        let mut factor = ShiftedFactor::near(problem, centre, asked, memory)?;
        let of = |side| LinearisedOperator { problem, factor: &factor, side, reach: asked };
        let (right, left) = rayon::join(
            || search(&of(MatrixSide::Right), SEEDS.0),
            || search(&of(MatrixSide::Left), SEEDS.1),
        );
        let (right, left) = (right?, left?);
        let radius = right.radius.min(left.radius);
        let reach = asked.min(radius);
        let (mut triples, lonely) = pair(factor.shift(), &right, &left, reach);
        // as they are found, and once more as they will be refined
        factor.take(triples.len() * 4 * problem.size() * size_of::<c64>())?;
        biorthogonalise(problem, &mut triples, CLUSTER * reach);
        let crowded = right.crowded || left.crowded;
        Ok(Self { factor, radius, reach, triples, crowded, lonely })
    }
}

/// Triples of what both sides have found, and what within the radius only one side has.
fn pair(
    centre: c64,
    right: &FoundAroundShift,
    left: &FoundAroundShift,
    radius: f64,
) -> (Vec<Triple>, Vec<c64>) {
    let values = |found: &FoundAroundShift| found.pairs.iter().map(|pair| pair.value).collect::<Vec<_>>();
    let (of_right, of_left) = (values(right), values(left));
    let mut pairs = one_to_one(&of_right, &of_left, SAME * radius);
    pairs.sort_unstable();
    let triples = pairs.iter().map(|(i, j)| Triple {
        value: 0.5 * (of_right[*i] + of_left[*j]),
        right: right.pairs[*i].vector.clone(),
        left: left.pairs[*j].vector.clone(),
    });
    let alone = |values: &[c64], paired: Vec<usize>| -> Vec<c64> {
        let unpaired = (0..values.len()).filter(|k| !paired.contains(k)).map(|k| values[k]);
        unpaired.filter(|value| (value - centre).modulus() <= WELL_INSIDE * radius).collect()
    };
    let mut lonely = alone(&of_right, pairs.iter().map(|(i, _)| *i).collect());
    lonely.extend(alone(&of_left, pairs.iter().map(|(_, j)| *j).collect()));
    (triples.collect(), lonely)
}

/// Makes the left vectors of a multiple eigenvalue orthogonal to the right vectors of its others: zᵢᵀ ((λᵢ+λⱼ) M + C) xⱼ = 0.
///
/// Left as they are where the eigenvalue is defective: no such vectors exist.
pub(super) fn biorthogonalise(problem: &Quadratic, triples: &mut [Triple], distance: f64) {
    /// A smaller share of the vectors' products than this is rounding.
    const DEFECTIVE: f64 = 1e-6;
    let mut taken = vec![false; triples.len()];
    for first in 0..triples.len() {
        let close =
            |k: &usize| !taken[*k] && (triples[*k].value - triples[first].value).modulus() <= distance;
        let cluster: Vec<usize> = (first..triples.len()).filter(close).collect();
        cluster.iter().for_each(|k| taken[*k] = true);
        if cluster.len() < 2 {
            continue;
        }
        let slope = |i: usize, j: usize| {
            let middle = 0.5 * (triples[i].value + triples[j].value);
            let image = problem.slope(MatrixSide::Right, middle, column(&triples[j].right));
            bilinear(&triples[i].left, image.col(0))
        };
        let products = Mat::from_fn(cluster.len(), cluster.len(), |i, j| slope(cluster[i], cluster[j]));
        let mut inverse = Mat::<c64>::identity(cluster.len(), cluster.len());
        if solve_complex(products.clone(), &mut inverse).is_none() {
            continue;
        }
        let (norm, of_inverse) = (products.norm_l2(), inverse.norm_l2());
        // of a defective eigenvalue the products are singular
        let condition = norm * of_inverse;
        if condition.is_nan() || condition > 1.0 / DEFECTIVE {
            continue;
        }
        let combined: Vec<Vec<c64>> = (0..cluster.len())
            .map(|i| {
                let mut sum = vec![c64::new(0.0, 0.0); problem.size()];
                for (j, member) in cluster.iter().enumerate() {
                    for (s, z) in sum.iter_mut().zip(&triples[*member].left) {
                        *s += inverse[(i, j)] * z;
                    }
                }
                sum
            })
            .collect();
        for (member, left) in cluster.iter().zip(combined) {
            triples[*member].left = left;
            super::vectors::normalise(&mut triples[*member].left);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::krylov::EigenPair;
    use super::*;

    fn found(values: &[f64]) -> FoundAroundShift {
        let pair = |value: &f64| EigenPair { value: c64::new(*value, 0.0), vector: vec![c64::new(1.0, 0.0)] };
        FoundAroundShift { pairs: values.iter().map(pair).collect(), radius: 10.0, crowded: false }
    }

    #[test]
    fn an_eigenvalue_hidden_from_one_side_is_lonely() {
        let centre = c64::new(0.0, 0.0);
        let (triples, lonely) = pair(centre, &found(&[1.0, 2.0, 3.0]), &found(&[1.0, 3.0 + 1e-7]), 10.0);
        assert_eq!(triples.len(), 2);
        assert_eq!(lonely, [c64::new(2.0, 0.0)]);
        let (triples, lonely) = pair(centre, &found(&[1.0]), &found(&[1.0, 9.9]), 10.0);
        assert_eq!((triples.len(), lonely.len()), (1, 0));
    }
}
