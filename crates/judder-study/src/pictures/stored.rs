//! Stored arrays as figures read them: each of the type, and over the dimensions, that judder writes, or told as wrong.

use crate::error::WrongArray;
use judder_store::{Dataset, Variable, VariableValues};
use num_complex::Complex64;
use serde_json::{Map, Value};
use std::cell::RefCell;
use std::rc::Rc;

/// The arrays of an analysis while they are drawn.
///
/// An array that is not there is left out of the figure: what there is depends on what was asked. One that is there and is not what judder writes is
/// left out as well, and remembered, so that no figure of it is shown: reading goes on as if it were not there, and whoever draws asks at the end.
#[derive(Debug, Clone)]
pub struct StoredArrays<'a> {
    dataset: &'a Dataset,
    wrong: Rc<RefCell<Option<WrongArray>>>,
}

/// Where arrays are read from.
pub trait ArraySource<'a> {
    /// The array of this name.
    fn stored(&self, name: &str) -> Option<&'a Variable>;

    /// Is told of an array that is not what it should be.
    fn refuse(&self, wrong: WrongArray);
}

impl<'a> ArraySource<'a> for &StoredArrays<'a> {
    fn stored(&self, name: &str) -> Option<&'a Variable> {
        self.dataset.variable(name)
    }

    fn refuse(&self, wrong: WrongArray) {
        self.wrong.borrow_mut().get_or_insert(wrong);
    }
}

impl<'a> ArraySource<'a> for &'a Dataset {
    fn stored(&self, name: &str) -> Option<&'a Variable> {
        self.variable(name)
    }

    fn refuse(&self, _: WrongArray) {}
}

impl<'a> StoredArrays<'a> {
    /// The arrays of a dataset.
    #[must_use]
    pub fn of(dataset: &'a Dataset) -> Self {
        Self { dataset, wrong: Rc::default() }
    }

    /// Other values in their place, such as the same in other units; what is wrong with these is remembered as well.
    #[must_use]
    pub fn replaced<'b>(&self, dataset: &'b Dataset) -> StoredArrays<'b> {
        StoredArrays { dataset, wrong: Rc::clone(&self.wrong) }
    }

    /// What was drawn of them, unless one of those that were read is wrong.
    ///
    /// # Errors
    /// The first array that is not what judder writes.
    pub fn settled<T>(&self, drawn: T) -> Result<T, WrongArray> {
        match self.wrong.take() {
            Some(wrong) => Err(wrong),
            None => Ok(drawn),
        }
    }

    /// All of them.
    #[must_use]
    pub fn dataset(&self) -> &'a Dataset {
        self.dataset
    }

    /// All of them, in the order in which they were written.
    #[must_use]
    pub fn variables(&self) -> &'a [Variable] {
        self.dataset.variables()
    }

    /// The array of this name.
    #[must_use]
    pub fn variable(&self, name: &str) -> Option<&'a Variable> {
        self.dataset.variable(name)
    }

    /// The attributes of the whole.
    #[must_use]
    pub fn attributes(&self) -> &'a Map<String, Value> {
        self.dataset.attributes()
    }

    /// Nothing unless these arrays, as far as they are there, are over the same dimensions; for what is read side by side. Those are right that most
    /// of them have, or most of all arrays, or the first.
    #[must_use]
    pub fn alike(&self, names: &[&str]) -> Option<()> {
        let there: Vec<&Variable> = names.iter().filter_map(|name| self.variable(name)).collect();
        let count = |among: &mut dyn Iterator<Item = &Variable>, own: &Variable| {
            among.filter(|other| other.dimensions == own.dimensions).count()
        };
        let shared = |own: &Variable| {
            (count(&mut there.iter().copied(), own), count(&mut self.variables().iter(), own))
        };
        let Some(usual) = there.iter().rev().copied().max_by_key(|own| shared(own)) else { return Some(()) };
        let dimensions: Vec<&str> = usual.dimensions.iter().map(String::as_str).collect();
        there.iter().try_for_each(|own| self.over(&own.name, &dimensions))
    }

    /// Nothing unless this array, where it is there, is over these dimensions.
    #[must_use]
    pub fn over(&self, name: &str, dimensions: &[&str]) -> Option<()> {
        match self.variable(name) {
            Some(own) if own.dimensions != dimensions => {
                self.refuse_as(own, format!("one over ({})", dimensions.join(", ")))
            }
            _ => Some(()),
        }
    }

    /// Nothing unless this array, where it is there, has so many dimensions, of the given lengths where they are fixed.
    #[must_use]
    pub fn shaped(&self, name: &str, lengths: &[Option<usize>]) -> Option<()> {
        let Some(own) = self.variable(name) else { return Some(()) };
        let is_so = own.shape.len() == lengths.len()
            && own
                .shape
                .iter()
                .zip(lengths)
                .all(|(found, length)| length.is_none_or(|length| length == *found));
        if is_so {
            return Some(());
        }
        let words: Vec<String> = lengths
            .iter()
            .map(|length| length.map_or_else(|| "any".to_owned(), |length| length.to_string()))
            .collect();
        self.refuse_as(own, format!("one of {} dimensions, of lengths ({})", lengths.len(), words.join(", ")))
    }

    /// Refuses this array, where something else is right in its place.
    pub(super) fn refuse_as(&self, own: &Variable, expected: String) -> Option<()> {
        self.refuse(WrongArray::of(own, expected));
        None
    }
}

/// Reads an array of values of one kind; none where there is no such array, or another kind of values.
fn read<'a, T>(
    arrays: impl ArraySource<'a>,
    name: &str,
    kind: &str,
    pick: impl Fn(&'a VariableValues) -> Option<&'a [T]>,
) -> Option<&'a [T]> {
    let own = arrays.stored(name)?;
    let values = pick(&own.data);
    if values.is_none() {
        arrays.refuse(WrongArray::of(own, format!("one of {kind}")));
    }
    values
}

/// The real numbers of this array; none where there is no such array of them.
pub fn reals<'a>(arrays: impl ArraySource<'a>, name: &str) -> Option<&'a [f64]> {
    read(arrays, name, "real numbers", |data| match data {
        VariableValues::F64(values) => Some(values),
        _ => None,
    })
}

/// The complex numbers of this array; none where there is no such array of them.
pub fn complexes<'a>(arrays: impl ArraySource<'a>, name: &str) -> Option<&'a [Complex64]> {
    read(arrays, name, "complex numbers", |data| match data {
        VariableValues::Complex(values) => Some(values),
        _ => None,
    })
}

/// The whole numbers of this array; none where there is no such array of them.
pub fn wholes<'a>(arrays: impl ArraySource<'a>, name: &str) -> Option<&'a [i64]> {
    read(arrays, name, "whole numbers", |data| match data {
        VariableValues::I64(values) => Some(values),
        _ => None,
    })
}

/// The codes of this array of classes; none where there is no such array of them.
pub fn codes<'a>(arrays: impl ArraySource<'a>, name: &str) -> Option<&'a [u8]> {
    read(arrays, name, "codes", |data| match data {
        VariableValues::U8(values) => Some(values),
        _ => None,
    })
}

/// The words of this array; none where there is no such array of them.
pub fn words<'a>(arrays: impl ArraySource<'a>, name: &str) -> Option<&'a [String]> {
    read(arrays, name, "words", |data| match data {
        VariableValues::Text(values) => Some(values),
        _ => None,
    })
}

/// The number at a place of a list; none where the list ends before it.
#[must_use]
pub fn at(values: &[f64], place: usize) -> f64 {
    values.get(place).copied().unwrap_or(f64::NAN)
}

/// The numbers at these places.
#[must_use]
pub fn picked(values: &[f64], places: &[usize]) -> Vec<f64> {
    places.iter().map(|place| at(values, *place)).collect()
}

/// The middle between the ends of a list; none of an empty one.
#[must_use]
pub fn middle(values: &[f64]) -> f64 {
    values.first().zip(values.last()).map_or(f64::NAN, |(first, last)| 0.5 * (first + last))
}
