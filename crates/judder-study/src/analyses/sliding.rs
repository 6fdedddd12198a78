//! The analyses of a sliding case.

mod growth;
mod locus;
mod march;
mod spectrogram;

pub(crate) use locus::conditions as locus_conditions;

use crate::error::StudyError;
use crate::kept::Kept;
use crate::outcome::Outcome;
use crate::progress::Progress;
use crate::sliding::{SlidingSystem, alone};
use judder_case::sliding::locus::Along;
use judder_case::sliding::march::March;
use judder_case::sliding::observe::ObservedPoint;
use judder_case::{Analysis, SlidingAnalysis, SlidingCase};
use judder_sliding::motion::Motion;
use judder_sliding::pair::Pair;

/// What marches, and how it is asked to.
pub(crate) struct Marched<'a> {
    /// The name of the analysis.
    pub(crate) name: &'a str,
    /// What the case asks for.
    pub(crate) march: &'a March,
    /// The slider and its track.
    pub(crate) pair: &'a Pair,
    /// The points whose motion is kept.
    pub(crate) points: &'a [ObservedPoint],
    /// What is prescribed, from the start of the march to its end.
    pub(crate) motion: Motion,
}

/// How many steps an analysis announces.
pub(super) fn steps(kind: &SlidingAnalysis) -> usize {
    match kind {
        SlidingAnalysis::Locus(settings) => match &settings.along {
            Along::Positions(positions) => positions.points,
            Along::Key { sweep, .. } => sweep.values.len(),
        },
        _ => 1,
    }
}

pub(super) fn run(
    (case, system): (&SlidingCase, &SlidingSystem),
    analysis: &Analysis<SlidingAnalysis>,
    kept: Kept<'_>,
    progress: &dyn Progress,
) -> Result<Outcome, StudyError> {
    if progress.interrupted() {
        return Err(StudyError::Interrupted);
    }
    let mut outcome = match &analysis.kind {
        SlidingAnalysis::Modes { structure, modes: sought } => {
            let part = &system.parts[*structure];
            let own = (&alone(case, *structure), &*part.structure);
            let reduced = Some(&part.reduced.body.eigenvalues[..]);
            let outcome = super::structure::modes(own, &analysis.name, sought.wanted(), reduced)?;
            progress.advance();
            outcome
        }
        SlidingAnalysis::Locus(settings) => locus::run((case, system), settings, progress)?,
        SlidingAnalysis::Growth(settings) => growth::run((case, system), settings, progress)?,
        SlidingAnalysis::March(asked) => {
            let motion = Motion { start: asked.from, end: asked.to, ..system.motion };
            let (name, pair, points) = (analysis.name.as_str(), &system.pair, case.points.as_slice());
            march::run(&Marched { name, march: asked, pair, points, motion }, kept, progress)?
        }
        SlidingAnalysis::Spectrogram(asked) => {
            let outcome = spectrogram::run((&analysis.name, asked), &case.points, kept.place)?;
            progress.advance();
            outcome
        }
    };
    outcome.warnings.extend(system.warnings.iter().cloned());
    Ok(outcome)
}
