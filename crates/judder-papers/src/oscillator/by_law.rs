//! How much of the paper's maps and thresholds is the fit's: the same analyses with the printed, the corrected and the computed law.

mod thresholds;

use super::exhibits::{EXHIBITS, PanelSource};
use super::readings::{READINGS, ReadLaw, Reading};
use super::{analysis_name, computed_for};
use crate::drawn::{StoredAnalysis, made};
use judder_oscillator::mechanism::StabilityClass;
use judder_report::figure::{Class, ClassMap};
use judder_report::page::PageTable;
use judder_report::{Axis, Figure, Layer, PageBlock, PageSection, Panel, Role, UndrawnFigure};
use judder_store::{StudyFolder, Summary};
use judder_study::StudyError;
use judder_study::pictures::{StoredArrays, axis, codes, picked, reals};
use judder_study::report::figure_blocks;

/// The loads that friction can act on.
const LOADS: [&str; 2] = ["normal-load", "contact-force"];
/// The laws with their names in legends and their colours.
const LAWS: [(ReadLaw, &str, Role); 3] = [
    (ReadLaw::Printed, "as printed", Role::Series(1)),
    (ReadLaw::Corrected, "corrected axis", Role::Series(2)),
    (ReadLaw::Computed, "computed", Role::Series(0)),
];
/// Points along each side of a drawn map.
const DRAWN_SIDE: usize = 300;

/// The section on what the fit does to maps and thresholds. A map or a figure that cannot be made says why.
pub(super) fn section(store: &StudyFolder, summary: &Summary) -> Result<PageSection, StudyError> {
    let (mut changes, mut undrawn) = (Vec::new(), Vec::new());
    for source in maps() {
        for load in LOADS {
            let Some(analyses) = stored(store, summary, source, load) else { continue };
            let changed = made(store.path(), &analyses.each_ref(), |maps| ChangedMap::of(source, load, maps));
            let lacking =
                |reason| UndrawnFigure { name: format!("{} in {}", source.name, map_stem(load)), reason };
            match changed {
                Ok(change) => changes.push(change),
                Err(reason) => undrawn.push(PageBlock::Undrawn(lacking(reason))),
            }
        }
    }
    let mut blocks = vec![PageBlock::text(lead(&changes, computed_for(summary)))];
    if !changes.is_empty() {
        blocks.push(PageBlock::Table(table(&changes)));
        for load in LOADS {
            let of_load = changes.iter().filter(|change| change.load == load);
            let panels: Vec<Panel> = of_load.map(ChangedMap::panel).collect();
            if !panels.is_empty() {
                let draw = || Ok(vec![map_figure(panels, load)]);
                blocks.extend(figure_blocks(store, &map_stem(load), draw)?);
            }
        }
    }
    blocks.extend(undrawn);
    let (moved, undrawn) = thresholds::all(store, summary);
    if !moved.is_empty() {
        blocks.push(PageBlock::Table(thresholds::table(&moved)));
    }
    for moved in &moved {
        blocks.extend(figure_blocks(store, &moved.stem(), || Ok(vec![moved.figure()]))?);
    }
    blocks.extend(undrawn.into_iter().map(PageBlock::Undrawn));
    Ok(PageSection::new("How much of the map is the fit's?", blocks))
}

fn sources() -> impl Iterator<Item = &'static PanelSource> {
    EXHIBITS.iter().flat_map(|exhibit| exhibit.sources)
}

fn maps() -> impl Iterator<Item = &'static PanelSource> {
    sources().filter(|source| source.name.starts_with("fig-9") || source.name.starts_with("fig-10"))
}

/// How a friction load reads in a table or a caption.
fn friction(load: &str) -> &'static str {
    if load == LOADS[0] { "$F_{n} μ_{visc}$" } else { "$F_{k} μ_{visc}$" }
}

fn reading(law: ReadLaw, load: &str) -> Option<&'static Reading> {
    READINGS.iter().find(|reading| reading.law == law && reading.friction_load == load)
}

/// What is stored of an analysis with each of [`LAWS`]; `None` where one is not done.
fn stored(
    store: &StudyFolder,
    summary: &Summary,
    source: &PanelSource,
    load: &str,
) -> Option<[StoredAnalysis; 3]> {
    let with = |(law, ..): (ReadLaw, &str, Role)| {
        StoredAnalysis::read(store, summary, &analysis_name(source, reading(law, load)?))
    };
    let [printed, corrected, computed] = LAWS.map(with);
    Some([printed?, corrected?, computed?])
}

/// One map with the three laws.
struct ChangedMap {
    source: &'static PanelSource,
    load: &'static str,
    /// The axes along columns and rows, the same with all three.
    axes: [Axis; 2],
    /// The values along columns and rows.
    places: [Vec<f64>; 2],
    /// The class of every point with each of [`LAWS`].
    classes: [Vec<StabilityClass>; 3],
}

impl ChangedMap {
    /// What the maps with [`LAWS`] say together; nothing unless they are of one plane.
    fn of(source: &'static PanelSource, load: &'static str, maps: &[StoredArrays<'_>]) -> Option<Self> {
        let [plane, ..] = maps else { return None };
        plane.shaped("stability", &[None, None])?;
        let [y_name, x_name] = plane.variable("stability")?.dimensions.as_slice() else { return None };
        let (x, y) = (reals(plane, x_name)?.to_vec(), reals(plane, y_name)?.to_vec());
        let of_law = |map: &StoredArrays<'_>| {
            map.over("stability", &[y_name.as_str(), x_name.as_str()])?;
            map.shaped("stability", &[Some(y.len()), Some(x.len())])?;
            Some(codes(map, "stability")?.iter().map(|code| StabilityClass::from_code(*code)).collect())
        };
        let classes: Option<Vec<Vec<StabilityClass>>> = maps.iter().map(of_law).collect();
        let axes = [axis(plane.variable(x_name)?), axis(plane.variable(y_name)?)];
        Some(Self { source, load, axes, places: [x, y], classes: classes?.try_into().ok()? })
    }

    /// Share of the points that two of the laws class differently.
    fn share(&self, [a, b]: [usize; 2], differs: fn(StabilityClass, StabilityClass) -> bool) -> f64 {
        let pairs = self.classes[a].iter().zip(&self.classes[b]);
        let count = pairs.filter(|(a, b)| differs(**a, **b)).count();
        count as f64 / self.classes[a].len() as f64
    }

    fn verdict_changes(&self, laws: [usize; 2]) -> f64 {
        self.share(laws, |a, b| a.is_unstable() != b.is_unstable())
    }

    fn unstable(&self, law: usize) -> f64 {
        self.share([law, law], |class, _| class.is_unstable())
    }

    /// Where the printed and the computed law decide differently.
    fn panel(&self) -> Panel {
        let ([x, y], [printed, _, computed]) = (&self.places, &self.classes);
        let thinned = |count: usize| -> Vec<usize> {
            let (drawn, last) = (count.min(DRAWN_SIDE), count.saturating_sub(1));
            (0..drawn).map(|k| k * last / (drawn - 1).max(1)).collect()
        };
        let (across, up) = (thinned(x.len()), thinned(y.len()));
        let code = |(printed, computed): (&StabilityClass, &StabilityClass)| match (
            printed.is_unstable(),
            computed.is_unstable(),
        ) {
            (false, false) => 0,
            (true, true) => 1,
            (true, false) => 2,
            (false, true) => 3,
        };
        let at = |row: &usize, column: &usize| {
            let place = row * x.len() + column;
            printed.get(place).zip(computed.get(place)).map(code)
        };
        let codes = up.iter().flat_map(|row| across.iter().filter_map(move |column| at(row, column)));
        let map = ClassMap {
            codes: codes.collect(),
            x: picked(x, &across),
            y: picked(y, &up),
            classes: vec![
                Class::new("stable with both laws", Role::Stable),
                Class::new("unstable with both laws", Role::Reference),
                Class::new("unstable as printed only", Role::Series(1)),
                Class::new("unstable as computed only", Role::Series(0)),
            ],
        };
        let [across, up] = self.axes.clone();
        Panel::new(across, up, vec![Layer::Classes(map)]).with_title(self.source.label)
    }
}

fn lead(changes: &[ChangedMap], computed_for: &str) -> String {
    let between = |laws: [usize; 2]| {
        let shares: Vec<f64> = changes.iter().map(|change| 100.0 * change.verdict_changes(laws)).collect();
        let least = shares.iter().copied().fold(f64::INFINITY, f64::min);
        let most = shares.iter().copied().fold(0.0, f64::max);
        format!("{least:.0} to {most:.0} %")
    };
    if changes.is_empty() {
        return "The maps with the computed law are missing.".to_owned();
    }
    format!(
        "The maps and thresholds with the law computed for {computed_for}, beside those with the printed fits. From the printed to the computed law {} of the \
         points of a map change between stable and unstable: most of that is the velocity axis. From the fits with the corrected axis to the computed \
         law {} change. At low speed and larger loads the threshold hangs on the slope of the contact area over the speed, which is small there: the computed law \
         has the exact one, −(2/π) Σ C_k E_0 τ_k/τ over z, the fits fall like a Gaussian bell.",
        between([0, 2]),
        between([1, 2])
    )
}

fn table(changes: &[ChangedMap]) -> PageTable {
    let per_cent = |share: f64| format!("{:.1}", 100.0 * share);
    let row = |change: &ChangedMap| {
        let mut row = vec![change.source.name.replace("fig-", "Fig. "), friction(change.load).to_owned()];
        row.extend([0, 1, 2].map(|law| per_cent(change.unstable(law))));
        row.extend([[0, 2], [0, 1], [1, 2]].map(|laws| per_cent(change.verdict_changes(laws))));
        row.push(per_cent(change.share([0, 2], |a, b| a != b)));
        row
    };
    PageTable {
        caption: "Shares of the maps' points: unstable with each law; verdict that changes between two laws; verdict or mechanism that changes \
                  from the printed to the computed law."
            .to_owned(),
        head: [
            "map",
            "friction",
            "unstable, printed (%)",
            "unstable, corrected (%)",
            "unstable, computed (%)",
            "printed → computed (%)",
            "printed → corrected (%)",
            "corrected → computed (%)",
            "with mechanism, printed → computed (%)",
        ]
        .map(str::to_owned)
        .to_vec(),
        rows: changes.iter().map(row).collect(),
    }
}

/// The file stem of the drawing of the maps with a friction load.
fn map_stem(load: &str) -> String {
    if load == LOADS[0] { "maps-by-law".to_owned() } else { format!("maps-by-law-{load}") }
}

fn map_figure(panels: Vec<Panel>, load: &str) -> Figure {
    Figure::new(map_stem(load), "Stability maps, printed against computed law", panels).with_caption(format!(
        "Figs. 9 and 10 with {}: where the printed fits and the computed law decide differently between stable and unstable.",
        friction(load)
    ))
}
