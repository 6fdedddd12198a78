//! All eigenvalues of a coupled pair up to a frequency, at one position, with the proof that none is missing.
//!
//! The zeros of D are found together (O. Aberth, *Iteration methods for finding all zeros of a polynomial simultaneously*, Math. Comp.
//! 27, 1973), from the places between the poles. Then the zeros that are known and the poles are
//! divided out of D: what is left must not turn around zero along the border of the region, or a zero is missing.

mod count;
mod simultaneous;

use crate::SlidingError;
use crate::characteristic::{PRECISION, PairCharacteristic};
use crate::tracking::reach;
use judder_numerics::complex::ElementaryComplex;
use judder_numerics::order::{sort_by_number, sort_by_numbers, sort_numbers};
use num_complex::Complex64;
use simultaneous::{EigenIterate, Regular};
use std::f64::consts::TAU;

/// Which eigenvalues are wanted; of a conjugate pair only the upper one is listed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum WantedEigenvalues {
    /// So many of the lowest by the larger of imaginary and absolute real part; a few more are given as well.
    Lowest(usize),
    /// All with an imaginary part from zero up to this, rad/s.
    Below(f64),
}

/// Eigenvalues s of one position, 1/s.
#[derive(Debug, Clone, PartialEq)]
pub struct Spectrum {
    /// All with 0 ≤ Im s ≤ `limit` and |Re s| ≤ `limit`, by imaginary, then real part; real ones have Im s = 0.
    pub eigenvalues: Vec<Complex64>,
    /// How far each may be from the exact one, 1/s: a growth rate below it is neither stable nor unstable.
    pub errors: Vec<f64>,
    /// Up to where the list is complete, rad/s.
    pub limit: f64,
}

/// Zeros beyond those wanted that are sought as well: among them the border is laid.
pub(crate) const GUARD: usize = 3;
/// Eigenvalues beyond those counted that are known as well where branches are followed.
const BEYOND: usize = 2;
/// An imaginary part so small, as a share of the limit, is none.
const REAL: f64 = 1e-10;
/// Two eigenvalues of a conservative pair so near, as a share of their size, are mirror images.
const MIRROR: f64 = 1e-6;
/// How often missing zeros are sought from other places.
const ATTEMPTS: usize = 4;

impl Spectrum {
    /// The spectrum of a characteristic function; `position` in m is for the message.
    ///
    /// # Errors
    /// [`SlidingError::Incomplete`] where the count along the border does not agree with what was found;
    /// [`SlidingError::InvalidNumber`] for a limit that is not positive, or more eigenvalues than there are.
    pub fn new(
        function: &PairCharacteristic,
        position: f64,
        wanted: WantedEigenvalues,
    ) -> Result<Self, SlidingError> {
        // what is wanted of all modes is refused before some are left out
        last_pole(&pole_heights(function), wanted)?;
        match function.without_uncoupled() {
            None => Self::of_coupled(function, position, wanted),
            Some((coupled, free)) => Self::with_uncoupled(&coupled, free, position, wanted),
        }
    }

    /// The `count` lowest, and so many more that a branch among them is not at the border of what is known.
    ///
    /// # Errors
    /// As of [`Spectrum::new`].
    pub fn with_more(
        function: &PairCharacteristic,
        position: f64,
        count: usize,
    ) -> Result<Self, SlidingError> {
        last_pole(&pole_heights(function), WantedEigenvalues::Lowest(count))?;
        Self::new(function, position, WantedEigenvalues::Lowest((count + BEYOND).min(function.modes() - 1)))
    }

    /// The `count` lowest by the larger of imaginary and absolute real part, with how far each may be off, in their order.
    #[must_use]
    pub fn lowest(&self, count: usize) -> (Vec<Complex64>, Vec<f64>) {
        let mut ranks: Vec<usize> = (0..self.eigenvalues.len()).collect();
        sort_by_number(&mut ranks, |own| reach(self.eigenvalues[*own]));
        ranks.truncate(count);
        ranks.sort_unstable();
        ranks.into_iter().map(|rank| (self.eigenvalues[rank], self.errors[rank])).unzip()
    }

    /// The spectrum of a function beside which some eigenvalues are known.
    fn with_uncoupled(
        coupled: &PairCharacteristic,
        mut known: Vec<Complex64>,
        position: f64,
        wanted: WantedEigenvalues,
    ) -> Result<Self, SlidingError> {
        let most = coupled.modes().saturating_sub(1);
        let of_coupled = match wanted {
            _ if most == 0 => None,
            WantedEigenvalues::Lowest(count) => {
                Some(Self::of_coupled(coupled, position, WantedEigenvalues::Lowest(count.min(most)))?)
            }
            WantedEigenvalues::Below(_) => Some(Self::of_coupled(coupled, position, wanted)?),
        };
        let highest = known.iter().map(|s| s.modulus()).fold(0.0, f64::max);
        let below = |limit: f64| known.iter().filter(|s| s.im <= limit && s.re.abs() <= limit).count();
        let whole = highest.max(of_coupled.as_ref().map_or(0.0, |own| own.limit));
        let limit = match (wanted, &of_coupled) {
            (WantedEigenvalues::Below(limit), _) => limit,
            (WantedEigenvalues::Lowest(count), Some(own))
                if count <= own.eigenvalues.len() + below(own.limit) =>
            {
                own.limit
            }
            // all that there are
            (WantedEigenvalues::Lowest(_), _) => 1.5 * whole,
        };
        let mut errors: Vec<f64> = known.iter().map(|s| PRECISION * s.modulus()).collect();
        if let Some(own) = of_coupled {
            known.extend(own.eigenvalues);
            errors.extend(own.errors);
        }
        let mut both: Vec<(Complex64, f64)> = known.into_iter().zip(errors).collect();
        both.retain(|(s, _)| s.im <= limit && s.re.abs() <= limit);
        sort_by_numbers(&mut both, |(own, _)| [own.im, own.re]);
        let (eigenvalues, errors) = both.into_iter().unzip();
        Ok(Self { eigenvalues, errors, limit })
    }

    /// The spectrum of modes that are all coupled.
    fn of_coupled(
        function: &PairCharacteristic,
        position: f64,
        wanted: WantedEigenvalues,
    ) -> Result<Self, SlidingError> {
        let heights = pole_heights(function);
        let last = last_pole(&heights, wanted)?;
        let scale = match wanted {
            WantedEigenvalues::Below(limit) => heights[last].max(limit),
            WantedEigenvalues::Lowest(_) => heights[last],
        };
        let mut regular = Regular::new(function, scale);
        let mut zeros = starts(&heights[..=last], scale, 0);
        let mut failure = None;
        for attempt in 1..=ATTEMPTS {
            simultaneous::iterate(&mut regular, &mut zeros);
            zeros.retain(|zero| zero.is_done);
            settle(function, &mut zeros, scale);
            let limit = border(&zeros, wanted, scale);
            let known: Vec<Complex64> = zeros.iter().map(|zero| zero.value).collect();
            let inside = known.iter().filter(|s| s.im <= limit && s.re.abs() <= limit).count();
            let enough = !matches!(wanted, WantedEigenvalues::Lowest(count) if inside < count);
            match count::missing(&mut regular, &known, limit) {
                Some(0) if enough => return Ok(Self::below(function, known, limit, wanted)),
                Some(missing) if missing < 0 => zeros.clear(),
                missing => failure = Some((inside, missing.unwrap_or(0), limit)),
            }
            zeros.extend(starts(&heights[..=last], scale, attempt));
        }
        let (found, missing, limit) = failure.unwrap_or((0, 0, scale));
        // the count is that of both halves of the plane
        let expected = found + (missing.max(1) as usize).div_ceil(2);
        Err(SlidingError::Incomplete { position, found, expected, limit_hz: limit / TAU })
    }

    /// Those known in the region, of which no more than wanted where a limit is.
    fn below(
        function: &PairCharacteristic,
        mut known: Vec<Complex64>,
        border: f64,
        wanted: WantedEigenvalues,
    ) -> Self {
        let mut evaluator = function.evaluator();
        let limit = match wanted {
            WantedEigenvalues::Below(limit) => limit,
            WantedEigenvalues::Lowest(_) => border,
        };
        known.retain(|s| s.im <= limit && s.re.abs() <= limit);
        let errors = (0..known.len()).map(|k| moved(evaluator.error(known[k]), nearest(&known, k))).collect();
        Self { eigenvalues: known, errors, limit }
    }
}

/// Eigenvalues near `guesses`, so close that they may be told apart from all others; `None` where the iteration leaves them.
pub(crate) fn polished<const COUNT: usize>(
    function: &PairCharacteristic,
    guesses: [Complex64; COUNT],
) -> Option<[Complex64; COUNT]> {
    let scale = guesses.iter().map(|guess| guess.modulus()).fold(0.0, f64::max);
    let mut zeros = guesses.map(EigenIterate::new);
    simultaneous::iterate(&mut Regular::new(function, scale), &mut zeros);
    settle(function, &mut zeros, scale);
    zeros.iter().all(|zero| zero.is_done).then(|| zeros.map(|zero| zero.value))
}

/// How far an eigenvalue is from the nearest other one.
fn nearest(values: &[Complex64], own: usize) -> f64 {
    let away = |k: usize| (values[k] - values[own]).modulus();
    (0..values.len()).filter(|k| *k != own).map(away).fold(f64::INFINITY, f64::min)
}

/// How far an eigenvalue moves that a first order moves by δ, beside another at a distance g: two that meet part as ±√(g²/4 ± δ g).
fn moved(first_order: f64, gap: f64) -> f64 {
    let product = first_order * gap;
    if first_order <= 0.25 * gap || product.is_nan() { first_order } else { 2.0 * product.sqrt() }
}

/// Imaginary parts of the upper poles, ascending.
fn pole_heights(function: &PairCharacteristic) -> Vec<f64> {
    let mut heights: Vec<f64> = (0..function.modes()).map(|mode| function.poles(mode)[0].im).collect();
    sort_numbers(&mut heights);
    heights
}

/// The pole up to which zeros are sought between poles.
fn last_pole(heights: &[f64], wanted: WantedEigenvalues) -> Result<usize, SlidingError> {
    let highest = heights.len() - 1;
    let refuse = |name: &str, value: f64, requirement| {
        Err(SlidingError::InvalidNumber { name: name.to_owned(), value, requirement })
    };
    match wanted {
        WantedEigenvalues::Lowest(count) if count == 0 || count > highest => refuse(
            "the count of eigenvalues",
            count as f64,
            "at least one and less than the modes of the pair",
        ),
        WantedEigenvalues::Lowest(count) => Ok((count + GUARD).min(highest)),
        WantedEigenvalues::Below(limit) if !(limit.is_finite() && limit > 0.0) => {
            refuse("the limit of the eigenvalues", limit, "finite and above zero")
        }
        WantedEigenvalues::Below(limit) => {
            Ok((heights.partition_point(|height| *height <= limit) + GUARD).min(highest))
        }
    }
}

/// Places between the poles, beside the imaginary axis, farther from it with every attempt.
fn starts(heights: &[f64], scale: f64, attempt: usize) -> Vec<EigenIterate> {
    let mean = scale / heights.len() as f64;
    let between = heights.windows(2).enumerate().map(|(k, pair)| {
        let gap = (pair[1] - pair[0]).max(0.01 * mean);
        let side = if k % 2 == 0 { 1.0 } else { -1.0 };
        let (along, across) = match attempt {
            0 => (0.5, 0.05),
            _ => (0.15 + 0.17 * attempt as f64, 0.3 * (attempt * attempt) as f64),
        };
        EigenIterate::new(Complex64::new(side * across * gap, pair[0] + along * gap))
    });
    between.collect()
}

/// Real zeros are made real, mirror images exact where the pair is conservative; then all are sorted.
fn settle(function: &PairCharacteristic, zeros: &mut [EigenIterate], scale: f64) {
    for zero in zeros.iter_mut().filter(|zero| zero.value.im.abs() <= REAL * scale) {
        zero.value.im = 0.0;
    }
    if function.is_conservative() {
        mirror(zeros);
    }
    sort_by_numbers(zeros, |own| [own.value.im, own.value.re]);
}

/// Of a conservative pair s and −s̄ are eigenvalues together: those off the imaginary axis are paired, the others put on it.
fn mirror(zeros: &mut [EigenIterate]) {
    let nearest = |zeros: &[EigenIterate], image: Complex64| {
        let distance = |k: &usize| (zeros[*k].value - image).norm_sqr();
        (0..zeros.len()).min_by(|a, b| distance(a).total_cmp(&distance(b)))
    };
    for k in 0..zeros.len() {
        let value = zeros[k].value;
        if value.re == 0.0 || value.im == 0.0 {
            continue;
        }
        match nearest(zeros, -value.conj()) {
            Some(other)
                if other != k
                    && (zeros[other].value + value.conj()).modulus() <= MIRROR * value.modulus() =>
            {
                let mean = 0.5 * (value - zeros[other].value.conj());
                (zeros[k].value, zeros[other].value) = (mean, -mean.conj());
            }
            Some(same) if same == k && value.re.abs() <= MIRROR * value.modulus() => zeros[k].value.re = 0.0,
            _ => {}
        }
    }
}

/// Where the region ends: in the widest gap between the zeros above those wanted, by how large a region each wants.
///
/// By the imaginary part alone a large real zero, as friction near sprag-slip has, would count among the lowest and yet lie outside.
fn border(zeros: &[EigenIterate], wanted: WantedEigenvalues, scale: f64) -> f64 {
    let mut reaches: Vec<f64> = zeros.iter().map(|zero| reach(zero.value)).collect();
    sort_numbers(&mut reaches);
    let (first, at_least) = match wanted {
        WantedEigenvalues::Lowest(count) => (count, 0.0),
        WantedEigenvalues::Below(limit) => (reaches.partition_point(|reach| *reach <= limit), limit),
    };
    if first >= reaches.len() {
        return 1.5 * scale.max(zeros.iter().map(|zero| zero.value.modulus()).fold(0.0, f64::max));
    }
    let below = |k: usize| if k == 0 { at_least } else { reaches[k - 1].max(at_least) };
    let gap = |k: &usize| reaches[*k] - below(*k);
    let last = (first + GUARD).min(reaches.len());
    let widest = (first..last).max_by(|a, b| gap(a).total_cmp(&gap(b))).unwrap_or(first);
    0.5 * (below(widest) + reaches[widest])
}
