//! The analyses of a sliding case.

use super::SlidingCase;
use super::growth::Growth;
use super::locus::Locus;
use super::march::March;
use super::spectrogram::Spectrogram;
use super::structure::find_structure;
use crate::case::analysis::Kind;
use crate::models::structure::case::analysis::Modes;
use judder_keys::Settings;
use judder_keys::declared::{Named, Settings};

/// What an analysis of a sliding case computes.
#[derive(Debug, Clone, PartialEq)]
pub enum SlidingAnalysis {
    /// `modes`: undamped modes of one structure alone, as it is held, without contact.
    Modes(PartModes),
    /// `locus`: complex eigenvalues against position or against any key.
    Locus(Locus),
    /// `march`: the motion along the path.
    March(March),
    /// `growth`: the motion with the contact held, against the eigenvalue there.
    Growth(Growth),
    /// `spectrogram`: a signal of a march over time and frequency.
    Spectrogram(Spectrogram),
}

/// Undamped modes of one of the structures.
#[derive(Debug, Clone, PartialEq, Settings)]
pub struct PartModes {
    /// The name of a structure.
    #[key(later)]
    pub structure: Named<usize>,
    /// Which.
    #[key(flatten)]
    pub modes: Modes,
}

/// The kinds of a sliding case.
pub(crate) const KINDS: [Kind<SlidingCase, SlidingAnalysis>; 5] = [
    Kind::declared(
        "modes",
        "undamped modes of one of the two structures, as it is held, without contact",
        PartModes::declarations,
        |case, section| {
            let mut own = PartModes::read_table(section)?;
            find_structure(&mut own.structure, &case.structures, section)?;
            Ok(SlidingAnalysis::Modes(own))
        },
    ),
    Kind::declared(
        "locus",
        "complex eigenvalues against the position of the contact, or against any key, with located unstable zones",
        Locus::declarations,
        |case, section| Locus::read_table(section)?.admit(case, section).map(SlidingAnalysis::Locus),
    ),
    Kind::declared(
        "march",
        "the motion along the path by explicit time integration: signals, bursts, contact forces",
        March::declarations,
        |case, section| March::read_table(section)?.admit(case, section).map(SlidingAnalysis::March),
    ),
    Kind::declared(
        "growth",
        "the growth of one mode in a march with the contact held, against the eigenvalue there",
        Growth::declarations,
        |_, section| Growth::read_table(section).map(SlidingAnalysis::Growth),
    ),
    Kind::declared(
        "spectrogram",
        "a signal of a march over time, position and frequency, with the unstable zones of a locus",
        Spectrogram::declarations,
        |case, section| {
            Spectrogram::read_table(section)?.admit(case, section).map(SlidingAnalysis::Spectrogram)
        },
    ),
];
