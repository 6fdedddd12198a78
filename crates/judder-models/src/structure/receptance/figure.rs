//! Magnitude and phase over frequency.

use judder_numerics::complex::ElementaryComplex;
use judder_report::{Axis, Layer, Panel, Role};
use judder_store::Dataset;
use judder_study::pictures::{complexes, reals};

/// Magnitude on a logarithmic axis, and phase.
pub(super) fn receptance(dataset: &Dataset) -> Option<Vec<Panel>> {
    let (hertz, values) = (reals(dataset, "frequency")?, complexes(dataset, "receptance")?);
    let panel = |up: Axis, heights: Vec<f64>, title: &str| {
        let line = Layer::line("", hertz.to_vec(), heights, Role::Series(0).solid());
        Panel::new(Axis::linear("Frequency (Hz)"), up, vec![line]).with_title(title)
    };
    let magnitudes = values.iter().map(|value| value.modulus()).collect();
    // a line does not join −180° and 180°, which are the same
    let mut phases: Vec<f64> = values.iter().map(|value| value.argument().to_degrees()).collect();
    for k in 1..phases.len() {
        if (phases[k] - phases[k - 1]).abs() > 180.0 {
            phases[k - 1] = f64::NAN;
        }
    }
    Some(vec![
        panel(Axis::log("Receptance $|α|$ (m/N)"), magnitudes, "magnitude"),
        panel(Axis::linear("Phase (°)").over(-190.0, 190.0), phases, "phase"),
    ])
}
