//! The points of a sweep that are solved in full to make a basis for the others.

use super::projection::{Projected, Projection};
use crate::StructureError;
use crate::affine::{AffineFamily, Factors};
use crate::complex_modes::{
    ComplexMode, ComplexModeSettings, Gap, Region, SearchedRegion, finished, left_by_residuals, searched,
};
use rayon::prelude::*;

/// Points solved in full, each with the region's surroundings.
pub(super) struct FullSamples<'a> {
    family: &'a AffineFamily,
    points: &'a [Factors],
    region: &'a Region,
    /// By the order in which they were taken.
    taken: Vec<(usize, SearchedRegion)>,
    projection: Option<Projection<'a>>,
}

/// Samples to begin with.
const FIRST: usize = 3;
/// Samples at most: what a basis cannot carry by then is solved in full.
const LARGEST: usize = 12;
/// The samples' region is larger by this share of its sides: eigenvalues that a sweep brings in are known before they come.
const SURROUNDINGS: f64 = 0.1;

impl<'a> FullSamples<'a> {
    /// Takes samples, farthest from each other first, until the point farthest from all has its eigenvalues within the tolerance.
    pub(super) fn trained(
        family: &'a AffineFamily,
        points: &'a [Factors],
        region: &'a Region,
        tolerance: f64,
    ) -> Result<Self, StructureError> {
        let order = farthest_first(points, LARGEST + 1);
        let mut samples = Self { family, points, region, taken: Vec::new(), projection: None };
        let first = FIRST.min(order.len());
        samples.take(&order[..first])?;
        for next in &order[first..] {
            let Some(projection) = &samples.projection else { break };
            let sufficient = samples.projected(projection, *next)?.is_some_and(|of| of.0.within(tolerance));
            if samples.taken.len() == LARGEST || sufficient {
                break;
            }
            samples.take(&[*next])?;
        }
        Ok(samples)
    }

    /// Solves points in full and makes the basis anew.
    fn take(&mut self, numbers: &[usize]) -> Result<(), StructureError> {
        let wide = self.region.widened(SURROUNDINGS);
        let solved: Vec<SearchedRegion> = numbers
            .par_iter()
            .map(|number| searched(&self.family.at(&self.points[*number])?, &wide))
            .collect::<Result<_, _>>()?;
        self.taken.extend(numbers.iter().copied().zip(solved));
        self.projection = Projection::new(self.family, self.taken.iter().map(|(_, sample)| sample));
        Ok(())
    }

    pub(super) fn projection(&self) -> Option<&Projection<'a>> {
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
    ) -> Result<Vec<ComplexMode>, StructureError> {
        let problem = self.family.at(&self.points[number])?;
        let left_open: Vec<f64> =
            sample.refined.iter().map(|refined| left_by_residuals(&problem, refined)).collect();
        Ok(finished(&problem, &sample.refined, &left_open, self.region, settings))
    }

    /// The projected eigenvalues of a point, measured by the nearest sample, and the gaps of that sample; `None` where there are none.
    pub(super) fn projected(
        &self,
        projection: &Projection<'a>,
        number: usize,
    ) -> Result<Option<(Projected, Vec<Gap>)>, StructureError> {
        let scales = scales(self.points);
        let from_here = |(taken, _): &&(usize, SearchedRegion)| {
            distance(&self.points[*taken], &self.points[number], &scales)
        };
        let nearest = self.taken.iter().min_by(|a, b| from_here(a).total_cmp(&from_here(b)));
        let (factors, gaps) =
            nearest.map_or((&[][..], Vec::new()), |(_, sample)| (&sample.factors[..], sample.gaps.clone()));
        let projected = projection.at(&self.points[number], self.region, factors)?;
        Ok(projected.map(|projected| (projected, gaps)))
    }
}

/// The numbers of points: the first, then always the one farthest from all before.
fn farthest_first(points: &[Factors], count: usize) -> Vec<usize> {
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

fn all(factors: &Factors) -> impl Iterator<Item = f64> + '_ {
    factors.mass.iter().chain(&factors.damping).chain(&factors.stiffness).copied()
}

/// How much each factor changes over the points.
fn scales(points: &[Factors]) -> Vec<f64> {
    let mut ranges: Vec<(f64, f64)> = Vec::new();
    for point in points {
        ranges.resize(all(point).count(), (f64::INFINITY, f64::NEG_INFINITY));
        for (range, factor) in ranges.iter_mut().zip(all(point)) {
            *range = (range.0.min(factor), range.1.max(factor));
        }
    }
    ranges.iter().map(|(from, to)| to - from).collect()
}

/// Between two points, every factor counted by how much it changes over all of them.
fn distance(a: &Factors, b: &Factors, scales: &[f64]) -> f64 {
    let shares = all(a).zip(all(b)).zip(scales).filter(|(_, scale)| **scale > 0.0);
    shares.map(|((a, b), scale)| ((a - b) / scale).powi(2)).sum::<f64>().sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ends_come_first_and_then_the_middle() {
        let at = |k: usize| Factors { mass: vec![1.0], damping: vec![], stiffness: vec![k as f64, 3.0] };
        let points: Vec<Factors> = (0..9).map(at).collect();
        assert_eq!(farthest_first(&points, 5), [0, 8, 4, 2, 6]);
        assert_eq!(farthest_first(&points[..2], 5), [0, 1]);
        assert_eq!(farthest_first(&[at(3), at(3)], 5), [0]);
    }
}
