//! The same work on many things over all threads, collected in an order that does not depend on them.

use rayon::prelude::*;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};

/// How many things are worked on at once.
#[must_use]
pub fn threads() -> usize {
    rayon::current_num_threads()
}

/// What `of` gives for each of the `items`, in their order.
pub fn each<'a, I: Sync, T: Send>(items: &'a [I], of: impl Fn(&'a I) -> T + Sync) -> Vec<T> {
    each_place(items.len(), |place| of(&items[place]))
}

/// What `of` gives for 0, 1, …, `count` − 1, in this order.
pub fn each_place<T: Send>(count: usize, of: impl Fn(usize) -> T + Sync) -> Vec<T> {
    let found: Vec<Mutex<Option<T>>> = (0..count).map(|_| Mutex::new(None)).collect();
    spread(count, &|place| {
        let own = of(place);
        *found[place].lock().unwrap_or_else(PoisonError::into_inner) = Some(own);
    });
    found.into_iter().filter_map(|own| own.into_inner().unwrap_or_else(PoisonError::into_inner)).collect()
}

/// What `of` gives for each of the `items`, in their order.
///
/// # Errors
///
/// Of several errors the one of the first item; what stands behind it may not have been asked for.
pub fn try_each<'a, I: Sync, T: Send, E: Send>(
    items: &'a [I],
    of: impl Fn(&'a I) -> Result<T, E> + Sync,
) -> Result<Vec<T>, E> {
    try_each_place(items.len(), |place| of(&items[place]))
}

/// What `of` gives for 0, 1, …, `count` − 1, in this order.
///
/// # Errors
///
/// Of several errors the one of the lowest place; places behind it may not have been asked for.
pub fn try_each_place<T: Send, E: Send>(
    count: usize,
    of: impl Fn(usize) -> Result<T, E> + Sync,
) -> Result<Vec<T>, E> {
    let failed = AtomicUsize::new(count);
    let found = each_place(count, |place| {
        if place > failed.load(Ordering::Relaxed) {
            return None;
        }
        let own = of(place);
        if own.is_err() {
            failed.fetch_min(place, Ordering::Relaxed);
        }
        Some(own)
    });
    found.into_iter().flatten().collect()
}

/// Compiled once for whatever work: as a parallel iterator of its own, each kind of work takes some ten thousand bytes.
fn spread(count: usize, work: &(dyn Fn(usize) + Sync)) {
    (0..count).into_par_iter().for_each(work);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_are_in_order() {
        let items: Vec<usize> = (0..10_000).collect();
        assert_eq!(each(&items, |item| item * 2), each_place(10_000, |place| place * 2));
        assert_eq!(each(&items, |item| *item), items);
        assert_eq!(try_each(&items, |item| Ok::<_, ()>(*item)), Ok(items));
    }

    /// Also where the first one takes longest.
    #[test]
    fn of_several_errors_the_first_is_told() {
        let items: Vec<usize> = (0..1000).collect();
        for _ in 0..20 {
            let found = try_each(&items, |item| match item {
                300 => {
                    std::thread::sleep(std::time::Duration::from_millis(1));
                    Err(300)
                }
                301.. => Err(*item),
                _ => Ok(()),
            });
            assert_eq!(found, Err(300));
        }
    }
}
