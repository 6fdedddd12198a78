//! A few values of a locus against eigenproblems with full matrices.

use super::traced::Traced;
use crate::outcome::CheckRecord;
use judder_case::sliding::locus::Locus;
use judder_sliding::SlidingError;
use judder_sliding::characteristic::Characteristic;
use judder_sliding::coupling::Coupling;
use judder_sliding::dense_forms::ThreeField;
use judder_sliding::spectrum::{Spectrum, Wanted};
use num_complex::Complex64;
use rayon::prelude::*;

/// The coupling of the pair at a value, λ and d of its modes.
type Contact<'a> = &'a (dyn Fn(f64) -> Result<(Coupling, Vec<f64>, Vec<f64>), SlidingError> + Sync);

/// Where full matrices are shifted to, 1/s: off the imaginary axis.
const SHIFT: f64 = 2e4;
/// What spectra may differ by, relative.
const LIMIT: f64 = 1e-6;
/// An imaginary part so small, as a share of the limit of a spectrum, is none.
const REAL: f64 = 1e-7;

/// The checks of a locus: at a fifth and four fifths of its values and where it grows fastest.
pub(super) fn doubted(
    contact: Contact<'_>,
    traced: &Traced,
    settings: &Locus,
    values: &[f64],
) -> Result<Vec<CheckRecord>, SlidingError> {
    let there: Vec<f64> =
        values.iter().zip(&traced.rows).filter(|(_, row)| row.failure.is_none()).map(|(v, _)| *v).collect();
    let fastest = traced.zones.iter().max_by(|a, b| a.growth_rate.total_cmp(&b.growth_rate));
    let chosen = [1, 4].map(|fifths| there.get(fifths * there.len() / 5).copied());
    let chosen: Vec<f64> = chosen.into_iter().flatten().chain(fastest.map(|zone| zone.peak)).collect();
    let compared: Vec<Result<Compared, SlidingError>> =
        chosen.par_iter().map(|value| Compared::new(contact, settings, *value)).collect();
    let compared = compared.into_iter().collect::<Result<Vec<Compared>, SlidingError>>()?;
    let largest = |pick: &dyn Fn(&Compared) -> f64| compared.iter().map(pick).fold(0.0, f64::max);
    let at = format!("at {} values, one of them where growth is fastest", chosen.len());
    Ok(vec![
        CheckRecord {
            name: "the spectrum is that of the primal form".to_owned(),
            compared: format!("largest relative distance of eigenvalues of full matrices, {at}"),
            figure: largest(&|c| c.primal),
            limit: LIMIT,
        },
        CheckRecord {
            name: "the spectrum is that of the dual form".to_owned(),
            compared: format!("largest relative distance of eigenvalues of full matrices, {at}"),
            figure: largest(&|c| c.dual),
            limit: LIMIT,
        },
        CheckRecord {
            name: "no eigenvalue is missing".to_owned(),
            compared: format!(
                "eigenvalues found against those of full matrices up to the same frequency, {at}"
            ),
            figure: largest(&|c| c.missing as f64),
            limit: 0.0,
        },
    ])
}

/// One value.
struct Compared {
    primal: f64,
    dual: f64,
    missing: usize,
}

impl Compared {
    fn new(contact: Contact<'_>, settings: &Locus, value: f64) -> Result<Self, SlidingError> {
        let (coupling, eigenvalues, damping) = contact(value)?;
        let damping = if settings.damping { damping } else { vec![0.0; eigenvalues.len()] };
        let function = Characteristic::new(&coupling, &eigenvalues, &damping)?;
        let Spectrum { eigenvalues: found, limit } =
            Spectrum::new(&function, value, Wanted::Lowest(settings.count))?;
        let fields = ThreeField::new(&coupling, &eigenvalues, &damping)?;
        let [primal, dual] = [fields.primal_spectrum(SHIFT)?, fields.dual_spectrum(SHIFT)?];
        let inside = |s: &&Complex64| s.im >= -REAL * limit && s.im <= limit && s.re.abs() <= limit;
        let count = primal.iter().filter(inside).count();
        Ok(Self {
            primal: distance(&found, &primal),
            dual: distance(&found, &dual),
            missing: count.abs_diff(found.len()),
        })
    }
}

/// How far eigenvalues are from the nearest of others that no other one has taken, relative to their size.
fn distance(found: &[Complex64], others: &[Complex64]) -> f64 {
    let mut left = others.to_vec();
    let mut worst = 0.0_f64;
    for value in found {
        let nearest = |k: &usize| (left[*k] - value).norm();
        match (0..left.len()).min_by(|a, b| nearest(a).total_cmp(&nearest(b))) {
            Some(k) => worst = worst.max((left.swap_remove(k) - value).norm() / value.norm()),
            None => worst = f64::INFINITY,
        }
    }
    worst
}
