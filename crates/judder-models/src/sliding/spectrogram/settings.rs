//! `spectrogram`: a signal of a march over time and frequency.

use crate::sliding::case::SlidingCase;
use crate::sliding::case::observe::{ObservedPoint, Signal};
use crate::sliding::case::problem::SlidingProblem;
use crate::sliding::locus::settings::{Along, LocusAnalysis};
use crate::sliding::march::settings::MarchAnalysis;
use judder_keys::cause::Cause;
use judder_keys::declared::{Allowed, Named, Number, NumberPair, Setting, Whole};
use judder_keys::dimension::Dimension;
use judder_keys::document::Node;
use judder_keys::error::Fault;
use judder_keys::numeric_key::Range;
use judder_keys::numeric_key::read_si;
use judder_keys::problem::Placed;
use judder_keys::quantity::Quantity;
use judder_keys::section::{Section, text};
use judder_keys::{Choice, Settings};
use judder_study::case::analysis::Planned;
use judder_study::model::Analysis;
use serde_json::{Value as Json, json};
use std::sync::Arc;

/// A spectrogram of a signal.
#[derive(Debug, Clone, PartialEq, Settings)]
pub struct SpectrogramAnalysis {
    /// The name of a march that stands above.
    #[key(example = "\"…\", the name of a march that stands above")]
    pub of: String,
    /// Which of its signals, called as that of a march is; the first point's acceleration along y where left out.
    #[key(filled)]
    pub signal: Named<Signal>,
    /// How a piece of the signal fades in and out.
    #[key(default = SpectrogramWindow::Hann)]
    pub window: SpectrogramWindow,
    /// Length of its window.
    #[key(rule = Number::positive(Dimension::TIME), symbol = "T", default = 5e-3)]
    pub length: f64,
    /// Share of a window that the next one has too.
    #[key(rule = SHARE, symbol = "o", default = 0.75)]
    pub overlap: f64,
    /// The amplitude of 0 dB, in a unit of the signal; 1 of its SI unit where left out.
    #[key(filled)]
    pub reference: Amplitude,
    /// The levels between which colours run, dB; they follow from the signal where left out.
    #[key(rule = LEVELS)]
    pub range: Option<[f64; 2]>,
    /// Spectra that the waterfall draws one behind the other; 0 draws none.
    #[key(rule = Whole { from: 0, to: 200 }, usual = SPECTRA, omitted)]
    pub waterfall: Option<usize>,
    /// The name of a locus over positions that stands above, whose unstable zones are laid over.
    pub locus: Option<String>,
}

/// An amplitude of a signal, which decides its dimension.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Amplitude(pub Quantity);

/// How a piece of a signal fades in and out.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Choice)]
#[choice(what = "window")]
#[allow(missing_docs)]
pub enum SpectrogramWindow {
    Hann,
    Hamming,
    Blackman,
    Rectangular,
}

/// Spectra of a waterfall where the case does not say.
pub(super) const SPECTRA: usize = 30;
const SHARE: Number = Number { dimension: Dimension::NUMBER, range: Range::Fraction };
const LEVELS: NumberPair = NumberPair {
    of: Number::any(Dimension::NUMBER),
    what: "two levels in dB, from and to",
    is_ascending: true,
};

impl SpectrogramAnalysis {
    /// Finds the signal, and reads the amplitude of 0 dB in its unit.
    pub(crate) fn admit(mut self, case: &SlidingCase, section: &Section<'_>) -> Result<Self, Fault> {
        self.signal = Signal::named(section, "signal", &case.points)?;
        let dimension = self.signal.dimension();
        self.reference.0.dimension = dimension;
        if let Some(node) = section.get("reference") {
            let (key, number) = ("reference".to_owned(), read_si("reference", dimension, node)?);
            if number <= 0.0 {
                return Err(Cause::OutOfRange { key, number, range: Range::Positive }.at(node.place));
            }
            self.reference.0.number = number;
        }
        Ok(self)
    }
}

impl Default for Amplitude {
    fn default() -> Self {
        Self(Quantity { number: 1.0, dimension: Dimension::NUMBER })
    }
}

impl Setting for Amplitude {
    type Rule = ();

    fn form((): &()) -> Allowed {
        Allowed::Told {
            schema: json!({ "type": "string", "examples": ["1 m/s^2"] }),
            words: "a quantity of the signal, such as 1 m/s^2".to_owned(),
            keys: Vec::new(),
        }
    }

    /// Its number is read when its dimension is known.
    fn read(section: &Section<'_>, key: &str, node: &Node, (): &()) -> Result<Self, Fault> {
        text(&section.path(key), node).map(|_| Self::default())
    }

    fn write(&self, (): &()) -> Json {
        json!({ "value": self.0.number, "unit": self.0.dimension.unit() })
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
        check_name(above, is_march, "march", "of", &spectrogram.of, node)?;
        check_signal(above, spectrogram, points, node)?;
        if let Some(name) = &spectrogram.locus {
            let is_locus = |other: &Above| {
                other
                    .settings::<LocusAnalysis>()
                    .is_some_and(|locus| matches!(locus.along, Along::Positions(_)))
            };
            check_name(above, is_locus, "locus over positions", "locus", name, node)?;
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
    let march =
        above.iter().find(|other| other.name == spectrogram.of).and_then(Above::settings::<MarchAnalysis>);
    let kept = march.map(|march| march.kept(points.len()));
    if kept.is_none_or(|kept| kept.contains(&*spectrogram.signal)) {
        return Ok(());
    }
    let place = node.entry("signal").map_or(node.place, |value| value.place);
    let (march, signal) = (spectrogram.of.clone(), spectrogram.signal.name.clone());
    let quantity = spectrogram.signal.quantity();
    Err(SlidingProblem::NotKept { march, signal, quantity }.at(place))
}

fn check_name(
    above: &[Above],
    fits: impl Fn(&Above) -> bool,
    what: &'static str,
    key: &str,
    name: &str,
    node: &Node,
) -> Result<(), Fault> {
    let known: Vec<String> =
        above.iter().filter(|other| fits(other)).map(|other| other.name.clone()).collect();
    if known.iter().any(|other| other == name) {
        return Ok(());
    }
    let place = node.entry(key).map_or(node.place, |value| value.place);
    Err(if known.is_empty() {
        SlidingProblem::NothingAbove { what, name: name.to_owned() }.at(place)
    } else {
        Cause::UnknownName { what, name: name.to_owned(), known }.at(place)
    })
}
