//! What runs in every step of a march must not ask for memory.

use judder_numerics::signal::Decimation;
use judder_numerics::signal::decimate::Decimator;
use judder_numerics::signal::extremes::Extremes;

#[test]
fn a_push_allocates_nothing() {
    let mut filter = Decimator::new(&Decimation::new(1.0 / 3e-7, 50e3, 8), &[0.0]).unwrap();
    let mut extremes = Extremes::default();
    let mut sum = 0.0;
    let steps = || {
        for step in 0..10_000_u64 {
            let value = (step % 17) as f64;
            extremes.update(step, value);
            sum += filter.push(&[value]).map_or(0.0, |passed| passed[0]);
        }
    };
    assert_eq!(allocation_counter::measure(steps).count_total, 0);
    assert!(sum > 0.0 && extremes.maximum() == Some((16, 16.0)));
    assert_eq!(allocation_counter::measure(|| drop(filter.state())).count_current, 0);
    assert!(allocation_counter::measure(|| drop(filter.state())).count_total > 0);
}
