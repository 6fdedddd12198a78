//! Swept quantities as axes of arrays.

use crate::labels::{key, parameter};
use crate::oscillator::case::OscillatorCase;
use crate::oscillator::inputs::OscillatorInputs;
use crate::oscillator::keys::OscillatorKey;
use crate::sweep::{Family, ParameterKey, Sweep};
use judder_keys::keys::Keys;
use judder_numerics::words::plain;
use judder_oscillator::critical;
use judder_store::{Declared, Results, Told, ValueKind, Variable};
use judder_study::axis::{SweptAxis, coordinate};
use judder_study::case::scale::Spacing;
use judder_study::labels::SweptQuantity;
use serde_json::{Map, Value, json};

/// A swept key of a case as an axis.
pub(crate) fn of_key<K: Keys>(sweep: &Sweep<K>) -> SweptAxis {
    SweptAxis {
        quantity: key(sweep.key, sweep.form),
        values: sweep.values(),
        scale: sweep.scale,
        shown: None,
    }
}

/// A swept parameter of a two-degrees case as an axis.
pub(crate) fn of_parameter(sweep: &Sweep<ParameterKey>) -> SweptAxis {
    SweptAxis {
        quantity: parameter(name_of(&sweep.path)),
        values: sweep.values(),
        scale: sweep.scale,
        shown: None,
    }
}

/// The name of a parameter in its dotted path.
pub(crate) fn name_of(path: &str) -> &str {
    path.rsplit('.').next().unwrap_or(path)
}

/// The range of a sweep, for searches and continuation.
pub(crate) fn range<K>(sweep: &Sweep<K>) -> critical::ParameterRange {
    let scale = match sweep.scale {
        Spacing::Linear => critical::RangeScale::Linear,
        Spacing::Log => critical::RangeScale::Logarithmic,
    };
    critical::ParameterRange { from: sweep.from, to: sweep.to, scale }
}

/// The key that differs from curve to curve.
#[derive(Results)]
struct ToldFamily<'a> {
    /// its path
    key: &'a str,
    /// its values
    values: &'a [f64],
}

/// The keys of a summary, of which `curve` are those of a curve.
pub(crate) fn keys_of_curves(has_family: bool, curve: Vec<Declared>) -> Vec<Declared> {
    if !has_family {
        return curve;
    }
    let curves = ValueKind::Object(curve).list();
    vec![Declared::new("family", ToldFamily::kind()), Declared::new("curves", curves)]
}

/// The curves of an analysis: one operating point to start from for each value of the family, or one alone.
pub(crate) struct Curves<I = OscillatorInputs> {
    family: Option<(SweptQuantity, Vec<f64>, String)>,
    pub(crate) inputs: Vec<I>,
}

impl Curves {
    pub(crate) fn new(case: &OscillatorCase, family: Option<&Family<OscillatorKey>>) -> Self {
        let Some(family) = family else { return Self { family: None, inputs: vec![case.inputs] } };
        let inputs = family.values.iter().map(|value| {
            let mut inputs = case.inputs;
            family.set(&mut inputs, *value);
            inputs
        });
        let quantity = key(family.key, family.form);
        Self {
            family: Some((quantity, family.values.clone(), family.path.clone())),
            inputs: inputs.collect(),
        }
    }

    /// One curve, of a case that has no operating points.
    pub(crate) fn alone() -> Self {
        Self { family: None, inputs: vec![OscillatorInputs::default()] }
    }
}

impl Curves<Vec<f64>> {
    /// Curves over parameters with these values; the family's dimension is named `family`, for parameters may have any name.
    pub(crate) fn of_parameters(values: Vec<f64>, family: Option<&Family<ParameterKey>>) -> Self {
        let Some(family) = family else { return Self { family: None, inputs: vec![values] } };
        let inputs = family.values.iter().map(|value| {
            let mut inputs = values.clone();
            if let Some(parameter) = inputs.get_mut(family.key.index()) {
                *parameter = *value;
            }
            inputs
        });
        let quantity = SweptQuantity { name: "family".to_owned(), ..parameter(name_of(&family.path)) };
        Self {
            inputs: inputs.collect(),
            family: Some((quantity, family.values.clone(), family.path.clone())),
        }
    }
}

impl<I> Curves<I> {
    /// The family's coordinate, where there is one.
    pub(crate) fn coordinate(&self) -> Option<Variable> {
        let (quantity, values, _) = self.family.as_ref()?;
        Some(coordinate(quantity, values.clone()))
    }

    /// Dimension names and shape of an array over family, axis and further dimensions.
    pub(crate) fn dimensions<'a>(
        &'a self,
        axis: &'a SweptAxis,
        further: &[(&'a str, usize)],
    ) -> (Vec<&'a str>, Vec<usize>) {
        let family = self.family.as_ref().map(|(quantity, values, _)| (quantity.name.as_str(), values.len()));
        family.into_iter().chain([(axis.name(), axis.values.len())]).chain(further.iter().copied()).unzip()
    }

    /// The scalars of a run: the one curve's own, or a list of curves with the family's values; [`keys_of_curves`] declares them.
    pub(crate) fn scalars(&self, curves: Vec<Map<String, Value>>) -> Map<String, Value> {
        match &self.family {
            None => curves.into_iter().next().unwrap_or_default(),
            Some((_, values, path)) => {
                let mut all = Map::new();
                all.insert("family".to_owned(), ToldFamily { key: path, values }.told());
                all.insert("curves".to_owned(), json!(curves));
                all
            }
        }
    }

    /// What tells a curve in a message: parameter = value; `None` where there is one alone.
    pub(crate) fn told(&self, curve: usize) -> Option<String> {
        let (quantity, values, _) = self.family.as_ref()?;
        Some(format!("{} = {}", quantity.symbol, plain(*values.get(curve)?)))
    }

    /// The family's name and, for each curve, its value; for tables.
    pub(crate) fn column(&self, rows_of_curve: &[usize]) -> Option<(String, String, Vec<f64>)> {
        let (quantity, values, _) = self.family.as_ref()?;
        let column =
            values.iter().zip(rows_of_curve).flat_map(|(value, rows)| std::iter::repeat_n(*value, *rows));
        Some((quantity.name.clone(), quantity.unit.clone(), column.collect()))
    }
}
