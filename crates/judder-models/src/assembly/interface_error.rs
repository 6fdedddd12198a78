//! What interface modes cost: the same with each freedom of the contacts kept.

use super::AssemblySubject;
use super::build::BuiltAssembly;
use super::case::AssemblyCase;
use crate::error::ModelError;
use crate::structure::eigen::run::asked_of;
use crate::structure::solved_size::complex_mode_settings;
use judder_assembly::linearised::{Linearised, LinearisedTerms};
use judder_assembly::steady::SteadySliding;
use judder_numerics::complex::ElementaryComplex;
use judder_structure::asked_region::AskedRegion;
use judder_structure::complex_modes::complex_modes;
use num_complex::Complex64;

/// An assembly with each freedom of its contacts kept, in steady sliding.
pub(super) struct WithInterfaceFreedoms {
    built: BuiltAssembly,
    steady: SteadySliding,
}

impl WithInterfaceFreedoms {
    /// `None` where no freedoms of contacts are reduced.
    pub(super) fn of(of: &AssemblySubject<'_>) -> Result<Option<Self>, ModelError> {
        if !of.case.has_interface_modes() {
            return Ok(None);
        }
        let case: AssemblyCase = of.case.clone().with_interface_freedoms();
        let built = BuiltAssembly::new(&case)?;
        let finer = AssemblySubject { case: &case, built: &built, name: of.name };
        let steady = finer.steady(&finer.compliance()?)?;
        Ok(Some(Self { built, steady }))
    }

    /// ‖N − N′‖/‖N′‖ over the contact points; `None` where nothing presses.
    pub(super) fn of_forces(&self, steady: &SteadySliding) -> Option<f64> {
        let pairs = steady.points.iter().zip(&self.steady.points);
        let off = pairs.map(|(own, finer)| (own.normal_force - finer.normal_force).powi(2)).sum::<f64>();
        let all = self.steady.points.iter().map(|point| point.normal_force.powi(2)).sum::<f64>();
        (all > 0.0).then(|| (off / all).sqrt())
    }

    /// By how much eigenvalues of a region differ at most, over |λ|, each beside the nearest; why that is not known where there are not as
    /// many, or some may be missing.
    pub(super) fn of_eigenvalues(
        &self,
        eigenvalues: &[Complex64],
        terms: LinearisedTerms,
        asked: &AskedRegion,
    ) -> Result<Result<f64, String>, ModelError> {
        let about = Linearised::new(&self.built.assembly, &self.steady, terms)?;
        let found = complex_modes(
            &about.problem,
            &asked.rectangle(),
            &complex_mode_settings(about.problem.stiffness().val().len()),
        )?;
        let found = asked_of(found, asked);
        let mut finer: Vec<Complex64> = found.modes.iter().map(|mode| mode.eigenvalue.value).collect();
        let (own, all) = (eigenvalues.len(), finer.len());
        if own != all || !found.complete() {
            let least = if found.complete() { "" } else { "at least " };
            return Ok(Err(format!(
                "the error of interface modes is not known: with each freedom of the contacts kept there are {least}{all} modes in the \
                 searched region, here {own}; take more interface modes"
            )));
        }
        let mut largest = 0.0_f64;
        for own in eigenvalues {
            let distance = |k: &usize| (finer[*k] - own).modulus();
            let nearest = (0..finer.len()).min_by(|a, b| distance(a).total_cmp(&distance(b)));
            let Some(other) = nearest.map(|k| finer.swap_remove(k)) else { continue };
            largest = largest.max((other - own).modulus() / own.modulus());
        }
        Ok(Ok(largest))
    }
}
