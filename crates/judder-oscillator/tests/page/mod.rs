//! The equations of the oscillator paper once more, straight from the page, with the C library's functions.

use judder_oscillator::{FrictionLoad, Groups};

/// F̃_k, Ã, μ_visc of (34), (36), (38) with the coefficients (35), (37), (39).
pub(crate) fn contact_law(velocity: f64, indentation: f64) -> [f64; 3] {
    let (v, y) = (velocity.log10(), indentation.log10());
    let bell = |centre: f64, width: f64| (-(v - centre).powi(2) / (2.0 * width.powi(2))).exp();
    [
        11.890 * indentation.powf(1.5) * 0.5 * (1.199 + libm::erf(0.873 * v + (-0.449 * y + 0.412))),
        1.440 * indentation * (2.118 - bell(0.493 * y - 1.328, 0.826)),
        0.450 * indentation.sqrt() * bell(0.489 * y - 1.682, 0.766),
    ]
}

/// The second row of (15), left side minus right side, with x̃_e from the first row.
pub(crate) fn vertical_imbalance(groups: &Groups, load: FrictionLoad, indentation: f64) -> f64 {
    let Groups { velocity, normal_load, shear_strength, frequency_ratio: omega, .. } = *groups;
    let [force, area, friction] = contact_law(velocity, indentation);
    let carrier = match load {
        FrictionLoad::NormalLoad => normal_load,
        FrictionLoad::ContactForce => force,
    };
    let right = (carrier * friction + shear_strength * area) / normal_load;
    let y = indentation * groups.radius();
    let eta_squared = groups.coupling.powi(2);
    let (sine, cosine) = groups.coupling_angle.sin_cos();
    let x = (right - eta_squared * sine * cosine * y) / (1.0 + eta_squared * cosine.powi(2));
    (omega.powi(2) + eta_squared * sine.powi(2)) * y + eta_squared * sine * cosine * x - 1.0
        + force / normal_load
}
