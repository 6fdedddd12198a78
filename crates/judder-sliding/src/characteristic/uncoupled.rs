//! Eigenvalues that D cannot show: those of modes that the contact does not move, and of modes that are equal but for their shapes.

use super::PairCharacteristic;
use judder_numerics::order::sort_by_number;
use num_complex::Complex64;

/// Modes whose frequency and damping differ by no more than this share of the frequency are equal.
const EQUAL: f64 = 1e-13;
/// A pivot so small, as a share of the largest entry, is none.
const PIVOT: f64 = 1e-12;

impl PairCharacteristic {
    /// The function with as many modes of each frequency as the contact can couple, and the eigenvalues of the others, of conjugate pairs the upper ones:
    /// `None` where there are no others.
    ///
    /// m equal modes push on the contact as one does whose products are the sums of theirs. The sums are a matrix of rank r, no more than the
    /// order of D: D has a pole of order r there, and m − r combinations of the modes that the contact neither moves nor sees swing on
    /// as if alone.
    pub(crate) fn without_uncoupled(&self) -> Option<(Self, Vec<Complex64>)> {
        let mut order: Vec<usize> = (0..self.modes).collect();
        sort_by_number(&mut order, |mode| self.frequencies[*mode]);
        let mut groups: Vec<Vec<usize>> = Vec::new();
        for mode in order {
            let own = groups.iter_mut().rev().take_while(|group| self.is_near(group[0], mode));
            match own.into_iter().find(|group| self.is_equal(group[0], mode)) {
                Some(group) => group.push(mode),
                None => groups.push(vec![mode]),
            }
        }
        let (mut modes, mut free) = (Vec::new(), Vec::new());
        for group in &groups {
            let sums: Vec<f64> =
                self.products.iter().map(|products| group.iter().map(|mode| products[*mode]).sum()).collect();
            let coupled = rank(&sums, self.order).min(group.len());
            modes.extend((0..coupled).map(|k| (group[0], if k == 0 { Some(sums.clone()) } else { None })));
            for _ in coupled..group.len() {
                free.extend(self.poles(group[0]).into_iter().filter(|pole| pole.im >= 0.0));
            }
        }
        (!free.is_empty()).then(|| (self.with_modes(&modes), free))
    }

    fn is_near(&self, first: usize, other: usize) -> bool {
        (self.frequencies[first] - self.frequencies[other]).abs() <= EQUAL * self.frequencies[first]
    }

    fn is_equal(&self, first: usize, other: usize) -> bool {
        let apart = (self.damping[first] - self.damping[other]).abs();
        self.is_near(first, other) && (apart == 0.0 || apart <= EQUAL * self.frequencies[first])
    }

    /// The same function of other modes, each like one of this and with these products, or none.
    fn with_modes(&self, modes: &[(usize, Option<Vec<f64>>)]) -> Self {
        let padded = modes.len().next_multiple_of(super::LANES);
        let filled = |list: &mut dyn Iterator<Item = f64>, value: f64| {
            let mut list: Vec<f64> = list.collect();
            list.resize(padded, value);
            list
        };
        let product =
            |entry: usize| modes.iter().map(move |(_, sums)| sums.as_ref().map_or(0.0, |own| own[entry]));
        Self {
            order: self.order,
            modes: modes.len(),
            frequencies: filled(&mut modes.iter().map(|(mode, _)| self.frequencies[*mode]), 1.0),
            damping: filled(&mut modes.iter().map(|(mode, _)| self.damping[*mode]), 0.0),
            products: (0..self.products.len()).map(|entry| filled(&mut product(entry), 0.0)).collect(),
            follows_velocity: self.follows_velocity.clone(),
        }
    }
}

/// The rank of a square matrix whose rows and columns have units of their own, by elimination with full pivots; in doubt the larger one.
fn rank(matrix: &[f64], order: usize) -> usize {
    let mut left = matrix.to_vec();
    // every row, then every column as large as the others
    for is_row in [true, false] {
        for line in 0..order {
            let place = |k: usize| if is_row { line * order + k } else { k * order + line };
            let largest = (0..order).map(|k| left[place(k)].abs()).fold(0.0, f64::max);
            if largest > 0.0 {
                (0..order).for_each(|k| left[place(k)] /= largest);
            }
        }
    }
    let mut rank = 0;
    loop {
        let best = (0..left.len()).max_by(|a, b| left[*a].abs().total_cmp(&left[*b].abs()));
        let Some(pivot) = best.filter(|place| rank < order && left[*place].abs() > PIVOT) else {
            return rank;
        };
        let (row, column, size) = (pivot / order, pivot % order, left[pivot]);
        let of_pivot: Vec<f64> = (0..order).map(|k| left[row * order + k] / size).collect();
        for other in 0..order {
            let factor = left[other * order + column];
            for (k, own) in of_pivot.iter().enumerate() {
                left[other * order + k] -= factor * own;
            }
            left[other * order + column] = 0.0;
        }
        (0..order).for_each(|k| left[row * order + k] = 0.0);
        rank += 1;
    }
}
