//! The bifurcation diagram as scalars, arrays and a table.

use super::branches::SimulatedCycle;
use super::point::{SettledPoint, Settling};
use crate::error::ModelError;
use crate::motion::becomes::{BECOMES, CYCLE, LOST, UNCONFIRMED};
use crate::motion::bifurcation::SweepDirection;
use crate::motion::model::Coordinate;
use crate::motion::si::{SiUnits, stored_beside};
use judder_numerics::words::plain;
use judder_store::{Dataset, Results, Table, Variable};
use judder_study::axis::SweptAxis;

/// All sweeps along the axis.
pub(super) struct SweptDiagram<'a> {
    pub(super) axis: SweptAxis,
    pub(super) directions: &'a [SweepDirection],
    pub(super) sweeps: &'a [Vec<SettledPoint>],
    /// The units at each value in SI, where the case is written in SI.
    pub(super) si: Option<Vec<SiUnits>>,
}

/// What is told of the motions of all sweeps.
#[derive(Results)]
#[results(columns(
    direction,
    becomes,
    rms,
    period,
    quasi_steady_condition,
    stick_fraction,
    lift_off_fraction
))]
pub(super) struct ToldDiagram {
    /// the swept key
    key: String,
    /// its values
    value: Vec<f64>,
    direction: Vec<&'static str>,
    rms: Vec<f64>,
    becomes: Vec<&'static str>,
    period: Vec<f64>,
    quasi_steady_condition: Vec<f64>,
    stick_fraction: Vec<f64>,
    lift_off_fraction: Vec<f64>,
    /// the rms in m
    #[result(optional)]
    rms_m: Option<Vec<f64>>,
    /// the period in s
    #[result(optional)]
    period_s: Option<Vec<f64>>,
}

impl SweptDiagram<'_> {
    fn points(&self) -> impl Iterator<Item = &SettledPoint> {
        self.sweeps.iter().flatten()
    }

    /// One quantity of every point, NaN where the motion is lost.
    fn values(&self, value: impl Fn(&Settling) -> f64) -> Vec<f64> {
        self.points().map(|point| point.as_ref().map_or(f64::NAN, &value)).collect()
    }

    /// Every cycle that a motion has settled to.
    pub(super) fn cycles<const N: usize>(&self) -> Vec<SimulatedCycle<N>> {
        let cycle = |(value, point): (f64, &SettledPoint)| {
            let settling = point.as_ref().ok().filter(|settling| settling.becomes == CYCLE)?;
            Some(SimulatedCycle {
                value,
                start: settling.state.as_slice().try_into().ok()?,
                oscillations: settling.returns.len(),
                rms: settling.rms,
                period: settling.period?,
            })
        };
        self.places().0.into_iter().zip(self.points()).filter_map(cycle).collect()
    }

    fn becomes(&self) -> impl Iterator<Item = u8> {
        self.points().map(|point| point.as_ref().map_or(LOST, |settling| settling.becomes))
    }

    fn quasi_steady_condition(&self) -> Vec<f64> {
        self.values(|settling| settling.quasi_steady_condition.unwrap_or(f64::NAN))
    }

    fn period(&self) -> Vec<f64> {
        self.values(|settling| settling.period.unwrap_or(f64::NAN))
    }

    /// The swept value and the direction of every point, in their order.
    fn places(&self) -> (Vec<f64>, Vec<&'static str>) {
        let values = self.directions.iter().flat_map(|_| self.axis.values.iter().copied());
        let names = self
            .directions
            .iter()
            .flat_map(|direction| std::iter::repeat_n(direction.name(), self.axis.values.len()));
        (values.collect(), names.collect())
    }

    fn words(&self) -> Vec<&'static str> {
        self.becomes().map(|becomes| BECOMES[usize::from(becomes)].1).collect()
    }

    pub(super) fn told(&self, key: &str) -> ToldDiagram {
        let (value, direction) = self.places();
        ToldDiagram {
            key: key.to_owned(),
            value,
            direction,
            rms: self.values(|s| s.rms),
            becomes: self.words(),
            period: self.period(),
            quasi_steady_condition: self.quasi_steady_condition(),
            stick_fraction: self.values(|s| s.stick_fraction),
            lift_off_fraction: self.values(|s| s.lift_off_fraction),
            rms_m: self.in_si(self.values(|s| s.rms), |units| units.metre),
            period_s: self.in_si(self.period(), |units| units.second),
        }
    }

    /// A quantity of every point times its unit; none where the case is written in groups.
    fn in_si(&self, values: Vec<f64>, unit: fn(&SiUnits) -> f64) -> Option<Vec<f64>> {
        let units = self.si.as_ref()?;
        let every = self.directions.iter().flat_map(|_| units);
        Some(values.into_iter().zip(every).map(|(value, own)| value * unit(own)).collect())
    }

    /// All arrays in SI too, where the case is written in SI: `units` are those at a value of the swept key.
    pub(super) fn with_si(
        &self,
        dataset: Dataset,
        units: impl Fn(f64) -> Option<SiUnits>,
    ) -> Result<Dataset, ModelError> {
        let Some(all) = &self.si else { return Ok(dataset) };
        match all.first().filter(|first| all.iter().all(|own| own == *first)) {
            Some(same) => same.told_in(dataset),
            None => stored_beside(dataset, units),
        }
    }

    /// Every array; `coordinates` are those of a state.
    pub(super) fn dataset(&self, coordinates: &[Coordinate]) -> Result<Dataset, ModelError> {
        let shape = [self.directions.len(), self.axis.values.len()];
        let dimensions = ["direction", self.axis.name()];
        let over = |name: &str, long_name: &str, values: Vec<f64>| {
            Variable::new(name, &dimensions, &shape, values).units("1").long_name(long_name).apart()
        };
        let names: Vec<String> = self.directions.iter().map(|d| d.name().to_owned()).collect();
        let becomes: Vec<u8> = self.becomes().collect();
        let dataset = Dataset::new()
            .with(Variable::coordinate("direction", names).long_name("which way the key was followed"))?
            .with(self.axis.coordinate())?
            .with(over("rms", "rms of x about its mean", self.values(|s| s.rms)))?
            .with(over("period", "period of a cycle, mean time of an oscillation otherwise", self.period()))?
            .with(over("stick_fraction", "share of the time in stick", self.values(|s| s.stick_fraction)))?
            .with(over(
                "lift_off_fraction",
                "share of the time off the substrate",
                self.values(|s| s.lift_off_fraction),
            ))?
            .with(
                Variable::classes("becomes", &dimensions, &shape, becomes, &BECOMES)
                    .long_name("what the motion settles to"),
            )?;
        self.with_section(dataset, coordinates)
    }

    /// With the meetings of all motions with the section, where x is largest.
    fn with_section(&self, mut dataset: Dataset, coordinates: &[Coordinate]) -> Result<Dataset, ModelError> {
        let (values, directions) = self.places();
        let places = values.iter().zip(&directions).zip(self.points());
        let meetings: Vec<(f64, &str, &[f64])> = places
            .filter_map(|((value, direction), point)| Some((*value, *direction, point.as_ref().ok()?)))
            .flat_map(|(value, direction, settling)| {
                settling.returns.iter().map(move |state| (value, direction, state.as_slice()))
            })
            .collect();
        let count = meetings.len();
        let over =
            |name: &str, values: Vec<f64>| Variable::new(name, &["section"], &[count], values).units("1");
        dataset = dataset
            .with(over("section_value", meetings.iter().map(|m| m.0).collect()).long_name("swept value"))?
            .with(
                Variable::new(
                    "section_direction",
                    &["section"],
                    &[count],
                    meetings.iter().map(|m| m.1.to_owned()).collect::<Vec<_>>(),
                )
                .long_name("which way the key was followed"),
            )?;
        let velocity_x = coordinates.len() / 2;
        for (k, coordinate) in coordinates.iter().enumerate().filter(|(k, _)| *k != velocity_x) {
            let values = meetings.iter().map(|m| m.2[k]).collect();
            dataset = dataset.with(
                over(&format!("section_{}", coordinate.name), values)
                    .long_name(coordinate.long_name)
                    .attribute("label", coordinate.label),
            )?;
        }
        Ok(dataset)
    }

    pub(super) fn table(&self, told: &ToldDiagram) -> Result<Table, ModelError> {
        let axis = Table::new().column(self.axis.name(), &self.axis.quantity.unit, told.value.clone())?;
        let mut table = told.add_columns(axis)?;
        for (name, unit, values) in [("rms", "m", &told.rms_m), ("period", "s", &told.period_s)] {
            if let Some(values) = values {
                table = table.column(name, unit, values.clone())?;
            }
        }
        Ok(table)
    }

    /// How many motions could not be followed or confirmed.
    pub(super) fn warnings(&self) -> Vec<String> {
        self.lost().into_iter().chain(self.unconfirmed()).collect()
    }

    /// How many kinds are not confirmed, and where the first.
    fn unconfirmed(&self) -> Option<String> {
        let (values, directions) = self.places();
        let mut open =
            self.becomes().zip(values.iter().zip(directions)).filter(|(code, _)| *code == UNCONFIRMED);
        let (_, (value, direction)) = open.next()?;
        Some(format!(
            "what {} of {} motions settle to is not confirmed, the first at {}, {direction}: within `duration` they have not settled, finer \
             tolerances tell something else each time, or all motions nearby are cycles; a longer `duration` or a smaller `tolerance` may settle all but the last",
            open.count() + 1,
            values.len(),
            plain(*value)
        ))
    }

    /// How many motions could not be followed, and why the first.
    fn lost(&self) -> Option<String> {
        let (values, directions) = self.places();
        let mut lost = self
            .points()
            .zip(values.iter().zip(directions))
            .filter_map(|(point, place)| Some((point.as_ref().err()?, place)));
        let (reason, (value, direction)) = lost.next()?;
        Some(format!(
            "{} of {} motions cannot be followed, the first at {}, {direction}: {reason}",
            lost.count() + 1,
            values.len(),
            plain(*value)
        ))
    }
}
