//! How the contact points yield under forces at contact points.

use crate::AssemblyError;
use crate::assembly::{Assembly, from_triplets, triplets};
use crate::interface::FramedPoint;
use crate::row::Row;
use faer::Mat;
use faer::sparse::Triplet;
use judder_structure::assembly::Sparse;
use judder_structure::factor::SymmetricFactor;
use judder_structure::modes::{WantedModes, below, modes};
use judder_structure::rigid::{largest_ratio, rigid_limit};
use rayon::prelude::*;

/// The compliance of an assembly on its contact points, which no friction coefficient enters.
///
/// A body that contacts alone hold has no compliance of its own, so springs s hold the closures of all points:
/// (K + s Σ cᵀc) q = f + Σ (N cᵀ + T tᵀ) + s Σ cᵀ y with y = c q. On the points
///
/// y = y_f + S_nn (N + s y) + S_nt T,
///
/// which is true for every s.
#[derive(Debug)]
pub struct Compliance {
    /// S_nn in m/N: how the points open along their normals under unit forces along the normals, points².
    pub(crate) of_normal: Mat<f64>,
    /// S_nt in m/N: the same under unit forces along the slips.
    pub(crate) of_slip: Mat<f64>,
    /// y_f in m: how they open under the loads.
    pub(crate) of_load: Vec<f64>,
    /// s in N/m.
    pub(crate) spring: f64,
    factor: SymmetricFactor,
}

/// Contact points whose dense matrices are held, half a dozen of them: 5 GB.
const MOST_POINTS: usize = 10_000;
/// Right sides that are solved together: the factor is read once for all of them.
const TOGETHER: usize = 8;

impl Compliance {
    /// The compliance of the contact points, one solution a point.
    ///
    /// # Errors
    /// [`AssemblyError::TooManyPoints`], [`AssemblyError::RigidMotion`] where a motion is held neither by supports nor by contacts, what [`Assembly::framed`] says, and
    /// of a factorisation that does not fit into memory.
    pub fn new(assembly: &Assembly) -> Result<Self, AssemblyError> {
        Self::of_points(assembly, &assembly.framed()?)
    }

    pub(crate) fn of_points(assembly: &Assembly, points: &[FramedPoint<'_>]) -> Result<Self, AssemblyError> {
        if points.len() > MOST_POINTS {
            return Err(AssemblyError::TooManyPoints { points: points.len(), most: MOST_POINTS });
        }
        let spring = spring(&assembly.stiffness, points);
        let held = with_springs(&assembly.stiffness, points, spring)?;
        check_held(&held, &assembly.mass)?;
        let factor = SymmetricFactor::new(&held)?;
        let solve = |points: &[FramedPoint<'_>]| -> Vec<Vec<f64>> {
            let mut rights: [Vec<f64>; TOGETHER] = std::array::from_fn(|k| {
                let mut right = vec![0.0; assembly.size()];
                points.get(k).into_iter().for_each(|point| point.frame.normal.add_to(1.0, &mut right));
                right
            });
            factor.solve_together(rights.each_mut().map(Vec::as_mut_slice));
            rights.into_iter().take(points.len()).collect()
        };
        // K is symmetric: c_i K⁻¹ t_jᵀ = t_j K⁻¹ c_iᵀ, so solutions for the normals are enough
        let columns: Vec<(Vec<f64>, Vec<f64>)> = points
            .par_chunks(TOGETHER)
            .flat_map_iter(|chunk| {
                solve(chunk).into_iter().map(|moved| {
                    let normal = points.iter().map(|point| point.frame.normal.of(&moved)).collect();
                    (normal, points.iter().map(|point| point.frame.slip.of(&moved)).collect())
                })
            })
            .collect();
        let mut of_load = assembly.load.clone();
        factor.solve(&mut of_load);
        Ok(Self {
            of_normal: Mat::from_fn(points.len(), points.len(), |i, j| columns[j].0[i]),
            of_slip: Mat::from_fn(points.len(), points.len(), |i, j| columns[i].1[j]),
            of_load: points.iter().map(|point| point.frame.normal.of(&of_load)).collect(),
            spring,
            factor,
        })
    }

    /// q under the loads, the forces of the points and their openings y.
    pub(crate) fn displacement(
        &self,
        load: &[f64],
        points: &[FramedPoint<'_>],
        normal: &[f64],
        friction: &[f64],
        opening: &[f64],
    ) -> Vec<f64> {
        let mut q = load.to_vec();
        for (k, point) in points.iter().enumerate() {
            point.frame.normal.add_to(normal[k] + self.spring * opening[k], &mut q);
            point.frame.slip.add_to(friction[k], &mut q);
        }
        self.factor.solve(&mut q);
        q
    }
}

/// A stiffness as of the bodies at their contact points, so that both are of one size; of bodies without any, 1 N/m.
fn spring(stiffness: &Sparse, points: &[FramedPoint<'_>]) -> f64 {
    let diagonal = |freedom: usize| {
        let mut entries = stiffness.row_idx_of_col(freedom).zip(stiffness.val_of_col(freedom));
        entries.find(|(row, _)| *row == freedom).map_or(0.0, |(_, value)| value.abs())
    };
    let touched = points.iter().flat_map(|point| point.frame.normal.entries());
    let largest = touched.map(|(freedom, _)| diagonal(*freedom)).fold(0.0, f64::max);
    if largest > 0.0 { largest } else { 1.0 }
}

/// K + s Σ cᵀc.
fn with_springs(
    stiffness: &Sparse,
    points: &[FramedPoint<'_>],
    spring: f64,
) -> Result<Sparse, AssemblyError> {
    let mut entries: Vec<_> = triplets(stiffness).collect();
    for point in points {
        entries.extend(outer(spring, &point.frame.normal, &point.frame.normal));
    }
    from_triplets(stiffness.nrows(), stiffness.ncols(), &entries)
}

/// The entries of f aᵀ b.
pub(crate) fn outer<'a>(
    factor: f64,
    a: &'a Row,
    b: &'a Row,
) -> impl Iterator<Item = Triplet<usize, usize, f64>> + 'a {
    let entry = move |(row, a): &(usize, f64)| {
        let (row, a) = (*row, *a);
        b.entries().iter().map(move |(column, b)| Triplet::new(row, *column, factor * a * b))
    };
    a.entries().iter().flat_map(entry)
}

/// Refuses bodies that can move without force although springs hold every contact.
fn check_held(stiffness: &Sparse, mass: &Sparse) -> Result<(), AssemblyError> {
    let motions = rigid_motions(stiffness, mass)?;
    if motions == 0 {
        return Ok(());
    }
    let found = modes(stiffness, mass, WantedModes::Lowest(1))?;
    let shape = found.modes.into_iter().next().map(|mode| mode.shape).unwrap_or_default();
    let largest = |best: usize, k: usize| if shape[k].abs() > shape[best].abs() { k } else { best };
    Err(AssemblyError::RigidMotion { motions, freedom: (0..shape.len()).fold(0, largest), shape })
}

/// How many motions there are without force.
pub(crate) fn rigid_motions(stiffness: &Sparse, mass: &Sparse) -> Result<usize, AssemblyError> {
    let limit = rigid_limit(stiffness.nrows(), largest_ratio(stiffness, mass));
    Ok(below(stiffness, mass, limit)?)
}
