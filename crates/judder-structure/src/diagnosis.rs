//! Why a mode grows: who takes part, which matrix feeds it, what would change it.

use crate::StructureError;
use crate::affine::{AffineFamily, Factors, Term};
use crate::assembly::Sparse;
use crate::complex_modes::ComplexMode;
use crate::modes::Mode;
use crate::statics::{dot, product};
use faer::c64;
use judder_numerics::complex::ElementaryComplex;

/// Which sum a matrix belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MatrixSum {
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
    pub part: MatrixSum,
    /// Its name.
    pub name: String,
    /// Its factor f.
    pub factor: f64,
    /// What its work adds to the growth rate, in 1/s: work per cycle over the energy, times ω/4π. Negative where it takes energy out;
    /// `None` where the mode has no energy to divide by.
    pub growth: Option<f64>,
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
    /// The energy that work is measured by.
    pub energy: Energy,
    /// |Re(λ̄ xᴴ Q(λ) x)|, what the powers of all matrices leave of σ E, over |λ| times the magnitudes of the parts of E: zero but for
    /// rounding and the error of the mode, whatever E is.
    pub balance: f64,
}

/// The energy E of a mode, by which the work of matrices becomes a growth rate.
///
/// What grows where nothing does work has none: σ E is the power of all matrices. So it is of every eigenvalue off the imaginary axis
/// where the mass and the stiffness are symmetric and the damping is skew (divergence, flutter of gyroscopic systems: their Krein
/// signature is zero), and of every real eigenvalue without damping, whatever the stiffness.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Energy {
    /// E over the magnitudes of the parts that mass and stiffness have in it, from −1 to 1.
    pub share: f64,
    /// How far the share may be off: rounding, the error of the mode, and what the balance of power leaves open.
    pub error: f64,
}

/// What an energy says of the growths that are divided by it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EnergySign {
    /// Growths are work over energy.
    Positive,
    /// Growths sum to the growth rate, but what takes energy out of the motion lets it grow.
    Negative,
    /// No more than its own error: there is nothing to divide by.
    None,
}

impl Energy {
    /// Below so many times its error it is none: a growth would not have one digit.
    const KNOWN: f64 = 10.0;

    /// Whether it is positive, negative, or none.
    #[must_use]
    pub fn sign(self) -> EnergySign {
        // an error that is no number leaves nothing known
        let is_known = self.share.abs() > Self::KNOWN * self.error;
        match (is_known, self.share > 0.0) {
            (false, _) => EnergySign::None,
            (true, true) => EnergySign::Positive,
            (true, false) => EnergySign::Negative,
        }
    }

    /// The relative error that it gives to all growths; `None` where it is none.
    #[must_use]
    pub fn growth_error(self) -> Option<f64> {
        (self.sign() != EnergySign::None).then(|| self.error / self.share.abs())
    }
}

impl EnergySign {
    /// The word in summaries.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Positive => "positive",
            Self::Negative => "negative",
            Self::None => "none",
        }
    }
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
        let takes = self.growth.is_some_and(|growth| growth < -self.rounding);
        self.part == MatrixSum::Damping && takes && self.factor * self.sensitivity.re > 0.0
    }
}

/// The work of every matrix on a mode and the sensitivity of the eigenvalue to it.
///
/// The motion Re(x e^(λt)) has the power balance Re(λ̄ xᴴ Q(λ) x) = 0, so the growth rate is σ = −(|λ|² Re xᴴCx + ω Im xᴴKx)/E with E =
/// |λ|² xᴴMx + Re xᴴKx for a symmetric mass: symmetric stiffness and gyroscopic matrices do no work. Where E is zero, see [`Energy`],
/// no matrix has a growth. The sensitivity is
/// ∂λ/∂f = −yᴴ (∂Q/∂f) x/(yᴴ Q′(λ) x), infinite where the eigenvalue is defective.
///
/// # Errors
/// [`StructureError::WrongFactors`], and [`StructureError::WrongShape`] for a mode of another problem.
pub fn diagnosis(
    family: &AffineFamily,
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
        (MatrixSum::Mass, family.mass(), &factors.mass),
        (MatrixSum::Damping, family.damping(), &factors.damping),
        (MatrixSum::Stiffness, family.stiffness(), &factors.stiffness),
    ];
    let measured: Vec<(MatrixSum, &Term, Forms)> = sums
        .into_iter()
        .flat_map(|(part, terms, factors)| terms.iter().zip(factors).map(move |(t, f)| (part, t, *f)))
        .map(|(part, term, factor)| (part, term, Forms::of(&term.matrix, factor, mode)))
        .collect();
    // d and E sum over the terms
    let slope: c64 = measured.iter().map(|(part, _, forms)| forms.across * part.slope(value)).sum();
    let balance = Balance::of(&measured, mode);
    let energy = balance.energy();
    let is_none = energy.sign() == EnergySign::None;
    let influences = measured.iter().map(|(part, term, forms)| Influence {
        part: *part,
        name: term.name.clone(),
        factor: forms.factor,
        growth: (!is_none).then(|| -part.power(value, forms.within) / balance.energy),
        sensitivity: -forms.per_unit * part.weight(value) / slope,
        rounding: ROUNDING * value.modulus(),
    });
    Ok(Diagnosis { influences: influences.collect(), energy, balance: balance.left() })
}

/// The balance of power of a mode, σ E + P = 0, with what is needed to say how well E is known.
struct Balance {
    /// |λ|.
    size: f64,
    growth_rate: f64,
    /// E.
    energy: f64,
    /// The magnitudes of its parts.
    gross: f64,
    /// P, of all matrices.
    power: f64,
    /// How far E may be off by rounding and by the error of the mode.
    doubt: f64,
}

impl Balance {
    fn of(measured: &[(MatrixSum, &Term, Forms)], mode: &ComplexMode) -> Self {
        let value = mode.eigenvalue.value;
        let size = value.modulus();
        let of_each = |pick: fn(MatrixSum, c64, c64) -> f64| {
            measured.iter().map(move |(part, _, forms)| pick(*part, value, forms.within))
        };
        let gross: f64 = of_each(MatrixSum::energy).map(f64::abs).sum();
        let rounding: f64 = measured
            .iter()
            .map(|(part, _, forms)| f64::EPSILON * part.energy(value, c64::new(forms.size, 0.0)))
            .sum();
        // a vector is about as far off as its eigenvalue, and stands twice in E
        let of_mode = 2.0 * mode.eigenvalue.error / size * gross;
        Self {
            size,
            growth_rate: value.re,
            energy: of_each(MatrixSum::energy).sum(),
            gross,
            power: of_each(MatrixSum::power).sum(),
            doubt: rounding + of_mode,
        }
    }

    /// Re(λ̄ xᴴ Q x) over the magnitudes of its parts.
    fn left(&self) -> f64 {
        (self.power + self.growth_rate * self.energy).abs() / (self.size * self.gross)
    }

    fn energy(&self) -> Energy {
        let open = self.size / self.growth_rate.abs() * self.left();
        Energy { share: self.energy / self.gross, error: self.doubt / self.gross + open }
    }
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
    /// |f| |x|ᵀ |A| |x|.
    size: f64,
}

impl Forms {
    fn of(matrix: &Sparse, factor: f64, mode: &ComplexMode) -> Self {
        let (mut within, mut across, mut size) = (c64::new(0.0, 0.0), c64::new(0.0, 0.0), 0.0);
        for (column, x) in mode.right.iter().enumerate() {
            for (row, value) in matrix.row_idx_of_col(column).zip(matrix.val_of_col(column)) {
                within += mode.right[row].conj() * x * *value;
                across += mode.left[row].conj() * x * *value;
                size += mode.right[row].modulus() * x.modulus() * value.abs();
            }
        }
        let size = size * factor.abs();
        Self { factor, within: within * factor, across: across * factor, per_unit: across, size }
    }
}

impl MatrixSum {
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
/// The mass must be symmetric; shapes and mode have its length. None takes part in a mode without kinetic energy, one that moves freedoms
/// without mass alone.
#[must_use]
pub fn participations(mass: &Sparse, components: &[Mode], mode: &ComplexMode) -> Vec<Participation> {
    let re: Vec<f64> = mode.right.iter().map(|x| x.re).collect();
    let im: Vec<f64> = mode.right.iter().map(|x| x.im).collect();
    let (with_re, with_im) = (product(mass, &re), product(mass, &im));
    let (kinetic, plain) = (dot(&re, &with_re) + dot(&im, &with_im), dot(&re, &re) + dot(&im, &im));
    let largest = mass.val().iter().fold(0.0_f64, |largest, entry| largest.max(entry.abs()));
    if kinetic <= ROUNDING * largest * plain {
        return Vec::new();
    }
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
