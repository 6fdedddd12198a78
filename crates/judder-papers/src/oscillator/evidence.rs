//! What the claims about the contact computation are measured on.

use super::exhibits::{CONTACT_CASES, FIT, LAW_FILE, thin_out};
use judder_contact::fit::{FitSample, LawFit};
use judder_contact::law::boundary_elements::sample;
use judder_contact::law::file::from_json;
use judder_contact::law::{LawIndenter, PerQuantity};
use judder_contact::material::CreepSpectrum;
use judder_contact::steady::MEMORY;
use judder_contact::{ContactLaw, FittedLaw, Law, LawPoint};
use judder_models::ModelError;
use judder_models::computed_law::{self, NO_POINTS};
use judder_models::contact::Exciting;
use judder_models::contact::case::ContactCase;
use judder_models::contact::law::LawPlane;
use judder_models::contact::settings::{FitSettings, LawSettings};
use judder_models::material::ContactScales;
use judder_store::{LARGEST_DOCUMENT, StudyFolder, read_small_file};
use judder_study::Progress;
use judder_study::StudyError;
use judder_study::case::analysis::Planned;
use std::sync::Arc;

/// log₁₀ of the factor of v τ/R at which the fits are read: the corrected axis.
pub(super) const CORRECTED: f64 = -2.0;

/// v̂ of the contacts at both ends, at [`SHALLOW`]: z = v̂/√ŷ = 10⁻⁴ and 10⁶, where a contact is elastic but for ln z/z.
const ENDS: [f64; 2] = [1e-6, 1e4];
/// ŷ of the contacts at both ends: a sphere is a paraboloid there to 3·10⁻⁵.
const SHALLOW: f64 = 1e-4;
/// Relative accuracy of their force.
const END_ACCURACY: f64 = 1e-3;

/// The computed law of the paper's sphere, and what was fitted to it.
#[derive(Debug, Clone)]
pub(super) struct Evidence {
    pub(super) law: Law,
    /// F̃/ŷ^{3/2} and Ã/ŷ, solved for very slow and for very fast sliding.
    pub(super) ends: [[f64; 2]; 2],
    /// The law on the plane of Fig. 14: the samples of the fit, its figure and its scoreboard.
    pub(super) samples: Vec<FitSample>,
    /// The functions of appendix B through them, on the corrected axis.
    pub(super) fit: LawFit,
    /// The same as printed.
    pub(super) fit_as_printed: LawFit,
    /// The same for a paraboloid, on the corrected axis.
    pub(super) paraboloid: LawFit,
    /// The paper's material.
    pub(super) spectrum: CreepSpectrum,
    /// Whether a paraboloid stands for the sphere.
    pub(super) quick: bool,
}

impl Evidence {
    /// From what Fig. 3 left in a study folder.
    pub(super) fn stored(
        store: &StudyFolder,
        quick: bool,
        progress: &dyn Progress,
    ) -> Result<Self, StudyError> {
        let path = store.path().join(LAW_FILE);
        let unusable = |reason: String| StudyError::File { path: path.clone(), reason };
        let text = read_small_file(&path, LARGEST_DOCUMENT).map_err(|error| unusable(error.to_string()))?;
        let text = String::from_utf8(text).map_err(|error| unusable(error.to_string()))?;
        let law = from_json(&text).map_err(|error| unusable(error.to_string()))?;
        Ok(Self::new(law, quick, progress)?)
    }

    /// From a law of the paper's sphere, or of the paraboloid that stands for it in a quick run.
    pub(super) fn new(law: Law, quick: bool, progress: &dyn Progress) -> Result<Self, ModelError> {
        let (case, settings) = contact_case(FIT, quick)?;
        let scales = ContactScales::new(&case)?;
        let curve = computed_law::of_paraboloid(&scales.material, settings.accuracy, NO_POINTS, progress)?;
        let plane = LawPlane::new(&settings, &scales);
        let fit = |law: &Law, scale: f64| {
            plane.fit(law, scale).map_err(|error| ModelError::Unsupported(error.to_string()))
        };
        Ok(Self {
            samples: plane.samples(&law),
            fit: fit(&law, CORRECTED)?,
            fit_as_printed: fit(&law, 0.0)?,
            paraboloid: fit(&curve.law, CORRECTED)?,
            ends: [end(&scales, ENDS[0])?, end(&scales, ENDS[1])?],
            quick,
            spectrum: scales.material.spectrum,
            law,
        })
    }

    /// r² of force, area and friction of a fitted law against the computed values.
    pub(super) fn r_squared(&self, functions: &FittedLaw) -> [f64; 3] {
        let fitted: Vec<[f64; 3]> =
            self.samples.iter().map(|sample| values(functions, sample).into_array()).collect();
        [0, 1, 2].map(|k| {
            let computed: Vec<f64> =
                self.samples.iter().map(|sample| sample.values.into_array()[k]).collect();
            r_squared(&computed, &fitted.iter().map(|values| values[k]).collect::<Vec<f64>>())
        })
    }
}

/// F̃/ŷ^{3/2} and Ã/ŷ of a sphere at one speed.
fn end(scales: &ContactScales, velocity: f64) -> Result<[f64; 2], ModelError> {
    let found =
        sample(&scales.material.of_law(), LawIndenter::Sphere, velocity, SHALLOW, END_ACCURACY, MEMORY)
            .map_err(|error| ModelError::Unsupported(error.to_string()))?;
    Ok([found.force / libm::pow(SHALLOW, 1.5), found.area / SHALLOW])
}

/// r² = 1 − Σ (value − function)²/Σ (value − mean)².
pub(super) fn r_squared(values: &[f64], functions: &[f64]) -> f64 {
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    let off: f64 = values.iter().zip(functions).map(|(value, function)| (value - function).powi(2)).sum();
    1.0 - off / values.iter().map(|value| (value - mean).powi(2)).sum::<f64>()
}

/// F̃, Ã, μ of a law where a sample is.
pub(super) fn values(law: &impl ContactLaw, sample: &FitSample) -> PerQuantity<f64> {
    let found = law.evaluate(&LawPoint::new(sample.velocity, sample.indentation));
    PerQuantity { force: found.force.value, area: found.area.value, friction: found.friction.value }
}

/// The law that an analysis computes.
pub(super) fn law_of(analysis: &Planned<Arc<dyn Exciting>>) -> Option<&LawSettings> {
    let of_fit = || analysis.settings::<FitSettings>().map(|fit| &fit.law);
    analysis.settings::<LawSettings>().or_else(of_fit)
}

/// A case of the contact computation with the settings of its one law or fit.
pub(super) fn contact_case(name: &str, quick: bool) -> Result<(ContactCase, LawSettings), ModelError> {
    let missing = || ModelError::Unsupported(format!("the case {name} computes no law"));
    let (_, text) = CONTACT_CASES.iter().find(|(known, _)| *known == name).ok_or_else(missing)?;
    let mut case = judder_models::parse(name, text, &[])?.case;
    if quick {
        thin_out(&mut case);
    }
    let case: &ContactCase = case.of().ok_or_else(missing)?;
    let law = case.analyses.first().and_then(law_of).ok_or_else(missing)?.clone();
    Ok((case.clone(), law))
}

/// The evidence of Fig. 3's own case, computed once for all tests.
#[cfg(test)]
pub(super) fn computed() -> Evidence {
    use judder_models::computed_law::{LawTask, compute};
    use judder_study::Silent;
    use std::sync::OnceLock;
    static EVIDENCE: OnceLock<Evidence> = OnceLock::new();
    let make = || {
        let (case, settings) = contact_case(FIT, false).unwrap();
        let scales = ContactScales::new(&case).unwrap();
        let task = LawTask {
            material: &scales.material,
            indenter: LawIndenter::Sphere,
            method: settings.method,
            velocity: (settings.velocity.from, settings.velocity.to),
            indentation: (settings.indentation.from, settings.indentation.to),
            accuracy: settings.accuracy,
            memory: MEMORY,
        };
        let found = compute(&task, NO_POINTS, &Silent).unwrap();
        Evidence::new(found.law, false, &Silent).unwrap()
    };
    EVIDENCE.get_or_init(make).clone()
}
