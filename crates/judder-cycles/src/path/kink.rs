//! Kinks of a path: where equations that are smooth by parts change from one part to the next, it may turn sharply.

use super::{ClosingEquation, Newton, Path, PathEquations, PathPoint, distance, weighted};
use crate::CyclesError;
use crate::crossing::between;
use std::collections::VecDeque;

/// A step that fails below it stands before a kink of the path.
pub(super) const KINK: f64 = 1e-4;

/// The solutions that a path came by last.
#[derive(Default)]
pub(super) struct Trail(VecDeque<PathPoint>);

impl Trail {
    /// A solution that the path leaves behind it.
    pub(super) fn left(&mut self, point: PathPoint) -> &PathPoint {
        /// Steps of a path shorten before a kink: what it came by before that is among so many.
        const REMEMBERED: usize = 32;
        if self.0.len() == REMEMBERED {
            self.0.pop_front();
        }
        self.0.push_back(point);
        &self.0[self.0.len() - 1]
    }

    /// Whether a path that has come here came by another solution, a step from here: it is the one that Newton's method finds between two of the trail that have its last unknown between them.
    fn leads_by<E: PathEquations>(
        &self,
        (other, step): (&PathPoint, f64),
        here: &PathPoint,
        newton: &mut Newton<'_>,
        equations: &mut E,
    ) -> Result<bool, CyclesError> {
        /// How near to each other two are one solution, of the step.
        const SAME: f64 = 1e-3;
        let last = other.at.len() - 1;
        let closing = ClosingEquation::fixed(last, other.at.len(), other.at[last]);
        for (from, to) in self.0.iter().zip(self.0.iter().skip(1).chain([here])) {
            let share = (other.at[last] - from.at[last]) / (to.at[last] - from.at[last]);
            if !(0.0..=1.0).contains(&share) {
                continue;
            }
            let guess = between([from, to], share, equations.weights());
            match newton.corrected(equations, &guess, &closing, &from.tangent) {
                Ok(found) if distance(&found.at, &other.at, equations.weights()) <= SAME * step => {
                    return Ok(true);
                }
                Err(CyclesError::Stopped) => return Err(CyclesError::Stopped),
                _ => {}
            }
        }
        Ok(false)
    }
}

impl Path {
    /// A solution beyond a kink that is just ahead: the path goes on along the tangent that the equations have behind it, one way or the other, but not back.
    pub(super) fn round_the_kink<E: PathEquations>(
        &self,
        newton: &mut Newton<'_>,
        equations: &mut E,
    ) -> Result<Option<(PathPoint, f64)>, CyclesError> {
        let PathPoint { at, tangent, .. } = &self.point;
        let first = newton.rule.steps[0];
        for ahead in [4.0, 40.0] {
            let beyond: Vec<f64> =
                at.iter().zip(tangent).map(|(own, t)| own + ahead * self.step * t).collect();
            let Ok(behind) = newton.tangent_at(equations, &beyond, tangent) else { continue };
            for step in [first, 0.1 * first, 0.01 * first, 10.0 * KINK] {
                for sign in [1.0, -1.0] {
                    let tangent = behind.iter().map(|own| sign * own).collect();
                    let there = PathPoint { tangent, ..self.point.clone() };
                    if let Ok(next) = self.tried((&there, step), newton, equations)
                        && !self.lies_behind(&next, &behind, equations.weights())
                        && !self.trail.leads_by((&next, step), &self.point, newton, equations)?
                    {
                        return Ok(Some((next, step)));
                    }
                }
            }
        }
        Ok(None)
    }

    /// Whether a path along the tangent of the next solution comes to solutions that it has come by, as where it turns by more than a right angle at a kink: it goes on the other way.
    pub(super) fn goes_back<E: PathEquations>(
        &self,
        next: &PathPoint,
        newton: &mut Newton<'_>,
        equations: &mut E,
    ) -> Result<bool, CyclesError> {
        /// As far as that it must not come by any, of the way to the next one, and in how many steps.
        const FAR: f64 = 8.0;
        const STEPS: usize = 24;
        let way = distance(&next.at, &self.point.at, equations.weights());
        let mut ahead = Self { point: next.clone(), step: way, trail: Trail::default(), ..*self };
        for _ in 0..STEPS {
            let further = match ahead.found(newton, equations) {
                Ok(further) => further,
                Err(CyclesError::Stopped) => return Err(CyclesError::Stopped),
                Err(_) => break,
            };
            let step = distance(&further.at, &ahead.point.at, equations.weights());
            if self.trail.leads_by((&further, step), &self.point, newton, equations)? {
                return Ok(true);
            }
            if distance(&further.at, &next.at, equations.weights()) > FAR * way {
                break;
            }
            ahead.point = further;
        }
        Ok(false)
    }

    /// Whether a solution lies on the line back, along which the path does not run as it does beyond the kink.
    fn lies_behind(&self, other: &PathPoint, beyond: &[f64], weights: &[f64]) -> bool {
        /// How far from the line back, of the way.
        const NARROW: f64 = 0.2;
        let off_line = |of: &[f64], line: &[f64]| {
            let (along, length) = (weighted(of, line, weights), weighted(of, of, weights));
            (length - along * along).max(0.0).sqrt()
        };
        let PathPoint { at, tangent, .. } = &self.point;
        let way: Vec<f64> = other.at.iter().zip(at).map(|(a, b)| a - b).collect();
        let is_back = weighted(&way, tangent, weights) < 0.0
            && off_line(&way, tangent) < NARROW * weighted(&way, &way, weights).sqrt();
        is_back && off_line(&other.tangent, beyond) >= 0.5 * off_line(&other.tangent, tangent)
    }
}
