//! What spectrograms of all models are asked.

use judder_keys::cause::Cause;
use judder_keys::declared::{Allowed, Number, NumberPair, Setting, Whole};
use judder_keys::dimension::Dimension;
use judder_keys::document::Node;
use judder_keys::error::Fault;
use judder_keys::numeric_key::{Range, read_si};
use judder_keys::quantity::{Quantity, WrittenNumber};
use judder_keys::section::{Section, text};
use judder_keys::{Choice, Settings};
use judder_numerics::signal::spectrogram::SHORTEST_PIECE;
use judder_numerics::signal::window::Window;
use judder_study::case::analysis::Planned;
use judder_study::model::{Analysis, NeededMemory};
use serde_json::{Value as Json, json};
use std::sync::Arc;

/// A spectrogram of a march, of whatever model.
#[derive(Debug, Clone, PartialEq, Settings)]
pub struct SpectrumSettings {
    /// The name of a march that stands above.
    #[key(example = "\"…\", the name of a march that stands above")]
    pub of: String,
    /// How the signal is cut into pieces.
    #[key(flatten)]
    pub pieces: SpectrumPieces,
    /// The amplitude of 0 dB, in a unit of the signal; that of ISO 1683 where left out: 1 µm/s², 1 nm/s, 1 pm, 1 µN.
    #[key(filled)]
    pub reference: Amplitude,
    /// How levels are drawn.
    #[key(flatten)]
    pub drawn: DrawnLevels,
}

/// Numbers of a spectrum that are held at once for each that is told: levels as computed, as shown, as stored and drawn.
const LEVEL_COPIES: f64 = 4.0;

impl SpectrumSettings {
    /// What it needs of a march of so many samples with so many bytes of arrays, all of which are read.
    pub(crate) fn memory(&self, samples: f64, stored: f64) -> NeededMemory {
        // each of its windows has half as many lines as samples
        let levels = samples / (2.0 * (1.0 - self.pieces.overlap));
        NeededMemory {
            beside: (stored + 8.0 * LEVEL_COPIES * levels) as u128,
            what: format!("{samples:.3e} samples of the march `{}` and {levels:.3e} levels", self.of).into(),
            keys: &["overlap", "of"],
            advice: "give a smaller `overlap`, or a lower sample rate of the march",
            ..NeededMemory::LITTLE
        }
    }
}

/// How a signal is cut into pieces.
#[derive(Debug, Clone, Copy, PartialEq, Settings)]
pub struct SpectrumPieces {
    /// How a piece of the signal fades in and out.
    #[key(default = SpectrogramWindow::Hann)]
    pub window: SpectrogramWindow,
    /// Length of its window.
    #[key(rule = Number::positive(Dimension::TIME), symbol = "T", default = 5e-3)]
    pub length: f64,
    /// Share of a window that the next one has too.
    #[key(rule = SHARE, symbol = "o", default = 0.75)]
    pub overlap: f64,
}

impl SpectrumPieces {
    /// Samples of a window of a signal that is stored at this rate, Hz.
    pub(super) fn samples(&self, sample_rate: f64) -> usize {
        (self.length * sample_rate).round() as usize
    }

    /// Why a window of a march that stores its signals at this rate is too short; `None` where it is not.
    pub(crate) fn too_short(&self, march: &str, sample_rate: f64) -> Option<String> {
        let (length, samples) = (self.length, self.samples(sample_rate));
        (samples < SHORTEST_PIECE).then(|| {
            format!(
                "a window is {length} s long, {samples} samples of the march `{march}`, and at least {SHORTEST_PIECE} are needed"
            )
        })
    }
}

/// How levels are drawn.
#[derive(Debug, Clone, Copy, PartialEq, Settings)]
pub struct DrawnLevels {
    /// The levels between which colours run, dB; they follow from the signal where left out.
    #[key(rule = LEVELS)]
    pub range: Option<[f64; 2]>,
    /// Spectra that the waterfall draws one behind the other; 0 draws none.
    #[key(rule = Whole { from: 0, to: 200 }, usual = SPECTRA, omitted)]
    pub waterfall: Option<usize>,
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

impl SpectrogramWindow {
    /// Its weights.
    pub(super) fn window(self) -> Window {
        match self {
            Self::Hann => Window::Hann,
            Self::Hamming => Window::Hamming,
            Self::Blackman => Window::Blackman,
            Self::Rectangular => Window::Rectangular,
        }
    }
}

/// 0 dB of a quantity in its SI unit (ISO 1683); 1 of a quantity that has none there.
pub(crate) fn decibel_reference(dimension: Dimension) -> f64 {
    let known = [
        (Dimension::ACCELERATION, 1e-6),
        (Dimension::SPEED, 1e-9),
        (Dimension::LENGTH, 1e-12),
        (Dimension::FORCE, 1e-6),
    ];
    known.into_iter().find(|(of, _)| *of == dimension).map_or(1.0, |(_, reference)| reference)
}

impl Amplitude {
    /// Reads the amplitude of 0 dB in a unit of this dimension, which is that of the signal.
    pub(crate) fn admit(&mut self, dimension: Dimension, section: &Section<'_>) -> Result<(), Fault> {
        self.0 = Quantity { number: decibel_reference(dimension), dimension };
        if let Some(node) = section.get("reference") {
            let (key, number) = ("reference".to_owned(), read_si("reference", dimension, node)?);
            if number <= 0.0 {
                let number = WrittenNumber::of(node, number);
                return Err(Cause::OutOfRange { key, number, range: Range::Positive }.at(node.place));
            }
            self.0.number = number;
        }
        Ok(())
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

/// An analysis of a case that an analysis below takes the result of.
pub(crate) struct NamedAbove<'a> {
    /// What it is.
    pub(crate) what: &'static str,
    /// The key that names it.
    pub(crate) key: &'static str,
    /// The name.
    pub(crate) name: &'a str,
}

impl NamedAbove<'_> {
    /// Refuses a name that none of the analyses above has which fit; `node` is the analysis as the case has it, `nothing` what is wrong where none fits.
    pub(crate) fn check<C>(
        &self,
        above: &[Planned<Arc<dyn Analysis<C>>>],
        fits: impl Fn(&Planned<Arc<dyn Analysis<C>>>) -> bool,
        node: &Node,
        nothing: impl FnOnce() -> Cause,
    ) -> Result<(), Fault> {
        let known: Vec<String> =
            above.iter().filter(|other| fits(other)).map(|other| other.name.clone()).collect();
        if known.iter().any(|other| other == self.name) {
            return Ok(());
        }
        let place = node.entry(self.key).map_or(node.place, |value| value.place);
        Err(if known.is_empty() {
            nothing().at(place)
        } else {
            Cause::UnknownName { what: self.what, name: self.name.to_owned(), known }.at(place)
        })
    }
}
