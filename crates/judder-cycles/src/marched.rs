//! The periodic motion that a march comes to.
//!
//! In the last quarter of the march it is measured how far displacements and velocities of the contact points are from those at its beginning, as a root of
//! sums of squares over their swing: where the march comes back for the first time about as closely as it ever does, a period has passed.

use crate::CyclesError;
use crate::near::ForcesOverPeriod;
use crate::path::GoOn;
use faer::Mat;
use judder_assembly::assembly::Assembly;
use judder_assembly::steady::SteadySliding;
use judder_nonsmooth::gauss_seidel::ContactAccuracy;
use judder_nonsmooth::march::{NonsmoothMarch, NonsmoothSettings};
use judder_nonsmooth::scheme::ContactScheme;
use std::f64::consts::TAU;

/// How the march goes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MarchedSettings {
    /// h in s, of the implicit scheme.
    pub step: f64,
    /// How long it is, in s.
    pub duration: f64,
}

/// How close a periodic motion comes back, of its swing.
const RETURNS: f64 = 0.05;
/// What its kinetic energy may change between the halves of the last quarter.
const SETTLED: f64 = 0.05;
/// What is left of the largest kinetic energy where a motion has settled to steady sliding.
const GONE: f64 = 1e-8;
/// Steps between two questions whether to go on.
const PATIENCE: u64 = 256;
/// The fewest steps of the last quarter.
const FEWEST: u64 = 64;

/// The periodic motion that a march comes to from displacements and velocities of the freedoms.
///
/// # Errors
/// [`CyclesError::Settles`], [`CyclesError::StillChanges`], [`CyclesError::NotPeriodic`], [`CyclesError::Stopped`], and what the march says.
pub fn marched_period(
    assembly: &Assembly,
    steady: &SteadySliding,
    [displacement, velocity]: [&[f64]; 2],
    settings: &MarchedSettings,
    go_on: &GoOn<'_>,
) -> Result<ForcesOverPeriod, CyclesError> {
    let rows = NonsmoothMarch::new(assembly, &[], scheme(settings.step))?.contact().rows.clone();
    let mut march = NonsmoothMarch::new(assembly, &rows, scheme(settings.step))?;
    let forces: Vec<[f64; 2]> =
        steady.points.iter().map(|point| [point.normal_force, point.friction_force]).collect();
    march.set_force_scale(forces.iter().map(|own| own[0].abs()).fold(0.0, f64::max));
    march.start(displacement, velocity);
    march.guess(&forces);
    let steps = (settings.duration / settings.step).ceil() as u64;
    let watched = (steps / 4).max(FEWEST);
    let mut largest = march.energy().kinetic;
    for _ in 0..steps.saturating_sub(watched) {
        advance(&mut march, go_on)?;
        largest = largest.max(march.energy().kinetic);
    }
    let mut returns = Returns::new(&march, rows.len());
    let mut energies = Vec::new();
    for _ in 0..watched {
        advance(&mut march, go_on)?;
        returns.take(&march);
        energies.push(march.energy().kinetic);
    }
    let mean = |of: &[f64]| of.iter().sum::<f64>() / of.len() as f64;
    let changes = |halves: [&[f64]; 2]| mean(halves[1]) / mean(halves[0]) - 1.0;
    let (early, late) = energies.split_at(energies.len() / 2);
    if mean(&energies) <= GONE * largest {
        return Err(CyclesError::Settles);
    }
    let period = match returns.period() {
        Ok(period) => period,
        Err(missed) => {
            let change = changes([early, late]);
            return Err(match change.abs() > 10.0 * SETTLED {
                true => CyclesError::StillChanges { change },
                false => CyclesError::NotPeriodic { missed },
            });
        }
    };
    // whole periods, so that the energy does not change by how many there are
    let half = ((energies.len() as f64 / period / 2.0).floor() * period) as usize;
    let change = changes([&energies[..half], &energies[energies.len() - half..]]);
    if change.abs() > SETTLED {
        return Err(CyclesError::StillChanges { change });
    }
    once(&mut march, period, go_on)
}

fn scheme(step: f64) -> NonsmoothSettings {
    NonsmoothSettings {
        scheme: ContactScheme::MoreauJean { restitution: 0.0, implicitness: 0.5 },
        step,
        accuracy: ContactAccuracy::default(),
        cut_off: None,
    }
}

fn advance(march: &mut NonsmoothMarch<'_>, go_on: &GoOn<'_>) -> Result<(), CyclesError> {
    if march.steps().is_multiple_of(PATIENCE) && !go_on() {
        return Err(CyclesError::Stopped);
    }
    Ok(march.advance()?)
}

/// One period more, of so many steps, of which what counts is kept.
fn once(
    march: &mut NonsmoothMarch<'_>,
    period: f64,
    go_on: &GoOn<'_>,
) -> Result<ForcesOverPeriod, CyclesError> {
    let (dimension, points) = (march.contact().dimension, march.contact().points.len());
    let instants = period.round() as usize;
    let mut forces = Mat::zeros(instants, dimension * points);
    let mut gaps = vec![0.0; points];
    for instant in 0..instants {
        advance(march, go_on)?;
        for point in 0..points {
            let force = march.force(point);
            (0..dimension).for_each(|k| forces[(instant, point * dimension + k)] = force[k]);
            gaps[point] += march.gap(point) / instants as f64;
        }
    }
    Ok(ForcesOverPeriod { frequency: TAU / (period * march.settings().step), forces, gaps, balanced: None })
}

/// How far a motion is from where it was.
struct Returns {
    /// Displacements, then velocities, where it begins, now, and sums and sums of squares over the steps of what they differ by.
    first: [Vec<f64>; 2],
    now: [Vec<f64>; 2],
    sums: [Vec<f64>; 2],
    squares: [f64; 2],
    /// Σ of the squares of what displacements and velocities differ by, of each step.
    away: Vec<[f64; 2]>,
}

impl Returns {
    fn new(march: &NonsmoothMarch<'_>, rows: usize) -> Self {
        let none = || [vec![0.0; rows], vec![0.0; rows]];
        let mut own = Self { first: none(), now: none(), sums: none(), squares: [0.0; 2], away: Vec::new() };
        march.observed_displacements(&mut own.first[0]);
        march.observed_velocities(&mut own.first[1]);
        own
    }

    fn take(&mut self, march: &NonsmoothMarch<'_>) {
        march.observed_displacements(&mut self.now[0]);
        march.observed_velocities(&mut self.now[1]);
        let mut away = [0.0; 2];
        for (kind, away) in away.iter_mut().enumerate() {
            for (k, now) in self.now[kind].iter().enumerate() {
                let off = now - self.first[kind][k];
                self.sums[kind][k] += off;
                *away += off * off;
            }
            self.squares[kind] += *away;
        }
        self.away.push(away);
    }

    /// Steps of a period, or how close the motion comes to where it was, of its swing.
    fn period(&self) -> Result<f64, f64> {
        /// How much farther than the closest the first return may be, and how close any return is.
        const AS_CLOSE: f64 = 2.0;
        const CLOSE: f64 = 0.01;
        let count = self.away.len() as f64;
        // twice the variance, the mean square of the distance of two places of the motion
        let swing = [0, 1].map(|kind| {
            let means: f64 = self.sums[kind].iter().map(|sum| sum * sum).sum::<f64>() / count;
            2.0 * (self.squares[kind] - means) / count
        });
        let share = |kind: usize, away: f64| if swing[kind] > 0.0 { away / swing[kind] } else { 0.0 };
        let off: Vec<f64> = self.away.iter().map(|[u, v]| 0.5 * (share(0, *u) + share(1, *v))).collect();
        // it is away once it is farther than a typical place, less what a slow motion misses
        let Some(left) = off.iter().position(|own| *own > 0.5) else { return Err(1.0) };
        let lowest = |k: usize| {
            let [before, at, after] = [off[k - 1], off[k], off[k + 1]];
            let (bend, slope) = (0.5 * (before - 2.0 * at + after), 0.5 * (after - before));
            let shift = if bend > 0.0 { (-0.5 * slope / bend).clamp(-0.5, 0.5) } else { 0.0 };
            let least = (at + shift * (slope + shift * bend)).max(0.0);
            ((k + 1) as f64 + shift, least.sqrt())
        };
        // two periods at least are watched
        let within = (left + 1)..off.len() / 2;
        let minima = within.filter(|k| off[*k] < off[*k - 1] && off[*k] <= off[*k + 1]).map(lowest);
        let minima: Vec<(f64, f64)> = minima.collect();
        let closest = minima.iter().fold(1.0_f64, |least, (_, missed)| least.min(*missed));
        if closest > RETURNS {
            return Err(closest);
        }
        let first = minima.iter().find(|(_, missed)| *missed <= (AS_CLOSE * closest).max(CLOSE));
        first.map(|(period, _)| *period).ok_or(closest)
    }
}
