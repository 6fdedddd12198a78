//! Legends as lists: which entries a panel has, and how wide they are.

use crate::figure::{Layer, Panel};
use crate::palette::{Role, Style};
use crate::typeface::{SMALL_SIZE, width};

/// Height of an entry.
pub(crate) const ROW: f64 = 12.0;
/// Width of a line sample, and of the gap after it.
pub(crate) const SAMPLE: f64 = 20.0;
pub(crate) const SAMPLE_GAP: f64 = 5.0;

/// Between the entries and the edge of their box.
pub(crate) const INSET: f64 = 4.0;

/// A label with the samples that it explains.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Entry {
    pub(crate) label: String,
    pub(crate) line: Option<Style>,
    pub(crate) marker: Option<Style>,
    pub(crate) area: Option<Role>,
}

impl Entry {
    fn new(label: &str) -> Self {
        Self { label: label.to_owned(), line: None, marker: None, area: None }
    }
}

/// The entries of a panel, in the order of its layers; layers of the same label share one.
pub(crate) fn entries(panel: &Panel) -> Vec<Entry> {
    merge(panel.layers.iter().flat_map(layer_entries))
}

fn layer_entries(layer: &Layer) -> Vec<Entry> {
    match layer {
        Layer::Line(line) => vec![Entry { line: Some(line.style), ..Entry::new(&line.label) }],
        Layer::Points(points) => vec![Entry { marker: Some(points.style), ..Entry::new(&points.label) }],
        Layer::Classes(map) => map
            .classes
            .iter()
            .map(|class| Entry { area: Some(class.role), ..Entry::new(&class.label) })
            .collect(),
        Layer::Region(region) => vec![Entry { area: Some(region.role), ..Entry::new(&region.label) }],
        Layer::Values(_) | Layer::Rule(_) | Layer::Note(_) => Vec::new(),
    }
}

/// Drops entries without a label and joins those with the same one.
pub(crate) fn merge(entries: impl Iterator<Item = Entry>) -> Vec<Entry> {
    let mut merged: Vec<Entry> = Vec::new();
    for entry in entries.filter(|entry| !entry.label.is_empty()) {
        match merged.iter_mut().find(|known| known.label == entry.label) {
            Some(known) => {
                known.line = known.line.or(entry.line);
                known.marker = known.marker.or(entry.marker);
                known.area = known.area.or(entry.area);
            }
            None => merged.push(entry),
        }
    }
    merged
}

/// Width of an entry with its sample.
pub(crate) fn entry_width(entry: &Entry) -> f64 {
    SAMPLE + SAMPLE_GAP + width(&entry.label, SMALL_SIZE)
}
