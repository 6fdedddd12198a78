//! How the contact points yield under forces at contact points.

use crate::AssemblyError;
use crate::assembly::{Assembly, from_triplets, is_symmetric, triplets};
use crate::interface::FramedPoint;
use crate::row::Row;
use faer::Mat;
use faer::sparse::Triplet;
use judder_numerics::parallel;
use judder_structure::assembly::Sparse;
use judder_structure::factor::SymmetricFactor;
use judder_structure::modes::{WantedModes, below, modes};
use judder_structure::rigid::{largest_ratio, rigid_limit};
use judder_structure::statics::{GeneralStatics, product};
use std::sync::Arc;

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
    factor: Factor,
    /// The forms of the points along their normals and along the slips, K and f that it was made of.
    forms: Vec<[Row; 2]>,
    stiffness: Arc<Sparse>,
    load: Vec<f64>,
}

/// Contact points whose dense matrices are held, half a dozen of them: 5 GB.
const MOST_POINTS: usize = 10_000;

impl Compliance {
    /// The compliance of the contact points: of a symmetric stiffness from its elimination, of another one solution a point.
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
        let factor = Factor::held(&held, assembly)?;
        let [of_normal, of_slip] = factor.on_points(points, assembly.size());
        let mut of_load = assembly.load.clone();
        factor.solve(&mut of_load);
        Ok(Self {
            of_normal,
            of_slip,
            of_load: points.iter().map(|point| point.frame.normal.of(&of_load)).collect(),
            spring,
            factor,
            forms: forms(points).collect(),
            stiffness: Arc::clone(&assembly.stiffness),
            load: assembly.load.clone(),
        })
    }

    /// Whether it is that of another assembly too: of one with the same stiffness, load and directions of its points.
    ///
    /// # Errors
    /// As of [`Assembly::framed`].
    pub fn is_of(&self, assembly: &Assembly) -> Result<bool, AssemblyError> {
        let points = assembly.framed()?;
        let same_points =
            points.len() == self.forms.len() && forms(&points).zip(&self.forms).all(|(a, b)| a == *b);
        let [own, other] = [&self.stiffness, &assembly.stiffness];
        let is_alike = || {
            own.col_ptr() == other.col_ptr() && own.row_idx() == other.row_idx() && own.val() == other.val()
        };
        let same_stiffness = Arc::ptr_eq(own, other) || is_alike();
        Ok(same_points && same_stiffness && self.load == assembly.load)
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

/// What enters the compliance of points.
fn forms<'a>(points: &'a [FramedPoint<'_>]) -> impl Iterator<Item = [Row; 2]> + 'a {
    points.iter().map(|point| [point.frame.normal.clone(), point.frame.slip.clone()])
}

/// A stiffness that is factored: symmetric, or with the circulation that bodies bring.
#[derive(Debug)]
enum Factor {
    Symmetric(SymmetricFactor),
    General(Box<GeneralStatics>),
}

impl Factor {
    /// Of a stiffness that lets no body move without force.
    fn held(stiffness: &Sparse, assembly: &Assembly) -> Result<Self, AssemblyError> {
        if !is_symmetric(stiffness) {
            check_held(stiffness, assembly)?;
            return Ok(Self::General(Box::new(GeneralStatics::new(stiffness)?)));
        }
        let factor = SymmetricFactor::new(stiffness);
        if !factor.as_ref().is_ok_and(|factor| is_clearly_held(factor, stiffness, &assembly.mass)) {
            check_held(stiffness, assembly)?;
        }
        Ok(Self::Symmetric(factor?))
    }

    fn solve(&self, load: &mut [f64]) {
        match self {
            Self::Symmetric(factor) => factor.solve(load),
            Self::General(factor) => factor.solve(load),
        }
    }

    /// S_nn and S_nt.
    fn on_points(&self, points: &[FramedPoint<'_>], size: usize) -> [Mat<f64>; 2] {
        let count = points.len();
        match self {
            Self::Symmetric(factor) => {
                let normals = points.iter().map(|point| point.frame.normal.entries());
                let slips = points.iter().map(|point| point.frame.slip.entries());
                let all = factor.compliance(&normals.chain(slips).collect::<Vec<_>>(), count);
                [all.subcols(0, count).to_owned(), all.subcols(count, count).to_owned()]
            }
            Self::General(factor) => {
                let opened = |row: &Row| -> Vec<f64> {
                    let mut moved = vec![0.0; size];
                    row.add_to(1.0, &mut moved);
                    factor.solve(&mut moved);
                    points.iter().map(|point| point.frame.normal.of(&moved)).collect()
                };
                [0, 1].map(|which| {
                    let of_point = |point: &FramedPoint<'_>| {
                        opened(if which == 0 { &point.frame.normal } else { &point.frame.slip })
                    };
                    let columns: Vec<Vec<f64>> = parallel::each(points, of_point);
                    Mat::from_fn(count, count, |i, j| columns[j][i])
                })
            }
        }
    }
}

/// Whether no motion is anywhere near to be without force, by inverse iteration with the factors of a stiffness.
///
/// Doubt is no answer: what does without force is then counted.
fn is_clearly_held(factor: &SymmetricFactor, stiffness: &Sparse, mass: &Sparse) -> bool {
    /// An eigenvalue so many times the one that rounding makes of zero is not zero.
    const CLEARLY: f64 = 1e3;
    let limit = rigid_limit(stiffness.nrows(), largest_ratio(stiffness, mass));
    factor.negative_eigenvalues() == 0 && softest(mass, &|moved| factor.solve(moved)).1 > CLEARLY * limit
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
fn check_held(stiffness: &Sparse, assembly: &Assembly) -> Result<(), AssemblyError> {
    let mass = &assembly.mass;
    let largest = |shape: Vec<f64>, motions: usize| {
        let largest = |best: usize, k: usize| if shape[k].abs() > shape[best].abs() { k } else { best };
        AssemblyError::RigidMotion { motions, freedom: (0..shape.len()).fold(0, largest), shape }
    };
    if !is_symmetric(stiffness) {
        return motion_without_force(stiffness, mass)?.map_or(Ok(()), |shape| Err(largest(shape, 1)));
    }
    let motions = rigid_motions(stiffness, assembly)?;
    if motions == 0 {
        return Ok(());
    }
    let limit = rigid_limit(stiffness.nrows(), largest_ratio(stiffness, mass));
    let pushed = if assembly.gyroscopic.is_empty() { below(stiffness, mass, -limit)? } else { 0 };
    if pushed > 0 && pushed == motions {
        return Err(AssemblyError::PushedOn { motions: pushed });
    }
    let found = modes(stiffness, mass, WantedModes::Lowest(1))?;
    Err(largest(found.modes.into_iter().next().map(|mode| mode.shape).unwrap_or_default(), motions))
}

/// How many motions there are without force; of a stiffness that is not symmetric whether there is one.
///
/// Of bodies that turn some motions may be pushed on by more than their stiffness resists, and gyroscopic forces hold them: these are not without force.
pub(crate) fn rigid_motions(stiffness: &Sparse, assembly: &Assembly) -> Result<usize, AssemblyError> {
    let mass = &assembly.mass;
    if !is_symmetric(stiffness) {
        return Ok(usize::from(motion_without_force(stiffness, mass)?.is_some()));
    }
    let limit = rigid_limit(stiffness.nrows(), largest_ratio(stiffness, mass));
    // nothing resists anything where there is no stiffness at all
    if limit == 0.0 {
        return Ok(stiffness.nrows());
    }
    let count = below(stiffness, mass, limit)?;
    if count == 0 || assembly.gyroscopic.is_empty() {
        return Ok(count);
    }
    Ok(count - below(stiffness, mass, -limit)?.min(count))
}

/// A motion that a stiffness, which need not be symmetric, does not resist: by inverse iteration on K + s M with s the largest
/// eigenvalue that rounding makes of zero.
fn motion_without_force(stiffness: &Sparse, mass: &Sparse) -> Result<Option<Vec<f64>>, AssemblyError> {
    let limit = rigid_limit(stiffness.nrows(), largest_ratio(stiffness, mass));
    let scaled = triplets(mass).map(|entry| Triplet::new(entry.row, entry.col, limit * entry.val));
    let entries: Vec<_> = triplets(stiffness).chain(scaled).collect();
    let factor = GeneralStatics::new(&from_triplets(stiffness.nrows(), stiffness.ncols(), &entries)?)?;
    let (shape, nearest) = softest(mass, &|moved| factor.solve(moved));
    // of a motion without force it is s itself
    Ok((nearest <= 3.0 * limit).then_some(shape))
}

/// The motion that a factored matrix resists least beside the mass, and by how much: the size of its eigenvalue.
fn softest(mass: &Sparse, solve: &dyn Fn(&mut [f64])) -> (Vec<f64>, f64) {
    /// Steps: each brings out what lies at zero by as much as it lies nearer than the rest.
    const STEPS: usize = 3;
    let size = |shape: &[f64]| shape.iter().map(|x| x * x).sum::<f64>().sqrt();
    let mut shape: Vec<f64> = (0..mass.nrows()).map(|k| 1.0 + 0.5 * libm::sin(k as f64)).collect();
    let mut nearest = f64::INFINITY;
    for _ in 0..STEPS {
        let before = size(&shape);
        shape.iter_mut().for_each(|x| *x /= before);
        let mut moved = product(mass, &shape);
        solve(&mut moved);
        nearest = 1.0 / size(&moved);
        shape = moved;
    }
    (shape, nearest)
}
