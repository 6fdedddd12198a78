//! The table in which an instrument for dynamic mechanical analysis (DMA) hands over its results.

mod error;

pub use error::DmaTableError;

use crate::fields::{lines_of_fields, parted};
use std::f64::consts::TAU;

/// Measured moduli as columns of equal length, in SI units: positive, finite numbers, the frequency rising from row to row of one
/// temperature.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct DmaTable {
    /// ω [rad/s].
    pub angular_frequency: Vec<f64>,
    /// E′ \[Pa\].
    pub storage_modulus: Vec<f64>,
    /// E″ \[Pa\].
    pub loss_modulus: Vec<f64>,
    /// T \[K\], where the table has it.
    pub temperature: Option<Vec<f64>>,
}

/// Reads a table of text with one header line.
///
/// - Columns: frequency (`frequency`, `f`, or `angular frequency`, `omega`, `ω`), storage modulus (`E'`, `E′`, `E1`,
///   `storage modulus`), loss modulus (`E''`, `E″`, `E2`, `loss modulus`), temperature (`temperature`, `T`; may be absent),
///   in any order and case; others are not looked at.
/// - Units in brackets after the name: Hz or rad/s; Pa, kPa, MPa, GPa, N/mm² (or `N/mm^2`, `N/mm2`); K or °C. There is no default.
/// - Fields are separated by semicolons, tabs or commas, whichever the header has, in this order. Decimal points.
/// - Empty lines and lines that begin with `#` are left out.
///
/// # Errors
/// [`DmaTableError`], with the header's columns or the line: what is missing, there twice, without unit, not positive, or does
/// not rise in frequency.
pub fn read_dma_table(text: &str) -> Result<DmaTable, DmaTableError> {
    let mut table = lines_of_fields(text);
    let (header_line, columns) = table.next().ok_or(DmaTableError::Empty)?;
    let header = DmaHeader::of(&columns, header_line)?;
    let mut rows = Vec::new();
    for (line, fields) in table {
        if fields.len() != columns.len() {
            return Err(DmaTableError::Fields { line, found: fields.len(), expected: columns.len() });
        }
        rows.push(header.row(line, &fields)?);
    }
    if rows.is_empty() {
        return Err(DmaTableError::Empty);
    }
    check_order(&rows, &header.frequency)?;
    Ok(DmaTable {
        angular_frequency: rows.iter().map(|row| row.angular_frequency).collect(),
        storage_modulus: rows.iter().map(|row| row.storage_modulus).collect(),
        loss_modulus: rows.iter().map(|row| row.loss_modulus).collect(),
        temperature: rows.iter().map(|row| row.temperature).collect(),
    })
}

/// A row of the table, in SI units.
struct DmaRow {
    line: usize,
    temperature: Option<f64>,
    angular_frequency: f64,
    storage_modulus: f64,
    loss_modulus: f64,
}

/// Refuses a frequency that does not rise above the one before at the same temperature.
fn check_order(rows: &[DmaRow], frequency: &DmaColumn) -> Result<(), DmaTableError> {
    // the number as the file has it, without what its way to rad/s and back has added
    let as_given = |row: &DmaRow| {
        let value = row.angular_frequency / frequency.factor;
        format!("{value:.12e}").parse().unwrap_or(value)
    };
    let falls = |pair: &&[DmaRow]| {
        pair[0].temperature == pair[1].temperature && pair[1].angular_frequency <= pair[0].angular_frequency
    };
    match rows.windows(2).find(falls) {
        Some(pair) => Err(DmaTableError::Order {
            line: pair[1].line,
            before: as_given(&pair[0]),
            after: as_given(&pair[1]),
            unit: frequency.unit,
        }),
        None => Ok(()),
    }
}

/// A quantity that a column may hold: how messages call it, its names, its units with (factor, offset) to SI.
struct DmaQuantity {
    called: &'static str,
    names: &'static [&'static str],
    units: &'static [(&'static str, f64, f64)],
}

const FREQUENCY: DmaQuantity = DmaQuantity {
    called: "frequency (`frequency [Hz]` or `omega [rad/s]`)",
    names: &["frequency", "freq", "f"],
    units: &[("Hz", TAU, 0.0), ("rad/s", 1.0, 0.0)],
};
const ANGULAR_FREQUENCY: DmaQuantity = DmaQuantity {
    called: "frequency (`frequency [Hz]` or `omega [rad/s]`)",
    names: &["angular frequency", "omega", "ω"],
    units: &[("rad/s", 1.0, 0.0)],
};
const MODULUS_UNITS: &[(&str, f64, f64)] = &[
    ("Pa", 1.0, 0.0),
    ("kPa", 1e3, 0.0),
    ("MPa", 1e6, 0.0),
    ("GPa", 1e9, 0.0),
    ("N/mm²", 1e6, 0.0),
    ("N/mm^2", 1e6, 0.0),
    ("N/mm2", 1e6, 0.0),
];
const STORAGE: DmaQuantity = DmaQuantity {
    called: "storage modulus (`E' [MPa]`)",
    names: &["e'", "e1", "storage modulus", "storage modulus e'"],
    units: MODULUS_UNITS,
};
const LOSS: DmaQuantity = DmaQuantity {
    called: "loss modulus (`E'' [MPa]`)",
    names: &["e''", "e2", "loss modulus", "loss modulus e''"],
    units: MODULUS_UNITS,
};
const TEMPERATURE: DmaQuantity = DmaQuantity {
    called: "temperature (`temperature [°C]`)",
    names: &["temperature", "temp", "t"],
    units: &[("K", 1.0, 0.0), ("°C", 1.0, 273.15), ("degC", 1.0, 273.15)],
};

/// Where a quantity stands, and how it becomes SI.
struct DmaColumn {
    index: usize,
    unit: &'static str,
    factor: f64,
    offset: f64,
}

impl DmaColumn {
    /// The positive, finite number in SI of a line's fields.
    fn read(&self, line: usize, fields: &[&str], name: &'static str) -> Result<f64, DmaTableError> {
        let found = fields[self.index];
        let wrong = || DmaTableError::Value { line, name, found: found.to_owned() };
        let given: f64 = found.parse().ok().filter(|given: &f64| given.is_finite()).ok_or_else(wrong)?;
        let value = given * self.factor + self.offset;
        let unit = self.unit;
        match value {
            _ if !value.is_finite() => Err(DmaTableError::TooLarge { line, name, found: given, unit }),
            _ if value.is_normal() && value > 0.0 => Ok(value),
            _ if self.offset != 0.0 => {
                Err(DmaTableError::BelowAbsoluteZero { line, name, found: given, zero: -self.offset, unit })
            }
            _ => Err(DmaTableError::NotPositive { line, name, found: given }),
        }
    }
}

/// Where everything stands.
struct DmaHeader {
    frequency: DmaColumn,
    storage: DmaColumn,
    loss: DmaColumn,
    temperature: Option<DmaColumn>,
}

impl DmaHeader {
    fn of(columns: &[&str], line: usize) -> Result<Self, DmaTableError> {
        let needed = |quantities: &[&DmaQuantity]| {
            let called = quantities[0].called;
            let found = || columns.iter().map(|column| (*column).to_owned()).collect();
            find(columns, quantities, line)?.ok_or_else(|| DmaTableError::MissingColumn {
                line,
                quantity: called,
                found: found(),
            })
        };
        Ok(Self {
            frequency: needed(&[&FREQUENCY, &ANGULAR_FREQUENCY])?,
            storage: needed(&[&STORAGE])?,
            loss: needed(&[&LOSS])?,
            temperature: find(columns, &[&TEMPERATURE], line)?,
        })
    }

    fn row(&self, line: usize, fields: &[&str]) -> Result<DmaRow, DmaTableError> {
        Ok(DmaRow {
            line,
            angular_frequency: self.frequency.read(line, fields, "frequency")?,
            storage_modulus: self.storage.read(line, fields, "storage modulus")?,
            loss_modulus: self.loss.read(line, fields, error::LOSS)?,
            temperature: match &self.temperature {
                Some(column) => Some(column.read(line, fields, "temperature")?),
                None => None,
            },
        })
    }
}

/// The one column that is one of the quantities.
fn find(
    columns: &[&str],
    quantities: &[&DmaQuantity],
    line: usize,
) -> Result<Option<DmaColumn>, DmaTableError> {
    let mut found: Option<(DmaColumn, &str)> = None;
    for (index, column) in columns.iter().enumerate() {
        let (name, unit) = name_and_unit(column);
        let Some(quantity) = quantities.iter().find(|quantity| quantity.names.contains(&name.as_str()))
        else {
            continue;
        };
        if let Some((_, first)) = found {
            let (first, second) = (first.to_owned(), (*column).to_owned());
            return Err(DmaTableError::AmbiguousColumn { line, quantity: quantity.called, first, second });
        }
        let known = quantity.units.iter().find(|(name, ..)| Some(*name) == unit);
        let Some((unit, factor, offset)) = known else {
            let expected = quantity.units.iter().map(|(name, ..)| (*name).to_owned()).collect();
            return Err(DmaTableError::Unit { line, column: (*column).to_owned(), expected });
        };
        found = Some((DmaColumn { index, unit, factor: *factor, offset: *offset }, column));
    }
    Ok(found.map(|(column, _)| column))
}

/// `Storage_modulus (MPa)` as `storage modulus` and `MPa`.
fn name_and_unit(column: &str) -> (String, Option<&str>) {
    let (name, unit) = parted(column);
    let name = name.to_lowercase().replace('_', " ").replace(['′', '’'], "'").replace(['″', '"'], "''");
    (name.split_whitespace().collect::<Vec<_>>().join(" "), unit)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn refused(text: &str) -> String {
        read_dma_table(text).unwrap_err().to_string()
    }

    #[test]
    fn units_and_order_of_columns_are_read() {
        let text = "\u{feff}# a rubber\n\nLoss modulus (kPa);tan delta;E′ [MPa];\"f [Hz]\"\n100;0.1;1.0;0.5\n200;0.1;2.0;5\n";
        let table = read_dma_table(text).unwrap();
        assert_eq!(table.angular_frequency, [std::f64::consts::PI, 10.0 * std::f64::consts::PI]);
        assert_eq!((table.storage_modulus, table.loss_modulus), (vec![1e6, 2e6], vec![1e5, 2e5]));
        assert_eq!(table.temperature, None);
    }

    #[test]
    fn newtons_per_square_millimetre_are_megapascals() {
        let of = |unit: &str| read_dma_table(&format!("f [Hz],E' [{unit}],E'' [{unit}]\n1,2,0.5\n")).unwrap();
        assert_eq!(of("MPa").storage_modulus, [2e6]);
        for unit in ["N/mm²", "N/mm^2", "N/mm2"] {
            assert_eq!(of(unit), of("MPa"), "{unit}");
        }
    }

    #[test]
    fn frequencies_begin_anew_at_every_temperature() {
        let text = "T [°C],omega [rad/s],E1 [Pa],E2 [Pa]\n20,1,5,1\n20,10,6,1\n30,1,4,1\n";
        let table = read_dma_table(text).unwrap();
        assert_eq!(table.angular_frequency, [1.0, 10.0, 1.0]);
        assert_eq!(table.temperature, Some(vec![293.15, 293.15, 303.15]));
    }

    #[test]
    fn headers_that_could_mean_something_else_are_refused() {
        assert!(
            refused("f [Hz],G' [Pa],G'' [Pa]\n1,1,1")
                .contains("has the columns `f [Hz]`, `G' [Pa]`, `G'' [Pa]`; one for the storage")
        );
        assert!(
            refused("f,E' [Pa],E'' [Pa]\n1,1,1")
                .contains("the column `f` of the header, line 1, is without a unit that it can have; write it in brackets, one of `Hz`, `rad/s`")
        );
        assert!(refused("omega [Hz],E' [Pa],E'' [Pa]\n1,1,1").contains("`omega [Hz]` of the header"));
        assert!(
            refused("f [Hz],omega [rad/s],E' [Pa],E'' [Pa]\n1,1,1,1")
                .contains("two columns for the frequency")
        );
        assert!(refused("f [Hz],E' [psi],E'' [Pa]\n1,1,1").contains("`GPa`"));
        assert!(refused("1.0,2e6,3e5\n2.0,2e6,3e5").contains("one for the frequency"));
    }

    #[test]
    fn bad_lines_are_refused_with_their_number() {
        let rows = |rows: &str| refused(&format!("# head\nf [Hz],E' [Pa],E'' [Pa]\n{rows}"));
        assert!(rows("1,1,1\n2,NaN,1").contains("storage modulus in line 4 is `NaN`"));
        assert!(rows("1,1,one").contains("is `one`; it must be a finite number with a decimal point"));
        let signs = rows("1,1,-1");
        assert!(
            signs.contains("loss modulus in line 3 is -1; it must be positive: E = E' + iE''"),
            "{signs}"
        );
        assert!(signs.contains("e^(−iωt) take the complex conjugate") && !signs.contains("point"), "{signs}");
        assert!(rows("1,-1,1").ends_with("the storage modulus in line 3 is -1; it must be positive"));
        assert!(rows("1,1,0").ends_with("the loss modulus in line 3 is 0; it must be positive"));
        assert!(rows("1,1,1\n1,1,1").contains("frequency in line 4"));
        let large = refused("f [Hz],E' [GPa],E'' [Pa]\n1,1e300,1\n");
        assert!(large.ends_with("the storage modulus in line 2 is 1e300 GPa, which is too large"), "{large}");
        let cold = refused("T [°C],f [Hz],E' [Pa],E'' [Pa]\n-300,1,2,1\n");
        assert!(
            cold.ends_with(
                "the temperature in line 2 is -300 °C; it must be above absolute zero, -273.15 °C"
            ),
            "{cold}"
        );
        let order = rows("20,1,1\n0.1,1,1");
        assert!(
            order.contains("in line 4 is 0.1 Hz and does not rise above 20 Hz, the one before"),
            "{order}"
        );
        assert!(rows("1,1").contains("line 3 has 2 fields, the header has 3"));
        assert!(rows("").contains("no measurements"));
        assert!(refused("").contains("no measurements"));
    }
}
