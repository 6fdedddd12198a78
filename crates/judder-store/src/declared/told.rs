//! Values of a summary.

use super::ValueKind;
use num_complex::Complex64;
use serde_json::{Map, Value};

/// A value of a summary.
pub trait Told {
    /// What it is.
    fn kind() -> ValueKind;

    /// As JSON.
    fn told(&self) -> Value;
}

/// `Told` of what JSON knows.
macro_rules! told {
    ($($shape:ident: $($kind:ty),*;)*) => {$($(
        impl Told for $kind {
            fn kind() -> ValueKind {
                ValueKind::$shape
            }

            fn told(&self) -> Value {
                Value::from(*self)
            }
        }
    )*)*};
}
told! {
    Number: f64;
    Count: i64, u32, u64, usize;
    Truth: bool;
}

impl Told for String {
    fn kind() -> ValueKind {
        ValueKind::Word
    }

    fn told(&self) -> Value {
        Value::from(self.as_str())
    }
}

impl Told for str {
    fn kind() -> ValueKind {
        ValueKind::Word
    }

    fn told(&self) -> Value {
        Value::from(self)
    }
}

/// Real and imaginary part.
impl Told for Complex64 {
    fn kind() -> ValueKind {
        <[f64; 2]>::kind()
    }

    fn told(&self) -> Value {
        [self.re, self.im].told()
    }
}

impl<T: Told> Told for [T] {
    fn kind() -> ValueKind {
        T::kind().list()
    }

    fn told(&self) -> Value {
        self.iter().map(Told::told).collect()
    }
}

impl<T: Told> Told for Vec<T> {
    fn kind() -> ValueKind {
        <[T]>::kind()
    }

    fn told(&self) -> Value {
        self[..].told()
    }
}

impl<T: Told, const N: usize> Told for [T; N] {
    fn kind() -> ValueKind {
        <[T]>::kind()
    }

    fn told(&self) -> Value {
        self[..].told()
    }
}

impl<T: Told + ?Sized> Told for &T {
    fn kind() -> ValueKind {
        T::kind()
    }

    fn told(&self) -> Value {
        T::told(self)
    }
}

/// `null` where there is none.
impl<T: Told> Told for Option<T> {
    fn kind() -> ValueKind {
        T::kind()
    }

    fn told(&self) -> Value {
        self.as_ref().map_or(Value::Null, Told::told)
    }
}

/// Values of one kind under names that the case decides, in their order.
#[derive(Debug, Clone, PartialEq)]
pub struct ByName<T>(Vec<(String, T)>);

impl<T> FromIterator<(String, T)> for ByName<T> {
    fn from_iter<I: IntoIterator<Item = (String, T)>>(values: I) -> Self {
        Self(values.into_iter().collect())
    }
}

impl<T: Told> Told for ByName<T> {
    fn kind() -> ValueKind {
        ValueKind::ByName(Box::new(T::kind()))
    }

    fn told(&self) -> Value {
        let named: Map<String, Value> =
            self.0.iter().map(|(name, value)| (name.clone(), value.told())).collect();
        Value::Object(named)
    }
}
