//! `engines`: one cycle by events, by time-stepping and with a smoothed sign.

mod figure;
mod ladder;
mod reached;
mod run;
pub mod settings;

use super::{KnownOscillator, Operated, OscillatorSubject};
use crate::error::ModelError;
use crate::estimate::{Estimate, cost};
use crate::motion::USUAL_TIME;
use crate::motion::model::OscillatorModel;
use crate::oscillator::case::OscillatorCase;
use crate::oscillator::case::swept_keys::OscillatorKeys;
use crate::oscillator::engines::settings::EnginesSettings;
use judder_keys::declared::Settings;
use judder_keys::numeric_key::Form;
use judder_store::{Declared, Results};
use judder_study::case::analysis::{Kind, Picture};
use judder_study::model::{Analysis, Task};
use judder_study::outcome::Outcome;
use run::ToldEngines;
use serde_json::{Map, Value as Json};
use std::sync::Arc;

/// The kind.
pub(crate) const KIND: Kind<OscillatorKeys, Arc<dyn Operated>> = Kind {
    name: "engines",
    doc: "the cycle that a motion settles to, by events, by time-stepping and with a smoothed sign",
    declared: EnginesSettings::declarations,
    read: |_, section| Ok(Arc::new(EnginesSettings::read_table(section)?)),
    picture: Some(Picture {
        draw: figure::engines,
        caption: "The cycle by time-stepping and with a smoothed sign against that by events: relative errors of rms and period. Dotted: in proportion to the \
        step, to the width. A sign that is too wide comes to another motion, or to none.",
    }),
};

impl Analysis<OscillatorCase> for EnginesSettings {
    fn steps(&self) -> usize {
        run::steps(self)
    }

    fn summary_keys(&self) -> Vec<Declared> {
        ToldEngines::declared()
    }

    fn run(&self, of: &OscillatorSubject<'_>, task: Task<'_>) -> Result<Outcome, ModelError> {
        let model = OscillatorModel { name: of.name, inputs: &of.case.inputs, contact: of.contact };
        run::run(&model, self, task.progress)
    }

    /// Nearly all of it is the smallest steps of the time-stepping.
    fn estimate(&self, &KnownOscillator { name, .. }: &KnownOscillator<'_>) -> Result<Estimate, ModelError> {
        let points = self.time_step.points + self.width.points;
        let steps: f64 = match self.time_step.form {
            Form::Group => self.time_step.values().iter().map(|step| USUAL_TIME / step).sum(),
            Form::Si => self.steps as f64,
        };
        let seconds = steps * cost::TIME_STEP
            + points as f64 * USUAL_TIME * cost::STEPS_OF_RADIAN * cost::MOTION_STEP
            + cost::FIGURE;
        Ok(Estimate { name: name.to_owned(), points, seconds, seconds_at_most: None })
    }

    fn write(&self, json: &mut Map<String, Json>) {
        self.write_table(json);
    }
}

impl Operated for EnginesSettings {}
