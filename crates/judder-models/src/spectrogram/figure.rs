//! Spectrograms: levels over time and frequency, along a path with unstable zones, and the waterfall of their spectra.

#![deny(clippy::indexing_slicing, reason = "stored arrays may be of any length")]

use super::settings::SPECTRA;
use crate::sliding::march::figure::positions;
use judder_numerics::order::sort_by_number;
use judder_report::figure::ValueMap;
use judder_report::palette::ColourMap;
use judder_report::{Axis, Layer, Legend, Panel, Role};
use judder_study::pictures::{StoredArrays, at, axis, middle, reals, text};
use serde_json::Value;

/// Cells of the drawn map along time and along frequency, at most; each shows the highest level in it.
const CELLS: [usize; 2] = [420, 260];
/// Levels that are shown below the highest where the case does not say, dB.
const SHOWN: f64 = 80.0;
/// How many distances of the spectra of a waterfall the shown levels span.
const HEIGHT: f64 = 4.0;
/// Frequencies that are shown beside zones, over the highest of theirs.
const ABOVE_ZONES: f64 = 1.5;
/// Half the height of the frame about a zone, as a share of the frequencies that are shown.
const FRAME: f64 = 0.02;
/// Widths of that frame, and of the bar of a zone among spectra, points.
const OUTLINE: f64 = 1.0;
const BAR: f64 = 2.4;
/// The diameter of the marker there, over the usual one.
const MARKER: f64 = 0.8;

/// Levels with the zones laid over, and the waterfall.
pub(crate) fn spectrogram(dataset: &StoredArrays<'_>) -> Option<Vec<Panel>> {
    let levels = Levels::of(dataset)?;
    let asked = dataset.attributes().get("waterfall").and_then(Value::as_u64);
    let spectra = asked.map_or(SPECTRA, |spectra| spectra as usize);
    let waterfall = if spectra > 0 { Some(levels.waterfall(dataset, spectra)?) } else { None };
    Some([Some(levels.map(dataset)?), waterfall].into_iter().flatten().collect())
}

/// Levels in at most so many cells.
struct Levels {
    times: Vec<f64>,
    /// Where the contact was, m; none of a march along no path.
    positions: Option<Vec<f64>>,
    /// kHz.
    frequencies: Vec<f64>,
    /// dB, a row a time.
    values: Vec<f64>,
    range: (f64, f64),
    zones: Vec<DrawnZone>,
}

/// An unstable zone: positions in m, ascending, frequency in kHz.
struct DrawnZone {
    from: f64,
    to: f64,
    frequency: f64,
}

impl Levels {
    /// All frequencies, or where zones are laid over, those up to some multiple of the highest of them.
    fn of(dataset: &StoredArrays<'_>) -> Option<Self> {
        dataset.over("level", &["time", "frequency"])?;
        dataset.alike(&["time", "position"])?;
        dataset.alike(&["zone_from", "zone_to", "zone_frequency"])?;
        let (times, frequencies) = (reals(dataset, "time")?, reals(dataset, "frequency")?);
        let levels = reals(dataset, "level")?;
        let zones = zones(dataset);
        let highest_zone = zones.iter().map(|zone| 1e3 * zone.frequency).fold(0.0, f64::max);
        let end = if highest_zone > 0.0 { ABOVE_ZONES * highest_zone } else { f64::INFINITY };
        let shown =
            frequencies.partition_point(|frequency| *frequency <= end).clamp(1, frequencies.len().max(1));
        let rows = levels.chunks(frequencies.len().max(1));
        let kept: Vec<f64> = rows.flat_map(|row| row.iter().take(shown).copied()).collect();
        let highest = kept.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let stated = dataset
            .attributes()
            .get("range_db")
            .and_then(|range| Some((range.get(0)?.as_f64()?, range.get(1)?.as_f64()?)));
        Some(Self {
            times: middles(times, CELLS[0]),
            positions: reals(dataset, "position").map(|positions| middles(positions, CELLS[0])),
            frequencies: middles(frequencies.get(..shown)?, CELLS[1]).iter().map(|f| 1e-3 * f).collect(),
            values: coarser(&kept, shown, CELLS),
            range: stated.unwrap_or((highest - SHOWN, highest)),
            zones,
        })
    }

    fn map(&self, dataset: &StoredArrays<'_>) -> Option<Panel> {
        let (columns, rows) = (self.times.len(), self.frequencies.len());
        // the rows of a map run along x, those of the levels along the frequencies
        let turned =
            (0..rows).flat_map(|row| (0..columns).map(move |column| at(&self.values, column * rows + row)));
        let label = text(dataset.variable("level")?, "label").unwrap_or("Level (dB)");
        let map = ValueMap {
            x: self.times.clone(),
            y: self.frequencies.clone(),
            z: turned.collect(),
            bar: Axis::linear(label).over(self.range.0, self.range.1),
            colours: ColourMap::Sequential,
        };
        let mut layers = vec![Layer::Values(map)];
        if !self.zones.is_empty() {
            let (x, y) = self.zones.iter().filter_map(|zone| self.frame(zone)).flatten().unzip();
            layers.push(Layer::line("", x, y, Role::Series(1).solid().with_width(OUTLINE)));
            layers.push(Layer::key(zones_label(dataset), Role::Series(1).solid()));
        }
        let across = axis(dataset.variable("time")?);
        let panel = Panel::new(across, Axis::linear("Frequency (kHz)"), layers).with_legend(Legend::Below);
        let panel = panel.with_title(format!("levels of {}", signal(dataset)?));
        let time = reals(dataset, "time")?;
        Some(match reals(dataset, "position").and_then(|position| positions(time, position)) {
            Some(second) => panel.with_second_axis(second),
            None => panel,
        })
    }

    /// The frame about a zone, by time and kHz, what grows in it left in sight; `None` where the contact never is in it.
    fn frame(&self, zone: &DrawnZone) -> Option<[(f64, f64); 6]> {
        let positions = self.positions.as_ref()?;
        let ends = [positions.first()?, positions.last()?];
        let (low, high) = (ends[0].min(*ends[1]), ends[0].max(*ends[1]));
        if zone.to < low || zone.from > high {
            return None;
        }
        let [from, to] = [zone.from, zone.to].map(|at| self.time_at(at.clamp(low, high)));
        let half = FRAME * (self.frequencies.last()? - self.frequencies.first()?);
        let (below, above) = (zone.frequency - half, zone.frequency + half);
        let (from, to) = (from?, to?);
        Some([(from, below), (from, above), (to, above), (to, below), (from, below), (f64::NAN, f64::NAN)])
    }

    /// When the contact is at a position; none where it never is.
    fn time_at(&self, position: f64) -> Option<f64> {
        let own = self.positions.as_ref()?;
        let pairs = own.iter().zip(own.iter().skip(1)).zip(self.times.iter().zip(self.times.iter().skip(1)));
        let passes = |((from, to), _): &((&f64, &f64), _)| {
            from != to && (**from - position) * (**to - position) <= 0.0
        };
        let ((from, to), (start, end)) = pairs.into_iter().find(passes)?;
        Some(start + (position - from) / (to - from) * (end - start))
    }

    /// Spectra one behind the other, each standing on its position, or its time where there is none, the front ones hiding what is behind; zones where they are.
    fn waterfall(&self, dataset: &StoredArrays<'_>, count: usize) -> Option<Panel> {
        let lines = self.frequencies.len();
        let spectra = coarser(&self.values, lines, [count, lines]);
        let (along, label, unit) = match &self.positions {
            Some(positions) => (positions, "Position $s$ (mm)", "mm"),
            None => (&self.times, "Time $t$ (ms)", "ms"),
        };
        let places: Vec<f64> = middles(along, count).iter().map(|place| 1e3 * place).collect();
        let (first, last) = (*places.first()?, *places.last()?);
        let distance = (last - first).abs() / (places.len().max(2) - 1) as f64;
        let (low, high) = self.range;
        let rise = |level: f64| (level.clamp(low, high) - low) / (high - low) * HEIGHT * distance;
        let mut order: Vec<(usize, (&f64, &[f64]))> =
            places.iter().zip(spectra.chunks(lines.max(1))).enumerate().collect();
        sort_by_number(&mut order, |own| *own.1.0);
        let mut skyline = vec![f64::NEG_INFINITY; lines];
        let mut layers = Vec::new();
        for (k, (place, levels)) in order {
            let heights: Vec<f64> = levels.iter().map(|level| place + rise(*level)).collect();
            let seen =
                heights.iter().zip(&skyline).map(|(own, front)| if own >= front { *own } else { f64::NAN });
            let role = Role::Graded { index: k, count: places.len() };
            layers.push(Layer::line(
                "",
                self.frequencies.clone(),
                seen.collect(),
                role.solid().with_width(0.6),
            ));
            for (front, own) in skyline.iter_mut().zip(heights) {
                *front = front.max(own);
            }
        }
        layers.extend(self.bars(&zones_label(dataset)));
        let title =
            format!("{}: {:.0} dB are {:.1} {unit} high", signal(dataset)?, high - low, HEIGHT * distance);
        let (least, most) = (first.min(last), first.max(last));
        let top = skyline.iter().copied().fold(most, f64::max);
        let up = Axis::linear(label).over(least, top + 0.5 * distance);
        let across =
            Axis::linear("Frequency (kHz)").over(*self.frequencies.first()?, *self.frequencies.last()?);
        Some(Panel::new(across, up, layers).with_title(title).with_legend(Legend::Below))
    }

    /// The zones among spectra: a bar from start to end, and a marker in its middle, since most are short.
    fn bars(&self, label: &str) -> Vec<Layer> {
        let mut layers = Vec::new();
        for zone in &self.zones {
            let (x, y) = (vec![zone.frequency; 2], vec![1e3 * zone.from, 1e3 * zone.to]);
            layers.push(Layer::line("", x, y, Role::Series(1).solid().with_width(BAR)));
        }
        let (x, y) = self.zones.iter().map(|zone| (zone.frequency, 500.0 * (zone.from + zone.to))).unzip();
        if !self.zones.is_empty() {
            layers.push(Layer::bubbles(label, x, y, vec![MARKER; self.zones.len()], Role::Series(1)));
        }
        layers
    }
}

fn signal<'a>(dataset: &StoredArrays<'a>) -> Option<&'a str> {
    dataset.attributes().get("signal")?.as_str()
}

fn zones_label(dataset: &StoredArrays<'_>) -> String {
    match dataset.attributes().get("locus").and_then(serde_json::Value::as_str) {
        Some(locus) => format!("unstable zones of {locus}"),
        None => "unstable zones of the locus".to_owned(),
    }
}

/// The unstable zones that a spectrogram holds, by m and kHz.
fn zones(dataset: &StoredArrays<'_>) -> Vec<DrawnZone> {
    let of = |name: &str| reals(dataset, name).unwrap_or_default();
    let (from, to, frequency) = (of("zone_from"), of("zone_to"), of("zone_frequency"));
    let zone = |((from, to), frequency): ((&f64, &f64), &f64)| DrawnZone {
        from: from.min(*to),
        to: from.max(*to),
        frequency: 1e-3 * frequency,
    };
    from.iter().zip(to).zip(frequency).map(zone).collect()
}

/// Groups of as many neighbours as leave at most `most` of them.
fn group(length: usize, most: usize) -> usize {
    length.div_ceil(most).max(1)
}

/// The middle of each group.
fn middles(values: &[f64], most: usize) -> Vec<f64> {
    values.chunks(group(values.len(), most)).map(middle).collect()
}

/// The highest level of each cell of groups along time and along the lines of a spectrum.
fn coarser(levels: &[f64], lines: usize, [times, frequencies]: [usize; 2]) -> Vec<f64> {
    let (rows, columns) = (group(levels.len() / lines.max(1), times), group(lines, frequencies));
    let mut cells = Vec::new();
    for spectra in levels.chunks((rows * lines).max(1)) {
        // the larger of a number and none is the number
        let mut highest = vec![f64::NAN; lines.div_ceil(columns)];
        for spectrum in spectra.chunks(lines.max(1)) {
            for (cell, levels) in highest.iter_mut().zip(spectrum.chunks(columns)) {
                *cell = levels.iter().copied().fold(*cell, f64::max);
            }
        }
        cells.extend(highest);
    }
    cells
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_coarser_map_keeps_the_highest_levels() {
        // three times of four lines into cells of two by two
        let levels = [0.0, 1.0, 2.0, 3.0, 4.0, 0.0, 0.0, 9.0, 5.0, 6.0, 7.0, 1.0];
        assert_eq!(coarser(&levels, 4, [2, 2]), [4.0, 9.0, 6.0, 7.0]);
        assert_eq!(coarser(&levels, 4, [3, 4]), levels);
        assert_eq!(middles(&[0.0, 1.0, 2.0], 2), [0.5, 2.0]);
    }

    #[test]
    fn a_frame_reaches_from_start_to_end_of_what_is_passed_of_a_zone() {
        let levels = Levels {
            times: vec![0.0, 1.0, 2.0],
            positions: Some(vec![0.01, 0.02, 0.03]),
            frequencies: vec![0.0, 10.0],
            values: Vec::new(),
            range: (0.0, 1.0),
            zones: Vec::new(),
        };
        let frame = |from, to| levels.frame(&DrawnZone { from, to, frequency: 5.0 });
        let near = |(x, y): (f64, f64), to: (f64, f64)| (x - to.0).abs() + (y - to.1).abs() < 1e-12;
        let inside = frame(0.015, 0.02).unwrap();
        assert!(near(inside[0], (0.5, 4.8)) && near(inside[2], (1.0, 5.2)), "{inside:?}");
        // what begins before the march or ends after it is cut, what it never meets is left out
        let cut = frame(0.025, 0.05).unwrap();
        assert!(near(cut[0], (1.5, 4.8)) && near(cut[2], (2.0, 5.2)), "{cut:?}");
        assert!(frame(0.031, 0.05).is_none() && frame(0.0, 0.009).is_none());
    }
}
