//! What would keep the leading mode from growing: derivatives of its growth rate by numbers of the case.

use super::at_change::{MOST, ModeInBand, ModesAtChange};
use super::settings::AskedCures;
use crate::assembly::AssemblySubject;
use crate::assembly::case::AssemblyCase;
use crate::assembly::eigen::band;
use crate::assembly::swept::{SWEPT, SweptAssembly};
use crate::error::ModelError;
use crate::key_sweep::KeySweep;
use judder_keys::dimension::Dimension;
use judder_keys::document::PARAMETERS;
use judder_keys::quantity::WrittenUnit;
use judder_numerics::complex::ElementaryComplex;
use judder_numerics::parallel;
use judder_store::Results;
use judder_study::Progress;
use judder_study::case::scale::Spacing;
use judder_study::labels::any_key;
use num_complex::Complex64;
use std::f64::consts::TAU;

/// By how much of itself a number is changed for its derivative.
const STEP: f64 = 1e-3;
/// By how much derivatives upwards and downwards may differ, of the larger.
const ALIKE: f64 = 0.1;
/// What may be left of the growth rate at the change that takes it to zero at first order, where that is to stand before others.
const LEFT: f64 = 0.2;
/// What rounding may change of the growth rate, of the modulus of the eigenvalue.
const ROUNDING: f64 = 1e-11;
/// Frequencies around the mode in which it is sought again.
const AROUND: [f64; 2] = [0.97, 1.03];

/// How the growth rate of a mode follows the numbers of the case.
#[derive(Clone, Results)]
pub(super) struct ToldCures {
    /// frequency of the mode about steady sliding; none where none grows
    frequency_hz: Option<f64>,
    /// its growth rate
    #[result(unit = "1/s")]
    growth_rate: Option<f64>,
    /// each number of the case, of those whose change keeps a fifth of the growth rate at most the one that has to change least first
    keys: Vec<ToldCure>,
    /// why there are none
    reason: String,
}

/// What a number of the case does to the growth rate.
#[derive(Clone, Results)]
struct ToldCure {
    /// dotted path of the number
    key: String,
    /// its value
    value: f64,
    /// its unit
    unit: String,
    /// the unit in which the case has it, in which tables show it
    shown_unit: String,
    /// what the growth rate gains with the number's relative change; none where the mode was not found beside it
    #[result(unit = "1/s")]
    growth_by_change: Option<f64>,
    /// the relative change that takes the growth rate to zero at first order; none where that would take the number below zero
    #[result(unit = "1")]
    change: Option<f64>,
    /// whether the derivative is the same upwards and downwards
    smooth: Option<bool>,
    /// the growth rate of the mode with the number changed so far, of a whole solution there; none where the mode was not found again
    #[result(unit = "1/s")]
    growth_rate_at_change: Option<f64>,
    /// whether the mode decays then; none where that is not known
    cured: Option<bool>,
    /// modes of the band that grow then; none where it is not proven that these are all
    unstable_at_change: Option<usize>,
    /// what that change does, in words; empty where there is none
    at_change: String,
    /// why there is no derivative, or what is to be said of it
    reason: String,
}

/// The cures of the mode that leads those of a band that grow.
pub(super) fn cures(
    of: &AssemblySubject<'_>,
    asked: &AskedCures,
    leading: Result<ModeInBand, String>,
    progress: &dyn Progress,
) -> Result<ToldCures, ModelError> {
    let leading = match leading {
        Ok(leading) => leading,
        Err(reason) => return Ok(ToldCures::none(reason)),
    };
    let mode = leading.value;
    let told = ToldCures {
        frequency_hz: Some(mode.im / TAU),
        growth_rate: Some(mode.re),
        ..ToldCures::none(String::new())
    };
    let paths = paths(of, asked);
    if paths.is_empty() {
        return Ok(ToldCures { reason: without_usual(of), ..told });
    }
    let sought = |path: &String| -> Result<Option<ToldCure>, ModelError> {
        progress.go_on()?;
        let Some((value, dimension)) = of.case.number(path) else { return Ok(None) };
        let sweep = around(of.case, path, (value, dimension));
        let found = match value == 0.0 {
            true => ToldCure::none(&sweep, value, "it is zero, of which there is no relative change"),
            false => cure(of, &sweep, value, mode),
        };
        let Some(change) = found.change else { return Ok(Some(found)) };
        let then = leading.at_change(of, &sweep, (value, change), progress)?;
        Ok(Some(found.with_change(then)))
    };
    let mut keys: Vec<ToldCure> = parallel::try_each(&paths, sought)?.into_iter().flatten().collect();
    let place = |own: &ToldCure| {
        let is_short = own.growth_rate_at_change.is_none_or(|growth| growth > LEFT * mode.re);
        (own.change.is_none(), is_short, own.smooth != Some(true))
    };
    let size = |own: &ToldCure| own.change.map_or(f64::INFINITY, f64::abs);
    keys.sort_by(|a, b| place(a).cmp(&place(b)).then(size(a).total_cmp(&size(b))));
    Ok(ToldCures { keys, ..told })
}

/// The numbers that are asked for.
fn paths(of: &AssemblySubject<'_>, asked: &AskedCures) -> Vec<String> {
    match asked {
        AskedCures::Keys(paths) => paths.clone(),
        AskedCures::Usual => of.case.numbers().into_iter().filter(|path| is_usual(path)).collect(),
    }
}

/// What cures are reckoned from, in words.
pub(super) fn cures_estimated(of: &AssemblySubject<'_>, asked: &AskedCures) -> String {
    let numbers = paths(of, asked).len();
    format!(
        "; modes beside {numbers} numbers of the case, and at up to {} values of each on the way to the change that would keep the mode from growing",
        1 + MOST
    )
}

/// The values on both sides of a number of the case between which its derivative is taken.
pub(super) fn around(case: &AssemblyCase, path: &str, (value, dimension): (f64, Dimension)) -> KeySweep {
    let values = [1.0 - STEP, 1.0 + STEP].map(|factor| factor * value).to_vec();
    let unit = case.unit(path).unwrap_or_else(|| WrittenUnit::si(dimension));
    KeySweep { path: path.to_owned(), values, dimension, scale: Spacing::Linear, unit }
}

/// How dampings, moduli and stiffnesses are called.
const USUAL: [&str; 9] = [
    "cubic_stiffness",
    "alpha",
    "beta",
    "loss_factor",
    "ratio",
    "damping",
    "youngs_modulus",
    "stiffness",
    "point_stiffness",
];

/// Whether a number is of a section that can vary.
fn is_of_bodies(path: &str) -> bool {
    SWEPT.names.iter().any(|section| path.split('.').next() == Some(section))
}

/// Dampings, moduli and stiffnesses.
fn is_usual(path: &str) -> bool {
    is_of_bodies(path) && path.rsplit('.').next().is_some_and(|last| USUAL.contains(&last))
}

/// That `true` means none of the numbers of the case, and what can be named in its place.
fn without_usual(of: &AssemblySubject<'_>) -> String {
    /// Numbers that are named.
    const NAMED: usize = 6;
    let others: Vec<String> = of.case.numbers().into_iter().filter(|path| is_of_bodies(path)).collect();
    let named = others.iter().take(NAMED).map(|path| format!("\"{path}\"")).collect::<Vec<_>>().join(", ");
    let more = if others.len() > NAMED { ", …" } else { "" };
    let usual = USUAL.join(", ");
    match others.is_empty() {
        true => format!("the case gives no number of its bodies, contacts, springs and loads ({usual}, …)"),
        false => {
            format!(
                "the case gives none of {usual}; name numbers that it gives, such as cures = [{named}{more}]"
            )
        }
    }
}

/// The eigenvalue nearest to that of a mode, with a number at another value; in words why there is none.
fn beside(
    of: &AssemblySubject<'_>,
    sweep: &KeySweep,
    value: f64,
    mode: Complex64,
) -> Result<Complex64, String> {
    let family = SweptAssembly::new(of, vec![sweep], true);
    let found = family
        .state(&[value])
        .and_then(|state| family.solved_alone(&state, &band(AROUND[0] * mode.im, AROUND[1] * mode.im)));
    let modes = found.map_err(|error| error.to_string())?.modes;
    let values = modes.iter().map(|own| own.eigenvalue.value);
    let nearest = values.min_by(|a, b| (a - mode).modulus().total_cmp(&(b - mode).modulus()));
    nearest.ok_or_else(|| "the mode was not found beside it".to_owned())
}

fn cure(of: &AssemblySubject<'_>, sweep: &KeySweep, value: f64, mode: Complex64) -> ToldCure {
    let none = ToldCure::none(sweep, value, "");
    let ends = [sweep.values[0], sweep.values[1]].map(|end| beside(of, sweep, end, mode));
    let [low, high] = match ends {
        [Ok(low), Ok(high)] => [low, high],
        [Err(reason), _] | [_, Err(reason)] => return ToldCure { reason, ..none },
    };
    let is_moved = [low, high].iter().any(|end| (end.re - mode.re).abs() > ROUNDING * mode.modulus());
    if !is_moved {
        let reason = "the growth rate does not follow it".to_owned();
        return ToldCure { growth_by_change: Some(0.0), smooth: Some(true), reason, ..none };
    }
    let derivative = (high.re - low.re) / (2.0 * STEP);
    let [down, up] = [(mode.re - low.re) / STEP, (high.re - mode.re) / STEP];
    // what bodies are made of keeps its sign, a parameter, as a temperature, need not
    let is_parameter = sweep.path.split('.').next() == Some(PARAMETERS);
    let least = if is_parameter { f64::NEG_INFINITY } else { -1.0 };
    let change = Some(-mode.re / derivative).filter(|change| change.is_finite() && *change > least);
    let is_smooth = (up - down).abs() <= ALIKE * up.abs().max(down.abs());
    let reason = match (is_smooth, change) {
        (false, _) => {
            "derivatives upwards and downwards differ: contact points change, another mode is near, or what follows from it turns there"
        }
        (_, None) => "it would have to change its sign",
        _ => "",
    };
    let reason = reason.to_owned();
    ToldCure { growth_by_change: Some(derivative), change, smooth: Some(is_smooth), reason, ..none }
}

impl ToldCure {
    /// Of a number that nothing is known of, for a reason.
    fn none(sweep: &KeySweep, value: f64, reason: &str) -> Self {
        Self {
            key: sweep.path.clone(),
            value,
            unit: any_key(&sweep.path, sweep.dimension).unit,
            shown_unit: sweep.shown_unit(),
            growth_by_change: None,
            change: None,
            smooth: None,
            growth_rate_at_change: None,
            cured: None,
            unstable_at_change: None,
            at_change: String::new(),
            reason: reason.to_owned(),
        }
    }

    /// With what its change does.
    fn with_change(self, then: ModesAtChange) -> Self {
        Self {
            growth_rate_at_change: then.growth,
            cured: then.cured,
            unstable_at_change: then.unstable,
            at_change: then.words,
            ..self
        }
    }
}

impl ToldCures {
    /// None, for a reason.
    fn none(reason: String) -> Self {
        Self { frequency_hz: None, growth_rate: None, keys: Vec::new(), reason }
    }

    /// What is to be said of them: of the first few changes that are no cures, and of how many more.
    pub(super) fn doubts(&self) -> Vec<String> {
        const TOLD: usize = 3;
        if !self.reason.is_empty() {
            return vec![format!("no cures are listed: {}", self.reason)];
        }
        let changed = self.keys.iter().filter_map(|own| Some((own, own.change?)));
        let told = |(own, change): (&ToldCure, f64)| {
            format!("with `{}` changed by {}, {}", own.key, per_cent(change), own.at_change)
        };
        let all: Vec<String> = changed.filter(|(own, _)| own.cured != Some(true)).map(told).collect();
        let more = all.len().saturating_sub(TOLD);
        let rest = (more > 0).then(|| format!("{more} more changes told at first order are no known cures"));
        all.into_iter().take(TOLD).chain(rest).collect()
    }
}

/// A change as it is told.
pub(super) fn per_cent(change: f64) -> String {
    format!("{:+.1} %", 100.0 * change).replace('-', "−")
}
