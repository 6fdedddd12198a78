//! The force of a contact point as the projection of its force and motion on what the contact allows.
//!
//! With a force λ of a point and its motion y (the gap, and the velocity of the slider beside the track along the slip and across it) the set-valued laws
//! are λ = π(λ, y), for any ε_N, ε_T > 0:
//!
//! - rigid: π_N = max(0, λ_N − ε_N g); where it stays closed λ_N − ε_N g; compliant: π_N = N(−g);
//! - π_T = τ min(1, b/|τ|), τ = λ_T − ε_T v, b = μ(|v|) π_N: T = −b v/|v| where it slips, |T| ≤ b where it sticks.
//!
//! This is what the dynamic Lagrangians of S. Nacivet, C. Pierre, F. Thouverez, L. Jézéquel, J. Sound Vib. 265 (2003) come to, with forces as unknowns.

use judder_assembly::interface::{FramedPoint, InterfaceLaw};
use judder_nonsmooth::contact_problem::{PointMotion, length};

/// Components of a point: along the normal, along the slip, across it.
pub(crate) const COMPONENTS: usize = 3;

/// ε of a point: what its motions are multiplied by to be beside forces.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PointScales {
    /// ε_N in N/m.
    pub stiffness: f64,
    /// ε_T in N s/m.
    pub viscosity: f64,
}

/// π of a point at an instant, with its derivatives.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ProjectedForce {
    /// π in N.
    pub force: [f64; COMPONENTS],
    /// ∂π/∂λ, row after row.
    pub by_force: [[f64; COMPONENTS]; COMPONENTS],
    /// ∂π/∂y.
    pub by_motion: [[f64; COMPONENTS]; COMPONENTS],
    /// What the point does.
    pub state: PointMotion,
}

impl ProjectedForce {
    /// Whether nothing changes it: of a point that is open, and has no friction then.
    pub(crate) fn is_constant(&self) -> bool {
        let of_normal = || self.by_force[0].iter().chain(&self.by_motion[0]);
        self.state == PointMotion::Open && of_normal().all(|own| *own == 0.0)
    }

    /// Its slopes grow by the sizes of another's: they are zero where those of all others are.
    pub(crate) fn add_sizes_of_slopes(&mut self, other: &Self) {
        let own = self.by_force.iter_mut().chain(&mut self.by_motion).flatten();
        own.zip(other.by_force.iter().chain(&other.by_motion).flatten())
            .for_each(|(own, other)| *own += other.abs());
    }
}

/// A force with its derivatives by λ and y.
#[derive(Debug, Clone, Copy, Default)]
struct Sided {
    value: f64,
    by_force: [f64; COMPONENTS],
    by_motion: [f64; COMPONENTS],
}

/// π of a point with the force λ in N and the motion y: the gap in m, slip velocities in m/s.
#[must_use]
pub fn projected(
    point: &FramedPoint<'_>,
    scales: PointScales,
    force: [f64; COMPONENTS],
    motion: [f64; COMPONENTS],
) -> ProjectedForce {
    let mut out = ProjectedForce::default();
    project(point, scales, [force, motion], &mut out);
    out
}

/// The same in place of what there is.
pub(crate) fn project(
    point: &FramedPoint<'_>,
    scales: PointScales,
    [force, motion]: [[f64; COMPONENTS]; 2],
    out: &mut ProjectedForce,
) {
    *out = ProjectedForce::default();
    let opens = match point.law {
        InterfaceLaw::Rigid(_) => force[0] - scales.stiffness * motion[0] <= 0.0,
        InterfaceLaw::Compliant(..) => motion[0] >= 0.0,
        InterfaceLaw::Asperity(_) => false,
    };
    // what is open has neither forces nor slopes
    if opens && !point.stays_closed {
        return;
    }
    let speed = length([motion[1], motion[2]]);
    let direction = if speed > 0.0 { [motion[1] / speed, motion[2] / speed] } else { [0.0; 2] };
    let (normal, bound) = normal_and_bound(point, scales, [force, motion], speed, direction);
    set(out, 0, normal);
    // without friction there is nothing to project on
    let slides_freely = bound.value == 0.0 && bound.by_motion == [0.0; COMPONENTS];
    out.state = match normal.value > 0.0 {
        true if slides_freely => PointMotion::Slip,
        true => friction(out, scales, [force, motion], bound),
        false => PointMotion::Open,
    };
}

fn set(out: &mut ProjectedForce, component: usize, own: Sided) {
    out.force[component] = own.value;
    out.by_force[component] = own.by_force;
    out.by_motion[component] = own.by_motion;
}

/// π_N, and b where it presses.
fn normal_and_bound(
    point: &FramedPoint<'_>,
    scales: PointScales,
    [force, motion]: [[f64; COMPONENTS]; 2],
    speed: f64,
    direction: [f64; 2],
) -> (Sided, Sided) {
    let by_speed = |slope: f64| [0.0, slope * direction[0], slope * direction[1]];
    let normal = match point.law {
        InterfaceLaw::Rigid(_) => {
            let tried = force[0] - scales.stiffness * motion[0];
            match tried > 0.0 || point.stays_closed {
                true => Sided {
                    value: tried,
                    by_force: [1.0, 0.0, 0.0],
                    by_motion: [-scales.stiffness, 0.0, 0.0],
                },
                false => Sided::default(),
            }
        }
        InterfaceLaw::Compliant(..) | InterfaceLaw::Asperity(_) => {
            let own = point.law.forces(point.point.area, -motion[0], speed, point.stays_closed).normal;
            let mut by_motion = by_speed(own.by_speed);
            by_motion[0] = -own.by_closure;
            Sided { value: own.value, by_force: [0.0; COMPONENTS], by_motion }
        }
    };
    let bound = match point.law {
        InterfaceLaw::Rigid(law) | InterfaceLaw::Compliant(_, law) => {
            let at = law.at(speed);
            let own = by_speed(at.slope * normal.value);
            Sided {
                value: at.coefficient * normal.value,
                by_force: normal.by_force.map(|part| at.coefficient * part),
                by_motion: std::array::from_fn(|k| at.coefficient * normal.by_motion[k] + own[k]),
            }
        }
        InterfaceLaw::Asperity(law) => {
            let own = law.forces(-motion[0], speed).friction;
            let mut by_motion = by_speed(own.by_speed);
            by_motion[0] = -own.by_closure;
            Sided { value: own.value, by_force: [0.0; COMPONENTS], by_motion }
        }
    };
    (normal, bound)
}

/// π_T of a point that presses.
fn friction(
    out: &mut ProjectedForce,
    scales: PointScales,
    [force, motion]: [[f64; COMPONENTS]; 2],
    bound: Sided,
) -> PointMotion {
    let tried = [1, 2].map(|k| force[k] - scales.viscosity * motion[k]);
    let size = length(tried);
    if size <= bound.value {
        for k in [1, 2] {
            out.force[k] = tried[k - 1];
            out.by_force[k][k] = 1.0;
            out.by_motion[k][k] = -scales.viscosity;
        }
        return PointMotion::Stick;
    }
    let along = tried.map(|part| part / size);
    let share = bound.value / size;
    for (k, own) in along.into_iter().enumerate() {
        let row = k + 1;
        out.force[row] = bound.value * own;
        for column in 0..COMPONENTS {
            out.by_force[row][column] = own * bound.by_force[column];
            out.by_motion[row][column] = own * bound.by_motion[column];
        }
        for (j, other) in along.into_iter().enumerate() {
            // the direction of τ turns
            let turned = share * (f64::from(u8::from(k == j)) - own * other);
            out.by_force[row][j + 1] += turned;
            out.by_motion[row][j + 1] -= scales.viscosity * turned;
        }
    }
    PointMotion::Slip
}
