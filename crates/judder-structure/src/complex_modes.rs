//! Complex modes: all eigenvalues of (λ² M + λ C + K) x = 0 in a region of the complex plane, each with its error.
//!
//! A small problem is solved whole, and determinants around the region prove that nothing is missing. A large one is covered by discs
//! around shifts. Around each shift the problem is inverted and searched by block Arnoldi, once for right vectors and once, from a start
//! of its own, for left vectors, each from more random vectors than any crowd of eigenvalues has members; discs overlap. What one search
//! lacks of another is a [`Gap`]. Every eigenvalue is then refined on the full problem, and its error follows from its residuals and both
//! vectors.
//!
//! F. Tisseur and K. Meerbergen, *The quadratic eigenvalue problem*, SIAM Review 43 (2001).

mod accuracy;
mod cover;
mod determinant;
mod disc;
mod everywhere;
mod krylov;
mod linearised;
mod matching;
mod refine;
mod shift;
pub(crate) mod vectors;
mod whole;

pub use crate::quadratic::Region;
pub use cover::Gap;
pub use everywhere::all_complex_modes;
pub use judder_numerics::verdict::Verdict;
pub use shift::likely_bytes_of_shift;

use disc::SAME;
pub(crate) use disc::Triple;
use judder_numerics::complex::ElementaryComplex;
pub(crate) use refine::RefinedEigenvalue;
pub(crate) use shift::{ShiftedFactor, shifts_at_once};

use crate::StructureError;
use crate::quadratic::Quadratic;
use accuracy::Accuracy;
pub(crate) use accuracy::left_by_residuals;
use cover::{Cover, cover};
use faer::c64;
use judder_memory::{HeldMemory, MemoryBudget};
use judder_numerics::order::sort_by_numbers;
use judder_numerics::parallel;
use refine::Neighbourhood;
use whole::whole;

/// What the matrices are worth, and what a search may take.
#[derive(Debug, Clone)]
pub struct ComplexModeSettings {
    /// ε: how well the entries of the matrices are known, relative to their norms. 10⁻¹² by default: assembled matrices carry more
    /// rounding than their number format.
    pub data_precision: f64,
    /// What all searches with these settings may hold together: their factors, and the vectors they are made with. No limit by default.
    pub memory: HeldMemory,
}

impl Default for ComplexModeSettings {
    fn default() -> Self {
        Self { data_precision: 1e-12, memory: HeldMemory::of(MemoryBudget::unlimited()) }
    }
}

/// The complex modes of a region.
#[derive(Debug, Clone, PartialEq)]
pub struct ComplexModes {
    /// By rising imaginary part.
    pub modes: Vec<ComplexMode>,
    /// Why there may be more; empty where the check closed.
    pub gaps: Vec<Gap>,
    /// The middles of the discs, in 1/s.
    pub shifts: Vec<c64>,
}

/// A complex mode; a motion x e^(λt).
#[derive(Debug, Clone, PartialEq)]
pub struct ComplexMode {
    /// λ.
    pub eigenvalue: Eigenvalue,
    /// x with Q(λ) x = 0, of length one, its largest entry real and positive.
    pub right: Vec<c64>,
    /// y with yᴴ Q(λ) = 0, of length one.
    pub left: Vec<c64>,
}

/// An eigenvalue and how well it is known.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Eigenvalue {
    /// λ = growth rate + i ω, in 1/s.
    pub value: c64,
    /// ‖Q(λ) x‖/(|λ|² ‖M‖ + |λ| ‖C‖ + ‖K‖), the normalised backward error of the right vector.
    pub residual: f64,
    /// That of the left vector.
    pub left_residual: f64,
    /// (|λ|² ‖M‖ + |λ| ‖C‖ + ‖K‖)/(|λ| |yᴴ Q′(λ) x|): how much more λ changes than the matrices, both relatively (F. Tisseur, 2000).
    pub condition: f64,
    /// How far the true eigenvalue may be, in 1/s, to first order in residual and precision of the matrices.
    pub error: f64,
    /// Whether it cannot be told from a defective one: another eigenvalue with the same vector lies within its error.
    pub defective: bool,
}

impl ComplexModes {
    /// Whether every check closed: nothing is missing.
    #[must_use]
    pub fn complete(&self) -> bool {
        self.gaps.is_empty()
    }
}

impl Eigenvalue {
    /// Stable, marginal or unstable: marginal where the sign of the growth rate is not known, which is below its own error.
    #[must_use]
    pub fn verdict(&self) -> Verdict {
        if self.value.re > self.error {
            Verdict::Unstable
        } else if self.value.re < -self.error {
            Verdict::Stable
        } else {
            // so too where the error is not a number
            Verdict::Marginal
        }
    }

    /// ζ = −Re λ/|λ|.
    #[must_use]
    pub fn damping_ratio(&self) -> f64 {
        -self.value.re / self.value.modulus()
    }

    /// Im λ/2π in Hz; zero where Im λ is no more than its error, as of a mode that grows or decays without oscillating.
    #[must_use]
    pub fn frequency_hz(&self) -> f64 {
        if self.value.im.abs() <= self.error { 0.0 } else { self.value.im / std::f64::consts::TAU }
    }
}

/// All complex modes of a region.
///
/// # Errors
/// [`StructureError::EmptyRegion`], [`StructureError::SingularEverywhere`] where λ²M + λC + K has no inverse at all,
/// [`StructureError::BeyondMemory`], [`StructureError::OutOfMemory`]. Modes that may be missing are no error but a [`Gap`].
pub fn complex_modes(
    problem: &Quadratic,
    region: &Region,
    settings: &ComplexModeSettings,
) -> Result<ComplexModes, StructureError> {
    let searched = searched(problem, region, &settings.memory)?;
    let left_open: Vec<f64> =
        searched.refined.iter().map(|refined| left_by_residuals(problem, refined)).collect();
    let modes = finished(problem, &searched.refined, &left_open, region, settings);
    let shifts = searched.factors.iter().map(ShiftedFactor::shift).collect();
    Ok(ComplexModes { modes, gaps: searched.gaps, shifts })
}

/// What a search of a region leaves: more than its modes, for those who go on from them.
pub(crate) struct SearchedRegion {
    /// Those of the region, and those beside it that came along.
    pub(crate) refined: Vec<RefinedEigenvalue>,
    pub(crate) factors: Vec<ShiftedFactor>,
    pub(crate) gaps: Vec<Gap>,
}

/// Every eigenvalue of a region, refined, with the factors at the shifts.
pub(crate) fn searched(
    problem: &Quadratic,
    region: &Region,
    memory: &HeldMemory,
) -> Result<SearchedRegion, StructureError> {
    region.check()?;
    if problem.size() <= whole::LARGEST {
        return whole(problem, region, memory);
    }
    let cover = cover(problem, region, memory)?;
    let refined = refined(problem, &cover, &region.widened(REFINED))?;
    let mut gaps = cover.gaps;
    for ((disc, place), refined) in cover.members.iter().zip(&refined) {
        let (from, to) = (cover.discs[*disc].triples[*place].value, refined.triple.value);
        let moved = (to - from).modulus();
        // of those beside the region that came along none is looked for
        let concerns = [from, to].iter().any(|value| region.contains(*value, moved));
        if concerns && moved > SAME * cover.discs[*disc].reach {
            gaps.push(Gap::Strayed { from, to });
        }
    }
    let factors = cover.discs.into_iter().map(|disc| disc.factor).collect();
    Ok(SearchedRegion { refined, factors, gaps })
}

/// Eigenvalues that lie outside of a region by no more than this share of its sides are refined with those inside.
const REFINED: f64 = 0.01;

/// Every eigenvalue of a cover, in a region refined with the factors of its disc; those beside it, which came along, as they were found.
fn refined(
    problem: &Quadratic,
    cover: &Cover,
    region: &Region,
) -> Result<Vec<RefinedEigenvalue>, StructureError> {
    let neighbourhoods: Vec<Neighbourhood<'_>> =
        cover.discs.iter().map(|disc| Neighbourhood::new(problem, &disc.factor, &disc.triples)).collect();
    parallel::try_each(&cover.members, |(disc, place)| {
        let triple = &cover.discs[*disc].triples[*place];
        // no less than rounding may move it
        match region.contains(triple.value, SAME * region.radius()) {
            true => neighbourhoods[*disc].refined_to_rounding(*place),
            false => Ok(RefinedEigenvalue::measured(problem, triple.clone())),
        }
    })
}

/// The modes in a region, or so near to it that rounding cannot tell, by rising imaginary part, with what each is known to; the method leaves open so much of each, times d.
pub(crate) fn finished(
    problem: &Quadratic,
    refined: &[RefinedEigenvalue],
    left_open: &[f64],
    region: &Region,
    settings: &ComplexModeSettings,
) -> Vec<ComplexMode> {
    // beside a defective eigenvalue the first order says too much
    let widest = SAME * region.radius();
    let is_near = |k: &usize| region.contains(refined[*k].triple.value, widest);
    let near: Vec<usize> = (0..refined.len()).filter(is_near).collect();
    let known = near.iter().zip(Accuracy::among(problem, refined, &near));
    let inside = known.filter(|(k, known)| {
        let value = refined[**k].triple.value;
        // what rounding does is looked at where it decides
        region.contains(value, 0.0) || region.contains(value, known.rounding(left_open[**k]).min(widest))
    });
    let mut modes: Vec<ComplexMode> = inside
        .map(|(k, known)| mode(&refined[*k].triple, known.eigenvalue(left_open[*k], settings)))
        .collect();
    sort_by_numbers(&mut modes, |own| [own.eigenvalue.value.im, own.eigenvalue.value.re]);
    modes
}

/// A mode whose right vector's largest entry is real.
fn mode(triple: &Triple, eigenvalue: Eigenvalue) -> ComplexMode {
    let largest =
        triple.right.iter().fold(c64::new(0.0, 0.0), |a, b| if b.modulus() > a.modulus() { *b } else { a });
    let turn = largest.conj() / largest.modulus();
    ComplexMode {
        eigenvalue,
        right: triple.right.iter().map(|x| x * turn).collect(),
        left: triple.left.iter().map(c64::conj).collect(),
    }
}
