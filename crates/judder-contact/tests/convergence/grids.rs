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

/// In between the limits there is no closed form: the steps from grid to grid fall by at least 1.5 orders a halving, from the first
/// to the last, at every contrast and speed. One by one they jump, for the edge falls into its cells as it pleases.
#[test]
fn the_viscoelastic_force_converges_faster_than_linearly() {
    println!("E∞/E0   z      steps, order");
    for (contrast, length) in
        [(10.0, 0.1), (10.0, 1.0), (10.0, 10.0), (100.0, 0.3), (100.0, 3.0), (1000.0, 1.0)]
    {
        let forces = forces(&SlidingSubstrate::single(contrast, length));
        let steps: Vec<f64> = forces.windows(2).map(|pair| (pair[1] / pair[0] - 1.0).abs()).collect();
        let order = (steps[0] / steps[2]).log2() / 2.0;
        println!("{contrast:5} {length:5} {:8.1e} {:8.1e} {:8.1e} {order:5.2}", steps[0], steps[1], steps[2]);
        assert!(order > 1.5, "{order} from {steps:?}");
        assert!(steps[2] < 1e-4, "{steps:?}");
    }
}
