//! The boundaries that are laid over a map: of the full system, without damping, and without coupling.

use super::super::axis::{Axis, range};
use crate::bridge;
use crate::checks::VanishingGrowth;
use crate::error::StudyError;
use crate::outcome::CheckRecord;
use crate::progress::Progress;
use judder_case::{OscillatorCase, OscillatorKey, StabilityMap as MapSettings, Value as CaseValue};
use judder_oscillator::boundary::{Boundary, Condition, End, Fold, boundaries};
use judder_oscillator::equilibrium::equilibrium;
use judder_oscillator::linearisation::Linearisation;
use judder_oscillator::{Coefficients, Contact};
use judder_store::{Dataset, Variable};
use serde_json::{Value, json};

/// One kind of boundary over the map, all its pieces.
pub(crate) struct Overlay {
    /// Name in arrays and summaries.
    pub(crate) name: &'static str,
    what: &'static str,
    curves: Vec<Boundary>,
    /// The growth rates along a Hopf boundary; `None` for the conservative one.
    growth: Option<VanishingGrowth>,
}

/// Follows all boundaries that make sense for these settings.
pub(super) fn trace(
    contact: &Contact,
    case: &OscillatorCase,
    settings: &MapSettings<OscillatorKey>,
    progress: &dyn Progress,
) -> Result<Vec<Overlay>, StudyError> {
    let at = |coupled: bool| {
        move |x: f64, y: f64| -> Coefficients {
            let mut inputs = case.inputs;
            settings.x.set(&mut inputs, x);
            settings.y.set(&mut inputs, y);
            if !coupled {
                inputs.set(OscillatorKey::Coupling, CaseValue::group(0.0));
            }
            bridge::coefficients(&inputs)
        }
    };
    let ranges = (&range(&settings.x), &range(&settings.y));
    let sweeps_coupling = [settings.x.key, settings.y.key].contains(&OscillatorKey::Coupling);
    let wanted = [
        ("full_boundary", "stability boundary of the full system", Condition::Full, true),
        ("conservative_boundary", "boundary without damping, eqs. (27), (28)", Condition::Conservative, true),
        ("decoupled_boundary", "stability boundary of the full system with η = 0", Condition::Full, false),
    ];
    let mut overlays = Vec::new();
    for (name, what, condition, coupled) in wanted.into_iter().filter(|w| w.3 || !sweeps_coupling) {
        if progress.interrupted() {
            return Err(StudyError::Interrupted);
        }
        let coefficients = at(coupled);
        let curves = boundaries(contact, condition, ranges, &coefficients);
        let growth = (condition == Condition::Full).then(|| growth_along(contact, &curves, &coefficients));
        overlays.push(Overlay { name, what, curves, growth });
    }
    Ok(overlays)
}

/// The growth rates at every seventh point of Hopf boundaries: zero up to rounding.
fn growth_along(
    contact: &Contact,
    curves: &[Boundary],
    at: &impl Fn(f64, f64) -> Coefficients,
) -> VanishingGrowth {
    let mut growth = VanishingGrowth::default();
    for point in curves.iter().flat_map(|curve| &curve.points).step_by(7) {
        let c = at(point.x, point.y);
        let linearisation = equilibrium(contact, &c)
            .map(|state| Linearisation::new(contact.friction_load, &c, &state.response));
        growth.add(linearisation.and_then(|l| l.system().reduced()).ok());
    }
    growth
}

/// A warning for each overlay that has incomplete curves.
pub(crate) fn incomplete(overlays: &[Overlay]) -> Vec<String> {
    overlays
        .iter()
        .filter_map(|overlay| {
            let stalled: Vec<&Boundary> = overlay.curves.iter().filter(|curve| curve.end == End::Stalled).collect();
            let last = stalled.first()?.points.last()?;
            Some(format!(
                "{}: {} of {} curves end inside the map, for one at ({:.4e}, {:.4e}): a corner, where other curves go on, or a place too \
                 narrow to follow",
                overlay.what,
                stalled.len(),
                overlay.curves.len(),
                last.x,
                last.y
            ))
        })
        .collect()
}

/// The checks that the overlays carry.
pub(super) fn check(overlays: &[Overlay]) -> Vec<CheckRecord> {
    let checked = overlays.iter().filter_map(|overlay| Some((overlay.what, overlay.growth?)));
    checked
        .filter(|(_, growth)| growth.count > 0)
        .map(|(what, growth)| CheckRecord {
            name: format!("growth rate vanishes on the {what}"),
            compared: format!(
                "|max Re λ| over max |λ| from the eigenvalues, at {} points of the followed curve",
                growth.count
            ),
            figure: growth.figure,
            limit: growth.limit,
        })
        .collect()
}

impl Overlay {
    /// The stability boundary of a system that is no oscillator.
    pub(crate) fn of_system(curves: Vec<Boundary>) -> Self {
        Self { name: "full_boundary", what: "stability boundary", curves, growth: None }
    }

    /// Pieces, how they end, folds, range of frequencies.
    pub(super) fn summary(&self) -> Value {
        let count = |end: End| self.curves.iter().filter(|c| c.end == end).count();
        let folds = |fold: Fold| self.curves.iter().flat_map(|c| &c.folds).filter(|f| f.1 == fold).count();
        let frequencies = self.curves.iter().flat_map(|c| c.points.iter().map(|p| p.frequency));
        let (low, high) =
            frequencies.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), f| (l.min(f), h.max(f)));
        json!({
            "curves": self.curves.len(),
            "closed": count(End::Closed),
            "stalled": count(End::Stalled),
            "points": self.curves.iter().map(|c| c.points.len()).sum::<usize>(),
            "folds_in_x": folds(Fold::InX),
            "folds_in_y": folds(Fold::InY),
            "frequency": if low <= high { json!([low, high]) } else { Value::Null },
        })
    }

    /// Adds the points of all pieces: the two swept quantities, the frequency, and whether the curve turns back there.
    pub(super) fn add_to(&self, dataset: Dataset, x: &Axis, y: &Axis) -> Result<Dataset, StudyError> {
        let mut columns: [Vec<f64>; 4] = Default::default();
        let mut folds = Vec::new();
        for curve in &self.curves {
            for (index, point) in curve.points.iter().enumerate() {
                for (column, value) in
                    columns.iter_mut().zip([point.x, point.y, point.frequency, point.indentation])
                {
                    column.push(value);
                }
                let turned = |fold: Fold| u8::from(curve.folds.contains(&(index, fold)));
                folds.push(turned(Fold::InX) + 2 * turned(Fold::InY));
            }
            columns.iter_mut().for_each(|column| column.push(f64::NAN));
            folds.push(0);
        }
        let length = folds.len();
        let dimension = format!("{}_point", self.name);
        let [along_x, along_y, frequency, indentation] = columns;
        let names = [
            (x.name(), along_x, x.quantity.unit.as_str(), "first swept quantity"),
            (y.name(), along_y, y.quantity.unit.as_str(), "second swept quantity"),
            ("frequency", frequency, "1", "frequency of the oscillation born there, ω/ω_nx"),
            ("indentation", indentation, "1", "indentation ŷ_e"),
        ];
        let mut dataset = dataset;
        for (name, values, unit, meaning) in names {
            let variable = Variable::new(&format!("{}_{name}", self.name), &[&dimension], &[length], values)
                .units(unit)
                .long_name(&format!("{}: {meaning}; NaN between separate curves", self.what));
            dataset = dataset.with(variable)?;
        }
        let meanings = [(0, "none"), (1, "fold in x"), (2, "fold in y"), (3, "fold in both")];
        let folds =
            Variable::classes(&format!("{}_fold", self.name), &[&dimension], &[length], folds, &meanings);
        Ok(dataset.with(folds.long_name(&format!("{}: where it turns back", self.what)))?)
    }
}
