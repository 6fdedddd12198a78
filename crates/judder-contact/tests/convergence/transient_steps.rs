//! Orders in time and space, shown.

use crate::questions::{follow, paraboloid, transient};
use judder_contact::transient::{
    Before, CreepingSubstrate, IndenterPath, NormalCourse, PathCourse, StepControl,
};
use judder_contact::unilateral::{Loading, UnilateralLimits};

/// Force relaxation at rest has a closed form: its error falls with the square of the number of steps.
#[test]
fn the_steps_are_of_second_order() {
    let substrate = CreepingSubstrate::single(10.0, 1.0);
    let path = IndenterPath::at_rest(NormalCourse::Indentation(PathCourse::Constant(1.0)));
    let runs: Vec<[f64; 2]> = [1e-3, 1e-4, 1e-5]
        .map(|tolerance| {
            let mut question = transient(&substrate, &path, 0.5, 16);
            question.steps = StepControl { tolerance, ..StepControl::default() };
            question.limits = UnilateralLimits { tolerance: 1e-9, ..UnilateralLimits::default() };
            let history = follow(&question);
            let glassy = history.samples[0].force;
            let error = history.samples.iter().map(|sample| {
                let exact = 0.1 * (1.0 + 9.0 * (-10.0 * sample.time).exp());
                (sample.force / (glassy * exact) - 1.0).abs()
            });
            [history.samples.len() as f64, error.fold(0.0, f64::max)]
        })
        .to_vec();
    for pair in runs.windows(2) {
        let order = (pair[0][1] / pair[1][1]).ln() / (pair[1][0] / pair[0][0]).ln();
        assert!((1.7..3.0).contains(&order), "{order} from {runs:?}");
    }
    assert!(runs[2][1] < 1e-3);
}

/// Cells and steps made smaller together bring sliding that has lasted long nearer to steady sliding.
#[test]
#[ignore = "expensive: run by make validate"]
fn finer_grids_bring_long_sliding_nearer_to_steady_sliding() {
    let substrate = CreepingSubstrate::single(10.0, 1.0);
    let steady = paraboloid(&substrate.sliding_at(1.0), Loading::Indentation(1.0), 256).refinement;
    let path = IndenterPath::start_of_sliding(1.0, 0.0, NormalCourse::Indentation(PathCourse::Constant(1.0)));
    let errors: Vec<f64> = [16, 32, 64]
        .map(|cells| {
            let mut question = transient(&substrate, &path, 8.0, cells);
            question.before = Before::Settled;
            question.steps.cells_a_step = 0.5;
            let history = follow(&question);
            (history.mean(7.0, 8.0, |sample| sample.force) / steady.force.value - 1.0).abs()
        })
        .to_vec();
    assert!(errors[0] > 2.0 * errors[1] && errors[1] > 2.0 * errors[2], "{errors:?}");
    assert!(errors[2] < 3e-4, "{errors:?}");
}
