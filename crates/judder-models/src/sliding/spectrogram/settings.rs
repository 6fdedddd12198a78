//! `spectrogram`: a signal of a march over time and frequency.

use crate::sliding::case::SlidingCase;
use crate::sliding::case::observe::{ObservedPoint, Signal};
use crate::sliding::case::problem::SlidingProblem;
use crate::sliding::locus::settings::{Along, LocusAnalysis};
use crate::sliding::march::settings::MarchAnalysis;
use crate::spectrogram::settings::{NamedAbove, SpectrumSettings};
use judder_keys::Settings;
use judder_keys::cause::Cause;
use judder_keys::declared::Named;
use judder_keys::document::Node;
use judder_keys::error::Fault;
use judder_keys::problem::Placed;
use judder_keys::section::Section;
use judder_study::case::analysis::Planned;
use judder_study::model::Analysis;
use std::sync::Arc;

/// A spectrogram of a signal.
#[derive(Debug, Clone, PartialEq, Settings)]
pub struct SpectrogramAnalysis {
    /// Of which march, and how.
    #[key(flatten)]
    pub levels: SpectrumSettings,
    /// Which of its signals, called as that of a march is; the first point's acceleration along y where left out.
    #[key(filled)]
    pub signal: Named<Signal>,
    /// The name of a locus over positions that stands above, whose unstable zones are laid over.
    pub locus: Option<String>,
}

impl SpectrogramAnalysis {
    /// Finds the signal, and reads the amplitude of 0 dB in its unit.
    pub(crate) fn admit(mut self, case: &SlidingCase, section: &Section<'_>) -> Result<Self, Fault> {
        self.signal = Signal::named(section, "signal", &case.points)?;
        self.levels.reference.admit(self.signal.dimension(), section)?;
        Ok(self)
    }
}

/// An analysis of the case.
type Above = Planned<Arc<dyn Analysis<SlidingCase>>>;

/// Refuses a spectrogram of what does not stand above it; `nodes` are the analyses as the case has them.
pub(crate) fn check_references(
    analyses: &[Above],
    points: &[ObservedPoint],
    nodes: &[Node],
) -> Result<(), Fault> {
    for (index, (analysis, node)) in analyses.iter().zip(nodes).enumerate() {
        let Some(spectrogram) = analysis.settings::<SpectrogramAnalysis>() else { continue };
        let above = &analyses[..index];
        let is_march = |other: &Above| other.settings::<MarchAnalysis>().is_some();
        let march = NamedAbove { what: "march", key: "of", name: &spectrogram.levels.of };
        march.check(above, is_march, node, || nothing(&march))?;
        check_signal(above, spectrogram, points, node)?;
        if let Some(name) = &spectrogram.locus {
            let is_locus = |other: &Above| {
                other
                    .settings::<LocusAnalysis>()
                    .is_some_and(|locus| matches!(locus.along, Along::Positions(_)))
            };
            let locus = NamedAbove { what: "locus over positions", key: "locus", name };
            locus.check(above, is_locus, node, || nothing(&locus))?;
        }
    }
    Ok(())
}

/// Refuses a signal that the march does not keep.
fn check_signal(
    above: &[Above],
    spectrogram: &SpectrogramAnalysis,
    points: &[ObservedPoint],
    node: &Node,
) -> Result<(), Fault> {
    let march = above
        .iter()
        .find(|other| other.name == spectrogram.levels.of)
        .and_then(Above::settings::<MarchAnalysis>);
    let kept = march.map(|march| march.kept(points.len()));
    if kept.is_none_or(|kept| kept.contains(&*spectrogram.signal)) {
        return Ok(());
    }
    let place = node.entry("signal").map_or(node.place, |value| value.place);
    let (march, signal) = (spectrogram.levels.of.clone(), spectrogram.signal.name.clone());
    let quantity = spectrogram.signal.quantity();
    Err(SlidingProblem::NotKept { march, signal, quantity }.at(place))
}

fn nothing(named: &NamedAbove<'_>) -> Cause {
    SlidingProblem::NothingAbove { what: named.what, name: named.name.to_owned() }.into()
}
