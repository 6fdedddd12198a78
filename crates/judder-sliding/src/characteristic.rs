//! The characteristic function of two structures in modal form: its zeros are the eigenvalues of the coupled pair.
//!
//! With q_i = (e_i N + Σ b_ki y_k) / p_i(s), p_i(s) = s² + d_i s + λ_i, the closed gap c q = 0 and the feedbacks y_k = r_k q (or s r_k q)
//! leave 1 + m homogeneous equations in N and y. Their determinant D(s) is the function. It has poles at the roots of the p_i, and each
//! value costs O(n), where a dense eigenproblem costs O(n³).

mod accuracy;
mod uncoupled;

use crate::SlidingError;
use crate::coupling::Coupling;
pub(crate) use accuracy::PRECISION;
use num_complex::Complex64;
use pulp::{Arch, Simd, WithSimd};

/// Numbers that are treated side by side; sums run in this many lanes on every machine, so that they end in the same bits.
const LANES: usize = 8;

/// p at the pole of a rigid motion, 1/s²: smaller than any that counts, and its square is still a number.
const NONE: f64 = 1e-100;

/// D(s) of one place of contact.
#[derive(Debug, Clone, PartialEq)]
pub struct PairCharacteristic {
    /// 1 + m.
    order: usize,
    modes: usize,
    /// ω_i = √λ_i, filled up to whole lanes.
    frequencies: Vec<f64>,
    /// d_i, filled up likewise.
    damping: Vec<f64>,
    /// row_a,i · column_b,i, one list for each (a, b), row by row, filled up with zeros.
    products: Vec<Vec<f64>>,
    /// Of each row, whether it follows velocities.
    follows_velocity: Vec<bool>,
}

/// A function's value and its derivative by s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Valued {
    /// D.
    pub value: Complex64,
    /// dD/ds.
    pub slope: Complex64,
}

/// D with the room that its evaluation needs: no evaluation allocates.
#[derive(Debug, Clone)]
pub struct CharacteristicEvaluator<'a> {
    function: &'a PairCharacteristic,
    arch: Arch,
    inverses: Inverses,
    matrix: Vec<Complex64>,
    slopes: Vec<Complex64>,
    replaced: Vec<Complex64>,
}

/// 1/p_i and d(1/p_i)/ds by real and imaginary parts.
#[derive(Debug, Clone)]
struct Inverses {
    value: [Vec<f64>; 2],
    slope: [Vec<f64>; 2],
}

impl PairCharacteristic {
    /// That of a coupling, of λ_i in 1/s² and d_i in 1/s of all modes.
    ///
    /// # Errors
    /// [`SlidingError::Length`] for lists that differ in length, [`SlidingError::InvalidNumber`] for numbers that are not finite, a λ
    /// or a d below zero.
    pub fn new(coupling: &Coupling, eigenvalues: &[f64], damping: &[f64]) -> Result<Self, SlidingError> {
        let modes = eigenvalues.len();
        check_sizes(coupling, eigenvalues, damping)?;
        let feedback = &coupling.feedback;
        let rows: Vec<_> =
            std::iter::once(&coupling.compatibility).chain(feedback.iter().map(|f| &f.row)).collect();
        let columns: Vec<_> =
            std::iter::once(&coupling.equilibrium).chain(feedback.iter().map(|f| &f.column)).collect();
        let padded = modes.next_multiple_of(LANES);
        let filled = |list: &mut dyn Iterator<Item = f64>, value: f64| {
            let mut list: Vec<f64> = list.collect();
            list.resize(padded, value);
            list
        };
        let mut products = Vec::with_capacity(rows.len() * rows.len());
        for row in &rows {
            for column in &columns {
                products.push(filled(&mut row.iter().zip(*column).map(|(r, c)| r * c), 0.0));
            }
        }
        Ok(Self {
            order: rows.len(),
            modes,
            frequencies: filled(&mut eigenvalues.iter().map(|value| value.sqrt()), 1.0),
            damping: filled(&mut damping.iter().copied(), 0.0),
            products,
            follows_velocity: std::iter::once(false)
                .chain(feedback.iter().map(|f| f.follows_velocity))
                .collect(),
        })
    }

    /// How many modes the two structures have together.
    #[must_use]
    pub fn modes(&self) -> usize {
        self.modes
    }

    /// Whether nothing damps or feeds the motion: D is then even in s, and eigenvalues come as s and −s.
    #[must_use]
    pub fn is_conservative(&self) -> bool {
        self.damping.iter().all(|d| *d == 0.0) && !self.follows_velocity.contains(&true)
    }

    /// p_i(s) and dp_i/ds of a mode.
    #[inline]
    #[must_use]
    pub fn mode_polynomial(&self, mode: usize, s: Complex64) -> Valued {
        let (frequency, damping) = (self.frequencies[mode], self.damping[mode]);
        let [re, im] = polynomial(s, frequency, damping);
        Valued { value: Complex64::new(re, im), slope: 2.0 * s + damping }
    }

    /// The roots of p_i, the one of larger imaginary part first, then the one of larger real part: the poles of D.
    #[must_use]
    pub fn poles(&self, mode: usize) -> [Complex64; 2] {
        let (frequency, half) = (self.frequencies[mode], 0.5 * self.damping[mode]);
        let discriminant = (frequency - half) * (frequency + half);
        if discriminant >= 0.0 {
            let height = discriminant.sqrt();
            return [Complex64::new(-half, height), Complex64::new(-half, -height)];
        }
        // the smaller root by the product of both, which does not cancel
        let fast = half + (-discriminant).sqrt();
        [Complex64::new(-frequency * (frequency / fast), 0.0), Complex64::new(-fast, 0.0)]
    }

    /// D, ready to be evaluated.
    #[must_use]
    pub fn evaluator(&self) -> CharacteristicEvaluator<'_> {
        let list = || vec![0.0; self.frequencies.len()];
        let square = vec![Complex64::ZERO; self.order * self.order];
        CharacteristicEvaluator {
            function: self,
            arch: Arch::new(),
            inverses: Inverses { value: [list(), list()], slope: [list(), list()] },
            matrix: square.clone(),
            slopes: square.clone(),
            replaced: square,
        }
    }
}

impl CharacteristicEvaluator<'_> {
    /// Of which function.
    #[must_use]
    pub fn function(&self) -> &PairCharacteristic {
        self.function
    }

    /// D and dD/ds at s; on a pole the value a rounding beside it.
    pub fn at(&mut self, s: Complex64) -> Valued {
        let PairCharacteristic { order, products, follows_velocity, .. } = self.function;
        self.arch.dispatch(Invert { s, function: self.function, inverses: &mut self.inverses });
        for (k, products) in products.iter().enumerate() {
            let [re, im, slope_re, slope_im] =
                self.arch.dispatch(Sums { products, inverses: &self.inverses });
            let (value, slope) = (Complex64::new(re, im), Complex64::new(slope_re, slope_im));
            let (row, column) = (k / order, k % order);
            let unit = if row > 0 && row == column { 1.0 } else { 0.0 };
            (self.matrix[k], self.slopes[k]) = if follows_velocity[row] {
                (s * value - unit, value + s * slope)
            } else {
                (value - unit, slope)
            };
        }
        if *order == 1 {
            return Valued { value: self.matrix[0], slope: self.slopes[0] };
        }
        let mut slope = Complex64::ZERO;
        for column in 0..*order {
            self.replaced.copy_from_slice(&self.matrix);
            for row in 0..*order {
                self.replaced[row * order + column] = self.slopes[row * order + column];
            }
            slope += determinant(&mut self.replaced, *order);
        }
        self.replaced.copy_from_slice(&self.matrix);
        Valued { value: determinant(&mut self.replaced, *order), slope }
    }
}

/// p = s² + d s + ω² by parts: written so that it keeps its digits next to its root.
#[inline(always)]
fn polynomial(s: Complex64, frequency: f64, damping: f64) -> [f64; 2] {
    let re = (frequency - s.im) * (frequency + s.im) + s.re * (s.re + damping);
    [re, s.im * (2.0 * s.re + damping)]
}

/// Fills the inverses of all modes at s.
struct Invert<'a> {
    s: Complex64,
    function: &'a PairCharacteristic,
    inverses: &'a mut Inverses,
}

impl WithSimd for Invert<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        let Self { s, function, inverses } = self;
        let Inverses { value: [value_re, value_im], slope: [slope_re, slope_im] } = inverses;
        let modes = function.frequencies.iter().zip(&function.damping);
        let values = value_re.iter_mut().zip(value_im.iter_mut());
        let slopes = slope_re.iter_mut().zip(slope_im.iter_mut());
        for (((frequency, damping), (value_re, value_im)), (slope_re, slope_im)) in
            modes.zip(values).zip(slopes)
        {
            let [re, im] = polynomial(s, *frequency, *damping);
            // a rounding of λ away from a pole that is met exactly
            let away = f64::EPSILON * frequency * frequency + NONE;
            let re = if re == 0.0 && im == 0.0 { away } else { re };
            let size = 1.0 / (re * re + im * im);
            let (inverse_re, inverse_im) = (re * size, -im * size);
            let (square_re, square_im) =
                (inverse_re * inverse_re - inverse_im * inverse_im, 2.0 * inverse_re * inverse_im);
            let (by_re, by_im) = (-(2.0 * s.re + damping), -2.0 * s.im);
            (*value_re, *value_im) = (inverse_re, inverse_im);
            *slope_re = by_re * square_re - by_im * square_im;
            *slope_im = by_re * square_im + by_im * square_re;
        }
    }
}

/// Σ product_i / p_i and its derivative, by parts.
struct Sums<'a> {
    products: &'a [f64],
    inverses: &'a Inverses,
}

impl WithSimd for Sums<'_> {
    type Output = [f64; 4];

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) -> [f64; 4] {
        let Inverses { value: [value_re, value_im], slope: [slope_re, slope_im] } = self.inverses;
        let (products, _) = self.products.as_chunks::<LANES>();
        let (value_re, _) = value_re.as_chunks::<LANES>();
        let (value_im, _) = value_im.as_chunks::<LANES>();
        let (slope_re, _) = slope_re.as_chunks::<LANES>();
        let (slope_im, _) = slope_im.as_chunks::<LANES>();
        let mut lanes = [[0.0; LANES]; 4];
        let values = value_re.iter().zip(value_im);
        for ((product, values), slopes) in products.iter().zip(values).zip(slope_re.iter().zip(slope_im)) {
            for lane in 0..LANES {
                lanes[0][lane] += product[lane] * values.0[lane];
                lanes[1][lane] += product[lane] * values.1[lane];
                lanes[2][lane] += product[lane] * slopes.0[lane];
                lanes[3][lane] += product[lane] * slopes.1[lane];
            }
        }
        lanes.map(|lanes| lanes.iter().sum())
    }
}

/// By elimination with pivots; the matrix is used up.
fn determinant(matrix: &mut [Complex64], order: usize) -> Complex64 {
    let mut product = Complex64::ONE;
    for column in 0..order {
        let size = |row: &usize| matrix[row * order + column].norm_sqr();
        let Some(pivot) = (column..order).max_by(|a, b| size(a).total_cmp(&size(b))) else { break };
        if matrix[pivot * order + column] == Complex64::ZERO {
            return Complex64::ZERO;
        }
        if pivot != column {
            (0..order).for_each(|k| matrix.swap(pivot * order + k, column * order + k));
            product = -product;
        }
        let diagonal = matrix[column * order + column];
        product *= diagonal;
        for row in column + 1..order {
            let factor = matrix[row * order + column] / diagonal;
            for k in column + 1..order {
                let above = matrix[column * order + k];
                matrix[row * order + k] -= factor * above;
            }
        }
    }
    product
}

pub(crate) fn check_sizes(
    coupling: &Coupling,
    eigenvalues: &[f64],
    damping: &[f64],
) -> Result<(), SlidingError> {
    let own = [
        ("the equilibrium column", &coupling.equilibrium[..]),
        ("the compatibility row", &coupling.compatibility[..]),
    ];
    let feedback = coupling.feedback.iter().flat_map(|term| {
        [("the row of a feedback", &term.row[..]), ("the column of a feedback", &term.column[..])]
    });
    for (name, list) in own.into_iter().chain(feedback).chain([("the damping of the modes", damping)]) {
        if list.len() != eigenvalues.len() {
            let name = name.to_owned();
            return Err(SlidingError::Length { name, found: list.len(), expected: eigenvalues.len() });
        }
        crate::body::finite(list.iter(), name)?;
    }
    let lists = [("ω² of a mode", eigenvalues), ("the damping of a mode", damping)];
    for (name, value) in lists.iter().flat_map(|(name, list)| list.iter().map(move |value| (name, *value))) {
        if !(value.is_finite() && value >= 0.0) {
            let requirement = "finite and not negative";
            return Err(SlidingError::InvalidNumber { name: (*name).to_owned(), value, requirement });
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::coupling::Feedback;
    use judder_numerics::counter::uniform;

    fn random(order: usize, modes: usize) -> PairCharacteristic {
        let list = |seed: u64| (0..modes).map(|k| uniform(seed, k as u64) - 0.5).collect::<Vec<_>>();
        let feedback = (1..order).map(|k| Feedback {
            row: list(2 * k as u64 + 2),
            column: list(2 * k as u64 + 3),
            follows_velocity: k == 1,
        });
        let coupling =
            Coupling { compatibility: list(0), equilibrium: list(1), feedback: feedback.collect() };
        let eigenvalues: Vec<f64> = (0..modes).map(|k| (k * k) as f64).collect();
        let damping: Vec<f64> = (0..modes).map(|k| 0.01 * uniform(99, k as u64)).collect();
        PairCharacteristic::new(&coupling, &eigenvalues, &damping).unwrap()
    }

    /// The determinant of the definition, summed in the plainest way for one feedback; the slope is that of a central difference.
    #[test]
    fn value_and_slope_are_those_of_the_definition() {
        for order in 1..=4 {
            let function = random(order, 13);
            let mut evaluator = function.evaluator();
            let s = Complex64::new(0.3, 2.4);
            let found = evaluator.at(s);
            let entry = |k: usize| -> Complex64 {
                (0..13).map(|i| function.products[k][i] / function.mode_polynomial(i, s).value).sum()
            };
            let expected = match order {
                1 => entry(0),
                2 => entry(0) * (s * entry(3) - 1.0) - entry(1) * s * entry(2),
                _ => found.value,
            };
            assert!((found.value - expected).norm() < 1e-13, "{order}");
            for step in [Complex64::new(1e-5, 0.0), Complex64::new(0.0, 1e-5)] {
                let slope = (evaluator.at(s + step).value - evaluator.at(s - step).value) / (2.0 * step);
                assert!((slope - found.slope).norm() < 1e-7 * found.slope.norm(), "{order}: {slope}");
            }
        }
    }

    /// Not a bit of value and slope depends on the width of the vectors.
    #[test]
    fn no_bit_depends_on_the_width_of_the_vectors() {
        let function = random(4, 43);
        let by = |arch: Arch| {
            CharacteristicEvaluator { arch, ..function.evaluator() }.at(Complex64::new(0.3, 2.4))
        };
        let scalar = by(Arch::Scalar);
        assert!(crate::vectors::widths().into_iter().all(|arch| by(arch) == scalar));
    }

    /// The roots of p are where p vanishes, also of a mode that is overdamped or rigid.
    #[test]
    fn poles_are_the_roots_of_the_modes() {
        let coupling =
            Coupling { compatibility: vec![1.0; 3], equilibrium: vec![1.0; 3], feedback: Vec::new() };
        let function = PairCharacteristic::new(&coupling, &[0.0, 4.0, 1e-6], &[0.5, 1e-3, 10.0]).unwrap();
        for mode in 0..3 {
            for pole in function.poles(mode) {
                assert!(function.mode_polynomial(mode, pole).value.norm() < 1e-14, "{mode}: {pole}");
            }
        }
        assert_eq!(function.poles(0)[0], Complex64::ZERO);
        assert!(function.evaluator().at(function.poles(1)[0]).value.is_finite());
    }

    #[test]
    fn lists_that_do_not_fit_are_refused() {
        let coupling =
            Coupling { compatibility: vec![1.0; 2], equilibrium: vec![1.0; 2], feedback: Vec::new() };
        assert!(PairCharacteristic::new(&coupling, &[1.0], &[0.0]).is_err());
        assert!(PairCharacteristic::new(&coupling, &[1.0, -1.0], &[0.0, 0.0]).is_err());
        assert!(PairCharacteristic::new(&coupling, &[1.0, f64::NAN], &[0.0, 0.0]).is_err());
    }
}
