//! Searches that are stopped.

use crate::common::block::block_held;
use crate::growing;
use judder_assembly::friction::Friction;
use judder_assembly::interface::InterfaceLaw;
use judder_assembly::pressure::Pressure;
use judder_cycles::CyclesError;
use judder_cycles::branch::{BranchSettings, cycle_branch};
use judder_cycles::cycle::{CycleSettings, HarmonicCount, limit_cycles};
use judder_cycles::path::PathRule;
use judder_cycles::shooting::{ShootingSettings, shoot};
use judder_cycles::stability::floquet_multipliers;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Whatever it is asked for the how manieth time: what is stopped ends at once, and says so.
#[test]
fn what_is_stopped_ends_where_it_is() {
    let with_friction = |coefficient: f64| {
        let law = InterfaceLaw::Compliant(Pressure::Stiffness(1e11), Friction::Constant(coefficient));
        block_held(law, 1.0, [100.0, 5e-8])
    };
    let case = with_friction(0.3);
    let (steady, values) = growing(&case, [1e3, 6e5]);
    let settings = CycleSettings { harmonics: HarmonicCount::Fixed(5), ..CycleSettings::default() };
    let found = limit_cycles(&case, &steady, values[0], &settings, &|| true).unwrap();
    let cycle = &found.cycles[0];
    let rule = PathRule { steps: [0.02, 0.2, 1e-4], ..PathRule::default() };
    let along = BranchSettings { rule, range: [0.0, 0.5], unit: 0.3, rises: false, points: 9 };
    let stopped_after = |most: usize, which: usize| {
        let asked = AtomicUsize::new(0);
        let go_on = || asked.fetch_add(1, Ordering::Relaxed) < most;
        let error = match which {
            0 => limit_cycles(&case, &steady, values[0], &settings, &go_on).err(),
            1 => {
                let at = |coefficient: f64| Ok(with_friction(coefficient));
                cycle_branch(&at, &cycle.balance, (0.3, &cycle.motion), &along, &go_on).err()
            }
            2 => floquet_multipliers(&cycle.balance, &cycle.motion, &go_on).err(),
            _ => {
                let settings = ShootingSettings::default();
                shoot(&case, &cycle.balance, &cycle.motion, &settings, &go_on).err()
            }
        };
        (error, asked.into_inner())
    };
    for (most, which) in [0, 1, 7, 20].into_iter().flat_map(|most| (0..4).map(move |which| (most, which))) {
        let (error, asked) = stopped_after(most, which);
        assert_eq!(error, Some(CyclesError::Stopped), "{which} after {most}");
        assert_eq!(asked, most + 1, "{which} goes on");
    }
}
