//! Where a cycle is sought that no mode need lead to: at the motion that a march comes to, at a cycle that is stored.

use super::stored::StudyReference;
use crate::assembly::AssemblySubject;
use crate::assembly::build::Unassembled;
use crate::assembly::case::AssemblyCase;
use crate::assembly::case::problem::AssemblyProblem;
use crate::assembly::march::settings::{AssemblyStart, check_steps};
use crate::assembly::march::start::MotionState;
use crate::error::ModelError;
use judder_assembly::steady::SteadySliding;
use judder_cycles::CyclesError;
use judder_cycles::cycle::{AssemblyCycle, CycleSettings};
use judder_cycles::marched::{MarchedSettings, marched_period};
use judder_cycles::near::{ForcesOverPeriod, cycle_near};
use judder_keys::Settings;
use judder_keys::declared::Number;
use judder_keys::dimension::Dimension;
use judder_keys::error::Fault;
use judder_keys::file_reference::FileReference;
use judder_keys::problem::Placed;
use judder_keys::section::Section;
use judder_study::Progress;
use judder_study::model::Refusal;

/// Where a cycle is sought in place of along the motions of a mode.
#[derive(Debug, Clone, PartialEq, Settings)]
pub enum CycleStart {
    /// Near the periodic motion that an implicit march comes to.
    #[key(
        example = "{ step = \"1 us\", duration = \"50 ms\", start = { velocity = [\"1e-2\", \"0\"] } }, or study = \"…\" with an analysis"
    )]
    March(StartingMarch),
    /// From a cycle that is stored.
    Study {
        /// The folder of a finished study, relative to the case file, with a cycle of the same contact points to begin at, in place of a march.
        study: StudyReference,
        /// The `limit-cycle` of the study that has found it.
        #[key(example = "\"…\", the name of a `limit-cycle` of the study")]
        analysis: String,
    },
}

/// A march that comes to a periodic motion.
#[derive(Debug, Clone, PartialEq, Settings)]
#[settings(check = StartingMarch::check)]
pub struct StartingMarch {
    /// The time step.
    #[key(rule = Number::positive(Dimension::TIME), symbol = "h")]
    pub step: f64,
    /// How long it is: the motion has to be periodic in its last quarter.
    #[key(rule = Number::positive(Dimension::TIME))]
    pub duration: f64,
    /// How it begins, beside steady sliding.
    #[key(example = "{ velocity = [\"1e-2\", \"0\"] }, in m/s, or { mode = 1, amplitude = \"1 um\" }")]
    pub start: AssemblyStart,
}

impl CycleStart {
    /// Finds the files of a case; `section` is that of the analysis.
    pub(in crate::assembly) fn find(
        &mut self,
        section: &Section<'_>,
        case: Option<&AssemblyCase>,
    ) -> Result<(), Fault> {
        match (self, case, section.inner("start")?) {
            (Self::Study { study, analysis }, Some(case), Some(inner)) => {
                study.find(&inner, "study", case.folder(), analysis)
            }
            _ => Ok(()),
        }
    }

    /// The files that it names.
    pub(in crate::assembly) fn files(&self) -> Vec<&FileReference> {
        match self {
            Self::March(_) => Vec::new(),
            Self::Study { study, .. } => study.files().iter().collect(),
        }
    }

    /// Refuses a stored cycle of other contact points, or none.
    pub(in crate::assembly) fn fits(
        &self,
        of: &AssemblySubject<'_>,
    ) -> Result<Result<(), Refusal>, ModelError> {
        let Self::Study { study, analysis } = self else { return Ok(Ok(())) };
        let found = study.cycle(analysis, of)?.map(drop);
        Ok(found.map_err(|Unassembled { path, cause }| Refusal::key(path, *cause)))
    }

    /// Where it begins, in words.
    pub(in crate::assembly) fn words(&self) -> String {
        match self {
            Self::March(march) => {
                format!("near the motion of a march of {:.0} steps", (march.duration / march.step).ceil())
            }
            Self::Study { analysis, .. } => format!("from the stored cycle `{analysis}`"),
        }
    }

    /// The cycle that it leads to, or why to none.
    pub(in crate::assembly) fn cycle<'a>(
        &self,
        of: &AssemblySubject<'a>,
        steady: &SteadySliding,
        settings: &CycleSettings,
        progress: &dyn Progress,
    ) -> Result<Result<AssemblyCycle<'a>, CyclesError>, ModelError> {
        let assembly = &of.built.assembly;
        let go_on = || !progress.interrupted();
        let known = match self {
            Self::March(march) => march.period(of, steady, progress)?,
            Self::Study { study, analysis } => Ok(study.cycle(analysis, of)??),
        };
        match known.and_then(|known| cycle_near(assembly, steady, &known, settings, &go_on)) {
            Err(error) if !error.is_of_the_motion() => Err(error.into()),
            found => Ok(found),
        }
    }
}

impl StartingMarch {
    fn check(&mut self, section: &Section<'_>) -> Result<(), Fault> {
        check_steps(self.step, self.duration)
            .map_err(|reason| AssemblyProblem::Refused { reason }.at(section.place_of(&["step"])))
    }

    /// The motion that it comes to.
    fn period(
        &self,
        of: &AssemblySubject<'_>,
        steady: &SteadySliding,
        progress: &dyn Progress,
    ) -> Result<Result<ForcesOverPeriod, CyclesError>, ModelError> {
        let state = MotionState::new(of, [steady, steady], Some(&self.start), 0.0)?;
        let march = MarchedSettings { step: self.step, duration: self.duration };
        let begins = [state.displacement.as_slice(), &state.velocity];
        Ok(marched_period(&of.built.assembly, steady, begins, &march, &|| !progress.interrupted()))
    }
}
