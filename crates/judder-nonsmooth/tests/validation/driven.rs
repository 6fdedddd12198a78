//! Motions that are driven: closed forms of what changes over time.

use crate::common::{IMPLICIT, assembly, coulomb, diagonal, mass_on_plane, settings};
use judder_assembly::assembly::Assembly;
use judder_assembly::friction::{Friction, TableInterpolation};
use judder_assembly::interface::InterfaceLaw;
use judder_nonsmooth::contact_problem::PointMotion;
use judder_nonsmooth::course::{Course, TimeFactor, TimeTable};
use judder_nonsmooth::excitation::{DrivingSignal, Excitation, FrequencySweep};
use judder_nonsmooth::march::NonsmoothMarch;
use judder_nonsmooth::scheme::ContactScheme;
use std::f64::consts::PI;

const SCHEMES: [ContactScheme; 2] = [IMPLICIT, ContactScheme::ForwardIncrement];
const ALL: [ContactScheme; 3] = [IMPLICIT, ContactScheme::ForwardIncrement, ContactScheme::Smoothed];
/// A track that all but rests.
const REST: f64 = 1e-12;

fn table(times: &[f64], values: &[f64]) -> TimeTable {
    TimeTable { times: times.to_vec(), values: values.to_vec() }
}

fn sine(amplitude: f64, angular_frequency: f64, phase: f64) -> DrivingSignal {
    DrivingSignal::Sine { amplitude, angular_frequency, phase }
}

/// A mass on a spring with a damper that touches nothing.
fn oscillator(mass: f64, damping: f64, spring: f64, load: f64) -> Assembly {
    let mut case = assembly(
        [diagonal(&[mass]), diagonal(&[damping]), diagonal(&[spring])],
        vec![load],
        Vec::new(),
        coulomb(0.0),
    );
    case.interfaces.clear();
    case
}

/// Where a motion from rest is after a time.
fn place(
    case: &Assembly,
    scheme: ContactScheme,
    step: f64,
    end: f64,
    course: &Course,
    driven: &[Excitation],
) -> f64 {
    let mut march = NonsmoothMarch::new(case, &[], settings(scheme, step)).unwrap();
    march.follow(course.clone(), driven).unwrap();
    march.start(&[0.0], &[0.0]);
    (0..(end / step).round() as u64).for_each(|_| march.advance().unwrap());
    march.state()[0][0]
}

/// Each halving of the step leaves a quarter of what is off.
fn is_of_second_order(off: [f64; 3], what: &str) {
    for pair in off.windows(2) {
        assert!((3.5..4.5).contains(&(pair[0] / pair[1])), "{what}: {off:?}");
    }
}

/// A mass on a spring on a base that shakes with a sin(Ω t + φ), seen from the base, whatever the phase with which it begins.
#[test]
fn a_mass_on_a_shaking_base_moves_as_its_closed_form() {
    let (mass, spring, shaking, omega): (f64, f64, f64, f64) = (2.0, 800.0, 3.0, 13.0);
    let (natural, end) = ((spring / mass).sqrt(), 1.7);
    let case = oscillator(mass, 0.0, spring, 0.0);
    for scheme in SCHEMES {
        for phase in [0.0, 0.5 * PI, 1.1] {
            // ẍ + ω² x = −a sin(Ω t + φ) from rest
            let size = -shaking / (natural * natural - omega * omega);
            let exact = size
                * ((omega * end + phase).sin()
                    - phase.sin() * (natural * end).cos()
                    - phase.cos() * omega / natural * (natural * end).sin());
            let base = Excitation { signal: sine(shaking, omega, phase), forces: vec![-mass] };
            let off = [2e-3, 1e-3, 5e-4].map(|step| {
                (place(&case, scheme, step, end, &Course::default(), std::slice::from_ref(&base)) - exact)
                    .abs()
            });
            assert!(off[2] < 1e-3 * size.abs(), "{scheme:?} {phase}: {off:?}");
            is_of_second_order(off, &format!("{scheme:?} {phase}"));
        }
    }
}

/// The same with a damper, when its own motion is over: amplitude a/√((ω² − Ω²)² + (d Ω)²), behind by the angle of the same.
#[test]
fn a_damped_mass_swings_with_its_amplitude_and_phase() {
    let (mass, damping, spring, shaking, omega): (f64, f64, f64, f64, f64) = (2.0, 8.0, 800.0, 3.0, 19.0);
    let case = oscillator(mass, damping, spring, 0.0);
    let (detuned, rate) = (spring / mass - omega * omega, damping / mass * omega);
    let (amplitude, behind) = (shaking / detuned.hypot(rate), rate.atan2(detuned));
    let base = Excitation { signal: sine(shaking, omega, 0.0), forces: vec![-mass] };
    for (scheme, allowed) in [(IMPLICIT, 5e-5), (ContactScheme::ForwardIncrement, 3e-3)] {
        for end in [12.0, 12.1, 12.2] {
            let exact = -amplitude * (omega * end - behind).sin();
            let found = place(&case, scheme, 2e-4, end, &Course::default(), std::slice::from_ref(&base));
            assert!((found - exact).abs() < allowed * amplitude, "{scheme:?}: {found} {exact}");
        }
    }
}

/// A load that rises with half a cosine, on a mass at rest without it.
#[test]
fn a_load_that_rises_moves_a_mass_as_its_closed_form() {
    let (mass, spring, load, rise, end): (f64, f64, f64, f64, f64) = (0.5, 200.0, 7.0, 0.8, 0.6);
    let (natural, turning) = ((spring / mass).sqrt(), PI / rise);
    let free = (natural * end).cos();
    let exact = 0.5 * load / spring * (1.0 - free)
        - 0.5 * load / mass * ((turning * end).cos() - free) / (natural * natural - turning * turning);
    let case = oscillator(mass, 0.0, spring, load);
    let course = Course { load: TimeFactor::Rise(rise), ..Course::default() };
    for scheme in SCHEMES {
        let off =
            [2e-3, 1e-3, 5e-4].map(|step| (place(&case, scheme, step, end, &course, &[]) - exact).abs());
        assert!(off[2] < 1e-4 * exact.abs(), "{scheme:?}: {off:?} {exact}");
        is_of_second_order(off, &format!("{scheme:?}"));
    }
}

/// A linear sweep passes a soft spring's mass as if it were free: the second integral of a sin(α t²/2) starts as α t⁴/24.
#[test]
fn a_sweep_starts_as_its_phase_says() {
    let case = oscillator(1.0, 0.0, 1e-9, 0.0);
    let (rate, duration, end) = (4.0, 10.0, 0.3);
    let sweep =
        FrequencySweep { amplitude: 2.0, from: 0.0, to: rate * duration, duration, is_logarithmic: false };
    let force = Excitation { signal: DrivingSignal::Sweep(sweep), forces: vec![1.0] };
    let exact = 2.0 * rate * f64::powi(end, 4) / 24.0;
    for scheme in SCHEMES {
        let found = place(&case, scheme, 1e-4, end, &Course::default(), std::slice::from_ref(&force));
        assert!((found / exact - 1.0).abs() < 2e-3, "{scheme:?}: {found} {exact}");
    }
}

/// A belt that stops evenly within T: a mass that friction can hold stops with it and never slides; one that it cannot slides on with −μ g and stops when it
/// has gone V²/(2 μ g), and what becomes heat is μ m g times how far it slid beside the belt.
#[test]
fn a_mass_on_a_belt_that_stops() {
    let (mass, weight, speed, stop): (f64, f64, f64, f64) = (1.0, 10.0, 0.5, 0.2);
    let course = Course { speed: TimeFactor::Table(table(&[0.0, stop], &[1.0, 0.0])), ..Course::default() };
    for scheme in SCHEMES {
        for friction in [0.4, 0.1] {
            let case = mass_on_plane(mass, 0.0, [0.0, -weight], friction, speed);
            let step = 1e-4;
            let mut march = NonsmoothMarch::new(&case, &[], settings(scheme, step)).unwrap();
            march.set_force_scale(weight);
            march.follow(course.clone(), &[]).unwrap();
            march.start(&[0.0; 2], &[speed, 0.0]);
            let mut slid = 0;
            for _ in 0..8000 {
                march.advance().unwrap();
                slid += u32::from(march.motion(0) == PointMotion::Slip);
            }
            let holds = friction * weight / mass > speed / stop;
            let gone =
                if holds { 0.5 * speed * stop } else { 0.5 * speed * speed / (friction * weight / mass) };
            let [place, velocity] = march.state();
            assert!(
                (place[0] - gone).abs() < 2.0 * step * speed,
                "{scheme:?} {friction}: {} {gone}",
                place[0]
            );
            assert!(velocity[0].abs() < 1e-12 && march.motion(0) == PointMotion::Stick);
            let heat = friction * weight * (gone - 0.5 * speed * stop);
            assert!(
                (march.works().heat - heat).abs() < 1e-3 * weight * speed * stop,
                "{scheme:?}: {:?} {heat}",
                march.works()
            );
            let sliding = if holds { 0.0 } else { speed / (friction * weight / mass) };
            assert!((f64::from(slid) * step - sliding).abs() < 3.0 * step, "{scheme:?}: {slid}");
        }
    }
}

/// A block on an incline that friction holds, and a force along it that shakes it loose once in a period: it creeps down by what its closed form says.
#[test]
fn a_block_on_an_incline_creeps_when_it_is_shaken() {
    let (mass, gravity, angle, friction): (f64, f64, f64, f64) = (2.0, 9.81, 0.2, 0.35);
    let (down, normal) = (mass * gravity * angle.sin(), mass * gravity * angle.cos());
    let (held, force, omega) = (friction * normal, 5.0, 40.0);
    // too little to push it up, enough to let it slide down
    assert!(down + force > held && force - down < held);
    let leaves = ((held - down) / force).asin() / omega;
    let from = |time: f64| time - leaves;
    let velocity = |time: f64| {
        ((down - held) * from(time) + force / omega * ((omega * leaves).cos() - (omega * time).cos())) / mass
    };
    let (mut low, mut high) = ((PI - omega * leaves) / omega, leaves + 2.0 * PI / omega);
    for _ in 0..80 {
        let middle = 0.5 * (low + high);
        if velocity(middle) > 0.0 { low = middle } else { high = middle }
    }
    let slides = from(low);
    let swept = (omega * leaves).cos() * slides - ((omega * low).sin() - (omega * leaves).sin()) / omega;
    let crept = (0.5 * (down - held) * slides * slides + force / omega * swept) / mass;
    let case = mass_on_plane(mass, 0.0, [down, -normal], friction, REST);
    let shaken = Excitation { signal: sine(force, omega, 0.0), forces: vec![1.0, 0.0] };
    // friction that turns smoothly never holds quite still
    for (scheme, allowed) in
        [(IMPLICIT, 1e-3), (ContactScheme::ForwardIncrement, 1e-3), (ContactScheme::Smoothed, 0.1)]
    {
        let step = 2.0 * PI / omega / 8192.0;
        let mut march = NonsmoothMarch::new(&case, &[], settings(scheme, step)).unwrap();
        march.set_force_scale(normal);
        march.follow(Course::default(), std::slice::from_ref(&shaken)).unwrap();
        march.start(&[0.0; 2], &[0.0; 2]);
        (0..3 * 8192).for_each(|_| march.advance().unwrap());
        let found = march.state()[0][0] / 3.0;
        assert!((found / crept - 1.0).abs() < allowed, "{scheme:?}: {found} {crept}");
    }
}

/// Where a temperature takes half of the friction, half of the force drags.
#[test]
fn heat_that_halves_friction_halves_the_force() {
    let temperature = table(&[0.0, 1e-2, 2e-2], &[20.0, 220.0, 220.0]);
    let friction =
        TimeFactor::over("a temperature", &temperature, [&[0.0, 120.0, 220.0], &[1.0, 1.0, 0.5]]).unwrap();
    let course = Course { friction: vec![friction], ..Course::default() };
    for scheme in ALL {
        let mut case = mass_on_plane(1.0, 100.0, [0.0, -10.0], 0.4, 5.0);
        case.damping = diagonal(&[0.0, 200.0]).into();
        let mut march = NonsmoothMarch::new(&case, &[], settings(scheme, 1e-5)).unwrap();
        march.set_force_scale(10.0);
        march.follow(course.clone(), &[]).unwrap();
        march.start(&[0.0; 2], &[0.0; 2]);
        let mut ratio = |steps: usize| {
            (0..steps).for_each(|_| march.advance().unwrap());
            let [normal, friction, _] = march.force(0);
            friction / normal
        };
        let found = [ratio(400), ratio(1500)];
        assert!((found[0] - 0.4).abs() < 1e-9 && (found[1] - 0.2).abs() < 1e-9, "{scheme:?}: {found:?}");
    }
}

/// A block that is thrown on a plane whose friction is a table of the speed: v̇ = −g (μ₀ + c v) on each of its pieces.
#[test]
fn friction_by_a_table_stops_a_block_as_its_closed_form() {
    let (gravity, thrown): (f64, f64) = (10.0, 1.5);
    let law = Friction::table(vec![0.0, 1.0, 2.0], vec![0.2, 0.4, 0.3], TableInterpolation::Linear).unwrap();
    // the time from one speed to a lower one of one piece
    let time = |from: f64, to: f64, at_rest: f64, slope: f64| {
        ((at_rest + slope * from) / (at_rest + slope * to)).ln() / (gravity * slope)
    };
    let all = time(thrown, 1.0, 0.5, -0.1) + time(1.0, 0.0, 0.2, 0.2);
    let mut case = mass_on_plane(1.0, 0.0, [0.0, -gravity], 0.0, REST);
    case.interfaces[0].law = InterfaceLaw::Rigid(law);
    for (scheme, allowed) in
        [(IMPLICIT, 2e-4), (ContactScheme::ForwardIncrement, 2e-4), (ContactScheme::Smoothed, 1e-2)]
    {
        let step = 1e-4;
        let mut march = NonsmoothMarch::new(&case, &[], settings(scheme, step)).unwrap();
        march.set_force_scale(gravity);
        march.start(&[0.0; 2], &[thrown, 0.0]);
        while march.motion(0) != PointMotion::Stick && march.time() < 2.0 {
            march.advance().unwrap();
        }
        assert!(
            (march.time() - all).abs() < allowed * all + 2.0 * step,
            "{scheme:?}: {} {all}",
            march.time()
        );
    }
}

/// What no march follows.
#[test]
fn courses_and_signals_that_are_none_are_refused() {
    let case = oscillator(1.0, 0.0, 100.0, 0.0);
    let mut march = NonsmoothMarch::new(&case, &[], settings(IMPLICIT, 1e-3)).unwrap();
    let mut refused = |course: Course, signal: DrivingSignal, forces: Vec<f64>| {
        march.follow(course, &[Excitation { signal, forces }]).unwrap_err().to_string()
    };
    let still = || sine(0.0, 1.0, 0.0);
    let negative = Course { friction: vec![TimeFactor::Constant(-1.0)], ..Course::default() };
    assert!(refused(negative, still(), vec![1.0]).contains("a factor of friction is -1"));
    assert!(
        refused(Course::default(), sine(1.0, 4000.0, 0.0), vec![1.0])
            .contains("is too fast for steps of 0.001 s")
    );
    let two = refused(Course::default(), still(), vec![1.0; 2]);
    assert_eq!(two, "a signal acts on 2 freedoms, the assembly has 1");
}
