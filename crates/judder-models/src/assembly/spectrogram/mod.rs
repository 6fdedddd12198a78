//! `spectrogram`: a signal of a march over time and frequency, from what the march has stored.

pub mod settings;

use super::AssemblySubject;
use super::march::MarchedSize;
use super::march::settings::AssemblyMarch;
use super::march::size::stored_rate;
use crate::assembly::case::AssemblyCase;
use crate::assembly::case::problem::AssemblyProblem;
use crate::error::ModelError;
use crate::spectrogram::figure;
use crate::spectrogram::levels::{AskedLevels, ToldSpectrogram};
use judder_keys::cause::Cause;
use judder_keys::declared::Settings;
use judder_store::{Declared, Results};
use judder_study::case::analysis::{Kind, Picture};
use judder_study::model::{Analysis, NeededMemory, Refusal, Task};
use judder_study::outcome::Outcome;
use serde_json::{Map, Value as Json};
use settings::AssemblySpectrogram;
use std::sync::Arc;

/// The kind.
pub(crate) const KIND: Kind<Option<AssemblyCase>, Arc<dyn Analysis<AssemblyCase>>> = Kind {
    name: "spectrogram",
    doc: "a signal of a march over time and frequency",
    declared: AssemblySpectrogram::declarations,
    read: |case, section| {
        let own = AssemblySpectrogram::read_table(section)?;
        Ok(Arc::new(match case {
            Some(case) => own.admit(case, section)?,
            None => own,
        }))
    },
    picture: Some(Picture {
        draw: figure::spectrogram,
        caption: "First, the highest level in each cell of the drawing. Then the highest level in each of successive stretches: every spectrum stands on its time and \
        hides what is behind it.",
    }),
};

impl Analysis<AssemblyCase> for AssemblySpectrogram {
    fn fits(&self, of: &AssemblySubject<'_>) -> Result<Result<(), Refusal>, ModelError> {
        let known = signals(of);
        if let Some(signal) = self.signal.as_ref().filter(|signal| !known.contains(signal)) {
            let (what, name) = ("signal", signal.clone());
            return Ok(Err(Refusal::key("signal", Cause::UnknownName { what, name, known })));
        }
        let Some(march) = march(self, of) else { return Ok(Ok(())) };
        let (pieces, name, duration) = (&self.levels.pieces, &self.levels.of, march.duration);
        let length = pieces.length;
        let too_long = (length > duration).then(|| {
            format!(
                "a window is {length} s long, but the march `{name}` takes {duration} s: give a shorter `length`"
            )
        });
        let too_short = || pieces.too_short(name, stored_rate(march));
        let reason = too_long.or_else(|| Some(too_short()? + ": give a longer `length`"));
        let refused = |reason| Refusal::key("length", AssemblyProblem::Refused { reason });
        Ok(reason.map_or(Ok(()), |reason| Err(refused(reason))))
    }

    fn summary_keys(&self) -> Vec<Declared> {
        Declared::without(ToldSpectrogram::declared(), &["peak_position_m"])
    }

    fn run(&self, of: &AssemblySubject<'_>, task: Task<'_>) -> Result<Outcome, ModelError> {
        let usual = signals(of).into_iter().next().unwrap_or_default();
        let signal = self.signal.as_deref().unwrap_or(&usual);
        let levels = AskedLevels { name: of.name, signal: [signal, signal], asked: &self.levels };
        let place = levels.place(task.own.place, &[])?;
        let shown = levels.shown(&place)?;
        let dataset = shown.dataset(&levels, None)?;
        Ok(Outcome { scalars: shown.told(&levels).scalars(), dataset, ..Outcome::default() })
    }

    fn memory(&self, of: &AssemblySubject<'_>) -> Result<NeededMemory, ModelError> {
        let read = march(self, of).map(|march| MarchedSize::new(of, march));
        let known = |size: MarchedSize| self.levels.memory(size.samples, size.stored());
        Ok(read.map_or(NeededMemory::LITTLE, known))
    }

    fn estimate(&self, _: &AssemblySubject<'_>) -> Result<String, ModelError> {
        Ok(format!("levels of a signal of `{}`", self.levels.of))
    }

    fn takes_up(&self) -> Vec<&str> {
        vec![&self.levels.of]
    }

    fn write(&self, json: &mut Map<String, Json>) {
        self.write_table(json);
    }
}

/// The march whose signal it shows.
fn march<'a>(asked: &AssemblySpectrogram, of: &AssemblySubject<'a>) -> Option<&'a AssemblyMarch> {
    of.case.analyses.iter().find(|own| own.name == asked.levels.of)?.settings()
}

/// The signals of a march over time: accelerations of the observed points, forces of the contacts, velocities of the observed points.
fn signals(of: &AssemblySubject<'_>) -> Vec<String> {
    let watched = || of.built.watched.iter().map(|own| &own.name);
    let forces = of.built.assembly.interfaces.iter().flat_map(|interface| {
        ["normal_force", "friction_force"].map(|force| format!("{}.{force}", interface.name))
    });
    watched().cloned().chain(forces).chain(watched().map(|name| format!("{name}.velocity"))).collect()
}
