//! A uniform pressure on a square cell of an elastic half-space (Love 1929).

use std::f64::consts::PI;

/// Distance from the centre, in cells, beyond which the cell is seen as a point with its first corrections.
pub const FAR: f64 = 16.0;

/// Surface displacement at (x, y) from a unit pressure on the square of side 1 about the origin: (1/π) ∫ dA/r.
///
/// Closed form near the cell, [`far_displacement`] beyond [`FAR`] cells; relative error below 1e-12. Lengths in
/// cells, displacement in cells times pressure over E0*.
#[must_use]
pub fn displacement(x: f64, y: f64) -> f64 {
    if x * x + y * y > FAR * FAR { far_displacement(x, y) } else { near_displacement(x, y) }
}

/// Displacements at x, x + 1, x + 2, … of one row.
pub(crate) fn fill(x: f64, y: f64, out: &mut [f64]) {
    for (index, value) in out.iter_mut().enumerate() {
        *value = far_displacement(x + index as f64, y);
    }
    if y <= FAR {
        let index = |at: f64| (at - x).max(0.0) as usize;
        let (from, to) = (index(-FAR).min(out.len()), (index(FAR) + 1).min(out.len()));
        for (offset, value) in out[from..to].iter_mut().enumerate() {
            *value = displacement(x + (from + offset) as f64, y);
        }
    }
}

/// Love's closed form, the logarithms of opposite corners taken together so that little cancels.
fn near_displacement(x: f64, y: f64) -> f64 {
    let (x, y) = (x.abs(), y.abs());
    let (left, right, low, high) = (x - 0.5, x + 0.5, y - 0.5, y + 0.5);
    let right_side = right * log_ratio(right, low, high);
    let left_side = left * log_ratio(left, low, high);
    let high_side = high * log_ratio(high, left, right);
    let low_side = low * log_ratio(low, left, right);
    ((right_side - left_side) + (high_side - low_side)) / PI
}

/// asinh(b/|c|) − asinh(a/|c|), for b > |a|; 0 for c = 0, where only its product with c is wanted.
fn log_ratio(c: f64, a: f64, b: f64) -> f64 {
    let (square, top) = (c * c, b + libm::hypot(b, c));
    if square == 0.0 {
        return 0.0;
    }
    let bottom = libm::hypot(a, c) + a.abs();
    // a + √(a² + c²) of a negative a would cancel: it is c²/(√(a² + c²) − a).
    libm::log(if a < 0.0 { top * bottom / square } else { top / bottom })
}

/// The cell from afar: 1/r and its averages over the square to sixth order in 1/r, error about 1e-4/r⁸.
#[inline(always)]
#[must_use]
pub fn far_displacement(x: f64, y: f64) -> f64 {
    let (xx, yy) = (x * x, y * y);
    let inverse = 1.0 / (xx + yy);
    let skew = xx * yy * inverse * inverse;
    let fourth = 7.0 / 96.0 * skew - 7.0 / 1920.0;
    let sixth = 3.0 / 256.0 * skew - 3.0 / 7168.0;
    let corrections = 1.0 + inverse * (1.0 / 24.0 + inverse * (fourth + inverse * sixth));
    corrections * inverse.sqrt() / PI
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_centre_of_a_cell_yields_by_four_over_pi_times_the_logarithm_of_one_and_root_two() {
        let exact = 4.0 / PI * (1.0 + 2.0_f64.sqrt()).ln();
        assert!((displacement(0.0, 0.0) - exact).abs() < 1e-15);
    }

    #[test]
    fn near_and_far_agree_where_they_meet() {
        for angle in [0.0, 0.3, 0.785, 1.2, 1.57] {
            let (sine, cosine) = f64::sin_cos(angle);
            let (x, y) = (FAR * cosine, FAR * sine);
            let ratio = near_displacement(x, y) / far_displacement(x, y);
            assert!((ratio - 1.0).abs() < 1e-12, "{angle}: {ratio}");
        }
    }
}
