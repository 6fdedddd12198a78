//! Random assemblies that march: complementarity after every step, no energy from contact, no number that is none, no end that does not come.

use super::definite;
use crate::common::{IMPLICIT, assembly, coulomb, dense, diagonal, point_on_plane, settings};
use judder_assembly::assembly::Assembly;
use judder_assembly::friction::{FallingFriction, Friction};
use judder_assembly::interface::InterfaceLaw;
use judder_assembly::pressure::Pressure;
use judder_nonsmooth::course::{Course, TimeFactor, TimeTable};
use judder_nonsmooth::excitation::{DrivingSignal, Excitation};
use judder_nonsmooth::march::{MarchCheckpoint, NonsmoothMarch};
use judder_nonsmooth::scheme::ContactScheme;
use judder_nonsmooth::statistics::Statistics;
use proptest::prelude::*;
use proptest::test_runner::{RngAlgorithm, TestCaseError, TestRng, TestRunner};

/// What is drawn of an assembly.
#[derive(Debug, Clone)]
struct Drawn {
    numbers: Vec<f64>,
    space: bool,
    scheme: usize,
    law: usize,
    friction: f64,
    speed: f64,
    load: f64,
    gap: f64,
    /// Points on the freedoms of the first ones.
    doubled: usize,
}

fn drawn() -> impl Strategy<Value = Drawn> {
    let shape = (any::<bool>(), 0_usize..2, 0_usize..3, 0_usize..3);
    let size = (0.0..1.5_f64, -3.0..1.0_f64, -1.0..3.0_f64, -6.0..-3.0_f64);
    (prop::collection::vec(-1.0..1.0_f64, 160), shape, size).prop_map(
        |(numbers, (space, scheme, law, doubled), (friction, speed, load, gap))| Drawn {
            numbers,
            space,
            scheme,
            law,
            friction,
            speed: 10_f64.powf(speed),
            load: 10_f64.powf(load),
            gap: 10_f64.powf(gap),
            doubled,
        },
    )
}

const NODES: usize = 5;

impl Drawn {
    fn assembly(&self) -> Assembly {
        let each = if self.space { 3 } else { 2 };
        let size = NODES * each;
        let scaled = |factor: f64| {
            let rows = definite(&self.numbers, size, 0.2);
            rows.into_iter()
                .map(|row| row.into_iter().map(|own| factor * own).collect())
                .collect::<Vec<Vec<f64>>>()
        };
        let law = match self.law {
            0 => coulomb(self.friction),
            1 => InterfaceLaw::Rigid(Friction::Falling(FallingFriction::exponential(
                [self.friction, 0.5 * self.friction],
                0.3,
            ))),
            _ => InterfaceLaw::Compliant(Pressure::PointStiffness(1e5), Friction::Constant(self.friction)),
        };
        let mut load = vec![0.0; size];
        for node in 0..NODES {
            load[node * each] = 0.3 * self.load * self.numbers[node + 20];
            load[node * each + 1] = -self.load * (0.6 + 0.5 * self.numbers[node]);
        }
        let point = |node: usize, gap: f64| {
            let first = node * each;
            point_on_plane(&(first..first + each).collect::<Vec<_>>(), self.speed, gap)
        };
        let gap = |node: usize| self.gap * self.numbers[node + 10].max(0.0);
        let once = (0..NODES - 1).map(|node| point(node, gap(node)));
        let again = (0..self.doubled).map(|node| point(node, gap(node)));
        let mass: Vec<f64> = (0..size).map(|k| 1.0 + 0.9 * self.numbers[k + 40]).collect();
        assembly(
            [diagonal(&mass), dense(&scaled(0.2)), dense(&scaled(1e4))],
            load,
            once.chain(again).collect(),
            law,
        )
    }

    fn march(&self, steps: usize) -> Result<(), TestCaseError> {
        let case = self.assembly();
        let scheme = [IMPLICIT, ContactScheme::ForwardIncrement][self.scheme];
        let mut march = NonsmoothMarch::new(&case, &[], settings(scheme, 1e-4)).unwrap();
        // impulses that stop the bodies within a step leave rounding, beside which a load may be as good as none
        march.set_force_scale(self.load.max(1e-3 * self.speed / 1e-4));
        let first = march.energy();
        let (mut exchanged, mut unsolved) = (0.0_f64, 0);
        for step in 0..steps {
            march.advance().unwrap();
            // a step that is told as unsolved has promised nothing
            let is_told = march.record().unsolved > unsolved;
            unsolved = march.record().unsolved;
            if is_told {
                continue;
            }
            for point in 0..march.contact().points.len() {
                let [normal, along, across] = march.force(point);
                prop_assert!(normal >= -1e-9 * self.load, "{step}: {normal}");
                let friction = along.hypot(across);
                prop_assert!(
                    friction <= self.friction * normal + 1e-9 * (self.load + normal),
                    "{step}: {friction} of {normal}"
                );
                let [opening, slip, drift] = march.velocity(point);
                let power = along * (slip - self.speed) + across * drift;
                prop_assert!(
                    power <= 1e-9 * (self.load + normal) * (self.speed + slip.abs()),
                    "{step}: {power}"
                );
                if self.law < 2 && self.scheme == 0 && normal > 1e-9 * self.load {
                    prop_assert!(
                        opening.abs() <= 1e-9 * (self.speed + slip.abs() + 1.0),
                        "{step}: {opening}"
                    );
                }
            }
            let works = march.works();
            let all = [works.friction, works.normal, works.heat, works.damping];
            exchanged = all.iter().fold(exchanged, |most, own| most.max(own.abs()));
        }
        prop_assert!(unsolved <= steps as u64 / 1000, "{:?}", march.record());
        let (last, works) = (march.energy(), march.works());
        let gained = last.kinetic + last.potential - first.kinetic - first.potential;
        let told = works.friction + works.normal + works.damping + works.circulation;
        prop_assert!((gained - told).abs() <= 1e-8 * (exchanged + gained.abs()), "{gained} {told}");
        prop_assert!(works.damping <= 0.0 && works.heat >= -TURNING * exchanged, "{works:?}");
        if self.law < 2 && self.scheme == 0 {
            prop_assert!(works.normal <= 1e-9 * exchanged, "{works:?}");
        }
        Ok(())
    }
}

impl Drawn {
    /// A march that is cut anywhere and goes on from what was written of it, in one that was elsewhere, is the one that was not cut.
    fn goes_on(&self, steps: usize) -> Result<(), TestCaseError> {
        let case = self.assembly();
        let scheme = [IMPLICIT, ContactScheme::ForwardIncrement, ContactScheme::Smoothed]
            [(self.law + self.scheme) % 3];
        let new = || {
            let mut march = NonsmoothMarch::new(&case, &[], settings(scheme, 1e-4)).unwrap();
            march.set_force_scale(self.load.max(1e-3 * self.speed / 1e-4));
            if self.doubled > 0 {
                let speed = TimeFactor::Table(TimeTable { times: vec![0.0, 0.01], values: vec![1.0, 0.3] });
                let forces = vec![0.1 * self.load; case.size()];
                let signal = DrivingSignal::Sine { amplitude: 1.0, angular_frequency: 700.0, phase: 0.3 };
                let course = Course { speed, load: TimeFactor::Rise(0.005), ..Course::default() };
                march.follow(course, &[Excitation { signal, forces }]).unwrap();
            }
            march
        };
        let (mut whole, mut cut) = (new(), new());
        let mut statistics = Statistics::new(whole.contact().points.len());
        let every = 1 + (self.numbers[0].abs() * 30.0) as usize;
        for step in 1..=steps {
            whole.advance().unwrap();
            statistics.take(&whole);
            cut.advance().unwrap();
            if step % every == 0 {
                let text = serde_json::to_string(&(cut.checkpoint(), &statistics)).unwrap();
                let (checkpoint, read): (MarchCheckpoint, Statistics) = serde_json::from_str(&text).unwrap();
                prop_assert_eq!(&read, &statistics);
                cut = new();
                (0..step % 7).for_each(|_| cut.advance().unwrap());
                cut.resume(&checkpoint).unwrap();
            }
            prop_assert!(cut.checkpoint() == whole.checkpoint(), "{step}");
        }
        let [a, b] = [whole, cut].map(|march| serde_json::to_string(&march.checkpoint()).unwrap());
        prop_assert_eq!(a, b);
        Ok(())
    }
}

/// Heat is taken at the mean of the velocities before and after a step, and a point that turns within one drags against the later of them.
const TURNING: f64 = 1e-3;

fn many(cases: u32, held_to: impl Fn(Drawn) -> Result<(), TestCaseError>) {
    let config = ProptestConfig { cases, failure_persistence: None, ..ProptestConfig::default() };
    // the same assemblies every time
    let mut runner = TestRunner::new_with_rng(config, TestRng::deterministic_rng(RngAlgorithm::ChaCha));
    runner.run(&drawn(), held_to).unwrap();
}

#[test]
fn random_assemblies_march() {
    many(30, |own| own.march(400));
}

#[test]
fn a_march_goes_on_from_its_checkpoint_to_the_bit() {
    many(30, |own| own.goes_on(200));
}

/// The same at length.
#[test]
#[ignore = "takes minutes"]
fn a_thousand_random_assemblies_march() {
    many(1000, |own| own.march(10_000));
}
