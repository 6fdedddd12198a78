//! The stability decision for many points at once.
//!
//! The same functions that decide one point run here in loops over a block of points, which the compiler turns into
//! vector code; the widest instructions of the machine are chosen at run time. No operation differs between the widths,
//! so neither do the results. Points that do not settle fall back to the bracketed scalar solution.

use crate::characteristic::Characteristic;
use crate::conservative::discriminant_share;
use crate::equilibrium::{ForceBalance, ln_indentation};
use crate::groups::Coefficients;
use crate::linear_system::ReducedSystem;
use crate::linearisation::Linearisation;
use crate::mechanism::StabilityClass;
use crate::{Contact, FrictionLoad};
use judder_contact::{ContactLaw, Law, LawPoint};
use multiversion::multiversion;

/// Points in a block: enough for every vector width, few enough to stay in the nearest cache.
pub const LANES: usize = 32;

/// One number a point.
type Lanes = [f64; LANES];

/// [`Coefficients`] of every point of a block, one array a coefficient.
#[derive(Debug, Clone)]
struct CoefficientLanes {
    velocity: Lanes,
    normal_load: Lanes,
    shear_strength: Lanes,
    stiffness: Lanes,
    retardation_time: Lanes,
    damping_x: Lanes,
    damping_y: Lanes,
    k11: Lanes,
    k12: Lanes,
    k22: Lanes,
    spring: Lanes,
    coupling_ratio: Lanes,
}

impl CoefficientLanes {
    const ZERO: Self = Self {
        velocity: [0.0; LANES],
        normal_load: [0.0; LANES],
        shear_strength: [0.0; LANES],
        stiffness: [0.0; LANES],
        retardation_time: [0.0; LANES],
        damping_x: [0.0; LANES],
        damping_y: [0.0; LANES],
        k11: [0.0; LANES],
        k12: [0.0; LANES],
        k22: [0.0; LANES],
        spring: [0.0; LANES],
        coupling_ratio: [0.0; LANES],
    };

    #[inline(always)]
    fn set(&mut self, lane: usize, c: &Coefficients) {
        self.velocity[lane] = c.velocity;
        self.normal_load[lane] = c.normal_load;
        self.shear_strength[lane] = c.shear_strength;
        self.stiffness[lane] = c.stiffness;
        self.retardation_time[lane] = c.retardation_time;
        self.damping_x[lane] = c.damping_x;
        self.damping_y[lane] = c.damping_y;
        self.k11[lane] = c.k11;
        self.k12[lane] = c.k12;
        self.k22[lane] = c.k22;
        self.spring[lane] = c.spring;
        self.coupling_ratio[lane] = c.coupling_ratio;
    }

    #[inline(always)]
    fn get(&self, lane: usize) -> Coefficients {
        Coefficients {
            velocity: self.velocity[lane],
            normal_load: self.normal_load[lane],
            shear_strength: self.shear_strength[lane],
            stiffness: self.stiffness[lane],
            retardation_time: self.retardation_time[lane],
            damping_x: self.damping_x[lane],
            damping_y: self.damping_y[lane],
            k11: self.k11[lane],
            k12: self.k12[lane],
            k22: self.k22[lane],
            spring: self.spring[lane],
            coupling_ratio: self.coupling_ratio[lane],
        }
    }
}

/// A block of points: coefficients and guesses go in, indentations and classes come out, margins where they are asked for.
#[derive(Debug, Clone)]
pub struct PointBlock {
    coefficients: CoefficientLanes,
    ln_velocity: Lanes,
    /// ln ŷ_e of each point: a guess before the decision (NaN for none), the solution after it.
    pub ln_indentation: Lanes,
    step: Lanes,
    class: Lanes,
    imbalance: Lanes,
    /// The stability margin ([`Characteristic::margin`]) of each point, after [`PointBlock::measure_margins`].
    pub margin: Lanes,
    /// The share of the discriminant ([`discriminant_share`]) of each point, likewise; negative where the undamped modes have merged.
    pub conservative_margin: Lanes,
}

impl Default for PointBlock {
    fn default() -> Self {
        let none = [f64::NAN; LANES];
        Self {
            coefficients: CoefficientLanes::ZERO,
            ln_velocity: none,
            ln_indentation: none,
            step: none,
            class: none,
            imbalance: none,
            margin: none,
            conservative_margin: none,
        }
    }
}

/// Logarithms of the speeds, once a decision.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl", "x86_64+avx2", "aarch64+neon"))]
fn take_logarithms(block: &mut PointBlock) {
    for lane in 0..LANES {
        let at = LawPoint::new(block.coefficients.velocity[lane], 1.0);
        block.coefficients.velocity[lane] = at.velocity;
        block.ln_velocity[lane] = at.ln_velocity;
    }
}

/// One Newton step in ln ŷ of every point.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl", "x86_64+avx2", "aarch64+neon"))]
fn iterate<L: ContactLaw>(law: &L, load: FrictionLoad, block: &mut PointBlock) {
    for lane in 0..LANES {
        let c = block.coefficients.get(lane);
        let at = LawPoint::at_ln_indentation(c.velocity, block.ln_velocity[lane], block.ln_indentation[lane]);
        let response = law.evaluate(&at);
        let step = ForceBalance::new(load, &c, &at, &response).newton_step();
        block.step[lane] = step;
        block.ln_indentation[lane] += step;
    }
}

/// Class and force balance of every point, at the indentations that stand in the block.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl", "x86_64+avx2", "aarch64+neon"))]
fn classify<L: ContactLaw>(law: &L, load: FrictionLoad, block: &mut PointBlock) {
    for lane in 0..LANES {
        let (balance, system) = linearise(law, load, block, lane);
        block.imbalance[lane] = balance.residual;
        block.class[lane] = StabilityClass::code(&system);
    }
}

/// Margins of every point, at the indentations that stand in the block.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl", "x86_64+avx2", "aarch64+neon"))]
fn weigh<L: ContactLaw>(law: &L, load: FrictionLoad, block: &mut PointBlock) {
    for lane in 0..LANES {
        let (_, system) = linearise(law, load, block, lane);
        block.margin[lane] = Characteristic::new(&system).margin();
        block.conservative_margin[lane] = discriminant_share(&system.stiffness);
    }
}

/// The balance of forces of a lane, and the system about it.
#[inline(always)]
fn linearise<L: ContactLaw>(
    law: &L,
    load: FrictionLoad,
    block: &PointBlock,
    lane: usize,
) -> (ForceBalance, ReducedSystem) {
    let c = block.coefficients.get(lane);
    let at = LawPoint::at_ln_indentation(c.velocity, block.ln_velocity[lane], block.ln_indentation[lane]);
    let response = law.evaluate(&at);
    let linearisation = Linearisation::new(load, &c, &response);
    let system = ReducedSystem { damping: linearisation.damping(), stiffness: linearisation.stiffness() };
    (ForceBalance::new(load, &c, &at, &response), system)
}

impl PointBlock {
    /// Puts a point into a lane, with a guess of its ln ŷ_e (NaN for none).
    #[inline(always)]
    pub fn set(&mut self, lane: usize, coefficients: &Coefficients, ln_indentation: f64) {
        self.coefficients.set(lane, coefficients);
        self.ln_indentation[lane] = ln_indentation;
    }

    /// Decides the first `count` points.
    ///
    /// Lanes without a guess start from the lane before. Lanes with k12 < 0 (where equilibria must be counted), or whose iteration
    /// does not settle, are solved by [`crate::equilibrium`]; where that has no answer either, the class is [`StabilityClass::Unresolved`] and ln ŷ_e NaN.
    pub fn decide(&mut self, contact: &Contact, count: usize) {
        for lane in 0..count {
            if self.coefficients.k12[lane] < 0.0 {
                self.solve_alone(contact, lane);
            } else if self.ln_indentation[lane].is_nan() {
                match lane.checked_sub(1).map(|before| self.ln_indentation[before]) {
                    Some(before) if !before.is_nan() => self.ln_indentation[lane] = before,
                    _ => self.solve_alone(contact, lane),
                }
            }
        }
        for lane in count..LANES {
            let first = self.coefficients.get(0);
            self.set(lane, &first, self.ln_indentation[0]);
        }
        match &contact.law {
            Law::Fitted(law) => self.decide_with(law, contact, count),
            Law::Hertz(law) => self.decide_with(law, contact, count),
            Law::Collapsed(law) => self.decide_with(law.as_ref(), contact, count),
            Law::Tabulated(law) => self.decide_with(law.as_ref(), contact, count),
            Law::Sampled(law) => self.decide_with(law.as_ref(), contact, count),
        }
    }

    /// The margins of the decided points; NaN where there is no equilibrium.
    pub fn measure_margins(&mut self, contact: &Contact) {
        match &contact.law {
            Law::Fitted(law) => weigh(law, contact.friction_load, self),
            Law::Hertz(law) => weigh(law, contact.friction_load, self),
            Law::Collapsed(law) => weigh(law.as_ref(), contact.friction_load, self),
            Law::Tabulated(law) => weigh(law.as_ref(), contact.friction_load, self),
            Law::Sampled(law) => weigh(law.as_ref(), contact.friction_load, self),
        }
        for lane in 0..LANES {
            if self.ln_indentation[lane].is_nan() {
                (self.margin[lane], self.conservative_margin[lane]) = (f64::NAN, f64::NAN);
            }
        }
    }

    fn decide_with<L: ContactLaw>(&mut self, law: &L, contact: &Contact, count: usize) {
        /// Newton doubles the digits: after a step this small the error is below rounding.
        const SETTLED: f64 = 3e-8;
        const LIMIT: usize = 12;
        /// Force imbalance, over the load, that a settled iteration leaves; rounding leaves 1e-15.
        const BALANCED: f64 = 1e-12;
        let load = contact.friction_load;
        take_logarithms(self);
        for _ in 0..LIMIT {
            iterate(law, load, self);
            if !self.step[..count].iter().any(|step| step.abs() > SETTLED) {
                break;
            }
        }
        classify(law, load, self);
        let unsettled: Vec<usize> = (0..count)
            .filter(|lane| self.imbalance[*lane].abs() > BALANCED || self.imbalance[*lane].is_nan())
            .collect();
        if !unsettled.is_empty() {
            for lane in &unsettled {
                self.solve_alone(contact, *lane);
            }
            classify(law, load, self);
        }
    }

    fn solve_alone(&mut self, contact: &Contact, lane: usize) {
        self.ln_indentation[lane] = ln_indentation(contact, &self.coefficients.get(lane)).unwrap_or(f64::NAN);
    }

    /// The class of a decided point.
    #[inline(always)]
    #[must_use]
    pub fn class(&self, lane: usize) -> StabilityClass {
        if self.ln_indentation[lane].is_nan() {
            return StabilityClass::Unresolved;
        }
        StabilityClass::from_code(self.class[lane] as u8)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Groups;
    use crate::equilibrium::equilibrium;
    use judder_contact::FittedLaw;
    use proptest::prelude::*;

    fn paper(friction_load: FrictionLoad) -> Contact {
        Contact { law: Law::Fitted(FittedLaw::oscillator_paper()), friction_load }
    }

    proptest! {
        #[test]
        fn the_vector_path_is_the_scalar_path(
            logs in prop::collection::vec((-8.0..2.0_f64, -9.0..-1.0_f64, -4.0..0.0_f64), LANES),
            contact_force: bool,
            guess in -1.0..1.0_f64,
        ) {
            let contact = paper(if contact_force { FrictionLoad::ContactForce } else { FrictionLoad::NormalLoad });
            let points: Vec<Coefficients> = logs.iter().map(|(v, f, t)| Groups {
                velocity: 10_f64.powf(*v), normal_load: 10_f64.powf(*f), shear_strength: 10_f64.powf(*t), ..Groups::default()
            }.coefficients().unwrap()).collect();
            let mut block = PointBlock::default();
            for (lane, c) in points.iter().enumerate() {
                let exact = equilibrium(&contact, c).unwrap().ln_indentation;
                block.set(lane, c, exact + guess);
            }
            block.decide(&contact, LANES);
            block.measure_margins(&contact);
            for (lane, c) in points.iter().enumerate() {
                let e = equilibrium(&contact, c).unwrap();
                prop_assert!((block.ln_indentation[lane] - e.ln_indentation).abs() <= 1e-13);
                let l = Linearisation::new(contact.friction_load, c, &e.response);
                let system = ReducedSystem { damping: l.damping(), stiffness: l.stiffness() };
                let margin = Characteristic::new(&system).margin();
                prop_assert!((block.margin[lane] - margin).abs() <= 1e-11, "{} {}", block.margin[lane], margin);
                if StabilityClass::clearance(&system) > 1e-10 {
                    prop_assert_eq!(block.class(lane), StabilityClass::of(&system));
                }
            }
        }
    }

    #[test]
    fn a_point_without_an_answer_is_unresolved() {
        let mut block = PointBlock::default();
        let good = Groups::default().coefficients().unwrap();
        block.set(0, &good, f64::NAN);
        block.set(1, &Coefficients { normal_load: f64::NAN, ..good }, f64::NAN);
        block.decide(&paper(FrictionLoad::NormalLoad), 2);
        assert_ne!(block.class(0), StabilityClass::Unresolved);
        assert_eq!(block.class(1), StabilityClass::Unresolved);
    }
}
