//! Rubbers: E∞/E0 = 1000 at every speed.

use crate::questions::paraboloid;
use judder_contact::kernel::substrate::SlidingSubstrate;
use judder_contact::unilateral::Loading;

/// On 128 × 128 cells the two frictions agree to 1 %; on 64 × 64 they come to 1.1 %.
///
/// At cell centres the active set cycles here and the pressure has holes; a loss angle upstream it has none.
#[test]
fn a_contrast_of_a_thousand_is_solved_at_every_speed_without_holes() {
    for exponent in -2..=6 {
        let length = 10.0_f64.powf(0.5 * f64::from(exponent) + 0.25);
        let contact = paraboloid(&SlidingSubstrate::single(1000.0, length), Loading::Indentation(1.0), 128);
        assert!(contact.refinement.levels.iter().all(|level| level.converged), "z = {length}");
        assert!(contact.friction_difference() < 1e-2, "z = {length}: {}", contact.friction_difference());
        let grid = contact.finest.grid;
        for row in contact.finest.solution.pressure.chunks_exact(grid.columns) {
            let runs = row.windows(2).filter(|pair| pair[0] == 0.0 && pair[1] > 0.0).count();
            assert!(runs <= 1, "z = {length}: a row has {runs} separate contacts");
        }
    }
}
