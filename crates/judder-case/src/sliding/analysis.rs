//! The analyses of a sliding case.

use super::SlidingCase;
use super::growth::Growth;
use super::locus::{self, Locus, read_locus};
use super::march::{MARCH_KEYS, March, read_march};
use super::spectrogram::{self, Spectrogram, read_spectrogram};
use super::structure::find_structure;
use crate::analysis::Kind;
use crate::declared::Settings;
use crate::structure::analysis::Modes;

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
#[derive(Debug, Clone, PartialEq)]
pub struct PartModes {
    /// The index of the structure.
    pub structure: usize,
    /// Which.
    pub modes: Modes,
}

/// The kinds of a sliding case.
pub(crate) const KINDS: [Kind<SlidingCase, SlidingAnalysis>; 5] = [
    Kind {
        name: "modes",
        keys: &["structure", "count", "band"],
        declared: None,
        doc: "undamped modes of one of the two structures, as it is held, without contact",
        read: |case, section| {
            let structure = find_structure(&case.structures, section, "structure")?;
            let modes = Modes::read_table(section)?;
            Ok(SlidingAnalysis::Modes(PartModes { structure, modes }))
        },
    },
    Kind {
        name: "locus",
        keys: locus::KEYS,
        declared: None,
        doc: "complex eigenvalues against the position of the contact, or against any key, with located unstable zones",
        read: |case, section| read_locus(case, section).map(SlidingAnalysis::Locus),
    },
    Kind {
        name: "march",
        keys: MARCH_KEYS,
        declared: None,
        doc: "the motion along the path by explicit time integration: signals, bursts, contact forces",
        read: |case, section| read_march(case, section).map(SlidingAnalysis::March),
    },
    Kind {
        name: "growth",
        keys: Growth::KEYS,
        declared: Some(Growth::declarations),
        doc: "the growth of one mode in a march with the contact held, against the eigenvalue there",
        read: |_, section| Growth::read_table(section).map(SlidingAnalysis::Growth),
    },
    Kind {
        name: "spectrogram",
        keys: spectrogram::KEYS,
        declared: None,
        doc: "a signal of a march over time, position and frequency, with the unstable zones of a locus",
        read: |case, section| read_spectrogram(case, section).map(SlidingAnalysis::Spectrogram),
    },
];
