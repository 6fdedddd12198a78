//! Spectrograms: levels over time and frequency with unstable zones, and the waterfall of their spectra.

use super::super::{axis, reals, text};
use super::march::positions;
use judder_report::figure::ValueMap;
use judder_report::palette::ColourMap;
use judder_report::{Axis, Layer, Legend, Panel, Role};
use judder_store::Dataset;

/// Cells of the drawn map along time and along frequency, at most; each shows the highest level in it.
const CELLS: [usize; 2] = [420, 260];
/// Levels that are shown below the highest where the case does not say, dB.
const SHOWN: f64 = 80.0;
/// Spectra of a waterfall, and how many of their distances the shown levels span.
const SPECTRA: usize = 30;
const HEIGHT: f64 = 5.0;

/// Levels with the zones laid over, and the waterfall.
pub(in crate::pictures) fn spectrogram(dataset: &Dataset) -> Option<Vec<Panel>> {
    let levels = Levels::of(dataset)?;
    Some(vec![levels.map(dataset)?, levels.waterfall(dataset)?])
}

/// Levels in at most so many cells.
struct Levels {
    times: Vec<f64>,
    positions: Vec<f64>,
    /// kHz.
    frequencies: Vec<f64>,
    /// dB, a row a time.
    values: Vec<f64>,
    range: (f64, f64),
}

impl Levels {
    fn of(dataset: &Dataset) -> Option<Self> {
        let (times, frequencies) = (reals(dataset, "time")?, reals(dataset, "frequency")?);
        let (levels, positions) = (reals(dataset, "level")?, reals(dataset, "position")?);
        let values = coarser(levels, frequencies.len(), CELLS);
        let highest = levels.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let stated = dataset
            .attributes()
            .get("range_db")
            .and_then(|range| Some((range.get(0)?.as_f64()?, range.get(1)?.as_f64()?)));
        Some(Self {
            times: middles(times, CELLS[0]),
            positions: middles(positions, CELLS[0]),
            frequencies: middles(frequencies, CELLS[1]).iter().map(|frequency| 1e-3 * frequency).collect(),
            values,
            range: stated.unwrap_or((highest - SHOWN, highest)),
        })
    }

    fn map(&self, dataset: &Dataset) -> Option<Panel> {
        let (columns, rows) = (self.times.len(), self.frequencies.len());
        // the rows of a map run along x, those of the levels along the frequencies
        let turned =
            (0..rows).flat_map(|row| (0..columns).map(move |column| self.values[column * rows + row]));
        let label = text(dataset.variable("level")?, "label").unwrap_or("Level (dB)");
        let map = ValueMap {
            x: self.times.clone(),
            y: self.frequencies.clone(),
            z: turned.collect(),
            bar: Axis::linear(label).with_range(self.range.0, self.range.1),
            colours: ColourMap::Sequential,
        };
        let mut layers = vec![Layer::Values(map)];
        layers.extend(self.zones(dataset));
        let across = axis(dataset.variable("time")?);
        let panel = Panel::new(across, Axis::linear("Frequency (kHz)"), layers).with_legend(Legend::Below);
        Some(match positions(reals(dataset, "time")?, reals(dataset, "position")?) {
            Some(second) => panel.with_second_axis(second),
            None => panel,
        })
    }

    /// The unstable zones of the locus within the map, as bars from start to end, each marked at its middle.
    fn zones(&self, dataset: &Dataset) -> Vec<Layer> {
        let zone = |name: &str| reals(dataset, name).unwrap_or_default();
        let (from, to, at) = (zone("zone_from"), zone("zone_to"), zone("zone_frequency"));
        let highest = self.frequencies.last().copied().unwrap_or(0.0);
        let (mut bars, mut middles) = ((Vec::new(), Vec::new()), (Vec::new(), Vec::new()));
        for k in (0..from.len()).filter(|k| 1e-3 * at[*k] <= highest) {
            let middle = self.time_at(0.5 * (from[k] + to[k]));
            let (Some(middle), frequency) = (middle, 1e-3 * at[k]) else { continue };
            let end = |position: f64| self.time_at(position).unwrap_or(middle);
            bars.0.extend([end(from[k]), end(to[k]), f64::NAN]);
            bars.1.extend([frequency, frequency, f64::NAN]);
            middles.0.push(middle);
            middles.1.push(frequency);
        }
        if middles.0.is_empty() {
            return Vec::new();
        }
        let locus = dataset.attributes().get("locus").and_then(serde_json::Value::as_str);
        let label = match locus {
            Some(locus) => format!("unstable zones of `{locus}`"),
            None => "unstable zones of the locus".to_owned(),
        };
        let style = Role::Series(1).solid();
        // what begins there stays in sight
        let sizes = vec![0.6; middles.0.len()];
        vec![
            Layer::line("", bars.0, bars.1, style.with_width(2.0)),
            Layer::bubbles(label, middles, sizes, Role::Series(1)),
        ]
    }

    /// When the contact is at a position; none where it never is.
    fn time_at(&self, position: f64) -> Option<f64> {
        let own = &self.positions;
        let k = own.windows(2).position(|p| p[0] != p[1] && (p[0] - position) * (p[1] - position) <= 0.0)?;
        let share = (position - own[k]) / (own[k + 1] - own[k]);
        Some(self.times[k] + share * (self.times[k + 1] - self.times[k]))
    }

    /// Spectra one after the other, each standing on its position.
    fn waterfall(&self, dataset: &Dataset) -> Option<Panel> {
        let lines = self.frequencies.len();
        let spectra = coarser(&self.values, lines, [SPECTRA, lines]);
        let places = middles(&self.positions, SPECTRA);
        let (first, last) = (1e3 * places.first()?, 1e3 * places.last()?);
        let distance = (last - first).abs() / (places.len().max(2) - 1) as f64;
        let (low, high) = self.range;
        let rise = |level: f64| (level.clamp(low, high) - low) / (high - low) * HEIGHT * distance;
        let spectrum = |(k, (place, levels)): (usize, (&f64, &[f64]))| {
            let heights = levels.iter().map(|level| 1e3 * place + rise(*level)).collect();
            let role = Role::Graded { index: k, count: places.len() };
            Layer::line("", self.frequencies.clone(), heights, role.solid().with_width(0.6))
        };
        let layers = places.iter().zip(spectra.chunks(lines)).enumerate().map(spectrum).collect();
        let signal = dataset.attributes().get("signal")?.as_str()?;
        let title = format!("{signal}: {:.0} dB are {:.1} mm high", high - low, HEIGHT * distance);
        let up = Axis::linear("Position $s$ (mm)");
        Some(Panel::new(Axis::linear("Frequency (kHz)"), up, layers).with_title(title))
    }
}

/// Groups of as many neighbours as leave at most `most` of them.
fn group(length: usize, most: usize) -> usize {
    length.div_ceil(most).max(1)
}

/// The middle of each group.
fn middles(values: &[f64], most: usize) -> Vec<f64> {
    let middle = |group: &[f64]| 0.5 * (group[0] + group[group.len() - 1]);
    values.chunks(group(values.len(), most)).map(middle).collect()
}

/// The highest level of each cell of groups along time and along the lines of a spectrum.
fn coarser(levels: &[f64], lines: usize, [times, frequencies]: [usize; 2]) -> Vec<f64> {
    let (rows, columns) = (group(levels.len() / lines.max(1), times), group(lines, frequencies));
    let mut cells = Vec::new();
    for spectra in levels.chunks(rows * lines) {
        let mut highest = vec![f64::NEG_INFINITY; lines.div_ceil(columns)];
        for spectrum in spectra.chunks(lines) {
            for (k, level) in spectrum.iter().enumerate() {
                highest[k / columns] = highest[k / columns].max(*level);
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
}
