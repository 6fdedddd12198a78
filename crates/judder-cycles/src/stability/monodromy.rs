//! What small motions about a periodic one become in a period.

use super::mean_law::MeanLaws;
use super::turn::SlipTurns;
use crate::CyclesError;
use crate::backbone::PeriodicMotion;
use crate::balance::HarmonicBalance;
use crate::path::GoOn;
use crate::point_law::ProjectedForce;
use crate::receptance::BodyStep;
use crate::series::Series;
use faer::Mat;
use judder_dense::general::solve;
use judder_dense::product::product;
use judder_nonsmooth::contact_problem::PointMotion;
use std::f64::consts::TAU;

/// What the steps of a period make of displacements and velocities of the coordinates, in this order.
pub(crate) struct Monodromy {
    pub(crate) matrix: Mat<f64>,
    /// Whether no point sticks or turns, so that its error falls with the square of the step.
    pub(super) slides: bool,
}

impl Monodromy {
    /// The matrix without what is known of its error from that of half as many steps (L. F. Richardson): where both are of second order.
    pub(super) fn beyond(&self, coarse: &Self) -> Mat<f64> {
        let more = if self.slides && coarse.slides { 1.0 / 3.0 } else { 0.0 };
        Mat::from_fn(self.matrix.nrows(), self.matrix.ncols(), |i, j| {
            let own = self.matrix[(i, j)];
            own + more * (own - coarse.matrix[(i, j)])
        })
    }
}

/// What a period makes of small motions in so many steps.
pub(crate) fn monodromy(
    balance: &HarmonicBalance<'_>,
    cycle: &PeriodicMotion,
    steps: usize,
    go_on: &GoOn<'_>,
) -> Result<Monodromy, CyclesError> {
    let step = TAU / cycle.turning.frequency / steps as f64;
    // the laws amid the steps
    let series = Series::new(balance.series().harmonics(), 2 * steps);
    let signals = balance.signals_at(&cycle.unknown, cycle.turning)?;
    let projected = balance.projected(&series, &signals);
    let turns = SlipTurns::of(balance, (&series, &signals), &projected, step);
    let means = MeanLaws::of(balance, (&series, &signals), &projected);
    let mut motions = SteppedMotions::new(balance, cycle.turning.frequency, step)?;
    let points = 0..balance.contact().points.len();
    for which in 0..steps {
        if !go_on() {
            return Err(CyclesError::Stopped);
        }
        if let Some(means) = &means {
            for part in means.parts(which) {
                let laws = points.clone().map(|point| means.over(point, part)).collect();
                motions.advance(part[1] - part[0], laws)?;
            }
            continue;
        }
        let law = |point: usize| *projected.at(2 * turns.law_of(point, which) + 1, point);
        motions.advance(1.0, points.clone().map(law).collect())?;
        let SteppedMotions { whole, x, v, .. } = &mut motions;
        turns.take(balance, which, v, |component, column| {
            whole.bodies.carries(component, x.col_as_slice(column))
        });
    }
    Ok(Monodromy { matrix: motions.matrix(), slides: means.is_some() })
}

/// Small motions that each begin with another unit of displacements and velocities.
pub(super) struct SteppedMotions<'b, 'a> {
    balance: &'b HarmonicBalance<'a>,
    /// By which velocities are measured, so that the matrix is of the order of one.
    omega: f64,
    /// In s.
    step: f64,
    whole: PartOfStep,
    x: Mat<f64>,
    v: Mat<f64>,
}

impl<'b, 'a> SteppedMotions<'b, 'a> {
    pub(super) fn new(balance: &'b HarmonicBalance<'a>, omega: f64, step: f64) -> Result<Self, CyclesError> {
        let size = balance.bodies().coordinates();
        let unit = |row: usize, column: usize| f64::from(u8::from(row == column));
        Ok(Self {
            balance,
            omega,
            step,
            whole: PartOfStep::new(balance, step)?,
            x: Mat::from_fn(size, 2 * size, unit),
            v: Mat::from_fn(size, 2 * size, |row, column| omega * unit(row + size, column)),
        })
    }

    /// A share of a step under the laws of all points.
    pub(super) fn advance(&mut self, share: f64, laws: Vec<ProjectedForce>) -> Result<(), CyclesError> {
        let step = share * self.step;
        let part = if share == 1.0 { None } else { Some(PartOfStep::new(self.balance, step)?) };
        let of = part.as_ref().unwrap_or(&self.whole);
        let at = PointsAt { balance: self.balance, of, projected: laws, step };
        let next = at.advanced(&self.x, &self.v)?;
        let middle = |k: usize, j: usize| 0.5 * (self.v[(k, j)] + next[(k, j)]);
        self.x = Mat::from_fn(self.x.nrows(), self.x.ncols(), |k, j| self.x[(k, j)] + step * middle(k, j));
        self.v = next;
        Ok(())
    }

    /// What sticks under these laws is caught at once: it loses its slip, and nothing moves meanwhile.
    pub(super) fn catch(&mut self, laws: Vec<ProjectedForce>) -> Result<(), CyclesError> {
        /// A share of a step that is none.
        const AT_ONCE: f64 = 1e-6;
        let step = AT_ONCE * self.step;
        let of = PartOfStep::new(self.balance, step)?;
        let at = PointsAt { balance: self.balance, of: &of, projected: laws, step };
        self.v = at.advanced(&self.x, &self.v)?;
        Ok(())
    }

    /// What they have become.
    pub(super) fn matrix(&self) -> Mat<f64> {
        let size = self.x.nrows();
        Mat::from_fn(2 * size, 2 * size, |row, column| match row < size {
            true => self.x[(row, column)],
            false => self.v[(row - size, column)] / self.omega,
        })
    }
}

/// The bodies in a step or a part of it.
struct PartOfStep {
    bodies: BodyStep,
    /// P A⁻¹ h Pᵀ.
    compliance: Mat<f64>,
}

impl PartOfStep {
    fn new(balance: &HarmonicBalance<'_>, step: f64) -> Result<Self, CyclesError> {
        let bodies = balance.bodies().step(step)?;
        let compliance = product(bodies.rows.as_ref(), bodies.pushes.as_ref());
        Ok(Self { bodies, compliance })
    }
}

/// The points amid a step.
struct PointsAt<'s, 'b, 'a> {
    balance: &'b HarmonicBalance<'a>,
    of: &'s PartOfStep,
    projected: Vec<ProjectedForce>,
    step: f64,
}

impl PointsAt<'_, '_, '_> {
    /// δv⁺.
    fn advanced(&self, x: &Mat<f64>, v: &Mat<f64>) -> Result<Mat<f64>, CyclesError> {
        let free = self.of.bodies.free(x, v);
        let rows = self.of.bodies.rows.as_ref();
        let [place, before, after] = [x, v, &free].map(|own| product(rows, own.as_ref()));
        // y of the step without contact forces, and what these add
        let carried = self.carried(x, v, &free);
        let moved = Mat::from_fn(place.nrows(), place.ncols(), |component, column| {
            let [of_place, of_before, of_after] = self.shares(component);
            let own = of_place * place[(component, column)]
                + of_before * before[(component, column)]
                + of_after * after[(component, column)];
            own - carried.as_ref().map_or(0.0, |carried| carried[(component, column)])
        });
        let matrix =
            self.law(|component, other| self.shares(component)[2] * self.of.compliance[(component, other)]);
        let mut forces = Mat::from_fn(moved.nrows(), moved.ncols(), |component, column| {
            self.by_motion(component, |other| moved[(other, column)])
        });
        solve(matrix, &mut forces).ok_or(CyclesError::Singular)?;
        Ok(free + product(self.of.bodies.pushes.as_ref(), forces.as_ref()))
    }

    fn dimension(&self) -> usize {
        self.balance.contact().dimension
    }

    /// Shares of place, of velocities before and after the step in the y that the law takes: amid the step where it is smooth, at its end where it holds a point.
    fn shares(&self, component: usize) -> [f64; 3] {
        let (point, own) = (component / self.dimension(), component % self.dimension());
        let state = self.projected[point].state;
        let is_rigid = !self.balance.contact().is_compliant(point);
        match (own, state) {
            (0, PointMotion::Stick | PointMotion::Slip) if is_rigid => [1.0, 0.0, self.step],
            (0, _) => [1.0, 0.25 * self.step, 0.25 * self.step],
            (_, PointMotion::Stick) => [0.0, 0.0, 1.0],
            _ => [0.0, 0.5, 0.5],
        }
    }

    /// What the passing material brings amid the step, where there is any.
    fn carried(&self, x: &Mat<f64>, v: &Mat<f64>, free: &Mat<f64>) -> Option<Mat<f64>> {
        if self.of.bodies.convected.is_empty() {
            return None;
        }
        let mut all = Mat::zeros(self.of.bodies.rows.nrows(), x.ncols());
        for (component, row) in &self.of.bodies.convected {
            for column in 0..x.ncols() {
                let middle =
                    |k: usize| x[(k, column)] + 0.25 * self.step * (v[(k, column)] + free[(k, column)]);
                all[(*component, column)] = row.iter().enumerate().map(|(k, share)| share * middle(k)).sum();
            }
        }
        Some(all)
    }

    /// Σ ∂π/∂y y of a component.
    fn by_motion(&self, component: usize, motion: impl Fn(usize) -> f64) -> f64 {
        let (dimension, own) = (self.dimension(), component % self.dimension());
        let first = component - own;
        let slopes = &self.projected[component / dimension].by_motion[own];
        (0..dimension).map(|k| slopes[k] * motion(first + k)).sum()
    }

    /// 1 − ∂π/∂λ − ∂π/∂y (∂y/∂λ).
    fn law(&self, moved: impl Fn(usize, usize) -> f64) -> Mat<f64> {
        let dimension = self.dimension();
        let size = self.of.compliance.nrows();
        Mat::from_fn(size, size, |i, j| {
            let (point, own) = (i / dimension, i % dimension);
            let by_force =
                if j / dimension == point { self.projected[point].by_force[own][j % dimension] } else { 0.0 };
            f64::from(u8::from(i == j)) - by_force - self.by_motion(i, |k| moved(k, j))
        })
    }
}
