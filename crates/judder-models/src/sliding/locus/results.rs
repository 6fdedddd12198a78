//! What a locus leaves.

use super::traced::{FamilyRow, Traced};
use crate::error::ModelError;
use crate::key_unit::{in_unit, unit_of_any};
use crate::sliding::locus::settings::{Along, LocusAnalysis};
use judder_sliding::zones::{Zone, ZoneEnd};
use judder_store::{Dataset, Declared, Results, Table, Variable};
use judder_study::axis::SweptAxis;
use num_complex::Complex64;
use std::f64::consts::TAU;

/// What the numbers of [`code`] say.
const KINDS: &str = "0 growth rate zero, 1 end of the range, 2 jump of the growth rate, 3 met its mirror image, 4 lost: the zone goes on";

/// What the codes of verdicts mean.
const VERDICTS: [(u8, &str); 4] = [(0, "stable"), (1, "marginal"), (2, "unstable"), (3, "no eigenvalue")];

/// The verdict on an eigenvalue as a code: a growth rate below its error has no sign.
fn verdict(eigenvalue: Complex64, error: f64) -> u8 {
    match eigenvalue.re {
        growth if growth.is_nan() => 3,
        growth if growth > error => 2,
        growth if growth < -error => 0,
        _ => 1,
    }
}

/// The end of a zone as a number of an array.
const fn code(end: ZoneEnd) -> i64 {
    match end {
        ZoneEnd::Root => 0,
        ZoneEnd::Range => 1,
        ZoneEnd::Jump => 2,
        ZoneEnd::Meeting => 3,
        ZoneEnd::Lost => 4,
    }
}

/// What is told of a locus.
#[derive(Results)]
pub(super) struct ToldLocus {
    #[result(optional)]
    position_m: Option<Vec<f64>>,
    /// the values of another key
    #[result(optional)]
    value: Option<Vec<f64>>,
    /// of the branches at each
    frequencies_hz: Vec<Vec<f64>>,
    #[result(unit = "1/s")]
    growth_rates: Vec<Vec<f64>>,
    #[result(unit = "1/s")]
    growth_rate_errors: Vec<Vec<f64>>,
    /// the unstable zones
    unstable: Vec<ToldZone>,
    #[result(unit = "N")]
    normal_force: Vec<f64>,
    slope: Vec<f64>,
    configuration: &'static str,
    damping: bool,
    /// where there are no eigenvalues
    missing: Vec<LocusFailure>,
    #[result(optional)]
    key: Option<String>,
    #[result(optional)]
    unit: Option<String>,
    /// the unit in which the case has its values, in which tables, figures and messages show them
    #[result(optional)]
    shown_unit: Option<String>,
    /// where the contact is held
    #[result(optional)]
    at_m: Option<f64>,
    degrees_of_freedom: usize,
}

/// An unstable zone.
#[derive(Results)]
struct ToldZone {
    #[result(optional)]
    from_m: Option<f64>,
    #[result(optional)]
    to_m: Option<f64>,
    /// where it grows fastest
    #[result(optional)]
    peak_m: Option<f64>,
    #[result(optional)]
    from: Option<f64>,
    #[result(optional)]
    to: Option<f64>,
    #[result(optional)]
    peak: Option<f64>,
    ends: [&'static str; 2],
    frequency_hz: f64,
    #[result(unit = "1/s")]
    max_growth_rate: f64,
    error: f64,
}

/// A point without eigenvalues.
#[derive(Results)]
struct LocusFailure {
    #[result(optional)]
    position_m: Option<f64>,
    #[result(optional)]
    value: Option<f64>,
    reason: String,
}

/// The keys of the summary of a locus over positions, or over the values of another key.
pub(super) fn summary_keys(along: &Along) -> Vec<Declared> {
    let without = |others: &[&str]| Declared::without(ToldLocus::declared(), others);
    match along {
        Along::Positions(_) => without(&["value", "from", "to", "peak", "key", "unit", "shown_unit", "at_m"]),
        Along::Key { sweep, .. } => {
            let keys = without(&["position_m", "from_m", "to_m", "peak_m"]);
            in_unit(keys, &unit_of_any(sweep), &["value", "from", "to", "peak"])
        }
    }
}

pub(super) struct Locating<'a> {
    pub(super) settings: &'a LocusAnalysis,
    pub(super) axis: &'a SweptAxis,
    pub(super) traced: &'a Traced,
}

impl Locating<'_> {
    fn is_over_positions(&self) -> bool {
        matches!(self.settings.along, Along::Positions(_))
    }

    pub(super) fn told(&self, degrees_of_freedom: usize) -> ToldLocus {
        let Self { settings, axis, traced } = self;
        let table = |pick: &dyn Fn(&Complex64) -> f64| -> Vec<Vec<f64>> {
            traced.rows.iter().map(|row| row.eigenvalues.iter().map(pick).collect()).collect()
        };
        let column = |pick: &dyn Fn(&FamilyRow) -> f64| traced.rows.iter().map(pick).collect::<Vec<f64>>();
        let failures = axis.values.iter().zip(&traced.rows);
        let failures = failures.filter_map(|(value, row)| {
            let (position_m, value) = self.along(*value);
            Some(LocusFailure { position_m, value, reason: row.failure.clone()? })
        });
        let (position_m, value) = self.along(axis.values.clone());
        let (at, key) = match &settings.along {
            Along::Positions(_) => (None, None),
            Along::Key { at, sweep } => (Some(*at), Some(sweep.path.clone())),
        };
        ToldLocus {
            position_m,
            value,
            frequencies_hz: table(&|s| s.im / TAU),
            growth_rates: table(&|s| s.re),
            growth_rate_errors: traced.rows.iter().map(|row| row.errors.clone()).collect(),
            unstable: traced.zones.iter().map(|zone| self.zone(zone)).collect(),
            normal_force: column(&|row| row.state.normal_force),
            slope: column(&|row| row.state.slope),
            configuration: settings.configuration.name(),
            damping: settings.damping,
            missing: failures.collect(),
            unit: key.is_some().then(|| axis.quantity.unit.clone()),
            shown_unit: axis.shown_unit(),
            key,
            at_m: at,
            degrees_of_freedom,
        }
    }

    /// What lies along the axis as what is told of positions, or else as what is told of another key.
    fn along<T>(&self, told: T) -> (Option<T>, Option<T>) {
        if self.is_over_positions() { (Some(told), None) } else { (None, Some(told)) }
    }

    fn zone(&self, zone: &Zone) -> ToldZone {
        let ((from_m, from), (to_m, to), (peak_m, peak)) =
            (self.along(zone.from), self.along(zone.to), self.along(zone.peak));
        ToldZone {
            from_m,
            to_m,
            peak_m,
            from,
            to,
            peak,
            ends: zone.ends.map(ZoneEnd::name),
            frequency_hz: zone.frequency_hz,
            max_growth_rate: zone.growth_rate,
            error: zone.error,
        }
    }

    pub(super) fn dataset(&self) -> Result<Dataset, ModelError> {
        let Self { settings, axis, traced } = self;
        let (name, rows) = (axis.name(), traced.rows.len());
        let eigenvalues: Vec<Complex64> =
            traced.rows.iter().flat_map(|row| row.eigenvalues.clone()).collect();
        let errors: Vec<f64> = traced.rows.iter().flat_map(|row| row.errors.clone()).collect();
        let verdicts = eigenvalues.iter().zip(&errors).map(|(s, error)| verdict(*s, *error)).collect();
        let count = traced.rows.first().map_or(0, |row| row.eigenvalues.len());
        let branches: Vec<i64> = (1..=count as i64).collect();
        let along = |own: &str, pick: &dyn Fn(&FamilyRow) -> f64| {
            Variable::new(own, &[name], &[rows], traced.rows.iter().map(pick).collect::<Vec<f64>>())
        };
        let zones = &traced.zones;
        let of_zone = |own: &str, unit: &str, words: &str, pick: &dyn Fn(&Zone) -> f64| {
            let values = zones.iter().map(pick).collect::<Vec<f64>>();
            Variable::new(own, &["zone"], &[zones.len()], values).units(unit).long_name(words)
        };
        let kind = |own: &str, side: usize| {
            let values = zones.iter().map(|zone| code(zone.ends[side])).collect::<Vec<i64>>();
            Variable::new(own, &["zone"], &[zones.len()], values).long_name(KINDS)
        };
        let unit = &axis.quantity.unit;
        let points: Vec<(usize, (f64, Complex64))> = zones
            .iter()
            .enumerate()
            .flat_map(|(k, zone)| zone.path.iter().map(move |point| (k, *point)))
            .collect();
        let of_point =
            |own: &str, values: Vec<f64>| Variable::new(own, &["zone_point"], &[points.len()], values);
        let numbers: Vec<i64> = points.iter().map(|(zone, _)| *zone as i64 + 1).collect();
        let values: Vec<Complex64> = points.iter().map(|(_, (_, value))| *value).collect();
        Ok(Dataset::new()
            .attribute("configuration", settings.configuration.name())?
            .attribute("damping", settings.damping)?
            .with(axis.coordinate())?
            .with(Variable::coordinate("branch", branches).long_name("number of the branch"))?
            .with(
                Variable::new("eigenvalue", &[name, "branch"], &[rows, count], eigenvalues)
                    .units("1/s")
                    .long_name("eigenvalue λ of a branch, NaN where it is not among the lowest"),
            )?
            .with(
                Variable::new("eigenvalue_error", &[name, "branch"], &[rows, count], errors)
                    .units("1/s")
                    .long_name("how far an eigenvalue may be off"),
            )?
            .with(
                Variable::classes("verdict", &[name, "branch"], &[rows, count], verdicts, &VERDICTS)
                    .long_name("verdict"),
            )?
            .with(
                along("normal_force", &|row| row.state.normal_force)
                    .units("N")
                    .long_name("normal force at rest"),
            )?
            .with(
                along("slope", &|row| row.state.slope)
                    .units("1")
                    .long_name("slope of the edge at the contact"),
            )?
            .with(of_zone("zone_from", unit, "start of an unstable zone", &|zone| zone.from))?
            .with(of_zone("zone_to", unit, "end of an unstable zone", &|zone| zone.to))?
            .with(kind("zone_from_kind", 0))?
            .with(kind("zone_to_kind", 1))?
            .with(of_zone("zone_peak", unit, "where a zone grows fastest", &|zone| zone.peak))?
            .with(of_zone("zone_growth_rate", "1/s", "largest growth rate of a zone", &|zone| {
                zone.growth_rate
            }))?
            .with(of_zone("zone_frequency", "Hz", "frequency where a zone grows fastest", &|zone| {
                zone.frequency_hz
            }))?
            .with(of_zone("zone_error", "1/s", "how far the largest growth rate may be off", &|zone| {
                zone.error
            }))?
            .with(
                Variable::new("zone_path", &["zone_point"], &[points.len()], numbers)
                    .long_name("number of the zone that a point lies on"),
            )?
            .with(
                of_point("zone_path_at", points.iter().map(|(_, (at, _))| *at).collect())
                    .units(unit)
                    .long_name("place of the point"),
            )?
            .with(
                Variable::new("zone_path_eigenvalue", &["zone_point"], &[points.len()], values)
                    .units("1/s")
                    .long_name("eigenvalue of the zone there"),
            )?)
    }

    pub(super) fn table(&self) -> Result<Table, ModelError> {
        let Self { axis, traced, .. } = self;
        let rows = axis.values.iter().zip(&traced.rows).flat_map(|(value, row)| {
            let branches = row.eigenvalues.iter().enumerate();
            branches
                .filter(|(_, s)| s.re.is_finite())
                .map(move |(branch, s)| (*value, branch as i64 + 1, *s, row.state, row.errors[branch]))
        });
        let rows: Vec<_> = rows.collect();
        let numbers = |pick: &dyn Fn(usize) -> f64| (0..rows.len()).map(pick).collect::<Vec<f64>>();
        Ok(Table::new()
            .column(axis.name(), &axis.quantity.unit, numbers(&|k| rows[k].0))?
            .column("branch", "1", rows.iter().map(|row| row.1).collect::<Vec<i64>>())?
            .column("frequency", "Hz", numbers(&|k| rows[k].2.im / TAU))?
            .column("growth_rate", "1/s", numbers(&|k| rows[k].2.re))?
            .column("error", "1/s", numbers(&|k| rows[k].4))?
            .column("normal_force", "N", numbers(&|k| rows[k].3.normal_force))?
            .column("slope", "1", numbers(&|k| rows[k].3.slope))?)
    }
}
