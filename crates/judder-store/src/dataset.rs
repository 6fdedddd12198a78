//! All arrays of one analysis.

use serde_json::{Map, Value};

use crate::name::check_name;
use crate::{StoreError, Variable};

/// Attributes by which readers that follow the CF convention would change the values, or that the store writes itself.
const RESERVED_ATTRIBUTES: [&str; 10] = [
    "_FillValue",
    "_Unsigned",
    "add_offset",
    "calendar",
    "coordinates",
    "dtype",
    "long_name",
    "missing_value",
    "scale_factor",
    "units",
];

/// Units that `xarray` decodes as durations.
const DURATION_UNITS: [&str; 7] =
    ["days", "hours", "minutes", "seconds", "milliseconds", "microseconds", "nanoseconds"];

/// All arrays of one analysis: variables that share dimensions, as an `xarray.Dataset` does.
///
/// Every variable is checked as it joins, so a `Dataset` can always be stored, and opened by `xarray` without a warning.
///
/// ```
/// use judder_store::{Dataset, Variable};
/// let dataset = Dataset::new()
///     .with(Variable::coordinate("velocity", vec![1e-4, 1e-2]).units("1").long_name("speed v_d τ/R"))?
///     .with(Variable::new("growth_rate", &["velocity"], &[2], vec![-0.1, 0.2]).units("1"))?;
/// assert_eq!(dataset.dimension_length("velocity"), Some(2));
/// # Ok::<(), judder_store::StoreError>(())
/// ```
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Dataset {
    variables: Vec<Variable>,
    attributes: Map<String, Value>,
}

impl Dataset {
    /// No variables yet.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// With one more variable.
    ///
    /// # Errors
    /// A name that is taken or cannot be stored; a shape that does not fit the values or the dimension names; a dimension
    /// whose length differs from the variables before; a variable named as a dimension that is not its coordinate; an
    /// attribute or unit that readers would misunderstand.
    pub fn with(self, variable: Variable) -> Result<Self, StoreError> {
        check_filled(&variable)?;
        self.joined_by(variable)
    }

    /// The same for a variable whose values may lie elsewhere.
    pub(crate) fn joined_by(mut self, variable: Variable) -> Result<Self, StoreError> {
        check_variable(&variable)?;
        if self.variable(&variable.name).is_some() {
            return Err(StoreError::Duplicate { what: "variable", name: variable.name });
        }
        for (dimension, &found) in variable.dimensions.iter().zip(&variable.shape) {
            match self.along(dimension) {
                Some((before, expected)) if expected != found => {
                    let (before, dimension) = (before.to_owned(), dimension.clone());
                    let variable = variable.name;
                    return Err(StoreError::DimensionConflict {
                        variable,
                        dimension,
                        before,
                        expected,
                        found,
                    });
                }
                _ => {}
            }
        }
        self.variables.push(variable);
        match self.variables.iter().find(|variable| self.misnames_a_dimension(variable)) {
            Some(variable) => Err(StoreError::NotACoordinate { variable: variable.name.clone() }),
            None => Ok(self),
        }
    }

    /// With an attribute of the whole, as JSON.
    ///
    /// # Errors
    /// A name that readers or the store keep for themselves.
    pub fn attribute(mut self, name: &str, value: impl Into<Value>) -> Result<Self, StoreError> {
        check_attribute("dataset", name)?;
        self.attributes.insert(name.to_owned(), value.into());
        Ok(self)
    }

    /// With further attributes of its variables: those that `of` has for the name of each.
    ///
    /// # Errors
    /// As of [`Dataset::attribute`].
    pub fn described(mut self, of: impl Fn(&str) -> Vec<(&'static str, Value)>) -> Result<Self, StoreError> {
        for variable in &mut self.variables {
            for (name, value) in of(&variable.name) {
                check_attribute(&variable.name, name)?;
                variable.attributes.insert(name.to_owned(), value);
            }
        }
        Ok(self)
    }

    /// With an attribute of the whole dataset before all others.
    ///
    /// # Errors
    /// As of [`Dataset::attribute`].
    pub fn headed(mut self, name: &str, value: impl Into<Value>) -> Result<Self, StoreError> {
        check_attribute("dataset", name)?;
        self.attributes.shift_insert(0, name.to_owned(), value.into());
        Ok(self)
    }

    /// The variables, coordinates among them, in the order in which they joined.
    #[must_use]
    pub fn variables(&self) -> &[Variable] {
        &self.variables
    }

    /// The variable of this name.
    #[must_use]
    pub fn variable(&self, name: &str) -> Option<&Variable> {
        self.variables.iter().find(|variable| variable.name == name)
    }

    /// The attributes of the whole.
    #[must_use]
    pub fn attributes(&self) -> &Map<String, Value> {
        &self.attributes
    }

    /// The length of a dimension, where a variable has it.
    #[must_use]
    pub fn dimension_length(&self, dimension: &str) -> Option<usize> {
        self.along(dimension).map(|(_, length)| length)
    }

    /// The first variable that has a dimension, and its length there.
    fn along(&self, dimension: &str) -> Option<(&str, usize)> {
        self.variables.iter().find_map(|variable| {
            let axis = variable.dimensions.iter().position(|name| name == dimension)?;
            Some((variable.name.as_str(), variable.shape.get(axis).copied()?))
        })
    }

    /// Size of all values, in bytes.
    pub(crate) fn byte_count(&self) -> u64 {
        self.variables.iter().map(|variable| variable.byte_count() as u64).sum()
    }

    /// Whether a variable has the name of a dimension that it does not label: `xarray` refuses such a dataset.
    fn misnames_a_dimension(&self, variable: &Variable) -> bool {
        self.dimension_length(&variable.name).is_some() && variable.dimensions != [variable.name.as_str()]
    }
}

/// Refuses a variable whose values do not fill its shape.
fn check_filled(variable: &Variable) -> Result<(), StoreError> {
    let filled = variable.shape.iter().try_fold(1_usize, |count, &length| count.checked_mul(length));
    if variable.dimensions.len() != variable.shape.len() || filled != Some(variable.data.len()) {
        return Err(StoreError::ShapeMismatch {
            variable: variable.name.clone(),
            dimensions: variable.dimensions.clone(),
            shape: variable.shape.clone(),
            found: variable.data.len(),
        });
    }
    Ok(())
}

/// What else can be checked of a variable alone.
fn check_variable(variable: &Variable) -> Result<(), StoreError> {
    check_name("a variable", &variable.name)?;
    for (axis, dimension) in variable.dimensions.iter().enumerate() {
        check_name("a dimension", dimension)?;
        if variable.dimensions.iter().take(axis).any(|before| before == dimension) {
            return Err(StoreError::Duplicate { what: "dimension", name: dimension.clone() });
        }
    }
    for attribute in variable.attributes.keys() {
        check_attribute(&variable.name, attribute)?;
    }
    if DURATION_UNITS.contains(&variable.units.as_str()) || variable.units.contains(" since ") {
        let (variable, units) = (variable.name.clone(), variable.units.clone());
        return Err(StoreError::DateUnits { variable, units });
    }
    Ok(())
}

fn check_attribute(owner: &str, attribute: &str) -> Result<(), StoreError> {
    if RESERVED_ATTRIBUTES.contains(&attribute) || attribute == crate::metadata::HASH_ATTRIBUTE {
        return Err(StoreError::ReservedAttribute {
            owner: owner.to_owned(),
            attribute: attribute.to_owned(),
        });
    }
    Ok(())
}
