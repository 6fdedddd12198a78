//! A few values of a locus against eigenproblems with full matrices.

use super::traced::Traced;
use crate::sliding::locus::settings::LocusAnalysis;
use judder_numerics::complex::ElementaryComplex;
use judder_numerics::parallel;
use judder_sliding::SlidingError;
use judder_sliding::characteristic::PairCharacteristic;
use judder_sliding::coupling::Coupling;
use judder_sliding::dense_forms::ThreeField;
use judder_sliding::spectrum::{Spectrum, WantedEigenvalues};
use judder_study::outcome::{CheckRecord, Disagreement};
use num_complex::Complex64;

/// The coupling of the pair at a value, λ and d of its modes.
type CouplingAt<'a> = &'a (dyn Fn(f64) -> Result<(Coupling, Vec<f64>, Vec<f64>), SlidingError> + Sync);

/// Where full matrices are shifted to, 1/s: off the imaginary axis.
const SHIFT: f64 = 2e4;
/// What spectra may differ by, relative.
const LIMIT: f64 = 1e-6;
/// An imaginary part so small, as a share of the limit of a spectrum, is none.
const REAL: f64 = 1e-7;

/// The checks of a locus: at a fifth and four fifths of its values and where it grows fastest.
pub(super) fn doubted(
    contact: CouplingAt<'_>,
    traced: &Traced,
    settings: &LocusAnalysis,
    values: &[f64],
) -> Result<Vec<CheckRecord>, SlidingError> {
    let there: Vec<f64> =
        values.iter().zip(&traced.rows).filter(|(_, row)| row.failure.is_none()).map(|(v, _)| *v).collect();
    let fastest = traced.zones.iter().max_by(|a, b| a.growth_rate.total_cmp(&b.growth_rate));
    let chosen = [1, 4].map(|fifths| there.get(fifths * there.len() / 5).copied());
    let chosen: Vec<f64> = chosen.into_iter().flatten().chain(fastest.map(|zone| zone.peak)).collect();
    let compared = parallel::try_each(&chosen, |value| ComparedValue::new(contact, settings, *value))?;
    let all = |pick: &dyn Fn(&ComparedValue) -> Vec<f64>| -> Disagreement {
        compared.iter().flat_map(pick).collect()
    };
    let at = format!("at {} values, one of them where growth is fastest", chosen.len());
    Ok(vec![
        CheckRecord::new(
            "the spectrum is that of the primal form",
            format!("largest relative distance of eigenvalues of full matrices, {at}"),
            all(&|c| c.primal.clone()),
            LIMIT,
        ),
        CheckRecord::new(
            "the spectrum is that of the dual form",
            format!("largest relative distance of eigenvalues of full matrices, {at}"),
            all(&|c| c.dual.clone()),
            LIMIT,
        ),
        CheckRecord::new(
            "no eigenvalue is missing",
            format!("eigenvalues found against those of full matrices up to the same frequency, {at}"),
            all(&|c| vec![c.missing as f64]),
            0.0,
        ),
    ])
}

/// One value.
struct ComparedValue {
    /// Distances of the eigenvalues from those of this form.
    primal: Vec<f64>,
    dual: Vec<f64>,
    missing: usize,
}

impl ComparedValue {
    fn new(contact: CouplingAt<'_>, settings: &LocusAnalysis, value: f64) -> Result<Self, SlidingError> {
        let (coupling, eigenvalues, damping) = contact(value)?;
        let damping = if settings.damping { damping } else { vec![0.0; eigenvalues.len()] };
        let function = PairCharacteristic::new(&coupling, &eigenvalues, &damping)?;
        let Spectrum { eigenvalues: found, limit, .. } =
            Spectrum::new(&function, value, WantedEigenvalues::Lowest(settings.count))?;
        let fields = ThreeField::new(&coupling, &eigenvalues, &damping)?;
        let [primal, dual] = [fields.primal_spectrum(SHIFT)?, fields.dual_spectrum(SHIFT)?];
        let inside = |s: &&Complex64| s.im >= -REAL * limit && s.im <= limit && s.re.abs() <= limit;
        let count = primal.iter().filter(inside).count();
        Ok(Self {
            primal: distances(&found, primal),
            dual: distances(&found, dual),
            missing: count.abs_diff(found.len()),
        })
    }
}

/// How far eigenvalues are from the nearest of others that no other one has taken, relative to their size.
fn distances(found: &[Complex64], mut others: Vec<Complex64>) -> Vec<f64> {
    let distance = |value: &Complex64| {
        let nearest = |k: &usize| (others[*k] - value).modulus();
        let nearest = (0..others.len()).min_by(|a, b| nearest(a).total_cmp(&nearest(b)));
        nearest.map_or(f64::INFINITY, |k| match (others.swap_remove(k) - value).modulus() {
            // a rigid motion has no size of its own
            0.0 => 0.0,
            distance => distance / value.modulus(),
        })
    };
    found.iter().map(distance).collect()
}
