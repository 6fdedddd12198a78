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
pub(crate) struct LegendEntry {
    pub(crate) label: String,
    pub(crate) line: Option<Style>,
    pub(crate) marker: Option<Style>,
    pub(crate) area: Option<Role>,
}

impl LegendEntry {
    fn new(label: &str) -> Self {
        Self { label: label.to_owned(), line: None, marker: None, area: None }
    }
}

/// The entries of a panel, in the order of its layers; layers of the same label share one.
pub(crate) fn entries(panel: &Panel) -> Vec<LegendEntry> {
    merge(panel.layers.iter().flat_map(layer_entries))
}

fn layer_entries(layer: &Layer) -> Vec<LegendEntry> {
    match layer {
        Layer::Line(line) => vec![LegendEntry { line: Some(line.style), ..LegendEntry::new(&line.label) }],
        Layer::Points(points) => {
            vec![LegendEntry { marker: Some(points.style), ..LegendEntry::new(&points.label) }]
        }
        Layer::Classes(map) => map
            .classes
            .iter()
            .map(|class| LegendEntry { area: Some(class.role), ..LegendEntry::new(&class.label) })
            .collect(),
        Layer::Region(region) => {
            vec![LegendEntry { area: Some(region.role), ..LegendEntry::new(&region.label) }]
        }
        Layer::Values(_) | Layer::Rule(_) | Layer::Note(_) => Vec::new(),
    }
}

/// Drops entries without a label and joins those with the same one.
pub(crate) fn merge(entries: impl Iterator<Item = LegendEntry>) -> Vec<LegendEntry> {
    let mut merged: Vec<LegendEntry> = Vec::new();
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
pub(crate) fn entry_width(entry: &LegendEntry) -> f64 {
    SAMPLE + SAMPLE_GAP + width(&entry.label, SMALL_SIZE)
}
