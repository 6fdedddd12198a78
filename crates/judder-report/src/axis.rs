//! An axis as data: what it shows, and how values are spread along it.

use crate::error::PanelError;
use serde::Serialize;

/// Beyond this magnitude (and below its inverse, on log axes) differences overflow; nothing is drawn there.
pub(crate) const LARGEST: f64 = 1e300;
/// What is smaller than this counts as zero on a linear axis, whose steps would underflow.
pub(crate) const SMALLEST: f64 = 1e-280;

/// An axis: what it shows, how values are spread along it, and from where to where.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Axis {
    /// Quantity, symbol and unit, e.g. `"Load $F̃_{n}$ (−)"`.
    pub label: String,
    /// How values are spread along the axis.
    pub scale: Scale,
    /// First and last value, ascending; `None` takes what the data span.
    pub range: Option<(f64, f64)>,
    /// What stands at these values, ascending, in place of numbers; numbers where there are none.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub names: Vec<(f64, String)>,
}

impl Axis {
    /// A linear axis over what the data span.
    pub fn linear(label: impl Into<String>) -> Self {
        Self { label: label.into(), scale: Scale::Linear, range: None, names: Vec::new() }
    }

    /// A logarithmic axis over what the (positive) data span.
    pub fn log(label: impl Into<String>) -> Self {
        Self { label: label.into(), scale: Scale::Log, range: None, names: Vec::new() }
    }

    /// An axis logarithmic to both sides of zero, linear between −`linear` and `linear`; linear throughout where no axis can be drawn with that,
    /// as of values of which there are none.
    pub fn symmetric_log(label: impl Into<String>, linear: f64) -> Self {
        let even = Self::linear(label);
        let axis = Self { scale: Scale::SymmetricLog { linear }, ..even.clone() };
        if axis.check("").is_ok() { axis } else { even }
    }

    /// An axis of things without an order: the first at 0, the next at 1, …, with half a place beside the outermost.
    pub fn named(label: impl Into<String>, names: impl IntoIterator<Item = String>) -> Self {
        let names: Vec<(f64, String)> = (0..).map(f64::from).zip(names).collect();
        let end = names.len().max(1) as f64 - 0.5;
        Self { names, ..Self::linear(label).with_range(-0.5, end) }
    }

    /// The same axis from `from` to `to`.
    #[must_use]
    pub fn with_range(self, from: f64, to: f64) -> Self {
        Self { range: Some((from, to)), ..self }
    }

    /// The same axis over what computed values span; over what the data span where no axis can be drawn between these ends, as of values of
    /// which there are none or that are all equal.
    #[must_use]
    pub fn over(self, from: f64, to: f64) -> Self {
        let ranged = self.clone().with_range(from, to);
        if ranged.check("").is_ok() { ranged } else { self }
    }

    /// Whether the axis, which errors call `name`, can be drawn.
    pub(crate) fn check(&self, name: &'static str) -> Result<(), PanelError> {
        if let Scale::SymmetricLog { linear } = self.scale
            && !drawable(Scale::Log, linear)
        {
            return Err(PanelError::LinearPart { axis: name, linear });
        }
        let Some((from, to)) = self.range else { return Ok(()) };
        // closer ends than this differ by rounding alone, or underflow
        let least = if self.scale == Scale::Log { 0.0 } else { SMALLEST };
        let apart = to - from > 1e-12 * from.abs().max(to.abs()).max(least);
        if apart && drawable(self.scale, from) && drawable(self.scale, to) {
            return Ok(());
        }
        Err(PanelError::Range { axis: name, from, to })
    }
}

/// How values are spread along an axis or over a colour bar.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Scale {
    /// Evenly.
    #[default]
    Linear,
    /// By the logarithm; values that are not positive have no place and make gaps.
    Log,
    /// By the logarithm of the magnitude on both sides of zero, evenly between −`linear` and `linear`.
    SymmetricLog {
        /// Half width of the even part, > 0; it is as wide as two decades.
        linear: f64,
    },
}

/// Whether a value has a place on such an axis.
pub(crate) fn drawable(scale: Scale, value: f64) -> bool {
    match scale {
        Scale::Log => (1.0 / LARGEST..=LARGEST).contains(&value),
        _ => value.abs() <= LARGEST,
    }
}
