//! Complex modes over parameters, followed from point to point.
//!
//! The full answer solves every point on its own. The fast one solves a few, the samples, makes a basis of their right and left
//! vectors, and solves the other points in it; what the projection leaves open of an eigenvalue is measured on the full problem and is
//! a part of its shown error.

mod basis;
mod projection;
mod samples;
mod tracking;

use crate::StructureError;
use crate::affine::{AffineFamily, Factors};
use crate::complex_modes::{
    ComplexMode, ComplexModeSettings, Eigenvalue, Gap, Region, complex_modes, finished,
};
use faer::c64;
use rayon::prelude::*;
use samples::FullSamples;
use std::fmt::{self, Display, Formatter};
use std::ops::Range;
use tracking::SweepTracker;

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
struct Solved {
    modes: Vec<ComplexMode>,
    gaps: Vec<Gap>,
    full: bool,
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
    region.check()?;
    let points = curves.concat();
    for factors in &points {
        family.check(factors)?;
    }
    let full = |factors: &Factors| -> Result<Solved, StructureError> {
        let modes = complex_modes(&family.at(factors)?, region, settings)?;
        Ok(Solved { modes: modes.modes, gaps: modes.gaps, full: true })
    };
    let each_curve = |solve: &(dyn Fn(usize) -> Result<Solved, StructureError> + Sync)| {
        let mut first = 0;
        let ranges = curves.iter().map(|curve| {
            first += curve.len();
            first - curve.len()..first
        });
        ranges.map(|range| followed(range, region, solve)).collect::<Result<Vec<SweptEigenvalues>, _>>()
    };
    let (SweepMethod::Projected { tolerance }, false) = (method, points.is_empty()) else {
        return each_curve(&|number| full(&points[number]));
    };
    let samples = FullSamples::trained(family, &points, region, tolerance)?;
    let Some(projection) = samples.projection() else {
        return each_curve(&|number| full(&points[number]));
    };
    let sweeps = each_curve(&|number| {
        if let Some((taken, sample)) = samples.of_point(number) {
            let modes = samples.modes(*taken, sample, settings)?;
            return Ok(Solved { modes, gaps: sample.gaps.clone(), full: true });
        }
        let projected = samples.projected(projection, number)?;
        let Some((projected, gaps)) = projected.filter(|(projected, _)| projected.within(tolerance)) else {
            return full(&points[number]);
        };
        let problem = family.at(&points[number])?;
        let modes = finished(&problem, &projected.refined, &projected.left_open, region, settings);
        Ok(Solved { modes, gaps, full: false })
    })?;
    let with_basis =
        |sweep| SweptEigenvalues { basis: Some(projection.size()), samples: samples.points(), ..sweep };
    Ok(sweeps.into_iter().map(with_basis).collect())
}

/// Solves the points of a curve side by side and follows their modes in order.
fn followed(
    curve: Range<usize>,
    region: &Region,
    solve: &(dyn Fn(usize) -> Result<Solved, StructureError> + Sync),
) -> Result<SweptEigenvalues, StructureError> {
    let mut tracker = SweepTracker::default();
    let mut sweep = SweptEigenvalues::empty();
    let numbers: Vec<usize> = curve.collect();
    for batch in numbers.chunks(BATCH) {
        let solved: Vec<Solved> = batch.par_iter().map(|number| solve(*number)).collect::<Result<_, _>>()?;
        for Solved { modes, gaps, full } in solved {
            let branches = tracker.next(&modes);
            let eigenvalues = modes
                .iter()
                .zip(branches)
                .map(|(mode, branch)| Tracked { eigenvalue: mode.eigenvalue, branch })
                .collect();
            sweep.points.push(PointEigenvalues { eigenvalues, gaps, full });
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
                let reach = known.map_or(0.0, |known| STEPS * (value - known).norm());
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
