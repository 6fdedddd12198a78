//! Arrays of motions in SI: what of them has a dimension, what is stored of that, how it is drawn.

use super::SiUnits;
use crate::array_in_si::{ArrayInSi, FACTOR};
use crate::error::ModelError;
use judder_store::{Dataset, StoreError, Table, Variable, VariableValues};
use judder_study::prefixed::PrefixedUnit;
use serde_json::{Map, Value, json};
use std::borrow::Cow;

/// What is measured by what, of the arrays of motions.
#[derive(Clone, Copy)]
enum MotionDimension {
    Time,
    Length,
    Velocity,
    Frequency,
    Rate,
    Area,
    Force,
}

impl MotionDimension {
    /// Its unit in SI.
    fn unit(self) -> &'static str {
        match self {
            Self::Time => "s",
            Self::Length => "m",
            Self::Velocity => "m/s",
            Self::Frequency => "Hz",
            Self::Rate => "1/s",
            Self::Area => "m²",
            Self::Force => "N",
        }
    }

    /// That in which values up to a largest one are drawn.
    fn drawn(self, largest: f64) -> PrefixedUnit {
        match self {
            Self::Rate => PrefixedUnit { factor: 1.0, name: self.unit().to_owned() },
            _ => PrefixedUnit::of(self.unit(), largest),
        }
    }
}

/// An array of motions that has a dimension.
#[derive(Clone, Copy)]
struct MotionQuantity {
    name: &'static str,
    measured: MotionDimension,
    /// What it is in SI.
    words: &'static str,
    /// What stands at its axis before its unit, where it is drawn.
    label: &'static str,
}

const fn quantity(
    name: &'static str,
    measured: MotionDimension,
    words: &'static str,
    label: &'static str,
) -> MotionQuantity {
    MotionQuantity { name, measured, words, label }
}

/// The coordinates of a state.
const STATES: [MotionQuantity; 4] = [
    quantity("x", MotionDimension::Length, "displacement x along sliding", "Displacement $x$"),
    quantity("y", MotionDimension::Length, "displacement y into the substrate", "Displacement $y$"),
    quantity("velocity_x", MotionDimension::Velocity, "velocity dx/dt", "Velocity d$x$/d$t$"),
    quantity("velocity_y", MotionDimension::Velocity, "velocity dy/dt", "Velocity d$y$/d$t$"),
];
/// How the names of arrays of states begin that are not over the grid of time.
const STATES_AT: [&str; 4] = ["event_", "path_", "section_", "start_"];

/// All others.
const OTHERS: [MotionQuantity; 21] = [
    quantity("time", MotionDimension::Time, "time t", "Time $t$"),
    quantity("event_time", MotionDimension::Time, "time of a change of the contact state", ""),
    quantity("path_time", MotionDimension::Time, "end of a step that does not end in stick", ""),
    quantity("oscillation_time", MotionDimension::Time, "end of an oscillation, where x is largest", ""),
    quantity("oscillation_period", MotionDimension::Time, "time of an oscillation", ""),
    quantity("settling_time", MotionDimension::Time, "time after which that was clear", "Settling time"),
    quantity("period", MotionDimension::Time, "period of a cycle, mean time of an oscillation otherwise", ""),
    quantity("branch_period", MotionDimension::Time, "period", ""),
    quantity("oscillation_amplitude", MotionDimension::Length, "half the range of x", ""),
    quantity(
        "amplitude",
        MotionDimension::Length,
        "amplitude of x about its mean, after the transient",
        "Amplitude of $x$",
    ),
    quantity("rms", MotionDimension::Length, "rms of x about its mean", "rms of $x$"),
    quantity("branch_rms", MotionDimension::Length, "rms of x about its mean", ""),
    quantity("fold_rms", MotionDimension::Length, "rms of the cycle nearest to a fold", ""),
    quantity("frequency", MotionDimension::Frequency, "frequency", "Frequency"),
    quantity(
        "relative_velocity",
        MotionDimension::Velocity,
        "velocity less that of the track",
        "Relative velocity $v_{rel}$",
    ),
    quantity("growth_rate", MotionDimension::Rate, "growth rate", ""),
    quantity(
        "growth_rate_error",
        MotionDimension::Rate,
        "how far the growth rate may be off by the errors of the contact law",
        "",
    ),
    quantity("eigenvalues", MotionDimension::Rate, "eigenvalues λ", ""),
    quantity("conservative_eigenvalues", MotionDimension::Rate, "eigenvalues λ without damping", ""),
    quantity("contact_area", MotionDimension::Area, "contact area A", "Contact area $A$"),
    quantity("normal_force", MotionDimension::Force, "contact force F_k", "Contact force $F_{k}$"),
];

impl MotionQuantity {
    /// That of an array, by its name.
    fn of(name: &str) -> Option<Self> {
        let state = STATES_AT.iter().find_map(|start| name.strip_prefix(start)).unwrap_or(name);
        let other = OTHERS.iter().find(|own| own.name == name);
        other.or_else(|| STATES.iter().find(|own| own.name == state)).copied()
    }

    /// After which quantity those are called that are drawn or reckoned together, and so share a unit.
    fn axis(self) -> &'static str {
        match self.name {
            "branch_rms" | "fold_rms" => "rms",
            "branch_period" => "period",
            "event_time" | "path_time" | "oscillation_time" | "oscillation_period" => "time",
            own => own,
        }
    }
}

impl SiUnits {
    /// What a number in groups is multiplied by to be in SI.
    fn factor(self, measured: MotionDimension) -> f64 {
        match measured {
            MotionDimension::Time => self.second,
            MotionDimension::Length => self.metre,
            MotionDimension::Velocity => self.metre / self.second,
            MotionDimension::Frequency => self.hertz(1.0),
            MotionDimension::Rate => 1.0 / self.second,
            MotionDimension::Area => self.square_metre,
            MotionDimension::Force => self.joule / self.metre,
        }
    }

    /// Says of every array with a dimension what it is in SI, and what the units are.
    pub(crate) fn told_in(self, dataset: Dataset) -> Result<Dataset, ModelError> {
        let told = dataset.described(|name| {
            MotionQuantity::of(name).map_or_else(Vec::new, |quantity| {
                let (unit, factor) = (quantity.measured.unit(), self.factor(quantity.measured));
                ArrayInSi { unit, factor, words: quantity.words }.attributes()
            })
        })?;
        let Self { second, metre, joule, square_metre } = self;
        let own = json!({ "second": second, "metre": metre, "joule": joule, "square_metre": square_metre });
        Ok(told.attribute("si_units", own)?)
    }

    /// A coordinate of a state in SI.
    pub(crate) fn coordinate(self, name: &str, value: f64) -> f64 {
        MotionQuantity::of(name).map_or(value, |quantity| self.factor(quantity.measured) * value)
    }

    /// A quantity as a column in SI beside that in groups; nothing of one without dimension.
    pub(crate) fn add_column(self, table: Table, name: &str, values: &[f64]) -> Result<Table, ModelError> {
        let Some(MotionQuantity { measured, .. }) = MotionQuantity::of(name) else { return Ok(table) };
        let factor = self.factor(measured);
        let in_si: Vec<f64> = values.iter().map(|value| factor * value).collect();
        Ok(table.column(name, measured.unit(), in_si)?)
    }
}

/// What the attributes of a dataset tell that a unit of time is, in s; none where its case is written in groups.
pub(crate) fn second_of(attributes: &Map<String, Value>) -> Option<f64> {
    attributes.get("si_units")?.get("second")?.as_f64().filter(|second| *second > 0.0)
}

/// How an array in SI is called that stands beside that in groups.
fn beside(name: &str) -> String {
    format!("{name}_si")
}

/// Where the values of the swept key are that points of a dimension belong to; those of another are along a coordinate of its name.
const SWEPT_VALUES: [(&str, &str); 4] = [
    ("section", "section_value"),
    ("branch_point", "branch_value"),
    ("fold", "fold_value"),
    ("steady_point", "steady_value"),
];

/// The arrays of a diagram in SI beside those in groups, whose units are `units` of the value of the swept key.
pub(crate) fn stored_beside(
    mut dataset: Dataset,
    units: impl Fn(f64) -> Option<SiUnits>,
) -> Result<Dataset, ModelError> {
    let numbers = |name: &str| match dataset.variable(name).map(|own| &own.data) {
        Some(VariableValues::F64(values)) => values.as_slice(),
        _ => &[],
    };
    let mut in_si = Vec::new();
    for variable in dataset.variables() {
        let (Some(quantity), Some(along)) = (MotionQuantity::of(&variable.name), variable.dimensions.last())
        else {
            continue;
        };
        let swept =
            SWEPT_VALUES.iter().find(|(dimension, _)| dimension == along).map_or(along.as_str(), |own| own.1);
        let factor = |value: &f64| units(*value).map_or(f64::NAN, |own| own.factor(quantity.measured));
        let factors: Vec<f64> = numbers(swept).iter().map(factor).collect();
        let values = numbers(&variable.name).iter().zip(factors.iter().cycle());
        let values: Vec<f64> = values.map(|(value, factor)| factor * value).collect();
        let own = Variable { name: beside(&variable.name), data: values.into(), ..variable.clone() };
        in_si.push(own.units(quantity.measured.unit()).long_name(quantity.words));
    }
    for variable in in_si {
        dataset = dataset.with(variable)?;
    }
    Ok(dataset)
}

/// The arrays of a motion in the units in which they are drawn: SI where the case is written in SI, with the prefix of the largest value on
/// an axis.
pub(crate) fn shown(dataset: &Dataset) -> Cow<'_, Dataset> {
    let in_si: Vec<Option<InSi>> = dataset.variables().iter().map(|own| InSi::of(dataset, own)).collect();
    if in_si.iter().all(Option::is_none) {
        return Cow::Borrowed(dataset);
    }
    let drawn = in_si.iter().map(|own| own.as_ref().map(|own| own.drawn(&in_si))).collect();
    converted(dataset, drawn).map_or(Cow::Borrowed(dataset), Cow::Owned)
}

fn converted(dataset: &Dataset, drawn: Vec<Option<Variable>>) -> Result<Dataset, StoreError> {
    let all = dataset.variables().iter().zip(drawn).map(|(own, drawn)| drawn.unwrap_or_else(|| own.clone()));
    let all = all.into_iter().try_fold(Dataset::new(), Dataset::with)?;
    dataset.attributes().iter().try_fold(all, |all, (name, value)| all.attribute(name, value.clone()))
}

/// An array with its values in SI.
struct InSi<'a> {
    quantity: MotionQuantity,
    variable: &'a Variable,
    values: Vec<f64>,
}

impl<'a> InSi<'a> {
    /// Those of an array; none where it stays as it is.
    fn of(dataset: &Dataset, variable: &'a Variable) -> Option<Self> {
        let quantity = MotionQuantity::of(&variable.name)?;
        let factor = ArrayInSi::of(variable).map(|own| own.factor);
        let (data, factor) = match (factor, dataset.variable(&beside(&variable.name))) {
            (Some(factor), _) => (&variable.data, factor),
            (None, Some(in_si)) => (&in_si.data, 1.0),
            (None, None) => return None,
        };
        let VariableValues::F64(values) = data else { return None };
        Some(Self { quantity, variable, values: values.iter().map(|value| factor * value).collect() })
    }

    /// The array in the unit of the largest value of all that share its axis.
    fn drawn(&self, all: &[Option<Self>]) -> Variable {
        let Self { quantity, variable, values } = self;
        let beside = all.iter().flatten().filter(|own| own.quantity.axis() == quantity.axis());
        let sizes = beside.flat_map(|own| &own.values).map(|value| value.abs());
        let largest = sizes.filter(|size| size.is_finite()).fold(0.0, f64::max);
        let shown = quantity.measured.drawn(largest);
        let data = values.iter().map(|value| shown.factor * value).collect::<Vec<f64>>().into();
        let mut drawn = Variable { data, ..(*variable).clone() }.units(&shown.name).long_name(quantity.words);
        drawn.attributes.shift_remove(FACTOR);
        if !quantity.label.is_empty() {
            drawn = drawn.attribute("label", format!("{} ({})", quantity.label, shown.name));
        }
        drawn
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn in_groups() -> Dataset {
        let over_time = |name: &str| Variable::new(name, &["time"], &[2], vec![1.0, 3.0]).units("1");
        Dataset::new()
            .with(Variable::coordinate("time", vec![0.0, 2.0]).units("1"))
            .and_then(|own| own.with(over_time("x").long_name("displacement x/x0")))
            .and_then(|own| own.with(over_time("contact_area")))
            .and_then(|own| own.with(over_time("oscillation_period")))
            .and_then(|own| own.with(over_time("quasi_steady_condition")))
            .unwrap()
    }

    const UNITS: SiUnits = SiUnits { second: 0.025, metre: 4e-3, joule: 8e-4, square_metre: 1e-4 };

    #[test]
    fn arrays_are_drawn_in_si_where_units_are_known() {
        let told = UNITS.told_in(in_groups()).unwrap();
        let shown_in_si = shown(&told);
        let values = |name: &str| match &shown_in_si.variable(name).unwrap().data {
            VariableValues::F64(values) => values.clone(),
            _ => panic!("numbers"),
        };
        assert_eq!((values("time"), values("x")), (vec![0.0, 50.0], vec![4.0, 12.0]));
        assert_eq!(values("contact_area"), [100.0, 300.0]);
        let told = |name: &str| {
            let own = shown_in_si.variable(name).unwrap();
            (own.units.clone(), own.attributes.get("label").and_then(Value::as_str).map(str::to_owned))
        };
        assert_eq!(told("oscillation_period").0, "ms", "as the time, of which periods are parts");
        assert_eq!(told("x"), ("mm".to_owned(), Some("Displacement $x$ (mm)".to_owned())));
        assert_eq!(told("time"), ("ms".to_owned(), Some("Time $t$ (ms)".to_owned())));
        assert_eq!(values("quasi_steady_condition"), [1.0, 3.0]);
        assert!(matches!(shown(&in_groups()), Cow::Borrowed(_)));
    }

    /// A unit of length in proportion to the load, as x0 = F_n/k_x is.
    #[test]
    fn arrays_whose_units_vary_stand_beside_in_si() {
        let rms = Variable::new("rms", &["direction", "load"], &[2, 2], vec![1.0, 2.0, 3.0, 4.0]);
        let diagram = Dataset::new()
            .with(Variable::coordinate("load", vec![1.0, 2.0]))
            .and_then(|own| own.with(rms.units("1")))
            .and_then(|own| own.with(Variable::new("section_value", &["section"], &[1], vec![2.0])))
            .and_then(|own| own.with(Variable::new("section_x", &["section"], &[1], vec![5.0]).units("1")))
            .unwrap();
        let told = stored_beside(diagram, |load| Some(SiUnits { metre: 1e-6 * load, ..UNITS })).unwrap();
        let rms = told.variable("rms_si").unwrap();
        assert_eq!(rms.data, VariableValues::F64(vec![1e-6, 2e-6 * 2.0, 3e-6, 4.0 * 2e-6]));
        assert_eq!((rms.units.as_str(), rms.dimensions.len()), ("m", 2));
        assert_eq!(told.variable("section_x_si").unwrap().data, VariableValues::F64(vec![2e-6 * 5.0]));
        let shown_in_si = shown(&told);
        assert_eq!(shown_in_si.variable("rms").unwrap().units, "µm");
        assert_eq!(shown_in_si.variable("section_x").unwrap().data, VariableValues::F64(vec![1e6 * 1e-5]));
    }

    #[test]
    fn arrays_say_what_they_are_in_si() {
        let told = UNITS.told_in(in_groups()).unwrap();
        let attribute = |name: &str, key: &str| told.variable(name).unwrap().attributes.get(key).cloned();
        assert_eq!(
            (attribute("x", "si_unit"), attribute("x", FACTOR)),
            (Some("m".into()), Some(4e-3.into()))
        );
        assert_eq!(attribute("x", "si_long_name"), Some("displacement x along sliding".into()));
        assert_eq!(told.variable("x").unwrap().units, "1", "stored is what the model computes in");
        assert_eq!(attribute("quasi_steady_condition", "si_unit"), None);
        assert_eq!(MotionQuantity::of("event_velocity_y").unwrap().words, "velocity dy/dt");
        assert!(MotionQuantity::of("event_rms").is_none());
    }
}
