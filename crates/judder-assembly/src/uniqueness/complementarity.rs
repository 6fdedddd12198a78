//! Steady sliding as a linear complementarity problem.

use crate::AssemblyError;
use crate::assembly::Assembly;
use crate::compliance::{Compliance, rigid_motions};
use crate::interface::{FramedPoint, InterfaceLaw};
use crate::pressure::Pressure;
use crate::steady::{GrowingFriction, SteadySliding};
use faer::Mat;
use judder_dense::general::solve;
use judder_dense::symmetric::negative_eigenvalues;
use judder_structure::StructureError;

/// M w − Q N = r on all points.
pub(super) struct Complementarity {
    /// M.
    opened: Mat<f64>,
    /// Q.
    pressed: Mat<f64>,
    /// r in m.
    right: Vec<f64>,
    /// Whether a point stays closed whatever its force.
    bound: Vec<bool>,
    /// Whether something else than contacts holds the bodies: M is regular.
    pub(super) is_held: bool,
    /// Whether the pressure of some point is no multiple of its closure: then it is that of a table, which rises, and its compliance is
    /// left out of Q. A state is still the only one where A is a P-matrix, but sets cannot be tried, and where A is singular means nothing.
    pub(super) is_curved: bool,
    /// M⁻¹ S_nn + k⁻¹ and M⁻¹ S_nt μ, where M is regular; of contact without friction μ is one.
    pub(super) parts: Option<[Mat<f64>; 2]>,
}

/// The problem seen from one of its states: what is zero there as a function of what is not.
pub(super) struct Pivoted {
    /// On the points that may open, scaled.
    pub(super) matrix: Mat<f64>,
    /// Whether each point of the state either presses or is open.
    pub(super) is_decided: bool,
}

/// A state that one set of closed points has.
pub(super) struct SetState {
    /// What is closed.
    pub(super) closed: Vec<usize>,
    /// The normal force of every point in N.
    forces: Vec<f64>,
}

/// What of a scaled matrix is rounding.
pub(super) const PIVOTED: f64 = 1e-10;
/// Forces and gaps below so much of the largest are none.
const NONE: f64 = 1e-10;
/// States whose forces differ by less than so much of the largest are the same.
const SAME: f64 = 1e-7;
/// Solutions larger than those of the state by so much are those of singular equations.
const SINGULAR: f64 = 1e9;

impl Complementarity {
    /// The problem of an assembly; none where friction is not proportional to the normal force, as of spheres.
    pub(super) fn new(
        assembly: &Assembly,
        compliance: &Compliance,
        points: &[FramedPoint<'_>],
    ) -> Result<Option<Self>, AssemblyError> {
        let count = points.len();
        let (mut coefficients, mut yielding) = (Vec::new(), Vec::new());
        let mut is_curved = false;
        for point in points {
            let (friction, soft) = match point.law {
                InterfaceLaw::Rigid(friction) => (friction, 0.0),
                InterfaceLaw::Compliant(Pressure::Stiffness(stiffness), friction) => {
                    (friction, 1.0 / (stiffness * point.point.area))
                }
                InterfaceLaw::Compliant(Pressure::PointStiffness(stiffness), friction) => {
                    (friction, 1.0 / stiffness)
                }
                // what stays closed pulls by a law of its own
                InterfaceLaw::Compliant(
                    Pressure::Table(_)
                    | Pressure::Cubic(_)
                    | Pressure::PointCubic(_)
                    | Pressure::PointTable(_),
                    friction,
                ) if !point.stays_closed => {
                    is_curved = true;
                    (friction, 0.0)
                }
                InterfaceLaw::Compliant(..) | InterfaceLaw::Asperity(_) => return Ok(None),
            };
            coefficients.push(friction.at(point.frame.speed).coefficient);
            yielding.push(soft);
        }
        let Compliance { of_normal, of_slip, of_load, spring, .. } = compliance;
        let unit = |i: usize, j: usize| if i == j { 1.0 } else { 0.0 };
        let opened = Mat::from_fn(count, count, |i, j| unit(i, j) - spring * of_normal[(i, j)]);
        let pressed = Mat::from_fn(count, count, |i, j| {
            of_normal[(i, j)] + of_slip[(i, j)] * coefficients[j] + opened[(i, j)] * yielding[j]
        });
        let gaps = |i: usize| (0..count).map(|j| opened[(i, j)] * points[j].point.gap).sum::<f64>();
        let right = (0..count).map(|i| of_load[i] + gaps(i)).collect();
        let is_held = match rigid_motions(&assembly.stiffness, assembly) {
            Ok(motions) => motions == 0,
            // of bodies without any stiffness
            Err(AssemblyError::Structure(StructureError::Singular { .. })) => false,
            Err(error) => return Err(error),
        };
        let parts = || {
            let mut normal = of_normal.clone();
            solve(opened.clone(), &mut normal)?;
            (0..count).for_each(|k| normal[(k, k)] += yielding[k]);
            let growing = GrowingFriction::of(points);
            let friction = |i: usize, j: usize| of_slip[(i, j)] * growing.coefficient(coefficients[j]);
            let mut friction = Mat::from_fn(count, count, friction);
            solve(opened.clone(), &mut friction)?;
            Some([normal, friction])
        };
        let parts = if is_held { parts() } else { None };
        let bound = points.iter().map(|point| point.stays_closed).collect();
        Ok(Some(Self { opened, pressed, right, bound, is_held: parts.is_some(), is_curved, parts }))
    }

    /// The points that may open.
    pub(super) fn free(&self) -> Vec<usize> {
        (0..self.bound.len()).filter(|k| !self.bound[*k]).collect()
    }

    /// The points that stay closed.
    pub(super) fn bound(&self) -> Vec<usize> {
        (0..self.bound.len()).filter(|k| self.bound[*k]).collect()
    }

    /// The columns of the forces of closed points and the gaps of open ones.
    fn basis(&self, is_closed: &dyn Fn(usize) -> bool) -> Mat<f64> {
        let count = self.right.len();
        Mat::from_fn(
            count,
            count,
            |i, j| if is_closed(j) { -self.pressed[(i, j)] } else { self.opened[(i, j)] },
        )
    }

    /// The problem seen from a state.
    pub(super) fn pivoted(&self, steady: &SteadySliding) -> Option<Pivoted> {
        let free = self.free();
        let is_closed = |k: usize| self.bound[k] || steady.points[k].is_closed;
        let basis = self.basis(&is_closed);
        let mut others = Mat::from_fn(self.right.len(), free.len() + 1, |i, column| match free.get(column) {
            // −(M w − Q N) of what is zero, gaps of closed points and forces of open ones
            Some(&j) if is_closed(j) => -self.opened[(i, j)],
            Some(&j) => self.pressed[(i, j)],
            None => self.right[i],
        });
        solve(basis, &mut others)?;
        let diagonal: Vec<f64> = (0..free.len()).map(|k| others[(free[k], k)]).collect();
        if diagonal.iter().any(|own| *own < 0.0) {
            // of P-matrices it is positive; without friction too
            return Some(Pivoted { matrix: Mat::from_fn(1, 1, |_, _| -1.0), is_decided: false });
        }
        let scale = |k: usize| if diagonal[k] > 0.0 { 1.0 / diagonal[k].sqrt() } else { 1.0 };
        let matrix = Mat::from_fn(free.len(), free.len(), |i, j| scale(i) * scale(j) * others[(free[i], j)]);
        let of_state = |k: usize| others[(k, free.len())].abs();
        let largest = |closed: bool| {
            free.iter().filter(|k| is_closed(**k) == closed).map(|k| of_state(*k)).fold(0.0, f64::max)
        };
        let (forces, gaps) = (largest(true), largest(false));
        let is_decided = free.iter().all(|k| of_state(*k) > NONE * if is_closed(*k) { forces } else { gaps });
        Some(Pivoted { matrix, is_decided })
    }

    /// The states that solve the problem, every set of closed points tried: what is closed, and all forces. Of those sets whose equations are singular none does under loads that are not made for it.
    pub(super) fn states(&self, steady: &SteadySliding) -> Vec<SetState> {
        let free = self.free();
        let most = steady.points.iter().map(|point| point.normal_force.abs()).fold(0.0, f64::max);
        let mut solutions: Vec<SetState> = Vec::new();
        for set in 0..1_usize << free.len() {
            let among =
                |k: usize| free.iter().position(|own| *own == k).is_some_and(|own| set >> own & 1 == 1);
            let is_closed = |k: usize| self.bound[k] || among(k);
            let mut solved = Mat::from_fn(self.right.len(), 1, |i, _| self.right[i]);
            if solve(self.basis(&is_closed), &mut solved).is_none() {
                continue;
            }
            let values: Vec<f64> = (0..self.right.len()).map(|k| solved[(k, 0)]).collect();
            let largest = |closed: bool| {
                let own = (0..values.len()).filter(|k| is_closed(*k) == closed);
                own.map(|k| values[k].abs()).fold(0.0, f64::max)
            };
            let (forces, gaps) = (largest(true), largest(false));
            let holds = |k: &usize| values[*k] >= -NONE * if is_closed(*k) { forces } else { gaps };
            if !free.iter().all(holds) || forces > SINGULAR * most || gaps > SINGULAR * self.size() {
                continue;
            }
            // a point that neither presses nor is open belongs to several sets
            let state = SetState {
                forces: (0..values.len()).map(|k| if is_closed(k) { values[k] } else { 0.0 }).collect(),
                closed: (0..values.len()).filter(|k| is_closed(*k)).collect(),
            };
            if !solutions.iter().any(|known| known.has_forces(&state.forces)) {
                solutions.push(state);
            }
        }
        solutions
    }

    /// What gaps are measured by, in m.
    fn size(&self) -> f64 {
        self.right.iter().map(|own| own.abs()).fold(f64::MIN_POSITIVE, f64::max)
    }
}

impl SetState {
    /// Whether its forces are these.
    pub(super) fn has_forces(&self, others: &[f64]) -> bool {
        let largest = self.forces.iter().map(|own| own.abs()).fold(0.0, f64::max);
        self.forces.len() == others.len()
            && self.forces.iter().zip(others).all(|(a, b)| (a - b).abs() <= SAME * largest)
    }
}

/// Whether the symmetric part is positive definite by so much; by less than nothing: semidefinite.
pub(super) fn is_definite(matrix: &Mat<f64>, by: f64) -> bool {
    let count = matrix.nrows();
    let half = |i: usize, j: usize| 0.5 * (matrix[(i, j)] + matrix[(j, i)]);
    let less = Mat::from_fn(count, count, |i, j| half(i, j) - if i == j { by } else { 0.0 });
    less.norm_max().is_finite() && negative_eigenvalues(&less) == Some(0)
}
