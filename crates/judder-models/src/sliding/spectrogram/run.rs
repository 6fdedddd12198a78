//! The levels of a stored signal, with the zones of a stored locus.

use crate::error::ModelError;
use crate::sliding::case::observe::ObservedPoint;
use crate::sliding::march::variable_name;
use crate::sliding::spectrogram::settings::SpectrogramAnalysis;
use crate::spectrogram::levels::AskedLevels;
use judder_store::{Dataset, Results, Variable};
use judder_study::kept::StudyPlace;
use judder_study::outcome::Outcome;
use serde_json::Value;

/// Levels of a signal over time and frequency, with the unstable zones of a locus.
pub(crate) fn run(
    name: &str,
    asked: &SpectrogramAnalysis,
    points: &[ObservedPoint],
    place: Option<StudyPlace<'_>>,
) -> Result<Outcome, ModelError> {
    let (signal, called) = (variable_name(*asked.signal, points), asked.signal.name(points));
    let SpectrogramAnalysis { levels, locus, .. } = asked;
    let levels = AskedLevels { name, signal: [&signal, &called], asked: levels };
    let place = levels.place(place, &locus.iter().map(String::as_str).collect::<Vec<_>>())?;
    let shown = levels.shown(&place)?;
    let found = match locus {
        Some(locus) => zones(&place, locus)?,
        None => Vec::new(),
    };
    let dataset = with_zones(shown.dataset(&levels, locus.as_deref())?, &found)?;
    Ok(Outcome { scalars: shown.told(&levels).scalars(), dataset, ..Outcome::default() })
}

/// With the zones of a locus.
fn with_zones(mut dataset: Dataset, zones: &[LocusZone]) -> Result<Dataset, ModelError> {
    for (name, unit, values) in [
        ("zone_from", "m", zones.iter().map(|zone| zone.from).collect::<Vec<_>>()),
        ("zone_to", "m", zones.iter().map(|zone| zone.to).collect()),
        ("zone_frequency", "Hz", zones.iter().map(|zone| zone.frequency).collect()),
        ("zone_growth_rate", "1/s", zones.iter().map(|zone| zone.growth_rate).collect()),
    ] {
        let what = format!("unstable zone of the locus, {}", name.replace('_', " "));
        let variable = Variable::new(name, &["zone"], &[values.len()], values);
        dataset = dataset.with(variable.units(unit).long_name(&what))?;
    }
    Ok(dataset)
}

/// An unstable zone of a locus.
struct LocusZone {
    from: f64,
    to: f64,
    frequency: f64,
    growth_rate: f64,
}

/// The unstable zones that a locus has left in the summary.
fn zones(place: &StudyPlace<'_>, locus: &str) -> Result<Vec<LocusZone>, ModelError> {
    let summary = place.study.read_summary()?;
    let results = summary.as_ref().and_then(|summary| summary.results.get(locus));
    let listed = results.and_then(|results| results.get("unstable")).and_then(Value::as_array);
    let zone = |listed: &Value| {
        let number = |key: &str| listed.get(key).and_then(Value::as_f64);
        Some(LocusZone {
            from: number("from_m")?,
            to: number("to_m")?,
            frequency: number("frequency_hz")?,
            growth_rate: number("max_growth_rate")?,
        })
    };
    Ok(listed.into_iter().flatten().filter_map(zone).collect())
}
