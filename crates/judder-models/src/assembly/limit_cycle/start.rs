//! Where a cycle is sought that no mode leads to: at the motion that a march comes to.

use crate::assembly::AssemblySubject;
use crate::assembly::march::settings::AssemblyStart;
use crate::assembly::march::start::MotionState;
use crate::error::ModelError;
use judder_assembly::steady::SteadySliding;
use judder_cycles::CyclesError;
use judder_cycles::cycle::{AssemblyCycle, CycleSettings};
use judder_cycles::marched::{MarchedSettings, marched_period};
use judder_cycles::near::cycle_near;
use judder_keys::Settings;
use judder_keys::declared::Number;
use judder_keys::dimension::Dimension;
use judder_study::Progress;

/// Where a cycle is sought in place of along the motions of a mode.
#[derive(Debug, Clone, PartialEq, Settings)]
pub struct CycleStart {
    /// Near the periodic motion that an implicit march comes to.
    #[key(example = "{ step = \"1 us\", duration = \"50 ms\", start = { velocity = [\"1e-2\", \"0\"] } }")]
    pub march: StartingMarch,
}

/// A march that comes to a periodic motion.
#[derive(Debug, Clone, PartialEq, Settings)]
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
    /// The cycle that it leads to, or why to none.
    pub(in crate::assembly) fn cycle<'a>(
        &self,
        of: &AssemblySubject<'a>,
        steady: &SteadySliding,
        settings: &CycleSettings,
        progress: &dyn Progress,
    ) -> Result<Result<AssemblyCycle<'a>, CyclesError>, ModelError> {
        let built = of.built;
        let go_on = || !progress.interrupted();
        let state = MotionState::new(of, [steady, steady], Some(&self.march.start), 0.0)?;
        let march = MarchedSettings { step: self.march.step, duration: self.march.duration };
        let begins = [state.displacement.as_slice(), &state.velocity];
        let found = marched_period(&built.assembly, steady, begins, &march, &go_on)
            .and_then(|known| cycle_near(&built.assembly, steady, &known, settings, &go_on));
        match found {
            Err(error) if !error.is_of_the_motion() => Err(error.into()),
            found => Ok(found),
        }
    }
}
