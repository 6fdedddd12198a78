//! A continuous creep spectrum 𝒞(τ), and how few retardation times stand for it.

use super::checks::decades;
use super::creep::{CreepSpectrum, CreepTerm};
use super::error::{MaterialError, positive};
use judder_numerics::complex::ElementaryComplex;
use judder_numerics::decade::power_of_ten;
use judder_numerics::order::sort_by_number;
use judder_numerics::quadrature::gauss_legendre;
use nalgebra::{DMatrix, DVector, SymmetricEigen};
use std::f64::consts::LN_10;

/// Largest number of terms of a discretisation.
pub const MOST_TERMS: usize = 200;
/// Gauss points of every panel of the fine rule.
const PANEL_POINTS: usize = 8;
/// Panels in every decade, or between edges nearer than that, to begin with.
const PANELS: f64 = 2.0;
/// Panels are halved until there are this many for one.
const MOST_HALVED: usize = 32;
/// Change of E(ω) between two rules, relative, at which the finer one is taken for exact.
const QUADRATURE_TOLERANCE: f64 = 1e-11;
/// Widths of a log-normal spectrum that are kept on either side: what is left out is 1e-15 of it.
const WIDTHS: f64 = 8.0;

/// 1/E(ω) = 1/E∞ + ∫ 𝒞(τ)/(1 + iωτ) dτ, the oscillator paper's (30), with 𝒞 ≥ 0 on a bounded range of τ.
///
/// The integral over ln τ is held as a Gauss rule on panels, fine enough that finer panels change nothing.
#[derive(Debug, Clone, PartialEq)]
pub struct ContinuousSpectrum {
    fine: CreepSpectrum,
    quadrature_error: f64,
}

/// A few retardation times for a continuous spectrum, with the error that this makes.
#[derive(Debug, Clone, PartialEq)]
pub struct Discretisation {
    /// The Prony series, of the same E∞ and E0.
    pub spectrum: CreepSpectrum,
    /// max |E_n(ω) − E(ω)|/|E(ω)| over all ω at which the material is not elastic, at sixteen a decade.
    pub error: f64,
    /// The ω [rad/s] of this maximum.
    pub worst_at: f64,
}

impl ContinuousSpectrum {
    /// E∞ \[Pa\] and 𝒞(τ) [1/(Pa s)] on `from` ≤ τ ≤ `to` \[s\].
    ///
    /// # Errors
    /// [`MaterialError::NotPositive`] for E∞ or a time, [`MaterialError::Range`], [`MaterialError::Density`] where 𝒞 is negative or
    /// not finite, or if it is zero everywhere.
    pub fn from_density(
        glassy_modulus: f64,
        from: f64,
        to: f64,
        density: impl Fn(f64) -> f64,
    ) -> Result<Self, MaterialError> {
        // ∫ 𝒞 dτ = ∫ τ 𝒞 d ln τ
        Self::refined(glassy_modulus, &[from, to], None, |time| time * density(time))
    }

    /// E∞ \[Pa\] and samples (τ \[s\], 𝒞 [1/(Pa s)]), ascending in τ; between them τ𝒞 is linear in ln τ.
    ///
    /// # Errors
    /// As [`ContinuousSpectrum::from_density`], and [`MaterialError::Samples`] for fewer than two samples.
    pub fn sampled(glassy_modulus: f64, samples: &[(f64, f64)]) -> Result<Self, MaterialError> {
        let times: Vec<f64> = samples.iter().map(|sample| sample.0).collect();
        let value = |time: f64| {
            let after = samples.partition_point(|sample| sample.0 < time).clamp(1, samples.len() - 1);
            let [(t0, c0), (t1, c1)] = [samples[after - 1], samples[after]];
            let share = libm::log(time / t0) / libm::log(t1 / t0);
            (1.0 - share) * t0 * c0 + share * t1 * c1
        };
        Self::refined(glassy_modulus, &times, None, value)
    }

    /// Between E0 and E∞ \[Pa\], 𝒞 ∝ τ^{m−1} on `from` ≤ τ ≤ `to` \[s\]: the compliance grows as τ^m; m = 0 is the box, even in ln τ.
    ///
    /// # Errors
    /// As [`ContinuousSpectrum::from_density`], and [`MaterialError::RubberyNotBelowGlassy`].
    pub fn power_law(
        rubbery: f64,
        glassy: f64,
        from: f64,
        to: f64,
        exponent: f64,
    ) -> Result<Self, MaterialError> {
        // over the geometric mean, so that the power stays a number
        let middle = from.sqrt() * to.sqrt();
        Self::between(rubbery, glassy, &[from, to], |time| libm::pow(time / middle, exponent))
    }

    /// Between E0 and E∞ \[Pa\], τ𝒞 a Gaussian in log10 τ about `median` \[s\] with a standard deviation of `width` decades.
    ///
    /// # Errors
    /// As [`ContinuousSpectrum::power_law`].
    pub fn log_normal(rubbery: f64, glassy: f64, median: f64, width: f64) -> Result<Self, MaterialError> {
        positive("the width of the spectrum in decades", width)?;
        let reach = power_of_ten(WIDTHS * width);
        let gaussian = |time: f64| libm::exp(-0.5 * (libm::log10(time / median) / width).powi(2));
        Self::between(rubbery, glassy, &[median / reach, median, median * reach], gaussian)
    }

    /// A shape of τ𝒞 scaled so that the compliance reaches 1/E0.
    fn between(
        rubbery: f64,
        glassy: f64,
        edges: &[f64],
        shape: impl Fn(f64) -> f64,
    ) -> Result<Self, MaterialError> {
        let total = CreepSpectrum::single(rubbery, glassy, 1.0)?.terms()[0].compliance;
        Self::refined(glassy, edges, Some(total), shape)
    }

    /// Halves the panels between the edges until E(ω) no longer changes.
    fn refined(
        glassy_modulus: f64,
        edges: &[f64],
        total: Option<f64>,
        shape: impl Fn(f64) -> f64,
    ) -> Result<Self, MaterialError> {
        positive("the glassy modulus E∞ [Pa]", glassy_modulus)?;
        edges
            .iter()
            .try_for_each(|time| positive("a retardation time of the spectrum [s]", *time).map(drop))?;
        if edges.len() < 2 {
            return Err(MaterialError::Samples { samples: edges.len() });
        }
        if let Some(pair) = edges.windows(2).find(|pair| pair[1] <= pair[0]) {
            return Err(MaterialError::Range { before: pair[0], after: pair[1] });
        }
        let rule = |parts| fine_rule(glassy_modulus, edges, parts, total, &shape);
        let mut parts = 1;
        let mut known = rule(parts)?;
        loop {
            parts *= 2;
            let fine = rule(parts)?;
            let quadrature_error = largest_difference(&known, &fine).0;
            if quadrature_error <= QUADRATURE_TOLERANCE || parts >= MOST_HALVED {
                return Ok(Self { fine, quadrature_error });
            }
            known = fine;
        }
    }

    /// The spectrum as a series of very many terms, as good as the integral.
    #[must_use]
    pub fn fine(&self) -> &CreepSpectrum {
        &self.fine
    }

    /// Largest relative change of E(ω) when the panels of the integral were halved last; large where 𝒞 jumps.
    #[must_use]
    pub fn quadrature_error(&self) -> f64 {
        self.quadrature_error
    }

    /// The continuous spectrum as `terms` retardation times, positive, with the same E0 and E∞.
    ///
    /// They are the nodes of the Gauss rule in ln τ for the density τ𝒞 τ^{−β}, β = ln(E∞/E0)/ln(τ_max/τ_min): the weight keeps
    /// the short times, which are small in compliance and all there is at high frequency.
    ///
    /// # Errors
    /// [`MaterialError::Terms`].
    pub fn discretised(&self, terms: usize) -> Result<Discretisation, MaterialError> {
        if !(1..=MOST_TERMS).contains(&terms) {
            return Err(MaterialError::Terms { terms, most: MOST_TERMS });
        }
        // a narrow spectrum is exact in fewer terms than may be asked for
        let spectrum = self.gauss_terms(terms.min(self.fine.terms().len()))?;
        let (error, worst_at) = largest_difference(&spectrum, &self.fine);
        Ok(Discretisation { spectrum, error, worst_at })
    }

    /// The retardation times that keep E(ω) within `tolerance` (relative) at every frequency, such that one less does not.
    ///
    /// # Errors
    /// [`MaterialError::NotPositive`] for the tolerance, [`MaterialError::ToleranceNotMet`] if [`MOST_TERMS`] are too few.
    pub fn discretised_within(&self, tolerance: f64) -> Result<Discretisation, MaterialError> {
        positive("the tolerance", tolerance)?;
        let (mut too_few, mut terms) = (0, 1);
        let mut found = self.discretised(terms)?;
        while found.error > tolerance {
            if terms == MOST_TERMS {
                return Err(MaterialError::ToleranceNotMet { terms, error: found.error, tolerance });
            }
            (too_few, terms) = (terms, (2 * terms).min(MOST_TERMS));
            found = self.discretised(terms)?;
        }
        while terms - too_few > 1 {
            let middle = terms.midpoint(too_few);
            let fewer = self.discretised(middle)?;
            if fewer.error <= tolerance {
                (terms, found) = (middle, fewer);
            } else {
                too_few = middle;
            }
        }
        Ok(found)
    }

    fn gauss_terms(&self, count: usize) -> Result<CreepSpectrum, MaterialError> {
        let terms = self.fine.terms();
        let logarithms = terms.iter().map(|term| libm::log(term.retardation_time));
        let positions = DVector::from_iterator(terms.len(), logarithms);
        let (first, last) = (positions[0], positions[positions.len() - 1]);
        let (middle, half) = (0.5 * (first + last), (0.5 * (last - first)).max(f64::MIN_POSITIVE));
        let unit = positions.map(|position| (position - middle) / half);
        // τ^−β is e^{−bias x}, one in the middle
        let bias = 0.5 * libm::log(self.fine.contrast());
        let masses = terms.iter().zip(unit.iter()).map(|(term, x)| term.compliance * libm::exp(-bias * x));
        let (nodes, weights) = gauss_rule(&unit, &DVector::from_iterator(terms.len(), masses), count);
        let compliances: Vec<f64> =
            nodes.iter().zip(&weights).map(|(x, weight)| weight * libm::exp(bias * x)).collect();
        // the rule gives the sum to about its own error; E0 is kept exactly
        let sum = |values: &mut dyn Iterator<Item = f64>| values.sum::<f64>();
        let scale =
            sum(&mut terms.iter().map(|term| term.compliance)) / sum(&mut compliances.iter().copied());
        let term = |(x, compliance): (&f64, &f64)| CreepTerm {
            retardation_time: libm::exp(middle + half * x),
            compliance: compliance * scale,
        };
        let terms = nodes.iter().zip(&compliances).map(term).filter(|term| term.compliance.is_normal());
        CreepSpectrum::new(self.fine.glassy_modulus(), terms.collect())
    }
}

/// The integral over τ as a sum: Gauss points on panels between neighbouring edges, each cut into `parts`.
fn fine_rule(
    glassy_modulus: f64,
    edges: &[f64],
    parts: usize,
    total: Option<f64>,
    shape: &impl Fn(f64) -> f64,
) -> Result<CreepSpectrum, MaterialError> {
    let rule = gauss_legendre::<PANEL_POINTS>();
    let mut terms = Vec::new();
    for pair in edges.windows(2) {
        let (from, width) = (libm::log(pair[0]), libm::log(pair[1]) - libm::log(pair[0]));
        let count = (width / LN_10 * PANELS).ceil().max(1.0) * parts as f64;
        for panel in 0..count as usize {
            for (node, weight) in rule {
                let time = libm::exp(from + width * (panel as f64 + node) / count);
                let value = shape(time);
                if !(value >= 0.0 && value.is_finite()) {
                    return Err(MaterialError::Density { time, value: value / time });
                }
                terms.push(CreepTerm { retardation_time: time, compliance: value * weight * width / count });
            }
        }
    }
    let sum: f64 = terms.iter().map(|term| term.compliance).sum();
    let scale = total.map_or(1.0, |total| total / sum);
    terms.iter_mut().for_each(|term| term.compliance *= scale);
    // parts that vanish, or nearly so, are no terms
    terms.retain(|term| term.compliance.is_normal());
    match terms.first() {
        Some(_) => CreepSpectrum::new(glassy_modulus, terms),
        None => Err(MaterialError::Density { time: edges[0], value: 0.0 }),
    }
}

/// max |E_a − E_b|/|E_b| over the frequencies at which `b` is not elastic, and where.
fn largest_difference(a: &CreepSpectrum, b: &CreepSpectrum) -> (f64, f64) {
    const MARGIN: f64 = 2.0;
    let time = |term: Option<&CreepTerm>| term.map_or(1.0, |term| libm::log10(term.retardation_time));
    let slowest = -time(b.terms().last()) - MARGIN;
    let fastest = -time(b.terms().first()) + libm::log10(b.contrast()) + MARGIN;
    let difference = |frequency: f64| {
        // of compliances, relative to that of a: the same number, without the inverses
        let (a, b) = (a.complex_compliance(frequency), b.complex_compliance(frequency));
        ((a - b).modulus() / a.modulus(), frequency)
    };
    decades(slowest, fastest)
        .into_iter()
        .map(difference)
        .fold((0.0, 0.0), |x, y| if y.0 > x.0 { y } else { x })
}

/// The Gauss rule of `count` points for masses at given positions: its Jacobi matrix by Lanczos, orthogonalised in full.
fn gauss_rule(positions: &DVector<f64>, masses: &DVector<f64>, count: usize) -> (Vec<f64>, Vec<f64>) {
    let total = masses.sum();
    let mut basis = vec![masses.map(|mass| (mass / total).sqrt())];
    let (mut diagonal, mut off) = (Vec::new(), Vec::new());
    for k in 0..count {
        let mut next = basis[k].component_mul(positions);
        diagonal.push(basis[k].dot(&next));
        for _ in 0..2 {
            for known in &basis {
                let overlap = known.dot(&next);
                next.axpy(-overlap, known, 1.0);
            }
        }
        let length = next.norm();
        // the masses lie on as few points as there are terms
        if k + 1 == count || length < f64::EPSILON {
            break;
        }
        off.push(length);
        basis.push(next / length);
    }
    rule_of(&diagonal, &off, total)
}

/// Nodes, ascending, and weights of the rule with a given Jacobi matrix (Golub and Welsch, Math. Comp. 23, 1969).
fn rule_of(diagonal: &[f64], off: &[f64], total: f64) -> (Vec<f64>, Vec<f64>) {
    let jacobi = DMatrix::from_fn(diagonal.len(), diagonal.len(), |row, column| match row.abs_diff(column) {
        0 => diagonal[row],
        1 => off[row.min(column)],
        _ => 0.0,
    });
    let eigen = SymmetricEigen::new(jacobi);
    let weight = |k: usize| total * eigen.eigenvectors[(0, k)].powi(2);
    let mut pairs: Vec<(f64, f64)> = (0..diagonal.len()).map(|k| (eigen.eigenvalues[k], weight(k))).collect();
    sort_by_number(&mut pairs, |own| own.0);
    pairs.into_iter().unzip()
}
