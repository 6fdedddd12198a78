//! Means beside a filter: where they lie, what they keep of a jump.

use judder_numerics::counter::uniform;
use judder_numerics::signal::Decimation;
use judder_numerics::signal::decimate::Decimator;
use judder_numerics::signal::means::WindowMeans;

const STEPS: usize = 3000;

fn filter(factor: usize) -> Decimator {
    let kept = 1e6 / factor as f64;
    let asked = Decimation { stop_edge: kept - 0.4 * kept, ..Decimation::new(1e6, 0.4 * kept, factor) };
    Decimator::new(&asked, &[0.0]).unwrap()
}

/// Outputs of the filter and means, from the first that does not lie before the first sample.
fn both(factor: usize, signal: &dyn Fn(usize) -> f64) -> Vec<[f64; 2]> {
    let mut filter = filter(factor);
    let mut means = WindowMeans::beside(&filter, 1);
    let delay = filter.delay_in_samples();
    let mut outputs = Vec::new();
    let mut next = 0;
    let mut add = |passed: f64, means: &mut WindowMeans| {
        if next * factor >= delay {
            let mut mean = [0.0];
            means.take(&mut mean);
            outputs.push([passed, mean[0]]);
        }
        next += 1;
    };
    for step in 0..STEPS {
        means.push(&[signal(step)]);
        if let Some(passed) = filter.push(&[signal(step)]) {
            add(passed[0], &mut means);
        }
    }
    filter.finish()[0].iter().for_each(|passed| add(*passed, &mut means));
    outputs
}

#[test]
fn means_lie_at_the_times_of_the_outputs() {
    // a filter of linear phase lets a straight line through; of an odd number of samples the mean is the middle one
    let outputs = both(7, &|step| step as f64);
    assert!(outputs.len() >= STEPS / 7);
    let settled = &outputs[40..outputs.len() - 40];
    assert!(settled.iter().all(|[passed, mean]| (passed - mean).abs() < 1e-3 * passed), "{settled:?}");
    // and amid an even number half a sample after it
    let settled = &both(8, &|step| step as f64)[40..300];
    assert!(settled.windows(2).all(|pair| (pair[1][1] - pair[0][1] - 8.0).abs() < 1e-9));
}

#[test]
fn a_jump_does_not_ring() {
    let outputs = both(8, &|step| f64::from(u8::from(step >= STEPS / 2)));
    assert!(outputs.iter().any(|[passed, _]| *passed > 1.005), "the filter rings");
    assert!(outputs.iter().all(|[_, mean]| (0.0..=1.0).contains(mean)));
    let between = outputs.iter().filter(|[_, mean]| *mean > 0.0 && *mean < 1.0).count();
    assert!(between <= 1, "{between}");
}

#[test]
fn the_sum_of_the_samples_is_kept() {
    let sample = |step: usize| {
        if (100..STEPS - 100).contains(&step) { uniform(3, step as u64) } else { 0.0 }
    };
    let means: f64 = both(6, &sample).iter().map(|[_, mean]| 6.0 * mean).sum();
    let samples: f64 = (0..STEPS).map(sample).sum();
    assert!((means / samples - 1.0).abs() < 1e-12, "{means} {samples}");
}

#[test]
fn what_was_kept_goes_on_to_the_bit() {
    let filter = filter(5);
    let mut whole = WindowMeans::beside(&filter, 1);
    let mut kept = whole.clone();
    for step in 0..977 {
        let sample = [uniform(1, step)];
        whole.push(&sample);
        if step == 433 {
            let text = serde_json::to_string(&kept).unwrap();
            kept = serde_json::from_str(&text).unwrap();
        }
        kept.push(&sample);
    }
    assert_eq!(whole, kept);
}
