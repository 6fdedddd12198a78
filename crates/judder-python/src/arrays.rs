//! Arrays from Python: real, finite, of the shape that is needed, whatever their strides and their kind of number. Each is copied once: the work
//! runs without the interpreter's lock, and meanwhile another thread may change what it was given.

use crate::errors;
use numpy::{PyArrayDyn, PyArrayMethods, PyReadonlyArrayDyn, PyUntypedArrayMethods};
use pyo3::prelude::*;

/// The numbers of an array or of anything that NumPy makes one of.
fn numbers<'py>(name: &str, object: &Bound<'py, PyAny>) -> PyResult<PyReadonlyArrayDyn<'py, f64>> {
    let numpy = object.py().import("numpy")?;
    let array = numpy.call_method1("asarray", (object,));
    let array = array.map_err(|error| errors::input(name, format!("not an array of numbers ({error})")))?;
    let kind: String = array.getattr("dtype")?.getattr("kind")?.extract()?;
    if !matches!(kind.as_str(), "f" | "i" | "u") {
        let dtype = array.getattr("dtype")?;
        return Err(errors::input(name, format!("real numbers are needed, this is an array of {dtype}")));
    }
    let array = numpy.call_method1("asarray", (array, "float64"))?;
    let array = array.cast_into::<PyArrayDyn<f64>>().map_err(PyErr::from)?;
    let array = array.try_readonly().map_err(|error| errors::input(name, error))?;
    let bad = array.as_array().iter().enumerate().find(|(_, value)| !value.is_finite()).map(|(k, v)| (k, *v));
    match bad {
        Some((index, value)) => {
            Err(errors::input(name, format!("value {index} is {value}; every one must be finite")))
        }
        None => Ok(array),
    }
}

/// A one-dimensional array of at least one number.
pub(crate) fn vector(name: &str, object: &Bound<'_, PyAny>) -> PyResult<Vec<f64>> {
    let array = numbers(name, object)?;
    match array.shape() {
        [0] => Err(errors::input(name, "the array is empty")),
        [_] => Ok(array.as_array().iter().copied().collect()),
        shape => Err(errors::input(name, format!("one dimension is needed, the shape is {shape:?}"))),
    }
}

/// A two-dimensional array, row by row, with its rows and columns.
pub(crate) fn matrix(name: &str, object: &Bound<'_, PyAny>) -> PyResult<(Vec<f64>, [usize; 2])> {
    let array = numbers(name, object)?;
    match *array.shape() {
        [rows, columns] if rows * columns > 0 => {
            Ok((array.as_array().iter().copied().collect(), [rows, columns]))
        }
        [_, _] => Err(errors::input(name, "the array is empty")),
        _ => Err(errors::input(name, format!("two dimensions are needed, the shape is {:?}", array.shape()))),
    }
}

/// Two arrays, broadcast against each other, with the shape that they have then.
pub(crate) fn broadcast(
    [(first, one), (second, other)]: [(&str, &Bound<'_, PyAny>); 2],
) -> PyResult<([Vec<f64>; 2], Vec<usize>)> {
    let (one, other) = (numbers(first, one)?, numbers(second, other)?);
    let spread = one.py().import("numpy")?.call_method1("broadcast_arrays", (&*one, &*other));
    let mismatch = |_| {
        let message = format!(
            "the shape {:?} does not go with {:?} of `{first}`; the same is needed, or what NumPy broadcasts",
            other.shape(),
            one.shape()
        );
        errors::input(second, message)
    };
    let (one, other) = spread.map_err(mismatch)?.extract::<(Bound<'_, PyAny>, Bound<'_, PyAny>)>()?;
    let ((one, shape), (other, _)) = (any(first, &one)?, any(second, &other)?);
    Ok(([one, other], shape))
}

/// An array of any shape, with that shape.
pub(crate) fn any(name: &str, object: &Bound<'_, PyAny>) -> PyResult<(Vec<f64>, Vec<usize>)> {
    let array = numbers(name, object)?;
    Ok((array.as_array().iter().copied().collect(), array.shape().to_vec()))
}
