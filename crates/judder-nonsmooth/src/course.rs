//! What a march multiplies over time: how fast the tracks move, what the loads are, how much friction there is.

mod integral;

pub use integral::FactorIntegral;

use crate::NonsmoothError;
use judder_assembly::assembly::Assembly;
use judder_assembly::friction::check_table;
use judder_assembly::interface::{Asperity, ForceAt, InterfaceLaw, PointForces};
use judder_assembly::row::Row;
use judder_numerics::order::sort_by_number;
use judder_numerics::ramp::{half_cosine, straight};
use std::f64::consts::PI;
use std::sync::Arc;

/// A factor over time.
#[derive(Debug, Clone, PartialEq)]
pub enum TimeFactor {
    /// The same at all times.
    Constant(f64),
    /// Straight between times, constant before the first and after the last.
    Table(TimeTable),
    /// Half a cosine from 0 to 1 over this time in s, and 1 after it.
    Rise(f64),
}

/// Values at times.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct TimeTable {
    /// In s, ascending.
    pub times: Vec<f64>,
    /// As many.
    pub values: Vec<f64>,
}

/// The course of a march: what its speeds, loads and friction coefficients are multiplied by.
#[derive(Debug, Clone, PartialEq)]
pub struct Course {
    /// How fast the tracks move, with what their passing material brings.
    pub speed: TimeFactor,
    /// The loads.
    pub load: TimeFactor,
    /// The friction of all contacts, by all of these.
    pub friction: Vec<TimeFactor>,
}

impl TimeTable {
    /// Whether its times ascend and there are as many values, all finite.
    ///
    /// # Errors
    /// [`NonsmoothError::Assembly`] with the number to blame.
    pub fn check(&self) -> Result<(), NonsmoothError> {
        check_table(["a time of a table", "values of a table over time"], &self.times, self.values.len())?;
        finite("a value of a table over time", &self.values)
    }

    /// How close two of its times lie at least, in s; none of one.
    #[must_use]
    pub fn closest(&self) -> Option<f64> {
        self.times.windows(2).map(|pair| pair[1] - pair[0]).reduce(f64::min)
    }

    /// The value at a time in s.
    #[must_use]
    pub fn at(&self, time: f64) -> f64 {
        straight(&self.times, &self.values, time).0
    }
}

impl TimeFactor {
    /// Whether its numbers make a factor.
    ///
    /// # Errors
    /// [`NonsmoothError::InvalidNumber`], and what [`TimeTable::check`] says.
    pub fn check(&self) -> Result<(), NonsmoothError> {
        match self {
            Self::Constant(value) => finite("a factor", &[*value]),
            Self::Table(table) => table.check(),
            Self::Rise(time) if time.is_finite() && *time >= 0.0 => Ok(()),
            Self::Rise(time) => Err(NonsmoothError::InvalidNumber {
                name: "the time over which a factor rises",
                value: *time,
                requirement: "finite and not negative",
            }),
        }
    }

    /// Its value at a time in s.
    #[must_use]
    pub fn at(&self, time: f64) -> f64 {
        match self {
            Self::Constant(value) => *value,
            Self::Table(table) => table.at(time),
            Self::Rise(duration) => half_cosine(time, *duration),
        }
    }

    /// How fast it changes at a time in s, in 1/s; at a corner of a table as after it.
    #[must_use]
    pub fn rate(&self, time: f64) -> f64 {
        match self {
            Self::Constant(_) => 0.0,
            Self::Rise(duration) if (0.0..*duration).contains(&time) => {
                0.5 * PI / duration * libm::sin(PI * time / duration)
            }
            Self::Rise(_) => 0.0,
            Self::Table(TimeTable { times, values }) => match times.partition_point(|own| *own <= time) {
                next if next == 0 || next == times.len() => 0.0,
                next => (values[next] - values[next - 1]) / (times[next] - times[next - 1]),
            },
        }
    }

    /// Its integral over time.
    #[must_use]
    pub fn integral(&self) -> FactorIntegral {
        FactorIntegral::new(self.clone())
    }

    /// Whether it does not change.
    #[must_use]
    pub fn is_constant(&self) -> bool {
        match self {
            Self::Constant(_) => true,
            Self::Table(table) => table.values.iter().all(|value| *value == table.values[0]),
            Self::Rise(_) => false,
        }
    }

    /// Whether it is 1 at all times.
    #[must_use]
    pub fn is_one(&self) -> bool {
        *self == Self::Constant(1.0)
    }

    /// The factors that a table gives for a quantity which is given over time: straight between times where the quantity passes an entry of the table.
    ///
    /// # Errors
    /// [`NonsmoothError::OutsideTable`] where the quantity leaves the table, which is not extrapolated; what [`TimeTable::check`] says of either.
    pub fn over(
        name: &'static str,
        quantity: &TimeTable,
        [places, factors]: [&[f64]; 2],
    ) -> Result<Self, NonsmoothError> {
        quantity.check()?;
        check_table([name, "factors of a table"], places, factors.len())?;
        finite("a factor", factors)?;
        let (first, last) = (places[0], places[places.len() - 1]);
        let is_outside = |(_, value): &(&f64, &f64)| !(first..=last).contains(*value);
        if let Some((time, value)) = quantity.times.iter().zip(&quantity.values).find(is_outside) {
            return Err(NonsmoothError::OutsideTable { name, time: *time, value: *value, first, last });
        }
        let mut made = TimeTable::default();
        for (times, values) in quantity.times.windows(2).zip(quantity.values.windows(2)) {
            let ([from, to], [before, after]) = ([times[0], times[1]], [values[0], values[1]]);
            made.times.push(from);
            made.values.push(straight(places, factors, before).0);
            let passed = |place: &&f64| (**place > before.min(after)) && (**place < before.max(after));
            let mut corners: Vec<(f64, f64)> = places
                .iter()
                .zip(factors)
                .filter(|(place, _)| passed(place))
                .map(|(place, factor)| (from + (to - from) * ((place - before) / (after - before)), *factor))
                .collect();
            sort_by_number(&mut corners, |own| own.0);
            for (time, factor) in corners {
                // one that rounding puts on another is no corner
                if made.times.last().is_some_and(|before| *before < time) && time < to {
                    made.times.push(time);
                    made.values.push(factor);
                }
            }
        }
        made.times.extend(quantity.times.last());
        made.values.extend(quantity.values.last().map(|last| straight(places, factors, *last).0));
        Ok(Self::Table(made))
    }
}

/// Everything as the assembly has it, at all times.
impl Default for Course {
    fn default() -> Self {
        let one = || TimeFactor::Constant(1.0);
        Self { speed: one(), load: one(), friction: Vec::new() }
    }
}

impl Course {
    /// Whether everything is as the assembly has it, at all times.
    #[must_use]
    pub fn is_constant(&self) -> bool {
        [&self.speed, &self.load].into_iter().chain(&self.friction).all(TimeFactor::is_one)
    }

    /// Whether its numbers make a course; friction is not negative.
    ///
    /// # Errors
    /// What [`TimeFactor::check`] says; [`NonsmoothError::InvalidNumber`].
    pub fn check(&self) -> Result<(), NonsmoothError> {
        [&self.speed, &self.load].into_iter().chain(&self.friction).try_for_each(TimeFactor::check)?;
        self.friction.iter().try_for_each(not_negative)
    }

    /// What friction is multiplied by at a time in s.
    #[must_use]
    pub fn friction_at(&self, time: f64) -> f64 {
        self.friction.iter().map(|factor| factor.at(time)).product()
    }

    /// Whether at the start everything is as the assembly has it.
    #[must_use]
    pub fn starts_as_given(&self) -> bool {
        [self.speed.at(0.0), self.load.at(0.0), self.friction_at(0.0)] == [1.0; 3]
    }

    /// The assembly as a motion begins: with the loads, friction and speeds of the start. A track that stands then is one that just begins to move: all of its friction
    /// is drawn on, in the direction in which it will drag.
    #[must_use]
    pub fn first(&self, assembly: &Assembly) -> Assembly {
        /// Of the speed of a track that just begins to move.
        const LEAST: f64 = 1e-9;
        let (speed, load, friction) = (self.speed.at(0.0), self.load.at(0.0), self.friction_at(0.0));
        let speed = if speed.abs() < LEAST { LEAST } else { speed };
        let mut first = assembly.clone();
        first.load.iter_mut().for_each(|own| *own *= load);
        for interface in &mut first.interfaces {
            for point in &mut interface.points {
                point.velocity = point.velocity.map(|own| speed * own);
                let convected = point.convected.iter_mut().flatten();
                convected.for_each(|row| *row = Row::sum([(speed, &*row)]));
            }
            interface.law = match &interface.law {
                InterfaceLaw::Rigid(law) => InterfaceLaw::Rigid(law.scaled(friction)),
                InterfaceLaw::Compliant(pressure, law) => {
                    InterfaceLaw::Compliant(pressure.clone(), law.scaled(friction))
                }
                InterfaceLaw::Asperity(law) => {
                    InterfaceLaw::Asperity(Arc::new(ScaledAsperity { law: Arc::clone(law), friction }))
                }
            };
        }
        first
    }
}

/// A contact with another friction.
#[derive(Debug)]
struct ScaledAsperity {
    law: Arc<dyn Asperity>,
    friction: f64,
}

impl Asperity for ScaledAsperity {
    fn forces(&self, closure: f64, speed: f64) -> PointForces {
        let PointForces { normal, friction } = self.law.forces(closure, speed);
        let scaled = |value: f64| self.friction * value;
        let friction = ForceAt {
            value: scaled(friction.value),
            by_closure: scaled(friction.by_closure),
            by_speed: scaled(friction.by_speed),
        };
        PointForces { normal, friction }
    }
}

/// Refuses a factor that is negative at some time.
fn not_negative(factor: &TimeFactor) -> Result<(), NonsmoothError> {
    let values = match factor {
        TimeFactor::Constant(value) => std::slice::from_ref(value),
        TimeFactor::Table(table) => table.values.as_slice(),
        TimeFactor::Rise(_) => &[],
    };
    match values.iter().find(|value| **value < 0.0) {
        Some(value) => Err(NonsmoothError::InvalidNumber {
            name: "a factor of friction",
            value: *value,
            requirement: "not negative",
        }),
        None => Ok(()),
    }
}

/// Refuses a number that is none.
fn finite(name: &'static str, values: &[f64]) -> Result<(), NonsmoothError> {
    match values.iter().find(|value| !value.is_finite()) {
        Some(value) => Err(NonsmoothError::InvalidNumber { name, value: *value, requirement: "finite" }),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table(times: &[f64], values: &[f64]) -> TimeTable {
        TimeTable { times: times.to_vec(), values: values.to_vec() }
    }

    #[test]
    fn factors_have_their_values() {
        let stop = TimeFactor::Table(table(&[0.0, 3.0], &[1.0, 0.0]));
        assert_eq!([-1.0, 0.0, 1.5, 3.0, 4.0].map(|time| stop.at(time)), [1.0, 1.0, 0.5, 0.0, 0.0]);
        assert_eq!([0.0, 2.0].map(|time| TimeFactor::Rise(2.0).at(time)), [0.0, 1.0]);
        let both = Course { friction: vec![stop, TimeFactor::Constant(2.0)], ..Course::default() };
        assert_eq!(both.friction_at(1.5), 1.0);
        assert!(Course::default().is_constant() && !both.is_constant() && !both.starts_as_given());
    }

    /// A quantity that goes up and down through a table: the factor is the table's at every time, not only at those that are given.
    #[test]
    fn a_factor_over_a_quantity_is_that_of_its_table() {
        let quantity = table(&[0.0, 1.0, 4.0], &[20.0, 220.0, 70.0]);
        let (places, factors) = ([20.0, 100.0, 150.0, 300.0], [1.0, 0.8, 1.1, 0.2]);
        let factor = TimeFactor::over("a temperature", &quantity, [&places, &factors]).unwrap();
        for k in 0..=800 {
            let time = f64::from(k) / 200.0;
            let expected = straight(&places, &factors, quantity.at(time)).0;
            assert!((factor.at(time) - expected).abs() < 1e-12, "{time}: {} {expected}", factor.at(time));
        }
        let hotter = table(&[0.0, 1.0], &[20.0, 301.0]);
        assert_eq!(
            TimeFactor::over("a temperature", &hotter, [&places, &factors]).unwrap_err().to_string(),
            "a temperature is 301 at 1 s, outside of the table of factors, which goes from 20 to 300 and is not extrapolated"
        );
    }

    #[test]
    fn what_makes_no_factor_is_refused() {
        let refused = |factor: TimeFactor| factor.check().unwrap_err().to_string();
        let unsorted = refused(TimeFactor::Table(table(&[0.0, 2.0, 1.0], &[1.0; 3])));
        assert_eq!(unsorted, "a time of a table is 1: it must be above the one before");
        assert!(
            refused(TimeFactor::Table(table(&[0.0, 1.0], &[1.0]))).contains("there are 1, but must be 2")
        );
        assert!(refused(TimeFactor::Table(table(&[], &[]))).contains("there are 0, but must be 1"));
        assert!(refused(TimeFactor::Table(table(&[0.0], &[f64::NAN]))).contains("it must be finite"));
        assert!(refused(TimeFactor::Rise(-1.0)).contains("-1: it must be finite and not negative"));
        let course = Course { friction: vec![TimeFactor::Constant(-0.1)], ..Course::default() };
        assert_eq!(
            course.check().unwrap_err().to_string(),
            "a factor of friction is -0.1: it must be not negative"
        );
    }
}
