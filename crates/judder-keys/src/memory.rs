//! Amounts of memory: `"4 GiB"`, `"512 MB"`.

use std::fmt;

use crate::cause::Cause;
use crate::declared::{Allowed, Setting};
use crate::document::Node;
use crate::error::Fault;
use crate::quantity::leading_number;
use crate::section::{Section, text};
use serde_json::{Value as Json, json};

/// An amount of memory.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Memory {
    /// Bytes.
    pub bytes: u64,
}

const KIB: u64 = 1 << 10;
const MIB: u64 = 1 << 20;
const GIB: u64 = 1 << 30;
/// Each unit with its bytes, the binary ones from large to small first.
const UNITS: [(&str, u64); 8] = [
    ("TiB", 1 << 40),
    ("GiB", GIB),
    ("MiB", MIB),
    ("KiB", KIB),
    ("TB", 1_000_000_000_000),
    ("GB", 1_000_000_000),
    ("MB", 1_000_000),
    ("kB", 1_000),
];
/// The least limit that leaves room for a contact.
const LEAST: u64 = MIB;

impl Memory {
    /// 4 GiB: what the computation of one contact may take where the case does not say.
    pub const DEFAULT: Self = Self { bytes: 4 * GIB };

    /// Reads `"4 GiB"`: a number and one of TiB, GiB, MiB, KiB, TB, GB, MB, kB.
    pub fn parse(text: &str) -> Option<Self> {
        let text = text.trim();
        let (number, length) = leading_number(text)?;
        let (_, unit) = UNITS.iter().find(|(unit, _)| *unit == text[length..].trim_start())?;
        let bytes = number * *unit as f64;
        (bytes >= LEAST as f64 && bytes < (1_u64 << 53) as f64).then_some(Self { bytes: bytes as u64 })
    }

    /// How an amount is written, in words.
    pub fn form() -> String {
        let units = UNITS.map(|(unit, _)| unit).join(", ");
        format!("a number of 1 MiB or more with its unit ({units}), such as \"4 GiB\"")
    }

    /// The amount that a limit would need to be, in whole GiB or MiB, as a case writes it.
    pub fn rounded_up(self) -> String {
        let (unit, size) = if self.bytes >= GIB { ("GiB", GIB) } else { ("MiB", MIB) };
        format!("{} {unit}", self.bytes.div_ceil(size))
    }
}

impl fmt::Display for Memory {
    /// In the largest binary unit that gives one or more: `3.2 GiB`.
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (unit, size) =
            UNITS[..3].iter().find(|(_, size)| self.bytes >= *size).copied().unwrap_or(("KiB", KIB));
        write!(formatter, "{:.1} {unit}", self.bytes as f64 / size as f64)
    }
}

/// 4 GiB where it is left out.
impl Setting for Memory {
    type Rule = ();
    const IS_OPTIONAL: bool = true;

    fn absent() -> Option<Self> {
        Some(Self::DEFAULT)
    }

    fn form((): &()) -> Allowed {
        let schema = json!({ "type": "string", "examples": ["4 GiB", "512 MiB"], "default": "4 GiB" });
        let units = UNITS.map(|(unit, _)| unit).join(", ");
        Allowed::Told { schema, words: format!("an amount such as 4 GiB, in {units}"), keys: Vec::new() }
    }

    fn read(section: &Section<'_>, key: &str, node: &Node, (): &()) -> Result<Self, Fault> {
        let key = section.path(key);
        Self::parse(text(&key, node)?).ok_or_else(|| Cause::NotMemory { key }.at(node.place))
    }

    fn write(&self, (): &()) -> Json {
        json!(self.bytes)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn amounts_are_read_and_shown_in_their_units() {
        let shown = |text: &str| Memory::parse(text).map(|memory| memory.to_string());
        for (text, expected) in [
            ("4 GiB", "4.0 GiB"),
            ("3435973837 B", ""),
            ("3.2GiB", "3.2 GiB"),
            (" 512 MB ", "488.3 MiB"),
            ("2 TiB", "2.0 TiB"),
            ("2048 KiB", "2.0 MiB"),
            ("1000 kB", ""),
            ("-1 GiB", ""),
            ("1e300 GiB", ""),
            ("4", ""),
            ("GiB", ""),
        ] {
            let expected = (!expected.is_empty()).then(|| expected.to_owned());
            assert_eq!(shown(text), expected, "{text:?}");
        }
        assert_eq!(Memory { bytes: 6 * GIB + 1 }.rounded_up(), "7 GiB");
        assert_eq!(Memory { bytes: 5 * MIB }.rounded_up(), "5 MiB");
        assert_eq!(Memory { bytes: 700 }.to_string(), "0.7 KiB");
    }
}
