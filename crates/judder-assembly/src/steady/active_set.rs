//! Which points are closed, and what they carry: a primal–dual active set on the contact points.

use crate::AssemblyError;
use crate::assembly::Assembly;
use crate::compliance::{Compliance, rigid_motions};
use crate::interface::{FramedPoint, InterfaceLaw};
use faer::Mat;
use judder_dense::general::solve;
use std::collections::BTreeSet;

/// Opening, normal force and friction force of a point, each affine in its one unknown z.
#[derive(Clone, Copy)]
pub(super) struct AffinePoint {
    pub(super) opening: Affine,
    pub(super) normal: Affine,
    pub(super) friction: Affine,
}

/// slope z + offset.
#[derive(Clone, Copy)]
pub(super) struct Affine {
    pub(super) slope: f64,
    pub(super) offset: f64,
}

impl Affine {
    const ZERO: Self = Self { slope: 0.0, offset: 0.0 };
    const UNKNOWN: Self = Self { slope: 1.0, offset: 0.0 };

    fn at(self, z: f64) -> f64 {
        self.slope * z + self.offset
    }

    fn scaled(self, factor: f64) -> Self {
        Self { slope: factor * self.slope, offset: factor * self.offset }
    }
}

/// Which rigid points are closed, and how far each point is opened: y in m.
#[derive(Clone)]
pub(super) struct Guess {
    pub(super) closed: Vec<bool>,
    pub(super) opening: Vec<f64>,
}

/// N and T of a point, in N.
#[derive(Clone, Copy)]
pub(super) struct Carried {
    pub(super) normal: f64,
    pub(super) friction: f64,
}

/// What was found, and how many systems it took.
pub(super) struct FoundContacts {
    pub(super) guess: Guess,
    pub(super) carried: Vec<Carried>,
    pub(super) iterations: usize,
}

/// Sets that are tried before points change one at a time.
const FREE_ITERATIONS: usize = 40;
/// Iterations altogether: so many, and so many more a point.
const ITERATIONS: usize = 200;
/// Closures this near to their equations, by the largest of them, are theirs.
const CONVERGED: f64 = 1e-12;
/// By how much the logarithm of a depth changes at most in one step.
const LARGEST_STEP: f64 = 3.0;
/// No asperity is as little deep, m.
const NO_DEPTH: f64 = 1e-30;

#[derive(Clone, Copy)]
pub(super) struct Solver<'a> {
    pub(super) assembly: &'a Assembly,
    pub(super) compliance: &'a Compliance,
    pub(super) points: &'a [FramedPoint<'a>],
    /// By what all friction forces are multiplied.
    pub(super) friction: f64,
}

/// The openings with which the equations had a solution last.
///
/// From a piece on which a law is soft a step of Newton's method may lead beyond where points lift off, and nothing holds the bodies there.
#[derive(Default)]
struct HeldBefore {
    opening: Option<Vec<f64>>,
    halvings: usize,
}

impl HeldBefore {
    /// Takes back half of the step from there, and whether it does: where loads lift bodies off it would do so for ever.
    fn halve(&mut self, guess: &mut Guess) -> bool {
        const MOST: usize = 60;
        let Some(before) = &self.opening else { return false };
        self.halvings += 1;
        let is_worth_it = self.halvings <= MOST;
        if is_worth_it {
            guess.opening.iter_mut().zip(before).for_each(|(own, before)| *own = 0.5 * (*own + before));
        }
        is_worth_it
    }
}

impl Solver<'_> {
    /// The closed points with their openings, the forces, and how many systems it took.
    pub(super) fn solved(&self) -> Result<FoundContacts, AssemblyError> {
        let of_load = &self.compliance.of_load;
        let touches = |k: usize| {
            let point = &self.points[k];
            matches!(point.law, InterfaceLaw::Rigid(_))
                && (point.stays_closed || of_load[k] + point.point.gap <= 0.0)
        };
        let guess = Guess { closed: (0..self.points.len()).map(touches).collect(), opening: of_load.clone() };
        self.solved_from(guess, ITERATIONS + 10 * self.points.len())
    }

    /// The same from a guess, in so many iterations.
    pub(super) fn solved_from(&self, mut guess: Guess, limit: usize) -> Result<FoundContacts, AssemblyError> {
        let of_load = &self.compliance.of_load;
        let mut seen = BTreeSet::new();
        let mut one_at_a_time = false;
        let (mut residual, mut changing) = (f64::INFINITY, 0);
        let mut last = 0;
        let (mut was_brought_together, mut has_settled) = (false, false);
        let is_curved = self.points.iter().any(|point| point.law.is_curved());
        let mut held = HeldBefore::default();
        for iteration in 1..=limit {
            let mut affine: Vec<AffinePoint> =
                (0..self.points.len()).map(|k| self.affine(k, &guess)).collect();
            let is_held = self.is_held(&affine)?;
            if !is_held && held.halve(&mut guess) {
                continue;
            }
            if !is_held {
                // springs say whether loads bring any point nearer, and which comes first; where that does not press, none does
                let comes_nearer = of_load.iter().any(|opening| *opening < 0.0);
                if std::mem::replace(&mut was_brought_together, true) || !comes_nearer {
                    return Err(self.nothing_closes(of_load, false));
                }
                let first = self.bring_together(&mut guess);
                affine[first] = self.affine(first, &guess);
            }
            let unknowns = match self.unknowns(&affine, &guess) {
                Err(AssemblyError::Undetermined { .. }) if held.halve(&mut guess) => continue,
                unknowns => unknowns?,
            };
            held.opening = Some(guess.opening.clone());
            let opening: Vec<f64> = (0..self.points.len())
                .map(|k| self.opened(k, &guess, affine[k].opening.at(unknowns[k])))
                .collect();
            let normal: Vec<f64> = affine.iter().zip(&unknowns).map(|(a, z)| a.normal.at(*z)).collect();
            let mut changes: Vec<usize> = (0..self.points.len())
                .filter(|k| self.changes(*k, &guess, opening[*k], normal[*k]))
                .collect();
            let carried: Vec<Carried> =
                (0..self.points.len()).map(|k| self.forces(k, opening[k], unknowns[k], affine[k])).collect();
            let off = self.off(&opening, &carried);
            residual = off.iter().copied().fold(0.0, f64::max);
            let farthest = |best: usize, k: usize| if off[k] > off[best] { k } else { best };
            last = changes.first().copied().unwrap_or_else(|| (0..off.len()).fold(0, farthest));
            (guess.opening, changing) = (opening, changes.len());
            let settles = changes.is_empty() && residual <= CONVERGED * self.scale(&guess.opening);
            // of a law that is curved one step more has all digits
            if settles && (has_settled || !is_curved) {
                return Ok(FoundContacts { guess, carried, iterations: iteration });
            }
            has_settled = settles;
            // a set that was there before would come again
            one_at_a_time |=
                iteration > FREE_ITERATIONS || (!changes.is_empty() && !seen.insert(guess.closed.clone()));
            changes.truncate(if one_at_a_time { 1 } else { changes.len() });
            for k in changes {
                guess.closed[k] = !guess.closed[k];
            }
        }
        let interface = self.interface_of(last);
        let (points, place) = (self.points.len(), self.points[last].point.place);
        Err(AssemblyError::NoConvergence { iterations: limit, changing, points, residual, interface, place })
    }

    /// The name of a point's interface.
    pub(super) fn interface_of(&self, k: usize) -> String {
        self.assembly.interfaces[self.points[k].interface].name.clone()
    }

    /// That all points are open, by that which comes nearest where they are opened so far; `is_held` where something else than contacts holds the bodies.
    pub(super) fn nothing_closes(&self, opening: &[f64], is_held: bool) -> AssemblyError {
        let gap = |k: &usize| self.points[*k].point.gap + opening[*k];
        let nearest = (0..self.points.len()).min_by(|a, b| gap(a).total_cmp(&gap(b))).unwrap_or(0);
        let point = self.points[nearest].point;
        AssemblyError::NothingCloses {
            interface: self.interface_of(nearest),
            place: point.place,
            gap: point.gap,
            normal: point.normal,
            opened: opening[nearest],
            is_held,
        }
    }

    /// Whether a contact carries a force, or something else holds the bodies.
    fn is_held(&self, affine: &[AffinePoint]) -> Result<bool, AssemblyError> {
        let carries = |point: &AffinePoint| point.normal.slope != 0.0;
        Ok(affine.iter().any(carries) || rigid_motions(&self.assembly.stiffness, self.assembly)? == 0)
    }

    /// Closes the point whose gap is smallest where springs hold the bodies, and says which.
    fn bring_together(&self, guess: &mut Guess) -> usize {
        let of_load = &self.compliance.of_load;
        let gap = |k: &usize| self.points[*k].point.gap + of_load[*k];
        let first = (0..self.points.len()).min_by(|a, b| gap(a).total_cmp(&gap(b))).unwrap_or(0);
        guess.closed[first] = matches!(self.points[first].law, InterfaceLaw::Rigid(_));
        // a compliant one by as much as the springs yield
        guess.opening[first] = -self.points[first].point.gap - of_load[first].abs();
        first
    }

    /// How a point's opening and forces follow from its unknown: the force of a rigid one that is closed, the opening of any other.
    pub(super) fn affine(&self, k: usize, guess: &Guess) -> AffinePoint {
        let point = &self.points[k];
        if let InterfaceLaw::Rigid(friction) = point.law {
            let coefficient = self.friction * friction.at(point.frame.speed).coefficient;
            return match guess.closed[k] {
                true => AffinePoint {
                    opening: Affine { slope: 0.0, offset: -point.point.gap },
                    normal: Affine::UNKNOWN,
                    friction: Affine::UNKNOWN.scaled(coefficient),
                },
                false => {
                    AffinePoint { opening: Affine::UNKNOWN, normal: Affine::ZERO, friction: Affine::ZERO }
                }
            };
        }
        let opening = guess.opening[k];
        let forces = point.forces_at(opening);
        // d = −(g₀ + y)
        let tangent =
            |value: f64, by_closure: f64| Affine { slope: -by_closure, offset: value + by_closure * opening };
        AffinePoint {
            opening: Affine::UNKNOWN,
            normal: tangent(forces.normal.value, forces.normal.by_closure),
            friction: tangent(forces.friction.value, forces.friction.by_closure).scaled(self.friction),
        }
    }

    /// The opening of a point after a step of Newton's method that leads to `linear`.
    ///
    /// The force of an asperity rises with a power of its depth, which spans decades: its step is one in the logarithm of the depth,
    /// from which powers look convex, so that it comes down to its root and never leaves the contact on the way.
    fn opened(&self, k: usize, guess: &Guess, linear: f64) -> f64 {
        let point = &self.points[k];
        let depth = -(point.point.gap + guess.opening[k]);
        let wanted = -(point.point.gap + linear);
        let is_open = depth <= 0.0 || (depth < NO_DEPTH && wanted <= 0.0);
        if is_open || !matches!(point.law, InterfaceLaw::Asperity(_)) {
            return linear;
        }
        let step = (wanted / depth - 1.0).clamp(-LARGEST_STEP, LARGEST_STEP);
        -(point.point.gap + depth * libm::exp(step))
    }

    /// z of all points: y − S_nn (N + s y) − S_nt T = y_f.
    fn unknowns(&self, affine: &[AffinePoint], guess: &Guess) -> Result<Vec<f64>, AssemblyError> {
        let Compliance { of_normal, of_slip, of_load, spring, .. } = self.compliance;
        let count = affine.len();
        let normal: Vec<Affine> = affine
            .iter()
            .map(|a| Affine {
                slope: a.normal.slope + spring * a.opening.slope,
                offset: a.normal.offset + spring * a.opening.offset,
            })
            .collect();
        let matrix = Mat::from_fn(count, count, |i, j| {
            let own = if i == j { affine[j].opening.slope } else { 0.0 };
            own - of_normal[(i, j)] * normal[j].slope - of_slip[(i, j)] * affine[j].friction.slope
        });
        let offsets: (Vec<f64>, Vec<f64>) =
            normal.iter().zip(affine).map(|(normal, a)| (normal.offset, a.friction.offset)).unzip();
        let moved = self.moved(&offsets.0, &offsets.1);
        let mut right = Mat::from_fn(count, 1, |i, _| of_load[i] - affine[i].opening.offset + moved[i]);
        let closed = (0..count).filter(|k| self.is_closed(*k, guess)).count();
        solve(matrix, &mut right).ok_or(AssemblyError::Undetermined { closed, open: count - closed })?;
        Ok((0..count).map(|k| right[(k, 0)]).collect())
    }

    /// Whether a rigid point should be closed where it is open, or open where it is closed.
    fn changes(&self, k: usize, guess: &Guess, opening: f64, normal: f64) -> bool {
        let point = &self.points[k];
        let is_bound = point.stays_closed || !matches!(point.law, InterfaceLaw::Rigid(_));
        !is_bound && if guess.closed[k] { normal < 0.0 } else { point.point.gap + opening < 0.0 }
    }

    /// Whether a point carries a force.
    pub(super) fn is_closed(&self, k: usize, guess: &Guess) -> bool {
        let point = &self.points[k];
        match point.law {
            InterfaceLaw::Rigid(_) => guess.closed[k],
            _ => point.stays_closed || point.forces_at(guess.opening[k]).normal.value > 0.0,
        }
    }

    /// N and T of a point; of a compliant one what its law says, not the tangent.
    fn forces(&self, k: usize, opening: f64, unknown: f64, affine: AffinePoint) -> Carried {
        match self.points[k].law {
            InterfaceLaw::Rigid(_) => {
                Carried { normal: affine.normal.at(unknown), friction: affine.friction.at(unknown) }
            }
            _ => {
                let forces = self.points[k].forces_at(opening);
                Carried { normal: forces.normal.value, friction: self.friction * forces.friction.value }
            }
        }
    }

    /// How far the equations of each point are off, in m.
    fn off(&self, opening: &[f64], carried: &[Carried]) -> Vec<f64> {
        let Compliance { of_load, spring, .. } = self.compliance;
        let forces: (Vec<f64>, Vec<f64>) =
            carried.iter().zip(opening).map(|(own, y)| (own.normal + spring * y, own.friction)).unzip();
        let moved = self.moved(&forces.0, &forces.1);
        (0..opening.len()).map(|i| (opening[i] - of_load[i] - moved[i]).abs()).collect()
    }

    /// S_nn N + S_nt T, column by column as they lie in memory.
    fn moved(&self, normal: &[f64], friction: &[f64]) -> Vec<f64> {
        let Compliance { of_normal, of_slip, .. } = self.compliance;
        let mut moved = vec![0.0; normal.len()];
        for (j, (normal, friction)) in normal.iter().zip(friction).enumerate() {
            let (of_normal, of_slip) = (of_normal.col(j), of_slip.col(j));
            for (i, moved) in moved.iter_mut().enumerate() {
                *moved += of_normal[i] * normal + of_slip[i] * friction;
            }
        }
        moved
    }

    /// What openings are measured by, in m: with the springs the forces of all points move each.
    pub(super) fn scale(&self, opening: &[f64]) -> f64 {
        let all = opening.iter().chain(&self.compliance.of_load).map(|y| y.abs());
        all.chain(self.points.iter().map(|point| point.point.gap.abs())).fold(f64::MIN_POSITIVE, f64::max)
    }
}
