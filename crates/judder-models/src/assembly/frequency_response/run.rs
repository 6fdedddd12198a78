//! The response, and what is to be said of it.

use super::arrays::{dataset, table};
use super::followed::FollowedCoordinate;
use super::settings::FrequencyResponse;
use super::told::{ToldPeak, ToldResponse, end, peak_of};
use crate::assembly::AssemblySubject;
use crate::assembly::limit_cycle::stability::KnownStability;
use crate::error::ModelError;
use judder_assembly::AssemblyError;
use judder_assembly::steady::SteadySliding;
use judder_cycles::CyclesError;
use judder_cycles::balance::HarmonicBalance;
use judder_cycles::cycle::points;
use judder_cycles::forced::{ForcedResponse, ResponseEnd, forced_response};
use judder_cycles::power::power;
use judder_numerics::parallel;
use judder_store::Results;
use judder_study::Progress;
use judder_study::outcome::{CheckRecord, Disagreement, Outcome};
use std::f64::consts::TAU;

/// Instants at which the energy over a period is looked at, at least.
const INSTANTS: usize = 4000;
/// What the balance of energy may be off, over what goes in and out.
const BALANCE: f64 = 1e-3;
/// Rows of the eigenvalue problem of Hill's method up to which every motion has its opinion: hundredths of a second each.
pub(super) const ROWS: usize = 200;

pub(super) fn run(
    of: &AssemblySubject<'_>,
    asked: &FrequencyResponse,
    progress: &dyn Progress,
) -> Result<Outcome, ModelError> {
    let steady = start(of)?;
    let force = asked.force(of)?;
    let [from, to] = asked.frequency;
    let assembly = &of.built.assembly;
    let balance = HarmonicBalance::new(assembly, &steady, 0.5 * (from + to), asked.series(), &[force])
        .map_err(unanswered)?;
    let guess = balance.steady(&steady);
    let found = forced_response(&balance, &guess, &asked.settings(), &|| !progress.interrupted())
        .map_err(unanswered)?;
    progress.go_on()?;
    let of_motion = |motion| {
        KnownStability::of(&balance, motion, asked.stability, progress)?
            .and_by_hill(&balance, motion, ROWS, progress)
    };
    let stabilities = parallel::try_each(&found.motions, of_motion)?;
    let coordinates = FollowedCoordinate::all(&of.built.watched, &balance, &found)?;
    let (mut peaks, mut disagreement) = (Vec::new(), Disagreement::default());
    for own in &coordinates {
        let motion = &found.motions[peak_of(own)];
        let (_, quality) = points(&balance, motion)?;
        disagreement.add(power(&balance, motion, INSTANTS)?.imbalance());
        peaks.push((own.name.clone(), ToldPeak::new(&found, own, quality, balance.force_scale())));
    }
    let coarse = coordinates.iter().filter_map(coarse);
    let warnings =
        [of.doubts(&steady), words(&found, &peaks), unknown(asked, &stabilities), coarse.collect()].concat();
    let told = ToldResponse::new(&found, asked.harmonics, balance.force_scale(), peaks, &stabilities);
    Ok(Outcome {
        scalars: told.scalars(),
        dataset: dataset(asked, &found, &coordinates, &stabilities)?,
        table: Some(table(&found, &coordinates)?),
        checks: checks(asked, &found, disagreement),
        missing: usize::from(found.end != ResponseEnd::Range),
        warnings,
        ..Outcome::default()
    })
}

/// Why there is no response at all.
fn unanswered(error: CyclesError) -> ModelError {
    match error.into() {
        ModelError::AssemblyCycle(error) => ModelError::Response(Box::new(error)),
        other => other,
    }
}

/// Where the motions begin: steady sliding; what nothing presses together, as it is meshed.
fn start(of: &AssemblySubject<'_>) -> Result<SteadySliding, ModelError> {
    match of.steady_to_march() {
        Err(ModelError::Assembly(AssemblyError::NothingCloses { .. })) => {
            Ok(SteadySliding::as_meshed(&of.built.assembly))
        }
        other => other,
    }
}

/// What is to be said of a response.
fn words(found: &ForcedResponse, peaks: &[(String, ToldPeak)]) -> Vec<String> {
    let mut words = Vec::new();
    if found.end != ResponseEnd::Range {
        words.push(format!("the response ends before it leaves the range of frequencies: {}", end(found)));
    }
    for (name, own) in peaks {
        if !own.converged {
            words.push(format!(
                "at the peak of {name} the harmonics leave {:.1} % of the swing of the contact forces out: give more `harmonics`",
                100.0 * own.left_out
            ));
        }
    }
    words
}

/// That stability is not known of all motions of which it was asked for.
fn unknown(asked: &FrequencyResponse, stabilities: &[KnownStability]) -> Vec<String> {
    let count = stabilities.iter().filter(|own| asked.stability && own.is_stable().is_none()).count();
    let words = || {
        format!(
            "whether motions nearby are drawn to it is not known of {count} of {} motions",
            stabilities.len()
        )
    };
    (count > 0).then(words).into_iter().collect()
}

/// A peak that is narrow beside the steps: what lies between its motions may be higher.
fn coarse(own: &FollowedCoordinate) -> Option<String> {
    /// Of the amplitude at the peak, what its neighbours have at least.
    const NEAR: f64 = 0.7;
    let place = peak_of(own);
    let amplitude = |k: usize| own.measures.get(k).map(|[amplitude, ..]| *amplitude);
    let (peak, before, after) = (amplitude(place)?, amplitude(place.checked_sub(1)?)?, amplitude(place + 1)?);
    (before.min(after) < NEAR * peak).then(|| {
        let share = 100.0 * before.min(after) / peak;
        format!(
            "beside the peak of {} the next motion has {share:.0} % of its amplitude: a higher one may lie between them, give a shorter `longest_step`",
            own.name
        )
    })
}

/// The equations of all motions, and the energy over a period of those at peaks.
fn checks(asked: &FrequencyResponse, found: &ForcedResponse, energy: Disagreement) -> Vec<CheckRecord> {
    let rule = asked.settings().rule;
    let [from, to] = asked.frequency.map(|own| own / TAU);
    vec![
        CheckRecord::new(
            "harmonics of the contact forces are those that the contact laws make of the motion",
            format!(
                "largest residual over the force scale, {} harmonics, {} motions between {from:.6} and {to:.6} Hz",
                asked.harmonics,
                found.motions.len(),
            ),
            found.motions.iter().map(|own| own.residual).collect(),
            rule.tolerance,
        ),
        CheckRecord::new(
            "over a period what drives gives what damping and friction take",
            format!(
                "works of the forces that swing, of damping, of the contact laws at {INSTANTS} instants, at the peaks, over what goes in and out"
            ),
            energy,
            BALANCE,
        ),
    ]
}
