//! Computed laws of a contact in closed form: exact limits, a bell of friction, a dip of area.
#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use judder_contact::law::{KnotValues, Knots, LawIndenter, LawMaterial, LawOrigin, PerQuantity};
use judder_contact::{CollapsedLaw, Law, TabulatedLaw};
use std::sync::Arc;

/// E∞/E0.
const RATIO: f64 = 10.0;

/// f, g, m at ln z and ŷ; the depth changes them by a few percent.
fn values(speeds: &Knots, depths: &[f64]) -> KnotValues {
    let mut values = KnotValues::default();
    for y in depths {
        for ln_z in speeds.iter() {
            let z = ln_z.exp();
            let bell = z * z / (1.0 + z * z * z) * (1.0 - 0.2 * y);
            values.force.push(4.0 / 3.0 * (RATIO.ln() * z * z / (1.0 + z + z * z)).exp() * (1.0 - 0.1 * y));
            values.area.push(std::f64::consts::PI * (-0.5 * bell).exp());
            values.friction.push(0.9 * z / (1.0 + 0.125 * z * z) * (-0.4 * bell).exp());
        }
    }
    values
}

/// The curve of a paraboloid and the table of a sphere.
pub(crate) fn computed_laws() -> [Law; 2] {
    let material = LawMaterial::one_time(RATIO).unwrap();
    let source = "closed form of the tests".to_owned();
    let speeds = Knots::new("ln z", 0.01_f64.ln(), 1000.0_f64.ln(), 65).unwrap();
    let depths = Knots::new("ln y", 1e-3_f64.ln(), 0.3_f64.ln(), 9).unwrap();
    let none = PerQuantity::uniform(0.0);
    let curve =
        CollapsedLaw::new(material.clone(), source.clone(), speeds, values(&speeds, &[0.0]), none).unwrap();
    let rows: Vec<f64> = depths.iter().map(f64::exp).collect();
    let origin = LawOrigin { material, indenter: LawIndenter::Sphere, source };
    let table = TabulatedLaw::new(origin, speeds, depths, values(&speeds, &rows), none).unwrap();
    [Law::Collapsed(Arc::new(curve)), Law::Tabulated(Arc::new(table))]
}
