//! Ranges with equal ratios between their points.

use crate::cause::Cause;
use crate::declared::both;
use crate::document::Node;
use crate::error::{Fault, Place};
use crate::numeric_key::{Form, Scaled};
use crate::section::Section;

/// A range with equal ratios between its points.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Span {
    /// The lower end; positive.
    pub from: f64,
    /// The upper end; above the lower one.
    pub to: f64,
    /// The number of points, both ends included, at least 2.
    pub points: usize,
    /// Whether the ends are groups or in SI units.
    pub form: Form,
}

impl Span {
    /// All points in order: the ends exact.
    pub fn values(&self) -> Vec<f64> {
        let last = self.points.saturating_sub(1).max(1);
        let (first, end) = (libm::log10(self.from), libm::log10(self.to));
        (0..self.points)
            .map(|index| match index {
                0 => self.from,
                _ if index == last => self.to,
                _ => libm::pow(10_f64, first + (end - first) * index as f64 / last as f64),
            })
            .collect()
    }
}

/// Reads `{ from, to, points }`, with the points of a range that does not say, and the most.
pub fn read_ends(of: &Scaled, path: &str, node: &Node, usual: usize, most: usize) -> Result<Span, Fault> {
    let table = Section::of_table(node, path, &format!("`{path}`"))?;
    let end = |end: &str| {
        let node = table.required(end, &format!("{end} = …, the value at this end"))?;
        Ok((of.read(&table.path(end), node)?, node.place))
    };
    let ends = both(both(end("from"), end("to")), table.whole("points", 2, most));
    let ((), (((from, _), (to, to_place)), points)) =
        both(table.refuse_others(&["from", "to", "points"]), ends)?;
    if from.form != to.form {
        let keys = format!("`{}` and `{}`", table.path("from"), table.path("to"));
        return Err(Cause::MixedForms { keys }.at(to_place));
    }
    ascending(from.number, to.number, node.place)?;
    Ok(Span { from: from.number, to: to.number, points: points.unwrap_or(usual), form: from.form })
}

/// Refuses a range that is empty or runs backwards.
pub fn ascending(from: f64, to: f64, place: Place) -> Result<(), Fault> {
    match from.total_cmp(&to) {
        std::cmp::Ordering::Less => Ok(()),
        std::cmp::Ordering::Equal => Err(Cause::EmptyRange { from }.at(place)),
        std::cmp::Ordering::Greater => Err(Cause::Backwards { from, to }.at(place)),
    }
}
