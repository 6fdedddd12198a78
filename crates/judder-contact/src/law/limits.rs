//! What is known exactly about an indenter: the elastic contact, and friction in very slow and very fast sliding.

use crate::cylinder_on_layer::{CylinderError, CylinderOnLayer};
use crate::kernel::check::KernelError;
use crate::kernel::layer::BondedLayer;
use crate::law::error::LawError;
use crate::law::material::LawMaterial;
use crate::law::quantities::PerQuantity;
use judder_numerics::quadrature::gauss_legendre;
use serde::{Deserialize, Serialize};
use std::f64::consts::PI;

/// The indenter of a computed law.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum LawIndenter {
    /// Height r²/2R: everything depends on v τ/√(R δ) alone.
    Paraboloid,
    /// Height R − √(R² − r²): a paraboloid where it is shallow.
    Sphere,
    /// Height x²/2R for every y, on a layer: a line contact, whose law is that of the length R.
    Cylinder(LawLayer),
}

/// The layer under a cylinder.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LawLayer {
    /// h/R, its thickness.
    pub thickness: f64,
    /// ν.
    pub poisson_ratio: f64,
}

impl LawLayer {
    /// As kernels know it, lengths in R.
    ///
    /// # Errors
    /// As [`BondedLayer::new`].
    pub fn layer(self) -> Result<BondedLayer, KernelError> {
        BondedLayer::new(self.thickness, self.poisson_ratio)
    }
}

/// The elastic contact of an indenter at one depth, over that of the paraboloid of the same radius on a half-space.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ElasticContact {
    /// F/(4/3 E* √R δ^{3/2}); of a cylinder F/(E* δ) per length.
    pub force: f64,
    /// A/(π R δ); of a cylinder the width over √(R δ).
    pub area: f64,
    /// Mean curvature of the indenter under the elastic pressure, times R: the friction of slow sliding over a paraboloid's.
    pub slow_friction: f64,
    /// ∫p u/(0.8 F δ): the friction of fast sliding over a paraboloid's.
    pub fast_friction: f64,
    /// How fast the area's logarithm falls with z from rest, over a paraboloid: √(R δ)/a.
    pub area_slope: f64,
    /// How fast the logarithm of friction over speed does.
    pub friction_slope: f64,
}

/// What is known of a scaled logarithm (see [`crate::law::scaled`]) at both ends of the speed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct SpeedLimits {
    /// Its value at rest.
    pub(crate) rest: f64,
    /// Its slope over z at rest.
    pub(crate) slope: f64,
    /// Its value at infinite speed.
    pub(crate) infinite: f64,
}

/// ∫_0^end f, on panels so short that rounding is all that is left for the functions here (singular at 1, `end` ≤ 0.84).
fn integral(end: f64, function: impl Fn(f64) -> f64) -> f64 {
    const PANELS: usize = 24;
    let rule = gauss_legendre::<5>();
    let width = end / PANELS as f64;
    let panel =
        |k: usize| -> f64 { rule.iter().map(|(x, weight)| weight * function((k as f64 + x) * width)).sum() };
    width * (0..PANELS).map(panel).sum::<f64>()
}

impl LawIndenter {
    /// Whether its law is one per length: that of the length R.
    #[must_use]
    pub fn is_line(self) -> bool {
        matches!(self, Self::Cylinder(_))
    }

    /// F̃/f, Ã/g and μ/m at ŷ, the powers of the depth that a law is tabulated over.
    pub(crate) fn units(self, indentation: f64) -> PerQuantity<f64> {
        let root = indentation.sqrt();
        if self.is_line() {
            PerQuantity { force: indentation, area: root, friction: root }
        } else {
            PerQuantity { force: indentation * root, area: indentation, friction: root }
        }
    }

    /// The elastic contact at ŷ = δ/R.
    ///
    /// Any smooth axisymmetric indenter is a sequence of flat punches (Sneddon 1965; Johnson, *Contact Mechanics*, 5.2): with δ(a) the
    /// depth at contact radius a, F = 2 E* ∫ s δ′(s) ds, the mean curvature under the pressure is ∫ δ′² ds/∫ 2 s δ′ ds, and
    /// ∫p u = 2 ∫F dδ. Both the pressure near the edge and that of a punch with the indenter's slope grow as δ′(a), so the friction of
    /// slow sliding falls with its square. Sphere: δ = a artanh(a/R); paraboloid: δ = a²/R.
    ///
    /// A cylinder on its layer: [`CylinderOnLayer`], whose curvature is 1/R everywhere. Of its width the shift takes a part of 2a, not of
    /// π a/2 on average; the moment of the trailing edge's singularity is 4π c T with T of the tilted stamp, as the two-dimensional edge
    /// field is the same under any smooth part of the displacement, and the friction of slow sliding falls by (π/2) K T/F (s − 2 m/s) v̂.
    ///
    /// # Errors
    /// A sphere at ŷ that is not between 0 and 1: the half-space knows no such contact; [`CylinderError`].
    pub fn elastic(self, indentation: f64) -> Result<ElasticContact, LawError> {
        match self {
            Self::Paraboloid => Ok(ElasticContact {
                force: 1.0,
                area: 1.0,
                slow_friction: 1.0,
                fast_friction: 1.0,
                area_slope: 1.0,
                friction_slope: 1.0,
            }),
            Self::Sphere if indentation > 0.0 && indentation < 1.0 => Ok(sphere(indentation)),
            Self::Cylinder(layer) => Ok(cylinder(&layer.layer()?, indentation)?),
            Self::Sphere => Err(LawError::InvalidNumber {
                name: "indentation δ/R of a sphere",
                value: indentation,
                requirement: "between 0 and 1",
            }),
        }
    }

    /// What is known of the logarithms of [`crate::law::scaled`] at a depth, at rest and at infinite speed.
    pub(crate) fn logarithms(
        self,
        indentation: f64,
        material: &LawMaterial,
    ) -> Result<PerQuantity<SpeedLimits>, LawError> {
        let elastic = self.elastic(indentation)?;
        let (force, area) = (libm::log(elastic.force), libm::log(elastic.area));
        Ok(PerQuantity {
            force: SpeedLimits {
                rest: force,
                slope: 0.0,
                infinite: force + libm::log(material.modulus_ratio),
            },
            area: SpeedLimits {
                rest: area,
                slope: elastic.area_slope * material.slow_area_slope(),
                infinite: area,
            },
            friction: SpeedLimits {
                rest: libm::log(elastic.slow_friction),
                slope: elastic.friction_slope * material.slow_friction_slope(),
                infinite: libm::log(elastic.fast_friction),
            },
        })
    }
}

fn cylinder(layer: &BondedLayer, indentation: f64) -> Result<ElasticContact, CylinderError> {
    let contact = CylinderOnLayer::of_indentation(layer, indentation)?;
    let root = indentation.sqrt();
    Ok(ElasticContact {
        force: contact.force / indentation,
        area: 2.0 * contact.half_width / root,
        slow_friction: 1.0,
        fast_friction: contact.twice_the_work / (0.8 * contact.force * indentation),
        area_slope: 0.25 * PI * root / contact.half_width,
        friction_slope: 0.25 * PI * PI * contact.edge * contact.tilted_edge * root / contact.force,
    })
}

fn sphere(indentation: f64) -> ElasticContact {
    let depth = |a: f64| a * libm::atanh(a);
    let slope = |a: f64| libm::atanh(a) + a / (1.0 - a * a);
    let radius = contact_radius(indentation);
    // F/(E* R²): as an integral of positive terms, because the closed form cancels for shallow contacts
    let force = integral(radius, |a| 2.0 * a * slope(a));
    let curvature = integral(radius, |a| slope(a) * slope(a)) / force;
    // 2 ∫F dδ = 2 (F δ − ∫δ dF)
    let work = 2.0 * (force * indentation - integral(radius, |a| 2.0 * a * slope(a) * depth(a)));
    let force_ratio = force / (4.0 / 3.0 * indentation * indentation.sqrt());
    let area_ratio = radius * radius / indentation;
    // δ′(a) over that of the paraboloid of the same radius of contact
    let steepness = slope(radius) / (2.0 * radius);
    ElasticContact {
        force: force_ratio,
        area: area_ratio,
        slow_friction: curvature,
        fast_friction: work / (0.8 * force * indentation),
        area_slope: 1.0 / area_ratio.sqrt(),
        friction_slope: area_ratio * steepness * steepness / (force_ratio * curvature),
    }
}

/// a/R with a artanh(a/R) = δ: Newton from above, where a convex function cannot be overshot.
fn contact_radius(indentation: f64) -> f64 {
    const LIMIT: usize = 60;
    let mut radius = indentation.sqrt();
    for _ in 0..LIMIT {
        let excess = radius * libm::atanh(radius) - indentation;
        let next = radius - excess / (libm::atanh(radius) + radius / (1.0 - radius * radius));
        if next >= radius {
            break;
        }
        radius = next;
    }
    radius
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sphere_against_the_closed_form_of_sneddon() {
        for a in [0.05_f64, 0.3, 0.6] {
            let depth = a * a.atanh();
            let contact = LawIndenter::Sphere.elastic(depth).unwrap();
            let force = (1.0 + a * a) * a.atanh() - a;
            assert!((contact.force * 4.0 / 3.0 * depth.powf(1.5) / force - 1.0).abs() < 1e-11, "{a}");
            assert!((contact.area * depth / (a * a) - 1.0).abs() < 1e-12, "{a}");
        }
    }

    #[test]
    fn the_ratios_of_friction_from_the_pressure_itself() {
        // p(r) = (E*/π) ∫_r^a δ′(s)/√(s² − r²) ds, integrated here by s² = r² + w², r = a sin θ
        let a: f64 = 0.5;
        let contact = LawIndenter::Sphere.elastic(a * a.atanh()).unwrap();
        let slope = |s: f64| s.atanh() + s / (1.0 - s * s);
        let mut sums = [0.0; 3];
        for k in 0..400 {
            let theta = (k as f64 + 0.5) / 400.0 * PI / 2.0;
            let r = a * theta.sin();
            let end = a * theta.cos();
            let pressure = integral(end, |w| {
                let s = (r * r + w * w).sqrt();
                slope(s) / s
            });
            let weight = pressure * r * a * theta.cos();
            let root = (1.0 - r * r).sqrt();
            let curvature = 0.5 * (1.0 / root.powi(3) + 1.0 / root);
            for (sum, factor) in sums.iter_mut().zip([1.0, curvature, a * a.atanh() - (1.0 - root)]) {
                *sum += weight * factor;
            }
        }
        assert!((sums[1] / sums[0] / contact.slow_friction - 1.0).abs() < 1e-5);
        assert!((sums[2] / sums[0] / (0.8 * a * a.atanh()) / contact.fast_friction - 1.0).abs() < 1e-5);
    }

    #[test]
    fn a_shallow_sphere_is_a_paraboloid() {
        let contact = LawIndenter::Sphere.elastic(1e-10).unwrap();
        let slopes = [contact.area_slope, contact.friction_slope];
        let ratios = [contact.force, contact.area, contact.slow_friction, contact.fast_friction];
        for ratio in ratios.into_iter().chain(slopes) {
            assert!((ratio - 1.0).abs() < 1e-9, "{ratio}");
        }
        assert!(LawIndenter::Sphere.elastic(1.0).is_err());
        assert!(LawIndenter::Sphere.elastic(f64::NAN).is_err());
    }
}
