//! One named array.

use num_complex::Complex64;
use serde_json::{Map, Value};

/// The values of a [`Variable`], row-major (the last dimension varies fastest).
#[derive(Debug, Clone, PartialEq)]
pub enum VariableValues {
    /// Real numbers; NaN where there is none.
    F64(Vec<f64>),
    /// Complex numbers, stored as such: `complex128` in NumPy, so `dataset.eigenvalues.real` works.
    Complex(Vec<Complex64>),
    /// Whole numbers.
    I64(Vec<i64>),
    /// Small codes: classes, flags.
    U8(Vec<u8>),
    /// Labels.
    Text(Vec<String>),
}

impl VariableValues {
    /// How many values there are.
    #[must_use]
    pub fn len(&self) -> usize {
        match self {
            Self::F64(values) => values.len(),
            Self::Complex(values) => values.len(),
            Self::I64(values) => values.len(),
            Self::U8(values) => values.len(),
            Self::Text(values) => values.len(),
        }
    }

    /// Whether there are no values: the answer of a search that found nothing.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Size of one value, in bytes; of a label, a guess.
    #[must_use]
    pub fn value_size(&self) -> usize {
        match self {
            Self::F64(_) | Self::I64(_) => 8,
            Self::Complex(_) | Self::Text(_) => 16,
            Self::U8(_) => 1,
        }
    }
}

/// `From` for each kind of values, so that a plain vector is taken wherever data are.
macro_rules! data_from {
    ($($kind:ident: $value:ty),*) => {$(
        impl From<Vec<$value>> for VariableValues {
            fn from(values: Vec<$value>) -> Self {
                Self::$kind(values)
            }
        }
    )*};
}
data_from!(F64: f64, Complex: Complex64, I64: i64, U8: u8, Text: String);

/// One named array with what a reader must know of it. Checked when it joins a [`Dataset`](crate::Dataset).
///
/// ```
/// use judder_store::Variable;
/// let growth = Variable::new("growth_rate", &["load", "velocity"], &[1, 2], vec![-0.1, 0.2])
///     .units("1")
///     .long_name("growth rate, Re(λ)/ω_nx");
/// assert_eq!(growth.shape, [1, 2]);
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Variable {
    /// Its name: letters, digits, `_`, `-`, `.`.
    pub name: String,
    /// Dimension names, one an axis. A variable over the one dimension of its own name labels that dimension.
    pub dimensions: Vec<String>,
    /// Length of each axis. A length may be 0; no axes at all make a scalar.
    pub shape: Vec<usize>,
    /// The values, row-major.
    pub data: VariableValues,
    /// Unit symbol, `1` where dimensionless, empty where a unit makes no sense (classes, labels).
    pub units: String,
    /// What it is, with its symbol, as it should stand at an axis.
    pub long_name: String,
    /// Whether readers should list it with the coordinates rather than with the results.
    pub is_coordinate: bool,
    /// Further attributes, as JSON (which has no NaN: see [`number`](crate::number)).
    pub attributes: Map<String, Value>,
}

impl Variable {
    /// An array over the named dimensions.
    #[must_use]
    pub fn new(name: &str, dimensions: &[&str], shape: &[usize], data: impl Into<VariableValues>) -> Self {
        Self {
            name: name.to_owned(),
            dimensions: dimensions.iter().map(|&dimension| dimension.to_owned()).collect(),
            shape: shape.to_vec(),
            data: data.into(),
            units: String::new(),
            long_name: String::new(),
            is_coordinate: dimensions == [name],
            attributes: Map::new(),
        }
    }

    /// The coordinate of the dimension `name`: the values along it.
    #[must_use]
    pub fn coordinate(name: &str, values: impl Into<VariableValues>) -> Self {
        let data = values.into();
        Self::new(name, &[name], &[data.len()], data)
    }

    /// A map of classes: a code a point, and what each code means, by the CF convention (`flag_values`,
    /// `flag_meanings`; blanks in a meaning become `_`).
    #[must_use]
    pub fn classes(
        name: &str,
        dimensions: &[&str],
        shape: &[usize],
        codes: Vec<u8>,
        meanings: &[(u8, &str)],
    ) -> Self {
        let values: Vec<u8> = meanings.iter().map(|&(code, _)| code).collect();
        let words: Vec<String> = meanings
            .iter()
            .map(|(_, meaning)| meaning.split_whitespace().collect::<Vec<_>>().join("_"))
            .collect();
        Self::new(name, dimensions, shape, codes)
            .attribute("flag_values", values)
            .attribute("flag_meanings", words.join(" "))
    }

    /// With a unit symbol: `m/s`, `1` where dimensionless.
    #[must_use]
    pub fn units(mut self, units: &str) -> Self {
        units.clone_into(&mut self.units);
        self
    }

    /// With what it is, as it should stand at an axis.
    #[must_use]
    pub fn long_name(mut self, long_name: &str) -> Self {
        long_name.clone_into(&mut self.long_name);
        self
    }

    /// Listed with the coordinates: it labels points along dimensions that it does not name.
    #[must_use]
    pub fn as_coordinate(mut self) -> Self {
        self.is_coordinate = true;
        self
    }

    /// All attributes under which it is stored: long name and units, where it has them, then the others.
    #[must_use]
    pub fn told(&self) -> Map<String, Value> {
        let mut attributes = Map::new();
        for (key, text) in [("long_name", &self.long_name), ("units", &self.units)] {
            if !text.is_empty() {
                attributes.insert(key.into(), text.as_str().into());
            }
        }
        attributes.extend(self.attributes.clone());
        attributes
    }

    /// Size of its values, in bytes, wherever they lie.
    pub(crate) fn byte_count(&self) -> usize {
        match &self.data {
            VariableValues::Text(values) => values.iter().map(String::len).sum(),
            data => self.shape.iter().product::<usize>() * data.value_size(),
        }
    }

    /// With a further attribute.
    #[must_use]
    pub fn attribute(mut self, name: &str, value: impl Into<Value>) -> Self {
        self.attributes.insert(name.to_owned(), value.into());
        self
    }

    /// Says that neighbours along a coordinate need not be of one curve, so that no line may join them: a row is a list, whose n-th entry is not
    /// the n-th of the next row, or every value was found by itself. Pages draw points.
    #[must_use]
    pub fn apart(self) -> Self {
        self.attribute("neighbours", "apart")
    }
}
