//! Zeros of D found together: Newton's method where every zero is pushed off by the others.

use crate::characteristic::{CharacteristicEvaluator, PairCharacteristic, Valued};
use judder_numerics::complex::ElementaryComplex;
use num_complex::Complex64;

/// D with the poles nearby multiplied out.
pub(super) struct Regular<'a> {
    evaluator: CharacteristicEvaluator<'a>,
    /// Modes whose poles are multiplied out.
    near: Vec<usize>,
    /// About the size of what is sought, rad/s.
    pub(super) scale: f64,
}

/// A zero on its way.
#[derive(Debug, Clone, Copy)]
pub(super) struct EigenIterate {
    pub(super) value: Complex64,
    pub(super) is_done: bool,
    last_step: f64,
    /// How many steps below [`ROUNDING`] were no shorter than the one before.
    stalls: usize,
}

/// Sweeps over all zeros; from between the poles it takes about ten.
const SWEEPS: usize = 80;
/// A step so small, as a share of the zero, is followed by none that counts: the next error is its square.
const SMALL: f64 = 1e-11;
/// Below this share of the zero, steps that do not shrink, so many of them, are rounding: two zeros are one to half of the digits.
const ROUNDING: f64 = 1e-5;
const STALLS: usize = 4;
/// The longest step, as a share of the scale.
const LONGEST: f64 = 0.2;

impl EigenIterate {
    pub(super) fn new(value: Complex64) -> Self {
        Self { value, is_done: false, last_step: f64::INFINITY, stalls: 0 }
    }

    /// Takes a step; it is done where the step was small, or as small as rounding lets it be.
    fn take(&mut self, step: Complex64, scale: f64) {
        let length = step.modulus();
        let step = if length > LONGEST * scale { step * (LONGEST * scale / length) } else { step };
        self.value -= step;
        if self.value.im < 0.0 {
            self.value = self.value.conj();
        }
        let size = self.value.modulus() + 1e-3 * scale;
        if length <= ROUNDING * size && length >= 0.9 * self.last_step {
            self.stalls += 1;
        }
        self.is_done = length <= SMALL * size || self.stalls >= STALLS;
        self.last_step = length;
    }
}

impl<'a> Regular<'a> {
    /// Poles within one and a half of the scale are multiplied out.
    pub(super) fn new(function: &'a PairCharacteristic, scale: f64) -> Self {
        let is_near = |mode: &usize| function.poles(*mode).iter().any(|pole| pole.modulus() <= 1.5 * scale);
        let near = (0..function.modes()).filter(is_near).collect();
        Self { evaluator: function.evaluator(), near, scale }
    }

    /// f′/f of f = D Π p.
    fn logarithmic_slope(&mut self, s: Complex64) -> Complex64 {
        let Valued { value, slope } = self.evaluator.at(s);
        let function = self.evaluator.function();
        self.near.iter().fold(slope / value, |sum, mode| {
            let Valued { value, slope } = function.mode_polynomial(*mode, s);
            sum + slope * reciprocal(value)
        })
    }

    /// f with known zeros divided out, with its logarithmic slope; both mirror images of a zero that is not real.
    pub(super) fn divided(&mut self, s: Complex64, zeros: &[Complex64]) -> (Complex64, Complex64) {
        let Valued { mut value, slope } = self.evaluator.at(s);
        let mut logarithmic = slope / value;
        let unit = 1.0 / (self.scale * self.scale);
        let function = self.evaluator.function();
        let factors = self.near.iter().map(|mode| function.mode_polynomial(*mode, s));
        let mut divisors = zeros.iter().map(|zero| divisor(s, *zero));
        // by turns, so that neither product overflows
        for factor in factors {
            value *= factor.value * unit;
            logarithmic += factor.slope * reciprocal(factor.value);
            if let Some(divisor) = divisors.next() {
                value /= divisor.value * unit;
                logarithmic -= divisor.slope * reciprocal(divisor.value);
            }
        }
        for divisor in divisors {
            value /= divisor.value * unit;
            logarithmic -= divisor.slope * reciprocal(divisor.value);
        }
        (value, logarithmic)
    }
}

/// (s − z)(s − z̄), or s − z where z is real.
fn divisor(s: Complex64, zero: Complex64) -> Valued {
    if zero.im == 0.0 {
        return Valued { value: s - zero, slope: Complex64::ONE };
    }
    Valued { value: (s - zero) * (s - zero.conj()), slope: 2.0 * (s - zero.re) }
}

/// 1/z without the care for overflow that complex division takes.
#[inline(always)]
fn reciprocal(z: Complex64) -> Complex64 {
    z.conj() * (1.0 / z.norm_sqr())
}

/// Moves all iterates that are not done towards zeros of f, one after the other, until they stay.
pub(super) fn iterate(regular: &mut Regular<'_>, zeros: &mut [EigenIterate]) {
    let scale = regular.scale;
    part(zeros, scale);
    for _ in 0..SWEEPS {
        for k in 0..zeros.len() {
            if zeros[k].is_done {
                continue;
            }
            let s = zeros[k].value;
            let mut slope = regular.logarithmic_slope(s);
            for (_, other) in zeros.iter().enumerate().filter(|(j, _)| *j != k) {
                slope -= reciprocal(s - other.value);
                if other.value.im > 1e-9 * scale {
                    slope -= reciprocal(s - other.value.conj());
                }
            }
            let step = reciprocal(slope);
            if step.is_finite() {
                zeros[k].take(step, scale);
            } else if slope.is_finite() {
                // a saddle: no direction is down
                zeros[k].value += Complex64::new(1e-3 * scale, 1e-3 * scale);
            } else {
                zeros[k].take(Complex64::ZERO, scale);
            }
        }
        if zeros.iter().all(|zero| zero.is_done) {
            return;
        }
    }
}

/// Iterates that stand on each other are set apart: they would never part.
fn part(zeros: &mut [EigenIterate], scale: f64) {
    for k in 1..zeros.len() {
        let stands = |other: &EigenIterate| (other.value - zeros[k].value).modulus() <= 1e-9 * scale;
        if !zeros[k].is_done && zeros[..k].iter().any(stands) {
            zeros[k].value += Complex64::new(1e-6, 1e-6) * (scale * k as f64);
        }
    }
}
