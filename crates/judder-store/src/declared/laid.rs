//! Values of arrays and cells of tables.

use crate::{Cells, Variable};
use num_complex::Complex64;

/// What can be a value of an array.
pub trait Element: Clone {
    /// An array of such values.
    fn variable(name: &str, dimensions: &[&str], shape: &[usize], values: Vec<Self>) -> Variable;
}

/// What can be a cell of a table.
pub trait Cell: Clone {
    /// A column of such cells.
    fn cells(values: Vec<Self>) -> Cells;
}

/// A field that can be an array.
pub trait Array {
    /// The array; none where there is none.
    fn variable(&self, name: &str, dimensions: &[&str]) -> Option<Variable>;
}

/// A field that can be a column of a table.
pub trait Column {
    /// The column; none where there is none.
    fn cells(&self) -> Option<Cells>;
}

/// `Element` of what arrays hold as it is, with the unit that such values have where nobody says another.
macro_rules! element {
    ($($kind:ty: $unit:literal),*) => {$(
        impl Element for $kind {
            fn variable(name: &str, dimensions: &[&str], shape: &[usize], values: Vec<Self>) -> Variable {
                Variable::new(name, dimensions, shape, values).units($unit)
            }
        }
    )*};
}
element!(f64: "1", Complex64: "1", i64: "", String: "");

/// `Cell` of what tables hold as it is.
macro_rules! cell {
    ($($kind:ty),*) => {$(
        impl Cell for $kind {
            fn cells(values: Vec<Self>) -> Cells {
                values.into()
            }
        }
    )*};
}
cell!(f64, i64, String);

/// Not a number where there is none.
impl Element for Option<f64> {
    fn variable(name: &str, dimensions: &[&str], shape: &[usize], values: Vec<Self>) -> Variable {
        let values = values.into_iter().map(|value| value.unwrap_or(f64::NAN)).collect();
        f64::variable(name, dimensions, shape, values)
    }
}

/// Not a number where there is none.
impl Cell for Option<f64> {
    fn cells(values: Vec<Self>) -> Cells {
        let values: Vec<f64> = values.into_iter().map(|value| value.unwrap_or(f64::NAN)).collect();
        values.into()
    }
}

impl Cell for &'static str {
    fn cells(values: Vec<Self>) -> Cells {
        values.into_iter().map(str::to_owned).collect::<Vec<String>>().into()
    }
}

impl<T: Element> Array for Vec<T> {
    fn variable(&self, name: &str, dimensions: &[&str]) -> Option<Variable> {
        Some(T::variable(name, dimensions, &[self.len()], self.clone()))
    }
}

impl<T: Cell> Column for Vec<T> {
    fn cells(&self) -> Option<Cells> {
        Some(T::cells(self.clone()))
    }
}

impl<A: Array> Array for Option<A> {
    fn variable(&self, name: &str, dimensions: &[&str]) -> Option<Variable> {
        self.as_ref()?.variable(name, dimensions)
    }
}

impl<C: Column> Column for Option<C> {
    fn cells(&self) -> Option<Cells> {
        self.as_ref()?.cells()
    }
}

/// Values along several dimensions, the last varies fastest.
#[derive(Debug, Clone, PartialEq)]
pub struct GridValues<T> {
    /// Length of each axis.
    pub shape: Vec<usize>,
    /// The values.
    pub values: Vec<T>,
}

impl<T: Element> Array for GridValues<T> {
    fn variable(&self, name: &str, dimensions: &[&str]) -> Option<Variable> {
        Some(T::variable(name, dimensions, &self.shape, self.values.clone()))
    }
}
