//! Eigenvalues over a short piece of a parameter's range: alone, or two that may meet.
//!
//! Of two eigenvalues that meet, the mean m and d = ((s₁ − s₂)/2)² are smooth through the meeting, s = m ± √d are not.

use crate::characteristic::{PRECISION, PairCharacteristic};
use crate::spectrum::polished;
use judder_numerics::complex::ElementaryComplex;
use num_complex::Complex64;

/// Even places at which a piece is sampled.
pub(super) const SAMPLES: usize = 5;

/// A smooth function over a piece by its values at even places: a polynomial of fourth degree.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Smooth {
    values: [Complex64; SAMPLES],
    /// How far the second degree through the ends and the middle is off at the places between.
    pub(super) error: f64,
}

/// One eigenvalue, or two that may meet, over a piece.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum EigenvalueGroup {
    /// Far from all others.
    Alone(Smooth),
    /// m and d.
    Two(Smooth, Smooth),
}

/// The more or the less unstable of the eigenvalues of a group.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Sheet {
    More,
    Less,
}

/// What decides on stability: unstable where it is above zero; with the eigenvalue.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct StabilityMargin {
    pub(super) value: f64,
    /// By how much the value may be wrong.
    pub(super) doubt: f64,
    pub(super) eigenvalue: Complex64,
}

/// A real part so small, as a share of the eigenvalue, is rounding where nothing damps.
const ROUNDING: f64 = 1e-7;
/// The share of the error of the second degree that the fourth keeps: for a smooth function it is far less.
const KEPT: f64 = 0.1;
/// Two eigenvalues are sought from so far apart at least, as a share of their size.
const APART: f64 = 1e-4;
/// An error of this share of the eigenvalue is too large to tell anything.
const ROUGH: f64 = 3e-3;

impl Smooth {
    pub(super) fn new(values: [Complex64; SAMPLES]) -> Self {
        let [first, left, middle, right, last] = values;
        let errors = [
            0.375 * first + 0.75 * middle - 0.125 * last - left,
            0.375 * last + 0.75 * middle - 0.125 * first - right,
        ];
        Self { values, error: errors.iter().map(|error| error.modulus()).fold(0.0, f64::max) }
    }

    /// At a share of the piece, from 0 to 1 (Lagrange).
    fn at(&self, share: f64) -> Complex64 {
        let t = 4.0 * share;
        let [a, b, c, d, e] = [t, t - 1.0, t - 2.0, t - 3.0, t - 4.0];
        let weights = [
            b * c * d * e / 24.0,
            -a * c * d * e / 6.0,
            a * b * d * e / 4.0,
            -a * b * c * e / 6.0,
            a * b * c * d / 24.0,
        ];
        self.values.iter().zip(weights).map(|(value, weight)| value * weight).sum()
    }

    fn size(&self) -> f64 {
        self.values.iter().map(|value| value.modulus()).fold(0.0, f64::max)
    }

    fn doubt(&self) -> f64 {
        KEPT * self.error
    }
}

impl EigenvalueGroup {
    /// Of one eigenvalue at even places.
    pub(super) fn alone(values: [Complex64; SAMPLES]) -> Self {
        Self::Alone(Smooth::new(values))
    }

    /// Whether the samples foretell about what lies between them.
    pub(super) fn is_smooth(&self) -> bool {
        match self {
            Self::Alone(value) => value.error <= ROUGH * value.size(),
            Self::Two(mean, difference) => {
                mean.error <= ROUGH * mean.size() && difference.error <= ROUGH * ROUGH * mean.size().powi(2)
            }
        }
    }

    /// Of two eigenvalues at even places.
    pub(super) fn two(first: [Complex64; SAMPLES], second: [Complex64; SAMPLES]) -> Self {
        let of = |f: fn(Complex64, Complex64) -> Complex64| {
            Smooth::new(std::array::from_fn(|k| f(first[k], second[k])))
        };
        let mean = of(|a, b| 0.5 * (a + b));
        Self::Two(mean, of(|a, b| 0.25 * (a - b) * (a - b)))
    }

    /// How many eigenvalues it has, the more unstable first.
    pub(super) fn sheets(&self) -> &'static [Sheet] {
        match self {
            Self::Alone(_) => &[Sheet::More],
            Self::Two(..) => &[Sheet::More, Sheet::Less],
        }
    }

    /// As the polynomials have it, at a share of the piece.
    pub(super) fn foretold(&self, share: f64, sheet: Sheet, is_conservative: bool) -> StabilityMargin {
        match self {
            Self::Alone(value) => {
                let margin = alone(value.at(share), is_conservative);
                // where nothing damps, an eigenvalue that meets no other stays on its axis
                let doubt = if is_conservative { 0.0 } else { value.doubt() };
                StabilityMargin { doubt, ..margin }
            }
            Self::Two(mean, difference) => {
                let (m, d) = (mean.at(share), difference.at(share));
                let margin = two(m, d, sheet, is_conservative);
                let off = difference.doubt();
                let doubt = if is_conservative {
                    off
                } else {
                    mean.doubt() + off.sqrt().min(off / d.modulus().sqrt().max(f64::MIN_POSITIVE))
                };
                StabilityMargin { doubt, ..margin }
            }
        }
    }

    /// As the characteristic function there has it; `None` where its zeros are not those foretold.
    pub(super) fn found(
        &self,
        share: f64,
        sheet: Sheet,
        function: &PairCharacteristic,
    ) -> Option<StabilityMargin> {
        let is_conservative = function.is_conservative();
        match self {
            Self::Alone(value) => {
                let guess = value.at(share);
                let [found] = polished(function, [guess])?;
                is_near(found, guess).then(|| alone(found, is_conservative))
            }
            Self::Two(mean, difference) => {
                let (m, d) = (mean.at(share), difference.at(share));
                // two that start nearer to each other than they are push each other to and fro; on an axis they stay on it
                let is_apart = d.modulus() > (APART * m.modulus()).powi(2);
                let half = if is_apart { d.square_root() } else { Complex64::new(APART, APART) * m };
                let [a, b] = polished(function, [m + half, m - half])?;
                let (found, square) = (0.5 * (a + b), 0.25 * (a - b) * (a - b));
                is_near(found, m).then(|| two(found, square, sheet, is_conservative))
            }
        }
    }
}

/// Whether an eigenvalue is the one foretold.
fn is_near(found: Complex64, foretold: Complex64) -> bool {
    (found - foretold).modulus() <= 1e-3 * foretold.modulus()
}

/// What decides on the stability of one eigenvalue: a growth rate below the precision of its numbers is none.
pub(super) fn alone(value: Complex64, is_conservative: bool) -> StabilityMargin {
    let floor = if is_conservative { ROUNDING } else { PRECISION };
    StabilityMargin { value: value.re - floor * value.modulus(), doubt: 0.0, eigenvalue: value }
}

/// Where nothing damps, d itself decides: it passes through zero, while the growth rate √d starts there.
fn two(mean: Complex64, difference: Complex64, sheet: Sheet, is_conservative: bool) -> StabilityMargin {
    let half = difference.square_root();
    let more = if half.re < 0.0 { -half } else { half };
    let eigenvalue = match sheet {
        Sheet::More => mean + more,
        Sheet::Less => mean - more,
    };
    let value = match (is_conservative, sheet) {
        (false, _) => alone(eigenvalue, false).value,
        (true, Sheet::More) => difference.re - ROUNDING * ROUNDING * mean.norm_sqr(),
        (true, Sheet::Less) => -mean.norm_sqr(),
    };
    StabilityMargin { value, doubt: 0.0, eigenvalue }
}
