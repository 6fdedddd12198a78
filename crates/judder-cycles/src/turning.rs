//! Where paths turn, and where others may branch off.

use crate::CyclesError;
use crate::path::{ClosingEquation, Newton, PathEquations, PathPoint};

/// The solutions at which values along a path go back by more than `least`, and whether they rose to them; at first they do as told.
pub(crate) fn turns(values: &[f64], mut rises: bool, least: f64) -> Vec<(usize, bool)> {
    let (mut turns, mut farthest) = (Vec::new(), 0);
    for k in 1..values.len() {
        let ahead = values[k] - values[farthest];
        let ahead = if rises { ahead } else { -ahead };
        if ahead >= 0.0 {
            farthest = k;
        } else if -ahead > least {
            if farthest > 0 {
                turns.push((farthest, rises));
            }
            (rises, farthest) = (!rises, k);
        }
    }
    turns
}

/// The largest value of an unknown, or the smallest, on the branch through three places, by golden sections on planes across the line between the outer ones.
pub(crate) fn extreme<E: PathEquations>(
    equations: &mut E,
    newton: &mut Newton<'_>,
    [first, amid, last]: [&[f64]; 3],
    (unknown, largest): (usize, bool),
) -> Result<f64, CyclesError> {
    /// Sections: a thousandth of the way is left.
    const SECTIONS: usize = 14;
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    let sign = if largest { 1.0 } else { -1.0 };
    let way: Vec<f64> = last.iter().zip(first).map(|(a, b)| a - b).collect();
    let start = ClosingEquation::across(&way, equations.weights(), first);
    let end = ClosingEquation::across(&way, equations.weights(), last).value;
    let place = |share: f64| start.value + share * (end - start.value);
    let own = ClosingEquation::across(&way, equations.weights(), amid).value;
    let own = (own - start.value) / (end - start.value);
    let mut at = |share: f64| -> Result<f64, CyclesError> {
        let (from, to, part) = match share < own {
            true => (first, amid, share / own),
            false => (amid, last, (share - own) / (1.0 - own)),
        };
        let guess: Vec<f64> = from.iter().zip(to).map(|(a, b)| a + part * (b - a)).collect();
        let closing = ClosingEquation { value: place(share), ..start.clone() };
        match newton.corrected(equations, &guess, &closing, &way) {
            Ok(found) => Ok(sign * found.at[unknown]),
            Err(CyclesError::Stopped) => Err(CyclesError::Stopped),
            Err(_) => Ok(f64::NEG_INFINITY),
        }
    };
    let mut farthest = sign * amid[unknown];
    let mut between = [0.0, 1.0];
    let mut tried = [(1.0 - GOLDEN, at(1.0 - GOLDEN)?), (GOLDEN, at(GOLDEN)?)];
    for _ in 0..SECTIONS {
        farthest = farthest.max(tried[0].1).max(tried[1].1);
        if tried[0].1 > tried[1].1 {
            between[1] = tried[1].0;
            let share = between[1] - GOLDEN * (between[1] - between[0]);
            tried = [(share, at(share)?), tried[0]];
        } else {
            between[0] = tried[0].0;
            let share = between[0] + GOLDEN * (between[1] - between[0]);
            tried = [tried[1], (share, at(share)?)];
        }
    }
    Ok(sign * farthest)
}

/// The closest two solutions between two others across which the determinant of the equations under the tangent changes its sign, by halves on planes across the line between them.
pub(crate) fn sign_change<E: PathEquations>(
    equations: &mut E,
    newton: &mut Newton<'_>,
    [before, after]: [&PathPoint; 2],
) -> Result<[PathPoint; 2], CyclesError> {
    /// Halves: a thousandth of the way is left.
    const HALVES: usize = 10;
    let (mut low, mut high) = (before.clone(), after.clone());
    for _ in 0..HALVES {
        let guess: Vec<f64> = low.at.iter().zip(&high.at).map(|(a, b)| 0.5 * (a + b)).collect();
        let chord: Vec<f64> = low.at.iter().zip(&high.at).map(|(a, b)| b - a).collect();
        let closing = ClosingEquation::across(&chord, equations.weights(), &guess);
        match newton.corrected(equations, &guess, &closing, &chord) {
            Ok(between) if between.orientation == low.orientation => low = between,
            Ok(between) => high = between,
            Err(CyclesError::Stopped) => return Err(CyclesError::Stopped),
            Err(_) => break,
        }
    }
    Ok([low, high])
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::path::{PathRule, follow};
    use faer::MatMut;

    /// f(x, p) = 0 with its derivatives.
    struct OneEquation {
        of: fn(f64, f64) -> [f64; 3],
        residual: [f64; 1],
    }

    impl PathEquations for OneEquation {
        fn residual(&mut self, at: &[f64]) -> Result<&[f64], CyclesError> {
            self.residual = [(self.of)(at[0], at[1])[0]];
            Ok(&self.residual)
        }

        fn derivative(&mut self, at: &[f64], mut out: MatMut<'_, f64>) -> Result<(), CyclesError> {
            let [_, by_x, by_p] = (self.of)(at[0], at[1]);
            (out[(0, 0)], out[(0, 1)]) = (by_x, by_p);
            Ok(())
        }

        fn weights(&self) -> &[f64] {
            &[1.0, 1.0]
        }

        fn is_sought(&mut self, _: &[f64]) -> Result<bool, CyclesError> {
            Ok(true)
        }

        fn accept(&mut self, _: &[f64]) -> Result<(), CyclesError> {
            Ok(())
        }
    }

    /// The parameters of the solutions from a place on, and where the determinant changes its sign.
    fn followed(of: fn(f64, f64) -> [f64; 3], start: [f64; 2], towards: [f64; 2]) -> (Vec<f64>, Vec<f64>) {
        let rule = PathRule { steps: [0.07, 0.07, 1e-6], ..PathRule::default() };
        let (mut newton, mut equations) = (Newton::new(rule, &|| true), OneEquation { of, residual: [0.0] });
        let closing = ClosingEquation::fixed(1, 2, start[1]);
        let first = newton.corrected(&mut equations, &start, &closing, &towards).unwrap();
        let (mut all, mut changes) = (vec![first.at[1]], Vec::new());
        let end = follow(&mut newton, &mut equations, first, 40, |equations, newton, [before, next]| {
            if before.orientation != next.orientation {
                let [low, high] = sign_change(equations, newton, [before, next])?;
                changes.push(0.5 * (low.at[1] + high.at[1]));
            }
            all.push(next.at[1]);
            Ok((next.at[1].abs() > 1.2).then_some(()))
        });
        end.unwrap();
        (all, changes)
    }

    /// x³ = p x: along x = 0 another path crosses at p = 0; along p = x² none but that one, and the fold is there.
    #[test]
    fn a_path_that_crosses_changes_the_sign_and_one_that_turns_does_not() {
        let crossing = |x: f64, p: f64| [x * x * x - p * x, 3.0 * x * x - p, -x];
        let (_, changes) = followed(crossing, [0.0, -1.0], [0.0, 1.0]);
        let [at] = changes[..] else { panic!("{changes:?}") };
        assert!(at.abs() < 1e-4, "{at}");
        let parabola = |x: f64, p: f64| [x * x - p, 2.0 * x, -1.0];
        let (parameters, changes) = followed(parabola, [-1.0, 1.0], [1.0, -1.0]);
        assert!(changes.is_empty());
        let [(place, rose)] = turns(&parameters, false, 0.0)[..] else { panic!("{parameters:?}") };
        assert!(!rose && parameters[place] < 0.01);
        let rule = PathRule::default();
        let (mut newton, mut equations) =
            (Newton::new(rule, &|| true), OneEquation { of: parabola, residual: [0.0] });
        let near = [[-0.05, 0.0025], [0.02, 0.0004], [0.09, 0.0081]];
        let near = near.each_ref().map(<[f64; 2]>::as_slice);
        let turn = extreme(&mut equations, &mut newton, near, (1, false)).unwrap();
        assert!((0.0..1e-8).contains(&turn), "{turn}");
    }

    #[test]
    fn less_than_what_is_not_looked_at_is_no_turn() {
        let values = [1.0, 1.21, 1.2475, 1.0];
        assert_eq!(turns(&values, true, 0.1), [(2, true)]);
        assert!(turns(&values, true, 0.3).is_empty());
    }
}
