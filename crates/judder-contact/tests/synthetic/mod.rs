//! A contact in closed form that is physically sane: exact limits of a paraboloid or a sphere, friction ∝ v and ∝ 1/v, force
//! that rises, area that dips, approaches as z (with the exact factor), z² and 1/z. It stands in for a solver.
#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use judder_contact::law::sweep::LawSample;
use judder_contact::law::{KnotValues, Knots, LawIndenter, LawMaterial, LawOrigin, PerQuantity};
use judder_contact::{CollapsedLaw, TabulatedLaw};
use std::convert::Infallible;
use std::f64::consts::PI;

/// E∞/E0 of all synthetic contacts.
pub(crate) const RATIO: f64 = 10.0;

/// F̃, Ã, μ at v̂, ŷ.
pub(crate) fn contact(indenter: LawIndenter, v: f64, y: f64) -> PerQuantity<f64> {
    let z = v / y.sqrt();
    let elastic = indenter.elastic(y).unwrap();
    // from 0 as z², to 1 as 1/z
    let rise = z * z / (1.0 + z + z * z);
    // from 0 as z², to 0 as 1/z; the depth shifts it a little where the indenter is not a paraboloid
    let bell = z * z / (1.0 + z * z * z);
    let deep = elastic.force;
    let substrate = material();
    // what is exact at rest, to 0 as 1/z
    let lag = z / (1.0 + z * z);
    let shrinking = substrate.slow_area_slope() * elastic.area_slope * lag;
    let easing = substrate.slow_friction_slope() * elastic.friction_slope * lag;
    let stiffening = (RATIO.ln() * rise).exp();
    let (slow, fast) = (0.9 * elastic.slow_friction, 0.8 * (RATIO - 1.0) * elastic.fast_friction);
    PerQuantity {
        force: 4.0 / 3.0 * y.powf(1.5) * elastic.force * stiffening,
        area: PI * y * elastic.area * (shrinking - 0.5 * deep * bell).exp(),
        friction: y.sqrt() * slow * z / (1.0 + slow / fast * z * z) * (easing - 0.4 * deep * bell).exp(),
    }
}

/// The same as a solver's answer.
pub(crate) fn sample(indenter: LawIndenter) -> impl Fn(f64, f64) -> Result<LawSample, Infallible> + Sync {
    move |v, y| {
        let PerQuantity { force, area, friction } = contact(indenter, v, y);
        Ok(LawSample { force, area, friction, force_error: 1e-4, area_error: 2e-4, friction_error: 3e-4 })
    }
}

pub(crate) fn material() -> LawMaterial {
    LawMaterial::one_time(RATIO).unwrap()
}

pub(crate) fn origin(indenter: LawIndenter) -> LawOrigin {
    LawOrigin { material: material(), indenter, source: "closed form of the tests".to_owned() }
}

fn values(indenter: LawIndenter, speeds: &Knots, depths: &[f64]) -> KnotValues {
    let mut values = KnotValues::default();
    for ln_y in depths {
        for ln_z in speeds.iter() {
            let y = ln_y.exp();
            let sample = contact(indenter, ln_z.exp() * y.sqrt(), y);
            values.force.push(sample.force / y.powf(1.5));
            values.area.push(sample.area / y);
            values.friction.push(sample.friction / y.sqrt());
        }
    }
    values
}

pub(crate) fn speeds(count: usize) -> Knots {
    Knots::new("ln z", 0.01_f64.ln(), 1000.0_f64.ln(), count).unwrap()
}

pub(crate) fn collapsed(count: usize) -> CollapsedLaw {
    let speeds = speeds(count);
    let values = values(LawIndenter::Paraboloid, &speeds, &[0.01_f64.ln()]);
    CollapsedLaw::new(material(), "test".to_owned(), speeds, values, PerQuantity::uniform(0.0)).unwrap()
}

/// A table for ŷ from 1e-3 to 0.3.
pub(crate) fn tabulated(indenter: LawIndenter, columns: usize, rows: usize) -> TabulatedLaw {
    let speeds = speeds(columns);
    let depths = Knots::new("ln y", 1e-3_f64.ln(), 0.3_f64.ln(), rows).unwrap();
    let values = values(indenter, &speeds, &depths.iter().collect::<Vec<_>>());
    TabulatedLaw::new(origin(indenter), speeds, depths, values, PerQuantity::uniform(0.0)).unwrap()
}
