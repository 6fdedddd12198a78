//! Lines through rows of tables: only neighbours that belong together are joined, whatever a table holds one after the other.

#![deny(clippy::indexing_slicing, reason = "stored arrays may be of any length")]

/// A line through points: abscissae and ordinates, of which a NaN is a gap.
pub type Curve = (Vec<f64>, Vec<f64>);

/// A line through neighbouring rows, with a gap wherever `joins(k)` does not say that row k + 1 goes on from row k. Rows that go on from none
/// and from which none goes on are left out.
pub fn through(x: &[f64], y: &[f64], joins: impl Fn(usize) -> bool) -> Curve {
    let mut runs: Vec<Curve> = Vec::new();
    let mut is_open = false;
    let rows = x.iter().zip(y);
    for (row, ((x, y), (next_x, next_y))) in rows.clone().zip(rows.skip(1)).enumerate() {
        let goes_on = joins(row);
        if goes_on && !is_open {
            runs.push((vec![*x], vec![*y]));
        }
        if let Some((across, up)) = runs.last_mut().filter(|_| goes_on) {
            across.push(*next_x);
            up.push(*next_y);
        }
        is_open = goes_on;
    }
    apart(runs)
}

/// A line through some of the rows, in their order: a gap stays one where the rows that have no place are among those left out.
pub fn thinned(x: &[f64], y: &[f64], shown: &[usize]) -> Curve {
    let place = |row: usize| x.get(row).copied().zip(y.get(row).copied());
    let is_whole = |row: usize| place(row).is_some_and(|(x, y)| x.is_finite() && y.is_finite());
    let mut runs: Vec<Curve> = Vec::new();
    let mut last = None;
    for row in shown {
        let Some((x, y)) = place(*row) else { continue };
        let goes_on = last.is_some_and(|last| (last..=*row).all(is_whole));
        match runs.last_mut().filter(|_| goes_on) {
            Some((across, up)) => {
                across.push(x);
                up.push(y);
            }
            None => runs.push((vec![x], vec![y])),
        }
        last = Some(*row);
    }
    apart(runs)
}

/// Lines one after the other as one, with a gap after each.
pub fn apart(lines: impl IntoIterator<Item = Curve>) -> Curve {
    let mut all = Curve::default();
    for (x, y) in lines {
        all.0.extend(x.into_iter().chain([f64::NAN]));
        all.1.extend(y.into_iter().chain([f64::NAN]));
    }
    all
}

/// The points of a line that are joined to none, which the line itself does not show.
pub fn alone(x: &[f64], y: &[f64]) -> Curve {
    let is_point =
        |k: usize| x.get(k).is_some_and(|x| x.is_finite()) && y.get(k).is_some_and(|y| y.is_finite());
    let is_alone = |k: &usize| is_point(*k) && (*k == 0 || !is_point(k - 1)) && !is_point(k + 1);
    x.iter().zip(y).enumerate().filter(|(k, _)| is_alone(k)).map(|(_, (x, y))| (*x, *y)).unzip()
}

#[cfg(test)]
mod tests {
    use super::*;

    const NAN: f64 = f64::NAN;

    /// NaN as `None`, so that curves can be compared.
    fn told((_, y): &Curve) -> Vec<Option<f64>> {
        y.iter().map(|y| y.is_finite().then_some(*y)).collect()
    }

    #[test]
    fn rows_of_two_branches_are_not_joined_whatever_lies_between() {
        // a branch that is wanted to its end, then one that begins unwanted
        let number = [0, 0, 1, 1, 1];
        let wanted = [true, true, false, true, true];
        let rows = [1.0, 2.0, 3.0, 4.0, 5.0];
        let line = through(&rows, &rows, |k| number[k] == number[k + 1] && wanted[k] && wanted[k + 1]);
        assert_eq!(told(&line), [Some(1.0), Some(2.0), None, Some(4.0), Some(5.0), None]);
    }

    #[test]
    fn a_gap_between_two_rows_that_are_shown_stays_one() {
        let x = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0];
        let y = [0.0, 1.0, 2.0, NAN, 4.0, 5.0, 6.0];
        assert_eq!(
            told(&thinned(&x, &y, &[0, 2, 4, 6])),
            [Some(0.0), Some(2.0), None, Some(4.0), Some(6.0), None]
        );
    }

    #[test]
    fn points_that_are_joined_to_none_are_found() {
        let curve = (vec![0.0, 1.0, 2.0, 3.0, 4.0], vec![1.0, NAN, 2.0, 3.0, NAN]);
        assert_eq!(alone(&curve.0, &curve.1), (vec![0.0], vec![1.0]));
    }
}
