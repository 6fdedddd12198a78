//! Magnitude and phase over frequency.

#![deny(clippy::indexing_slicing, reason = "stored arrays may be of any length")]

use judder_numerics::complex::ElementaryComplex;
use judder_report::{Axis, Layer, Panel, Role};
use judder_study::pictures::{StoredArrays, complexes, reals};

/// Magnitude on a logarithmic axis, and phase.
pub(super) fn receptance(dataset: &StoredArrays<'_>) -> Option<Vec<Panel>> {
    dataset.alike(&["frequency", "receptance"])?;
    let (hertz, values) = (reals(dataset, "frequency")?, complexes(dataset, "receptance")?);
    let panel = |up: Axis, heights: Vec<f64>, title: &str| {
        let line = Layer::line("", hertz.to_vec(), heights, Role::Series(0).solid());
        Panel::new(Axis::linear("Frequency (Hz)"), up, vec![line]).with_title(title)
    };
    let magnitudes = values.iter().map(|value| value.modulus()).collect();
    // a line does not join −180° and 180°, which are the same
    let phases: Vec<f64> = values.iter().map(|value| value.argument().to_degrees()).collect();
    let next = phases.iter().skip(1).map(Some).chain([None]);
    let phases = phases.iter().zip(next).map(|(own, next)| match next {
        Some(next) if (next - own).abs() > 180.0 => f64::NAN,
        _ => *own,
    });
    let phases = phases.collect();
    Some(vec![
        panel(Axis::log("Receptance $|α|$ (m/N)"), magnitudes, "magnitude"),
        panel(Axis::linear("Phase (°)").over(-190.0, 190.0), phases, "phase"),
    ])
}
