//! What would keep the leading mode from growing: derivatives of its growth rate by numbers of the case.

use super::settings::AskedCures;
use crate::assembly::AssemblySubject;
use crate::assembly::case::AssemblyCase;
use crate::assembly::eigen::band;
use crate::assembly::swept::{SWEPT, SweptAssembly};
use crate::error::ModelError;
use crate::key_sweep::KeySweep;
use judder_keys::dimension::Dimension;
use judder_keys::quantity::WrittenUnit;
use judder_store::Results;
use judder_study::Progress;
use judder_study::case::scale::Spacing;
use judder_study::labels::any_key;
use num_complex::Complex64;
use rayon::prelude::*;
use std::f64::consts::TAU;

/// By how much of itself a number is changed for its derivative.
const STEP: f64 = 1e-3;
/// By how much derivatives upwards and downwards may differ, of the larger.
const ALIKE: f64 = 0.1;
/// By how much of itself the best number is changed to see whether the first order holds, at most, and what the change of the growth rate may be off then.
const TRIED: f64 = 0.05;
const HOLDS: f64 = 0.2;
/// What rounding may change of the growth rate, of the modulus of the eigenvalue.
const ROUNDING: f64 = 1e-11;
/// Frequencies around the mode in which it is sought again.
const AROUND: [f64; 2] = [0.97, 1.03];

/// How the growth rate of a mode follows the numbers of the case.
#[derive(Clone, Results)]
pub(super) struct ToldCures {
    /// frequency of the mode about steady sliding; none where none grows
    frequency_hz: Option<f64>,
    /// its growth rate, in 1/s
    growth_rate: Option<f64>,
    /// each number of the case, the one that has to change least first
    keys: Vec<ToldCure>,
    /// the first of them changed a little, and the mode computed anew
    check: Option<ToldCheck>,
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
    /// what the growth rate gains with the number's relative change, in 1/s; none where the mode was not found beside it
    growth_by_change: Option<f64>,
    /// the relative change that takes the growth rate to zero at first order; none where that would take the number below zero
    change: Option<f64>,
    /// whether the derivative is the same upwards and downwards
    smooth: Option<bool>,
    /// why there is none
    reason: String,
}

/// Whether the first order holds.
#[derive(Clone, Results)]
struct ToldCheck {
    /// the number that was changed
    key: String,
    /// by how much of itself
    change: f64,
    /// the growth rate that the derivative says, in 1/s
    predicted: f64,
    /// that of the mode computed anew, in 1/s
    found: f64,
    /// whether they agree to a fifth of the change
    holds: bool,
}

/// The cures of the mode with this eigenvalue, which leads those that grow.
pub(super) fn cures(
    of: &AssemblySubject<'_>,
    asked: &AskedCures,
    mode: Option<Complex64>,
    progress: &dyn Progress,
) -> Result<ToldCures, ModelError> {
    let Some(mode) = mode else {
        return Ok(ToldCures::none("no mode of the band grows".to_owned()));
    };
    let paths: Vec<String> = match asked {
        AskedCures::Keys(paths) => paths.clone(),
        AskedCures::Usual => of.case.numbers().into_iter().filter(|path| is_usual(path)).collect(),
    };
    if paths.is_empty() {
        let (frequency_hz, growth_rate) = (Some(mode.im / TAU), Some(mode.re));
        return Ok(ToldCures { frequency_hz, growth_rate, ..ToldCures::none(without_usual(of)) });
    }
    let sought = |path: &String| -> Result<Option<(ToldCure, KeySweep)>, ModelError> {
        progress.go_on()?;
        let Some((value, dimension)) = of.case.number(path) else { return Ok(None) };
        let sweep = around(of.case, path, (value, dimension));
        let found = match value == 0.0 {
            true => ToldCure::none(&sweep, value, "it is zero, of which there is no relative change"),
            false => cure(of, &sweep, value, mode),
        };
        Ok(Some((found, sweep)))
    };
    // all of them, so that of several errors the first is told
    let found: Vec<Result<Option<(ToldCure, KeySweep)>, ModelError>> = paths.par_iter().map(sought).collect();
    let mut found: Vec<(ToldCure, KeySweep)> =
        found.into_iter().filter_map(Result::transpose).collect::<Result<_, _>>()?;
    // those whose first order says little come last, since the first is tried
    let place = |own: &ToldCure| (own.smooth != Some(true), own.change.map_or(f64::INFINITY, f64::abs));
    found.sort_by(|(a, _), (b, _)| {
        let ((a_is_rough, a), (b_is_rough, b)) = (place(a), place(b));
        a_is_rough.cmp(&b_is_rough).then(a.total_cmp(&b))
    });
    let check = found.first().and_then(|(best, sweep)| checked(of, best, sweep, mode));
    Ok(ToldCures {
        frequency_hz: Some(mode.im / TAU),
        growth_rate: Some(mode.re),
        reason: String::new(),
        keys: found.into_iter().map(|(own, _)| own).collect(),
        check,
    })
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
    let nearest = values.min_by(|a, b| (a - mode).norm().total_cmp(&(b - mode).norm()));
    nearest.ok_or_else(|| "the mode was not found beside it".to_owned())
}

fn cure(of: &AssemblySubject<'_>, sweep: &KeySweep, value: f64, mode: Complex64) -> ToldCure {
    let none = ToldCure::none(sweep, value, "");
    let ends = [sweep.values[0], sweep.values[1]].map(|end| beside(of, sweep, end, mode));
    let [low, high] = match ends {
        [Ok(low), Ok(high)] => [low, high],
        [Err(reason), _] | [_, Err(reason)] => return ToldCure { reason, ..none },
    };
    let is_moved = [low, high].iter().any(|end| (end.re - mode.re).abs() > ROUNDING * mode.norm());
    if !is_moved {
        let reason = "the growth rate does not follow it".to_owned();
        return ToldCure { growth_by_change: Some(0.0), smooth: Some(true), reason, ..none };
    }
    let derivative = (high.re - low.re) / (2.0 * STEP);
    let [down, up] = [(mode.re - low.re) / STEP, (high.re - mode.re) / STEP];
    let change = Some(-mode.re / derivative).filter(|change| change.is_finite() && *change > -1.0);
    let is_smooth = (up - down).abs() <= ALIKE * up.abs().max(down.abs());
    let reason = match (is_smooth, change) {
        (false, _) => {
            "derivatives upwards and downwards differ: contact points change, or another mode is near"
        }
        (_, None) => "it would have to fall below zero",
        _ => "",
    };
    let reason = reason.to_owned();
    ToldCure { growth_by_change: Some(derivative), change, smooth: Some(is_smooth), reason, ..none }
}

/// The mode with the best number changed as far as it must, or a little.
fn checked(
    of: &AssemblySubject<'_>,
    best: &ToldCure,
    sweep: &KeySweep,
    mode: Complex64,
) -> Option<ToldCheck> {
    let (change, derivative) = (best.change?.clamp(-TRIED, TRIED), best.growth_by_change?);
    let found = beside(of, sweep, best.value * (1.0 + change), mode).ok()?.re;
    let predicted = mode.re + derivative * change;
    let holds = (found - predicted).abs() <= HOLDS * (derivative * change).abs();
    Some(ToldCheck { key: best.key.clone(), change, predicted, found, holds })
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
            reason: reason.to_owned(),
        }
    }
}

impl ToldCures {
    /// None, for a reason.
    fn none(reason: String) -> Self {
        Self { frequency_hz: None, growth_rate: None, keys: Vec::new(), check: None, reason }
    }

    /// What is to be said of them.
    pub(super) fn doubt(&self) -> Option<String> {
        if !self.reason.is_empty() {
            return Some(format!("no cures are listed: {}", self.reason));
        }
        let check = self.check.as_ref().filter(|own| !own.holds)?;
        Some(format!(
            "with `{}` changed by {:.1} % the mode grows with {:.4} 1/s and not {:.4}: the first order does not hold so far",
            check.key,
            100.0 * check.change,
            check.found,
            check.predicted,
        ))
    }
}
