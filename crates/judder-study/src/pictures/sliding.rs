//! Sliding structures: loci, marches and their spectrograms.

mod locus;
mod march;
mod spectrogram;

pub(super) use locus::locus;
pub(super) use march::march;
pub(super) use spectrogram::spectrogram;
