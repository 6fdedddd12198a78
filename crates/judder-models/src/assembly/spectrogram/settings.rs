//! `spectrogram`: which signal of which march, and how its levels are taken.

use crate::assembly::case::AssemblyCase;
use crate::assembly::case::problem::AssemblyProblem;
use crate::assembly::march::settings::AssemblyMarch;
use crate::spectrogram::settings::{NamedAbove, SpectrumSettings};
use judder_keys::Settings;
use judder_keys::dimension::Dimension;
use judder_keys::document::Node;
use judder_keys::error::Fault;
use judder_keys::section::Section;
use judder_study::case::analysis::Planned;
use judder_study::model::Analysis;
use std::sync::Arc;

/// A spectrogram of a signal.
#[derive(Debug, Clone, PartialEq, Settings)]
pub struct AssemblySpectrogram {
    /// Of which march, and how.
    #[key(flatten)]
    pub levels: SpectrumSettings,
    /// Which of its arrays over time: `POINT.x`, an acceleration, `POINT.x.velocity`, `CONTACT.normal_force` or `CONTACT.friction_force`; the acceleration of the first observed point, else the normal force of the first contact, where left out.
    #[key(omitted)]
    pub signal: Option<String>,
}

impl AssemblySpectrogram {
    /// Reads the amplitude of 0 dB in the unit of the signal.
    pub(super) fn admit(mut self, case: &AssemblyCase, section: &Section<'_>) -> Result<Self, Fault> {
        let dimension = match &self.signal {
            Some(signal) if signal.ends_with("_force") => Dimension::FORCE,
            Some(signal) if signal.ends_with(".velocity") => Dimension::SPEED,
            None if case.watched.is_empty() => Dimension::FORCE,
            _ => Dimension::ACCELERATION,
        };
        self.levels.reference.admit(dimension, section)?;
        Ok(self)
    }
}

/// Refuses a spectrogram of a march that does not stand above it; `nodes` are the analyses as the case has them.
pub(crate) fn check_references(
    analyses: &[Planned<Arc<dyn Analysis<AssemblyCase>>>],
    nodes: &[Node],
) -> Result<(), Fault> {
    for (index, (analysis, node)) in analyses.iter().zip(nodes).enumerate() {
        let Some(spectrogram) = analysis.settings::<AssemblySpectrogram>() else { continue };
        let march = NamedAbove { what: "march", key: "of", name: &spectrogram.levels.of };
        let is_march =
            |other: &Planned<Arc<dyn Analysis<AssemblyCase>>>| other.settings::<AssemblyMarch>().is_some();
        march.check(&analyses[..index], is_march, node, || {
            let reason = format!("no march stands above that could be `{}`", spectrogram.levels.of);
            AssemblyProblem::Refused { reason }.into()
        })?;
    }
    Ok(())
}
