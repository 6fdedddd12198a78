//! The order of convergence, shown.

use crate::questions::on_grid;
use judder_contact::kernel::substrate::SlidingSubstrate;
use judder_contact::steady::GridChoice;
use judder_contact::steady::profile::Paraboloid;
use judder_contact::unilateral::Loading;

fn forces(substrate: &SlidingSubstrate) -> Vec<f64> {
    let contact = on_grid(substrate, &Paraboloid, Loading::Indentation(1.0), GridChoice::Cells(256), 1e-8);
    contact.refinement.levels.iter().map(|level| level.force).collect()
}

/// Against Hertz the force gains at least 1.5 orders with every halving of the cell.
#[test]
fn the_elastic_force_converges_faster_than_linearly() {
    let errors: Vec<f64> =
        forces(&SlidingSubstrate::elastic()).iter().map(|force| (force * 0.75 - 1.0).abs()).collect();
    let order = (errors[0] / errors[3]).log2() / 3.0;
    assert!(order > 1.5, "{order} from {errors:?}");
    assert!(errors[3] < 1e-5);
}

/// In between the limits there is no closed form: the differences of successive grids fall.
#[test]
fn the_viscoelastic_force_settles() {
    let forces = forces(&SlidingSubstrate::single(10.0, 0.1));
    let steps: Vec<f64> = forces.windows(2).map(|pair| (pair[1] - pair[0]).abs()).collect();
    assert!(steps[1] < 0.5 * steps[0] && steps[2] < 0.5 * steps[1], "{steps:?}");
}
