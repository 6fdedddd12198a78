//! The limit cycle that a mode grows to.

use crate::CyclesError;
use crate::backbone::{Backbone, BackboneSettings, PeriodicMotion, backbone, refined};
use crate::balance::HarmonicBalance;
use crate::path::GoOn;
use crate::series::Series;
use faer::{Mat, c64};
use judder_assembly::assembly::Assembly;
use judder_assembly::row::Row;
use judder_assembly::steady::SteadySliding;
use judder_nonsmooth::contact_problem::PointMotion;

/// How a limit cycle is sought.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CycleSettings {
    /// How many harmonics it gets.
    pub harmonics: HarmonicCount,
    /// Instants of a period a harmonic.
    pub samples: usize,
    /// How the motions of the mode are followed, with few harmonics.
    pub backbone: BackboneSettings,
}

/// How many harmonics a cycle gets.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum HarmonicCount {
    /// So many.
    Fixed(usize),
    /// As many as leave this share of the swing of the contact forces out, up to a number.
    Adaptive {
        /// [`CycleQuality::left_out`].
        left_out: f64,
        /// The most.
        most: usize,
    },
}

impl Default for CycleSettings {
    fn default() -> Self {
        let harmonics = HarmonicCount::Adaptive { left_out: 0.01, most: 40 };
        Self { harmonics, samples: 16, backbone: BackboneSettings::default() }
    }
}

/// A limit cycle.
#[derive(Debug, Clone)]
pub struct AssemblyCycle<'a> {
    /// Its equations, with the harmonics that it has.
    pub balance: HarmonicBalance<'a>,
    /// Its unknowns.
    pub motion: PeriodicMotion,
    /// Whether σ falls with the amplitude: motions of this shape nearby are drawn to it; unknown of a cycle that was not found along the motions of a mode.
    pub attracts: Option<bool>,
    /// What its points do.
    pub points: Vec<PointCycle>,
    /// How well it is known.
    pub quality: CycleQuality,
    /// Why it has no more harmonics, where it should.
    pub held_back: Option<CyclesError>,
}

/// What became of a mode.
#[derive(Debug, Clone)]
pub struct CycleSearch<'a> {
    /// Its motions over their amplitude, with few harmonics.
    pub backbone: Backbone,
    /// With how many they were followed, one count after the other: those of the backbone come last.
    pub followed_with: Vec<usize>,
    /// Its cycles, in order of their amplitude along the backbone.
    pub cycles: Vec<AssemblyCycle<'a>>,
}

/// Harmonics with which the motions of a mode are followed, with more of them where fewer lead to no cycle.
const FEW: [usize; 3] = [3, 7, 15];
/// Unknowns up to which they are followed once more: some hundred steps with as large a dense matrix take seconds.
const FOLLOWED_AGAIN: usize = 500;

/// The limit cycles of the mode with this eigenvalue about steady sliding.
///
/// # Errors
/// What [`HarmonicBalance::new`] and [`backbone`] say.
pub fn limit_cycles<'a>(
    assembly: &'a Assembly,
    steady: &SteadySliding,
    eigenvalue: c64,
    settings: &CycleSettings,
    go_on: &GoOn<'_>,
) -> Result<CycleSearch<'a>, CyclesError> {
    let [few, more @ ..] = FEW.map(|count| count.min(settings.most()));
    let mut balance = HarmonicBalance::new(assembly, steady, eigenvalue.im, settings.series(few), &[])?;
    let follow =
        |balance: &HarmonicBalance<'_>| backbone(balance, steady, eigenvalue, &settings.backbone, go_on);
    let mut found = follow(&balance)?;
    let mut followed_with = vec![few];
    for count in more {
        let next = balance.with_series(settings.series(count));
        let is_known = followed_with.last() == Some(&count);
        if !found.cycles.is_empty() || is_known || next.unknowns() > FOLLOWED_AGAIN {
            break;
        }
        match follow(&next) {
            Ok(backbone) => (balance, found) = (next, backbone),
            Err(error) if error.is_of_the_motion() => break,
            Err(error) => return Err(error),
        }
        followed_with.push(count);
    }
    let mut cycles = Vec::new();
    for (motion, attracts) in &found.cycles {
        let cycle = AssemblyCycle::of(balance.clone(), motion.clone(), Some(*attracts))?;
        cycles.push(cycle.with_enough(settings, go_on)?);
    }
    Ok(CycleSearch { backbone: found, followed_with, cycles })
}

impl CycleSettings {
    /// The most harmonics.
    pub(crate) fn most(&self) -> usize {
        match self.harmonics {
            HarmonicCount::Fixed(count) => count,
            HarmonicCount::Adaptive { most, .. } => most,
        }
    }

    pub(crate) fn series(&self, harmonics: usize) -> Series {
        Series::new(harmonics, self.samples * harmonics)
    }
}

impl<'a> AssemblyCycle<'a> {
    pub(crate) fn of(
        balance: HarmonicBalance<'a>,
        motion: PeriodicMotion,
        attracts: Option<bool>,
    ) -> Result<Self, CyclesError> {
        let (points, quality) = points(&balance, &motion)?;
        Ok(Self { balance, motion, attracts, points, quality, held_back: None })
    }

    /// The same with as many harmonics as it should have, or as are found.
    pub(crate) fn with_enough(self, settings: &CycleSettings, go_on: &GoOn<'_>) -> Result<Self, CyclesError> {
        let asked = settings.most();
        let limit = match settings.harmonics {
            HarmonicCount::Fixed(_) => 0.0,
            HarmonicCount::Adaptive { left_out, .. } => left_out,
        };
        let mut cycle = self;
        while cycle.balance.series().harmonics() < asked && cycle.quality.left_out > limit {
            let now = cycle.balance.series().harmonics();
            let balance = cycle.balance.with_series(settings.series((now + now.div_ceil(2)).min(asked)));
            let next = refined(&balance, &cycle.motion, &settings.backbone.rule, go_on)
                .and_then(|motion| Self::of(balance, motion, cycle.attracts));
            match next {
                Ok(next) => cycle = next,
                Err(CyclesError::Stopped) => return Err(CyclesError::Stopped),
                Err(error) => {
                    cycle.held_back = Some(error);
                    break;
                }
            }
        }
        Ok(cycle)
    }
}

impl AssemblyCycle<'_> {
    /// What a form on the freedoms does: its mean and harmonics, as those of [`crate::series`].
    ///
    /// # Errors
    /// [`CyclesError::Singular`].
    pub fn followed(&self, row: &Row) -> Result<Vec<f64>, CyclesError> {
        let (mean, harmonics) = self.balance.coordinates(&self.motion.unknown, self.motion.turning)?;
        let own = self.balance.bodies().on_coordinates(row);
        let mut coefficients = vec![own.iter().zip(&mean).map(|(a, b)| a * b).sum()];
        for harmonic in &harmonics {
            let sum: c64 = own.iter().zip(harmonic).map(|(a, b)| b * *a).sum();
            coefficients.extend([sum.re, -sum.im]);
        }
        Ok(coefficients)
    }

    /// ω in rad/s.
    #[must_use]
    pub fn frequency(&self) -> f64 {
        self.motion.turning.frequency
    }

    /// Forces, motions and states of the points at even instants of a period.
    ///
    /// # Errors
    /// [`CyclesError::Singular`].
    pub fn over_a_period(&self, instants: usize) -> Result<PointsOverPeriod, CyclesError> {
        PointsOverPeriod::of(&self.balance, &self.motion, instants)
    }
}

/// The points over a period, a row an instant.
#[derive(Debug, Clone)]
pub struct PointsOverPeriod {
    /// What the contact laws make of them, in N, a column a component.
    pub forces: Mat<f64>,
    /// Gaps in m, slip velocities in m/s.
    pub motions: Mat<f64>,
    /// What each point does.
    pub states: Vec<Vec<PointMotion>>,
}

impl PointsOverPeriod {
    /// Those of a periodic motion at so many even instants.
    ///
    /// # Errors
    /// [`CyclesError::Singular`].
    pub fn of(
        balance: &HarmonicBalance<'_>,
        motion: &PeriodicMotion,
        instants: usize,
    ) -> Result<Self, CyclesError> {
        let series = Series::new(balance.series().harmonics(), instants);
        let signals = balance.signals_at(&motion.unknown, motion.turning)?;
        let projected = balance.projected(&series, &signals);
        let (dimension, points) = (balance.contact().dimension, balance.contact().points.len());
        let forces = Mat::from_fn(series.samples(), balance.components(), |instant, component| {
            projected.at(instant, component / dimension).force[component % dimension]
        });
        let at = |instant: usize| (0..points).map(|point| projected.at(instant, point).state).collect();
        let states = (0..series.samples()).map(at).collect();
        Ok(Self { forces, motions: series.values(signals.motions.as_ref()), states })
    }
}

/// A point over a cycle.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct PointCycle {
    /// Shares of the period: stuck, sliding, open.
    pub shares: [f64; 3],
    /// The mean of N in N.
    pub normal_force: f64,
    /// The mean of the friction along the slip of steady sliding, in N.
    pub friction_force: f64,
    /// The root mean square of the velocity along the slip about its mean, in m/s.
    pub tangential_velocity_rms: f64,
}

/// How well a cycle is known.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CycleQuality {
    /// The largest |λ − π(λ, y)| of a point at any instant between and at the samples, of the force scale.
    pub between_samples: f64,
    /// The share of the swing of the contact forces that lies beyond the harmonics, as a root of energies.
    pub left_out: f64,
}

/// How many times more instants a cycle is looked at than it was solved with.
pub const FINER: usize = 4;
/// The root mean square of a swing that forces have for no more than what the equations are solved to, of the force scale.
const LEAST_SWING: f64 = 1e-6;

/// What points do over a periodic motion, from instants between those it was solved with.
///
/// # Errors
/// [`CyclesError::Singular`].
pub fn points(
    balance: &HarmonicBalance<'_>,
    motion: &PeriodicMotion,
) -> Result<(Vec<PointCycle>, CycleQuality), CyclesError> {
    let series = Series::new(balance.series().harmonics(), FINER * balance.series().samples());
    let signals = balance.signals_at(&motion.unknown, motion.turning)?;
    let projected = balance.projected(&series, &signals);
    let forces = series.values(signals.forces.as_ref());
    let dimension = balance.contact().dimension;
    let instants = series.samples() as f64;
    let mut points = vec![PointCycle::default(); balance.contact().points.len()];
    let (mut between, mut missing, mut swing) = (0.0_f64, 0.0, 0.0);
    for instant in 0..series.samples() {
        for (point, told) in points.iter_mut().enumerate() {
            let projected = projected.at(instant, point);
            let state = match projected.state {
                PointMotion::Stick => 0,
                PointMotion::Slip => 1,
                PointMotion::Open => 2,
            };
            told.shares[state] += 1.0;
            told.normal_force += projected.force[0] / instants;
            told.friction_force += projected.force[1] / instants;
            for k in 0..dimension {
                let component = point * dimension + k;
                let off = forces[(instant, component)] - projected.force[k];
                let mean = signals.forces[(0, component)];
                between = between.max(off.abs() / balance.force_scale());
                missing += off * off;
                swing += (projected.force[k] - mean) * (projected.force[k] - mean);
            }
        }
    }
    for (point, told) in points.iter_mut().enumerate() {
        told.shares = told.shares.map(|count| count / instants);
        let own = signals.motions.col_as_slice(point * dimension + 1);
        told.tangential_velocity_rms = (own[1..].iter().map(|a| a * a).sum::<f64>() / 2.0).sqrt();
    }
    let least = (LEAST_SWING * balance.force_scale()).powi(2) * instants;
    let left_out = (missing / f64::max(swing, least)).sqrt();
    Ok((points, CycleQuality { between_samples: between, left_out }))
}
