//! Results declared once: what an analysis leaves in `summary.json`, among the arrays and in the table, from one struct.

mod laid;
mod told;

pub use judder_store_derive::Results;
pub use laid::{Array, Cell, Column, Element, GridValues};
pub use told::{ByName, Told};

use crate::{Dataset, StoreError, Table};
use serde_json::{Map, Value};

/// What a value of a summary is. Any may be `null`, which reads "none".
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum ValueKind {
    /// A number; `null` where it is not finite.
    Number,
    /// A whole number: how many there are, or which one.
    Count,
    /// Whether something is so.
    Truth,
    /// A word or a sentence.
    Word,
    /// A list, each item of one kind.
    List(Box<ValueKind>),
    /// An object with these keys.
    Object(Vec<Declared>),
    /// An object whose keys the case decides, each value of one kind.
    ByName(Box<ValueKind>),
}

impl ValueKind {
    /// A list of such values.
    #[must_use]
    pub fn list(self) -> Self {
        Self::List(Box::new(self))
    }

    /// The same without the keys of some names.
    fn without(self, names: &[&str]) -> Self {
        match self {
            Self::List(own) => own.without(names).list(),
            Self::ByName(own) => Self::ByName(Box::new(own.without(names))),
            Self::Object(keys) => Self::Object(Declared::without(keys, names)),
            plain => plain,
        }
    }
}

/// A key of a summary.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Declared {
    /// The key.
    pub name: String,
    /// What stands under it.
    pub kind: ValueKind,
    /// Unit symbol of the numbers under it that have none of their own, `1` of plain ones, empty where none is declared: of words, and of what has the unit of a key.
    pub unit: String,
    /// Whether it may be left out.
    pub is_optional: bool,
}

impl Declared {
    /// A key that is always there, with the unit that its name ends in.
    #[must_use]
    pub fn new(name: impl Into<String>, kind: ValueKind) -> Self {
        let name = name.into();
        let unit = unit_of(&name, &kind).to_owned();
        Self { name, kind, unit, is_optional: false }
    }

    /// These keys without those of some names, wherever they are: what settings leave out of all that may be there.
    #[must_use]
    pub fn without(keys: Vec<Self>, names: &[&str]) -> Vec<Self> {
        let rest = keys.into_iter().filter(|key| !names.contains(&key.name.as_str()));
        rest.map(|key| Self { kind: key.kind.without(names), ..key }).collect()
    }

    /// These keys, of which one has values by names that are these and no others.
    #[must_use]
    pub fn named(mut keys: Vec<Self>, name: &str, names: &[impl AsRef<str>]) -> Vec<Self> {
        for key in keys.iter_mut().filter(|key| key.name == name) {
            if let ValueKind::ByName(kind) = &key.kind {
                let own = names.iter().map(|name| Self::new(name.as_ref(), (**kind).clone()));
                key.kind = ValueKind::Object(own.collect());
            }
        }
        keys
    }
}

/// Endings of names of results and the unit that they say, longer ones before those that they end in.
const UNIT_ENDINGS: [(&str, &str); 21] = [
    ("_newton_second_per_metre", "N s/m"),
    ("_newton_per_metre", "N/m"),
    ("_metre_per_second", "m/s"),
    ("_square_metre", "m²"),
    ("_per_pascal", "1/Pa"),
    ("_m_per_n", "m/N"),
    ("_per_s", "1/s"),
    ("_newton", "N"),
    ("_pascal", "Pa"),
    ("_metre", "m"),
    ("_second", "s"),
    ("_joule", "J"),
    ("_hz", "Hz"),
    ("_db", "dB"),
    ("_deg", "°"),
    ("_s", "s"),
    ("_m", "m"),
    ("_fraction", "1"),
    ("_fractions", "1"),
    ("_share", "1"),
    ("_ratio", "1"),
];

/// The unit of what is called so; that of counts and of truths, as 1 and 0, is known without.
fn unit_of(name: &str, kind: &ValueKind) -> &'static str {
    match kind {
        ValueKind::Count | ValueKind::Truth => "1",
        ValueKind::List(own) | ValueKind::ByName(own) => unit_of(name, own),
        ValueKind::Number => {
            UNIT_ENDINGS.iter().find(|(ending, _)| name.ends_with(ending)).map_or("", |(_, unit)| unit)
        }
        ValueKind::Word | ValueKind::Object(_) => "",
    }
}

/// What an analysis leaves: the derive macro of this name writes it, and [`Told`], from the fields of a struct.
///
/// ```
/// use judder_store::{Dataset, Results, Table};
///
/// #[derive(Results)]
/// #[results(along = "mode", arrays(mode, frequency), columns(mode, frequency))]
/// struct Modes {
///     /// number of the mode
///     #[result(hidden)]
///     mode: Vec<i64>,
///     /// natural frequency
///     #[result(summary = "frequencies_hz", unit = "Hz")]
///     frequency: Vec<f64>,
///     /// modes of a free body
///     rigid_modes: usize,
/// }
///
/// let modes = Modes { mode: vec![1, 2], frequency: vec![10.0, f64::NAN], rigid_modes: 0 };
/// let summary = serde_json::Value::Object(modes.scalars());
/// assert_eq!(summary.to_string(), r#"{"frequencies_hz":[10.0,null],"rigid_modes":0}"#);
/// let dataset = modes.add_arrays(Dataset::new())?;
/// assert_eq!(dataset.variables()[1].long_name, "natural frequency");
/// assert_eq!(modes.add_columns(Table::new())?.rows(), 2);
/// # Ok::<(), judder_store::StoreError>(())
/// ```
pub trait Results {
    /// The keys of the summary.
    fn declared() -> Vec<Declared>;

    /// The summary.
    fn scalars(&self) -> Map<String, Value>;

    /// A dataset with the arrays and the attributes.
    ///
    /// # Errors
    /// As [`Dataset::with`].
    fn add_arrays(&self, dataset: Dataset) -> Result<Dataset, StoreError> {
        Ok(dataset)
    }

    /// A table with the columns.
    ///
    /// # Errors
    /// As [`Table::column`].
    fn add_columns(&self, table: Table) -> Result<Table, StoreError> {
        Ok(table)
    }
}

/// Those of what may not be there: every key may be left out.
impl<R: Results> Results for Option<R> {
    fn declared() -> Vec<Declared> {
        R::declared().into_iter().map(|own| Declared { is_optional: true, ..own }).collect()
    }

    fn scalars(&self) -> Map<String, Value> {
        self.as_ref().map(R::scalars).unwrap_or_default()
    }

    fn add_arrays(&self, dataset: Dataset) -> Result<Dataset, StoreError> {
        match self {
            Some(own) => own.add_arrays(dataset),
            None => Ok(dataset),
        }
    }

    fn add_columns(&self, table: Table) -> Result<Table, StoreError> {
        match self {
            Some(own) => own.add_columns(table),
            None => Ok(table),
        }
    }
}

/// Results of which each is a row of a list.
pub trait Rows: Results + Sized {
    /// A dataset with an array for each field of the rows.
    ///
    /// # Errors
    /// As [`Dataset::with`].
    fn add_arrays(_rows: &[Self], dataset: Dataset) -> Result<Dataset, StoreError> {
        Ok(dataset)
    }

    /// A table with a column for each field of the rows.
    ///
    /// # Errors
    /// As [`Table::column`].
    fn add_columns(_rows: &[Self], table: Table) -> Result<Table, StoreError> {
        Ok(table)
    }
}
