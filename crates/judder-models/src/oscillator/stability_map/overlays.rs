//! The boundaries that are laid over a map: of the full system, without damping, and without coupling.

use crate::axis::range;
use crate::bridge;
use crate::checks::VanishingGrowth;
use crate::error::ModelError;
use crate::oscillator::case::OscillatorCase;
use crate::oscillator::keys::OscillatorKey;
use crate::sweep::StabilityMapAnalysis;
use judder_keys::numeric_key::Value as CaseValue;
use judder_oscillator::boundary::{Boundary, BoundaryEnd, BoundaryFold, Condition, boundaries};
use judder_oscillator::equilibrium::equilibrium;
use judder_oscillator::linearisation::Linearisation;
use judder_oscillator::{Coefficients, Contact};
use judder_store::{Dataset, Results, Variable};
use judder_study::Progress;
use judder_study::axis::SweptAxis;
use judder_study::outcome::CheckRecord;
use judder_study::text::short;

/// A boundary that is laid over a stability map.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BoundaryKind {
    /// Of the full, damped system.
    Full,
    /// Without damping, eqs. (27), (28).
    Conservative,
    /// Of the full system with η = 0.
    Decoupled,
}

impl BoundaryKind {
    /// All of them, in the order in which a map has them.
    pub const ALL: [Self; 3] = [Self::Full, Self::Conservative, Self::Decoupled];

    /// `"full"`, `"conservative"` or `"decoupled"`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Full => "full",
            Self::Conservative => "conservative",
            Self::Decoupled => "decoupled",
        }
    }

    /// The name in arrays and summaries.
    fn array_name(self) -> &'static str {
        match self {
            Self::Full => "full_boundary",
            Self::Conservative => "conservative_boundary",
            Self::Decoupled => "decoupled_boundary",
        }
    }

    fn what(self) -> &'static str {
        match self {
            Self::Full => "stability boundary of the full system",
            Self::Conservative => "boundary without damping, eqs. (27), (28)",
            Self::Decoupled => "stability boundary of the full system with η = 0",
        }
    }

    fn condition(self) -> Condition {
        match self {
            Self::Full | Self::Decoupled => Condition::Full,
            Self::Conservative => Condition::Conservative,
        }
    }

    /// Whether it makes sense over these keys: where the coupling is swept, none is without it.
    fn is_over(self, settings: &StabilityMapAnalysis<OscillatorKey>) -> bool {
        self != Self::Decoupled || ![settings.x.key, settings.y.key].contains(&OscillatorKey::Coupling)
    }
}

/// The pieces of one boundary, one behind the other, with NaN after each.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct BoundaryCurves {
    /// Values of the first swept quantity, in its form.
    pub x: Vec<f64>,
    /// Values of the second swept quantity, in its form.
    pub y: Vec<f64>,
    /// The frequency of the oscillation that is born there, ω/ω_nx.
    pub frequency: Vec<f64>,
    /// The indentation ŷ_e there.
    pub indentation: Vec<f64>,
}

impl BoundaryCurves {
    fn new(curves: &[Boundary]) -> Self {
        let mut columns = Self::default();
        for curve in curves {
            for point in &curve.points {
                columns.push([point.x, point.y, point.frequency, point.indentation]);
            }
            columns.push([f64::NAN; 4]);
        }
        columns
    }

    fn push(&mut self, [x, y, frequency, indentation]: [f64; 4]) {
        self.x.push(x);
        self.y.push(y);
        self.frequency.push(frequency);
        self.indentation.push(indentation);
    }
}

/// One boundary of the plane of a stability map, as its overlay has it; `None` for [`BoundaryKind::Decoupled`] where the coupling is
/// itself swept.
#[must_use]
pub fn boundary_curves(
    kind: BoundaryKind,
    case: &OscillatorCase,
    contact: &Contact,
    settings: &StabilityMapAnalysis<OscillatorKey>,
) -> Option<BoundaryCurves> {
    let curves = || followed(kind, contact, settings, &coefficients(kind, case, settings));
    kind.is_over(settings).then(|| BoundaryCurves::new(&curves()))
}

/// The oscillator of a kind of boundary over the plane of a map.
fn coefficients<'a>(
    kind: BoundaryKind,
    case: &'a OscillatorCase,
    settings: &'a StabilityMapAnalysis<OscillatorKey>,
) -> impl Fn(f64, f64) -> Coefficients + Sync + 'a {
    move |x, y| {
        let mut inputs = case.inputs;
        settings.x.set(&mut inputs, x);
        settings.y.set(&mut inputs, y);
        if kind == BoundaryKind::Decoupled {
            inputs.set(OscillatorKey::Coupling, CaseValue::group(0.0));
        }
        bridge::coefficients(&inputs)
    }
}

fn followed(
    kind: BoundaryKind,
    contact: &Contact,
    settings: &StabilityMapAnalysis<OscillatorKey>,
    at: &(dyn Fn(f64, f64) -> Coefficients + Sync),
) -> Vec<Boundary> {
    boundaries(contact, kind.condition(), &range(&settings.x), &range(&settings.y), at)
}

/// One kind of boundary over the map, all its pieces.
pub(crate) struct Overlay {
    /// Name in arrays and summaries.
    pub(crate) name: &'static str,
    what: &'static str,
    curves: Vec<Boundary>,
    /// The growth rates along a Hopf boundary; `None` for the conservative one.
    growth: Option<VanishingGrowth>,
    /// Whether its points have one: those of an oscillator.
    has_indentation: bool,
}

/// Follows all boundaries that make sense for these settings.
pub(super) fn trace(
    contact: &Contact,
    case: &OscillatorCase,
    settings: &StabilityMapAnalysis<OscillatorKey>,
    progress: &dyn Progress,
) -> Result<Vec<Overlay>, ModelError> {
    let mut overlays = Vec::new();
    for kind in BoundaryKind::ALL.into_iter().filter(|kind| kind.is_over(settings)) {
        if progress.interrupted() {
            return Err(ModelError::Interrupted);
        }
        let at = coefficients(kind, case, settings);
        let curves = followed(kind, contact, settings, &at);
        let growth = (kind.condition() == Condition::Full).then(|| growth_along(contact, &curves, &at));
        overlays.push(Overlay {
            name: kind.array_name(),
            what: kind.what(),
            curves,
            growth,
            has_indentation: true,
        });
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
            let stalled: Vec<&Boundary> = overlay.curves.iter().filter(|curve| curve.end == BoundaryEnd::Stalled).collect();
            let last = stalled.first()?.points.last()?;
            Some(format!(
                "{}: {} of {} curves end inside the map, for one at ({}, {}): a corner, where other curves go on, or a place too \
                 narrow to follow",
                overlay.what,
                stalled.len(),
                overlay.curves.len(),
                short(last.x),
                short(last.y)
            ))
        })
        .collect()
}

/// The checks that the overlays carry.
pub(super) fn check(overlays: &[Overlay]) -> Vec<CheckRecord> {
    let checked = overlays.iter().filter_map(|overlay| Some((overlay.what, overlay.growth?)));
    checked
        .map(|(what, growth)| {
            let compared = format!(
                "|max Re λ| over max |λ| from the eigenvalues, at {} points of the followed curve",
                growth.found.numbers()
            );
            CheckRecord::new(
                format!("growth rate vanishes on the {what}"),
                compared,
                growth.found,
                growth.limit,
            )
        })
        // a map may have no such curve
        .filter(|check| !check.compared_nothing())
        .collect()
}

/// What is told of a boundary.
#[derive(Results)]
pub(super) struct ToldBoundary {
    /// pieces
    curves: usize,
    closed: usize,
    stalled: usize,
    points: usize,
    folds_in_x: usize,
    folds_in_y: usize,
    /// from and to
    #[result(unit = "1")]
    frequency: Option<[f64; 2]>,
}

impl Overlay {
    /// The stability boundary of a system that is no oscillator.
    pub(crate) fn of_system(curves: Vec<Boundary>) -> Self {
        Self {
            name: "full_boundary",
            what: "stability boundary",
            curves,
            growth: None,
            has_indentation: false,
        }
    }

    /// Pieces, how they end, folds, range of frequencies.
    pub(super) fn summary(&self) -> ToldBoundary {
        let count = |end: BoundaryEnd| self.curves.iter().filter(|c| c.end == end).count();
        let folds =
            |fold: BoundaryFold| self.curves.iter().flat_map(|c| &c.folds).filter(|f| f.1 == fold).count();
        let frequencies = self.curves.iter().flat_map(|c| c.points.iter().map(|p| p.frequency));
        let (low, high) =
            frequencies.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), f| (l.min(f), h.max(f)));
        ToldBoundary {
            curves: self.curves.len(),
            closed: count(BoundaryEnd::Closed),
            stalled: count(BoundaryEnd::Stalled),
            points: self.curves.iter().map(|c| c.points.len()).sum(),
            folds_in_x: folds(BoundaryFold::InX),
            folds_in_y: folds(BoundaryFold::InY),
            frequency: (low <= high).then_some([low, high]),
        }
    }

    /// Adds the points of all pieces: the two swept quantities, the frequency, and whether the curve turns back there.
    pub(super) fn add_to(
        &self,
        dataset: Dataset,
        x: &SweptAxis,
        y: &SweptAxis,
        of_frequency: &str,
    ) -> Result<Dataset, ModelError> {
        let BoundaryCurves { x: along_x, y: along_y, frequency, indentation } =
            BoundaryCurves::new(&self.curves);
        let folds = self.fold_codes();
        let length = folds.len();
        let dimension = format!("{}_point", self.name);
        let mut names = vec![
            (x.name(), along_x, x.quantity.unit.as_str(), "first swept quantity"),
            (y.name(), along_y, y.quantity.unit.as_str(), "second swept quantity"),
            ("frequency", frequency, "1", of_frequency),
        ];
        if self.has_indentation {
            names.push(("indentation", indentation, "1", "indentation ŷ_e"));
        }
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

    /// At each point of [`BoundaryCurves`], whether the curve turns back there: 1 in x, 2 in y.
    fn fold_codes(&self) -> Vec<u8> {
        let code = |curve: &Boundary, index: usize| {
            let turned = |fold: BoundaryFold| u8::from(curve.folds.contains(&(index, fold)));
            turned(BoundaryFold::InX) + 2 * turned(BoundaryFold::InY)
        };
        let of = |curve: &Boundary| -> Vec<u8> {
            (0..curve.points.len()).map(|index| code(curve, index)).chain([0]).collect()
        };
        self.curves.iter().flat_map(of).collect()
    }
}
