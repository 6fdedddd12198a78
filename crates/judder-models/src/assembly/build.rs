//! From the keys of an assembly case to bodies that touch.
//!
//! - `body`: one body, whole or reduced.
//! - `load`: what acts on it. `driven`: forces that change over time, inertia beside a base that moves.
//! - `turning`: what turning does to it, and what of that is left out.
//! - `interface`: contact points found, laws as the physics has them. `joint`: springs and ties.
//! - `interface_modes`: which bodies may have their contact freedoms reduced.
//! - `sphere`: laws of contacts that are a sphere on a substrate.
//! - `field`: fields over the bodies on the freedoms.
//! - `travel`: edges along which contact points travel.
//! - `watched`: observed points as forms on the freedoms.
//! - `deformed`: contact points of bodies as they lie in steady sliding.
//! - `size`: how large a body is.
//! - `shown`: all bodies as one, for pictures and files.

mod body;
mod deformed;
mod driven;
mod field;
mod interface;
mod interface_modes;
mod joint;
mod load;
mod shown;
mod size;
mod sphere;
mod travel;
mod turning;
mod watched;

pub(crate) use body::BuiltBody;
pub(crate) use shown::ShownBodies;
pub(crate) use size::extent;
pub(crate) use sphere::{SphereState, SubstrateSphere};
pub(crate) use travel::TrackEnd;
pub(crate) use watched::WatchedRow;

use crate::assembly::case::AssemblyCase;
use crate::assembly::case::problem::AssemblyProblem;
use crate::assembly::case::structure::BodyReduction;
use crate::assembly::quickly_found::QuicklyFound;
use crate::error::ModelError;
use crate::structure::build::{Structure, Unbuilt};
use interface::Touching;
use judder_assembly::AssemblyError;
use judder_assembly::assembly::{Assembly, stacked};
use judder_assembly::row::Row;
use judder_assembly::steady::SteadySliding;
use judder_assembly::tie::Bond;
use judder_cycles::CyclesError;
use judder_keys::cause::Cause;
use judder_nonsmooth::travel::TravellingContact;
use judder_structure::assembly::Sparse;
use judder_study::Progress;
use judder_study::case::text::CaseText;
use num_complex::Complex64;
use std::sync::{Arc, OnceLock};

/// Bodies that touch, their files read, their elements assembled, their contact points found.
pub(crate) struct BuiltAssembly {
    pub(crate) bodies: Arc<[BuiltBody]>,
    touching: Arc<Touching>,
    /// M, C and K of the bodies, without what joins them.
    matrices: [Arc<Sparse>; 3],
    pub(crate) assembly: Assembly,
    /// The slider's node of each contact point, by contact.
    pub(crate) nodes: Vec<Vec<usize>>,
    /// The sphere of each contact that is one.
    pub(crate) spheres: Vec<Option<Arc<SubstrateSphere>>>,
    /// Contacts whose points travel.
    pub(crate) travelling: Vec<TravellingContact>,
    /// Observed points, along each direction in which they move.
    pub(crate) watched: Vec<WatchedRow>,
    /// What of bodies that turn is left out, in words.
    pub(crate) left_out: Vec<String>,
    /// What the user has to know.
    pub(crate) warnings: Vec<String>,
    /// How the freedoms of the bodies follow from those that ties leave.
    bond: Option<Bond>,
    quickly_found: OnceLock<QuicklyFound>,
}

/// Why an assembly cannot be, and at which dotted path of the case.
#[derive(Debug)]
pub(crate) struct Unassembled {
    pub(crate) path: String,
    pub(crate) cause: Box<Cause>,
}

impl Unassembled {
    pub(crate) fn new(path: impl Into<String>, problem: impl Into<Cause>) -> Self {
        Self { path: path.into(), cause: Box::new(problem.into()) }
    }

    /// With a reason in words.
    pub(crate) fn because(path: impl Into<String>, reason: &impl ToString) -> Self {
        Self::new(path, AssemblyProblem::Refused { reason: reason.to_string() })
    }

    /// As an error at its place in the case file.
    pub(crate) fn placed(self, file: &CaseText) -> ModelError {
        file.error(&self.path, *self.cause).into()
    }
}

impl From<Unbuilt> for Unassembled {
    fn from(Unbuilt { path, problem }: Unbuilt) -> Self {
        Self::new(path, problem)
    }
}

impl From<Unassembled> for ModelError {
    fn from(unassembled: Unassembled) -> Self {
        Self::Unsupported(unassembled.cause.to_string())
    }
}

impl BuiltAssembly {
    /// Reads, assembles and brings together what a case describes.
    pub(crate) fn new(case: &AssemblyCase) -> Result<Self, Unassembled> {
        Self::with_at_most(case, None)
    }

    /// The same, refused before a body is reduced where that leaves more freedoms than so many.
    pub(crate) fn with_at_most(case: &AssemblyCase, most: Option<usize>) -> Result<Self, Unassembled> {
        let structures = (0..case.structures.len())
            .map(|index| BuiltBody::structure(case, index))
            .collect::<Result<Vec<_>, _>>()?;
        let touching = interface::touching(case, &structures)?;
        interface_modes::admit(case)?;
        if let Some(most) = most {
            admit_reductions(case, &structures, &touching, most)?;
        }
        let mut bodies: Vec<BuiltBody> = Vec::with_capacity(structures.len());
        for (index, structure) in structures.into_iter().enumerate() {
            let before = bodies.last().map_or([0, 0], BuiltBody::end);
            bodies.push(BuiltBody::new(case, index, structure, touching.of_body(index), before)?);
        }
        let all = |pick: fn(&BuiltBody) -> &Sparse| {
            stacked(&bodies.iter().map(pick).collect::<Vec<_>>())
                .map(Arc::new)
                .map_err(|error| Unassembled::because("structure", &error))
        };
        let matrices = [
            all(|body| &body.matrices.mass)?,
            all(|body| &body.matrices.damping)?,
            all(|body| &body.matrices.stiffness)?,
        ];
        Self::of_bodies(case, bodies.into(), Arc::new(touching), matrices)
    }

    /// The assembly of a case that differs from this one's in keys alone; bodies that these cannot concern are taken over.
    pub(crate) fn swept<'a>(
        &self,
        case: &AssemblyCase,
        mut paths: impl Iterator<Item = &'a str>,
    ) -> Result<Self, Unassembled> {
        match paths.all(|path| path.starts_with("contact.")) {
            true => {
                let matrices = self.matrices.each_ref().map(Arc::clone);
                Self::of_bodies(case, Arc::clone(&self.bodies), Arc::clone(&self.touching), matrices)
            }
            false => Self::new(case),
        }
    }

    /// Whether another has the same bodies.
    pub(crate) fn shares_bodies(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.bodies, &other.bodies)
    }

    /// Brings bodies together.
    fn of_bodies(
        case: &AssemblyCase,
        bodies: Arc<[BuiltBody]>,
        touching: Arc<Touching>,
        matrices: [Arc<Sparse>; 3],
    ) -> Result<Self, Unassembled> {
        let mut warnings: Vec<String> =
            bodies.iter().flat_map(|body| body.warnings.iter().cloned()).collect();
        let (interfaces, nodes) = interface::interfaces(case, &bodies, &touching, &mut warnings)?;
        let left_out = turning::left_out(case);
        warnings.extend(left_out.iter().map(|what| format!("left out: {what}")));
        let joints = |error: &AssemblyError| Unassembled::because("spring", error);
        let [mass, damping, stiffness] = matrices.each_ref().map(Arc::clone);
        let assembly = Assembly {
            mass,
            damping,
            stiffness,
            gyroscopic: body::gyroscopic(&bodies)?,
            load: bodies.iter().flat_map(|body| body.load.iter().copied()).collect(),
            interfaces,
        };
        let assembly =
            assembly.with_springs(&joint::springs(case, &bodies)?).map_err(|error| joints(&error))?;
        let (mut assembly, bond) = bonded(case, &bodies, assembly, &mut warnings)?;
        match assembly.framed().map(drop) {
            Err(AssemblyError::NoSlip { interface, place, velocity, normal }) => {
                let path = format!("contact.{interface}.sliding");
                Err(Unassembled::because(path, &AssemblyError::NoSlip { interface, place, velocity, normal }))
            }
            Err(error) => Err(Unassembled::because("contact", &error)),
            Ok(()) => Ok(()),
        }?;
        deformed::deform(case, (&bodies, &touching, bond.as_ref()), &mut assembly, &nodes)?;
        let spheres = sphere::spheres(case, &mut assembly)?;
        let mut travelling = travel::travelling(case, &bodies, &touching, &nodes)?;
        let mut watched = watched::watched(case, &bodies)?;
        if let Some(bond) = &bond {
            let of_travel = travelling.iter_mut().flat_map(travel::rows_of);
            for row in watched.iter_mut().map(|own| &mut own.row).chain(of_travel) {
                *row = bond.form(row);
            }
        }
        Ok(Self {
            bodies,
            touching,
            matrices,
            assembly,
            nodes,
            spheres,
            travelling,
            watched,
            left_out,
            warnings,
            bond,
            quickly_found: OnceLock::new(),
        })
    }

    /// What is quickly found out about steady sliding, looked for once.
    pub(super) fn quickly_found(&self) -> &QuicklyFound {
        self.quickly_found.get_or_init(|| QuicklyFound::of(self))
    }

    /// Finds the laws of all spheres, where they are not known yet.
    pub(crate) fn find_laws(&self, progress: &dyn Progress) -> Result<(), ModelError> {
        self.spheres.iter().flatten().try_for_each(|sphere| sphere.find(progress))
    }

    /// Each sphere with the number of its interface and its state in steady sliding, unless it is in the air.
    pub(crate) fn sliding_spheres<'a>(
        &'a self,
        steady: &'a SteadySliding,
    ) -> impl Iterator<Item = (usize, &'a Arc<SubstrateSphere>, SphereState)> + 'a {
        let interfaces = self.spheres.iter().enumerate();
        interfaces.filter_map(|(index, sphere)| {
            let (sphere, point) = (sphere.as_ref()?, self.assembly.interfaces[index].points.first()?);
            let state = steady.points.iter().find(|point| point.interface == index)?;
            Some((index, sphere, sphere.state(state, point.slip_speed())?))
        })
    }

    /// A shape on the freedoms of all bodies from one on those of the assembly.
    pub(crate) fn expanded(&self, shape: &[Complex64]) -> Vec<Complex64> {
        let of_bodies = self.bond.as_ref().map(|bond| bond.expanded(shape));
        let shape = of_bodies.as_deref().unwrap_or(shape);
        self.bodies
            .iter()
            .flat_map(|body| body.expanded(&shape[body.first..body.first + body.size()]))
            .collect()
    }

    /// What an analysis was refused for, in words of the case: a freedom by its structure and place.
    pub(crate) fn told(&self, error: AssemblyError) -> ModelError {
        let AssemblyError::RigidMotion { motions, freedom, .. } = &error else { return error.into() };
        let freedom = self.bond.as_ref().map_or(*freedom, |bond| bond.freedom(*freedom));
        match self.bodies.iter().find(|body| (body.first..body.first + body.size()).contains(&freedom)) {
            Some(body) => {
                let moves = body.moves(freedom - body.first);
                ModelError::Unsupported(format!(
                    "{motions} rigid motion{} held neither by supports nor by contacts: the first moves `{}` {moves}; support it, or let a \
                     contact hold it",
                    if *motions == 1 { " is" } else { "s are" },
                    body.name,
                ))
            }
            None => error.into(),
        }
    }
}

/// Refuses reductions that keep more freedoms than so many, as far as that is known before they are made: not of what ties take.
fn admit_reductions(
    case: &AssemblyCase,
    structures: &[Structure],
    touching: &Touching,
    most: usize,
) -> Result<(), Unassembled> {
    let is_reduced = |index: &usize| matches!(case.structures[*index].reduction, BodyReduction::Modes(_));
    if !case.ties.is_empty() || !(0..structures.len()).any(|index| is_reduced(&index)) {
        return Ok(());
    }
    let size = |(index, own)| BuiltBody::least_size(case, index, own, &touching.of_body(index));
    let sizes = structures.iter().enumerate().map(size).collect::<Result<Vec<usize>, _>>()?;
    let freedoms: usize = sizes.iter().sum();
    let largest = (0..sizes.len()).filter(is_reduced).max_by_key(|index| sizes[*index]);
    match largest.filter(|_| freedoms > most) {
        None => Ok(()),
        Some(largest) => {
            let (name, own) = (&case.structures[largest].name, sizes[largest]);
            let path = format!("structure.{name}.reduction");
            let error = CyclesError::TooManyFreedoms { freedoms, most };
            Err(Unassembled::because(
                path,
                &format!("{error}: the reduction of `{name}` keeps {own} of them"),
            ))
        }
    }
}

/// The assembly on the freedoms that ties leave.
fn bonded(
    case: &AssemblyCase,
    bodies: &[BuiltBody],
    assembly: Assembly,
    warnings: &mut Vec<String>,
) -> Result<(Assembly, Option<Bond>), Unassembled> {
    let ties = joint::ties(case, bodies, warnings)?;
    if ties.is_empty() {
        return Ok((assembly, None));
    }
    let forms: Vec<Row> = ties.iter().map(|tied| tied.form.clone()).collect();
    match assembly.tied(&forms) {
        Ok((assembly, bond)) => Ok((assembly, Some(bond))),
        Err(AssemblyError::RedundantTie { form }) => {
            let name = case.ties[ties[form].tie].name.to_string();
            Err(Unassembled::new(format!("tie.{name}"), AssemblyProblem::RedundantTie { name }))
        }
        Err(error) => Err(Unassembled::because("tie", &error)),
    }
}
