//! Eigenvalues and unstable zones of a family of pairs, with what could not be.

use super::kept_values::KeptValues;
use super::rest_state::RestState;
use crate::error::ModelError;
use judder_numerics::parallel;
use judder_numerics::words::plain;
use judder_sliding::SlidingError;
use judder_sliding::characteristic::PairCharacteristic;
use judder_sliding::locus::{Followed, follow};
use judder_sliding::spectrum::{Spectrum, WantedEigenvalues};
use judder_sliding::zones::{PairFamily, Zone, ZoneEnd};
use judder_study::Progress;
use judder_study::axis::SweptAxis;
use judder_study::kept::KeptLines;
use num_complex::Complex64;
use std::sync::atomic::{AtomicBool, Ordering};

/// A pair for each value of a parameter.
pub(super) trait TracedFamily: Sync {
    /// Its characteristic function.
    fn at(&self, value: f64) -> Result<PairCharacteristic, SlidingError>;
    /// Its state of rest.
    fn state(&self, value: f64) -> Result<RestState, SlidingError>;
    /// Why there is none at a value, in words; `None` where there is one.
    fn reason(&self, value: f64) -> Option<String>;
}

/// A smooth piece after the other from one value to another.
type Pieces<'a> = &'a (dyn Fn([f64; 2]) -> Result<Vec<[f64; 2]>, SlidingError> + Sync);

/// Where a family is traced.
pub(super) struct TracedRange<'a> {
    /// Ascending.
    pub(super) values: &'a [f64],
    /// The pieces between two of them on which the family is smooth.
    pub(super) pieces: Pieces<'a>,
    /// How narrow a zone may be.
    pub(super) resolution: f64,
}

/// What a family has at one value.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct FamilyRow {
    /// One a branch; NaN where it is not among the lowest.
    pub(super) eigenvalues: Vec<Complex64>,
    /// How far each may be off, 1/s.
    pub(super) errors: Vec<f64>,
    pub(super) state: RestState,
    /// Why there is nothing.
    pub(super) failure: Option<String>,
}

/// All of them.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Traced {
    pub(super) rows: Vec<FamilyRow>,
    /// By where they start.
    pub(super) zones: Vec<Zone>,
    /// Ranges in which branches are not followed and zones not located, and why.
    pub(super) untraced: Vec<([f64; 2], String)>,
}

/// What stands where a branch has no eigenvalue.
const NONE: Complex64 = Complex64::new(f64::NAN, f64::NAN);
/// Failures that are told one by one.
const SHOWN: usize = 3;

impl Traced {
    /// How many results are missing: values without eigenvalues, ranges without zones.
    pub(super) fn missing(&self) -> usize {
        self.rows.iter().filter(|row| row.failure.is_some()).count() + self.untraced.len()
    }

    /// What the user has to know.
    pub(super) fn warnings(&self, axis: &SweptAxis) -> Vec<String> {
        let failed = || {
            let rows = axis.values.iter().zip(&self.rows);
            rows.filter_map(|(value, row)| Some((value, row.failure.as_ref()?)))
        };
        let unit = if axis.quantity.unit == "1" { "" } else { &axis.quantity.unit };
        let shown = |value: f64| match &axis.shown {
            Some(_) => axis.text(value),
            None => format!("{} {unit}", plain(value)).trim_end().to_owned(),
        };
        let told = |(value, reason): (&f64, &String)| {
            format!("nothing at {} = {}: {reason}", axis.name(), shown(*value))
        };
        let mut warnings: Vec<String> = failed().take(SHOWN).map(told).collect();
        let more = failed().count().saturating_sub(SHOWN);
        if more > 0 {
            warnings.push(format!("nothing at {more} more values"));
        }
        warnings.extend(self.untraced.iter().map(|([from, to], reason)| {
            let (from, to) = (shown(*from), shown(*to));
            format!("from {from} to {to} branches are not followed and zones not located: {reason}")
        }));
        warnings.extend(self.torn(axis).map(|(zone, side)| {
            let (at, end) = ([zone.from, zone.to][side], ["starts before", "goes on beyond"][side]);
            let reason = match zone.ends[side] {
                ZoneEnd::Lost => "its eigenvalue could not be followed any farther",
                _ => "at the next value there is nothing",
            };
            format!("the unstable zone at {:.1} Hz {end} {}: {reason}", zone.frequency_hz, shown(at))
        }));
        warnings
    }

    /// Starts (0) and ends (1) of zones that are none: where a branch was lost, or the range ends at a value beside one that failed.
    fn torn(&self, axis: &SweptAxis) -> impl Iterator<Item = (&Zone, usize)> {
        let values = || axis.values.iter().copied();
        let whole = [values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max)];
        let is_torn = move |zone: &Zone, side: usize| match zone.ends[side] {
            ZoneEnd::Lost => true,
            ZoneEnd::Range => [zone.from, zone.to][side] != whole[side],
            ZoneEnd::Root | ZoneEnd::Jump | ZoneEnd::Meeting => false,
        };
        let sides = |zone| [(zone, 0), (zone, 1)];
        self.zones.iter().flat_map(sides).filter(move |(zone, side)| is_torn(zone, *side))
    }
}

/// Traces a family; where a value fails, what lies on both sides of it is traced all the same.
///
/// # Errors
/// [`ModelError::Interrupted`]; the failure of all values, where none succeeds.
pub(super) fn trace(
    family: &impl TracedFamily,
    range: &TracedRange<'_>,
    count: usize,
    (kept, progress): (KeptLines<'_>, &dyn Progress),
) -> Result<Traced, ModelError> {
    let kept = KeptValues::new(kept);
    let state = |value: &f64| {
        if progress.interrupted() { None } else { kept.state(*value, &|| family.state(*value)).ok() }
    };
    let states: Vec<Option<RestState>> = parallel::each(range.values, state);
    let mut rows: Vec<FamilyRow> = states
        .into_iter()
        .map(|state| FamilyRow {
            eigenvalues: Vec::new(),
            errors: Vec::new(),
            state: state.unwrap_or(RestState { normal_force: f64::NAN, slope: f64::NAN }),
            failure: None,
        })
        .collect();
    let mut traced = Traced { rows: Vec::new(), zones: Vec::new(), untraced: Vec::new() };
    let search = LocusSearch { family, range, count, kept: &kept, progress };
    let whole = search.followed(0, range.values.len(), true);
    stop(progress)?;
    match whole {
        Ok(found) => {
            traced.zones = found.zones.clone();
            place(&mut rows, 0, found);
        }
        Err(error) => search.piecewise(&mut rows, &mut traced, error)?,
    }
    let branches = rows.iter().map(|row| row.eigenvalues.len()).max().unwrap_or(0);
    for row in &mut rows {
        row.eigenvalues.resize(branches, NONE);
        row.errors.resize(branches, f64::NAN);
    }
    traced.rows = rows;
    Ok(traced)
}

/// An error without the place that it names, which is the value of the swept key.
fn told(error: &SlidingError) -> String {
    match error {
        SlidingError::Incomplete { found, expected, limit_hz, .. } => {
            format!("{found} of {expected} eigenvalues were found up to {} Hz", plain(*limit_hz))
        }
        _ => error.to_string(),
    }
}

fn stop(progress: &dyn Progress) -> Result<(), ModelError> {
    if progress.interrupted() { Err(ModelError::Interrupted) } else { Ok(()) }
}

/// Gives rows the branches found for them, beside the `begun` ones that are other rows'; how many there then are.
fn place(rows: &mut [FamilyRow], begun: usize, found: Followed) -> usize {
    let mut width = begun;
    for (row, (values, errors)) in rows.iter_mut().zip(found.eigenvalues.into_iter().zip(found.errors)) {
        row.eigenvalues.resize(begun, NONE);
        row.errors.resize(begun, f64::NAN);
        row.eigenvalues.extend(values);
        row.errors.extend(errors);
        width = row.eigenvalues.len();
    }
    width
}

/// The lowest eigenvalues of one value.
fn alone(spectrum: &Spectrum, count: usize) -> Followed {
    let (eigenvalues, errors) = spectrum.lowest(count);
    Followed { eigenvalues: vec![eigenvalues], errors: vec![errors], zones: Vec::new() }
}

/// How a family is traced.
struct LocusSearch<'a, F> {
    family: &'a F,
    range: &'a TracedRange<'a>,
    count: usize,
    kept: &'a KeptValues<'a>,
    progress: &'a dyn Progress,
}

/// A family as it is followed over some values: what is kept of it is known, and the user may stop.
struct FollowedFamily<'a, F> {
    search: &'a LocusSearch<'a, F>,
    values: &'a [f64],
    /// Of each value whether it has advanced the progress: the search for zones comes by some again.
    is_told: Vec<AtomicBool>,
}

impl<F: TracedFamily> FollowedFamily<'_, F> {
    /// Refuses to go on where the user has stopped, which the caller tells as an interruption.
    fn met(&self, value: f64) -> Result<(), SlidingError> {
        if self.search.progress.interrupted() {
            return Err(SlidingError::Interrupted);
        }
        if let Ok(k) = self.values.binary_search_by(|known| known.total_cmp(&value))
            && self.is_told.get(k).is_some_and(|is_told| !is_told.swap(true, Ordering::Relaxed))
        {
            self.search.progress.advance();
        }
        Ok(())
    }
}

impl<F: TracedFamily> PairFamily for FollowedFamily<'_, F> {
    fn at(&self, value: f64) -> Result<PairCharacteristic, SlidingError> {
        self.met(value)?;
        self.search.family.at(value)
    }

    fn spectrum(&self, value: f64, count: usize) -> Result<Spectrum, SlidingError> {
        self.met(value)?;
        let solve = || Spectrum::with_more(&self.search.family.at(value)?, value, count);
        self.search.kept.spectrum(value, &solve)
    }
}

impl<F: TracedFamily> LocusSearch<'_, F> {
    /// Branches and zones from one value to another, by their numbers; each value may advance the progress.
    fn followed(&self, first: usize, end: usize, is_told: bool) -> Result<Followed, SlidingError> {
        let values = &self.range.values[first..end];
        let told = if is_told { values.len() } else { 0 };
        let is_told = (0..told).map(|_| AtomicBool::new(false)).collect();
        let pieces = match values {
            [first, .., last] => (self.range.pieces)([*first, *last])?,
            _ => Vec::new(),
        };
        let family = FollowedFamily { search: self, values, is_told };
        follow(&family, values, &pieces, self.count, self.range.resolution)
    }

    /// Every value by itself, then each run of values that succeed.
    fn piecewise(
        &self,
        rows: &mut [FamilyRow],
        traced: &mut Traced,
        error: SlidingError,
    ) -> Result<(), ModelError> {
        let Self { family, range, count, kept, progress } = *self;
        let spectra: Vec<Result<Spectrum, SlidingError>> = parallel::each(range.values, |value| {
            let solve = || Spectrum::new(&family.at(*value)?, *value, WantedEigenvalues::Lowest(count));
            if progress.interrupted() { Err(SlidingError::Interrupted) } else { kept.alone(*value, &solve) }
        });
        stop(progress)?;
        if spectra.iter().all(Result::is_err) {
            return Err(error.into());
        }
        for ((row, found), value) in rows.iter_mut().zip(&spectra).zip(range.values) {
            if let Err(error) = found {
                row.failure = Some(family.reason(*value).unwrap_or_else(|| told(error)));
            }
        }
        let (mut first, mut begun) = (0, 0);
        while first < spectra.len() {
            let end = (first..spectra.len()).find(|k| spectra[*k].is_err()).unwrap_or(spectra.len());
            let run = (end > first + 1).then(|| self.followed(first, end, false));
            stop(progress)?;
            if let Some(Ok(found)) = run {
                traced.zones.extend(found.zones.clone());
                begun = place(&mut rows[first..end], begun, found);
            } else {
                if let Some(Err(error)) = run {
                    traced.untraced.push(([range.values[first], range.values[end - 1]], told(&error)));
                }
                // neighbours stand in branches apart: none is known to go on as another
                let apart = spectra[first..end].iter().flatten().enumerate().map(|(k, spectrum)| {
                    let row = std::slice::from_mut(&mut rows[first + k]);
                    place(row, begun + k % 2 * count, alone(spectrum, count))
                });
                begun = apart.max().unwrap_or(begun);
            }
            first = end + 1;
        }
        Ok(())
    }
}
