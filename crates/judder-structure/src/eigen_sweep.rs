//! Complex modes over parameters, followed from point to point.
//!
//! The full answer solves every point on its own. The fast one solves a few, the samples, makes a basis of their right and left
//! vectors, and solves the other points in it; what the projection leaves open of an eigenvalue is measured on the full problem and is
//! a part of its shown error.

mod basis;
mod problem_family;
mod projection;
mod samples;
mod tracking;

use crate::StructureError;
use crate::affine::{AffineFamily, Factors};
use crate::complex_modes::{
    ComplexMode, ComplexModeSettings, Eigenvalue, Gap, Region, complex_modes, finished,
};
use crate::onset::StabilityAt;
use faer::c64;
use judder_numerics::complex::ElementaryComplex;
use judder_numerics::parallel;
use projection::Projection;
use samples::FullSamples;
use std::fmt::{self, Display, Formatter};
use std::ops::Range;
use tracking::SweepTracker;

pub use problem_family::{ProblemFamily, ProjectedProblem};

/// How the points are solved.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SweepMethod {
    /// Each on its own.
    Full,
    /// In a basis of samples, as long as that leaves less open than a share of |λ|; where it does not, on its own.
    Projected {
        /// The share.
        tolerance: f64,
    },
}

impl Display for SweepMethod {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            Self::Full => "full",
            Self::Projected { .. } => "projected",
        })
    }
}

/// Eigenvalues over points, as branches.
#[derive(Debug, Clone, PartialEq)]
pub struct SweptEigenvalues {
    /// In the order of the factors.
    pub points: Vec<PointEigenvalues>,
    /// How many branches there are.
    pub branches: usize,
    /// Vectors of the basis; `None` where there is none.
    pub basis: Option<usize>,
    /// The points that made the basis, by their numbers in the curve, or in all curves one after the other.
    pub samples: Vec<usize>,
}

impl SweptEigenvalues {
    fn empty() -> Self {
        Self { points: Vec::new(), branches: 0, basis: None, samples: Vec::new() }
    }
}

/// The eigenvalues of a point.
#[derive(Debug, Clone, PartialEq)]
pub struct PointEigenvalues {
    /// By rising imaginary part.
    pub eigenvalues: Vec<Tracked>,
    /// Why there may be more.
    pub gaps: Vec<Gap>,
    /// Whether it was solved on its own, not in a basis.
    pub full: bool,
}

/// An eigenvalue and its branch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tracked {
    /// The eigenvalue; its error holds what a projection leaves open.
    pub eigenvalue: Eigenvalue,
    /// From 0, in the order in which branches appear.
    pub branch: usize,
}

/// A point that is solved but not yet followed.
#[derive(Debug, Clone)]
pub struct SolvedPoint {
    /// Its modes; vectors of all points have one length.
    pub modes: Vec<ComplexMode>,
    /// Why there may be more.
    pub gaps: Vec<Gap>,
    /// Whether it was solved on its own, not in a basis.
    pub full: bool,
}

impl SolvedPoint {
    /// A point of which nothing is known.
    #[must_use]
    pub fn unsolved() -> Self {
        Self { modes: Vec::new(), gaps: Vec::new(), full: true }
    }

    /// What it says of stability with the contact points on these pieces of their laws.
    #[must_use]
    pub fn stability(&self, pieces: Vec<usize>) -> StabilityAt {
        let eigenvalues = self.modes.iter().map(|mode| mode.eigenvalue).collect();
        StabilityAt { eigenvalues, branches: Vec::new(), complete: self.gaps.is_empty(), pieces }
    }
}

/// An eigenvalue may have entered or left the region within so many of its last steps.
const STEPS: f64 = 3.0;
/// Points that are solved side by side.
const BATCH: usize = 8;

/// The eigenvalues of a region at every point, followed from each point to the next.
///
/// Neighbouring points should lie so near that the vectors of an eigenvalue stay alike, or that it moves by less than a twentieth of
/// itself beside what it moved before.
///
/// # Errors
/// Those of [`complex_modes`], at the first point that has one; [`StructureError::WrongFactors`].
pub fn eigen_sweep(
    family: &AffineFamily,
    points: &[Factors],
    region: &Region,
    settings: &ComplexModeSettings,
    method: SweepMethod,
) -> Result<SweptEigenvalues, StructureError> {
    let mut sweeps = eigen_sweeps(family, &[points], region, settings, method)?;
    Ok(sweeps.pop().unwrap_or_else(SweptEigenvalues::empty))
}

/// As [`eigen_sweep`], for curves of points, each followed on its own: one basis, of samples from all of them, serves every curve.
///
/// # Errors
/// Those of [`eigen_sweep`].
pub fn eigen_sweeps(
    family: &AffineFamily,
    curves: &[&[Factors]],
    region: &Region,
    settings: &ComplexModeSettings,
    method: SweepMethod,
) -> Result<Vec<SweptEigenvalues>, StructureError> {
    let points: Vec<&Factors> = curves.iter().copied().flatten().collect();
    for factors in &points {
        family.check(factors)?;
    }
    let prepared = PreparedSweep::new(family, points, region, settings.clone(), method)?;
    let mut first = 0;
    let each = curves.iter().map(|curve| {
        first += curve.len();
        prepared.followed(first - curve.len()..first)
    });
    each.collect()
}

/// A sweep whose samples are solved: any point can be asked for.
pub struct PreparedSweep<'a, F: ProblemFamily> {
    family: &'a F,
    region: &'a Region,
    settings: ComplexModeSettings,
    points: Vec<&'a F::Point>,
    /// With the share of |λ| that the basis may leave open.
    samples: Option<(FullSamples<'a, F>, f64)>,
}

impl<'a, F: ProblemFamily> PreparedSweep<'a, F> {
    /// Solves the points that the method needs as samples.
    ///
    /// # Errors
    /// As of [`eigen_sweep`].
    pub fn new(
        family: &'a F,
        points: Vec<&'a F::Point>,
        region: &'a Region,
        settings: ComplexModeSettings,
        method: SweepMethod,
    ) -> Result<Self, F::Error> {
        region.check()?;
        let samples = match method {
            SweepMethod::Projected { tolerance } if !points.is_empty() => Some((
                FullSamples::trained(family, points.clone(), region, tolerance, &settings.memory)?,
                tolerance,
            )),
            _ => None,
        };
        let samples = samples.filter(|(samples, _)| samples.projection().is_some());
        Ok(Self { family, region, settings, points, samples })
    }

    /// The modes at one of its points.
    ///
    /// # Errors
    /// Those of [`complex_modes`], and where there is no problem.
    pub fn point(&self, number: usize) -> Result<SolvedPoint, F::Error> {
        if let Some((samples, _)) = &self.samples
            && let Some((taken, sample)) = samples.of_point(number)
        {
            let modes = samples.modes(*taken, sample, &self.settings)?;
            return Ok(SolvedPoint { modes, gaps: sample.gaps.clone(), full: true });
        }
        self.at(self.points[number])
    }

    /// The modes at any point.
    ///
    /// # Errors
    /// Those of [`complex_modes`], and where there is no problem.
    pub fn at(&self, point: &F::Point) -> Result<SolvedPoint, F::Error> {
        self.within(point, self.region)
    }

    /// The modes at any point in a part of the region.
    ///
    /// # Errors
    /// As of [`Self::at`].
    pub fn within(&self, point: &F::Point, region: &Region) -> Result<SolvedPoint, F::Error> {
        let problem = self.family.at(point)?;
        if let Some((samples, tolerance)) = &self.samples
            && let Some(projection) = samples.projection()
            && let Some((projected, gaps)) = samples.projected(projection, point, &problem, region)?
            && projected.within(*tolerance)
        {
            let modes = finished(&problem, &projected.refined, &projected.left_open, region, &self.settings);
            return Ok(SolvedPoint { modes, gaps, full: false });
        }
        let modes = complex_modes(&problem, region, &self.settings)?;
        Ok(SolvedPoint { modes: modes.modes, gaps: modes.gaps, full: true })
    }

    /// The eigenvalues of a curve of its points, followed.
    ///
    /// # Errors
    /// As of [`Self::point`], at the first point that has one.
    pub fn followed(&self, curve: Range<usize>) -> Result<SweptEigenvalues, F::Error> {
        let sweep = followed(curve, self.region, &|number| self.point(number), &NothingFollowed)?;
        Ok(SweptEigenvalues { basis: self.basis(), samples: self.samples(), ..sweep })
    }

    /// Vectors of the basis; `None` where there is none.
    #[must_use]
    pub fn basis(&self) -> Option<usize> {
        self.samples.as_ref().and_then(|(samples, _)| samples.projection()).map(Projection::size)
    }

    /// The points that made the basis.
    #[must_use]
    pub fn samples(&self) -> Vec<usize> {
        self.samples.as_ref().map_or_else(Vec::new, |(samples, _)| samples.points())
    }
}

/// Points of a curve that an earlier run has followed, by their numbers, and who keeps those that this one follows.
pub trait FollowedPoints {
    /// The point of this number, if it is known.
    fn known(&self, number: usize) -> Option<PointEigenvalues>;
    /// Takes a point that was not.
    fn keep(&self, number: usize, point: &PointEigenvalues);
}

/// No point is known, and none is kept.
pub struct NothingFollowed;

impl FollowedPoints for NothingFollowed {
    fn known(&self, _: usize) -> Option<PointEigenvalues> {
        None
    }

    fn keep(&self, _: usize, _: &PointEigenvalues) {}
}

/// Solves the points of a curve that are not known side by side and follows their modes in order, from those of the point before, which is solved again.
///
/// # Errors
/// That of the first point that has one.
pub fn followed<E: Send>(
    curve: Range<usize>,
    region: &Region,
    solve: &(dyn Fn(usize) -> Result<SolvedPoint, E> + Sync),
    earlier: &dyn FollowedPoints,
) -> Result<SweptEigenvalues, E> {
    let mut tracker = SweepTracker::default();
    let mut sweep = SweptEigenvalues::empty();
    let known: Vec<Option<PointEigenvalues>> = curve.clone().map(|number| earlier.known(number)).collect();
    let is_open = |place: usize| known.get(place).is_some_and(Option::is_none);
    let places: Vec<usize> = (0..known.len()).collect();
    for batch in places.chunks(BATCH) {
        let solved = parallel::try_each(batch, |place| {
            let is_needed = is_open(*place) || is_open(place + 1);
            is_needed.then(|| solve(curve.start + place)).transpose()
        })?;
        for (place, solved) in batch.iter().zip(solved) {
            let SolvedPoint { modes, gaps, full } = solved.unwrap_or_else(SolvedPoint::unsolved);
            if let Some(point) = &known[*place] {
                tracker.pass(point, &modes);
                sweep.points.push(point.clone());
                continue;
            }
            let branches = tracker.next(&modes).into_iter();
            let eigenvalues = modes.iter().zip(branches);
            let eigenvalues =
                eigenvalues.map(|(mode, branch)| Tracked { eigenvalue: mode.eigenvalue, branch }).collect();
            let point = PointEigenvalues { eigenvalues, gaps, full };
            earlier.keep(curve.start + place, &point);
            sweep.points.push(point);
        }
    }
    sweep.branches = tracker.branches();
    mark_torn(&mut sweep.points, region);
    Ok(sweep)
}

/// Marks the ends of branches inside the region beside points that were solved in a basis: what the basis lacks has no other trace.
fn mark_torn(points: &mut [PointEigenvalues], region: &Region) {
    let mut torn = Vec::new();
    for place in 0..points.len() {
        for tracked in &points[place].eigenvalues {
            let (before, after) = (place.checked_sub(1), (place + 1 < points.len()).then_some(place + 1));
            let value = tracked.eigenvalue.value;
            for (beside, beyond) in [(before, after), (after, before)] {
                let Some(beside) = beside else { continue };
                let in_full = points[place].full && points[beside].full;
                if in_full || points[beside].value(tracked.branch).is_some() {
                    continue;
                }
                let known = beyond.and_then(|beyond| points[beyond].value(tracked.branch));
                let reach = known.map_or(0.0, |known| STEPS * (value - known).modulus());
                if region.distance_to_edge(value) > reach.max(tracked.eigenvalue.error) {
                    torn.push((place, Gap::Torn { value }));
                }
            }
        }
    }
    for (place, gap) in torn {
        points[place].gaps.push(gap);
    }
}

impl PointEigenvalues {
    /// What they say of stability with the contact points on these pieces of their laws.
    #[must_use]
    pub fn stability(&self, pieces: Vec<usize>) -> StabilityAt {
        let (eigenvalues, branches) =
            self.eigenvalues.iter().map(|tracked| (tracked.eigenvalue, tracked.branch)).unzip();
        StabilityAt { eigenvalues, branches, complete: self.gaps.is_empty(), pieces }
    }

    /// The eigenvalue of a branch.
    fn value(&self, branch: usize) -> Option<c64> {
        self.eigenvalues.iter().find(|of| of.branch == branch).map(|of| of.eigenvalue.value)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Points of one branch each, where there is a value.
    fn points(values: &[Option<f64>], full: bool) -> Vec<PointEigenvalues> {
        let tracked = |value: f64| Tracked {
            eigenvalue: Eigenvalue {
                value: c64::new(0.0, value),
                residual: 0.0,
                left_residual: 0.0,
                condition: 1.0,
                error: 1e-6,
                defective: false,
            },
            branch: 0,
        };
        let point = |value: &Option<f64>| PointEigenvalues {
            eigenvalues: value.iter().map(|value| tracked(*value)).collect(),
            gaps: Vec::new(),
            full,
        };
        values.iter().map(point).collect()
    }

    #[test]
    fn a_branch_that_ends_inside_the_region_is_torn() {
        let region = Region { re: [-10.0, 10.0], im: [0.0, 20.0] };
        let torn = |values: &[Option<f64>], full: bool| {
            let mut points = points(values, full);
            mark_torn(&mut points, &region);
            points.iter().map(|point| point.gaps.len()).collect::<Vec<_>>()
        };
        let hidden = [Some(9.0), Some(9.1), None, Some(9.3)];
        assert_eq!(torn(&hidden, false), [0, 1, 0, 1]);
        assert_eq!(torn(&hidden, true), [0; 4], "points on their own answer for themselves");
        assert_eq!(torn(&[Some(18.0), Some(19.0), None, None], false), [0; 4], "it leaves over the edge");
    }
}
