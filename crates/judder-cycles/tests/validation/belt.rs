//! A mass on a belt with friction that falls: its stick-slip cycle, against the motion itself.

use crate::common::{assembly, diagonal, point_on_plane};
use crate::growing;
use judder_assembly::assembly::Assembly;
use judder_assembly::friction::{FallingFriction, Friction};
use judder_assembly::interface::InterfaceLaw;
use judder_cycles::cycle::{CycleSettings, HarmonicCount, limit_cycles};

const FALLING: FallingFriction = FallingFriction { at_rest: 0.4, at_speed: 0.2, decay_speed: 0.5 };
const SPEED: f64 = 0.3;
const DAMPING: f64 = 0.02;
const STIFFNESS: f64 = 100.0;

/// 1 kg on 100 N/m, pressed with 1 N on a belt at 0.3 m/s.
fn mass_on_belt() -> Assembly {
    assembly(
        [diagonal(&[1.0; 2]), diagonal(&[DAMPING, 0.0]), diagonal(&[STIFFNESS, 0.0])],
        vec![0.0, -1.0],
        vec![point_on_plane(&[0, 1], SPEED, 0.0)],
        InterfaceLaw::Rigid(Friction::Falling(FALLING)),
    )
}

/// ω in rad/s, the share of stick, the root mean square of the velocity: the mass leaves the belt where the spring overcomes μ(0), slides until it is as fast
/// as the belt again (Runge–Kutta of the fourth order), and is carried back to where it left.
fn by_the_motion_itself() -> [f64; 3] {
    const STEP: f64 = 1e-5;
    let rate = |[x, v]: [f64; 2]| [v, FALLING.at((v - SPEED).abs()).0 - DAMPING * v - STIFFNESS * x];
    let leaves = (FALLING.at_rest - DAMPING * SPEED) / STIFFNESS;
    let along = |[x, v]: [f64; 2], [dx, dv]: [f64; 2], by: f64| [x + by * dx, v + by * dv];
    let mut at = [leaves + 1e-12, SPEED - 1e-12];
    let (mut time, mut squared, mut steps) = (0.0, 0.0, 0_u64);
    loop {
        let k1 = rate(at);
        let k2 = rate(along(at, k1, 0.5 * STEP));
        let k3 = rate(along(at, k2, 0.5 * STEP));
        let k4 = rate(along(at, k3, STEP));
        let next = [0, 1].map(|i| at[i] + STEP / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]));
        let share = if next[1] > SPEED && steps > 1000 { (SPEED - at[1]) / (next[1] - at[1]) } else { 1.0 };
        time += share * STEP;
        squared += share * STEP * 0.5 * (at[1] * at[1] + next[1].min(SPEED) * next[1].min(SPEED));
        at = [at[0] + share * (next[0] - at[0]), next[1].min(SPEED)];
        steps += 1;
        if share < 1.0 {
            break;
        }
    }
    let stuck = (leaves - at[0]) / SPEED;
    let period = time + stuck;
    [std::f64::consts::TAU / period, stuck / period, ((squared + SPEED * SPEED * stuck) / period).sqrt()]
}

/// Friction jumps where the mass is caught, so that the error falls slowly with the number of harmonics.
#[test]
fn a_mass_sticks_and_slips_as_the_motion_itself_does() {
    let case = mass_on_belt();
    let (steady, values) = growing(&case, [5.0, 20.0]);
    let [frequency, _, rms] = by_the_motion_itself();
    let errors = [10, 40, 160].map(|harmonics| {
        let settings =
            CycleSettings { harmonics: HarmonicCount::Fixed(harmonics), ..CycleSettings::default() };
        let found = limit_cycles(&case, &steady, values[0], &settings, &|| true).unwrap();
        let cycle = &found.cycles[0];
        assert!(cycle.attracts && cycle.held_back.is_none());
        assert_eq!(cycle.balance.series().harmonics(), harmonics);
        let [stick, slip, open] = cycle.points[0].shares;
        assert!(stick > 0.0 && (stick + slip - 1.0).abs() < 1e-12 && open == 0.0);
        [cycle.frequency() / frequency - 1.0, cycle.points[0].tangential_velocity_rms / rms - 1.0]
    });
    let largest = errors.map(|own| own[0].abs().max(own[1].abs()));
    assert!(largest[1] < 5e-4 && largest[2] < 2e-4, "{errors:?}");
    assert!(largest[1] < 0.1 * largest[0], "{errors:?}");
}
