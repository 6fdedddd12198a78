//! The balance of harmonics with unknowns beside the forces: the frequency, and what else is free.

use crate::CyclesError;
use crate::backbone::PeriodicMotion;
use crate::balance::{CycleRate, Evaluated, HarmonicBalance};
use crate::path::{PathEquations, PathPoint};
use crate::phase::Phase;
use faer::MatMut;
use judder_assembly::assembly::Assembly;
use judder_nonsmooth::contact_problem::PointMotion;

/// Where a balance comes from.
pub(crate) trait BalanceSource {
    /// What is made of it at a value of the parameter.
    fn with<T>(
        &mut self,
        parameter: f64,
        make: impl FnOnce(&HarmonicBalance<'_>) -> Result<T, CyclesError>,
    ) -> Result<T, CyclesError>;

    /// The same beside a value at which it is needed again.
    fn beside<T>(
        &self,
        parameter: f64,
        make: impl FnOnce(&HarmonicBalance<'_>) -> Result<T, CyclesError>,
    ) -> Result<T, CyclesError>;
}

impl BalanceSource for &HarmonicBalance<'_> {
    fn with<T>(
        &mut self,
        parameter: f64,
        make: impl FnOnce(&HarmonicBalance<'_>) -> Result<T, CyclesError>,
    ) -> Result<T, CyclesError> {
        self.beside(parameter, make)
    }

    fn beside<T>(
        &self,
        _: f64,
        make: impl FnOnce(&HarmonicBalance<'_>) -> Result<T, CyclesError>,
    ) -> Result<T, CyclesError> {
        make(self)
    }
}

/// That of an assembly which follows a parameter: built once for a value that is needed several times.
pub(crate) struct KeyedBalance<'f, 'a, F> {
    assembly_at: &'f F,
    /// With the scales of the first, and the bodies of the last.
    balance: HarmonicBalance<'a>,
    last: Option<(f64, Assembly)>,
}

impl<'f, 'a, F: Fn(f64) -> Result<Assembly, CyclesError>> KeyedBalance<'f, 'a, F> {
    pub(crate) fn new(assembly_at: &'f F, balance: &HarmonicBalance<'a>) -> Self {
        Self { assembly_at, balance: balance.clone(), last: None }
    }
}

impl<F: Fn(f64) -> Result<Assembly, CyclesError>> BalanceSource for KeyedBalance<'_, '_, F> {
    fn with<T>(
        &mut self,
        parameter: f64,
        make: impl FnOnce(&HarmonicBalance<'_>) -> Result<T, CyclesError>,
    ) -> Result<T, CyclesError> {
        let assembly = match self.last.take() {
            Some((value, assembly)) if value == parameter => assembly,
            _ => (self.assembly_at)(parameter)?,
        };
        let balance = self.balance.of(&assembly)?;
        self.balance.take_bodies(&balance);
        let made = make(&balance);
        drop(balance);
        self.last = Some((parameter, assembly));
        made
    }

    fn beside<T>(
        &self,
        parameter: f64,
        make: impl FnOnce(&HarmonicBalance<'_>) -> Result<T, CyclesError>,
    ) -> Result<T, CyclesError> {
        let assembly = (self.assembly_at)(parameter)?;
        make(&self.balance.of(&assembly)?)
    }
}

/// What is free beside the forces and the frequency.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Free {
    /// Nothing.
    Nothing,
    /// σ, measured by the frequency.
    Growth,
    /// A parameter, measured by a unit.
    Parameter(f64),
}

/// The balance with its forces, the frequency and what else is free as unknowns, and a phase where nothing drives.
pub(crate) struct ExtendedBalance<S> {
    source: S,
    free: Free,
    /// In rad/s, what the frequency is measured by.
    frequency: f64,
    weights: Vec<f64>,
    phase: Option<Phase>,
    /// Unknown forces, and components of the points.
    unknowns: usize,
    components: usize,
    /// Where the largest forces so far count as one: the mean square of them.
    largest: Option<f64>,
    /// Where the parameter may lie; the frequency where nothing is free beside it.
    range: [f64; 2],
    /// What was evaluated last, and where.
    place: Vec<f64>,
    evaluated: Evaluated,
    residual: Vec<f64>,
}

impl<S: BalanceSource> ExtendedBalance<S> {
    /// Of a balance whose shape is that of the source's.
    pub(crate) fn new(
        source: S,
        like: &HarmonicBalance<'_>,
        frequency: f64,
        free: Free,
        reference: Option<Vec<f64>>,
    ) -> Self {
        let (unknowns, components) = (like.unknowns(), like.components());
        let mut weights = vec![1.0 / components as f64; unknowns];
        weights.resize(unknowns + if free == Free::Nothing { 1 } else { 2 }, 1.0);
        Self {
            source,
            free,
            frequency,
            weights,
            phase: reference.map(|reference| Phase::new(like, reference)),
            unknowns,
            components,
            largest: None,
            range: [f64::NEG_INFINITY, f64::INFINITY],
            place: Vec::new(),
            evaluated: Evaluated::new(),
            residual: Vec::new(),
        }
    }

    /// Lets paths end where the parameter, or the frequency where nothing is free beside it, comes to an end of a range.
    pub(crate) fn keep_within(&mut self, range: [f64; 2]) {
        self.range = range;
    }

    /// What forces and the frequency count in the length of a step, of what they are measured by; whether the largest forces so far count as one.
    pub(crate) fn weigh(&mut self, force: f64, frequency: f64, by_the_largest: bool) {
        self.weights[..self.unknowns].fill(force * force / self.components as f64);
        self.weights[self.unknowns] = frequency * frequency;
        self.largest = by_the_largest.then_some(1.0);
    }

    /// Lets forces count more where loads press far more than a motion swings, of which steps of the usual length would see nothing.
    pub(crate) fn weigh_swing(&mut self, unknown: &[f64]) {
        /// What the swing counts at least, of the force scale.
        const LEAST: f64 = 0.01;
        let size = self.unknowns / self.components;
        let swings = unknown[..self.unknowns].chunks_exact(size).flat_map(|own| &own[1..]);
        let swing = (swings.map(|own| own * own).sum::<f64>() / self.components as f64).sqrt();
        self.weigh((LEAST / swing).max(1.0), 1.0, false);
    }

    /// The unknowns of a motion, at a value of the parameter where that is free.
    pub(crate) fn place(&self, motion: &PeriodicMotion, parameter: f64) -> Vec<f64> {
        let turning = motion.turning;
        let mut at: Vec<f64> =
            motion.unknown.iter().copied().chain([turning.frequency / self.frequency]).collect();
        match self.free {
            Free::Nothing => {}
            Free::Growth => at.push(turning.growth / self.frequency),
            Free::Parameter(unit) => at.push(parameter / unit),
        }
        at
    }

    pub(crate) fn rate(&self, at: &[f64]) -> CycleRate {
        let frequency = self.frequency * at[self.unknowns];
        match self.free {
            Free::Nothing => CycleRate { frequency: self.last(at), growth: 0.0 },
            Free::Growth => CycleRate { frequency, growth: self.last(at) },
            Free::Parameter(_) => CycleRate { frequency, growth: 0.0 },
        }
    }

    /// The parameter where it is free.
    pub(crate) fn parameter(&self, at: &[f64]) -> f64 {
        match self.free {
            Free::Parameter(_) => self.last(at),
            _ => 0.0,
        }
    }

    /// What the last unknown is measured by.
    fn unit(&self) -> f64 {
        match self.free {
            Free::Nothing | Free::Growth => self.frequency,
            Free::Parameter(unit) => unit,
        }
    }

    /// What the last unknown stands for: at an end of its range that itself.
    fn last(&self, at: &[f64]) -> f64 {
        let (own, unit) = (at[at.len() - 1], self.unit());
        let end = self.range.into_iter().find(|end| own == end / unit);
        end.unwrap_or(unit * own)
    }

    /// What every point does at every instant.
    pub(crate) fn states(&mut self, at: &[f64]) -> Result<Vec<PointMotion>, CyclesError> {
        self.evaluate(at)?;
        Ok(self.evaluated.projected.iter().map(|own| own.state).collect())
    }

    /// What points and bodies do at a place; known if it was the last.
    fn evaluate(&mut self, at: &[f64]) -> Result<(), CyclesError> {
        if self.place == at {
            return Ok(());
        }
        self.place.clear();
        let (rate, parameter, unknowns) = (self.rate(at), self.parameter(at), self.unknowns);
        let Self { source, evaluated, .. } = self;
        source.with(parameter, |balance| balance.evaluate(&at[..unknowns], rate, evaluated))?;
        self.place.extend_from_slice(at);
        Ok(())
    }

    /// The motion at a solution.
    pub(crate) fn motion(&mut self, point: &PathPoint) -> Result<PeriodicMotion, CyclesError> {
        self.evaluate(&point.at)?;
        let motions = &self.evaluated.signals.motions;
        Ok(PeriodicMotion {
            unknown: point.at[..self.unknowns].to_vec(),
            turning: self.rate(&point.at),
            amplitude: self.phase.as_ref().map_or(0.0, |phase| phase.amplitude(motions)),
            residual: point.residual,
        })
    }

    /// ∂/∂p of what is left, of p over its unit, by a difference.
    fn by_parameter(&self, at: &[f64], unit: f64) -> Result<Vec<f64>, CyclesError> {
        /// Of the unit.
        const DIFFERENCE: f64 = 1e-6;
        let (rate, unknowns) = (self.rate(at), self.unknowns);
        let mut beside = Evaluated::new();
        let here = self.parameter(at);
        let difference = if here + DIFFERENCE * unit > self.range[1] { -DIFFERENCE } else { DIFFERENCE };
        let parameter = here + difference * unit;
        self.source.beside(parameter, |balance| balance.evaluate(&at[..unknowns], rate, &mut beside))?;
        let mut own = beside.residual;
        own.extend(self.phase.as_ref().map(|phase| phase.of(&beside.signals.motions)));
        own.iter_mut().zip(&self.residual).for_each(|(own, here)| *own = (*own - here) / difference);
        Ok(own)
    }
}

impl<S: BalanceSource> PathEquations for ExtendedBalance<S> {
    fn residual(&mut self, at: &[f64]) -> Result<&[f64], CyclesError> {
        self.evaluate(at)?;
        let Evaluated { residual, signals, .. } = &self.evaluated;
        self.residual.clear();
        self.residual.extend_from_slice(residual);
        self.residual.extend(self.phase.as_ref().map(|phase| phase.of(&signals.motions)));
        Ok(&self.residual)
    }

    fn derivative(&mut self, at: &[f64], mut out: MatMut<'_, f64>) -> Result<(), CyclesError> {
        self.residual(at)?;
        let (rate, parameter, unknowns) = (self.rate(at), self.parameter(at), self.unknowns);
        let turning = if self.free == Free::Growth { 2 } else { 1 };
        let Self { source, evaluated, phase, .. } = self;
        source.with(parameter, |balance| {
            let own = out.as_mut().submatrix_mut(0, 0, unknowns, unknowns + turning);
            let slopes = balance.derivative(evaluated, rate, own)?;
            if let Some(phase) = phase {
                let mut row = out.as_mut().row_mut(unknowns);
                row.fill(0.0);
                balance.slopes_of_first(&slopes, &phase.factors(), &mut |column, slope| {
                    if column < unknowns + turning {
                        row[column] = slope;
                    }
                });
            }
            Ok(())
        })?;
        for column in unknowns..unknowns + turning {
            (0..out.nrows()).for_each(|row| out[(row, column)] *= self.frequency);
        }
        if let Free::Parameter(unit) = self.free {
            let slopes = self.by_parameter(at, unit)?;
            slopes.into_iter().enumerate().for_each(|(row, own)| out[(row, unknowns + 1)] = own);
        }
        Ok(())
    }

    fn weights(&self) -> &[f64] {
        &self.weights
    }

    fn ends(&self) -> [f64; 2] {
        self.range.map(|end| end / self.unit())
    }

    fn is_sought(&mut self, at: &[f64]) -> Result<bool, CyclesError> {
        self.evaluate(at)?;
        Ok(self.phase.as_ref().is_none_or(|phase| phase.moves(&self.evaluated.signals.motions)))
    }

    fn accept(&mut self, at: &[f64]) -> Result<(), CyclesError> {
        self.evaluate(at)?;
        if let Some(phase) = &mut self.phase {
            phase.follow(&self.evaluated.signals.motions);
        }
        if let Some(largest) = &mut self.largest {
            let components = self.components as f64;
            let square = at[..self.unknowns].iter().map(|own| own * own).sum::<f64>() / components;
            *largest = largest.max(square);
            self.weights[..self.unknowns].fill(1.0 / (components * *largest));
        }
        Ok(())
    }
}
