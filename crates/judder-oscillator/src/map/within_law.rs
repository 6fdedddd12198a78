//! Where over a map the errors of the contact law decide, not steady sliding.
//!
//! Looked at on a coarse grid. A cell of it whose corners are alike, and in which the map has one verdict, is taken to be like its corners; every
//! other is looked at point by point, and so is a neighbour whose edge then turns out not to be like its corners, until there is none. What
//! can be missed lies wholly inside a coarse cell.

use super::{DecisionMethod, OperatingPlane, StabilityMap, coarse_lines};
use crate::Contact;
use crate::equilibrium::equilibrium;
use crate::mechanism::StabilityClass;
use crate::within_law::WithinLaw;
use judder_numerics::parallel;

/// What the errors of the law leave of the verdict at a point; the number is that in stored results.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LawStanding {
    /// The law with its errors has one verdict, or the point has no steady sliding to judge.
    Decided = 0,
    /// It has others too.
    Marginal = 1,
    /// The errors of the law are not known there.
    Unknown = 2,
}

/// Codes of [`LawStanding`] of all points of a map, row by row; `None` where `interrupted` said so, which is asked at every point.
#[must_use]
pub fn within_law<P: OperatingPlane>(
    contact: &Contact,
    plane: &P,
    map: &StabilityMap,
    method: DecisionMethod,
    interrupted: &(dyn Fn() -> bool + Sync),
) -> Option<Vec<u8>> {
    let law = LawMap { contact, plane, map, codes: vec![None; map.classes.len()] };
    match method {
        _ if contact.law.is_formula() => Some(vec![LawStanding::Decided as u8; map.classes.len()]),
        DecisionMethod::EveryPoint => law.every_point(interrupted),
        // a line has no cells
        DecisionMethod::Adaptive if map.columns < 2 || map.rows < 2 => law.every_point(interrupted),
        DecisionMethod::Adaptive => law.adaptive(interrupted),
    }
}

struct LawMap<'a, P> {
    contact: &'a Contact,
    plane: &'a P,
    map: &'a StabilityMap,
    /// Of what was looked at.
    codes: Vec<Option<u8>>,
}

/// Columns and rows between two neighbouring lines of the coarse grid each, both among them.
#[derive(Clone, Copy)]
struct MapCell {
    columns: [usize; 2],
    rows: [usize; 2],
}

impl<P: OperatingPlane> LawMap<'_, P> {
    fn every_point(mut self, interrupted: &(dyn Fn() -> bool + Sync)) -> Option<Vec<u8>> {
        self.look_at(0..self.codes.len(), interrupted)?;
        self.codes.into_iter().collect()
    }

    fn adaptive(mut self, interrupted: &(dyn Fn() -> bool + Sync)) -> Option<Vec<u8>> {
        let (across, up) = (coarse_lines(self.map.columns), coarse_lines(self.map.rows));
        let columns = self.map.columns;
        let grid = up.iter().flat_map(|row| across.iter().map(move |column| row * columns + column));
        self.look_at(grid, interrupted)?;
        let between = |lines: &[usize]| lines.windows(2).map(|pair| [pair[0], pair[1]]).collect::<Vec<_>>();
        let across = between(&across);
        let cell = |rows: [usize; 2]| across.iter().map(move |columns| MapCell { columns: *columns, rows });
        let cells: Vec<MapCell> = between(&up).into_iter().flat_map(cell).collect();
        let (mut open, mut closed): (Vec<MapCell>, Vec<MapCell>) =
            cells.into_iter().partition(|cell| !self.has_one_verdict(cell) || !self.is_alike(cell));
        while !open.is_empty() {
            let points: Vec<usize> = open.iter().flat_map(|cell| cell.points(columns)).collect();
            self.look_at(points, interrupted)?;
            (closed, open) = closed.into_iter().partition(|cell| self.is_alike(cell));
        }
        for cell in closed {
            let code = self.codes[cell.first(columns)];
            for point in cell.points(columns) {
                self.codes[point] = self.codes[point].or(code);
            }
        }
        self.codes.into_iter().collect()
    }

    /// Looks at those of the points that were not looked at.
    fn look_at(
        &mut self,
        points: impl IntoIterator<Item = usize>,
        interrupted: &(dyn Fn() -> bool + Sync),
    ) -> Option<()> {
        let mut points: Vec<usize> =
            points.into_iter().filter(|point| self.codes[*point].is_none()).collect();
        points.sort_unstable();
        points.dedup();
        let code = |point: &usize| (!interrupted()).then(|| self.code(*point));
        let codes: Vec<u8> = parallel::each(&points, code).into_iter().collect::<Option<_>>()?;
        for (point, code) in points.into_iter().zip(codes) {
            self.codes[point] = Some(code);
        }
        Some(())
    }

    fn code(&self, point: usize) -> u8 {
        let (column, row) = (point % self.map.columns, point / self.map.columns);
        let standing = match self.map.class(column, row) {
            StabilityClass::Unresolved => LawStanding::Decided,
            _ => {
                let c = self.plane.coefficients(column, row);
                let within =
                    equilibrium(self.contact, &c).ok().and_then(|s| WithinLaw::new(self.contact, &c, &s));
                match within.map(|within| within.is_decided()) {
                    Some(true) => LawStanding::Decided,
                    Some(false) => LawStanding::Marginal,
                    None => LawStanding::Unknown,
                }
            }
        };
        standing as u8
    }

    /// Whether all points of a cell that were looked at are alike.
    fn is_alike(&self, cell: &MapCell) -> bool {
        let first = self.codes[cell.first(self.map.columns)];
        cell.points(self.map.columns).all(|point| self.codes[point].is_none_or(|code| Some(code) == first))
    }

    fn has_one_verdict(&self, cell: &MapCell) -> bool {
        let verdict = |point: usize| StabilityClass::from_code(self.map.classes[point]).verdict();
        let first = verdict(cell.first(self.map.columns));
        cell.points(self.map.columns).all(|point| verdict(point) == first)
    }
}

impl MapCell {
    fn first(&self, columns: usize) -> usize {
        self.rows[0] * columns + self.columns[0]
    }

    fn points(&self, columns: usize) -> impl Iterator<Item = usize> + use<> {
        let [left, right] = self.columns;
        let [bottom, top] = self.rows;
        (bottom..=top).flat_map(move |row| (left..=right).map(move |column| row * columns + column))
    }
}
