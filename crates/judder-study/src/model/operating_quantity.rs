//! Quantities of operating points.

/// A quantity of an operating point, as a column of a sweep.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct OperatingQuantity {
    /// Its name in a case file.
    pub name: &'static str,
    /// Its unit; empty for codes.
    pub units: &'static str,
    /// What it is, with its symbol.
    pub long_name: &'static str,
    /// What stands at an axis; none of a code.
    pub label: Option<&'static str>,
    /// What each code means, where it is a code.
    pub flags: &'static [&'static str],
    /// Whether it is a root that has to be sought.
    pub is_sought: bool,
}
