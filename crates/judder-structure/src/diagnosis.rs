//! Why a mode grows: who takes part, which matrix feeds it, what would change it.

use crate::StructureError;
use crate::affine::{Factors, Family, Term};
use crate::assembly::Sparse;
use crate::complex_modes::ComplexMode;
use crate::modes::Mode;
use crate::statics::{dot, product};
use faer::c64;

/// Which sum a matrix belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Part {
    /// M.
    Mass,
    /// C.
    Damping,
    /// K.
    Stiffness,
}

/// What one matrix of a family does to a mode.
#[derive(Debug, Clone, PartialEq)]
pub struct Influence {
    /// The sum that it belongs to.
    pub part: Part,
    /// Its name.
    pub name: String,
    /// Its factor f.
    pub factor: f64,
    /// What its work adds to the growth rate, in 1/s: work per cycle over the energy, times ω/4π. Negative where it takes energy out.
    pub growth: f64,
    /// ∂λ/∂f in 1/s per unit of the factor.
    pub sensitivity: c64,
    /// Growths of this size are rounding.
    rounding: f64,
}

/// The influences on a mode, mass before damping before stiffness.
#[derive(Debug, Clone, PartialEq)]
pub struct Diagnosis {
    /// One for each matrix; their growths sum to the growth rate.
    pub influences: Vec<Influence>,
    /// Whether the energy that work is measured by is positive; where it is not, growths still sum, but mean no work.
    pub positive_energy: bool,
}

/// How much an undamped mode takes part in a complex one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Participation {
    /// The undamped mode, in the order given.
    pub component: usize,
    /// |φᵀ M x|²/((φᵀ M φ)(xᴴ M x)): its share in the kinetic energy; the shares of all modes sum to one.
    pub share: f64,
    /// |φᵀ x|²/((φᵀ φ)(xᴴ x)), the modal assurance criterion (R. J. Allemang and D. L. Brown, 1982).
    pub assurance: f64,
}

impl Influence {
    /// The damping paradox: a damping that takes energy out of the motion, and of which more lets it grow faster (H. Ziegler, 1952).
    #[must_use]
    pub fn is_paradox(&self) -> bool {
        self.part == Part::Damping && self.growth < -self.rounding && self.factor * self.sensitivity.re > 0.0
    }
}

/// The work of every matrix on a mode and the sensitivity of the eigenvalue to it.
///
/// The motion Re(x e^(λt)) has the power balance Re(λ̄ xᴴ Q(λ) x) = 0, so the growth rate is σ = −(|λ|² Re xᴴCx + ω Im xᴴKx)/E with E =
/// |λ|² xᴴMx + Re xᴴKx for a symmetric mass: symmetric stiffness and gyroscopic matrices do no work. The sensitivity is
/// ∂λ/∂f = −yᴴ (∂Q/∂f) x/(yᴴ Q′(λ) x), infinite where the eigenvalue is defective.
///
/// # Errors
/// [`StructureError::WrongFactors`], and [`StructureError::WrongShape`] for a mode of another problem.
pub fn diagnosis(
    family: &Family,
    factors: &Factors,
    mode: &ComplexMode,
) -> Result<Diagnosis, StructureError> {
    family.check(factors)?;
    if mode.right.len() != family.size() || mode.left.len() != family.size() {
        return Err(StructureError::WrongShape {
            name: "mode's".to_owned(),
            found: (mode.right.len(), mode.left.len()),
            rows: family.size(),
        });
    }
    let value = mode.eigenvalue.value;
    let sums = [
        (Part::Mass, family.mass(), &factors.mass),
        (Part::Damping, family.damping(), &factors.damping),
        (Part::Stiffness, family.stiffness(), &factors.stiffness),
    ];
    let measured: Vec<(Part, &Term, Forms)> = sums
        .into_iter()
        .flat_map(|(part, terms, factors)| terms.iter().zip(factors).map(move |(t, f)| (part, t, *f)))
        .map(|(part, term, factor)| (part, term, Forms::of(&term.matrix, factor, mode)))
        .collect();
    // d and E sum over the terms
    let slope: c64 = measured.iter().map(|(part, _, forms)| forms.across * part.slope(value)).sum();
    let energy: f64 = measured.iter().map(|(part, _, forms)| part.energy(value, forms.within)).sum();
    let influences = measured.iter().map(|(part, term, forms)| Influence {
        part: *part,
        name: term.name.clone(),
        factor: forms.factor,
        growth: -part.power(value, forms.within) / energy,
        sensitivity: -forms.per_unit * part.weight(value) / slope,
        rounding: ROUNDING * value.norm(),
    });
    Ok(Diagnosis { influences: influences.collect(), positive_energy: energy > 0.0 })
}

/// Growths below this share of |λ| are rounding: those of matrices that do no work.
const ROUNDING: f64 = 1e-12;

/// The products of one matrix with a mode's vectors.
struct Forms {
    factor: f64,
    /// f xᴴ A x.
    within: c64,
    /// f yᴴ A x.
    across: c64,
    /// yᴴ A x.
    per_unit: c64,
}

impl Forms {
    fn of(matrix: &Sparse, factor: f64, mode: &ComplexMode) -> Self {
        let (mut within, mut across) = (c64::new(0.0, 0.0), c64::new(0.0, 0.0));
        for (column, x) in mode.right.iter().enumerate() {
            for (row, value) in matrix.row_idx_of_col(column).zip(matrix.val_of_col(column)) {
                within += mode.right[row].conj() * x * *value;
                across += mode.left[row].conj() * x * *value;
            }
        }
        Self { factor, within: within * factor, across: across * factor, per_unit: across }
    }
}

impl Part {
    /// The word in reports.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Mass => "mass",
            Self::Damping => "damping",
            Self::Stiffness => "stiffness",
        }
    }

    /// What the matrix is multiplied by in Q(λ).
    fn weight(self, value: c64) -> c64 {
        match self {
            Self::Mass => value * value,
            Self::Damping => value,
            Self::Stiffness => c64::new(1.0, 0.0),
        }
    }

    /// That in Q′(λ).
    fn slope(self, value: c64) -> c64 {
        match self {
            Self::Mass => 2.0 * value,
            Self::Damping => c64::new(1.0, 0.0),
            Self::Stiffness => c64::new(0.0, 0.0),
        }
    }

    /// Its part of E: what of Re(λ̄ xᴴ Q x) is proportional to the growth rate.
    fn energy(self, value: c64, form: c64) -> f64 {
        match self {
            Self::Mass => value.norm_sqr() * form.re,
            Self::Damping => 0.0,
            Self::Stiffness => form.re,
        }
    }

    /// What else of Re(λ̄ xᴴ Q x) it has.
    fn power(self, value: c64, form: c64) -> f64 {
        match self {
            Self::Mass => -value.norm_sqr() * value.im * form.im,
            Self::Damping => value.norm_sqr() * form.re,
            Self::Stiffness => value.im * form.im,
        }
    }
}

/// How much each of some undamped modes takes part in a complex mode, in their order.
///
/// The mass must be symmetric; shapes and mode have its length.
#[must_use]
pub fn participations(mass: &Sparse, components: &[Mode], mode: &ComplexMode) -> Vec<Participation> {
    let re: Vec<f64> = mode.right.iter().map(|x| x.re).collect();
    let im: Vec<f64> = mode.right.iter().map(|x| x.im).collect();
    let (with_re, with_im) = (product(mass, &re), product(mass, &im));
    let (kinetic, plain) = (dot(&re, &with_re) + dot(&im, &with_im), dot(&re, &re) + dot(&im, &im));
    components
        .iter()
        .enumerate()
        .map(|(component, Mode { shape, .. })| {
            let squares = |re: &[f64], im: &[f64]| dot(shape, re).powi(2) + dot(shape, im).powi(2);
            Participation {
                component,
                share: squares(&with_re, &with_im) / (dot(shape, &product(mass, shape)) * kinetic),
                assurance: squares(&re, &im) / (dot(shape, shape) * plain),
            }
        })
        .collect()
}
