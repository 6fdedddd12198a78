//! One module a kind of analysis; each turns a case and its settings into an [`Outcome`].

mod axis;
pub(crate) mod contact;
mod critical;
mod equivalent_damping;
mod law_errors;
mod margins;
mod motion;
mod sliding;
mod spectrum;
mod stability_map;
pub(crate) mod steady_states;
mod structure;
mod two_degrees;

pub(crate) use axis::Axis;
pub(crate) use margins::NOT_KNOWN;
pub use motion::MotionBlock;
pub(crate) use motion::{becomes, belt};
pub(crate) use sliding::locus_conditions;
pub use stability_map::{BoundaryCurves, BoundaryKind, boundary_curves};
pub(crate) use stability_map::{NONE_MOVED, ONE_WAY, STARTS_IT, UNKNOWN, WITHIN_LAW, class_name};
pub(crate) use steady_states::SteadyState;

use crate::bridge::{self, CaseContact};
use crate::error::StudyError;
use crate::kept::Kept;
use crate::known_substrate::KnownSubstrate;
use crate::outcome::Outcome;
use crate::progress::Progress;
use crate::quasi_steady::{Condition, corners, of_motions};
use crate::sliding::SlidingSystem;
use crate::structure::Structure;
use judder_case::{
    Case, Family, MapMethod, OscillatorAnalysis, OscillatorCase, OscillatorKey, Sweep, Within,
};
use judder_contact::law::sweep::SolvedPoint;
use judder_oscillator::Contact;
use motion::{BeltModel, OscillatorModel};
use std::sync::Arc;

/// The names of the analyses of a case, in its order.
#[must_use]
pub fn names(case: &Case) -> Vec<String> {
    match case {
        Case::Oscillator(case) => case.analyses.iter().map(|a| a.name.clone()).collect(),
        Case::Contact(case) => case.analyses.iter().map(|a| a.name.clone()).collect(),
        Case::Belt(case) => case.analyses.iter().map(|a| a.name.clone()).collect(),
        Case::TwoDegrees(case) => case.analyses.iter().map(|a| a.name.clone()).collect(),
        Case::Structure(case) => case.analyses.iter().map(|a| a.name.clone()).collect(),
        Case::Sliding(case) => case.analyses.iter().map(|a| a.name.clone()).collect(),
    }
}

/// How many steps the analysis at `index` announces to its progress.
#[must_use]
pub fn steps(case: &Case, index: usize) -> usize {
    let curves = |family: &Option<judder_case::Family<_>>| family.as_ref().map_or(1, |f| f.values.len());
    match case {
        Case::Oscillator(case) => match &case.analyses[index].kind {
            OscillatorAnalysis::EquivalentDamping { sweep, family }
            | OscillatorAnalysis::Spectrum { sweep, family }
            | OscillatorAnalysis::CriticalShearStrength { sweep, family, .. }
            | OscillatorAnalysis::CriticalLoad { sweep, family, .. } => sweep.points * curves(family),
            // the decisions and the boundaries are a step each, the growth rates one a row
            OscillatorAnalysis::StabilityMap(map) if map.method == MapMethod::EveryPoint => 2 + map.y.points,
            OscillatorAnalysis::StabilityMap(_) => 2,
            OscillatorAnalysis::Motion(kind) => motion::steps(kind),
            OscillatorAnalysis::Engines(settings) => motion::engines::steps(settings),
        },
        Case::Contact(case) => contact::steps(&case.analyses[index].kind),
        Case::Belt(case) => motion::steps(&case.analyses[index].kind),
        Case::TwoDegrees(_) => 1,
        Case::Sliding(case) => sliding::steps(&case.analyses[index].kind),
        Case::Structure(case) => structure::steps(&case.analyses[index].kind),
    }
}

/// Runs the analysis at `index` of a case.
///
/// # Errors
/// [`StudyError::Interrupted`], or arrays that the store refuses.
pub fn run(case: &Case, index: usize, progress: &dyn Progress) -> Result<Outcome, StudyError> {
    run_alone((case, &Prepared::new(case)?), index, progress)
}

/// Runs the analysis at `index` of a case in no study folder: nothing is kept, and nothing is known from before.
pub(crate) fn run_alone(
    (case, prepared): (&Case, &Prepared),
    index: usize,
    progress: &dyn Progress,
) -> Result<Outcome, StudyError> {
    run_from((case, prepared), index, (Kept::NOTHING, Kept::NOTHING), progress)
}

/// Runs the analysis at `index` of a case; it goes on from what an interrupted run has kept of the law that the analyses of an
/// oscillator case share, and of this analysis.
pub(crate) fn run_from(
    (case, prepared): (&Case, &Prepared),
    index: usize,
    (law, own): (Kept<'_>, Kept<'_>),
    progress: &dyn Progress,
) -> Result<Outcome, StudyError> {
    match case {
        Case::Oscillator(case) => in_contact(case, index, (law, progress), |case, contact| {
            oscillator((case, contact), &case.analyses[index].kind, own, progress)
        }),
        Case::Contact(case) => contact::run(case, &case.analyses[index], own, progress),
        Case::Belt(case) => motion::run(&BeltModel::new(case), &case.analyses[index].kind, own, progress),
        Case::TwoDegrees(case) => two_degrees::run(case, &case.analyses[index].kind, progress),
        Case::Sliding(case) => match prepared {
            Prepared::Sliding(system) => sliding::run((case, system), &case.analyses[index], own, progress),
            _ => sliding::run((case, &SlidingSystem::new(case)?), &case.analyses[index], own, progress),
        },
        Case::Structure(case) => match prepared {
            Prepared::Structure(built) => structure::run((case, built), &case.analyses[index], progress),
            _ => structure::run((case, &Structure::new(case)?), &case.analyses[index], progress),
        },
    }
}

/// Runs the analysis at `index` of a case as [`run`] does; one of kind `motion` hands its samples to `watch` while it is computed.
///
/// # Errors
/// As [`run`].
pub fn run_watched(
    case: &Case,
    index: usize,
    progress: &dyn Progress,
    watch: &mut dyn FnMut(MotionBlock),
) -> Result<Outcome, StudyError> {
    match case {
        Case::Oscillator(case) => in_contact(case, index, (Kept::NOTHING, progress), |case, contact| {
            match &case.analyses[index].kind {
                OscillatorAnalysis::Motion(kind) => motion::run_watched(
                    &OscillatorModel { inputs: &case.inputs, contact },
                    kind,
                    progress,
                    watch,
                ),
                kind => oscillator((case, contact), kind, Kept::NOTHING, progress),
            }
        }),
        Case::Belt(case) => {
            motion::run_watched(&BeltModel::new(case), &case.analyses[index].kind, progress, watch)
        }
        _ => run(case, index, progress),
    }
}

/// Runs the analysis at `index` of an oscillator case in its contact, whose law goes on from the points that are kept.
fn in_contact(
    case: &OscillatorCase,
    index: usize,
    (law, progress): (Kept<'_>, &dyn Progress),
    analysis: impl FnOnce(&OscillatorCase, &Contact) -> Result<Outcome, StudyError>,
) -> Result<Outcome, StudyError> {
    let case = &bridge::with_material(case)?;
    let points = law.known();
    let keep = |point: &SolvedPoint| law.add(point);
    let CaseContact { contact, warnings } = bridge::contact(case, (&points, &keep), progress)?;
    let mut outcome = analysis(case, &contact)?;
    outcome.warnings.extend(warnings);
    let (kind, substrate) = (&case.analyses[index].kind, KnownSubstrate::of(case)?);
    outcome.warnings.extend(substrate.band_warning(&contact, corners(&case.inputs, kind)));
    outcome.warnings.extend(substrate.temperature_warning);
    if let Some(condition) = Condition::of_analysis((case, &substrate.terms), &contact, kind) {
        outcome.warnings.extend(condition.warning(of_motions(&outcome.scalars)));
        outcome.scalars.extend(condition.scalars());
    }
    Ok(outcome)
}

/// What all analyses of a case share that takes time to make.
pub(crate) enum Prepared {
    /// Nothing.
    Nothing,
    /// The structure of a structure case.
    Structure(Arc<Structure>),
    /// The pair of a sliding case.
    Sliding(Box<SlidingSystem>),
}

impl Prepared {
    /// What the analyses of a case share.
    fn new(case: &Case) -> Result<Self, StudyError> {
        match case {
            Case::Structure(case) => Ok(Self::Structure(Arc::new(Structure::new(case)?))),
            Case::Sliding(case) => Ok(Self::Sliding(Box::new(SlidingSystem::new(case)?))),
            _ => Ok(Self::Nothing),
        }
    }
}

fn oscillator(
    (case, contact): (&OscillatorCase, &Contact),
    analysis: &OscillatorAnalysis,
    kept: Kept<'_>,
    progress: &dyn Progress,
) -> Result<Outcome, StudyError> {
    match analysis {
        OscillatorAnalysis::EquivalentDamping { sweep, family } => {
            equivalent_damping::run((case, contact), sweep, family.as_ref(), progress)
        }
        OscillatorAnalysis::Spectrum { sweep, family } => {
            spectrum::run((case, contact), sweep, family.as_ref(), progress)
        }
        OscillatorAnalysis::CriticalShearStrength { sweep, within, family, global_margin } => {
            let settings = critical_settings(sweep, within, family, *global_margin);
            critical::run((case, contact), critical::Sought::ShearStrength, &settings, progress)
        }
        OscillatorAnalysis::CriticalLoad { sweep, within, family, global_margin } => {
            let settings = critical_settings(sweep, within, family, *global_margin);
            critical::run((case, contact), critical::Sought::Load, &settings, progress)
        }
        OscillatorAnalysis::StabilityMap(map) => stability_map::run((case, contact), map, progress),
        OscillatorAnalysis::Motion(kind) => {
            motion::run(&OscillatorModel { inputs: &case.inputs, contact }, kind, kept, progress)
        }
        OscillatorAnalysis::Engines(settings) => {
            motion::engines::run(&OscillatorModel { inputs: &case.inputs, contact }, settings, progress)
        }
    }
}

fn critical_settings<'a>(
    sweep: &'a Sweep<OscillatorKey>,
    within: &'a Within,
    family: &'a Option<Family<OscillatorKey>>,
    global_margin: bool,
) -> critical::Settings<'a> {
    critical::Settings { sweep, within, family: family.as_ref(), global_margin }
}
