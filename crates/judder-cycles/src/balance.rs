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

mod jacobian;

use crate::CyclesError;
use crate::point_law::{COMPONENTS, PointScales, ProjectedForce, project};
use crate::receptance::{AtHarmonic, HarmonicBodies, StaticResponse};
use crate::series::Series;
use faer::{Mat, c64};
use judder_assembly::assembly::Assembly;
use judder_assembly::steady::SteadySliding;
use judder_nonsmooth::contact::ContactPoints;
use std::sync::Arc;

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

/// What the bodies and the points do at a guess.
#[derive(Debug, Clone)]
pub(crate) struct Evaluated {
    /// Of each harmonic.
    harmonics: Vec<AtHarmonic>,
    /// Coefficients.
    pub(crate) signals: PointSignals,
    projected: Vec<ProjectedForce>,
    /// Λ − F_H(π) as shares of the force scale, component after component.
    pub(crate) residual: Vec<f64>,
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
        let driving = forcing.iter().flat_map(|own| own.amplitude.iter().map(|own| own.norm()));
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
        Ok(Self { contact, bodies, series, scales, force, load, statics, forcing: loads })
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
            force: self.force,
            statics,
            forcing: self.forcing.clone(),
        })
    }

    /// The same bodies with other harmonics.
    #[must_use]
    pub fn with_series(&self, series: Series) -> Self {
        let mut forcing = self.forcing.clone();
        forcing.resize(series.harmonics(), None);
        Self { series, forcing, ..self.clone() }
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

    /// λ of a harmonic of the unknowns, from one on.
    fn harmonic(&self, unknown: &[f64], harmonic: usize) -> Vec<c64> {
        let columns = unknown.chunks_exact(self.series.coefficients());
        columns.map(|own| self.force * c64::new(own[2 * harmonic - 1], -own[2 * harmonic])).collect()
    }

    /// s₀.
    fn mean(&self, unknown: &[f64]) -> Vec<f64> {
        unknown.chunks_exact(self.series.coefficients()).map(|own| self.force * own[0]).collect()
    }

    fn responses(&self, unknown: &[f64], at: CycleRate) -> Result<Vec<AtHarmonic>, CyclesError> {
        let of = |harmonic: usize| {
            let load = self.forcing[harmonic - 1].as_deref();
            let forces = self.harmonic(unknown, harmonic);
            self.bodies.at(at.of(harmonic), at.growth, &forces, load)
        };
        (1..=self.series.harmonics()).map(of).collect()
    }

    /// Coefficients of forces and motions.
    fn signals(&self, unknown: &[f64], harmonics: &[AtHarmonic]) -> PointSignals {
        let (size, dimension) = (self.series.coefficients(), self.contact.dimension);
        let components = self.components();
        let mut forces = Mat::from_fn(size, components, |k, c| self.force * unknown[c * size + k]);
        let mut motions = Mat::zeros(size, components);
        let mean = self.mean(unknown);
        for component in 0..components {
            let own: f64 = (0..components).map(|j| self.statics.receptance[(component, j)] * mean[j]).sum();
            let moved = self.statics.free[component] + own;
            let point = component / dimension;
            motions[(0, component)] = match component % dimension {
                0 => {
                    forces[(0, component)] -= self.scales[point].stiffness * moved;
                    self.contact.first_gap(point) + moved
                }
                1 => moved - self.contact.speed(point),
                _ => moved,
            };
            for (k, own) in harmonics.iter().enumerate() {
                motions[(2 * k + 1, component)] = own.motion[component].re;
                motions[(2 * k + 2, component)] = -own.motion[component].im;
            }
        }
        PointSignals { forces, motions }
    }

    /// Forces and motions at a guess, as coefficients.
    ///
    /// # Errors
    /// [`CyclesError::Singular`].
    pub fn signals_at(&self, unknown: &[f64], at: CycleRate) -> Result<PointSignals, CyclesError> {
        Ok(self.signals(unknown, &self.responses(unknown, at)?))
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
        let harmonics = self.responses(unknown, at)?;
        let mean = self.statics.coordinates(&self.mean(unknown));
        Ok((mean, harmonics.into_iter().map(|own| own.coordinates).collect()))
    }

    /// π of all points at the instants of a series, instant after instant, in order of the points.
    #[must_use]
    pub fn projected(&self, series: &Series, signals: &PointSignals) -> Vec<ProjectedForce> {
        let [forces, motions] =
            [&signals.forces, &signals.motions].map(|coefficients| series.values(coefficients.as_ref()));
        let (dimension, points) = (self.contact.dimension, self.contact.points.len());
        let of = |values: &Mat<f64>, instant: usize, point: usize| {
            let mut own = [0.0; COMPONENTS];
            for (k, own) in own.iter_mut().take(dimension).enumerate() {
                *own = values[(instant, point * dimension + k)];
            }
            own
        };
        let mut all = vec![ProjectedForce::default(); series.samples() * points];
        for point in 0..points {
            for instant in 0..series.samples() {
                let (force, motion) = (of(&forces, instant, point), of(&motions, instant, point));
                let out = &mut all[instant * points + point];
                project(&self.contact.points[point], self.scales[point], [force, motion], out);
            }
        }
        all
    }

    /// What is left of the equations at a guess, as shares of the force scale, component after component.
    ///
    /// # Errors
    /// [`CyclesError::Singular`].
    pub fn residual(&self, unknown: &[f64], at: CycleRate) -> Result<Vec<f64>, CyclesError> {
        Ok(self.evaluated(unknown, at)?.residual)
    }

    pub(crate) fn evaluated(&self, unknown: &[f64], at: CycleRate) -> Result<Evaluated, CyclesError> {
        let harmonics = self.responses(unknown, at)?;
        let signals = self.signals(unknown, &harmonics);
        let projected = self.projected(&self.series, &signals);
        let residual = self.residual_of(&signals, &projected);
        Ok(Evaluated { harmonics, signals, projected, residual })
    }

    fn residual_of(&self, signals: &PointSignals, projected: &[ProjectedForce]) -> Vec<f64> {
        let (size, dimension) = (self.series.coefficients(), self.contact.dimension);
        let points = self.contact.points.len();
        let allowed = Mat::from_fn(self.series.samples(), self.components(), |instant, component| {
            projected[instant * points + component / dimension].force[component % dimension]
        });
        let allowed = self.series.of_values(allowed.as_ref());
        let entry =
            |k: usize| (signals.forces[(k % size, k / size)] - allowed[(k % size, k / size)]) / self.force;
        (0..self.unknowns()).map(entry).collect()
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
        self.linearised(self.evaluated(unknown, at)?, at)
    }

    pub(crate) fn linearised(&self, evaluated: Evaluated, at: CycleRate) -> Result<Balanced, CyclesError> {
        let Evaluated { harmonics, signals, projected, residual } = evaluated;
        let receptance = |harmonic: usize| self.bodies.receptance(at.of(harmonic), at.growth);
        let receptances = (1..=self.series.harmonics()).map(receptance).collect::<Result<Vec<_>, _>>()?;
        let responses = Responses { receptances, harmonics };
        let mut jacobian = self.jacobian(&responses, &projected);
        (0..self.unknowns()).filter(|k| self.is_mean_friction(*k)).for_each(|k| jacobian[(k, k)] += LEAST);
        let first = self.first(&responses);
        Ok(Balanced { residual, jacobian, signals, first })
    }
}

/// The bodies at all harmonics, Γ of each and what they do.
struct Responses {
    receptances: Vec<Mat<c64>>,
    harmonics: Vec<AtHarmonic>,
}

/// What was evaluated last, which a linearisation at the same place starts from.
#[derive(Debug, Clone, Default)]
pub(crate) struct LastEvaluated(Option<(Vec<f64>, Evaluated)>);

impl LastEvaluated {
    pub(crate) fn keep(&mut self, at: &[f64], evaluated: Evaluated) {
        self.0 = Some((at.to_vec(), evaluated));
    }

    /// What is kept, where it is of this place.
    pub(crate) fn take(&mut self, at: &[f64]) -> Option<Evaluated> {
        self.0.take().filter(|(place, _)| place == at).map(|(_, evaluated)| evaluated)
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
    let size = |component: usize| receptance[(component, component)].norm();
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
