//! Eigenvalues and unstable zones of a family of pairs, with what could not be.

use crate::error::ModelError;
use judder_numerics::parallel;
use judder_numerics::words::plain;
use judder_sliding::SlidingError;
use judder_sliding::characteristic::PairCharacteristic;
use judder_sliding::coupling::SteadyFriction;
use judder_sliding::locus::{Conditions, Configuration, Followed, follow};
use judder_sliding::pair::Pair;
use judder_sliding::spectrum::{Spectrum, WantedEigenvalues};
use judder_sliding::statics::PairEquilibrium;
use judder_sliding::zones::{Zone, ZoneEnd};
use judder_study::Progress;
use judder_study::axis::SweptAxis;
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

/// What a pair is like at rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct RestState {
    /// N, N.
    pub(super) normal_force: f64,
    /// By how much the edge climbs at the contact, over the line from the track's first node to its last.
    pub(super) slope: f64,
}

impl RestState {
    pub(super) fn new(pair: &Pair, conditions: &Conditions, position: f64) -> Result<Self, SlidingError> {
        let Conditions { configuration, velocity, load, .. } = *conditions;
        let sliding = SteadyFriction::at(pair.friction(), velocity);
        let rest = match configuration {
            Configuration::Undeformed => PairEquilibrium::undeformed(pair, position, load, sliding)?,
            Configuration::Deformed => PairEquilibrium::new(pair, position, load, sliding)?,
        };
        let ([x, y], [along, up]) = (pair.direction(), rest.touch.tangent);
        let slope = (x * up - y * along) / (x * along + y * up);
        Ok(Self { normal_force: rest.normal_force, slope })
    }
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
    progress: &dyn Progress,
) -> Result<Traced, ModelError> {
    let states: Vec<Option<RestState>> =
        parallel::each(
            range.values,
            |value| {
                if progress.interrupted() { None } else { family.state(*value).ok() }
            },
        );
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
    let whole = followed(family, range, 0, range.values.len(), count, Some(progress));
    stop(progress)?;
    match whole {
        Ok(found) => {
            traced.zones = found.zones.clone();
            place(&mut rows, 0, found);
        }
        Err(error) => piecewise(family, range, count, &mut rows, &mut traced, progress, error)?,
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

/// Branches and zones from one value to another, by their numbers; each value advances the progress, and the user may stop.
fn followed(
    family: &impl TracedFamily,
    range: &TracedRange<'_>,
    first: usize,
    end: usize,
    count: usize,
    progress: Option<&dyn Progress>,
) -> Result<Followed, SlidingError> {
    let values = &range.values[first..end];
    let is_told: Vec<AtomicBool> = values.iter().map(|_| AtomicBool::new(false)).collect();
    let at = |value: f64| {
        if let Some(progress) = progress {
            if progress.interrupted() {
                // told as an interruption by the caller
                return Err(SlidingError::NoEquilibrium {
                    position: value,
                    reason: "the run was interrupted",
                });
            }
            // the search for zones comes by some values again
            if let Ok(k) = values.binary_search_by(|known| known.total_cmp(&value))
                && !is_told[k].swap(true, Ordering::Relaxed)
            {
                progress.advance();
            }
        }
        family.at(value)
    };
    let pieces = match values {
        [first, .., last] => (range.pieces)([*first, *last])?,
        _ => Vec::new(),
    };
    follow(&at, values, &pieces, count, range.resolution)
}

/// Every value by itself, then each run of values that succeed.
fn piecewise(
    family: &impl TracedFamily,
    range: &TracedRange<'_>,
    count: usize,
    rows: &mut [FamilyRow],
    traced: &mut Traced,
    progress: &dyn Progress,
    error: SlidingError,
) -> Result<(), ModelError> {
    let spectra: Vec<Result<Spectrum, SlidingError>> = parallel::each(range.values, |value| {
        Spectrum::new(&family.at(*value)?, *value, WantedEigenvalues::Lowest(count))
    });
    if spectra.iter().all(Result::is_err) {
        return Err(error.into());
    }
    stop(progress)?;
    for ((row, found), value) in rows.iter_mut().zip(&spectra).zip(range.values) {
        if let Err(error) = found {
            row.failure = Some(family.reason(*value).unwrap_or_else(|| told(error)));
        }
    }
    let (mut first, mut begun) = (0, 0);
    while first < spectra.len() {
        let end = (first..spectra.len()).find(|k| spectra[*k].is_err()).unwrap_or(spectra.len());
        let run = (end > first + 1).then(|| followed(family, range, first, end, count, None));
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
