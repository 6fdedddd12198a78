//! The frequencies at which the analyses of a contact case excite the substrate, before anything is solved.

use super::{Asked, Plane, loading};
use crate::error::StudyError;
use crate::indenter::{height_map, profile};
use crate::material::ContactScales;
use crate::measured_band::MeasuredBand;
use judder_case::{ContactAnalysis, ContactCase, Shape};
use judder_contact::unilateral::Loading;
use std::f64::consts::TAU;

/// That an analysis excites what was not measured, in words.
///
/// # Errors
/// An indenter that cannot be read.
pub(crate) fn band_warning(
    case: &ContactCase,
    kind: &ContactAnalysis,
    scales: &ContactScales,
) -> Result<Option<String>, StudyError> {
    let Some(band) = MeasuredBand::of(&scales.material) else { return Ok(None) };
    Ok(band.warning(excited(case, kind, scales)?))
}

/// ω τ = v τ/a of what is asked, with a = √(R δ) of the depth that is asked or that an elastic contact has; of a periodic surface 2π v τ/λ of its longest and, where
/// it is known, its shortest wave.
fn excited(
    case: &ContactCase,
    kind: &ContactAnalysis,
    scales: &ContactScales,
) -> Result<Vec<f64>, StudyError> {
    let radius = scales.scales.radius;
    let half_length = |pressed: Loading| -> Result<f64, StudyError> {
        let depth = match pressed {
            Loading::Indentation(depth) => depth,
            Loading::Load(force) => profile(&case.shape, radius)?.elastic_depth(force),
        };
        Ok(depth.sqrt())
    };
    Ok(match kind {
        ContactAnalysis::Contact(settings) => {
            let velocity = scales.velocity(settings.velocity);
            match &case.shape {
                Shape::Rough(rough) => {
                    [rough.roll_off, rough.cut_off].map(|wave| TAU * velocity * radius / wave).to_vec()
                }
                shape if shape.is_periodic() => {
                    let grid = height_map(shape, radius)?.grid();
                    vec![TAU * velocity / (grid.columns as f64 * grid.cell)]
                }
                _ => vec![velocity / half_length(loading(&case.shape, settings, scales))?],
            }
        }
        ContactAnalysis::ContactLaw(law) | ContactAnalysis::Fit { law, .. } => {
            let plane = Plane::new(law, scales);
            let ends = |values: &[f64]| {
                [values.first().copied(), values.last().copied()].into_iter().flatten().collect::<Vec<_>>()
            };
            let depths = ends(&plane.indentations);
            ends(&plane.velocities)
                .into_iter()
                .flat_map(|v| depths.iter().map(move |y| v / y.sqrt()))
                .collect()
        }
        ContactAnalysis::Transient(settings) => {
            let asked = Asked::new(&case.shape, settings, scales);
            asked.frequencies(half_length(asked.loading())?)
        }
        ContactAnalysis::Modulus { .. } => Vec::new(),
    })
}
