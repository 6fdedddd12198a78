//! What is told of a response.

use super::followed::FollowedCoordinate;
use crate::assembly::limit_cycle::search::is_converged;
use crate::assembly::limit_cycle::stability::{KnownStability, SecondOpinion, crossing_words};
use judder_cycles::cycle::CycleQuality;
use judder_cycles::forced::{ForcedResponse, ResponseEnd};
use judder_cycles::stability::stability_changes;
use judder_numerics::words::plain;
use judder_store::{ByName, Results};
use std::f64::consts::TAU;

/// What is told of a response.
#[derive(Results)]
pub(super) struct ToldResponse {
    /// motions along the branch
    points: usize,
    /// why it ends there
    end: String,
    /// harmonics beside the mean
    harmonics: usize,
    /// where the frequency turns, in the order along the branch
    folds: Vec<ToldFold>,
    /// of each observed coordinate, the largest of what is told of it along the branch
    peaks: ByName<ToldPeak>,
    /// the largest residual of a motion: harmonics of the contact forces beside those that the contact laws make of it, over `force_scale`
    #[result(unit = "1")]
    residual: f64,
    /// what residuals are measured by
    #[result(unit = "N")]
    force_scale: f64,
    /// how many motions are stable, in words
    stability: String,
    /// at how many of them Hill's method says the same, in words
    second_opinion: String,
    /// where the stability changes, and how, as far as Floquet multipliers were asked for
    stability_changes: Vec<ToldStabilityChange>,
}

/// Where multipliers cross the unit circle.
#[derive(Results)]
struct ToldStabilityChange {
    kind: &'static str,
    /// frequencies of the motions before and after it, in the order along the branch
    between_hz: Vec<f64>,
}

/// Where the frequency turns.
#[derive(Results)]
struct ToldFold {
    frequency_hz: f64,
}

/// A coordinate where it swings most, by parabolas through three motions.
#[derive(Results)]
pub(super) struct ToldPeak {
    /// amplitude of the first harmonic
    #[result(unit = "m")]
    amplitude: f64,
    /// frequency at which it is largest
    frequency_hz: f64,
    /// root mean square with the mean
    #[result(unit = "m")]
    rms: f64,
    rms_frequency_hz: f64,
    /// root mean square about the mean
    #[result(unit = "m")]
    rms_about_mean: f64,
    rms_about_mean_frequency_hz: f64,
    /// largest magnitude
    #[result(unit = "m")]
    largest: f64,
    largest_frequency_hz: f64,
    /// whether the amplitude is largest at an end of the branch: beyond it may be a larger one
    at_end: bool,
    /// where the amplitude is largest, the share of the swing of the contact forces beyond the harmonics
    pub(super) left_out: f64,
    /// whether that is no more than a tenth
    pub(super) converged: bool,
    /// there, how far forces are off their laws between the instants of the balance
    #[result(unit = "N")]
    between_samples: f64,
}

/// The motion in which the amplitude of a coordinate is largest.
pub(super) fn peak_of(coordinate: &FollowedCoordinate) -> usize {
    most(coordinate, 0)
}

fn most(coordinate: &FollowedCoordinate, measure: usize) -> usize {
    let all = &coordinate.measures;
    // of equal ones the first
    (0..all.len()).rev().max_by(|a, b| all[*a][measure].total_cmp(&all[*b][measure])).unwrap_or(0)
}

impl ToldPeak {
    pub(super) fn new(
        found: &ForcedResponse,
        own: &FollowedCoordinate,
        quality: CycleQuality,
        force_scale: f64,
    ) -> Self {
        let of = |measure: usize| {
            let (value, frequency) =
                found.highest(most(own, measure), &|motion| own.measures[motion][measure]);
            (value, frequency / TAU)
        };
        let [(amplitude, frequency_hz), (rms, rms_frequency_hz)] = [0, 1].map(of);
        let [(rms_about_mean, rms_about_mean_frequency_hz), (largest, largest_frequency_hz)] = [2, 3].map(of);
        let place = peak_of(own);
        Self {
            amplitude,
            frequency_hz,
            rms,
            rms_frequency_hz,
            rms_about_mean,
            rms_about_mean_frequency_hz,
            largest,
            largest_frequency_hz,
            at_end: place == 0 || place + 1 == found.motions.len(),
            left_out: quality.left_out,
            converged: is_converged(quality.left_out),
            between_samples: force_scale * quality.between_samples,
        }
    }
}

impl ToldResponse {
    pub(super) fn new(
        found: &ForcedResponse,
        harmonics: usize,
        force_scale: f64,
        peaks: Vec<(String, ToldPeak)>,
        stabilities: &[KnownStability],
    ) -> Self {
        // a change lies between motions of which both ways together decide
        let decided = |own: &'_ KnownStability| own.is_stable().is_some();
        let multipliers: Vec<_> =
            stabilities.iter().map(|own| own.known().filter(|_| decided(own))).collect();
        let frequency = |motion: usize| found.motions[motion].turning.frequency / TAU;
        let changes = stability_changes(&multipliers).into_iter().map(|own| ToldStabilityChange {
            kind: crossing_words(own.crossing),
            between_hz: own.between.map(frequency).to_vec(),
        });
        Self {
            points: found.motions.len(),
            end: end(found),
            harmonics,
            folds: found.folds.iter().map(|(_, own)| ToldFold { frequency_hz: own / TAU }).collect(),
            peaks: peaks.into_iter().collect(),
            residual: found.motions.iter().map(|own| own.residual).fold(0.0, f64::max),
            force_scale,
            stability: how_many(stabilities),
            second_opinion: second_opinions(stabilities),
            stability_changes: changes.collect(),
        }
    }
}

/// How many motions are stable, in words.
fn how_many(stabilities: &[KnownStability]) -> String {
    let count = |of: Option<bool>| stabilities.iter().filter(|own| own.is_stable() == of).count();
    match stabilities.iter().any(KnownStability::is_asked) {
        true => {
            format!("{} stable, {} unstable, {} unknown", count(Some(true)), count(Some(false)), count(None))
        }
        false => "not asked for".to_owned(),
    }
}

/// At how many motions Hill's method says the same of the stability, in words.
fn second_opinions(stabilities: &[KnownStability]) -> String {
    let both: Vec<SecondOpinion> = stabilities.iter().filter_map(KnownStability::opinion).collect();
    let count = |of: SecondOpinion| both.iter().filter(|own| **own == of).count();
    match stabilities.iter().any(KnownStability::is_asked) {
        true => format!(
            "Hill's method says the same of {}, the contrary of {}, only one of both decides of {}, and it does not apply to {}",
            count(SecondOpinion::Same),
            count(SecondOpinion::Contrary),
            count(SecondOpinion::OneDecides),
            stabilities.len() - both.len()
        ),
        false => "not asked for".to_owned(),
    }
}

/// Why a response ends, in words.
pub(super) fn end(found: &ForcedResponse) -> String {
    let last = found.motions.last().map_or(0.0, |own| own.turning.frequency / TAU);
    match &found.end {
        ResponseEnd::Range => "it leaves the range of frequencies".to_owned(),
        ResponseEnd::Points => {
            format!("it has as many motions as `points` allows, the last at {} Hz", plain(last))
        }
        ResponseEnd::Lost(error) => format!("beyond {} Hz no motion was found: {error}", plain(last)),
    }
}
