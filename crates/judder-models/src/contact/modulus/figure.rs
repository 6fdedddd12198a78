//! Moduli over frequency.

#![deny(clippy::indexing_slicing, reason = "stored arrays may be of any length")]

use judder_report::{Axis, Layer, Panel, Role};
use judder_study::pictures::{StoredArrays, axis, reals};

/// Storage and loss modulus; loss tangent; for measured data, how far the series is from them.
pub(crate) fn modulus(dataset: &StoredArrays<'_>) -> Option<Vec<Panel>> {
    dataset.alike(&["frequency", "storage_modulus", "loss_modulus", "loss_tangent"])?;
    dataset.alike(&[
        "measured_frequency",
        "measured_storage_modulus",
        "measured_loss_modulus",
        "storage_deviation",
        "loss_deviation",
    ])?;
    let frequency = reals(dataset, "frequency")?;
    let horizontal = || dataset.variable("frequency").map(axis);
    let measured = reals(dataset, "measured_frequency");
    let line = |name: &str, label: &str, role: Role| {
        Some(Layer::line(label, frequency.to_vec(), reals(dataset, name)?.to_vec(), role.solid()))
    };
    let points = |name: &str, label: &str, role: Role| {
        Some(Layer::points(label, measured?.to_vec(), reals(dataset, name)?.to_vec(), role))
    };
    let mut moduli = vec![
        line("storage_modulus", "storage modulus $E$′", Role::Series(0))?,
        line("loss_modulus", "loss modulus $E$″", Role::Series(1))?,
    ];
    moduli.extend(points("measured_storage_modulus", "measured $E$′", Role::Series(0)));
    moduli.extend(points("measured_loss_modulus", "measured $E$″", Role::Series(1)));
    let tangent = line("loss_tangent", "", Role::Series(2))?;
    let mut panels = vec![
        Panel::new(horizontal()?, Axis::log("Modulus $E$ (Pa)"), moduli),
        Panel::new(horizontal()?, Axis::log("Loss tangent $E$″/$E$′ (−)"), vec![tangent]),
    ];
    if let Some(measured) = measured {
        let deviation = |name: &str, label: &str, role: Role| {
            Some(Layer::points(label, measured.to_vec(), reals(dataset, name)?.to_vec(), role))
        };
        let layers = vec![
            Layer::horizontal_rule(0.0, ""),
            deviation("storage_deviation", "measured $E$′", Role::Series(0))?,
            deviation("loss_deviation", "measured $E$″", Role::Series(1))?,
        ];
        panels.push(Panel::new(horizontal()?, Axis::linear("Series over measured − 1 (−)"), layers));
    }
    Some(panels)
}
