//! Ranges with equal ratios between their points.

use crate::cause::Cause;
use crate::error::Fault;
use crate::keys::{Form, Key, Range};
use crate::section::Section;
use crate::swept_keys::read_value;
use std::cmp::Ordering;

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
        let (first, end) = (self.from.log10(), self.to.log10());
        (0..self.points)
            .map(|index| match index {
                0 => self.from,
                _ if index == last => self.to,
                _ => 10_f64.powf(first + (end - first) * index as f64 / last as f64),
            })
            .collect()
    }
}

/// Reads `{ from, to, points }` of a key; `default` is in groups, and required without one. `points` are those of a range
/// that does not say, and the most.
pub(crate) fn read_span<K>(
    section: &Section<'_>,
    entry: &Key<K>,
    default: Option<(f64, f64, usize)>,
    (usual, most): (usize, usize),
) -> Result<Span, Fault> {
    let name = entry.name();
    let node = match (section.get(name), default) {
        (Some(node), _) => node,
        (None, Some((from, to, points))) => return Ok(Span { from, to, points, form: Form::Group }),
        (None, None) => section.required(name, "a range, { from = …, to = … }")?,
    };
    let table = Section::open(node, name, &format!("`{name}`"), &["from", "to", "points"])?;
    let end = |end: &str| {
        let node = table.required(end, &format!("{end} = …, the value at this end"))?;
        let value = read_value(entry, &table.path(end), node)?;
        if value.number > 0.0 {
            return Ok((value, node.place));
        }
        let (key, number) = (table.path(end), value.number);
        Err(Cause::OutOfRange { key, number, range: Range::Positive }.at(node.place))
    };
    let ((from, _), (to, to_place)) = (end("from")?, end("to")?);
    if from.form != to.form {
        let keys = format!("`{}` and `{}`", table.path("from"), table.path("to"));
        return Err(Cause::MixedForms { keys }.at(to_place));
    }
    let (form, from, to) = (from.form, from.number, to.number);
    match from.total_cmp(&to) {
        Ordering::Equal => Err(Cause::EmptyRange { from }.at(table.place)),
        Ordering::Greater => Err(Cause::Backwards { from, to }.at(table.place)),
        Ordering::Less => {
            let points = table.whole("points", 2, most)?.unwrap_or(usual);
            Ok(Span { from, to, points, form })
        }
    }
}
