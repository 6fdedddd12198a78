//! Sliding structures: marches and their spectrograms.

mod march;
mod spectrogram;

pub(super) use march::march;
pub(super) use spectrogram::spectrogram;
