//! A map and its overlays as arrays and scalars.

use super::overlays::{Overlay, ToldBoundary};
use crate::error::ModelError;
use judder_oscillator::map::StabilityMap;
use judder_oscillator::mechanism::StabilityClass;
use judder_store::{ByName, Dataset, Declared, Results, Variable};
use judder_study::axis::SweptAxis;

/// What a map leaves in the store.
pub(crate) struct MapArrays<'a> {
    pub(crate) x: &'a SweptAxis,
    pub(crate) y: &'a SweptAxis,
    pub(crate) map: &'a StabilityMap,
    pub(crate) growth: Option<Vec<f64>>,
    pub(crate) overlays: &'a [Overlay],
    pub(crate) words: &'a MapWords,
}

/// How a model calls what is shown of its maps.
pub(crate) struct MapWords {
    /// An instability by one-way coupling of the directions by speed.
    pub(crate) one_way: &'static str,
    pub(crate) stability: &'static str,
    /// The frequency of the oscillation that is born at a boundary.
    pub(crate) frequency: &'static str,
}

/// Those of the oscillator.
pub(super) const WORDS: MapWords = MapWords {
    one_way: NORMAL_FORCE,
    stability: "stability of steady sliding, by mechanism",
    frequency: "frequency of the oscillation born there, ω/ω_nx",
};

/// A map, and the axes that it lies over.
#[derive(Clone, Copy)]
pub(super) struct MapOverAxes<'a> {
    pub(super) x: &'a SweptAxis,
    pub(super) y: &'a SweptAxis,
    pub(super) map: &'a StabilityMap,
}

impl MapOverAxes<'_> {
    /// An array of codes over the map.
    pub(super) fn classes(&self, name: &str, codes: Vec<u8>, meanings: &[(u8, &str)]) -> Variable {
        let shape = [self.map.rows, self.map.columns];
        Variable::classes(name, &[self.y.name(), self.x.name()], &shape, codes, meanings)
    }
}

/// In the oscillator it is the normal force that follows the speed.
pub(crate) const NORMAL_FORCE: &str = "normal-force-coupling";
/// A general system has no normal force.
pub(crate) const ONE_WAY: &str = "one-way-coupling";

impl MapArrays<'_> {
    /// `stability` (codes by row and column), `growth_rate` where every point was decided, and for each overlay its points with NaN
    /// between separate curves.
    pub(crate) fn dataset(self) -> Result<Dataset, ModelError> {
        let dimensions = [self.y.name(), self.x.name()];
        let shape = [self.map.rows, self.map.columns];
        let meanings: Vec<(u8, &str)> = StabilityClass::ALL
            .iter()
            .map(|class| (*class as u8, class_name(*class, self.words.one_way)))
            .collect();
        let classes =
            Variable::classes("stability", &dimensions, &shape, self.map.classes.clone(), &meanings)
                .long_name(self.words.stability);
        let mut dataset =
            Dataset::new().with(self.x.coordinate())?.with(self.y.coordinate())?.with(classes)?;
        if let Some(growth) = self.growth {
            let growth = Variable::new("growth_rate", &dimensions, &shape, growth)
                .units("1")
                .long_name("growth rate max Re(λ)/ω_nx");
            dataset = dataset.with(growth)?;
        }
        for overlay in self.overlays {
            dataset = overlay.add_to(dataset, self.x, self.y, self.words.frequency)?;
        }
        Ok(dataset.attribute("one_way", self.words.one_way)?)
    }
}

/// The name of a class where one-way coupling by speed is called `one_way`.
pub(crate) fn class_name(class: StabilityClass, one_way: &'static str) -> &'static str {
    if class == StabilityClass::NormalForceCoupling { one_way } else { class.name() }
}

/// What is told of a map.
#[derive(Results)]
pub(crate) struct ToldStabilityMap {
    /// decisions made
    points: usize,
    grid: [usize; 2],
    unstable_fraction: f64,
    unresolved: usize,
    /// the share of every class
    fractions: ByName<f64>,
    /// by the clock on the wall
    seconds: f64,
    boundaries: ByName<ToldBoundary>,
}

impl ToldStabilityMap {
    pub(crate) fn new(map: &StabilityMap, one_way: &'static str, seconds: f64, overlays: &[Overlay]) -> Self {
        let total = map.classes.len() as f64;
        let fractions = StabilityClass::ALL
            .iter()
            .map(|class| (class_name(*class, one_way).to_owned(), map.count(*class) as f64 / total));
        Self {
            points: map.decisions,
            grid: [map.columns, map.rows],
            unstable_fraction: map.unstable_fraction(),
            unresolved: map.count(StabilityClass::Unresolved),
            fractions: fractions.collect(),
            seconds,
            boundaries: overlays.iter().map(|own| (own.name.to_owned(), own.summary())).collect(),
        }
    }

    /// The keys of the summary of a map with such a class.
    pub(crate) fn keys(one_way: &'static str) -> Vec<Declared> {
        let classes = StabilityClass::ALL.map(|class| class_name(class, one_way));
        Declared::named(Self::declared(), "fractions", &classes)
    }
}
