//! The periodic motions of a mode over their amplitude.
//!
//! A mode that grows with σ moves periodically where σ is taken off all motions alike: M ẍ + (C + 2 σ M) ẋ + K x = f + Pᵀ λ (M. Krack, *Nonlinear modal analysis of
//! nonconservative systems*, Comput. Struct. 154, 2015). As its amplitude grows, points stick, slide the other way, lift off, and σ
//! changes; where it passes through zero the motion needs nothing: a limit cycle. Where it falls with the amplitude motions
//! nearby are drawn to it, as far as they have this shape; where it rises they leave it.

mod mode;

use crate::CyclesError;
use crate::balance::{CycleRate, HarmonicBalance};
use crate::crossing::{between, sign_change};
use crate::extended::{ExtendedBalance, Free};
use crate::path::{ClosingEquation, GoOn, Newton, PathEquations, PathPoint, PathRule, ended, follow};
use faer::c64;
use judder_assembly::steady::SteadySliding;

/// How the motions of a mode are followed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BackboneSettings {
    /// How solutions are sought.
    pub rule: PathRule,
    /// The most of them.
    pub points: usize,
    /// The amplitude at which they end, of that at which contact first changes its state.
    pub largest: f64,
    /// How many limit cycles are enough.
    pub cycles: usize,
}

impl Default for BackboneSettings {
    fn default() -> Self {
        Self { rule: PathRule::default(), points: 400, largest: 1e3, cycles: 1 }
    }
}

/// A periodic motion.
#[derive(Debug, Clone, PartialEq)]
pub struct PeriodicMotion {
    /// Unknowns of the balance.
    pub unknown: Vec<f64>,
    /// ω in rad/s, and σ in 1/s.
    pub turning: CycleRate,
    /// The root of Σ |ε y₁|² over all components, y₁ the first harmonic of their motions, in N.
    pub amplitude: f64,
    /// What is left of the equations, of the force scale.
    pub residual: f64,
}

/// Why the motions of a mode are followed no further.
#[derive(Debug, Clone, PartialEq)]
pub enum BackboneEnd {
    /// As many limit cycles were found as were asked for.
    Found,
    /// The amplitude is as large as was asked for.
    Largest,
    /// There are as many motions as were asked for.
    Points,
    /// They came back to small ones.
    Shrunk,
    /// No next motion was found.
    Lost(CyclesError),
}

/// The periodic motions of a mode.
#[derive(Debug, Clone, PartialEq)]
pub struct Backbone {
    /// In the order in which they were found, from small ones on.
    pub motions: Vec<PeriodicMotion>,
    /// Those with σ = 0, and whether σ falls there as the amplitude grows.
    pub cycles: Vec<(PeriodicMotion, bool)>,
    /// The amplitude of the mode at which the contact first changes its state.
    pub first_change: f64,
    /// Why there are no more.
    pub end: BackboneEnd,
}

/// The periodic motions of the mode with this eigenvalue about steady sliding.
///
/// # Errors
/// What the smallest motion says; what is lost later ends the backbone. [`CyclesError::Stopped`].
pub fn backbone(
    balance: &HarmonicBalance<'_>,
    steady: &SteadySliding,
    eigenvalue: c64,
    settings: &BackboneSettings,
    go_on: &GoOn<'_>,
) -> Result<Backbone, CyclesError> {
    let mut newton = Newton::new(settings.rule, go_on).without_branches();
    let begins = |share: f64, newton: &mut Newton<'_>| begins(balance, steady, eigenvalue, share, newton);
    let (mut equations, mut first) = begins(SHARES[0], &mut newton)?;
    let mut share = SHARES[0];
    for smaller in &SHARES[1..] {
        // where σ has changed its sign already there is a cycle below
        if first.at[first.at.len() - 1] * eigenvalue.re >= 0.0 {
            break;
        }
        match begins(*smaller, &mut newton) {
            Ok(found) => ((equations, first), share) = (found, *smaller),
            Err(CyclesError::Stopped) => return Err(CyclesError::Stopped),
            Err(_) => break,
        }
    }
    let smallest = equations.motion(&first)?;
    let (least, first_change) = (0.5 * smallest.amplitude, smallest.amplitude / share);
    let (mut motions, mut cycles) = (vec![smallest], Vec::new());
    let growth = first.at.len() - 1;
    let end =
        follow(&mut newton, &mut equations, first, settings.points, |equations, newton, [before, next]| {
            let motion = equations.motion(next)?;
            let amplitude = motion.amplitude;
            if before.at[growth] * next.at[growth] <= 0.0 && before.at[growth] != 0.0 {
                let cycle = located(equations, newton, [before, next])?;
                motions.push(cycle.0.clone());
                cycles.push(cycle);
            }
            motions.push(motion);
            Ok(if cycles.len() >= settings.cycles {
                Some(BackboneEnd::Found)
            } else if amplitude > settings.largest * first_change {
                Some(BackboneEnd::Largest)
            } else if amplitude < least {
                Some(BackboneEnd::Shrunk)
            } else {
                None
            })
        });
    let end = ended(end, BackboneEnd::Points, BackboneEnd::Lost)?;
    Ok(Backbone { motions, cycles, first_change, end })
}

/// The smallest amplitude, of that at which the contact first changes its state, and those from which on motions are followed where a cycle lies below it.
const SHARES: [f64; 3] = [0.5, 0.1, 0.02];

/// The equations of the motions of a mode, and the motion at a share of the amplitude at which the contact first changes its state.
fn begins<'b, 'a>(
    balance: &'b HarmonicBalance<'a>,
    steady: &SteadySliding,
    eigenvalue: c64,
    share: f64,
    newton: &mut Newton<'_>,
) -> Result<(ExtendedBalance<&'b HarmonicBalance<'a>>, PathPoint), CyclesError> {
    let start = mode::smallest(balance, steady, eigenvalue, share)?;
    let mut equations =
        ExtendedBalance::new(balance, balance, eigenvalue.im, Free::Growth, Some(start.reference));
    equations.weigh_swing(&start.direction);
    let closing = ClosingEquation::across(&start.direction, equations.weights(), &start.at);
    let first = newton.corrected(&mut equations, &start.at, &closing, &start.direction)?;
    equations.accept(&first.at)?;
    Ok((equations, first))
}

/// A limit cycle near another that is known with as many harmonics or fewer.
///
/// # Errors
/// [`CyclesError::NotConverged`], [`CyclesError::Singular`] and [`CyclesError::Stopped`].
pub fn refined(
    balance: &HarmonicBalance<'_>,
    near: &PeriodicMotion,
    rule: &PathRule,
    go_on: &GoOn<'_>,
) -> Result<PeriodicMotion, CyclesError> {
    let mut at = balance.with_its_harmonics(&near.unknown);
    at.extend([1.0, 0.0]);
    let reference = Some(vec![1.0; 2 * balance.components()]);
    let mut equations =
        ExtendedBalance::new(balance, balance, near.turning.frequency, Free::Growth, reference);
    equations.accept(&at)?;
    let closing = ClosingEquation::fixed(at.len() - 1, at.len(), 0.0);
    let found = Newton::new(*rule, go_on).corrected(&mut equations, &at, &closing, &closing.row)?;
    let cycle = equations.motion(&found)?;
    if cycle.amplitude < SHRUNK * near.amplitude { Err(CyclesError::Shrunk) } else { Ok(cycle) }
}

/// A motion so much smaller than those near it is steady sliding, or on its way there.
const SHRUNK: f64 = 0.3;

/// The cycle between two motions, and whether σ falls from small to large ones; where it is not found there the path between them is followed once more in short steps.
fn located(
    equations: &mut ExtendedBalance<&HarmonicBalance<'_>>,
    newton: &mut Newton<'_>,
    [before, after]: [&PathPoint; 2],
) -> Result<(PeriodicMotion, bool), CyclesError> {
    match located_between(equations, newton, [before, after]) {
        Err(CyclesError::NotConverged { .. } | CyclesError::Singular) => {
            let growth = before.at.len() - 1;
            let [low, high] = sign_change(equations, newton, [before, after], growth)?;
            let found = located_between(equations, newton, [&low, &high]);
            equations.accept(&after.at)?;
            found
        }
        found => found,
    }
}

/// The cycle between two motions, and whether σ falls from small to large ones.
///
/// Steady sliding is a solution with σ = 0 too: σ is free until it is small, on planes across the path.
fn located_between(
    equations: &mut ExtendedBalance<&HarmonicBalance<'_>>,
    newton: &mut Newton<'_>,
    [before, after]: [&PathPoint; 2],
) -> Result<(PeriodicMotion, bool), CyclesError> {
    /// Steps, and the σ at which it is as good as zero.
    const STEPS: usize = 12;
    const SMALL: f64 = 1e-7;
    let last = before.at.len() - 1;
    let small = equations.motion(before)?.amplitude;
    let large = equations.motion(after)?.amplitude;
    let (mut low, mut high) = (before.clone(), after.clone());
    for _ in 0..STEPS {
        let nearest = if low.at[last].abs() < high.at[last].abs() { &low } else { &high };
        if nearest.at[last].abs() < SMALL {
            break;
        }
        let share = (low.at[last] / (low.at[last] - high.at[last])).clamp(0.1, 0.9);
        let guess = between([&low, &high], share, equations.weights());
        let chord: Vec<f64> = low.at.iter().zip(&high.at).map(|(a, b)| b - a).collect();
        let closing = ClosingEquation::across(&chord, equations.weights(), &guess);
        let next = newton.corrected(equations, &guess, &closing, &before.tangent)?;
        if next.at[last] * low.at[last] > 0.0 { low = next } else { high = next }
    }
    let nearest = if low.at[last].abs() < high.at[last].abs() { low } else { high };
    let closing = ClosingEquation::fixed(last, nearest.at.len(), 0.0);
    let found = newton.corrected(equations, &nearest.at, &closing, &nearest.tangent)?;
    let cycle = equations.motion(&found)?;
    if cycle.amplitude < SHRUNK * small.min(large) {
        return Err(CyclesError::Shrunk);
    }
    Ok((cycle, (large > small) == (after.at[last] < before.at[last])))
}
