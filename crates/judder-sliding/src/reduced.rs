//! A reduced structure as the contact sees it.

use crate::SlidingError;
use crate::body::Body;
use judder_structure::StructureError;
use judder_structure::craig_bampton::CraigBampton;
use judder_structure::modal_form::ModalForm;

/// A structure in modal form with the rows of its kept freedoms.
#[derive(Debug, Clone)]
pub struct Reduced {
    /// Its modes; those of rigid motions have exactly λ = 0.
    pub body: Body,
    form: ModalForm,
    /// Tᵀ f of the inertia load of a unit acceleration, in reduced coordinates.
    inertia: Vec<f64>,
}

impl Reduced {
    /// All modes of a reduced structure with Rayleigh damping α, β. Those up to `rigid`, in 1/s², are rigid motions: what rounding in the
    /// matrices of the full structure makes of zero ([`judder_structure::rigid::rigid_limit`] of them). `inertia_load` is that of a unit acceleration of its frame on the
    /// freedoms of the full structure, in kg.
    ///
    /// # Errors
    /// [`StructureError::NoModalForm`].
    pub fn new(
        reduced: &CraigBampton,
        alpha: f64,
        beta: f64,
        rigid: f64,
        inertia_load: &[f64],
    ) -> Result<Self, StructureError> {
        let form = reduced.modal_form()?;
        let clean = |value: &f64| if *value <= rigid { 0.0 } else { *value };
        let body = Body { eigenvalues: form.eigenvalues.iter().map(clean).collect(), alpha, beta };
        let basis = &reduced.basis;
        let on = |column: usize| {
            inertia_load.iter().enumerate().map(|(row, load)| basis[(row, column)] * load).sum()
        };
        let inertia = if inertia_load.is_empty() { Vec::new() } else { (0..basis.ncols()).map(on).collect() };
        Ok(Self { body, form, inertia })
    }

    /// The row of Φ of a kept freedom, by its place among those kept; zeros where it is held.
    ///
    /// # Errors
    /// [`SlidingError::Length`] for a freedom that is not kept.
    pub fn row(&self, kept: Option<usize>) -> Result<Vec<f64>, SlidingError> {
        let modes = self.body.modes();
        match kept {
            None => Ok(vec![0.0; modes]),
            Some(kept) if kept < self.form.kept => {
                Ok((0..modes).map(|mode| self.form.shapes[(kept, mode)]).collect())
            }
            Some(kept) => Err(SlidingError::Length {
                name: "the list of kept freedoms".to_owned(),
                found: self.form.kept,
                expected: kept + 1,
            }),
        }
    }

    /// Φᵀ M 1 by mode, √kg.
    #[must_use]
    pub fn inertia(&self) -> Vec<f64> {
        let of = |mode: usize| {
            self.inertia.iter().enumerate().map(|(k, load)| self.form.shapes[(k, mode)] * load).sum()
        };
        (0..self.body.modes()).map(of).collect()
    }
}
