//! `spectrum`: the eigenvalues along one key (Figs. 5, 6), of the full system and without damping.

use crate::axis::{self, Curves};
use crate::checks;
use crate::error::ModelError;
use crate::motion::si::SiUnits;
use crate::oscillator::case::OscillatorCase;
use crate::oscillator::keys::OscillatorKey;
use crate::oscillator::law_errors::{self, Erring};
use crate::oscillator::steady_states::{SteadyState, along, failure_warning, validity_warnings};
use crate::sweep::{Family, Sweep};
use judder_oscillator::conservative::conservative_eigenvalues;
use judder_oscillator::spectrum::{eigenvalues, growth_rate, leading};
use judder_oscillator::{Contact, LinearSystem};
use judder_store::{Dataset, Results, Table, Variable};
use judder_study::Progress;
use judder_study::axis::SweptAxis;
use judder_study::outcome::Outcome;
use num_complex::Complex64;
use std::f64::consts::TAU;

/// The eigenvalues of one system, full and without damping.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Spectra {
    full: [Complex64; 4],
    conservative: [Complex64; 4],
}

impl Spectra {
    /// `None` where the system has no spectrum to give.
    pub(crate) fn new(system: &LinearSystem) -> Option<Self> {
        let reduced = system.reduced().ok()?;
        let full = eigenvalues(&reduced).ok()?;
        Some(Self { full, conservative: conservative_eigenvalues(&reduced.stiffness) })
    }

    const MISSING: Self = {
        let none = Complex64::new(f64::NAN, f64::NAN);
        Self { full: [none; 4], conservative: [none; 4] }
    };
}

/// How a model calls its eigenvalues.
pub(crate) struct SpectraWords {
    pub(crate) full: &'static str,
    pub(crate) conservative: &'static str,
}

const WORDS: SpectraWords = SpectraWords {
    full: "eigenvalues λ/ω_nx of the full system, eq. (21)",
    conservative: "eigenvalues λ/ω_nx without damping, eqs. (24), (25)",
};

/// The errors of the growth rate: the larger distance of its ends in the box of the law from it.
pub(super) const GROWTH_RATE: Erring = Erring {
    name: "growth_rate_error",
    long_name: "how far the growth rate may be off by the errors of the contact law",
    of: |state, within| {
        let own = growth_rate(&eigenvalues(&state.linearisation.system().reduced().ok()?).ok()?);
        let (least, most) = within.growth_rates().ok()?;
        Some((most - own).max(own - least))
    },
};

pub(super) fn run(
    case: &OscillatorCase,
    contact: &Contact,
    sweep: &Sweep<OscillatorKey>,
    family: Option<&Family<OscillatorKey>>,
    progress: &dyn Progress,
) -> Result<Outcome, ModelError> {
    let (axis, curves) = (axis::of_key(sweep), Curves::new(case, family));
    let (mut spectra, mut states, mut warnings) = (Vec::new(), Vec::new(), Vec::new());
    for inputs in &curves.inputs {
        let line = along(contact, inputs, sweep, progress)?;
        warnings.extend(failure_warning(&line, &axis.values));
        spectra.extend(
            line.iter().map(|s| s.as_ref().ok().and_then(|s| Spectra::new(&s.linearisation.system()))),
        );
        states.extend(line.into_iter().map(Result::ok));
    }
    let known: Vec<SteadyState> = states.iter().flatten().copied().collect();
    warnings.extend(validity_warnings(contact, known.iter()));
    let seconds = curves.inputs.iter().flat_map(|inputs| {
        axis.values.iter().map(|value| {
            let mut here = *inputs;
            sweep.set(&mut here, *value);
            here.si_units()
        })
    });
    let si: Option<Vec<SiUnits>> = seconds.collect();
    let mut outcome = outcome(&axis, &curves, spectra, &WORDS, si.as_deref())?;
    outcome.warnings = warnings;
    outcome.checks = checks::steady_sliding(contact, &known);
    law_errors::add(&mut outcome, &axis, &curves, contact, &states, &GROWTH_RATE)?;
    if let Some(units) = si.as_deref().and_then(same) {
        outcome.dataset = units.told_in(outcome.dataset)?;
    }
    Ok(outcome)
}

/// The outcome of spectra that lie along an axis, curve after curve.
pub(crate) fn outcome(
    axis: &SweptAxis,
    curves: &Curves,
    spectra: Vec<Option<Spectra>>,
    words: &SpectraWords,
    si: Option<&[SiUnits]>,
) -> Result<Outcome, ModelError> {
    let missing = spectra.iter().filter(|s| s.is_none()).count();
    let spectra: Vec<Spectra> = spectra.into_iter().map(|s| s.unwrap_or(Spectra::MISSING)).collect();
    let points = axis.values.len();
    let told = |(curve, spectra): (usize, &[Spectra])| {
        let units = si.and_then(|units| units.get(curve * points..(curve + 1) * points));
        ToldSpectra::new(axis, spectra, units).scalars()
    };
    let scalars = spectra.chunks(points).enumerate().map(told).collect();
    let (dimensions, shape) = curves.dimensions(axis, &[("mode", 4)]);
    let flat = |pick: fn(&Spectra) -> [Complex64; 4]| spectra.iter().flat_map(pick).collect::<Vec<_>>();
    let full = Variable::new("eigenvalues", &dimensions, &shape, flat(|s| s.full))
        .units("1")
        .long_name(words.full)
        .apart();
    let conservative =
        Variable::new("conservative_eigenvalues", &dimensions, &shape, flat(|s| s.conservative))
            .units("1")
            .long_name(words.conservative)
            .apart();
    let mut dataset = Dataset::new().with(axis.coordinate())?;
    if let Some(coordinate) = curves.coordinate() {
        dataset = dataset.with(coordinate)?;
    }
    Ok(Outcome {
        scalars: curves.scalars(scalars),
        dataset: dataset.with(full)?.with(conservative)?,
        table: Some(table(axis, curves, &spectra)?),
        missing,
        ..Outcome::default()
    })
}

/// What is told of a curve.
#[derive(Results)]
pub(crate) struct ToldSpectra {
    value: Vec<f64>,
    #[result(unit = "1")]
    eigenvalues: Vec<[Complex64; 4]>,
    #[result(unit = "1")]
    conservative_eigenvalues: Vec<[Complex64; 4]>,
    #[result(unit = "1")]
    growth_rate: Vec<f64>,
    /// that in 1/s
    #[result(optional)]
    growth_rate_per_s: Option<Vec<f64>>,
    /// the frequency of the fastest growing mode in Hz
    #[result(optional)]
    frequency_hz: Option<Vec<f64>>,
}

/// The unit of time, where it is the same at all points.
fn same(units: &[SiUnits]) -> Option<SiUnits> {
    units.first().copied().filter(|first| units.iter().all(|own| own.second == first.second))
}

impl ToldSpectra {
    fn new(axis: &SweptAxis, spectra: &[Spectra], units: Option<&[SiUnits]>) -> Self {
        let per_second = |of: fn(&[Complex64; 4]) -> f64| -> Option<Vec<f64>> {
            Some(spectra.iter().zip(units?).map(|(own, units)| of(&own.full) / units.second).collect())
        };
        Self {
            value: axis.values.clone(),
            eigenvalues: spectra.iter().map(|own| own.full).collect(),
            conservative_eigenvalues: spectra.iter().map(|own| own.conservative).collect(),
            growth_rate: spectra.iter().map(|own| growth_rate(&own.full)).collect(),
            growth_rate_per_s: per_second(growth_rate),
            frequency_hz: per_second(|own| leading(own).im.abs() / TAU),
        }
    }
}

fn table(axis: &SweptAxis, curves: &Curves, spectra: &[Spectra]) -> Result<Table, ModelError> {
    let rows = vec![axis.values.len(); curves.inputs.len()];
    let mut table = Table::new();
    if let Some((name, unit, column)) = curves.column(&rows) {
        table = table.column(&name, &unit, column)?;
    }
    let repeated: Vec<f64> = rows.iter().flat_map(|_| axis.values.clone()).collect();
    table = table.column(axis.name(), &axis.quantity.unit, repeated)?;
    for mode in 0..4 {
        let part =
            |pick: fn(Complex64) -> f64| spectra.iter().map(|s| pick(s.full[mode])).collect::<Vec<_>>();
        table = table.column(&format!("re_{}", mode + 1), "1", part(|l| l.re))?.column(
            &format!("im_{}", mode + 1),
            "1",
            part(|l| l.im),
        )?;
    }
    Ok(table)
}
