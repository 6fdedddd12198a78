//! The balance of harmonics on the contact points.
//!
//! Unknown are the forces of all points, λ(τ) = Λ₀ + Σ (…); bodies follow as y(τ) = Y₀ + Re Σ Γ(i h ω) Λ_h e^{ihτ}. What is sought is
//!
//! ```text
//! Λ = F_H(π(λ(τ), y(τ)))
//! ```
//!
//! with the laws of [`crate::point_law`] at even instants of a period and F_H the first H harmonics: alternating frequency and time (T. M. Cameron, J. H. Griffin,
//! J. Appl. Mech. 56, 1989). Bodies of any size come in by their receptances at the points alone. Of the mean the unknown is s₀ = Λ₀ + ε c x₀ on the normals: [`StaticResponse`].

mod evaluated;
mod jacobian;

use crate::CyclesError;
use crate::point_law::PointScales;
use crate::receptance::{AtHarmonic, HarmonicBodies, HarmonicSlopes, StaticResponse};
use crate::series::Series;
use faer::{Mat, MatMut, c64};
use judder_assembly::assembly::Assembly;
use judder_assembly::steady::SteadySliding;
use judder_nonsmooth::contact::ContactPoints;
use judder_numerics::complex::ElementaryComplex;
use std::sync::Arc;

pub(crate) use evaluated::Evaluated;
pub use evaluated::ProjectedForces;

/// A periodic force on the freedoms, Re f e^{ihτ}.
#[derive(Debug, Clone, PartialEq)]
pub struct HarmonicForce {
    /// h, from one on.
    pub harmonic: usize,
    /// f of each freedom in N.
    pub amplitude: Vec<c64>,
}

/// What keeps Newton's method from moving friction that nothing determines.
const LEAST: f64 = 1e-9;

/// The equations of periodic motions of an assembly.
#[derive(Debug, Clone)]
pub struct HarmonicBalance<'a> {
    contact: ContactPoints<'a>,
    bodies: HarmonicBodies,
    series: Series,
    scales: Vec<PointScales>,
    /// In rad/s, at which the scales are taken.
    scaled_at: f64,
    /// In N: unknowns and residuals are shares of it.
    force: f64,
    /// f on the freedoms, and what it does.
    load: Vec<f64>,
    statics: Arc<StaticResponse>,
    /// On the coordinates, of each harmonic from one on.
    forcing: Vec<Option<Vec<c64>>>,
}

/// What periodic motions turn and grow with.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CycleRate {
    /// ω in rad/s.
    pub frequency: f64,
    /// σ in 1/s, which is taken off.
    pub growth: f64,
}

impl CycleRate {
    /// s of a harmonic.
    fn of(self, harmonic: usize) -> c64 {
        c64::new(0.0, harmonic as f64 * self.frequency)
    }
}

/// Forces and motions of the points: a column a component, of coefficients or of instants.
#[derive(Debug, Clone)]
pub struct PointSignals {
    /// λ in N.
    pub forces: Mat<f64>,
    /// y: gaps in m, slip velocities in m/s.
    pub motions: Mat<f64>,
}

/// The equations at a guess.
#[derive(Debug, Clone)]
pub struct Balanced {
    /// Λ − F_H(π) as shares of the force scale, component after component.
    pub residual: Vec<f64>,
    /// Its derivative by the unknowns, and by ω and σ in the last two columns.
    pub jacobian: Mat<f64>,
    /// Coefficients.
    pub signals: PointSignals,
    /// Derivatives of the first harmonics of y by the unknowns, ω and σ: cosine and sine of each component, two rows a component.
    pub first: Mat<f64>,
}

impl<'a> HarmonicBalance<'a> {
    /// Those of an assembly about steady sliding, whose motions turn about as fast as `frequency` in rad/s.
    ///
    /// # Errors
    /// [`CyclesError::NothingTouches`], [`CyclesError::NotHeld`], [`CyclesError::TooManyFreedoms`], and what the contact points say.
    pub fn new(
        assembly: &'a Assembly,
        steady: &SteadySliding,
        frequency: f64,
        series: Series,
        forcing: &[HarmonicForce],
    ) -> Result<Self, CyclesError> {
        let contact = ContactPoints::new(assembly, &[])?;
        if contact.points.is_empty() {
            return Err(CyclesError::NothingTouches);
        }
        let bodies = HarmonicBodies::new(assembly, &contact)?;
        let force = steady.points.iter().fold(0.0_f64, |most, own| most.max(own.normal_force.abs()));
        let driving = forcing.iter().flat_map(|own| own.amplitude.iter().map(|own| own.modulus()));
        let force = [force, largest(&assembly.load), driving.fold(0.0, f64::max), 1.0];
        let force = force.into_iter().find(|own| *own > 0.0).unwrap_or(1.0);
        let scales = scales(&bodies, contact.dimension, frequency)?;
        let stiffness: Vec<f64> = scales.iter().map(|own| own.stiffness).collect();
        let statics = Arc::new(bodies.statics(&assembly.load, &stiffness)?);
        let load = assembly.load.clone();
        let mut loads = vec![None; series.harmonics()];
        for own in forcing {
            if let Some(load) = own.harmonic.checked_sub(1).and_then(|k| loads.get_mut(k)) {
                let part = |part: fn(&c64) -> f64| {
                    bodies.forces(&own.amplitude.iter().map(part).collect::<Vec<_>>())
                };
                let [re, im] = [part(|own| own.re), part(|own| own.im)];
                *load = Some(re.into_iter().zip(im).map(|(re, im)| c64::new(re, im)).collect());
            }
        }
        let scaled_at = frequency;
        Ok(Self { contact, bodies, series, scales, scaled_at, force, load, statics, forcing: loads })
    }

    /// The same equations, with the same scales, of another assembly of as many points.
    ///
    /// # Errors
    /// As [`HarmonicBalance::new`]; [`CyclesError::OtherPoints`].
    pub fn of<'o>(&self, assembly: &'o Assembly) -> Result<HarmonicBalance<'o>, CyclesError> {
        let contact = ContactPoints::new(assembly, &[])?;
        let [found, expected] = [contact.rows.len(), self.components()];
        if found != expected {
            return Err(CyclesError::OtherPoints { found, expected });
        }
        let known = self.bodies.are_of(assembly, &contact);
        let bodies = if known { self.bodies.clone() } else { HarmonicBodies::new(assembly, &contact)? };
        let statics = match known && self.load == assembly.load {
            true => self.statics.clone(),
            false => {
                let stiffness: Vec<f64> = self.scales.iter().map(|own| own.stiffness).collect();
                Arc::new(bodies.statics(&assembly.load, &stiffness)?)
            }
        };
        Ok(HarmonicBalance {
            load: assembly.load.clone(),
            contact,
            bodies,
            series: self.series.clone(),
            scales: self.scales.clone(),
            scaled_at: self.scaled_at,
            force: self.force,
            statics,
            forcing: self.forcing.clone(),
        })
    }

    /// The bodies of another balance, to which assemblies are compared from now on.
    pub(crate) fn take_bodies(&mut self, other: &HarmonicBalance<'_>) {
        if !Arc::ptr_eq(&self.statics, &other.statics) {
            self.bodies = other.bodies.clone();
            self.statics = other.statics.clone();
            self.load.clone_from(&other.load);
        }
    }

    /// The same bodies with other harmonics.
    #[must_use]
    pub fn with_series(&self, series: Series) -> Self {
        let mut forcing = self.forcing.clone();
        forcing.resize(series.harmonics(), None);
        Self { series, forcing, ..self.clone() }
    }

    /// The same bodies with so many times the harmonics, and as unknowns the forces that the laws make of a motion: with what its own harmonics leave out of them.
    pub(crate) fn with_left_out(
        &self,
        unknown: &[f64],
        at: CycleRate,
        times: usize,
    ) -> Result<(Self, Vec<f64>), CyclesError> {
        let harmonics = self.series.harmonics();
        let wide = Series::new(times * harmonics, times * self.series.samples());
        let signals = self.signals_at(unknown, at)?;
        let projected = self.projected(&Series::new(harmonics, wide.samples()), &signals);
        let dimension = self.contact.dimension;
        let forces = Mat::from_fn(wide.samples(), self.components(), |instant, component| {
            projected.at(instant, component / dimension).force[component % dimension]
        });
        let moved = |point: usize| signals.motions[(0, point * dimension)] - self.contact.first_gap(point);
        let unknown = self.unknown_of(wide.of_values(forces.as_ref()), moved);
        Ok((self.with_series(wide), unknown))
    }

    /// The unknowns of forces in N, as coefficients, and of how far each point lies on average beyond its first gap.
    fn unknown_of(&self, mut forces: Mat<f64>, moved: impl Fn(usize) -> f64) -> Vec<f64> {
        for (point, scales) in self.scales.iter().enumerate() {
            forces[(0, point * self.contact.dimension)] += scales.stiffness * moved(point);
        }
        let of = |component: usize| forces.col_as_slice(component).iter().map(|own| own / self.force);
        (0..self.components()).flat_map(of).collect()
    }

    /// The unknowns that forces at even instants of a period are, a row an instant, in N, with the mean gaps of the points in m.
    pub(crate) fn unknown_over_period(&self, forces: &Mat<f64>, gaps: &[f64]) -> Vec<f64> {
        let moved = |point: usize| gaps[point] - self.contact.first_gap(point);
        self.unknown_of(self.series.of_period(forces.as_ref()), moved)
    }

    /// The unknowns of the same forces with more or fewer harmonics than those have.
    pub(crate) fn with_its_harmonics(&self, unknown: &[f64]) -> Vec<f64> {
        let (size, known) = (self.series.coefficients(), unknown.len() / self.components());
        let mut own = vec![0.0; self.unknowns()];
        for (own, from) in own.chunks_exact_mut(size).zip(unknown.chunks_exact(known)) {
            let kept = known.min(size);
            own[..kept].copy_from_slice(&from[..kept]);
        }
        own
    }

    /// The harmonics.
    #[must_use]
    pub fn series(&self) -> &Series {
        &self.series
    }

    /// The contact points.
    #[must_use]
    pub fn contact(&self) -> &ContactPoints<'a> {
        &self.contact
    }

    /// The bodies.
    #[must_use]
    pub fn bodies(&self) -> &HarmonicBodies {
        &self.bodies
    }

    /// What drives on the coordinates, of a harmonic from one on.
    pub(crate) fn forcing(&self, harmonic: usize) -> Option<&[c64]> {
        self.forcing.get(harmonic.checked_sub(1)?)?.as_deref()
    }

    /// Whether anything drives the bodies.
    pub(crate) fn is_driven(&self) -> bool {
        self.forcing.iter().any(Option::is_some)
    }

    /// The force in N by which unknowns are measured.
    #[must_use]
    pub fn force_scale(&self) -> f64 {
        self.force
    }

    /// ε of each point.
    #[must_use]
    pub fn scales(&self) -> &[PointScales] {
        &self.scales
    }

    /// The frequency in rad/s at which those are taken: what harmonics leave out of a motion depends on it.
    #[must_use]
    pub fn scaled_at(&self) -> f64 {
        self.scaled_at
    }

    /// Components of all points.
    #[must_use]
    pub fn components(&self) -> usize {
        self.contact.rows.len()
    }

    /// Unknown shares of the force scale: component after component, of each its coefficients.
    #[must_use]
    pub fn unknowns(&self) -> usize {
        self.components() * self.series.coefficients()
    }

    /// The unknowns of steady sliding.
    #[must_use]
    pub fn steady(&self, steady: &SteadySliding) -> Vec<f64> {
        let (dimension, size) = (self.contact.dimension, self.series.coefficients());
        let mut unknown = vec![0.0; self.unknowns()];
        for (point, state) in steady.points.iter().enumerate() {
            let opening = state.gap - self.contact.first_gap(point);
            let normal = state.normal_force + self.scales[point].stiffness * opening;
            unknown[point * dimension * size] = normal / self.force;
            unknown[(point * dimension + 1) * size] = state.friction_force / self.force;
        }
        unknown
    }

    /// Whether an unknown is a mean of friction: of a point that sticks throughout the laws leave it open.
    fn is_mean_friction(&self, unknown: usize) -> bool {
        let size = self.series.coefficients();
        unknown.is_multiple_of(size) && !(unknown / size).is_multiple_of(self.contact.dimension)
    }

    /// The equations with their derivatives.
    ///
    /// # Errors
    /// [`CyclesError::Singular`].
    pub fn balanced(&self, unknown: &[f64], at: CycleRate) -> Result<Balanced, CyclesError> {
        let mut out = Evaluated::new();
        self.evaluate(unknown, at, &mut out)?;
        let unknowns = self.unknowns();
        let mut jacobian = Mat::zeros(unknowns, unknowns + 2);
        let slopes = self.derivative(&out, at, jacobian.as_mut())?;
        let mut first = Mat::zeros(2 * self.components(), unknowns + 2);
        let mut factors = vec![0.0; first.nrows()];
        for row in 0..first.nrows() {
            factors[row] = 1.0;
            self.slopes_of_first(&slopes, &factors, &mut |column, slope| first[(row, column)] = slope);
            factors[row] = 0.0;
        }
        Ok(Balanced { residual: out.residual, jacobian, signals: out.signals, first })
    }

    /// The derivative by the unknowns and, as far as the matrix has columns, by ω and σ, in place of what it has.
    pub(crate) fn derivative(
        &self,
        evaluated: &Evaluated,
        at: CycleRate,
        mut out: MatMut<'_, f64>,
    ) -> Result<Vec<HarmonicSlopes>, CyclesError> {
        let slopes = (1..).zip(&evaluated.harmonics).map(|(harmonic, own): (usize, &AtHarmonic)| {
            self.bodies.slopes(at.of(harmonic), at.growth, &own.coordinates)
        });
        let slopes = slopes.collect::<Result<Vec<_>, _>>()?;
        self.jacobian(&slopes, &evaluated.projected, out.as_mut());
        (0..self.unknowns()).filter(|k| self.is_mean_friction(*k)).for_each(|k| out[(k, k)] += LEAST);
        Ok(slopes)
    }
}

/// ε of each point, from how it yields to a force that grows as fast as the motion turns: there nothing resonates.
fn scales(
    bodies: &HarmonicBodies,
    dimension: usize,
    frequency: f64,
) -> Result<Vec<PointScales>, CyclesError> {
    /// The smaller they are, the closer are forces to their laws between the instants, and the harder to find.
    const NORMAL: f64 = 0.3;
    const TANGENTIAL: f64 = 0.5;
    let receptance = bodies.receptance(c64::new(frequency, 0.0), 0.0)?;
    let size = |component: usize| receptance[(component, component)].modulus();
    let of = |point: usize| {
        let [normal, tangential] = [0, 1].map(|k| size(point * dimension + k));
        let stiffness = NORMAL / normal;
        // a point that cannot move along the contact is measured by its normal
        let viscosity = if tangential > 0.0 { TANGENTIAL / tangential } else { stiffness / frequency };
        PointScales { stiffness, viscosity }
    };
    Ok((0..bodies.components() / dimension).map(of).collect())
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most, own| most.max(own.abs()))
}
