//! Things in the order of their numbers.

use std::cmp::Ordering;

/// Sorts numbers, rising, as [`f64::total_cmp`] has it.
pub fn sort_numbers(numbers: &mut [f64]) {
    numbers.sort_unstable_by(f64::total_cmp);
}

/// Sorts by a number of each item, rising, as [`f64::total_cmp`] has it; equal ones stay as they stand.
pub fn sort_by_number<T>(items: &mut [T], of: impl Fn(&T) -> f64) {
    sort_by_numbers(items, |item| [of(item)]);
}

/// Sorts by numbers of each item, by the first, of equal ones by the second, and so on.
pub fn sort_by_numbers<T, const N: usize>(items: &mut [T], of: impl Fn(&T) -> [f64; N]) {
    let numbers: Vec<f64> = items.iter().flat_map(of).collect();
    let mut order = sorted_places(&numbers, N);
    for place in 0..order.len() {
        // what stood there has gone to where another came from
        let mut from = order[place];
        while from < place {
            from = order[from];
        }
        order[place] = from;
        items.swap(place, from);
    }
}

/// The places of items in the order of their numbers, `each` of every item: compiled once, not for every kind of item.
fn sorted_places(numbers: &[f64], each: usize) -> Vec<usize> {
    let mut order: Vec<usize> = (0..numbers.len() / each.max(1)).collect();
    order.sort_by(|one, other| {
        let pairs = numbers[one * each..].iter().zip(&numbers[other * each..]).take(each);
        pairs.map(|(one, other)| one.total_cmp(other)).find(|order| order.is_ne()).unwrap_or(Ordering::Equal)
    });
    order
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// Infinities, both zeros and what is not a number among them.
        #[test]
        fn the_order_is_that_of_the_standard_library(
            values in prop::collection::vec((prop::num::f64::ANY, -2i32..2), 0..300)
        ) {
            let pairs: Vec<(usize, f64, f64)> =
                values.iter().enumerate().map(|(k, (value, other))| (k, *value, f64::from(*other))).collect();
            let places = |pairs: &[(usize, f64, f64)]| pairs.iter().map(|own| own.0).collect::<Vec<_>>();
            let (mut own, mut expected) = (pairs.clone(), pairs.clone());
            sort_by_number(&mut own, |pair| -pair.1);
            expected.sort_by(|a, b| b.1.total_cmp(&a.1));
            prop_assert_eq!(places(&own), places(&expected));
            let (mut own, mut expected) = (pairs.clone(), pairs);
            sort_by_numbers(&mut own, |pair| [pair.2, pair.1]);
            expected.sort_by(|a, b| a.2.total_cmp(&b.2).then(a.1.total_cmp(&b.1)));
            prop_assert_eq!(places(&own), places(&expected));
        }
    }
}
