//! Quadratic problems whose eigenvalues are planted, with multiplicities up to twelve, against their count and their places.
//!
//! Blocks with known roots stand on a diagonal, some of them many times over, and two random matrices of moderate condition hide them.

use faer::sparse::Triplet;
use faer::{Mat, c64};
use judder_numerics::counter::uniform;
use judder_structure::assembly::Sparse;
use judder_structure::complex_modes::{ComplexModeSettings, Region, complex_modes};
use judder_structure::quadratic::Quadratic;

/// Numbers drawn one after the other.
struct Draw {
    seed: u64,
    next: u64,
}

impl Draw {
    fn share(&mut self) -> f64 {
        self.next += 1;
        uniform(self.seed, self.next)
    }

    fn between(&mut self, from: f64, to: f64) -> f64 {
        from + (to - from) * self.share()
    }

    fn below(&mut self, count: usize) -> usize {
        ((self.share() * count as f64) as usize).min(count - 1)
    }
}

/// Matrices with a block on their diagonals.
#[derive(Default)]
struct Planted {
    size: usize,
    /// Row, column, entry of M, C, K.
    entries: [Vec<(usize, usize, f64)>; 3],
    roots: Vec<c64>,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Kind {
    /// λ² + 2ζω λ + ω² with |ζ| < 1.
    Complex,
    /// The same with |ζ| > 1: two real roots.
    Real,
    /// Two or three of them with a one beside the diagonal: one vector.
    Defective,
    /// (λ² + k)² + g² λ².
    Gyroscopic,
    /// c λ + k.
    Massless,
}

const KINDS: [Kind; 5] = [Kind::Complex, Kind::Real, Kind::Defective, Kind::Gyroscopic, Kind::Massless];
const MOST_COPIES: usize = 12;

impl Planted {
    fn put(&mut self, matrix: usize, row: usize, column: usize, entry: f64) {
        self.entries[matrix].push((self.size + row, self.size + column, entry));
    }

    /// Adds a block; gives its freedoms.
    fn plant(&mut self, kind: Kind, length: usize, numbers: [f64; 2]) {
        let [frequency, ratio] = numbers;
        let freedoms = match kind {
            Kind::Complex | Kind::Real | Kind::Massless => 1,
            Kind::Defective => length,
            Kind::Gyroscopic => 2,
        };
        let pair = |sum: c64, product: c64| {
            let inner = (sum * sum / 4.0 - product).sqrt();
            [sum / 2.0 + inner, sum / 2.0 - inner]
        };
        match kind {
            Kind::Complex | Kind::Real | Kind::Defective => {
                for k in 0..freedoms {
                    self.put(0, k, k, 1.0);
                    self.put(1, k, k, 2.0 * ratio * frequency);
                    self.put(2, k, k, frequency * frequency);
                    if k + 1 < freedoms {
                        self.put(2, k, k + 1, 0.5 * frequency);
                    }
                    let sum = c64::new(-2.0 * ratio * frequency, 0.0);
                    self.roots.extend(pair(sum, c64::new(frequency * frequency, 0.0)));
                }
            }
            Kind::Gyroscopic => {
                let (gyro, stiffness) = (frequency, ratio);
                for k in 0..2 {
                    self.put(0, k, k, 1.0);
                    self.put(2, k, k, stiffness);
                    self.put(1, k, 1 - k, if k == 0 { gyro } else { -gyro });
                }
                for sign in [1.0, -1.0] {
                    self.roots.extend(pair(c64::new(0.0, sign * gyro), c64::new(stiffness, 0.0)));
                }
            }
            Kind::Massless => {
                self.put(1, 0, 0, 1.0);
                self.put(2, 0, 0, frequency);
                self.roots.push(c64::new(-frequency, 0.0));
            }
        }
        self.size += freedoms;
    }

    /// At least so many freedoms, and no more than others.
    fn random(draw: &mut Draw, [least, most]: [usize; 2]) -> Self {
        /// Copies differ by nothing, by rounding, or by so much that a search may take them for one.
        const APART: [f64; 4] = [0.0, 1e-14, 1e-11, 1e-7];
        let mut planted = Self::default();
        let wanted = least + draw.below(most - least);
        while planted.size < wanted {
            let kind = KINDS[draw.below(KINDS.len())];
            let length = 2 + draw.below(2);
            let each = match kind {
                Kind::Defective => length,
                Kind::Gyroscopic => 2,
                _ => 1,
            };
            let room = (most - planted.size) / each;
            if room == 0 {
                break;
            }
            let copies = 1 + draw.below(MOST_COPIES.min(room));
            let frequency = draw.between(1.0, 10.0);
            let ratio = match kind {
                Kind::Real => draw.between(1.1, 1.6),
                Kind::Gyroscopic => draw.between(-4.0, 4.0),
                _ => draw.between(-0.3, 0.6),
            };
            let apart = if kind == Kind::Defective { 0.0 } else { APART[draw.below(APART.len())] };
            for copy in 0..copies {
                planted.plant(kind, length, [frequency * (1.0 + apart * copy as f64), ratio]);
            }
        }
        if planted.entries[0].is_empty() {
            planted.plant(Kind::Complex, 1, [draw.between(1.0, 10.0), 0.05]);
        }
        planted
    }

    fn dense(&self, matrix: usize) -> Mat<f64> {
        let mut dense = Mat::zeros(self.size, self.size);
        for (row, column, entry) in &self.entries[matrix] {
            dense[(*row, *column)] += entry;
        }
        dense
    }
}

/// An orthogonal matrix times scales over half a decade, times another.
fn disguise(size: usize, draw: &mut Draw) -> Mat<f64> {
    let mut matrix =
        Mat::from_fn(size, size, |i, j| if i == j { 10_f64.powf(draw.between(-0.25, 0.25)) } else { 0.0 });
    for side in 0..2 {
        for _ in 0..3 {
            let normal: Vec<f64> = (0..size).map(|_| draw.between(-1.0, 1.0)).collect();
            let squares: f64 = normal.iter().map(|v| v * v).sum();
            let mirror =
                Mat::from_fn(size, size, |i, j| f64::from(i == j) - 2.0 * normal[i] * normal[j] / squares);
            matrix = if side == 0 { &matrix * &mirror } else { &mirror * &matrix };
        }
    }
    matrix
}

fn sparse(dense: &Mat<f64>) -> Sparse {
    let size = dense.nrows();
    let entries = (0..size).flat_map(|j| (0..size).map(move |i| (i, j)));
    let triplets: Vec<_> = entries.map(|(i, j)| Triplet::new(i, j, dense[(i, j)])).collect();
    Sparse::try_new_from_triplets(size, size, &triplets).unwrap()
}

/// A region around a root whose edges keep clear of every root, so that what is inside does not depend on rounding.
fn region(roots: &[c64], draw: &mut Draw) -> Option<Region> {
    const CLEAR: f64 = 0.15;
    let (width, height) = (draw.between(1.0, 20.0), draw.between(1.0, 20.0));
    let centre = roots[draw.below(roots.len())];
    let (re, im) =
        (centre.re + 0.6 * draw.between(-width, width), centre.im + 0.6 * draw.between(-height, height));
    let region =
        Region { re: [re - width / 2.0, re + width / 2.0], im: [im - height / 2.0, im + height / 2.0] };
    let from_edge = |value: &c64| {
        let along = |x: f64, range: [f64; 2]| (x - range[0]).min(range[1] - x);
        along(value.re, region.re).min(along(value.im, region.im)).abs()
    };
    roots.iter().all(|root| from_edge(root) > CLEAR).then_some(region)
}

fn inside(region: &Region, value: c64) -> bool {
    (region.re[0]..=region.re[1]).contains(&value.re) && (region.im[0]..=region.im[1]).contains(&value.im)
}

/// What became of trials.
#[derive(Debug, Default)]
struct Tally {
    trials: usize,
    complete: usize,
    most: usize,
    with_eigenvalues: usize,
    wrong: Vec<String>,
    open: Vec<String>,
}

fn trial(seed: u64, freedoms: [usize; 2], tally: &mut Tally) {
    let mut draw = Draw { seed, next: 0 };
    let planted = Planted::random(&mut draw, freedoms);
    let (left, right) = (disguise(planted.size, &mut draw), disguise(planted.size, &mut draw));
    let matrices = [0, 1, 2].map(|matrix| &left * planted.dense(matrix) * &right);
    let [mass, damping, stiffness] = [0, 1, 2].map(|k| sparse(&matrices[k]));
    let problem = Quadratic::new(mass, damping, stiffness).unwrap();
    let Some(region) = (0..200).find_map(|_| region(&planted.roots, &mut draw)) else { return };
    let expected: Vec<c64> = planted.roots.iter().copied().filter(|root| inside(&region, *root)).collect();
    tally.trials += 1;
    tally.with_eigenvalues += usize::from(!expected.is_empty());
    let modes = complex_modes(&problem, &region, &ComplexModeSettings::default()).unwrap();
    let (found, complete) = (modes.modes.len(), modes.complete());
    tally.complete += usize::from(complete);
    if !complete {
        tally.open.push(format!(
            "{seed} (n = {}): {found} of {}, {:?}",
            planted.size,
            expected.len(),
            modes.gaps
        ));
    }
    if complete && found != expected.len() {
        tally.wrong.push(format!(
            "{seed} (n = {}): {found} of {} and complete",
            planted.size,
            expected.len()
        ));
    }
    // of a complete region every planted eigenvalue has one of its own, within its error and that of the planting
    if complete && found == expected.len() {
        let mut left: Vec<c64> = expected.clone();
        for mode in &modes.modes {
            let value = mode.eigenvalue.value;
            let Some(nearest) = (0..left.len())
                .min_by(|a, b| (left[*a] - value).norm().total_cmp(&(left[*b] - value).norm()))
            else {
                break;
            };
            let distance = (left.swap_remove(nearest) - value).norm();
            if distance > mode.eigenvalue.error + 1e-9 && !mode.eigenvalue.defective {
                tally.wrong.push(format!(
                    "{seed}: {value} lies {distance:e} off, error {:e}",
                    mode.eigenvalue.error
                ));
            }
        }
    }
    let copies = |root: &c64| expected.iter().filter(|other| (*other - root).norm() < 1e-5).count();
    tally.most = tally.most.max(expected.iter().map(copies).max().unwrap_or(0));
}

fn tallied(seeds: std::ops::Range<u64>, freedoms: [usize; 2]) -> Tally {
    let mut tally = Tally::default();
    for seed in seeds {
        trial(seed, freedoms, &mut tally);
    }
    tally
}

fn assert_honest(tally: &Tally) {
    assert!(tally.wrong.is_empty(), "{tally:#?}");
    assert!(tally.trials - tally.complete <= tally.trials / 100, "{tally:#?}");
    assert!(tally.most >= MOST_COPIES && 2 * tally.with_eigenvalues > tally.trials, "{tally:#?}");
}

const SMALL: [usize; 2] = [2, 40];
/// Too many to be solved whole: these are searched for.
const LARGE: [usize; 2] = [205, 240];

/// No region is told complete that is not, and all but one in a hundred are.
#[test]
fn planted_multiplicities_are_found_whole() {
    assert_honest(&tallied(0..60, SMALL));
}

#[test]
#[ignore = "the first of two thousand problems, in four parts"]
fn two_thousand_planted_problems_are_found_whole_1() {
    assert_honest(&tallied(0..500, SMALL));
}

#[test]
#[ignore = "the second part of two thousand problems"]
fn two_thousand_planted_problems_are_found_whole_2() {
    assert_honest(&tallied(500..1000, SMALL));
}

#[test]
#[ignore = "the third part of two thousand problems"]
fn two_thousand_planted_problems_are_found_whole_3() {
    assert_honest(&tallied(1000..1500, SMALL));
}

#[test]
#[ignore = "the last part of two thousand problems"]
fn two_thousand_planted_problems_are_found_whole_4() {
    assert_honest(&tallied(1500..2000, SMALL));
}

/// What is not solved whole may be told incomplete, and is never told complete where it is not.
#[test]
#[ignore = "large problems"]
fn a_search_is_as_honest_about_planted_multiplicities() {
    let tally = tallied(0..10, LARGE);
    assert!(tally.wrong.is_empty() && tally.complete > 0, "{tally:#?}");
}
