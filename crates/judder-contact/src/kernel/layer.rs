//! A layer on a rigid base under pressures that do not change across the direction of sliding: plane strain.

use super::check::KernelError;
use super::line;
use judder_numerics::quadrature::gauss_legendre;
use std::f64::consts::{FRAC_2_PI, PI};
use std::sync::{Arc, Mutex, PoisonError};

/// Distance, in thicknesses, beyond which the surface does not move: the displacement falls by a factor of e^{−0.8} a thickness at least.
const REACH: f64 = 40.0;
/// Panels of the table of the displacement in a thickness, and coefficients of a panel.
const PANELS_A_THICKNESS: usize = 2;
const COEFFICIENTS: usize = 14;
/// Wave numbers, over the thickness, beyond which a layer is a half-space to rounding, and panels of the quadrature up to there.
const DEEPEST_WAVE: f64 = 24.0;
const WAVE_PANELS: usize = 96;
/// Nodes of a panel of the quadrature.
const NODES: usize = 12;
/// Responses that are kept.
const KEPT: usize = 8;
/// Widths of a cell, over the thickness, that one rule integrates.
const WIDEST_PANEL: f64 = 0.5;
/// Nodes of the mean over a cell.
const CELL_NODES: usize = 6;

/// A layer of a thickness on a base that does not move and holds it: nothing slips there.
///
/// A pressure p e^{iqx} moves its surface by 2 J(q) f(q h)/|q| p e^{iqx}, in 1/E0*, with f of [`BondedLayer::transfer`]: as the half-space does
/// (f = 1) where waves are short, and by a finite amount where they are long. So a line contact has an indentation.
#[derive(Debug, Clone, PartialEq)]
pub struct BondedLayer {
    thickness: f64,
    response: Arc<LayerResponse>,
}

impl BondedLayer {
    /// A layer of thickness h, in the problem's length unit, and Poisson's ratio ν, the same at all frequencies.
    ///
    /// # Errors
    /// [`KernelError::Thickness`], [`KernelError::PoissonRatio`] beyond −1 to 1/2.
    pub fn new(thickness: f64, poisson_ratio: f64) -> Result<Self, KernelError> {
        if !(thickness > 0.0 && thickness.is_finite()) {
            return Err(KernelError::Thickness { value: thickness });
        }
        if !(poisson_ratio > -1.0 && poisson_ratio <= 0.5) {
            return Err(KernelError::PoissonRatio { value: poisson_ratio });
        }
        Ok(Self { thickness, response: LayerResponse::of(poisson_ratio) })
    }

    /// h, in the problem's length unit.
    #[must_use]
    pub fn thickness(&self) -> f64 {
        self.thickness
    }

    /// ν.
    #[must_use]
    pub fn poisson_ratio(&self) -> f64 {
        self.response.poisson_ratio
    }

    /// The same layer with lengths in other units.
    #[must_use]
    pub(super) fn in_units(&self, unit: f64) -> Self {
        Self { thickness: self.thickness / unit, response: Arc::clone(&self.response) }
    }

    /// f(q h), what the layer yields to a pressure e^{iqx} over what a half-space does: with κ = 3 − 4ν
    ///
    /// f(α) = (κ sinh 2α − 2α)/(κ cosh 2α + 2α² + 5 − 12ν + 8ν²), of Bentall and Johnson (1968); see also Johnson, *Contact Mechanics*, 5.8.
    /// For α → 0 it is α (1 − 2ν)/(2 (1 − ν)²), the layer that yields where it is pressed; for ν = 1/2 it is 2α³/3, the layer that can only flow aside.
    #[must_use]
    pub fn transfer(&self, wave_number: f64) -> f64 {
        transfer(wave_number.abs() * self.thickness, self.response.poisson_ratio)
    }

    /// Displacement at x from a unit force on a line at the origin, over E0*, but for −(2/π) ln(|x|/h): smooth.
    #[must_use]
    pub fn smooth_part(&self, x: f64) -> f64 {
        self.response.smooth_part(x.abs() / self.thickness)
    }

    /// Displacement at x from a unit pressure on the strip of width 1 about the origin.
    ///
    /// Lengths in widths of the strip, displacement in widths times pressure over E0*.
    #[must_use]
    pub fn displacement(&self, x: f64) -> f64 {
        let (x, half) = (x.abs(), 0.5);
        if x - half > REACH * self.thickness {
            return 0.0;
        }
        let panels = (1.0 / (WIDEST_PANEL * self.thickness)).ceil().max(1.0);
        let rule = gauss_legendre::<CELL_NODES>();
        let width = 1.0 / panels;
        let mean: f64 = (0..panels as usize)
            .flat_map(|panel| rule.map(move |(node, weight)| ((panel as f64 + node) * width, weight * width)))
            .map(|(at, weight)| weight * self.smooth_part(x - half + at))
            .sum();
        line::displacement(x, self.thickness) + mean
    }
}

/// f(α).
fn transfer(wave: f64, poisson_ratio: f64) -> f64 {
    let (z, nu) = (2.0 * wave, poisson_ratio);
    let decay = libm::exp(-z);
    // sinh z − z cancels for long waves
    let numerator = if z < 0.3 {
        let square = z * z;
        let beyond = z * square / 6.0 * (1.0 + square / 20.0 * (1.0 + square / 42.0 * (1.0 + square / 72.0)));
        2.0 * decay * ((2.0 - 4.0 * nu) * libm::sinh(z) + beyond)
    } else {
        (3.0 - 4.0 * nu) * (1.0 - decay * decay) - 2.0 * z * decay
    };
    numerator / denominator(z, nu)
}

/// 1 − f(α), which falls as α² e^{−2α}.
fn lack(wave: f64, poisson_ratio: f64) -> f64 {
    let (z, nu) = (2.0 * wave, poisson_ratio);
    let decay = libm::exp(-z);
    let held = z * z + 2.0 * z + 10.0 - 24.0 * nu + 16.0 * nu * nu;
    decay * (2.0 * (3.0 - 4.0 * nu) * decay + held) / denominator(z, nu)
}

/// 2 e^{−z} times the denominator of f, z = 2α.
fn denominator(z: f64, nu: f64) -> f64 {
    let decay = libm::exp(-z);
    (3.0 - 4.0 * nu) * (1.0 + decay * decay) + decay * (z * z + 10.0 - 24.0 * nu + 16.0 * nu * nu)
}

/// The smooth part of the displacement under a line of force as a table over the distance in thicknesses:
/// c(ξ) = (2/π) ∫_0^∞ (e^{−α} − (1 − f(α)) cos αξ)/α dα, from −ln ξ = ∫ (cos αξ − e^{−α})/α dα.
#[derive(Debug, PartialEq)]
struct LayerResponse {
    poisson_ratio: f64,
    /// Coefficients of Chebyshev's polynomials, a panel each.
    panels: Vec<[f64; COEFFICIENTS]>,
}

impl LayerResponse {
    /// That of a Poisson's ratio; the last few are kept.
    fn of(poisson_ratio: f64) -> Arc<Self> {
        static KNOWN: Mutex<Vec<Arc<LayerResponse>>> = Mutex::new(Vec::new());
        let known = || KNOWN.lock().unwrap_or_else(PoisonError::into_inner);
        let is_it = |response: &&Arc<Self>| response.poisson_ratio.to_bits() == poisson_ratio.to_bits();
        if let Some(found) = known().iter().find(is_it) {
            return Arc::clone(found);
        }
        let made = Arc::new(Self::new(poisson_ratio));
        let mut known = known();
        if known.len() == KEPT {
            known.remove(0);
        }
        known.push(Arc::clone(&made));
        made
    }

    fn new(poisson_ratio: f64) -> Self {
        let rule = gauss_legendre::<NODES>();
        let width = DEEPEST_WAVE / WAVE_PANELS as f64;
        let waves: Vec<[f64; 3]> = (0..WAVE_PANELS)
            .flat_map(|panel| rule.map(|(node, weight)| ((panel as f64 + node) * width, weight * width)))
            .map(|(wave, weight)| {
                [wave, weight * libm::exp(-wave) / wave, weight * lack(wave, poisson_ratio) / wave]
            })
            .collect();
        let at = |distance: f64| -> f64 {
            waves.iter().map(|[wave, free, lacks]| free - lacks * libm::cos(wave * distance)).sum::<f64>()
                * FRAC_2_PI
        };
        let count = (REACH * PANELS_A_THICKNESS as f64) as usize;
        let panels = (0..count).map(|panel| coefficients(|t| at(place(panel, t)))).collect();
        Self { poisson_ratio, panels }
    }

    fn smooth_part(&self, distance: f64) -> f64 {
        let panel = (distance * PANELS_A_THICKNESS as f64) as usize;
        let Some(coefficients) = self.panels.get(panel) else {
            // the displacement is zero
            return FRAC_2_PI * libm::log(distance);
        };
        let t = 2.0 * (distance * PANELS_A_THICKNESS as f64 - panel as f64) - 1.0;
        let (mut last, mut before) = (0.0, 0.0);
        for coefficient in coefficients.iter().skip(1).rev() {
            (last, before) = (2.0 * t * last - before + coefficient, last);
        }
        t * last - before + coefficients[0]
    }
}

/// The place of t ∈ (−1, 1) in a panel, in thicknesses.
fn place(panel: usize, t: f64) -> f64 {
    (panel as f64 + 0.5 * (1.0 + t)) / PANELS_A_THICKNESS as f64
}

/// The coefficients of Chebyshev's polynomials through a function's values at their zeros.
fn coefficients(function: impl Fn(f64) -> f64) -> [f64; COEFFICIENTS] {
    let angle = |k: usize| PI * (k as f64 + 0.5) / COEFFICIENTS as f64;
    let values: [f64; COEFFICIENTS] = std::array::from_fn(|k| function(libm::cos(angle(k))));
    std::array::from_fn(|order| {
        let sum: f64 =
            values.iter().enumerate().map(|(k, value)| value * libm::cos(order as f64 * angle(k))).sum();
        sum * if order == 0 { 1.0 } else { 2.0 } / COEFFICIENTS as f64
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use judder_numerics::dense::Triangles;

    /// Displacement over 2/(E* q) of a pressure cos qx on a layer, from Airy's stress function (A + B z) cosh qz + (C + D z) sinh qz of one wave.
    fn of_stress_function(wave: f64, nu: f64) -> f64 {
        // lengths in 1/q, stresses in p, displacements in (1 + ν)/E; value and three slopes of the four functions at z
        let functions = |z: f64| {
            let (s, c) = (z.sinh(), z.cosh());
            let plain = [[c, s, c, s], [s, c, s, c]];
            let with_z = |even: bool| {
                let (a, b) = if even { (c, s) } else { (s, c) };
                [z * a, a + z * b, 2.0 * b + z * a, 3.0 * a + z * b]
            };
            [plain[0], with_z(true), plain[1], with_z(false)]
        };
        let [base, top] = [functions(0.0), functions(wave)];
        let along = |f: [f64; 4]| (1.0 - nu) * f[2] + nu * f[0];
        let down = |f: [f64; 4]| -((1.0 - nu) * f[3] - (2.0 - nu) * f[1]);
        let rows = [base.map(along), base.map(down), top.map(|f| f[1]), top.map(|f| f[0])].concat();
        let mut solution = [0.0, 0.0, 0.0, 1.0];
        Triangles::new(4, rows).unwrap().solve(&mut solution);
        let displacement: f64 = top.map(down).iter().zip(solution).map(|(f, factor)| f * factor).sum();
        displacement / (2.0 * (1.0 - nu))
    }

    #[test]
    fn the_transfer_function_is_that_of_a_stress_function() {
        for nu in [0.0, 0.3, 0.45, 0.5] {
            for wave in [0.05, 0.149, 0.151, 0.7, 2.0, 6.0] {
                let (found, expected) = (transfer(wave, nu), of_stress_function(wave, nu));
                assert!((found - expected).abs() < 1e-10, "ν {nu}, q h {wave}: {found} {expected}");
                assert!((1.0 - lack(wave, nu) - found).abs() < 1e-13);
            }
        }
    }

    /// The displacement of a strip in space, summed over waves: 2 f(q)/q.
    #[test]
    fn the_displacement_is_that_of_the_transfer_function() {
        for nu in [0.0, 0.3, 0.5] {
            for (thickness, wave) in [(3.0, 0.4), (20.0, 0.1), (0.4, 1.0)] {
                let layer = BondedLayer::new(thickness, nu).unwrap();
                let rule = gauss_legendre::<8>();
                // strips at all places, by panels that are graded towards the edges of one
                let mut sum = 0.0;
                let edges = |from: f64, to: f64, add: &mut dyn FnMut(f64, f64)| {
                    rule.iter()
                        .for_each(|(node, weight)| add(from + (to - from) * node, weight * (to - from)));
                };
                let mut breaks: Vec<f64> = (0..60).map(|k| 0.5 * (1.0 - 0.6_f64.powi(k))).collect();
                breaks.extend((0..60).rev().map(|k| 0.5 * (1.0 + 0.6_f64.powi(k))));
                let end = 30.0 * thickness.max(1.0);
                breaks.extend((1..400).map(|k| 1.0 + (end - 1.0) * f64::from(k) / 399.0));
                for pair in breaks.windows(2) {
                    edges(pair[0], pair[1], &mut |x, weight| {
                        sum += 2.0 * weight * layer.displacement(x) * (wave * x).cos();
                    });
                }
                let sinc = (0.5 * wave).sin() / (0.5 * wave);
                let expected = 2.0 * layer.transfer(wave) / wave * sinc;
                assert!((sum - expected).abs() < 2e-8, "ν {nu}, h {thickness}: {sum} {expected}");
            }
        }
    }

    #[test]
    fn the_surface_is_at_rest_where_the_table_ends() {
        for nu in [-0.9, 0.0, 0.25, 0.5] {
            let response = LayerResponse::of(nu);
            let left = response.smooth_part(REACH * (1.0 - 1e-12)) - FRAC_2_PI * REACH.ln();
            assert!(left.abs() < 5e-12, "ν {nu}: {left:e}");
        }
    }
}
