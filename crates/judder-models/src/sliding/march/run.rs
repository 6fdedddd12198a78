//! The march, from its first step or from where an interrupted run was.

use super::blocks::Marching;
use super::loudness::loudness;
use super::summary::EndedMarch;
use super::{Marched, expected, sampling, signals, sound};
use crate::error::ModelError;
use crate::samples::{Finished, Samples};
use crate::sliding::case::signals::SoundSignals;
use crate::sliding::system::{beyond_friction, step};
use judder_sliding::march::{March, MarchSettings};
use judder_sliding::recorder::Recorder;
use judder_store::Results;
use judder_study::Progress;
use judder_study::kept::KeptLines;
use judder_study::outcome::Outcome;

/// Marches along the path of an analysis, or goes on where an interrupted run was.
pub(crate) fn run(
    of: &Marched<'_>,
    kept: KeptLines<'_>,
    progress: &dyn Progress,
) -> Result<Outcome, ModelError> {
    let (asked, points) = (of.march, of.points);
    let method = asked.method();
    let chosen = step(of.pair, method, asked.step, of.motion)?;
    let decimation = sampling::decimation(&asked.signals, chosen.step);
    let signals = asked.kept(points.len());
    let channels: Vec<_> = signals.iter().map(|signal| signals::channel(*signal)).collect();
    let predictor = asked.predictor.unwrap_or_default();
    let march_settings = MarchSettings { method, step: chosen.step, motion: of.motion, predictor };
    let mut marching = Marching {
        march: March::new(of.pair, march_settings)?,
        recorder: Recorder::new(of.pair, &of.motion, &channels, &decimation)?,
        samples: Samples::open(kept.place, signals::growing(&signals, points))?,
        decimation,
        motion: of.motion,
        step: chosen.step,
        block: asked.checkpoint_steps as u64,
    };
    let way = marching.march_on(progress)?;
    let Marching { march, recorder, samples, .. } = marching;
    let sample_rate = decimation.sample_rate / decimation.factor as f64;
    let zones = expected::zones(of);
    let promised = zones.as_deref().unwrap_or_default();
    let loud = loudness(&samples, *asked.signal, points, of.motion.settled(), sample_rate, promised)?;
    let told = EndedMarch {
        of,
        chosen,
        steps: march.steps(),
        way: &way,
        tally: recorder.tally(),
        loud: &loud,
        zones: &zones,
    };
    let mut outcome = Outcome {
        table: Some(told.table()?),
        warnings: told.warnings().into_iter().chain(beyond_friction(of.pair, &of.motion)).collect(),
        missing: usize::from(way.ended.is_some()),
        ..Outcome::default()
    };
    let mut heard = None;
    if asked.sound != SoundSignals::Nothing {
        let sounds = sound::sounds(of.name, &samples, &asked.heard(points.len()), points, sample_rate)?;
        let files = sounds.into_iter().map(|sound| (sound.told, (sound.name, sound.bytes)));
        let (told, files) = files.unzip();
        (heard, outcome.files) = (Some(told), files);
    }
    outcome.scalars = told.told(heard).scalars();
    match samples.finish(told.dataset(sample_rate)?)? {
        Finished::Stored => outcome.is_stored = true,
        Finished::Whole(dataset) => outcome.dataset = *dataset,
    }
    progress.advance();
    Ok(outcome)
}
