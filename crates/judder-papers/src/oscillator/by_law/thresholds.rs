//! The thresholds of Figs. 7 and 8 with the three laws: drawn, and how far they move.

use super::{LAWS, LOADS, friction, sources, stored};
use crate::claim::short;
use crate::drawn::made;
use judder_models::oscillator::curves::curves_of;
use judder_report::page::PageTable;
use judder_report::runs::through;
use judder_report::{Axis, Figure, Layer, Legend, Panel, Style, UndrawnFigure};
use judder_store::{StudyFolder, Summary};
use judder_study::labels::short_number;
use judder_study::pictures::{StoredArrays, axis, reals};

/// A figure of thresholds over speed.
struct ThresholdFigure {
    /// Its source.
    source: &'static str,
    /// Its name in the paper.
    label: &'static str,
    /// File stem of the drawing.
    stem: &'static str,
    title: &'static str,
    /// Name of the coordinate of its curves, and its symbol.
    family: (&'static str, &'static str),
    vertical: &'static str,
    /// Which of the thresholds at one speed it is about: the paper knows one, the full system up to three.
    which: &'static str,
    pick: fn(&[f64]) -> Option<usize>,
}

const KINDS: [ThresholdFigure; 2] = [
    ThresholdFigure {
        source: "fig-7",
        label: "Fig. 7",
        stem: "thresholds-by-law",
        title: "Critical shear strength with three laws",
        family: ("normal_load", "$F̃_{n}$"),
        vertical: "Lowest threshold $τ̃_{0,crit}$ (−)",
        which: "lowest",
        pick: |roots| roots.iter().position(|root| root.is_finite()),
    },
    ThresholdFigure {
        source: "fig-8",
        label: "Fig. 8",
        stem: "loads-by-law",
        title: "Critical load with three laws",
        family: ("shear_strength", "$τ̃_{0}$"),
        vertical: "Highest threshold $F̃_{n,crit}$ (−)",
        which: "highest",
        pick: |roots| roots.iter().rposition(|root| root.is_finite()),
    },
];

/// The threshold that a figure is about along the speeds, NaN where there is none, and on which of the curves of all thresholds it lies.
struct Picked {
    values: Vec<f64>,
    on: Vec<Option<usize>>,
}

impl Picked {
    /// Neighbours on one curve as a line, and those that have none as points.
    fn layers(&self, speeds: &[f64], label: &str, style: Style) -> Vec<Layer> {
        let Self { values, on } = self;
        let goes_on = |k: usize| on[k].is_some() && on.get(k + 1) == Some(&on[k]);
        let (x, y) = through(speeds, values, goes_on);
        let is_alone = |k: &usize| on[*k].is_some() && !goes_on(*k) && (*k == 0 || !goes_on(k - 1));
        let (across, up) = (0..on.len()).filter(is_alone).map(|k| (speeds[k], values[k])).unzip();
        let points = Layer::points("", across, up, Style { crowded: true, ..style });
        vec![Layer::line(label, x, y, style), points]
    }
}

/// One figure with one friction load: `[law][curve]`.
pub(super) struct MovedThresholds {
    kind: &'static ThresholdFigure,
    load: &'static str,
    speed: Axis,
    speeds: Vec<f64>,
    family: Vec<f64>,
    full: Vec<Vec<Picked>>,
    conservative: Vec<Vec<Picked>>,
}

/// What is stored of both figures with both friction loads, and of which figures it is not what judder writes.
pub(super) fn all(store: &StudyFolder, summary: &Summary) -> (Vec<MovedThresholds>, Vec<UndrawnFigure>) {
    let (mut all, mut undrawn) = (Vec::new(), Vec::new());
    for kind in &KINDS {
        let Some(source) = sources().find(|source| source.name == kind.source) else { continue };
        for load in LOADS {
            let Some(analyses) = stored(store, summary, source, load) else { continue };
            let moved = |laws: &[StoredArrays<'_>]| MovedThresholds::of(kind, load, laws);
            match made(store.path(), &analyses.each_ref(), moved) {
                Ok(moved) => all.push(moved),
                Err(reason) => undrawn.push(UndrawnFigure { name: stem(kind, load), reason }),
            }
        }
    }
    (all, undrawn)
}

/// The file stem of the drawing of a figure with a friction load.
fn stem(kind: &ThresholdFigure, load: &str) -> String {
    if load == LOADS[0] { kind.stem.to_owned() } else { format!("{}-{load}", kind.stem) }
}

impl MovedThresholds {
    /// What the thresholds with [`LAWS`] say together; nothing unless all have the same speeds and the same family.
    fn of(kind: &'static ThresholdFigure, load: &'static str, laws: &[StoredArrays<'_>]) -> Option<Self> {
        let first = laws.first()?;
        let (speeds, family) = (reals(first, "velocity")?, reals(first, kind.family.0)?);
        let of = |name: &str| {
            let shape = [Some(family.len()), Some(speeds.len()), None];
            laws.iter()
                .map(|arrays| {
                    arrays.shaped(name, &shape)?;
                    picked(arrays, name, kind).filter(|curves| curves.len() == family.len())
                })
                .collect::<Option<Vec<_>>>()
        };
        Some(Self {
            kind,
            load,
            speed: axis(first.variable("velocity")?),
            full: of("full")?,
            conservative: of("conservative")?,
            speeds: speeds.to_vec(),
            family: family.to_vec(),
        })
    }

    /// The file stem of the drawing.
    pub(super) fn stem(&self) -> String {
        stem(self.kind, self.load)
    }

    /// One panel a curve of the paper's figure, with the three laws.
    pub(super) fn figure(&self) -> Figure {
        let panel = |(curve, value): (usize, &f64)| {
            let mut layers = Vec::new();
            for (law, (_, name, role)) in LAWS.into_iter().enumerate() {
                layers.extend(self.full[law][curve].layers(&self.speeds, name, role.solid()));
                layers.extend(self.conservative[law][curve].layers(&self.speeds, "", role.dashed()));
            }
            Panel::new(self.speed.clone(), Axis::log(self.kind.vertical), layers)
                .with_title(format!("{} = {}", self.kind.family.1, short_number(*value)))
                .with_legend(Legend::Below)
        };
        let panels = self.family.iter().enumerate().map(panel).collect();
        Figure::new(self.stem(), self.kind.title, panels).with_caption(format!(
            "The {} threshold of {} with {}. Solid: full system. Dashed: without damping.",
            self.kind.which,
            self.kind.label,
            friction(self.load)
        ))
    }

    /// One row a curve: by what factor the thresholds of the full system differ between two laws.
    fn rows(&self) -> Vec<Vec<String>> {
        let row = |(curve, value): (usize, &f64)| {
            let value = format!("{} = {}", self.kind.family.1, short_number(*value));
            let mut row = vec![self.kind.label.to_owned(), friction(self.load).to_owned(), value];
            for [a, b] in [[0, 2], [1, 2]] {
                let distance = Distance::between(&self.full[a][curve].values, &self.full[b][curve].values);
                row.push(short(distance.median));
                row.push(short(distance.largest));
                row.push(format!("{:.0}", 100.0 * distance.unpaired));
            }
            row
        };
        self.family.iter().enumerate().map(row).collect()
    }
}

/// The threshold that a figure is about, of every curve and speed.
fn picked(dataset: &StoredArrays<'_>, name: &str, kind: &ThresholdFigure) -> Option<Vec<Picked>> {
    let speeds = reals(dataset, "velocity")?.len().max(1);
    let most = (*dataset.variable(name)?.shape.last()?).max(1);
    let curve = |roots: &[f64]| {
        let on = curves_of(roots, most);
        let picks = roots.chunks(most).zip(on.chunks(most)).map(|(at, on)| {
            let place = (kind.pick)(at);
            (place.map_or(f64::NAN, |place| at[place]), place.and_then(|place| on[place]))
        });
        let (values, on) = picks.unzip();
        Picked { values, on }
    };
    Some(reals(dataset, name)?.chunks(most * speeds).map(curve).collect())
}

/// How far two curves of thresholds are from each other.
struct Distance {
    /// Median over the speeds of the larger threshold over the smaller.
    median: f64,
    /// The same, the largest.
    largest: f64,
    /// Share of the speeds at which one of the two has a threshold and the other none.
    unpaired: f64,
}

impl Distance {
    fn between(a: &[f64], b: &[f64]) -> Self {
        let pairs = || a.iter().zip(b);
        let both = pairs().filter(|(a, b)| a.is_finite() && b.is_finite());
        let mut factors: Vec<f64> = both.map(|(a, b)| (a / b).max(b / a)).collect();
        factors.sort_by(f64::total_cmp);
        let single = pairs().filter(|(a, b)| a.is_finite() != b.is_finite()).count();
        Self {
            median: factors.get(factors.len() / 2).copied().unwrap_or(f64::NAN),
            largest: factors.last().copied().unwrap_or(f64::NAN),
            unpaired: single as f64 / a.len().max(1) as f64,
        }
    }
}

/// How far the thresholds move, in numbers.
pub(super) fn table(moved: &[MovedThresholds]) -> PageTable {
    PageTable {
        caption: "The threshold of the full system (Fig. 7: the lowest, Fig. 8: the highest) with one law over that with another, the larger over the smaller: \
                  median and largest over the speeds; and the share of the speeds at which one law has a threshold and the other none. \
                  Factors of thousands stand where a branch ends at another speed and a threshold far from it takes its place."
            .to_owned(),
        head: [
            "figure",
            "friction",
            "curve",
            "printed → computed, median (−)",
            "largest (−)",
            "only one (%)",
            "corrected → computed, median (−)",
            "largest (−)",
            "only one (%)",
        ]
        .map(str::to_owned)
        .to_vec(),
        rows: moved.iter().flat_map(MovedThresholds::rows).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thresholds_are_compared_where_both_laws_have_one() {
        let none = f64::NAN;
        let distance = Distance::between(&[1.0, 2.0, 8.0, none, none], &[2.0, 2.0, 1.0, 3.0, none]);
        assert_eq!((distance.median, distance.largest, distance.unpaired), (2.0, 8.0, 0.2));
        assert_eq!((KINDS[0].pick)(&[0.1, 0.3, none]), Some(0));
        assert_eq!((KINDS[1].pick)(&[0.1, 0.3, none]), Some(1));
    }
}
