//! A law sampled from a function, as finely as a tolerance asks.

use super::axis::KnotAxis;
use super::{AXES, LawSamples, SampledLaw};
use crate::law::error::LawError;
use crate::law::quantities::{KnotValues, PerQuantity};

/// Knots a side of the first grid.
const FIRST: usize = 9;
/// Knots that a side may have.
const MOST_A_SIDE: usize = 2049;
/// Knots that a law may have.
const MOST: usize = 1 << 18;

/// Where a function is sampled.
#[derive(Debug, Clone, PartialEq)]
pub struct SampleRequest {
    /// Where the function comes from, in words.
    pub source: String,
    /// v̂ between which the law is wanted.
    pub velocity: (f64, f64),
    /// ŷ between which the law is wanted.
    pub indentation: (f64, f64),
    /// What the interpolation may leave, relative; of the friction to its largest value.
    pub tolerance: f64,
}

/// A sampled law, and whether it is as exact as was asked.
#[derive(Debug, Clone, PartialEq)]
pub struct SampledAdaptively {
    /// The law.
    pub law: SampledLaw,
    /// Whether its estimated error is within the tolerance.
    pub meets_tolerance: bool,
}

/// Samples a function on grids that are even in ln v̂ and ln ŷ, each side halved where knots that are left out are missed by more
/// than the tolerance. The function takes speeds and depths, one of each a point, and gives F̃_k, Ã, μ_visc at every point.
///
/// # Errors
/// A range or a tolerance that is none ([`LawError`]), what the function refuses, values that make no law.
pub fn sampled<E: From<LawError>>(
    request: &SampleRequest,
    mut function: impl FnMut(&[f64], &[f64]) -> Result<KnotValues, E>,
) -> Result<SampledAdaptively, E> {
    if !(request.tolerance > 0.0 && request.tolerance.is_finite()) {
        let (name, requirement) = ("tolerance", "positive and finite");
        return Err(LawError::InvalidNumber { name, value: request.tolerance, requirement }.into());
    }
    for ((from, to), axis) in [(request.velocity, AXES[0]), (request.indentation, AXES[1])] {
        KnotAxis::new(&[from, to], axis)?;
    }
    let mut known: Option<LawSamples> = None;
    let mut counts = [FIRST; 2];
    loop {
        let velocities = spaced(request.velocity.0, request.velocity.1, counts[0]);
        let indentations = spaced(request.indentation.0, request.indentation.1, counts[1]);
        let values = fill(&velocities, &indentations, known.as_ref(), &mut function)?;
        let source = request.source.clone();
        let law = SampledLaw::new(LawSamples { source, velocities, indentations, values })?;
        let misses = law
            .errors_by_axis()
            .map(|errors| errors.into_array().into_iter().any(|error| error > request.tolerance));
        let finer = [0, 1].map(|k| if misses[k] { 2 * counts[k] - 1 } else { counts[k] });
        let is_full = finer[0].max(finer[1]) > MOST_A_SIDE || finer[0] * finer[1] > MOST;
        if finer == counts || is_full {
            return Ok(SampledAdaptively { law, meets_tolerance: finer == counts });
        }
        known = Some(law.samples().clone());
        counts = finer;
    }
}

/// Values at evenly spaced logarithms; the same bits whenever the same place is one of a grid twice as fine.
fn spaced(from: f64, to: f64, count: usize) -> Vec<f64> {
    let (low, high) = (libm::log(from), libm::log(to));
    (0..count)
        .map(|k| match k {
            0 => from,
            _ if k + 1 == count => to,
            _ => libm::exp(low + (high - low) * (k as f64 / (count - 1) as f64)),
        })
        .collect()
}

/// The values on a grid; those that a coarser one has are taken from there.
fn fill<E: From<LawError>>(
    velocities: &[f64],
    indentations: &[f64],
    known: Option<&LawSamples>,
    function: &mut impl FnMut(&[f64], &[f64]) -> Result<KnotValues, E>,
) -> Result<KnotValues, E> {
    let columns = velocities.len();
    let earlier = |index: usize| {
        let known = known?;
        let step = |fine: &[f64], coarse: &[f64]| if fine.len() > coarse.len() { 2 } else { 1 };
        let every = [step(velocities, &known.velocities), step(indentations, &known.indentations)];
        let (column, row) = (index % columns, index / columns);
        let is_there = column.is_multiple_of(every[0]) && row.is_multiple_of(every[1]);
        is_there.then(|| row / every[1] * known.velocities.len() + column / every[0])
    };
    let points = columns * indentations.len();
    let fresh: Vec<usize> = (0..points).filter(|index| earlier(*index).is_none()).collect();
    let speeds: Vec<f64> = fresh.iter().map(|index| velocities[index % columns]).collect();
    let depths: Vec<f64> = fresh.iter().map(|index| indentations[index / columns]).collect();
    let found = function(&speeds, &depths)?;
    for (list, quantity) in found.as_ref().zip(crate::law::quantities::NAMES).into_array() {
        if list.len() != fresh.len() {
            return Err(LawError::WrongCount { quantity, found: list.len(), expected: fresh.len() }.into());
        }
    }
    let of = |take: fn(&KnotValues) -> &Vec<f64>| {
        let mut new = take(&found).iter().copied();
        let value = |index: usize| match (earlier(index), known) {
            (Some(place), Some(known)) => take(&known.values)[place],
            _ => new.next().unwrap_or(f64::NAN),
        };
        (0..points).map(value).collect()
    };
    Ok(PerQuantity { force: of(|v| &v.force), area: of(|v| &v.area), friction: of(|v| &v.friction) })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact_law::ContactLaw;
    use crate::{FittedLaw, LawPoint};

    fn request(tolerance: f64) -> SampleRequest {
        SampleRequest { source: String::new(), velocity: (1e-6, 1e1), indentation: (1e-5, 1e-1), tolerance }
    }

    #[test]
    fn a_function_is_sampled_to_the_tolerance_and_no_point_twice() {
        let exact = FittedLaw::oscillator_paper();
        let mut asked = std::collections::BTreeSet::new();
        let found = sampled(&request(1e-3), |velocities, indentations| -> Result<_, LawError> {
            let at = |k: usize| exact.evaluate(&LawPoint::new(velocities[k], indentations[k]));
            let all = 0..velocities.len();
            for k in all.clone() {
                assert!(asked.insert((velocities[k].to_bits(), indentations[k].to_bits())), "asked twice");
            }
            Ok(PerQuantity {
                force: all.clone().map(|k| at(k).force.value).collect(),
                area: all.clone().map(|k| at(k).area.value).collect(),
                friction: all.map(|k| at(k).friction.value).collect(),
            })
        })
        .unwrap();
        assert!(found.meets_tolerance && asked.len() == found.law.samples().values.force.len());
        for (velocity, indentation) in [(2.3e-5, 4e-3), (0.4, 7e-5), (3e-3, 2e-2)] {
            let at = LawPoint::new(velocity, indentation);
            let (a, b) = (found.law.evaluate(&at), exact.evaluate(&at));
            assert!((a.force.value / b.force.value - 1.0).abs() < 1e-3);
            assert!((a.friction.value - b.friction.value).abs() < 1e-3);
        }
    }

    #[test]
    fn what_jumps_is_told_to_miss_the_tolerance() {
        let found = sampled(&request(1e-6), |velocities, indentations| -> Result<_, LawError> {
            let force = indentations.iter().map(|y| y.powf(1.5)).collect();
            let friction = velocities.iter().map(|v| if *v > 1e-2 { 1.0 } else { 0.0 }).collect();
            Ok(PerQuantity { force, area: indentations.to_vec(), friction })
        })
        .unwrap();
        assert!(!found.meets_tolerance && found.law.errors().friction > 0.1);
    }
}
