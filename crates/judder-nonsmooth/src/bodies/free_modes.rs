//! The modes of all bodies together, which their damping leaves free of each other.

use faer::Mat;
use judder_assembly::assembly::{Assembly, is_symmetric};
use judder_dense::symmetric::generalised;
use judder_structure::assembly::Sparse;

/// Freedoms up to which all modes are computed: some seconds.
const MOST: usize = 1200;
/// Damping between modes that is rounding, as a share of the modes' own.
const ROUNDING: f64 = 1e-8;

/// z̈ + d ż + λ z = Φᵀ f of each mode, with q = Φ z and Φᵀ M Φ = 1.
#[derive(Debug, Clone)]
pub struct FreeModes {
    /// λ in rad²/s², ascending.
    pub eigenvalues: Vec<f64>,
    /// d in 1/s.
    pub damping: Vec<f64>,
    /// Φ, freedoms × modes, in 1/√kg.
    pub shapes: Mat<f64>,
    /// M Φ, in √kg.
    pub weighted: Mat<f64>,
}

impl FreeModes {
    /// Those of an assembly without its contacts; `None` where they are too many, their damping joins them, or a matrix is not symmetric.
    #[must_use]
    pub fn new(assembly: &Assembly) -> Option<Self> {
        let freedoms = assembly.size();
        let symmetric = is_symmetric(&assembly.stiffness) && is_symmetric(&assembly.mass);
        if freedoms == 0 || freedoms > MOST || !assembly.gyroscopic.is_empty() || !symmetric {
            return None;
        }
        let mass = assembly.mass.to_dense();
        let eigen = generalised(assembly.stiffness.to_dense(), &mass)?;
        let damping = modal_damping(&assembly.damping, &eigen.vectors, &eigen.values)?;
        let weighted = judder_dense::product::product(mass.as_ref(), eigen.vectors.as_ref());
        Some(Self { eigenvalues: eigen.values, damping, shapes: eigen.vectors, weighted })
    }
}

/// d of each mode, where Φᵀ C Φ has no other entries.
fn modal_damping(damping: &Sparse, shapes: &Mat<f64>, eigenvalues: &[f64]) -> Option<Vec<f64>> {
    let product = judder_dense::product::product(damping.to_dense().as_ref(), shapes.as_ref());
    let projected = judder_dense::product::product(shapes.transpose(), product.as_ref());
    let size = shapes.ncols();
    let own: Vec<f64> = (0..size).map(|mode| projected[(mode, mode)]).collect();
    let largest = own.iter().fold(0.0_f64, |most, own| most.max(own.abs()));
    let fastest = eigenvalues.iter().fold(0.0_f64, |most, own| most.max(own.abs())).sqrt();
    let joins = |i: usize, j: usize| {
        let size = (own[i].abs() * own[j].abs()).sqrt().max(f64::EPSILON * largest.max(fastest));
        projected[(i, j)].abs() > ROUNDING * size
    };
    let is_free = (0..size).all(|i| (0..i).all(|j| !joins(i, j) && !joins(j, i)));
    is_free.then_some(own)
}
