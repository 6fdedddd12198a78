//! Steady sliding as friction grows from nothing, and where it ends.

use super::active_set::{FoundContacts, Guess, Solver};
use super::friction_limit::{GrowingFriction, LARGEST, Singular, singular_friction};
use crate::AssemblyError;
use crate::interface::InterfaceLaw;

/// Iterations that a state is given which begins at one with less friction.
const ITERATIONS: usize = 100;
/// Intervals that are looked at.
const STEPS: usize = 200;
/// The end is located to so much of the friction,
const PRECISION: f64 = 1e-9;
/// and to so much where there are too many points for their eigenvalues.
const COARSE: f64 = 1e-3;
/// Beside a limit of the closed points states are looked at with so much less friction, and more: nearer to it forces without bound leave few digits.
const BESIDE: f64 = 1e-3;

/// Steady sliding with the friction of `full`, followed from that without friction.
///
/// # Errors
/// [`AssemblyError::NoSteadySliding`] where it ends on the way, what the search without friction says.
pub(super) fn followed(full: &Solver<'_>) -> Result<FoundContacts, AssemblyError> {
    let frictionless = Solver { friction: 0.0, ..*full };
    let last = frictionless.solved()?;
    if !(0..full.points.len()).any(|k| frictionless.is_closed(k, &last.guess)) {
        return Err(frictionless.nothing_closes(&last.guess.opening, true));
    }
    let growing = GrowingFriction::of(full.points);
    let (force, limit) = (largest_force(&last), singular_friction(full, &last.guess, &growing));
    let mut following =
        FollowedFriction { full, growing, iterations: last.iterations, last, low: 0.0, limit };
    match following.tried(1.0) {
        Some(found) => Ok(found),
        None => Err(following.end(force)),
    }
}

/// A state with less friction than asked for.
struct FollowedFriction<'a> {
    full: &'a Solver<'a>,
    growing: GrowingFriction,
    last: FoundContacts,
    /// Its friction, by what all forces are multiplied.
    low: f64,
    /// The limit of the points that are closed there.
    limit: Singular,
    iterations: usize,
}

impl FollowedFriction<'_> {
    /// The state with so much friction, from the last one.
    fn tried(&mut self, friction: f64) -> Option<FoundContacts> {
        let solver = Solver { friction, ..*self.full };
        let found = solver.solved_from(self.last.guess.clone(), ITERATIONS).ok()?;
        self.iterations += found.iterations;
        Some(FoundContacts { iterations: self.iterations, ..found })
    }

    /// Goes on to a state with more friction.
    fn advance(&mut self, friction: f64, found: FoundContacts) {
        let closed = |guess: &Guess| {
            (0..self.full.points.len()).map(|k| self.full.is_closed(k, guess)).collect::<Vec<_>>()
        };
        let is_curved = self.full.points.iter().any(|point| !matches!(point.law, InterfaceLaw::Rigid(_)));
        if is_curved || closed(&found.guess) != closed(&self.last.guess) {
            self.limit = singular_friction(self.full, &found.guess, &self.growing);
        }
        (self.low, self.last) = (friction, found);
    }

    /// Where it ends, before friction is as large as asked for; `force` is what forces are measured by, in N.
    fn end(mut self, force: f64) -> AssemblyError {
        let full = self.full;
        let precision = if full.points.len() > LARGEST { COARSE } else { PRECISION };
        let mut high = 1.0;
        for _ in 0..STEPS {
            if high - self.low <= precision * high {
                break;
            }
            let middle = 0.5 * (self.low + high);
            match self.limit {
                Singular::At { size: factor, row: point } if factor > self.low && factor < high => {
                    let (less, more) = (factor * (1.0 - BESIDE), factor * (1.0 + BESIDE));
                    let reaches = less <= self.low
                        || self.tried(less).is_some_and(|own| own.guess.closed == self.last.guess.closed);
                    match self.tried(more).filter(|_| more < high) {
                        Some(beyond) => self.advance(more, beyond),
                        None if reaches => return ends(full, factor, point, true),
                        None => self.halve(middle, &mut high),
                    }
                }
                _ => self.halve(middle, &mut high),
            }
        }
        match self.limit {
            Singular::At { size, row: point } if size < high * (1.0 + COARSE) => {
                ends(full, high, point, true)
            }
            _ => {
                let solver = Solver { friction: self.low, ..*full };
                ends(full, high, next_to_change(&solver, &self.last, force), false)
            }
        }
    }

    /// Looks at the middle of what is left.
    fn halve(&mut self, middle: f64, high: &mut f64) {
        match self.tried(middle) {
            Some(found) => self.advance(middle, found),
            None => *high = middle,
        }
    }
}

/// The largest normal force in N.
fn largest_force(found: &FoundContacts) -> f64 {
    found.carried.iter().map(|own| own.normal.abs()).fold(f64::MIN_POSITIVE, f64::max)
}

/// The point that is nearest to opening or closing: its force measured by this one, its gap by what openings are.
fn next_to_change(solver: &Solver<'_>, found: &FoundContacts, force: f64) -> usize {
    let (guess, points) = (&found.guess, solver.points);
    let size = solver.scale(&guess.opening);
    let share = |k: &usize| match solver.is_closed(*k, guess) {
        true => found.carried[*k].normal.abs() / force,
        false => (points[*k].point.gap + guess.opening[*k]).abs() / size,
    };
    let free = (0..points.len()).filter(|k| !points[*k].stays_closed);
    free.min_by(|a, b| share(a).total_cmp(&share(b))).unwrap_or(0)
}

/// That steady sliding ends with so much friction at a point.
fn ends(full: &Solver<'_>, factor: f64, point: usize, digs_in: bool) -> AssemblyError {
    let framed = &full.points[point];
    let coefficient = match framed.law {
        InterfaceLaw::Rigid(friction) | InterfaceLaw::Compliant(_, friction) => {
            Some(factor * friction.at(framed.frame.speed).coefficient)
        }
        InterfaceLaw::Asperity(_) => None,
    };
    let before = full.points[..point].iter().filter(|own| own.interface == framed.interface);
    AssemblyError::NoSteadySliding {
        factor,
        coefficient,
        interface: full.interface_of(point),
        point: before.count(),
        place: framed.point.place,
        digs_in,
    }
}
