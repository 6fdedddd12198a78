//! The elastic contact of a cylinder with a layer, by Chebyshev's polynomials: what is exact about every line contact.

use crate::kernel::check::KernelError;
use crate::kernel::layer::BondedLayer;
use judder_numerics::dense::Triangles;
use judder_numerics::gmres::dot;
use std::f64::consts::{FRAC_2_PI, LN_2, PI};
use thiserror::Error;

/// Polynomials of the pressure, and as many more for every thickness of half width: it bends within a thickness of its edges.
const POLYNOMIALS: usize = 12;
const POLYNOMIALS_A_THICKNESS: f64 = 4.0;
/// Half widths over thickness up to which a contact is solved.
const WIDEST: f64 = 40.0;
/// Steps in which the half width is found, and its relative error.
const STEPS: usize = 60;
const TOLERANCE: f64 = 1e-13;

/// Why there is no elastic contact of a cylinder with a layer.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum CylinderError {
    /// There is no such layer.
    #[error(transparent)]
    Layer(#[from] KernelError),
    /// The depth is not one.
    #[error("the indentation is {value} R, and must be positive and finite")]
    Indentation {
        /// δ/R.
        value: f64,
    },
    /// The contact is far wider than the layer is thick.
    #[error(
        "at an indentation of {indentation} R the contact is more than {WIDEST} times as wide as twice the layer, of {thickness} R: press less, or take a \
         thicker layer"
    )]
    TooWide {
        /// δ/R.
        indentation: f64,
        /// h/R.
        thickness: f64,
    },
}

/// The elastic contact of the cylinder x²/2R with a layer; lengths in R, pressures in E0*, all per length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CylinderOnLayer {
    /// δ.
    pub indentation: f64,
    /// a, half the width.
    pub half_width: f64,
    /// F.
    pub force: f64,
    /// ∫p u dx, twice the work that was done on the layer.
    pub twice_the_work: f64,
    /// K of p → K √d at a distance d inside an edge.
    pub edge: f64,
    /// T of the pressure T/√d at an edge of a stamp of the contact's width that is tilted: u = x.
    pub tilted_edge: f64,
    /// p at the middle.
    pub peak_pressure: f64,
}

impl CylinderOnLayer {
    /// The contact at a half width.
    ///
    /// With x = a t the pressure is √(1 − t²) Σ b_n U_2n(t), the displacement −(2/π) ∫p ln(|x − s|/h) ds of the half-space, exact for every
    /// polynomial, and the smooth part of the layer, by the rule of Gauss and Chebyshev; b_n and δ are such that u = δ − x²/2R at the
    /// zeros of a polynomial. On a thick layer this is Hertz: a² = 4F R/(π E0*).
    ///
    /// # Errors
    /// [`CylinderError::TooWide`].
    pub fn of_half_width(layer: &BondedLayer, half_width: f64) -> Result<Self, CylinderError> {
        let too_wide = CylinderError::TooWide {
            indentation: 0.5 * half_width * half_width,
            thickness: layer.thickness(),
        };
        let basis = CylinderBasis::new(layer, half_width).ok_or(too_wide)?;
        let (pressed, tilted) = (basis.pressed().ok_or(too_wide)?, basis.tilted().ok_or(too_wide)?);
        let (indentation, b) = pressed.split_last().ok_or(too_wide)?;
        let force = 0.5 * PI * half_width * b[0];
        // ∫√(1 − t²) U_2n t² is π/8 for n = 0 and n = 1
        let second_moment = PI / 8.0 * half_width.powi(3) * (b[0] + b[1]);
        let edges: f64 = b.iter().enumerate().map(|(n, b)| (2 * n + 1) as f64 * b).sum();
        let middle: f64 = b.iter().enumerate().map(|(n, b)| if n % 2 == 0 { *b } else { -b }).sum();
        Ok(Self {
            indentation: *indentation,
            half_width,
            force,
            twice_the_work: indentation * force - 0.5 * second_moment,
            edge: (2.0 / half_width).sqrt() * edges,
            tilted_edge: (0.5 * half_width).sqrt() * tilted.iter().sum::<f64>(),
            peak_pressure: middle,
        })
    }

    /// The contact at a depth.
    ///
    /// # Errors
    /// A depth that is none, [`CylinderError::TooWide`].
    pub fn of_indentation(layer: &BondedLayer, indentation: f64) -> Result<Self, CylinderError> {
        if !(indentation > 0.0 && indentation.is_finite()) {
            return Err(CylinderError::Indentation { value: indentation });
        }
        let too_wide = CylinderError::TooWide { indentation, thickness: layer.thickness() };
        // ln δ over ln a is smooth and rises: between √δ/4 and √(6 δ), the thinnest layer that keeps its volume
        let excess = |ln_half: f64| -> Result<f64, CylinderError> {
            let pressed = CylinderBasis::new(layer, libm::exp(ln_half)).and_then(|basis| basis.pressed());
            let found = pressed.and_then(|pressed| pressed.last().copied()).ok_or(too_wide)?;
            Ok(libm::log(found / indentation))
        };
        let root = indentation.sqrt();
        let (mut low, mut high) =
            (libm::log(0.05 * root), libm::log((2.5 * root).min(WIDEST * layer.thickness())));
        let (mut below, mut above) = (excess(low)?, excess(high)?);
        if below > 0.0 || above < 0.0 {
            return Err(too_wide);
        }
        // regula falsi that halves the value of the end that stays
        for _ in 0..STEPS {
            if high - low < TOLERANCE {
                break;
            }
            let middle = (low * above - high * below) / (above - below);
            let here = excess(middle)?;
            if here.abs() < TOLERANCE {
                (low, high) = (middle, middle);
            } else if here > 0.0 {
                (high, above, below) = (middle, here, 0.5 * below);
            } else {
                (low, below, above) = (middle, here, 0.5 * above);
            }
        }
        Self::of_half_width(layer, libm::exp(0.5 * (low + high))).map_err(|_| too_wide)
    }
}

/// What a pressure of polynomials makes of a layer.
struct CylinderBasis<'a> {
    layer: &'a BondedLayer,
    half_width: f64,
    count: usize,
}

impl<'a> CylinderBasis<'a> {
    /// `None` where the contact is too wide for it.
    fn new(layer: &'a BondedLayer, half_width: f64) -> Option<Self> {
        let wide = half_width / layer.thickness();
        (wide > 0.0 && wide <= WIDEST).then(|| {
            let count = POLYNOMIALS + (POLYNOMIALS_A_THICKNESS * wide) as usize;
            Self { layer, half_width, count }
        })
    }

    /// b_n and δ of the cylinder.
    fn pressed(&self) -> Option<Vec<f64>> {
        let (size, a) = (self.count + 1, self.half_width);
        let rule = self.rule();
        let weights: Vec<Vec<f64>> = (0..self.count)
            .map(|n| {
                let order = (2 * n + 1) as f64;
                rule.iter()
                    .map(|node| node.weight * libm::sin(node.angle) * libm::sin(order * node.angle))
                    .collect()
            })
            .collect();
        let mut entries = Vec::with_capacity(size * size);
        let mut right = Vec::with_capacity(size);
        for k in 0..size {
            let angle = self.angle(k, size);
            let smooth = self.smooth_at(angle, &rule);
            for (n, weights) in weights.iter().enumerate() {
                let order = (2 * n) as f64;
                let far = PI * libm::cos((order + 2.0) * angle) / (order + 2.0);
                // −∫√(1 − s²) U ln|t − s| ds
                let logarithm =
                    0.5 * if n == 0 { PI * LN_2 - far } else { PI * libm::cos(order * angle) / order - far };
                let weighted = dot(&smooth, weights);
                let reference = if n == 0 { 0.5 * PI * libm::log(self.layer.thickness() / a) } else { 0.0 };
                entries.push(a * (FRAC_2_PI * (logarithm + reference) + weighted));
            }
            entries.push(-1.0);
            right.push(-0.5 * (a * libm::cos(angle)).powi(2));
        }
        Triangles::new(size, entries)?.solve(&mut right);
        Some(right)
    }

    /// Coefficients of T_{2n+1}(t)/√(1 − t²) in the pressure of a stamp that is tilted: u = x.
    fn tilted(&self) -> Option<Vec<f64>> {
        let (size, a) = (self.count, self.half_width);
        let rule = self.rule();
        let weights: Vec<Vec<f64>> = (0..size)
            .map(|n| {
                let order = (2 * n + 1) as f64;
                rule.iter().map(|node| node.weight * libm::cos(order * node.angle)).collect()
            })
            .collect();
        let mut entries = Vec::with_capacity(size * size);
        let mut right = Vec::with_capacity(size);
        for k in 0..size {
            let angle = self.angle(k, size);
            let smooth = self.smooth_at(angle, &rule);
            for (n, weights) in weights.iter().enumerate() {
                let order = (2 * n + 1) as f64;
                entries.push(a * (2.0 * libm::cos(order * angle) / order + dot(&smooth, weights)));
            }
            right.push(a * libm::cos(angle));
        }
        Triangles::new(size, entries)?.solve(&mut right);
        Some(right)
    }

    /// The k-th of so many zeros t = cos θ > 0 of a polynomial.
    fn angle(&self, k: usize, size: usize) -> f64 {
        PI * (2 * k + 1) as f64 / (4 * size) as f64
    }

    /// Nodes on the whole width: of the first kind, with which ∫ f(t)/√(1 − t²) dt is exact.
    fn rule(&self) -> Vec<WidthNode> {
        let nodes = 8 * (self.count + 2);
        let weight = PI / nodes as f64;
        (0..nodes).map(|k| WidthNode { angle: weight * (k as f64 + 0.5), weight }).collect()
    }

    /// The smooth part of the displacement at a place from a force at every node.
    fn smooth_at(&self, angle: f64, rule: &[WidthNode]) -> Vec<f64> {
        let at = libm::cos(angle);
        rule.iter()
            .map(|node| self.layer.smooth_part(self.half_width * (at - libm::cos(node.angle))))
            .collect()
    }
}

/// A node t = cos θ.
struct WidthNode {
    angle: f64,
    weight: f64,
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Johnson, *Contact Mechanics*, 4.2: F = π a²/4R, p0 = a/2R, and so K = √(2a)/2R; a tilted stamp has p = x/(2 √(a² − x²)).
    #[test]
    fn on_a_thick_layer_it_is_hertz() {
        for nu in [0.0, 0.5] {
            let layer = BondedLayer::new(300.0, nu).unwrap();
            let contact = CylinderOnLayer::of_half_width(&layer, 0.1).unwrap();
            let near = |found: f64, expected: f64| {
                assert!((found / expected - 1.0).abs() < 1e-6, "{found} {expected}");
            };
            near(contact.force, PI * 0.01 / 4.0);
            near(contact.peak_pressure, 0.05);
            near(contact.edge, 0.2_f64.sqrt() / 2.0);
            near(contact.tilted_edge, 0.5 * 0.05_f64.sqrt());
        }
    }

    /// Johnson, *Contact Mechanics*, 5.8: a thin layer that yields where it is pressed has δ = a²/2R and
    /// F = (2/3) E* (1 − ν)²/(1 − 2ν) a³/(R h); one that keeps its volume δ = a²/6R and F = E* a⁵/(30 R h³).
    #[test]
    fn on_a_thin_layer_it_is_that_of_johnson() {
        let error = |nu: f64, wide: f64| {
            let (h, a): (f64, f64) = (1e-3, 1e-3 * wide);
            let contact = CylinderOnLayer::of_half_width(&BondedLayer::new(h, nu).unwrap(), a).unwrap();
            let (depth, force) = if nu == 0.5 {
                (a * a / 6.0, a.powi(5) / (30.0 * h.powi(3)))
            } else {
                (a * a / 2.0, 2.0 / 3.0 * (1.0 - nu).powi(2) / (1.0 - 2.0 * nu) * a.powi(3) / h)
            };
            [(contact.indentation / depth - 1.0).abs(), (contact.force / force - 1.0).abs()]
        };
        for nu in [0.0, 0.3, 0.5] {
            let ([depth, force], [less_depth, less_force]) = (error(nu, 10.0), error(nu, 40.0));
            // of first order in h/a
            assert!(less_depth < 0.35 * depth && less_depth < 0.08, "ν {nu}: {depth} {less_depth}");
            assert!(less_force < 0.35 * force && less_force < 0.25, "ν {nu}: {force} {less_force}");
        }
    }

    /// Work done on the layer while it is pressed: 2 ∫F dδ.
    #[test]
    fn the_work_is_that_of_the_force_along_the_depth() {
        for nu in [0.3, 0.5] {
            let layer = BondedLayer::new(0.3, nu).unwrap();
            let of = |half_width: f64| CylinderOnLayer::of_half_width(&layer, half_width).unwrap();
            let steps = 400;
            let halves: Vec<f64> = (0..=steps).map(|k| 0.2 * f64::from(k) / f64::from(steps)).collect();
            let work: f64 = halves[1..]
                .windows(2)
                .map(|pair| (of(pair[0]), of(pair[1])))
                .map(|(a, b)| (a.force + b.force) * (b.indentation - a.indentation))
                .sum();
            let end = of(0.2);
            assert!((work / end.twice_the_work - 1.0).abs() < 2e-4, "{work} {}", end.twice_the_work);
            let back = CylinderOnLayer::of_indentation(&layer, end.indentation).unwrap();
            assert!(
                (back.half_width / 0.2 - 1.0).abs() < 1e-10 && (back.force / end.force - 1.0).abs() < 1e-9
            );
        }
    }

    #[test]
    fn what_is_no_contact_is_refused() {
        let layer = BondedLayer::new(1e-3, 0.5).unwrap();
        for depth in [0.0, f64::NAN] {
            let found = CylinderOnLayer::of_indentation(&layer, depth);
            assert!(matches!(found, Err(CylinderError::Indentation { .. })));
        }
        let found = CylinderOnLayer::of_indentation(&layer, 0.1);
        assert!(matches!(found, Err(CylinderError::TooWide { .. })));
        assert!(matches!(
            CylinderOnLayer::of_half_width(&layer, f64::NAN),
            Err(CylinderError::TooWide { .. })
        ));
    }
}
