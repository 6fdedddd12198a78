//! The locus.

#![deny(clippy::indexing_slicing, reason = "stored arrays may be of any length")]

use crate::structure::eigen::figure::frequency_axis;
use crate::structure::shape_panels::significant;
use judder_numerics::order::{sort_by_number, sort_numbers};
use judder_report::figure::ShadedRegion;
use judder_report::palette::{Dash, Style};
use judder_report::runs::{alone, apart, thinned};
use judder_report::{Axis, Layer, Legend, Panel, Role};
use judder_store::Variable;
use judder_study::pictures::{StoredArrays, at, axis, complexes, reals, text, wholes};
use judder_study::shown::ShownValues;
use num_complex::Complex64;
use std::f64::consts::TAU;

/// Values that lines and points are drawn at, at most: zones are located, not sampled.
const SHOWN: usize = 400;
/// Shades of the complex plane.
const SHADES: usize = 8;
/// Of the fastest growth, what the even part of the axis of growth rates takes.
const EVEN: f64 = 0.1;
/// Where a logarithmic axis ends, over the largest value.
const ROOM: f64 = 2.0;
/// What the even axes show below zero and up to, over the fastest growth.
const SHOWN_BELOW: f64 = 0.25;
const SHOWN_ABOVE: f64 = 1.1;
/// Zones of one mode differ less in frequency.
const ALIKE: f64 = 0.02;
/// Width of a branch, points.
const THIN: f64 = 0.8;
/// The diameter of the largest marker of a zone over the usual one, and the share of it that the smallest has.
const BUBBLES: (f64, f64) = (2.5, 0.4);

/// Where no eigenvalue is.
const NOWHERE: Complex64 = Complex64::new(f64::NAN, f64::NAN);

/// A locus over position or any key.
struct DrawnLocus<'a> {
    coordinate: &'a Variable,
    /// The unit of the values; none of plain numbers.
    unit: Option<String>,
    /// The values that are shown, by their numbers.
    shown: Vec<usize>,
    values: Vec<f64>,
    eigenvalues: &'a [Complex64],
    /// How far each may be off; none in a study that was stored before errors were.
    errors: &'a [f64],
    count: usize,
    zones: Vec<ZoneOfLocus>,
}

struct ZoneOfLocus {
    from: f64,
    to: f64,
    peak: f64,
    growth: f64,
    frequency: f64,
    /// Whether growth is zero at start and end; it is not where the range ends, or the contact passes a node.
    is_root: [bool; 2],
    /// Its own growth rate from place to place; empty in a study that was stored before paths were.
    path: Vec<(f64, f64)>,
}

/// The complex plane, as a whole and about its unstable side; frequencies; growth rates, of all branches and of the unstable zones; the
/// normal force at rest.
pub(crate) fn locus(dataset: &StoredArrays<'_>) -> Option<Vec<Panel>> {
    let locus = DrawnLocus::new(dataset, shown_values(dataset)?)?;
    dataset.over("normal_force", &[&locus.coordinate.name])?;
    let force = reals(dataset, "normal_force")?.to_vec();
    let force = Layer::line("", locus.values.clone(), force, Role::Series(0).solid());
    let mut panels = vec![locus.plane("locus", locus.growth_axis())];
    if !locus.zones.is_empty() {
        panels.push(locus.plane("locus, its unstable side", locus.unstable_side()));
    }
    panels.extend([locus.frequencies(), locus.growth_rates()]);
    if !locus.zones.is_empty() {
        panels.push(locus.zones_alone());
    }
    let at_rest = Panel::new(locus.across(), Axis::linear("Normal force $N$ (N)"), vec![force]);
    panels.push(at_rest.with_title("at rest"));
    Some(panels)
}

/// Positions and growth rates along each unstable zone, from its start to its end where they vanish; in m for a locus over position.
pub fn zone_profiles(dataset: &StoredArrays<'_>) -> Vec<Vec<(f64, f64)>> {
    let Some(locus) = DrawnLocus::new(dataset, ShownValues::called(None)) else { return Vec::new() };
    locus.zones.iter().map(|zone| locus.profile(zone)).collect()
}

/// What the locus runs over.
fn coordinate<'a>(dataset: &StoredArrays<'a>) -> Option<&'a Variable> {
    dataset.shaped("eigenvalue", &[None, None])?;
    dataset.variable(dataset.variable("eigenvalue")?.dimensions.first()?)
}

/// Whether it runs over positions.
fn is_position(coordinate: &Variable) -> bool {
    coordinate.name == "position"
}

/// Positions in mm, another key in the unit in which the case has it.
fn shown_values(dataset: &StoredArrays<'_>) -> Option<ShownValues> {
    let own = coordinate(dataset)?;
    Some(if is_position(own) { ShownValues::called(Some("mm")) } else { ShownValues::of_variable(own) })
}

/// Whether two frequencies are those of one mode; that of a divergence is zero.
fn are_alike(one: f64, other: f64) -> bool {
    (one - other).abs() <= ALIKE * one.max(other)
}

/// The places and growth rates that are stored of each zone, by its number from 0.
fn paths<'a>(
    dataset: &StoredArrays<'a>,
    unit: &'a ShownValues,
) -> impl Fn(usize) -> Vec<(f64, f64)> + use<'a> {
    let is_so = dataset.alike(&["zone_path", "zone_path_at", "zone_path_eigenvalue"]).is_some();
    let numbers = wholes(dataset, "zone_path").filter(|_| is_so).unwrap_or_default();
    let at = reals(dataset, "zone_path_at").unwrap_or_default();
    let values = complexes(dataset, "zone_path_eigenvalue").unwrap_or_default();
    move |zone| {
        let points = numbers.iter().zip(at.iter().zip(values));
        points
            .filter(|(number, _)| **number == zone as i64 + 1)
            // at an end that is a root rounding may leave less than nothing
            .map(|(_, (at, value))| (unit.number(*at), value.re.max(0.0)))
            .collect()
    }
}

impl<'a> DrawnLocus<'a> {
    fn new(dataset: &StoredArrays<'a>, unit: ShownValues) -> Option<Self> {
        let coordinate = coordinate(dataset)?;
        let values = unit.values(reals(dataset, &coordinate.name)?);
        let count = *dataset.variable("eigenvalue")?.shape.last()?;
        dataset.shaped("eigenvalue", &[None, None])?;
        dataset.alike(&["eigenvalue", "eigenvalue_error"])?;
        dataset.alike(&[
            "zone_from",
            "zone_to",
            "zone_peak",
            "zone_growth_rate",
            "zone_frequency",
            "zone_from_kind",
            "zone_to_kind",
        ])?;
        let of = |name: &str| reals(dataset, name);
        let (from, to, peak) = (of("zone_from")?, of("zone_to")?, of("zone_peak")?);
        let (growth, frequency) = (of("zone_growth_rate")?, of("zone_frequency")?);
        let is_root =
            |name: &str, k: usize| wholes(dataset, name).is_none_or(|kinds| kinds.get(k) == Some(&0));
        let path = paths(dataset, &unit);
        let zone = |k: usize| ZoneOfLocus {
            path: path(k),
            from: unit.number(at(from, k)),
            to: unit.number(at(to, k)),
            peak: unit.number(at(peak, k)),
            growth: at(growth, k),
            frequency: at(frequency, k),
            is_root: [is_root("zone_from_kind", k), is_root("zone_to_kind", k)],
        };
        let zones = (0..from.len()).map(zone).collect();
        let step = values.len().div_ceil(SHOWN).max(1);
        let last = values.len().checked_sub(1)?;
        let mut shown: Vec<usize> = (0..values.len()).step_by(step).collect();
        if shown.last() != Some(&last) {
            shown.push(last);
        }
        Some(Self {
            coordinate,
            // a study that was stored before units were has that of the key
            unit: [unit.unit(), Some(coordinate.units.as_str())]
                .into_iter()
                .flatten()
                .next()
                .map(str::to_owned),
            shown,
            values,
            eigenvalues: complexes(dataset, "eigenvalue")?,
            errors: of("eigenvalue_error").unwrap_or_default(),
            count,
            zones,
        })
    }

    /// The axis of positions in mm, or of the swept key.
    fn across(&self) -> Axis {
        let own = match is_position(self.coordinate) {
            true => Axis::linear("Contact position $s$ (mm)"),
            false => axis(self.coordinate),
        };
        match (self.values.first(), self.values.last()) {
            (Some(first), Some(last)) if first != last => own.over(first.min(*last), first.max(*last)),
            _ => own,
        }
    }

    fn at(&self, row: usize, branch: usize) -> Complex64 {
        self.eigenvalues.get(row * self.count + branch).copied().unwrap_or(NOWHERE)
    }

    /// Every branch as a thin line; those that are unstable somewhere stand out.
    fn lines(&self, pick: impl Fn(Complex64) -> f64) -> Vec<Layer> {
        let rows = self.values.len();
        let error = |place: usize| self.errors.get(place).copied().unwrap_or(0.0);
        let grows = |row: usize, branch: usize| self.at(row, branch).re > error(row * self.count + branch);
        let is_unstable = |branch: usize| (0..rows).any(|row| grows(row, branch));
        let layers = |unstable: bool| {
            let (label, role) = match unstable {
                true => ("branch that becomes unstable", Role::Series(0)),
                false => ("", Role::Reference),
            };
            let own = (0..self.count).filter(|branch| is_unstable(*branch) == unstable);
            let curve = apart(own.map(|branch| {
                let up: Vec<f64> = (0..rows).map(|row| pick(self.at(row, branch))).collect();
                thinned(&self.values, &up, &self.shown)
            }));
            let (x, y) = alone(&curve.0, &curve.1);
            let points = (!x.is_empty()).then(|| Layer::points("", x, y, role.crowded()));
            let is_drawn = curve.1.iter().any(|up| up.is_finite());
            let line = Layer::line(label, curve.0, curve.1, role.solid().with_width(THIN));
            [is_drawn.then_some(line), points]
        };
        [layers(false), layers(true)].into_iter().flatten().flatten().collect()
    }

    fn growth_axis(&self) -> Axis {
        let rates = || self.eigenvalues.iter().map(|s| s.re).filter(|rate| rate.is_finite());
        let fastest = self.zones.iter().map(|zone| zone.growth).fold(0.0, f64::max);
        let low = rates().fold(0.0, f64::min);
        let label = "Growth rate Re $λ$ (1/s)";
        let even = if fastest > 0.0 { EVEN * fastest } else { EVEN * EVEN * -low };
        if even == 0.0 {
            return Axis::linear(label).with_range(-1.0, 1.0);
        }
        let high = rates().fold(fastest, f64::max);
        Axis::symmetric_log(label, even).over((ROOM * low).min(-even), (ROOM * high).max(even))
    }

    /// An even axis from somewhat below zero to beyond the fastest growth.
    fn unstable_side(&self) -> Axis {
        let fastest = self.zones.iter().map(|zone| zone.growth).fold(0.0, f64::max);
        Axis::linear("Growth rate Re $λ$ (1/s)").over(-SHOWN_BELOW * fastest, SHOWN_ABOVE * fastest)
    }

    /// Fig. 2 of the beams paper: growth rate and frequency, from dark to light along the axis.
    fn plane(&self, title: &str, growth: Axis) -> Panel {
        let symbol = text(self.coordinate, "symbol").unwrap_or(&self.coordinate.name);
        let unit =
            self.unit.as_ref().filter(|own| *own != "1").map_or_else(String::new, |own| format!(" {own}"));
        let shades = SHADES.min(self.shown.len());
        let mut layers = vec![Layer::vertical_rule(0.0, "")];
        for (index, rows) in self.shown.chunks(self.shown.len().div_ceil(shades.max(1)).max(1)).enumerate() {
            let points: Vec<Complex64> =
                rows.iter().flat_map(|row| (0..self.count).map(|branch| self.at(*row, branch))).collect();
            let (x, y) = points.iter().map(|s| (s.re, s.im / TAU)).unzip();
            let role = Role::Graded { index, count: shades };
            let first = rows.first().map_or(f64::NAN, |row| at(&self.values, *row));
            let label = format!("from {symbol} = {}{unit}", significant(first));
            layers.push(Layer::points(label, x, y, role.crowded()));
        }
        let (x, y) = self.zones.iter().map(|zone| (zone.growth, zone.frequency)).unzip();
        layers.push(Layer::points("fastest growth of a zone", x, y, Role::Series(1)));
        Panel::new(growth, frequency_axis(self.eigenvalues), layers)
            .with_title(title)
            .with_legend(Legend::Below)
    }

    /// Frequencies, with every unstable zone, by whose marker its growth rate is seen.
    fn frequencies(&self) -> Panel {
        let mut layers = self.lines(|s| s.im / TAU);
        for zone in &self.zones {
            let (x, y) = (vec![zone.from, zone.to], vec![zone.frequency; 2]);
            layers.push(Layer::line("", x, y, Role::Series(1).solid().with_width(3.0)));
        }
        let fastest = self.zones.iter().map(|zone| zone.growth).fold(f64::MIN_POSITIVE, f64::max);
        let sizes =
            self.zones.iter().map(|zone| BUBBLES.0 * (zone.growth / fastest).max(0.0).sqrt().max(BUBBLES.1));
        let (x, y) = self.zones.iter().map(|zone| (zone.peak, zone.frequency)).unzip();
        if !self.zones.is_empty() {
            let label = "unstable; area: growth rate";
            layers.push(Layer::bubbles(label, x, y, sizes.collect(), Role::Series(1)));
        }
        Panel::new(self.across(), frequency_axis(self.eigenvalues), layers)
            .with_title("frequencies")
            .with_legend(Legend::Below)
    }

    /// Growth rates, the zones shaded.
    fn growth_rates(&self) -> Panel {
        let shade = |(k, zone): (usize, &ZoneOfLocus)| {
            let label = if k == 0 { "unstable zone" } else { "" };
            let x = Some((zone.from, zone.to));
            Layer::Region(ShadedRegion { label: label.to_owned(), x, y: None, role: Role::UnstableZone })
        };
        let mut layers: Vec<Layer> = self.zones.iter().enumerate().map(shade).collect();
        layers.push(Layer::horizontal_rule(0.0, ""));
        layers.extend(self.lines(|s| s.re));
        let (x, y) = self.zones.iter().map(|zone| (zone.peak, zone.growth)).unzip();
        layers.push(Layer::points("fastest growth of a zone", x, y, Role::Series(1)));
        Panel::new(self.across(), self.growth_axis(), layers)
            .with_title("growth rates")
            .with_legend(Legend::Below)
    }

    /// Growth rates of the unstable zones alone, on an even axis, from dark to light with their frequency.
    fn zones_alone(&self) -> Panel {
        let mut layers = Vec::new();
        for frequency in self.frequencies_of_zones() {
            let (mut x, mut y) = (Vec::new(), Vec::new());
            let of_it = |zone: &&ZoneOfLocus| are_alike(zone.frequency, frequency);
            for zone in self.zones.iter().filter(of_it) {
                let gap = (f64::NAN, f64::NAN);
                let (along, up): (Vec<f64>, Vec<f64>) = self.profile(zone).into_iter().chain([gap]).unzip();
                x.extend(along);
                y.extend(up);
            }
            layers.push(Layer::line(
                format!("about {:.2} kHz", 1e-3 * frequency),
                x,
                y,
                self.of_frequency(frequency),
            ));
        }
        let fastest = self.zones.iter().map(|zone| zone.growth).fold(0.0, f64::max);
        let up = Axis::linear("Growth rate Re $λ$ (1/s)").over(0.0, SHOWN_ABOVE * fastest);
        Panel::new(self.across(), up, layers).with_title("unstable zones").with_legend(Legend::Below)
    }

    /// The shade of a frequency, the same in all loci that reach as high: a step a kilohertz, within which dashes tell zones apart.
    fn of_frequency(&self, frequency: f64) -> Style {
        const DASHES: [Dash; 4] = [Dash::Solid, Dash::Dashed, Dash::DashDotted, Dash::Dotted];
        let highest = self.eigenvalues.iter().map(|s| s.im / TAU).fold(0.0, f64::max);
        let kilohertz = |frequency: f64| (1e-3 * frequency).round() as usize;
        let alike = |other: &f64| *other < frequency && kilohertz(*other) == kilohertz(frequency);
        let before = self.frequencies_of_zones().into_iter().filter(alike).count();
        let role = Role::Graded { index: kilohertz(frequency), count: kilohertz(highest) + 1 };
        role.solid().with_dash(DASHES.get(before % DASHES.len()).copied().unwrap_or(Dash::Solid))
    }

    /// One frequency for all zones that lie about it, ascending.
    fn frequencies_of_zones(&self) -> Vec<f64> {
        let mut all: Vec<f64> = self.zones.iter().map(|zone| zone.frequency).collect();
        sort_numbers(&mut all);
        all.dedup_by(|next, kept| are_alike(*next, *kept));
        all
    }

    /// Positions and growth rates of a zone from its start over its peak to its end: of its own eigenvalue, whose frequency may change.
    fn profile(&self, zone: &ZoneOfLocus) -> Vec<(f64, f64)> {
        if !zone.path.is_empty() {
            return zone.path.clone();
        }
        // without a path that of the fastest branch beside its frequency, and a gap where there is none
        let fastest = |row: usize| {
            let near = (0..self.count).map(|branch| self.at(row, branch));
            near.filter(|s| are_alike(s.im / TAU, zone.frequency)).map(|s| s.re).fold(f64::NAN, f64::max)
        };
        let (low, high) = (zone.from.min(zone.to), zone.from.max(zone.to));
        let inside = self.values.iter().enumerate().map(|(row, at)| (*at, row));
        let inside = inside.filter(|(at, _)| *at > low && *at < high).map(|(at, row)| (at, fastest(row)));
        let ends = [zone.from, zone.to].into_iter().zip(zone.is_root);
        let roots = ends.filter(|(_, is_root)| *is_root).map(|(end, _)| (end, 0.0));
        let mut profile: Vec<(f64, f64)> = roots.chain([(zone.peak, zone.growth)]).chain(inside).collect();
        sort_by_number(&mut profile, |own| own.0);
        profile
    }
}
