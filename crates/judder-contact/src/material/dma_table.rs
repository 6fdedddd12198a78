//! The table in which a DMA instrument hands over its results.

use super::dma::{DmaData, DmaPoint, DmaSweeps};
use super::error::DmaError;
use std::f64::consts::TAU;

/// What a table of measured moduli held.
#[derive(Debug, Clone, PartialEq)]
pub enum DmaTable {
    /// No column of temperatures: one sweep over frequency.
    Sweep(DmaData),
    /// A column of temperatures: one sweep for every run of rows with equal temperature.
    Sweeps(DmaSweeps),
}

impl DmaTable {
    /// Reads a table of text with one header line.
    ///
    /// - Columns: frequency (`frequency`, `f`, or `angular frequency`, `omega`, `ω`), storage modulus (`E'`, `E′`, `E1`,
    ///   `storage modulus`), loss modulus (`E''`, `E″`, `E2`, `loss modulus`), temperature (`temperature`, `T`; may be absent),
    ///   in any order and case; others are not looked at.
    /// - Units in brackets after the name: Hz or rad/s; Pa, kPa, MPa, GPa; K or °C. There is no default.
    /// - Fields are separated by semicolons, tabs or commas, whichever the header has, in this order. Decimal points.
    /// - Empty lines and lines that begin with `#` are left out.
    ///
    /// # Errors
    /// [`DmaError`], with the header's columns or the line: what is missing, there twice, without unit, not positive, or does
    /// not rise in frequency.
    pub fn parse(text: &str) -> Result<Self, DmaError> {
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let mut lines = text.lines().enumerate().map(|(index, line)| (index + 1, line.trim()));
        let mut lines = lines.by_ref().filter(|(_, line)| !line.is_empty() && !line.starts_with('#'));
        let (header_line, header) = lines.next().ok_or(DmaError::Empty)?;
        let separator = [';', '\t'].into_iter().find(|candidate| header.contains(*candidate)).unwrap_or(',');
        let columns: Vec<&str> = header.split(separator).map(unquoted).collect();
        let layout = Layout::of(&columns, header_line)?;
        let mut rows = Vec::new();
        for (line, text) in lines {
            let fields: Vec<&str> = text.split(separator).map(unquoted).collect();
            if fields.len() != columns.len() {
                return Err(DmaError::Fields { line, found: fields.len(), expected: columns.len() });
            }
            rows.push(layout.read(line, &fields)?);
        }
        let unit = layout.frequency.unit();
        if layout.temperature.is_none() {
            let points = rows.into_iter().map(|(line, _, point)| (line, point)).collect();
            return Ok(Self::Sweep(DmaData::from_lines(points, unit)?));
        }
        if rows.is_empty() {
            return Err(DmaError::Empty);
        }
        let sweeps = rows.chunk_by(|a, b| a.1 == b.1).map(|run| {
            let points = run.iter().map(|(line, _, point)| (*line, *point)).collect();
            Ok((run[0].1, DmaData::from_lines(points, unit)?))
        });
        Ok(Self::Sweeps(DmaSweeps { sweeps: sweeps.collect::<Result<_, _>>()? }))
    }

    /// The data, where there is only one temperature.
    ///
    /// # Errors
    /// [`DmaError::SeveralTemperatures`].
    pub fn single(self) -> Result<DmaData, DmaError> {
        match self {
            Self::Sweep(data) => Ok(data),
            Self::Sweeps(DmaSweeps { mut sweeps }) if sweeps.len() == 1 => Ok(sweeps.remove(0).1),
            Self::Sweeps(DmaSweeps { sweeps }) => Err(DmaError::SeveralTemperatures { sweeps: sweeps.len() }),
        }
    }
}

/// A quantity that a column may hold: how messages call it, its names, its units with (factor, offset) to SI.
struct Quantity {
    called: &'static str,
    names: &'static [&'static str],
    units: &'static [(&'static str, f64, f64)],
}

const FREQUENCY: Quantity = Quantity {
    called: "frequency (`frequency [Hz]` or `omega [rad/s]`)",
    names: &["frequency", "freq", "f"],
    units: &[("Hz", TAU, 0.0), ("rad/s", 1.0, 0.0)],
};
const ANGULAR_FREQUENCY: Quantity = Quantity {
    called: "frequency (`frequency [Hz]` or `omega [rad/s]`)",
    names: &["angular frequency", "omega", "ω"],
    units: &[("rad/s", 1.0, 0.0)],
};
const MODULUS_UNITS: &[(&str, f64, f64)] =
    &[("Pa", 1.0, 0.0), ("kPa", 1e3, 0.0), ("MPa", 1e6, 0.0), ("GPa", 1e9, 0.0)];
const STORAGE: Quantity = Quantity {
    called: "storage modulus (`E' [MPa]`)",
    names: &["e'", "e1", "storage modulus", "storage modulus e'"],
    units: MODULUS_UNITS,
};
const LOSS: Quantity = Quantity {
    called: "loss modulus (`E'' [MPa]`)",
    names: &["e''", "e2", "loss modulus", "loss modulus e''"],
    units: MODULUS_UNITS,
};
const TEMPERATURE: Quantity = Quantity {
    called: "temperature (`temperature [°C]`)",
    names: &["temperature", "temp", "t"],
    units: &[("K", 1.0, 0.0), ("°C", 1.0, 273.15), ("degC", 1.0, 273.15)],
};

/// Where a quantity stands, and how it becomes SI.
struct Column {
    index: usize,
    unit: &'static str,
    factor: f64,
    offset: f64,
}

impl Column {
    /// The unit, with its factor to SI.
    fn unit(&self) -> (&'static str, f64) {
        (self.unit, self.factor)
    }
}

/// Where everything stands.
struct Layout {
    frequency: Column,
    storage: Column,
    loss: Column,
    temperature: Option<Column>,
}

impl Layout {
    fn of(columns: &[&str], line: usize) -> Result<Self, DmaError> {
        let needed = |quantities: &[&Quantity]| {
            let called = quantities[0].called;
            let found = || columns.iter().map(|column| (*column).to_owned()).collect();
            find(columns, quantities, line)?.ok_or_else(|| DmaError::MissingColumn {
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

    /// (line, temperature, point) of a line; without temperatures, zero.
    fn read(&self, line: usize, fields: &[&str]) -> Result<(usize, f64, DmaPoint), DmaError> {
        let read = |column: &Column, name: &'static str| {
            let found = fields[column.index];
            let wrong = || DmaError::Value { line, name, found: found.to_owned() };
            let value: f64 = found.parse().map_err(|_| wrong())?;
            let value = value * column.factor + column.offset;
            if value.is_normal() && value > 0.0 { Ok(value) } else { Err(wrong()) }
        };
        let point = DmaPoint {
            angular_frequency: read(&self.frequency, "frequency")?,
            storage_modulus: read(&self.storage, "storage modulus")?,
            loss_modulus: read(&self.loss, "loss modulus")?,
        };
        let temperature = self.temperature.as_ref().map(|column| read(column, "absolute temperature"));
        Ok((line, temperature.transpose()?.unwrap_or(0.0), point))
    }
}

/// The one column that is one of the quantities.
fn find(columns: &[&str], quantities: &[&Quantity], line: usize) -> Result<Option<Column>, DmaError> {
    let mut found: Option<(Column, &str)> = None;
    for (index, column) in columns.iter().enumerate() {
        let (name, unit) = name_and_unit(column);
        let Some(quantity) = quantities.iter().find(|quantity| quantity.names.contains(&name.as_str()))
        else {
            continue;
        };
        if let Some((_, first)) = found {
            let (first, second) = (first.to_owned(), (*column).to_owned());
            return Err(DmaError::AmbiguousColumn { line, quantity: quantity.called, first, second });
        }
        let known = quantity.units.iter().find(|(name, ..)| Some(*name) == unit);
        let Some((unit, factor, offset)) = known else {
            let expected = quantity.units.iter().map(|(name, ..)| (*name).to_owned()).collect();
            return Err(DmaError::Unit { line, column: (*column).to_owned(), expected });
        };
        found = Some((Column { index, unit, factor: *factor, offset: *offset }, column));
    }
    Ok(found.map(|(column, _)| column))
}

/// `Storage_modulus (MPa)` as `storage modulus` and `MPa`.
fn name_and_unit(column: &str) -> (String, Option<&str>) {
    let opening = column.find(['[', '(']);
    let unit = opening.and_then(|at| column[at + 1..].strip_suffix([']', ')'])).map(str::trim);
    let name = &column[..opening.unwrap_or(column.len())];
    let name = name.to_lowercase().replace('_', " ").replace(['′', '’'], "'").replace(['″', '"'], "''");
    (name.split_whitespace().collect::<Vec<_>>().join(" "), unit)
}

/// A field without the quotes around it.
fn unquoted(field: &str) -> &str {
    let field = field.trim();
    field.strip_prefix('"').and_then(|inner| inner.strip_suffix('"')).unwrap_or(field)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn refused(text: &str) -> String {
        DmaTable::parse(text).unwrap_err().to_string()
    }

    #[test]
    fn units_and_order_of_columns_are_read() {
        let text = "\u{feff}# a rubber\n\nLoss modulus (kPa);tan delta;E′ [MPa];\"f [Hz]\"\n100;0.1;1.0;0.5\n200;0.1;2.0;5\n";
        let data = DmaTable::parse(text).unwrap().single().unwrap();
        assert_eq!(data.points().len(), 2);
        let expected =
            DmaPoint { angular_frequency: std::f64::consts::PI, storage_modulus: 1e6, loss_modulus: 1e5 };
        assert_eq!(data.points()[0], expected);
    }

    #[test]
    fn a_column_of_temperatures_makes_sweeps() {
        let text = "T [°C],omega [rad/s],E1 [Pa],E2 [Pa]\n20,1,5,1\n20,10,6,1\n30,1,4,1\n";
        let DmaTable::Sweeps(sweeps) = DmaTable::parse(text).unwrap() else { panic!("no sweeps") };
        assert_eq!(sweeps.sweeps.len(), 2);
        assert!((sweeps.sweeps[1].0 - 303.15).abs() < 1e-12);
        let master = sweeps.shifted_by(&[1.0, 0.1]).unwrap();
        let frequencies: Vec<f64> = master.points().iter().map(|p| p.angular_frequency).collect();
        assert_eq!(frequencies, [0.1, 1.0, 10.0]);
        assert!(sweeps.shifted_by(&[1.0]).is_err());
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
        assert!(rows("1,1,-1").contains("loss modulus in line 3 is `-1`"));
        assert!(rows("1,1,1\n1,1,1").contains("frequency in line 4"));
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
