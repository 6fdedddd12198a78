//! One body of an assembly, whole or reduced, and what acts on it.

use super::Unassembled;
use super::load::{Imposed, load};
use super::size::size_warning;
use super::turning::Turning;
use crate::assembly::case::AssemblyCase;
use crate::assembly::case::structure::{AssemblyStructure, BodyReduction, ReducedBody};
use crate::error::ModelError;
use crate::structure::build::{Structure, factors, symmetric_part};
use crate::structure::case::StructureCase;
use crate::structure::case::damping::Damping;
use crate::structure::case::reduction::FixedModes;
use faer::Mat;
use faer::sparse::Triplet;
use judder_assembly::AssemblyError;
use judder_assembly::assembly::{
    Gyroscopic, from_triplets, placed, sum, symmetric_part as symmetrised, triplets,
};
use judder_assembly::row::Row;
use judder_structure::assembly::{Sparse, inertia_load};
use judder_structure::craig_bampton::{CraigBampton, CutOff};
use judder_structure::freedom::{Direction, Numbering, Supports};
use judder_structure::interface_modes::InterfaceModes;
use num_complex::Complex64;
use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::TAU;

/// A body with its matrices on its freedoms, or on what a reduction leaves of them: its coordinates.
pub(crate) struct BuiltBody {
    /// Its name in the case.
    pub(crate) name: String,
    pub(crate) structure: Structure,
    pub(crate) matrices: BodyMatrices,
    /// f in N.
    pub(crate) load: Vec<f64>,
    /// The centrifugal force, which is part of the load, on its freedoms.
    centrifugal: Option<Vec<f64>>,
    /// Held displacements that loads impose, in m.
    pub(crate) imposed: Imposed,
    /// Where its coordinates begin among those of the assembly.
    pub(crate) first: usize,
    /// Where its freedoms begin among those of all bodies.
    pub(crate) first_freedom: usize,
    /// T of a reduced body.
    pub(super) basis: Option<Mat<f64>>,
    /// The coordinate of each freedom; `None` where a reduction does not keep it.
    coordinates: Vec<Option<usize>>,
    /// Freedoms that follow from interface modes, as forms on its coordinates.
    on_interface: BTreeMap<usize, Row>,
    pub(crate) warnings: Vec<String>,
}

/// M, C and K of a body, and G where it turns.
pub(crate) struct BodyMatrices {
    pub(crate) mass: Sparse,
    pub(crate) damping: Sparse,
    pub(crate) stiffness: Sparse,
    pub(crate) gyroscopic: Option<Sparse>,
}

impl BuiltBody {
    /// The structure of a body, read and assembled.
    pub(super) fn structure(case: &AssemblyCase, index: usize) -> Result<Structure, Unassembled> {
        let made = Structure::new(&alone(case, index));
        made.map_err(|unbuilt| unbuilt.of_structure(&case.structures[index].name).into())
    }

    /// A body whose coordinates and freedoms begin behind `before`, and whose nodes `touching` need their freedoms.
    pub(super) fn new(
        case: &AssemblyCase,
        index: usize,
        structure: Structure,
        touching: TouchingNodes,
        [first, first_freedom]: [usize; 2],
    ) -> Result<Self, Unassembled> {
        let own = &case.structures[index];
        let (load, imposed) = load(case, index, &structure)?;
        let matrices = matrices(case, index, &structure)?;
        let mut warnings: Vec<String> = size_warning(&own.name, &own.source, &structure)
            .into_iter()
            .chain(structure.warnings.iter().cloned())
            .collect();
        let turning =
            Turning::new(own, &structure, [&matrices.stiffness, &matrices.mass], &imposed, &mut warnings)?;
        let mut body = Self {
            name: own.name.to_string(),
            coordinates: (0..load.len()).map(Some).collect(),
            matrices,
            load,
            centrifugal: None,
            imposed,
            first,
            first_freedom,
            basis: None,
            on_interface: BTreeMap::new(),
            warnings,
            structure,
        };
        let path = |key: &str| format!("structure.{}.{key}", own.name);
        let softening = match turning {
            Some(turning) => {
                body.turn(turning).map_err(|error| Unassembled::because(path("rotation"), &error))?
            }
            None => None,
        };
        if let BodyReduction::Modes(reduced) = own.reduction {
            let refused = |error: AssemblyError| Unassembled::because(path("reduction"), &error);
            body.reduce(reduced, &touching).map_err(refused)?;
        }
        if let Some(softening) = softening {
            body.soften(&softening).map_err(|error| Unassembled::because(path("rotation"), &error))?;
        }
        Ok(body)
    }

    /// How many coordinates a body has at least, which is known before its reduction is made.
    pub(super) fn least_size(
        case: &AssemblyCase,
        index: usize,
        structure: &Structure,
        touching: &TouchingNodes,
    ) -> Result<usize, Unassembled> {
        let (load, _) = load(case, index, structure)?;
        let BodyReduction::Modes(reduced) = case.structures[index].reduction else { return Ok(load.len()) };
        let is_needed = |freedom: &usize| load[*freedom] != 0.0;
        let mut kept: BTreeSet<usize> = (0..load.len()).filter(is_needed).collect();
        kept.extend(freedoms_of(structure, &touching.joined));
        // those of contacts may become interface modes
        if reduced.interface_modes.is_none() {
            kept.extend(freedoms_of(structure, &touching.in_contact));
        }
        let modes = if let FixedModes::Count(count) = reduced.modes { count } else { 0 };
        Ok(load.len().min(kept.len() + modes))
    }

    /// How many coordinates it has.
    pub(crate) fn size(&self) -> usize {
        self.load.len()
    }

    /// How many freedoms it has, whatever a reduction keeps.
    pub(crate) fn freedoms(&self) -> usize {
        self.coordinates.len()
    }

    /// Where coordinates and freedoms of the next body begin.
    pub(super) fn end(&self) -> [usize; 2] {
        [self.first + self.size(), self.first_freedom + self.freedoms()]
    }

    /// The displacement of a point as a form on the coordinates of the assembly; empty where it is held.
    pub(super) fn displacement(&self, point: usize, direction: Direction) -> Row {
        let layout = self.structure.layout.as_ref();
        let freedom = layout.and_then(|layout| layout.freedoms.get(point)?[direction as usize]);
        let Some(freedom) = freedom else { return Row::default() };
        match (self.coordinates[freedom], self.on_interface.get(&freedom)) {
            (Some(coordinate), _) => Row::of_freedom(self.first + coordinate),
            (None, Some(row)) => row.clone(),
            (None, None) => Row::default(),
        }
    }

    /// The displacement of any point as a form on the coordinates of the assembly, also of one that a reduction does not keep.
    pub(super) fn seen(&self, point: usize, direction: Direction) -> Row {
        let layout = self.structure.layout.as_ref();
        let freedom = layout.and_then(|layout| layout.freedoms.get(point)?[direction as usize]);
        match (freedom, &self.basis) {
            (Some(freedom), Some(basis)) => {
                Row::new((0..basis.ncols()).map(|k| (self.first + k, basis[(freedom, k)])).collect())
            }
            (Some(freedom), None) => Row::of_freedom(self.first + freedom),
            (None, _) => Row::default(),
        }
    }

    /// How a point is displaced whatever happens, in m.
    pub(super) fn displaced(&self, point: usize) -> [f64; 3] {
        Direction::ALL.map(|direction| self.imposed.get(&(point, direction)).copied().unwrap_or(0.0))
    }

    /// A shape on its freedoms from one on its coordinates.
    pub(super) fn expanded(&self, shape: &[Complex64]) -> Vec<Complex64> {
        let Some(basis) = &self.basis else { return shape.to_vec() };
        let row = |i: usize| shape.iter().enumerate().map(|(k, z)| z * basis[(i, k)]).sum();
        (0..basis.nrows()).map(row).collect()
    }

    /// Its mass without that of its points, in kg: the force that accelerates all of it; unknown of matrices.
    pub(crate) fn whole_mass(&self) -> Result<Option<f64>, ModelError> {
        let Some(elements) = &self.structure.elements else { return Ok(None) };
        let free = Numbering::new(&elements.mesh, elements.numbering.dimension(), &Supports::default())?;
        let load = inertia_load(&elements.mesh, &elements.materials, &free, [1.0, 0.0, 0.0])?;
        Ok(Some(load.iter().sum()))
    }

    /// Forces on its freedoms as forces on its coordinates.
    pub(super) fn on_basis(&self, forces: Vec<f64>) -> Vec<f64> {
        let Some(basis) = &self.basis else { return forces };
        let along = |k: usize| forces.iter().enumerate().map(|(i, force)| basis[(i, k)] * force).sum();
        (0..basis.ncols()).map(along).collect()
    }

    /// How a coordinate moves it, in words.
    pub(super) fn moves(&self, coordinate: usize) -> String {
        let freedom = self.coordinates.iter().position(|own| *own == Some(coordinate));
        let place = freedom.and_then(|freedom| {
            let layout = self.structure.layout.as_ref()?;
            let along = |own: &[Option<usize>; 3]| own.iter().position(|own| *own == Some(freedom));
            let places = layout.freedoms.iter().enumerate();
            let (point, axis) = places.filter_map(|(point, own)| Some((point, along(own)?))).next()?;
            Some(format!("along {}, most at {}", Direction::ALL[axis], layout.word(point)))
        });
        place.unwrap_or_else(|| format!("in coordinate {coordinate}"))
    }

    /// Adds what turning does, but for what it takes of the stiffness, which is left over: the modes of a reduction are those without it.
    fn turn(&mut self, turning: Turning) -> Result<Option<Sparse>, AssemblyError> {
        let Turning { gyroscopic, softening, centrifugal } = turning;
        self.matrices.gyroscopic = gyroscopic;
        if let Some((stiffness, load)) = centrifugal {
            self.matrices.stiffness = sum(&self.matrices.stiffness, std::iter::once(&stiffness))?;
            self.load.iter_mut().zip(&load).for_each(|(load, own)| *load += own);
            self.centrifugal = Some(load);
        }
        Ok(softening)
    }

    /// Takes off what turning takes of the stiffness.
    fn soften(&mut self, softening: &Sparse) -> Result<(), AssemblyError> {
        let own = match &self.basis {
            Some(basis) => projected(basis, softening)?,
            None => softening.clone(),
        };
        let taken = triplets(&own).map(|entry| Triplet::new(entry.row, entry.col, -entry.val));
        let taken = from_triplets(own.nrows(), own.ncols(), &taken.collect::<Vec<_>>())?;
        // a projection is symmetric but for rounding
        self.matrices.stiffness = symmetrised(&sum(&self.matrices.stiffness, std::iter::once(&taken))?)?;
        Ok(())
    }

    /// The body on the freedoms that contacts and loads need, or on interface modes of the contacts, and fixed-interface modes.
    fn reduce(&mut self, asked: ReducedBody, touching: &TouchingNodes) -> Result<(), AssemblyError> {
        let joined = freedoms_of(&self.structure, &touching.joined);
        let of_contacts = freedoms_of(&self.structure, &touching.in_contact);
        // the centrifugal force acts everywhere, and needs none
        let of_load =
            |(k, force): (usize, &f64)| *force != self.centrifugal.as_ref().map_or(0.0, |own| own[k]);
        let mut needed: Vec<bool> = self.load.iter().enumerate().map(of_load).collect();
        joined.into_iter().for_each(|freedom| needed[freedom] = true);
        let is_kept = needed.clone();
        of_contacts.into_iter().for_each(|freedom| needed[freedom] = true);
        let kept: Vec<usize> = (0..needed.len()).filter(|freedom| needed[*freedom]).collect();
        let cut_off = match asked.modes {
            FixedModes::Count(count) => CutOff::Count(count),
            FixedModes::CutOff(limit) => CutOff::Frequency(limit / TAU),
        };
        let reduced = CraigBampton::new(&self.matrices.stiffness, &self.matrices.mass, &kept, cut_off)?;
        self.coordinates = vec![None; needed.len()];
        let Some(count) = asked.interface_modes else {
            for (coordinate, freedom) in kept.iter().enumerate() {
                self.coordinates[*freedom] = Some(coordinate);
            }
            return self.project(reduced.basis, &reduced.mass, &reduced.stiffness);
        };
        let (others, interface): (Vec<usize>, Vec<usize>) =
            (0..kept.len()).partition(|place| is_kept[kept[*place]]);
        let InterfaceModes { mass, stiffness, basis, shapes, first, .. } =
            InterfaceModes::new(&reduced, &interface, count)?;
        for (coordinate, place) in others.iter().enumerate() {
            self.coordinates[kept[*place]] = Some(coordinate);
        }
        for (row, place) in interface.iter().enumerate() {
            let of_mode = |mode: usize| (self.first + first + mode, shapes[(row, mode)]);
            self.on_interface.insert(kept[*place], Row::new((0..shapes.ncols()).map(of_mode).collect()));
        }
        self.project(basis, &mass, &stiffness)
    }

    /// Its matrices and loads on the coordinates of a basis, on which mass and stiffness are known.
    fn project(
        &mut self,
        basis: Mat<f64>,
        mass: &Mat<f64>,
        stiffness: &Mat<f64>,
    ) -> Result<(), AssemblyError> {
        let BodyMatrices { damping, gyroscopic, .. } = &self.matrices;
        self.matrices = BodyMatrices {
            mass: sparse(mass)?,
            damping: projected(&basis, damping)?,
            stiffness: sparse(stiffness)?,
            gyroscopic: gyroscopic.as_ref().map(|own| projected(&basis, own)).transpose()?,
        };
        self.basis = Some(basis);
        let load = std::mem::take(&mut self.load);
        self.load = self.on_basis(load);
        Ok(())
    }
}

/// The nodes of a body whose freedoms others need.
pub(super) struct TouchingNodes {
    /// Those of contacts,
    pub(super) in_contact: Vec<usize>,
    /// and those of springs and ties.
    pub(super) joined: Vec<usize>,
}

/// The freedoms of nodes.
fn freedoms_of(structure: &Structure, nodes: &[usize]) -> Vec<usize> {
    let layout = structure.layout.iter();
    let of_nodes = layout.flat_map(|layout| nodes.iter().filter_map(|node| layout.freedoms.get(*node)));
    of_nodes.flatten().flatten().copied().collect()
}

/// A body as a case of its own.
fn alone(case: &AssemblyCase, index: usize) -> StructureCase {
    let own = &case.structures[index];
    StructureCase::alone(&case.title, &case.parameters, &own.source, own.damping())
}

/// M with its point masses, C and K; what α of Rayleigh's damping stands before is all of M.
pub(super) fn matrices(
    case: &AssemblyCase,
    index: usize,
    structure: &Structure,
) -> Result<BodyMatrices, Unassembled> {
    let own = &case.structures[index];
    let path = format!("structure.{}", own.name);
    let refused = |error: &dyn std::fmt::Display| Unassembled::because(path.as_str(), &error.to_string());
    let factors = factors(&alone(case, index), &case.values()).map_err(|error| refused(&error))?;
    let [mass, damping, stiffness] = structure.family.matrices(&factors).map_err(|error| refused(&error))?;
    let points = point_masses(own, structure)?;
    let alpha = if let Damping::Rayleigh(rayleigh) = own.damping() { rayleigh.alpha } else { 0.0 };
    let added = |matrix: &Sparse, factor: f64| {
        let on_points = points.iter().map(|(freedom, mass)| Triplet::new(*freedom, *freedom, factor * mass));
        let entries: Vec<_> = triplets(matrix).chain(on_points).collect();
        from_triplets(matrix.nrows(), matrix.ncols(), &entries).map_err(|error| refused(&error))
    };
    let (part, departure) = symmetric_part(&stiffness).map_err(|error| refused(&error))?;
    let is_symmetric = departure <= ROUNDING;
    if !is_symmetric && own.reduction != BodyReduction::None {
        let reason = "its stiffness is not symmetric, and fixed-interface modes are those of a symmetric one: leave `reduction` out";
        return Err(Unassembled::because(format!("{path}.reduction"), &reason));
    }
    let stiffness = if is_symmetric { part } else { stiffness };
    let (mass, damping) = (added(&mass, 1.0)?, added(&damping, alpha)?);
    Ok(BodyMatrices { mass, damping, stiffness, gyroscopic: None })
}

/// Departure from symmetry that is rounding.
const ROUNDING: f64 = 1e-12;

/// The freedoms that point masses move, and the mass on each.
pub(super) fn point_masses(
    own: &AssemblyStructure,
    structure: &Structure,
) -> Result<Vec<(usize, f64)>, Unassembled> {
    let Some(layout) = &structure.layout else { return Ok(Vec::new()) };
    let mut found = Vec::new();
    for (index, point) in own.masses.iter().enumerate() {
        let nodes = structure
            .set(&point.set, &format!("structure.masses.{index}.set"))
            .map_err(|unbuilt| unbuilt.of_structure(&own.name))?;
        let share = point.mass / nodes.len() as f64;
        let freedoms = nodes.iter().flat_map(|node| layout.freedoms[*node]).flatten();
        found.extend(freedoms.map(|freedom| (freedom, share)));
    }
    Ok(found)
}

/// A dense matrix as a sparse one, zeros left out.
fn sparse(matrix: &Mat<f64>) -> Result<Sparse, AssemblyError> {
    let all = (0..matrix.ncols()).flat_map(|j| (0..matrix.nrows()).map(move |i| (i, j)));
    let entries = all.map(|(i, j)| Triplet::new(i, j, matrix[(i, j)]));
    let entries: Vec<_> = entries.filter(|entry| entry.val != 0.0).collect();
    from_triplets(matrix.nrows(), matrix.ncols(), &entries)
}

/// Tᵀ A T.
fn projected(basis: &Mat<f64>, matrix: &Sparse) -> Result<Sparse, AssemblyError> {
    let mut image = Mat::<f64>::zeros(basis.nrows(), basis.ncols());
    for Triplet { row, col, val } in triplets(matrix) {
        for k in 0..basis.ncols() {
            image[(row, k)] += val * basis[(col, k)];
        }
    }
    sparse(&(basis.transpose() * image))
}

/// The gyroscopic matrices on the freedoms of all bodies.
pub(super) fn gyroscopic(bodies: &[BuiltBody]) -> Result<Vec<Gyroscopic>, Unassembled> {
    let all = bodies.iter().map(BuiltBody::size).sum();
    let of_body = |body: &BuiltBody| {
        let own = body.matrices.gyroscopic.as_ref()?;
        let failed = |error| Unassembled::because(format!("structure.{}", body.name), &error);
        let matrix = placed(own, body.first, all).map_err(failed);
        Some(matrix.map(|matrix| Gyroscopic { body: body.name.clone(), matrix: matrix.into() }))
    };
    bodies.iter().filter_map(of_body).collect()
}
