//! What bodies and points do at a guess: from harmonics to instants and back, in place of what was known of another guess.

use super::{CycleRate, HarmonicBalance, PointSignals};
use crate::CyclesError;
use crate::point_law::{COMPONENTS, ProjectedForce, project};
use crate::receptance::AtHarmonic;
use crate::series::{Series, sized};
use faer::{Mat, c64};

/// What the bodies and the points do at a guess.
#[derive(Debug, Clone)]
pub(crate) struct Evaluated {
    /// λ of a harmonic, and the bodies at each.
    forces: Vec<c64>,
    pub(super) harmonics: Vec<AtHarmonic>,
    /// Coefficients.
    pub(crate) signals: PointSignals,
    /// Values of forces and motions, and what the laws make of them.
    values: [Mat<f64>; 2],
    pub(crate) projected: ProjectedForces,
    /// Values and coefficients of that.
    allowed: [Mat<f64>; 2],
    /// Λ − F_H(π) as shares of the force scale, component after component.
    pub(crate) residual: Vec<f64>,
}

/// π of all points at the instants of a period.
#[derive(Debug, Clone, Default)]
pub struct ProjectedForces {
    instants: usize,
    /// Point after point.
    all: Vec<ProjectedForce>,
}

impl ProjectedForces {
    /// That of a point at an instant.
    #[must_use]
    pub fn at(&self, instant: usize, point: usize) -> &ProjectedForce {
        &self.all[point * self.instants + instant]
    }

    /// Those of a point, instant after instant.
    #[must_use]
    pub fn of_point(&self, point: usize) -> &[ProjectedForce] {
        &self.all[point * self.instants..(point + 1) * self.instants]
    }

    /// Those of all points, one point after the other.
    pub fn iter(&self) -> impl Iterator<Item = &ProjectedForce> {
        self.all.iter()
    }
}

impl Evaluated {
    /// Of no guess yet.
    pub(crate) fn new() -> Self {
        let empty = || [Mat::new(), Mat::new()];
        let [forces, motions] = empty();
        Self {
            forces: Vec::new(),
            harmonics: Vec::new(),
            signals: PointSignals { forces, motions },
            values: empty(),
            projected: ProjectedForces::default(),
            allowed: empty(),
            residual: Vec::new(),
        }
    }
}

impl HarmonicBalance<'_> {
    /// s₀.
    fn mean(&self, unknown: &[f64]) -> Vec<f64> {
        unknown.chunks_exact(self.series.coefficients()).map(|own| self.force * own[0]).collect()
    }

    /// The bodies at each harmonic.
    fn respond(&self, unknown: &[f64], at: CycleRate, out: &mut Evaluated) -> Result<(), CyclesError> {
        let size = self.series.coefficients();
        out.harmonics.resize_with(self.series.harmonics(), AtHarmonic::default);
        for (harmonic, own) in (1..).zip(&mut out.harmonics) {
            let force = |own: &[f64]| self.force * c64::new(own[2 * harmonic - 1], -own[2 * harmonic]);
            out.forces.clear();
            out.forces.extend(unknown.chunks_exact(size).map(force));
            let load = self.forcing[harmonic - 1].as_deref();
            self.bodies.at(at.of(harmonic), at.growth, &out.forces, load, own)?;
        }
        Ok(())
    }

    /// Coefficients of forces and motions.
    fn follow(&self, unknown: &[f64], out: &mut Evaluated) {
        let (size, dimension) = (self.series.coefficients(), self.contact.dimension);
        let components = self.components();
        let Evaluated { harmonics, signals: PointSignals { forces, motions }, .. } = out;
        sized(forces, size, components);
        sized(motions, size, components);
        let mean = self.mean(unknown);
        for component in 0..components {
            let known = &unknown[component * size..(component + 1) * size];
            let force = forces.col_as_slice_mut(component);
            force.iter_mut().zip(known).for_each(|(own, known)| *own = self.force * known);
            let own: f64 = (0..components).map(|j| self.statics.receptance[(component, j)] * mean[j]).sum();
            let moved = self.statics.free[component] + own;
            let point = component / dimension;
            let motion = motions.col_as_slice_mut(component);
            motion[0] = match component % dimension {
                0 => {
                    force[0] -= self.scales[point].stiffness * moved;
                    self.contact.first_gap(point) + moved
                }
                1 => moved - self.contact.speed(point),
                _ => moved,
            };
            for (pair, own) in motion[1..].chunks_exact_mut(2).zip(harmonics.iter()) {
                (pair[0], pair[1]) = (own.motion[component].re, -own.motion[component].im);
            }
        }
    }

    /// Forces and motions at a guess, as coefficients.
    ///
    /// # Errors
    /// [`CyclesError::Singular`].
    pub fn signals_at(&self, unknown: &[f64], at: CycleRate) -> Result<PointSignals, CyclesError> {
        let mut out = Evaluated::new();
        self.respond(unknown, at, &mut out)?;
        self.follow(unknown, &mut out);
        Ok(out.signals)
    }

    /// x of the coordinates of the bodies: the mean, and the complex amplitude of each harmonic.
    ///
    /// # Errors
    /// [`CyclesError::Singular`].
    pub fn coordinates(
        &self,
        unknown: &[f64],
        at: CycleRate,
    ) -> Result<(Vec<f64>, Vec<Vec<c64>>), CyclesError> {
        let mut out = Evaluated::new();
        self.respond(unknown, at, &mut out)?;
        let mean = self.statics.coordinates(&self.mean(unknown));
        Ok((mean, out.harmonics.into_iter().map(|own| own.coordinates).collect()))
    }

    /// π of all points at the instants of a series.
    #[must_use]
    pub fn projected(&self, series: &Series, signals: &PointSignals) -> ProjectedForces {
        let (mut values, mut projected) = ([Mat::new(), Mat::new()], ProjectedForces::default());
        self.project(series, signals, &mut values, &mut projected);
        projected
    }

    fn project(
        &self,
        series: &Series,
        signals: &PointSignals,
        values: &mut [Mat<f64>; 2],
        out: &mut ProjectedForces,
    ) {
        for (own, values) in [&signals.forces, &signals.motions].into_iter().zip(values.iter_mut()) {
            series.values_into(own.as_ref(), values);
        }
        let (dimension, instants) = (self.contact.dimension, series.samples());
        let of = |values: &Mat<f64>, instant: usize, point: usize| {
            let mut own = [0.0; COMPONENTS];
            for (k, own) in own.iter_mut().take(dimension).enumerate() {
                *own = values[(instant, point * dimension + k)];
            }
            own
        };
        let [forces, motions] = values;
        out.instants = instants;
        out.all.resize(instants * self.contact.points.len(), ProjectedForce::default());
        let points = self.contact.points.iter().zip(&self.scales).enumerate();
        for ((point, (own, scales)), all) in points.zip(out.all.chunks_exact_mut(instants)) {
            for (instant, out) in all.iter_mut().enumerate() {
                let (force, motion) = (of(forces, instant, point), of(motions, instant, point));
                project(own, *scales, [force, motion], out);
            }
        }
    }

    /// What is left of the equations at a guess, as shares of the force scale, component after component.
    ///
    /// # Errors
    /// [`CyclesError::Singular`].
    pub fn residual(&self, unknown: &[f64], at: CycleRate) -> Result<Vec<f64>, CyclesError> {
        let mut out = Evaluated::new();
        self.evaluate(unknown, at, &mut out)?;
        Ok(out.residual)
    }

    pub(crate) fn evaluate(
        &self,
        unknown: &[f64],
        at: CycleRate,
        out: &mut Evaluated,
    ) -> Result<(), CyclesError> {
        self.respond(unknown, at, out)?;
        self.follow(unknown, out);
        let Evaluated { signals, values, projected, allowed: [allowed, kept], residual, .. } = out;
        self.project(&self.series, signals, values, projected);
        let (samples, dimension) = (self.series.samples(), self.contact.dimension);
        sized(allowed, samples, self.components());
        for component in 0..self.components() {
            let own = projected.of_point(component / dimension);
            let values = allowed.col_as_slice_mut(component);
            values.iter_mut().zip(own).for_each(|(out, own)| *out = own.force[component % dimension]);
        }
        self.series.of_values_into(allowed.as_ref(), kept);
        residual.clear();
        for component in 0..self.components() {
            let (force, kept) = (signals.forces.col_as_slice(component), kept.col_as_slice(component));
            residual.extend(force.iter().zip(kept).map(|(force, kept)| (force - kept) / self.force));
        }
        Ok(())
    }
}
