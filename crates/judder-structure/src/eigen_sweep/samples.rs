//! The points of a sweep that are solved in full to make a basis for the others.

use super::basis::SnapshotBasis;
use super::problem_family::ProblemFamily;
use super::projection::{Projected, Projection, snapshots};
use crate::StructureError;
use crate::complex_modes::{
    ComplexMode, ComplexModeSettings, Gap, Region, SearchedRegion, finished, left_by_residuals, searched,
};
use crate::quadratic::Quadratic;
use judder_memory::HeldMemory;
use judder_numerics::parallel;

/// Points solved in full, each with the region's surroundings.
pub(super) struct FullSamples<'a, F: ProblemFamily> {
    family: &'a F,
    points: Vec<&'a F::Point>,
    region: &'a Region,
    /// The coordinates of the points, and how much each changes over all of them.
    coordinates: Vec<Vec<f64>>,
    scales: Vec<f64>,
    /// The share of |λ| that the basis may leave open.
    tolerance: f64,
    /// What the samples hold together.
    memory: HeldMemory,
    /// By the order in which they were taken.
    taken: Vec<(usize, SearchedRegion)>,
    projection: Option<Projection<'a, F>>,
}

/// Samples to begin with.
const FIRST: usize = 3;
/// Samples at most: what a basis cannot carry by then is solved in full.
const LARGEST: usize = 12;
/// The samples' region is larger by this share of its sides: eigenvalues that a sweep brings in are known before they come.
const SURROUNDINGS: f64 = 0.1;

impl<'a, F: ProblemFamily> FullSamples<'a, F> {
    /// Takes samples, farthest from each other first, until the point farthest from all has its eigenvalues within the tolerance.
    pub(super) fn trained(
        family: &'a F,
        points: Vec<&'a F::Point>,
        region: &'a Region,
        tolerance: f64,
        memory: &HeldMemory,
    ) -> Result<Self, F::Error> {
        let coordinates: Vec<Vec<f64>> = points.iter().map(|point| family.coordinates(point)).collect();
        let order = farthest_first(&coordinates, LARGEST + 1);
        let scales = scales(&coordinates);
        let (taken, projection) = (Vec::new(), None);
        let memory = memory.clone();
        let mut samples =
            Self { family, points, region, coordinates, scales, tolerance, memory, taken, projection };
        let first = FIRST.min(order.len());
        samples.take(&order[..first])?;
        for next in &order[first..] {
            let Some(projection) = &samples.projection else { break };
            let point = samples.points[*next];
            let projected = samples.projected(projection, point, &family.at(point)?, region)?;
            let sufficient = projected.is_some_and(|of| of.0.within(tolerance));
            if samples.taken.len() == LARGEST || sufficient {
                break;
            }
            samples.take(&[*next])?;
        }
        Ok(samples)
    }

    /// Solves points in full and makes the basis anew.
    fn take(&mut self, numbers: &[usize]) -> Result<(), F::Error> {
        let wide = self.region.widened(SURROUNDINGS);
        let search = |number: &usize| {
            Ok::<_, F::Error>(searched(&self.family.at(self.points[*number])?, &wide, &self.memory)?)
        };
        let solved: Vec<SearchedRegion> = parallel::try_each(numbers, search)?;
        let before = self.projection.take().map(Projection::into_basis);
        let mut basis = Some(before.unwrap_or_else(|| SnapshotBasis::empty(self.tolerance)));
        for sample in solved.iter().filter(|sample| !sample.refined.is_empty()) {
            basis = basis.and_then(|basis| basis.extended(snapshots(sample)));
        }
        self.taken.extend(numbers.iter().copied().zip(solved));
        if let (Some(basis), Some((first, _))) = (basis, self.taken.first()) {
            self.projection = Projection::new(self.family, basis, &self.family.at(self.points[*first])?);
        }
        Ok(())
    }

    pub(super) fn projection(&self) -> Option<&Projection<'a, F>> {
        self.projection.as_ref()
    }

    /// The points that were taken.
    pub(super) fn points(&self) -> Vec<usize> {
        self.taken.iter().map(|(number, _)| *number).collect()
    }

    /// The sample at a point, where it is one.
    pub(super) fn of_point(&self, number: usize) -> Option<&(usize, SearchedRegion)> {
        self.taken.iter().find(|(taken, _)| *taken == number)
    }

    /// The modes of a sample in the region.
    pub(super) fn modes(
        &self,
        number: usize,
        sample: &SearchedRegion,
        settings: &ComplexModeSettings,
    ) -> Result<Vec<ComplexMode>, F::Error> {
        let problem = self.family.at(self.points[number])?;
        let left_open: Vec<f64> =
            sample.refined.iter().map(|refined| left_by_residuals(&problem, refined)).collect();
        Ok(finished(&problem, &sample.refined, &left_open, self.region, settings))
    }

    /// The projected eigenvalues of any point, measured by the nearest sample, and the gaps of that sample; `None` where there are none.
    pub(super) fn projected(
        &self,
        projection: &Projection<'a, F>,
        point: &F::Point,
        problem: &Quadratic,
        region: &Region,
    ) -> Result<Option<(Projected, Vec<Gap>)>, StructureError> {
        let here = self.family.coordinates(point);
        let from_here =
            |(taken, _): &&(usize, SearchedRegion)| distance(&self.coordinates[*taken], &here, &self.scales);
        let nearest = self.taken.iter().min_by(|a, b| from_here(a).total_cmp(&from_here(b)));
        let (factors, gaps) =
            nearest.map_or((&[][..], Vec::new()), |(_, sample)| (&sample.factors[..], sample.gaps.clone()));
        let projected = projection.at(point, problem, region, factors)?;
        Ok(projected.map(|projected| (projected, gaps)))
    }
}

/// The numbers of points: the first, then always the one farthest from all before.
fn farthest_first(points: &[Vec<f64>], count: usize) -> Vec<usize> {
    let scales = scales(points);
    let mut order = vec![0];
    let mut apart: Vec<f64> = points.iter().map(|point| distance(point, &points[0], &scales)).collect();
    while order.len() < count.min(points.len()) {
        let Some(next) = (0..points.len()).max_by(|a, b| apart[*a].total_cmp(&apart[*b]).then(b.cmp(a)))
        else {
            break;
        };
        if apart[next] == 0.0 {
            break;
        }
        order.push(next);
        for (apart, point) in apart.iter_mut().zip(points) {
            *apart = apart.min(distance(point, &points[next], &scales));
        }
    }
    order
}

/// How much each coordinate changes over the points.
fn scales(points: &[Vec<f64>]) -> Vec<f64> {
    let mut ranges: Vec<(f64, f64)> = Vec::new();
    for point in points {
        ranges.resize(point.len(), (f64::INFINITY, f64::NEG_INFINITY));
        for (range, own) in ranges.iter_mut().zip(point) {
            *range = (range.0.min(*own), range.1.max(*own));
        }
    }
    ranges.iter().map(|(from, to)| to - from).collect()
}

/// Between two points, every coordinate counted by how much it changes over all of them.
fn distance(a: &[f64], b: &[f64], scales: &[f64]) -> f64 {
    let shares = a.iter().zip(b).zip(scales).filter(|(_, scale)| **scale > 0.0);
    shares.map(|((a, b), scale)| ((a - b) / scale).powi(2)).sum::<f64>().sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ends_come_first_and_then_the_middle() {
        let at = |k: usize| vec![1.0, k as f64, 3.0];
        let points: Vec<Vec<f64>> = (0..9).map(at).collect();
        assert_eq!(farthest_first(&points, 5), [0, 8, 4, 2, 6]);
        assert_eq!(farthest_first(&points[..2], 5), [0, 1]);
        assert_eq!(farthest_first(&[at(3), at(3)], 5), [0]);
    }
}
