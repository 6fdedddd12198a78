//! Ranges with equal ratios between their points.

use crate::cause::Cause;
use crate::declared::both;
use crate::document::{Data, Node};
use crate::error::{Fault, Place};
use crate::numeric_key::{Form, Scaled};
use crate::quantity::WrittenNumber;
use crate::section::Section;
use judder_numerics::decade::power_of_ten;

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
                _ => power_of_ten(first + (end - first) * index as f64 / last as f64),
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
    let ends = [("from", from), ("to", to)];
    ascending(
        [from.number, to.number],
        || ends.map(|(key, own)| table.written(key, own.number)),
        node.place,
    )?;
    Ok(Span { from: from.number, to: to.number, points: points.unwrap_or(usual), form: from.form })
}

/// Refuses a range that is empty or runs backwards; `written` is how its ends are.
pub fn ascending(
    [from, to]: [f64; 2],
    written: impl Fn() -> [WrittenNumber; 2],
    place: Place,
) -> Result<(), Fault> {
    let order = from.total_cmp(&to);
    if order.is_lt() {
        return Ok(());
    }
    let [from, to] = written();
    Err(if order.is_eq() { Cause::EmptyRange { from } } else { Cause::Backwards { from, to } }.at(place))
}

/// Both items of a list of two as they are written.
pub(crate) fn written_items(node: &Node, numbers: [f64; 2]) -> [WrittenNumber; 2] {
    let of = |k: usize| match &node.data {
        Data::List(items) => items.get(k).map(|item| WrittenNumber::of(item, numbers[k])),
        _ => None,
    };
    [0, 1].map(|k| of(k).unwrap_or_else(|| numbers[k].into()))
}
