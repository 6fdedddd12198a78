//! The summit of a function between two places, by golden sections.

const GOLDEN: f64 = 0.618_033_988_749_894_8;
/// Golden sections for a peak: the last is below 10⁻⁶ of the first.
const SECTIONS: usize = 30;

/// The place of the highest value of a function that has one summit between two places; the ends count.
pub(super) fn highest(mut function: impl FnMut(f64) -> f64, [from, to]: [f64; 2]) -> f64 {
    let (mut a, mut b) = (from, to);
    let (mut left, mut right) = (b - GOLDEN * (b - a), a + GOLDEN * (b - a));
    let (mut at_left, mut at_right) = (function(left), function(right));
    for _ in 0..SECTIONS {
        if at_left >= at_right {
            (b, right, at_right) = (right, left, at_left);
            left = b - GOLDEN * (b - a);
            at_left = function(left);
        } else {
            (a, left, at_left) = (left, right, at_right);
            right = a + GOLDEN * (b - a);
            at_right = function(right);
        }
    }
    let inner = if at_left >= at_right { (left, at_left) } else { (right, at_right) };
    [(from, function(from)), (to, function(to))]
        .into_iter()
        .fold(inner, |best, end| if end.1 > best.1 { end } else { best })
        .0
}
