//! Section 4.3: Figs. 9 and 10.

use crate::panels::{Panel, panels};
use crate::sampling::linearised;
use judder_oscillator::Verdict;
use judder_oscillator::characteristic::Characteristic;
use judder_oscillator::linearisation::Linearisation;
use judder_oscillator::map::{OperatingPlane, adaptive};
use judder_oscillator::mechanism::StabilityClass;

/// Three shares of a panel, in per cent.
type Shares = (&'static str, &'static str, f64, f64, f64);

/// The unstable share of the panel; the share of the unstable area that is neither flutter (C = 0) nor ξ_eq < 0; and what of that is
/// unstable without c21 too.
const AREAS: [Shares; 8] = [
    ("fig-9a", "normal-load", 51.00, 5.37, 0.65),
    ("fig-9b", "normal-load", 43.76, 22.15, 3.18),
    ("fig-10a", "normal-load", 43.61, 9.79, 0.29),
    ("fig-10b", "normal-load", 71.67, 10.23, 1.11),
    ("fig-9a", "contact-force", 51.12, 5.23, 0.65),
    ("fig-9b", "contact-force", 42.25, 31.03, 3.36),
    ("fig-10a", "contact-force", 43.96, 16.86, 0.29),
    ("fig-10b", "contact-force", 72.13, 11.29, 1.12),
];

/// The text knows two mechanisms, mode coupling and "a Stribeck's effect". Others carry 5–22 % of the unstable area with
/// the normal load and 5–31 % with the contact force.
#[test]
fn other_mechanisms_carry_part_of_the_unstable_area() {
    let mut wrong = Vec::new();
    for (panel, (figure, load, unstable, neither, unequal)) in panels(1000).iter().zip(AREAS) {
        let map = adaptive(&panel.contact, &panel.plane);
        let share = 100.0 * map.unstable_fraction();
        let of_unstable = |class: StabilityClass| {
            100.0 * map.count(class) as f64 / map.classes.len() as f64 / map.unstable_fraction()
        };
        let by_damping = of_unstable(StabilityClass::DestabilisedByDamping);
        let third = of_unstable(StabilityClass::NormalForceCoupling) + by_damping;
        println!(
            "{figure} {load}: {share:.3} % unstable, neither {third:.3} %, by damping {by_damping:.3} %"
        );
        assert_eq!((panel.figure, panel.load_name()), (figure, load));
        assert!((share - unstable).abs() < 0.01, "{figure} {load}: unstable {share:.3} %");
        assert!((third - neither).abs() < 0.01, "{figure} {load}: neither {third:.3} %");
        wrong.extend(((by_damping - unequal).abs() >= 0.01).then_some((figure, load, by_damping)));
        assert_eq!(map.count(StabilityClass::Unresolved) + map.count(StabilityClass::Marginal), 0);
    }
    assert!(wrong.is_empty(), "by damping: {wrong:?}");
}

/// "The unstable region enlarges for materials with a higher interfacial shear strength", and "an instability region that is
/// larger than the conservative counterpart".
#[test]
fn the_unstable_region_grows_with_shear_strength_and_beyond_the_conservative_one() {
    let maps: Vec<_> = panels(200).iter().map(|p| adaptive(&p.contact, &p.plane)).collect();
    for load in [0, 4] {
        assert!(maps[load + 3].unstable_fraction() > 1.5 * maps[load + 2].unstable_fraction());
    }
    for map in &maps {
        let flutter = map.count(StabilityClass::Flutter) + map.count(StabilityClass::Both);
        assert!(flutter as f64 / (map.classes.len() as f64) < map.unstable_fraction());
    }
}

fn is_unstable(linearisation: &Linearisation) -> bool {
    Characteristic::new(&linearisation.system().reduced().unwrap()).verdict() == Verdict::Unstable
}

/// Share of a panel that changes sides with the text's positive c21.
fn moved_by_the_sign_of_c21(panel: &Panel) -> f64 {
    let (columns, rows) = (panel.plane.columns(), panel.plane.rows());
    let moves = |k: usize| {
        let right = linearised(&panel.contact, &panel.plane.coefficients(k % columns, k / columns));
        let printed = Linearisation { c21: -right.c21, ..right };
        is_unstable(&right) != is_unstable(&printed)
    };
    (0..columns * rows).filter(|k| moves(*k)).count() as f64 / (columns * rows) as f64
}

/// How much the wrong sign of c21 (section 4.1) would move.
#[test]
fn the_sign_of_c21_moves_up_to_a_tenth_of_the_maps() {
    for panel in panels(100) {
        let moved = moved_by_the_sign_of_c21(&panel);
        assert!((0.02..0.10).contains(&moved), "{} {}: {moved}", panel.figure, panel.load_name());
    }
}
