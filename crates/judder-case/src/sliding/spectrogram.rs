//! `spectrogram`: a signal of a march over time and frequency.

use super::SlidingCase;
use super::analysis::SlidingAnalysis;
use super::locus::{Along, Locus};
use super::observe::{ObservedPoint, Signal, read_signal};
use super::problem::SlidingProblem;
use crate::analysis::Analysis;
use crate::cause::Cause;
use crate::document::Node;
use crate::error::Fault;
use crate::keys::Range;
use crate::section::{Section, finite_number, list, text};
use crate::sliding_keys::SlidingKey;
use crate::structure::analysis::ascending;
use crate::structure::lists::{length, number};
use crate::swept_keys::read_si;

/// A spectrogram of a signal.
#[derive(Debug, Clone, PartialEq)]
pub struct Spectrogram {
    /// The name of a march that stands above.
    pub of: String,
    /// Which of its signals.
    pub signal: Signal,
    /// How a piece of the signal fades in and out.
    pub window: Window,
    /// How long a piece is, s.
    pub length: f64,
    /// Share of a piece that the next one has too, from 0 to below 1.
    pub overlap: f64,
    /// The amplitude of 0 dB, in the SI unit of the signal.
    pub reference: f64,
    /// The levels between which colours run, dB; `None` where they follow from the signal.
    pub range: Option<[f64; 2]>,
    /// The name of a locus that stands above, whose unstable zones are laid over.
    pub locus: Option<String>,
}

/// How a piece of a signal fades in and out.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum Window {
    Hann,
    Hamming,
    Blackman,
    Rectangular,
}

impl Window {
    /// The windows with their names in a case file.
    pub const ALL: [(&'static str, Self); 4] = [
        ("hann", Self::Hann),
        ("hamming", Self::Hamming),
        ("blackman", Self::Blackman),
        ("rectangular", Self::Rectangular),
    ];

    /// The name in a case file.
    pub fn name(self) -> &'static str {
        Self::ALL[self as usize].0
    }
}

/// The keys of the kind.
pub(super) const KEYS: &[&str] =
    &["of", "signal", "window", "length", "overlap", "reference", "range", "locus"];

pub(super) fn read_spectrogram(case: &SlidingCase, section: &Section<'_>) -> Result<Spectrogram, Fault> {
    let of = text("of", section.required("of", "of = \"…\", the name of a march that stands above")?)?;
    let signal = read_signal(section, "signal", &case.points)?;
    Ok(Spectrogram {
        of: of.to_owned(),
        signal,
        window: section.choice("window", "window", &Window::ALL)?.unwrap_or(Window::Hann),
        length: number(section, SlidingKey::WindowLength.entry())?,
        overlap: number(section, SlidingKey::Overlap.entry())?,
        reference: read_reference(section, signal)?,
        range: read_range(section)?,
        locus: section.text("locus")?.map(str::to_owned),
    })
}

/// The amplitude of 0 dB: 1 of the signal's SI unit where the case does not say.
fn read_reference(section: &Section<'_>, signal: Signal) -> Result<f64, Fault> {
    let Some(node) = section.get("reference") else { return Ok(1.0) };
    let number = read_si("reference", signal.dimension(), node)?;
    if number > 0.0 {
        return Ok(number);
    }
    Err(Cause::OutOfRange { key: "reference".to_owned(), number, range: Range::Positive }.at(node.place))
}

fn read_range(section: &Section<'_>) -> Result<Option<[f64; 2]>, Fault> {
    let Some(node) = section.get("range") else { return Ok(None) };
    let numbers = list("range", node)?.iter().map(|item| finite_number("range", item));
    let numbers = numbers.collect::<Result<Vec<f64>, Fault>>()?;
    let [from, to] = numbers[..] else {
        return Err(length(section, "range", "two levels in dB, from and to", node));
    };
    ascending(from, to, node)?;
    Ok(Some([from, to]))
}

/// Refuses a spectrogram of what does not stand above it; `nodes` are the analyses as the case has them.
pub(super) fn check_references(
    analyses: &[Analysis<SlidingAnalysis>],
    points: &[ObservedPoint],
    nodes: &[Node],
) -> Result<(), Fault> {
    for (index, (analysis, node)) in analyses.iter().zip(nodes).enumerate() {
        let SlidingAnalysis::Spectrogram(spectrogram) = &analysis.kind else { continue };
        let above = &analyses[..index];
        let is_march = |kind: &SlidingAnalysis| matches!(kind, SlidingAnalysis::March(_));
        check_name(above, is_march, ("march", "of"), &spectrogram.of, node)?;
        check_signal(above, spectrogram, points, node)?;
        if let Some(name) = &spectrogram.locus {
            let is_locus = |kind: &SlidingAnalysis| {
                matches!(kind, SlidingAnalysis::Locus(Locus { along: Along::Positions(_), .. }))
            };
            check_name(above, is_locus, ("locus over positions", "locus"), name, node)?;
        }
    }
    Ok(())
}

/// Refuses a signal that the march does not keep.
fn check_signal(
    above: &[Analysis<SlidingAnalysis>],
    spectrogram: &Spectrogram,
    points: &[ObservedPoint],
    node: &Node,
) -> Result<(), Fault> {
    let kept = above.iter().find(|other| other.name == spectrogram.of).and_then(|other| match &other.kind {
        SlidingAnalysis::March(march) => Some(march.kept(points.len())),
        _ => None,
    });
    if kept.is_none_or(|kept| kept.contains(&spectrogram.signal)) {
        return Ok(());
    }
    let place = node.entry("signal").map_or(node.place, |value| value.place);
    let (march, signal) = (spectrogram.of.clone(), spectrogram.signal.name(points));
    let quantity = spectrogram.signal.quantity();
    Err(SlidingProblem::NotKept { march, signal, quantity }.at(place))
}

fn check_name(
    above: &[Analysis<SlidingAnalysis>],
    fits: impl Fn(&SlidingAnalysis) -> bool,
    (what, key): (&'static str, &str),
    name: &str,
    node: &Node,
) -> Result<(), Fault> {
    let known: Vec<String> =
        above.iter().filter(|other| fits(&other.kind)).map(|other| other.name.clone()).collect();
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
