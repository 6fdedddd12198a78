//! Sliding structures: loci, growth with the contact held, marches and their spectrograms.

mod growth;
mod locus;
pub(crate) mod march;
mod spectrogram;

pub(super) use growth::growth;
pub(super) use locus::locus;
pub(crate) use locus::zone_profiles;
pub(super) use march::march;
pub(super) use spectrogram::spectrogram;
